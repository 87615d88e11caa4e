#include "widgets/files/job.h"

#include "widgets/base/look/named.h"

#include <QProgressDialog>
#include <QPushButton>
#include <QThreadPool>
#include <QWidget>

#include <cmath>

namespace widgets {
namespace {

constexpr int kTick_ms = 100;
constexpr int kSteps = 1000;

} // namespace

FileJob::FileJob(const QString &title, Work work, QWidget *window)
    : QObject(window)
    , m_title(title)
    , m_left(std::make_shared<QSemaphore>())
{
    connect(&m_timer, &QTimer::timeout, this, &FileJob::tick);
    m_timer.start(kTick_ms);
    m_elapsed.start();
    QThreadPool::globalInstance()->start([this, left = m_left, work = std::move(work)] {
        Finish finish = work([this](double fraction) {
            m_fraction = fraction;
            return !m_cancelled;
        });
        QMetaObject::invokeMethod(
            this,
            [this, finish = std::move(finish)] {
                m_timer.stop();
                delete m_dialog;
                if (finish)
                    finish();
                m_over = true;
                Q_EMIT over();
                deleteLater();
            },
            Qt::QueuedConnection);
        left->release();
    });
}

FileJob::~FileJob()
{
    m_cancelled = true;
    m_left->acquire();
    delete m_dialog;
}

void FileJob::cancel() { m_cancelled = true; }

void FileJob::tick()
{
    if (m_elapsed.elapsed() < kQuiet_ms)
        return;
    if (!m_dialog) {
        m_dialog = named(new QProgressDialog(qobject_cast<QWidget *>(parent())), "fileJob");
        m_dialog->setWindowTitle(m_title);
        m_dialog->setRange(0, kSteps);
        m_dialog->setAutoClose(false);
        m_dialog->setAutoReset(false);
        auto *cancel = named(new QPushButton(tr("Cancel")), "fileJobCancel");
        m_dialog->setCancelButton(cancel);
        connect(m_dialog, &QProgressDialog::canceled, this, &FileJob::cancel);
        m_dialog->show();
    }
    const double fraction = m_fraction;
    m_dialog->setLabelText(m_cancelled ? tr("Being cancelled\u2026") : estimate(fraction));
    m_dialog->setValue(static_cast<int>(fraction * kSteps));
}

QString FileJob::estimate(double fraction) const
{
    if (fraction < 0.02)
        return m_title;
    const double seconds = static_cast<double>(m_elapsed.elapsed()) / 1000.0;
    const double left = std::ceil(seconds * (1.0 - fraction) / fraction);
    return tr("%1: about %2 s left", "what is done, a number").arg(m_title, QString::number(left));
}

} // namespace widgets
