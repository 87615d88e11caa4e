#include "widgets/base/messages.h"

#include "session/link/problems.h"
#include "widgets/base/device_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

namespace widgets {
namespace {

struct Messages {
    Q_DECLARE_TR_FUNCTIONS(Messages)
};

/// The words of drive and session (core/drive, core/session/link), English there as in recordings and on the command
/// line. No place holder takes a space.
constexpr const char *kReasons[] = {
    // NOLINTBEGIN(bugprone-suspicious-missing-comma): long ones stand in several pieces
    QT_TRANSLATE_NOOP("Messages", "beyond your own limit of %1 rpm"),
    QT_TRANSLATE_NOOP("Messages", "beyond your own limit of %1 A"),
    QT_TRANSLATE_NOOP("Messages", "beyond the limit of %1 rpm"),
    QT_TRANSLATE_NOOP("Messages", "beyond the limit of %1 A"),
    QT_TRANSLATE_NOOP("Messages", "%1 is beyond your own limit of %2 rpm"),
    QT_TRANSLATE_NOOP("Messages", "%1 is beyond your own limit of %2 A"),
    QT_TRANSLATE_NOOP("Messages", "%1 is beyond the limit of %2 rpm"),
    QT_TRANSLATE_NOOP("Messages", "%1 is beyond the limit of %2 A"),
    QT_TRANSLATE_NOOP("Messages", "the speed on the way is beyond your own limit of %1 rpm"),
    QT_TRANSLATE_NOOP("Messages", "the speed on the way is beyond the limit of %1 rpm"),
    QT_TRANSLATE_NOOP(
        "Messages", "%1 is on, and then no limit of your own holds: turn it off first"),
    QT_TRANSLATE_NOOP(
        "Messages", "in this control mode no limit of your own holds: take yours away first"),
    QT_TRANSLATE_NOOP("Messages",
        "in torque control nothing keeps the speed within your own limit of %1 rpm: take that "
        "limit away first"),
    QT_TRANSLATE_NOOP("Messages",
        "in torque control this board does not tell to which current a start goes; take your own "
        "limit of current away first"),
    QT_TRANSLATE_NOOP("Messages", "beyond the %1 rpm that this protocol can hold"),
    QT_TRANSLATE_NOOP("Messages", "beyond what 16 bits hold"),
    QT_TRANSLATE_NOOP("Messages", "the scale of motor %1 is not known"),
    QT_TRANSLATE_NOOP("Messages", "the board does not tell where the shaft is"),
    QT_TRANSLATE_NOOP("Messages", "the limits have changed"),
    QT_TRANSLATE_NOOP("Messages", "too many wishes wait already"),
    QT_TRANSLATE_NOOP("Messages", "the fault is still present; remove its cause first"),
    QT_TRANSLATE_NOOP("Messages", "no answer about what it would start to"),
    QT_TRANSLATE_NOOP("Messages", "no answer"), QT_TRANSLATE_NOOP("Messages", "not connected"),
    QT_TRANSLATE_NOOP("Messages", "not armed"),
    QT_TRANSLATE_NOOP("Messages", "stopped; arm again first"),
    QT_TRANSLATE_NOOP("Messages", "too late: it was asked for more than half a second ago"),
    QT_TRANSLATE_NOOP("Messages", "a register of it is lent to an experiment until that ends"),
    // NOLINTEND(bugprone-suspicious-missing-comma)
};

constexpr session::ProblemWords kLinkWords = [](const char *english) {
    return QCoreApplication::translate("Link", english);
};

} // namespace

QString linkStateText(drive::LinkState state)
{
    using drive::LinkState;
    switch (state) {
    case LinkState::Closed:
        return Messages::tr("not connected");
    case LinkState::Connecting:
        return Messages::tr("connecting");
    case LinkState::Connected:
        return Messages::tr("board answering");
    case LinkState::Suspect:
        return Messages::tr("board silent");
    case LinkState::Recovering:
        return Messages::tr("recovering");
    case LinkState::Lost:
        return Messages::tr("link lost");
    }
    return {};
}

QStringList linkStateTexts()
{
    using drive::LinkState;
    QStringList all{Messages::tr("no board found")};
    for (const LinkState state : {LinkState::Closed, LinkState::Connecting, LinkState::Connected,
             LinkState::Suspect, LinkState::Recovering, LinkState::Lost})
        all.append(linkStateText(state));
    return all;
}

bool noBoardFound(const drive::LinkChanged &link)
{
    using drive::LinkReason;
    const bool met = link.reason == LinkReason::None || link.reason == LinkReason::Silence
        || link.reason == LinkReason::RecoveryFailed || link.reason == LinkReason::BoardReset;
    return link.state == drive::LinkState::Lost && !met;
}

QString linkStateText(const drive::LinkChanged &link)
{
    return noBoardFound(link) ? Messages::tr("no board found") : linkStateText(link.state);
}

QString linkReasonText(drive::LinkReason reason)
{
    using drive::LinkReason;
    QString text = session::linkProblemText(reason, kLinkWords);
    if (reason == LinkReason::BoardReset)
        text += u' ' + Messages::tr("It is connected again; arm it before you go on.");
    if (reason == LinkReason::OldProtocol || reason == LinkReason::OtherProtocol)
        text += u' ' + Messages::tr("Choose that one, or Auto, and connect again.");
    return text;
}

QString interruptionText(const session::Interruption &what)
{
    using Cause = session::Interruption::Cause;
    const QString seconds = QString::number(toSeconds(what.length), 'f', 1);
    const QString effect = what.stopped
        ? Messages::tr("All motors were told to stop. Look at them, then arm again.")
        : Messages::tr("It was disarmed; the motors go on as they are.");
    switch (what.cause) {
    case Cause::Interface:
        return Messages::tr("This window stood still for %1 s.").arg(seconds) + QLatin1Char(' ')
            + effect;
    case Cause::Gap:
        return Messages::tr("This program or the computer stood still for %1 s.").arg(seconds)
            + QLatin1Char(' ') + effect;
    case Cause::Hold:
        return Messages::tr("The jog was ended: this window stood still while it was held.");
    case Cause::LateArming:
        return Messages::tr(
            "Not armed: it was asked for while this window stood still. Arm again.");
    }
    return {};
}

QString motorsOutOfReachText(bool wereAtRest, std::optional<std::chrono::milliseconds> watchdog)
{
    if (wereAtRest)
        return Messages::tr("No motor was driven when the board was last heard.");
    if (watchdog)
        return Messages::tr("The motor may still be turning; the drive is to stop it by itself "
                            "after %1 ms.")
            .arg(QString::number(watchdog->count()));
    return Messages::tr(
        "The motor may still be turning (this drive has no communication time-out).");
}

QString portProblemText(const session::PortError &error, const QString &port)
{
    QString text = session::portErrorText(
        {error.problem, deviceText(error.detail)}, deviceText(port), kLinkWords);
    if (error.problem == session::PortProblem::TakenOver)
        text += u' ' + Messages::tr("Rotorscope reconnects; arm again to move.");
    return text;
}

QString outcomeText(drive::Outcome outcome)
{
    using drive::Outcome;
    switch (outcome) {
    case Outcome::Ok:
        return Messages::tr("done");
    case Outcome::Refused:
        return Messages::tr("refused");
    case Outcome::NotSent:
        return Messages::tr("not sent");
    case Outcome::Unknown:
        return Messages::tr("sent, but the answer was lost");
    }
    return {};
}

QString outcomeText(const drive::Ended &ended)
{
    if (ended.outcome != drive::Outcome::Refused)
        return outcomeText(ended.outcome);
    return ended.byProgram ? Messages::tr("refused by this program")
                           : Messages::tr("refused by the board");
}

QString motorStateText(drive::MotorState state)
{
    using drive::MotorState;
    switch (state) {
    case MotorState::Unknown:
        return Messages::tr("Unknown", "state of a motor");
    case MotorState::Idle:
        return Messages::tr("Idle", "state of a motor");
    case MotorState::Starting:
        return Messages::tr("Starting", "state of a motor");
    case MotorState::Running:
        return Messages::tr("Running", "state of a motor");
    case MotorState::Stopping:
        return Messages::tr("Stopping", "state of a motor");
    case MotorState::FaultNow:
        return Messages::tr("Fault present", "state of a motor");
    case MotorState::FaultOver:
        // Not every board tells whether its cause is still there.
        return Messages::tr("Fault latched", "state of a motor; acknowledge to go on");
    }
    return {};
}

QString stopWordText(drive::StopWord word)
{
    using drive::StopWord;
    switch (word) {
    case StopWord::Requested:
        return Messages::tr("stop requested");
    case StopWord::Accepted:
        return Messages::tr("accepted", "the board accepted the stop");
    case StopWord::DriveIdle:
        return Messages::tr("drive idle");
    case StopWord::Standstill:
        return Messages::tr("standstill measured");
    case StopWord::MayCoast:
        return Messages::tr("speed not measurable: the rotor may coast");
    case StopWord::NotConfirmed:
        return Messages::tr("not confirmed");
    }
    return {};
}

QString motionCautionText(drive::MotionCaution caution, const QString &limit, const QString &speed)
{
    using drive::MotionCaution;
    switch (caution) {
    case MotionCaution::FirstStart:
        return Messages::tr("It is the first start since the board was connected or stopped.");
    case MotionCaution::Step:
        return Messages::tr("The set-point moves by more than 20 % of the limit of %1.").arg(limit);
    case MotionCaution::StepFromUnknown:
        return Messages::tr("It is not known from where the set-point moves.");
    case MotionCaution::Reversal:
        return Messages::tr("It acts against the way the motor turns now (%1).", "speed")
            .arg(speed);
    case MotionCaution::Position:
        return Messages::tr("The shaft goes to an angle by itself, and is held there.");
    case MotionCaution::NoSpeedLimit:
        return Messages::tr("In torque control nothing keeps the speed within your own limit.");
    case MotionCaution::OtherMode:
        return Messages::tr("The control changes between speed and torque while the motor runs.");
    case MotionCaution::UnknownMode:
        return Messages::tr("It is not known whether its speed or its torque is controlled.");
    case MotionCaution::EndsExperiment:
        return Messages::tr("It ends the experiment that is running; where nothing else bounds the "
                            "motor, as in torque control, every motor is stopped instead.");
    }
    return {};
}

QString motionActText(drive::MotionAct act)
{
    using drive::MotionAct;
    switch (act) {
    case MotionAct::Arm:
        return Messages::tr("Arm");
    case MotionAct::Disarm:
        return Messages::tr("Disarm");
    case MotionAct::Limits:
        return Messages::tr("Own limits");
    case MotionAct::Expert:
        return Messages::tr("Expert mode");
    case MotionAct::CurrentScale:
        return Messages::tr("Current scale", "a person says it");
    case MotionAct::Start:
        return Messages::tr("Start", "of a motor");
    case MotionAct::Stop:
        return Messages::tr("Stop motors");
    case MotionAct::StopMotor:
        return Messages::tr("Stop one motor");
    case MotionAct::StopRamp:
        return Messages::tr("Stop ramp");
    case MotionAct::AcknowledgeFaults:
        return Messages::tr("Acknowledge faults");
    case MotionAct::SpeedRamp:
        return Messages::tr("Speed ramp");
    case MotionAct::TorqueRamp:
        return Messages::tr("Torque ramp");
    case MotionAct::CurrentReference:
        return Messages::tr("Current reference");
    case MotionAct::PositionRamp:
        return Messages::tr("Position ramp");
    case MotionAct::Write:
        return Messages::tr("Write", "a register that can move something");
    }
    return {};
}

QString motionSourceText(drive::Source source)
{
    using drive::Source;
    switch (source) {
    case Source::Person:
        return Messages::tr("user");
    case Source::CommandLine:
        return Messages::tr("command line");
    case Source::Script:
        return Messages::tr("script");
    }
    return {};
}

QString limitGapText(drive::LimitGap gap)
{
    using drive::LimitGap;
    switch (gap) {
    case LimitGap::MaxSpeed:
        return Messages::tr("greatest speed");
    case LimitGap::MaxCurrent:
        return Messages::tr("greatest current");
    case LimitGap::NominalCurrent:
        return Messages::tr("nominal current");
    }
    return {};
}

QString stopNotConfirmedText()
{
    return Messages::tr("Stop NOT confirmed. Use the hardware stop.");
}

std::optional<QString> reasonText(const QString &english)
{
    static const QRegularExpression place(QStringLiteral("%\\d"));
    static const QRegularExpression number(QStringLiteral("^\\d+\\.\\d+$"));
    for (const char *known : kReasons) {
        QStringList pieces = QString::fromUtf8(known).split(place);
        for (QString &piece : pieces)
            piece = QRegularExpression::escape(piece);
        const QRegularExpression pattern(
            QRegularExpression::anchoredPattern(pieces.join(QStringLiteral("(\\S+)"))));
        const auto match = pattern.match(english);
        if (!match.hasMatch())
            continue;
        QString text = QCoreApplication::translate("Messages", known);
        for (qsizetype at = pieces.size() - 1; at > 0; --at) {
            QString word = deviceText(match.captured(int(at)));
            if (number.match(word).hasMatch())
                word.replace(QLatin1Char('.'), QLocale().decimalPoint());
            text.replace(QStringLiteral("%%1").arg(at), word);
        }
        return text;
    }
    return std::nullopt;
}

QString failureText(const QString &action, const drive::Ended &ended)
{
    if (ended.outcome == drive::Outcome::Ok)
        return {};
    const QString reason =
        reasonText(QString::fromStdString(ended.reason)).value_or(deviceText(ended.reason));
    const QString how = outcomeText(ended);
    return reason.isEmpty()
        ? Messages::tr("%1: %2.", "action: how it ended").arg(action, how)
        : Messages::tr("%1: %2 (%3).", "action: how it ended (the board's word)")
              .arg(action, how, reason);
}

QString translatedFileProblem(const char *english)
{
    return QCoreApplication::translate("FileProblem", english);
}

QString exportFileErrorText(const session::FileResult &result, const QString &path)
{
    using session::FileError;
    const QString name = deviceText(path);
    const QString detail = deviceText(result.systemText);
    switch (result.error) {
    case FileError::None:
        return {};
    case FileError::Cancelled:
        return Messages::tr("The export was cancelled; no file was written.");
    case FileError::NotAFile:
        return Messages::tr("%1 is not a file. Choose another name.").arg(name);
    case FileError::CannotOpen:
        return Messages::tr("%1 cannot be written (%2). Choose another folder.").arg(name, detail);
    case FileError::CannotWrite:
        return Messages::tr("Not written: %1. Make room or choose another "
                            "folder; nothing was replaced.")
            .arg(detail);
    case FileError::CannotReplace:
        return Messages::tr("%1 cannot be replaced (%2). Choose another name.").arg(name, detail);
    }
    return {};
}

} // namespace widgets
