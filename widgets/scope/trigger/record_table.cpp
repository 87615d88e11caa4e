#include "widgets/scope/trigger/record_table.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/base/device_text.h"

#include <algorithm>
#include <array>

namespace widgets {

namespace {
constexpr double kTimeStep = 1e-4; ///< seconds
/// In the order of scope::Record::Cause.
constexpr std::array kCauses{QT_TRANSLATE_NOOP("widgets::RecordTable", "trigger"),
    QT_TRANSLATE_NOOP("widgets::RecordTable", "event"),
    QT_TRANSLATE_NOOP("widgets::RecordTable", "forced"),
    QT_TRANSLATE_NOOP("widgets::RecordTable", "automatic")};

QString causeText(const scope::Record &record)
{
    if (record.state == scope::Record::State::Released)
        return RecordTable::tr("samples are gone");
    return RecordTable::tr(kCauses.at(static_cast<std::size_t>(record.cause)));
}
} // namespace

RecordTable::RecordTable(TriggerControl &control, QObject *parent)
    : RowTable(parent, {tr("Pinned, trigger time"), tr("Age"), tr("Cause"), tr("Label")})
    , m_control(control)
{
    refresh();
}

void RecordTable::refresh()
{
    const auto &now = m_control.trigger().history().records();
    replace(m_records, {now.rbegin(), now.rend()},
        [](const scope::Record &one, const scope::Record &other) { return one.id == other.id; });
}

int RecordTable::rowOf(scope::RecordId id) const
{
    const auto found = std::find_if(m_records.begin(), m_records.end(),
        [id](const scope::Record &record) { return record.id == id; });
    return found == m_records.end() ? -1 : static_cast<int>(found - m_records.begin());
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
    Qt::ItemFlags flags = RowTable::flags(index);
    if (index.isValid() && index.column() == TimeColumn)
        flags |= Qt::ItemIsUserCheckable;
    if (index.isValid() && index.column() == LabelColumn)
        flags |= Qt::ItemIsEditable;
    return flags;
}

} // namespace widgets
