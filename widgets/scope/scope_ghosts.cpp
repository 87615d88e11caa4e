#include "widgets/scope/scope_ghosts.h"

#include "capture/capture.h"
#include "widgets/scope/plot_stack.h"

#include <utility>

namespace widgets {
namespace {

constexpr int kReferenceAlpha = 130; ///< of 255

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
    const char mark = which == Reference::A ? 'A' : 'B';
    const auto index = static_cast<std::size_t>(which);
    const Zero zero = m_zero();
    m_replaced[index] = std::exchange(m_references[index],
        {{m_capture.snapshot(shown), zero.seconds, kReferenceAlpha, mark}, zero.trigger});
    Q_EMIT referencesChanged();
    Q_EMIT redrawWanted();
}

void ScopeGhosts::drop(Reference which)
{
    const auto index = static_cast<std::size_t>(which);
    m_references[index] = std::exchange(m_replaced[index], {});
    Q_EMIT referencesChanged();
    Q_EMIT redrawWanted();
}

void ScopeGhosts::place()
{
    std::vector<Ghost> all;
    const Zero zero = m_zero();
    for (const Kept &reference : m_references) {
        if (!reference.ghost.kept || reference.trigger != zero.trigger)
            continue;
        all.push_back(reference.ghost);
        all.back().shift -= zero.seconds;
    }
    all.insert(all.end(), m_records.begin(), m_records.end());
    m_stack.setGhosts(std::move(all));
}

} // namespace widgets
