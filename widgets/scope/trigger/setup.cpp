#include "widgets/scope/trigger/setup.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {
struct TriggerText {
    Q_DECLARE_TR_FUNCTIONS(Trigger)
};

scope::Nanos nanos(double seconds) { return capture::toNanos(seconds); }

scope::Slope slopeOf(TriggerWay way)
{
    return way == TriggerWay::First ? scope::Slope::Rising
        : way == TriggerWay::Second ? scope::Slope::Falling
                                    : scope::Slope::Either;
}

scope::DurationTest durationsOf(const TriggerSetup &setup)
{
    using Where = scope::DurationTest::Where;
    return {nanos(setup.least), nanos(setup.most), setup.outside ? Where::Outside : Where::Inside};
}

decltype(scope::TriggerCondition::what) searchedFor(const TriggerSetup &setup)
{
    using namespace scope;
    const bool first = setup.way == TriggerWay::First;
    const EdgeTrigger edge{slopeOf(setup.way), setup.level, setup.hysteresis};
    switch (setup.type) {
    case TriggerType::Edge:
        break;
    case TriggerType::Level:
        return LevelTrigger{
            first ? LevelTrigger::Side::AtOrAbove : LevelTrigger::Side::AtOrBelow, setup.level};
    case TriggerType::Window:
        return WindowTrigger{first ? WindowTrigger::When::Leaves : WindowTrigger::When::Enters,
            setup.level, setup.upper, setup.hysteresis};
    case TriggerType::Pulse:
        return PulseTrigger{
            first ? PulseTrigger::Polarity::Positive : PulseTrigger::Polarity::Negative,
            setup.level, setup.hysteresis, durationsOf(setup)};
    case TriggerType::Slew:
        return SlewTrigger{
            slopeOf(setup.way), setup.level, setup.upper, setup.hysteresis, durationsOf(setup)};
    case TriggerType::Dropout:
        return DropoutTrigger{edge, nanos(setup.time)};
    case TriggerType::NthEdge:
        return NthEdgeTrigger{
            edge, static_cast<std::uint32_t>(std::max(setup.count, 0)), nanos(setup.time)};
    case TriggerType::StateChange:
        return EventTrigger{EventTrigger::Kind::StateChange, {}};
    case TriggerType::Fault:
        return EventTrigger{EventTrigger::Kind::Fault, {}};
    case TriggerType::RegisterWrite:
        return EventTrigger{EventTrigger::Kind::RegisterWrite, {}};
    case TriggerType::SetPoint:
        return EventTrigger{EventTrigger::Kind::SetPoint, {}};
    }
    return edge;
}
} // namespace

TriggerFields fieldsOf(TriggerType type)
{
    switch (type) {
    case TriggerType::Edge:
        return {};
    case TriggerType::Level:
        return {.hysteresis = false};
    case TriggerType::Window:
        return {.upper = true};
    case TriggerType::Pulse:
        return {.durations = true};
    case TriggerType::Slew:
        return {.upper = true, .durations = true};
    case TriggerType::Dropout:
        return {.time = true};
    case TriggerType::NthEdge:
        return {.time = true, .count = true};
    case TriggerType::StateChange:
    case TriggerType::Fault:
    case TriggerType::RegisterWrite:
    case TriggerType::SetPoint:
        break;
    }
    return {.source = false,
        .written = type == TriggerType::RegisterWrite,
        .ways = false,
        .hysteresis = false};
}

QString plainName(QString name)
{
    if (name.endsWith(QLatin1String("@1")))
        name.chop(2);
    return name;
}

QString typeText(TriggerType type)
{
    switch (type) {
    case TriggerType::Edge:
        return TriggerText::tr("Edge");
    case TriggerType::Level:
        return TriggerText::tr("Level");
    case TriggerType::Window:
        return TriggerText::tr("Window");
    case TriggerType::Pulse:
        return TriggerText::tr("Pulse width");
    case TriggerType::Slew:
        return TriggerText::tr("Slew");
    case TriggerType::Dropout:
        return TriggerText::tr("Dropout");
    case TriggerType::NthEdge:
        return TriggerText::tr("N-th edge");
    case TriggerType::StateChange:
        return TriggerText::tr("State change");
    case TriggerType::Fault:
        return TriggerText::tr("Fault");
    case TriggerType::RegisterWrite:
        return TriggerText::tr("Register write");
    case TriggerType::SetPoint:
        return TriggerText::tr("Set-point", "type of the trigger");
    }
    return {};
}

QList<WayText> wayTexts(TriggerType type)
{
    const WayText rising{QStringLiteral("\u2197"), TriggerText::tr("rising")};
    const WayText falling{QStringLiteral("\u2198"), TriggerText::tr("falling")};
    const WayText either{QStringLiteral("\u2195"), TriggerText::tr("either way")};
    switch (type) {
    case TriggerType::Edge:
    case TriggerType::Dropout:
    case TriggerType::NthEdge:
    case TriggerType::Slew:
        return {rising, falling, either};
    case TriggerType::Level:
        return {{QStringLiteral("\u2265"), TriggerText::tr("at or above")},
            {QStringLiteral("\u2264"), TriggerText::tr("at or below")}};
    case TriggerType::Window:
        return {{QStringLiteral("\u21a6"), TriggerText::tr("leaves the window")},
            {QStringLiteral("\u21a4"), TriggerText::tr("enters the window")}};
    case TriggerType::Pulse:
        return {{QStringLiteral("+"), TriggerText::tr("positive pulse")},
            {QStringLiteral("\u2212"), TriggerText::tr("negative pulse")}};
    case TriggerType::StateChange:
    case TriggerType::Fault:
    case TriggerType::RegisterWrite:
    case TriggerType::SetPoint:
        break;
    }
    return {};
}

QString levelName(TriggerType type)
{
    return fieldsOf(type).upper ? TriggerText::tr("Lower level") : TriggerText::tr("Level");
}

QString modeText(scope::Mode mode)
{
    switch (mode) {
    case scope::Mode::Auto:
        return TriggerText::tr("Auto", "mode of the trigger");
    case scope::Mode::Normal:
        return TriggerText::tr("Normal", "mode of the trigger");
    case scope::Mode::Single:
        return TriggerText::tr("Single", "mode of the trigger");
    case scope::Mode::Roll:
        return TriggerText::tr("Roll", "mode of the trigger");
    }
    return {};
}

QString stateText(scope::AcquisitionState state)
{
    switch (state) {
    case scope::AcquisitionState::Stop:
        return TriggerText::tr("Hold", "state of the trigger");
    case scope::AcquisitionState::Armed:
        return TriggerText::tr("Armed", "state of the trigger");
    case scope::AcquisitionState::Triggered:
        return TriggerText::tr("Trig'd", "state of the trigger");
    case scope::AcquisitionState::Auto:
        return TriggerText::tr("Auto", "state of the trigger");
    case scope::AcquisitionState::Roll:
        return TriggerText::tr("Roll", "state of the trigger");
    }
    return {};
}

QString ageText(double seconds)
{
    const QLocale locale;
    if (seconds < 0.95)
        return TriggerText::tr("%1 s ago").arg(locale.toString(std::max(seconds, 0.0), 'f', 1));
    if (seconds < 120.0)
        return TriggerText::tr("%1 s ago")
            .arg(locale.toString(std::floor(std::max(seconds, 1.0)), 'f', 0));
    return TriggerText::tr("%1 min ago").arg(locale.toString(std::floor(seconds / 60.0), 'f', 0));
}

QString conditionErrorText(scope::ConditionError error)
{
    switch (error) {
    case scope::ConditionError::NotFinite:
        return TriggerText::tr("A level or a time is no number.");
    case scope::ConditionError::NegativeHysteresis:
        return TriggerText::tr("The hysteresis is below zero.");
    case scope::ConditionError::LevelsSwapped:
        return TriggerText::tr("The upper level has to be above the lower one.");
    case scope::ConditionError::NoTime:
        return TriggerText::tr("These times leave nothing to wait for.");
    case scope::ConditionError::NoCount:
        return TriggerText::tr("The count has to be at least 1.");
    }
    return {};
}

scope::TriggerCondition conditionOf(
    const TriggerSetup &setup, const std::optional<capture::ChannelInfo> &source)
{
    scope::TriggerCondition condition;
    condition.what = searchedFor(setup);
    if (source)
        condition.between = scope::betweenSamples(*source);
    return condition;
}

scope::AcquisitionSettings settingsOf(
    const TriggerSetup &setup, const std::optional<capture::ChannelInfo> &source)
{
    scope::AcquisitionSettings settings;
    settings.condition = conditionOf(setup, source);
    settings.mode = setup.mode;
    settings.length = nanos(setup.length);
    settings.preTrigger = setup.preTrigger;
    settings.holdOff = nanos(setup.holdOff);
    return settings;
}

} // namespace widgets
