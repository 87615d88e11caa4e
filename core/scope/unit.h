// Units as products of powers, to say what a computed channel is measured in: V * A = W, A per second = A/s.
// Symbols that are not known are symbols of their own; nothing is converted (rpm stays rpm).
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace scope {

class Unit {
public:
    Unit() = default; ///< of a plain number

    /// From what stands beside a value: "A", "W", "Ω", "A/s", "V·s", "A²". Never fails.
    static Unit of(std::string_view text);

    bool isNumber() const { return m_halves.empty(); }
    bool operator==(const Unit &) const = default;

    Unit operator*(const Unit &other) const;
    Unit operator/(const Unit &other) const;

    /// Powers of the basic symbols, in halves: V^(1/2) is {"V", 1}.
    const std::map<std::string, int, std::less<>> &halves() const { return m_halves; }
    void add(std::string_view symbol, int halves);

    /// As people write it: "W", "A/s", "V/(A·s)"; empty for a plain number.
    std::string text() const;

private:
    std::map<std::string, int, std::less<>> m_halves;
};

/// One turn of an angle that is measured in this; 0 if it is none.
double turnOf(std::string_view unit);

} // namespace scope
