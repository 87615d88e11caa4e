#include "lab/subject.h"

#include "drive/start_target.h"
#include "motor/rev_up.h"

#include <algorithm>
#include <cmath>

namespace lab {

namespace {

constexpr unsigned kLeastSignals = 4; ///< that experiments record at a time
/// For the samples; the rest is for commands and readings. An answer waits for the packet of samples before it, which
/// takes 20 ms of a slow line at most (mcp::chooseBufferSize): at 115200 baud a request of 12 bytes, its pause of
/// 1.5 ms and its answer take 24 ms with it. Ahead of a reading of the bus go the vitals and a set-point, whose mode is
/// read before: 100 ms in all, of the 600 ms that an envelope takes for silence. A smaller share shortens no packet,
/// and at 230400 baud a current's response needs 0.695 by loops of 16 kHz, 0.724 by those of 25 kHz.
constexpr double kShareOfLink = 0.75;

/// A register of this motor that the board records or that can be read; 0: it has none of that name.
drive::RegisterId idOf(const catalog::Catalog &catalog, std::string_view name, int motor)
{
    const catalog::RegisterInfo *info = name.empty() ? nullptr : catalog.find(name);
    return info == nullptr ? 0 : catalog.withMotor(*info, motor);
}

/// The same, if the board records it.
drive::RegisterId streamed(const catalog::Catalog &catalog, std::string_view name, int motor)
{
    const drive::RegisterId id = idOf(catalog, name, motor);
    const catalog::RegisterInfo *info = id == 0 ? nullptr : catalog.find(id);
    return info != nullptr && info->streaming != catalog::Streaming::Polled ? id : 0;
}

/// What its samples lack, in a sentence; empty: nothing.
std::string lackOf(const drive::StreamLimits &streaming, const Registers &registers)
{
    if (streaming.frameOverhead > 0)
        return "This board sends its samples once an exchange: this is measured by samples at the "
               "rate of its control loop.";
    if (registers.speed == 0)
        return "This board does not record the speed that its main sensor tells.";
    if (registers.reference == 0 || registers.current == 0)
        return "This board does not record both the current of its motor and what it is to be.";
    if (streaming.maxSignals < kLeastSignals)
        return "This board records " + std::to_string(streaming.maxSignals)
            + " signals at a time, and experiments need " + std::to_string(kLeastSignals) + ".";
    return {};
}

/// Why what this needs is not there, in a sentence; empty: it is.
std::string reasonAgainst(
    const drive::Identified &board, int motor, std::initializer_list<drive::Feature> needs)
{
    if (!board.catalog || motor < 1 || motor > board.identity.motors)
        return "There is no such motor.";
    for (const drive::Capability &can : board.capabilities)
        if (!can.available && std::ranges::find(needs, can.feature) != needs.end())
            return can.reason;
    return {};
}

/// Without what is recorded.
Subject unrecorded(const drive::Identified &board, int motor)
{
    const auto at = static_cast<std::size_t>(motor - 1);
    const catalog::Catalog &catalog = *board.catalog;
    Subject found;
    found.motor = motor;
    found.catalog = board.catalog;
    found.limits = at < board.limits.size() ? board.limits[at] : drive::MotorLimits{};
    found.setPoint = drive::startRegisters(catalog, motor);
    // An experiment begins in speed control.
    std::erase_if(found.setPoint, [&catalog](catalog::RegisterId id) {
        return catalog.find(id)->name == catalog.start().torqueRamp;
    });
    for (const std::string_view name : catalog.start().way)
        if (const drive::RegisterId id = idOf(catalog, name, motor); id != 0)
            found.way.push_back(id);
    found.registers.bus = idOf(catalog, "BUS_VOLTAGE", motor);
    found.registers.temperature = idOf(catalog, "HEATS_TEMP", motor);
    found.registers.startUp = idOf(catalog, "REVUP_DATA", motor);
    found.registers.speedReference = idOf(catalog, "SPEED_REF", motor);
    return found;
}

/// The angle that belongs to a speed: boards name both after the sensor.
std::string angleNameOf(const std::string &speed)
{
    const std::size_t sensor = speed.find('_');
    return sensor == std::string::npos ? std::string() : speed.substr(0, sensor) + "_EL_ANGLE";
}

} // namespace

std::string Subject::nameOf(drive::RegisterId id) const
{
    return id == 0 ? std::string() : catalog->nameOf(id);
}

unsigned Subject::fastEvery(std::size_t signalCount) const
{
    constexpr double kSampleBytes = 2.0, kMostEvery = 256.0;
    const double bytes = kSampleBytes * static_cast<double>(signalCount) * tickHz;
    const double room = kShareOfLink * linkBytesPerSecond;
    return room > 0.0 ? static_cast<unsigned>(std::clamp(std::ceil(bytes / room), 1.0, kMostEvery))
                      : 1U;
}

/// Boards name a speed after its sensor; those that record nothing have one name for all, and say how many stages a
/// start-up without a sensor has. Where that is not said nothing is known, and none is assumed.
bool Subject::seesRotor() const
{
    if (exchanged) // servo drives are made for a sensor
        return true;
    if (polled)
        return registers.startUp == 0 && catalog && catalog->find("RUC_STAGE_NBR") != nullptr;
    const std::string speed = nameOf(registers.speed);
    return byEncoder(speed) || byHall(speed);
}

double Subject::leastObservedRpm(double own_rpm) const
{
    constexpr double kSafely = 2.0;
    const bool told = limits.maxSpeedRpm > 0.0 || !polled;
    const double most_rpm = told ? limits.maxSpeedRpm : own_rpm;
    return seesRotor() ? 0.0 : kSafely * motor::minimumStartSpeed_rpm(most_rpm);
}

Result<Subject, std::string> subjectOf(const drive::Identified &board, int motor)
{
    using drive::Feature;
    if (auto why =
            reasonAgainst(board, motor, {Feature::SpeedRamp, Feature::Stream, Feature::Start});
        !why.empty())
        return fail(std::move(why));
    const auto at = static_cast<std::size_t>(motor - 1);
    const catalog::Catalog &catalog = *board.catalog;
    const std::string speed =
        at < board.identity.speedSignals.size() ? board.identity.speedSignals[at] : std::string();
    Subject found = unrecorded(board, motor);
    found.tickHz = board.streaming.tickHz;
    found.linkBytesPerSecond = board.streaming.linkBytesPerSecond;
    Registers &registers = found.registers;
    registers.reference = streamed(catalog, "I_Q_REF", motor);
    registers.referenceD = streamed(catalog, "I_D_REF", motor);
    registers.current = streamed(catalog, "I_Q_MEAS", motor);
    registers.currentD = streamed(catalog, "I_D_MEAS", motor);
    registers.voltage = streamed(catalog, "V_Q", motor);
    registers.voltageD = streamed(catalog, "V_D", motor);
    registers.speed = streamed(catalog, speed, motor);
    registers.angle = streamed(catalog, angleNameOf(speed), motor);
    if (reasonAgainst(board, motor, {Feature::PositionRamp}).empty())
        registers.position = idOf(catalog, "CURRENT_POSITION", motor);
    registers.gain = idOf(catalog, "SPEED_KP", motor);
    registers.gainExponent = idOf(catalog, "SPEED_KP_DIV", motor);
    registers.integral = idOf(catalog, "SPEED_KI", motor);
    registers.integralExponent = idOf(catalog, "SPEED_KI_DIV", motor);
    if (std::string why = lackOf(board.streaming, registers); !why.empty())
        return fail(std::move(why));
    return found;
}

Result<Subject, std::string> pollableSubjectOf(const drive::Identified &board, int motor)
{
    using drive::Feature;
    const bool exchanged = board.streaming.frameOverhead > 0;
    const bool polled = board.streaming.readsPerSecond > 0.0; // what is drawn, as often as it goes
    if (!exchanged && !polled)
        return subjectOf(board, motor);
    if (auto why = reasonAgainst(board, motor, {Feature::SpeedRamp, Feature::Start}); !why.empty())
        return fail(std::move(why));
    Subject found = unrecorded(board, motor);
    found.polled = !exchanged;
    found.exchanged = exchanged;
    found.tickHz = board.streaming.tickHz;
    found.linkBytesPerSecond = board.streaming.linkBytesPerSecond;
    Registers &registers = found.registers;
    const auto id = exchanged ? streamed : idOf;
    registers.speed = id(*board.catalog, "SPEED_MEAS", motor);
    if (registers.speed == 0)
        return fail(std::string("This board does not tell the speed of its motor."));
    if (exchanged)
        registers.reference = streamed(*board.catalog, "I_Q_REF", motor);
    // In digits it would bound nothing and say nothing, and each read makes the others rarer.
    const drive::RegisterId current = id(*board.catalog, "I_Q_MEAS", motor);
    if (board.catalog->readScale(current).unit == "A")
        registers.current = current;
    // Beside the one that a start goes to, to say what it goes on showing.
    if (std::ranges::find(found.setPoint, registers.speedReference) == found.setPoint.end()
        && registers.speedReference != 0)
        found.setPoint.push_back(registers.speedReference);
    return found;
}

} // namespace lab
