#include "motor_facts.h"

namespace cli {

std::optional<drive::RegisterId> registerOf(const Desk &desk, const std::string &name)
{
    return desk.catalog().resolve(name + "@" + std::to_string(desk.arguments.motor));
}

Outcome<drive::MotorFacts> readMotorFacts(Desk &desk)
{
    const int motor = desk.arguments.motor;
    const auto readings = desk.talk.read(drive::motorRegisters(desk.catalog(), motor));
    if (!readings)
        return tl::make_unexpected(readings.error());
    return drive::motorFacts(
        desk.catalog(), motor, [&](drive::RegisterId id) -> std::optional<drive::Value> {
            for (const drive::Reading &reading : *readings)
                if (reading.id == id && reading.status == drive::ReadStatus::Ok)
                    return reading.value;
            return std::nullopt;
        });
}

Outcome<drive::StartTarget> startTarget(Desk &desk)
{
    const int motor = desk.arguments.motor;
    const auto readings = desk.talk.read(drive::startRegisters(desk.catalog(), motor));
    if (!readings)
        return tl::make_unexpected(readings.error());
    return drive::startTarget(desk.catalog(),
        desk.board.limits.at(static_cast<std::size_t>(motor - 1)), motor,
        [&](drive::RegisterId id) -> std::optional<drive::Value> {
            for (const drive::Reading &reading : *readings)
                if (reading.id == id && reading.status == drive::ReadStatus::Ok)
                    return reading.value;
            return std::nullopt;
        });
}

Outcome<std::map<std::string, Digits16>> readDigits(
    Desk &desk, const std::vector<std::string> &names)
{
    std::vector<drive::RegisterId> ids;
    std::vector<std::string> asked;
    for (const std::string &name : names) {
        if (const auto id = registerOf(desk, name)) {
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
