#include "lab/evaluation/load_evaluation.h"

#include "lab/evaluation/segments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lab {

namespace {

/// Means over blocks of one segment: rpm; A.
struct Blocks {
    double block_s = 0.0;
    std::vector<double> speed, reference, peak;
};

/// By Hall sensors over a whole electrical turn, whose edges are not equally far apart.
Blocks blocksOf(const Segment &segment, const Recorded<LoadPlan> &of)
{
    constexpr double kBlock_s = 4e-3, kMinute_s = 60.0, kTurn_deg = 360.0;
    const double turn_s = kMinute_s / (std::abs(of.plan.fromRpm) * of.polePairs);
    Blocks blocks;
    blocks.block_s = byHall(of.angle) ? turn_s * std::ceil(kBlock_s / turn_s) : kBlock_s;
    const auto length = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::lround(blocks.block_s / segment.step_s)));
    const auto count = static_cast<double>(length);
    blocks.block_s = count * segment.step_s;
    for (std::size_t end = length; end < segment.turned_deg.size(); end += length) {
        double sum = 0.0, most = 0.0;
        for (std::size_t i = end - length; i < end; ++i) {
            sum += segment.values[0][i];
            most = std::max(most, std::abs(segment.values[1][i]));
        }
        blocks.speed.push_back((segment.turned_deg[end] - segment.turned_deg[end - length])
            / (kTurn_deg * of.polePairs * blocks.block_s) * kMinute_s);
        blocks.reference.push_back(sum / count);
        blocks.peak.push_back(most);
    }
    return blocks;
}

struct Change {
    bool comes = true; ///< else it goes
    double load_a = 0.0, dip_rpm = 0.0, recovery_s = 0.0, peak_a = 0.0; ///< magnitudes
};

/// The speed that was held, and its noise, of all segments: one that lies in a change has its own middle.
struct Held {
    double rpm = 0.0, noise_rpm = 0.0;
    explicit Held(const std::vector<Blocks> &all)
    {
        constexpr double kDeviation = 1.4826; // of a normal spread, in median deviations
        std::vector<double> speeds;
        for (const Blocks &blocks : all)
            speeds.insert(speeds.end(), blocks.speed.begin(), blocks.speed.end());
        rpm = medianOf(speeds);
        for (double &speed : speeds)
            speed = std::abs(speed - rpm);
        noise_rpm = kDeviation * medianOf(speeds);
    }
};

/// Changes of the load in one segment.
class Changes {
public:
    Changes(const Blocks &blocks, const Held &held, bool forwards)
        : m_blocks(blocks)
        , m_held_rpm(held.rpm)
        , m_noise_rpm(held.noise_rpm)
        , m_hold(static_cast<std::size_t>(std::ceil(kHeld_s / blocks.block_s)))
        , m_forwards(forwards)
    {
        const double clear = std::max(kClear * m_noise_rpm, kLeastShare * std::abs(m_held_rpm));
        bool quiet = false; // since the last one, of which a tenth may be more than noise
        for (std::size_t at = m_hold; at < m_blocks.speed.size(); ++at) {
            const bool off = away(at) > clear;
            if (off && quiet)
                at = follow(at);
            quiet = !off;
        }
    }
    std::vector<Change> found;
    bool open = false; ///< one was not over where the segment ends
    bool brief = false; ///< one went before the speed was back: nothing tells how strong it was

private:
    static constexpr double kClear = 6.0, kLeastShare = 0.005, kLeft = 0.1, kQuiet = 3.0;
    static constexpr double kHeld_s = 0.05; ///< it stays so long; and the means before and behind
    static constexpr double kStays = 0.3; ///< of how far the reference went meanwhile, at the least

    double away(std::size_t at) const { return std::abs(m_blocks.speed[at] - m_held_rpm); }
    double meanReference(std::size_t from) const
    {
        double sum = 0.0;
        for (std::size_t at = from; at < from + m_hold; ++at)
            sum += m_blocks.reference[at];
        return sum / static_cast<double>(m_hold);
    }

    /// @return  the last block that belongs to it
    std::size_t follow(std::size_t seen)
    {
        const std::size_t end = m_blocks.speed.size();
        std::size_t from = seen;
        while (from > m_hold && away(from - 1) > m_noise_rpm)
            --from;
        Change change;
        change.comes = (m_blocks.speed[seen] < m_held_rpm) == m_forwards;
        const double before_a = meanReference(from - m_hold);
        double most_a = 0.0;
        std::size_t quiet = 0, over = seen;
        for (std::size_t at = seen; at < end; ++at) {
            change.dip_rpm = std::max(change.dip_rpm, away(at));
            change.peak_a = std::max(change.peak_a, m_blocks.peak[at]);
            most_a = std::max(most_a, std::abs(m_blocks.reference[at] - before_a));
            const bool left = away(at) > std::max(kLeft * change.dip_rpm, kQuiet * m_noise_rpm);
            quiet = left ? 0 : quiet + 1;
            over = left ? at + 1 : over;
            if (quiet < m_hold)
                continue;
            change.recovery_s = static_cast<double>(over - from) * m_blocks.block_s;
            change.load_a = std::abs(meanReference(over) - before_a);
            if (change.load_a >= kStays * most_a)
                found.push_back(change);
            else
                brief = true;
            return at;
        }
        open = true;
        return end;
    }

    const Blocks &m_blocks;
    double m_held_rpm, m_noise_rpm;
    std::size_t m_hold;
    bool m_forwards;
};

/// Of those that come and those that go alike.
std::optional<Estimate> meanOver(const std::vector<Change> &changes, double Change::*what)
{
    std::array<std::vector<double>, 2> values;
    for (const Change &change : changes)
        values[change.comes ? 0 : 1].push_back(change.*what);
    return meanOfBoth(values[0], values[1]);
}

Figures figuresFrom(const std::vector<Change> &changes, const Recorded<LoadPlan> &of)
{
    const auto load = meanOver(changes, &Change::load_a);
    double peak_a = 0.0;
    for (const Change &change : changes)
        peak_a = std::max(peak_a, change.peak_a);
    std::vector<double> yields;
    for (const Change &change : changes)
        if (change.load_a > 0.0)
            yields.push_back(change.dip_rpm / change.load_a);
    // An angle that stands aside, by an observer or an alignment against friction, makes less of an ampere.
    constexpr double kTorque = 0.03;
    const double kt = of.torquePerAmp;
    std::optional<Estimate> torque;
    if (load && kt > 0.0)
        torque = load->low && load->high
            ? withScale({load->value * kt, *load->low * kt, *load->high * kt}, kTorque)
            : Estimate{load->value * kt, {}, {}};
    return {{"load_a", "Load", "A", load}, {"load_nm", "Torque of the load", "N m", torque},
        {"dip_rpm", "The speed gives way by", "rpm", meanOver(changes, &Change::dip_rpm)},
        {"dip_rpm_per_a", "For each ampere by", "rpm/A", meanOf(yields)},
        {"recovery_s", "Back within", "s", meanOver(changes, &Change::recovery_s)},
        {"peak_iq_a", "Peak Iq", "A", Estimate{peak_a, {}, {}}}};
}

} // namespace

Result<LoadSteps, std::string> evaluateLoad(const capture::Capture &capture, const Happenings &all)
{
    const auto [of, after] = planIn<LoadPlan>(all);
    if (!of)
        return fail(std::string("it is no recording of a load that changes"));
    const auto span = drivenSpan(
        of->motor, after.begin(), after.end(), std::numeric_limits<Nanos>::max(), setsSpeedAtOnce);
    if (!span)
        return fail(std::string("the set-point was never moved in it"));
    const std::vector<Segment> segments =
        segmentsOf(capture, of->angle, {of->reference, of->current}, span->from, span->to);
    std::vector<Change> changes;
    bool open = false, brief = false;
    std::vector<Blocks> pieces;
    for (const Segment &segment : segments)
        if (Blocks blocks = blocksOf(segment, *of); !blocks.speed.empty())
            pieces.push_back(std::move(blocks));
    if (pieces.empty())
        return fail(std::string("it holds no samples of the signals that it needs"));
    const Held held(pieces);
    for (const Blocks &blocks : pieces) {
        const Changes inIt(blocks, held, of->plan.fromRpm > 0);
        changes.insert(changes.end(), inIt.found.begin(), inIt.found.end());
        open = open || inIt.open;
        brief = brief || inIt.brief;
    }
    if (changes.empty())
        return fail(std::string(open || brief
                ? "the load changed, and the speed did not come back before the end, or before it "
                  "went again"
                : "no load came or went while the speed was held: nothing "
                  "moved it out of its noise"));
    LoadSteps found{figuresFrom(changes, *of), {}};
    const auto came = std::ranges::count_if(changes, &Change::comes);
    found.notes.push_back("the load came " + std::to_string(came) + " times and went "
        + std::to_string(std::ssize(changes) - came) + " times");
    if (open)
        found.notes.emplace_back("a change of the load was not over at the end, or where samples "
                                 "are missing: it does not count");
    if (brief)
        found.notes.emplace_back(
            "a load came and went before the speed was back: it does not count");
    noteGaps(found.notes, missingIn(segments));
    noteEnd(found.notes, span->over, span->reason);
    return found;
}

} // namespace lab
