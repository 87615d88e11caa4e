#include "widgets/scope/ghosts.h"

#include "capture/capture.h"
#include "widgets/scope/plot_stack.h"

#include <algorithm>
#include <utility>

namespace widgets {
namespace {

char markOf(Reference which) { return which == Reference::A ? 'A' : 'B'; }

capture::TimeSpan aroundZero(const ScopeGhosts::Zero &zero)
{
    return {zero.picture.from - zero.seconds, zero.picture.to - zero.seconds};
}

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
            {}, 0, aroundZero(zero)});
}

void ScopeGhosts::lay(
    Reference which, capture::Snapshot kept, std::vector<Instant> instants, std::size_t first)
{
    const double seconds = instants[first].seconds;
    replace(which,
        {{std::move(kept), seconds, kReferenceAlpha, markOf(which)}, false, std::move(instants),
            first, aroundZero(m_zero())});
    Q_EMIT laid(which);
}

std::vector<KeptReference> ScopeGhosts::forWorkspace() const
{
    std::vector<KeptReference> references;
    std::size_t room = kMostReferenceSamples;
    for (const Reference which : {Reference::A, Reference::B}) {
        if (!hasReference(which))
            continue;
        const Kept &kept = keptAs(which);
        const double zero = kept.ghost.shift;
        std::vector<KeptTrace> traces = keptTraces(
            kept.ghost.kept, {zero + kept.picture.from, zero + kept.picture.to}, zero, room);
        for (const KeptTrace &trace : traces)
            room -= trace.count;
        if (!traces.empty())
            references.push_back({which, kept.trigger,
                isFromFile(which) ? instant(which).text : QString(), std::move(traces)});
    }
    return references;
}

void ScopeGhosts::adoptFromWorkspace(const std::vector<KeptReference> &references)
{
    for (const KeptReference &one : references) {
        capture::Snapshot kept = snapshotOf(one.traces);
        if (kept->empty())
            continue;
        capture::TimeSpan picture{0.0, 0.0};
        for (const capture::Channel &channel : *kept)
            if (const auto span = channel.timeSpan())
                picture = {std::min(picture.from, span->from), std::max(picture.to, span->to)};
        std::vector<Instant> instants;
        if (!one.moment.isEmpty())
            instants.push_back({0.0, one.moment});
        replace(one.which,
            {{std::move(kept), 0.0, kReferenceAlpha, markOf(one.which)}, one.trigger,
                std::move(instants), 0, picture});
    }
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
