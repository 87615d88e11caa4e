#include "scope/unit.h"

#include <array>
#include <numbers>

namespace scope {

namespace {

struct Derived {
    std::string_view symbol;
    int volts; ///< powers of V, A and s
    int amperes;
    int seconds;
};
/// The first one of the same powers is how it is written.
constexpr std::array<Derived, 6> kDerived{{
    {"W", 1, 1, 0},
    {"Ω", 1, -1, 0},
    {"Ohm", 1, -1, 0},
    {"J", 1, 1, 1},
    {"H", 1, -1, 1},
    {"Wb", 1, 0, 1},
}};

constexpr std::string_view kDot = "·";
constexpr std::string_view kSquare = "²";
constexpr std::string_view kCube = "³";

bool takeEnd(std::string_view &text, std::string_view end)
{
    if (text.size() <= end.size() || !text.ends_with(end))
        return false;
    text.remove_suffix(end.size());
    return true;
}

void addFactor(Unit &unit, std::string_view factor, int sign)
{
    if (factor.empty() || factor == "1")
        return;
    const int power = takeEnd(factor, kSquare) ? 2 : takeEnd(factor, kCube) ? 3 : 1;
    for (const Derived &derived : kDerived) {
        if (derived.symbol == factor) {
            unit.add("V", sign * power * derived.volts * 2);
            unit.add("A", sign * power * derived.amperes * 2);
            unit.add("s", sign * power * derived.seconds * 2);
            return;
        }
    }
    unit.add(factor, sign * power * 2);
}

void addProduct(Unit &unit, std::string_view product, int sign)
{
    for (std::size_t dot = product.find(kDot); dot != std::string_view::npos;
         dot = product.find(kDot)) {
        addFactor(unit, product.substr(0, dot), sign);
        product.remove_prefix(dot + kDot.size());
    }
    addFactor(unit, product, sign);
}

std::string power(std::string_view symbol, int halves)
{
    std::string result(symbol);
    if (halves == 4)
        result += kSquare;
    else if (halves == 6)
        result += kCube;
    else if (halves % 2 != 0)
        result += "^(" + std::to_string(halves) + "/2)";
    else if (halves != 2)
        result += "^" + std::to_string(halves / 2);
    return result;
}

} // namespace

void Unit::add(std::string_view symbol, int halves)
{
    const auto at = m_halves.try_emplace(std::string(symbol), 0).first;
    at->second += halves;
    if (at->second == 0)
        m_halves.erase(at);
}

Unit Unit::of(std::string_view text)
{
    Unit unit;
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) {
        addProduct(unit, text, 1);
        return unit;
    }
    std::string_view below = text.substr(slash + 1);
    if (below.starts_with('(') && below.ends_with(')'))
        below = below.substr(1, below.size() - 2);
    if (below.empty() || below.find_first_of("/()") != std::string_view::npos) {
        unit.add(text, 2); // more than is understood: a symbol of its own
        return unit;
    }
    addProduct(unit, text.substr(0, slash), 1);
    addProduct(unit, below, -1);
    return unit;
}

Unit Unit::operator*(const Unit &other) const
{
    Unit result = *this;
    for (const auto &[symbol, halves] : other.m_halves)
        result.add(symbol, halves);
    return result;
}

Unit Unit::operator/(const Unit &other) const
{
    Unit result = *this;
    for (const auto &[symbol, halves] : other.m_halves)
        result.add(symbol, -halves);
    return result;
}

std::string Unit::text() const
{
    for (const Derived &derived : kDerived) {
        if (*this == of(derived.symbol))
            return std::string(derived.symbol);
    }
    std::string above;
    std::string below;
    int factors = 0;
    for (const auto &[symbol, halves] : m_halves) {
        std::string &side = halves > 0 ? above : below;
        factors += halves < 0 ? 1 : 0;
        side += side.empty() ? "" : kDot;
        side += power(symbol, halves > 0 ? halves : -halves);
    }
    if (below.empty())
        return above;
    return (above.empty() ? "1" : above) + "/" + (factors > 1 ? "(" + below + ")" : below);
}

double turnOf(std::string_view unit)
{
    if (unit == "°")
        return 360.0;
    return unit == "rad" ? 2.0 * std::numbers::pi : 0.0;
}

} // namespace scope
