#include "widgets/base/look/line_icon.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace widgets {
namespace {

class LineIconEngine : public QIconEngine {
public:
    explicit LineIconEngine(QString name)
        : m_name(std::move(name))
    {
    }

    QIconEngine *clone() const override { return new LineIconEngine(m_name); }
    QString key() const override { return QStringLiteral("line"); }
    QString iconName() override { return m_name; }
    bool isNull() override { return false; }

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State state) override
    {
        const qreal ratio = painter->device()->devicePixelRatioF();
        painter->drawPixmap(rect, scaledPixmap(rect.size() * ratio, mode, state, ratio));
    }
    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        return scaledPixmap(size, mode, state, 1.0);
    }
    QPixmap scaledPixmap(const QSize &size, QIcon::Mode mode, QIcon::State, qreal ratio) override
    {
        const QColor color = colorOf(mode);
        const QString kept = QStringLiteral("line %1 %2 %3x%4 %5")
                                 .arg(m_name, color.name(), QString::number(size.width()),
                                     QString::number(size.height()), QString::number(ratio));
        QPixmap pixmap;
        if (!QPixmapCache::find(kept, &pixmap)) {
            pixmap = QPixmap(size);
            pixmap.fill(Qt::transparent);
            QFile file(QStringLiteral(":/icons/line/%1.svg").arg(m_name));
            if (file.open(QIODevice::ReadOnly)) {
                QSvgRenderer drawing(
                    file.readAll().replace("currentColor", color.name().toLatin1()));
                QPainter painter(&pixmap);
                drawing.render(&painter, QRectF(QPointF(), size));
            }
            QPixmapCache::insert(kept, pixmap);
        }
        pixmap.setDevicePixelRatio(ratio);
        return pixmap;
    }

private:
    static QColor colorOf(QIcon::Mode mode)
    {
        const QPalette palette = QApplication::palette();
        switch (mode) {
        case QIcon::Disabled:
            return palette.color(QPalette::Disabled, QPalette::ButtonText);
        case QIcon::Selected:
            return palette.color(QPalette::HighlightedText);
        case QIcon::Normal:
        case QIcon::Active:
            break;
        }
        return palette.color(QPalette::Active, QPalette::ButtonText);
    }

    QString m_name;
};

} // namespace

QIcon lineIcon(const char *name) { return QIcon(new LineIconEngine(QLatin1String(name))); }

void setLineIcon(QAction &action, const char *name)
{
    action.setIcon(lineIcon(name));
    action.setIconVisibleInMenu(!action.isCheckable());
}

void setLineIcon(QAbstractButton &button, const char *name) { button.setIcon(lineIcon(name)); }

} // namespace widgets
