#include "widgets/files/happening_text.h"

#include "drive/event.h"
#include "drive/wish.h"
#include "recorded/drive_entries.h"
#include "widgets/base/device_text.h"
#include "widgets/base/messages.h"
#include "widgets/files/event_recorder.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace widgets {
namespace {

struct Happenings {
    Q_DECLARE_TR_FUNCTIONS(Happenings)
};

using recorded::Happening;

template <class Enum, std::size_t N>
std::optional<Enum> wordOf(
    const Happening &happening, std::string_view key, const std::array<const char *, N> &words)
{
    const auto found = std::find(words.begin(), words.end(), happening.field(key));
    return found == words.end() ? std::nullopt
                                : std::optional(static_cast<Enum>(found - words.begin()));
}

int motorOf(const Happening &happening) { return happening.number<int>("motor").value_or(1); }

/// A file does not say how many motors there were: the first one is not named.
QString ofMotor(const Happening &happening, const QString &text)
{
    return EventRecorder::motorText(motorOf(happening), text, motorOf(happening) > 1);
}

/// What a command or a ramp was as a wish; empty if it is none, or not all of it is there.
std::optional<drive::Wish> wishOf(const Happening &happening)
{
    const int motor = motorOf(happening);
    const auto amps = happening.number<double>("A");
    const auto radians = happening.number<double>("rad");
    const auto rpm = happening.number<std::int32_t>("rpm");
    const auto iq = happening.number<double>("Iq A");
    const auto id = happening.number<double>("Id A");
    const auto ms = happening.number<std::int64_t>("ms");
    const std::chrono::milliseconds time(ms.value_or(0));
    drive::Wish wish;
    const auto action = wordOf<drive::MotorAction>(happening, "action", recorded::kActionWords);
    if (happening.name == "command" && action)
        wish.what = drive::Command{*action, motor};
    else if (happening.name == "speed ramp" && rpm && ms)
        wish.what = drive::SpeedRamp{motor, *rpm, time};
    else if (happening.name == "torque ramp" && amps && ms)
        wish.what = drive::TorqueRamp{motor, *amps, time};
    else if (happening.name == "position ramp" && radians && ms)
        wish.what = drive::PositionRamp{motor, *radians, time};
    else if (happening.name == "current reference" && iq && id)
        wish.what = drive::CurrentReference{motor, *iq, *id};
    else
        return {};
    return wish;
}

/// The codes that were written: what they mean is not in the file.
QString writeText(const Happening &happening)
{
    QStringList writes;
    for (const auto &[name, value] : happening.fields)
        if (name != "wish")
            writes.append(QStringLiteral("%1 \u2192 %2").arg(deviceText(name), deviceText(value)));
    return writes.join(QStringLiteral(", "));
}

QString stateText(const Happening &happening)
{
    const auto state = wordOf<drive::MotorState>(happening, "state", recorded::kMotorStateWords);
    QString text = deviceText(happening.field("name"));
    if (text.isEmpty() && state)
        text = motorStateText(*state);
    const QString faults = deviceText(happening.field("faults now"));
    if (!text.isEmpty() && !faults.isEmpty())
        text += QStringLiteral(": ") + faults;
    return text.isEmpty() ? text : ofMotor(happening, text);
}

/// The counters that are not zero; they are those since the port was opened.
QString troubleText(const Happening &happening)
{
    const std::pair<const char *, QString> counters[] = {
        {"bad packets", Happenings::tr("bad packets: %1")},
        {"refused packets", Happenings::tr("refused packets: %1")},
        {"timeouts", Happenings::tr("unanswered: %1")},
        {"recoveries", Happenings::tr("recoveries: %1")},
        {"lost ticks", Happenings::tr("lost control periods: %1")},
        {"skipped stream packets", Happenings::tr("skipped packets: %1")}};
    QStringList texts;
    for (const auto &[key, text] : counters)
        if (const auto count = happening.number<std::uint64_t>(key); count && *count > 0)
            texts.append(text.arg(QString::number(*count)));
    return texts.join(QStringLiteral(", "));
}

QString endText(const Happening &happening)
{
    const auto outcome = wordOf<drive::Outcome>(happening, "outcome", recorded::kOutcomeWords);
    if (!outcome)
        return {};
    QStringList texts{outcomeText(*outcome)};
    for (const auto &[name, value] : happening.fields) {
        if (name == "reason" && !value.empty())
            texts.append(deviceText(value));
        else if (name != "wish" && name != "outcome" && name != "reason")
            texts.append(QStringLiteral("%1: %2").arg(deviceText(name), deviceText(value)));
    }
    return texts.join(QStringLiteral(", "));
}

/// Empty where there are no words for it.
QString ownText(const Happening &happening)
{
    if (const auto wish = wishOf(happening))
        return EventRecorder::wishText(*wish, motorOf(happening) > 1);
    if (happening.name == "write")
        return writeText(happening);
    if (happening.name == "motor state")
        return stateText(happening);
    if (happening.name == "link trouble")
        return troubleText(happening);
    if (happening.name == "ended")
        return endText(happening);
    if (happening.name == "link") {
        const auto state = wordOf<drive::LinkState>(happening, "state", recorded::kLinkStateWords);
        return state ? linkStateText(*state) : QString();
    }
    if (happening.name == "stop") {
        const auto word = wordOf<drive::StopWord>(happening, "word", recorded::kStopWords);
        return word ? ofMotor(happening, stopWordText(*word)) : EventRecorder::tr("Stop motors");
    }
    if (happening.name == "motion" && !happening.fields.empty())
        return deviceText(happening.fields.front().second);
    return {};
}

} // namespace

QString happeningText(const Happening &happening)
{
    QString text = ownText(happening);
    if (!text.isEmpty())
        return text;
    text = deviceText(happening.name);
    for (const auto &[key, value] : happening.fields)
        if (!value.empty() && key != "wish")
            text += QStringLiteral(" %1=%2").arg(deviceText(key), deviceText(value));
    return text;
}

} // namespace widgets
