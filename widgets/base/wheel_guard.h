// WheelGuard: the wheel scrolls past a control that has no focus, instead of changing what it is set to.
#pragma once

#include <QObject>

class QWidget;

namespace widgets {

class WheelGuard : public QObject {
    Q_OBJECT
public:
    /// Guards `control`, which also owns the guard; the wheel no longer gives it the focus either.
    explicit WheelGuard(QWidget *control);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace widgets
