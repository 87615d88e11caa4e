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
    switch (act) {
    case MotionAct::Arm:
        return "ARM";
    case MotionAct::Disarm:
        return "DISARM";
    case MotionAct::Limits:
        return "LIMITS";
    case MotionAct::Expert:
        return "EXPERT_MODE";
    case MotionAct::CurrentScale:
        return "CURRENT_SCALE";
    case MotionAct::Start:
        return "START";
    case MotionAct::Stop:
        return "STOP";
    case MotionAct::StopMotor:
        return "STOP_MOTOR";
    case MotionAct::StopRamp:
        return "STOP_RAMP";
    case MotionAct::AcknowledgeFaults:
        return "FAULT_ACK";
    case MotionAct::SpeedRamp:
        return "SPEED_RAMP";
    case MotionAct::TorqueRamp:
        return "TORQUE_RAMP";
    case MotionAct::CurrentReference:
        return "CURRENT_REFERENCE";
    case MotionAct::PositionRamp:
        return "POSITION_RAMP";
    case MotionAct::Write:
        break;
    }
    return "WRITE";
}

std::string_view wordOf(Source source)
{
    switch (source) {
    case Source::Person:
        return "person";
    case Source::CommandLine:
        return "command line";
    case Source::Script:
        break;
    }
    return "script";
}

std::string_view wordOf(Outcome outcome)
{
    switch (outcome) {
    case Outcome::Ok:
        return "ok";
    case Outcome::Refused:
        return "refused";
    case Outcome::NotSent:
        return "not sent";
    case Outcome::Unknown:
        break;
    }
    return "unknown";
}

std::string_view wordOf(StopWord word)
{
    switch (word) {
    case StopWord::Requested:
        return "requested";
    case StopWord::Accepted:
        return "accepted";
    case StopWord::DriveIdle:
        return "drive idle";
    case StopWord::Standstill:
        return "standstill measured";
    case StopWord::MayCoast:
        return "speed not measurable";
    case StopWord::NotConfirmed:
        break;
    }
    return "NOT confirmed";
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
