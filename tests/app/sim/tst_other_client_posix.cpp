// Another client than ours uses rotorscope-sim and cannot tell it from a board: tests/support/other_client.py, which
// shares nothing with this program but the protocol.
#include "support/places.h"

#include <QProcess>
#include <QRegularExpression>
#include <QTest>

namespace {

/// Ended with the test, whatever becomes of that.
struct Served : QProcess {
    ~Served() override
    {
        kill();
        waitForFinished();
    }
};

} // namespace

class TestOtherClient : public QObject {
    Q_OBJECT

private slots:
    void itConnectsReadsDrivesRecordsAndStops_data();
    void itConnectsReadsDrivesRecordsAndStops();
};

void TestOtherClient::itConnectsReadsDrivesRecordsAndStops_data()
{
    QTest::addColumn<QString>("options");
    QTest::newRow("6.4") << QStringLiteral("--profile mcsdk-6.4");
    QTest::newRow("6.0") << QStringLiteral("--profile mcsdk-6.0");
    QTest::newRow("the printed text") << QStringLiteral("--profile spec");
    QTest::newRow("over TCP") << QStringLiteral("--tcp 0");
}

void TestOtherClient::itConnectsReadsDrivesRecordsAndStops()
{
    QFETCH(QString, options);
    constexpr int kPatience_ms = 60'000;
    Served simulator;
    simulator.start(support::programFile(QStringLiteral("rotorscope-sim")),
        QStringList{QStringLiteral("mcp"), QStringLiteral("--control")}
            + options.split(QLatin1Char(' ')));
    while (!simulator.canReadLine() && simulator.waitForReadyRead(kPatience_ms)) { }
    const QString line = QString::fromLocal8Bit(simulator.readLine()).trimmed();
    QVERIFY2(line.startsWith(QLatin1String("ready ")), qPrintable(line));

    QString place = line.mid(6);
    if (!place.startsWith(QLatin1Char('/')))
        place.prepend(QLatin1String("tcp:"));

    QProcess client;
    client.setProcessChannelMode(QProcess::MergedChannels);
    client.start(QStringLiteral("python3"),
        {support::sourceFile(QStringLiteral("tests/support/other_client.py")), place});
    QVERIFY2(client.waitForFinished(kPatience_ms), qPrintable(client.errorString()));
    const QString said = QString::fromUtf8(client.readAll());
    QVERIFY2(
        client.exitStatus() == QProcess::NormalExit && client.exitCode() == 0, qPrintable(said));

    static const QRegularExpression summary(
        QStringLiteral("client: (\\d+) requests, .* (\\d+) samples"));
    const auto match = summary.match(said);
    QVERIFY2(match.hasMatch(), qPrintable(said));
    constexpr int kInASecond = 16'000;
    // A busy machine loses some.
    QVERIFY2(match.captured(2).toInt() > kInASecond / 4, qPrintable(said));

    simulator.closeWriteChannel();
    QVERIFY(simulator.waitForFinished(kPatience_ms));
    QCOMPARE(simulator.exitCode(), 0);
}

QTEST_GUILESS_MAIN(TestOtherClient)
#include "tst_other_client_posix.moc"
