// Our own form, checked against the simulator's table of parameters.
#include "session/files/motor_file.h"

#include "base/text.h"
#include "session/files/motor_file_st.h"
#include "session/files/whole_file.h"
#include "simulation/plant/parameter_table.h"
#include "simulation/plant/presets.h"

#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace session {

namespace {

using motor::MotorSheet;
using simulation::ParameterInfo;
using simulation::PlantParameters;
using Kind = MotorFileError::Kind;

constexpr double kRoomAboveSupply = 1.5; ///< as the presets have it

/// Where a figure of a description stands in a file.
struct Place {
    std::optional<double> MotorSheet::*member;
    std::string_view section, name;
};
constexpr std::array kPlaces{
    Place{&MotorSheet::polePairs, "motor", "polePairs"},
    Place{&MotorSheet::rs_ohm, "motor", "rs_ohm"},
    Place{&MotorSheet::ld_h, "motor", "ld_h"},
    Place{&MotorSheet::lq_h, "motor", "lq_h"},
    Place{&MotorSheet::flux_wb, "motor", "flux_wb"},
    Place{&MotorSheet::inertia_kgm2, "motor", "inertia_kgm2"},
    Place{&MotorSheet::viscous_nms, "motor", "viscous_nms"},
    Place{&MotorSheet::coulomb_nm, "motor", "coulomb_nm"},
    Place{&MotorSheet::nominalCurrent_a, "motor", "nominal_a"},
    Place{&MotorSheet::maxSpeed_rpm, "motor", "maxSpeed_rpm"},
    Place{&MotorSheet::bus_v, "inverter", "supply_v"},
};

std::string pathOf(std::string_view section, std::string_view name)
{
    return std::string(section) + '.' + std::string(name);
}

std::string sectionNames()
{
    std::string names = "preset";
    std::string_view last;
    for (const ParameterInfo &info : simulation::parameterTable()) {
        if (info.section != last)
            names += ", " + std::string(info.section);
        last = info.section;
    }
    return names;
}

std::string namesIn(std::string_view section)
{
    std::string names;
    for (const ParameterInfo &info : simulation::parameterTable())
        if (info.section == section)
            names += (names.empty() ? "" : ", ") + std::string(info.name);
    return names;
}

const ParameterInfo *rowOf(std::string_view section, std::string_view name)
{
    const auto table = simulation::parameterTable();
    const auto row = std::ranges::find_if(table,
        [&](const ParameterInfo &info) { return info.section == section && info.name == name; });
    return row == table.end() ? nullptr : &*row;
}

bool put(const ParameterInfo::Slot &slot, const QJsonValue &value)
{
    if (bool *const *flag = std::get_if<bool *>(&slot)) {
        **flag = value.toBool();
        return value.isBool();
    }
    if (std::string *const *text = std::get_if<std::string *>(&slot)) {
        **text = value.toString().toStdString();
        return value.isString();
    }
    const double number = value.toDouble();
    if (int *const *whole = std::get_if<int *>(&slot)) {
        constexpr double kMost = 1e9;
        const bool fits =
            value.isDouble() && std::abs(number) < kMost && number == std::trunc(number);
        **whole = fits ? static_cast<int>(number) : 0;
        return fits;
    }
    *std::get<double *>(slot) = number;
    return value.isDouble();
}

MotorFileError::Wanted wantedBy(const ParameterInfo::Slot &slot)
{
    return std::holds_alternative<bool *>(slot)       ? MotorFileError::Wanted::YesOrNo
        : std::holds_alternative<std::string *>(slot) ? MotorFileError::Wanted::Text
        : std::holds_alternative<int *>(slot)         ? MotorFileError::Wanted::WholeNumber
                                                      : MotorFileError::Wanted::Number;
}

class OwnReader {
public:
    Result<MotorFile, MotorFileError> read(const QJsonObject &object)
    {
        m_file.machine = simulation::presets().front().parameters;
        if (object.contains(QLatin1String("preset"))
            && !parsePreset(object[QLatin1String("preset")]))
            return fail(m_error);
        for (auto at = object.begin(); at != object.end(); ++at)
            if (at.key() != QLatin1String("preset")
                && !parseSection(at.key().toStdString(), at.value()))
                return fail(m_error);
        if (!settleBus(m_file))
            return fail(
                MotorFileError{.kind = Kind::RangeBelowSupply, .place = "inverter.busRange_v"});
        return m_file;
    }

    /// A range that was not given follows the supply. False: the one that was given is below it.
    static bool settleBus(MotorFile &file)
    {
        auto &inverter = file.machine.inverter;
        if (inverter.busRange_v >= inverter.supply_v)
            return true;
        if (file.given.contains("inverter.busRange_v"))
            return false;
        inverter.busRange_v = kRoomAboveSupply * inverter.supply_v;
        return true;
    }

private:
    bool complain(MotorFileError error)
    {
        m_error = std::move(error);
        return false;
    }

    bool parsePreset(const QJsonValue &value)
    {
        const auto *preset = simulation::findPreset(value.toString().toStdString());
        if (preset == nullptr)
            return complain({.kind = Kind::UnknownPreset, .place = "preset"});
        m_file.machine = *preset;
        for (const ParameterInfo &info : simulation::parameterTable())
            if (info.name != "busRange_v") // follows the supply where that is given
                m_file.given.insert(pathOf(info.section, info.name));
        return true;
    }

    bool parseSection(const std::string &section, const QJsonValue &value)
    {
        if (namesIn(section).empty())
            return complain({.kind = Kind::UnknownKey, .place = section, .detail = sectionNames()});
        if (!value.isObject())
            return complain(
                {.kind = Kind::NotAnObject, .place = section, .detail = namesIn(section)});
        const QJsonObject object = value.toObject();
        for (auto at = object.begin(); at != object.end(); ++at)
            if (!parseValue(section, at.key().toStdString(), at.value()))
                return false;
        return true;
    }

    bool parseValue(const std::string &section, const std::string &name, const QJsonValue &value)
    {
        const ParameterInfo *row = rowOf(section, name);
        if (row == nullptr)
            return complain({.kind = Kind::UnknownKey,
                .place = pathOf(section, name),
                .detail = namesIn(section)});
        const ParameterInfo::Slot slot = row->slot(m_file.machine);
        if (!put(slot, value) || !simulation::withinBounds(*row, m_file.machine))
            return complain({.kind = Kind::WrongValue,
                .place = pathOf(section, name),
                .wanted = wantedBy(slot),
                .least = row->least,
                .most = row->most});
        m_file.given.insert(pathOf(section, name));
        return true;
    }

    MotorFile m_file;
    MotorFileError m_error;
};

/// 1 for the first line.
std::size_t lineOf(const QByteArray &text, int offset)
{
    return 1 + static_cast<std::size_t>(text.left(std::max(offset, 0)).count('\n'));
}

std::string allowedText(const MotorFileError &error)
{
    const std::string range = decimalText(error.least) + " to " + decimalText(error.most);
    switch (error.wanted) {
    case MotorFileError::Wanted::YesOrNo:
        return "true or false";
    case MotorFileError::Wanted::Text:
        return "a text of at most " + decimalText(error.most) + " bytes";
    case MotorFileError::Wanted::WholeNumber:
        return "a whole number from " + range;
    case MotorFileError::Wanted::Number:
        break;
    }
    return "a number from " + range;
}

/// Boards hold 0.35 as a float: written out in full it would look like a measurement.
double rounded(double value)
{
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), static_cast<float>(value)).ptr;
    double read = value;
    readDecimal(text.data(), end, read);
    return read;
}

} // namespace

std::string motorFileErrorText(const std::string &file, const MotorFileError &error)
{
    const std::string at = file + ": " + (error.place.empty() ? "" : error.place + ": ");
    switch (error.kind) {
    case Kind::Unreadable:
        return file + ": cannot be read: " + error.detail;
    case Kind::TooLarge:
        return file + ": is larger than any description of a motor";
    case Kind::NotJson:
        return file + ": line " + std::to_string(error.line) + ": no JSON (" + error.detail + ')';
    case Kind::NotAnObject:
        return at + "must be an object of " + error.detail;
    case Kind::UnknownKey: {
        const std::size_t dot = error.place.find('.');
        const bool inside = dot != std::string::npos;
        return file + ": " + (inside ? error.place.substr(0, dot) + ": " : "")
            + "there is no key \"" + error.place.substr(inside ? dot + 1 : 0) + "\"; there are "
            + error.detail;
    }
    case Kind::UnknownPreset:
        return at + "there is no motor of that name; see rotorscope-sim --list-motors";
    case Kind::WrongValue:
        return at + "must be " + allowedText(error);
    case Kind::Missing:
        return at + "is missing";
    case Kind::RangeBelowSupply:
        break;
    }
    return at + "must not be below supply_v";
}

MotorSheet MotorFile::sheet() const
{
    MotorSheet sheet;
    PlantParameters copy = machine;
    if (given.contains("motor.name"))
        sheet.name = machine.motor.name;
    for (const Place &place : kPlaces) {
        const ParameterInfo *row = rowOf(place.section, place.name);
        if (row != nullptr && given.contains(pathOf(place.section, place.name)))
            sheet.*place.member = simulation::numberAt(row->slot(copy));
    }
    return sheet;
}

Result<MotorFile, MotorFileError> readMotor(const QByteArray &json)
{
    if (json.size() > kMostText)
        return fail(MotorFileError{.kind = Kind::TooLarge});
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (document.isNull())
        return fail(MotorFileError{.kind = Kind::NotJson,
            .line = lineOf(json, error.offset),
            .detail = error.errorString().toStdString()});
    if (!document.isObject())
        return fail(MotorFileError{.kind = Kind::NotAnObject, .detail = sectionNames()});
    if (isStMotor(document.object())) {
        auto file = readStMotor(document.object());
        if (file)
            OwnReader::settleBus(*file);
        return file;
    }
    return OwnReader().read(document.object());
}

Result<MotorFile, MotorFileError> readMotorFile(const QString &path)
{
    if (QFileInfo(path).size() > kMostText)
        return fail(MotorFileError{.kind = Kind::TooLarge});
    const auto content = readWholeFile(path, kMostText);
    if (!content)
        return fail(
            MotorFileError{.kind = Kind::Unreadable, .detail = content.error().toStdString()});
    return readMotor(*content);
}

QByteArray motorJson(const MotorSheet &sheet)
{
    PlantParameters scratch;
    QJsonObject sections;
    const auto insert = [&](std::string_view section, std::string_view name,
                            const QJsonValue &value) {
        const ParameterInfo *row = rowOf(section, name);
        if (row == nullptr || !put(row->slot(scratch), value)
            || !simulation::withinBounds(*row, scratch))
            return; // no machine can be so, and no reader would take it
        const QString key = QString::fromUtf8(section);
        QJsonObject object = sections[key].toObject();
        object[QString::fromUtf8(name)] = value;
        sections[key] = object;
    };
    if (!sheet.name.empty())
        insert("motor", "name", QString::fromStdString(sheet.name));
    for (const Place &place : kPlaces)
        if (const auto &value = sheet.*place.member)
            insert(place.section, place.name, rounded(*value));
    return QJsonDocument(sections).toJson();
}

} // namespace session
