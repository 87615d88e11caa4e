#include "commands.h"
#include "sentences.h"

#include <QJsonArray>
#include <QJsonObject>

namespace cli {

namespace {

QStringList plainTexts(const std::vector<std::string> &texts)
{
    QStringList plain;
    for (const std::string &text : texts)
        plain.append(plainText(text));
    return plain;
}

QJsonArray textsOf(const std::vector<std::string> &texts)
{
    return QJsonArray::fromStringList(plainTexts(texts));
}

/// What the board does not tell is 0 in our structures, and null for others.
QJsonValue known(double number) { return number > 0.0 ? QJsonValue(number) : QJsonValue(); }

QJsonObject statusJson(const drive::MotorStatus &status)
{
    return {{QStringLiteral("motor"), status.motor},
        {QStringLiteral("state"), plainText(status.stateName)},
        {QStringLiteral("state_number"), static_cast<qint64>(status.rawState)},
        {QStringLiteral("faults_now"), textsOf(status.faultsNow)},
        {QStringLiteral("faults_past"), textsOf(status.faultsPast)},
        {QStringLiteral("speed_rpm"), orNull(status.speedRpm)}};
}

QJsonObject motorJson(const drive::MotorStatus &status, const drive::MotorLimits &limits)
{
    QJsonObject motor = statusJson(status);
    motor[QStringLiteral("max_speed_rpm")] = known(limits.maxSpeedRpm);
    motor[QStringLiteral("max_current_a")] = known(limits.maxCurrentAmps);
    motor[QStringLiteral("nominal_current_a")] = known(limits.nominalCurrentAmps);
    motor[QStringLiteral("pole_pairs")] = known(limits.polePairs);
    return motor;
}

QJsonObject boardJson(const drive::Identified &board, const QJsonArray &motors)
{
    const drive::Identity &identity = board.identity;
    const drive::StreamLimits &streaming = board.streaming;
    return {{QStringLiteral("protocol"), plainText(identity.protocol)},
        {QStringLiteral("firmware"), plainText(identity.firmware)},
        {QStringLiteral("version"), plainText(identity.version)},
        {QStringLiteral("known_firmware"), identity.knownFirmware},
        {QStringLiteral("watchdog_ms"),
            identity.watchdog ? QJsonValue(static_cast<qint64>(identity.watchdog->count()))
                              : QJsonValue()},
        {QStringLiteral("control_board"), plainText(identity.controlBoard)},
        {QStringLiteral("power_boards"), textsOf(identity.powerBoards)},
        {QStringLiteral("motor_names"), textsOf(identity.motorNames)},
        {QStringLiteral("motors"), motors},
        {QStringLiteral("request_bytes"), static_cast<qint64>(board.requestBytes)},
        {QStringLiteral("response_bytes"), static_cast<qint64>(board.responseBytes)},
        {QStringLiteral("stream_bytes"), static_cast<qint64>(board.streamBytes)},
        {QStringLiteral("stream_signals"), static_cast<qint64>(streaming.maxSignals)},
        {QStringLiteral("control_rate_hz"), known(streaming.tickHz)},
        {QStringLiteral("link_bytes_per_second"), streaming.linkBytesPerSecond}};
}

void printBoard(Output &out, const drive::Identified &board)
{
    const drive::Identity &identity = board.identity;
    const auto row = [&out](const char *name, const QString &text) {
        if (!text.trimmed().isEmpty())
            out.line(QString::fromLatin1(name).leftJustified(16) + text);
    };
    row("Firmware", plainText(identity.firmware + " " + identity.version));
    row("Protocol", plainText(identity.protocol));
    if (!identity.evidence.empty())
        row("Found by", plainText(identity.evidence));
    row("Control board", plainText(identity.controlBoard));
    row("Power board", plainTexts(identity.powerBoards).join(QStringLiteral(", ")));
    row("Motor", plainTexts(identity.motorNames).join(QStringLiteral(", ")));
    row("Drive watchdog",
        identity.watchdog ? QStringLiteral("%1 ms").arg(identity.watchdog->count())
                          : QStringLiteral("none"));
    if (board.requestBytes > 0)
        row("Sizes",
            QStringLiteral("request %1, response %2, stream %3 bytes")
                .arg(QString::number(board.requestBytes), QString::number(board.responseBytes),
                    QString::number(board.streamBytes)));
    if (board.streaming.tickHz > 0)
        row("Streaming",
            QStringLiteral("up to %1 signals at %2 Hz")
                .arg(QString::number(board.streaming.maxSignals),
                    numberText(board.streaming.tickHz)));
    if (!identity.knownFirmware)
        row("Note",
            QStringLiteral(
                "this firmware is not known: registers are shown raw and nothing is written"));
}

} // namespace

void printStatus(Output &out, const drive::MotorStatus &status)
{
    if (out.json()) {
        out.line(statusJson(status));
        return;
    }
    const QString speed =
        status.speedRpm ? QStringLiteral(", %1 rpm").arg(numberText(*status.speedRpm)) : QString();
    out.line(QStringLiteral("Motor %1: %2%3")
                 .arg(QString::number(status.motor), stateText(status), speed));
}

namespace {

Outcome<int> runInfo(Desk &desk)
{
    QJsonArray motors;
    std::vector<drive::MotorStatus> statuses;
    for (int motor = 1; motor <= desk.board.identity.motors; ++motor) {
        const auto status = desk.talk.status(motor);
        if (!status)
            return tl::make_unexpected(status.error());
        const auto index = static_cast<std::size_t>(motor - 1);
        const auto &limits = desk.board.limits;
        motors.append(
            motorJson(*status, index < limits.size() ? limits[index] : drive::MotorLimits{}));
        statuses.push_back(*status);
    }
    if (desk.out.json()) {
        desk.out.line(boardJson(desk.board, motors));
        return kDone;
    }
    printBoard(desk.out, desk.board);
    for (const drive::MotorStatus &status : statuses)
        printStatus(desk.out, status);
    return kDone;
}

} // namespace

const Command kInfo{.name = "info",
    .help = "Says what the board is, what was negotiated, and what its motors do.",
    .run = runInfo};

} // namespace cli
