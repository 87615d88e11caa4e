#include "mcb/error_code.h"

namespace mcb {

bool isKnown(std::uint32_t code)
{
    switch (static_cast<ErrorCode>(code)) {
    case ErrorCode::AccessNotSupported:
    case ErrorCode::NoSuchRegister:
    case ErrorCode::CannotBeMapped:
    case ErrorCode::TooMuchMapped:
    case ErrorCode::General:
    case ErrorCode::BadCyclicIndex:
    case ErrorCode::CyclicNotReachable:
    case ErrorCode::MappingRefused:
    case ErrorCode::InvalidCommand:
    case ErrorCode::BadCrc:
        return true;
    }
    return false;
}

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
