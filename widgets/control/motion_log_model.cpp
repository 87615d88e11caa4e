#include "widgets/control/motion_log_model.h"

#include "widgets/base/device_text.h"
#include "widgets/base/messages.h"

namespace widgets {
namespace {

QString bytesText(const drive::MotionEntry &record)
{
    QStringList parts;
    for (const Bytes &request : record.sent)
        parts.append(QString::fromLatin1(QByteArray(
            reinterpret_cast<const char *>(request.data()), static_cast<qsizetype>(request.size()))
                                             .toHex(' ')
                                             .toUpper()));
    if (record.requests > record.sent.size())
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

void MotionLogModel::accept(const drive::MotionEntry &record, const QDateTime &now)
{
    if (m_log.size() >= kMost) {
        ++m_leftOut;
        return;
    }
    const int row = static_cast<int>(m_log.size());
    session::LoggedMotion one = session::loggedNow(record, now);
    if (m_clock.accept(one) && row > 0)
        Q_EMIT dataChanged(index(0, TimeColumn), index(row - 1, TimeColumn));
    beginInsertRows({}, row, row);
    m_log.push_back(std::move(one));
    endInsertRows();
}

QByteArray MotionLogModel::text() const { return session::motionLogText(m_log, who()); }

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
    const drive::MotionEntry &record = one.record;
    switch (column) {
    case TimeColumn:
        // What became of a Stop is told when it was seen; all else when it was asked for.
        return m_clock.at(one, record.stop ? record.ended : record.asked)
            .toLocalTime()
            .toString(QStringLiteral("HH:mm:ss.zzz"));
    case MotorColumn:
        return record.motor > 0 ? QString::number(record.motor) : QStringLiteral("\u2013");
    case ActColumn:
        return motionActText(record.act);
    case DetailColumn:
        return deviceText(record.detail);
    case OutcomeColumn: {
        const QString end = record.stop ? stopWordText(*record.stop) : outcomeText(record.outcome);
        return record.reason.empty()
            ? end
            : tr("%1 (%2)", "outcome, the board's word").arg(end, deviceText(record.reason));
    }
    case SourceColumn:
        return motionSourceText(record.source);
    case BytesColumn:
        return bytesText(record);
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
