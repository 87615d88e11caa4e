#include "drive/write_caution.h"

#include <algorithm>
#include <cmath>

namespace drive {

namespace {

using catalog::Caution;
using catalog::Gain;
using catalog::RegisterId;
using catalog::RegisterInfo;
using catalog::Value;

constexpr std::string_view kExponentSuffix = "_DIV";
constexpr double kGreatestGainStep = 2.0;

std::optional<double> numberOf(const std::optional<Value> &value)
{
    const auto *whole = value ? std::get_if<std::int64_t>(&*value) : nullptr;
    return whole != nullptr ? std::optional(static_cast<double>(*whole)) : std::nullopt;
}

std::vector<RegisterWrite>::const_iterator writeOf(
    const std::vector<RegisterWrite> &writes, RegisterId id)
{
    return std::ranges::find(writes, id, &RegisterWrite::id);
}

/// The caution of a gain of which both halves are written while its motor runs.
Caution cautionOfQuotient(
    const RegisterWrite &numerator, const RegisterWrite &exponent, const HeldValues &facts)
{
    const auto oldNumerator = numberOf(facts.held(numerator.id)),
               oldExponent = numberOf(facts.held(exponent.id)),
               newNumerator = numberOf(numerator.value), newExponent = numberOf(exponent.value);
    if (!oldNumerator || !oldExponent || !newNumerator || !newExponent)
        return Caution::GainJump;
    const double from = *oldNumerator * std::exp2(-*oldExponent),
                 to = *newNumerator * std::exp2(-*newExponent);
    const double least = std::min(std::abs(from), std::abs(to)),
                 greatest = std::max(std::abs(from), std::abs(to));
    const bool turned = from * to < 0.0;
    return turned || !(greatest <= kGreatestGainStep * least) ? Caution::GainJump : Caution::None;
}

} // namespace

std::optional<RegisterId> otherHalf(const catalog::Catalog &catalog, RegisterId id)
{
    const RegisterInfo *info = catalog.find(id);
    if (info == nullptr || info->gain == Gain::None)
        return std::nullopt;
    std::string name = info->name;
    if (info->gain == Gain::Numerator)
        name += kExponentSuffix;
    else if (name.ends_with(kExponentSuffix))
        name.resize(name.size() - kExponentSuffix.size());
    else
        return std::nullopt;
    const RegisterInfo *other = catalog.find(name);
    if (other == nullptr || other->gain == Gain::None || other->gain == info->gain)
        return std::nullopt;
    return catalog.withMotor(*other, catalog.motorOf(id));
}

std::vector<Caution> cautionsOf(const std::vector<RegisterWrite> &writes,
    const catalog::Catalog &catalog, const HeldValues &facts)
{
    std::vector<Caution> cautions;
    cautions.reserve(writes.size());
    for (const RegisterWrite &write : writes) {
        const RegisterInfo *info = catalog.find(write.id);
        if (info == nullptr) {
            cautions.push_back(Caution::None);
            continue;
        }
        const bool running = facts.running(info->perMotor ? catalog.motorOf(write.id) : 0);
        const auto half = otherHalf(catalog, write.id);
        const auto other = half ? writeOf(writes, *half) : writes.end();
        const bool pair = other != writes.end() && running && !info->dangerous;
        if (!pair)
            cautions.push_back(
                catalog::cautionOf(*info, facts.held(write.id), write.value, running));
        else if (info->gain == Gain::Numerator)
            cautions.push_back(cautionOfQuotient(write, *other, facts));
        else
            cautions.push_back(cautionOfQuotient(*other, write, facts));
    }
    return cautions;
}

std::vector<RegisterWrite> pairsTogether(
    std::vector<RegisterWrite> writes, const catalog::Catalog &catalog, const HeldValues &facts)
{
    std::vector<RegisterWrite> ordered;
    ordered.reserve(writes.size());
    for (const RegisterWrite &write : writes) {
        if (writeOf(ordered, write.id) != ordered.end())
            continue; // came with its other half
        const auto half = otherHalf(catalog, write.id);
        const auto other = half ? writeOf(writes, *half) : writes.end();
        if (other == writes.end()) {
            ordered.push_back(write);
            continue;
        }
        const bool isNumerator = catalog.find(write.id)->gain == Gain::Numerator;
        const RegisterWrite &numerator = isNumerator ? write : *other;
        const RegisterWrite &exponent = isNumerator ? *other : write;
        const auto held = numberOf(facts.held(exponent.id)), wanted = numberOf(exponent.value);
        const bool divisorGrows = held && wanted && *wanted > *held;
        ordered.push_back(divisorGrows ? exponent : numerator);
        ordered.push_back(divisorGrows ? numerator : exponent);
    }
    return ordered;
}

} // namespace drive
