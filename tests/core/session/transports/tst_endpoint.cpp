// What the name of a port means: simulated boards, SPI devices with and without a ready line, everything else.
#include "session/transports/endpoint.h"
#include "session/transports/spi_transport.h"

#include <QtTest>

using drive::Protocol;
using session::Endpoint;
using session::endpointFor;
using session::SpiPort;
using session::spiPortOf;

class TestEndpoint : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theNameSaysWhatItIs();
    void aReadyLineStandsBehindTheDevice();
    void anSpiDeviceThatIsNotThereIsOneError();
};

void TestEndpoint::theNameSaysWhatItIs()
{
    const Endpoint sim = endpointFor(QStringLiteral("sim"), 921600);
    QVERIFY(sim.kind == Endpoint::Kind::Simulator && sim.protocol == Protocol::Auto);
    QVERIFY(sim.board.empty() && sim.baud == 921600U);
    const Endpoint servo = endpointFor(QStringLiteral("sim:mcb"), 921600);
    QVERIFY(servo.kind == Endpoint::Kind::Simulator && servo.protocol == Protocol::Mcb);
    const Endpoint older = endpointFor(QStringLiteral("sim:legacy-text"), 921600);
    QVERIFY(older.kind == Endpoint::Kind::Simulator && older.protocol == Protocol::Auto);
    QVERIFY(older.board == "legacy-text" && older.baud == 115200U);
    const Endpoint none = endpointFor(QStringLiteral("sim:nothing"), 921600);
    QVERIFY(none.kind == Endpoint::Kind::Serial);
    const Endpoint spi = endpointFor(QStringLiteral("/dev/spidev0.0"), 1'000'000);
    QVERIFY(spi.kind == Endpoint::Kind::Serial && spi.protocol == Protocol::Mcb);
    const Endpoint chosen =
        endpointFor(QStringLiteral("/dev/spidev0.0"), 20'000'000, Protocol::Mcp);
    QVERIFY(chosen.protocol == Protocol::Mcb && chosen.baud == 20'000'000U);
    const Endpoint serial = endpointFor(QStringLiteral("/dev/ttyACM0"), 921600, Protocol::Mcp);
    QVERIFY(serial.kind == Endpoint::Kind::Serial && serial.protocol == Protocol::Mcp);
}

void TestEndpoint::aReadyLineStandsBehindTheDevice()
{
    QCOMPARE(spiPortOf(QStringLiteral("/dev/spidev0.0")).value(),
        (SpiPort{QStringLiteral("/dev/spidev0.0"), {}, 0}));
    QCOMPARE(spiPortOf(QStringLiteral("/dev/spidev1.0@gpiochip0:25")).value(),
        (SpiPort{QStringLiteral("/dev/spidev1.0"), QStringLiteral("gpiochip0"), 25}));
    for (const char *wrong : {"/dev/ttyACM0", "/dev/spidev0.0@", "/dev/spidev0.0@gpiochip0",
             "/dev/spidev0.0@gpiochip0:x", "/dev/spidev0.0@:3"})
        QVERIFY2(!spiPortOf(QString::fromLatin1(wrong)), wrong);
}

void TestEndpoint::anSpiDeviceThatIsNotThereIsOneError()
{
    const auto transport =
        session::makeSpiTransport(QStringLiteral("/dev/spidev99.9@gpiochip0:1"), 1'000'000);
    if (transport) // this system has SPI
        QVERIFY(transport->open(TimePoint{}).problem != session::PortProblem::None);
    QVERIFY(!session::makeSpiTransport(QStringLiteral("/dev/ttyACM0"), 1'000'000));
}

QTEST_GUILESS_MAIN(TestEndpoint)
#include "tst_endpoint.moc"
