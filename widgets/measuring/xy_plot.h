// One value over another as a picture: the trail with its newest point, in equal scales where the units are, and the
// voltages that the bus allows. Strokes follow the pixels: points that fall on the same one are drawn once.
#pragma once

#include "scope/xy.h"
#include "widgets/measuring/keyed_plot.h"

#include <QPointF>

#include <optional>

namespace widgets {

class XyPlot final : public KeyedPlot {
    Q_OBJECT
public:
    explicit XyPlot(QWidget *parent = nullptr);

    enum class Trail : std::uint8_t { Alike, Fading, None };
    struct Picture {
        std::vector<scope::XyPoint> points; ///< oldest first
        QString xLabel;
        QString yLabel;
        bool equal = true; ///< a unit is as long on one axis as on the other
        bool vector = false; ///< an arrow from zero to the newest point; zero is in the middle
        Trail trail = Trail::Fading;
        double busVolts = 0.0; ///< 0: no limits are drawn
        bool hexagon = false; ///< the limits have corners, for they do not turn with the rotor
    };
    void showPicture(Picture picture);
    void showNothing(const QString &why);
    void fit() override; ///< F: everything
    struct Ranges {
        double left, right, bottom, top;
    };
    Ranges ranges() const; ///< of the axes
    int strokes() const { return m_strokes; } ///< of the trail as it was painted last
    QRect area() const; ///< where it is drawn

protected:
    void zoom(double factor) override;
    void pan(double shareX) override { shift(shareX, 0.0); }
    void panUp(double shareY) override { shift(0.0, shareY); }
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool handleMouse(QEvent *event);
    void shift(double shareX, double shareY);
    void draw() override;
    Ranges wanted() const;
    Ranges equalised(Ranges ranges) const;
    QPointF pixel(double x, double y) const;
    void paintOn(QPainter &painter);
    void paintLimits(QPainter &painter) const;
    void paintTrail(QPainter &painter);
    void paintNewest(QPainter &painter) const;

    QWidget *m_glass; ///< over the axes; paints the trail
    Picture m_picture;
    std::optional<Ranges> m_moved; ///< by hand
    QPointF m_taken; ///< where the mouse holds the picture
    int m_strokes = 0;
};

} // namespace widgets
