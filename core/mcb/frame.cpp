#include "mcb/frame.h"

#include "base/crc.h"

#include <algorithm>

namespace mcb {
namespace {

constexpr std::uint16_t kReservedBit = 0x8000;

void put(Bytes &bytes, std::uint16_t word)
{
    bytes.push_back(static_cast<std::uint8_t>(word >> 8));
    bytes.push_back(static_cast<std::uint8_t>(word));
}

std::uint16_t wordAt(ByteView bytes, std::size_t index)
{
    return static_cast<std::uint16_t>(bytes[2 * index] << 8 | bytes[2 * index + 1]);
}

bool allAre(ByteView bytes, std::uint8_t value)
{
    return std::ranges::all_of(bytes, [value](auto byte) { return byte == value; });
}

} // namespace

Bytes encodeFrame(const Frame &frame)
{
    const std::size_t cyclic = std::min(frame.cyclic.size(), kMostCyclicWords);
    Bytes bytes;
    bytes.reserve(frameBytes(cyclic));
    const unsigned address = frame.address & kMostAddress;
    const auto command = static_cast<unsigned>(frame.command);
    put(bytes, static_cast<std::uint16_t>(address << 4 | command << 1 | (frame.pending ? 1U : 0U)));
    for (const std::uint16_t word : frame.config)
        put(bytes, word);
    for (const std::uint16_t word : WordView(frame.cyclic).first(cyclic))
        put(bytes, word);
    put(bytes, crc16Xmodem(bytes));
    return bytes;
}

Result<Frame, FrameError> decodeFrame(ByteView bytes)
{
    const std::size_t size = bytes.size();
    if (size < kConfigFrameBytes || size > kMostFrameBytes || size % 2 != 0)
        return fail(FrameError::WrongLength);
    if (allAre(bytes, 0xFF))
        return fail(FrameError::DeadHigh);
    if (crc16Xmodem(bytes) != 0) // over the CRC, too
        return fail(FrameError::BadCrc);
    const std::uint16_t header = wordAt(bytes, 0);
    if ((header & kReservedBit) != 0)
        return fail(FrameError::ReservedBit);
    Frame frame{static_cast<std::uint16_t>(header >> 4), static_cast<Command>(header >> 1 & 7),
        (header & 1) != 0, {}, {}};
    for (std::size_t i = 0; i < kConfigWords; ++i)
        frame.config[i] = wordAt(bytes, 1 + i);
    const std::size_t end = size / 2 - 1;
    for (std::size_t i = 1 + kConfigWords; i < end; ++i)
        frame.cyclic.push_back(wordAt(bytes, i));
    return frame;
}

Result<Frame, FrameError> decodeAnswer(ByteView bytes)
{
    auto frame = decodeFrame(bytes);
    if (!frame)
        return frame;
    if (allAre(bytes, 0))
        return fail(FrameError::DeadLow);
    if (frame->command < Command::Ack)
        return fail(FrameError::FromMaster);
    return frame;
}

} // namespace mcb
