// Entries to the payload of a block and back. docs/recording-format.md has the layout of every kind.
//
//   "RS" | u8 version 1 | u8 kind | body     little-endian; a text is a u16 length and UTF-8
// Link bytes have no payload header: the block holds the bytes of the line and nothing else.
#pragma once

#include "base/result.h"
#include "recorded/entry.h"

namespace recorded {

constexpr std::uint8_t kPayloadVersion = 1;
constexpr std::size_t kMostPayload = std::size_t{1} << 20; ///< bytes of one block
constexpr std::size_t kMostSignals = 1024; ///< of a layout, fast or slow; boards have a handful

enum class PayloadError : std::uint8_t {
    TooLong, ///< more than kMostPayload, or a text of more than 65535 bytes
    NotOurs, ///< no "RS", or a version that is not known
    UnknownKind, ///< of a later version: to be passed over
    Malformed, ///< a length that does not fit, or a number that makes no sense
};

/// A Layout or PolledRegister that was written before, once more, for readers that lost the first one.
enum class Repeat : bool { No, Yes };

/// Sizes agree and are within bounds: columns can be cut out of it, and it can be written.
bool isWhole(const capture::SampleBlock &block);

/// A tick within three years of the session's 0 s, as all samples of a recording are: times are 64 bits.
bool isNear(const capture::StreamLayout &layout, double tick);

/// Not for LinkBytes. Fails with TooLong only.
Result<Bytes, PayloadError> encodeEntry(const Entry &entry, Repeat repeat = Repeat::No);

/// The same of a block whose fast samples lie in columns, one a signal, `block.count` each, instead of in `fast`.
/// @param room  bytes for what the caller puts around it, and for all that is not fast: allocated at once
Bytes encodeSamples(const capture::SampleBlock &block,
    std::span<const std::vector<std::int16_t>> columns, std::size_t room);

struct Decoded {
    Entry entry;
    Repeat repeat = Repeat::No;
};
/// Every length is checked against what is there before anything is allocated. Bytes behind the body are passed over.
/// A payload that only keeps a place (kind 0) is UnknownKind.
Result<Decoded, PayloadError> decodeEntry(ByteView payload);

} // namespace recorded
