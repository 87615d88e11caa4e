// What the main window asks before a motor is left behind: when it is closed and when it disconnects.
#include "widgets/base/messages.h"
#include "widgets/files/file_job.h"
#include "widgets/files/marker_file.h"
#include "widgets/window/connect_bar.h"
#include "widgets/window/main_window.h"
#include "widgets/window/shutdown.h"

#include <QCloseEvent>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>
#include <utility>

namespace widgets {

void MainWindow::leaveThen(Leaving leaving)
{
    if (!m_shutdown->mayTurn())
        return leaving.go();
    m_leaving = std::move(leaving);
    say(Banner::Kind::Warning, m_leaving.stopping);
    m_shutdown->begin();
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (m_shutdown->mayTurn()) {
        event->ignore();
        leaveThen({tr("Stopping the motors before Rotorscope ends\u2026"),
            tr("End Rotorscope all the same\u2026"), [this] { close(); }});
        return;
    }
    if (m_markers->changed() && !m_leaveMarkers) {
        event->ignore();
        askForMarkers([this] {
            m_leaveMarkers = true;
            close();
            m_leaveMarkers = false;
        });
        return;
    }
    if (FileJob *job = exportUnderWay()) {
        event->ignore();
        askAboutExport(*job);
        return;
    }
    m_device.close();
    event->accept();
    Q_EMIT closed();
}

FileJob *MainWindow::exportUnderWay() const
{
    const auto jobs =
        findChildren<FileJob *>(QLatin1String(kExportJob), Qt::FindDirectChildrenOnly);
    const auto found =
        std::find_if(jobs.begin(), jobs.end(), [](const FileJob *job) { return job->underWay(); });
    return found == jobs.end() ? nullptr : *found;
}

/// Closing ends it, and with it the file that is not whole yet.
void MainWindow::askAboutExport(FileJob &job)
{
    auto *box = new QMessageBox(QMessageBox::Warning, tr("Export"), tr("An export is under way."),
        QMessageBox::NoButton, this);
    box->setObjectName(QStringLiteral("exportQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(tr("Without it there is no file."));
    QPushButton *wait = box->addButton(tr("Close when it is written"), QMessageBox::AcceptRole);
    QPushButton *leave = box->addButton(tr("Close without it"), QMessageBox::DestructiveRole);
    box->setDefaultButton(wait);
    box->setEscapeButton(box->addButton(QMessageBox::Cancel));
    connect(&job, &FileJob::over, box, &QMessageBox::reject); // nothing to be asked any more
    connect(
        box, &QMessageBox::buttonClicked, &job, [this, &job, wait, leave](QAbstractButton *button) {
            m_closeAfterExport = button == wait;
            if (button != leave)
                return;
            job.cancel();
            close();
        });
    box->open();
}

void MainWindow::askToLeave()
{
    auto *box = new QMessageBox(QMessageBox::Warning, tr("Stop motors"), stopNotConfirmedText(),
        QMessageBox::NoButton, this);
    box->setObjectName(QStringLiteral("leaveQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(m_device.portOpen()
            ? tr("Rotorscope has told every motor to stop, but there is no evidence that they "
                 "did. A motor may still be turning.")
            : tr("No port is open that could carry a stop. A motor may still be turning, and "
                 "nothing tells how fast."));
    QPushButton *again = box->addButton(tr("Try again"), QMessageBox::AcceptRole);
    QPushButton *leave = box->addButton(m_leaving.allTheSame, QMessageBox::DestructiveRole);
    QPushButton *stay = box->addButton(tr("Stay"), QMessageBox::RejectRole);
    box->setDefaultButton(again);
    box->setEscapeButton(stay);
    connect(box, &QMessageBox::buttonClicked, this, [this, leave, again](QAbstractButton *button) {
        if (button == leave)
            confirmLeaving();
        else if (button == again)
            leaveThen(std::exchange(m_leaving, {}));
    });
    box->open();
}

void MainWindow::confirmLeaving()
{
    auto *box = new QMessageBox(QMessageBox::Warning, tr("Leave running?"),
        tr("Leave the motors as they are?"), QMessageBox::NoButton, this);
    box->setObjectName(QStringLiteral("leaveRunning"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(tr("They may go on turning, and nothing will watch them."));
    QPushButton *stay = box->addButton(tr("Stay"), QMessageBox::RejectRole);
    QPushButton *leave = box->addButton(tr("Leave running"), QMessageBox::DestructiveRole);
    box->setDefaultButton(stay);
    box->setEscapeButton(stay);
    connect(box, &QMessageBox::buttonClicked, this, [this, leave](QAbstractButton *button) {
        if (button != leave)
            return;
        m_shutdown->leaveAsTheyAre();
        m_leaving.go();
    });
    box->open();
}

/// A motor that is seen to turn may be meant to; where nothing is seen, it is stopped first.
void MainWindow::disconnectFromBoard()
{
    if (m_shutdown->mayTurn() && m_device.answering() && !m_device.allIdle())
        askToDisconnect();
    else
        leaveThen(disconnection());
}

MainWindow::Leaving MainWindow::disconnection()
{
    return {tr("Stopping the motors before the port is closed\u2026"),
        tr("Disconnect all the same\u2026"), [this] { m_connectBar->disconnectNow(); }};
}

void MainWindow::askToDisconnect()
{
    auto *box = new QMessageBox(QMessageBox::Warning, tr("Disconnect"), tr("A motor is not idle."),
        QMessageBox::NoButton, this);
    box->setObjectName(QStringLiteral("disconnectQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(
        tr("Without a connection nothing watches it, and this program cannot stop it."));
    QPushButton *stop = box->addButton(tr("Stop motors, then disconnect"), QMessageBox::AcceptRole);
    QPushButton *leave = box->addButton(tr("Leave running"), QMessageBox::DestructiveRole);
    QPushButton *stay = box->addButton(tr("Stay connected"), QMessageBox::RejectRole);
    box->setDefaultButton(stay);
    box->setEscapeButton(stay);
    connect(box, &QMessageBox::buttonClicked, this, [this, stop, leave](QAbstractButton *button) {
        if (button == stop)
            leaveThen(disconnection());
        else if (button == leave)
            m_connectBar->disconnectNow();
    });
    box->open();
}

} // namespace widgets
