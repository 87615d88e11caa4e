// GainForecast: what the loops will do with planned gains, in words and drawn small, over what they do with the
// board's.
#pragma once

#include "motor/current_loop.h"
#include "widgets/forms/gain_plan_table.h"

#include <QWidget>

namespace widgets {

class GainLabel;

/// The step of a loop drawn small: the one that the new gains will make, and the one of the gains that the board has
/// now, dashed. Draws what it is given.
class GainPlot : public QWidget {
    Q_OBJECT
public:
    explicit GainPlot(const QString &title, QWidget *parent = nullptr);

    /// Empty responses are not drawn. Both begin at 0; what lies beyond `duration_s` is cut.
    void setSteps(const motor::StepPrediction &planned, const motor::StepPrediction &present,
        double duration_s);
    /// Instead of a picture: why there is none.
    void setReason(const QString &sentence);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void drawStep(QPainter &painter, const QRectF &area, const motor::StepPrediction &step) const;
    double top() const;

    QString m_title, m_reason;
    motor::StepPrediction m_planned, m_present;
    double m_duration_s = 0.0;
};

class GainForecast : public QWidget {
    Q_OBJECT
public:
    explicit GainForecast(QWidget *parent = nullptr);

    /// @param asked_radps  the bandwidth that was wished for
    void showPlan(const motor::GainPlan &plan, double asked_radps, const motor::GainPlant &plant,
        const motor::PerGain<HeldGain> &board);

private:
    void showCurrent(const motor::GainPlan &plan, double asked_radps, const motor::GainPlant &plant,
        const motor::PerGain<HeldGain> &board);
    void showSpeed(const motor::GainPlan &plan, const motor::GainPlant &plant,
        const motor::PerGain<HeldGain> &board);

    GainLabel *m_currentText, *m_speedText;
    GainPlot *m_currentPlot, *m_speedPlot;
};

} // namespace widgets
