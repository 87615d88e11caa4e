#include "widgets/scope/color_menu.h"

#include "widgets/base/trace_colors.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <QPixmap>

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

} // namespace

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

} // namespace widgets
