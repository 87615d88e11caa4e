// rotorscope-sim as others script against it: its first line, its link, its end, its complaints.
#include "aspep/packet.h"
#include "drive/protocol_table.h"
#include "support/places.h"

#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <arpa/inet.h>
#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

namespace {

/// The program, ended with the test if it still runs.
struct SimProgram {
    explicit SimProgram(const QStringList &arguments)
    {
        process.start(support::programFile(QStringLiteral("rotorscope-sim")), arguments);
        process.waitForStarted();
    }
    ~SimProgram()
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

/// Adds what has come to what is there. @return  the size of that
qsizetype hear(int fd, QByteArray &answer)
{
    char piece[64];
    const ssize_t count = ::read(fd, piece, sizeof piece);
    if (count > 0)
        answer.append(piece, count);
    return answer.size();
}

} // namespace

class TestSimulatorProgram : public QObject {
    Q_OBJECT

private slots:
    void aWrongCommandLineIsOneSentenceAndStatus2_data();
    void aWrongCommandLineIsOneSentenceAndStatus2();
    void eachProtocolOfTheTableIsServed();
    void helpNamesEveryFlag();
    void listsHaveOneThingALine_data();
    void listsHaveOneThingALine();
    void itDescribesItselfAndReadsThatBack();
    void aMotorFileIsNotTakenForMoreThanItSays_data();
    void aMotorFileIsNotTakenForMoreThanItSays();
    void overTcpOneClientAtATimeIsServed();
    void browsersAreTurnedAway_data();
    void browsersAreTurnedAway();
    void itSaysWhereItIsLinksAndEndsOnSigterm();
    void onlyALeftOverLinkIsReplaced();
    void aClientIsAnsweredAndTheNextOneToo();
    void aRequestThatCameWhileItStoodIsAnswered();
    void aRigIsAnsweredAndObeysItsWords();
    void withControlItEndsWithItsInput();
    void withoutControlItNeverReadsItsInput();
};

void TestSimulatorProgram::aWrongCommandLineIsOneSentenceAndStatus2_data()
{
    QTest::addColumn<QStringList>("arguments");
    const auto row = [](const char *name, const char *words) {
        QString line = QString::fromLatin1(words);
        line.replace(QStringLiteral("DATA/"), support::dataFile({}));
        QTest::newRow(name) << line.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    };
    row("nothing", "");
    row("unknown protocol", "quantum");
    row("a profile of the newer protocol", "legacy --profile mcsdk-6.4");
    row("no such rig", "powerpc --rig /nowhere/rig.json");
    row("a rig that is none", "legacy --rig DATA/vectors/legacy.jsonl");
    row("a rig for another protocol", "mcp --rig DATA/rigs/legacy-A.json");
    row("a motor for a rig of the older protocol",
        "legacy --motor pm24 --rig DATA/rigs/legacy-A.json");
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
    row("unknown build option", "mcp --with profiler,steam");
    row("unknown motor", "mcp --motor steam");
    row("no such file", "mcp --motor /nowhere/motor.json");
    row("no load", "mcp --load heavy");
    row("unknown load", "mcp --load spring:3");
    row("three motors", "mcp --motors 3");
    row("no port", "mcp --tcp 70000");
    row("three motors of the older protocol", "legacy --motors 3");
    row("a fault that a frame has not", "mcb --liar twice");
    row("a profile of another protocol", "mcb --profile mcsdk-6.4");
    row("no such rig", "mcb --rig /nowhere/rig.json");
    row("a motor in a rig", "mcb --rig /nowhere/rig.json --motor pm24");
    row("a description of a rig", "mcb --rig /nowhere/rig.json --describe");
    row("a rig of a board", "mcp --rig /nowhere/rig.json");
    row("link and TCP", "mcp --tcp 0 --link /tmp/x");
}

void TestSimulatorProgram::aWrongCommandLineIsOneSentenceAndStatus2()
{
    QFETCH(QStringList, arguments);
    SimProgram program(arguments);
    QVERIFY(program.ended());
    QCOMPARE(program.process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.process.exitCode(), 2);
    QCOMPARE(program.process.readAllStandardOutput(), QByteArray());
    QCOMPARE(program.process.readAllStandardError().count('\n'), 1);
}

/// As the window and the command line have a simulated board for each.
void TestSimulatorProgram::eachProtocolOfTheTableIsServed()
{
    for (const drive::ProtocolRow &row : drive::protocolTable()) {
        if (row.choice.protocol == drive::Protocol::Auto)
            continue;
        const QString word = QString::fromStdString(std::string(row.choice.word));
        SimProgram program({word, QStringLiteral("--tcp"), QStringLiteral("0")});
        QVERIFY2(program.firstLine().startsWith(QLatin1String("ready ")), qPrintable(word));
    }
}

void TestSimulatorProgram::helpNamesEveryFlag()
{
    SimProgram program({QStringLiteral("mcp"), QStringLiteral("--help")});
    QVERIFY(program.ended());
    QCOMPARE(program.process.exitCode(), 0);
    const QByteArray text = program.process.readAllStandardOutput();
    for (const char *flag : {"--profile", "--link", "--rx-max", "--txs-max", "--txa-max", "--crc",
             "--version", "--liid", "--streams", "--baud", "--hf-hz", "--ts0", "--null-check",
             "--wide", "--user-cb", "--watchdog", "--seed", "--control", "--liar", "--list-liars",
             "--rig", "--help"})
        QVERIFY2(text.contains(flag), flag);
}

void TestSimulatorProgram::listsHaveOneThingALine_data()
{
    QTest::addColumn<QString>("option");
    QTest::addColumn<QByteArrayList>("names");
    QTest::newRow("profiles") << QStringLiteral("--list-profiles")
                              << QByteArrayList{
                                     "mcsdk-6.4 ", "mcsdk-6.0 ", "six-step ", "hso ", "spec "};
    QTest::newRow("options") << QStringLiteral("--list-options") << QByteArrayList{"profiler "};
    QTest::newRow("motors") << QStringLiteral(
        "--list-motors") << QByteArrayList{"pm24 ", "prop12 ", "servo24 ", "blower36 ", "ipm48 "};
    QTest::newRow("liars") << QStringLiteral("--list-liars")
                           << QByteArrayList{"  twice (4) ", "  flood ", "  never-stops (1) "};
}

void TestSimulatorProgram::listsHaveOneThingALine()
{
    QFETCH(QString, option);
    QFETCH(QByteArrayList, names);
    SimProgram program({option});
    QVERIFY(program.ended());
    QCOMPARE(program.process.exitCode(), 0);
    const QByteArray text = '\n' + program.process.readAllStandardOutput();
    for (const QByteArray &name : names)
        QVERIFY2(text.contains('\n' + name), name.constData());
}

namespace {

QJsonObject described(const QString &options)
{
    SimProgram program(QStringList{QStringLiteral("mcp"), QStringLiteral("--describe")}
        + options.split(QLatin1Char(' '), Qt::SkipEmptyParts));
    if (!program.ended() || program.process.exitCode() != 0)
        return {};
    return QJsonDocument::fromJson(program.process.readAllStandardOutput()).object();
}

QString fileWith(const QTemporaryDir &folder, const QByteArray &text)
{
    QFile file(folder.filePath(QStringLiteral("motor.json")));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        return {};
    return file.fileName();
}

} // namespace

void TestSimulatorProgram::itDescribesItselfAndReadsThatBack()
{
    const QJsonObject first =
        described(QStringLiteral("--motor ipm48 --load 0.25,fan:1e-6 --liar twice:9"));
    QCOMPARE(first[QStringLiteral("profile")].toString(), QStringLiteral("mcsdk-6.4"));
    QCOMPARE(first[QStringLiteral("lies")][0][QStringLiteral("oneIn")].toInt(), 9);
    const QJsonValue machine = first[QStringLiteral("machine")];
    QCOMPARE(machine[QStringLiteral("motor")][QStringLiteral("lq_h")].toDouble(), 0.6e-3);
    QCOMPARE(machine[QStringLiteral("load")][QStringLiteral("constant_nm")].toDouble(), 0.25);

    const QTemporaryDir folder;
    const QString file = fileWith(folder, QJsonDocument(machine.toObject()).toJson());
    const QJsonObject second = described(QStringLiteral("--motor ") + file);
    QCOMPARE(second[QStringLiteral("machine")], machine);
}

void TestSimulatorProgram::aMotorFileIsNotTakenForMoreThanItSays_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("complaint"); // empty: it is fine
    const auto row = [](const char *name, const char *text, const char *complaint) {
        QTest::newRow(name) << QByteArray(text) << QByteArray(complaint);
    };
    row("nothing", "{}", "");
    row("one figure", R"({"motor": {"rs_ohm": 0.5}})", "");
    row("from a preset", R"({"preset": "servo24", "load": {"drive_nm": -0.1}})", "");
    row("no JSON", "{\n\"motor\": }", "line 2");
    row("no object", "[1, 2]", "preset, motor, sensors");
    row("unknown section", R"({"engine": {}})", "\"engine\"");
    row("unknown key", R"({"motor": {"rs": 0.5}})", "\"rs\"");
    row("unknown preset", R"({"preset": "steam"})", "--list-motors");
    row("too small", R"({"motor": {"ld_h": 0}})", "motor.ld_h: must be a number from 1e-06 to 1");
    row("a text", R"({"motor": {"ld_h": "0.5e-3"}})", "motor.ld_h: must be a number");
    row("half a pole", R"({"motor": {"polePairs": 2.5}})", "a whole number from 1 to 64");
    row("one for true", R"({"sensors": {"hall": 1}})", "true or false");
    row("too long a name", R"({"motor": {"name": "A motor with a very long name"}})", "at most 23");
    row("no section", R"({"motor": 3})", "an object of name, polePairs");
    row("blind to its supply", R"({"inverter": {"supply_v": 48, "busRange_v": 40}})", "busRange_v");
}

void TestSimulatorProgram::aMotorFileIsNotTakenForMoreThanItSays()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, complaint);
    const QTemporaryDir folder;
    const QString file = fileWith(folder, text);
    SimProgram program(
        {QStringLiteral("mcp"), QStringLiteral("--describe"), QStringLiteral("--motor"), file});
    QVERIFY(program.ended());
    QCOMPARE(program.process.exitCode(), complaint.isEmpty() ? 0 : 2);
    const QByteArray said = program.process.readAllStandardError();
    QVERIFY2(said.contains(complaint), said.constData());
    QCOMPARE(said.contains(file.toLocal8Bit()), !complaint.isEmpty());
    QCOMPARE(said.count('\n'), complaint.isEmpty() ? 0 : 1);
}

void TestSimulatorProgram::overTcpOneClientAtATimeIsServed()
{
    SimProgram program({QStringLiteral("mcp"), QStringLiteral("--tcp"), QStringLiteral("0")});
    const QString line = program.firstLine();
    QVERIFY2(line.startsWith(QLatin1String("ready 127.0.0.1:")), qPrintable(line));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(line.mid(line.lastIndexOf(QLatin1Char(':')) + 1).toUShort());
    const auto client = [&address] {
        const int fd = ::socket(AF_INET, SOCK_STREAM, 0);
        if (::connect(fd, reinterpret_cast<sockaddr *>(&address), sizeof address) != 0)
            return -1;
        ::fcntl(fd, F_SETFL, O_NONBLOCK);
        return fd;
    };
    const QByteArray offer = QByteArray::fromHex("05ffff0f");
    QByteArray answer;
    const auto heard = [&answer](int fd) {
        char piece[64];
        const ssize_t count = ::recv(fd, piece, sizeof piece, 0);
        if (count > 0)
            answer.append(piece, count);
        return answer.size() >= 4;
    };
    const int first = client();
    QVERIFY(first >= 0);
    QCOMPARE(::send(first, offer.constData(), 4, MSG_NOSIGNAL), ssize_t{4});
    QTRY_VERIFY(heard(first));
    const int second = client();
    QVERIFY(second >= 0);
    char byte = 0;
    QTRY_COMPARE(::recv(second, &byte, 1, 0), ssize_t{0}); // turned away
    answer.clear();
    QCOMPARE(::send(first, offer.constData(), 4, MSG_NOSIGNAL), ssize_t{4});
    QTRY_VERIFY(heard(first));
    ::close(first);
    ::close(second);
    answer.clear();
    const auto third = [&] { // until the first is seen to have gone
        const int fd = client();
        ::send(fd, offer.constData(), 4, MSG_NOSIGNAL);
        const bool served = QTest::qWaitFor([&] { return heard(fd); }, 200);
        ::close(fd);
        return served;
    };
    QTRY_VERIFY(third());
}

void TestSimulatorProgram::browsersAreTurnedAway_data()
{
    QTest::addColumn<QByteArray>("first");
    QTest::newRow("GET") << QByteArray("GET / HTTP/1.1\r\n");
    QTest::newRow("POST in pieces") << QByteArray("P|OST /|x");
    QTest::newRow("TLS") << QByteArray("\x16\x03\x01\x02");
}

/// A page in a browser can make it connect to any port of this machine and send what the page says, after a line of
/// HTTP.
void TestSimulatorProgram::browsersAreTurnedAway()
{
    QFETCH(QByteArray, first);
    SimProgram program({QStringLiteral("mcp"), QStringLiteral("--tcp"), QStringLiteral("0")});
    const QString line = program.firstLine();
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(line.mid(line.lastIndexOf(QLatin1Char(':')) + 1).toUShort());
    const int client = ::socket(AF_INET, SOCK_STREAM, 0);
    QVERIFY(::connect(client, reinterpret_cast<sockaddr *>(&address), sizeof address) == 0);
    ::fcntl(client, F_SETFL, O_NONBLOCK);
    for (const QByteArray &piece : first.split('|'))
        ::send(client, piece.constData(), static_cast<std::size_t>(piece.size()), MSG_NOSIGNAL);
    const QByteArray offer = QByteArray::fromHex("05ffff0f");
    ::send(client, offer.constData(), 4, MSG_NOSIGNAL);
    char byte = 0;
    const auto turnedAway = [&] { // closed, or reset because something had not been read
        const ssize_t count = ::recv(client, &byte, 1, 0);
        return count == 0 || (count < 0 && errno == ECONNRESET);
    };
    QTRY_VERIFY(turnedAway());
    ::close(client);
}

void TestSimulatorProgram::itSaysWhereItIsLinksAndEndsOnSigterm()
{
    const QTemporaryDir folder;
    const QString link = folder.filePath(QStringLiteral("board"));
    SimProgram program({QStringLiteral("mcp"), QStringLiteral("--link"), link});
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
    SimProgram refused({QStringLiteral("mcp"), QStringLiteral("--link"), mine});
    QVERIFY(refused.ended());
    QCOMPARE(refused.process.exitCode(), 5);
    QCOMPARE(QFileInfo(mine).symLinkTarget(), folder.path());
    SimProgram taken({QStringLiteral("mcp"), QStringLiteral("--link"), old});
    QCOMPARE(QFileInfo(old).symLinkTarget(), taken.firstLine().mid(6));
}

void TestSimulatorProgram::aClientIsAnsweredAndTheNextOneToo()
{
    SimProgram program({QStringLiteral("mcp")});
    const QByteArray path = program.firstLine().mid(6).toLocal8Bit();
    for (int client = 0; client < 2; ++client) {
        const int fd = ::open(path.constData(), O_RDWR | O_NOCTTY | O_NONBLOCK);
        QVERIFY(fd >= 0);
        termios settings{};
        tcgetattr(fd, &settings);
        QVERIFY((settings.c_lflag & (ICANON | ECHO)) == 0); // raw from the beginning
        const QByteArray offer = QByteArray::fromHex("05ffff0f");
        QByteArray answer;
        const auto heard = [&] { return hear(fd, answer) >= 4; };
        QCOMPARE(::write(fd, offer.constData(), 4), ssize_t{4});
        QTRY_VERIFY(heard());
        QCOMPARE(answer.toHex(), QByteArray("05c70114"));
        ::close(fd);
    }
}

/// Its header and its payload are read in one piece then, whatever their sender did.
void TestSimulatorProgram::aRequestThatCameWhileItStoodIsAnswered()
{
    SimProgram program({QStringLiteral("mcp")});
    const QByteArray path = program.firstLine().mid(6).toLocal8Bit();
    const int fd = ::open(path.constData(), O_RDWR | O_NOCTTY | O_NONBLOCK);
    QVERIFY(fd >= 0);
    const auto closing = qScopeGuard([fd] { ::close(fd); });
    const auto send = [fd](const aspep::Header &header) {
        const aspep::HeaderBytes bytes = aspep::encodeHeader(header);
        return ::write(fd, bytes.data(), bytes.size()) == ssize_t(bytes.size());
    };
    QByteArray answer;
    const auto heard = [&](qsizetype size) { return hear(fd, answer) >= size; };
    const auto offer = aspep::Beacon{};
    QVERIFY(send(offer));
    QTRY_VERIFY(heard(4));
    aspep::HeaderBytes bytes{};
    std::copy_n(answer.cbegin(), bytes.size(), bytes.begin());
    QVERIFY(send(*aspep::decodeHeader(bytes)));
    QTRY_VERIFY(heard(8));
    QVERIFY(send(aspep::Ping{}));
    QTRY_VERIFY(heard(12));
    const auto pid = static_cast<pid_t>(program.process.processId());
    for (int i = 0; i < 5; ++i) {
        answer.clear();
        QCOMPARE(::kill(pid, SIGSTOP), 0);
        const char getVersion[2] = {0, 0};
        QVERIFY(send(aspep::Data{false, sizeof getVersion}));
        QCOMPARE(::write(fd, getVersion, sizeof getVersion), ssize_t{2});
        QElapsedTimer stood;
        stood.start();
        QTRY_VERIFY(stood.elapsed() >= 5);
        QCOMPARE(::kill(pid, SIGCONT), 0);
        QTRY_VERIFY(heard(4));
        std::copy_n(answer.cbegin(), bytes.size(), bytes.begin());
        const auto header = aspep::decodeHeader(bytes);
        const auto *data = header ? std::get_if<aspep::Data>(&*header) : nullptr;
        QVERIFY2(data && data->response, answer.toHex().constData());
        // All of it: what comes late would be taken for the next answer.
        QTRY_VERIFY2(heard(4 + data->length), answer.toHex().constData());
    }
}

void TestSimulatorProgram::aRigIsAnsweredAndObeysItsWords()
{
    SimProgram program({QStringLiteral("legacy"), QStringLiteral("--control"),
        QStringLiteral("--rig"), support::dataFile(QStringLiteral("rigs/legacy-P.json"))});
    const QByteArray path = program.firstLine().mid(6).toLocal8Bit();
    const int fd = ::open(path.constData(), O_RDWR | O_NOCTTY | O_NONBLOCK);
    QVERIFY(fd >= 0);
    const auto ask = [fd](const char *hex) {
        const QByteArray request = QByteArray::fromHex(hex);
        return ::write(fd, request.constData(), static_cast<std::size_t>(request.size()));
    };
    QByteArray answer;
    const auto heard = [&](qsizetype size) { return hear(fd, answer) >= size; };
    QCOMPARE(ask("03010105"), ssize_t{4}); // the rig speaks PowerPC under either name
    QTRY_VERIFY(heard(4));
    QCOMPARE(answer.toHex(), QByteArray("f00101f2"));
    program.process.write(
        "state 300\nfaults xyz\nstate 10\nfaults 0x00020040\nexecute\nrx-timeout\n"
        "rx-overrun\n");
    answer.clear();
    QTRY_VERIFY(heard(4)); // the overrun is refused, and all words before it are done
    QCOMPARE(answer.toHex(), QByteArray("ff010809"));
    answer.clear();
    QCOMPARE(ask("02010104"), ssize_t{4});
    QTRY_VERIFY(heard(7));
    QCOMPARE(answer.toHex(), QByteArray("f0044000020037"));
    ::close(fd);
    program.process.write("quit\n");
    QVERIFY(program.ended());
    QCOMPARE(program.process.exitCode(), 0);
    QCOMPARE(program.process.readAllStandardError().count('\n'), 2);
}

void TestSimulatorProgram::withControlItEndsWithItsInput()
{
    SimProgram program({QStringLiteral("mcp"), QStringLiteral("--control")});
    QVERIFY(!program.firstLine().isEmpty());
    program.process.write("fault 0x40\nnofault\nload 0.05\nload 0 1\nmute 10\ncorrupt 3\ninject "
                          "0a0b\nreset\ndance\n");
    program.process.closeWriteChannel();
    QVERIFY(program.ended());
    QCOMPARE(program.process.exitCode(), 0);
    QCOMPARE(program.process.readAllStandardError().count('\n'), 1); // there is no dance
}

void TestSimulatorProgram::withoutControlItNeverReadsItsInput()
{
    SimProgram program({QStringLiteral("mcp")});
    QVERIFY(!program.firstLine().isEmpty());
    program.process.write("quit\n");
    program.process.closeWriteChannel();
    QVERIFY(!program.process.waitForFinished(200));
    program.process.terminate();
    QVERIFY(program.ended());
}

QTEST_GUILESS_MAIN(TestSimulatorProgram)
#include "tst_simulator_program_posix.moc"
