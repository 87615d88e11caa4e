// The reasons that a slave gives for a refusal: a number in the first two config words, low word first.
// Source: the table of "MCB protocol description". The text's own example has the words the other way round.
#pragma once

#include "mcb/frame.h"

#include <string_view>

namespace mcb {

/// Codes that the text names; a drive may send any other number.
enum class ErrorCode : std::uint32_t {
    AccessNotSupported = 0x06010000, ///< a write to what is read-only, a read of what is write-only
    NoSuchRegister = 0x06020000,
    CannotBeMapped = 0x06040041, ///< config only, or of the other direction
    TooMuchMapped = 0x06040042, ///< more than 32 cyclic words
    General = 0x08000000,
    BadCyclicIndex = 0x08010000, ///< a gap in the mapping list
    CyclicNotReachable = 0x08010010,
    MappingRefused = 0x08010020,
    InvalidCommand = 0x08010030,
    BadCrc = 0x08010040, ///< the slave saw one
};

/// "no such register"; "error" for every code that is none of those above.
std::string_view meaningOf(std::uint32_t code);
/// True for the codes above.
bool isKnown(std::uint32_t code);

/// The code in an error frame. Words that make no known code are tried in the other order, and if that makes none
/// either the number is given as the rule has it.
std::uint32_t errorCodeOf(const ConfigWords &config);

ConfigWords configOf(ErrorCode code);

} // namespace mcb
