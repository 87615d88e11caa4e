#include "widgets/measuring/math_traces.h"

#include "widgets/scope/view.h"

#include <algorithm>

namespace widgets {

MathTraces::MathTraces(
    MathChannels &channels, const capture::Capture &capture, ScopeView &scope, QObject *parent)
    : QObject(parent)
    , m_channels(channels)
    , m_capture(capture)
    , m_scope(scope)
{
    connect(&channels, &MathChannels::made, this, &MathTraces::made);
    connect(&channels, &MathChannels::goes, &scope, &ScopeView::removeChannel);
    connect(&channels, &MathChannels::changed, this, &MathTraces::follow);
    connect(&channels, &MathChannels::advanced, &scope, &ScopeView::redraw);
    connect(&scope, &ScopeView::drawn, this, &MathTraces::remember);
    connect(&scope, &ScopeView::removeRequested, this, &MathTraces::takenOff);
}

QColor MathTraces::colorOf(const ScopeView &scope, capture::ChannelId channel)
{
    return scope.plotOf(channel) >= 0 ? scope.colorOf(channel) : QColor();
}

/// Plots move up when one above them goes.
void MathTraces::remember()
{
    for (const MathChannels::Entry &entry : m_channels.entries())
        if (const int plot = m_scope.plotOf(entry.channel); plot >= 0)
            m_places[entry.formula.name].plot = plot;
}

void MathTraces::made(const QString &name, quint32 before)
{
    const auto entries = m_channels.entries();
    const auto entry = std::find_if(entries.begin(), entries.end(),
        [&name](const MathChannels::Entry &one) { return one.formula.name == name; });
    Place &place = m_places[name];
    if (const int plot = m_scope.plotOf(before); plot >= 0)
        place.plot = entry->unit == place.unit ? plot : -1;
    place.unit = entry->unit;
    if (entry->formula.shown)
        show(*entry); // before the other goes, and perhaps its plot with it
    m_scope.removeChannel(before);
    remember();
}

void MathTraces::show(const MathChannels::Entry &entry)
{
    int &plot = m_places[entry.formula.name].plot;
    const bool known = plot >= 0 && plot < m_scope.plotCount();
    m_scope.addChannel(entry.channel, known ? plot : plotForUnit(m_scope, m_capture, entry.unit));
    plot = m_scope.plotOf(entry.channel);
}

void MathTraces::follow()
{
    const auto entries = m_channels.entries();
    for (const MathChannels::Entry &entry : entries) {
        const bool drawn = m_scope.plotOf(entry.channel) >= 0;
        if (entry.channel != 0 && entry.formula.shown && !drawn)
            show(entry);
        else if (drawn && !entry.formula.shown)
            m_scope.removeChannel(entry.channel);
    }
    m_places.removeIf([&entries](const auto &place) {
        return std::none_of(entries.begin(), entries.end(),
            [&place](const auto &entry) { return entry.formula.name == place.key(); });
    });
}

/// Off the picture is not out of the world: it may be another's input.
void MathTraces::takenOff(quint32 channel)
{
    for (const MathChannels::Entry &entry : m_channels.entries())
        if (entry.channel == channel && channel != 0)
            m_channels.setShown(entry.formula.name, false);
}

} // namespace widgets
