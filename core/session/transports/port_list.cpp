#include "session/transports/port_list.h"

#include "drive/protocol_table.h"

#include <QDir>
#include <QSerialPortInfo>

#include <algorithm>
#include <array>

namespace session {

namespace {

constexpr quint16 kStVendor = 0x0483;
/// V2-1, V2-1 without mass storage, V3 (three kinds), V3 without mass storage, V3PWR. Older ones
/// have no port.
constexpr std::array<quint16, 7> kStLinkProducts{
    0x374B, 0x3752, 0x374E, 0x374F, 0x3753, 0x3754, 0x3757};

QString titleOf(const SystemPort &port)
{
    QStringList words;
    for (const QString &word : {port.manufacturer, port.description, port.serialNumber}) {
        if (!word.isEmpty() && !words.contains(word))
            words.append(word);
    }
    return words.join(QLatin1Char(' '));
}

} // namespace

QList<SystemPort> SystemPortSource::ports() const
{
    QList<SystemPort> ports;
    const QList<QSerialPortInfo> infos = QSerialPortInfo::availablePorts();
    for (const QSerialPortInfo &info : infos) {
        ports.append({.path = info.systemLocation(),
            .description = info.description(),
            .manufacturer = info.manufacturer(),
            .serialNumber = info.serialNumber(),
            .vendor = info.vendorIdentifier(),
            .product = info.productIdentifier()});
    }
    const QStringList buses =
        QDir(QStringLiteral("/dev"))
            .entryList({QStringLiteral("spidev*")}, QDir::System | QDir::Files, QDir::Name);
    for (const QString &name : buses)
        ports.append({.path = QStringLiteral("/dev/") + name,
            .description = QStringLiteral("SPI"),
            .manufacturer = {},
            .serialNumber = {}});
    return ports;
}

bool isStLink(quint16 vendor, quint16 product)
{
    return vendor == kStVendor
        && std::ranges::find(kStLinkProducts, product) != kStLinkProducts.end();
}

QList<PortChoice> simulatedBoards()
{
    using Kind = PortChoice::Kind;
    QList<PortChoice> choices{{Kind::Simulator, QString::fromLatin1(kSimulatorPath), {}}};
    for (const drive::ProtocolRow &row : drive::protocolTable()) {
        if (row.boards.front().empty())
            continue; // the board above
        const drive::ProtocolChoice &choice = row.choice;
        choices.append({Kind::Simulator,
            QString::fromLatin1(kSimulatorPath) + QLatin1Char(':')
                + QString::fromLatin1(choice.word.data(), qsizetype(choice.word.size())),
            QString::fromLatin1(choice.title.data(), qsizetype(choice.title.size()))});
    }
    return choices;
}

QList<PortChoice> portChoices(const PortSource &source)
{
    using Kind = PortChoice::Kind;
    QList<PortChoice> choices = simulatedBoards();
    const auto boards = choices.size();
    const QList<SystemPort> ports = source.ports();
    for (const SystemPort &port : ports) {
        const Kind kind = isStLink(port.vendor, port.product) ? Kind::StLink : Kind::Serial;
        choices.append({kind, port.path, titleOf(port)});
    }
    std::stable_sort(
        choices.begin() + boards, choices.end(), [](const PortChoice &a, const PortChoice &b) {
            return std::pair(a.kind, a.path) < std::pair(b.kind, b.path);
        });
    return choices;
}

} // namespace session
