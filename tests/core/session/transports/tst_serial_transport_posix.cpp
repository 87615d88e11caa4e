// The serial port against pseudo-terminals: bytes, one writer, and every way a port can fail.
#include "session/transports/serial_transport.h"
#include "support/pseudo_terminal.h"

#include <QAbstractEventDispatcher>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <sys/stat.h>
#include <unistd.h>

using namespace std::chrono_literals;
using session::PortError;
using session::PortProblem;
using session::SerialTransport;
using support::PseudoTerminal;

class TestSerialTransport : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void bytesPassBothWaysUnchanged();
    void everyUsualAndUnusualSpeedOpens_data();
    void everyUsualAndUnusualSpeedOpens();
    void anUnpluggedPortFailsOnceAndIsClosed();
    void anUnpluggedPortFailsOnceWhileWriting();
    void aPortThatWasNotLookedAtIsNotDeaf();
    void whatNobodyWaitsForIsToldTogether();
    void aSecondOpenIsRefusedAlsoByAnotherName();
    void rootIsRefusedToo();
    void aClosedPortCanBeOpenedAgain();
    void whatALineDidNotTakeCanBeDropped();
    void whatIsNotASerialPortIsRefused();
    void aSpeedThatCannotBeIsRefused();
};

namespace {

struct Port {
    SerialTransport transport;
    QByteArray heard;
    int failures = 0;
    PortError error;

    explicit Port(const QString &path, std::uint32_t baud = 1843200)
        : transport(path, baud)
    {
        QObject::connect(&transport, &session::Transport::received, &transport,
            [this](const QByteArray &bytes) { heard += bytes; });
        QObject::connect(
            &transport, &session::Transport::failed, &transport, [this](const PortError &why) {
                ++failures;
                error = why;
            });
    }
    PortProblem open() { return transport.open({}).problem; }
};

Bytes allBytes()
{
    Bytes bytes(256);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(i);
    return bytes;
}

} // namespace

void TestSerialTransport::bytesPassBothWaysUnchanged()
{
    PseudoTerminal device;
    Port port(device.path());
    QCOMPARE(port.open(), PortProblem::None);
    const Bytes bytes = allBytes();
    port.transport.write(bytes, {});
    QVERIFY(port.transport.sent({})); // without a turn of the event loop
    QCOMPARE(device.read(), bytes);
    device.write(bytes);
    QTRY_COMPARE(port.heard, QByteArray(reinterpret_cast<const char *>(bytes.data()), 256));
}

void TestSerialTransport::everyUsualAndUnusualSpeedOpens_data()
{
    QTest::addColumn<quint32>("baud");
    for (const quint32 baud : {115200U, 230400U, 460800U, 921600U, 1843200U, 123456U})
        QTest::addRow("%u", baud) << baud;
}

void TestSerialTransport::everyUsualAndUnusualSpeedOpens()
{
    QFETCH(quint32, baud);
    PseudoTerminal device;
    QCOMPARE(Port(device.path(), baud).open(), PortProblem::None);
}

void TestSerialTransport::anUnpluggedPortFailsOnceAndIsClosed()
{
    PseudoTerminal device;
    Port port(device.path());
    QCOMPARE(port.open(), PortProblem::None);
    device.write(Bytes{0x1A, 0x00}); // half a header
    device.unplug();
    QTRY_COMPARE(port.failures, 1);
    QCOMPARE(port.error.problem, PortProblem::Unplugged);
    QVERIFY(!port.transport.nextWake()); // nothing left to look after
    int turns = 0;
    while (
        QCoreApplication::eventDispatcher()->processEvents(QEventLoop::AllEvents) && turns < 1000)
        ++turns;
    QVERIFY2(turns < 100, qPrintable(QString::number(turns))); // the event loop comes to rest
    QCOMPARE(port.failures, 1);
}

void TestSerialTransport::anUnpluggedPortFailsOnceWhileWriting()
{
    PseudoTerminal device;
    Port port(device.path());
    QCOMPARE(port.open(), PortProblem::None);
    device.unplug();
    port.transport.write(allBytes(), {});
    port.transport.write(allBytes(), {});
    QTRY_COMPARE(port.failures, 1);
    port.transport.write(allBytes(), {}); // harmless
    QVERIFY(port.transport.sent({}));
    QCoreApplication::processEvents();
    QCOMPARE(port.failures, 1);
}

void TestSerialTransport::aPortThatWasNotLookedAtIsNotDeaf()
{
    PseudoTerminal terminal;
    Port port(terminal.path());
    QCOMPARE(port.open(), PortProblem::None);
    terminal.write(allBytes());
    // Its owner is called again and again, but the event loop does not come round.
    for (int i = 1; i < 10; ++i)
        port.transport.advance(TimePoint(i * 1s));
    QCOMPARE(port.failures, 0);
    QTRY_COMPARE(port.heard.size(), 256);
    port.transport.advance(TimePoint(10s));
    QCOMPARE(port.failures, 0);
}

void TestSerialTransport::whatNobodyWaitsForIsToldTogether()
{
    PseudoTerminal device;
    Port port(device.path());
    QCOMPARE(port.open(), PortProblem::None);
    const auto turn = [] {
        for (int i = 0; i < 20; ++i)
            QCoreApplication::processEvents();
    };
    TimePoint now{1s};
    port.transport.gather(10ms, now); // nothing came yet
    device.write(Bytes{1});
    QTRY_COMPARE(port.heard.size(), 1);
    port.transport.gather(10ms, now);
    port.transport.gather(20ms, now); // does not make it longer
    device.write(Bytes{2, 3});
    turn();
    QCOMPARE(port.heard.size(), 1);
    QVERIFY(port.transport.nextWake() <= now + 10ms);
    now += 10ms;
    port.transport.advance(now);
    QTRY_COMPARE(port.heard.size(), 3);

    port.transport.gather(10ms, now);
    device.write(Bytes{4});
    turn();
    QCOMPARE(port.heard.size(), 3);
    port.transport.gather(0ms, now); // now it is read
    QTRY_COMPARE(port.heard.size(), 4);
    QCOMPARE(port.failures, 0);
}

void TestSerialTransport::aSecondOpenIsRefusedAlsoByAnotherName()
{
    PseudoTerminal device;
    QTemporaryDir folder;
    const QString alias = folder.filePath(QStringLiteral("alias"));
    QVERIFY(QFile::link(device.path(), alias));
    Port first(device.path());
    QCOMPARE(first.open(), PortProblem::None);
    for (const QString &name : {device.path(), alias}) {
        Port second(name);
        const PortError error = second.transport.open({});
        QCOMPARE(error.problem, PortProblem::Busy);
        QVERIFY2(error.detail.contains(QString::number(QCoreApplication::applicationPid())),
            qPrintable(error.detail));
    }
    first.transport.write(Bytes{1}, {}); // the first is undisturbed
    QCOMPARE(device.read(), Bytes{1});
    first.transport.close();
    QCOMPARE(Port(alias).open(), PortProblem::None);
}

/// The system lets root pass where others are held; the lock does not. Without root this is only one more refusal.
void TestSerialTransport::rootIsRefusedToo()
{
    constexpr uid_t kNobody = 65534;
    const bool root = ::geteuid() == 0;
    PseudoTerminal device;
    QCOMPARE(::chmod(QFile::encodeName(device.path()).constData(), 0666), 0);
    Port first(device.path());
    if (root)
        QCOMPARE(::seteuid(kNobody), 0);
    const PortProblem problem = first.open();
    if (root)
        QCOMPARE(::seteuid(0), 0);
    QCOMPARE(problem, PortProblem::None);
    Port second(device.path());
    QCOMPARE(second.open(), PortProblem::Busy);
    first.transport.close();
    QCOMPARE(second.open(), PortProblem::None);
}

void TestSerialTransport::aClosedPortCanBeOpenedAgain()
{
    PseudoTerminal device;
    Port port(device.path());
    for (int i = 0; i < 3; ++i) {
        QCOMPARE(port.open(), PortProblem::None);
        port.transport.write(Bytes{7}, {});
        QCOMPARE(device.read(), Bytes{7});
        port.transport.close();
    }
    device.unplug();
    QCOMPARE(port.open(), PortProblem::NotFound);
}

void TestSerialTransport::whatALineDidNotTakeCanBeDropped()
{
    support::PseudoTerminal terminal;
    Port port(terminal.path());
    QCOMPARE(port.transport.open({}).problem, PortProblem::None);
    // The other end does not read: the line takes a part, and the rest waits.
    const Bytes start(std::size_t{256} * 1024, 0xAA);
    port.transport.write(start, {});
    QVERIFY(!port.transport.sent({}));
    port.transport.discardOutput();
    QVERIFY(port.transport.sent({}));
    const Bytes stop{0x55};
    port.transport.write(stop, {});
    Bytes heard;
    QTRY_VERIFY([&] {
        const Bytes more = terminal.read();
        heard.insert(heard.end(), more.begin(), more.end());
        return !heard.empty() && heard.back() == 0x55;
    }());
    QVERIFY(heard.size() < start.size());
}

void TestSerialTransport::whatIsNotASerialPortIsRefused()
{
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("file")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(Port(file.fileName()).open(), PortProblem::NotFound);
    QCOMPARE(Port(folder.filePath(QStringLiteral("nothing"))).open(), PortProblem::NotFound);
    QVERIFY(Port(folder.path()).open() != PortProblem::None);
}

void TestSerialTransport::aSpeedThatCannotBeIsRefused()
{
    PseudoTerminal device;
    QCOMPARE(Port(device.path(), 0).open(), PortProblem::BadSpeed);
}

QTEST_GUILESS_MAIN(TestSerialTransport)
#include "tst_serial_transport_posix.moc"
