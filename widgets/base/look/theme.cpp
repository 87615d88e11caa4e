#include "widgets/base/look/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPointer>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <QToolTip>

namespace widgets {
namespace {

struct Shades {
    QColor window, base, alternate, text, dimmed, button, mid, dark, highlight, highlighted, link,
        toolTip;
};

QPalette paletteOf(const Shades &s)
{
    QPalette palette(s.button, s.window);
    const auto set = [&palette](QPalette::ColorRole role, const QColor &color) {
        palette.setColor(role, color);
    };
    set(QPalette::Window, s.window);
    set(QPalette::WindowText, s.text);
    set(QPalette::Base, s.base);
    set(QPalette::AlternateBase, s.alternate);
    set(QPalette::Text, s.text);
    set(QPalette::PlaceholderText, s.dimmed);
    set(QPalette::Button, s.button);
    set(QPalette::ButtonText, s.text);
    set(QPalette::BrightText, Qt::white);
    set(QPalette::Mid, s.mid);
    set(QPalette::Dark, s.dark);
    set(QPalette::Highlight, s.highlight);
    set(QPalette::HighlightedText, s.highlighted);
    set(QPalette::Link, s.link);
    set(QPalette::ToolTipBase, s.toolTip);
    set(QPalette::ToolTipText, s.text);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, s.dimmed);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, s.mid);
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, s.dimmed);
    return palette;
}

/// The style fills menus and the boxes in them with the colour of fields, and draws the boxes' edges darker still: on a
/// dark field they cannot be seen. Nor can entries that are disabled be told from the others there.
QPalette menuPalette(const QPalette &whole, bool dark)
{
    QPalette palette = whole;
    if (!dark)
        return palette;
    palette.setColor(QPalette::Base, whole.color(QPalette::Button));
    palette.setColor(QPalette::Window, whole.color(QPalette::Base));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, whole.color(QPalette::Mid).lighter(160));
    return palette;
}

/// The style draws the edges of boxes a little darker than their window: an empty one cannot be told from it.
class EdgeStyle : public QProxyStyle {
public:
    EdgeStyle()
        : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion")))
    {
    }
    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
        const QWidget *widget) const override
    {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        const bool box =
            element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck;
        if (!box)
            return;
        painter->save();
        painter->setPen(option->palette.color(QPalette::PlaceholderText));
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        painter->restore();
    }
};

bool desktopIsDark()
{
    // Asked once, before the first theme replaces the palette.
    static const bool dark = QApplication::palette().color(QPalette::Window).lightness() < 128;
    return dark;
}

} // namespace

QPalette lightPalette()
{
    return paletteOf({QColor(0xf1, 0xf3, 0xf5), QColor(0xff, 0xff, 0xff), QColor(0xf6, 0xf8, 0xfa),
        QColor(0x1b, 0x1f, 0x24), QColor(0x6b, 0x73, 0x7c), QColor(0xe9, 0xec, 0xef),
        QColor(0xc4, 0xca, 0xd0), QColor(0xa0, 0xa8, 0xb0), QColor(0x1f, 0x6f, 0xb4),
        QColor(0xff, 0xff, 0xff), QColor(0x0b, 0x5c, 0xad), QColor(0xff, 0xff, 0xff)});
}

QPalette darkPalette()
{
    // The style draws outlines as a darker window colour: fields need a base that is darker still.
    return paletteOf({QColor(0x30, 0x35, 0x3b), QColor(0x1a, 0x1d, 0x21), QColor(0x20, 0x24, 0x29),
        QColor(0xe8, 0xec, 0xf0), QColor(0x98, 0xa1, 0xab), QColor(0x40, 0x47, 0x4e),
        QColor(0x50, 0x58, 0x61), QColor(0x14, 0x17, 0x1a), QColor(0x2f, 0x81, 0xc7),
        QColor(0xff, 0xff, 0xff), QColor(0x6c, 0xb6, 0xff), QColor(0x40, 0x47, 0x4e)});
}

void applyTheme(Theme theme)
{
    const bool dark = desktopIsDark();
    // Kept, not asked for: with a style sheet the application's style is Qt's own, with ours behind it.
    static QPointer<QStyle> style;
    if (!style)
        QApplication::setStyle(style = new EdgeStyle);
    const bool wantDark = theme == Theme::Dark || (theme == Theme::System && dark);
    const QPalette palette = wantDark ? darkPalette() : lightPalette();
    QApplication::setPalette(palette);
    QApplication::setPalette(menuPalette(palette, wantDark), "QMenu");
    QToolTip::setPalette(palette);
}

} // namespace widgets
