// Lies within answers: lists, structures, texts, numbers and status bytes. What an answer holds is found from the
// identifiers in its request, as a Controller finds it.
#include "simulation/mcp/liars.h"

#include "mcp/protocol.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace simulation {

namespace {

using mcp::CommandId;
using mcp::RegisterId;
using mcp::RegisterType;

CommandId commandOf(ByteView request)
{
    return static_cast<CommandId>(ByteReader(request).u16() >> 3);
}

bool isRead(ByteView request)
{
    return request.size() >= 4 && commandOf(request) == CommandId::GetRegister;
}

/// One value of an answer: a raw one with its size, a text with its end.
struct Field {
    RegisterId id;
    std::size_t at, size;
};

/// The values that are really there, in order. `payload` is honest and ends in the status byte.
std::vector<Field> fieldsOf(ByteView request, const Bytes &payload)
{
    std::vector<Field> fields;
    if (!isRead(request) || payload.empty())
        return fields;
    ByteReader ids(request.subspan(2));
    ByteReader values(ByteView(payload).first(payload.size() - 1));
    while (ids.left() >= 2 && values.left() > 0) {
        const RegisterId id{ids.u16()};
        const std::size_t at = values.position();
        if (static_cast<RegisterType>(id.type()) == RegisterType::Raw)
            values.take(values.u16());
        else if (static_cast<RegisterType>(id.type()) == RegisterType::String)
            values.zeroTerminated();
        else
            values.take(mcp::scalarWidth(id.type()));
        if (!values.ok())
            break;
        fields.push_back({id, at, values.position() - at});
    }
    return fields;
}

bool isRaw(const Field &field)
{
    return static_cast<RegisterType>(field.id.type()) == RegisterType::Raw;
}

/// Where the floating-point numbers of a value are, from the beginning of the answer.
std::vector<std::size_t> floatsIn(const Field &field)
{
    constexpr RegisterId kMotorPower = mcp::registerId(109, RegisterType::Bits32, 0);
    constexpr std::size_t kContent = 2, kFloat = 4;
    const RegisterId id = field.id.withMotor(0);
    std::vector<std::size_t> places;
    const auto add = [&](std::size_t first, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            if (first + (i + 1) * kFloat <= field.size)
                places.push_back(field.at + first + i * kFloat);
        }
    };
    if (id == kMotorPower)
        add(0, 1);
    else if (id == mcp::reg::kMotorConfig)
        add(kContent, 9);
    else if (id == mcp::reg::kApplicationConfig)
        add(kContent + 4, 2);
    else if (id == mcp::reg::kScaleConfig)
        add(kContent, 3);
    else if (id == mcp::reg::kPositionRamp)
        add(kContent, 2);
    return places;
}

void put(Bytes &payload, std::size_t at, std::uint64_t value, std::size_t width)
{
    for (std::size_t i = 0; i < width; ++i)
        payload[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

void putFloats(const std::vector<Field> &fields, Bytes &payload, float even, float odd)
{
    for (const Field &field : fields) {
        std::size_t count = 0;
        for (const std::size_t at : floatsIn(field))
            put(payload, at, std::bit_cast<std::uint32_t>(count++ % 2 == 0 ? even : odd), 4);
    }
}

/// The largest number in all scalars but those that are sets of bits or states.
void putHuge(const std::vector<Field> &fields, Bytes &payload)
{
    constexpr float kMost = std::numeric_limits<float>::max();
    putFloats(fields, payload, kMost, -kMost);
    for (const Field &field : fields) {
        const RegisterId id = field.id.withMotor(0);
        const std::size_t width = mcp::scalarWidth(id.type());
        if (width < 2 || id == mcp::reg::kFaultsFlags || !floatsIn(field).empty())
            continue;
        put(payload, field.at, width == 2 ? 0x7FFF : 0x7FFFFFFF, width);
    }
}

} // namespace

std::optional<Bytes> Liar::insteadOf(ByteView request) const
{
    if (request.size() < 2)
        return std::nullopt;
    const CommandId command = commandOf(request);
    const bool pretends = (command == CommandId::StopMotor && chosen(Lie::NeverStops))
        || (command == CommandId::StartMotor && chosen(Lie::OkButIdle));
    if (!pretends)
        return std::nullopt;
    return Bytes{static_cast<std::uint8_t>(mcp::Status::Ok)};
}

Bytes Liar::answer(ByteView request, Bytes payload)
{
    if (honest() || payload.empty())
        return payload;
    lieAboutValues(request, payload);
    lieAboutStatus(request, payload);
    lieAboutRaw(request, payload);
    if (payload.size() > 1 && happens(Lie::ShortList))
        payload.erase(payload.begin() + static_cast<std::ptrdiff_t>(below(payload.size() - 1)),
            payload.end() - 1);
    if (happens(Lie::OddLength))
        payload.insert(payload.end() - 1, static_cast<std::uint8_t>(random()));
    if (happens(Lie::BeyondAgreed)) {
        constexpr std::size_t kBeyond = 4096 + 64; ///< more than any agreement allows
        const Bytes more = noise(kBeyond - std::min(kBeyond, payload.size()));
        payload.insert(payload.end() - 1, more.begin(), more.end());
    }
    const Bytes former = std::exchange(m_last, payload);
    return !former.empty() && happens(Lie::WrongAnswer) ? former : payload;
}

void Liar::lieAboutValues(ByteView request, Bytes &payload)
{
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const std::vector<Field> fields = fieldsOf(request, payload);
    if (fields.empty())
        return;
    if (happens(Lie::NotANumber))
        putFloats(fields, payload, kNan, kNan);
    if (happens(Lie::Infinite))
        putFloats(fields, payload, kInfinity, -kInfinity);
    if (happens(Lie::Denormal))
        putFloats(fields, payload, std::numeric_limits<float>::denorm_min(), -0.0F);
    if (happens(Lie::Zeros))
        putFloats(fields, payload, 0.0F, 0.0F);
    if (happens(Lie::Huge))
        putHuge(fields, payload);
    for (const Field &field : fields) {
        constexpr std::size_t kMotorsAt = 2 + 4;
        constexpr std::array<std::uint8_t, 3> kMotors{0, 8, 255};
        constexpr std::uint8_t kNoState = 200;
        const RegisterId id = field.id.withMotor(0);
        if (id == mcp::reg::kGlobalConfig && field.size > kMotorsAt && happens(Lie::ManyMotors))
            payload[field.at + kMotorsAt] = kMotors[below(kMotors.size())];
        if (id == mcp::reg::kStatus && happens(Lie::StrangeState))
            payload[field.at] = kNoState;
    }
}

void Liar::lieAboutRaw(ByteView request, Bytes &payload)
{
    const std::vector<Field> fields = fieldsOf(request, payload);
    // From behind: places before a change stay where they are.
    for (auto field = fields.rbegin(); field != fields.rend(); ++field) {
        const auto at = payload.begin() + static_cast<std::ptrdiff_t>(field->at);
        const auto behind = at + static_cast<std::ptrdiff_t>(field->size);
        if (isRaw(*field) && field->size > 2 && happens(Lie::ShortRaw)) {
            payload.erase(behind - static_cast<std::ptrdiff_t>(1 + below(field->size - 2)), behind);
        } else if (isRaw(*field) && happens(Lie::LongRaw)) {
            const Bytes more = noise(1 + below(20));
            payload.insert(behind, more.begin(), more.end());
        } else if (static_cast<RegisterType>(field->id.type()) == RegisterType::String
            && happens(Lie::NoNul)) {
            payload.erase(behind - 1);
        }
    }
}

void Liar::lieAboutStatus(ByteView request, Bytes &payload)
{
    const CommandId command = request.size() >= 2 ? commandOf(request) : CommandId::GetMcpVersion;
    const auto refuse = [&](mcp::Status status) {
        payload.assign(1, static_cast<std::uint8_t>(status));
    };
    if (isRead(request) && happens(Lie::RefusedReads))
        refuse(mcp::Status::UnknownRegister);
    if (command == CommandId::SetRegister && happens(Lie::RefusedWrites))
        refuse(mcp::Status::ReadOnly);
    if (command == CommandId::StartMotor && happens(Lie::NokButRuns))
        refuse(mcp::Status::Nok);
    if (happens(Lie::UnknownStatus)) {
        constexpr std::array<std::uint8_t, 4> kUnknown{0x0E, 0x42, 0x80, 0xFF};
        payload.back() = kUnknown[below(kUnknown.size())];
    }
}

} // namespace simulation
