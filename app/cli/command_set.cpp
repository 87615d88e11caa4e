#include "commands.h"
#include "sentences.h"
#include "values.h"

#include <QJsonArray>

#include <algorithm>

namespace cli {

namespace {

struct Wanted {
    drive::Write write;
    QStringList names;
};

Outcome<Wanted> wantedOf(const Desk &desk, Digits digits)
{
    Wanted wanted;
    for (const QString &word : desk.arguments.words) {
        const auto equals = word.indexOf(QLatin1Char('='));
        if (equals < 1)
            return failure(kUsage, QStringLiteral("Write NAME=VALUE, not \"%1\".").arg(word));
        const auto id = resolveName(desk.catalog(), word.left(equals).trimmed());
        if (!id)
            return tl::make_unexpected(id.error());
        if (std::any_of(wanted.write.writes.begin(), wanted.write.writes.end(),
                [&id](const drive::RegisterWrite &one) { return one.id == *id; }))
            return failure(kUsage,
                QStringLiteral("%1 is named twice; give it one value.")
                    .arg(QString::fromStdString(desk.catalog().nameOf(*id))));
        const catalog::RegisterInfo *info = desk.catalog().find(*id);
        if (info != nullptr && !info->writable())
            return failure(kRefused,
                QStringLiteral(
                    "%1 cannot be written; rotorscope-cli registers shows RW for what can.")
                    .arg(QString::fromStdString(info->name)));
        auto value = parseValue(desk.catalog(), *id, word.mid(equals + 1), digits);
        if (!value)
            return tl::make_unexpected(value.error());
        wanted.write.writes.push_back({*id, std::move(*value)});
    }
    return wanted;
}

QString sideText(
    const Desk &desk, drive::RegisterId id, const std::optional<drive::Value> &value, Digits digits)
{
    return value ? valueText(desk.catalog(), id, *value, digits) : QStringLiteral("?");
}

const char *wordOf(drive::Outcome outcome)
{
    switch (outcome) {
    case drive::Outcome::Ok:
        return "ok";
    case drive::Outcome::Refused:
        return "refused";
    case drive::Outcome::NotSent:
        return "not sent";
    case drive::Outcome::Unknown:
        return "unknown";
    }
    return "unknown";
}

QJsonObject jsonOf(const Desk &desk, const drive::WriteResult &result, Digits digits)
{
    QJsonObject object{
        {QStringLiteral("name"), QString::fromStdString(desk.catalog().nameOf(result.id))},
        {QStringLiteral("id"), idText(result.id)},
        {QStringLiteral("outcome"), QLatin1String(wordOf(result.outcome))},
        {QStringLiteral("reason"), plainText(result.reason)}};
    if (result.before)
        object[QStringLiteral("old")] =
            valueJson(desk.catalog(), result.id, *result.before, digits)[QStringLiteral("value")];
    if (result.readBack)
        object[QStringLiteral("new")] =
            valueJson(desk.catalog(), result.id, *result.readBack, digits)[QStringLiteral("value")];
    return object;
}

QString reasonText(const std::string &reason)
{
    return reason.empty() ? QString() : QStringLiteral(" (%1)").arg(plainText(reason));
}

} // namespace

Outcome<int> runSet(Desk &desk)
{
    const Digits digits = desk.arguments.raw ? Digits::Raw : Digits::Shown;
    const auto wanted = wantedOf(desk, digits);
    if (!wanted)
        return tl::make_unexpected(wanted.error());
    desk.talk.arm();
    const auto ended = desk.talk.ask(wanted->write);
    if (!ended)
        return tl::make_unexpected(ended.error());
    QJsonArray list;
    QStringList failed;
    for (const drive::WriteResult &result : ended->writes) {
        const QString name = QString::fromStdString(desk.catalog().nameOf(result.id));
        if (result.outcome != drive::Outcome::Ok)
            failed.append(name + reasonText(result.reason));
        if (desk.out.json())
            list.append(jsonOf(desk, result, digits));
        else
            desk.out.line(QStringLiteral("%1: %2 -> %3")
                              .arg(name, sideText(desk, result.id, result.before, digits),
                                  sideText(desk, result.id, result.readBack, digits)));
    }
    if (desk.out.json())
        desk.out.line(list);
    if (ended->outcome == drive::Outcome::Unknown)
        return failure(kNoConnection,
            QStringLiteral(
                "The board's answer was lost; look with rotorscope-cli get what is there now."));
    if (!failed.isEmpty())
        return failure(kRefused,
            QStringLiteral("Not written: %1; the values above are what the board has now.")
                .arg(failed.join(QStringLiteral(", "))));
    if (ended->outcome != drive::Outcome::Ok)
        return failure(
            kRefused, QStringLiteral("Nothing was written%1.").arg(reasonText(ended->reason)));
    return kDone;
}

} // namespace cli
