// KeyedPlot: a picture with keys of its own: + and - zoom, arrows move, F shows everything. They are those of the scope, which
// has them in the whole window: while the picture has the focus they are the picture's.
#pragma once

#include <QWidget>

namespace widgets {

class KeyedPlot : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    virtual void fit() = 0; ///< everything

protected:
    virtual void zoom(double factor) = 0;
    virtual void pan(double shareX) = 0; ///< by a part of what is shown
    /// The same for what is above; a picture whose values fit themselves has no other way than to zoom.
    virtual void panUp(double shareY) { zoom(shareY > 0.0 ? kKeyZoom : 1.0 / kKeyZoom); }
    void keyPressEvent(QKeyEvent *event) override;
    bool event(QEvent *event) override;

    static constexpr double kKeyZoom = 1.5;

private:
    bool takeKey(int key);
};

} // namespace widgets
