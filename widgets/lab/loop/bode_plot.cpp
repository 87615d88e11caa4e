#include "widgets/lab/loop/bode_plot.h"

#include "widgets/base/plot_look.h"
#include "widgets/base/trace_colors.h"

#include <QScopedValueRollback>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace widgets {
namespace {

constexpr double kLeastCoherence = 0.8; ///< below it a point is hollow
constexpr double kWidest = 1.5; ///< from one point to the next: more is a gap
constexpr double kDot = 5.0; ///< pixels
constexpr int kLeast = 18, kLowest = 56; ///< pixels, of the coherence: at least, and at most
constexpr int kLow = 240; ///< pixels: below it the coherence has no number between 0 and 1
constexpr int kEachTick = 22; ///< pixels, at least
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kLeast_hz = 0.5, kMost_hz = 2e4; ///< that an axis shows

double dbOf(double gain)
{
    constexpr double kDecibel = 20.0, kSmallest = 1e-6;
    return kDecibel * std::log10(std::max(gain, kSmallest));
}

struct Ends {
    double least = 1e9, most = -1e9;
    void accept(double value)
    {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    QCPRange range(double room) const { return {least - room, most + room}; }
};

} // namespace

BodeCurve bodeCurve(const lab::FrequencyResponse &response, BodeOf of)
{
    constexpr double kNormal = 1.96, kMostRelative = 0.999;
    BodeCurve curve;
    double last = 0.0;
    for (const lab::ResponsePoint &point : response.points) {
        const bool loop = of == BodeOf::Loop;
        if (loop ? point.loop == std::complex<double>() : !point.plantKnown)
            continue;
        const std::complex<double> value = loop ? point.loop : point.plant;
        const double gain = std::abs(value), phase = std::arg(value) * kDegrees;
        last = curve.points.isEmpty() ? phase : phase + 360.0 * std::round((last - phase) / 360.0);
        const double half = kNormal * (loop ? point.loopRelative : point.relative);
        curve.points.append(
            {point.hz, dbOf(gain), dbOf(gain * (1.0 - std::min(half, kMostRelative))),
                dbOf(gain * (1.0 + half)), last, half * kDegrees, point.coherence});
    }
    return curve;
}

BodePlot::BodePlot(QWidget *parent)
    : KeyedPlot(QStringLiteral("bodePlot"), tr("Frequency response"), parent)
    , m_coherences(new QCPAxisTickerFixed)
{
    plot().setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    plot().plotLayout()->setRowSpacing(0);
    auto *margins = new QCPMarginGroup(&plot());
    const QSharedPointer<QCPAxisTickerLog> frequencies(new QCPAxisTickerLog);
    for (std::size_t part = 0; part < kParts; ++part) {
        auto *rect = part == Gain ? plot().axisRect() : new QCPAxisRect(&plot());
        m_rects[part] = rect;
        if (part != Gain)
            plot().plotLayout()->addElement(static_cast<int>(part), 0, rect);
        for (QCPAxis *axis : rect->axes()) {
            axis->setLayer(QStringLiteral("axes"));
            axis->grid()->setLayer(QStringLiteral("grid"));
        }
        rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
        rect->setRangeDrag(Qt::Horizontal);
        rect->setRangeZoom(Qt::Horizontal);
        QCPAxis *x = rect->axis(QCPAxis::atBottom);
        x->setScaleType(QCPAxis::stLogarithmic);
        x->setTicker(frequencies);
        x->setNumberFormat(QStringLiteral("gb"));
        x->setNumberPrecision(4);
        x->setTickLabels(part == Coherence);
        connect(x, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), this, &BodePlot::bound);
        rect->setMinimumMargins({0, 4, 4, part == Coherence ? 0 : 2});
    }
    plot().plotLayout()->setRowStretchFactor(Gain, 3.0);
    plot().plotLayout()->setRowStretchFactor(Phase, 3.0);
    // The numbers of all three stand below it, however low the picture is.
    m_rects[Coherence]->setMinimumSize(0, kLeast);
    m_rects[Coherence]->setMaximumSize(QWIDGETSIZE_MAX, kLowest);
    m_rects[Coherence]->axis(QCPAxis::atLeft)->setTicker(m_coherences);
    dress();
    showCurves({}, {});
}

void BodePlot::dress()
{
    KeyedPlot::dress();
    for (QCPAxisRect *rect : m_rects)
        for (QCPAxis *axis : rect->axes())
            dressAxis(*axis, palette().color(QPalette::Text), font());
}

void BodePlot::showCurves(const QVector<BodeCurve> &curves, const QString &unit)
{
    m_curves = curves;
    m_unit = unit;
    const bool none = std::all_of(m_curves.begin(), m_curves.end(),
        [](const BodeCurve &curve) { return curve.points.isEmpty(); });
    say(none ? tr("No response yet.") : QString());
    draw();
}

void BodePlot::drawCurve(const BodeCurve &curve, bool dark)
{
    const QColor color = traceColor(curve.slot, dark);
    struct Line {
        QVector<double> hz, value;
    };
    std::array<Line, kParts> whole, sure, unsure;
    std::array<QVector<double>, kParts> below, above;
    const auto add = [](Line &line, double hz, double value) {
        line.hz.append(hz);
        line.value.append(value);
    };
    double last_hz = 0.0;
    for (const BodeCurve::Point &point : curve.points) {
        const std::array values{point.gain_db, point.phase_deg, point.coherence};
        for (std::size_t part = 0; part < kParts; ++part) {
            if (last_hz > 0.0 && point.hz > kWidest * last_hz)
                add(whole[part], (last_hz + point.hz) / 2, std::nan(""));
            add(whole[part], point.hz, values[part]);
            add((point.coherence >= kLeastCoherence ? sure : unsure)[part], point.hz, values[part]);
        }
        below[Gain].append(point.gain_db - point.low_db);
        above[Gain].append(point.high_db - point.gain_db);
        below[Phase].append(point.phaseHalf_deg);
        above[Phase].append(point.phaseHalf_deg);
        last_hz = point.hz;
    }
    for (std::size_t part = 0; part < kParts; ++part) {
        if (part == Coherence && !curve.measured)
            continue;
        const auto graph = [&](const Line &line) {
            QCPGraph *made = plot().addGraph(
                m_rects[part]->axis(QCPAxis::atBottom), m_rects[part]->axis(QCPAxis::atLeft));
            made->setPen(QPen(color, 0, curve.measured ? Qt::SolidLine : Qt::DashLine));
            made->setData(line.hz, line.value, true);
            return made;
        };
        graph(whole[part]);
        if (!curve.measured)
            continue;
        for (const bool hollow : {false, true}) {
            QCPGraph *dots = graph(hollow ? unsure[part] : sure[part]);
            dots->setLineStyle(QCPGraph::lsNone);
            dots->setScatterStyle({QCPScatterStyle::ssCircle, QPen(color, 1.0),
                hollow ? QBrush(palette().color(QPalette::Base)) : QBrush(color), kDot});
        }
        if (part == Coherence)
            continue;
        QCPGraph *points = graph(Line());
        QVector<double> hz, value;
        for (const BodeCurve::Point &point : curve.points) {
            hz.append(point.hz);
            value.append(part == Gain ? point.gain_db : point.phase_deg);
        }
        points->setData(hz, value, true);
        points->setLineStyle(QCPGraph::lsNone);
        auto *bars = new QCPErrorBars(points->keyAxis(), points->valueAxis());
        bars->setDataPlottable(points);
        bars->setPen(QPen(color, 0));
        bars->setWhiskerWidth(kDot - 1.0);
        bars->setSymbolGap(kDot);
        bars->setData(below[part], above[part]);
    }
}

void BodePlot::scale()
{
    Ends hz, gain, phase;
    for (const BodeCurve &curve : m_curves)
        for (const BodeCurve::Point &point : curve.points) {
            hz.accept(point.hz);
            gain.accept(point.gain_db);
            phase.accept(point.phase_deg);
        }
    if (hz.most < hz.least) {
        hz = {1.0, 100.0};
        gain = {-20.0, 20.0};
        phase = {-180.0, 0.0};
    }
    constexpr double kRoom = 1.1, kRoom_db = 4.0, kRoom_deg = 15.0;
    const bool all = !(m_to_hz > m_from_hz);
    for (QCPAxisRect *rect : m_rects)
        rect->axis(QCPAxis::atBottom)
            ->setRange(all ? hz.least / kRoom : m_from_hz, all ? hz.most * kRoom : m_to_hz);
    m_rects[Gain]->axis(QCPAxis::atLeft)->setRange(gain.range(kRoom_db));
    m_rects[Phase]->axis(QCPAxis::atLeft)->setRange(phase.range(kRoom_deg));
    m_rects[Coherence]->axis(QCPAxis::atLeft)->setRange(0.0, 1.05);
}

void BodePlot::draw()
{
    const QScopedValueRollback setting(m_setting, true);
    plot().clearPlottables();
    plot().clearItems();
    const bool dark = isDark(palette());
    for (const BodeCurve &curve : m_curves)
        drawCurve(curve, dark);
    scale();
    const auto label = [this](Part part, const QString &text) {
        QCPAxis *axis = m_rects[part]->axis(QCPAxis::atLeft);
        axis->setLabel(text);
        axis->ticker()->setTickCount(std::clamp(height() / int(kParts) / kEachTick, 1, 6));
    };
    label(Gain, m_unit.isEmpty() ? tr("dB") : tr("dB of %1", "a unit").arg(m_unit));
    label(Phase, QStringLiteral("\u00b0"));
    label(Coherence, tr("Coh.", "coherence, short"));
    m_coherences->setTickStep(height() < kLow ? 1.0 : 0.5);
    m_rects[Coherence]->axis(QCPAxis::atBottom)->setLabel(tr("Hz"));
    plot().replot(QCustomPlot::rpQueuedReplot);
}

void BodePlot::fit()
{
    m_from_hz = m_to_hz = 0.0;
    draw();
}

/// The mouse moved an axis.
void BodePlot::bound(const QCPRange &range)
{
    if (!m_setting && !m_curves.isEmpty())
        setLimits(range.lower, range.upper);
}

void BodePlot::setLimits(double least, double most)
{
    constexpr double kNarrowest = 1.2;
    if (!(most >= kNarrowest * least))
        return draw();
    m_from_hz = std::clamp(least, kLeast_hz, kMost_hz / kNarrowest);
    m_to_hz = std::clamp(most, kNarrowest * m_from_hz, kMost_hz);
    draw();
}

void BodePlot::zoom(double factor)
{
    const QCPRange shown = m_rects[Gain]->axis(QCPAxis::atBottom)->range();
    const double middle = std::sqrt(shown.lower * shown.upper);
    const double half = std::pow(shown.upper / shown.lower, 0.5 / factor);
    setLimits(middle / half, middle * half);
}

void BodePlot::pan(double share)
{
    const QCPRange shown = m_rects[Gain]->axis(QCPAxis::atBottom)->range();
    const double by = std::pow(shown.upper / shown.lower, share);
    setLimits(shown.lower * by, shown.upper * by);
}

} // namespace widgets
