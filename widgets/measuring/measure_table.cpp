#include "widgets/measuring/measure_table.h"

#include "scope/measurer.h"
#include "scope/phase.h"
#include "widgets/base/device_text.h"
#include "widgets/measuring/measure_text.h"
#include "widgets/scope/scope_view.h"

#include <algorithm>

namespace widgets {

namespace {
using scope::Quantity;

/// Those that ask for a step; the others describe a signal that repeats.
bool aboutStep(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Overshoot:
    case Quantity::Undershoot:
    case Quantity::PeakTime:
    case Quantity::Settling:
    case Quantity::DeadTime:
    case Quantity::SteadyStateError:
    case Quantity::Ripple:
    case Quantity::RippleRms:
    case Quantity::AbsoluteError:
    case Quantity::TimedError:
        return true;
    default:
        return false;
    }
}

bool fromEnvelope(Quantity quantity)
{
    return quantity == Quantity::Min || quantity == Quantity::Max
        || quantity == Quantity::PeakToPeak;
}
} // namespace

MeasureTable::MeasureTable(const ScopeView &scope, const capture::Capture &capture, QObject *parent)
    : QAbstractTableModel(parent)
    , m_scope(scope)
    , m_capture(capture)
{
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
    row.wanted = wanted;
    row.named.quantity = wanted.quantity;
    if (const capture::Channel *channel = channelOf(wanted))
        row.named.signal = deviceText(channel->info().name);
    if (const capture::Channel *second = secondOf(wanted))
        row.named.against = deviceText(second->info().name);
    beginInsertRows({}, rowCount(), rowCount());
    m_next = m_rows.size(); // its turn
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
    for (Row &row : m_rows)
        row.statistics.clear();
    if (!m_rows.empty())
        Q_EMIT dataChanged(index(0, MeanColumn), index(rowCount() - 1, CountColumn));
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

/// @param trigger  a step is measured from there if it lies inside
MeasureTable::Measured MeasureTable::measured(const Wanted &wanted, capture::Nanos from,
    capture::Nanos to, std::optional<capture::Nanos> trigger) const
{
    Measured one;
    one.result.quantity = wanted.quantity;
    one.result.unit = scope::unitOf(wanted.quantity);
    const capture::Channel *channel = channelOf(wanted);
    if (!channel || channel->empty())
        return one;
    const double seconds = capture::toSeconds(from);
    const std::uint64_t count =
        fromEnvelope(wanted.quantity) ? 0 : channel->countIn(seconds, capture::toSeconds(to));
    one.tooLong = count > kMostSamples;
    if (one.tooLong)
        return one;
    if (wanted.quantity == Quantity::Phase) {
        if (const capture::Channel *second = secondOf(wanted))
            one.result = scope::measurePhase(*channel, *second, from, to);
        one.read = 2 * count;
        return one;
    }
    std::optional<scope::StepSettings> step;
    if (aboutStep(wanted.quantity)) {
        step.emplace();
        // A record of the trigger has the step where the trigger is.
        if (trigger && *trigger > from && *trigger < to)
            step->at = *trigger;
    }
    one.result = scope::Measurer(*channel, from, to, step).measure(wanted.quantity);
    one.read = count;
    return one;
}

void MeasureTable::measure(double from, double to)
{
    if (m_rows.empty() || !(to > from))
        return;
    const auto mark = m_scope.triggerMarks().position;
    const auto trigger = mark ? std::optional(capture::toNanos(*mark)) : std::nullopt;
    // Long pictures are measured some rows at a time, so that the window never waits for all of them.
    std::uint64_t cost = 0;
    for (std::size_t done = 0; done < m_rows.size() && cost < kSamplesAtOnce; ++done) {
        m_next %= m_rows.size();
        Row &row = m_rows[m_next++];
        const Measured now =
            measured(row.wanted, capture::toNanos(from), capture::toNanos(to), trigger);
        row.result = now.result;
        row.tooLong = now.tooLong;
        cost += now.read;
    }
    Q_EMIT dataChanged(index(0, ValueColumn), index(rowCount() - 1, CountColumn));
}

void MeasureTable::count(capture::Nanos from, capture::Nanos to, capture::Nanos trigger)
{
    if (m_rows.empty() || to <= from)
        return;
    for (Row &row : m_rows) {
        const auto value = measured(row.wanted, from, to, trigger).result.value;
        row.statistics.add(value ? std::optional(*value) : std::nullopt);
    }
    Q_EMIT dataChanged(index(0, MeanColumn), index(rowCount() - 1, CountColumn));
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

int MeasureTable::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int MeasureTable::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : kColumns;
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
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole && section >= ValueColumn)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case SignalColumn:
        return tr("Trace");
    case QuantityColumn:
        return tr("Measure");
    case ValueColumn:
        return tr("Value");
    case MeanColumn:
        return tr("Mean", "of a measurement over records");
    case SigmaColumn:
        return QStringLiteral("\u03c3");
    case MinColumn:
        return tr("Min");
    case MaxColumn:
        return tr("Max");
    case CountColumn:
        return tr("Records", "number of records counted");
    default:
        return {};
    }
}

} // namespace widgets
