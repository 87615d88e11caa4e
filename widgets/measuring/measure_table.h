// The automatic measurements of the scope as a table: one a row, its value in the picture or between the cursors, and
// statistics over the records of the trigger. Computes nothing itself; core/scope does, and where that takes long
// another thread: one job for the picture at a time, and the records one after the other, of which none is left out.
#pragma once

#include "scope/measurement.h"
#include "widgets/base/row_table.h"
#include "widgets/measuring/job_rest.h"
#include "widgets/measuring/measure_job.h"
#include "widgets/measuring/measure_text.h"
#include "widgets/scope/drawing/marks.h"

#include <QThreadPool>

#include <atomic>

namespace widgets {

class ScopeView;

class MeasureTable : public RowTable {
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
    /// More samples than this in the range are not read: some of it takes a second then.
    static constexpr std::uint64_t kMostSamples = 100'000'000;
    /// What reads more than this, of all rows together, is done in another thread.
    static constexpr std::uint64_t kSamplesAtOnce = 100'000;

    struct Wanted {
        catalog::RegisterId registerId = 0;
        capture::ChannelInfo::Kind kind = capture::ChannelInfo::Kind::Fast;
        scope::Quantity quantity = scope::Quantity::Mean;
        /// Phase only: the second trace.
        std::optional<catalog::RegisterId> against;
    };

    MeasureTable(
        const ScopeView &scope, const capture::Capture &capture, QObject *parent = nullptr);
    ~MeasureTable() override;

    bool add(const Wanted &wanted); ///< false if it is there already, or there are kMost
    void remove(int row);
    NamedMeasure named(int row) const;
    void clearStatistics();
    /// Measures in [from, to). Where that is long the values follow; until they have, and for a while after, further
    /// calls for something long do nothing.
    void measure(double from, double to);
    /// Counts a record of the trigger in the statistics of every row, with what lies in [from, to) of it; what is
    /// written as the value stays. A long one is counted later.
    void count(capture::Nanos from, capture::Nanos to, capture::Nanos trigger);
    MeasureMarks marks(int row) const; ///< what that row measured; empty if it did not

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        std::uint64_t id = 0;
        Wanted wanted;
        NamedMeasure named;
        scope::Measurement result;
        scope::Statistics statistics;
        bool tooLong = false;
    };
    std::size_t rowsHeld() const override { return m_rows.size(); }
    const capture::Channel *channelOf(const Wanted &wanted) const;
    const capture::Channel *secondOf(const Wanted &wanted) const;
    /// What is there to be done for all rows, and the samples that it reads; without rows that would read too many.
    MeasureJob jobFor(capture::Nanos from, capture::Nanos to, std::optional<capture::Nanos> trigger,
        std::uint64_t &cost) const;
    using Results = std::vector<MeasureJob::Result>;
    /// What a long one was asked for: the same again would find the same.
    struct Asked {
        capture::Nanos from = 0;
        capture::Nanos to = 0;
        std::optional<capture::Nanos> trigger;
        std::uint64_t cost = 0; ///< more samples are another picture
        std::vector<std::pair<std::uint64_t, capture::ChannelId>> rows;
        bool operator==(const Asked &) const = default;
    };
    void measureLong(MeasureJob job, std::uint64_t cost);
    void inThread(
        MeasureJob job, std::function<bool()> goesOn, std::function<void(const Results &)> take);
    void show(const Results &results);
    void add(const Results &results); ///< to the statistics
    Row *find(std::uint64_t id);
    QString valueText(const Row &row) const;
    QString numberOf(const Row &row, std::optional<double> value) const;

    const ScopeView &m_scope;
    const capture::Capture &m_capture;
    std::vector<Row> m_rows;
    std::uint64_t m_lastId = 0;
    std::atomic<int> m_asked = 0; ///< times that a picture was: an older answer is of no use
    std::atomic<int> m_cleared = 0; ///< times that the statistics were
    Asked m_answered;
    JobRest m_rest; ///< of long pictures
    std::atomic<bool> m_leaving = false;
    QThreadPool m_pool; // last: its jobs end before anything that they tell
};

} // namespace widgets
