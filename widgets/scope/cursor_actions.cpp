#include "widgets/scope/cursor_actions.h"

#include "capture/capture.h"
#include "widgets/scope/events/log.h"
#include "widgets/scope/mouse.h"
#include "widgets/scope/plot_stack.h"
#include "widgets/scope/time_window.h"

#include <algorithm>
#include <utility>

namespace widgets {
namespace {

constexpr double kShareA = 0.3; ///< of the picture's width, where cursors appear
constexpr double kShareB = 0.7;

} // namespace

CursorActions::CursorActions(Parts parts, QObject *parent)
    : QObject(parent)
    , m_parts(std::move(parts))
{
}

void CursorActions::place(CursorEnd end, double share)
{
    const TimeWindow::Range seen = m_parts.time.range();
    m_parts.cursors.move(end, seen.from + share * seen.span());
}

/// Where the mouse is on the plots; empty if it is not.
std::optional<double> CursorActions::timeUnderMouse() const
{
    const auto at = m_parts.mouse.position();
    return at ? std::optional(m_parts.time.timeAt(at->x())) : std::nullopt;
}

void CursorActions::toggle()
{
    if (m_parts.cursors.visible()) {
        m_parts.mouse.attach({});
        m_parts.cursors.setVisible(false);
        return;
    }
    // A pair that was put somewhere stays there as long as one end of it can be seen.
    const CursorPair pair = m_parts.cursors.pair();
    const TimeWindow::Range seen = m_parts.time.range();
    if (pair.a == pair.b || (!seen.has(pair.a) && !seen.has(pair.b))) {
        place(CursorEnd::A, kShareA);
        place(CursorEnd::B, kShareB);
    }
    m_parts.cursors.setVisible(true);
}

void CursorActions::accept(CursorEnd end)
{
    if (!m_parts.cursors.visible())
        toggle();
    if (m_parts.mouse.attached() == end) {
        m_parts.mouse.attach({});
        return;
    }
    m_parts.cursors.setActive(end);
    if (const auto time = timeUnderMouse()) {
        m_parts.cursors.move(end, *time);
        m_parts.mouse.attach(end);
    } else if (!m_parts.time.range().has(m_parts.cursors.pair().at(end))) {
        place(end, end == CursorEnd::A ? kShareA : kShareB);
    }
}

/// The selected trace, or the one with the most samples a second that comes first.
const capture::Channel *CursorActions::nudged() const
{
    if (const auto selected = m_parts.stack.selected())
        return m_parts.capture.channel(*selected);
    const capture::Channel *best = nullptr;
    for (const capture::ChannelId id : m_parts.stack.channels()) {
        const capture::Channel *channel = m_parts.capture.channel(id);
        if (channel && !channel->empty() && (!best || channel->info().kind < best->info().kind))
            best = channel;
    }
    return best;
}

void CursorActions::nudge(int samples)
{
    const auto end = m_parts.cursors.active();
    if (!end || samples == 0)
        return;
    const double now = m_parts.cursors.pair().at(*end);
    const capture::Channel *channel = nudged();
    if (!channel || channel->empty()) {
        const int width = m_parts.stack.plot(0).rect->parentPlot()->width();
        const double pixel = m_parts.time.range().span() / std::max(1, width);
        m_parts.cursors.move(*end, now + samples * pixel);
        return;
    }
    // The sample that holds at the cursor, or the next one where none does: "one later" is the one after it.
    const capture::Nanos time = capture::toNanos(now);
    auto index = static_cast<std::int64_t>(channel->atOrAfter(time));
    const bool onSample = index < static_cast<std::int64_t>(channel->end())
        && channel->timeOf(capture::Index(index)) == time;
    index += samples > 0 && !onSample ? samples - 1 : samples;
    const auto first = static_cast<std::int64_t>(channel->begin());
    const auto last = static_cast<std::int64_t>(channel->end()) - 1;
    index = std::clamp(index, first, last);
    m_parts.cursors.move(*end, capture::toSeconds(channel->timeOf(capture::Index(index))));
    m_parts.show(m_parts.cursors.pair().at(*end));
}

void CursorActions::setMarker()
{
    const auto active = m_parts.cursors.active();
    const auto newest = m_parts.stack.newestSample();
    const TimeWindow::Range seen = m_parts.time.range();
    if (const auto time = timeUnderMouse())
        setMarkerAt(*time);
    else if (active)
        setMarkerAt(m_parts.cursors.pair().at(*active));
    else
        setMarkerAt(newest && seen.has(*newest) ? *newest : seen.from + seen.span() / 2);
}

/// Not where there is one already: a recording has one for a time.
void CursorActions::setMarkerAt(double seconds)
{
    const auto there = [at = capture::toNanos(seconds)](const ScopeEvent &event) {
        return event.kind == EventKind::Marker && capture::toNanos(event.seconds) == at;
    };
    const auto &events = m_parts.events.events();
    if (std::any_of(events.begin(), events.end(), there))
        return;
    m_parts.events.add(EventKind::Marker, seconds, m_parts.events.freeMarkerName());
}

} // namespace widgets
