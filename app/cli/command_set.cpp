#include "commands.h"
#include "values.h"
#include "write_report.h"

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

Outcome<int> runSet(Desk &desk)
{
    const Digits digits = desk.arguments.raw ? Digits::Raw : Digits::Shown;
    const auto wanted = wantedOf(desk, digits);
    if (!wanted)
        return tl::make_unexpected(wanted.error());
    drive::Write write = wanted->write;
    if (desk.arguments.expert)
        write.reach = drive::Reach::Everything;
    return writeAndReport(desk, write, digits, QStringLiteral("The writing"));
}

} // namespace

const Command kSet{.name = "set",
    .words = "NAME[@MOTOR]=VALUE...",
    .help = "Writes registers and prints each as old -> new, as read back. Values are in the unit "
            "that get shows, with --raw the numbers on the wire; the decimal sign is a point; "
            "structures are hexadecimal.",
    .least = 1,
    .most = kAnyWords,
    .options = {&kRawOption, 1},
    .canMove = true,
    .run = runSet};

} // namespace cli
