// The frequency response of a current loop, Iq by its reference, from a recording in which the speed's set-point went
// to and fro (lab/response_plan.h). Pure.
//
// The reference is known to the board without noise, and what it does above the speed loop's crossover hardly follows
// the current: the plain ratio Sxy / Sxx is right there. Left out are the frequencies of the machine itself, once,
// twice and k x 6 in an electrical turn, and those that a reference with one value for each turn of the speed loop does
// not hold. Source: Bendat and Piersol, Random Data, ch. 6 and 9.
#pragma once

#include "lab/evaluation/response_evaluation.h"

namespace lab {

/// The first such experiment in a recording; or why there is none, or nothing follows from it, without a full stop.
Result<FrequencyResponse, std::string> evaluateCurrentResponse(
    const capture::Capture &capture, const Happenings &all);

} // namespace lab
