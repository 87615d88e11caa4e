#include "widgets/files/record_table.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/base/device_text.h"

#include <algorithm>

namespace widgets {

namespace {
constexpr double kTimeStep = 1e-4; ///< seconds

QString causeText(const scope::Record &record)
{
    if (record.state == scope::Record::State::Released)
        return RecordTable::tr("samples are gone");
    switch (record.cause) {
    case scope::Record::Cause::Condition:
        return RecordTable::tr("trigger");
    case scope::Record::Cause::Event:
        return RecordTable::tr("event");
    case scope::Record::Cause::Forced:
        return RecordTable::tr("forced");
    case scope::Record::Cause::Automatic:
        return RecordTable::tr("automatic");
    }
    return {};
}
} // namespace

RecordTable::RecordTable(TriggerControl &control, QObject *parent)
    : QAbstractTableModel(parent)
    , m_control(control)
{
    refresh();
}

void RecordTable::refresh()
{
    const auto &now = m_control.trigger().history().records();
    std::vector<scope::Record> fresh(now.rbegin(), now.rend());
    const bool same = std::equal(fresh.begin(), fresh.end(), m_records.begin(), m_records.end(),
        [](const scope::Record &one, const scope::Record &other) { return one.id == other.id; });
    if (!same) {
        beginResetModel();
        m_records = std::move(fresh);
        endResetModel();
        return;
    }
    m_records = std::move(fresh);
    if (!m_records.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int RecordTable::rowOf(scope::RecordId id) const
{
    const auto found = std::find_if(m_records.begin(), m_records.end(),
        [id](const scope::Record &record) { return record.id == id; });
    return found == m_records.end() ? -1 : static_cast<int>(found - m_records.begin());
}

int RecordTable::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_records.size());
}

int RecordTable::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : kColumns;
}

QVariant RecordTable::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const scope::Record &record = m_records[std::size_t(index.row())];
    const bool isLabel = index.column() == LabelColumn;
    if (role == IdRole)
        return record.id;
    if (role == Qt::CheckStateRole && index.column() == TimeColumn)
        return static_cast<int>(record.pinned ? Qt::Checked : Qt::Unchecked);
    if (role == Qt::EditRole && isLabel)
        return QString::fromStdString(record.label);
    if (role != Qt::DisplayRole)
        return {};
    const double trigger = capture::toSeconds(record.trigger);
    switch (index.column()) {
    case TimeColumn:
        return timeLabel(trigger, kTimeStep, 1.0, QLocale::c());
    case AgeColumn:
        return ageText(m_control.trigger().now() - trigger);
    case CauseColumn:
        return causeText(record);
    default:
        return QString::fromStdString(record.label);
    }
}

bool RecordTable::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || index.row() >= rowCount())
        return false;
    const scope::RecordId id = m_records[std::size_t(index.row())].id;
    if (role == Qt::CheckStateRole && index.column() == TimeColumn)
        m_control.trigger().setPinned(id, value.toInt() == Qt::Checked);
    else if (role == Qt::EditRole && index.column() == LabelColumn)
        m_control.trigger().setLabel(id, value.toString().simplified());
    else
        return false;
    refresh();
    return true;
}

Qt::ItemFlags RecordTable::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (index.isValid() && index.column() == TimeColumn)
        flags |= Qt::ItemIsUserCheckable;
    if (index.isValid() && index.column() == LabelColumn)
        flags |= Qt::ItemIsEditable;
    return flags;
}

QVariant RecordTable::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case TimeColumn:
        return tr("Pinned, trigger time");
    case AgeColumn:
        return tr("Age");
    case CauseColumn:
        return tr("Cause");
    case LabelColumn:
        return tr("Label");
    default:
        return {};
    }
}

} // namespace widgets
