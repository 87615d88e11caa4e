#include "widgets/lab/step_overlay.h"

#include "widgets/base/si_text.h"
#include "widgets/base/trace_colors.h"
#include "widgets/lab/run_mark.h"
#include "widgets/scope/drawing/axis_ticker.h"

#include <QScopedValueRollback>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace widgets {
namespace {

constexpr double kLeastShown_s = 0.01; ///< that the axis shows
constexpr int kTicks = 6; ///< of a curve
constexpr double kRoom = 0.08; ///< of what is drawn, above and below
constexpr double kLeastRoom_rpm = 1.0, kLeastRoom_a = 0.01, kLeastRoom_deg = 0.1;

} // namespace

StepOverlay::StepOverlay(QWidget *parent)
    : KeyedPlot(QStringLiteral("stepOverlay"), tr("Steps over one another"), parent)
{
    for (QCPAxis *axis : {plot().xAxis, plot().yAxis})
        axis->setTicker(QSharedPointer<AxisTicker>::create(AxisTicker::Labels::Values));
    plot().setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    plot().axisRect()->setRangeDrag(Qt::Horizontal);
    plot().axisRect()->setRangeZoom(Qt::Horizontal);
    plot().xAxis->setLabel(tr("Time since the step [ms]"));
    plot().yAxis->setLabel(tr("Speed [rpm]"));
    connect(plot().xAxis, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), this,
        &StepOverlay::bound);
    dress();
    say(tr("No step yet."));
    draw();
}

void StepOverlay::showSteps(const std::vector<StepResult> &results, bool up, StepKind kind)
{
    if (std::exchange(m_kind, kind) != kind)
        m_from_s = m_to_s = 0.0;
    plot().yAxis->setLabel(kind == StepKind::Torque ? tr("Iq [A]")
            : kind == StepKind::Flux                ? tr("Id [A]")
            : kind == StepKind::Position            ? tr("Position [\u00b0]")
                                                    : tr("Speed [rpm]"));
    m_curves.clear();
    m_least_s = 0.0;
    m_most_s = kLeastShown_s;
    bool missing = false;
    for (const StepResult &result : results)
        for (const StepCurve &curve : result.curves) {
            if (curve.up != up || result.kind() != kind)
                continue;
            missing = missing || curve.seconds.isEmpty();
            if (curve.seconds.isEmpty())
                continue;
            m_least_s = std::min(m_least_s, curve.seconds.first());
            m_most_s = std::max(m_most_s, curve.seconds.last());
            m_curves.push_back({result.number, curve});
        }
    say(!m_curves.empty() ? QString()
            : missing     ? tr("Not drawn: samples are missing.")
                          : tr("No step yet."));
    if (m_to_s > m_most_s)
        m_from_s = m_to_s = 0.0;
    draw();
}

int StepOverlay::curves() const { return static_cast<int>(m_curves.size()); }

void StepOverlay::fit()
{
    m_from_s = m_to_s = 0.0;
    draw();
}

/// The line, in pieces where samples are missing, and its ticks apart from it: they are where those of other series are
/// not.
void StepOverlay::drawCurve(const Drawn &drawn, bool dark)
{
    const QColor color = runColor(drawn.number, dark);
    QVector<double> times;
    for (const double seconds : drawn.curve.seconds)
        times.append(seconds * kMilli);
    QVector<qsizetype> ends = drawn.curve.gaps;
    ends.append(times.size());
    qsizetype piece = 0;
    for (const qsizetype end : std::as_const(ends)) {
        QCPGraph *line = plot().addGraph();
        line->setPen(QPen(color, 0));
        line->setAntialiased(false);
        line->setData(
            times.mid(piece, end - piece), drawn.curve.values.mid(piece, end - piece), true);
        piece = end;
    }
    QCPGraph *ticks = plot().addGraph();
    ticks->setLineStyle(QCPGraph::lsNone);
    ticks->setScatterStyle(runTick(drawn.number, color));
    const double from = plot().xAxis->range().lower, each = plot().xAxis->range().size() / kTicks;
    const double first = from + each * std::fmod(0.3 + 0.37 * drawn.number, 1.0);
    for (int i = 0; i < kTicks; ++i) {
        const auto at = std::lower_bound(times.begin(), times.end(), first + i * each);
        if (at != times.end())
            ticks->addData(*at, drawn.curve.values[at - times.begin()]);
    }
}

void StepOverlay::draw()
{
    const QScopedValueRollback setting(m_setting, true);
    const bool all = !(m_to_s > m_from_s), dark = isDark(palette());
    plot().xAxis->setRange(
        kMilli * (all ? m_least_s : m_from_s), kMilli * (all ? m_most_s : m_to_s));
    plot().clearPlottables();
    double least = 0.0, most = 1.0;
    bool any = false;
    for (const Drawn &drawn : m_curves) {
        const auto [low, high] =
            std::minmax_element(drawn.curve.values.begin(), drawn.curve.values.end());
        least = any ? std::min(least, *low) : *low;
        most = any ? std::max(most, *high) : *high;
        any = true;
        drawCurve(drawn, dark);
    }
    const double leastRoom = m_kind == StepKind::Speed ? kLeastRoom_rpm
        : m_kind == StepKind::Position                 ? kLeastRoom_deg
                                                       : kLeastRoom_a;
    const double room = std::max(leastRoom, kRoom * (most - least));
    plot().yAxis->setRange(least - room, most + room);
    const auto ticks = [](QCPAxis *axis, int pixels, int each, int close) {
        axis->ticker().dynamicCast<AxisTicker>()->setMost(
            std::max(2, pixels / each), pixels, pixels / close);
    };
    ticks(plot().xAxis, plot().axisRect()->width(), 80, 60);
    ticks(plot().yAxis, plot().axisRect()->height(), 30, 18);
    plot().replot(QCustomPlot::rpQueuedReplot);
}

/// The mouse moved the axis.
void StepOverlay::bound(const QCPRange &range)
{
    if (!m_setting && !m_curves.empty())
        setLimits(range.lower / kMilli, range.upper / kMilli);
}

void StepOverlay::setLimits(double least, double most)
{
    const double whole = m_most_s - m_least_s;
    const double width = std::clamp(most - least, std::min(kLeastShown_s, whole), whole);
    m_from_s = std::clamp((least + most - width) / 2, m_least_s, m_most_s - width);
    m_to_s = m_from_s + width;
    draw();
}

void StepOverlay::zoom(double factor)
{
    const QCPRange shown = plot().xAxis->range();
    const double half = shown.size() / 2 / factor;
    setLimits((shown.center() - half) / kMilli, (shown.center() + half) / kMilli);
}

void StepOverlay::pan(double share)
{
    const QCPRange shown = plot().xAxis->range();
    const double shift = share * shown.size();
    setLimits((shown.lower + shift) / kMilli, (shown.upper + shift) / kMilli);
}

} // namespace widgets
