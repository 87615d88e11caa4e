// JogBox: two buttons that turn a motor slowly one way or the other while they are held, with a pointer or with the
// Enter key. Keys that repeat by themselves count as one.
#pragma once

#include "widgets/control/jog.h"
#include "widgets/control/motor_button.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

class QLabel;

namespace widgets {

class NumberEdit;

/// Tells how it is held: began once, then ended (let go) or lost (focus, window, visibility), never both.
class JogButton : public MotorButton {
    Q_OBJECT
public:
    explicit JogButton(const QString &text, QWidget *parent = nullptr);

    bool held() const { return m_held; }

Q_SIGNALS:
    void began();
    void stillHeld(); ///< some times within the time that a hold lasts without it
    void ended();
    void lost();

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;

private:
    void begin();
    void lose();
    void end();
    void watchWindow(bool watch);

    bool m_held = false;
    QPointer<QWidget> m_watched; ///< the window, while held
    QTimer m_holding; ///< runs while it is held
    QTimer m_released; ///< runs while a key that came up may turn out to repeat itself
    quint64 m_releasedAt = 0; ///< by the window system's clock
};

class JogBox : public QWidget {
    Q_OBJECT
public:
    JogBox(Device &device, MotionGate &motion, QWidget *parent = nullptr);

    Jog &jog() { return m_jog; }

public Q_SLOTS:
    void follow(); ///< the device may allow something else now
    void refresh(widgets::Milliseconds now) { m_jog.refresh(now); }

private:
    JogButton *makeButton(const QString &text, const char *name, int sign);
    void updateLimit();

    Device &m_device;
    Jog m_jog;
    NumberEdit *m_speed;
    JogButton *m_back;
    JogButton *m_forth;
    bool m_speedGiven = false; ///< the field holds a speed for this board
};

} // namespace widgets
