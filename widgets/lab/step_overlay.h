// StepOverlay: the steps of all series over one another, each in the colour and with the tick of its row, from their
// instants on. The wheel, dragging and keys move the time axis; speeds and currents fit themselves.
#pragma once

#include "widgets/lab/step_result.h"
#include "widgets/measuring/keyed_plot.h"

class QCPRange;

namespace widgets {

class StepOverlay final : public KeyedPlot {
    Q_OBJECT
public:
    explicit StepOverlay(QWidget *parent = nullptr);

    /// Those of one kind: speeds and currents have no axis in common.
    void showSteps(
        const std::vector<StepResult> &results, bool up, StepKind kind = StepKind::Speed);
    void fit() override; ///< all of the time
    int curves() const; ///< that are drawn

    QSize minimumSizeHint() const override { return {220, 130}; }

protected:
    void zoom(double factor) override;
    void pan(double share) override;

private:
    struct Drawn {
        int number = 0; ///< of its series
        StepCurve curve;
    };
    void draw() override;
    void drawCurve(const Drawn &drawn, bool dark);
    void bound(const QCPRange &range);
    void setLimits(double least, double most);

    std::vector<Drawn> m_curves;
    StepKind m_kind = StepKind::Speed;
    double m_least_s = 0.0, m_most_s = 0.1; ///< that there are points of
    double m_from_s = 0.0, m_to_s = 0.0; ///< shown; both 0: all
    bool m_setting = false;
};

} // namespace widgets
