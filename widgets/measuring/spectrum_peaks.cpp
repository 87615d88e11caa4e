#include "widgets/measuring/spectrum_peaks.h"

#include "widgets/base/si_text.h"
#include "widgets/base/value_text.h"

#include <cmath>

namespace widgets {

QString decibelText(double decibel)
{
    return numberText(decibel, 1).replace(QLatin1Char('-'), QChar(0x2212)) + QChar(QChar::Nbsp)
        + QStringLiteral("dB");
}

SpectrumPeaks::SpectrumPeaks(QObject *parent)
    : RowTable(parent,
        {QStringLiteral("#"), tr("Frequency"),
            tr("Order", "a multiple of the electrical frequency"), tr("Amplitude"),
            tr("Relative", "a peak compared with the largest one, in decibels")})
{
}

void SpectrumPeaks::show(
    std::vector<scope::SpectrumPeak> peaks, const QString &unit, scope::OrderAxis orders)
{
    const int before = rowCount();
    const int now = static_cast<int>(peaks.size());
    m_unit = unit;
    m_orders = orders;
    if (now < before) { // the rows that stay keep their selection
        beginRemoveRows({}, now, before - 1);
        m_peaks = std::move(peaks);
        endRemoveRows();
    } else if (now > before) {
        beginInsertRows({}, before, now - 1);
        m_peaks = std::move(peaks);
        endInsertRows();
    } else {
        m_peaks = std::move(peaks);
    }
    cellsChanged();
}

QVariant SpectrumPeaks::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const scope::SpectrumPeak &peak = m_peaks[std::size_t(index.row())];
    switch (index.column()) {
    case NumberColumn:
        return QString::number(index.row() + 1);
    case FrequencyColumn:
        return siText(peak.hertz, QStringLiteral("Hz"));
    case OrderColumn:
        return m_orders.valid() ? numberText(m_orders.order(peak.hertz), 2)
                                : QStringLiteral("\u2013");
    case AmplitudeColumn:
        return siText(peak.amplitude, m_unit);
    case RelativeColumn:
        return decibelText(20.0 * std::log10(peak.amplitude / m_peaks.front().amplitude));
    default:
        return {};
    }
}

} // namespace widgets
