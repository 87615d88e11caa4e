#include "recorded/overview.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace recorded {

namespace {

using capture::CodeRange;
using capture::Tick;

constexpr std::size_t kMostBins = 8192; ///< twice as many as a wide screen has columns
constexpr std::size_t kLeastBins = 256; ///< fewer are no picture
constexpr std::size_t kMostOverviews = 64;
constexpr std::size_t kHeadBytes = 4 + 4 + 8 + 8 + 4; ///< beside the layout and the bins
constexpr Tick kMostTicks = Tick{1} << 60; ///< from the first to the last
constexpr std::uint8_t kKind = 11;

void halve(Overview &overview)
{
    for (std::vector<CodeRange> &bins : overview.columns) {
        for (std::size_t i = 0; i < bins.size(); i += 2) {
            CodeRange both = bins[i];
            if (i + 1 < bins.size())
                both.include(bins[i + 1]);
            bins[i / 2] = both;
        }
        bins.resize((bins.size() + 1) / 2);
    }
    overview.binTicks *= 2;
}

std::size_t bytesOf(const Overview &overview)
{
    return overview.bins() * overview.columns.size() * sizeof(CodeRange);
}

} // namespace

Result<Bytes, PayloadError> encodeOverview(const Overview &overview)
{
    const auto layout = encodeEntry(overview.layout);
    if (!layout || layout->size() + kHeadBytes + bytesOf(overview) > kMostPayload)
        return fail(PayloadError::TooLong);
    ByteWriter out;
    out.text("RS").u8(kPayloadVersion).u8(kKind);
    out.u32(static_cast<std::uint32_t>(layout->size())).bytes(*layout);
    out.s64(overview.first).s64(overview.binTicks);
    out.u32(static_cast<std::uint32_t>(overview.bins()));
    for (const std::vector<CodeRange> &bins : overview.columns)
        for (const CodeRange &bin : bins)
            out.s16(bin.min).s16(bin.max);
    return out.take();
}

Result<Overview, PayloadError> decodeOverview(ByteView payload)
{
    ByteReader in(payload);
    const ByteView mark = in.take(2);
    if (mark.size() != 2 || mark[0] != 'R' || mark[1] != 'S' || in.u8() != kPayloadVersion)
        return fail(PayloadError::NotOurs);
    if (in.u8() != kKind)
        return fail(PayloadError::UnknownKind);
    const auto layout = decodeEntry(in.take(in.u32()));
    const auto *described = layout ? std::get_if<capture::StreamLayout>(&layout->entry) : nullptr;
    Overview overview;
    overview.first = in.s64();
    overview.binTicks = in.s64();
    const std::size_t bins = in.u32();
    const bool sane = in.ok() && described && bins > 0 && !described->fast.empty()
        && overview.binTicks > 0 && overview.binTicks % 2 == 0
        && isNear(*described, static_cast<double>(overview.first))
        && isNear(*described,
            static_cast<double>(overview.first)
                + static_cast<double>(overview.binTicks) * static_cast<double>(bins))
        && bins <= in.left() / sizeof(CodeRange) / described->fast.size();
    if (!sane)
        return fail(PayloadError::Malformed);
    overview.layout = *described;
    for (std::size_t s = 0; s < described->fast.size(); ++s) {
        std::vector<CodeRange> &signal = overview.columns.emplace_back(bins);
        for (CodeRange &bin : signal)
            bin = {in.s16(), in.s16()};
    }
    return overview;
}

void restore(const Overview &overview, capture::Capture &capture)
{
    capture::StreamLayout layout = overview.layout;
    layout.slow.clear();
    const Tick step = overview.binTicks / 2;
    if (step > std::numeric_limits<std::uint32_t>::max())
        return; // years
    layout.fastStep = static_cast<std::uint32_t>(step);
    for (capture::StreamSignal &signal : layout.fast)
        signal.name += " (overview)";
    capture.begin(layout);
    for (std::size_t from = 0; from < overview.bins();) {
        const auto empty = [&](std::size_t bin) { return overview.columns.front()[bin].empty(); };
        std::size_t to = from;
        while (to < overview.bins() && !empty(to))
            ++to;
        if (to > from) {
            capture::SampleBlock block{layout.id,
                overview.first + static_cast<Tick>(from) * overview.binTicks,
                static_cast<std::uint32_t>(2 * (to - from)), {}, {}, 0};
            for (const std::vector<CodeRange> &bins : overview.columns)
                for (std::size_t bin = from; bin < to; ++bin)
                    block.fast.insert(block.fast.end(), {bins[bin].min, bins[bin].max});
            capture.append(block);
        }
        from = to + 1;
    }
    capture.begin({});
}

void OverviewMaker::begin(const capture::StreamLayout &layout)
{
    if (!m_all.empty() && m_all.back().bins() == 0)
        m_all.pop_back(); // nothing came
    m_tooMany = m_tooMany || m_all.size() == kMostOverviews;
    if (m_tooMany || layout.fast.empty())
        return;
    Overview overview;
    overview.layout = layout;
    overview.binTicks = 2 * Tick{std::max<std::uint32_t>(layout.fastStep, 1)};
    overview.columns.resize(layout.fast.size());
    m_all.push_back(std::move(overview));
}

void OverviewMaker::add(const capture::SampleBlock &block)
{
    if (m_tooMany || m_all.empty() || block.count == 0)
        return;
    Overview &overview = m_all.back();
    const Tick step = overview.layout.fastStep;
    if (block.stream != overview.layout.id
        || block.fast.size() != block.count * overview.columns.size())
        return;
    if (overview.bins() == 0)
        overview.first = block.firstTick;
    const Tick begin = block.firstTick - overview.first;
    const Tick end = begin + Tick{block.count} * step;
    if (block.firstTick < overview.first || end > kMostTicks)
        return; // its clock does not run on: no part of this picture
    while ((end - 1) / overview.binTicks >= Tick{kMostBins})
        halve(overview);
    const auto bins = static_cast<std::size_t>((end - 1) / overview.binTicks) + 1;
    for (std::size_t s = 0; s < overview.columns.size(); ++s) {
        std::vector<CodeRange> &signal = overview.columns[s];
        signal.resize(std::max(signal.size(), bins), CodeRange::nothing());
        const std::int16_t *codes = block.fast.data() + s * block.count;
        for (Tick i = 0; i < Tick{block.count};) {
            const Tick bin = (begin + i * step) / overview.binTicks;
            const Tick next = ((bin + 1) * overview.binTicks - begin + step - 1) / step;
            const Tick to = std::min(next, Tick{block.count});
            signal[static_cast<std::size_t>(bin)].include(
                capture::extremesOf(codes + i, static_cast<std::size_t>(to - i)));
            i = to;
        }
    }
}

std::vector<Overview> OverviewMaker::take(std::size_t mostBytes)
{
    begin({}); // one without samples goes
    std::vector<Overview> all = std::exchange(m_all, {});
    if (m_tooMany)
        return {};
    std::size_t sum = 0;
    for (Overview &overview : all) {
        constexpr std::size_t kRoom = kMostPayload * 3 / 4; // the rest is for names
        while (bytesOf(overview) > kRoom)
            halve(overview);
        sum += bytesOf(overview);
    }
    while (sum > mostBytes) {
        const auto largest = std::ranges::max_element(
            all, [](const Overview &a, const Overview &b) { return bytesOf(a) < bytesOf(b); });
        if (largest->bins() < 2 * kLeastBins)
            return {};
        sum -= bytesOf(*largest);
        halve(*largest);
        sum += bytesOf(*largest);
    }
    return all;
}

} // namespace recorded
