// PlanPicture: what a motor is to do by itself, as a small picture: its speed over time, the currents that it gets at
// rest, and the caps beyond which it is stopped.
#pragma once

#include <QVector>
#include <QWidget>

class QCustomPlot;

namespace widgets {

struct SpeedPlan {
    QVector<double> seconds, rpm; ///< straight lines between
    QVector<double> ampSeconds, amps; ///< the same of the currents of a motor at rest
    double leastRpm = 0.0, mostRpm = 0.0; ///< the caps
};

class PlanPicture : public QWidget {
    Q_OBJECT
public:
    explicit PlanPicture(const SpeedPlan &plan, QWidget *parent = nullptr);

    QSize sizeHint() const override { return {460, 190}; }
    QSize minimumSizeHint() const override { return {320, 150}; }

protected:
    void changeEvent(QEvent *event) override;

private:
    void applyPalette();
    void draw();
    void drawCurrents();

    SpeedPlan m_speeds;
    QCustomPlot *m_plot;
};

} // namespace widgets
