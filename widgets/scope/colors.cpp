#include "widgets/scope/colors.h"

#include "widgets/base/trace_colors.h"
#include "widgets/scope/plot_stack.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <QPixmap>
#include <QWidget>

#include <functional>

namespace widgets {

namespace {

constexpr int kMenuSwatch = 14; ///< pixels

struct Colors {
    Q_DECLARE_TR_FUNCTIONS(Colors)
};

QIcon swatch(const QColor &color)
{
    QPixmap square(kMenuSwatch, kMenuSwatch);
    square.fill(color);
    return square;
}

/// In the order of the slots.
QStringList colorNames()
{
    return {Colors::tr("Blue"), Colors::tr("Vermilion"), Colors::tr("Green"), Colors::tr("Purple"),
        Colors::tr("Orange"), Colors::tr("Sky blue"), Colors::tr("Yellow"), Colors::tr("Ink")};
}

/// A swatch a colour, and its name beside it, for a user who sees fewer colours cannot tell the swatches apart.
/// @param chosen  slot of trace_colors.h that the user gave it; empty: given by itself
/// @param choose  told the new one; empty: by itself again
void fillColorMenu(QMenu &menu, std::optional<int> chosen, bool dark,
    const std::function<void(std::optional<int>)> &choose)
{
    auto *group = new QActionGroup(&menu);
    const auto add = [&](const QString &text, std::optional<int> slot) {
        QAction *entry = menu.addAction(text);
        entry->setCheckable(true);
        entry->setChecked(slot == chosen);
        group->addAction(entry);
        QObject::connect(entry, &QAction::triggered, &menu, [choose, slot] { choose(slot); });
        return entry;
    };
    const QStringList names = colorNames();
    for (int slot = 0; slot < kTraceColors; ++slot) {
        QAction *entry =
            add(QStringLiteral("&%1 %2").arg(QString::number(slot + 1), names[slot]), slot);
        entry->setIcon(swatch(traceColor(slot, dark)));
        entry->setIconVisibleInMenu(true);
    }
    menu.addSeparator();
    add(Colors::tr("&Automatic", "a colour is chosen"), std::nullopt);
}

} // namespace

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
