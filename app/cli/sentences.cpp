#include "sentences.h"

namespace cli {

using drive::LinkReason;
using session::PortProblem;

QString plainText(const std::string &text)
{
    constexpr qsizetype kLongest = 200;
    QString plain = QString::fromUtf8(text).left(kLongest);
    for (QChar &c : plain) {
        if (c.isSpace() || c.category() == QChar::Other_Control)
            c = QLatin1Char(' ');
        else if (!c.isPrint() || c.category() == QChar::Other_Format)
            c = QChar::ReplacementCharacter;
    }
    return plain;
}

QString sentenceOf(const session::PortError &error, const Arguments &arguments)
{
    const QString &port = arguments.port;
    const QString detail =
        error.detail.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(error.detail);
    switch (error.problem) {
    case PortProblem::None:
        return {};
    case PortProblem::NotFound:
        if (port.startsWith(QLatin1String("sim:")))
            return QStringLiteral("There is no simulated board %1; there are sim, %2.")
                .arg(port, otherBoards());
        return QStringLiteral("There is no serial port %1; check the cable, or list the ports with "
                              "rotorscope-cli ports.")
            .arg(port);
    case PortProblem::NoPermission:
        return QStringLiteral("You may not use %1; join the group dialout (sudo adduser $USER "
                              "dialout) and log in again.")
            .arg(port);
    case PortProblem::Busy:
        if (error.detail.isEmpty())
            return QStringLiteral("%1 is used by another program; close that one first.").arg(port);
        return QStringLiteral("%1 is used by %2; close that program first.")
            .arg(port, error.detail);
    case PortProblem::BadSpeed:
        return QStringLiteral("%1 cannot do %2 baud; choose another speed with --baud.")
            .arg(port, QString::number(arguments.baud));
    case PortProblem::Unplugged: // the system's own words for it are left-overs of another call
        return QStringLiteral(
            "The connection to %1 broke; check the cable. A motor may still be turning.")
            .arg(port);
    case PortProblem::TakenOver:
        return QStringLiteral("This program did not run for a while; its guardian has told every "
                              "motor on %1 to stop. "
                              "Look at them with rotorscope-cli info.")
            .arg(port);
    case PortProblem::BadFile:
        return QStringLiteral("%1 is no recorded session.").arg(port);
    case PortProblem::Other:
        break;
    }
    return QStringLiteral("%1 cannot be opened%2; check the device.").arg(port, detail);
}

QString sentenceOf(LinkReason reason, const Arguments &arguments)
{
    const QString &port = arguments.port;
    switch (reason) {
    case LinkReason::OnlyGarbage:
        return QStringLiteral("What %1 sends at %2 baud makes no sense; try another --baud%3, and "
                              "check the board's firmware.")
            .arg(port, QString::number(arguments.baud),
                arguments.protocol == drive::Protocol::Mcb
                    ? QString()
                    : QStringLiteral(", or --protocol mcb for a drive that speaks MCB"));
    case LinkReason::NoAgreement:
        return QStringLiteral(
            "The board at %1 does not agree on how to talk; reset it and try again.")
            .arg(port);
    case LinkReason::OldProtocol:
        return QStringLiteral("The board at %1 speaks an older protocol; try --protocol auto.")
            .arg(port);
    case LinkReason::OtherProtocol:
        return QStringLiteral("The board at %1 speaks a newer protocol; try --protocol auto.")
            .arg(port);
    case LinkReason::BoardReset:
        return QStringLiteral("The board at %1 was reset meanwhile; try again.").arg(port);
    case LinkReason::Silence:
    case LinkReason::RecoveryFailed:
        return QStringLiteral("The board at %1 stopped answering; check cable and power. A motor "
                              "may still be turning.")
            .arg(port);
    case LinkReason::NotReady:
        return QStringLiteral(
            "The drive at %1 does not say that it is ready; check its power and the ready line.")
            .arg(port);
    case LinkReason::DeadLine:
        return QStringLiteral(
            "Nothing drives the line from %1; check wiring, chip select and power.")
            .arg(port);
    case LinkReason::None:
    case LinkReason::AskingNewer:
    case LinkReason::AskingOlder:
    case LinkReason::NoAnswer:
        break;
    }
    return QStringLiteral("No board answers at %1; check power, cable and --baud (now %2).")
        .arg(port, QString::number(arguments.baud));
}

QString sentenceOf(const session::FileResult &file, const QString &path)
{
    return QStringLiteral("%1 was not written: %2; make room or choose another place with -o.")
        .arg(path,
            file.error == session::FileError::NotAFile ? QStringLiteral("it is no file")
                                                       : file.systemText);
}

QString stateText(const drive::MotorStatus &status)
{
    QStringList faults;
    for (const std::string &fault : status.faultsNow)
        faults.append(plainText(fault));
    for (const std::string &fault : status.faultsPast) {
        const QString name = plainText(fault);
        if (!faults.contains(name))
            faults.append(name);
    }
    const QString state = plainText(status.stateName);
    return faults.isEmpty()
        ? state
        : QStringLiteral("%1 (%2)").arg(state, faults.join(QStringLiteral(", ")));
}

} // namespace cli
