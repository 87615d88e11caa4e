#include "commands.h"
#include "sentences.h"
#include "session/transports/port_list.h"

#include <QJsonArray>
#include <QJsonObject>

#include <array>

namespace cli {

namespace {

using session::PortChoice;

const char *wordOf(PortChoice::Kind kind)
{
    constexpr std::array kWords{"simulator", "st-link", "serial"};
    return kWords.at(static_cast<std::size_t>(kind));
}

QString titleOf(const PortChoice &port)
{
    const QString title = plainText(port.title.toStdString());
    switch (port.kind) {
    case PortChoice::Kind::Simulator:
        return title.isEmpty() ? QStringLiteral("Simulated board")
                               : QStringLiteral("Simulated board, ") + title;
    case PortChoice::Kind::StLink:
        return QStringLiteral("ST-LINK: ") + title;
    case PortChoice::Kind::Serial:
        break;
    }
    return title;
}

Outcome<int> runPorts(const Arguments & /*arguments*/, Output &out)
{
    QJsonArray list;
    for (const PortChoice &port : session::portChoices()) {
        if (out.json())
            list.append(QJsonObject{{QStringLiteral("path"), port.path},
                {QStringLiteral("kind"), QLatin1String(wordOf(port.kind))},
                {QStringLiteral("title"), titleOf(port)}});
        else
            out.line(
                QStringLiteral("%1  %2").arg(port.path.leftJustified(16), titleOf(port)).trimmed());
    }
    if (out.json())
        out.line(list);
    return kDone;
}

} // namespace

const Command kPorts{.name = "ports",
    .help = "Lists the serial ports; those of ST-LINK debuggers are marked.",
    .needsPort = false,
    .runAlone = runPorts};

} // namespace cli
