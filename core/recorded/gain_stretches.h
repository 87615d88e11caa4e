// The stretches of a recording between one change of gains and the next: what a board read back of a written gain parts
// them. Times are those of the entries, so a packet of samples belongs to the stretch in which it arrived.
#pragma once

#include "recorded/entry.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace recorded {

/// A register whose name says so, e.g. "SPEED_KP" or "SPEED_KP@2".
bool isGain(std::string_view name);

struct GainStretch {
    Nanos from = 0, to = 0;
    /// Digits, by the names in the recording; those that were ever written.
    std::map<std::string, double> gains;
};

class GainStretches {
public:
    /// In the order of the file.
    void accept(Nanos at, const Entry &entry);
    /// What comes from then on is a stretch of its own, with the same gains. Nothing where one begins there anyway.
    void part(Nanos at);
    /// By their time. Of a gain that nothing was told of until it was written, what it was before counts.
    const std::vector<GainStretch> &all() const { return m_all; }

private:
    void change(Nanos at, const std::string &name, double before, double after);

    std::vector<GainStretch> m_all;
};

} // namespace recorded
