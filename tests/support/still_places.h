// Where everything is in a window that has a name and is seen, so that a test can tell what moved. What lies over the
// window without a place of its own in it (a message, a mark across the picture) is none of it, nor what comes and goes
// itself.
#pragma once

#include <QAbstractButton>
#include <QRect>
#include <QStringList>
#include <QWidget>

#include <map>

namespace facts {

class StillPlaces {
public:
    /// @param over  names of what lies over the others
    explicit StillPlaces(const QWidget &window, QStringList over = {})
        : m_window(window)
        , m_over(std::move(over))
        , m_before(places())
    {
    }

    qsizetype count() const { return static_cast<qsizetype>(m_before.size()); }

    /// What has another place or size than when this was made, in words; empty: nothing.
    QString moved() const
    {
        QStringList all;
        if (m_window.size() != m_size)
            all.append(
                QStringLiteral("the window: %1 -> %2").arg(text(m_size), text(m_window.size())));
        const auto now = places();
        for (const auto &[name, place] : m_before) {
            const auto at = now.find(name);
            if (at != now.end() && at->second != place)
                all.append(QStringLiteral("%1: %2 -> %3").arg(name, text(place), text(at->second)));
        }
        return all.join(QStringLiteral("; "));
    }

private:
    static QString text(const QSize &size)
    {
        return QStringLiteral("%1x%2").arg(size.width()).arg(size.height());
    }
    static QString text(const QRect &place)
    {
        return text(place.size()) + QStringLiteral("+%1+%2").arg(place.x()).arg(place.y());
    }

    /// By its name, and those of what it is in: a button of a chip has none of its own.
    QString nameOf(const QWidget *widget) const
    {
        QStringList names;
        for (const QWidget *one = widget; one && one != &m_window; one = one->parentWidget()) {
            if (m_over.contains(one->objectName()))
                return {};
            if (!one->objectName().isEmpty())
                names.prepend(one->objectName());
        }
        const bool named = !widget->objectName().isEmpty();
        if (!named && qobject_cast<const QAbstractButton *>(widget) == nullptr)
            return {};
        return names.mid(std::max<qsizetype>(0, names.size() - 2)).join(QLatin1Char('/'));
    }

    std::map<QString, QRect> places() const
    {
        std::map<QString, QRect> found;
        for (const QWidget *widget : m_window.findChildren<QWidget *>()) {
            if (!widget->isVisible() || widget->window() != &m_window)
                continue;
            const QString name = nameOf(widget);
            if (name.isEmpty())
                continue;
            QString key = name;
            for (int more = 2; found.contains(key); ++more)
                key = QStringLiteral("%1 %2").arg(name).arg(more);
            found[key] = QRect(widget->mapTo(&m_window, QPoint()), widget->size());
        }
        return found;
    }

    const QWidget &m_window;
    QStringList m_over;
    QSize m_size = m_window.size();
    std::map<QString, QRect> m_before;
};

} // namespace facts
