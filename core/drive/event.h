// What a drive tells: plain values that cross from the worker thread to the window. Neutral.
#pragma once

#include "base/time.h"
#include "capture/sample_block.h"
#include "catalog/catalog.h"
#include "drive/motion_entry.h"
#include "drive/wish.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace drive {

enum class LinkState : std::uint8_t {
    Closed, ///< nothing is asked
    Connecting,
    Connected,
    Suspect, ///< connected, but nothing valid was heard for a while
    Recovering, ///< out of step; a dialogue is under way
    Lost, ///< given up; the reason says why
};

enum class LinkReason : std::uint8_t {
    None,
    NoAnswer,
    OnlyGarbage,
    NoAgreement,
    Silence,
    RecoveryFailed,
    BoardReset, ///< connected again, but the board had been reset
    OldProtocol, ///< the board speaks an older protocol
    NotReady, ///< the line by which the drive says that it is ready stays low
    DeadLine, ///< only zeros, or only ones: the line is not driven
    AskingNewer, ///< Connecting: it is tried whether a board speaks a newer protocol
    AskingOlder, ///< Connecting: and now an older one
    OtherProtocol, ///< the board refused as one of the newer protocol does
};

struct LinkChanged {
    LinkState state = LinkState::Closed;
    LinkReason reason = LinkReason::None;
};

/// What the board said of itself. Text is the device's: never format or rich text.
struct Identity {
    /// For people, e.g. "MCP over ASPEP 6.4.0": comes from core, shown as it is.
    std::string protocol;
    std::string firmware; ///< name
    std::string version; ///< e.g. "6.4.0"
    std::string controlBoard;
    std::vector<std::string> powerBoards; ///< one a motor
    std::vector<std::string> motorNames; ///< one a motor
    int motors = 1;
    /// The drive stops its motor by itself when it hears nothing for that long; none: it turns on.
    std::optional<std::chrono::milliseconds> watchdog;
    bool knownFirmware = true; ///< false: registers are shown raw and nothing is written
    std::string evidence = {}; ///< by what the protocol was recognised, in words; from core
    /// One a motor: the register that its main sensor's speed is streamed from; empty: none, it is polled.
    std::vector<std::string> speedSignals = {};
};

/// What bounds a set-point of one motor. Zero: the board did not say.
struct MotorLimits {
    double maxSpeedRpm = 0.0;
    double maxCurrentAmps = 0.0;
    double nominalCurrentAmps = 0.0;
    double polePairs = 0.0;
    double torquePerAmp = 0.0; ///< N m for each A of Iq
    double saliency_h = 0.0; ///< Lq less Ld, where it is more and both are told
    double speedStepRpm = 1.0; ///< what a set-point of speed resolves, or what people ask for
    /// The greatest speed that the protocol holds.
    double wireRpm = std::numeric_limits<double>::infinity();
};

/// What can be streamed, and what the link can carry.
struct StreamLimits {
    double tickHz = 0.0; ///< control periods a second; 0: no streaming
    unsigned maxSignals = 0;
    std::size_t maxPacket = 0; ///< bytes
    double linkBytesPerSecond = 0.0;
    double readsPerSecond = 0.0; ///< registers that can be read one by one, at best; 0: not told
    /// Bytes around the samples of a period where each is a frame of its own, with requests in it and samples as wide
    /// as their registers. 0: packets gather samples.
    std::size_t frameOverhead = 0;
};

enum class Feature : std::uint8_t {
    Start,
    Stop,
    AcknowledgeFaults,
    SpeedRamp,
    TorqueRamp,
    CurrentReference,
    Stream,
    WriteRegisters,
    PositionRamp,
    CyclicSetPoints,
    CurrentScale ///< the user says the scale of currents, because the board does not
};
inline constexpr std::size_t kFeatures = static_cast<std::size_t>(Feature::CurrentScale) + 1;
struct Capability {
    Feature feature;
    bool available = true;
    std::string reason; ///< why not; from core, for a tool tip
};

enum class MotorState : std::uint8_t {
    Unknown,
    Idle,
    Starting,
    Running,
    Stopping,
    FaultNow,
    FaultOver
};

/// There is one, or it waits to be acknowledged.
constexpr bool hasFault(MotorState state)
{
    return state == MotorState::FaultNow || state == MotorState::FaultOver;
}
/// Nothing drives the motor; it may turn on by itself. False if it is not known.
constexpr bool rests(MotorState state) { return state == MotorState::Idle || hasFault(state); }

/// One step of what a motor goes through: the firmware's names of the states that it covers.
struct StateStep {
    MotorState state = MotorState::Unknown;
    std::vector<std::string> names;
};

struct Identified {
    Identity identity;
    std::shared_ptr<const catalog::Catalog> catalog;
    std::vector<MotorLimits> limits; ///< one a motor
    StreamLimits streaming;
    std::vector<Capability> capabilities;
    std::size_t requestBytes = 0, responseBytes = 0, streamBytes = 0; ///< negotiated sizes
    std::vector<StateStep> states = {}; ///< in the order in which a run goes through them
};

enum class ReadStatus : std::uint8_t { Ok, NotSupported, Refused };
struct Reading {
    RegisterId id = 0;
    ReadStatus status = ReadStatus::Ok;
    Value value;
    TimePoint at; ///< when the answer came
    /// The value was true at some time within so long before `at`; 0: not told.
    Duration spread{};
};
struct RegistersRead {
    std::vector<Reading> readings;
};

/// How a wish ended; exactly one for each.
enum class Outcome : std::uint8_t {
    Ok,
    Refused, ///< the board or the drive said no; nothing or only a part happened (see writes)
    NotSent, ///< certainly not carried out
    Unknown, ///< sent, the answer was lost; whether it happened must be read back
};
struct WriteResult {
    RegisterId id = 0;
    Outcome outcome = Outcome::Ok;
    std::string reason; ///< the board's word for its refusal, e.g. "RO_REG"
    /// Value known before the write: read right before it, or a moment ago with nothing written since (LatelyRead).
    std::optional<Value> before;
    std::optional<Value> readBack; ///< value after it
    /// Written, and what was read back is what was written. Empty: not written, or not read back.
    std::optional<bool> verified;
};
struct Ended {
    WishId id = 0;
    Outcome outcome = Outcome::Ok;
    std::string reason; ///< the board's or the drive's word, from core
    std::vector<WriteResult> writes;
    bool byProgram = false; ///< refused before anything of it left: the board was not asked
};

struct MotorStatus {
    int motor = 1;
    MotorState state = MotorState::Unknown;
    std::int64_t rawState = 0;
    bool waitsForBus = false; ///< starting, but nothing drives the motor until the bus has risen
    std::string stateName; ///< the firmware's name, e.g. "CHARGE_BOOT_CAP"
    std::vector<std::string> faultsNow; ///< by name, present
    std::vector<std::string> faultsPast; ///< occurred and not acknowledged
    std::optional<double> speedRpm;
    /// Whether an encoder or Hall sensors tell the speed, also of a rotor that nothing drives. An observer does not:
    /// without voltages it sees nothing. Empty: not known yet.
    std::optional<bool> speedMeasured = {};
    TimePoint at;
    TimePoint asked = {}; ///< when the reading began: it is no older than that; 0: not known
};

/// A stream takes effect; every block that follows belongs to it until the next one. An empty layout: stopped.
struct StreamStarted {
    capture::StreamLayout layout;
};

/// Whether set-points travel with every exchange from now on.
struct CyclicSetPointsChanged {
    bool on = false;
};

/// The four words of a stop, each with its own evidence, and the alarm when there is none. The last word is MayCoast,
/// and never Standstill, where nothing measures the speed of a rotor that is not driven.
enum class StopWord : std::uint8_t {
    Requested,
    Accepted,
    DriveIdle,
    Standstill,
    NotConfirmed,
    MayCoast
};
struct StopProgress {
    int motor = 1;
    StopWord word = StopWord::Requested;
    TimePoint at;
};

/// Counters since the port was opened; they only grow.
struct LinkCounters {
    std::uint64_t bytesIn = 0, bytesOut = 0;
    std::uint64_t packetsIn = 0, packetsOut = 0;
    std::uint64_t badPackets = 0; ///< all the ways a packet can be bad, added up
    std::uint64_t nacks = 0;
    std::uint64_t timeouts = 0;
    std::uint64_t recoveries = 0;
    std::uint64_t streamPackets = 0;
    std::uint64_t streamLostTicks = 0; ///< control periods that no packet holds
    std::uint64_t streamSkipped = 0; ///< packets of unknown kind, mark or length
    bool operator==(const LinkCounters &) const = default;
};

using Event =
    std::variant<LinkChanged, Identified, RegistersRead, Ended, MotorStatus, StreamStarted,
        CyclicSetPointsChanged, capture::SampleBlock, StopProgress, LinkCounters, MotionEntry>;

} // namespace drive
