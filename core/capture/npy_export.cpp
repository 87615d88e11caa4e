#include "capture/npy_export.h"

#include "base/text.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace capture {

namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 20; ///< bytes

/// As Python writes it; NumPy reads the head as Python's literals.
std::string quoted(std::string_view name)
{
    std::string text = "'";
    for (const char c : name) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || code == 0x7F) {
            text += "\\x" + hexDigits(code, 2, kLowerHex);
            continue;
        }
        if (c == '\'' || c == '\\')
            text += '\\';
        text += c;
    }
    return text + '\'';
}

/// Told apart: NumPy takes no name twice, and none that is empty.
std::string freeName(const std::string &wanted, std::set<std::string> &taken)
{
    const std::string stem = wanted.empty() ? "signal" : wanted;
    std::string name = stem;
    for (int i = 2; !taken.insert(name).second; ++i)
        name = stem + '_' + std::to_string(i);
    return name;
}

/// The control period that is nearest to an instant, as the first fast signal counts them; -1 without one.
Tick tickAt(const Snapshot &channels, Nanos time)
{
    for (const Channel &channel : *channels) {
        if (channel.fast() == nullptr || channel.fast()->segments().empty())
            continue;
        const std::vector<Segment> &segments = channel.fast()->segments();
        const auto after = std::ranges::upper_bound(segments, time, {}, &Segment::start);
        const TickBase &base = (after == segments.begin() ? *after : *std::prev(after)).base;
        const auto ticks = static_cast<long double>(time - base.origin)
            * static_cast<long double>(base.milliHz) / TickBase::kNanosPerKilosecond;
        return static_cast<Tick>(std::llround(ticks));
    }
    return -1;
}

void put(std::uint64_t value, std::size_t width, std::string &out)
{
    for (std::size_t i = 0; i < width; ++i)
        out += static_cast<char>(value >> (8 * i) & 0xFFU);
}

} // namespace

NpyWriter::NpyWriter(
    const Snapshot &channels, const std::optional<TimeSpan> &range, std::size_t mostBytes)
    : m_channels(channels)
{
    const std::size_t most = mostBytes / ((m_channels->size() + 2) * sizeof(double));
    m_rows = rowsOf(m_channels, range, [&](std::size_t rows, std::size_t least) {
        m_tooLong = std::max(rows, least) > most;
        return !m_tooLong;
    });
    findGaps();
    m_tooLong = m_tooLong || rows() > most;
}

void NpyWriter::findGaps()
{
    std::set<double> found;
    for (const Channel &channel : *m_channels) {
        if (channel.fast() == nullptr)
            continue;
        const std::vector<Segment> &segments = channel.fast()->segments();
        for (std::size_t i = 1; i < segments.size(); ++i)
            if (segments[i].start() > segments[i - 1].stop())
                found.insert(toSeconds(segments[i - 1].stop()));
    }
    const auto &time = m_rows.time;
    for (const double at : found)
        if (!time.empty() && at > time.front() && at < time.back()
            && !std::ranges::binary_search(time, at))
            m_gaps.push_back(at);
}

std::string NpyWriter::head() const
{
    std::set<std::string> taken{"tick", "seconds"};
    std::string text = "{'descr': [('tick', '<i8'), ('seconds', '<f8')";
    for (const Channel &channel : *m_channels)
        text += ", (" + quoted(freeName(channel.info().name, taken)) + ", '<f8')";
    text += "], 'fortran_order': False, 'shape': (" + std::to_string(rows()) + ",)}";
    const bool plain =
        text.size() < 60'000 && std::ranges::all_of(text, [](char c) { return (c & 0x80) == 0; });
    // Of the length of what follows; version 3.0 is in UTF-8.
    const std::size_t width = plain ? 2 : 4;
    constexpr std::size_t kAligned = 64;
    while ((8 + width + text.size() + 1) % kAligned != 0)
        text += ' ';
    text += '\n';
    std::string head = std::string("\x93NUMPY") + (plain ? '\1' : '\3') + '\0';
    put(text.size(), width, head);
    return head + text;
}

void NpyWriter::putRow()
{
    const bool isGap = m_gap < m_gaps.size()
        && (m_row == m_rows.time.size() || m_gaps[m_gap] < m_rows.time[m_row]);
    const double seconds = isGap ? m_gaps[m_gap++] : m_rows.time[m_row];
    put(std::bit_cast<std::uint64_t>(tickAt(m_channels, toNanos(seconds))), 8, m_piece);
    put(std::bit_cast<std::uint64_t>(seconds), 8, m_piece);
    for (const std::vector<double> &column : m_rows.columns)
        put(std::bit_cast<std::uint64_t>(
                isGap ? std::numeric_limits<double>::quiet_NaN() : column[m_row]),
            8, m_piece);
    m_row += isGap ? 0 : 1;
}

bool NpyWriter::next(std::string_view &bytes)
{
    if (m_tooLong || (m_begun && m_row + m_gap == rows()))
        return false;
    m_piece = std::exchange(m_begun, true) ? std::string() : head();
    while (m_row + m_gap < rows() && m_piece.size() < kBuffer)
        putRow();
    bytes = m_piece;
    return true;
}

double NpyWriter::progress() const
{
    return rows() == 0 ? 1.0 : static_cast<double>(m_row + m_gap) / static_cast<double>(rows());
}

} // namespace capture
