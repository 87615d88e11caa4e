#include "widgets/lab/step_runs.h"

#include "widgets/base/look/section_head.h"
#include "widgets/base/si_text.h"
#include "widgets/base/value_text.h"
#include "widgets/lab/run_mark.h"
#include "widgets/lab/text.h"

#include <QGuiApplication>
#include <QStringList>

#include <algorithm>
#include <array>

namespace widgets {
namespace {

constexpr int kMarkHeight = 14; ///< pixels
const QChar kMinus(0x2212), kNarrow(0x202f);
const QString kPlusMinus = QStringLiteral(" \u00b1 ");

/// What a column shows of a series, and of one of its runs.
struct Metric {
    std::optional<lab::Estimate> lab::StepSeries::*mean;
    std::optional<double> lab::StepRun::*run;
    double factor;
    int decimals;
    const char *unit;
};
constexpr std::array<Metric, 4> kMetrics{{
    {&lab::StepSeries::rise_s, &lab::StepRun::rise_s, kMilli, 1, "ms"},
    {&lab::StepSeries::overshoot_pct, &lab::StepRun::overshoot_pct, 1.0, 1, "%"},
    {&lab::StepSeries::settling_s, &lab::StepRun::settling_s, kMilli, 0, "ms"},
    {&lab::StepSeries::peakIq_a, &lab::StepRun::peakIq_a, 1.0, 2, "A"},
}};

const Metric *shownIn(int column)
{
    const int at = column - StepRuns::RiseColumn;
    return at >= 0 && at < int(kMetrics.size()) ? &kMetrics[std::size_t(at)] : nullptr;
}

/// Currents follow some thirty times as fast as speeds.
int decimalsOf(const Metric &metric, const StepResult &result)
{
    return metric.decimals + (result.current && metric.factor == kMilli ? 1 : 0);
}

QString signedText(double value, int decimals)
{
    QString text = numberText(std::abs(value), decimals);
    const bool zero = text == numberText(0.0, decimals);
    return zero ? QStringLiteral("\u00b1") + text
                : (value < 0.0 ? QString(kMinus) : QStringLiteral("+")) + text;
}

/// To either side, of what was told from values that were polled; 0: it was recorded.
double errorOf(const lab::StepRun &run, int column)
{
    const bool settling = column == StepRuns::SettlingColumn && run.pollDistance_s > 0.0;
    return column == StepRuns::RiseColumn ? run.pollDistance_s
        : settling                        ? run.instantError_s.value_or(0.0)
                                          : 0.0;
}

/// With how many were held to their end, which are fewer than planned where the series ended early.
QString stepText(const StepResult &result)
{
    const lab::StepSeries &series = result.series;
    const auto held = [&series](bool up) {
        return QString::number(std::ranges::count_if(
            series.runs, [up](const lab::StepRun &run) { return run.up == up && !run.cut; }));
    };
    const QString up = held(true), down = held(false);
    const auto number = [](int rpm) {
        return QString::number(rpm).replace(QLatin1Char('-'), kMinus);
    };
    const auto amps = [](double value) {
        return numberText(value, 2).replace(QLatin1Char('-'), kMinus);
    };
    const auto &current = result.current;
    const QString ends = result.position ? StepRuns::kindText(result.kind()) + QLatin1Char(' ')
            + amps(result.position->byDegrees) + QChar(0xb0)
        : current
        ? StepRuns::kindText(result.kind()) + QLatin1Char(' ')
            + QStringLiteral("%1 \u2192 %2").arg(amps(current->fromAmps), amps(current->toAmps))
            + kNarrow + QLatin1Char('A')
        : QStringLiteral("%1 \u2192 %2").arg(number(series.plan.fromRpm), number(series.plan.toRpm))
            + kNarrow + StepRuns::tr("rpm");
    return ends + QStringLiteral(", ")
        + (up == down
                ? up + QChar(0x00d7)
                : StepRuns::tr("%1\u00d7 up, %2\u00d7 down", "numbers of steps").arg(up, down));
}

/// Another step is no other tuning of this one.
bool isSameStep(const StepResult &one, const StepResult &other)
{
    if (one.kind() != other.kind())
        return false;
    if (one.position)
        return one.position->byDegrees == other.position->byDegrees
            && one.position->ramp == other.position->ramp;
    if (one.current)
        return one.current->fromAmps == other.current->fromAmps
            && one.current->toAmps == other.current->toAmps;
    return one.series.plan.fromRpm == other.series.plan.fromRpm
        && one.series.plan.toRpm == other.series.plan.toRpm;
}

} // namespace

QString StepRuns::kindText(StepKind kind)
{
    return kind == StepKind::Torque  ? tr("Torque")
        : kind == StepKind::Flux     ? tr("Flux")
        : kind == StepKind::Position ? tr("Position")
                                     : tr("Speed");
}

StepRuns::StepRuns(QObject *parent)
    : RowTable(parent,
        {tr("Run"), tr("Kp"), tr("Ki"), tr("Rise"), tr("Overshoot"), tr("Settling"), tr("Peak Iq"),
            tr("Bus"), tr("Step")})
{
}

void StepRuns::add(StepResult result)
{
    if (rowCount() >= kMost)
        remove(reference() == 0 ? 1 : 0);
    result.number = ++m_last;
    beginInsertRows({}, rowCount(), rowCount());
    m_results.push_back(std::move(result));
    endInsertRows();
    if (reference() < 0)
        setReference(rowCount() - 1);
    Q_EMIT changed();
}

void StepRuns::remove(int row)
{
    if (row < 0 || row >= rowCount())
        return;
    const bool was = row == reference();
    beginRemoveRows({}, row, row);
    m_results.erase(m_results.begin() + row);
    endRemoveRows();
    if (was)
        setReference(0);
    Q_EMIT changed();
}

int StepRuns::reference() const
{
    const auto at = std::find_if(m_results.begin(), m_results.end(),
        [this](const StepResult &result) { return result.number == m_reference; });
    return at == m_results.end() ? -1 : static_cast<int>(at - m_results.begin());
}

void StepRuns::setReference(int row)
{
    m_reference = row >= 0 && row < rowCount() ? m_results[std::size_t(row)].number : 0;
    cellsChanged();
    Q_EMIT changed();
}

void StepRuns::setDark(bool dark)
{
    m_dark = dark;
    cellsChanged(RunColumn, RunColumn);
}

/// The mean of a series, with half of the interval where it is known, and the difference to the reference where that is
/// of the same step.
QString StepRuns::number(const StepResult &result, int column) const
{
    const Metric *shown = shownIn(column);
    const auto &mean = result.series.*(shown->mean);
    if (!mean)
        return QStringLiteral("\u2013");
    const int decimals = decimalsOf(*shown, result);
    QString text = numberText(mean->value * shown->factor, decimals);
    if (mean->low)
        text += kPlusMinus + numberText((mean->value - *mean->low) * shown->factor, decimals);
    text += kNarrow + QLatin1String(shown->unit);
    const int row = reference();
    if (row < 0 || result.number == m_reference)
        return text;
    const StepResult &with = m_results[std::size_t(row)];
    const auto &other = with.series.*(shown->mean);
    if (!other || !isSameStep(with, result))
        return text;
    return text
        + QStringLiteral("  (%1)").arg(
            signedText((mean->value - other->value) * shown->factor, decimals));
}

QString StepRuns::text(const StepResult &result, int column) const
{
    switch (column) {
    case RunColumn:
        return result.number == m_reference
            ? tr("%1, ref.", "number of the run that others are compared with")
                  .arg(QString::number(result.number))
            : QString::number(result.number);
    case StepColumn:
        return stepText(result);
    case KpColumn:
        return result.kp;
    case KiColumn:
        return result.ki;
    case BusColumn:
        return result.bus_v
            ? tr("%1 to %2", "least and greatest voltage")
                    .arg(numberText(result.bus_v->first, 0), numberText(result.bus_v->second, 0))
                + kNarrow + QLatin1Char('V')
            : QStringLiteral("\u2013");
    default:
        return number(result, column);
    }
}

/// Every step of the series, and what has to be known of its numbers.
QString StepRuns::tip(const StepResult &result) const
{
    QStringList lines;
    int count = 0;
    for (const lab::StepRun &run : result.series.runs) {
        QStringList values;
        for (int column = RiseColumn; column <= PeakColumn; ++column) {
            const Metric &shown = *shownIn(column);
            const int decimals = decimalsOf(shown, result);
            const auto &value = run.*(shown.run);
            const double error = errorOf(run, column);
            QString text = QStringLiteral("\u2013");
            if (value)
                text = numberText(*value * shown.factor, decimals)
                    + (error > 0.0 ? kPlusMinus + numberText(error * shown.factor, decimals)
                                   : QString())
                    + kNarrow + QLatin1String(shown.unit);
            values.append(headerData(column, Qt::Horizontal, Qt::DisplayRole).toString()
                + QLatin1Char(' ') + text);
        }
        lines.append((run.up ? tr("Step %1, up: %2", "number, what was measured")
                             : tr("Step %1, down: %2", "number, what was measured"))
                         .arg(QString::number(++count), values.join(QStringLiteral(", "))));
    }
    lines += labSentences(result.series.notes);
    constexpr qsizetype kMostLines = 24;
    if (lines.size() > kMostLines)
        lines = lines.mid(0, kMostLines) << QStringLiteral("\u2026");
    return QStringLiteral("<p style='white-space:pre'>%1</p>")
        .arg(lines.join(QLatin1Char('\n')).toHtmlEscaped());
}

QVariant StepRuns::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const StepResult &result = m_results[std::size_t(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return text(result, index.column());
    case Qt::ToolTipRole:
        return tip(result);
    case Qt::DecorationRole:
        return index.column() == RunColumn
            ? runMark(result.number, m_dark, kMarkHeight, qGuiApp->devicePixelRatio())
            : QVariant();
    case Qt::AccessibleTextRole:
        return index.column() == RunColumn
            ? text(result, RunColumn) + QStringLiteral(", ") + runTickName(result.number)
            : text(result, index.column());
    case Qt::FontRole:
        return index.column() == RunColumn && result.number == m_reference ? inBold({})
                                                                           : QVariant();
    default:
        return {};
    }
}

} // namespace widgets
