#include "drive/mcb/mcb_messages.h"

namespace drive {

using Wire = mcb::Command;
using mcb::ErrorCode;
using mcb::Frame;

namespace {

Bytes framesOf(std::uint16_t address, Wire command, mcb::WordView words = {})
{
    Bytes bytes;
    for (const Frame &frame : mcb::fragmentsOf(address, command, words)) {
        const Bytes one = mcb::encodeFrame(frame);
        bytes.insert(bytes.end(), one.begin(), one.end());
    }
    return bytes;
}

std::string_view meaningOf(std::uint32_t code)
{
    switch (static_cast<ErrorCode>(code)) {
    case ErrorCode::AccessNotSupported:
        return "access not supported";
    case ErrorCode::NoSuchRegister:
        return "no such register";
    case ErrorCode::CannotBeMapped:
        return "cannot be mapped";
    case ErrorCode::TooMuchMapped:
        return "too much mapped";
    case ErrorCode::General:
        return "general error";
    case ErrorCode::BadCyclicIndex:
        return "bad cyclic index";
    case ErrorCode::CyclicNotReachable:
        return "cyclic state not reachable";
    case ErrorCode::MappingRefused:
        return "mapping refused";
    case ErrorCode::InvalidCommand:
        return "invalid command";
    case ErrorCode::BadCrc:
        return "CRC error";
    }
    return "error";
}

bool isEntryOf(std::uint16_t count, std::uint16_t address)
{
    return address > count && address <= count + mcb::kMostMapped;
}

} // namespace

Bytes mcbRead(std::uint16_t address) { return framesOf(address, Wire::Read); }
Bytes mcbInfo(std::uint16_t address) { return framesOf(address, Wire::GetInfo); }
Bytes mcbWrite(std::uint16_t address, mcb::WordView words)
{
    return framesOf(address, Wire::Write, words);
}

Bytes mcbMap(const mcb::Mapping &mapping)
{
    Bytes bytes;
    for (const mcb::MappingStep &step : mcb::stepsOf(mapping, true)) {
        const Bytes one = mcbWrite(step.address, step.words);
        bytes.insert(bytes.end(), one.begin(), one.end());
    }
    return bytes;
}

Bytes mcbUnmap()
{
    const mcb::Words state{mcb::kConfigState};
    return mcbWrite(mcb::kStateRegister, state);
}

McbRequest mcbRequestOf(ByteView request)
{
    McbRequest result;
    for (; request.size() >= mcb::kConfigFrameBytes;
         request = request.subspan(mcb::kConfigFrameBytes)) {
        const auto frame = mcb::decodeFrame(request.first(mcb::kConfigFrameBytes));
        if (!frame)
            break;
        const bool state = frame->command == Wire::Write && frame->address == mcb::kStateRegister;
        if (state)
            result.kind = frame->config[0] == mcb::kCyclicState ? McbRequest::Kind::Map
                                                                : McbRequest::Kind::Unmap;
        result.request.command = frame->command;
        result.request.address = frame->address;
        if (frame->command == Wire::Write)
            result.request.words.insert(
                result.request.words.end(), frame->config.begin(), frame->config.end());
        const mcb::MappedRegister entry{
            frame->config[0], static_cast<std::uint8_t>(frame->config[1])};
        if (isEntryOf(mcb::kRxCountRegister, frame->address))
            result.mapping.rx.push_back(entry);
        else if (isEntryOf(mcb::kTxCountRegister, frame->address))
            result.mapping.tx.push_back(entry);
    }
    return result;
}

bool mcbReads(ByteView request) { return mcbRequestOf(request).request.command != Wire::Write; }

Bytes mcbAnswer(const mcb::Master::Done &done)
{
    ByteWriter writer;
    writer.u8(done.end == mcb::Master::End::Ok ? 1 : 0).u32(done.code);
    for (const std::uint16_t word : done.words)
        writer.u16(word);
    return writer.take();
}

McbAnswer mcbAnswerOf(ByteView response)
{
    ByteReader reader(response);
    McbAnswer answer;
    answer.ok = reader.u8() != 0;
    answer.code = reader.u32();
    while (reader.left() >= 2)
        answer.words.push_back(reader.u16());
    return answer;
}

std::string hexText(std::uint64_t number, int digits)
{
    static constexpr char kDigits[] = "0123456789ABCDEF";
    std::string text = "0x";
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
        text.push_back(kDigits[number >> shift & 0xFU]);
    return text;
}

std::string mcbWordOf(std::uint32_t code)
{
    if (code == kOtherValueRead)
        return "another value is read back";
    return std::string(meaningOf(code)) + " (" + hexText(code, 8) + ")";
}

} // namespace drive
