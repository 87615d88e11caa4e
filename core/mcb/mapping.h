// Which registers travel in every cyclic frame, and how the drive is told. Source: "MCB protocol description", section
// on mapping; the rounding to whole words and the common length are mcblib's.
#pragma once

#include "mcb/value.h"

#include <algorithm>

namespace mcb {

constexpr std::uint16_t kStateRegister = 0x640; ///< 1 config, 2 cyclic
constexpr std::uint16_t kRxCountRegister = 0x650, kTxCountRegister = 0x660;
constexpr std::uint16_t kConfigState = 1, kCyclicState = 2;
constexpr std::size_t kMostMapped = 15; ///< each way

struct MappedRegister {
    std::uint16_t address = 0;
    std::uint8_t size = 0; ///< bytes
    bool operator==(const MappedRegister &) const = default;
};

struct Mapping {
    std::vector<MappedRegister> rx; ///< master to drive
    std::vector<MappedRegister> tx; ///< drive to master
    bool operator==(const Mapping &) const = default;

    /// Cyclic words of a frame: the longer direction.
    std::size_t words() const { return std::max(wordsOfList(rx), wordsOfList(tx)); }

    static std::size_t wordsOfList(const std::vector<MappedRegister> &list)
    {
        std::size_t sum = 0;
        for (const MappedRegister &one : list)
            sum += wordsOf(one.size);
        return sum;
    }
    /// Fits the lists and a frame, and maps something.
    bool possible() const
    {
        return rx.size() <= kMostMapped && tx.size() <= kMostMapped && words() > 0
            && words() <= kMostCyclicWords;
    }
};

/// A write of the procedure.
struct MappingStep {
    std::uint16_t address = 0;
    Words words;
};

/// Every write that brings the cyclic state about, in order: cyclic off, entries, counts, cyclic on.
/// @param clearCounts  sets both counts to 0 before the entries, as mcblib does and the text does not
std::vector<MappingStep> stepsOf(const Mapping &mapping, bool clearCounts);

} // namespace mcb
