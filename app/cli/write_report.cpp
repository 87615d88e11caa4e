#include "write_report.h"

#include "drive/motion_entry.h"
#include "sentences.h"

#include <QJsonArray>

namespace cli {

namespace {

QString nameOf(const Desk &desk, drive::RegisterId id)
{
    return QString::fromStdString(desk.catalog().nameOf(id));
}

QString sideText(
    const Desk &desk, drive::RegisterId id, const std::optional<drive::Value> &value, Digits digits)
{
    return value ? valueText(desk.catalog(), id, *value, digits) : QStringLiteral("?");
}

QString reasonText(const std::string &reason)
{
    return reason.empty() ? QString() : QStringLiteral(" (%1)").arg(plainText(reason));
}

QJsonObject jsonOf(const Desk &desk, const drive::WriteResult &result, Digits digits)
{
    QJsonObject object{{QStringLiteral("name"), nameOf(desk, result.id)},
        {QStringLiteral("id"), idText(result.id)},
        {QStringLiteral("outcome"), utf8Text(wordOf(result.outcome))},
        {QStringLiteral("reason"), plainText(result.reason)},
        {QStringLiteral("verified"), orNull(result.verified)}};
    const auto put = [&](const char *side, const std::optional<drive::Value> &value) {
        if (value)
            object[QLatin1String(side)] =
                valueJson(desk.catalog(), result.id, *value, digits)[QStringLiteral("value")];
    };
    put("old", result.before);
    put("new", result.readBack);
    return object;
}

QString lineOf(const Desk &desk, const drive::WriteResult &result, Digits digits)
{
    const QString line =
        QStringLiteral("%1: %2 -> %3")
            .arg(nameOf(desk, result.id), sideText(desk, result.id, result.before, digits),
                sideText(desk, result.id, result.readBack, digits));
    const bool sent =
        result.outcome == drive::Outcome::Ok || result.outcome == drive::Outcome::Refused;
    if (result.readBack || result.outcome == drive::Outcome::Refused)
        return sent && result.outcome == drive::Outcome::Ok ? line + reasonText(result.reason)
                                                            : line;
    return line
        + QStringLiteral(" (%1)").arg(
            sent ? QStringLiteral("written, not read back") : utf8Text(wordOf(result.outcome)));
}

/// One sentence about a list that came to no good end because the answers ended.
QString brokenSentence(const std::vector<drive::WriteResult> &writes, const QString &what)
{
    int counts[4] = {};
    for (const drive::WriteResult &result : writes)
        ++counts[static_cast<std::size_t>(result.outcome)];
    const auto count = [&](drive::Outcome outcome) {
        return QString::number(counts[static_cast<std::size_t>(outcome)]);
    };
    return QStringLiteral(
        "%1 broke off: of %2 registers %3 were written, %4 may have been, %5 were "
        "not; connect again and look with rotorscope-cli get or diff.")
        .arg(what, QString::number(writes.size()), count(drive::Outcome::Ok),
            count(drive::Outcome::Unknown),
            QString::number(counts[static_cast<std::size_t>(drive::Outcome::NotSent)]
                + counts[static_cast<std::size_t>(drive::Outcome::Refused)]));
}

Outcome<int> verdict(const Desk &desk, const drive::Ended &ended)
{
    QStringList failed, other, unread;
    bool shown = true; // above is what the board has now
    for (const drive::WriteResult &result : ended.writes) {
        const catalog::RegisterInfo *info = desk.catalog().find(result.id);
        const bool unknown = !result.readBack && info != nullptr && info->readable();
        shown = shown && !unknown && (result.readBack || result.outcome == drive::Outcome::Ok);
        if (result.outcome != drive::Outcome::Ok)
            failed.append(nameOf(desk, result.id) + reasonText(result.reason));
        else if (result.verified == false)
            other.append(nameOf(desk, result.id));
        else if (unknown)
            unread.append(nameOf(desk, result.id));
    }
    const auto sentence = [shown](const char *begin, const QStringList &names) {
        const QString advice = shown
            ? QStringLiteral("the values above are what the board has now")
            : QStringLiteral("read them with rotorscope-cli get to see what the board has now");
        return QStringLiteral("%1: %2; %3.")
            .arg(QLatin1String(begin), names.join(QStringLiteral(", ")), advice);
    };
    if (!failed.isEmpty())
        return failure(kRefused, sentence("Not written", failed));
    if (!other.isEmpty())
        return failure(kRefused, sentence("The board made another value of", other));
    if (!unread.isEmpty())
        return failure(kRefused, sentence("Written, but not read back", unread));
    if (ended.outcome != drive::Outcome::Ok)
        return failure(
            kRefused, QStringLiteral("Nothing was written%1.").arg(reasonText(ended.reason)));
    return kDone;
}

} // namespace

Outcome<int> writeAndReport(
    Desk &desk, const drive::Write &write, Digits digits, const QString &what)
{
    desk.talk.arm();
    const Conversation::Asked asked = desk.talk.askToTheEnd(write);
    QJsonArray list;
    if (asked.ended) {
        for (const drive::WriteResult &result : asked.ended->writes) {
            // Of one that was refused before anything was read the verdict says all there is.
            const bool known =
                result.before || result.readBack || result.outcome != drive::Outcome::Refused;
            if (desk.out.json())
                list.append(jsonOf(desk, result, digits));
            else if (known)
                desk.out.line(lineOf(desk, result, digits));
        }
    }
    if (desk.out.json())
        desk.out.line(list);
    const bool broken = asked.broken || asked.ended->outcome == drive::Outcome::Unknown;
    if (!broken)
        return verdict(desk, *asked.ended);
    const int status = asked.broken ? asked.broken->status : kNoConnection;
    if (asked.ended && !asked.ended->writes.empty())
        return failure(status, brokenSentence(asked.ended->writes, what));
    return asked.broken ? tl::make_unexpected(*asked.broken)
                        : failure(status, QStringLiteral("%1 broke off.").arg(what));
}

} // namespace cli
