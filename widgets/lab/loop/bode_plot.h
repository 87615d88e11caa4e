// BodePlot: frequency responses over one another: gain, phase, and how much of what was measured counts. Error bars
// hold the true value in 95 of 100 cases; points with a coherence below 0.8 are hollow. It draws what it is given.
#pragma once

#include "lab/evaluation/response_evaluation.h"
#include "widgets/measuring/keyed_plot.h"

#include <QSharedPointer>
#include <QString>
#include <QVector>

#include <array>

class QCPAxisRect;
class QCPAxisTickerFixed;
class QCPRange;

namespace widgets {

struct BodeCurve {
    struct Point {
        double hz = 0.0;
        double gain_db = 0.0, low_db = 0.0, high_db = 0.0;
        double phase_deg = 0.0, phaseHalf_deg = 0.0;
        double coherence = 0.0;
    };
    QString name;
    int slot = 0; ///< of its colour
    bool measured = true; ///< else it is a line without points, dashed
    QVector<Point> points; ///< by frequency
};

enum class BodeOf : std::uint8_t { Loop, Motor };
/// The open loop, or the motor (of a current: the closed loop), of the points that tell it.
BodeCurve bodeCurve(const lab::FrequencyResponse &response, BodeOf of);

class BodePlot final : public KeyedPlot {
    Q_OBJECT
public:
    explicit BodePlot(QWidget *parent = nullptr);

    /// @param unit  of the gain that is 0 dB: "(rad/s)/A"; empty: none
    void showCurves(const QVector<BodeCurve> &curves, const QString &unit);
    void fit() override;
    const QVector<BodeCurve> &curves() const { return m_curves; }

    QSize minimumSizeHint() const override { return {240, 160}; }

protected:
    void zoom(double factor) override;
    void pan(double share) override;

private:
    enum Part : std::size_t { Gain, Phase, Coherence, kParts };
    void dress() override;
    void draw() override;
    void drawCurve(const BodeCurve &curve, bool dark);
    void scale();
    void bound(const QCPRange &range);
    void setLimits(double least, double most);

    std::array<QCPAxisRect *, kParts> m_rects{};
    QSharedPointer<QCPAxisTickerFixed> m_coherences;
    QVector<BodeCurve> m_curves;
    QString m_unit;
    double m_from_hz = 0.0, m_to_hz = 0.0; ///< shown; both 0: all
    bool m_setting = false;
};

} // namespace widgets
