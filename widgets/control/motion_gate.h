// MotionGate: the one way by which panels ask for motion. It judges every act anew (drive/motion_caution.h), asks
// before what could surprise, sends, and tells how it ended if not well. A stop does not come through here: it is never
// asked.
//
// want() may emit asked(); then confirm() or decline() has to follow, or the gate withdraws the question by itself: a
// stop, a lost link, another motor, a board that is silent for a second. A shorter hiccup leaves it open; a yes counts
// only once the board answers again, and if what was asked about is still so. While a question is open nothing else is
// taken.
#pragma once

#include "drive/motion_caution.h"
#include "drive/start_target.h"
#include "widgets/base/device.h"
#include "widgets/registers/model.h"

#include <QMap>
#include <QObject>
#include <QTimer>

#include <map>
#include <set>

namespace widgets {

/// What the user is asked.
struct MotionQuestion {
    int motor = 1;
    QString action; ///< e.g. "Start"
    QStringList lines; ///< motor, old and new value with unit, and why it is asked
    QString offer; ///< not to be asked again about the like of it; empty: there is none
};

class MotionGate : public QObject {
    Q_OBJECT
public:
    MotionGate(Device &device, RegisterModel &registers, QObject *parent = nullptr);

    /// One act of the user: `action` names it for them. Several wishes are asked about once, and each is sent when the
    /// one before has ended well.
    void want(const QString &action, drive::WishContent act);
    void want(const QString &action, std::vector<drive::WishContent> acts);
    /// Whether want() would ask now.
    bool wouldAsk(const std::vector<drive::WishContent> &acts) const;
    bool asking() const { return !m_asked.empty(); }
    /// A speed and a start as one act that lasts while something is held: sent at once or not at all. Where the start
    /// has to be asked about, only the agreement is taken, and nothing moves until it is held again.
    /// @param rpm  within a fifth of the limit, so that nothing but the start can be in question
    /// @return     whether it was sent
    bool jog(const QString &action, int motor, std::int32_t rpm);
    /// Whether jog() would move this motor without asking about its start.
    bool jogAgreed(int motor) const
    {
        return m_started.contains(motor) || m_agreed.contains(motor);
    }

    /// What a start of the motor would go to, by what was read last; nothing of what is stale.
    drive::StartTarget startTarget(int motor) const;
    /// The same for people: "1500 rpm"; empty: not known.
    QString startText(int motor) const;

    /// An experiment moves a motor from now on, or does no more: what is asked for meanwhile ends it.
    void setExperiment(bool running) { m_experiment = running; }
    /// What of an act of several wishes has not been sent is not sent any more.
    void dropRest() { m_rest.clear(); }

public Q_SLOTS:
    void confirm();
    /// Before confirm(): steps up to the set-points of this question are not asked about again, until it is disarmed.
    void agreeToSteps();
    void decline();

Q_SIGNALS:
    void asked(const widgets::MotionQuestion &question);
    /// The board does not tell all limits of this motor: nothing was sent, the user has to agree first.
    void expertNeeded(int motor);
    void withdrawn(); ///< no answer is needed any more
    void failed(const QString &sentence); ///< what was sent did not end well

private:
    drive::MotionScene sceneOf(int motor) const;
    void setReferences(drive::MotionScene &scene, int motor) const;
    std::optional<double> reading(const char *name, int motor) const;
    std::optional<double> shaftOf(int motor) const; ///< where it is [rad]
    QStringList linesOf(const drive::WishContent &act, const drive::MotionScene &scene,
        const drive::StartTarget &target) const;
    bool needsExpert(const std::vector<drive::WishContent> &acts);
    void ask();
    void send();
    void withdraw();
    void withdrawAndTell(const QString &why);
    void forgetStarts();
    void linkChanged();
    QStringList subject() const;
    void sendNext();
    void ended(const drive::Ended &ended);

    struct Open {
        QString action;
        int startOf = 0; ///< a START of this motor; 0: something else
    };

    Device &m_device;
    RegisterModel &m_registers;
    /// Motors since the board was met. Agreed: to jogging alone, a start by its own button is asked about all the same.
    std::set<int> m_started, m_agreed;
    /// Magnitudes of set-points, by motor: steps up to them were agreed to.
    struct Agreed {
        double rpm = 0.0, amps = 0.0;
    };
    std::map<int, Agreed> m_agreedSteps;
    Agreed stepsOf(const std::vector<drive::WishContent> &acts) const;
    QString offerFor(const std::vector<drive::WishContent> &acts) const;
    QMap<drive::WishId, Open> m_open; ///< sent and not ended
    QString m_action;
    std::vector<drive::WishContent> m_asked; ///< waits for an answer
    std::vector<drive::WishContent> m_rest; ///< of the act that is being sent
    drive::WishId m_last = 0; ///< whose end the rest waits for
    bool m_agreeOnly = false; ///< yes sends nothing
    QTimer m_patience; ///< with a board that is silent while a question is open
    bool m_experiment = false; ///< one is running
    bool m_hiccup = false; ///< since it was asked
    QStringList m_subject; ///< of the question, without what changes all the time
};

} // namespace widgets
