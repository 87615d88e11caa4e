#include "drive/motion_of.h"

#include "base/text.h"
#include "drive/values.h"

namespace drive {

namespace {

constexpr std::size_t kMostNamed = 8; ///< registers in the detail of a write

std::string inTime(std::chrono::milliseconds duration)
{
    return " in " + std::to_string(duration.count()) + " ms";
}

std::string limitText(double limit, const char *unit)
{
    return limit > 0.0 ? shortNumber(limit) + unit : std::string("none");
}

std::string valueText(const catalog::Catalog &catalog, const RegisterWrite &write)
{
    if (const auto *bytes = std::get_if<Bytes>(&write.value))
        return "0x" + hexOf(*bytes);
    const auto value = asNumber(write.value);
    if (!value)
        return "?";
    const catalog::Scale scale = catalog.readScale(write.id);
    return shortNumber(*value * scale.factor) + (scale.unit.empty() ? "" : " " + scale.unit);
}

struct Begin {
    const catalog::Catalog &catalog;
    MotionRecord record;

    bool begin(MotionAct act, int motor, std::string detail = {})
    {
        record.act = act;
        record.motor = motor;
        record.detail = std::move(detail);
        return true;
    }

    bool operator()(const Command &command)
    {
        switch (command.action) {
        case MotorAction::Start:
            return begin(MotionAct::Start, command.motor);
        case MotorAction::StopMotor:
            return begin(MotionAct::StopMotor, command.motor);
        case MotorAction::StopRamp:
            return begin(MotionAct::StopRamp, command.motor);
        case MotorAction::AcknowledgeFaults:
            break;
        }
        return begin(MotionAct::AcknowledgeFaults, command.motor);
    }
    bool operator()(const SpeedRamp &ramp)
    {
        return begin(MotionAct::SpeedRamp, ramp.motor,
            std::to_string(ramp.rpm) + " rpm" + inTime(ramp.duration));
    }
    bool operator()(const TorqueRamp &ramp)
    {
        return begin(MotionAct::TorqueRamp, ramp.motor,
            shortNumber(ramp.amps) + " A" + inTime(ramp.duration));
    }
    bool operator()(const CurrentReference &reference)
    {
        return begin(MotionAct::CurrentReference, reference.motor,
            "Iq " + shortNumber(reference.iqAmps) + " A, Id " + shortNumber(reference.idAmps)
                + " A");
    }
    bool operator()(const PositionRamp &ramp)
    {
        return begin(MotionAct::PositionRamp, ramp.motor,
            shortNumber(ramp.radians) + " rad" + inTime(ramp.duration));
    }
    bool operator()(const UserLimits &limits)
    {
        return begin(MotionAct::Limits, 0,
            limitText(limits.maxSpeedRpm, " rpm") + ", " + limitText(limits.maxCurrentAmps, " A"));
    }
    bool operator()(const ExpertMode &expert) { return begin(MotionAct::Expert, expert.motor); }
    bool operator()(const CurrentScale &scale)
    {
        return begin(MotionAct::CurrentScale, scale.motor, limitText(scale.fullScaleAmps, " A"));
    }
    bool operator()(const Write &write)
    {
        record.act = MotionAct::Write;
        std::size_t named = 0;
        for (const RegisterWrite &one : write.writes) {
            const auto *info = catalog.find(one.id);
            if (info == nullptr || (!info->dangerous && info->setPoint == catalog::SetPoint::None))
                continue;
            if (++named > kMostNamed)
                continue;
            if (named == 1 && info->perMotor)
                record.motor = catalog.motorOf(one.id);
            record.detail +=
                (named > 1 ? "; " : "") + catalog.nameOf(one.id) + " = " + valueText(catalog, one);
        }
        if (named > kMostNamed)
            record.detail += "; and " + std::to_string(named - kMostNamed) + " more";
        return named > 0;
    }
    bool operator()(const Read &) { return false; }
    bool operator()(const Stream &) { return false; }
    bool operator()(const CyclicSetPoints &) { return false; }
    bool operator()(const Watch &) { return false; }
};

} // namespace

std::optional<MotionRecord> motionOf(
    const Wish &wish, const catalog::Catalog &catalog, TimePoint now)
{
    Begin begin{catalog, {}};
    begin.record.asked = begin.record.ended = now;
    begin.record.source = wish.source;
    if (!std::visit(begin, wish.what))
        return std::nullopt;
    return std::move(begin.record);
}

void noteSent(MotionRecord &record, ByteView request)
{
    ++record.requests;
    if (record.sent.size() < MotionRecord::kMostSent)
        record.sent.emplace_back(request.begin(), request.end());
}

} // namespace drive
