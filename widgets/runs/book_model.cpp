#include "widgets/runs/book_model.h"

#include "widgets/base/device_text.h"
#include "widgets/runs/texts.h"

#include <QDateTime>
#include <QLocale>

namespace widgets {
namespace {

constexpr int kMostNote = 2000; ///< characters

QString tipOf(const session::Run &run)
{
    QStringList lines{experimentText(run), resultText(run)};
    for (const QString &note : run.notes)
        lines.append(deviceText(note));
    if (!run.motorName.isEmpty() || !run.board.isEmpty())
        lines.append(deviceText(run.board) + QStringLiteral(", ") + deviceText(run.motorName));
    if (!run.registers)
        lines.append(RunBookModel::tr("Its registers were not read to the end."));
    return plainToolTip(lines.join(QLatin1Char('\n')));
}

} // namespace

RunBookModel::RunBookModel(QObject *parent)
    : RowTable(
        parent, {tr("Run"), tr("Time"), tr("Experiment"), tr("Kp / Ki"), tr("Result"), tr("Note")})
{
}

void RunBookModel::setRuns(std::vector<session::Run> runs)
{
    beginResetModel();
    m_runs = std::move(runs);
    endResetModel();
}

void RunBookModel::add(const session::Run &run)
{
    beginInsertRows({}, 0, 0);
    m_runs.push_back(run);
    endInsertRows();
}

QVariant RunBookModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const session::Run &shown = run(index.row());
    if (role == Qt::ToolTipRole)
        return tipOf(shown);
    if (role == Qt::CheckStateRole && index.column() == RunColumn)
        return shown.starred ? Qt::Checked : Qt::Unchecked;
    if (role == Qt::AccessibleTextRole && index.column() == RunColumn)
        return shown.starred ? tr("%1, with a star", "number").arg(shown.number)
                             : QString::number(shown.number);
    if (role != Qt::DisplayRole && role != Qt::EditRole)
        return {};
    switch (index.column()) {
    case RunColumn:
        return shown.starred ? QStringLiteral("%1 \u2605").arg(shown.number)
                             : QString::number(shown.number);
    case TimeColumn:
        return QLocale().toString(QDateTime::fromSecsSinceEpoch(shown.at), QLocale::ShortFormat);
    case ExperimentColumn:
        return experimentText(shown);
    case GainsColumn:
        return gainsText(shown);
    case ResultColumn:
        return resultText(shown);
    case NoteColumn:
        return role == Qt::EditRole ? shown.note : deviceText(shown.note);
    default:
        return {};
    }
}

bool RunBookModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid())
        return false;
    session::Run &changed = m_runs[m_runs.size() - 1 - std::size_t(index.row())];
    if (role == Qt::CheckStateRole && index.column() == RunColumn)
        changed.starred = value.toInt() == Qt::Checked;
    else if (role == Qt::EditRole && index.column() == NoteColumn)
        changed.note = value.toString().left(kMostNote);
    else
        return false;
    Q_EMIT dataChanged(index, index);
    Q_EMIT annotated(changed.number, changed.note, changed.starred);
    return true;
}

Qt::ItemFlags RunBookModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = RowTable::flags(index);
    if (index.column() == RunColumn)
        flags |= Qt::ItemIsUserCheckable;
    if (index.column() == NoteColumn)
        flags |= Qt::ItemIsEditable;
    return flags;
}

QVariant RunBookModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && role == Qt::ToolTipRole && section == GainsColumn)
        return tr("Digits of the proportional and the integral gain of the speed loop");
    return RowTable::headerData(section, orientation, role);
}

} // namespace widgets
