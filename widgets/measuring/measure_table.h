// The automatic measurements of the scope as a table: one a row, its value in the picture or between the cursors, and
// statistics over the records of the trigger. Computes nothing itself; core/scope does.
#pragma once

#include "capture/capture.h"
#include "scope/statistics.h"
#include "widgets/measuring/measure_text.h"
#include "widgets/scope/drawing/marks.h"

#include <QAbstractTableModel>

namespace widgets {

class ScopeView;

class MeasureTable : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column {
        SignalColumn,
        QuantityColumn,
        ValueColumn,
        MeanColumn,
        SigmaColumn,
        MinColumn,
        MaxColumn,
        CountColumn,
        kColumns
    };
    static constexpr int kMost = kMostMeasures;
    /// More samples than this in the range are not read: a picture of an hour must not hold up the window.
    static constexpr std::uint64_t kMostSamples = 2'000'000;
    /// Once so many were read, the other rows wait for the next time.
    static constexpr std::uint64_t kSamplesAtOnce = 1'000'000;

    struct Wanted {
        catalog::RegisterId registerId = 0;
        capture::ChannelInfo::Kind kind = capture::ChannelInfo::Kind::Fast;
        scope::Quantity quantity = scope::Quantity::Mean;
        /// Phase only: the second trace.
        std::optional<catalog::RegisterId> against;
    };

    MeasureTable(
        const ScopeView &scope, const capture::Capture &capture, QObject *parent = nullptr);

    bool add(const Wanted &wanted); ///< false if it is there already, or there are kMost
    void remove(int row);
    NamedMeasure named(int row) const;
    void clearStatistics();
    /// Measures in [from, to): everything, or where that is long the next rows in turn.
    void measure(double from, double to);
    /// Counts a record of the trigger in the statistics of every row, with what lies in [from, to) of it; what is
    /// written as the value stays.
    void count(capture::Nanos from, capture::Nanos to, capture::Nanos trigger);
    MeasureMarks marks(int row) const; ///< what that row measured; empty if it did not

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        Wanted wanted;
        NamedMeasure named;
        scope::Measurement result;
        scope::Statistics statistics;
        bool tooLong = false;
    };
    const capture::Channel *channelOf(const Wanted &wanted) const;
    const capture::Channel *secondOf(const Wanted &wanted) const;
    struct Measured {
        scope::Measurement result;
        bool tooLong = false;
        std::uint64_t read = 0; ///< samples
    };
    Measured measured(const Wanted &wanted, capture::Nanos from, capture::Nanos to,
        std::optional<capture::Nanos> trigger) const;
    QString valueText(const Row &row) const;
    QString numberOf(const Row &row, std::optional<double> value) const;

    const ScopeView &m_scope;
    const capture::Capture &m_capture;
    std::vector<Row> m_rows;
    std::size_t m_next = 0; ///< whose turn it is
};

} // namespace widgets
