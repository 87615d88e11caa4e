// GainForecast: what the loops will do with planned gains, in words and drawn small, over what they do with the board's.
#pragma once

#include "widgets/forms/gain_plan_table.h"

#include <QWidget>

namespace widgets {

class GainLabel;
class GainPlot;

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
