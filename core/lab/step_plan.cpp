#include "lab/step_plan.h"

#include "drive/start_target.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>

namespace lab {

namespace {

using namespace std::chrono_literals;

constexpr const char *kEntry = "step plan";
constexpr milliseconds kLongest = 60s; ///< of a series that nobody watches over
constexpr milliseconds kReaching = 5s; ///< until the speed is that of the set-point
constexpr int kMostRepeats = 100;

std::string textOf(double value)
{
    std::array<char, 32> buffer{};
    return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

/// The whole text as a number; 0 if it is none.
double numberOf(const std::string &text)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(value) ? value
                                                                                            : 0.0;
}

/// A register of this motor that the board records or that can be read; 0: it has none of that name.
drive::RegisterId idOf(const catalog::Catalog &catalog, std::string_view name, int motor)
{
    const catalog::RegisterInfo *info = catalog.find(name);
    return info == nullptr ? 0 : catalog.withMotor(*info, motor);
}

bool streams(const catalog::Catalog &catalog, drive::RegisterId id)
{
    const catalog::RegisterInfo *info = id == 0 ? nullptr : catalog.find(id);
    return info != nullptr && info->streaming != catalog::Streaming::Polled;
}

/// The angle that belongs to a speed: boards name both after the sensor.
std::string angleNameOf(const std::string &speed)
{
    const std::size_t sensor = speed.find('_');
    return sensor == std::string::npos ? std::string() : speed.substr(0, sensor) + "_EL_ANGLE";
}

} // namespace

milliseconds lengthOf(const StepPlan &plan)
{
    return 2 * (plan.approach + kReaching) + 2 * plan.repeat * plan.hold;
}

std::string objectionTo(const StepPlan &plan, const drive::MotorLimits &limits)
{
    if (plan.fromRpm == plan.toRpm)
        return "both speeds are the same: there is no step";
    if (plan.repeat < 1 || plan.repeat > kMostRepeats)
        return "a series has 1 to " + std::to_string(kMostRepeats) + " repetitions";
    if (plan.hold < 50ms || plan.hold > 10s)
        return "a speed is held for 50 ms to 10 s";
    if (plan.approach < 1ms || plan.approach > 10s)
        return "the way to the first speed takes 1 ms to 10 s";
    if (lengthOf(plan) > kLongest)
        return "it could take " + std::to_string(lengthOf(plan) / 1s)
            + " s, and what moves a motor by itself ends within " + std::to_string(kLongest / 1s)
            + " s: take fewer repetitions or hold each speed for a shorter time";
    const double highest = std::max(std::abs(plan.fromRpm), std::abs(plan.toRpm));
    const double allowed = plan.maxRpm > 0.0 && limits.maxSpeedRpm > 0.0
        ? std::min(plan.maxRpm, limits.maxSpeedRpm)
        : std::max(plan.maxRpm, limits.maxSpeedRpm);
    if (!(allowed > 0.0))
        return "nothing says how fast this motor may turn: give the greatest speed that it may have";
    if (highest > allowed)
        return textOf(highest) + " rpm are more than the " + textOf(allowed)
            + " rpm that are allowed";
    return {};
}

Result<StepBoard, std::string> stepBoardOf(const drive::Identified &board, int motor)
{
    if (!board.catalog || motor < 1 || motor > board.identity.motors)
        return fail(std::string("there is no such motor"));
    for (const drive::Capability &can : board.capabilities)
        if (!can.available
            && (can.feature == drive::Feature::SpeedRamp || can.feature == drive::Feature::Stream
                || can.feature == drive::Feature::Start))
            return fail(can.reason);
    const auto at = static_cast<std::size_t>(motor - 1);
    const catalog::Catalog &catalog = *board.catalog;
    StepBoard found;
    found.catalog = board.catalog;
    found.limits = at < board.limits.size() ? board.limits[at] : drive::MotorLimits{};
    found.setPoint = drive::startRegisters(catalog, motor);
    found.tickHz = board.streaming.tickHz;
    found.linkBytesPerSecond = board.streaming.linkBytesPerSecond;
    const std::string speed =
        at < board.identity.speedSignals.size() ? board.identity.speedSignals[at] : std::string();
    StepRegisters &registers = found.registers;
    const auto streamed = [&](std::string_view name) {
        const drive::RegisterId id = name.empty() ? 0 : idOf(catalog, name, motor);
        return streams(catalog, id) ? id : 0;
    };
    registers.reference = streamed("I_Q_REF");
    registers.current = streamed("I_Q_MEAS");
    registers.speed = streamed(speed);
    registers.angle = streamed(angleNameOf(speed));
    registers.bus = idOf(catalog, "BUS_VOLTAGE", motor);
    registers.temperature = idOf(catalog, "HEATS_TEMP", motor);
    found.gain = idOf(catalog, "SPEED_KP", motor);
    found.gainExponent = idOf(catalog, "SPEED_KP_DIV", motor);
    if (board.streaming.maxSignals < 4 || registers.reference == 0 || registers.current == 0
        || registers.speed == 0)
        return fail(std::string("this board does not record the speed and the current of its motor "
                                "at the rate of its control loop"));
    return found;
}

unsigned StepBoard::fastEvery(std::size_t signalCount, double share) const
{
    constexpr double kSampleBytes = 2.0, kMostEvery = 256.0;
    const double bytes = kSampleBytes * static_cast<double>(signalCount) * tickHz;
    const double room = share * linkBytesPerSecond;
    return room > 0.0 ? static_cast<unsigned>(std::clamp(std::ceil(bytes / room), 1.0, kMostEvery))
                      : 1U;
}

double jumpPerRpm(const StepBoard &board, double gain, double exponent)
{
    const double amps = board.catalog ? board.catalog->streamScale(board.registers.reference).factor
                                      : 0.0;
    const double step = board.limits.speedStepRpm;
    if (!(step > 0.0) || !(exponent >= 0.0) || exponent > 31.0)
        return 0.0;
    return gain / std::exp2(exponent) / step * amps;
}

record::Happening entryOf(const StepExperiment &experiment, double jump)
{
    const StepPlan &plan = experiment.plan;
    const StepBoard &board = experiment.board;
    const auto name = [&](drive::RegisterId id) {
        return id == 0 ? std::string() : board.catalog->nameOf(id);
    };
    return {kEntry,
        {{"motor", std::to_string(plan.motor)}, {"from rpm", std::to_string(plan.fromRpm)},
            {"to rpm", std::to_string(plan.toRpm)}, {"repeat", std::to_string(plan.repeat)},
            {"hold ms", std::to_string(plan.hold.count())},
            {"approach ms", std::to_string(plan.approach.count())},
            {"max rpm", textOf(plan.maxRpm)}, {"max A", textOf(plan.maxAmps)},
            {"reference", name(board.registers.reference)},
            {"current", name(board.registers.current)}, {"speed", name(board.registers.speed)},
            {"angle", name(board.registers.angle)}, {"pole pairs", textOf(board.limits.polePairs)},
            {"speed step rpm", textOf(board.limits.speedStepRpm)},
            {"jump A per rpm", textOf(jump)}}};
}

std::optional<RecordedPlan> recordedPlan(const record::Happening &happening)
{
    if (happening.name != kEntry)
        return std::nullopt;
    std::map<std::string, std::string> fields(happening.fields.begin(), happening.fields.end());
    const auto whole = [&](const char *key, int most) {
        const double number = numberOf(fields[key]);
        return std::abs(number) <= most ? static_cast<int>(number) : 0;
    };
    constexpr int kMost = 1'000'000;
    RecordedPlan found;
    StepPlan &plan = found.plan;
    plan.motor = whole("motor", kMost);
    plan.fromRpm = whole("from rpm", kMost);
    plan.toRpm = whole("to rpm", kMost);
    plan.repeat = whole("repeat", kMostRepeats);
    plan.hold = milliseconds(whole("hold ms", kMost));
    plan.approach = milliseconds(whole("approach ms", kMost));
    plan.maxRpm = numberOf(fields["max rpm"]);
    plan.maxAmps = numberOf(fields["max A"]);
    found.reference = fields["reference"];
    found.current = fields["current"];
    found.speed = fields["speed"];
    found.angle = fields["angle"];
    found.polePairs = numberOf(fields["pole pairs"]);
    found.speedStepRpm = numberOf(fields["speed step rpm"]);
    found.jumpPerRpm = numberOf(fields["jump A per rpm"]);
    if (plan.motor < 1 || plan.fromRpm == plan.toRpm || plan.repeat < 1 || plan.hold < 1ms)
        return std::nullopt;
    return found;
}

} // namespace lab
