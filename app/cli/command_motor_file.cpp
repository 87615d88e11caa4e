// motor: what the board says of its motor, beside a file, or into one.
#include "motor_facts.h"
#include "session/files/motor_file.h"
#include "snapshot_work.h"
#include "values.h"

#include <QJsonArray>
#include <QJsonObject>

#include <array>

namespace cli {

namespace {

using motor::MotorQuantity;
using motor::MotorWarning;

constexpr int kDigits = 7; ///< boards hold these numbers in 32 bits

// Each in the order of its enumeration.
constexpr std::array kQuantityNames{"pole_pairs", "rs", "ld", "lq", "flux", "current", "max_speed",
    "bus_voltage", "inertia", "friction", "dry_friction"};
constexpr std::array kWarningWords{"the pole pairs are no whole number from 1 to 50",
    "the resistance is missing or no motor's", "an inductance is missing or no motor's",
    "the flux is missing or no motor's", "the current is missing or no motor's",
    "Ld is greater than Lq, perhaps swapped", "L / R is outside 10 us to 1 s",
    "the motor's current is more than the drive can measure",
    "the greatest speed needs flux weakening"};

QString nameOf(MotorQuantity quantity)
{
    return QLatin1String(kQuantityNames.at(static_cast<std::size_t>(quantity)));
}

QString wordOf(MotorWarning warning)
{
    return QLatin1String(kWarningWords.at(static_cast<std::size_t>(warning)));
}

QString textOf(const std::optional<double> &value, std::string_view unit)
{
    if (!value)
        return QStringLiteral("-");
    const QString number = QString::number(*value, 'g', kDigits);
    return unit.empty() ? number : number + QLatin1Char(' ') + utf8Text(unit);
}

struct Derived {
    const char *name, *unit;
    std::optional<double> value;
};

std::vector<Derived> derivedOf(const drive::MotorFacts &facts)
{
    const auto constants = motor::motorConstants(facts.motor, facts.bus_v);
    return {{"kt", "N m/A", constants.kt_nmpa}, {"ke", "V/krpm", constants.ke_vrmsPerKrpm},
        {"kv", "rpm/V", constants.kv_rpmpv}, {"tau_q", "s", constants.timeConstantQ_s},
        {"tau_d", "s", constants.timeConstantD_s}, {"base_speed", "rpm", constants.baseSpeed_rpm}};
}

QJsonObject row(const QString &name, std::string_view unit, const std::optional<double> &board)
{
    return {{QStringLiteral("name"), name}, {QStringLiteral("unit"), utf8Text(unit)},
        {QStringLiteral("board"), orNull(board)}};
}

void print(Output &out, const drive::MotorFacts &facts, const motor::MotorSheet *file)
{
    const auto sheet = drive::sheetOf(facts);
    QJsonArray rows, derived, warnings;
    for (const auto &one : motor::compareMotors(sheet, file != nullptr ? *file : sheet)) {
        const auto unit = motor::motorQuantities()[static_cast<std::size_t>(one.quantity)].unit;
        QJsonObject object = row(nameOf(one.quantity), unit, one.here);
        QString line = nameOf(one.quantity).leftJustified(12) + textOf(one.here, unit);
        if (file != nullptr) {
            object[QStringLiteral("file")] = orNull(one.there);
            object[QStringLiteral("differs")] = one.differs;
            line = line.leftJustified(28) + QStringLiteral("  ") + textOf(one.there, unit)
                + (one.differs ? QStringLiteral("  differs") : QString());
        }
        rows.append(object);
        if (!out.json())
            out.line(line);
    }
    for (const Derived &one : derivedOf(facts)) {
        const QString name = QLatin1String(one.name);
        derived.append(row(name, one.unit, one.value));
        if (!out.json())
            out.line(name.leftJustified(12) + textOf(one.value, one.unit));
    }
    const motor::DriveLimits drive{
        facts.bus_v, facts.limits.maxCurrentAmps, facts.limits.maxSpeedRpm};
    for (const MotorWarning warning : motor::checkMotor(facts.motor, drive)) {
        warnings.append(wordOf(warning));
        if (!out.json())
            out.line(QStringLiteral("note: ") + wordOf(warning));
    }
    if (out.json())
        out.line(QJsonObject{{QStringLiteral("motor"), utf8Text(facts.name)},
            {QStringLiteral("values"), rows}, {QStringLiteral("derived"), derived},
            {QStringLiteral("warnings"), warnings}});
}

Outcome<int> runMotor(Desk &desk)
{
    const QString path = desk.arguments.words.value(0);
    std::optional<motor::MotorSheet> file;
    if (!path.isEmpty()) {
        const auto read = session::readMotorFile(path);
        if (!read)
            return failure(kFileError,
                QString::fromStdString(
                    session::motorFileErrorText(path.toStdString(), read.error()))
                    + QLatin1Char('.'));
        file = read->sheet();
    }
    const auto facts = readMotorFacts(desk);
    if (!facts)
        return tl::make_unexpected(facts.error());
    const QString &target = desk.arguments.tuning.file;
    if (!target.isEmpty())
        if (const auto saved = saveFile(target, session::motorJson(drive::sheetOf(*facts))); !saved)
            return saved;
    print(desk.out, *facts, file ? &*file : nullptr);
    return kDone;
}

Outcome<bool> readMotorFile(const Given &given, Arguments &arguments)
{
    arguments.tuning.file = given.value("output");
    return true;
}

} // namespace

const Command kMotor{.name = "motor",
    .words = "[FILE.json] [-o FILE.json]",
    .help = "Shows what the board says of its motor and what follows from it, beside a motor file "
            "or into one.",
    .most = 1,
    .options = {&kOutputOption, 1},
    .read = readMotorFile,
    .ofOneMotor = true,
    .run = runMotor};

} // namespace cli
