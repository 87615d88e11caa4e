#include "recorded/entry_codec.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

namespace recorded {

namespace {

using capture::SampleBlock;
using capture::SlowGroup;
using capture::StreamLayout;
using capture::StreamSignal;

constexpr std::size_t kLongestText = 0xFFFF;
constexpr std::size_t kLeastSignal = 4 + 2 + 2 + 8 + 8; ///< bytes of one with empty texts

enum class Kind : std::uint8_t {
    Padding,
    Begin,
    Layout,
    Samples,
    Register,
    Polled,
    Happening,
    Snapshot,
    Note,
    Lost,
    End
};

ByteWriter start(Kind kind)
{
    ByteWriter out;
    out.text("RS").u8(kPayloadVersion).u8(static_cast<std::uint8_t>(kind));
    return out;
}

void putText(ByteWriter &out, const std::string &text)
{
    const auto length = std::min(text.size(), kLongestText);
    out.u16(static_cast<std::uint32_t>(length)).text(std::string_view(text).substr(0, length));
}

std::string takeText(ByteReader &in)
{
    const ByteView bytes = in.take(in.u16());
    return {bytes.begin(), bytes.end()};
}

/// 16-bit codes as they lie in memory, where memory is little-endian; else one by one.
void putCodes(ByteWriter &out, const std::vector<std::int16_t> &codes)
{
    if constexpr (std::endian::native == std::endian::little) {
        out.bytes({reinterpret_cast<const std::uint8_t *>(codes.data()), codes.size() * 2});
    } else {
        for (const std::int16_t code : codes)
            out.s16(code);
    }
}

void takeCodes(ByteReader &in, std::vector<std::int16_t> &codes)
{
    if constexpr (std::endian::native == std::endian::little) {
        const ByteView bytes = in.take(codes.size() * 2);
        if (!bytes.empty())
            std::memcpy(codes.data(), bytes.data(), bytes.size());
    } else {
        for (std::int16_t &code : codes)
            code = in.s16();
    }
}

void putSignal(ByteWriter &out, const StreamSignal &signal)
{
    out.u32(signal.id);
    putText(out, signal.name);
    putText(out, signal.unit);
    out.f64(signal.factor).f64(signal.offset);
}

StreamSignal takeSignal(ByteReader &in)
{
    return {in.u32(), takeText(in), takeText(in), in.f64(), in.f64()};
}

bool makesSense(const StreamSignal &signal)
{
    return std::isfinite(signal.factor) && std::isfinite(signal.offset);
}

ByteWriter put(const Begin &begin)
{
    ByteWriter out = start(Kind::Begin);
    out.s64(begin.startSeconds);
    putText(out, begin.program);
    putText(out, begin.source);
    return out;
}

ByteWriter put(const StreamLayout &layout, Repeat repeat)
{
    ByteWriter out = start(Kind::Layout);
    out.u8(repeat == Repeat::Yes ? 1 : 0).u32(layout.id);
    out.f64(layout.tickHz).f64(layout.originSeconds).u32(layout.fastStep);
    out.u16(static_cast<std::uint32_t>(layout.fast.size()));
    out.u16(static_cast<std::uint32_t>(layout.slow.size()));
    for (const StreamSignal &signal : layout.fast)
        putSignal(out, signal);
    for (const StreamSignal &signal : layout.slow)
        putSignal(out, signal);
    // Behind what older readers know, and only where it says something.
    if (std::ranges::any_of(layout.slow, [](const auto &s) { return s.real; }))
        for (const StreamSignal &signal : layout.slow)
            out.u8(signal.real ? 1 : 0);
    return out;
}

/// @param fast  its fast samples, in one piece or more
ByteWriter put(
    const SampleBlock &block, std::span<const std::vector<std::int16_t>> fast, std::size_t room)
{
    std::size_t codes = 0;
    for (const std::vector<std::int16_t> &piece : fast)
        codes += piece.size();
    const std::size_t signalCount = block.count > 0 ? codes / block.count : 0;
    const std::size_t slowCount = block.slow.empty() ? 0 : block.slow.front().values.size();
    ByteWriter out = start(Kind::Samples);
    out.reserve(room + codes * 2);
    out.u32(block.stream).s64(block.firstTick).s64(block.lostTicks).u32(block.count);
    out.u16(static_cast<std::uint32_t>(signalCount)).u16(static_cast<std::uint32_t>(slowCount));
    out.u32(static_cast<std::uint32_t>(block.slow.size()));
    for (const std::vector<std::int16_t> &piece : fast)
        putCodes(out, piece);
    for (const SlowGroup &group : block.slow) {
        out.s64(group.tick);
        for (const std::int32_t value : group.values)
            out.s32(value);
    }
    return out;
}

ByteWriter put(const SampleBlock &block) { return put(block, {&block.fast, 1}, 0); }

ByteWriter put(const PolledRegister &polled, Repeat repeat)
{
    ByteWriter out = start(Kind::Register);
    out.u8(repeat == Repeat::Yes ? 1 : 0).u32(polled.id);
    putText(out, polled.name);
    putText(out, polled.unit);
    return out;
}

ByteWriter put(const PolledValues &polled)
{
    ByteWriter out = start(Kind::Polled);
    out.u32(static_cast<std::uint32_t>(polled.values.size()));
    for (const PolledValue &value : polled.values)
        out.u32(value.id).s64(value.at).f64(value.value);
    return out;
}

ByteWriter put(const Happening &happening)
{
    ByteWriter out = start(Kind::Happening);
    putText(out, happening.name);
    out.u16(static_cast<std::uint32_t>(happening.fields.size()));
    for (const auto &[key, value] : happening.fields) {
        putText(out, key);
        putText(out, value);
    }
    return out;
}

ByteWriter put(const RegisterSnapshot &snapshot)
{
    ByteWriter out = start(Kind::Snapshot);
    putText(out, snapshot.title);
    out.u32(static_cast<std::uint32_t>(snapshot.json.size())).text(snapshot.json);
    return out;
}

ByteWriter put(const Note &note)
{
    ByteWriter out = start(Kind::Note);
    out.s64(note.from).s64(note.to);
    putText(out, note.text);
    return out;
}

ByteWriter put(const Lost &lost)
{
    ByteWriter out = start(Kind::Lost);
    out.u64(lost.samples).u64(lost.linkBytes).u64(lost.others);
    return out;
}

ByteWriter put(const End &end)
{
    ByteWriter out = start(Kind::End);
    out.u8(static_cast<std::uint8_t>(end.reason)).u64(end.blocks).u64(end.samples);
    putText(out, end.text);
    return out;
}

/// Only what fits the fixed widths of the layout is written at all.
bool fits(const Entry &entry)
{
    const auto small = [](std::size_t count) { return count <= kMostSignals; };
    if (const auto *layout = std::get_if<StreamLayout>(&entry))
        return small(layout->fast.size()) && small(layout->slow.size());
    if (const auto *block = std::get_if<SampleBlock>(&entry))
        return isWhole(*block);
    if (const auto *happening = std::get_if<Happening>(&entry))
        return happening->fields.size() <= kLongestText;
    if (const auto *note = std::get_if<Note>(&entry))
        return note->text.size() <= kLongestText;
    if (const auto *snapshot = std::get_if<RegisterSnapshot>(&entry))
        return snapshot->json.size() <= kMostPayload;
    return true;
}

// ---- reading -------------------------------------------------------------------------------------------------------

std::optional<Decoded> takeLayout(ByteReader &in)
{
    const auto repeat = in.u8() != 0 ? Repeat::Yes : Repeat::No;
    StreamLayout layout;
    layout.id = in.u32();
    layout.tickHz = in.f64();
    layout.originSeconds = in.f64();
    layout.fastStep = in.u32();
    const std::size_t fastCount = in.u16();
    const std::size_t slowCount = in.u16();
    if (!std::isfinite(layout.tickHz) || !(std::abs(layout.originSeconds) < 1e9)
        || layout.fastStep == 0 || layout.fastStep > 1'000'000
        || std::max(fastCount, slowCount) > kMostSignals
        || (fastCount + slowCount) * kLeastSignal > in.left())
        return std::nullopt;
    for (std::size_t i = 0; i < fastCount + slowCount; ++i) {
        StreamSignal signal = takeSignal(in);
        if (!makesSense(signal))
            return std::nullopt;
        (i < fastCount ? layout.fast : layout.slow).push_back(std::move(signal));
    }
    if (in.left() >= slowCount)
        for (StreamSignal &signal : layout.slow)
            signal.real = in.u8() != 0;
    return Decoded{std::move(layout), repeat};
}

std::optional<Decoded> takeSamples(ByteReader &in)
{
    constexpr capture::Tick kFarthestTick = capture::Tick{1} << 53; ///< 17,000 years at 16 kHz
    SampleBlock block;
    block.stream = in.u32();
    block.firstTick = in.s64();
    block.lostTicks = in.s64();
    block.count = in.u32();
    const std::size_t signalCount = in.u16();
    const std::size_t slowCount = in.u16();
    const std::size_t groupCount = in.u32();
    const std::size_t groupBytes = 8 + 4 * slowCount;
    const auto near = [](capture::Tick tick) {
        return tick > -kFarthestTick && tick < kFarthestTick;
    };
    if (!near(block.firstTick) || !near(block.lostTicks) || block.lostTicks < 0
        || block.count > in.left() || (block.count == 0 && signalCount != 0)
        || std::max(signalCount, slowCount) > kMostSignals
        || block.count * signalCount * 2 > in.left() || groupCount > in.left() / groupBytes)
        return std::nullopt;
    block.fast.resize(block.count * signalCount);
    takeCodes(in, block.fast);
    if (groupCount > in.left() / groupBytes)
        return std::nullopt;
    block.slow.resize(groupCount);
    for (SlowGroup &group : block.slow) {
        group.tick = in.s64();
        if (!near(group.tick))
            return std::nullopt;
        group.values.resize(slowCount);
        for (std::int32_t &value : group.values)
            value = in.s32();
    }
    return Decoded{std::move(block)};
}

std::optional<Decoded> takePolled(ByteReader &in)
{
    constexpr std::size_t kValueBytes = 4 + 8 + 8;
    const std::size_t count = in.u32();
    if (count > in.left() / kValueBytes)
        return std::nullopt;
    PolledValues polled;
    for (std::size_t i = 0; i < count; ++i)
        polled.values.push_back({in.u32(), in.s64(), in.f64()});
    return Decoded{std::move(polled)};
}

std::optional<Decoded> takeHappening(ByteReader &in)
{
    Happening happening;
    happening.name = takeText(in);
    const std::size_t count = in.u16();
    if (count > in.left() / 4)
        return std::nullopt;
    for (std::size_t i = 0; i < count; ++i)
        happening.fields.push_back({takeText(in), takeText(in)});
    return Decoded{std::move(happening)};
}

std::optional<Decoded> takeBody(Kind kind, ByteReader &in)
{
    switch (kind) {
    case Kind::Padding:
        break;
    case Kind::Begin:
        return Decoded{Begin{in.s64(), takeText(in), takeText(in)}};
    case Kind::Layout:
        return takeLayout(in);
    case Kind::Samples:
        return takeSamples(in);
    case Kind::Register: {
        const auto repeat = in.u8() != 0 ? Repeat::Yes : Repeat::No;
        return Decoded{PolledRegister{in.u32(), takeText(in), takeText(in)}, repeat};
    }
    case Kind::Polled:
        return takePolled(in);
    case Kind::Happening:
        return takeHappening(in);
    case Kind::Snapshot: {
        RegisterSnapshot snapshot;
        snapshot.title = takeText(in);
        const ByteView json = in.take(in.u32());
        snapshot.json.assign(json.begin(), json.end());
        return Decoded{std::move(snapshot)};
    }
    case Kind::Note:
        return Decoded{Note{in.s64(), in.s64(), takeText(in)}};
    case Kind::Lost:
        return Decoded{Lost{in.u64(), in.u64(), in.u64()}};
    case Kind::End: {
        End end;
        const std::uint8_t reason = in.u8();
        if (reason > static_cast<std::uint8_t>(End::Reason::WriteFailed))
            return std::nullopt;
        end.reason = static_cast<End::Reason>(reason);
        end.blocks = in.u64();
        end.samples = in.u64();
        end.text = takeText(in);
        return Decoded{std::move(end)};
    }
    }
    return std::nullopt;
}

} // namespace

bool isWhole(const SampleBlock &block)
{
    const std::size_t slowCount = block.slow.empty() ? 0 : block.slow.front().values.size();
    const bool fast = block.count == 0
        ? block.fast.empty()
        : block.fast.size() % block.count == 0 && block.fast.size() / block.count <= kMostSignals;
    return fast && slowCount <= kMostSignals
        && std::ranges::all_of(block.slow,
            [slowCount](const SlowGroup &group) { return group.values.size() == slowCount; });
}

bool isNear(const StreamLayout &layout, double tick)
{
    const auto base = capture::TickBase::of(layout.tickHz, layout.originSeconds);
    return std::abs(layout.originSeconds) < kFarthest_s
        && std::abs(tick) < kFarthest_s * static_cast<double>(base.milliHz) / 1000.0;
}

Result<Bytes, PayloadError> encodeEntry(const Entry &entry, Repeat repeat)
{
    if (!fits(entry))
        return fail(PayloadError::TooLong);
    Bytes payload = std::visit(
        [repeat]<class T>(const T &what) {
            if constexpr (std::is_same_v<T, LinkBytes>)
                return ByteWriter(); // has no payload of its own
            else if constexpr (std::is_same_v<T, StreamLayout> || std::is_same_v<T, PolledRegister>)
                return put(what, repeat);
            else
                return put(what);
        },
        entry)
                        .take();
    if (payload.size() > kMostPayload)
        return fail(PayloadError::TooLong);
    return payload;
}

Bytes encodeSamples(
    const SampleBlock &block, std::span<const std::vector<std::int16_t>> columns, std::size_t room)
{
    return put(block, columns, room).take();
}

Result<Decoded, PayloadError> decodeEntry(ByteView payload)
{
    ByteReader in(payload);
    const bool ours = in.u8() == 'R' && in.u8() == 'S' && in.u8() == kPayloadVersion;
    if (!ours)
        return fail(PayloadError::NotOurs);
    const std::uint8_t kind = in.u8();
    if (!in.ok())
        return fail(PayloadError::Malformed);
    if (kind == static_cast<std::uint8_t>(Kind::Padding)
        || kind > static_cast<std::uint8_t>(Kind::End))
        return fail(PayloadError::UnknownKind);
    auto decoded = takeBody(static_cast<Kind>(kind), in);
    if (!decoded || !in.ok())
        return fail(PayloadError::Malformed);
    return std::move(*decoded);
}

} // namespace recorded
