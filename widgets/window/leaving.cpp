#include "widgets/window/leaving.h"

#include "widgets/base/messages.h"

#include <utility>

namespace widgets {

using Kind = Answer::Kind;

Leaving::Leaving(
    Device &device, std::function<TimePoint()> clock, QuestionPrompt &prompt, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_prompt(prompt)
    , m_shutdown(device, std::move(clock))
{
    connect(&m_shutdown, &Shutdown::confirmed, this, &Leaving::go);
    connect(&m_shutdown, &Shutdown::notConfirmed, this, &Leaving::ask);
}

void Leaving::before(Act act)
{
    if (!m_shutdown.mayTurn())
        return act.go();
    m_act = std::move(act);
    Q_EMIT said(m_act.stopping);
    m_shutdown.begin();
}

void Leaving::ask()
{
    m_prompt.ask({.name = "leaveQuestion",
        .title = tr("Stop motors"),
        .text = stopNotConfirmedText(),
        .more = m_device.portOpen()
            ? tr("Rotorscope has told every motor to stop, but there is no evidence that they "
                 "did. A motor may still be turning.")
            : tr("No port is open that could carry a stop. A motor may still be turning, and "
                 "nothing tells how fast."),
        .answers = {{Kind::Go, tr("Try again"), [this] { before(std::exchange(m_act, {})); }},
            {Kind::Force, m_act.allTheSame, [this] { confirm(); }}, {Kind::Stay, tr("Stay")}}});
}

void Leaving::confirm()
{
    m_prompt.ask({.name = "leaveRunning",
        .title = tr("Leave running?"),
        .text = tr("Leave the motors as they are?"),
        .more = tr("They may go on turning, and nothing will watch them."),
        .answers = {{Kind::Stay, tr("Stay")}, {Kind::Force, tr("Leave running"), [this] {
                                                   m_shutdown.leaveAsTheyAre();
                                                   go();
                                               }}}});
}

/// What goes on may be followed by something else that leaves.
void Leaving::go()
{
    const std::function<void()> goOn = m_act.go;
    goOn();
}

void Leaving::beforeDisconnecting(const std::function<void()> &disconnect)
{
    const auto stopAndLeave = [this, disconnect] {
        before({tr("Stopping the motors before the port is closed\u2026"),
            tr("Disconnect all the same\u2026"), disconnect});
    };
    if (!m_shutdown.mayTurn() || !m_device.answering() || m_device.allIdle())
        return stopAndLeave();
    m_prompt.ask({.name = "disconnectQuestion",
        .title = tr("Disconnect"),
        .text = tr("A motor is not idle."),
        .more = tr("Without a connection nothing watches it, and this program cannot stop it."),
        .answers = {{Kind::Go, tr("Stop motors, then disconnect"), stopAndLeave},
            {Kind::Force, tr("Leave running"), disconnect}, {Kind::Stay, tr("Stay connected")}},
        .usual = 2});
}

} // namespace widgets
