#include "commands.h"
#include "values.h"

#include <QJsonArray>
#include <QJsonObject>

#include <array>
#include <set>

namespace cli {

namespace {

using catalog::Access;
using catalog::RegisterInfo;
using catalog::Streaming;

const char *wordOf(Access access)
{
    constexpr std::array kWords{"-", "R", "W", "RW"};
    return kWords.at(static_cast<std::size_t>(access));
}

const char *wordOf(catalog::ValueType type)
{
    constexpr std::array kWords{"u8", "s8", "u16", "s16", "u32", "s32", "f32", "text", "raw"};
    return kWords.at(static_cast<std::size_t>(type));
}

QJsonObject jsonOf(const RegisterInfo &info, const QString &unit)
{
    QJsonArray aliases;
    for (const std::string &alias : info.aliases)
        aliases.append(QString::fromStdString(alias));
    return {{QStringLiteral("name"), QString::fromStdString(info.name)},
        {QStringLiteral("aliases"), aliases}, {QStringLiteral("id"), idText(info.id)},
        {QStringLiteral("type"), QLatin1String(wordOf(info.type))},
        {QStringLiteral("access"), QLatin1String(wordOf(info.access))},
        {QStringLiteral("unit"), unit},
        {QStringLiteral("group"), QString::fromStdString(info.group)},
        {QStringLiteral("per_motor"), info.perMotor},
        {QStringLiteral("streams"), info.streaming != Streaming::Polled},
        {QStringLiteral("help"), QString::fromStdString(info.help)}};
}

/// The readable registers that this board does not give, asked for one by one: its build decides what it has.
Outcome<std::set<catalog::RegisterId>> notGiven(Desk &desk)
{
    std::vector<catalog::RegisterId> ids;
    for (const RegisterInfo &info : desk.catalog().registers())
        if (info.readable())
            ids.push_back(desk.catalog().withMotor(info, 1));
    const auto readings = desk.talk.read(ids);
    if (!readings)
        return tl::make_unexpected(readings.error());
    std::set<catalog::RegisterId> missing;
    for (const drive::Reading &reading : *readings)
        if (reading.status != drive::ReadStatus::Ok)
            missing.insert(reading.id);
    return missing;
}

Outcome<int> runRegisters(Desk &desk)
{
    const catalog::Catalog &catalog = desk.catalog();
    const auto missing = notGiven(desk);
    if (!missing)
        return tl::make_unexpected(missing.error());
    QJsonArray list;
    for (const RegisterInfo &info : catalog.registers()) {
        const catalog::RegisterId id = catalog.withMotor(info, 1);
        const QString unit = QString::fromStdString(catalog.readScale(id).unit);
        const bool given = !missing->contains(id);
        if (desk.out.json()) {
            QJsonObject object = jsonOf(info, unit);
            if (info.readable())
                object.insert(QStringLiteral("given"), given);
            list.append(object);
            continue;
        }
        const QString stream = !given             ? QStringLiteral("not on this board")
            : info.streaming == Streaming::Polled ? QString()
                                                  : QStringLiteral("streams");
        desk.out.line(QStringLiteral("%1 %2 %3 %4 %5 %6")
                          .arg(QString::fromStdString(info.name).leftJustified(28), idText(info.id),
                              QString::fromLatin1(wordOf(info.type)).leftJustified(4),
                              QString::fromLatin1(wordOf(info.access)).leftJustified(2),
                              unit.leftJustified(8), stream)
                          .trimmed());
    }
    if (desk.out.json())
        desk.out.line(list);
    return kDone;
}

} // namespace

const Command kRegisters{.name = "registers",
    .help =
        "Lists the registers of the firmware's version, and marks what this board does not give.",
    .run = runRegisters};

} // namespace cli
