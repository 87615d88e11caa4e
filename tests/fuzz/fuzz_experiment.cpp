// Any plan and any events of a recording, through what evaluates experiments. The first byte says how the recorded
// signals look; the rest is text: a line is an event, "MILLISECONDS name;key=value;key=value".
#include "fuzz/script.h"
#include "lab/evaluation/current_response_evaluation.h"
#include "lab/evaluation/current_step_evaluation.h"
#include "lab/evaluation/finding.h"
#include "lab/evaluation/tuning.h"
#include "recorded/restore.h"

#include <array>
#include <charconv>
#include <string_view>

namespace {

using capture::Nanos;

constexpr std::size_t kSamples = 9000;
constexpr std::array kSignals{
    "I_Q_REF", "I_Q_MEAS", "ENCODER_SPEED", "ENCODER_EL_ANGLE", "V_Q", "I_D_MEAS", "V_D"};

/// Bits 0 and 1: standing still, at a speed, to and fro, noise. Bit 2: samples are missing. Bits 3 and 4: the rate.
void fill(capture::Capture &capture, unsigned look)
{
    capture::StreamLayout layout;
    layout.id = 1;
    layout.tickHz = std::array{1000.0, 2000.0, 16000.0, 1.5}[look >> 3 & 3U];
    constexpr double kHalf = 32768.0, kDegrees = 180.0;
    for (const char *name : kSignals) {
        layout.fast.push_back({static_cast<catalog::RegisterId>(layout.fast.size() + 1), name, "",
            layout.fast.size() == 3 ? kDegrees / kHalf : 0.01});
    }
    capture.begin(layout);
    std::uint32_t random = 1;
    std::uint16_t angle = 0;
    std::array<std::vector<std::int16_t>, kSignals.size()> recorded;
    for (std::size_t i = 0; i < kSamples; ++i) {
        random = random * 1664525U + 1013904223U;
        const auto noise = static_cast<std::int16_t>(random >> 16);
        const auto wave = static_cast<std::int16_t>(i / 250 % 2 == 0 ? 900 : -300);
        const auto value = std::array<std::int16_t, 4>{0, 500, wave, noise}[look & 3U];
        angle = static_cast<std::uint16_t>(angle + (look & 3U) * 60U + value / 16);
        recorded[0].push_back(value);
        recorded[1].push_back(static_cast<std::int16_t>(value / 2 + i % 3));
        recorded[2].push_back(static_cast<std::int16_t>(value / 3 + i % 5));
        recorded[3].push_back(static_cast<std::int16_t>(angle));
        recorded[4].push_back(static_cast<std::int16_t>(value / 4 + 7));
        recorded[5].push_back(static_cast<std::int16_t>(i / 50 % 7 * 40));
        recorded[6].push_back(static_cast<std::int16_t>(value / 5 + i % 2));
    }
    constexpr std::size_t kBlock = 3000;
    for (std::size_t at = 0; at < kSamples; at += kBlock) {
        capture::SampleBlock block;
        block.stream = layout.id;
        block.lostTicks = (look & 4U) != 0 && at > 0 ? 5 : 0;
        block.firstTick = static_cast<capture::Tick>(at) + (at > 0 ? block.lostTicks * 2 : 0);
        block.count = kBlock;
        for (const auto &signal : recorded)
            block.fast.insert(block.fast.end(), signal.begin() + std::ptrdiff_t(at),
                signal.begin() + std::ptrdiff_t(at + kBlock));
        capture.append(block);
    }
}

std::string_view cut(std::string_view &text, char mark)
{
    const std::size_t end = std::min(text.find(mark), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

lab::Happenings happeningsOf(std::string_view text)
{
    lab::Happenings happenings;
    while (!text.empty()) {
        std::string_view line = cut(text, '\n');
        const std::string_view time = cut(line, ' ');
        std::int64_t ms = 0;
        std::from_chars(time.data(), time.data() + time.size(), ms);
        constexpr Nanos kNanos = 1'000'000, kMost = recorded::kFarthest / kNanos;
        recorded::Happening what{std::string(cut(line, ';')), {}};
        while (!line.empty()) {
            std::string_view field = cut(line, ';');
            const std::string_view key = cut(field, '=');
            what.fields.emplace_back(key, field);
        }
        happenings.emplace_back(std::clamp(ms, -kMost, kMost) * kNanos, std::move(what));
    }
    return happenings;
}

/// What is told of a number is around it.
void check(const std::optional<lab::Estimate> &estimate)
{
    if (estimate && estimate->low && estimate->high)
        fuzz::require(!(*estimate->low > *estimate->high));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size == 0)
        return 0;
    capture::Capture capture({.maxBytes = 10'000'000});
    fill(capture, data[0]);
    const lab::Happenings happenings =
        happeningsOf({reinterpret_cast<const char *>(data + 1), size - 1});
    std::size_t told = 0;
    for (const lab::Happenings &run : lab::runsIn(happenings)) {
        told += run.size();
        fuzz::require(!lab::nameOfRun(run).empty());
        (void)lab::findingIn(capture, run);
    }
    fuzz::require(told <= happenings.size());
    if (const auto steps = lab::stepSeries(capture, happenings)) {
        fuzz::require(steps->runs.size() <= happenings.size());
        for (const auto &mean :
            {steps->rise_s, steps->overshoot_pct, steps->settling_s, steps->peakIq_a})
            check(mean);
    }
    if (const auto steps = lab::currentSteps(capture, happenings)) {
        fuzz::require(steps->runs.size() <= happenings.size());
        for (const auto &mean :
            {steps->rise_s, steps->overshoot_pct, steps->settling_s, steps->peakIq_a})
            check(mean);
    }
    if (const auto found = lab::evaluateMechanics(capture, happenings)) {
        for (const auto &number :
            {found->inertia_kgm2, found->viscous_nms, found->dry_nm, found->fan_nms2})
            check(number);
        if (const auto &both = found->both)
            for (const auto &number : {both->forwards_kgm2, both->backwards_kgm2, both->always_nm})
                check(number);
    }
    if (const auto found = lab::evaluateElectrics(capture, happenings))
        for (const auto &number :
            {found->rs_ohm, found->deadTime_v, found->ld_h, found->lq_h, found->flux_wb})
            check(number);
    if (const auto found = lab::evaluateCurrentResponse(capture, happenings))
        for (const lab::ResponsePoint &point : found->points)
            fuzz::require(point.coherence >= 0.0 && point.coherence <= 1.0);
    if (const auto found = lab::evaluateResponse(capture, happenings)) {
        for (const lab::ResponsePoint &point : found->points)
            fuzz::require(point.coherence >= 0.0 && point.coherence <= 1.0);
        constexpr lab::GainDigits kDigits{1e-5, 1e-6};
        if (const auto proposed = lab::proposeGains(*found, kDigits, 5.0))
            for (const lab::GainCandidate &one : *proposed)
                fuzz::require(one.proportional > 0 && one.proportional <= kDigits.most
                    && one.integral > 0 && one.integral <= kDigits.most);
    }
    return 0;
}
