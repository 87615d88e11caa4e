// Which registers there are, as rows of data: where the value of each is, who may write it, which builds and versions
// know it. One table a family; the register file does what the rows say.
#pragma once

#include "mcp/protocol.h"
#include "simulation/firmware/build.h"
#include "simulation/firmware/firmware.h"
#include "simulation/mcp/profile.h"

#include <bit>
#include <concepts>
#include <cstdint>
#include <map>
#include <span>

namespace simulation {

struct BoardOptions;

/// Values behind which there is nothing but memory, by identifier without motor.
using KeptValues = std::map<std::uint16_t, std::uint32_t>;

/// What the code of a register sees: one motor, and the board around it.
struct RegisterContext {
    const Traits &traits;
    const BoardOptions &options;
    const Build &build;
    Firmware &firmware;
    KeptValues kept;
    bool calibrated = false; ///< the current offsets were measured since power-on
};

struct RegisterRow {
    enum class Scope : std::uint8_t { Motor, Board, Both };
    using Get = std::uint32_t (*)(const RegisterContext &); ///< as the wire has it, in the low bits
    using Set = mcp::Status (*)(RegisterContext &, std::uint32_t);
    using Exists = bool (*)(const Build &);

    mcp::RegisterId id{}; ///< without motor
    Get get = nullptr; ///< nullptr: GET answers UNKNOWN_REG
    Set set = nullptr; ///< nullptr: SET answers `refusal`
    mcp::Status refusal = mcp::Status::ReadOnly;
    mcp::Status unread = mcp::Status::UnknownRegister; ///< of GET where there is no `get`
    Exists exists = nullptr; ///< nullptr: in every build
    Scope scope = Scope::Motor;
    std::uint32_t first = 0, last = UINT32_MAX; ///< versions, 0xMMmmpp, both included
    bool readable = true; ///< false: `get` is the datalog's alone
    bool logged = false; ///< the datalog takes it
    bool speed = false; ///< 0.1 Hz; GET shows a fraction of the full scale up to 6.3
    bool refusedAnywhere = false; ///< SET answers `refusal` for the motor bits of others, too
    bool keeps = false; ///< memory: it reads what was written, before that `get` or `initial`
    std::uint32_t initial = 0;

    /// The same row with another value of a member.
    template <class T>
    constexpr RegisterRow with(T RegisterRow::*member, T value) const
    {
        RegisterRow row = *this;
        row.*member = value;
        return row;
    }
    constexpr RegisterRow in(Exists when) const { return with(&RegisterRow::exists, when); }
    constexpr RegisterRow from(std::uint32_t version) const
    {
        return with(&RegisterRow::first, version);
    }
    constexpr RegisterRow upTo(std::uint32_t version) const
    {
        return with(&RegisterRow::last, version);
    }
    constexpr RegisterRow at(Scope where) const { return with(&RegisterRow::scope, where); }
    constexpr RegisterRow refuses(mcp::Status status) const
    {
        return with(&RegisterRow::refusal, status);
    }
    /// SET does not know it.
    constexpr RegisterRow silent() const { return refuses(mcp::Status::UnknownRegister); }
    constexpr RegisterRow refusesAnywhere() const
    {
        return with(&RegisterRow::refusedAnywhere, true);
    }
    constexpr RegisterRow unreadable(mcp::Status status) const
    {
        return with(&RegisterRow::unread, status);
    }
    constexpr RegisterRow settable(Set function) const { return with(&RegisterRow::set, function); }
    constexpr RegisterRow forDatalog() const { return with(&RegisterRow::logged, true); }
    constexpr RegisterRow ofSpeed() const { return forDatalog().with(&RegisterRow::speed, true); }
    constexpr RegisterRow onlyForDatalog() const
    {
        return forDatalog().with(&RegisterRow::readable, false).silent();
    }
};

/// The rows of a family, in the order of the protocol's list.
std::span<const RegisterRow> standardRegisters();
std::span<const RegisterRow> hsoRegisters();

/// The scalar register of an identifier in this build and version, whatever its motor bits; nullptr if it has none.
const RegisterRow *findRegister(mcp::RegisterId id, const Traits &traits, const Build &build);

// Ways to write rows ------------------------------------------------------------------------------------------------

template <class T>
constexpr std::uint32_t asWire(T value)
{
    if constexpr (std::same_as<T, float>)
        return std::bit_cast<std::uint32_t>(value);
    else if constexpr (sizeof(T) == 2)
        return static_cast<std::uint16_t>(value);
    else
        return static_cast<std::uint32_t>(value);
}

template <class T>
constexpr T fromWire(std::uint32_t value)
{
    if constexpr (std::same_as<T, float>)
        return std::bit_cast<float>(value);
    else
        return static_cast<T>(value);
}

template <std::size_t Bytes>
constexpr mcp::RegisterType typeOfWidth()
{
    static_assert(Bytes == 1 || Bytes == 2 || Bytes == 4);
    return Bytes == 1 ? mcp::RegisterType::Bits8
        : Bytes == 2  ? mcp::RegisterType::Bits16
                      : mcp::RegisterType::Bits32;
}

/// The structure of the firmware that a member belongs to.
inline Signals &ownerOf(Firmware &firmware, const Signals *) { return firmware.variables(); }
inline Tuning &ownerOf(Firmware &firmware, const Tuning *) { return firmware.tuning(); }
inline Commissioning &ownerOf(Firmware &firmware, const Commissioning *)
{
    return firmware.commissioning();
}

template <class Owner, class T, T Owner::*Member>
struct Variable {
    static std::uint32_t get(const RegisterContext &at)
    {
        return asWire(ownerOf(at.firmware, static_cast<const Owner *>(nullptr)).*Member);
    }
    static mcp::Status set(RegisterContext &at, std::uint32_t value)
    {
        ownerOf(at.firmware, static_cast<const Owner *>(nullptr)).*Member = fromWire<T>(value);
        return mcp::Status::Ok;
    }
    static constexpr RegisterRow row(unsigned element)
    {
        return {.id = mcp::registerId(element, typeOfWidth<sizeof(T)>(), 0), .get = &get};
    }
};

template <auto Member>
struct VariableOf;
template <class Owner, class T, T Owner::*Member>
struct VariableOf<Member> : Variable<Owner, T, Member> {
};

/// Read only, a variable of the firmware; its type is the register's.
template <auto Member>
constexpr RegisterRow measured(unsigned element)
{
    return VariableOf<Member>::row(element);
}

/// Read and written.
template <auto Member>
constexpr RegisterRow setting(unsigned element)
{
    return VariableOf<Member>::row(element).settable(&VariableOf<Member>::set);
}

/// Read only, worked out.
constexpr RegisterRow computed(unsigned element, mcp::RegisterType type, RegisterRow::Get get)
{
    return {.id = mcp::registerId(element, type, 0), .get = get};
}

/// Read and written, without effect on anything.
constexpr RegisterRow kept(unsigned element, mcp::RegisterType type, std::uint32_t initial = 0)
{
    return {.id = mcp::registerId(element, type, 0), .keeps = true, .initial = initial};
}

/// Known to SET alone, which refuses it as read-only.
constexpr RegisterRow onlyRefused(unsigned element, mcp::RegisterType type)
{
    return {.id = mcp::registerId(element, type, 0)};
}

/// Written, never read.
constexpr RegisterRow writeOnly(unsigned element, mcp::RegisterType type)
{
    return {.id = mcp::registerId(element, type, 0),
        .set = [](RegisterContext &, std::uint32_t) { return mcp::Status::Ok; }};
}

/// Answers OK both ways; a read carries bytes that mean nothing.
constexpr RegisterRow stub(unsigned element, mcp::RegisterType type)
{
    return {.id = mcp::registerId(element, type, 0),
        .get = [](const RegisterContext &) { return 0U; },
        .set = [](RegisterContext &, std::uint32_t) { return mcp::Status::Ok; }};
}

} // namespace simulation
