#include "commands.h"
#include "values.h"

#include <QJsonArray>

namespace cli {

namespace {

Outcome<int> runGet(Desk &desk)
{
    const catalog::Catalog &catalog = desk.catalog();
    const auto ids = resolveNames(catalog, desk.arguments.words);
    if (!ids)
        return tl::make_unexpected(ids.error());
    const auto readings = desk.talk.read(*ids);
    if (!readings)
        return tl::make_unexpected(readings.error());
    const Digits digits = desk.arguments.raw ? Digits::Raw : Digits::Shown;
    QJsonArray list;
    QStringList refused;
    for (const drive::Reading &reading : *readings) {
        const QString name = QString::fromStdString(catalog.nameOf(reading.id));
        const bool ok = reading.status == drive::ReadStatus::Ok;
        if (!ok)
            refused.append(name);
        if (!desk.out.json()) {
            if (ok)
                desk.out.line(QStringLiteral("%1 = %2").arg(
                    name, valueText(catalog, reading.id, reading.value, digits)));
            continue;
        }
        if (ok)
            list.append(valueJson(catalog, reading.id, reading.value, digits));
        else
            list.append(QJsonObject{{QStringLiteral("name"), name},
                {QStringLiteral("id"), idText(reading.id)},
                {QStringLiteral("error"),
                    reading.status == drive::ReadStatus::Refused
                        ? QStringLiteral("refused")
                        : QStringLiteral("not supported")}});
    }
    if (desk.out.json())
        desk.out.line(list);
    if (!refused.isEmpty())
        return failure(kRefused,
            QStringLiteral("The board does not give %1; leave it out, or see rotorscope-cli "
                           "registers for what it gives.")
                .arg(refused.join(QStringLiteral(", "))));
    return kDone;
}

} // namespace

const Command kGet{.name = "get",
    .words = "NAME[@MOTOR]...",
    .help = "Reads registers, in A, V, rpm, degrees; with --raw as the numbers on the wire.",
    .least = 1,
    .most = kAnyWords,
    .options = {&kRawOption, 1},
    .run = runGet};

} // namespace cli
