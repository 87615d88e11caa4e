// Which registers hold the gains of which loop, by the names of every protocol: a board has some of them.
#pragma once

#include "catalog/catalog.h"

#include <array>
#include <cstdint>
#include <span>

namespace catalog {

enum class GainLoop : std::uint8_t {
    Torque, ///< Iq
    Flux, ///< Id
    Speed,
    FluxWeakening,
    Position,
    Pll, ///< of the observer
    Observer, ///< C1, C2
    CordicObserver,
    Currents, ///< both at once
};

/// What a gain is a gain of; those of an motor::GainId come first, in its order.
enum class GainKind : std::uint8_t {
    TorqueKp,
    TorqueKi,
    FluxKp,
    FluxKi,
    SpeedKp,
    SpeedKi,
    WeakeningKp,
    WeakeningKi,
    PositionKp,
    PositionKi,
    PositionKd,
    PllKp,
    PllKi,
    Observer1,
    Observer2,
    PerUnit,
    InUnits, ///< not digits: a number in the unit that the board's catalogue tells
};
constexpr std::size_t kGainKinds = static_cast<std::size_t>(GainKind::InUnits) + 1;

struct GainRegister {
    const char *name = nullptr; ///< nullptr: there is none here
    GainKind kind = GainKind::PerUnit;
    bool divided = true; ///< by 2^NAME_DIV
};
constexpr int kGainPlaces = 3; ///< Kp, Ki, Kd
struct GainRow {
    GainLoop loop = GainLoop::Torque;
    std::array<GainRegister, kGainPlaces> gains;
};
std::span<const GainRow> gainRows(); ///< in the order in which a table has them
/// Whether a board of this catalogue has a gain of that kind.
bool hasGain(const Catalog &catalog, GainKind kind);

} // namespace catalog
