// Reading with Qt's JSON, checking against the table of parameters.
#include "motor_file.h"

#include "json_text.h"
#include "simulation/plant/parameter_table.h"
#include "simulation/plant/presets.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

namespace sim {

namespace {

using simulation::ParameterInfo;
using simulation::PlantParameters;

constexpr std::size_t kMostBytes = 1 << 20; ///< a file of parameters has a few hundred

std::string range(const ParameterInfo &info)
{
    return jsonNumber(info.least) + " to " + jsonNumber(info.most);
}

/// What a value of this row may be, for sentences.
std::string allowed(const ParameterInfo &info, const ParameterInfo::Slot &slot)
{
    if (std::holds_alternative<bool *>(slot))
        return "true or false";
    if (std::holds_alternative<std::string *>(slot))
        return "a text of at most " + jsonNumber(info.most) + " bytes";
    if (std::holds_alternative<int *>(slot))
        return "a whole number from " + range(info);
    return "a number from " + range(info);
}

std::string sectionNames()
{
    std::string names;
    std::string_view last;
    for (const ParameterInfo &info : simulation::parameterTable()) {
        if (info.section != last)
            names += ", " + std::string(info.section);
        last = info.section;
    }
    return names;
}

std::string namesIn(const std::string &section)
{
    std::string names;
    for (const ParameterInfo &info : simulation::parameterTable()) {
        if (info.section == section)
            names += (names.empty() ? "" : ", ") + std::string(info.name);
    }
    return names;
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

class Reader {
public:
    explicit Reader(std::string file)
        : m_file(std::move(file))
    {
    }

    Result<PlantParameters, std::string> read(const QJsonObject &object)
    {
        m_machine = simulation::presets().front().parameters;
        if (object.contains(QLatin1String("preset"))
            && !takePreset(object[QLatin1String("preset")]))
            return fail(m_problem);
        for (auto at = object.begin(); at != object.end(); ++at) {
            if (at.key() != QLatin1String("preset")
                && !takeSection(at.key().toStdString(), at.value()))
                return fail(m_problem);
        }
        if (const auto name = simulation::impossibleParameter(m_machine); !name.empty())
            return fail(m_file + ": " + std::string(name) + ": must not be below supply_v");
        return m_machine;
    }

private:
    bool complain(const std::string &what)
    {
        m_problem = m_file + ": " + what;
        return false;
    }

    bool takePreset(const QJsonValue &value)
    {
        const auto *preset = simulation::findPreset(value.toString().toStdString());
        if (preset == nullptr)
            return complain("preset: there is no motor of that name; see --list-motors");
        m_machine = *preset;
        return true;
    }

    bool takeSection(const std::string &section, const QJsonValue &value)
    {
        if (namesIn(section).empty())
            return complain(
                "there is no key " + jsonText(section) + "; there are preset" + sectionNames());
        if (!value.isObject())
            return complain(section + ": must be an object of " + namesIn(section));
        const QJsonObject object = value.toObject();
        for (auto at = object.begin(); at != object.end(); ++at) {
            if (!takeValue(section, at.key().toStdString(), at.value()))
                return false;
        }
        return true;
    }

    bool takeValue(const std::string &section, const std::string &name, const QJsonValue &value)
    {
        const auto table = simulation::parameterTable();
        const auto row = std::find_if(table.begin(), table.end(), [&](const ParameterInfo &info) {
            return info.section == section && info.name == name;
        });
        if (row == table.end())
            return complain(section + ": there is no key " + jsonText(name) + "; there are "
                + namesIn(section));
        const ParameterInfo::Slot slot = row->slot(m_machine);
        if (put(slot, value) && simulation::withinBounds(*row, m_machine))
            return true;
        return complain(section + "." + name + ": must be " + allowed(*row, slot));
    }

    std::string m_file;
    PlantParameters m_machine;
    std::string m_problem;
};

/// 1 for the first line.
std::size_t lineOf(std::string_view text, int offset)
{
    const auto before = text.substr(0, static_cast<std::size_t>(std::max(offset, 0)));
    return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

} // namespace

Result<PlantParameters, std::string> readMotor(std::string_view json, const std::string &name)
{
    QJsonParseError error;
    const QByteArray bytes(json.data(), static_cast<qsizetype>(json.size()));
    const QJsonDocument document = QJsonDocument::fromJson(bytes, &error);
    if (document.isNull())
        return fail(name + ": line " + std::to_string(lineOf(json, error.offset)) + ": no JSON ("
            + error.errorString().toStdString() + ')');
    if (!document.isObject())
        return fail(name + ": must be an object with the keys preset" + sectionNames());
    return Reader(name).read(document.object());
}

Result<PlantParameters, std::string> readMotorFile(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    std::string text;
    if (file)
        text.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    if (!file || file.bad())
        return fail(path + ": cannot be read: " + std::strerror(errno != 0 ? errno : EIO));
    if (text.size() > kMostBytes)
        return fail(path + ": is larger than any description of a motor");
    return readMotor(text, path);
}

} // namespace sim
