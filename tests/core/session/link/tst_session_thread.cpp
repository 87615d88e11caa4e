// The session in its own thread, as the window has it: it opens, is stopped and ends without being waited for.
#include "session/link/session.h"
#include "session/link/session_thread.h"

#include <QElapsedTimer>
#include <QPointer>
#include <QSemaphore>
#include <QThread>
#include <QtTest>

#include <optional>

using session::Session;
using session::SessionThread;

class TestSessionThread : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theBoardIsIdentifiedFromAnotherThread();
    void aStopFromThisThreadIsConfirmed();
    void theThreadEndsSoonWithAPortOpenAndWithout();
    void aDriverThatHangsDoesNotHoldUsUp();
};

namespace {

/// What the window's thread sees: everything arrives there by queued signals.
struct Viewer : QObject {
    SessionThread thread;
    std::optional<drive::Identified> board;
    std::optional<drive::StopWord> word;

    Viewer()
    {
        connect(thread.session(), &Session::batch, this, [this](const session::BatchPtr &batch) {
            for (const drive::Event &event : batch->events) {
                if (const auto *identified = std::get_if<drive::Identified>(&event))
                    board = *identified;
                else if (const auto *progress = std::get_if<drive::StopProgress>(&event))
                    word = progress->word;
            }
            QMetaObject::invokeMethod(
                thread.session(), &Session::acknowledge, Qt::QueuedConnection);
        });
        Session *session = thread.session();
        QMetaObject::invokeMethod(
            session, [session] { session->open({}); }, Qt::QueuedConnection);
    }
};

} // namespace

void TestSessionThread::theBoardIsIdentifiedFromAnotherThread()
{
    Viewer viewer;
    QTRY_VERIFY_WITH_TIMEOUT(viewer.board, 20'000);
    QVERIFY(viewer.thread.session()->thread() != QThread::currentThread());
}

void TestSessionThread::aStopFromThisThreadIsConfirmed()
{
    Viewer viewer;
    QTRY_VERIFY_WITH_TIMEOUT(viewer.board, 20'000);
    viewer.thread.session()->stopFromAnyThread();
    QTRY_COMPARE_WITH_TIMEOUT(viewer.word, std::optional(drive::StopWord::MayCoast), 20'000);
}

void TestSessionThread::theThreadEndsSoonWithAPortOpenAndWithout()
{
    QElapsedTimer time;
    {
        SessionThread idle;
        time.start();
    }
    QVERIFY2(time.elapsed() < 1900, qPrintable(QString::number(time.elapsed())));
    {
        Viewer viewer;
        QTRY_VERIFY_WITH_TIMEOUT(viewer.board, 20'000);
        time.start();
    }
    QVERIFY2(time.elapsed() < 1900, qPrintable(QString::number(time.elapsed())));
}

namespace {

/// A port whose driver does not come back from closing until it is let.
class HangingPort : public session::Transport {
public:
    explicit HangingPort(QSemaphore &let)
        : m_let(let)
    {
    }
    session::PortError open(TimePoint) override { return {}; }
    void close() override { m_let.acquire(); }
    void write(ByteView, TimePoint) override { }
    bool sent(TimePoint) const override { return true; }
    void advance(TimePoint) override { }
    std::optional<TimePoint> nextWake() const override { return {}; }
    bool real() const override { return false; }

private:
    QSemaphore &m_let;
};

} // namespace

void TestSessionThread::aDriverThatHangsDoesNotHoldUsUp()
{
    QSemaphore let;
    session::Parts parts = session::realParts();
    parts.transport = [&let](
                          const session::Endpoint &) { return std::make_unique<HangingPort>(let); };
    QPointer<QThread> left;
    QElapsedTimer time;
    bool opened = false; // told of the end of the port, too
    {
        SessionThread thread(parts);
        left = thread.session()->thread();
        connect(thread.session(), &Session::portChanged, this, [&opened] { opened = true; });
        Session *session = thread.session();
        QMetaObject::invokeMethod(
            session, [session] { session->open({}); }, Qt::QueuedConnection);
        QTRY_VERIFY(opened);
        time.start();
    }
    QVERIFY2(time.elapsed() < 6000, qPrintable(QString::number(time.elapsed())));
    QVERIFY(left && left->isRunning()); // not destroyed while it runs
    let.release(100);
    QTRY_VERIFY(!left);
}

QTEST_GUILESS_MAIN(TestSessionThread)
#include "tst_session_thread.moc"
