// Judges a list of writes that go out together: a gain is its numerator over two to the power of its exponent, so both
// halves are looked at as one number. Decides only; the caller asks the user.
#pragma once

#include "catalog/catalog.h"
#include "catalog/limits.h"
#include "drive/wish.h"

#include <functional>

namespace drive {

/// The other half of a gain: the exponent of a numerator, the numerator of an exponent, of the same motor. Empty if the
/// register is no gain or stands alone. By name: the exponent of X is X_DIV.
std::optional<catalog::RegisterId> otherHalf(
    const catalog::Catalog &catalog, catalog::RegisterId id);

struct HeldValues {
    /// What a register holds; empty: not known.
    std::function<std::optional<catalog::Value>(catalog::RegisterId)> held;
    /// Whether a motor is anywhere but at rest; 0 asks for any of them.
    std::function<bool(int motor)> running;
};

/// The caution of each write, in their order. Where both halves of a gain are written they share that of the quotient:
/// four times the numerator over two more of the exponent is no change.
std::vector<catalog::Caution> cautionsOf(const std::vector<drive::RegisterWrite> &writes,
    const catalog::Catalog &catalog, const HeldValues &facts);

/// The same writes with the halves of each gain side by side, the one first that lowers it: between the two the gain is
/// never above both the old and the new one. A pair stands where its earlier half stood.
std::vector<drive::RegisterWrite> pairsTogether(std::vector<drive::RegisterWrite> writes,
    const catalog::Catalog &catalog, const HeldValues &facts);

} // namespace drive
