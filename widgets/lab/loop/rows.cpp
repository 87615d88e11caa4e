#include "widgets/lab/loop/rows.h"

#include "widgets/base/device_text.h"
#include "widgets/base/si_text.h"
#include "widgets/base/trace_colors.h"
#include "widgets/base/value_text.h"

#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <cstring>

namespace widgets {
namespace {

constexpr int kMark = 12; ///< pixels
const QString kNone = QStringLiteral("\u2013");

/// A value, and half of its interval.
QString estimateText(const std::optional<lab::Estimate> &estimate, double factor, int decimals,
    const QString &unit = {})
{
    if (!estimate)
        return kNone;
    QString text = numberText(estimate->value * factor, decimals);
    if (estimate->low && estimate->high)
        text += QStringLiteral(" \u00b1 ")
            + numberText((*estimate->high - *estimate->low) / 2 * factor, decimals);
    return unit.isEmpty() ? text : text + QChar(0x202f) + unit;
}

} // namespace

LoopRows::LoopRows(QObject *parent)
    : RowTable(parent,
        {tr("Loop"), tr("Kp"), tr("Ki"), tr("Crossover"), tr("Phase margin"), tr("Ms"), tr("Rise"),
            tr("Overshoot")})
{
}

void LoopRows::show(std::vector<LoopRow> rows)
{
    replace(m_rows, std::move(rows),
        [](const LoopRow &a, const LoopRow &b) { return std::strcmp(a.key, b.key) == 0; });
}

int LoopRows::rowOf(const char *key) const
{
    const auto at = std::find_if(m_rows.begin(), m_rows.end(),
        [key](const LoopRow &row) { return std::strcmp(row.key, key) == 0; });
    return at == m_rows.end() ? -1 : static_cast<int>(at - m_rows.begin());
}

void LoopRows::setDark(bool dark)
{
    m_dark = dark;
    if (!m_rows.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, 0), {Qt::DecorationRole});
}

QString LoopRows::text(const LoopRow &row, int column) const
{
    switch (column) {
    case NameColumn:
        return row.name;
    case KpColumn:
        return row.kp ? QString::number(*row.kp) : kNone;
    case KiColumn:
        return row.ki ? QString::number(*row.ki) : kNone;
    case CrossoverColumn:
        return estimateText(row.crossover_hz, 1.0, 1, QStringLiteral("Hz"));
    case MarginColumn:
        return estimateText(row.phaseMargin_deg, 1.0, 0, QStringLiteral("\u00b0"));
    case MsColumn:
        return estimateText(row.ms, 1.0, 2);
    case RiseColumn:
        return estimateText(row.rise_s, kMilli, 1, QStringLiteral("ms"));
    case OvershootColumn:
        return estimateText(row.overshoot_pct, 1.0, 1, QStringLiteral("%"));
    default:
        return {};
    }
}

QVariant LoopRows::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const LoopRow &row = m_rows[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole)
        return text(row, index.column());
    if (role == Qt::ToolTipRole && !row.help.isEmpty())
        return plainToolTip(row.help);
    if (role == Qt::DecorationRole && index.column() == NameColumn) {
        QPixmap mark(kMark, kMark);
        mark.fill(Qt::transparent);
        QPainter painter(&mark);
        if (row.drawn)
            painter.fillRect(2, 2, kMark - 4, kMark - 4, traceColor(row.slot, m_dark));
        return mark;
    }
    return {};
}

} // namespace widgets
