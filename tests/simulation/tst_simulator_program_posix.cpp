// rotorscope-sim as others script against it: its first line, its link, its end, its complaints.
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

namespace {

/// The program, ended with the test if it still runs.
struct Program {
    explicit Program(const QStringList &arguments)
    {
        process.start(QStringLiteral(ROTORSCOPE_BIN "/rotorscope-sim"), arguments);
        process.waitForStarted();
    }
    ~Program()
    {
        process.kill();
        process.waitForFinished();
    }
    QString firstLine()
    {
        while (!process.canReadLine() && process.waitForReadyRead(5000)) { }
        return QString::fromLocal8Bit(process.readLine()).trimmed();
    }
    bool ended()
    {
        return process.state() == QProcess::NotRunning || process.waitForFinished(5000);
    }

    QProcess process;
};

} // namespace

class TestSimulatorProgram : public QObject {
    Q_OBJECT

private slots:
    void aWrongCommandLineIsOneSentenceAndStatus2_data();
    void aWrongCommandLineIsOneSentenceAndStatus2();
    void helpNamesEveryFlag();
    void itSaysWhereItIsLinksAndEndsOnSigterm();
    void onlyALeftOverLinkIsReplaced();
    void aClientIsAnsweredAndTheNextOneToo();
    void withControlItEndsWithItsInput();
    void withoutControlItNeverReadsItsInput();
};

void TestSimulatorProgram::aWrongCommandLineIsOneSentenceAndStatus2_data()
{
    QTest::addColumn<QStringList>("arguments");
    const auto row = [](const char *name, const char *words) {
        QTest::newRow(name) << QString::fromLatin1(words).split(
            QLatin1Char(' '), Qt::SkipEmptyParts);
    };
    row("nothing", "");
    row("unknown protocol", "quantum");
    row("unknown flag", "mcp --colour red");
    row("unknown profile", "mcp --profile mcsdk-9.9");
    row("no value", "mcp --baud");
    row("no number", "mcp --baud fast");
    row("too large", "mcp --hf-hz 1000000");
    row("no multiple", "mcp --rx-max 100");
    row("negative", "mcp --streams -1");
    row("unknown lie", "mcp --liar twice,honesty");
    row("no chance", "mcp --liar twice:0");
    row("lie with times of its own", "mcp --liar flood:3");
}

void TestSimulatorProgram::aWrongCommandLineIsOneSentenceAndStatus2()
{
    QFETCH(QStringList, arguments);
    Program program(arguments);
    QVERIFY(program.ended());
    QCOMPARE(program.process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.process.exitCode(), 2);
    QCOMPARE(program.process.readAllStandardOutput(), QByteArray());
    QCOMPARE(program.process.readAllStandardError().count('\n'), 1);
}

void TestSimulatorProgram::helpNamesEveryFlag()
{
    Program program({QStringLiteral("mcp"), QStringLiteral("--help")});
    QVERIFY(program.ended());
    QCOMPARE(program.process.exitCode(), 0);
    const QByteArray text = program.process.readAllStandardOutput();
    for (const char *flag :
        {"--profile", "--link", "--rx-max", "--txs-max", "--txa-max", "--crc", "--version",
            "--liid", "--streams", "--baud", "--hf-hz", "--ts0", "--null-check", "--wide",
            "--user-cb", "--watchdog", "--seed", "--control", "--liar", "--list-liars", "--help"})
        QVERIFY2(text.contains(flag), flag);
}

void TestSimulatorProgram::itSaysWhereItIsLinksAndEndsOnSigterm()
{
    const QTemporaryDir folder;
    const QString link = folder.filePath(QStringLiteral("board"));
    Program program({QStringLiteral("mcp"), QStringLiteral("--link"), link});
    const QString line = program.firstLine();
    QVERIFY2(line.startsWith(QLatin1String("ready /dev/")), qPrintable(line));
    QCOMPARE(QFileInfo(link).symLinkTarget(), line.mid(6));
    program.process.terminate();
    QVERIFY(program.ended());
    QCOMPARE(program.process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.process.exitCode(), 0);
    QVERIFY(!QFileInfo(link).isSymLink());
}

void TestSimulatorProgram::onlyALeftOverLinkIsReplaced()
{
    const QTemporaryDir folder;
    const QString mine = folder.filePath(QStringLiteral("mine"));
    const QString old = folder.filePath(QStringLiteral("old"));
    QVERIFY(QFile::link(folder.path(), mine));
    QVERIFY(QFile::link(QStringLiteral("/dev/pts/9999"), old));
    Program refused({QStringLiteral("mcp"), QStringLiteral("--link"), mine});
    QVERIFY(refused.ended());
    QCOMPARE(refused.process.exitCode(), 5);
    QCOMPARE(QFileInfo(mine).symLinkTarget(), folder.path());
    Program taken({QStringLiteral("mcp"), QStringLiteral("--link"), old});
    QCOMPARE(QFileInfo(old).symLinkTarget(), taken.firstLine().mid(6));
}

void TestSimulatorProgram::aClientIsAnsweredAndTheNextOneToo()
{
    Program program({QStringLiteral("mcp")});
    const QByteArray path = program.firstLine().mid(6).toLocal8Bit();
    for (int client = 0; client < 2; ++client) {
        const int fd = ::open(path.constData(), O_RDWR | O_NOCTTY | O_NONBLOCK);
        QVERIFY(fd >= 0);
        termios settings{};
        tcgetattr(fd, &settings);
        QVERIFY((settings.c_lflag & (ICANON | ECHO)) == 0); // raw from the beginning
        const QByteArray offer = QByteArray::fromHex("05ffff0f");
        QByteArray answer;
        const auto heard = [&] {
            char piece[64];
            const ssize_t count = ::read(fd, piece, sizeof piece);
            if (count > 0)
                answer.append(piece, count);
            return answer.size() >= 4;
        };
        QCOMPARE(::write(fd, offer.constData(), 4), ssize_t{4});
        QTRY_VERIFY(heard());
        QCOMPARE(answer.toHex(), QByteArray("05c70114"));
        ::close(fd);
    }
}

void TestSimulatorProgram::withControlItEndsWithItsInput()
{
    Program program({QStringLiteral("mcp"), QStringLiteral("--control")});
    QVERIFY(!program.firstLine().isEmpty());
    program.process.write("fault 0x40\nnofault\nmute 10\ncorrupt 3\ninject 0a0b\nreset\ndance\n");
    program.process.closeWriteChannel();
    QVERIFY(program.ended());
    QCOMPARE(program.process.exitCode(), 0);
    QCOMPARE(program.process.readAllStandardError().count('\n'), 1); // there is no dance
}

void TestSimulatorProgram::withoutControlItNeverReadsItsInput()
{
    Program program({QStringLiteral("mcp")});
    QVERIFY(!program.firstLine().isEmpty());
    program.process.write("quit\n");
    program.process.closeWriteChannel();
    QVERIFY(!program.process.waitForFinished(200));
    program.process.terminate();
    QVERIFY(program.ended());
}

QTEST_GUILESS_MAIN(TestSimulatorProgram)
#include "tst_simulator_program_posix.moc"
