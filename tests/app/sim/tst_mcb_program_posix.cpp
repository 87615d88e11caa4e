// rotorscope-sim mcb as a program: a session of the vectors through its pseudo-terminal, and the words it obeys.
#include "support/mcb/vectors.h"
#include "support/places.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

class TestMcbProgram : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSessionIsAnsweredByteForByte();
    void itObeysItsWordsAndEndsWithItsInput();
};

namespace {

constexpr int kServoTime_ms = 10'000;

/// The program with a rig of one register, 0x011 = 0x1637, which can be written.
class Program {
public:
    Program()
    {
        QFile rig(m_folder.filePath(QStringLiteral("rig.json")));
        if (rig.open(QIODevice::WriteOnly))
            rig.write(R"({"protocol": "mcb", "registers": {"0x011":
                {"type": "UINT16", "size": 2, "cyclic": "tx", "access": "rw", "words": ["1637"]}}})");
        rig.close();
        process.start(support::programFile(QStringLiteral("rotorscope-sim")),
            {QStringLiteral("mcb"), QStringLiteral("--control"), QStringLiteral("--rig"),
                rig.fileName()});
        while (!process.canReadLine() && process.waitForReadyRead(kServoTime_ms)) { }
        const QString path = QString::fromLocal8Bit(process.readLine()).section(u' ', -1).trimmed();
        m_line = ::open(path.toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    }
    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;
    ~Program()
    {
        ::close(m_line);
        process.kill();
        process.waitForFinished(kServoTime_ms);
    }

    /// What comes back for a frame in hexadecimal digits.
    QString exchange(const char *hex)
    {
        const Bytes asked = support::bytesOfHex(QString::fromLatin1(hex));
        if (::write(m_line, asked.data(), asked.size()) != static_cast<ssize_t>(asked.size()))
            return {};
        Bytes answer;
        pollfd state{m_line, POLLIN, 0};
        while (answer.size() < asked.size() && ::poll(&state, 1, kServoTime_ms) > 0) {
            std::array<std::uint8_t, 256> piece{};
            const ssize_t count = ::read(m_line, piece.data(), piece.size());
            if (count <= 0)
                break;
            answer.insert(answer.end(), piece.begin(), piece.begin() + count);
        }
        return support::hexOf(answer);
    }

    QProcess process;

private:
    QTemporaryDir m_folder;
    int m_line = -1;
};

const char *const kRead = "01120000000000000000fadc";
const char *const kIdle = "000e00000000000000007377";

} // namespace

void TestMcbProgram::aSessionIsAnsweredByteForByte()
{
    Program program;
    QCOMPARE(program.exchange(kRead), QLatin1String(kIdle));
    QCOMPARE(program.exchange(kIdle), QLatin1String("011616370000000000009b85"));
    QCOMPARE(program.exchange("123200000000000000007879"), QLatin1String(kIdle));
    QCOMPARE(program.exchange(kIdle), QLatin1String("123a000006020000000098e4"));
}

void TestMcbProgram::itObeysItsWordsAndEndsWithItsInput()
{
    Program program;
    QCOMPARE(program.exchange("011400060000000000000171"), QLatin1String(kIdle)); // write 6
    QCOMPARE(program.exchange(kRead), QLatin1String("01160006000000000000c716"));
    QCOMPARE(program.exchange(kIdle), QLatin1String("01160006000000000000c716"));
    program.process.setReadChannel(QProcess::StandardError);
    program.process.write("dance\nreset\nprance\n");
    QByteArray complaints;
    while (complaints.count('\n') < 2 && program.process.waitForReadyRead(kServoTime_ms))
        complaints += program.process.readAllStandardError();
    QVERIFY2(complaints.contains("dance") && complaints.contains("prance"), complaints);
    QCOMPARE(program.exchange(kRead), QLatin1String(kIdle));
    QCOMPARE(program.exchange(kIdle), QLatin1String("011616370000000000009b85"));
    program.process.closeWriteChannel();
    QVERIFY(program.process.waitForFinished(kServoTime_ms));
    QCOMPARE(program.process.exitCode(), 0);
}

QTEST_GUILESS_MAIN(TestMcbProgram)
#include "tst_mcb_program_posix.moc"
