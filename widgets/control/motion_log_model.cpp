#include "widgets/control/motion_log_model.h"

#include "widgets/base/device_text.h"
#include "widgets/base/messages.h"

#include <algorithm>

namespace widgets {
namespace {

QString bytesText(const drive::MotionEntry &entry)
{
    QStringList parts;
    for (const Bytes &request : entry.sent)
        parts.append(QString::fromLatin1(QByteArray(
            reinterpret_cast<const char *>(request.data()), static_cast<qsizetype>(request.size()))
                                             .toHex(' ')
                                             .toUpper()));
    if (entry.requests > entry.sent.size())
        parts.append(QStringLiteral("\u2026"));
    return parts.join(QStringLiteral(" | "));
}

} // namespace

MotionLogModel::MotionLogModel(QObject *parent)
    : RowTable(parent,
        {tr("Time"), tr("Motor"), tr("Act"), tr("What"), tr("Outcome"), tr("From"),
            tr("Bytes sent")})
{
}

void MotionLogModel::accept(const drive::MotionEntry &entry, const QDateTime &now)
{
    if (m_log.size() >= kMost)
        leaveOutOldest();
    const int row = static_cast<int>(m_log.size());
    session::LoggedMotion one = session::loggedNow(entry, now);
    if (m_clock.accept(one) && row > 0)
        Q_EMIT dataChanged(index(0, TimeColumn), index(row - 1, TimeColumn));
    beginInsertRows({}, row, row);
    m_log.push_back(std::move(one));
    endInsertRows();
}

void MotionLogModel::leaveOutOldest()
{
    const auto end = m_log.begin() + kLeftOutAtOnce;
    beginRemoveRows({}, 0, static_cast<int>(kLeftOutAtOnce) - 1);
    std::for_each(m_log.begin(), end, [this](const auto &one) { m_clock.forget(one); });
    m_log.erase(m_log.begin(), end);
    m_leftOut += kLeftOutAtOnce;
    endRemoveRows();
    cellsChanged(TimeColumn, TimeColumn);
}

QByteArray MotionLogModel::text() const { return session::motionLogText(m_log, who(), m_leftOut); }

QString MotionLogModel::who() { return session::motionLogWho(QStringLiteral("Rotorscope")); }

QString MotionLogModel::copyText(const QList<int> &rows) const
{
    QStringList lines;
    for (const int row : rows)
        if (row >= 0 && row < rowCount())
            lines.append(rowText(index(row, TimeColumn)));
    return lines.join(QLatin1Char('\n'));
}

QString MotionLogModel::cell(const session::LoggedMotion &one, int column) const
{
    const drive::MotionEntry &entry = one.entry;
    switch (column) {
    case TimeColumn:
        // What became of a Stop is told when it was seen; all else when it was asked for.
        return m_clock.at(one, entry.stop ? entry.ended : entry.asked)
            .toLocalTime()
            .toString(QStringLiteral("HH:mm:ss.zzz"));
    case MotorColumn:
        return entry.motor > 0 ? QString::number(entry.motor) : QStringLiteral("\u2013");
    case ActColumn:
        return motionActText(entry.act);
    case DetailColumn:
        return deviceText(entry.detail);
    case OutcomeColumn: {
        const QString end = entry.stop ? stopWordText(*entry.stop) : outcomeText(entry.outcome);
        return entry.reason.empty()
            ? end
            : tr("%1 (%2)", "outcome, the board's word").arg(end, deviceText(entry.reason));
    }
    case SourceColumn:
        return motionSourceText(entry.source);
    case BytesColumn:
        return bytesText(entry);
    default:
        return {};
    }
}

QVariant MotionLogModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole) {
        const QString text = cell(m_log[static_cast<std::size_t>(index.row())], index.column());
        return role == Qt::ToolTipRole ? plainToolTip(text) : text;
    }
    return {};
}

} // namespace widgets
