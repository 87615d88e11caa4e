// rotorscope-cli stop, as the wire sees it: the STOPs leave before anything else is asked, and whether or not answers
// come.
#include "support/board_on_terminal.h"
#include "support/places.h"
#include "support/programs/programs_posix.h"

#include <QtTest>

using support::CliRun;

namespace {

constexpr qint64 kSoon_ms = 500; ///< generous: the machine may stall; it takes about 25

const QByteArray kMcpStop = QByteArray::fromHex("2100"); ///< payload of STOP_MOTOR, motor 1
const QByteArray kOlderStop = QByteArray::fromHex("23010226"); ///< motor 1, EXECUTE, STOP, sum

/// A terminal that swallows all and answers nothing: the receive wire is cut.
class SilentTerminal {
public:
    SilentTerminal()
        : m_notifier(m_terminal.master(), QSocketNotifier::Read)
    {
        QObject::connect(&m_notifier, &QSocketNotifier::activated, &m_notifier, [this] {
            const Bytes bytes = m_terminal.read();
            if (heard.isEmpty())
                m_time.start();
            heard.append(reinterpret_cast<const char *>(bytes.data()), qsizetype(bytes.size()));
            if (!firstStop_ms && heard.contains(kMcpStop))
                firstStop_ms = m_time.elapsed();
        });
    }
    QString path() const { return m_terminal.path(); }

    QByteArray heard;
    std::optional<qint64> firstStop_ms; ///< after the first byte

private:
    support::PseudoTerminal m_terminal;
    QSocketNotifier m_notifier;
    QElapsedTimer m_time;
};

/// Without patience, beside this thread's event loop.
CliRun stopAt(const QString &path, const QStringList &more = {})
{
    QProcess process;
    QEventLoop loop;
    QObject::connect(&process, &QProcess::finished, &loop, &QEventLoop::quit);
    QTimer::singleShot(support::kProgramTime_ms, &loop, &QEventLoop::quit);
    process.start(support::programFile(QStringLiteral("rotorscope-cli")),
        QStringList{QStringLiteral("--port"), path} + more + QStringList{QStringLiteral("stop")});
    loop.exec();
    if (process.state() != QProcess::NotRunning)
        process.kill();
    return support::resultOf(process);
}

} // namespace

class TestCliStop : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whereNobodyAnswersTheStopsLeaveAllTheSame()
    {
        SilentTerminal line;
        const CliRun run = stopAt(line.path());
        QCOMPARE(run.status, 3);
        QVERIFY2(run.err.contains(QStringLiteral("hardware stop")), qPrintable(run.err));
        QVERIFY2(run.err.contains(QStringLiteral("STOPs were sent")), qPrintable(run.err));
        QVERIFY(run.oneLineOfError());
        QVERIFY2(line.firstStop_ms, line.heard.toHex(' ').constData());
        qInfo(
            "first STOP %lld ms after the first byte", static_cast<long long>(*line.firstStop_ms));
        QVERIFY(*line.firstStop_ms < kSoon_ms);
        QVERIFY(line.heard.count(kMcpStop) >= 5);
        QVERIFY(line.heard.contains(kOlderStop)); // whichever language it would have spoken
    }

    void theStopGoesBeforeTheIdentification_data()
    {
        QTest::addColumn<QString>("profile");
        QTest::addColumn<QString>("protocol");
        QTest::addColumn<QByteArray>("stop");
        QTest::addColumn<QByteArray>("read");
        QTest::newRow("MCP") << "mcsdk-6.4"
                             << "mcp" << kMcpStop << QByteArray::fromHex("0800");
        QTest::newRow("older") << "legacy"
                               // GET_REGISTER of motor 1.
                               << "legacy" << kOlderStop << QByteArray::fromHex("2201");
    }

    void theStopGoesBeforeTheIdentification()
    {
        QFETCH(QString, profile);
        QFETCH(QString, protocol);
        QFETCH(QByteArray, stop);
        QFETCH(QByteArray, read);
        simulation::BoardOptions options;
        options.profile = profile.toStdString();
        if (protocol != QLatin1String("mcp"))
            options.baud = 115200;
        support::BoardOnTerminal board(options);
        const QStringList words{
            QStringLiteral("--port"), board.path(), QStringLiteral("--protocol"), protocol};
        const CliRun started = support::typedAgain([&] {
            return support::runCliBeside(
                words + QStringList{QStringLiteral("start"), QStringLiteral("--expert")});
        });
        QVERIFY2(started.status == 0, qPrintable(started.err));
        QByteArray heard;
        board.onHeard = [&heard](const Bytes &bytes) {
            heard.append(reinterpret_cast<const char *>(bytes.data()), qsizetype(bytes.size()));
        };
        const CliRun run = stopAt(board.path(), words.mid(2));
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const auto firstStop = heard.indexOf(stop);
        const auto firstRead = heard.indexOf(read);
        QVERIFY(firstStop >= 0);
        QVERIFY2(firstRead > firstStop, heard.left(80).toHex(' ').constData());
    }

    void everyMotorOfABoardIsStopped()
    {
        simulation::BoardOptions options;
        options.motors = 2;
        support::BoardOnTerminal board(options);
        const QStringList words{QStringLiteral("--port"), board.path()};
        for (const char *motor : {"1", "2"}) {
            const CliRun started = support::typedAgain([&] {
                return support::runCliBeside(words
                    + QStringList{
                        QStringLiteral("start"), QStringLiteral("--motor"), QLatin1String(motor)});
            });
            QVERIFY2(started.status == 0, qPrintable(started.err));
        }
        const CliRun run = stopAt(board.path());
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const CliRun info = support::runCliBeside(
            words + QStringList{QStringLiteral("--json"), QStringLiteral("info")});
        const QJsonArray motors = info.object()[QLatin1String("motors")].toArray();
        QCOMPARE(motors.size(), 2);
        for (const auto &motor : motors)
            QCOMPARE(motor.toObject()[QLatin1String("state")].toString(), QStringLiteral("IDLE"));
    }

    void aPortThatCannotBeOpenedSaysWhatIsLeft()
    {
        const CliRun run = stopAt(QStringLiteral("/nowhere/ttyNone"));
        QCOMPARE(run.status, 3);
        QVERIFY2(run.err.contains(QStringLiteral("No STOP could be sent")), qPrintable(run.err));
        QVERIFY2(run.err.contains(QStringLiteral("hardware stop")), qPrintable(run.err));
        QVERIFY(run.oneLineOfError());
    }
};

QTEST_GUILESS_MAIN(TestCliStop)
#include "tst_cli_stop_posix.moc"
