// Conversation: one session with one board, asked step by step. Each step waits in the event loop until what it waits
// for has happened, the time is over, the connection broke or the user interrupted.
//
// Call order: connect(), then anything, then close(); or stopAtOnce() alone. The program has no other event loop, so
// none is nested.
#pragma once

#include "arguments.h"
#include "interrupt.h"
#include "lab/experiment.h"
#include "output.h"
#include "session/files/motion_log_file.h"
#include "session/link/session.h"
#include "session/recording/lent_note.h"
#include "session/recording/tap.h"

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace cli {

constexpr QLatin1String kStopNotConfirmed("Stop NOT confirmed. Use the hardware stop.");

enum class Waited : std::uint8_t { Happened, TimeOver };

class Conversation : public QObject {
    Q_OBJECT
public:
    using Milliseconds = std::chrono::milliseconds;

    /// @param guardian  stops the motors if this program dies; nullptr: they go on
    Conversation(const Arguments &arguments, const Interrupt &interrupt,
        std::shared_ptr<session::Guardian> guardian = {});
    ~Conversation() override;

    /// Opens the port, connects, learns what the board is.
    Outcome<drive::Identified> connect();
    /// Ends streaming and closes the port, within half a second. A motor goes on as it is.
    void close();

    /// Asks for something and waits for its end. Not armed: what writes or moves ends NotSent. What could not leave in
    /// time is asked for again, a few times: nothing of it has left.
    Outcome<drive::Ended> ask(const decltype(drive::Wish::what) &what);
    /// ask() for what changes something: whatever ends it, also what is known until then. At least one is there.
    struct Asked {
        std::optional<drive::Ended> ended;
        std::optional<Failure> broken; ///< the connection is closed then
    };
    Asked askToTheEnd(const decltype(drive::Wish::what) &what);
    /// ask() for what must succeed: any other outcome is a failure that begins with `what`. `advice` ends the sentence
    /// about a refusal.
    Outcome<int> command(const decltype(drive::Wish::what) &wish, const QString &what,
        const QString &advice = QStringLiteral(
            "look at the board's state and faults with rotorscope-cli info"));
    /// Readings in the order of the ids; a register that never answered is NotSupported at no time.
    Outcome<std::vector<drive::Reading>> read(const std::vector<drive::RegisterId> &ids);
    /// The newest status of a motor; waits for the first one.
    Outcome<drive::MotorStatus> status(int motor);
    /// A status that was taken after this call.
    Outcome<drive::MotorStatus> nextStatus(int motor);

    void arm();
    /// Arms; set-points travel with every exchange from then on where that was asked for.
    Outcome<int> armToMove();
    /// Limits of this run, and expert mode where it was asked for and something is unknown; after connect().
    Outcome<int> bound(const drive::Identified &board);
    /// The board with the scale of currents that the user gave for all its motors; after connect().
    Outcome<drive::Identified> scaled(const drive::Identified &board);
    /// What was asked of the motors, so far.
    const std::vector<session::LoggedMotion> &motionLog() const { return m_motionLog; }
    const drive::LinkCounters &lineCounters() const { return m_counters; } ///< the newest
    /// Carries out an experiment, which takes as long as its plan; armToMove() comes before it.
    Outcome<lab::Outcome> run(const lab::Experiment &experiment);
    /// How the last one ended, also where run() failed and something else, such as stop(), ended it.
    const std::optional<lab::Outcome> &experimentEnded() const { return m_experimentEnded; }
    /// Stops every motor; waits until the drive is idle (2 s at most), then up to `standstill` until they stand still.
    /// Works after an interrupt, too.
    /// @return  how far it was confirmed; a failure if the drive was not seen idle
    Outcome<drive::StopWord> stop(Milliseconds standstill);

    /// Opens the port and stops every motor before anything else is asked of the board, in whatever language it is
    /// found to speak; blind where no answer comes. Then as stop(). An interrupt does not end it before the STOPs have
    /// left.
    /// @return  as stop(); each failure says that the motors may turn
    Outcome<drive::StopWord> stopAtOnce(Milliseconds standstill);

    Outcome<Waited> waitUntil(const std::function<bool()> &condition, Milliseconds limit);

    /// What a recording of this conversation listens to.
    const std::shared_ptr<session::RecordingTap> &tap() const { return m_tap; }

    /// Called for each event, besides what is kept here.
    void listen(std::function<void(const drive::Event &)> listener)
    {
        m_listener = std::move(listener);
    }

private:
    /// What `told` holds within the limit; a failure that names `late` if it holds nothing.
    template <class T>
    Outcome<T> waitFor(const std::optional<T> &told, Milliseconds limit, drive::LinkReason late);
    void onBatch(const session::BatchPtr &batch);
    void accept(const drive::Event &event);
    void onInterruption(const session::Interruption &what);
    void onPort(session::PortState state, const session::PortError &why);
    bool ended() const;
    Failure endReason() const;
    bool allStopped(drive::StopWord least) const;
    bool stopsHaveLeft() const;
    drive::StopWord standstillWithin(Milliseconds limit);

    Arguments m_arguments;
    const Interrupt &m_interrupt;
    std::shared_ptr<session::LentNote> m_lentNote = std::make_shared<session::LentNote>();
    std::shared_ptr<session::RecordingTap> m_tap = std::make_shared<session::RecordingTap>();
    session::Session m_session;
    std::function<void(const drive::Event &)> m_listener;
    /// Neither an interrupt nor a lost link ends this: the drive stops blind.
    bool m_stopping = false;
    std::optional<Failure> m_broken; ///< why the connection is no more
    std::optional<drive::Identified> m_board;
    bool m_answered = false; ///< there was a connection
    std::map<int, drive::MotorStatus> m_status;
    std::map<int, drive::StopWord> m_stopWords;
    std::map<drive::RegisterId, drive::Reading> m_readings; ///< since the last read()
    std::vector<session::LoggedMotion> m_motionLog;
    drive::LinkCounters m_counters;
    std::optional<drive::Ended> m_ended;
    std::optional<lab::Outcome> m_experimentEnded;
    drive::WishId m_lastWish = 0;

Q_SIGNALS:
    void changed(); ///< something was told: what waits looks again
};

} // namespace cli
