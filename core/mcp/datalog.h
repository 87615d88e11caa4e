// The datalog: what to record, and the shape of the packets that follow from it.
//
// Configuration (raw value of ASYNC_UARTA/UARTB/STLNK): u16 buffer size | u8 HF rate | u8 HF count | u8 MF rate |
// u8 MF count | u16 ids | u8 mark. The printed text forgets the buffer size. Buffer size 0 or mark 0 stops.
// Packet (ASYNC payload): u32 timestamp in control periods | blocks | u8 mark | u8 async id, 0 for the datalog.
// A block is one 16-bit value a HF signal; after every (MF rate + 1)th block of a packet follow the MF values at their
// native widths. MF rate 254: once, at the end of the packet; 255: never. Block i is of the tick
// timestamp + i * (HF rate + 1).
// Source: firmware 6.0 to 6.4.2, recorded packets of 6.4.0 and 6.2.0.
#pragma once

#include "mcp/value.h"

#include <optional>
#include <vector>

namespace mcp {

constexpr std::uint8_t kSlowAtEnd = 254; ///< MF rate: once a packet
constexpr std::uint8_t kSlowNever = 255; ///< MF rate: not at all
constexpr std::size_t kDatalogOverhead = 6; ///< timestamp, mark and async id

struct DatalogConfig {
    std::uint16_t bufferSize = 0; ///< largest payload wanted
    std::uint8_t fastRate = 0; ///< HF rate: one block every fastRate + 1 control periods
    std::vector<RegisterId> fast; ///< with motor bits; never motor 0, which crashes firmware
    std::uint8_t slowRate = kSlowNever; ///< MF rate
    std::vector<RegisterId> slow;
    std::uint8_t mark = 0; ///< 1..255, another one for each configuration

    bool stops() const { return bufferSize == 0 || mark == 0; }
    bool operator==(const DatalogConfig &) const = default;
};

/// What ends recording, as the vendor's tool sends it: 00 08 00 00 FF 00 00. A board that agreed to less refuses a
/// larger buffer, even where it is only to stop. @param asyncMax  negotiated, bytes
DatalogConfig datalogStop(std::size_t asyncMax);

/// Which register configures the datalog of the link that the Ping reply named; with motor 1, see DatalogConfig::fast.
RegisterId datalogRegister(std::uint8_t linkId);
/// Whether a register configures the datalog of some link; its motor bits do not count.
bool isDatalogRegister(RegisterId id);

/// Fails if an id has no motor or a list is longer than its count can say.
Result<Bytes, CodecError> encodeDatalog(const DatalogConfig &config);

/// Also reads what only stops (buffer size 0 and nothing behind it). Bytes behind the mark are passed over, as firmware
/// does.
Result<DatalogConfig, CodecError> decodeDatalog(ByteView raw);

/// The shape of the packets of one configuration.
class DatalogLayout {
public:
    explicit DatalogLayout(const DatalogConfig &config);

    std::size_t fastBytes() const { return m_fastBytes; } ///< of one block
    std::size_t slowBytes() const { return m_slowBytes; } ///< of one MF group
    unsigned step() const { return m_step; } ///< ticks between two blocks
    /// Blocks between two MF groups; 0 if there is no repeating group.
    std::size_t blocksAGroup() const { return m_blocksAGroup; }

    /// Payload of a packet that was filled to its end; empty if none is ever sent.
    std::optional<std::size_t> fullLength() const { return m_fullLength; }
    /// Blocks of a full packet.
    std::size_t fullBlocks() const { return m_fullBlocks; }
    /// Blocks in a payload of `length` bytes; empty if no number of blocks gives it.
    /// Any length below the full one is that of a packet that a stop or a fault sent off: with MF rate 254 it has no MF
    /// group.
    std::optional<std::size_t> blocksIn(std::size_t length) const;
    /// Whether a payload of `length` bytes ends in an MF group.
    bool endsInGroup(std::size_t length) const { return m_slowAtEnd && m_fullLength == length; }
    /// The smallest buffer that firmware accepts.
    std::size_t smallestBuffer() const { return m_fastBytes + m_slowBytes + kDatalogOverhead; }

private:
    void fill(std::size_t bufferSize);

    std::size_t m_fastBytes = 0;
    std::size_t m_slowBytes = 0;
    unsigned m_step = 1;
    std::size_t m_blocksAGroup = 0;
    bool m_slowAtEnd = false;
    std::optional<std::size_t> m_fullLength;
    std::size_t m_fullBlocks = 0;
};

struct DatalogLink {
    std::size_t asyncMax = 0; ///< negotiated, bytes
    double tickHz = 0.0; ///< control periods a second
    std::uint32_t baud = 1843200;
};

/// The buffer size for these signals: as large as the link takes, but at most 12 ms of samples, so that pictures stay
/// fresh and the next packet comes before silence ends the search for it (aspep/hunt.h), and 20 ms of line time, so
/// that an answer never waits long behind a packet. Whole groups where MF values are logged, because their counter
/// restarts with each packet; at least one group even if that takes longer than 12 ms. Empty if not even one block (or
/// one group) fits. `config.bufferSize` is not looked at.
std::optional<std::uint16_t> chooseBufferSize(const DatalogConfig &config, const DatalogLink &link);

} // namespace mcp
