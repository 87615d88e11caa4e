#include "widgets/scope/scope_colors.h"

#include "widgets/base/trace_colors.h"
#include "widgets/scope/color_menu.h"
#include "widgets/scope/plot_stack.h"

#include <QWidget>

namespace widgets {

ScopeColors::ScopeColors(PlotStack &stack, const QWidget &view, QObject *parent)
    : QObject(parent)
    , m_stack(stack)
    , m_view(view)
{
}

QMap<QString, int> ScopeColors::chosen() const { return m_stack.chosenColors(); }

void ScopeColors::setChosen(const QMap<QString, int> &slotsByName)
{
    m_stack.setChosenColors(slotsByName);
}

void ScopeColors::choose(const QString &name, std::optional<int> slot)
{
    m_stack.setColor(name, slot);
    Q_EMIT changed();
}

void ScopeColors::fill(QMenu &menu, capture::ChannelId channel)
{
    if (const Trace *trace = m_stack.trace(channel))
        fill(menu, QString::fromStdString(trace->info.name));
}

void ScopeColors::fill(QMenu &menu, const QString &name)
{
    const auto &all = m_stack.chosenColors();
    const auto found = all.constFind(name);
    const auto now = found != all.constEnd() ? std::optional(*found) : std::nullopt;
    fillColorMenu(menu, now, isDark(m_view.palette()),
        [this, name](std::optional<int> slot) { choose(name, slot); });
}

} // namespace widgets
