#include "sentences.h"

#include "drive/protocol_table.h"
#include "session/link/problems.h"

namespace cli {

using drive::LinkReason;
using session::PortProblem;

namespace {

constexpr QLatin1String kMayTurn(" A motor may still be turning.");

QString baudText(const Arguments &arguments)
{
    return QStringLiteral(" The baud rate is %1 (--baud).").arg(arguments.baud);
}

} // namespace

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
    const QString text = session::portErrorText(error, arguments.port);
    switch (error.problem) {
    case PortProblem::NotFound:
        return text
            + (arguments.port.startsWith(QLatin1String("sim:"))
                    ? QStringLiteral(" Simulated boards are sim, %1.").arg(otherBoards())
                    : QStringLiteral(" rotorscope-cli ports lists them."));
    case PortProblem::BadSpeed:
        return text + baudText(arguments);
    case PortProblem::Unplugged:
        return text + kMayTurn;
    case PortProblem::TakenOver:
        return text + QStringLiteral(" Look at them with rotorscope-cli info.");
    default:
        return text;
    }
}

QString sentenceOf(LinkReason reason, const Arguments &arguments)
{
    QString text = arguments.port + QLatin1String(": ") + session::linkProblemText(reason);
    switch (reason) {
    case LinkReason::OnlyGarbage:
        for (const drive::ProtocolRow &row : drive::protocolTable()) {
            const QString word = QString::fromLatin1(row.choice.word);
            if (!row.choice.serial && row.choice.protocol != arguments.protocol)
                text += QStringLiteral(" A drive that speaks %1 needs --protocol %2.")
                            .arg(word.toUpper(), word);
        }
        [[fallthrough]];
    case LinkReason::NoAnswer:
        return text + baudText(arguments);
    case LinkReason::Silence:
    case LinkReason::RecoveryFailed:
        return text + kMayTurn;
    case LinkReason::BoardReset:
        return text + QStringLiteral(" Try again.");
    case LinkReason::OldProtocol:
    case LinkReason::OtherProtocol:
        return text + QStringLiteral(" Try --protocol auto.");
    default:
        return text;
    }
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
