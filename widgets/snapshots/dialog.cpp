#include "widgets/snapshots/dialog.h"

#include "session/files/snapshot_json.h"
#include "session/files/whole_file.h"
#include "snapshots/drive_parameters.h"
#include "widgets/base/device_text.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/look/spacing.h"
#include "widgets/snapshots/text.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace widgets {
namespace {

/// Of current, as the board says; 0: it did not.
double ampsPerDigit(const Device &device, int motor)
{
    const auto catalog = device.catalog();
    const auto id = catalog ? catalog->resolve("I_Q_REF@" + std::to_string(motor)) : std::nullopt;
    if (!id)
        return 0.0;
    const catalog::Scale scale = catalog->readScale(*id);
    return scale.unit == "A" ? scale.factor : 0.0;
}

} // namespace

SnapshotDialog::SnapshotDialog(
    Form form, Device &device, FilePrompt &files, const QString &folder, QWidget *parent)
    : QDialog(parent)
    , m_form(form)
    , m_device(device)
    , m_files(files)
    , m_folder(folder)
    , m_motor(device.motor())
    , m_reader(device)
    , m_summary(wrappedLabel("snapshotDialogSummary", this))
    , m_progress(new QProgressBar(this))
{
    setObjectName(QStringLiteral("snapshotDialog"));
    setModal(true);
    setWindowTitle(form == Form::Snapshot
            ? tr("Save a snapshot")
            : tr("Export C header of motor %1").arg(QString::number(m_motor)));
    m_progress->setAccessibleName(tr("Progress of reading"));
    auto *buttons = new QDialogButtonBox(this);
    m_save = buttons->addButton(tr("Save\u2026"), QDialogButtonBox::AcceptRole);
    m_save->setObjectName(QStringLiteral("snapshotDialogSave"));
    QPushButton *cancel = buttons->addButton(QDialogButtonBox::Cancel);
    cancel->setObjectName(QStringLiteral("snapshotDialogCancel"));
    connect(m_save, &QPushButton::clicked, this, [this] { m_content.isEmpty() ? begin() : ask(); });
    connect(cancel, &QPushButton::clicked, this, &SnapshotDialog::reject);
    connect(&m_reader, &SnapshotReader::progressed, this, [this](int done, int total) {
        m_progress->setRange(0, total);
        m_progress->setValue(done);
    });
    connect(&m_reader, &SnapshotReader::finished, this, &SnapshotDialog::read);
    auto *layout = edged(new QVBoxLayout(this), kDialogEdges, kGrid);
    layout->addWidget(m_summary);
    layout->addWidget(m_progress);
    layout->addWidget(buttons);
    setMinimumWidth(420);
    QMetaObject::invokeMethod(this, &SnapshotDialog::begin, Qt::QueuedConnection);
}

void SnapshotDialog::tell(const QString &sentence, bool bad)
{
    QFont font = this->font();
    font.setBold(bad);
    m_summary->setFont(font);
    m_summary->setText(sentence);
}

void SnapshotDialog::begin()
{
    tell(tr("Reading what the board holds\u2026"), false);
    m_save->setEnabled(false);
    m_progress->setRange(0, 0);
    m_progress->setVisible(true);
    m_reader.start(m_form == Form::Snapshot ? snapshots::Scope::All : snapshots::Scope::Tunable);
}

void SnapshotDialog::read(const BoardReading &reading)
{
    if (reading.end == BoardReading::End::Cancelled)
        return QDialog::reject();
    m_progress->setVisible(false);
    m_save->setEnabled(true);
    if (reading.end == BoardReading::End::Broken) {
        m_save->setText(tr("Try again"));
        return tell(tr("The board could not be read to the end; nothing was saved."), true);
    }
    m_save->setText(tr("Save\u2026"));
    m_snapshot = reading.snapshot;
    m_content = m_form == Form::Snapshot
        ? session::snapshotJson(m_snapshot)
        : QByteArray::fromStdString(
            snapshots::driveParametersHeader(m_snapshot, m_motor, ampsPerDigit(m_device, m_motor)));
    const int count = static_cast<int>(m_snapshot.entries.size());
    if (!reading.unanswered.isEmpty()) // the user decides whether that will do
        return tell(
            tr("%n register(s) were read. The board never answered for: %1.", nullptr, count)
                .arg(reading.unanswered.join(QStringLiteral(", "))),
            true);
    tell(tr("%n register(s) were read.", nullptr, count), false);
    ask();
}

void SnapshotDialog::ask()
{
    const bool json = m_form == Form::Snapshot;
    const QString name = suggestedFileName(QDateTime::currentDateTime(),
        json ? QStringLiteral("snapshot.json") : QStringLiteral("drive_parameters.h"));
    const SaveQuestion question{windowTitle(), orHome(m_folder), name,
        json ? tr("Snapshots (*.json)") : tr("C headers (*.h)"),
        json ? QStringLiteral("json") : QStringLiteral("h")};
    m_files.askSave(this, question, [this](const QString &path) { save(path); });
}

void SnapshotDialog::save(const QString &path)
{
    const QString why = session::writeWholeFile(path, m_content);
    if (!why.isEmpty())
        return tell(tr("%1 was not written: %2. Choose another place.", "file, the system's words")
                        .arg(deviceText(path), deviceText(why)),
            true);
    Q_EMIT saved(path, static_cast<int>(m_snapshot.entries.size()));
    accept();
}

void SnapshotDialog::reject()
{
    if (m_reader.running())
        m_reader.cancel();
    else
        QDialog::reject();
}

} // namespace widgets
