// Frames of the Motion Control Bus on SPI. Values in, values out: no buffers kept, no state. Bytes are in the order of
// the line, so the upper byte of each 16-bit word comes first.
//
//   word 0       header: 15..4 address (bit 15 is 0) | 3..1 command | 0 pending, more fragments follow
//   words 1..4   config data, always four
//   words 5..    0 to 32 cyclic words, in the cyclic state only
//   last word    CRC-16/XMODEM of all words before it
//
// Source: "MCB protocol description"; codes 4 and the number of cyclic words: mcblib 0.4.9. Every example of the text
// is a row of tests/data/vectors/mcb.jsonl, with the CRCs that are misprinted there put right.
#pragma once

#include "base/bytes.h"
#include "base/result.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mcb {

using Words = std::vector<std::uint16_t>;
using WordView = std::span<const std::uint16_t>;

constexpr std::size_t kConfigWords = 4;
constexpr std::size_t kMostCyclicWords = 32;
constexpr std::size_t kConfigFrameBytes = 12; ///< header, config words, CRC
constexpr std::size_t kMostFrameBytes = kConfigFrameBytes + 2 * kMostCyclicWords;
constexpr std::uint16_t kMostAddress = 0x7FF;

/// The config part of a frame; a value longer than this comes in fragments.
using ConfigWords = std::array<std::uint16_t, kConfigWords>;

enum class Command : std::uint8_t {
    GetInfo = 0, ///< from the master, as Read and Write
    Read = 1,
    Write = 2,
    Ack = 3, ///< from the slave, as the errors
    ErrorOfInfo = 4, ///< or a general error: not in the text
    ErrorOfRead = 5,
    ErrorOfWrite = 6,
    Idle = 7, ///< from both, with any address
};

struct Frame {
    std::uint16_t address = 0; ///< up to kMostAddress
    Command command = Command::Idle;
    bool pending = false; ///< more fragments of this value follow
    ConfigWords config{};
    Words cyclic; ///< up to kMostCyclicWords
    bool operator==(const Frame &) const = default;
};

enum class FrameError : std::uint8_t {
    WrongLength, ///< odd, shorter than a config frame, longer than the longest
    BadCrc,
    ReservedBit, ///< bit 15 of the header is set
    DeadLow, ///< all bits 0: a line that is not driven has a correct CRC
    DeadHigh, ///< all bits 1
    FromMaster, ///< a command that no slave sends
};

/// How long a frame with so many cyclic words is.
constexpr std::size_t frameBytes(std::size_t cyclicWords)
{
    return kConfigFrameBytes + 2 * cyclicWords;
}

/// Ready for the line, CRC included. An address or a number of cyclic words beyond the bounds is cut to them.
Bytes encodeFrame(const Frame &frame);

/// Whatever either side may send; words that the value does not need are as they came.
Result<Frame, FrameError> decodeFrame(ByteView bytes);

/// What came from a slave. All zeros are a correct GET INFO of register 0 from a master, and a dead line here.
Result<Frame, FrameError> decodeAnswer(ByteView bytes);

} // namespace mcb
