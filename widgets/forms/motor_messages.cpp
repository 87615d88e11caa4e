#include "widgets/forms/motor_messages.h"

#include "widgets/base/device_text.h"
#include "widgets/base/si_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <string_view>

namespace widgets {
namespace {

struct Motor {
    Q_DECLARE_TR_FUNCTIONS(Motor)
};

struct FieldRow {
    std::string_view key;
    const char *name;
    const char *help;
};

constexpr std::array kFields{
    FieldRow{"pole pairs", QT_TRANSLATE_NOOP("Motor", "Pole pairs"),
        QT_TRANSLATE_NOOP("Motor", "Electrical turns for each turn of the shaft.")},
    FieldRow{"rated flux", QT_TRANSLATE_NOOP("Motor", "Rated flux"),
        QT_TRANSLATE_NOOP("Motor",
            "Strength of the magnets, as the board has it: Ke (V rms between two terminals at 1000 "
            "rpm) in standard firmware, V/Hz in HSO firmware. Which of both is judged by the flux "
            "that it makes.")},
    FieldRow{"Rs", QT_TRANSLATE_NOOP("Motor", "Resistance Rs"),
        QT_TRANSLATE_NOOP(
            "Motor", "Of one phase: half of what is measured between two terminals.")},
    FieldRow{"skin factor", QT_TRANSLATE_NOOP("Motor", "Skin factor"),
        QT_TRANSLATE_NOOP("Motor", "0 in standard firmware: not used.")},
    FieldRow{"Lq", QT_TRANSLATE_NOOP("Motor", "Inductance Lq"),
        QT_TRANSLATE_NOOP("Motor", "Across the magnets, of one phase.")},
    FieldRow{"Ld", QT_TRANSLATE_NOOP("Motor", "Inductance Ld"),
        QT_TRANSLATE_NOOP("Motor",
            "Along the magnets, of one phase. Smaller than Lq where the magnets are buried.")},
    FieldRow{"max current", QT_TRANSLATE_NOOP("Motor", "Motor current"),
        QT_TRANSLATE_NOOP("Motor", "The motor's greatest current, peak.")},
    FieldRow{"copper mass", QT_TRANSLATE_NOOP("Motor", "Copper mass"),
        QT_TRANSLATE_NOOP("Motor", "0 in standard firmware: not used.")},
    FieldRow{"cooling tau", QT_TRANSLATE_NOOP("Motor", "Cooling time constant"),
        QT_TRANSLATE_NOOP("Motor", "0 in standard firmware: not used.")},
    FieldRow{"name", QT_TRANSLATE_NOOP("Motor", "Name"), ""},
    FieldRow{"max speed", QT_TRANSLATE_NOOP("Motor", "Greatest speed"),
        QT_TRANSLATE_NOOP("Motor", "No speed set-point goes beyond it.")},
    FieldRow{"max readable current", QT_TRANSLATE_NOOP("Motor", "Greatest readable current"),
        QT_TRANSLATE_NOOP("Motor",
            "The end of the current converters' range; more is not seen and not controlled.")},
    FieldRow{"nominal current", QT_TRANSLATE_NOOP("Motor", "Nominal current"),
        QT_TRANSLATE_NOOP("Motor", "No current set-point goes beyond it.")},
    FieldRow{"nominal voltage", QT_TRANSLATE_NOOP("Motor", "Nominal bus voltage"),
        QT_TRANSLATE_NOOP("Motor", "What gains and the voltage scale were made for.")},
    FieldRow{"drive type", QT_TRANSLATE_NOOP("Motor", "Drive type"), ""},
    FieldRow{"primary sensor", QT_TRANSLATE_NOOP("Motor", "Main speed sensor"), ""},
    FieldRow{"auxiliary sensor", QT_TRANSLATE_NOOP("Motor", "Auxiliary speed sensor"), ""},
    FieldRow{"topology", QT_TRANSLATE_NOOP("Motor", "Current sensing"), ""},
    FieldRow{"FOC rate", QT_TRANSLATE_NOOP("Motor", "PWM periods a control period"), ""},
    FieldRow{"PWM frequency", QT_TRANSLATE_NOOP("Motor", "Switching frequency (PWM)"), ""},
    FieldRow{"medium frequency", QT_TRANSLATE_NOOP("Motor", "Speed loop rate"), ""},
    FieldRow{"flags 1", QT_TRANSLATE_NOOP("Motor", "Built with"), ""},
    FieldRow{"flags 2", QT_TRANSLATE_NOOP("Motor", "Built with, too"), ""},
    FieldRow{"drive mode", QT_TRANSLATE_NOOP("Motor", "Drive mode"), ""},
    FieldRow{"voltage", QT_TRANSLATE_NOOP("Motor", "Voltage"),
        QT_TRANSLATE_NOOP("Motor", "What one digit of a phase voltage is worth.")},
    FieldRow{"current", QT_TRANSLATE_NOOP("Motor", "Current"),
        QT_TRANSLATE_NOOP("Motor", "What one digit of a current is worth.")},
    FieldRow{"frequency", QT_TRANSLATE_NOOP("Motor", "Speed"),
        QT_TRANSLATE_NOOP("Motor", "What one digit of a speed is worth.")},
    FieldRow{"version", QT_TRANSLATE_NOOP("Motor", "Firmware version"), ""},
    FieldRow{"motors", QT_TRANSLATE_NOOP("Motor", "Motors"), ""},
    FieldRow{"flags", QT_TRANSLATE_NOOP("Motor", "Streams over"), ""},
    FieldRow{"streams UART A", QT_TRANSLATE_NOOP("Motor", "Signals at once, UART A"), ""},
    FieldRow{"streams UART B", QT_TRANSLATE_NOOP("Motor", "Signals at once, UART B"), ""},
    FieldRow{"streams ST-LINK", QT_TRANSLATE_NOOP("Motor", "Signals at once, ST-LINK"), ""},
};

/// By MotorQuantity.
constexpr std::array kQuantities{
    QT_TRANSLATE_NOOP("Motor", "Pole pairs"),
    QT_TRANSLATE_NOOP("Motor", "Resistance Rs"),
    QT_TRANSLATE_NOOP("Motor", "Inductance Ld"),
    QT_TRANSLATE_NOOP("Motor", "Inductance Lq"),
    QT_TRANSLATE_NOOP("Motor", "Flux of the magnets"),
    QT_TRANSLATE_NOOP("Motor", "Motor current"),
    QT_TRANSLATE_NOOP("Motor", "Greatest speed"),
    QT_TRANSLATE_NOOP("Motor", "Nominal bus voltage"),
    QT_TRANSLATE_NOOP("Motor", "Inertia"),
    QT_TRANSLATE_NOOP("Motor", "Viscous friction"),
    QT_TRANSLATE_NOOP("Motor", "Dry friction"),
};
static_assert(
    kQuantities.size() == static_cast<std::size_t>(motor::MotorQuantity::DryFriction) + 1);

QString wantedText(const session::MotorFileError &error)
{
    using Wanted = session::MotorFileError::Wanted;
    const QString least = plainNumberText(error.least), most = plainNumberText(error.most);
    switch (error.wanted) {
    case Wanted::YesOrNo:
        return Motor::tr("It takes true or false.");
    case Wanted::Text:
        return Motor::tr("It takes a text of at most %1 bytes.").arg(most);
    case Wanted::WholeNumber:
        return Motor::tr("It takes a whole number from %1 to %2.").arg(least, most);
    case Wanted::Number:
        break;
    }
    return Motor::tr("It takes a number from %1 to %2.").arg(least, most);
}

} // namespace

FieldText fieldText(const std::string &key)
{
    const auto row = std::ranges::find(kFields, key, &FieldRow::key);
    if (row == kFields.end())
        return {deviceText(key), {}};
    return {Motor::tr(row->name), *row->help == '\0' ? QString() : Motor::tr(row->help)};
}

QString structureText(drive::StructureView::Of what)
{
    const QString texts[] = {Motor::tr("Motor"), Motor::tr("Limits of the drive"),
        Motor::tr("Control firmware"), Motor::tr("Scales"), Motor::tr("Board")};
    return texts[static_cast<std::size_t>(what)];
}

QString motorQuantityText(motor::MotorQuantity quantity)
{
    return Motor::tr(kQuantities.at(static_cast<std::size_t>(quantity)));
}

QString motorWarningText(motor::MotorWarning warning)
{
    using motor::MotorWarning;
    switch (warning) {
    case MotorWarning::PolePairsMissing:
        return Motor::tr("The pole pairs are no whole number from 1 to 50: count the magnets and "
                         "halve, and set them in the firmware's project.");
    case MotorWarning::ResistanceImplausible:
        return Motor::tr("The resistance is missing or no motor's: measure between two terminals "
                         "and take half.");
    case MotorWarning::InductanceImplausible:
        return Motor::tr("An inductance is missing or no motor's: check whether millihenry were "
                         "given as henry.");
    case MotorWarning::FluxImplausible:
        return Motor::tr("The strength of the magnets is missing or no motor's: the converter "
                         "gives Ke from KV or from a measurement.");
    case MotorWarning::NominalCurrentImplausible:
        return Motor::tr("The motor's current is missing or no motor's: take the nominal current "
                         "of the data sheet, times 1.414 if that is rms.");
    case MotorWarning::LdAboveLq:
        return Motor::tr("Ld is greater than Lq, which no magnet motor is: ST's generator may have "
                         "swapped them. Measure both before gains are made of them.");
    case MotorWarning::TimeConstantImplausible:
        return Motor::tr("L / R is outside 10 \u00b5s to 1 s: one of them has the wrong unit, or "
                         "one is between terminals and the other of a phase.");
    case MotorWarning::NominalCurrentBeyondDrive:
        return Motor::tr("The motor's current is more than the drive can measure: keep set-points "
                         "below, or take another shunt or gain.");
    case MotorWarning::SpeedBeyondBaseSpeed:
        return Motor::tr("The greatest speed is beyond the base speed: with nominal current and "
                         "bus voltage it needs flux weakening.");
    }
    return {};
}

QString motorFileErrorText(const session::MotorFileError &error)
{
    using Kind = session::MotorFileError::Kind;
    const QString place = deviceText(error.place), detail = QString::fromStdString(error.detail);
    switch (error.kind) {
    case Kind::Unreadable:
        return Motor::tr("It cannot be read: %1").arg(detail);
    case Kind::TooLarge:
        return Motor::tr("It is larger than any description of a motor.");
    case Kind::NotJson:
        return Motor::tr("Line %1 is no JSON: %2").arg(QString::number(error.line), detail);
    case Kind::NotAnObject:
        return place.isEmpty()
            ? Motor::tr("It is no JSON object with %1.").arg(detail)
            : Motor::tr("At \u201c%1\u201d there has to be an object with %2.").arg(place, detail);
    case Kind::UnknownKey:
        return Motor::tr("There is no key \u201c%1\u201d; there are %2.").arg(place, detail);
    case Kind::UnknownPreset:
        return Motor::tr("Its preset is none of the simulator's.");
    case Kind::WrongValue:
        return Motor::tr("The value of \u201c%1\u201d cannot be used.").arg(place)
            + QLatin1Char(' ') + wantedText(error);
    case Kind::Missing:
        return Motor::tr("\u201c%1\u201d is missing.").arg(place);
    case Kind::RangeBelowSupply:
        break;
    }
    return Motor::tr("\u201c%1\u201d is below the supply voltage.").arg(place);
}

QString motorFileNoteText(session::MotorFile::Note note)
{
    using Note = session::MotorFile::Note;
    switch (note) {
    case Note::InductanceInMillihenry:
        return Motor::tr("\u201cls\u201d was taken as millihenry: as henry it would be no motor.");
    case Note::OneInductanceOnly:
        return Motor::tr("Only one inductance was measured: of a motor with buried magnets, "
                         "measure Ld and Lq.");
    case Note::UnknownKeysLeftOut:
        break;
    }
    return Motor::tr("Keys that are not known were passed over.");
}

} // namespace widgets
