#include "widgets/scope/cursors.h"

#include <algorithm>
#include <cmath>

namespace widgets {

Cursors::Cursors(QObject *parent)
    : QObject(parent)
{
    m_pairs.push_back({freeName(), 0.0, 0.0});
}

void Cursors::setVisible(bool visible)
{
    if (visible == m_visible)
        return;
    m_visible = visible;
    if (!visible)
        m_active.reset();
    Q_EMIT changed();
}

void Cursors::setActive(std::optional<CursorEnd> end)
{
    if (end == m_active || (end && !m_visible))
        return;
    m_active = end;
    Q_EMIT changed();
}

void Cursors::move(CursorEnd end, double seconds)
{
    if (!std::isfinite(seconds))
        return;
    CursorPair &pair = m_pairs[std::size_t(m_current)];
    (end == CursorEnd::A ? pair.a : pair.b) = seconds;
    Q_EMIT changed();
}

void Cursors::shift(double seconds)
{
    if (!std::isfinite(seconds))
        return;
    for (CursorPair &pair : m_pairs) {
        pair.a += seconds;
        pair.b += seconds;
    }
    Q_EMIT changed();
}

void Cursors::setCurrent(int index)
{
    if (index == m_current || index < 0 || index >= static_cast<int>(m_pairs.size()))
        return;
    m_current = index;
    Q_EMIT changed();
}

void Cursors::addPair(double a, double b)
{
    if (m_pairs.size() >= std::size_t(kMostPairs) || !std::isfinite(a) || !std::isfinite(b))
        return;
    m_pairs.push_back({freeName(), a, b});
    m_current = static_cast<int>(m_pairs.size()) - 1;
    Q_EMIT changed();
}

void Cursors::removeCurrent()
{
    if (m_pairs.size() < 2)
        return;
    m_pairs.erase(m_pairs.begin() + m_current);
    m_current = std::min(m_current, static_cast<int>(m_pairs.size()) - 1);
    m_active.reset();
    Q_EMIT changed();
}

void Cursors::rename(const QString &name)
{
    const QString tidy = name.simplified().left(kNameLength);
    if (tidy.isEmpty() || tidy == pair().name)
        return;
    m_pairs[std::size_t(m_current)].name = tidy;
    Q_EMIT changed();
}

QString Cursors::freeName() const
{
    for (int number = 1;; ++number) {
        const QString name = tr("Pair %1", "of cursors").arg(number);
        const auto taken = [&name](const CursorPair &pair) { return pair.name == name; };
        if (std::none_of(m_pairs.begin(), m_pairs.end(), taken))
            return name;
    }
}

} // namespace widgets
