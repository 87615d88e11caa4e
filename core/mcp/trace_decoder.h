// Recorded packets, one after the other, to what they mean: neutral structs to be printed.
//
// It learns the datalog configurations from the SET requests it sees and matches each response with the request before
// it. It reads leniently where a board does (fields sent twice may differ): what is wrong is shown, not hidden.
#pragma once

#include "mcp/datalog.h"
#include "mcp/structure_fields.h"
#include "mcp/value.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mcp {

enum class TraceDirection : std::uint8_t { FromController, FromPerformer, Event };

/// What is known of a register by its id, motor included.
struct TraceNote {
    std::string name;
    catalog::ValueType type = catalog::ValueType::U16;
};
using TraceLookup = std::function<std::optional<TraceNote>(RegisterId)>;

struct TraceRegister {
    RegisterId id;
    std::string name; ///< empty if not known
};

struct TraceValue {
    TraceRegister reg;
    catalog::Value value; ///< number by the register's format, text, or raw content
    std::vector<Field> fields; ///< of a raw value whose structure is known
};

struct TraceEvent { }; ///< a line that is no packet: a reset, a note
struct TraceInvalid {
    std::string_view reason;
};
struct TraceBeacon {
    unsigned version = 0, crc = 0, rxsMax = 0, txsMax = 0, txaMax = 0;
};
struct TracePing {
    unsigned c = 0, c2 = 0, n = 0, n2 = 0, liid = 0, number = 0;
};
struct TraceError {
    unsigned code = 0, code2 = 0;
};
struct TraceRequest {
    std::size_t length = 0;
    bool hasCommand = false; ///< false: too short for one; the next three say nothing
    unsigned command = 0;
    std::string_view commandName;
    unsigned motor = 0;
    std::vector<TraceRegister> registers; ///< of a GET
    std::vector<TraceValue> writes; ///< of a SET, as far as it can be read
    std::optional<DatalogConfig> datalog; ///< the SET configures the datalog
};
struct TraceResponse {
    std::size_t length = 0;
    unsigned status = 0;
    std::string_view statusName;
    Bytes data; ///< without the status
    std::optional<std::vector<TraceValue>> values; ///< answer of a GET
    std::optional<std::vector<std::uint8_t>> registerStatus; ///< answer of a SET list with failures
    std::optional<std::uint32_t> version; ///< all four bytes; only the lowest means something
};
struct TraceSlowGroup {
    std::size_t block = 0; ///< 0-based number of the block before the group
    std::vector<std::int64_t> values;
};
struct TraceAsync {
    std::size_t length = 0;
    std::uint32_t timestamp = 0;
    unsigned mark = 0;
    unsigned asyncId = 0;
    /// false: no configuration of this mark, or the length does not fit: the rest is empty
    bool decoded = false;
    std::vector<TraceRegister> fast;
    std::vector<std::vector<std::int32_t>> fastSamples; ///< signal after signal
    std::vector<TraceRegister> slow;
    std::vector<TraceSlowGroup> slowGroups;
    std::size_t fastBlocks = 0; ///< samples a fast signal; 0 without fast signals
    /// Since the packet before it of the same configuration.
    std::optional<std::uint32_t> lostTicks;
    bool partial = false; ///< shorter than a full packet
};

using TraceItem = std::variant<TraceEvent, TraceInvalid, TraceBeacon, TracePing, TraceError,
    TraceRequest, TraceResponse, TraceAsync>;

class TraceDecoder {
public:
    explicit TraceDecoder(TraceLookup lookup);

    /// @param bytes  one whole packet, header first; payload CRC included if one was negotiated
    TraceItem next(TraceDirection direction, ByteView bytes);

private:
    struct Stream {
        DatalogConfig config;
        DatalogLayout layout;
        std::optional<std::uint32_t> expected; ///< timestamp of the next packet if nothing is lost
    };

    TraceItem beacon(TraceDirection direction, std::uint32_t word);
    TraceItem ping(TraceDirection direction, std::uint32_t word);
    TraceItem data(TraceDirection direction, bool response, std::uint32_t word, ByteView bytes);
    TraceItem request(ByteView payload);
    TraceItem response(ByteView payload);
    TraceItem async(ByteView payload);
    void decodeSamples(TraceAsync &item, Stream &stream, ByteView payload);
    void readSet(TraceRequest &item, ByteView content);
    void accept(const DatalogConfig &config);
    TraceRegister named(RegisterId id) const;
    TraceValue meant(RegisterId id, const Value &value) const;
    bool isUnsigned(RegisterId id) const;

    TraceLookup m_lookup;
    std::optional<std::uint32_t> m_offer; ///< last Beacon of the Controller
    bool m_payloadCrc = false;
    std::optional<std::uint16_t> m_command; ///< of the last request
    std::vector<RegisterId> m_asked; ///< by the last GET
    std::size_t m_written = 0; ///< registers of the last SET
    std::optional<DatalogConfig> m_pending; ///< of the last SET, not answered yet
    std::vector<Stream> m_streams; ///< oldest first
    bool m_active = false; ///< the newest configuration may be running
};

} // namespace mcp
