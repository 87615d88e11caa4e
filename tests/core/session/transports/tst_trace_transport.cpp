// A recorded session as a port: it plays what the board sent, at its pace, and takes nothing.
#include "session/transports/trace_transport.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace std::chrono_literals;
using session::PortProblem;
using session::TraceTransport;

class TestTraceTransport : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itPlaysTheBoardsPacketsInTheirTime();
    void whatIsNoTraceIsRefused_data();
    void whatIsNoTraceIsRefused();
};

namespace {
QString fileWith(const QTemporaryDir &folder, const QByteArray &text)
{
    QFile file(folder.filePath(QStringLiteral("trace.jsonl")));
    if (file.open(QIODevice::WriteOnly))
        file.write(text);
    return file.fileName();
}
} // namespace

void TestTraceTransport::itPlaysTheBoardsPacketsInTheirTime()
{
    QTemporaryDir folder;
    TraceTransport transport(fileWith(folder,
        "{\"transcript\":\"x\"}\n"
        "{\"t_ms\":1,\"dir\":\"C>P\",\"hex\":\"05ffff0f\"}\n"
        "{\"t_ms\":30.5,\"dir\":\"P>C\",\"hex\":\"0102\"}\n"
        "{\"t_ms\":2,\"dir\":\"P>C\",\"hex\":\"05c70114\"}\n"));
    QByteArray heard;
    connect(&transport, &session::Transport::received, &transport,
        [&](const QByteArray &bytes) { heard += bytes; });
    const TimePoint start{5s};
    QCOMPARE(transport.open(start).problem, PortProblem::None);
    QCOMPARE(*transport.nextWake(), start + 2ms);
    transport.write(Bytes{1, 2, 3}, start);
    transport.advance(start + 1ms);
    QVERIFY(heard.isEmpty());
    transport.advance(start + 2ms);
    QCOMPARE(heard, QByteArray::fromHex("05c70114"));
    QCOMPARE(*transport.nextWake(), start + 30500us);
    transport.advance(start + 1s);
    QCOMPARE(heard, QByteArray::fromHex("05c701140102"));
    QVERIFY(!transport.nextWake());
}

void TestTraceTransport::whatIsNoTraceIsRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("other text") << QByteArray("hello\nworld\n");
    QTest::newRow("only requests") << QByteArray("{\"t_ms\":1,\"dir\":\"C>P\",\"hex\":\"05\"}\n");
    QTest::newRow("times that are none")
        << QByteArray("{\"t_ms\":-1,\"dir\":\"P>C\",\"hex\":\"05\"}\n{\"t_ms\":1e300,\"dir\":\"P>"
                      "C\",\"hex\":\"05\"}\n");
}

void TestTraceTransport::whatIsNoTraceIsRefused()
{
    QFETCH(QByteArray, text);
    QTemporaryDir folder;
    QCOMPARE(TraceTransport(fileWith(folder, text)).open({}).problem, PortProblem::BadFile);
    QCOMPARE(TraceTransport(folder.filePath(QStringLiteral("nothing"))).open({}).problem,
        PortProblem::NotFound);
}

QTEST_GUILESS_MAIN(TestTraceTransport)
#include "tst_trace_transport.moc"
