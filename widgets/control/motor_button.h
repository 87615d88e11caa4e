// Buttons that act on a motor. They refuse the Space bar, which belongs to the scope: a focused button must never turn
// a key that means "hold the picture" into motion.
#pragma once

#include <QPushButton>

namespace widgets {

class MotorButton : public QPushButton {
    Q_OBJECT
public:
    using QPushButton::QPushButton;

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;
};

/// Red, at least 48 pixels high, acts when it is pressed and not when it is let go.
class StopButton : public MotorButton {
    Q_OBJECT
public:
    explicit StopButton(QWidget *parent = nullptr);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void stopPressed();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
};

} // namespace widgets
