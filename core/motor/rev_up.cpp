#include "motor/rev_up.h"

#include "motor/constants.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace motor {

namespace {

constexpr std::size_t kStageBytes = 8;
constexpr double kSecondsPerMs = 1e-3;

} // namespace

Result<RevUp, RevUpError> revUpOfBytes(ByteView bytes)
{
    if (bytes.size() % kStageBytes != 0 || bytes.size() > kStageBytes * kRevUpStages)
        return fail(RevUpError::WrongSize);
    RevUp stages;
    for (ByteReader reader(bytes); reader.left() > 0;)
        stages.push_back({reader.s32(), reader.s16(), reader.u16()});
    return stages;
}

Bytes bytesOf(const RevUp &stages)
{
    ByteWriter writer;
    for (std::size_t i = 0; i < std::min(stages.size(), kRevUpStages); ++i)
        writer.s32(stages[i].speed_rpm).s16(stages[i].current_digits).u16(stages[i].duration_ms);
    return writer.take();
}

RevUp completed(RevUp stages)
{
    RevUpStage filler = stages.empty() ? RevUpStage{} : stages.back();
    filler.duration_ms = 0;
    stages.resize(kRevUpStages, filler);
    return stages;
}

std::size_t usedStages(const RevUp &stages)
{
    std::size_t used = stages.size();
    while (used > 0 && stages[used - 1].duration_ms == 0)
        --used;
    return used;
}

RevUp withStage(const RevUp &stages, std::size_t index, const RevUpStage &stage)
{
    RevUp all = completed(stages);
    if (index >= all.size())
        return all;
    const RevUpStage old = all[index];
    all[index] = stage;
    RevUpStage repeat = old, repeated = stage;
    repeat.duration_ms = repeated.duration_ms = 0;
    for (std::size_t i = index + 1; i < all.size() && all[i] == repeat; ++i)
        all[i] = repeated;
    return all;
}

RevUp withStageAfter(const RevUp &stages, std::size_t index)
{
    RevUp all = completed(stages);
    const std::size_t used = usedStages(all);
    if (used >= kRevUpStages)
        return all;
    constexpr std::uint16_t kFirstStage_ms = 1000;
    RevUpStage added = all[std::min(index, std::max<std::size_t>(used, 1) - 1)];
    if (added.duration_ms == 0)
        added.duration_ms = kFirstStage_ms;
    all.resize(used);
    const std::size_t at = std::min(index + 1, used);
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(at), added);
    return completed(all);
}

RevUp withoutStage(const RevUp &stages, std::size_t index)
{
    RevUp all = completed(stages);
    const std::size_t used = usedStages(all);
    if (index >= used)
        return all;
    all.resize(used);
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(index));
    return completed(all);
}

RevUp withSwapped(const RevUp &stages, std::size_t a, std::size_t b)
{
    RevUp all = completed(stages);
    const std::size_t used = usedStages(all);
    if (a >= used || b >= used)
        return all;
    std::swap(all[a], all[b]);
    all.resize(used); // behind the last one only its repeats
    return completed(all);
}

RevUpBounds revUpBounds(
    double maxSpeed_rpm, double maxCurrent_a, double ampsPerDigit, double speedStep_rpm)
{
    RevUpBounds bounds{.speedStep_rpm = speedStep_rpm};
    if (maxSpeed_rpm > 0.0 && maxSpeed_rpm < bounds.speed_rpm)
        bounds.speed_rpm =
            static_cast<std::int32_t>(quantisedSpeed_rpm(maxSpeed_rpm, speedStep_rpm));
    constexpr double kRounding = 1e-6; // 5 A of 5 A / 2723 are 2723 digits
    const double digits = std::floor(maxCurrent_a / ampsPerDigit + kRounding);
    if (maxCurrent_a > 0.0 && ampsPerDigit > 0.0 && digits < bounds.digits)
        bounds.digits = static_cast<std::int16_t>(digits);
    return bounds;
}

RevUpStage fittedStage(const RevUpStage &old, double speed_rpm, double digits, double duration_ms,
    const RevUpBounds &bounds)
{
    const auto fitted = [](double value, double least, double most, double otherwise) {
        return std::isfinite(value) ? std::clamp(std::round(value), least, most) : otherwise;
    };
    const double step = bounds.speedStep_rpm, steps = std::floor(bounds.speed_rpm / step),
                 digitsMost = bounds.digits;
    RevUpStage stage = old;
    if (std::isfinite(speed_rpm))
        stage.speed_rpm =
            static_cast<std::int32_t>(step * fitted(speed_rpm / step, -steps, steps, 0.0));
    stage.current_digits = static_cast<std::int16_t>(
        fitted(digits, bounds.pulse ? 0.0 : -digitsMost, digitsMost, old.current_digits));
    stage.duration_ms =
        static_cast<std::uint16_t>(fitted(duration_ms, 0.0, bounds.duration_ms, old.duration_ms));
    return stage;
}

RevUp keptByFirmware(RevUp stages, double speedStep_rpm)
{
    for (RevUpStage &stage : stages)
        stage.speed_rpm =
            static_cast<std::int32_t>(quantisedSpeed_rpm(stage.speed_rpm, speedStep_rpm));
    return stages;
}

RevUp usualRevUp(double nominalCurrent_a, double maxSpeed_rpm, double ampsPerDigit)
{
    if (!(nominalCurrent_a > 0.0) || !(maxSpeed_rpm > 0.0) || !(ampsPerDigit > 0.0))
        return {};
    const RevUpBounds bounds = revUpBounds(maxSpeed_rpm, nominalCurrent_a, ampsPerDigit);
    constexpr double kCurrentShare = 0.5, kSpeedShare = 0.3;
    const double digits = kCurrentShare * nominalCurrent_a / ampsPerDigit;
    return completed({fittedStage({}, 0.0, digits, 2000.0, bounds),
        fittedStage({}, kSpeedShare * maxSpeed_rpm, digits, 3000.0, bounds)});
}

double revUpDuration_s(const RevUp &stages)
{
    double sum = 0.0;
    for (const RevUpStage &stage : stages)
        sum += stage.duration_ms * kSecondsPerMs;
    return sum;
}

double neededTorque_nm(const RevUpStage &stage, double from_rpm, const MechanicalLoad &load)
{
    const double change_radps = (stage.speed_rpm - from_rpm) * kRadpsPerRpm;
    const double faster_radps =
        std::max(std::abs(from_rpm), std::abs(static_cast<double>(stage.speed_rpm))) * kRadpsPerRpm;
    if (change_radps == 0.0 && faster_radps == 0.0)
        return 0.0; // stands
    const double friction = load.coulomb_nm + load.viscous_nms * faster_radps;
    if (change_radps == 0.0)
        return friction;
    if (stage.duration_ms == 0)
        return std::numeric_limits<double>::infinity();
    const double speedingUp =
        std::abs(static_cast<double>(stage.speed_rpm)) >= std::abs(from_rpm) ? 1.0 : -1.0;
    const double inertial =
        load.inertia_kgm2 * std::abs(change_radps) / (stage.duration_ms * kSecondsPerMs);
    return std::max(0.0, speedingUp * inertial + friction);
}

double availableTorque_nm(
    const RevUp &stages, std::size_t index, double ampsPerDigit, const MechanicalLoad &load)
{
    const auto amps = [&](std::size_t i) {
        return std::abs(stages[i].current_digits * ampsPerDigit);
    };
    // From nothing the current first aligns the rotor, which need not turn yet.
    const bool aligns = index == 0 && stages[0].speed_rpm == 0;
    const double before = index > 0 ? amps(index - 1) : 0.0;
    return load.kt_nmpa * (aligns ? amps(index) : std::min(before, amps(index)));
}

double minimumStartSpeed_rpm(double maxSpeed_rpm) { return 0.15 * maxSpeed_rpm; }

namespace {

/// Looks at one stage after the other; `m_from` is where the one before ended.
class Inspection {
public:
    Inspection(const RevUp &stages, double ampsPerDigit, const RevUpLimits &limits)
        : m_stages(stages)
        , m_ampsPerDigit(ampsPerDigit)
        , m_limits(limits)
        , m_used(usedStages(stages))
    {
    }

    std::vector<RevUpFinding> run()
    {
        if (m_used == 0)
            add(RevUpMistake::NoStage, 0, 0.0, 0.0);
        for (std::size_t i = 0; i < m_used; ++i) {
            torque(i);
            current(i);
            time(i);
            speed(i);
            m_from = m_stages[i];
        }
        if (m_used > 0)
            finalSpeed();
        return m_findings;
    }

private:
    void add(RevUpMistake mistake, std::size_t stage, double is, double limit)
    {
        m_findings.push_back({mistake, stage, is, limit});
    }
    double amps(const RevUpStage &stage) const
    {
        return std::abs(stage.current_digits * m_ampsPerDigit);
    }

    void torque(std::size_t i)
    {
        const MechanicalLoad &load = m_limits.load;
        if (!(load.kt_nmpa > 0.0) || !(load.inertia_kgm2 > 0.0) || m_stages[i].duration_ms == 0)
            return;
        const double needed = neededTorque_nm(m_stages[i], m_from.speed_rpm, load);
        const double given = availableTorque_nm(m_stages, i, m_ampsPerDigit, load);
        if (needed > given)
            add(RevUpMistake::TooLittleTorque, i, given, needed);
    }

    void current(std::size_t i)
    {
        double limit = m_limits.maxCurrent_a;
        const double nominal = m_limits.nominalCurrent_a;
        if (nominal > 0.0 && (!(limit > 0.0) || nominal < limit))
            limit = nominal;
        constexpr double kHalfDigit = 0.5; // a limit has no digits of its own
        if (limit > 0.0 && amps(m_stages[i]) > limit + kHalfDigit * m_ampsPerDigit)
            add(RevUpMistake::TooMuchCurrent, i, amps(m_stages[i]), limit);
    }

    void time(std::size_t i)
    {
        const RevUpStage &stage = m_stages[i];
        const bool jumps =
            stage.speed_rpm != m_from.speed_rpm || stage.current_digits != m_from.current_digits;
        if (stage.duration_ms == 0 && jumps)
            add(RevUpMistake::StageWithoutTime, i, 0.0, 1.0);
    }

    void speed(std::size_t i)
    {
        const double rpm = m_stages[i].speed_rpm;
        const double largest = std::numeric_limits<std::int16_t>::max();
        if (std::abs(rpm) > largest)
            add(RevUpMistake::SpeedDoesNotFit, i, rpm, largest);
        else if (m_limits.maxSpeed_rpm > 0.0 && std::abs(rpm) > m_limits.maxSpeed_rpm)
            add(RevUpMistake::SpeedBeyondLimit, i, rpm, m_limits.maxSpeed_rpm);
        if (rpm * m_from.speed_rpm < 0.0)
            add(RevUpMistake::TurnsBack, i, rpm, 0.0);
    }

    void finalSpeed()
    {
        const double rpm = std::abs(static_cast<double>(m_stages[m_used - 1].speed_rpm));
        if (m_limits.minimumSpeed_rpm > 0.0 && rpm <= m_limits.minimumSpeed_rpm)
            add(RevUpMistake::EndsTooSlow, m_used - 1, rpm, m_limits.minimumSpeed_rpm);
    }

    const RevUp &m_stages;
    double m_ampsPerDigit;
    const RevUpLimits &m_limits;
    std::size_t m_used;
    RevUpStage m_from;
    std::vector<RevUpFinding> m_findings;
};

} // namespace

std::vector<RevUpFinding> checkRevUp(
    const RevUp &stages, double ampsPerDigit, const RevUpLimits &limits)
{
    return Inspection(stages, ampsPerDigit, limits).run();
}

} // namespace motor
