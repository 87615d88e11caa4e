#include "widgets/window/leaving.h"

#include "widgets/base/messages.h"
#include "widgets/lab/experiments.h"
#include "widgets/lab/text.h"

#include <utility>

namespace widgets {

using Kind = Answer::Kind;

namespace {

constexpr auto kUnconfirmed = "leaveQuestion", kLeaveRunning = "leaveRunning",
               kNotIdle = "notIdleQuestion", kLeft = "leftBehindQuestion";

} // namespace

Leaving::Leaving(
    Device &device, std::function<TimePoint()> clock, QuestionPrompt &prompt, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_prompt(prompt)
    , m_shutdown(device, std::move(clock))
{
    connect(&m_shutdown, &Shutdown::confirmed, this, &Leaving::go);
    connect(&m_shutdown, &Shutdown::notConfirmed, this, &Leaving::ask);
    connect(&device, &Device::statusChanged, this, &Leaving::endQuestionsAtRest);
}

void Leaving::watch(const Experiments &experiments)
{
    m_experiments = &experiments;
    connect(&experiments, &Experiments::ended, this, [this](const Experiments::RunPtr &run) {
        if (!std::exchange(m_ending, false))
            return;
        m_left = run->outcome.leaves ? labSentence(run->outcome.reason) : QString();
        if (std::exchange(m_waits, false))
            go();
    });
}

bool Leaving::experimentRuns() const
{
    return m_experiments != nullptr && m_experiments->running();
}

bool Leaving::takesTime() const { return m_shutdown.mayTurn() || experimentRuns(); }

/// What was begun before has neither come to its end nor been given up.
bool Leaving::goesOn() const
{
    return m_shutdown.underWay() || m_waits || m_prompt.asks(kUnconfirmed)
        || m_prompt.asks(kLeaveRunning);
}

/// Since the user stayed, what an experiment left may be put right, or another board connected.
void Leaving::beginAnew()
{
    if (!goesOn())
        m_left.clear();
}

void Leaving::before(Act act)
{
    if (!takesTime())
        return act.go();
    beginAnew();
    m_act = std::move(act);
    stopFirst();
}

void Leaving::stopFirst()
{
    m_ending = experimentRuns();
    m_waits = false; // for the evidence, again
    Q_EMIT said(m_act.stopping);
    m_shutdown.begin();
}

void Leaving::ask()
{
    if (m_prompt.asks(kUnconfirmed) || m_prompt.asks(kLeaveRunning))
        return; // asked to end again, by a signal
    m_prompt.ask({.name = kUnconfirmed,
        .title = tr("Stop motors"),
        .text = stopNotConfirmedText(),
        .more = m_device.portOpen()
            ? tr("Rotorscope has told every motor to stop, but there is no evidence that they "
                 "did. A motor may still be turning.")
            : tr("No port is open that could carry a stop. A motor may still be turning, and "
                 "nothing tells how fast."),
        .answers = {{Kind::Go, tr("Try again"), [this] { takesTime() ? stopFirst() : go(); }},
            {Kind::Force, m_act.allTheSame, [this] { confirm(); }}, {Kind::Stay, tr("Stay")}}});
}

void Leaving::confirm()
{
    m_prompt.ask({.name = kLeaveRunning,
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
    if (m_ending) { // the Stop has ended it: its word is on its way
        m_waits = true;
        return;
    }
    if (!m_left.isEmpty())
        return showLeft();
    const std::function<void()> goOn = m_act.go;
    goOn();
}

void Leaving::showLeft()
{
    m_prompt.ask({.name = kLeft,
        .title = tr("Experiment"),
        .text = tr("The experiment leaves something on the board."),
        .more = std::exchange(m_left, {}),
        .answers = {{Kind::Force, tr("Leave it so"), [this] { go(); }}, {Kind::Stay, tr("Stay")}},
        .usual = 1});
}

/// What was to be left may be left now; a board that came back behind a pulled cable says so by itself. The motor of an
/// experiment rests between its parts, too.
void Leaving::endQuestionsAtRest()
{
    if (experimentRuns() || !m_shutdown.restIsSeen())
        return;
    bool asked = false;
    for (const char *name : {kUnconfirmed, kLeaveRunning, kNotIdle}) {
        asked = asked || m_prompt.asks(name);
        m_prompt.withdraw(name);
    }
    if (asked)
        go();
}

void Leaving::beforeDisconnecting(const std::function<void()> &disconnect)
{
    Act act{tr("Stopping the motors before the port is closed\u2026"),
        tr("Disconnect all the same\u2026"), disconnect};
    if (experimentRuns() || !takesTime() || !m_device.answering() || m_device.allIdle())
        return before(std::move(act));
    beginAnew();
    m_act = std::move(act);
    m_prompt.ask({.name = kNotIdle,
        .title = tr("Disconnect"),
        .text = tr("A motor is not idle."),
        .more = tr("Without a connection nothing watches it, and this program cannot stop it."),
        .answers = {{Kind::Go, tr("Stop motors, then disconnect"),
                        [this] { before(std::exchange(m_act, {})); }},
            {Kind::Force, tr("Leave running"),
                [this] {
                    // A tour goes on by itself, and may have begun its next station meanwhile.
                    experimentRuns() ? before(std::exchange(m_act, {})) : go();
                }},
            {Kind::Stay, tr("Stay connected")}},
        .usual = 2});
}

} // namespace widgets
