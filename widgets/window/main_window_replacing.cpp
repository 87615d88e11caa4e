// What the main window asks before samples and markers that are in no file go: when a file takes their place, with a
// connection, and at the end.
#include "widgets/base/device_text.h"
#include "widgets/base/replaying.h"
#include "widgets/files/marker_file.h"
#include "widgets/files/record_control.h"
#include "widgets/scope/scope_view.h"
#include "widgets/window/main_window.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace widgets {
namespace {

struct Question {
    QMessageBox *box;
    QPushButton *destroy;
};

/// Neither Enter nor Esc loses anything.
Question makeQuestion(QWidget *window, const char *name, const QString &title, const QString &text,
    const QString &destroy)
{
    auto *box = new QMessageBox(QMessageBox::Warning, title, text, QMessageBox::NoButton, window);
    box->setObjectName(QLatin1String(name));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    QPushButton *button = box->addButton(destroy, QMessageBox::DestructiveRole);
    button->setAutoDefault(false);
    QPushButton *cancel = box->addButton(QMessageBox::Cancel);
    box->setDefaultButton(cancel);
    box->setEscapeButton(cancel);
    return {box, button};
}

} // namespace

/// Asks before samples of a board or markers go that are in no file; goes on at once if there are none.
void MainWindow::replaceRecorded(std::function<void()> goOn)
{
    const capture::Capture &capture = m_workbench.capture();
    const bool kept = m_workbench.signalPlan().showsFile() || !capture.timeSpan()
        || capture.revision() == m_exportedRevision || m_record->holds(capture);
    if (kept) {
        askForMarkers(std::move(goOn));
        return;
    }
    const bool markers = m_markers->changed();
    const auto [box, replace] = makeQuestion(this, "replaceQuestion",
        tr("Replace what was recorded?"),
        tr("The scope holds samples of the last connection that were not exported. A file that is "
           "opened takes their place."),
        tr("&Replace"));
    replace->setObjectName(QStringLiteral("replaceYes"));
    QString more = tr("What was recorded to a disk stays there. The scope's own samples cannot be "
                      "brought back.");
    if (markers)
        more += QLatin1Char(' ') + tr("Markers that are in no file go with them.");
    box->setInformativeText(more);
    auto *save = box->addButton(tr("&Export first\u2026"), QMessageBox::AcceptRole);
    save->setObjectName(QStringLiteral("replaceSave"));
    QPushButton *saveMarkers =
        markers ? box->addButton(tr("Save the &markers"), QMessageBox::AcceptRole) : nullptr;
    if (saveMarkers)
        saveMarkers->setObjectName(QStringLiteral("replaceSaveMarkers"));
    connect(box, &QMessageBox::buttonClicked, this,
        [this, save, saveMarkers, yes = replace, goOn = std::move(goOn)](QAbstractButton *button) {
            if (button == yes) {
                m_markers->leave();
                goOn();
            } else if (button == save)
                exportCsv();
            else if (saveMarkers && button == saveMarkers)
                m_markers->saveThen({});
        });
    box->open();
}

/// Asks before changed markers go; goes on at once if there are none, and once they are saved.
void MainWindow::askForMarkers(std::function<void()> goOn)
{
    if (!m_markers->changed()) {
        goOn();
        return;
    }
    const auto *asked = findChild<QMessageBox *>(QStringLiteral("markersQuestion"));
    if (asked && asked->isVisible())
        return;
    const auto [box, leave] = makeQuestion(this, "markersQuestion",
        tr("Leave the markers unsaved?"), markersText(), tr("&Leave unsaved"));
    leave->setObjectName(QStringLiteral("leaveMarkers"));
    const bool asks = m_markers->place() == MarkerFile::Place::Opened
        || m_markers->place() == MarkerFile::Place::List;
    QPushButton *save =
        box->addButton(asks ? tr("&Save first\u2026") : tr("&Save first"), QMessageBox::AcceptRole);
    save->setObjectName(QStringLiteral("saveMarkersFirst"));
    connect(box, &QMessageBox::buttonClicked, this,
        [this, save, no = leave, goOn = std::move(goOn)](QAbstractButton *button) {
            if (button == no) {
                m_markers->leave();
                goOn();
            } else if (button == save)
                m_markers->saveThen(goOn);
        });
    box->open();
}

/// Which markers are in no file, and where they can go.
QString MainWindow::markersText() const
{
    switch (m_markers->place()) {
    case MarkerFile::Place::Opened:
        return tr("Markers of this recording were changed and are in no file.");
    case MarkerFile::Place::Recorded:
        return tr("The recording %1 does not hold all markers as they are now.")
            .arg(deviceText(QFileInfo(m_markers->path()).fileName()));
    case MarkerFile::Place::Running:
        return tr(
            "The recording that runs does not hold all markers: some were set before it began.");
    case MarkerFile::Place::List:
        break;
    }
    return tr("Markers are in no file, and there is no recording that could take them. They can be "
              "saved as a list of times and words (CSV).");
}

/// What happened in a file goes with it; markers of a connection and of a replay stay.
void MainWindow::clearRecorded()
{
    const auto clear = [this] {
        const bool file = m_workbench.signalPlan().showsFile();
        m_workbench.signalPlan().clear();
        if (file && !m_workbench.signalPlan().showsFile()) // a replay goes on
            m_workbench.events().clear();
    };
    if (m_workbench.signalPlan().showsFile() && !replaying(m_device))
        askForMarkers(clear);
    else
        clear();
}

} // namespace widgets
