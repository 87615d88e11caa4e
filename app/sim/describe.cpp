// The object, key by key in the order a reader wants.
#include "describe.h"

#include "json_text.h"
#include "simulation/plant/parameter_table.h"
#include "simulation/profile.h"

#include <array>
#include <cmath>

namespace sim {

namespace {

using simulation::BoardOptions;
using simulation::Build;
using simulation::ParameterInfo;
using simulation::PlantParameters;

/// Objects, arrays and values, indented.
class JsonWriter {
public:
    void open(std::string_view key, char bracket = '{')
    {
        begin(key);
        m_text += bracket;
        m_closing += bracket == '{' ? '}' : ']';
        m_first = true;
    }
    void close()
    {
        const char bracket = m_closing.back();
        m_closing.pop_back();
        if (!m_first)
            newLine();
        m_text += bracket;
        m_first = false;
    }
    void put(std::string_view key, double value) { plain(key, jsonNumber(value)); }
    void put(std::string_view key, int value) { plain(key, std::to_string(value)); }
    void put(std::string_view key, std::uint64_t value) { plain(key, std::to_string(value)); }
    void put(std::string_view key, bool value) { plain(key, value ? "true" : "false"); }
    void put(std::string_view key, std::string_view value) { plain(key, jsonText(value)); }
    // A text literal would rather be a bool.
    void put(std::string_view key, const char *value) { put(key, std::string_view(value)); }

    std::string take() { return std::move(m_text) + '\n'; }

private:
    void plain(std::string_view key, std::string_view value)
    {
        begin(key);
        m_text += value;
    }
    void begin(std::string_view key)
    {
        if (!m_first)
            m_text += ',';
        if (!m_closing.empty())
            newLine();
        m_first = false;
        if (!key.empty())
            m_text += jsonText(key) + ": ";
    }
    void newLine() { m_text += '\n' + std::string(2 * m_closing.size(), ' '); }

    std::string m_text, m_closing;
    bool m_first = true;
};

std::string_view familyName(simulation::Family family)
{
    switch (family) {
    case simulation::Family::Foc:
        return "FOC";
    case simulation::Family::SixStep:
        return "six-step";
    case simulation::Family::Hso:
        return "HSO/ZeST";
    }
    return {};
}

std::string_view sensorName(simulation::SpeedSensor sensor)
{
    constexpr std::array<std::string_view, 7> kNames{"none", "observer and PLL",
        "observer and CORDIC", "encoder", "Hall sensors", "HSO", "ZeST"};
    return kNames[static_cast<std::size_t>(sensor)];
}

std::string versionText(std::uint32_t version)
{
    return std::to_string(version >> 24) + '.' + std::to_string(version >> 16 & 0xFFU) + '.'
        + std::to_string(version >> 8 & 0xFFU);
}

void putFirmware(JsonWriter &json, const simulation::Traits &traits, const Build &build)
{
    json.open("firmware");
    json.put("name", traits.firmwareName);
    json.put("sdkVersion", versionText(traits.sdkVersion));
    json.put("family", familyName(build.family));
    json.put("mainSensor", sensorName(build.mainSensor));
    json.put("auxiliarySensor", sensorName(build.auxiliarySensor));
    json.put("motors", build.motors);
    json.open("builtIn");
    for (const simulation::BuildOption &option : simulation::buildOptions())
        json.put(option.name, build.*option.member);
    json.close();
    json.open("quirks");
    json.put("decodesHeadersInInterrupt", traits.decodesInInterrupt);
    json.put("cutsPingNumber", traits.truncatesPingNumber);
    json.put("ignoresMotorBits", traits.ignoresMotorBits);
    json.put("invertsStartStop", traits.invertsStartStop);
    json.put("hasSoftReset", traits.hasSoftReset);
    json.put("hasScaleConfig", traits.hasScaleConfig);
    json.put("nominalCurrentInDigits", traits.nominalCurrentInDigits);
    json.put("swapsPositionRamp", traits.swapsPositionRamp);
    json.put("flushesDatalogOnFault", traits.flushesOnFault);
    json.put("scalesReadSpeeds", traits.scalesReadSpeeds);
    json.put("asPrinted", traits.asPrinted);
    json.close();
    json.close();
}

void putLink(JsonWriter &json, const BoardOptions &options)
{
    json.open("link");
    json.put("baud", std::uint64_t{options.baud});
    json.put("request_bytes", std::uint64_t{options.rxMax});
    json.put("response_bytes", std::uint64_t{options.txSyncMax});
    json.put("datalog_bytes", std::uint64_t{options.txAsyncMax});
    json.put("datalogSignals", options.streams);
    json.put("firstTimestamp", std::uint64_t{options.firstTimestamp});
    json.put("dataCrc", options.dataCrc);
    json.put("protocolVersion", options.version);
    json.put("linkId", options.linkId);
    json.put("nullCheck", options.nullCheck);
    json.put("wideDatalog", options.wide);
    json.put("userCommands", options.userCallbacks);
    json.put("watchdog_ms", options.watchdogMs);
    json.close();
}

void putMachine(JsonWriter &json, PlantParameters machine)
{
    std::string_view section;
    json.open("machine");
    for (const ParameterInfo &info : simulation::parameterTable()) {
        if (info.section != section) {
            if (!section.empty())
                json.close();
            json.open(info.section);
            section = info.section;
        }
        std::visit([&](const auto *value) { json.put(info.name, *value); }, info.slot(machine));
    }
    json.close();
    json.close();
}

/// What a digit of the registers stands for; the formulas are those of SCALE_CONFIG.
void putScales(JsonWriter &json, const PlantParameters &machine)
{
    constexpr double kFullScale = 32768.0, kMostVoltage = 32767.0;
    json.open("scales");
    json.put("current_a", machine.inverter.maxReadable_a() / kFullScale);
    json.put("voltage_v", machine.inverter.supply_v / (std::sqrt(3.0) * kMostVoltage));
    json.put("speed_rpm", 6.0);
    json.close();
}

void putLies(JsonWriter &json, const BoardOptions &options)
{
    json.open("lies", '[');
    for (const simulation::LieChoice &choice : options.lies) {
        const simulation::LieInfo &info = simulation::lies()[static_cast<std::size_t>(choice.lie)];
        json.open({});
        json.put("name", info.name);
        json.put("oneIn", std::uint64_t{choice.oneIn > 0 ? choice.oneIn : info.oneIn});
        json.close();
    }
    json.close();
}

} // namespace

std::string describe(const BoardOptions &options)
{
    const simulation::Traits *traits = simulation::findTraits(options.profile);
    const auto machine = simulation::plantOf(options);
    if (traits == nullptr || !machine)
        return "{}\n";
    JsonWriter json;
    json.open({});
    json.put("profile", options.profile);
    putFirmware(json, *traits, simulation::buildOf(options));
    json.put("control_hz", options.hfHz);
    json.put("seed", options.seed);
    putLink(json, options);
    putLies(json, options);
    putScales(json, *machine);
    putMachine(json, *machine);
    json.close();
    return json.take();
}

} // namespace sim
