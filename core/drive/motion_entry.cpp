#include "drive/motion_entry.h"

#include "base/text.h"
#include "catalog/catalog.h"
#include "drive/event.h"
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
    MotionEntry entry;

    bool begin(MotionAct act, int motor, std::string detail = {})
    {
        entry.act = act;
        entry.motor = motor;
        entry.detail = std::move(detail);
        return true;
    }

    bool operator()(const Command &command)
    {
        using enum MotionAct;
        static constexpr MotionAct kActs[]{Start, StopMotor, StopRamp, AcknowledgeFaults};
        return begin(kActs[static_cast<std::size_t>(command.action)], command.motor);
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
        entry.act = MotionAct::Write;
        std::size_t named = 0;
        for (const RegisterWrite &one : write.writes) {
            const auto *info = catalog.find(one.id);
            if (info == nullptr || (!info->dangerous && info->setPoint == catalog::SetPoint::None))
                continue;
            if (++named > kMostNamed)
                continue;
            if (named == 1 && info->perMotor)
                entry.motor = catalog.motorOf(one.id);
            entry.detail +=
                (named > 1 ? "; " : "") + catalog.nameOf(one.id) + " = " + valueText(catalog, one);
        }
        if (named > kMostNamed)
            entry.detail += "; and " + std::to_string(named - kMostNamed) + " more";
        return named > 0;
    }
    bool operator()(const Read &) { return false; }
    bool operator()(const Stream &) { return false; }
    bool operator()(const CyclicSetPoints &) { return false; }
    bool operator()(const Watch &) { return false; }
};

} // namespace

std::optional<MotionEntry> motionOf(
    const Wish &wish, const catalog::Catalog &catalog, TimePoint now)
{
    Begin begin{catalog, {}};
    begin.entry.asked = begin.entry.ended = now;
    begin.entry.source = wish.source;
    if (!std::visit(begin, wish.what))
        return std::nullopt;
    return std::move(begin.entry);
}

void noteSent(MotionEntry &entry, ByteView request)
{
    ++entry.requests;
    if (entry.sent.size() < MotionEntry::kMostSent)
        entry.sent.emplace_back(request.begin(), request.end());
}

std::string_view wordOf(MotionAct act)
{
    using enum MotionAct;
    static constexpr Word<MotionAct> kWords[] = {{"ARM", Arm}, {"DISARM", Disarm},
        {"LIMITS", Limits}, {"EXPERT_MODE", Expert}, {"CURRENT_SCALE", CurrentScale},
        {"START", Start}, {"STOP", Stop}, {"STOP_MOTOR", StopMotor}, {"STOP_RAMP", StopRamp},
        {"FAULT_ACK", AcknowledgeFaults}, {"SPEED_RAMP", SpeedRamp}, {"TORQUE_RAMP", TorqueRamp},
        {"CURRENT_REFERENCE", CurrentReference}, {"POSITION_RAMP", PositionRamp}, {"WRITE", Write}};
    return wordFor(kWords, act);
}

std::string_view wordOf(Source source)
{
    static constexpr Word<Source> kWords[] = {{"person", Source::Person},
        {"command line", Source::CommandLine}, {"script", Source::Script}};
    return wordFor(kWords, source);
}

std::string_view wordOf(Outcome outcome)
{
    static constexpr Word<Outcome> kWords[] = {{"ok", Outcome::Ok}, {"refused", Outcome::Refused},
        {"not sent", Outcome::NotSent}, {"unknown", Outcome::Unknown}};
    return wordFor(kWords, outcome);
}

std::string_view wordOf(StopWord word)
{
    using enum StopWord;
    static constexpr Word<StopWord> kWords[] = {{"requested", Requested}, {"accepted", Accepted},
        {"drive idle", DriveIdle}, {"standstill measured", Standstill},
        {"speed not measurable", MayCoast}, {"NOT confirmed", NotConfirmed}};
    return wordFor(kWords, word);
}

} // namespace drive
