// What the user sets of the trigger, as one value in the units people read, and which of its fields matter for which
// type. core/scope searches; nothing here touches samples.
#pragma once

#include "scope/acquisition.h"

#include <QList>
#include <QString>

namespace widgets {

enum class TriggerType : std::uint8_t {
    Edge,
    Level,
    Window,
    Pulse,
    Slew,
    Dropout,
    NthEdge,
    StateChange,
    Fault,
    RegisterWrite,
    SetPoint,
};
inline constexpr int kTriggerTypes = 11;

/// Which way, in the words of the type: a slope, a side, a direction or a polarity.
enum class TriggerWay : std::uint8_t { First, Second, Third };

struct TriggerSetup {
    TriggerType type = TriggerType::Edge;
    TriggerWay way = TriggerWay::First;
    double level = 0.0; ///< of a window and a slew the lower one; the source's unit
    double upper = 1.0;
    double hysteresis = 0.0;
    double least = 0.0; ///< seconds, of a width or a rise
    double most = 1.0; ///< seconds
    bool outside = false; ///< all durations but [least, most]
    double time = 0.01; ///< seconds, of a dropout; of the pause before counting for the n-th edge
    int count = 2;
    /// The register whose write is waited for, by plainName(); empty: any.
    QString written;

    scope::Mode mode = scope::Mode::Roll;
    double preTrigger = 0.2; ///< share of the record
    double holdOff = 0.0; ///< seconds
    double length = 0.05; ///< seconds, of the record: what the picture shows

    bool operator==(const TriggerSetup &) const = default;
};

/// The fields that a type needs; all others have no effect.
struct TriggerFields {
    bool source = true; ///< a trace with a level; false: an event
    bool written = false;
    bool ways = true;
    bool upper = false;
    bool hysteresis = true;
    bool durations = false;
    bool time = false;
    bool count = false;
};
TriggerFields fieldsOf(TriggerType type);

/// A register's name as every board has it: the first motor's number is told only where there are several.
QString plainName(QString name);

QString typeText(TriggerType type);
/// A sign for narrow places and the word; the index is a TriggerWay.
struct WayText {
    QString sign;
    QString word;
};
QList<WayText> wayTexts(TriggerType type);
QString levelName(TriggerType type); ///< "Level", or "Lower level" where there are two
QString modeText(scope::Mode mode);
QString stateText(scope::AcquisitionState state); ///< the word on the screen
/// "3 s ago", as coarse as an age deserves.
QString ageText(double seconds);
QString conditionErrorText(scope::ConditionError error);

/// @param source  the channel that is watched
scope::TriggerCondition conditionOf(
    const TriggerSetup &setup, const std::optional<capture::ChannelInfo> &source);
scope::AcquisitionSettings settingsOf(
    const TriggerSetup &setup, const std::optional<capture::ChannelInfo> &source);

} // namespace widgets
