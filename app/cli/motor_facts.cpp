#include "motor_facts.h"

#include "mcp/structures.h"

namespace cli {

namespace {

/// The bytes of a structure; none if this build does not have it.
Outcome<Bytes> readStructure(Desk &desk, const char *name, int motor)
{
    const auto id = registerOf(desk, name, motor);
    if (!id)
        return Bytes{};
    const auto readings = desk.talk.read({*id});
    if (!readings)
        return tl::make_unexpected(readings.error());
    const auto *bytes = std::get_if<Bytes>(&readings->front().value);
    return readings->front().status == drive::ReadStatus::Ok && bytes != nullptr ? *bytes : Bytes{};
}

} // namespace

std::optional<drive::RegisterId> registerOf(const Desk &desk, const std::string &name, int motor)
{
    return desk.catalog().resolve(name + "@" + std::to_string(motor));
}

Outcome<MotorFacts> readMotorFacts(Desk &desk, int motor)
{
    MotorFacts facts;
    const auto index = static_cast<std::size_t>(motor - 1);
    if (index < desk.board.limits.size())
        facts.limits = desk.board.limits[index];
    if (const auto current = registerOf(desk, "I_Q_REF", motor))
        if (const auto scale = desk.catalog().readScale(*current); scale.unit == "A")
            facts.ampsPerDigit = scale.factor;
    Bytes structures[3];
    const char *const names[] = {"MOTOR_CONFIG", "APPLICATION_CONFIG", "FOCFW_CONFIG"};
    for (std::size_t i = 0; i < 3; ++i) {
        auto bytes = readStructure(desk, names[i], motor);
        if (!bytes)
            return tl::make_unexpected(bytes.error());
        structures[i] = std::move(*bytes);
    }
    if (const auto config = mcp::decodeMotorConfig(structures[0]))
        facts.motor = {.polePairs = config->polePairs,
            .rs_ohm = config->rs,
            .lq_h = config->lq,
            .ld_h = config->ld,
            .flux_wb = analysis::fluxOfConfiguration_wb(config->ratedFlux, config->polePairs),
            .nominalCurrent_a = config->maxCurrent};
    if (const auto config = mcp::decodeApplicationConfig(structures[1]))
        facts.bus_v = config->nominalVolts;
    const auto config = mcp::decodeFirmwareConfig(structures[2]);
    if (config && !config->sixStep && config->pwmHz > 0 && config->mediumHz > 0) {
        facts.controlPeriod_s = static_cast<double>(config->focRate) / config->pwmHz;
        facts.speedPeriod_s = 1.0 / config->mediumHz;
    }
    if (const auto inertia = registerOf(desk, "SC_J", motor)) {
        const auto readings = desk.talk.read({*inertia});
        if (!readings)
            return tl::make_unexpected(readings.error());
        const auto *found = std::get_if<double>(&readings->front().value);
        if (readings->front().status == drive::ReadStatus::Ok && found != nullptr && *found > 0.0)
            facts.inertia_kgm2 = *found;
    }
    return facts;
}

Outcome<std::map<std::string, Digits16>> readDigits(
    Desk &desk, const std::vector<std::string> &names, int motor)
{
    std::vector<drive::RegisterId> ids;
    std::vector<std::string> asked;
    for (const std::string &name : names) {
        if (const auto id = registerOf(desk, name, motor)) {
            ids.push_back(*id);
            asked.push_back(name);
        }
    }
    const auto readings = desk.talk.read(ids);
    if (!readings)
        return tl::make_unexpected(readings.error());
    std::map<std::string, Digits16> digits;
    for (std::size_t i = 0; i < readings->size(); ++i) {
        const drive::Reading &reading = (*readings)[i];
        const auto *whole = std::get_if<std::int64_t>(&reading.value);
        if (reading.status == drive::ReadStatus::Ok && whole != nullptr)
            digits[asked[i]] = {reading.id, *whole};
    }
    return digits;
}

} // namespace cli
