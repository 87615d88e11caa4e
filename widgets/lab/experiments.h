// Experiments: the window's side of what moves a motor by itself. It hands one to the session, keeps in memory what a
// recording of it would hold, entry by entry, and the caps that the user has agreed to since the drive was armed. What
// the entries mean is evaluated from them alone, as from a file.
//
// One at a time, or several in a row, each from where the motor was before: begin(), progressed() as it goes on, then
// ended() once. A Stop, or any other command, ends all of it; that needs nothing of this class.
#pragma once

#include "lab/caps.h"
#include "lab/happenings.h"
#include "recorded/restore.h"
#include "session/recording/tap.h"
#include "widgets/base/device.h"

#include <QObject>

#include <memory>
#include <vector>

namespace widgets {

class Experiments : public QObject {
    Q_OBJECT
public:
    struct Run {
        Run() = default;
        Run(const Run &) = delete; // Qt would copy what a signal tells
        Run &operator=(const Run &) = delete;
        lab::Outcome outcome;
        capture::Capture capture;
        lab::Happenings happenings; ///< of each its plan first, its end last
        std::vector<session::ToldPtr> told; ///< all of it, as a recording of it would hold it
        qint64 startSeconds = 0; ///< UTC of the session's 0 s
    };
    using RunPtr = std::shared_ptr<const Run>;
    struct Part {
        lab::Experiment experiment;
        recorded::Happening plan; ///< the same as an entry of its recording
    };

    /// @param tap  of the session, and of nothing else; @param clock  the session's
    Experiments(Device &device, std::shared_ptr<session::RecordingTap> tap, session::Clock clock,
        QObject *parent = nullptr);

    /// The motor that is shown; or why nothing can be measured with it, whatever it does.
    /// @param pollable  nothing but what polled values tell as well
    Result<lab::Subject, QString> subject(bool pollable = false) const;
    /// Why none can begin now; one sentence, empty if one can.
    QString obstacle(bool pollable = false) const;
    /// Whether the user has agreed to such a one within its caps. @param before_rpm  as capsOf() has it
    bool agreed(const lab::Experiment &experiment, double before_rpm) const;
    void agree(const lab::Experiment &experiment, double before_rpm);

    /// To be called only for what was agreed to; one after the other, as long as each comes to its end, leaves all as
    /// it was and is agreed to. Nothing while one is running.
    void begin(std::vector<Part> parts, double before_rpm);
    bool running() const { return m_run != nullptr; }
    std::size_t part() const { return m_part; } ///< the one that is running, from 0
    const lab::Happenings &happenings() const { return m_run->happenings; } ///< while running()

public Q_SLOTS:
    void accept(const session::ToldPtr &told);
    void end(const lab::Outcome &outcome);

Q_SIGNALS:
    void wished(const lab::Experiment &experiment); ///< for the session
    /// The plan and the end, for a recording.
    void noted(qint64 at, const recorded::Happening &what);
    void began();
    void progressed();
    void ended(const widgets::Experiments::RunPtr &run);
    void agreementEnded();

private:
    void beginPart(TimePoint now);
    void note(TimePoint at, const recorded::Happening &what);
    void forgetAgreement();

    Device &m_device;
    std::shared_ptr<session::RecordingTap> m_tap;
    session::Clock m_clock;
    std::vector<lab::Agreement> m_agreed; ///< for the motor that is shown, since it was armed
    std::vector<Part> m_parts;
    std::size_t m_part = 0;
    double m_before_rpm = 0.0;
    lab::Outcome m_soFar; ///< of those that are over
    std::shared_ptr<Run> m_run; ///< of what is running
    std::unique_ptr<recorded::Restorer> m_restorer;
    unsigned m_number = 0;
};

} // namespace widgets
