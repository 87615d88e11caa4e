#include "recorded/block.h"

#include "recorded/crc32.h"

namespace recorded {

namespace {

constexpr std::uint32_t kByteOrder = 0x1A2B3C4D;
constexpr std::uint32_t kLinkTypes[] = {147, 148};
constexpr std::uint32_t kOptionFlags = 2, kOptionHash = 3, kOptionPacketId = 5;
constexpr std::uint32_t kHashCrc32 = 2;
constexpr std::size_t kOptions = 36; ///< bytes of those of a packet block
constexpr std::size_t kPacketIdAt = 8 + 4; ///< in them
constexpr std::size_t kHashAt = kPacketIdAt + 8 + 4;

void option(ByteWriter &out, std::uint32_t code, ByteView value)
{
    out.u16(code).u16(static_cast<std::uint32_t>(value.size())).bytes(value);
    while (out.size() % 4 != 0)
        out.u8(0);
}

void option(ByteWriter &out, std::uint32_t code, std::string_view text)
{
    option(out, code, {reinterpret_cast<const std::uint8_t *>(text.data()), text.size()});
}

/// A block around its body; both lengths are put in.
Bytes framed(std::uint32_t type, const Bytes &body)
{
    const auto length = static_cast<std::uint32_t>(body.size() + 12);
    return ByteWriter().u32(type).u32(length).bytes(body).u32(length).take();
}

Bytes interfaceBlock(
    std::uint32_t linkType, std::int64_t startSeconds, std::string_view name, std::string_view what)
{
    ByteWriter body;
    body.u16(linkType).u16(0).u32(0); // no limit to a packet's length
    option(body, 2, name); // if_name
    option(body, 3, what); // if_description
    option(body, 9, ByteWriter().u8(9).take()); // if_tsresol: nanoseconds
    option(body, 14, ByteWriter().s64(startSeconds).take()); // if_tsoffset
    body.u32(0);
    return framed(kInterfaceBlock, body.take());
}

/// Over what stands in the head and nowhere in the data.
std::uint32_t headCrc(ByteView fixedHead, std::uint32_t direction, std::uint32_t number)
{
    return crc32(ByteWriter().bytes(fixedHead).u32(direction).u32(number).take());
}

} // namespace

Bytes fileHead(std::int64_t startSeconds, std::string_view program)
{
    ByteWriter section;
    section.u32(kByteOrder).u16(1).u16(0).u64(~std::uint64_t{0}); // 1.0, length not said
    option(section, 4, program); // shb_userappl
    section.u32(0);
    ByteWriter out;
    out.bytes(framed(kSectionBlock, section.take()));
    out.bytes(interfaceBlock(
        kLinkTypes[0], startSeconds, "link", "bytes of the line to the drive, both directions"));
    out.bytes(interfaceBlock(kLinkTypes[1], startSeconds, "rotorscope",
        "samples, values, events and notes; format: docs/recording-format.md of Rotorscope"));
    return out.take();
}

Bytes packetBlock(const BlockHead &head, Bytes data)
{
    const auto length = static_cast<std::uint32_t>(blockSize(data.size()));
    const auto time = static_cast<std::uint64_t>(head.at);
    const auto size = static_cast<std::uint32_t>(data.size());
    ByteWriter out;
    out.u32(kPacketBlock).u32(length).u32(static_cast<std::uint32_t>(head.interface));
    out.u32(static_cast<std::uint32_t>(time >> 32)).u32(static_cast<std::uint32_t>(time));
    const Bytes fixed = out.u32(size).u32(size).take();
    ByteWriter tail;
    option(tail, kOptionFlags, ByteWriter().u32(head.direction).take());
    const std::uint64_t check = headCrc(fixed, head.direction, head.number);
    option(tail, kOptionPacketId, ByteWriter().u64(check << 32 | head.number).take());
    option(tail, kOptionHash, ByteWriter().u8(kHashCrc32).u32(crc32(data)).take());
    const Bytes end = tail.u32(0).u32(length).take();
    data.reserve(length);
    data.insert(data.begin(), fixed.begin(), fixed.end());
    data.resize(length - end.size());
    data.insert(data.end(), end.begin(), end.end());
    return data;
}

Claim claimOf(ByteView bytes)
{
    ByteReader in(bytes);
    const std::uint32_t type = in.u32();
    return {type, in.u32()};
}

std::optional<BlockHead> packetHead(ByteView block, std::size_t most)
{
    ByteReader in(block);
    BlockHead head;
    const std::uint32_t type = in.u32();
    const std::uint32_t length = in.u32();
    const std::uint32_t interface = in.u32();
    const std::uint64_t high = in.u32();
    head.at = static_cast<capture::Nanos>(high << 32 | in.u32());
    head.dataBytes = in.u32();
    if (!in.ok() || type != kPacketBlock || interface > 1 || head.dataBytes > most
        || length != blockSize(head.dataBytes) || length > block.size())
        return std::nullopt;
    head.interface = static_cast<Interface>(interface);
    ByteReader options(block.subspan(length - kOptions - 4, kOptions));
    const bool flags = options.u16() == kOptionFlags && options.u16() == 4;
    head.direction = options.u32();
    const bool id = options.u16() == kOptionPacketId && options.u16() == 8;
    head.number = options.u32();
    const std::uint32_t check = options.u32();
    if (!flags || !id || check != headCrc(block.first(kFixedHead), head.direction, head.number))
        return std::nullopt;
    return head;
}

std::optional<ByteView> packetData(const BlockHead &head, ByteView block)
{
    const ByteView data = block.subspan(kFixedHead, head.dataBytes);
    const std::size_t length = blockSize(head.dataBytes);
    ByteReader hash(block.subspan(length - kOptions - 4 + kHashAt - 4, 9));
    const bool known = hash.u16() == kOptionHash && hash.u16() == 5 && hash.u8() == kHashCrc32;
    if (!known || hash.u32() != crc32(data))
        return std::nullopt;
    return data;
}

bool isSectionHead(ByteView bytes)
{
    ByteReader in(bytes);
    const bool type = in.u32() == kSectionBlock;
    const std::uint32_t length = in.u32();
    return type && in.u32() == kByteOrder && in.ok() && length >= 28 && length % 4 == 0;
}

} // namespace recorded
