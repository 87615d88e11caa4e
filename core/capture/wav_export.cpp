#include "capture/wav_export.h"

#include "base/text.h"

#include <algorithm>
#include <cmath>

namespace capture {

namespace {

constexpr std::size_t kMostChannels = 64;
constexpr std::size_t kPieceFrames = 32768;
constexpr std::size_t kMostCues = 10'000;
constexpr std::size_t kFormatBytes = 16;

std::string number(std::uint64_t value, int width)
{
    std::string bytes;
    for (int i = 0; i < width; ++i)
        bytes += static_cast<char>(value >> (8 * i));
    return bytes;
}

/// A chunk with its padding to an even length.
std::string chunk(const char *name, std::string content)
{
    const std::string size = number(content.size(), 4);
    if (content.size() % 2 != 0)
        content += '\0';
    return name + size + content;
}

} // namespace

WavWriter::WavWriter(const Snapshot &channels, std::optional<TimeSpan> range)
    : m_all(channels)
{
    for (const Channel &channel : *m_all) {
        if (channel.fast() && !channel.empty())
            m_channels.push_back(&channel);
    }
    if (m_channels.empty()) {
        m_problem = ExportProblem::NoFastSamples;
        return;
    }
    if (m_channels.size() > kMostChannels) {
        m_problem = ExportProblem::TooManySignals;
        return;
    }
    constexpr auto kEver = std::numeric_limits<Nanos>::max();
    const Nanos from = range ? toNanos(range->from) : -kEver;
    const Nanos to = range ? toNanos(range->to) : kEver;
    if (!findRate(from, to))
        return;
    findRuns(from, to);
    if (m_frames == 0)
        m_problem = ExportProblem::NoFastSamples;
    else if (m_frames > kMostDataBytes / (2 * m_channels.size()))
        m_problem = ExportProblem::TooLong;
}

/// The one rate of all samples in [from, to); false if there is none.
bool WavWriter::findRate(Nanos from, Nanos to)
{
    const Segment *one = nullptr;
    for (const Channel *channel : m_channels) {
        for (const Segment &segment : channel->fast()->segments()) {
            if (segment.start() >= to || segment.atOrAfter(from) == segment.end())
                continue;
            if (!one)
                one = &segment;
            if (segment.base.milliHz != one->base.milliHz || segment.step != one->step)
                m_problem = ExportProblem::DifferentRates;
        }
    }
    if (!one)
        m_problem = ExportProblem::NoFastSamples;
    if (m_problem != ExportProblem::None)
        return false;
    m_rate = static_cast<std::uint32_t>(
        std::lround(static_cast<double>(one->base.milliHz) / 1000.0 / one->step));
    return true;
}

/// Where every channel has samples at the same instants, as far as that goes on.
void WavWriter::findRuns(Nanos from, Nanos to)
{
    while (from < to) {
        Run run;
        Nanos start = from;
        // Up to an instant that all of them have.
        for (std::size_t i = 0, agreed = 0; agreed < m_channels.size();
             i = (i + 1) % m_channels.size()) {
            const FastColumn &column = *m_channels[i]->fast();
            const Index index = column.atOrAfter(start);
            if (index == column.end() || column.timeOf(index) >= to)
                return;
            agreed = column.timeOf(index) == start ? agreed + 1 : 1;
            start = column.timeOf(index);
        }
        run.count = std::numeric_limits<std::uint64_t>::max();
        Nanos stop = to;
        for (const Channel *channel : m_channels) {
            const FastColumn &column = *channel->fast();
            const Index first = column.atOrAfter(start);
            const Segment &segment = column.segments()[column.pieceOf(first)];
            run.first.push_back(first);
            run.count = std::min(run.count, segment.end() - first);
            stop = std::min(stop, segment.stop());
            if (to < segment.stop())
                run.count = std::min(run.count, segment.atOrAfter(to) - first);
        }
        from = std::max(stop, start + 1);
        addRun(start, std::move(run));
    }
}

void WavWriter::addRun(Nanos start, Run run)
{
    const bool gap = !m_runs.empty() && start > m_end;
    if (gap && m_gaps.size() < kMostCues)
        m_gaps.push_back({m_frames, start - m_end});
    const FastColumn &column = *m_channels.front()->fast();
    const Segment &segment = column.segments()[column.pieceOf(run.first.front())];
    m_end = segment.timeOf(run.first.front() + run.count);
    m_frames += run.count;
    m_runs.push_back(std::move(run));
}

bool WavWriter::next(std::string_view &bytes)
{
    m_piece.clear();
    const bool more = makePiece();
    bytes = m_piece;
    return more;
}

/// Appends to m_piece, which is empty.
bool WavWriter::makePiece()
{
    if (m_problem != ExportProblem::None || m_part == Part::Over)
        return false;
    if (m_part == Part::Head) {
        m_piece = head();
        m_part = Part::Frames;
        return true;
    }
    if (m_part == Part::Tail) {
        m_piece = cues() + comment();
        m_part = Part::Over;
        return true;
    }
    const std::size_t channelCount = m_channels.size();
    m_piece.reserve(kPieceFrames * 2 * channelCount);
    for (std::size_t room = kPieceFrames; room > 0 && m_run < m_runs.size();) {
        const Run &run = m_runs[m_run];
        std::size_t count =
            static_cast<std::size_t>(std::min<std::uint64_t>(room, run.count - m_inRun));
        std::vector<std::span<const std::int16_t>> codes;
        for (std::size_t i = 0; i < channelCount; ++i) {
            codes.push_back(m_channels[i]->fast()->codes(run.first[i] + m_inRun, count));
            count = std::min(count, codes.back().size());
        }
        for (std::size_t frame = 0; frame < count; ++frame) {
            for (const auto &channel : codes) {
                const auto code = static_cast<std::uint16_t>(channel[frame]);
                m_piece += static_cast<char>(code & 0xFF);
                m_piece += static_cast<char>(code >> 8);
            }
        }
        room -= count;
        m_written += count;
        m_inRun += count;
        if (m_inRun == run.count) {
            ++m_run;
            m_inRun = 0;
        }
    }
    if (m_run == m_runs.size())
        m_part = Part::Tail;
    return true;
}

double WavWriter::progress() const
{
    return m_frames == 0 ? 1.0 : static_cast<double>(m_written) / static_cast<double>(m_frames);
}

std::string WavWriter::head() const
{
    const auto frameBytes = static_cast<std::uint64_t>(2 * m_channels.size());
    const std::uint64_t dataBytes = m_frames * frameBytes;
    const std::string format = number(1, 2) + number(m_channels.size(), 2) + number(m_rate, 4)
        + number(m_rate * frameBytes, 4) + number(frameBytes, 2) + number(16, 2);
    const std::size_t tail = cues().size() + comment().size();
    return "RIFF" + number(4 + 8 + kFormatBytes + 8 + dataBytes + tail, 4) + "WAVE"
        + chunk("fmt ", format) + "data" + number(dataBytes, 4);
}

/// A point and a label for each gap.
std::string WavWriter::cues() const
{
    if (m_gaps.empty())
        return {};
    std::string points = number(m_gaps.size(), 4);
    std::string labels = "adtl";
    for (std::size_t i = 0; i < m_gaps.size(); ++i) {
        const std::string id = number(i + 1, 4);
        const std::string frame = number(m_gaps[i].frame, 4);
        points += id;
        points += frame;
        points += "data";
        points += number(0, 4);
        points += number(0, 4);
        points += frame;
        labels +=
            chunk("labl", id + "gap of " + decimalText(toSeconds(m_gaps[i].length)) + " s" + '\0');
    }
    return chunk("cue ", points) + chunk("LIST", labels);
}

std::string WavWriter::comment() const
{
    std::string words;
    for (const Channel *channel : m_channels) {
        const ChannelInfo &info = channel->info();
        if (!words.empty())
            words += "; ";
        words.append(info.name).append(" [").append(info.unit).append("] = (code + ");
        words.append(decimalText(info.offset)).append(") x ").append(decimalText(info.factor));
    }
    return chunk("LIST",
        "INFO" + chunk("ISFT", std::string("Rotorscope") + '\0') + chunk("ICMT", words + '\0'));
}

} // namespace capture
