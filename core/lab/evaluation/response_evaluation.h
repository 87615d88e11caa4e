// The frequency response of a motor and of its speed loop, from a recording in which the set-point went to and fro
// (lab/response_plan.h). Pure.
//
// In a closed loop noise goes round, and the ratio of speed to current is biased by it; the ratio of what both share
// with the set-point is not: G = Sry / Sru. A constant delay of the set-point cancels. Source: the instrument of H.
// Akaike, Ann. Inst. Stat. Math. 18 (1966); errors: Bendat and Piersol, Random Data, ch. 9.
#pragma once

#include "lab/experiment.h"
#include "lab/happenings.h"
#include "lab/maths/statistics.h"

#include <complex>
#include <optional>
#include <string>
#include <vector>

namespace lab {

struct ResponsePoint {
    double hz = 0.0;
    /// Speed of the shaft by Iq: (rad/s)/A, an observed one without what its angle owes to the current alone; where
    /// samples came with each exchange, the speed as the drive takes it, which is a mean; of a current loop Iq by its
    /// reference.
    std::complex<double> plant;
    bool plantKnown = true; ///< else what an observer adds is too much of it
    double relative = 0.0; ///< standard error of its gain, and of its phase in rad
    double coherence = 0.0; ///< the smaller one of both signals with the set-point
    std::complex<double> loop; ///< as the regulator closes it; 0: its gains are not known
    double loopRelative = 0.0; ///< standard error of it, and of its phase in rad
};

/// Of a loop.
struct FrequencyResponse {
    std::vector<ResponsePoint> points; ///< with a coherence of a half or more, by frequency
    std::optional<Estimate> crossover_hz, phaseMargin_deg;
    std::optional<Estimate> ms; ///< largest of 1 / |1 + loop|
    std::vector<std::string> notes; ///< sentences without a full stop
};
struct SpeedResponse : FrequencyResponse {
    SpeedRegulator regulator; ///< that closed it
    /// Rms of the current's reference that does not follow the set-point.
    double referenceNoise_a = 0.0;
};

/// Of a motor without an encoder: takes what follows the current out of the angle again, as far as one inertia with
/// friction explains it, and adds a note on that.
void correctObserved(SpeedResponse &found, double polePairs);

/// From which on points count for the margins of a speed loop.
inline constexpr double kLeastMarginCoherence = 0.5;
/// Crossover, phase margin and Ms by the loop of those points that are coherent enough.
void addMargins(FrequencyResponse &found, double leastCoherence);
/// Of a gain by one of two signals, relative, squared: standard error. Of its phase in rad, too.
double varianceOf(double coherence, int averages);

/// What a regulator makes of an error, with the hold of its output: A/rpm.
std::complex<double> regulatorAt(const SpeedRegulator &regulator, double hz);

/// Whether it is the end of a write by which a gain of this motor, or what its digits weigh, became or may have become
/// another.
bool changesGains(int motor, const recorded::Happening &what);
/// Then the loop is neither the one before nor the one behind, and nothing follows.
inline constexpr const char *kGainsChanged = "the gains were changed while it was measured";

/// The first such experiment in a recording; or why there is none, or nothing follows from it, without a full stop.
Result<SpeedResponse, std::string> evaluateResponse(
    const capture::Capture &capture, const Happenings &all);

} // namespace lab
