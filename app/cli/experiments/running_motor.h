// A motor that runs, for an experiment that measures it at rest: it is stopped before, and started again and brought
// back to its speed behind one that came to its end and left all as it was. The command that was typed is the word for
// all of that.
//
// Call order: runningMotor(), then stop(), the experiment, goOn().
#pragma once

#include "commands.h"
#include "lab/experiment.h"

#include <chrono>
#include <optional>
#include <vector>

namespace cli {

class RunningMotor {
public:
    RunningMotor(
        Desk &desk, lab::Subject subject, int rpm, std::optional<std::chrono::milliseconds> ramp);

    /// Of this motor; seen to be idle then. Behind a failure it may go on turning.
    Outcome<bool> stop();
    /// Once it stands, as far as that is seen; at its old speed then, and its set-point as it was. Behind a failure it
    /// may turn in any way.
    Outcome<bool> goOn();

private:
    Outcome<bool> reach();

    Desk &m_desk;
    lab::Subject m_subject;
    int m_rpm; ///< set-point, signed
    /// In which a start goes there; empty: not told.
    std::optional<std::chrono::milliseconds> m_ramp;
};

/// Empty: it rests, is measured as it runs, or is not in speed control, which the experiment refuses in its own words.
/// A failure where it would not be brought back to what it does now; nothing that moves it is sent.
Outcome<std::optional<RunningMotor>> runningMotor(
    Desk &desk, const lab::Subject &subject, const std::vector<lab::Experiment> &wanted);

} // namespace cli
