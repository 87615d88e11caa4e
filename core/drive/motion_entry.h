// The motion log: who asked a motor for what, when, how it ended, and which bytes left for it. A drive makes one entry
// for each act once its end is known, a stop one for each of its four words. They are only appended.
//
// The texts here are the log's own words, the same in every language, because files of different people are compared.
#pragma once

#include "base/bytes.h"
#include "base/time.h"
#include "drive/wish.h"

#include <optional>
#include <string>
#include <vector>

namespace catalog {
class Catalog;
}

namespace drive {

enum class Outcome : std::uint8_t;
enum class StopWord : std::uint8_t;

enum class MotionAct : std::uint8_t {
    Arm,
    Disarm,
    Limits, ///< the user's own
    Expert,
    CurrentScale, ///< as the user knows it
    Start,
    Stop, ///< of every motor, by the user
    StopMotor,
    StopRamp,
    AcknowledgeFaults,
    SpeedRamp,
    TorqueRamp,
    CurrentReference,
    PositionRamp,
    Write, ///< of a register that can move or harm something
};

struct MotionEntry {
    MotionAct act = MotionAct::Start;
    int motor = 0; ///< 0: none in particular
    Source source = Source::Person;
    TimePoint asked, ended;
    std::string detail; ///< numbers with units, names of registers; from core
    Outcome outcome{};
    std::string reason; ///< why not, the board's or the drive's word
    std::optional<StopWord> stop; ///< what is known of a stop with this entry
    std::size_t requests = 0; ///< how many left that can change something
    std::vector<Bytes> sent; ///< their payloads as on the wire, the first kMostSent of them
    static constexpr std::size_t kMostSent = 32;
};

/// The entry that a wish begins; empty for wishes that move nothing and can harm nothing.
std::optional<MotionEntry> motionOf(
    const Wish &wish, const catalog::Catalog &catalog, TimePoint now);
/// Notes a request that leaves for the act and can change something.
void noteSent(MotionEntry &entry, ByteView request);

std::string_view wordOf(MotionAct act); ///< "SPEED_RAMP"
std::string_view wordOf(Source source); ///< "person"
std::string_view wordOf(Outcome outcome); ///< "ok"
std::string_view wordOf(StopWord word); ///< "drive idle"

} // namespace drive
