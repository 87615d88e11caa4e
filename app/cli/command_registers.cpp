#include "commands.h"
#include "values.h"

#include <QJsonArray>
#include <QJsonObject>

namespace cli {

namespace {

using catalog::Access;
using catalog::RegisterInfo;
using catalog::Streaming;

const char *wordOf(Access access)
{
    switch (access) {
    case Access::None:
        return "-";
    case Access::Read:
        return "R";
    case Access::Write:
        return "W";
    case Access::ReadWrite:
        return "RW";
    }
    return "-";
}

const char *wordOf(catalog::ValueType type)
{
    static const char *const words[] = {
        "u8", "s8", "u16", "s16", "u32", "s32", "f32", "text", "raw"};
    return words[static_cast<std::size_t>(type)];
}

QString text(const std::string &utf8) { return QString::fromStdString(utf8); }

QJsonObject jsonOf(const RegisterInfo &info, const QString &unit)
{
    QJsonArray aliases;
    for (const std::string &alias : info.aliases)
        aliases.append(text(alias));
    return {{QStringLiteral("name"), text(info.name)}, {QStringLiteral("aliases"), aliases},
        {QStringLiteral("id"), idText(info.id)},
        {QStringLiteral("type"), QLatin1String(wordOf(info.type))},
        {QStringLiteral("access"), QLatin1String(wordOf(info.access))},
        {QStringLiteral("unit"), unit}, {QStringLiteral("group"), text(info.group)},
        {QStringLiteral("per_motor"), info.perMotor},
        {QStringLiteral("streams"), info.streaming != Streaming::Polled},
        {QStringLiteral("help"), text(info.help)}};
}

Outcome<int> runRegisters(Desk &desk)
{
    const catalog::Catalog &catalog = desk.catalog();
    QJsonArray list;
    for (const RegisterInfo &info : catalog.registers()) {
        const QString unit = text(catalog.readScale(catalog.withMotor(info, 1)).unit);
        if (desk.out.json()) {
            list.append(jsonOf(info, unit));
            continue;
        }
        const QString stream =
            info.streaming == Streaming::Polled ? QString() : QStringLiteral("streams");
        desk.out.line(QStringLiteral("%1 %2 %3 %4 %5 %6")
                          .arg(text(info.name).leftJustified(28), idText(info.id),
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
    .help = "Lists the registers that the board's firmware has.",
    .run = runRegisters};

} // namespace cli
