// What a formula is made of; only formula*.cpp includes it. Each expression is one of muparser's, reading its variables
// from slots that all of them share: first the channels, then the results of the calls.
#pragma once

#include "scope/formula.h"
#include "scope/unit.h"

#include <muParser.h>

#include <array>
#include <optional>

namespace scope {

/// muparser's parser with nothing but what formula.h lists.
class Expression {
public:
    /// @param code   in muparser's words, names already replaced by those of slots
    /// @param slots  stays where it is
    Expression(const std::string &code, std::vector<double> &slots);

    /// Where muparser finds fault with it; compiles it on the way.
    std::optional<std::size_t> fault();
    double value() const;
    /// The slots that occur in it.
    const std::vector<std::size_t> &used() const { return m_used; }

    static std::string slotName(std::size_t slot);
    /// Arguments of one of its functions; 0 if there is none of that name.
    static std::size_t argumentsOf(std::string_view function);
    static bool isConstant(std::string_view name) { return name == "pi" || name == "e"; }

private:
    std::unique_ptr<mu::Parser> m_parser;
    std::vector<std::size_t> m_used;
};

/// A call of a column function.
struct FormulaCall {
    std::unique_ptr<ColumnFunction> function;
    std::vector<Expression> arguments;
    std::size_t slot = 0; ///< where its result goes
    bool joined = false; ///< it was computed at the instant before
};

/// The unit of an expression, found by scaling its variables; nullopt if there is none.
std::optional<Unit> unitOf(const Expression &expression, std::vector<double> &slots,
    std::span<const std::optional<Unit>> units);

struct Formula::Program {
    std::vector<double> slots; ///< never grows: expressions point into it
    std::vector<std::size_t> used;
    std::vector<FormulaCall> calls; ///< inner ones first
    std::optional<Expression> result;
    std::string unit;
};

} // namespace scope
