// Experiments: the window's side of what moves a motor by itself. It hands one to the session, keeps in memory what a
// recording of it would hold, entry by entry, and knows to which caps a person has agreed since the drive was armed. What
// the entries mean is evaluated from them alone, as from a file.
//
// One at a time: begin(), progressed() as it goes on, then ended() once. A Stop, or a command of anybody else, ends it;
// that needs nothing of this class.
#pragma once

#include "lab/caps.h"
#include "lab/happenings.h"
#include "lab/outcome.h"
#include "record/restore.h"
#include "session/recording/recording_tap.h"
#include "widgets/base/device.h"

#include <QObject>

#include <memory>
#include <vector>

namespace widgets {

class Experiments : public QObject {
    Q_OBJECT
public:
    struct Record {
        Record() = default;
        Record(const Record &) = delete; // Qt would copy what a signal tells
        Record &operator=(const Record &) = delete;
        lab::Outcome outcome;
        capture::Capture capture;
        lab::Happenings happenings; ///< the plan first, the end last
        std::vector<session::ToldPtr> told; ///< all between, as a recording of it would hold it
        qint64 startSeconds = 0; ///< UTC of the session's 0 s
    };

    /// @param tap  of the session, and of nothing else; @param clock  the session's
    Experiments(Device &device, std::shared_ptr<session::RecordingTap> tap, session::Clock clock,
        QObject *parent = nullptr);

    /// The motor that is shown; or why nothing can be measured with it, whatever it does.
    Result<lab::Subject, QString> subject() const;
    /// Why none can begin now; one sentence, empty if one can.
    QString obstacle() const;
    /// Whether a person has agreed to its caps. @param before_rpm  as capsOf() has it
    bool agreed(const lab::Experiment &experiment, double before_rpm) const;
    void agree(const lab::Experiment &experiment, double before_rpm);

    /// To be called only for what was agreed to. Nothing while one is running.
    /// @param plan  the same as an entry of its recording
    void begin(const lab::Experiment &experiment, const record::Happening &plan);
    bool running() const { return m_record != nullptr; }
    const lab::Happenings &happenings() const { return m_record->happenings; } ///< while running()

public Q_SLOTS:
    void take(const session::ToldPtr &told);
    void end(const lab::Outcome &outcome);

Q_SIGNALS:
    void wished(const lab::Experiment &experiment); ///< for the session
    void noted(qint64 at, const record::Happening &what); ///< the plan and the end, for a recording
    void began();
    void progressed();
    void ended(const widgets::Experiments::Record &record);
    void agreementEnded();

private:
    void note(TimePoint at, const record::Happening &what);
    void forgetAgreement();

    Device &m_device;
    std::shared_ptr<session::RecordingTap> m_tap;
    session::Clock m_clock;
    std::vector<lab::Caps> m_agreed; ///< of the motor that is shown, since it was armed
    std::unique_ptr<Record> m_record; ///< of the one that is running
    std::unique_ptr<record::Restorer> m_restorer;
    unsigned m_number = 0;
};

} // namespace widgets
