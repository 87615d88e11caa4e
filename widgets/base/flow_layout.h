// FlowLayout: places widgets in lines, as words in a text. Before it begins a second line it makes those narrower that
// may be, if that saves the line.
#pragma once

#include <QLayout>

namespace widgets {

class FlowLayout : public QLayout {
public:
    explicit FlowLayout(int gap, QWidget *parent = nullptr);
    ~FlowLayout() override;

    /// So many of the last ones stay together, at the right end of their line.
    void setTrailing(int count) { m_trailing = count; }

    void addItem(QLayoutItem *item) override { m_items.append(item); }
    int count() const override { return static_cast<int>(m_items.size()); }
    QLayoutItem *itemAt(int index) const override { return m_items.value(index); }
    QLayoutItem *takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return {}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return arrange(QRect(0, 0, width, 0), false); }
    QSize sizeHint() const override { return minimumSize(); }
    QSize minimumSize() const override;
    void setGeometry(const QRect &rect) override;

private:
    int arrange(const QRect &rect, bool move) const; ///< the height it takes
    int trailingWidth(const QList<int> &widths) const;
    QList<int> widths(int room) const; ///< of the items, 0 for those that are not shown

    QList<QLayoutItem *> m_items;
    int m_gap;
    int m_trailing = 0;
    int m_width = 0; ///< where it was placed last
};

} // namespace widgets
