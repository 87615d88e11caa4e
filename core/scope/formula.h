// A formula of a math channel: text in, a machine out that computes one value an instant. muparser parses and computes
// the arithmetic; this adds the functions with a memory (column_functions.h), names of channels, and units.
//
//   names      those of channels as they are, or in brackets: [I_A (2)]
//   operators  + - * / ^ ( ) < > <= >= == != && || and c ? a : b
//   functions  sin cos tan asin acos atan atan2 exp ln log10 sqrt abs sign floor min max and the column functions;
//              angles of sin and cos in radians; the constants pi and e
//   numbers    with a dot, whatever the locale
// It can neither assign nor read or write anything. Length, depth and calls are bounded before muparser sees a byte.
//
// Units are found by trying: what multiplies by 2 when every volt does is a volt. So A + V has none, sqrt(A²) is A.
#pragma once

#include "base/result.h"
#include "scope/column_functions.h"

#include <memory>
#include <string>
#include <vector>

namespace scope {

enum class FormulaError : std::uint8_t {
    Empty,
    TooLong,
    TooDeep, ///< parentheses in parentheses, or too many calls
    BadCharacter,
    BadNumber,
    UnknownName,
    Syntax,
    WrongArgumentCount,
    NotConstant, ///< a filter's frequency or length depends on a signal
    OutOfRange, ///< or makes no sense
    NotAnAngle ///< its unit is neither ° nor rad
};

struct FormulaFault {
    FormulaError error = FormulaError::Syntax;
    std::size_t position = 0; ///< byte of the text where it was noticed
    bool operator==(const FormulaFault &) const = default;
};

/// A name that a formula may use.
struct FormulaName {
    std::string name;
    std::string unit;
};

class Formula {
public:
    static constexpr std::size_t kMostBytes = 500;
    static constexpr int kMostDepth = 32;
    static constexpr std::size_t kMostCalls = 32; ///< of column functions

    static Result<Formula, FormulaFault> compile(
        std::string_view text, std::span<const FormulaName> names);

    Formula(Formula &&) noexcept;
    Formula &operator=(Formula &&) noexcept;
    ~Formula();

    /// Indexes into `names` of those that occur, rising.
    const std::vector<std::size_t> &used() const;
    /// Of the result; empty if it is a plain number or does not follow.
    const std::string &unit() const;

    /// The value at the next instant.
    /// @param values   one for each of used(), finite
    /// @param seconds  since the instant before
    /// @param joined   nothing is missing since then
    /// @return NaN or infinite where there is none
    double step(std::span<const double> values, double seconds, bool joined);

private:
    struct Program;
    explicit Formula(std::unique_ptr<Program> program);
    std::unique_ptr<Program> m_program;
    friend class FormulaCompiler;
};

} // namespace scope
