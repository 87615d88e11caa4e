// Signals of one stream side by side, without a gap inside: what evaluations integrate over.
#pragma once

#include "capture/capture.h"

#include <span>
#include <string>
#include <vector>

namespace lab {

struct Segment {
    capture::Nanos at = 0; ///< its first sample
    double step_s = 0.0; ///< between two samples
    /// Of the board's control loops, of which not each may have been recorded.
    double period_s = 0.0;
    double first_deg = 0.0; ///< the angle at its beginning
    std::vector<double> turned_deg; ///< electrical, since its beginning, turns included
    std::vector<std::vector<double>> values; ///< one list a channel, as long

    double angle_rad(std::size_t sample) const; ///< electrical
};

/// The segments of [from, to) with three samples or more. None if the channels are not of one stream.
/// @param angle  electrical, in degrees, wrapped anyhow
std::vector<Segment> segmentsOf(const capture::Channel &angle,
    std::span<const capture::Channel *const> others, capture::Nanos from, capture::Nanos to);

/// The same of signals by their names; none if one was not recorded.
std::vector<Segment> segmentsOf(const capture::Capture &capture, const std::string &angle,
    const std::vector<std::string> &others, capture::Nanos from, capture::Nanos to);

/// The same of a speed and others that were read one after the other, or came with each exchange: on even steps, on
/// straight lines between what was read. The angle is mechanical, and counts from the beginning.
/// @param speed  rpm
/// @param farthest_s  nothing where two values of a channel are further apart
std::vector<Segment> segmentsOfReads(const capture::Channel &speed,
    std::span<const capture::Channel *const> others, capture::Nanos from, capture::Nanos to,
    double step_s = 5e-3, double farthest_s = 0.1);

/// Between the segments of segmentsOf(), s: samples that are not in any of them.
double missingIn(const std::vector<Segment> &segments);
/// Says how much is missing, if anything is.
void noteGaps(std::vector<std::string> &notes, double missing_s);

/// What of it the rotor turned through, in pieces of one direction: friction holds a rotor that stands by whatever it
/// takes, and no equation of a motor that turns is true of it.
/// @param least_degPerS  electrical; slower is as good as standing
/// @param edge_s  to either side of a sample, for its speed
std::vector<Segment> whileTurning(
    std::vector<Segment> segments, double least_degPerS, double edge_s = 5e-3);

/// What the current does within a control period is not seen: where the rotor turns far in one, and the inductance is
/// small, its mean is beside its samples. As a share of what follows from it, the square of that angle; next to nothing
/// up to 17 degrees.
double seldomSeen(double turn_rad);
std::string seldomSeenNote(double turn_rad); ///< without a full stop

} // namespace lab
