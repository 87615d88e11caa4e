#include "widgets/snapshots/model.h"

#include "widgets/base/device_text.h"
#include "widgets/base/register_texts.h"
#include "widgets/base/value_text.h"
#include "widgets/snapshots/text.h"

#include <QApplication>
#include <QPalette>

namespace widgets {
namespace {

/// As the plan names what it leaves: NAME or NAME@MOTOR.
bool isNamed(const snapshots::Entry &entry, const std::string &name)
{
    return name == entry.name || name == entry.name + "@" + std::to_string(entry.motor);
}

} // namespace

SnapshotModel::SnapshotModel(QObject *parent)
    : RowTable(parent,
        {tr("Register"), tr("Motor"), tr("A", "the first of two snapshots"),
            tr("B", "the second of two snapshots"), tr("Unit"),
            tr("A raw", "digits of the first of two snapshots"),
            tr("B raw", "digits of the second of two snapshots")})
{
}

void SnapshotModel::compare(Side a, Side b, snapshots::Scope scope)
{
    beginResetModel();
    if (a != m_a)
        m_unwanted.clear();
    m_a = std::move(a);
    m_b = std::move(b);
    m_rows.clear();
    m_plan = {};
    if (m_a && m_b)
        for (const snapshots::Difference &difference : snapshots::differences(*m_a, *m_b, scope))
            m_rows.push_back({difference, SIZE_MAX, {}, true});
    endResetModel();
    Q_EMIT chosenChanged();
}

void SnapshotModel::offer(const snapshots::RestorePlan &plan)
{
    m_plan = plan;
    for (Row &row : m_rows) {
        row.write = SIZE_MAX;
        row.why.clear();
        const snapshots::Entry &entry = row.difference.either();
        row.wanted = !m_unwanted.contains(Key(entry.name, entry.motor));
        for (std::size_t i = 0; row.difference.b != nullptr && i < plan.writes.size(); ++i)
            if (plan.writes[i].id == row.difference.b->id)
                row.write = i;
        for (const snapshots::RestorePlan::Left &left : plan.left)
            if (row.write == SIZE_MAX && isNamed(entry, left.name))
                row.why = notRestoredText(left.why);
    }
    cellsChanged();
    Q_EMIT chosenChanged();
}

std::vector<drive::RegisterWrite> SnapshotModel::chosen(
    const std::function<bool(int row)> &seen) const
{
    std::vector<bool> taken(m_plan.writes.size(), false);
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        if (m_rows[i].write < taken.size() && m_rows[i].wanted && seen(static_cast<int>(i)))
            taken[m_rows[i].write] = true;
    std::vector<drive::RegisterWrite> writes;
    for (std::size_t i = 0; i < taken.size(); ++i)
        if (taken[i])
            writes.push_back(m_plan.writes[i]);
    return writes;
}

QString SnapshotModel::copyText(const QList<int> &rows) const
{
    QStringList lines{titlesText()};
    for (const int row : rows)
        lines.append(rowText(index(row, NameColumn)));
    return lines.join(QLatin1Char('\n'));
}

void SnapshotModel::choose(const QList<int> &rows, bool wanted)
{
    for (const int row : rows)
        setData(index(row, NameColumn), wanted ? Qt::Checked : Qt::Unchecked, Qt::CheckStateRole);
}

QString SnapshotModel::text(const Row &row, int column) const
{
    const snapshots::Difference &difference = row.difference;
    switch (column) {
    case NameColumn:
        return deviceText(difference.either().name);
    case MotorColumn:
        return difference.either().motor > 0 ? QString::number(difference.either().motor)
                                             : QString();
    case AColumn:
        return snapshotValueText(difference.a);
    case BColumn:
        return snapshotValueText(difference.b);
    case UnitColumn: {
        const QString unit = unitText(difference.either().unit);
        return unit == QLatin1String("-") ? QString() : unit;
    }
    case ARawColumn:
        return snapshotRawText(difference.a);
    case BRawColumn:
        return snapshotRawText(difference.b);
    default:
        return {};
    }
}

QVariant SnapshotModel::sortKey(const Row &row, int column) const
{
    const bool ofA = column == AColumn || column == ARawColumn;
    const snapshots::Entry *entry = ofA ? row.difference.a : row.difference.b;
    if (column == AColumn || column == BColumn || column == ARawColumn || column == BRawColumn) {
        const double raw = entry != nullptr ? rawNumber(entry->value) : 0.0;
        const bool shown = column == AColumn || column == BColumn;
        return shown && entry != nullptr && entry->shown ? *entry->shown : raw;
    }
    return text(row, column);
}

QString SnapshotModel::toolTip(const Row &row) const
{
    const snapshots::Entry &entry = row.difference.either();
    QStringList lines{QStringLiteral("<b>%1</b>").arg(deviceToolTip(entry.name)),
        registerGroupText(entry.group).toHtmlEscaped()};
    if (row.difference.a == nullptr)
        lines.append(tr("Only B has it.").toHtmlEscaped());
    if (row.difference.b == nullptr)
        lines.append(tr("Only A has it.").toHtmlEscaped());
    if (!row.why.isEmpty())
        lines.append(tr("Not restored: %1", "the reason").arg(row.why).toHtmlEscaped());
    lines.removeAll(QString());
    return lines.join(QStringLiteral("<br>"));
}

QVariant SnapshotModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= differing())
        return {};
    const Row &row = m_rows[static_cast<std::size_t>(index.row())];
    const bool number = index.column() != NameColumn && index.column() != UnitColumn;
    switch (role) {
    case Qt::DisplayRole:
        return text(row, index.column());
    case Qt::CheckStateRole:
        if (index.column() != NameColumn || row.write == SIZE_MAX)
            return {};
        return row.wanted ? Qt::Checked : Qt::Unchecked;
    case Qt::TextAlignmentRole:
        return number ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::ToolTipRole:
        return toolTip(row);
    case Qt::ForegroundRole:
        return row.why.isEmpty()
            ? QVariant()
            : QVariant(QApplication::palette().brush(QPalette::Disabled, QPalette::Text));
    case SearchRole: {
        const snapshots::Entry &entry = row.difference.either();
        return QString(deviceText(entry.name) + QLatin1Char('\n') + deviceText(entry.group)
            + QLatin1Char('\n') + registerGroupText(entry.group));
    }
    case SortRole:
        return sortKey(row, index.column());
    case RestorableRole:
        return row.write != SIZE_MAX;
    default:
        return {};
    }
}

QVariant SnapshotModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole)
        return QVariant(
            (section == NameColumn          ? Qt::AlignLeft
                    : section == UnitColumn ? Qt::AlignHCenter // "B" ends where it begins
                                            : Qt::AlignRight)
            | Qt::AlignVCenter);
    return RowTable::headerData(section, orientation, role);
}

Qt::ItemFlags SnapshotModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = RowTable::flags(index);
    if (index.isValid() && index.column() == NameColumn
        && m_rows[static_cast<std::size_t>(index.row())].write != SIZE_MAX)
        flags |= Qt::ItemIsUserCheckable;
    return flags;
}

bool SnapshotModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::CheckStateRole || !flags(index).testFlag(Qt::ItemIsUserCheckable))
        return false;
    Row &row = m_rows[static_cast<std::size_t>(index.row())];
    const snapshots::Entry &entry = row.difference.either();
    row.wanted = value.toInt() == Qt::Checked;
    if (row.wanted)
        m_unwanted.erase(Key(entry.name, entry.motor));
    else
        m_unwanted.insert(Key(entry.name, entry.motor));
    Q_EMIT dataChanged(index, index, {Qt::CheckStateRole});
    Q_EMIT chosenChanged();
    return true;
}

} // namespace widgets
