#include "widgets/base/late_icons.h"

#include <QIconEngine>
#include <QPointer>

#include <utility>

namespace widgets {
namespace {

/// Gives every question to the style's icon, which it gets with the first. Not from the style of the application: that one may
/// stand before ours (Qt's, of a style sheet) and would ask ours, which would make the next late icon.
class LateIcon : public QIconEngine {
public:
    LateIcon(QPointer<QStyle> style, QStyle::StandardPixmap which)
        : m_style(std::move(style))
        , m_which(which)
    {
    }

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State state) override
    {
        icon().paint(painter, rect, Qt::AlignCenter, mode, state);
    }
    QSize actualSize(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        return icon().actualSize(size, mode, state);
    }
    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        return icon().pixmap(size, 1.0, mode, state);
    }
    QPixmap scaledPixmap(
        const QSize &size, QIcon::Mode mode, QIcon::State state, qreal scale) override
    {
        return icon().pixmap(size / scale, scale, mode, state);
    }
    QList<QSize> availableSizes(QIcon::Mode mode, QIcon::State state) override
    {
        return icon().availableSizes(mode, state);
    }
    QString iconName() override { return icon().name(); }
    bool isNull() override { return icon().isNull(); }
    QIconEngine *clone() const override { return new LateIcon(*this); }

private:
    const QIcon &icon()
    {
        if (m_icon.isNull() && m_style)
            m_icon = m_style->standardIcon(m_which);
        return m_icon;
    }

    QPointer<QStyle> m_style;
    QStyle::StandardPixmap m_which;
    QIcon m_icon;
};

} // namespace

LateIcons::LateIcons()
    : QProxyStyle(QStringLiteral("Fusion"))
{
}

QIcon LateIcons::standardIcon(
    StandardPixmap which, const QStyleOption * /*option*/, const QWidget * /*widget*/) const
{
    return QIcon(new LateIcon(baseStyle(), which));
}

} // namespace widgets
