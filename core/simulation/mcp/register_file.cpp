// Reads and writes by type.
#include "simulation/mcp/register_file.h"

#include "simulation/mcp/board_structures.h"
#include "simulation/mcp/per_unit.h"
#include "simulation/mcp/raw_registers.h"
#include "simulation/simulated_board.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace simulation {

namespace {

using mcp::RegisterId;
using mcp::RegisterType;
using mcp::scalarWidth;
using mcp::Status;
using Scope = RegisterRow::Scope;

/// Registers that an application of its own makes loggable: BoardOptions::wide.
constexpr std::array kWide{
    mcp::reg::kStatus, mcp::reg::kSpeedMeas, mcp::reg::kSpeedRef, mcp::reg::kFaultsFlags};

Status append(Bytes &out, int room, std::uint32_t value, std::size_t width)
{
    if (room < static_cast<int>(width))
        return Status::NoTxSyncSpace;
    for (std::size_t i = 0; i < width; ++i)
        out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    return Status::Ok;
}

/// Texts and structures compare with 16 bits without a sign: what was overdrawn by an unchecked one looks like plenty.
int unsignedRoom(int room) { return static_cast<std::uint16_t>(room); }

Status appendRaw(Bytes &out, int room, const Bytes &value)
{
    if (unsignedRoom(room) < static_cast<int>(value.size()) + 2)
        return Status::NoTxSyncSpace;
    append(out, 2, static_cast<std::uint32_t>(value.size()), 2);
    out.insert(out.end(), value.begin(), value.end());
    return Status::Ok;
}

std::uint32_t valueOf(const RegisterRow &row, const RegisterContext &at)
{
    if (row.keeps) {
        if (const auto written = at.kept.find(row.id.bits); written != at.kept.end())
            return written->second;
    }
    return row.get != nullptr ? row.get(at) : row.initial;
}

/// What the self-commissioning of a profiler build shows before it has run, which here it never does.
Commissioning beforeProfiling(const Firmware &firmware)
{
    constexpr std::uint8_t kStates = 23; // of self-commissioning and one-touch tuning together
    constexpr float kSpeedBandwidth_radps = 6.0F, kCurrentBandwidth_radps = 3000.0F;
    const MotorParameters &motor = motorOf(firmware);
    Commissioning c;
    c.steps = kStates;
    c.polePairs = static_cast<std::uint8_t>(motor.polePairs);
    c.pwm_hz = static_cast<std::int16_t>(std::lround(firmware.hfHz()));
    c.bus_v = static_cast<float>(firmware.stage().nominal_v);
    c.current_a = c.startUp_a = static_cast<float>(motor.nominal_a);
    c.speedBandwidth_radps = kSpeedBandwidth_radps;
    c.currentBandwidth_radps = kCurrentBandwidth_radps;
    c.nominalSpeed_rpm = static_cast<std::int32_t>(motor.maxSpeed_rpm);
    return c;
}

/// Up to 6.3 a read gives 0.1 Hz as a fraction of the full scale.
std::uint32_t asFraction(std::uint32_t value, const Firmware &firmware)
{
    const double scaled =
        static_cast<std::int16_t>(value) * 6.0 / fullScaleSpeedDigit_rpm(firmware);
    return static_cast<std::uint16_t>(
        static_cast<std::int16_t>(std::clamp(scaled, -32768.0, 32767.0)));
}

} // namespace

RegisterFile::RegisterFile(
    const Traits &traits, const BoardOptions &options, const Build &build, const Axes &axes)
    : m_traits(traits)
    , m_options(options)
    , m_build(build)
{
    for (const auto &axis : axes) {
        m_motors.push_back({traits, options, build, axis->firmware, {}, false});
        axis->firmware.commissioning() = beforeProfiling(axis->firmware);
    }
}

bool RegisterFile::hasMotor(RegisterId id) const
{
    return ignoresMotor() || id.motor() <= m_motors.size();
}

const RegisterContext *RegisterFile::addressed(RegisterId id, Scope scope) const
{
    if (ignoresMotor())
        return &m_motors.front();
    if (id.motor() == 0)
        return scope == Scope::Motor ? nullptr : &m_motors.front();
    if (scope == Scope::Board || id.motor() > m_motors.size())
        return nullptr;
    return &m_motors[id.motor() - 1U];
}

RegisterContext *RegisterFile::addressed(RegisterId id, Scope scope)
{
    return const_cast<RegisterContext *>(std::as_const(*this).addressed(id, scope)); // its own
}

Status RegisterFile::read(RegisterId id, int room, Bytes &out) const
{
    switch (static_cast<RegisterType>(id.type())) {
    case RegisterType::Bits8:
    case RegisterType::Bits16:
    case RegisterType::Bits32:
        return readScalar(id, room, out);
    case RegisterType::String:
        return readText(id, room, out);
    case RegisterType::Raw:
        return readRaw(id, room, out);
    }
    return Status::BadDataType;
}

Status RegisterFile::readScalar(RegisterId id, int room, Bytes &out) const
{
    const std::size_t width = scalarWidth(id.type());
    if (room < static_cast<int>(width))
        return Status::NoTxSyncSpace;
    const RegisterRow *row = findRegister(id, m_traits, m_build);
    const RegisterContext *at = row != nullptr ? addressed(id, row->scope) : nullptr;
    if (at == nullptr || !row->readable)
        return Status::UnknownRegister;
    if (row->get == nullptr && !row->keeps)
        return row->unread;
    std::uint32_t value = valueOf(*row, *at);
    if (row->speed && m_traits.scalesReadSpeeds)
        value = asFraction(value, at->firmware);
    return append(out, room, value, width);
}

Status RegisterFile::readText(RegisterId id, int room, Bytes &out) const
{
    const TextRow *row = findText(id);
    if (row == nullptr)
        return Status::UnknownRegister;
    const Scope scope = m_build.hso() && row->scope == Scope::Board ? Scope::Both : row->scope;
    const RegisterContext *at = addressed(id, scope);
    if (at == nullptr)
        return Status::UnknownRegister;
    const std::string text = row->get(*at);
    if (unsignedRoom(room) < static_cast<int>(text.size()) + 1)
        return m_traits.asPrinted ? Status::NoTxSyncSpace : Status::StringFormat;
    out.insert(out.end(), text.begin(), text.end());
    out.push_back(0);
    return Status::Ok;
}

Status RegisterFile::readRaw(RegisterId id, int room, Bytes &out) const
{
    if (isPrintedDatalog(id))
        return appendRaw(out, room, m_printedDatalog);
    const RawRow *row = findRaw(id, m_traits, m_build);
    const RegisterContext *at = row != nullptr ? addressed(id, row->scope) : nullptr;
    if (at == nullptr || row->get == nullptr)
        return Status::UnknownRegister;
    if (row->ofCalibration && !at->calibrated)
        return Status::RegisterAccess;
    const bool looks = row->looksAtRoom || m_traits.asPrinted;
    return appendRaw(out, looks ? room : INT16_MAX, row->get(*at));
}

RegisterFile::Written RegisterFile::write(
    RegisterId id, const StaleBytes &value, int available, DatalogRecorder &datalog)
{
    switch (static_cast<RegisterType>(id.type())) {
    case RegisterType::Bits8:
        return {writeScalar(id, value.u8(0)), 1};
    case RegisterType::Bits16:
        return {writeScalar(id, value.u16(0)), 2};
    case RegisterType::Bits32:
        return {writeScalar(id, value.u32(0)), 4};
    case RegisterType::String: {
        int size = 1; // the terminating zero at least
        while (size < available && value.u8(static_cast<std::size_t>(size - 1)) != 0)
            ++size;
        return {Status::ReadOnly, size};
    }
    case RegisterType::Raw: {
        const int size = value.u16(0);
        if (size + 2 > available)
            return {Status::BadRawFormat, 0};
        return {writeRaw(id, value.from(2), size, datalog), size + 2};
    }
    }
    return {Status::BadDataType, 0};
}

/// SET of something that has other motor bits: the firmware lists a few registers in both of its places.
template <class Row>
Status RegisterFile::refusalElsewhere(const Row *row, RegisterId id) const
{
    const bool listed = row != nullptr && row->refusedAnywhere && !m_build.hso()
        && !m_traits.asPrinted && id.motor() <= m_motors.size();
    return listed ? row->refusal : Status::UnknownRegister;
}

Status RegisterFile::writeScalar(RegisterId id, std::uint32_t value)
{
    const RegisterRow *row = findRegister(id, m_traits, m_build);
    RegisterContext *at = row != nullptr ? addressed(id, row->scope) : nullptr;
    if (at == nullptr)
        return refusalElsewhere(row, id);
    if (row->set != nullptr)
        return row->set(*at, value);
    if (!row->keeps)
        return row->refusal;
    at->kept[row->id.bits] = value;
    return Status::Ok;
}

bool RegisterFile::isDatalog(RegisterId id) const
{
    if (m_build.sixStep())
        return false;
    const RegisterId mine = m_options.linkId == 1 ? mcp::reg::kAsyncUartB : mcp::reg::kAsyncUartA;
    return id.withMotor(0) == mine && (id.motor() != 0 || ignoresMotor());
}

bool RegisterFile::isPrintedDatalog(RegisterId id) const
{
    const RegisterId mine = m_options.linkId == 1 ? mcp::reg::kAsyncUartB : mcp::reg::kAsyncUartA;
    return m_traits.asPrinted && id == mine;
}

Status RegisterFile::writeRaw(
    RegisterId id, const StaleBytes &value, int size, DatalogRecorder &datalog)
{
    if (isDatalog(id))
        return datalog.configure(value);
    if (isPrintedDatalog(id)) {
        const Status status = datalog.configureAsPrinted(value, size);
        if (status == Status::Ok) {
            m_printedDatalog.clear();
            for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i)
                m_printedDatalog.push_back(value.u8(i));
        }
        return status;
    }
    const RawRow *row = findRaw(id, m_traits, m_build);
    RegisterContext *at = row != nullptr ? addressed(id, row->scope) : nullptr;
    if (at == nullptr)
        return refusalElsewhere(row, id);
    return row->set != nullptr ? row->set(*at, value, size) : row->refusal;
}

Source RegisterFile::source(RegisterId id) const
{
    const RegisterRow *row = findRegister(id, m_traits, m_build);
    const RegisterContext *at = row != nullptr ? addressed(id, Scope::Motor) : nullptr;
    if (at == nullptr || row->get == nullptr)
        return {};
    const auto isRow = [row](RegisterId wide) { return wide == row->id; };
    const bool wide = m_options.wide && std::ranges::any_of(kWide, isRow);
    if (!row->logged && !wide)
        return {};
    return {row->get, at, m_build.hso()};
}

} // namespace simulation
