#include "mcb/error_code.h"

#include "base/text.h"

namespace mcb {
namespace {

constexpr std::string_view kUnknown = "error";
constexpr Word<ErrorCode> kMeanings[] = {{"access not supported", ErrorCode::AccessNotSupported},
    {"no such register", ErrorCode::NoSuchRegister},
    {"cannot be mapped", ErrorCode::CannotBeMapped}, {"too much mapped", ErrorCode::TooMuchMapped},
    {"general error", ErrorCode::General}, {"bad cyclic index", ErrorCode::BadCyclicIndex},
    {"cyclic state not reachable", ErrorCode::CyclicNotReachable},
    {"mapping refused", ErrorCode::MappingRefused}, {"invalid command", ErrorCode::InvalidCommand},
    {"CRC error", ErrorCode::BadCrc}, {kUnknown, {}}};

} // namespace

std::string_view meaningOf(std::uint32_t code)
{
    return wordFor(kMeanings, static_cast<ErrorCode>(code));
}

bool isKnown(std::uint32_t code) { return meaningOf(code) != kUnknown; }

std::uint32_t errorCodeOf(const ConfigWords &config)
{
    const std::uint32_t code = config[0] | std::uint32_t{config[1]} << 16;
    const std::uint32_t swapped = config[1] | std::uint32_t{config[0]} << 16;
    return !isKnown(code) && isKnown(swapped) ? swapped : code;
}

ConfigWords configOf(ErrorCode code)
{
    const auto number = static_cast<std::uint32_t>(code);
    return {static_cast<std::uint16_t>(number), static_cast<std::uint16_t>(number >> 16), 0, 0};
}

} // namespace mcb
