#include "capture/csv_import.h"

#include "base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace capture {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr Nanos kDay = 86'400 * kSecond;
/// 127 years: UTC seconds fit, and so does a difference of two times
constexpr Nanos kFarthest = 4'000'000'000 * kSecond;
constexpr int kGap = 10; ///< usual distances
/// Equal distances differ by less than this part of one, or a nanosecond of rounding.
constexpr int kExact = 1000;
constexpr std::size_t kShownField = 40;
constexpr std::size_t kAtOnce = 512; ///< values of a channel
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct TimeName {
    std::string_view name;
    Nanos unit;
    bool wraps;
};
constexpr std::array kTimeNames{TimeName{"time", kSecond, false},
    TimeName{"__time", kSecond, false}, TimeName{"t", kSecond, false},
    TimeName{"timestamp", kSecond, false}, TimeName{"ms_today", 1'000'000, true}};

std::string_view trimmed(std::string_view text)
{
    if (!text.empty() && text.front() > ' ' && text.back() > ' ')
        return text; // as nearly all of them
    const auto from = text.find_first_not_of(" \t");
    if (from == std::string_view::npos)
        return {};
    return text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

/// `NAME [unit]` in two; the apostrophe that keeps spreadsheets from computing goes.
std::pair<std::string, std::string> nameAndUnit(std::string_view heading)
{
    heading = trimmed(heading);
    constexpr std::string_view kFormula = "=+-@\t\r\n";
    if (heading.size() > 1 && heading[0] == '\''
        && kFormula.find(heading[1]) != std::string_view::npos)
        heading.remove_prefix(1);
    const auto open = heading.rfind(" [");
    if (open == std::string_view::npos || !heading.ends_with(']'))
        return {std::string(heading), {}};
    return {std::string(heading.substr(0, open)),
        std::string(heading.substr(open + 2, heading.size() - open - 3))};
}

bool isCalled(std::string_view name, std::string_view known)
{
    return std::equal(name.begin(), name.end(), known.begin(), known.end(), [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
    });
}

constexpr Word<Nanos> kTimeUnits[] = {
    {"s", kSecond}, {"ms", 1'000'000}, {"us", 1000}, {"\u00b5s", 1000}, {"ns", 1}};

/// The same of what may be the time: a unit of time may stand there without a blank, unlike one of a signal, whose name
/// may end like `joint[0]`.
std::pair<std::string, std::string> timeNameAndUnit(std::string_view heading)
{
    auto [name, unit] = nameAndUnit(heading);
    const auto open = name.rfind('[');
    if (!unit.empty() || open == std::string::npos || !name.ends_with(']'))
        return {std::move(name), std::move(unit)};
    unit = name.substr(open + 1, name.size() - open - 2);
    if (findWord(kTimeUnits, unit) == nullptr)
        return {std::move(name), std::string()};
    return {name.substr(0, open), std::move(unit)};
}

/// What separates the names: the most frequent of three outside quotes.
char separatorOf(std::string_view heading)
{
    using Count = std::pair<std::size_t, char>;
    std::array counts{Count{0, ','}, Count{0, ';'}, Count{0, '\t'}};
    bool quoted = false;
    for (const char c : heading) {
        quoted ^= c == '"';
        for (auto &[count, separator] : counts)
            count += !quoted && c == separator;
    }
    return std::ranges::max_element(counts, {}, &Count::first)->second;
}

bool isUnknown(std::string_view field)
{
    if (field.empty())
        return true;
    constexpr std::array kWords{"nan", "NaN", "NAN", "-nan", "inf", "-inf", "Inf", "-Inf"};
    return std::ranges::find(kWords, field) != kWords.end();
}

/// A plain decimal number of `unit` as nanoseconds, exactly; digits beyond the nanosecond are rounded.
std::optional<Nanos> exactTime(std::string_view text, Nanos unit)
{
    const bool negative = text.starts_with('-');
    text.remove_prefix(negative || text.starts_with('+') ? 1 : 0);
    Nanos whole = 0;
    const char *end = text.data() + text.size();
    const auto [at, problem] = std::from_chars(text.data(), end, whole);
    if (problem != std::errc{} || whole < 0 || whole > kFarthest / unit)
        return std::nullopt;
    Nanos nanos = whole * unit;
    if (at != end) {
        if (*at != '.')
            return std::nullopt;
        Nanos place = unit;
        bool rounded = false;
        for (const char *digit = at + 1; digit != end; ++digit) {
            if (*digit < '0' || *digit > '9')
                return std::nullopt;
            if (place > 1)
                nanos += (*digit - '0') * (place /= 10);
            else if (!std::exchange(rounded, true) && *digit >= '5')
                ++nanos;
        }
    }
    return negative ? -nanos : nanos;
}

} // namespace

bool CsvImport::fail(CsvError::What what, std::size_t column, std::string_view field)
{
    settleAll();
    m_error = CsvError{what, m_line, column, std::string(field.substr(0, kShownField))};
    return false;
}

bool CsvImport::feed(std::string_view text)
{
    while (!m_error && !text.empty()) {
        const auto end = text.find('\n');
        const std::string_view part = text.substr(0, end);
        if (m_rest.size() + part.size() > kLongestLine) {
            ++m_line;
            return fail(CsvError::What::LineTooLong);
        }
        if (end == std::string_view::npos) {
            m_rest += part;
            break;
        }
        text.remove_prefix(end + 1);
        if (m_rest.empty()) {
            parseLine(part);
        } else {
            m_rest += part;
            const std::string line = std::exchange(m_rest, {});
            parseLine(line);
        }
    }
    return !m_error;
}

bool CsvImport::finish()
{
    if (!m_error && !m_rest.empty()) {
        const std::string line = std::exchange(m_rest, {});
        parseLine(line);
    }
    settleAll();
    if (!m_error && m_rows == 0)
        return fail(m_columns == 0 ? CsvError::What::NoHeading : CsvError::What::NoRows);
    return !m_error;
}

bool CsvImport::parseLine(std::string_view line)
{
    ++m_line;
    if (m_line == 1 && line.starts_with(kByteOrderMark))
        line.remove_prefix(kByteOrderMark.size());
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    if (trimmed(line).empty())
        return true; // an empty line ends many a file
    return m_columns == 0 ? parseHeading(line) : parseRow(line);
}

/// A line into m_fields; quotes go, doubled ones become one.
bool CsvImport::split(std::string_view line)
{
    m_fields.clear();
    if (line.find('"') == std::string_view::npos) {
        for (std::size_t from = 0;;) {
            if (m_fields.size() == kMostColumns)
                return fail(CsvError::What::TooManyColumns, kMostColumns + 1);
            const auto to = line.find(m_separator, from);
            m_fields.push_back(line.substr(from, to - from));
            if (to == std::string_view::npos)
                break;
            from = to + 1;
        }
    } else if (!splitQuoted(line)) {
        return false;
    }
    // VESC Tool ends each line with a separator.
    if (m_fields.size() > 1 && m_fields.back().empty()
        && (m_columns == 0 || m_fields.size() > m_columns))
        m_fields.pop_back();
    return true;
}

bool CsvImport::splitQuoted(std::string_view line)
{
    m_unquoted.clear();
    m_unquoted.reserve(line.size()); // fields point into it
    std::size_t from = 0;
    const auto end = [&] {
        m_fields.push_back(std::string_view(m_unquoted).substr(from));
        from = m_unquoted.size();
    };
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"') {
            const bool doubled = quoted && i + 1 < line.size() && line[i + 1] == '"';
            if (doubled)
                m_unquoted += line[++i];
            else
                quoted = !quoted;
        } else if (c == m_separator && !quoted) {
            end();
            if (m_fields.size() == kMostColumns)
                return fail(CsvError::What::TooManyColumns, kMostColumns + 1);
        } else {
            m_unquoted += c;
        }
    }
    end();
    return true;
}

bool CsvImport::parseHeading(std::string_view line)
{
    m_separator = separatorOf(line);
    if (!split(line))
        return false;
    const auto looksLikeNumber = [](std::string_view field) {
        return numberIn<double>(trimmed(field)).has_value();
    };
    if (std::ranges::all_of(m_fields, looksLikeNumber))
        return fail(CsvError::What::NoHeading, 1, m_fields.front());
    if (m_fields.size() < 2)
        return fail(CsvError::What::NoSignals, 1, m_fields.front());
    m_columns = m_fields.size();
    bool found = false;
    for (std::size_t i = 0; i < m_columns && !found; ++i) {
        const std::string name = timeNameAndUnit(m_fields[i]).first;
        for (const TimeName &known : kTimeNames) {
            if (!isCalled(name, known.name))
                continue;
            m_timeColumn = i;
            m_timeUnit = known.unit;
            m_wrapsAtMidnight = known.wraps;
            found = true;
        }
    }
    const std::string timeUnit = timeNameAndUnit(m_fields[m_timeColumn]).second;
    if (const Nanos *known = findWord(kTimeUnits, timeUnit))
        m_timeUnit = *known;
    for (std::size_t i = 0; i < m_columns; ++i) {
        if (i == m_timeColumn)
            continue;
        auto [name, unit] = nameAndUnit(m_fields[i]);
        if (name.empty()) // by its place: a nameless last column of a file would be none for any reader
            name = '#' + std::to_string(i + 1);
        m_channels.push_back(m_capture.addImported(std::move(name), std::move(unit)));
    }
    m_pending.resize(m_channels.size());
    return true;
}

/// Good until the next call.
std::string_view CsvImport::withPoint(std::string_view field)
{
    if (m_separator == ',' || field.find(',') == std::string_view::npos)
        return field;
    m_scratch = field;
    std::ranges::replace(m_scratch, ',', '.');
    return m_scratch;
}

bool CsvImport::parseTime(std::string_view field, std::size_t column, Nanos &time)
{
    field = withPoint(field);
    const auto exact = exactTime(field, m_timeUnit);
    if (exact) {
        time = *exact;
        return true;
    }
    const auto value = numberIn<double>(field);
    if (!value
        || !(std::abs(*value) * static_cast<double>(m_timeUnit) < static_cast<double>(kFarthest)))
        return fail(CsvError::What::NoTime, column, field);
    time = static_cast<Nanos>(std::llround(*value * static_cast<double>(m_timeUnit)));
    return true;
}

/// Unknown where it is none, or not finite.
double CsvImport::number(std::string_view field)
{
    const auto value = numberIn<double>(withPoint(field));
    return value && std::isfinite(*value) ? *value : kUnknown;
}

/// The distance that three of four rows around this one, and itself, keep to. A few close rows or a few gaps do not
/// change it, and rows that come in twos and threes have that of their longer pauses.
Nanos CsvImport::usualAround(std::uint64_t row) const
{
    const std::uint64_t from = row > kAround ? row - kAround : 1;
    const std::uint64_t to = std::min(m_rows, row + kAround + 1);
    if (to <= from)
        return 1;
    if (m_sameSince <= from) // no need to look
        return m_distances[from % m_distances.size()];
    std::array<Nanos, 2 * kAround + 1> near{};
    const auto count = static_cast<std::ptrdiff_t>(to - from);
    for (std::uint64_t i = from; i < to; ++i)
        near[i - from] = m_distances[i % m_distances.size()];
    const auto usual = near.begin() + (count - 1) * 3 / 4;
    std::nth_element(near.begin(), usual, near.begin() + count);
    return *usual;
}

/// Far from the row before; or at several times the usual distance, where rows come at equal ones: then rows are
/// missing.
bool CsvImport::isGap(std::uint64_t row, Nanos usual) const
{
    const Nanos distance = m_distances[row % m_distances.size()];
    if ((distance - 1) / kGap >= usual) // divided: ten times a long distance is beyond 64 bits
        return true;
    const Nanos close = usual / kExact + 1, over = distance % usual;
    const bool nearTheNext = over > usual / 2;
    const Nanos times = distance / usual + (nearTheNext ? 1 : 0);
    if (times < 2 || (nearTheNext ? usual - over : over) > close)
        return false;
    const std::uint64_t from = row > kAround ? row - kAround : 1;
    const std::uint64_t to = std::min(m_rows, row + kAround + 1);
    std::uint64_t equal = 0;
    for (std::uint64_t i = from; i < to; ++i)
        equal += std::abs(m_distances[i % m_distances.size()] - usual) <= close ? 1 : 0;
    return equal * 4 >= (to - from) * 3;
}

/// The oldest row that waits goes into the capture.
void CsvImport::settle()
{
    const Row &row = m_ahead[m_settled % m_ahead.size()];
    const Nanos usual = usualAround(m_settled);
    const bool gap = m_settled > 0 && isGap(m_settled, usual);
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        Pending &pending = m_pending[i];
        const bool known = !std::isnan(row.values[i]);
        if (gap || !known) {
            store(i);
            m_capture.breakImported(m_channels[i]);
        }
        if (!known)
            continue;
        pending.times.push_back(row.time);
        pending.values.push_back(row.values[i]);
        pending.holdUntil = row.time + usual;
        if (pending.times.size() == kAtOnce)
            store(i);
    }
    ++m_settled;
}

void CsvImport::store(std::size_t channel)
{
    Pending &pending = m_pending[channel];
    if (pending.times.empty())
        return;
    m_capture.appendImported(m_channels[channel], pending.times, pending.values, pending.holdUntil);
    pending.times.clear();
    pending.values.clear();
}

void CsvImport::settleAll()
{
    while (m_settled < m_rows)
        settle();
    for (std::size_t i = 0; i < m_pending.size(); ++i)
        store(i);
}

bool CsvImport::parseRow(std::string_view line)
{
    if (!split(line))
        return false;
    if (m_fields.size() != m_columns)
        return fail(CsvError::What::OtherNumberOfFields, std::min(m_fields.size(), m_columns) + 1);
    Nanos time = 0;
    if (!parseTime(trimmed(m_fields[m_timeColumn]), m_timeColumn + 1, time))
        return false;
    time += m_midnights;
    if (m_rows > 0 && time < m_last && m_wrapsAtMidnight && m_last - time > kDay / 2) {
        m_midnights += kDay;
        time += kDay;
    }
    if (m_rows > 0 && time < m_last)
        return fail(CsvError::What::TimeRunsBack, m_timeColumn + 1, m_fields[m_timeColumn]);
    if (m_rows > 0 && time == m_last) {
        m_leftOut += m_wrapsAtMidnight ? 0 : 1; // which only VESC Tool's do
        return true;
    }
    Row &row = m_ahead[m_rows % m_ahead.size()];
    row.time = time;
    row.values.clear();
    for (std::size_t i = 0; i < m_columns; ++i) {
        if (i == m_timeColumn)
            continue;
        const std::string_view field = trimmed(m_fields[i]);
        row.values.push_back(number(field));
        if (std::isnan(row.values.back()) && !isUnknown(field))
            return fail(CsvError::What::NoNumber, i + 1, field);
    }
    const Nanos before = m_distances[(m_rows - 1) % m_distances.size()];
    m_distances[m_rows % m_distances.size()] = time - m_last; // means nothing for the first row
    if (m_rows < 2 || time - m_last != before)
        m_sameSince = m_rows;
    m_last = time;
    ++m_rows;
    if (m_rows - m_settled > kAround)
        settle();
    return true;
}

} // namespace capture
