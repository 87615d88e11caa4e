// The object, key by key in the order a reader wants.
#include "describe.h"

#include "session/files/json_text.h"
#include "simulation/mcp/profile.h"
#include "simulation/plant/parameter_table.h"

#include <array>
#include <cmath>

namespace sim {

namespace {

using simulation::BoardOptions;
using simulation::Build;
using simulation::ParameterInfo;
using simulation::PlantParameters;

using session::JsonText;

std::string_view familyName(simulation::Family family)
{
    constexpr std::array<std::string_view, 3> kNames{"FOC", "six-step", "HSO/ZeST"};
    return kNames[static_cast<std::size_t>(family)];
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

void putFirmware(JsonText &json, const simulation::Traits &traits, const Build &build)
{
    json.beginObject("firmware");
    json.member("name", traits.firmwareName);
    json.member("sdkVersion", versionText(traits.sdkVersion));
    json.member("family", familyName(build.family));
    json.member("mainSensor", sensorName(build.mainSensor));
    json.member("auxiliarySensor", sensorName(build.auxiliarySensor));
    json.member("motors", build.motors);
    json.beginObject("builtIn");
    for (const simulation::BuildOption &option : simulation::buildOptions())
        json.member(option.name, build.*option.member);
    json.endObject();
    json.beginObject("quirks");
    json.member("decodesHeadersInInterrupt", traits.decodesInInterrupt);
    json.member("cutsPingNumber", traits.truncatesPingNumber);
    json.member("ignoresMotorBits", traits.ignoresMotorBits);
    json.member("invertsStartStop", traits.invertsStartStop);
    json.member("hasSoftReset", traits.hasSoftReset);
    json.member("hasScaleConfig", traits.hasScaleConfig);
    json.member("nominalCurrentInDigits", traits.nominalCurrentInDigits);
    json.member("swapsPositionRamp", traits.swapsPositionRamp);
    json.member("flushesDatalogOnFault", traits.flushesOnFault);
    json.member("scalesReadSpeeds", traits.scalesReadSpeeds);
    json.member("asPrinted", traits.asPrinted);
    json.endObject();
    json.endObject();
}

void putLink(JsonText &json, const BoardOptions &options)
{
    json.beginObject("link");
    json.member("baud", options.baud);
    json.member("request_bytes", options.rxMax);
    json.member("response_bytes", options.txSyncMax);
    json.member("datalog_bytes", options.txAsyncMax);
    json.member("datalogSignals", options.streams);
    json.member("firstTimestamp", options.firstTimestamp);
    json.member("dataCrc", options.dataCrc);
    json.member("protocolVersion", options.version);
    json.member("linkId", options.linkId);
    json.member("nullCheck", options.nullCheck);
    json.member("wideDatalog", options.wide);
    json.member("userCommands", options.userCallbacks);
    json.member("watchdog_ms", options.watchdogMs);
    json.endObject();
}

void putMachine(JsonText &json, PlantParameters machine)
{
    std::string_view section;
    json.beginObject("machine");
    for (const ParameterInfo &info : simulation::parameterTable()) {
        if (info.section != section) {
            if (!section.empty())
                json.endObject();
            json.beginObject(info.section);
            section = info.section;
        }
        std::visit([&](const auto *value) { json.member(info.name, *value); }, info.slot(machine));
    }
    json.endObject();
    json.endObject();
}

/// What a digit of the registers stands for; the formulas are those of SCALE_CONFIG.
void putScales(JsonText &json, const PlantParameters &machine)
{
    constexpr double kFullScale = 32768.0, kMostVoltage = 32767.0;
    json.beginObject("scales");
    json.member("current_a", machine.inverter.maxReadable_a() / kFullScale);
    json.member("voltage_v", machine.inverter.supply_v / (std::sqrt(3.0) * kMostVoltage));
    json.member("speed_rpm", 6.0);
    json.endObject();
}

void putLies(JsonText &json, const BoardOptions &options)
{
    json.beginArray("lies");
    for (const simulation::LieChoice &choice : options.lies) {
        const simulation::LieInfo &info = simulation::lies()[static_cast<std::size_t>(choice.lie)];
        json.beginObject();
        json.member("name", info.name);
        json.member("oneIn", choice.oneIn > 0 ? choice.oneIn : info.oneIn);
        json.endObject();
    }
    json.endArray();
}

} // namespace

std::string describe(const BoardOptions &options)
{
    const simulation::Traits *traits = simulation::findTraits(options.profile);
    const auto machine = simulation::plantOf(options);
    if (traits == nullptr || !machine)
        return "{}\n";
    JsonText json(JsonText::Layout::Indented);
    json.beginObject();
    json.member("profile", options.profile);
    putFirmware(json, *traits, simulation::buildOf(options));
    json.member("control_hz", options.hfHz);
    json.member("seed", options.seed);
    putLink(json, options);
    putLies(json, options);
    putScales(json, *machine);
    putMachine(json, *machine);
    json.endObject();
    return json.text().toStdString() + '\n';
}

} // namespace sim
