// Leaving: what goes before a connection is left, by closing, disconnecting or opening something else. Where a motor
// may turn it is stopped first; where there is no evidence that it stands the user is asked, twice before it is left
// running. Where the evidence comes while the question waits, the question is over. An experiment that is running is
// always ended by a Stop first, because nothing bounds its motor afterwards; what it leaves on the board is shown, as
// it cannot be written back then.
#pragma once

#include "widgets/base/question.h"
#include "widgets/window/shutdown.h"

namespace widgets {

class Experiments;

class Leaving : public QObject {
    Q_OBJECT
public:
    /// Something for which the connection is left.
    struct Act {
        QString stopping; ///< what is told while the motors are stopped
        QString allTheSame; ///< the button that does it without evidence
        std::function<void()> go;
    };

    /// Both outlive it. @param clock  that of the session, which stamps what boards tell
    Leaving(Device &device, std::function<TimePoint()> clock, QuestionPrompt &prompt,
        QObject *parent = nullptr);

    void watch(const Experiments &experiments); ///< which outlive it

    bool mayTurn() const { return m_shutdown.mayTurn(); } ///< a motor
    bool takesTime() const; ///< a motor may turn, or an experiment is running
    bool wereAtRest() const { return m_shutdown.wereAtRest(); } ///< all motors, when last heard
    bool underWay() const { return m_shutdown.underWay(); }
    void before(Act act); ///< at once, or after the motors were stopped, or asked for
    /// A motor that is seen to turn may be meant to: that is asked first.
    void beforeDisconnecting(const std::function<void()> &disconnect);

Q_SIGNALS:
    void said(const QString &sentence);

private:
    bool experimentRuns() const;
    bool goesOn() const;
    void beginAnew();
    void stopFirst();
    void ask();
    void confirm();
    void go();
    void endQuestionsAtRest();
    void showLeft();

    Device &m_device;
    QuestionPrompt &m_prompt;
    Shutdown m_shutdown;
    Act m_act; ///< what it goes before
    const Experiments *m_experiments = nullptr;
    bool m_ending = false; ///< an experiment that was running, and whose end has not been told yet
    bool m_waits = false; ///< for that end alone
    QString m_left; ///< what that experiment left, in its words, until it was shown
};

} // namespace widgets
