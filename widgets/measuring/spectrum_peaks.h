// The peaks of a spectrum as a table, largest first: frequency, order, amplitude, and how far below the largest.
#pragma once

#include "scope/spectrum.h"
#include "widgets/base/row_table.h"

#include <QLocale>

namespace widgets {

class SpectrumPeaks : public RowTable {
    Q_OBJECT
public:
    enum Column {
        NumberColumn, ///< by which the picture names it
        FrequencyColumn,
        OrderColumn,
        AmplitudeColumn,
        RelativeColumn,
        kColumns
    };

    explicit SpectrumPeaks(QObject *parent = nullptr);

    /// @param orders  not valid: there are none to be told
    void show(std::vector<scope::SpectrumPeak> peaks, const QString &unit, scope::OrderAxis orders);
    const std::vector<scope::SpectrumPeak> &peaks() const { return m_peaks; }

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

private:
    std::size_t rowsHeld() const override { return m_peaks.size(); }

    std::vector<scope::SpectrumPeak> m_peaks;
    QString m_unit;
    scope::OrderAxis m_orders;
};

/// A level in decibels to a tenth, with a minus sign of its own.
QString decibelText(double decibel);

} // namespace widgets
