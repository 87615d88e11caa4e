#include "lab/segments.h"

#include "scope/sample_range.h"

#include <cmath>

namespace lab {

std::vector<Segment> segmentsOf(const capture::Channel &angle,
    std::span<const capture::Channel *const> others, capture::Nanos from, capture::Nanos to)
{
    const scope::SampleRange turns(angle, from, to);
    std::vector<std::vector<double>> all;
    for (const capture::Channel *channel : others) {
        const scope::SampleRange range(*channel, from, to);
        if (range.end() - range.begin() != turns.end() - turns.begin())
            return {};
        range.visit([&values = all.emplace_back()](
                        double, double value, bool) { values.push_back(value); });
    }
    std::vector<Segment> segments;
    Segment now;
    double before = 0.0, first_s = 0.0, last_s = 0.0;
    const auto finish = [&] {
        constexpr std::size_t kLeast = 3;
        if (now.turned_deg.size() >= kLeast) {
            now.step_s = (last_s - first_s) / static_cast<double>(now.turned_deg.size() - 1);
            segments.push_back(std::move(now));
        }
        now = {};
        now.values.resize(others.size());
    };
    finish();
    std::size_t at = 0;
    turns.visit([&](double seconds, double value, bool joined) {
        if (!joined)
            finish();
        if (now.turned_deg.empty()) {
            first_s = seconds;
            now.first_deg = value;
            now.at = turns.toNanos(seconds);
        }
        constexpr double kTurn_deg = 360.0;
        now.turned_deg.push_back(now.turned_deg.empty()
                ? 0.0
                : now.turned_deg.back() + std::remainder(value - before, kTurn_deg));
        for (std::size_t i = 0; i < all.size(); ++i)
            now.values[i].push_back(all[i][at]);
        before = value;
        last_s = seconds;
        ++at;
    });
    finish();
    return segments;
}

} // namespace lab
