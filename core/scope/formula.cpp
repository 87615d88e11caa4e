#include "scope/formula.h"

#include "base/text.h"
#include "scope/expression.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace scope {

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isNameStart(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isName(char c) { return isNameStart(c) || isDigit(c) || c == '.'; }

/// Text for muparser, with the place each byte came from.
struct Lowered {
    std::string code;
    std::vector<std::size_t> origin;
    void add(std::string_view text, std::size_t from)
    {
        code += text;
        origin.resize(code.size(), from);
    }
    void add(const Lowered &other)
    {
        code += other.code;
        origin.insert(origin.end(), other.origin.begin(), other.origin.end());
    }
};

/// [from, to) of the text.
struct Piece {
    std::size_t from;
    std::size_t to;
};

} // namespace

/// Replaces the names and calls of a formula by slots, innermost first. Faults are thrown inside this file and
/// returned by compile().
class FormulaCompiler {
public:
    FormulaCompiler(std::string_view text, std::span<const FormulaName> names)
        : m_text(text)
        , m_names(names)
        , m_program(std::make_unique<Formula::Program>())
    {
        m_program->slots.assign(names.size() + Formula::kMostCalls, 0.0);
        for (const FormulaName &name : names)
            m_units.emplace_back(Unit::of(name.unit));
        m_units.resize(m_program->slots.size());
    }

    Formula compile()
    {
        if (m_text.size() > Formula::kMostBytes)
            throw FormulaFault{FormulaError::TooLong, Formula::kMostBytes};
        const Piece all{0, m_text.size()};
        m_program->result.emplace(expression(all, 0));
        const auto unit = unitOf(*m_program->result, m_program->slots, m_units);
        m_program->unit = unit ? unit->text() : std::string();
        std::ranges::sort(m_used);
        m_used.erase(std::unique(m_used.begin(), m_used.end()), m_used.end());
        m_program->used = m_used;
        return Formula(std::move(m_program));
    }

private:
    /// One expression, checked by muparser.
    Expression expression(Piece piece, int depth)
    {
        const Lowered lowered = lower(piece, depth);
        if (lowered.code.find_first_not_of(' ') == std::string::npos)
            throw FormulaFault{depth == 0 ? FormulaError::Empty : FormulaError::Syntax, piece.from};
        Expression result(lowered.code, m_program->slots);
        if (const auto fault = result.fault())
            throw FormulaFault{FormulaError::Syntax,
                *fault < lowered.origin.size() ? lowered.origin[*fault] : piece.to};
        return result;
    }

    Lowered lower(Piece piece, int depth)
    {
        if (depth > Formula::kMostDepth)
            throw FormulaFault{FormulaError::TooDeep, piece.from};
        Lowered result;
        int open = depth;
        for (std::size_t at = piece.from; at < piece.to;) {
            const char c = m_text[at];
            if (c == ' ' || c == '\t') {
                result.add(" ", at++);
            } else if (isDigit(c) || c == '.') {
                at = number(at, piece.to, result);
            } else if (isNameStart(c)) {
                at = word(at, piece.to, open, result);
            } else if (c == '[') {
                at = bracketed(at, piece.to, result);
            } else {
                open += c == '(' ? 1 : c == ')' ? -1 : 0;
                if (open > Formula::kMostDepth)
                    throw FormulaFault{FormulaError::TooDeep, at};
                at = symbol(at, result);
            }
        }
        return result;
    }

    std::size_t symbol(std::size_t at, Lowered &result) const
    {
        static constexpr std::string_view kPairs[] = {"<=", ">=", "==", "!=", "&&", "||"};
        const std::string_view two = m_text.substr(at, 2);
        for (const std::string_view pair : kPairs) {
            if (two == pair) {
                result.add(pair, at);
                return at + 2;
            }
        }
        if (std::string_view("+-*/^()<>?:").find(m_text[at]) == std::string_view::npos)
            throw FormulaFault{
                m_text[at] == ',' ? FormulaError::Syntax : FormulaError::BadCharacter, at};
        result.add(m_text.substr(at, 1), at);
        return at + 1;
    }

    std::size_t number(std::size_t at, std::size_t to, Lowered &result) const
    {
        const char *const begin = m_text.data() + at;
        double value = 0.0;
        const auto [end, error] = readDecimal(begin, m_text.data() + to, value);
        const std::size_t next = at + static_cast<std::size_t>(end - begin);
        if (error != std::errc() || !std::isfinite(value) || (next < to && isName(m_text[next])))
            throw FormulaFault{FormulaError::BadNumber, at};
        result.add(" ", at); // so that no sign or name grows together with it
        result.add(m_text.substr(at, next - at), at);
        result.add(" ", at);
        return next;
    }

    std::size_t word(std::size_t at, std::size_t to, int depth, Lowered &result)
    {
        std::size_t end = at;
        while (end < to && isName(m_text[end]))
            ++end;
        const std::string_view name = m_text.substr(at, end - at);
        std::size_t next = end;
        while (next < to && m_text[next] == ' ')
            ++next;
        if (next < to && m_text[next] == '(')
            return call(name, at, next, to, depth, result);
        if (const auto slot = channel(name))
            addSlot(*slot, at, result);
        else if (Expression::isConstant(name))
            result.add(name, at);
        else
            throw FormulaFault{FormulaError::UnknownName, at};
        return end;
    }

    std::size_t bracketed(std::size_t at, std::size_t to, Lowered &result)
    {
        const std::size_t end = m_text.find(']', at);
        if (end == std::string_view::npos || end >= to)
            throw FormulaFault{FormulaError::Syntax, at};
        const auto slot = channel(m_text.substr(at + 1, end - at - 1));
        if (!slot)
            throw FormulaFault{FormulaError::UnknownName, at};
        addSlot(*slot, at, result);
        return end + 1;
    }

    std::optional<std::size_t> channel(std::string_view name) const
    {
        const auto found = std::ranges::find(m_names, name, &FormulaName::name);
        if (found == m_names.end())
            return std::nullopt;
        return static_cast<std::size_t>(found - m_names.begin());
    }

    void addSlot(std::size_t slot, std::size_t at, Lowered &result)
    {
        if (slot < m_names.size())
            m_used.push_back(slot);
        result.add(" " + Expression::slotName(slot) + " ", at);
    }

    /// The arguments between the parentheses that open at `open`; `end` is behind the closing one.
    std::vector<Piece> argumentsFrom(std::size_t open, std::size_t to, std::size_t &end) const
    {
        std::vector<Piece> result{{open + 1, open + 1}};
        int depth = 0;
        for (std::size_t at = open; at < to; ++at) {
            const char c = m_text[at];
            if (c == '[') {
                at = std::min(m_text.find(']', at), to);
            } else if (c == '(') {
                ++depth;
            } else if (c == ')' && --depth == 0) {
                result.back().to = at;
                end = at + 1;
                return result;
            } else if (c == ',' && depth == 1) {
                result.back().to = at;
                result.push_back({at + 1, at + 1});
            }
        }
        throw FormulaFault{FormulaError::Syntax, open};
    }

    std::size_t call(std::string_view name, std::size_t at, std::size_t open, std::size_t to,
        int depth, Lowered &result)
    {
        const ColumnFunctionInfo *const column = columnFunction(name);
        const std::size_t wanted = column ? column->arguments : Expression::argumentsOf(name);
        if (wanted == 0)
            throw FormulaFault{FormulaError::UnknownName, at};
        std::size_t end = 0;
        const std::vector<Piece> arguments = argumentsFrom(open, to, end);
        if (arguments.size() != wanted)
            throw FormulaFault{FormulaError::WrongArgumentCount, at};
        if (column) {
            addSlot(columnCall(*column, at, arguments, depth), at, result);
            return end;
        }
        result.add(name, at);
        result.add("(", open);
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            if (i > 0)
                result.add(",", arguments[i].from - 1);
            result.add(lower(arguments[i], depth + 1));
        }
        result.add(")", end - 1);
        return end;
    }

    std::size_t columnCall(const ColumnFunctionInfo &column, std::size_t at,
        const std::vector<Piece> &arguments, int depth)
    {
        FormulaCall call;
        ColumnSettings settings;
        std::vector<std::optional<Unit>> units;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            Expression argument = expression(arguments[i], depth + 1);
            if (column.lastIsConstant && i + 1 == arguments.size()) {
                if (!argument.used().empty())
                    throw FormulaFault{FormulaError::NotConstant, arguments[i].from};
                settings.constant = argument.value();
                if (!fits(column.kind, settings.constant))
                    throw FormulaFault{FormulaError::OutOfRange, arguments[i].from};
                break;
            }
            units.push_back(unitOf(argument, m_program->slots, m_units));
            if (isAngle(column.kind, i))
                settings.turn = turnOf(units.back(), arguments[i].from);
            call.arguments.push_back(std::move(argument));
        }
        if (m_program->calls.size() == Formula::kMostCalls)
            throw FormulaFault{FormulaError::TooDeep, at};
        call.slot = m_names.size() + m_program->calls.size();
        call.function = makeColumnFunction(column.kind, settings);
        m_units[call.slot] = resultUnit(column.kind, units);
        m_program->calls.push_back(std::move(call));
        return m_program->calls.back().slot;
    }

    static bool isAngle(ColumnKind kind, std::size_t argument)
    {
        const bool park = kind == ColumnKind::ParkD || kind == ColumnKind::ParkQ;
        return kind == ColumnKind::Unwrap || (park && argument == 2);
    }

    static double turnOf(const std::optional<Unit> &unit, std::size_t at)
    {
        if (unit == Unit::of("°"))
            return 360.0;
        if (unit == Unit::of("rad"))
            return 2.0 * std::numbers::pi;
        throw FormulaFault{FormulaError::NotAnAngle, at};
    }

    static std::optional<Unit> resultUnit(
        ColumnKind kind, const std::vector<std::optional<Unit>> &units)
    {
        if (!units[0])
            return std::nullopt;
        switch (kind) {
        case ColumnKind::Derivative:
            return *units[0] / Unit::of("s");
        case ColumnKind::Integral:
            return *units[0] * Unit::of("s");
        case ColumnKind::ClarkeBeta:
        case ColumnKind::ParkD:
        case ColumnKind::ParkQ:
            return units[0] == units[1] ? units[0] : std::nullopt;
        case ColumnKind::Power: {
            if (!units[1] || !units[2] || !units[3])
                return std::nullopt;
            const Unit d = *units[0] * *units[1];
            return d == *units[2] * *units[3] ? std::optional(d) : std::nullopt;
        }
        default:
            return units[0];
        }
    }

    std::string_view m_text;
    std::span<const FormulaName> m_names;
    std::unique_ptr<Formula::Program> m_program;
    std::vector<std::optional<Unit>> m_units; ///< of the slots
    std::vector<std::size_t> m_used;
};

Result<Formula, FormulaFault> Formula::compile(
    std::string_view text, std::span<const FormulaName> names)
{
    try {
        return FormulaCompiler(text, names).compile();
    } catch (const FormulaFault &fault) {
        return fail(fault);
    }
}

Formula::Formula(std::unique_ptr<Program> program)
    : m_program(std::move(program))
{
}
Formula::Formula(Formula &&) noexcept = default;
Formula &Formula::operator=(Formula &&) noexcept = default;
Formula::~Formula() = default;

const std::vector<std::size_t> &Formula::used() const { return m_program->used; }
const std::string &Formula::unit() const { return m_program->unit; }

double Formula::step(std::span<const double> values, double seconds, bool joined)
{
    Program &program = *m_program;
    for (std::size_t i = 0; i < program.used.size(); ++i)
        program.slots[program.used[i]] = values[i];
    std::array<double, kMostArguments> arguments{};
    for (FormulaCall &call : program.calls) {
        bool known = true;
        for (std::size_t i = 0; i < call.arguments.size(); ++i) {
            arguments[i] = call.arguments[i].value();
            known = known && std::isfinite(arguments[i]);
        }
        // What is not a number stays outside: one of them would spoil a filter for ever.
        program.slots[call.slot] = known
            ? call.function->step(
                std::span(arguments).first(call.arguments.size()), seconds, joined && call.joined)
            : std::numeric_limits<double>::quiet_NaN();
        call.joined = known;
    }
    return program.result->value();
}

} // namespace scope
