#include "widgets/scope/signals/set_point_trace.h"

#include "widgets/scope/view.h"

#include <algorithm>
#include <numbers>

namespace widgets {
namespace {

constexpr double kStep_s = 1e-3; ///< of a ramp
constexpr double kHeld_s = 5e-3; ///< a value that stays: longer ones would get a dot each
constexpr double kLeast_s = 1e-6; ///< shorter pieces are none
constexpr std::uint64_t kMostValues = 2'000'000;
/// Behind what is computed by formulas.
constexpr catalog::RegisterId kFirst = capture::kFirstOwnRegister + 0x10000;
constexpr double kDegreesPerRad = 180.0 / std::numbers::pi;

struct Sort {
    const char *name;
    const char *unit;
    double scale; ///< of what was sent
};

const Sort &sortOf(drive::SentSetPoint::Kind kind)
{
    static constexpr Sort kSorts[] = {{"SPEED_SENT", "rpm", 1.0}, {"IQ_SENT", "A", 1.0},
        {"SHAFT_SENT", "\u00b0", kDegreesPerRad}};
    return kSorts[static_cast<std::size_t>(kind)];
}

} // namespace

std::optional<double> SetPointTrace::Way::at(double seconds) const
{
    if (!to || !(seconds < begin_s + ramp_s - kLeast_s))
        return to;
    if (!from)
        return std::nullopt;
    return *from + (*to - *from) * std::clamp((seconds - begin_s) / ramp_s, 0.0, 1.0);
}

SetPointTrace::SetPointTrace(capture::Capture &capture, ScopeView &scope, QObject *parent)
    : QObject(parent)
    , m_capture(capture)
    , m_scope(scope)
{
    connect(&scope, &ScopeView::removeRequested, this, &SetPointTrace::takenOff);
}

void SetPointTrace::accept(const drive::SentSetPoint &sent)
{
    m_ahead_s = sent.ahead_s;
    // An answer may come behind the stop that overtook it.
    for (const int motor : {0, sent.motor})
        if (const auto over = m_ended.find(motor);
            over != m_ended.end() && sent.seconds <= over->second)
            return;
    for (auto &[key, drawn] : m_drawn) // one thing at a time is followed
        if (key.second == sent.motor && key.first != sent.kind)
            stay(drawn, sent.seconds, {});
    const Key key{sent.kind, sent.motor};
    const double value = sent.value * sortOf(sent.kind).scale;
    const double ramp_s = sent.runs ? std::chrono::duration<double>(sent.ramp).count() : 0.0;
    const auto known = m_drawn.find(key);
    if (!sent.sure) {
        if (known != m_drawn.end())
            stay(known->second, sent.seconds, {});
        return;
    }
    if (known == m_drawn.end()) { // from where it comes is not known
        m_drawn[key] = {0, sent.seconds, {{}, value, sent.seconds, ramp_s, sent.runs}, {}};
        return;
    }
    Drawn &drawn = known->second;
    const Way &last = drawn.last();
    const double begin = std::max({sent.seconds, drawn.until_s, last.begin_s});
    drawn.next.push_back(
        {last.runs ? last.at(begin) : std::nullopt, value, begin, ramp_s, sent.runs});
}

void SetPointTrace::finish(const drive::SetPointsEnd &end)
{
    if (!end.held)
        m_ended[end.motor] = std::max(m_ended[end.motor], end.seconds);
    for (auto &[key, drawn] : m_drawn) {
        if (end.motor != 0 && end.motor != key.second)
            continue;
        if (!end.held)
            stay(drawn, end.seconds, {});
        else if (drawn.last().runs) // else there is no ramp
            stay(drawn, end.seconds, drawn.last().at(end.seconds));
    }
}

/// Of what was known of later is nothing left: it is told now, and holds.
void SetPointTrace::stay(Drawn &drawn, double from_s, std::optional<double> value)
{
    const double begin = std::max(from_s, drawn.until_s);
    std::erase_if(drawn.next, [begin](const Way &way) { return way.begin_s >= begin; });
    drawn.next.push_back({value, value, begin, 0.0, true});
}

void SetPointTrace::advance(double now)
{
    for (auto &[key, drawn] : m_drawn)
        draw(key, drawn, now + m_ahead_s - kBehind_s);
}

void SetPointTrace::draw(const Key &key, Drawn &drawn, double until_s)
{
    if (!(until_s > drawn.until_s))
        return;
    if (!m_capture.channel(drawn.channel)) // also where all was cleared
        makeChannel(key, drawn);
    while (!drawn.next.empty() && drawn.next.front().begin_s <= until_s) {
        follow(drawn, drawn.next.front().begin_s);
        drawn.now = drawn.next.front();
        drawn.next.erase(drawn.next.begin());
    }
    follow(drawn, until_s);
    m_capture.keepNewest(drawn.channel, kMostValues);
    if (m_shown && m_scope.plotOf(drawn.channel) < 0)
        m_scope.addChannel(drawn.channel,
            plotForUnit(m_scope, m_capture, QString::fromUtf8(sortOf(key.first).unit)));
}

/// One value each step up to there; none where none is known.
void SetPointTrace::follow(Drawn &drawn, double until_s)
{
    while (until_s - drawn.until_s > kLeast_s) {
        const double end = drawn.now.begin_s + drawn.now.ramp_s;
        const bool ramps = end - drawn.until_s > kLeast_s;
        const double last = ramps ? std::min(end, until_s) : until_s;
        const std::optional<double> value = drawn.now.at(drawn.until_s);
        if (!value) {
            m_capture.breakImported(drawn.channel);
            drawn.until_s = last;
            continue;
        }
        const double next = std::min(drawn.until_s + (ramps ? kStep_s : kHeld_s), last);
        m_capture.appendImported(
            drawn.channel, capture::toNanos(drawn.until_s), *value, capture::toNanos(next));
        drawn.until_s = next;
    }
}

void SetPointTrace::makeChannel(const Key &key, Drawn &drawn)
{
    const Sort &sort = sortOf(key.first);
    const bool several = key.second > 1;
    drawn.channel = m_capture.addImported(
        sort.name + (several ? "@" + std::to_string(key.second) : std::string()), sort.unit,
        kFirst + 8 * static_cast<catalog::RegisterId>(key.first)
            + static_cast<catalog::RegisterId>(key.second));
}

void SetPointTrace::end()
{
    for (auto &[key, drawn] : m_drawn)
        if (m_capture.channel(drawn.channel))
            m_capture.breakImported(drawn.channel);
    m_drawn.clear();
    m_ended.clear();
    m_ahead_s = 0.0;
}

void SetPointTrace::setShown(bool shown)
{
    if (std::exchange(m_shown, shown) == shown)
        return;
    for (auto &[key, drawn] : m_drawn)
        if (!shown && m_scope.plotOf(drawn.channel) >= 0)
            m_scope.removeChannel(drawn.channel);
    Q_EMIT shownChanged(shown);
}

void SetPointTrace::takenOff(quint32 channel)
{
    for (const auto &[key, drawn] : m_drawn)
        if (drawn.channel == channel)
            return setShown(false);
}

} // namespace widgets
