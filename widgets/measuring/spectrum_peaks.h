// The peaks of a spectrum as a table, largest first: frequency, order, amplitude, and how far below the largest.
#pragma once

#include "scope/spectrum.h"

#include <QAbstractTableModel>
#include <QLocale>

namespace widgets {

class SpectrumPeaks : public QAbstractTableModel {
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

    using QAbstractTableModel::QAbstractTableModel;

    /// @param orders  not valid: there are none to be told
    void show(std::vector<scope::SpectrumPeak> peaks, const QString &unit, scope::OrderAxis orders);
    const std::vector<scope::SpectrumPeak> &peaks() const { return m_peaks; }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<scope::SpectrumPeak> m_peaks;
    QString m_unit;
    scope::OrderAxis m_orders;
};

/// A level in decibels to a tenth, with a minus sign of its own.
QString decibelText(double decibel);

} // namespace widgets
