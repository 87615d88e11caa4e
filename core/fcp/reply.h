// What a board sends: acknowledgements with their data, refusals, the notice of a restart. Decoders check every length;
// encoders serve the simulated boards.
#pragma once

#include "base/result.h"
#include "fcp/framer.h"
#include "fcp/protocol.h"
#include "fcp/request.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace fcp {

struct Ack {
    Bytes data;
    bool operator==(const Ack &) const = default;
};
struct Nack {
    /// ErrorCode, or a number without a name; empty: none was sent.
    std::optional<std::uint8_t> error;
    bool operator==(const Nack &) const = default;
};
/// Sent unasked by SDK 4 after a start: the selected motor and every value known before are void.
struct StartNotice {
    std::uint32_t buildId = 0;
    std::string version; ///< "5.4.3"
    std::uint16_t controlBoard = 0, powerBoard = 0, powerBoard2 = 0;
    bool operator==(const StartNotice &) const = default;
};
using Reply = std::variant<Ack, Nack, StartNotice>;

enum class ReplyError : std::uint8_t {
    UnknownHeader,
    BadLength, ///< fits no answer of this kind
    OtherCommand, ///< the acknowledgement repeats another command's id
    BadText, ///< bytes where text should be that are none
};

Result<Reply, ReplyError> decodeReply(const Frame &frame);

Bytes encodeAck(ByteView data = {});
Bytes encodeNack(ErrorCode error);

/// GET_BOARD_INFO: the version as three ASCII digits (firmware) or as three integers (the text), then the SDK's name.
struct BoardInfo {
    std::string version; ///< "5.4.3"; "B.1.0" from SDK 3.0
    std::string name; ///< bytes that are no printable ASCII appear as "?"
    bool operator==(const BoardInfo &) const = default;
};
/// Of GET_BOARD_INFO, as STM32 boards answer it, and GET_FW_VERSION.
constexpr std::size_t kInfoSize = 32;
/// In any length but none: shorter ones lack the name, or the version, too.
Result<BoardInfo, ReplyError> decodeBoardInfo(ByteView data);
/// @param version  "5.4.3"; each part's first character is sent
Bytes encodeBoardInfo(const BoardInfo &info);

/// GET_FW_VERSION: name, tab, "Ver.", version, perhaps a suffix.
struct FirmwareVersion {
    std::string text; ///< as it came, up to the first zero
    std::string name; ///< before the tab; the whole text where there is none
    std::string version; ///< "5.4.3", "4.3.0-RC2"; empty if the text has none
    bool operator==(const FirmwareVersion &) const = default;
};
Result<FirmwareVersion, ReplyError> decodeFirmwareVersion(ByteView data);
FirmwareVersion firmwareVersionOf(std::string_view text);
Bytes encodeFirmwareVersion(std::string_view text); ///< cut at 32 bytes

Result<StageFields, ReplyError> decodeRevUp(ByteView data);
Bytes encodeRevUp(const StageFields &stage);

/// Which dialect an acknowledged EXECUTE_CMD speaks: empty is STM32's, the id again is PowerPC's. Any other id is an
/// error.
Result<Dialect, ReplyError> decodeExecuteAck(std::uint8_t command, ByteView data);

} // namespace fcp
