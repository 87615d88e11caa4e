#include "widgets/scope/scope_ghosts.h"

#include "capture/capture.h"
#include "widgets/scope/plot_stack.h"

#include <utility>

namespace widgets {
namespace {

char markOf(Reference which) { return which == Reference::A ? 'A' : 'B'; }

} // namespace

ScopeGhosts::ScopeGhosts(
    capture::Capture &capture, PlotStack &stack, std::function<Zero()> zero, QObject *parent)
    : QObject(parent)
    , m_capture(capture)
    , m_stack(stack)
    , m_zero(std::move(zero))
{
}

void ScopeGhosts::setRecords(std::vector<Ghost> records)
{
    if (records.empty() && m_records.empty())
        return;
    m_records = std::move(records);
    if (m_records.size() > std::size_t(kMost))
        m_records.resize(std::size_t(kMost));
    Q_EMIT redrawWanted();
}

void ScopeGhosts::keep(Reference which)
{
    const std::vector<capture::ChannelId> shown = m_stack.channels();
    if (shown.empty())
        return;
    const Zero zero = m_zero();
    replace(which,
        {{m_capture.snapshot(shown), zero.seconds, kReferenceAlpha, markOf(which)}, zero.trigger,
            {}, 0});
}

void ScopeGhosts::lay(
    Reference which, capture::Snapshot kept, std::vector<Instant> instants, std::size_t first)
{
    const double seconds = instants[first].seconds;
    replace(which,
        {{std::move(kept), seconds, kReferenceAlpha, markOf(which)}, false, std::move(instants),
            first});
    Q_EMIT laid(which);
}

void ScopeGhosts::replace(Reference which, Kept kept)
{
    const auto index = static_cast<std::size_t>(which);
    m_replaced[index] = std::exchange(m_references[index], std::move(kept));
    Q_EMIT referencesChanged();
    if (m_replaced[index].ghost.kept)
        Q_EMIT replaced(which, false);
    Q_EMIT redrawWanted();
}

const Instant &ScopeGhosts::instant(Reference which) const
{
    return keptAs(which).instants[keptAs(which).instant];
}

void ScopeGhosts::nextInstant(Reference which, int by)
{
    Kept &kept = m_references[static_cast<std::size_t>(which)];
    const auto count = static_cast<int>(kept.instants.size());
    if (count == 0)
        return;
    kept.instant = static_cast<std::size_t>((static_cast<int>(kept.instant) + by + count) % count);
    kept.ghost.shift = kept.instants[kept.instant].seconds;
    Q_EMIT laid(which);
    Q_EMIT redrawWanted();
}

void ScopeGhosts::drop(Reference which)
{
    const auto index = static_cast<std::size_t>(which);
    m_references[index] = std::exchange(m_replaced[index], {});
    Q_EMIT referencesChanged();
    if (hasReference(which))
        Q_EMIT replaced(which, true);
    Q_EMIT redrawWanted();
}

void ScopeGhosts::place()
{
    std::vector<Ghost> all;
    const Zero zero = m_zero();
    for (const Kept &reference : m_references) {
        const bool suits = !reference.instants.empty() || reference.trigger == zero.trigger;
        if (!reference.ghost.kept || !suits)
            continue;
        all.push_back(reference.ghost);
        all.back().shift -= zero.seconds;
    }
    all.insert(all.end(), m_records.begin(), m_records.end());
    m_stack.setGhosts(std::move(all));
}

} // namespace widgets
