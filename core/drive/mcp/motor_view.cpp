// The structures of MCP boards for drive/motor_view.h. Facts: mcp-aspep sections 8 and 9.
#include "drive/motor_view.h"
#include "catalog/names.h"
#include "drive/mcp/scales.h"
#include "mcp/structure_fields.h"
#include "mcp/structures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace drive {

namespace {

/// By StructureView::Of.
constexpr std::array kStructures{
    "MOTOR_CONFIG", "APPLICATION_CONFIG", "FOCFW_CONFIG", "SCALE_CONFIG", "GLOBAL_CONFIG"};
constexpr const char *kInertia = "SC_J";

// Topologies as FOCFW_CONFIG numbers them.
constexpr std::uint8_t kThreeShunts = 0, kOneShunt = 1, kOneShuntShifted = 2;

struct FieldUnit {
    std::string_view key, unit;
};
constexpr FieldUnit kUnits[] = {{"Rs", "\u03a9"}, {"Lq", "H"}, {"Ld", "H"}, {"max current", "A"},
    {"copper mass", "kg"}, {"cooling tau", "s"}, {"max speed", "rpm"},
    {"max readable current", "A"}, {"nominal voltage", "V"}, {"PWM frequency", "Hz"},
    {"medium frequency", "Hz"}};

const catalog::RegisterInfo *readable(const catalog::Catalog &catalog, std::string_view name)
{
    const auto *info = catalog.find(name);
    return info != nullptr && info->readable() && !info->stub ? info : nullptr;
}

std::optional<Bytes> bytesOf(
    const catalog::Catalog &catalog, std::string_view name, int motor, const ValueSource &known)
{
    const auto *info = readable(catalog, name);
    if (info == nullptr)
        return std::nullopt;
    auto value = known(catalog.withMotor(*info, motor));
    auto *bytes = value ? std::get_if<Bytes>(&*value) : nullptr;
    return bytes != nullptr ? std::optional(std::move(*bytes)) : std::nullopt;
}

std::string fluxUnit(const MotorFacts &facts) { return facts.fluxPerHertz ? "V/Hz" : "V/krpm"; }

std::string unitOf(std::string_view structure, const mcp::Field &field, const MotorFacts &facts)
{
    if (structure == "SCALE_CONFIG") // of a six-step build: ticks of its timers
        return facts.sixStep          ? ""
            : field.name == "voltage" ? "V/digit"
            : field.name == "current" ? "A/digit"
                                      : "rpm/digit";
    if (field.name == "rated flux")
        return fluxUnit(facts);
    if (field.name == "nominal current") // the short form has digits
        return std::holds_alternative<double>(field.value) ? "A" : "digits";
    const auto *unit = std::ranges::find(kUnits, field.name, &FieldUnit::key);
    return unit == std::end(kUnits) ? "" : std::string(unit->unit);
}

/// With the averages that ST's generator writes unless told otherwise.
double speedDelay_s(std::uint8_t sensor, const MotorFacts &facts)
{
    constexpr double kObserverPeriods = 64.0; // control periods
    constexpr double kEncoderPeriods = 16.0; // periods of the speed loop
    constexpr double kHallEdges = 6.0; // an electrical turn
    switch (sensor) {
    case kPll:
    case kCordic:
        return kObserverPeriods / 2.0 * facts.controlPeriod_s;
    case kEncoder:
        return kEncoderPeriods / 2.0 * facts.speedPeriod_s;
    case kHall: { // edges come with the speed: at a third of the highest
        const double turns_hz = facts.motor.polePairs * facts.limits.maxSpeedRpm / 3.0 / 60.0;
        return turns_hz > 0.0 ? kHallEdges / 2.0 / (6.0 * turns_hz) : 0.0;
    }
    default:
        return 0.0;
    }
}

double bandwidthGuide_radps(std::uint8_t topology)
{
    constexpr double kWithThree = 9000.0, kWithOne = 4500.0; // features 6.2, ST's FAQ
    if (topology == kThreeShunts)
        return kWithThree;
    return topology == kOneShunt || topology == kOneShuntShifted ? kWithOne : 0.0;
}

void nameValue(StructureField &field)
{
    const auto *whole = std::get_if<std::int64_t>(&field.value);
    if (whole == nullptr)
        return;
    field.flags = !catalog::namedFlags(field.key).empty();
    if (field.flags) {
        field.names = catalog::flagNames(field.key, static_cast<std::uint32_t>(*whole));
    } else if (!catalog::namedValues(field.key).empty()) {
        field.names = {catalog::valueName(field.key, *whole)};
    } else if (field.key == "version") { // one byte each: 0xMMmmpp00
        const auto part = [&](int shift) { return std::to_string(*whole >> shift & 0xFF); };
        field.names = {part(24) + '.' + part(16) + '.' + part(8)};
    }
}

} // namespace

std::vector<RegisterId> motorRegisters(const catalog::Catalog &catalog, int motor)
{
    std::vector<RegisterId> ids;
    for (const char *name : kStructures)
        if (const auto *info = readable(catalog, name))
            ids.push_back(catalog.withMotor(*info, motor));
    if (const auto *info = readable(catalog, kInertia))
        ids.push_back(catalog.withMotor(*info, motor));
    return ids;
}

MotorFacts motorFacts(const catalog::Catalog &catalog, int motor, const ValueSource &known)
{
    MotorFacts facts;
    const auto structure = [&](const char *name) {
        return bytesOf(catalog, name, motor, known).value_or(Bytes{});
    };
    McpMotorDescription board;
    if (const auto config = mcp::decodeFirmwareConfig(structure("FOCFW_CONFIG"))) {
        board.firmware = *config;
        facts.fluxPerHertz = config->hso();
    }
    if (const auto config = mcp::decodeMotorConfig(structure("MOTOR_CONFIG"))) {
        board.motor = *config;
        facts.motor = {.polePairs = config->polePairs,
            .rs_ohm = config->rs,
            .lq_h = config->lq,
            .ld_h = config->ld,
            .flux_wb = motor::fluxOfConfiguration_wb(
                config->ratedFlux, config->polePairs, facts.fluxPerHertz),
            .nominalCurrent_a = config->maxCurrent};
        facts.name = config->name;
    }
    if (const auto config = mcp::decodeApplicationConfig(structure("APPLICATION_CONFIG"))) {
        board.application = *config;
        facts.bus_v = config->nominalVolts;
        facts.sixStep = config->driveType == 1;
    }
    facts.limits = limitsOf(board);
    if (const auto &config = board.firmware) {
        facts.sixStep = facts.sixStep || config->sixStep;
        if (config->primarySensor == kEncoder || config->primarySensor == kHall)
            facts.angleSensor = catalog::valueName("primary sensor", config->primarySensor);
        if (!config->sixStep && config->pwmHz > 0 && config->mediumHz > 0) {
            facts.controlPeriod_s = static_cast<double>(config->focRate) / config->pwmHz;
            facts.speedPeriod_s = 1.0 / config->mediumHz;
            facts.speedDelay_s = speedDelay_s(config->primarySensor, facts);
            facts.bandwidthGuide_radps = bandwidthGuide_radps(config->topology);
        }
    }
    if (const auto *current = catalog.find("I_Q_REF"))
        if (const auto scale = catalog.readScale(catalog.withMotor(*current, motor));
            scale.unit == "A")
            facts.ampsPerDigit = scale.factor;
    if (const auto *info = readable(catalog, kInertia)) {
        const auto value = known(catalog.withMotor(*info, motor));
        const auto *found = value ? std::get_if<double>(&*value) : nullptr;
        if (found != nullptr && *found > 0.0)
            facts.inertia_kgm2 = *found;
    }
    return facts;
}

motor::MotorSheet sheetOf(const MotorFacts &facts)
{
    const auto said = [](double value) {
        return std::isfinite(value) && value > 0.0 ? std::optional(value) : std::nullopt;
    };
    motor::MotorSheet sheet;
    sheet.name = facts.name;
    sheet.polePairs = said(facts.motor.polePairs);
    sheet.rs_ohm = said(facts.motor.rs_ohm);
    sheet.ld_h = said(facts.motor.ld_h);
    sheet.lq_h = said(facts.motor.lq_h);
    sheet.flux_wb = said(facts.motor.flux_wb);
    sheet.nominalCurrent_a = said(facts.motor.nominalCurrent_a);
    sheet.maxSpeed_rpm = said(facts.limits.maxSpeedRpm);
    sheet.bus_v = said(facts.bus_v);
    sheet.inertia_kgm2 = said(facts.inertia_kgm2);
    return sheet;
}

motor::GainPlant gainPlant(const MotorFacts &facts)
{
    motor::GainPlant plant;
    plant.motor = facts.motor;
    plant.inertia_kgm2 = facts.inertia_kgm2;
    plant.stage = {facts.bus_v, facts.ampsPerDigit > 0.0 ? 1.0 / facts.ampsPerDigit : 0.0,
        facts.controlPeriod_s};
    plant.speedPeriod_s = facts.speedPeriod_s;
    plant.speedDelay_s = facts.speedDelay_s;
    plant.bandwidthGuide_radps = facts.bandwidthGuide_radps;
    return plant;
}

std::vector<StructureView> motorStructures(
    const catalog::Catalog &catalog, int motor, const ValueSource &known)
{
    const MotorFacts facts = motorFacts(catalog, motor, known);
    std::vector<StructureView> views;
    for (std::size_t i = 0; i < kStructures.size(); ++i) {
        const auto *info = readable(catalog, kStructures[i]);
        if (info == nullptr)
            continue;
        StructureView view{static_cast<StructureView::Of>(i), catalog.withMotor(*info, motor),
            info->name, info->writable(), {}, {}};
        if (const auto bytes = bytesOf(catalog, kStructures[i], motor, known)) {
            view.bytes = bytes->size();
            for (const mcp::Field &field :
                mcp::fieldsOf({static_cast<std::uint16_t>(info->id)}, *bytes)) {
                StructureField shown{field.name, unitOf(info->name, field, facts), {}, false, {}};
                std::visit([&](const auto &value) { shown.value = value; }, field.value);
                nameValue(shown);
                view.fields.push_back(std::move(shown));
            }
        }
        views.push_back(std::move(view));
    }
    return views;
}

} // namespace drive
