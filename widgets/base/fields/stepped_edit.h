// SteppedEdit: what the fields for one number have in common. Arrow keys step the number, Page Up and Down by ten
// steps, the wheel only while the field has the focus; while the text is no good the field is red, with the reason as
// tool tip and for screen readers. A click into it selects all, as Tab does: what is typed then takes the number's
// place. What the text means, and how it steps, is the business of the class made from this one.
#pragma once

#include <QColor>
#include <QLineEdit>
#include <QPalette>

namespace widgets {

/// Behind a text that cannot be taken. Black text stays readable on it in both themes.
inline constexpr QColor kRefusedColor{0xff, 0x8f, 0x85};

/// For a field, by what is wrong with its text; that of its parents if nothing is.
QPalette problemPalette(const QString &problem);

/// Shows in a field what it follows. Cursor and selection stay where the user has put them: what is typed next is to
/// replace what is selected, however often the board is read meanwhile.
void followText(QLineEdit &edit, const QString &now);
bool focusIsIn(const QWidget &widget); ///< or will be once its window is the active one

class SteppedEdit : public QLineEdit {
    Q_OBJECT
public:
    explicit SteppedEdit(QWidget *parent = nullptr);

    virtual QString problem() const { return {}; } ///< one sentence; empty if the text is good

    void setFollowed(const QString &now) { followText(*this, now); }

protected:
    virtual void stepBy(int steps) = 0; ///< -10, -1, 1 or 10; nothing where the text is no number
    virtual bool wheelWanted() const { return hasFocus(); }
    void showProblem();

    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    bool m_clickedInto = false;
    QString m_told; ///< the problem that is shown as a tool tip
};

} // namespace widgets
