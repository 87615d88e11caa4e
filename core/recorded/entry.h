// What a recording holds, entry by entry: plain values, without any of the file's framing. Times are on the session's
// axis, the one of the scope.
#pragma once

#include "base/bytes.h"
#include "base/text.h"
#include "capture/sample_block.h"
#include "capture/tick_time.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace recorded {

using capture::Nanos;
using catalog::RegisterId;

/// A recording tells of nothing that is further from its session's 0 s: three years.
inline constexpr Nanos kFarthest = 100'000'000'000'000'000;
inline constexpr double kFarthest_s = 1e8;
inline constexpr std::size_t kMostRegisters = 65'536; ///< of which a reader remembers what was read

/// The first entry of every recording, and the one that says when and by whom.
struct Begin {
    std::int64_t startSeconds = 0; ///< UTC since 1970 of the session's 0 s, whole seconds
    std::string program; ///< that wrote it, with its version
    std::string source; ///< what was recorded: port, or the file it was taken from
    bool operator==(const Begin &) const = default;
};

/// Bytes of the line as the port handed them over, cut anywhere.
struct LinkBytes {
    enum class Direction : std::uint8_t { Received = 1, Sent = 2 } direction = Direction::Received;
    Bytes bytes;
    bool operator==(const LinkBytes &) const = default;
};

/// What a polled register is called. Comes before its first value.
struct PolledRegister {
    RegisterId id = 0;
    std::string name;
    std::string unit; ///< of PolledValue::value
    bool operator==(const PolledRegister &) const = default;
};
struct PolledValue {
    RegisterId id = 0;
    Nanos at = 0; ///< when the answer came
    double value = 0.0;
    bool operator==(const PolledValue &) const = default;
};
struct PolledValues {
    std::vector<PolledValue> values;
    bool operator==(const PolledValues &) const = default;
};

/// Something that happened once, in words: a command, a change of state, a fault, a lost link.
struct Happening {
    std::string name; ///< e.g. "motor state"
    std::vector<std::pair<std::string, std::string>> fields; ///< e.g. {"state", "RUN"}
    bool operator==(const Happening &) const = default;

    std::string field(std::string_view key) const ///< empty: none
    {
        for (const auto &[fieldName, value] : fields)
            if (fieldName == key)
                return value;
        return {};
    }
    /// Empty: none, or no such number.
    template <class Number>
    std::optional<Number> number(std::string_view key) const
    {
        return numberIn<Number>(field(key));
    }
};

/// The registers of the board at one time, as the snapshot file has them (docs/snapshot.md).
struct RegisterSnapshot {
    std::string title;
    std::string json;
    bool operator==(const RegisterSnapshot &) const = default;
};

/// Words of the user about [from, to].
struct Note {
    Nanos from = 0;
    Nanos to = 0;
    std::string text;
    bool operator==(const Note &) const = default;
};

/// The one that takes back what earlier ones said about this time.
inline Note noNote(Nanos at) { return {at, at - 1, {}}; }
inline bool isTakenBack(const Note &note) { return note.to < note.from; }

/// What did not get into the recording, because the disk could not follow, since the entry of this kind before it.
struct Lost {
    std::uint64_t samples = 0;
    std::uint64_t linkBytes = 0;
    std::uint64_t others = 0; ///< entries of any other kind
    bool operator==(const Lost &) const = default;
};

/// Why nothing follows. A recording without it was interrupted.
struct End {
    enum class Reason : std::uint8_t { Stopped, DiskFull, WriteFailed } reason = Reason::Stopped;
    std::string text; ///< the system's words for it
    std::uint64_t blocks = 0; ///< before it
    std::uint64_t samples = 0; ///< of all signals
    bool operator==(const End &) const = default;
};

/// A layout: every block of samples that follows belongs to it until the next one; empty: the stream ended.
using Entry = std::variant<Begin, LinkBytes, capture::StreamLayout, capture::SampleBlock,
    PolledRegister, PolledValues, Happening, RegisterSnapshot, Note, Lost, End>;

} // namespace recorded
