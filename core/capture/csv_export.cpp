#include "capture/csv_export.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>

namespace capture {

namespace {
using Kind = ChannelInfo::Kind;

// Bytes. All pieces are as large as that, to the byte: a system keeps a file's pages in blocks as large as the writes
// are and as they are aligned (folios, in Linux), and larger ones cost it less. Pieces of 256 KiB that begin anywhere
// take 1.4 times as long to write (ext4 of Linux 6.18); more than this gains nothing.
constexpr std::size_t kPiece = 1 << 20;
constexpr std::size_t kMostRowsARun = 512; ///< so that their text stays in the cache
constexpr std::size_t kTimeWidth = 24; ///< digits of 64 bits, sign and point
constexpr std::size_t kCodeWidth = 16; ///< of an entry of CodeTexts
/// A double's shortest text: sign, 17 digits, point, e-308.
constexpr std::size_t kNumberWidth = 24;
constexpr std::size_t kLineEndWidth = 2;
constexpr std::size_t kColumnWidth = kNumberWidth + 1; ///< and the separator

/// What a dialect writes between things.
struct Marks {
    char separator = ',';
    char decimal = '.';
    std::string_view lineEnd = "\n";
    std::string_view begin; ///< of the file
};

constexpr Marks kPlain{};
constexpr Marks kContinental{';', ',', "\r\n", "\xEF\xBB\xBF"};

const Marks &marksOf(CsvDialect dialect)
{
    return dialect == CsvDialect::Continental ? kContinental : kPlain;
}

/// to_chars() knows the point only.
char *withDecimal(char *from, char *to, char decimal)
{
    if (decimal != '.')
        std::replace(from, to, '.', decimal);
    return to;
}

/// Shortest text that reads back exactly; at most 24 characters.
char *writeNumber(char *at, double value, char decimal)
{
    return withDecimal(at, std::to_chars(at, at + kNumberWidth, value).ptr, decimal);
}

/// The digits of a number below 10^8, the first in the lowest byte: halves, then quarters, then digits side by side in
/// one word, each by a multiplication that stands for a division.
constexpr std::uint64_t eightDigits(std::uint32_t number)
{
    const std::uint64_t fours = number / 10'000 | std::uint64_t{number % 10'000} << 32;
    // / 100, exact below 10^4
    const std::uint64_t hundreds = (fours * 10486 >> 20) & 0x7F'0000'007FU;
    const std::uint64_t twos = hundreds | (fours - 100 * hundreds) << 16;
    const std::uint64_t tens = (twos * 103 >> 10) & 0x000F'000F'000F'000FU; // / 10, exact below 100
    return tens | (twos - 10 * tens) << 8;
}
static_assert(eightDigits(12'345'678) == 0x08'07'06'05'04'03'02'01U);
static_assert(eightDigits(99'999'999) == 0x09'09'09'09'09'09'09'09U);

/// The digits behind the point, and it, if they are not all zeros; ends with the last that is not 0.
char *writeFraction(char *at, Nanos nanos, char decimal)
{
    const auto fraction = static_cast<std::uint32_t>(nanos);
    if (fraction == 0)
        return at;
    *at++ = decimal;
    *at++ = static_cast<char>('0' + fraction / 100'000'000);
    const std::uint64_t digits = eightDigits(fraction % 100'000'000);
    if constexpr (std::endian::native == std::endian::little) {
        const std::uint64_t text = digits | 0x3030303030303030U;
        std::memcpy(at, &text, sizeof text);
    } else {
        for (int i = 0; i < 8; ++i)
            at[i] = static_cast<char>('0' + (digits >> 8 * i & 0xF));
    }
    return at + (std::bit_width(digits) + 7) / 8;
}

/// Writes `time` at `at`, returns the end. The caller has kTimeWidth bytes ready.
char *writeTime(char *at, Nanos time, char decimal)
{
    if (time < 0) {
        *at++ = '-';
        time = -time;
    }
    at = std::to_chars(at, at + kTimeWidth, time / kSecond).ptr;
    return writeFraction(at, time % kSecond, decimal);
}

/// The same for one time after another: the digits before the point change rarely.
class TimeTexts {
public:
    explicit TimeTexts(char decimal)
        : m_decimal(decimal)
    {
    }
    char *write(char *at, Nanos time)
    {
        if (time < 0)
            return writeTime(at, time, m_decimal);
        if (const Nanos second = time / kSecond; second != m_second) {
            m_second = second;
            m_size = static_cast<std::size_t>(
                std::to_chars(m_digits.data(), m_digits.data() + m_digits.size(), second).ptr
                - m_digits.data());
        }
        std::memcpy(at, m_digits.data(), m_digits.size());
        return writeFraction(at + m_size, time - m_second * kSecond, m_decimal);
    }

private:
    char m_decimal;
    Nanos m_second = -1;
    std::array<char, 16> m_digits{}; ///< fewer than eleven are used
    std::size_t m_size = 0;
};

/// Samples of a channel in a range.
struct Part {
    Index begin = 0;
    Index end = 0;
};

Part partOf(const Channel &channel, const std::optional<TimeSpan> &range)
{
    if (!range)
        return {channel.begin(), channel.end()};
    return {channel.atOrAfter(toNanos(range->from)), channel.atOrAfter(toNanos(range->to))};
}

/// The kind whose samples make the rows: the fastest that has any.
Kind rowKind(const std::vector<Channel> &channels, const std::optional<TimeSpan> &range)
{
    Kind fastest = Kind::Polled;
    for (const Channel &channel : channels) {
        const Part part = partOf(channel, range);
        if (part.begin < part.end)
            fastest = std::min(fastest, channel.info().kind);
    }
    return fastest;
}
} // namespace

/// 65536 codes need formatting once each: the table turns a field into the copy of one 16-byte entry.
class CsvWriter::CodeTexts {
public:
    CodeTexts(const Channel &channel, const Marks &marks)
        : m_channel(channel)
        , m_marks(marks)
        , m_entries(65536)
    {
    }

    /// Phase currents, and those made of them, share a scale: one table for all of them stays in the cache.
    bool serves(const Channel &channel) const
    {
        return channel.info().factor == m_channel.info().factor
            && channel.info().offset == m_channel.info().offset;
    }

    char *write(char *at, std::int16_t code)
    {
        const Entry &entry = m_first[static_cast<std::uint16_t>(code)];
        if (entry.size == 0) [[unlikely]]
            return writeNew(at, code);
        std::memcpy(at, &entry, kCodeWidth);
        return at + entry.size;
    }

private:
    struct Entry {
        std::array<char, kCodeWidth - 1> text{}; ///< the separator first
        std::uint8_t size = 0;
    };
    static_assert(sizeof(Entry) == kCodeWidth);

    char *writeNew(char *at, std::int16_t code)
    {
        // As float: 24 bits tell 65536 codes apart, and the text is a third shorter than a double's.
        const auto value = static_cast<float>(m_channel.toShown(code));
        *at = m_marks.separator;
        char *const end = std::to_chars(at + 1, at + kColumnWidth, value).ptr;
        withDecimal(at + 1, end, m_marks.decimal);
        // A sign, nine digits, a point and e-38 with the separator have no room in the table: made each time.
        const auto size = static_cast<std::size_t>(end - at);
        Entry &entry = m_entries[static_cast<std::uint16_t>(code)];
        if (size <= entry.text.size()) {
            std::copy(at, end, entry.text.begin());
            entry.size = static_cast<std::uint8_t>(size);
        }
        return end;
    }

    const Channel &m_channel;
    const Marks &m_marks;
    std::vector<Entry> m_entries;
    const Entry *const m_first = m_entries.data();
};

struct CsvWriter::Column {
    const Channel *channel = nullptr;
    bool makesRows = false;
    Index next = 0; ///< first sample not yet used
    Index stop = 0; ///< one past the last in the range
    std::shared_ptr<CodeTexts> texts; ///< fast channels only
    // A held value: its text and how long it holds.
    std::array<char, kNumberWidth> held{};
    std::size_t heldSize = 0;
    Nanos heldUntil = std::numeric_limits<Nanos>::min();
};

struct CsvWriter::Run {
    Nanos time = 0;
    std::size_t count = 0;
    std::vector<bool> there; ///< by column: has a sample in each of these rows
    const Segment *segment = nullptr; ///< gives the rows' times if fast channels make them
    Index first = 0; ///< in that segment
};

std::vector<Snapshot> splitByRate(const Snapshot &channels)
{
    std::vector<Channel> fast;
    std::vector<Channel> slow;
    std::vector<Snapshot> polled;
    for (const Channel &channel : *channels) {
        if (channel.empty())
            continue;
        if (channel.info().kind == Kind::Fast)
            fast.push_back(channel);
        else if (channel.info().kind == Kind::Slow)
            slow.push_back(channel);
        else
            polled.push_back(std::make_shared<std::vector<Channel>>(1, channel));
    }
    std::vector<Snapshot> result;
    if (!fast.empty())
        result.push_back(std::make_shared<std::vector<Channel>>(std::move(fast)));
    if (!slow.empty())
        result.push_back(std::make_shared<std::vector<Channel>>(std::move(slow)));
    result.insert(result.end(), polled.begin(), polled.end());
    return result;
}

bool everySampleHasARow(const Snapshot &channels)
{
    const Kind rows = rowKind(*channels, {});
    std::vector<const Channel *> makers;
    for (const Channel &channel : *channels) {
        if (channel.info().kind == rows)
            makers.push_back(&channel);
    }
    for (const Channel &channel : *channels) {
        for (Index i = channel.begin(); channel.info().kind != rows && i < channel.end(); ++i) {
            const Nanos from = channel.timeOf(i);
            const Nanos until = channel.holdUntil(i);
            const bool shown = std::ranges::any_of(makers, [&](const Channel *maker) {
                const Index row = maker->atOrAfter(from);
                return row < maker->end() && maker->timeOf(row) < until;
            });
            if (!shown)
                return false;
        }
    }
    return true;
}

std::string csvHeading(const ChannelInfo &channel)
{
    std::string heading = channel.name;
    if (!heading.empty() && std::strchr("=+-@\t\r\n", heading.front()))
        heading.insert(heading.begin(), '\'');
    if (!channel.unit.empty())
        heading += " [" + channel.unit + "]";
    // Readers find out what separates the names by counting outside quotes: a name may hold none of it there.
    if (heading.find_first_of("\",;\t\r\n") == std::string::npos)
        return heading;
    std::string quoted = "\"";
    for (const char c : heading)
        quoted.append(c == '"' ? 2 : 1, c);
    return quoted + '"';
}

std::string csvTime(Nanos time)
{
    std::array<char, kTimeWidth> text{};
    return {text.data(), writeTime(text.data(), time, '.')};
}

CsvWriter::CsvWriter(Snapshot channels, CsvOptions options)
    : m_channels(std::move(channels))
    , m_options(options)
{
    const Kind rows = rowKind(*m_channels, m_options.range);
    for (const Channel &channel : *m_channels) {
        auto column = std::make_unique<Column>();
        column->channel = &channel;
        column->makesRows = channel.info().kind == rows || channel.fast(); // which is never held
        const Part part = partOf(channel, m_options.range);
        column->next = part.begin;
        column->stop = part.end;
        if (!column->makesRows && column->next > channel.begin())
            --column->next; // may still hold when the range starts
        if (channel.fast())
            column->texts = textsFor(channel);
        if (column->makesRows && column->stop > column->next)
            m_total += column->stop - column->next;
        m_columns.push_back(std::move(column));
    }
}

CsvWriter::~CsvWriter() = default;

std::shared_ptr<CsvWriter::CodeTexts> CsvWriter::textsFor(const Channel &channel) const
{
    for (const auto &column : m_columns) {
        if (column->texts && column->texts->serves(channel))
            return column->texts;
    }
    return std::make_shared<CodeTexts>(channel, marksOf(m_options.dialect));
}

double CsvWriter::progress() const
{
    if (m_total == 0)
        return m_text.empty() ? 0.0 : 1.0;
    return static_cast<double>(m_done) / static_cast<double>(m_total);
}

bool CsvWriter::next(std::string_view &piece)
{
    if (m_text.empty()) {
        const std::string first = heading();
        const std::size_t rowWidth = kTimeWidth + m_columns.size() * kColumnWidth + kLineEndWidth;
        m_text.resize(first.size() + kPiece + kMostRowsARun * rowWidth);
        std::copy(first.begin(), first.end(), m_text.begin());
        m_size = first.size();
    }
    std::copy(m_text.begin() + static_cast<std::ptrdiff_t>(m_shown),
        m_text.begin() + static_cast<std::ptrdiff_t>(m_size), m_text.begin());
    m_size -= m_shown;
    Run run;
    while (m_size < kPiece && plan(run))
        m_size = static_cast<std::size_t>(writeRun(run, m_text.data() + m_size) - m_text.data());
    m_shown = std::min(m_size, kPiece);
    piece = {m_text.data(), m_shown};
    return !piece.empty();
}

std::string CsvWriter::heading() const
{
    const Marks &marks = marksOf(m_options.dialect);
    std::string text{marks.begin};
    text += "time [s]";
    for (const Channel &channel : *m_channels)
        text += marks.separator + csvHeading(channel.info());
    text += marks.lineEnd;
    return text;
}

/// Finds the next rows: their start, which columns have samples in them, and how many there are before that changes.
bool CsvWriter::plan(Run &run) const
{
    bool any = false;
    for (const auto &column : m_columns) {
        if (!column->makesRows || column->next >= column->stop)
            continue;
        const Nanos time = column->channel->timeOf(column->next);
        run.time = any ? std::min(run.time, time) : time;
        any = true;
    }
    if (!any)
        return false;
    run.there.assign(m_columns.size(), false);
    run.segment = nullptr;
    run.count = kMostRowsARun;
    Nanos others = std::numeric_limits<Nanos>::max();
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const Column &column = *m_columns[i];
        if (!column.makesRows || column.next >= column.stop)
            continue;
        const Nanos time = column.channel->timeOf(column.next);
        if (time > run.time) {
            others = std::min(others, time);
            continue;
        }
        run.there[i] = true;
        const FastColumn *fast = column.channel->fast();
        if (!fast) {
            run.count = 1;
            continue;
        }
        const Segment &segment = fast->segments()[fast->pieceOf(column.next)];
        const auto left =
            static_cast<std::size_t>(std::min(segment.end(), column.stop) - column.next);
        run.count = std::min(run.count, fast->codes(column.next, left).size());
        if (!run.segment) {
            run.segment = &segment;
            run.first = column.next;
        } else if (run.segment->base != segment.base || run.segment->step != segment.step) {
            run.count = 1;
        }
    }
    if (run.segment && others != std::numeric_limits<Nanos>::max())
        run.count = std::min(
            run.count, static_cast<std::size_t>(run.segment->atOrAfter(others) - run.first));
    return true;
}

/// @param at  has room for kMostRowsARun rows
char *CsvWriter::writeRun(const Run &run, char *at)
{
    m_fields.clear();
    m_codes.resize(m_columns.size() * kMostRowsARun);
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        Column &column = *m_columns[i];
        Field field{&column, nullptr, nullptr, run.there[i]};
        if (run.there[i] && column.texts) {
            field.texts = column.texts.get();
            // Copied: the columns lie whole chunks apart, and would push each other out of the processor's first cache.
            const auto codes = column.channel->fast()->codes(column.next, run.count);
            std::int16_t *const copy = m_codes.data() + i * kMostRowsARun;
            std::copy_n(codes.data(), run.count, copy);
            field.codes = copy;
        }
        m_fields.push_back(field);
    }
    // Most rows of a run are a whole number of nanoseconds apart; the exact division is for the others.
    const Segment *segment = run.segment;
    const std::int64_t nanosPerKilosteps =
        segment ? segment->step * TickBase::kNanosPerKilosecond : 0;
    const bool even = !segment || nanosPerKilosteps % segment->base.milliHz == 0;
    const Nanos step = segment ? nanosPerKilosteps / segment->base.milliHz : 0;

    const Marks &marks = marksOf(m_options.dialect);
    TimeTexts times(marks.decimal);
    Nanos time = run.time;
    // A copy: for all the compiler knows, text is written over members.
    const std::span<const Field> fields(m_fields);
    for (std::size_t row = 0; row < run.count; ++row) {
        if (row != 0)
            time = even ? time + step : segment->timeOf(run.first + row);
        at = times.write(at, time);
        for (const Field &field : fields) {
            if (field.codes) {
                at = field.texts->write(at, field.codes[row]);
                continue;
            }
            *at++ = marks.separator;
            if (!field.column->makesRows)
                at = writeHeld(*field.column, time, marks.decimal, at);
            else if (field.there)
                at = writeNumber(at, field.column->channel->at(field.column->next), marks.decimal);
        }
        at = std::copy(marks.lineEnd.begin(), marks.lineEnd.end(), at);
    }
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        if (run.there[i]) {
            m_columns[i]->next += run.count;
            m_done += run.count;
        }
    }
    m_rows += run.count;
    return at;
}

/// The newest value at or before `time`; nothing before the first and where it does not hold any more.
char *CsvWriter::writeHeld(Column &column, Nanos time, char decimal, char *at)
{
    const ValueColumn *values = column.channel->values();
    while (column.next < values->end() && values->timeOf(column.next) <= time) {
        const char *end = writeNumber(column.held.data(), column.channel->at(column.next), decimal);
        column.heldSize = static_cast<std::size_t>(end - column.held.data());
        column.heldUntil = column.channel->holdUntil(column.next);
        ++column.next;
    }
    if (time < column.heldUntil)
        at = std::copy_n(column.held.data(), column.heldSize, at);
    return at;
}

} // namespace capture
