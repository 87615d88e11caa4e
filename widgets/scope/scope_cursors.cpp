// What the scope does with its cursors and markers: brings them into view, hands them to the mouse, moves them sample by
// sample, sets them.
#include "widgets/scope/plot_stack.h"
#include "widgets/scope/scope_mouse.h"
#include "widgets/scope/scope_view.h"

#include <algorithm>

namespace widgets {

namespace {
constexpr double kShareA = 0.3; ///< of the picture's width, where cursors appear
constexpr double kShareB = 0.7;
} // namespace

bool ScopeView::inView(double seconds) const
{
    return seconds >= m_range.from && seconds <= m_range.to;
}

void ScopeView::placeInView(CursorEnd end, double share)
{
    m_cursors.move(end, m_range.from + share * (m_range.to - m_range.from));
}

void ScopeView::toggleCursors()
{
    if (m_cursors.visible()) {
        m_mouse->attach({});
        m_cursors.setVisible(false);
        return;
    }
    // A pair that was put somewhere stays there as long as one end of it can be seen.
    const CursorPair pair = m_cursors.pair();
    if (pair.a == pair.b || (!inView(pair.a) && !inView(pair.b))) {
        placeInView(CursorEnd::A, kShareA);
        placeInView(CursorEnd::B, kShareB);
    }
    m_cursors.setVisible(true);
}

void ScopeView::takeCursor(CursorEnd end)
{
    if (!m_cursors.visible())
        toggleCursors();
    if (m_mouse->attached() == end) {
        m_mouse->attach({});
        return;
    }
    m_cursors.setActive(end);
    if (const auto time = timeUnderMouse()) {
        m_cursors.move(end, *time);
        m_mouse->attach(end);
    } else if (!inView(m_cursors.pair().at(end))) {
        placeInView(end, end == CursorEnd::A ? kShareA : kShareB);
    }
}

/// The selected trace, or the one with the most samples a second that comes first.
const capture::Channel *ScopeView::nudgeChannel() const
{
    if (const auto selected = m_stack->selected())
        return m_capture.channel(*selected);
    const capture::Channel *best = nullptr;
    for (const capture::ChannelId id : m_stack->channels()) {
        const capture::Channel *channel = m_capture.channel(id);
        if (channel && !channel->empty() && (!best || channel->info().kind < best->info().kind))
            best = channel;
    }
    return best;
}

void ScopeView::nudgeCursor(int samples)
{
    const auto end = m_cursors.active();
    if (!end || samples == 0)
        return;
    const double now = m_cursors.pair().at(*end);
    const capture::Channel *channel = nudgeChannel();
    if (!channel || channel->empty()) {
        const double pixel = (m_range.to - m_range.from) / std::max(1, m_plot->width());
        m_cursors.move(*end, now + samples * pixel);
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
    m_cursors.move(*end, capture::toSeconds(channel->timeOf(capture::Index(index))));
    showTime(m_cursors.pair().at(*end));
}

void ScopeView::showTime(double seconds)
{
    if (inView(seconds) || (m_running && m_following))
        return;
    const double span = m_range.to - m_range.from;
    const double from = seconds < m_range.from ? seconds - span * 0.1 : seconds - span * 0.9;
    setVisibleRange(from, from + span);
}

void ScopeView::centerOn(double seconds)
{
    const double half = (m_range.to - m_range.from) / 2;
    setVisibleRange(seconds - half, seconds + half);
}

void ScopeView::setMarker()
{
    const auto active = m_cursors.active();
    const auto newest = m_stack->newestSample();
    const double middle = m_range.from + (m_range.to - m_range.from) / 2;
    if (const auto time = timeUnderMouse())
        setMarkerAt(*time);
    else if (active)
        setMarkerAt(m_cursors.pair().at(*active));
    else
        setMarkerAt(newest && inView(*newest) ? *newest : middle);
}

/// Not where there is one already: a recording has one for a time.
void ScopeView::setMarkerAt(double seconds)
{
    const auto there = [at = capture::toNanos(seconds)](const ScopeEvent &event) {
        return event.kind == EventKind::Marker && capture::toNanos(event.seconds) == at;
    };
    const auto &events = m_events.events();
    if (std::any_of(events.begin(), events.end(), there))
        return;
    m_events.add(EventKind::Marker, seconds, m_events.freeMarkerName());
}

} // namespace widgets
