// KeyedPlot: a picture with keys of its own. Its letters are those of the scope, which has them in the whole window:
// while the picture has the focus they are the picture's.
#pragma once

#include <QWidget>

namespace widgets {

class KeyedPlot : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

protected:
    /// A key without a modifier, of the keypad or not. False leaves it to what is around the picture.
    virtual bool takeKey(int key) = 0;
    void keyPressEvent(QKeyEvent *event) override;
    bool event(QEvent *event) override;
};

} // namespace widgets
