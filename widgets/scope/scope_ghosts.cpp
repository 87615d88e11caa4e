// The scope's trigger marks and the traces of other times behind its own: a reference, earlier records.
#include "widgets/base/device_text.h"
#include "widgets/scope/plot_stack.h"
#include "widgets/scope/scope_overlay.h"
#include "widgets/scope/scope_view.h"

namespace widgets {

namespace {
constexpr int kReferenceAlpha = 130; ///< of 255
}

QString ScopeView::nameOf(capture::ChannelId channel) const
{
    const auto info = m_capture.info(channel);
    return info ? deviceText(info->name) : QString();
}

void ScopeView::setTriggerMarks(const TriggerMarks &marks)
{
    if (marks == m_marks)
        return;
    m_marks = marks;
    m_overlay->setMarks(marks);
}

void ScopeView::setMeasureMarks(const MeasureMarks &marks) { m_overlay->setMeasure(marks); }

void ScopeView::setGhosts(std::vector<Ghost> ghosts)
{
    if (ghosts.empty() && m_ghosts.empty())
        return;
    m_ghosts = std::move(ghosts);
    if (m_ghosts.size() > std::size_t(kMostGhosts))
        m_ghosts.resize(std::size_t(kMostGhosts));
    redraw();
}

/// The time in the picture that a reference is laid upon.
double ScopeView::ghostZero() const { return m_marks.position.value_or(m_range.from); }

void ScopeView::keepReference(Reference which)
{
    const std::vector<capture::ChannelId> shown = m_stack->channels();
    if (shown.empty())
        return;
    const char mark = which == Reference::A ? 'A' : 'B';
    m_references[static_cast<std::size_t>(which)] = {
        m_capture.snapshot(shown), ghostZero(), kReferenceAlpha, mark};
    Q_EMIT referencesChanged();
    redraw();
}

void ScopeView::dropReference(Reference which)
{
    m_references[static_cast<std::size_t>(which)] = {};
    Q_EMIT referencesChanged();
    redraw();
}

void ScopeView::placeGhosts()
{
    std::vector<Ghost> all;
    for (const Ghost &reference : m_references) {
        if (!reference.kept)
            continue;
        all.push_back(reference);
        all.back().shift -= ghostZero();
    }
    all.insert(all.end(), m_ghosts.begin(), m_ghosts.end());
    m_stack->setGhosts(std::move(all));
}

} // namespace widgets
