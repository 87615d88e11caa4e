#include "widgets/base/flow_layout.h"

#include <QWidget>

#include <algorithm>
#include <utility>

namespace widgets {

FlowLayout::FlowLayout(int gap, QWidget *parent)
    : QLayout(parent)
    , m_gap(gap)
{
    setContentsMargins(0, 0, 0, 0);
}

FlowLayout::~FlowLayout() { qDeleteAll(m_items); }

QLayoutItem *FlowLayout::takeAt(int index)
{
    return index >= 0 && index < m_items.size() ? m_items.takeAt(index) : nullptr;
}

QSize FlowLayout::minimumSize() const
{
    QSize size;
    for (const QLayoutItem *item : m_items)
        size = size.expandedTo(item->minimumSize());
    // The least height of a window is asked for without a width: that of all lines at the width there is, else what
    // stands beside would be covered.
    return m_width > 0 ? size.expandedTo({0, heightForWidth(m_width)}) : size;
}

void FlowLayout::setGeometry(const QRect &rect)
{
    QLayout::setGeometry(rect);
    arrange(rect, true);
    if (parentWidget() != nullptr && !parentWidget()->isVisible())
        return; // as wide as it was made, a width that is never shown
    if (rect.width() != std::exchange(m_width, rect.width()))
        update(); // the least height may be another now
}

/// As wide as each wants to be; if one line holds them all only when they are squeezed, as wide as that leaves them.
QList<int> FlowLayout::widths(int room) const
{
    QList<int> all;
    int wanted = -m_gap;
    int slack = 0; ///< that can be taken from those that may be narrower
    for (QLayoutItem *item : m_items) {
        all.append(item->isEmpty() ? 0 : item->sizeHint().width());
        wanted += item->isEmpty() ? 0 : all.last() + m_gap;
        slack += item->isEmpty() ? 0 : std::max(0, all.last() - item->minimumSize().width());
    }
    int over = wanted - room;
    if (over <= 0 || over > slack)
        return all;
    for (int i = 0; i < all.size(); ++i) {
        QLayoutItem *item = m_items[i];
        const int own = item->isEmpty() ? 0 : std::max(0, all[i] - item->minimumSize().width());
        const int taken = slack > 0 ? (over * own + slack - 1) / slack : 0;
        all[i] -= taken;
        over -= taken;
        slack -= own;
    }
    return all;
}

int FlowLayout::trailingWidth(const QList<int> &widths) const
{
    int all = 0;
    for (const int width : widths.mid(widths.size() - m_trailing))
        all += width > 0 ? width + m_gap : 0;
    return all - m_gap;
}

int FlowLayout::arrange(const QRect &rect, bool move) const
{
    const QList<int> widths = this->widths(rect.width());
    int x = rect.x();
    int y = rect.y();
    int lineHeight = 0;
    for (int i = 0; i < m_items.size(); ++i) {
        QLayoutItem *item = m_items[i];
        if (item->isEmpty())
            continue;
        const QSize size(widths[i], item->sizeHint().height());
        const bool trails = m_trailing > 0 && i == static_cast<int>(m_items.size()) - m_trailing;
        const int together = trails ? trailingWidth(widths) : size.width();
        if (x > rect.x() && x + together > rect.x() + rect.width()) {
            x = rect.x();
            y += lineHeight + m_gap;
            lineHeight = 0;
        }
        if (trails)
            x = std::max(x, rect.x() + rect.width() - together);
        if (move)
            item->setGeometry(QRect(QPoint(x, y), size));
        x += size.width() + m_gap;
        lineHeight = std::max(lineHeight, size.height());
    }
    return y + lineHeight - rect.y();
}

} // namespace widgets
