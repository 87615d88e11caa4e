// Requests and answers between the tasks of McbDrive and its link, as bytes: a request is its frames as on the wire in the
// config state, which is what the motion log keeps; an answer is ours.
#pragma once

#include "base/bytes.h"
#include "drive/wish.h"
#include "mcb/master.h"

#include <optional>
#include <string>

namespace drive {

// The registers that this drive is driven by. Source: "MCB protocol description", section 7.
namespace mcbreg {
constexpr std::uint16_t kLastError = 0x00F, kControl = 0x010, kStatus = 0x011, kMode = 0x014,
                        kIq = 0x01A, kId = 0x01B, kPosition = 0x020, kVelocity = 0x021,
                        kProfileVelocity = 0x025, kProfileAcceleration = 0x026,
                        kProfileDeceleration = 0x027, kPositionNow = 0x030, kVelocityNow = 0x031,
                        kRatedCurrent = 0x100, kPolePairs = 0x106, kMaxCurrent = 0x1E0,
                        kMaxVelocity = 0x1E8, kEncoderCounts = 0x388, kVendor = 0x6E0,
                        kProduct = 0x6E1, kRevision = 0x6E2, kVersion = 0x6E4, kWeb = 0x6E5,
                        kSerial = 0x6E6, kPeakCurrent = 0x71F;
} // namespace mcbreg

Bytes mcbRead(std::uint16_t address);
Bytes mcbInfo(std::uint16_t address);
Bytes mcbWrite(std::uint16_t address, mcb::WordView words);
/// The way into the cyclic state, and out of it.
Bytes mcbMap(const mcb::Mapping &mapping);
Bytes mcbUnmap();

struct McbRequest {
    enum class Kind : std::uint8_t { One, Map, Unmap } kind = Kind::One;
    mcb::Master::Request request; ///< of One
    mcb::Mapping mapping; ///< of Map
};
McbRequest mcbRequestOf(ByteView request);
bool mcbReads(ByteView request); ///< it changes nothing

struct McbAnswer {
    bool ok = false; ///< false: refused
    mcb::Words words; ///< of the answer
    std::uint32_t code = 0; ///< of the refusal
};
Bytes mcbAnswer(const mcb::Master::Done &done);
McbAnswer mcbAnswerOf(ByteView response);

/// In the place of a code, but ours: the drive took the value, and another one is read back.
constexpr std::uint32_t kOtherValueRead = 0xFFFFFFFF;

/// What a code means, and the code: "no such register (0x06020000)".
std::string mcbWordOf(std::uint32_t code);
std::string hexText(std::uint64_t number, int digits);

} // namespace drive
