// A program for tests of the guardian: the window's process without its panels. A window on the screen that there is, a
// session in a thread of its own, a guardian; it arms and starts the motor as soon as it knows the board, and streams.
//
//   guarded_program PORT drive    drives until it is ended
//                        idle     arms, moves nothing
//                        leave    starts, then closes the port as the user does who leaves the motor running, and ends
#include "session/link/guardian.h"
#include "session/link/session.h"
#include "session/link/session_thread.h"

#include <QApplication>
#include <QTimer>
#include <QWidget>

#include <iostream>

namespace {

class Person : public QObject {
public:
    Person(session::Session &session, QString act)
        : m_session(session)
        , m_act(std::move(act))
    {
        using session::Session;
        connect(&session, &Session::batch, this, [this](const session::BatchPtr &batch) {
            for (const drive::Event &event : batch->events)
                accept(event);
            call([](Session &s) { s.acknowledge(); });
        });
        connect(&session, &Session::armedChanged, this, [this](bool armed) {
            say(armed ? "armed" : "disarmed");
            if (armed && m_act != QLatin1String("idle"))
                start();
        });
        connect(&session, &Session::interrupted, this, [this](const session::Interruption &what) {
            if (what.cause == session::Interruption::Cause::LateArming)
                arm();
        });
        connect(&session, &Session::portChanged, this,
            [this](session::PortState state, const session::PortError &why) {
                say(state == session::PortState::Open                    ? "open"
                        : why.problem == session::PortProblem::TakenOver ? "taken over"
                                                                         : "closed");
                if (state == session::PortState::Closed && m_left)
                    QCoreApplication::quit();
            });
    }

    template <class Call>
    void call(Call what)
    {
        QMetaObject::invokeMethod(
            &m_session, [session = &m_session, what] { what(*session); }, Qt::QueuedConnection);
    }

private:
    void accept(const drive::Event &event)
    {
        const auto *board = std::get_if<drive::Identified>(&event);
        if (board != nullptr && !std::exchange(m_met, true)) {
            if (const auto current = board->catalog->resolve("I_A"))
                wish(drive::Stream{{*current}, 8, {}, 1});
            arm();
        }
        // What a busy machine kept from leaving is asked for again.
        const auto *end = std::get_if<drive::Ended>(&event);
        if (end != nullptr && end->id == m_start && end->outcome == drive::Outcome::NotSent)
            QTimer::singleShot(100, this, [this] {
                arm();
                start();
            });
        const auto *status = std::get_if<drive::MotorStatus>(&event);
        if (status == nullptr || status->state != drive::MotorState::Running)
            return;
        if (m_act == QLatin1String("leave") && !std::exchange(m_left, true))
            call([](session::Session &session) { session.close(); });
    }
    void wish(decltype(drive::Wish::what) what)
    {
        call([id = ++m_wish, what = std::move(what)](
                 session::Session &session) { session.submit({.id = id, .what = what}); });
    }
    void arm()
    {
        call([](session::Session &session) { session.setArmed(true); });
    }
    void start()
    {
        wish(drive::Command{});
        m_start = m_wish;
    }
    static void say(const char *what) { std::cout << what << std::endl; }

    session::Session &m_session;
    QString m_act;
    drive::WishId m_wish = 0, m_start = 0;
    bool m_met = false, m_left = false;
};

} // namespace

int main(int argc, char **argv)
{
    const char *why = nullptr;
    session::Parts parts = session::realParts();
    parts.guardian = session::startGuardian(why);
    QApplication application(argc, argv);
    QWidget window;
    window.show();
    const session::SessionThread thread(std::move(parts));
    Person person(*thread.session(), QString::fromLocal8Bit(argc > 2 ? argv[2] : "drive"));
    auto endpoint =
        session::endpointFor(QString::fromLocal8Bit(argv[1]), 1843200, drive::Protocol::Mcp);
    endpoint.patience = std::chrono::milliseconds(1500); // of a busy machine
    QTimer pulse; // the user is there
    QObject::connect(&pulse, &QTimer::timeout, &window,
        [session = thread.session()] { session->attendFromAnyThread(); });
    pulse.start(100);
    person.call([endpoint](session::Session &session) { session.open(endpoint); });
    return QApplication::exec();
}
