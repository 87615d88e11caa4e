#include "widgets/measuring/measure_table.h"

#include "widgets/base/device_text.h"
#include "widgets/measuring/measure_text.h"
#include "widgets/scope/view.h"

#include <algorithm>
#include <utility>

namespace widgets {

MeasureTable::MeasureTable(const ScopeView &scope, const capture::Capture &capture, QObject *parent)
    : RowTable(parent,
        {tr("Trace"), tr("Measure"), tr("Value"), tr("Mean", "of a measurement over records"),
            QStringLiteral("\u03c3"), tr("Min"), tr("Max"),
            tr("Records", "number of records counted")})
    , m_scope(scope)
    , m_capture(capture)
{
    m_pool.setMaxThreadCount(1);
}

MeasureTable::~MeasureTable()
{
    m_leaving = true;
    m_pool.waitForDone();
}

bool MeasureTable::add(const Wanted &wanted)
{
    const auto same = [&wanted](const Row &row) {
        return row.wanted.registerId == wanted.registerId && row.wanted.kind == wanted.kind
            && row.wanted.quantity == wanted.quantity && row.wanted.against == wanted.against;
    };
    if (rowCount() >= kMost || std::any_of(m_rows.begin(), m_rows.end(), same))
        return false;
    Row row;
    row.id = ++m_lastId;
    row.wanted = wanted;
    row.named.quantity = wanted.quantity;
    if (const capture::Channel *channel = channelOf(wanted))
        row.named.signal = deviceText(channel->info().name);
    if (const capture::Channel *second = secondOf(wanted))
        row.named.against = deviceText(second->info().name);
    beginInsertRows({}, rowCount(), rowCount());
    m_rows.push_back(std::move(row));
    endInsertRows();
    return true;
}

void MeasureTable::remove(int row)
{
    if (row < 0 || row >= rowCount())
        return;
    beginRemoveRows({}, row, row);
    m_rows.erase(m_rows.begin() + row);
    endRemoveRows();
}

NamedMeasure MeasureTable::named(int row) const { return m_rows[std::size_t(row)].named; }

void MeasureTable::clearStatistics()
{
    ++m_cleared;
    for (Row &row : m_rows)
        row.statistics.clear();
    cellsChanged(MeanColumn);
}

const capture::Channel *MeasureTable::channelOf(const Wanted &wanted) const
{
    const auto id = m_capture.find(wanted.registerId, wanted.kind);
    return id ? m_capture.channel(*id) : nullptr;
}

const capture::Channel *MeasureTable::secondOf(const Wanted &wanted) const
{
    const auto id = wanted.against ? m_capture.find(*wanted.against) : std::nullopt;
    return id ? m_capture.channel(*id) : nullptr;
}

MeasureJob MeasureTable::jobFor(capture::Nanos from, capture::Nanos to,
    std::optional<capture::Nanos> trigger, std::uint64_t &cost) const
{
    MeasureJob job;
    job.from = from;
    job.to = to;
    job.trigger = trigger;
    cost = 0;
    for (const Row &row : m_rows) {
        const capture::Channel *channel = channelOf(row.wanted);
        const std::uint64_t own = channel ? samplesFor(row.wanted.quantity, *channel, from, to) : 0;
        if (own > kMostSamples)
            continue;
        cost += own;
        job.pieces.push_back({row.id, row.wanted.quantity, channel, secondOf(row.wanted)});
    }
    return job;
}

MeasureTable::Row *MeasureTable::find(std::uint64_t id)
{
    const auto found =
        std::find_if(m_rows.begin(), m_rows.end(), [id](const Row &row) { return row.id == id; });
    return found == m_rows.end() ? nullptr : &*found;
}

void MeasureTable::inThread(
    MeasureJob job, std::function<bool()> goesOn, std::function<void(const Results &)> take)
{
    job.detach(m_capture);
    m_pool.start([this, job = std::move(job), goesOn = std::move(goesOn), take = std::move(take)] {
        const auto results = std::make_shared<const Results>(
            job.run([this, &goesOn] { return !m_leaving && goesOn(); }));
        QMetaObject::invokeMethod(
            this, [results, take] { take(*results); }, Qt::QueuedConnection);
    });
}

void MeasureTable::measure(double from, double to)
{
    if (m_rows.empty() || !(to > from))
        return;
    const auto mark = m_scope.triggerMarks().position;
    const auto trigger = mark ? std::optional(capture::toNanos(*mark)) : std::nullopt;
    std::uint64_t cost = 0;
    MeasureJob job = jobFor(capture::toNanos(from), capture::toNanos(to), trigger, cost);
    for (Row &row : m_rows)
        row.tooLong = std::none_of(job.pieces.begin(), job.pieces.end(),
            [&row](const MeasureJob::Piece &piece) { return piece.row == row.id; });
    if (cost > kSamplesAtOnce)
        return measureLong(std::move(job), cost);
    ++m_asked;
    m_answered = {};
    show(job.run([] { return true; }));
}

void MeasureTable::measureLong(MeasureJob job, std::uint64_t cost)
{
    Asked asked{job.from, job.to, job.trigger, cost, {}};
    for (const MeasureJob::Piece &piece : job.pieces)
        asked.rows.emplace_back(piece.row, piece.channel ? piece.channel->info().id : 0);
    if (asked == m_answered || !m_rest.over(m_scope.running()))
        return;
    m_rest.begin();
    const auto newest = [this, number = ++m_asked] { return m_asked == number; };
    inThread(std::move(job), newest, [this, newest, asked](const Results &results) {
        m_rest.end();
        if (!newest())
            return;
        m_answered = asked;
        show(results);
    });
}

void MeasureTable::show(const Results &results)
{
    for (const MeasureJob::Result &result : results)
        if (Row *row = find(result.row))
            row->result = result.measured;
    cellsChanged(ValueColumn);
}

void MeasureTable::count(capture::Nanos from, capture::Nanos to, capture::Nanos trigger)
{
    if (m_rows.empty() || to <= from)
        return;
    std::uint64_t cost = 0;
    MeasureJob job = jobFor(from, to, trigger, cost);
    if (cost <= kSamplesAtOnce)
        return add(job.run([] { return true; }));
    const auto counts = [this, cleared = m_cleared.load()] { return m_cleared == cleared; };
    inThread(std::move(job), counts, [this, counts](const Results &results) {
        if (counts())
            add(results);
    });
}

void MeasureTable::add(const Results &results)
{
    for (const MeasureJob::Result &result : results)
        if (Row *row = find(result.row))
            row->statistics.add(
                result.measured.value ? std::optional(*result.measured.value) : std::nullopt);
    cellsChanged(MeanColumn);
}

MeasureMarks MeasureTable::marks(int row) const
{
    if (row < 0 || row >= rowCount())
        return {};
    const Row &one = m_rows[std::size_t(row)];
    const capture::Channel *channel = channelOf(one.wanted);
    if (!channel)
        return {};
    return {channel->info().id, one.result.levels, one.result.points,
        quantityText(one.wanted.quantity) + QLatin1Char(' ') + valueText(one)};
}

QString MeasureTable::numberOf(const Row &row, std::optional<double> value) const
{
    const capture::Channel *channel = channelOf(row.wanted);
    if (!value || !channel)
        return QStringLiteral("\u2013");
    return measuredText(*value, row.result.unit, channel->info(),
        m_scope.readingStepOf(channel->info().id), m_scope.locale());
}

QString MeasureTable::valueText(const Row &row) const
{
    if (row.tooLong)
        return tr("too many samples: zoom in");
    if (!row.result.value)
        return whyNotText(row.result.value.error());
    const QString number = numberOf(row, *row.result.value);
    return row.result.partial ? tr("%1 (samples are missing)").arg(number) : number;
}

QVariant MeasureTable::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const Row &row = m_rows[std::size_t(index.row())];
    if (role == Qt::TextAlignmentRole)
        return index.column() >= ValueColumn ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                                             : QVariant();
    if (role == Qt::ToolTipRole && index.column() == QuantityColumn)
        return quantityHelp(row.wanted.quantity);
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case SignalColumn:
        return row.named.against.isEmpty()
            ? row.named.signal
            : tr("%1 to %2", "a phase between two traces").arg(row.named.signal, row.named.against);
    case QuantityColumn:
        return quantityText(row.wanted.quantity);
    case ValueColumn:
        return valueText(row);
    case MeanColumn:
        return numberOf(row, row.statistics.mean());
    case SigmaColumn:
        return numberOf(row, row.statistics.sigma());
    case MinColumn:
        return numberOf(row, row.statistics.min());
    case MaxColumn:
        return numberOf(row, row.statistics.max());
    case CountColumn:
        return QString::number(row.statistics.count());
    default:
        return {};
    }
}

QVariant MeasureTable::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && section >= ValueColumn)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    return RowTable::headerData(section, orientation, role);
}

} // namespace widgets
