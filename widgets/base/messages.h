// What core reports as enums, said in the user's language: one sentence each, with what to do where something can be
// done. The only place that does so. What the command line says too comes from session, and is translated here.
#pragma once

#include "drive/event.h"
#include "drive/motion_caution.h"
#include "session/files/whole_file.h"
#include "session/link/dead_man.h"
#include "session/transports/endpoint.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace widgets {

QString linkStateText(drive::LinkState state);
/// The same, where the reason is known: what never answered is no link that was lost.
QString linkStateText(const drive::LinkChanged &link);
QStringList linkStateTexts(); ///< all that there are
/// Whether the search for a board ended without one; nothing is known of a board that was there before.
bool noBoardFound(const drive::LinkChanged &link);
/// Why a link ended or came back, in one sentence; empty for None.
QString linkReasonText(drive::LinkReason reason);
/// What the banner says of time that was not attended.
QString interruptionText(const session::Interruption &what);
/// What the banner says of the motors when contact to a board is gone. @param watchdog  of the drive, if it has one
QString motorsOutOfReachText(bool wereAtRest, std::optional<std::chrono::milliseconds> watchdog);
/// Why a port could not be opened or is gone, and what to do; empty for None.
QString portProblemText(const session::PortError &error, const QString &port);
QString outcomeText(drive::Outcome outcome);
/// The same, and who refused it.
QString outcomeText(const drive::Ended &ended);
/// The drive's own word for why something was not done; empty: it is none that is known, but a board's perhaps.
std::optional<QString> reasonText(const QString &english);
QString motorStateText(drive::MotorState state);
QString stopWordText(drive::StopWord word);
/// Why the user is asked before an act of motion. @param limit, speed  with unit
QString motionCautionText(drive::MotionCaution caution, const QString &limit, const QString &speed);
/// An act of the motion log, and where it came from.
QString motionActText(drive::MotionAct act);
QString motionSourceText(drive::Source source);
/// What a board does not tell of a motor.
QString limitGapText(drive::LimitGap gap);
/// The red alarm's text.
QString stopNotConfirmedText();
/// How a wish failed, in one sentence: `action` names it ("Start"); empty if it went well.
QString failureText(const QString &action, const drive::Ended &ended);

/// Why a file was not written, and what to do; empty for None.
QString exportFileErrorText(const session::FileResult &result, const QString &path);

/// A piece of what session/files/problems.h says.
QString translatedFileProblem(const char *english);

} // namespace widgets
