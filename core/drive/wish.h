// What can be asked of a drive: plain values that cross from the window to the worker thread. Neutral: no
// protocol's name or number is in here.
#pragma once

#include "base/time.h"
#include "catalog/register_info.h"

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace drive {

using catalog::RegisterId;
using catalog::Value;

/// Chosen by the caller; the matching Ended event carries it back. 0: the end is not waited for.
using WishId = std::uint64_t;

/// Who wants something; kept in the motion log.
enum class Source : std::uint8_t {
    Person, ///< at a window
    CommandLine,
    Script,
};

struct Read {
    std::vector<RegisterId> registers;
};
struct RegisterWrite {
    RegisterId id = 0;
    Value value;
    bool operator==(const RegisterWrite &) const = default;
};
/// How far a list of writes may reach: what lies beyond is refused, register by register.
enum class Reach : std::uint8_t {
    Parameters, ///< gains, limits, stages of a start-up: nothing that moves a motor. For what comes from a file
    References, ///< set-points and the control mode too, within the limits
    Everything, ///< the user's explicit word: also what nothing here bounds (catalog::RegisterInfo::takesWord)
};
/// Written in this order, in as few requests as the link's rules allow, then read back.
struct Write {
    std::vector<RegisterWrite> writes;
    Reach reach = Reach::References;
};

enum class MotorAction : std::uint8_t {
    Start,
    /// Of this motor alone, once, as the end of an act that began it (a jog). Not the Stop of the user, which is
    /// Drive::stop(): it is not repeated, and disarms nothing.
    StopMotor,
    StopRamp,
    AcknowledgeFaults
};
struct Command {
    MotorAction action = MotorAction::Start;
    int motor = 1;
};
struct SpeedRamp {
    int motor = 1;
    std::int32_t rpm = 0; ///< mechanical, signed
    std::chrono::milliseconds duration{};
};
struct TorqueRamp {
    int motor = 1;
    double amps = 0.0; ///< peak value of Iq
    std::chrono::milliseconds duration{};
};
struct CurrentReference {
    int motor = 1;
    double iqAmps = 0.0;
    double idAmps = 0.0;
};

/// The shaft to an angle, where the board controls positions; the board's own zero.
struct PositionRamp {
    int motor = 1;
    double radians = 0.0; ///< mechanical, turns included
    std::chrono::milliseconds duration{};
};

/// What the user allows, whatever a board says its motors stand: the lower of the two counts, for every motor and until
/// the next such wish. Zero: no limit of one's own. Needs neither a connection nor arming.
struct UserLimits {
    double maxSpeedRpm = 0.0;
    double maxCurrentAmps = 0.0; ///< peak
    bool operator==(const UserLimits &) const = default;
};
/// The user's word that a motor is to be moved although its board does not tell its limits (drive/motion_limits.h).
/// Ends with the connection; refused where nothing is unknown.
struct ExpertMode {
    int motor = 1;
};

/// Digits of the full-scale current: those of firmware's 16-bit fractions.
inline constexpr double kFullScaleDigits = 32768.0;

/// The scale of a motor's currents as the user knows it, for boards that do not tell it.
/// Zero: not known. Holds for this connection. Nothing is sent; what waits to be written is cut, and the drive is
/// disarmed, because it was meant by the scale before. Refused where the board tells its scale.
struct CurrentScale {
    int motor = 1;
    double fullScaleAmps = 0.0; ///< peak, of kFullScaleDigits
};

/// Signals that the board records by itself at its control rate. Replaces what was streamed before; empty stops.
struct Stream {
    std::vector<RegisterId> fast; ///< in the order wanted
    unsigned fastEvery = 1; ///< one sample every so many control periods, 1..256
    std::vector<RegisterId> slow;
    unsigned slowEvery = 1; ///< one slow group every so many fast samples, 1..254, or:
    static constexpr unsigned kSlowOncePerPacket = 255; ///< behind the last sample of each packet
};

/// Whether set-points travel with every exchange, instead of as a write of their own. It moves nothing by itself: what
/// the drive has is held. It begins only while the motor stands and ends with the connection; a position is always
/// written.
struct CyclicSetPoints {
    bool on = true;
};

/// Registers to be read over and over; replaces the list before. The drive spreads them over the spare link time.
struct Watch {
    std::vector<RegisterId> registers;
    /// Wished for; the rate reached is what the link can spare.
    Duration period = std::chrono::milliseconds(100);
    /// Of them, those that are drawn: where boards record nothing by themselves they are read as often as the line
    /// gives.
    std::vector<RegisterId> drawn = {};
};

/// What acts (Permission::Armed, and arming) is done at once or not at all: a wish that is older than this when the
/// link is free for it ends NotSent. A start that leaves seconds after its key was pressed is not expected any more.
constexpr Duration kWishExpiresAfter = std::chrono::milliseconds(500);
inline constexpr char kTooLate[] = "too late: it was asked for more than half a second ago";
inline constexpr char kNoAnswer[] = "no answer"; ///< why a wish ended, too

using WishContent = std::variant<Read, Write, Command, SpeedRamp, TorqueRamp, CurrentReference,
    PositionRamp, Stream, CyclicSetPoints, Watch, UserLimits, ExpertMode, CurrentScale>;
struct Wish {
    WishId id = 0;
    WishContent what;
    Source source = Source::Person;
    /// When the act that it comes from happened, e.g. the key press; empty: when it is submitted.
    std::optional<TimePoint> madeAt = {};
};

} // namespace drive
