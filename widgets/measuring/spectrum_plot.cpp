#include "widgets/measuring/spectrum_plot.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/base/trace_colors.h"
#include "widgets/scope/drawing/axis_ticker.h"

#include <QScopedValueRollback>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {
constexpr int kSpectrumSlot = 0;
constexpr int kPeakSlot = 1;
constexpr int kMostNumbers = 10;
constexpr double kFloor = 1e-12; ///< of the unit; below it a level says nothing
constexpr double kDecibelSpan = 100.0;
constexpr double kLeastBins = 8.0; ///< that the axis shows
constexpr double kPeakRoom = 1.12; ///< above the highest line, for the numbers of the peaks
} // namespace

SpectrumPlot::SpectrumPlot(QWidget *parent)
    : KeyedPlot(QStringLiteral("spectrumPlot"), tr("Spectrum"), parent)
    , m_trace(plot().addGraph())
    , m_dots(plot().addGraph())
    , m_mark(new QCPItemStraightLine(&plot()))
{
    plot().xAxis->setTicker(QSharedPointer<AxisTicker>::create(AxisTicker::Labels::Values));
    plot().yAxis->setTicker(QSharedPointer<AxisTicker>::create(AxisTicker::Labels::Values));
    plot().setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    plot().axisRect()->setRangeDrag(Qt::Horizontal);
    plot().axisRect()->setRangeZoom(Qt::Horizontal);
    m_trace->setAntialiased(false);
    m_dots->setLineStyle(QCPGraph::lsNone);
    m_mark->setVisible(false);
    for (int i = 0; i < kMostNumbers; ++i) {
        auto *number = new QCPItemText(&plot());
        number->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
        number->setText(QString::number(i + 1));
        number->setVisible(false);
        m_numbers.append(number);
    }
    setMinimumSize(220, 120);
    connect(plot().xAxis, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), this,
        &SpectrumPlot::bound);
    dress();
    draw();
}

void SpectrumPlot::dress()
{
    const QPalette colors = palette();
    const bool dark = isDark(colors);
    const QColor text = colors.color(QPalette::Text);
    KeyedPlot::dress();
    m_trace->setPen(QPen(traceColor(kSpectrumSlot, dark), 0));
    const QColor peak = traceColor(kPeakSlot, dark);
    m_dots->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, peak, 6));
    m_mark->setPen(QPen(text, 0, Qt::DashLine));
    for (QCPItemText *number : std::as_const(m_numbers)) {
        number->setColor(text);
        number->setFont(font());
    }
}

double SpectrumPlot::highest() const
{
    const scope::Spectrum &spectrum = m_picture.spectrum;
    return spectrum.meanSquares.empty()
        ? 0.0
        : spectrum.frequency(static_cast<double>(spectrum.meanSquares.size() - 1));
}

double SpectrumPlot::from() const { return m_from; }

double SpectrumPlot::to() const { return m_to > 0.0 ? std::min(m_to, highest()) : highest(); }

int SpectrumPlot::points() const { return m_trace->dataCount(); }

double SpectrumPlot::shownX(double hertz) const
{
    return m_picture.orders.valid() ? m_picture.orders.order(hertz) : hertz;
}

double SpectrumPlot::levelOf(double amplitude) const
{
    return m_picture.decibels ? 20.0 * std::log10(std::max(amplitude, kFloor)) : amplitude;
}

double SpectrumPlot::level(std::size_t bin) const
{
    return levelOf(m_picture.spectrum.amplitude(bin));
}

void SpectrumPlot::showSpectrum(Picture picture)
{
    say({});
    m_picture = std::move(picture);
    if (m_from >= highest())
        m_from = m_to = 0.0;
    const QString unit = m_picture.unit.isEmpty() ? QStringLiteral("1") : m_picture.unit;
    plot().xAxis->setLabel(m_picture.orders.valid()
            ? tr("Order", "a multiple of the electrical frequency")
            : QStringLiteral("Hz"));
    plot().yAxis->setLabel(m_picture.decibels
            ? tr("dB re 1 %1", "level above one of the unit").arg(unit)
            : m_picture.unit);
    draw();
}

void SpectrumPlot::showNothing(const QString &why)
{
    m_picture = {};
    say(why);
    draw();
}

void SpectrumPlot::mark(int peak)
{
    m_marked = peak;
    drawPeaks();
    plot().replot(QCustomPlot::rpQueuedReplot);
}

void SpectrumPlot::fit()
{
    m_from = m_to = 0.0;
    draw();
}

void SpectrumPlot::zoom(double factor)
{
    const double middle = (from() + to()) / 2;
    const double half = (to() - from()) / 2 / factor;
    setLimits(middle - half, middle + half);
}

void SpectrumPlot::pan(double share)
{
    const double shift = share * (to() - from());
    setLimits(from() + shift, to() + shift);
}

/// The mouse moved the axis.
void SpectrumPlot::bound(const QCPRange &range)
{
    if (m_setting || m_picture.spectrum.meanSquares.empty())
        return;
    const double scale = m_picture.orders.valid() ? m_picture.orders.electricalHz : 1.0;
    setLimits(range.lower * scale, range.upper * scale);
}

/// As near to it as there are frequencies; the width stays where only the place is wrong.
void SpectrumPlot::setLimits(double least, double most)
{
    const double end = highest();
    const double width =
        std::clamp(most - least, std::min(end, kLeastBins * m_picture.spectrum.binHz), end);
    m_from = std::clamp((least + most - width) / 2, 0.0, end - width);
    m_to = m_from + width;
    draw();
}

/// Bins as they are, or the highest and the lowest of each pixel column where there are more of them.
void SpectrumPlot::draw()
{
    const QScopedValueRollback setting(m_setting, true);
    const scope::Spectrum &spectrum = m_picture.spectrum;
    QVector<double> places;
    QVector<double> levels;
    double most = m_picture.decibels ? 20.0 * std::log10(kFloor) : 0.0;
    if (!spectrum.meanSquares.empty()) {
        const std::size_t last = spectrum.meanSquares.size() - 1;
        const auto binAt = [&](double hertz) {
            return std::clamp(std::round(hertz / spectrum.binHz), 0.0, static_cast<double>(last));
        };
        const auto first = static_cast<std::size_t>(std::max(0.0, binAt(from()) - 1));
        const auto stop = std::min(last, static_cast<std::size_t>(binAt(to())) + 1) + 1;
        const auto columns = static_cast<std::size_t>(std::max(100, plot().axisRect()->width()));
        const std::size_t each = std::max<std::size_t>(1, (stop - first) / columns);
        for (std::size_t bin = first; bin < stop; bin += each) {
            // Which bins are to be drawn is decided by their squares: of the levels only two a column are computed.
            const auto begin = spectrum.meanSquares.begin() + static_cast<std::ptrdiff_t>(bin);
            const auto end = spectrum.meanSquares.begin()
                + static_cast<std::ptrdiff_t>(std::min(stop, bin + each));
            const auto [least, greatest] = std::minmax_element(begin, end);
            const double high = level(bin + static_cast<std::size_t>(greatest - begin));
            const double low = level(bin + static_cast<std::size_t>(least - begin));
            const double place = shownX(spectrum.frequency(static_cast<double>(bin)));
            places.append(place);
            levels.append(high);
            if (each > 1) {
                places.append(place);
                levels.append(low);
            }
            most = std::max(most, high);
        }
    }
    m_trace->setData(places, levels, true);
    plot().xAxis->setRange(shownX(from()), std::max(shownX(to()), shownX(from()) + 1e-9));
    if (m_picture.decibels) {
        const double top = 10.0 * std::ceil((most + 6.0) / 10.0);
        plot().yAxis->setRange(top - kDecibelSpan, top);
    } else {
        const double wanted = most > 0.0 ? most * kPeakRoom : 1.0;
        const double step = tickStep(wanted, 8); // in steps, so that it stands still
        plot().yAxis->setRange(0.0, step * std::ceil(wanted / step));
    }
    const auto ticks = [](QCPAxis *axis, int pixels, int each) {
        axis->ticker().dynamicCast<AxisTicker>()->setMost(std::max(2, pixels / each), pixels);
    };
    ticks(plot().xAxis, plot().axisRect()->width(), 80);
    ticks(plot().yAxis, plot().axisRect()->height(), 30);
    drawPeaks();
    plot().replot(QCustomPlot::rpQueuedReplot);
}

void SpectrumPlot::drawPeaks()
{
    QVector<double> places;
    QVector<double> levels;
    for (const scope::SpectrumPeak &peak : m_picture.peaks) {
        places.append(shownX(peak.hertz));
        levels.append(levelOf(peak.amplitude));
    }
    m_dots->setData(places, levels);
    // Pixels; of two that would lie on each other the smaller peak's is left out.
    std::vector<QPointF> written;
    for (int i = 0; i < int(m_numbers.size()); ++i) {
        QCPItemText *number = m_numbers[i];
        bool visible = i < int(places.size());
        if (visible) {
            number->position->setCoords(places[i], levels[i]);
            const QPointF at(
                plot().xAxis->coordToPixel(places[i]), plot().yAxis->coordToPixel(levels[i]));
            const QFontMetrics metrics(number->font());
            visible = std::none_of(written.begin(), written.end(), [&](const QPointF &other) {
                return std::abs(other.x() - at.x())
                    < metrics.horizontalAdvance(QStringLiteral("00"))
                    && std::abs(other.y() - at.y()) < metrics.height();
            });
            if (visible)
                written.push_back(at);
        }
        number->setVisible(visible);
    }
    const bool marked = m_marked >= 0 && m_marked < int(places.size());
    m_mark->setVisible(marked);
    if (marked) {
        m_mark->point1->setCoords(places[m_marked], 0.0);
        m_mark->point2->setCoords(places[m_marked], 1.0);
    }
}

} // namespace widgets
