#include "widgets/scope/scope_ghosts.h"

#include "capture/capture.h"
#include "widgets/scope/plot_stack.h"

#include <utility>

namespace widgets {
namespace {

constexpr int kReferenceAlpha = 130; ///< of 255

} // namespace

ScopeGhosts::ScopeGhosts(
    capture::Capture &capture, PlotStack &stack, std::function<double()> zero, QObject *parent)
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
    m_references[static_cast<std::size_t>(which)] = {
        m_capture.snapshot(shown), m_zero(), kReferenceAlpha, mark};
    Q_EMIT referencesChanged();
    Q_EMIT redrawWanted();
}

void ScopeGhosts::drop(Reference which)
{
    m_references[static_cast<std::size_t>(which)] = {};
    Q_EMIT referencesChanged();
    Q_EMIT redrawWanted();
}

void ScopeGhosts::place()
{
    std::vector<Ghost> all;
    for (const Ghost &reference : m_references) {
        if (!reference.kept)
            continue;
        all.push_back(reference);
        all.back().shift -= m_zero();
    }
    all.insert(all.end(), m_records.begin(), m_records.end());
    m_stack.setGhosts(std::move(all));
}

} // namespace widgets
