#include "drive/mcp/scales.h"

#include "drive/motion_limits.h"
#include "motor/constants.h"
#include "motor/ramp.h"

#include <cmath>

namespace drive {

namespace {

// Beyond these a number is a misread structure, not a motor.
constexpr double kMaxPolePairs = 200.0, kMaxTickHz = 500000.0, kMaxTorquePerAmp = 1000.0,
                 kMaxInductance_h = 10.0;

constexpr std::uint32_t kVersion64 = 0x060400;

bool isSixStep(const McpMotorDescription &motor)
{
    constexpr std::uint8_t kSixStep = 1;
    return (motor.application && motor.application->driveType == kSixStep)
        || (motor.firmware && motor.firmware->sixStep);
}

} // namespace

catalog::Scales scalesOf(const McpMotorDescription &motor, std::uint32_t version)
{
    catalog::Scales scales;
    if (isSixStep(motor))
        return scales;
    constexpr double kMaxFactor = 1e6;
    if (motor.scale) {
        scales.ampsPerDigit = plausible(motor.scale->current, kMaxFactor);
        scales.voltsPerDigit = plausible(motor.scale->voltage, kMaxFactor);
        scales.hertzPerDigit = plausible(motor.scale->frequency, kMaxFactor);
        if (version < kVersion64)
            scales.rpmPerReadDigit =
                scales.hertzPerDigit > 0.0 ? scales.hertzPerDigit : motor::kSpeedStep_rpm;
    } else if (motor.application) {
        scales.ampsPerDigit =
            plausible(motor.application->maxReadableAmps, kHighestAmps) / kFullScaleDigits;
        scales.voltsPerDigit =
            motor.application->nominalVolts / (std::sqrt(3.0) * (kFullScaleDigits - 1.0));
        // 6.0 and 6.1 do not say the scale of the speeds they read out; it is the one that 6.2 says.
        const double maxRpm = plausible(motor.application->maxSpeedRpm, kHighestRpm);
        if (version < kVersion64 && maxRpm > 0.0)
            scales.rpmPerReadDigit = 1.15 * maxRpm / kFullScaleDigits;
    }
    return scales;
}

std::set<std::uint8_t> sensorsOf(const McpMotorDescription &motor)
{
    constexpr std::uint8_t kFoc = 0; // the numbers of ACIM builds were not seen
    if (!motor.application || motor.application->driveType != kFoc || !motor.firmware
        || motor.firmware->sixStep || motor.firmware->primarySensor == 0)
        return {};
    return {motor.firmware->primarySensor, motor.firmware->auxiliarySensor};
}

MotorLimits limitsOf(const McpMotorDescription &motor)
{
    MotorLimits limits{.speedStepRpm = motor::kSpeedStep_rpm, .wireRpm = motor::kMostSpeed_rpm};
    if (motor.application) {
        limits.maxSpeedRpm = plausible(motor.application->maxSpeedRpm, kHighestRpm);
        limits.maxCurrentAmps = plausible(motor.application->maxReadableAmps, kHighestAmps);
        limits.nominalCurrentAmps = plausible(motor.application->nominalAmps, kHighestAmps);
    }
    if (const auto &told = motor.motor) {
        limits.polePairs = plausible(told->polePairs, kMaxPolePairs);
        const bool perHertz = motor.firmware && motor.firmware->hso();
        const double flux =
            motor::fluxOfConfiguration_wb(told->ratedFlux, limits.polePairs, perHertz);
        limits.torquePerAmp =
            plausible(motor::ktOfFlux_nmpa(flux, limits.polePairs), kMaxTorquePerAmp);
        limits.saliency_h = plausible(told->ld > 0 ? told->lq - told->ld : 0, kMaxInductance_h);
    }
    return limits;
}

StreamLimits streamLimitsOf(const std::vector<McpMotorDescription> &motors, unsigned streams,
    std::size_t maxPacket, std::uint32_t baud)
{
    constexpr double kBitsPerByte = 10.0; // 8N1
    StreamLimits limits{.maxPacket = maxPacket, .linkBytesPerSecond = baud / kBitsPerByte};
    for (const McpMotorDescription &motor : motors)
        if (motor.firmware && !motor.firmware->sixStep && motor.firmware->focRate > 0)
            limits.tickHz += plausible(
                static_cast<double>(motor.firmware->pwmHz) / motor.firmware->focRate, kMaxTickHz);
    if (limits.tickHz > 0.0 && maxPacket > 0)
        limits.maxSignals = streams;
    else
        limits.tickHz = 0.0;
    return limits;
}

void addCapabilities(McpFacts &board, const McpMotorDescription &first)
{
    const std::string readOnly =
        board.knownFirmware ? "" : "This firmware is not known; it is shown read-only.";
    const auto needs = [&](const char *registerName, const char *reason) {
        return !readOnly.empty()                           ? readOnly
            : board.catalog->find(registerName) == nullptr ? reason
                                                           : "";
    };
    board.tell(Feature::Start, readOnly);
    board.tell(Feature::Stop, "");
    board.tell(Feature::AcknowledgeFaults, readOnly);
    board.tell(Feature::SpeedRamp, needs("SPEED_RAMP", "This build has no speed ramp."));
    std::string torque = needs("TORQUE_RAMP", "This build has no torque control.");
    if (torque.empty() && isSixStep(first))
        torque = "Six-step firmware has no torque control.";
    if (torque.empty() && !(board.ampsPerDigit(1) > 0.0))
        torque = "The board does not say its current scale.";
    board.tell(Feature::TorqueRamp, torque);
    board.tell(Feature::CurrentReference, torque);
    std::string stream;
    if (board.streamBytes == 0)
        stream = "The board sends no datalog on this link. If it did before, reset it.";
    else if (board.streaming.maxSignals == 0 || !(board.streaming.tickHz > 0.0))
        stream = "This build has no datalog.";
    board.tell(Feature::Stream, stream);
    board.tell(Feature::WriteRegisters, readOnly);
    constexpr unsigned kPositionFlag = 0x0100;
    std::string position = needs("POSITION_RAMP", "This build has no position control.");
    if (position.empty()
        && (board.catalog->find("CURRENT_POSITION") == nullptr || !first.firmware
            || (first.firmware->flags1 & kPositionFlag) == 0))
        position = "This build has no position control.";
    board.tell(Feature::PositionRamp, position);
    board.tell(Feature::CyclicSetPoints, kNoCycle);
    board.tell(Feature::CurrentScale, "The board tells its current scale itself.");
}

void makeRaw(std::vector<catalog::RegisterInfo> &registers)
{
    for (catalog::RegisterInfo &info : registers) {
        if (info.access == catalog::Access::ReadWrite)
            info.access = catalog::Access::Read;
        else if (info.access == catalog::Access::Write)
            info.access = catalog::Access::None;
        info.quantity = catalog::Quantity::Plain;
        info.fractionBits = 0;
        info.unit.clear();
    }
}

} // namespace drive
