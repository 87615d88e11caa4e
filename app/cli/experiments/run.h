// An experiment from the command line: recorded, carried out, and evaluated from its recording, as every later
// evaluation is.
#pragma once

#include "commands.h"
#include "experiments/running_motor.h"
#include "lab/experiment.h"
#include "recording_work.h"

#include <QTemporaryDir>

namespace cli {

class ExperimentRun {
public:
    /// @param file  in which its recording is kept; empty: it is not
    ExperimentRun(Desk &desk, const QString &file);
    explicit ExperimentRun(Desk &desk)
        : ExperimentRun(desk, desk.arguments.runFile)
    {
    }

    /// The motor that is meant; a failure if nothing can be measured with this board.
    /// @param pollable  nothing but what polled values tell as well
    Outcome<lab::Subject> subject(bool pollable = false) const;
    /// One after the other, each from where the motor was before, as long as nothing is left on the board; in one
    /// recording. A motor that runs is stopped for what is measured at rest, and runs again behind all of them.
    /// @return  the exit status of the evaluation's report; a failure if one of them did not come to its end
    Outcome<int> run(const lab::Subject &subject, const std::vector<lab::Plan> &plans);
    /// The same, without an evaluation. @return  the file of its recording, which lives as long as this
    Outcome<QString> record(const lab::Subject &subject, const std::vector<lab::Plan> &plans);

    /// That recording ended because the speed did not come to rest.
    bool swings() const { return m_swings; }

private:
    struct Part {
        lab::Experiment experiment;
        recorded::Happening entry; ///< the plan, as its recording has it
    };
    Outcome<lab::Outcome> carryOut(const std::vector<Part> &parts);
    Outcome<lab::Outcome> runAll(const std::vector<Part> &parts, ConversationRecording &recording);
    Outcome<QString> told(const lab::Outcome &outcome);
    Failure broken(const Failure &why, ConversationRecording &recording);
    Failure stopped(Failure why);
    tl::unexpected<Failure> notGoingOn(Failure why) const;

    Desk &m_desk;
    QTemporaryDir m_folder; ///< for a recording that is not kept
    std::optional<RunningMotor> m_ran; ///< it is measured at rest
    bool m_rests = false; ///< that one: it was stopped
    lab::Outcome m_soFar; ///< of those that are over
    bool m_kept, m_swings = false;
    QString m_path;
};

/// -o RUN.pcapng of an experiment; a failure if the file is there already.
Outcome<bool> readRunFile(const Given &given, Arguments &arguments);
constexpr OptionText kRunOption{
    "o,output", "RUN.pcapng", "Keeps the recording, for rotorscope-cli evaluate."};

} // namespace cli
