#include "drive/mcb/mcb_messages.h"

#include "base/text.h"

namespace drive {
namespace {

void addFrames(Bytes &bytes, std::uint16_t address, mcb::WordView words)
{
    for (const mcb::Frame &frame : mcb::fragmentsOf(address, mcb::Command::Write, words)) {
        const Bytes one = mcb::encodeFrame(frame);
        bytes.insert(bytes.end(), one.begin(), one.end());
    }
}

} // namespace

Bytes mcbChanges(const McbRequest &request)
{
    Bytes bytes;
    if (const auto *one = std::get_if<mcb::Master::Request>(&request)) {
        if (one->command == mcb::Command::Write)
            addFrames(bytes, one->address, one->words);
    } else if (const auto *map = std::get_if<McbMap>(&request)) {
        for (const mcb::MappingStep &step : mcb::stepsOf(map->mapping, true))
            addFrames(bytes, step.address, step.words);
    } else {
        addFrames(bytes, mcb::kStateRegister, mcb::Words{mcb::kConfigState});
    }
    return bytes;
}

std::optional<std::string> McbProtocol::refusalIn(const McbAnswer &answer)
{
    return answer.ok ? std::nullopt : std::optional(mcbWordOf(answer.code));
}

std::string mcbWordOf(std::uint32_t code)
{
    if (code == kOtherValueRead)
        return "another value is read back";
    return std::string(mcb::meaningOf(code)) + " (0x" + hexDigits(code, 8) + ")";
}

} // namespace drive
