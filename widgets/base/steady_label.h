// A label whose place does not depend on what it says: as wide as the widest that it was told to have room for, and
// always as high as its lines. What does not fit is cut, and whole in its tool tip.
#pragma once

#include <QLabel>

namespace widgets {

class SteadyLabel : public QLabel {
    Q_OBJECT
public:
    /// Plain text. @param lines  each paragraph has one, and goes on in those that are left over; the last line takes
    /// what is left of all
    explicit SteadyLabel(QWidget *parent = nullptr, int lines = 1);

    /// What it may have to say. Without, it is as wide as what it says now: give it a policy that ignores that.
    void setRoomFor(const QStringList &texts);
    void setLines(int lines);
    /// So many would hold a text, as wide as the label is.
    int linesFor(const QString &text) const;
    /// Its text can be marked and copied, with the mouse and with the keys of a text. For one of several lines.
    void setSelectable(bool selectable);
    bool isCut() const; ///< not all of its text is seen

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }
    bool hasHeightForWidth() const override { return false; }

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    QStringList lines() const;
    bool selectable() const { return textInteractionFlags().testFlag(Qt::TextSelectableByMouse); }
    int fittingWords(const QString &line, int width) const;

    QStringList m_room;
    int m_lines;
};

} // namespace widgets
