// What has to be written so that a board holds again what a snapshot says, and what must not be written. Decides only;
// the drive writes and reads back.
#pragma once

#include "snapshots/snapshot.h"

namespace snapshots {

/// Why a register that differs is not restored.
enum class NotRestored : std::uint8_t {
    NotOnBoard, ///< this build does not have it, or it cannot be written there
    OtherType, ///< it holds something else in this firmware
    Moves, ///< a set-point, a mode, a command or the like: a motor would follow it
    MotorMoves, ///< a write of it can move something, and the motor is not idle
    ReadsDifferently, ///< firmware gives it in another form than it takes it: what was read must not be written
};

struct RestorePlan {
    std::vector<drive::RegisterWrite> writes; ///< in the order in which they should go out
    struct Left {
        std::string name; ///< NAME or NAME@MOTOR, as the snapshot has it
        NotRestored why = NotRestored::NotOnBoard;
    };
    std::vector<Left> left;
};

/// Only tunable registers, and of those only what differs: what has its value already is not touched. What is tunable
/// the catalogue decides, not the file: a file of another time may call a set-point so, and it is left and named. Gains
/// come first, then structures, and last what is dangerous to write: on a board each of these changes what the ones
/// before it mean. The writes are to be sent with drive::Reach::Parameters.
/// @param now  what the board holds; registers that are not in there count as not on the board
/// @param moving  motors that are not idle: what is dangerous to write is left alone there
RestorePlan planRestore(const Snapshot &wanted, const Snapshot &now,
    const catalog::Catalog &catalog, const Selection &selection = {},
    const std::vector<int> &moving = {});

/// Names and boards that two snapshots do not share: another control board, power board or motor. Empty: the same
/// hardware, as far as it says. Firmware versions may differ.
std::vector<std::string> otherHardware(const drive::Identity &wanted, const drive::Identity &now);

} // namespace snapshots
