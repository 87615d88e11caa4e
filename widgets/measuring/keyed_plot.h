// KeyedPlot: what pictures with axes have in common: the palette's colours, words in place of what is not there, and
// keys of their own: + and - zoom, arrows move, F shows everything. The keys are those of the scope, which has them in
// the whole window: while the picture has the focus they are the picture's.
#pragma once

#include <QWidget>

class QCustomPlot;
class QLabel;

namespace widgets {

class KeyedPlot : public QWidget {
    Q_OBJECT
public:
    /// @param name  of the object; that of the words over an empty picture ends with "Why"
    /// @param title  for screen readers
    KeyedPlot(const QString &name, const QString &title, QWidget *parent);

    virtual void fit() = 0; ///< everything

protected:
    virtual void zoom(double factor) = 0;
    virtual void pan(double shareX) = 0; ///< by a part of what is shown
    /// The same for what is above; a picture whose values fit themselves has no other way than to zoom.
    virtual void panUp(double shareY) { zoom(shareY > 0.0 ? kKeyZoom : 1.0 / kKeyZoom); }
    virtual void draw() = 0; ///< all of it, in the size that it has
    virtual void dress(); ///< in the colours of the palette and the font; to be followed by draw()
    /// In place of a picture. @param why  empty: there is one
    void say(const QString &why);
    QCustomPlot &plot() const { return *m_plot; }

    void keyPressEvent(QKeyEvent *event) override;
    bool event(QEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

    static constexpr double kKeyZoom = 1.5;

private:
    bool handleKey(int key);

    QCustomPlot *m_plot;
    QLabel *m_why;
};

} // namespace widgets
