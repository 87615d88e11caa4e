#include "drive/motion_record.h"

#include "base/text.h"
#include "drive/event.h"

#include <charconv>

namespace drive {

namespace {

std::string hex(const std::vector<Bytes> &requests, std::size_t all)
{
    std::string text;
    for (const Bytes &request : requests)
        text += (text.empty() ? "" : " | ") + hexOf(request, " ");
    if (all > requests.size())
        text += " | and " + std::to_string(all - requests.size()) + " more";
    return text;
}

/// A cell that a spreadsheet takes as text: quoted where it must be, never a formula.
std::string cell(std::string_view text)
{
    std::string safe;
    if (!text.empty() && std::string_view("=+-@\t").find(text.front()) != std::string_view::npos)
        safe.push_back('\'');
    for (const char c : text)
        safe.push_back(static_cast<unsigned char>(c) < 0x20 ? ' ' : c);
    if (safe.find_first_of(",\"") == std::string::npos)
        return safe;
    std::string quoted = "\"";
    for (const char c : safe) {
        if (c == '"')
            quoted.push_back('"');
        quoted.push_back(c);
    }
    return quoted + '"';
}

std::string milliseconds(Duration time)
{
    char text[32];
    const double value = std::chrono::duration<double, std::milli>(time).count();
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 1).ptr};
}

} // namespace

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

std::string motionLogHeading()
{
    return "number,time,who,source,motor,command,detail,outcome,reason,took [ms],bytes";
}

std::string motionLogLine(
    const MotionRecord &record, std::size_t number, std::string_view time, std::string_view who)
{
    std::string line = std::to_string(number);
    const auto add = [&line](std::string_view text) { line += ',' + cell(text); };
    add(time);
    add(who);
    add(wordOf(record.source));
    add(record.motor > 0 ? std::to_string(record.motor) : std::string());
    add(wordOf(record.act));
    add(record.detail);
    add(record.stop ? wordOf(*record.stop) : wordOf(record.outcome));
    add(record.reason);
    add(milliseconds(record.ended - record.asked));
    add(hex(record.sent, record.requests));
    return line;
}

} // namespace drive
