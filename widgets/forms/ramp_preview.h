// RampPreview: a small picture of a ramp: the set-point that is to come, and, while it runs, what is measured.
#pragma once

#include "widgets/forms/ramp_preset.h"

#include <QWidget>

#include <vector>

class QCustomPlot;
class QCPGraph;
class QCPItemStraightLine;

namespace widgets {

struct RampPicture {
    struct Point {
        double seconds = 0.0, value = 0.0;
        bool operator==(const Point &) const = default;
    };
    std::vector<Point> plan; ///< each holds until the next where it goes in stairs
    bool stairs = false;
    QString label; ///< of the value axis, with unit
    bool operator==(const RampPicture &) const = default;
};

/// What a board makes of a ramp, in the unit of its kind.
/// @param stair_rpm  the step in which it counts speeds; 0: none
RampPicture plannedRamp(RampKind kind, double from, double to, double seconds, double stair_rpm);

class RampPreview : public QWidget {
    Q_OBJECT
public:
    explicit RampPreview(QWidget *parent = nullptr);

    void showPlan(const RampPicture &picture);
    const RampPicture &picture() const { return m_picture; }
    /// What was measured since the ramp goes, and how long that is; empty and negative: it does not.
    void showMeasured(const std::vector<RampPicture::Point> &measured, double now_s);

    QSize sizeHint() const override { return {360, 220}; }
    QSize minimumSizeHint() const override { return {200, 120}; }

protected:
    void changeEvent(QEvent *event) override;

private:
    void applyPalette();
    void draw();

    QCustomPlot *m_plot;
    QCPGraph *m_plan, *m_measured;
    QCPItemStraightLine *m_now;
    RampPicture m_picture;
    std::vector<RampPicture::Point> m_points;
    double m_nowSeconds = -1.0;
};

} // namespace widgets
