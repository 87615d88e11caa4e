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

    bool operator()(const Command &command)
    {
        record.motor = command.motor;
        switch (command.action) {
        case MotorAction::Start:
            record.act = MotionAct::Start;
            break;
        case MotorAction::StopMotor:
            record.act = MotionAct::StopMotor;
            break;
        case MotorAction::StopRamp:
            record.act = MotionAct::StopRamp;
            break;
        case MotorAction::AcknowledgeFaults:
            record.act = MotionAct::AcknowledgeFaults;
            break;
        }
        return true;
    }
    bool operator()(const SpeedRamp &ramp)
    {
        record.act = MotionAct::SpeedRamp;
        record.motor = ramp.motor;
        record.detail = std::to_string(ramp.rpm) + " rpm" + inTime(ramp.duration);
        return true;
    }
    bool operator()(const TorqueRamp &ramp)
    {
        record.act = MotionAct::TorqueRamp;
        record.motor = ramp.motor;
        record.detail = shortNumber(ramp.amps) + " A" + inTime(ramp.duration);
        return true;
    }
    bool operator()(const CurrentReference &reference)
    {
        record.act = MotionAct::CurrentReference;
        record.motor = reference.motor;
        record.detail = "Iq " + shortNumber(reference.iqAmps) + " A, Id "
            + shortNumber(reference.idAmps) + " A";
        return true;
    }
    bool operator()(const PositionRamp &ramp)
    {
        record.act = MotionAct::PositionRamp;
        record.motor = ramp.motor;
        record.detail = shortNumber(ramp.radians) + " rad" + inTime(ramp.duration);
        return true;
    }
    bool operator()(const UserLimits &limits)
    {
        const auto text = [](double limit, const char *unit) {
            return limit > 0.0 ? shortNumber(limit) + unit : std::string("none");
        };
        record.act = MotionAct::Limits;
        record.detail = text(limits.maxSpeedRpm, " rpm") + ", " + text(limits.maxCurrentAmps, " A");
        return true;
    }
    bool operator()(const ExpertMode &expert)
    {
        record.act = MotionAct::Expert;
        record.motor = expert.motor;
        return true;
    }
    bool operator()(const CurrentScale &scale)
    {
        record.act = MotionAct::CurrentScale;
        record.motor = scale.motor;
        record.detail = scale.fullScaleAmps > 0.0 ? shortNumber(scale.fullScaleAmps) + " A"
                                                  : std::string("none");
        return true;
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
