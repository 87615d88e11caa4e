#include "scope/expression.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace scope {

namespace {

struct Function {
    const char *name;
    double (*one)(double);
    double (*two)(double, double);
};

double signOf(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

// Lambdas, because the functions of <cmath> are overloaded.
const std::array<Function, 16> kMathFunctions{{
    {"sin", [](double x) { return std::sin(x); }, nullptr},
    {"cos", [](double x) { return std::cos(x); }, nullptr},
    {"tan", [](double x) { return std::tan(x); }, nullptr},
    {"asin", [](double x) { return std::asin(x); }, nullptr},
    {"acos", [](double x) { return std::acos(x); }, nullptr},
    {"atan", [](double x) { return std::atan(x); }, nullptr},
    {"exp", [](double x) { return std::exp(x); }, nullptr},
    {"ln", [](double x) { return std::log(x); }, nullptr},
    {"log10", [](double x) { return std::log10(x); }, nullptr},
    {"sqrt", [](double x) { return std::sqrt(x); }, nullptr},
    {"abs", [](double x) { return std::abs(x); }, nullptr},
    {"sign", signOf, nullptr},
    {"floor", [](double x) { return std::floor(x); }, nullptr},
    {"atan2", nullptr, [](double y, double x) { return std::atan2(y, x); }},
    {"min", nullptr, [](double a, double b) { return std::min(a, b); }},
    {"max", nullptr, [](double a, double b) { return std::max(a, b); }},
}};

const Function *find(std::string_view name)
{
    const auto *const found = std::ranges::find(kMathFunctions, name, &Function::name);
    return found != kMathFunctions.end() ? found : nullptr;
}

void define(mu::Parser &parser)
{
    parser.ClearFun();
    parser.ClearConst();
    parser.ClearPostfixOprt();
    for (const Function &function : kMathFunctions) {
        if (function.one)
            parser.DefineFun(function.name, function.one);
        else
            parser.DefineFun(function.name, function.two);
    }
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("e", std::numbers::e);
}

} // namespace

Expression::Expression(const std::string &code, std::vector<double> &slots)
    : m_parser(std::make_unique<mu::Parser>())
{
    define(*m_parser);
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
        const std::string name = slotName(slot);
        if (code.find(name) == std::string::npos)
            continue;
        m_parser->DefineVar(name, &slots[slot]);
        m_used.push_back(slot);
    }
    m_parser->SetExpr(code);
}

std::optional<std::size_t> Expression::fault()
{
    try {
        m_parser->Eval();
        if (m_parser->GetNumResults() == 1)
            return std::nullopt;
    } catch (const mu::ParserError &error) {
        // Below 0: it does not know where.
        return static_cast<std::size_t>(std::max(error.GetPos(), 0));
    }
    return 0;
}

double Expression::value() const
{
    try {
        return m_parser->Eval();
    } catch (const mu::ParserError &) {
        return std::numeric_limits<double>::quiet_NaN();
    }
}

/// With an end mark, so that no name is the beginning of another.
std::string Expression::slotName(std::size_t slot) { return "_" + std::to_string(slot) + "_"; }

std::size_t Expression::argumentsOf(std::string_view function)
{
    const Function *const found = find(function);
    if (!found)
        return 0;
    return found->one ? 1 : 2;
}

// ---- units ---------------------------------------------------------------------------------------------------------

namespace {

constexpr std::size_t kPoints = 6;
constexpr std::array<double, 2> kScales{2.0, 3.7};

/// Values without meaning, of both signs, that make nothing cancel.
double pointValue(std::size_t point, std::size_t slot)
{
    const double place = std::fmod(
        0.618033988749895 * static_cast<double>(1 + slot) + 0.377 * static_cast<double>(point),
        1.0);
    return ((point + slot) % 3 == 0 ? -1.0 : 1.0) * (0.3 + 2.4 * place);
}

/// By which power of `symbol` the expression goes; nullopt if by none.
std::optional<int> halvesOf(const Expression &expression, std::vector<double> &slots,
    std::span<const std::optional<Unit>> units, const std::string &symbol)
{
    std::optional<double> power;
    for (std::size_t point = 0; point < kPoints; ++point) {
        for (const double scale : kScales) {
            const auto evaluate = [&](double by) {
                for (const std::size_t slot : expression.used()) {
                    const auto &halves = units[slot]->halves();
                    const auto at = halves.find(symbol);
                    const double exponent = at != halves.end() ? at->second / 2.0 : 0.0;
                    slots[slot] = pointValue(point, slot) * std::pow(by, exponent);
                }
                return expression.value();
            };
            const double before = evaluate(1.0);
            const double after = evaluate(scale);
            if (!std::isfinite(before) || !std::isfinite(after) || (before == 0.0 && after == 0.0))
                continue;
            const double found = std::log(after / before) / std::log(scale);
            if (!std::isfinite(found) || (power && std::abs(found - *power) > 1e-6))
                return std::nullopt;
            power = found;
        }
    }
    if (!power || std::abs(*power) > 50 || std::abs(*power * 2 - std::round(*power * 2)) > 1e-5)
        return std::nullopt;
    return static_cast<int>(std::lround(*power * 2));
}

} // namespace

std::optional<Unit> unitOf(const Expression &expression, std::vector<double> &slots,
    std::span<const std::optional<Unit>> units)
{
    Unit symbols; // all that occur, as one product; the powers do not matter
    for (const std::size_t slot : expression.used()) {
        if (!units[slot])
            return std::nullopt;
        for (const auto &one : units[slot]->halves())
            symbols.add(one.first, 1'000'000 + one.second);
    }
    Unit result;
    for (const auto &one : symbols.halves()) {
        const auto halves = halvesOf(expression, slots, units, one.first);
        if (!halves)
            return std::nullopt;
        if (*halves != 0)
            result.add(one.first, *halves);
    }
    return result;
}

} // namespace scope
