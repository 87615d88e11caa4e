// Lines of the motion log for a spreadsheet.
#include "drive/event.h"
#include "session/files/motion_log_file.h"

#include <QTest>

using namespace session;
using namespace std::chrono_literals;
using drive::MotionAct;
using drive::MotionEntry;
using drive::Outcome;
using drive::StopWord;

namespace {

std::string lineOf(const MotionEntry &entry) { return motionLogLine(entry, 1, "", ""); }

} // namespace

class TestMotionLogFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void linesAreForSpreadsheets();
    void cellsAreNoFormulas();
    void bytesAreInHex();
};

void TestMotionLogFile::linesAreForSpreadsheets()
{
    MotionEntry entry;
    entry.act = MotionAct::SpeedRamp;
    entry.motor = 2;
    entry.detail = "-1200 rpm in 500 ms";
    entry.outcome = Outcome::Refused;
    entry.reason = "beyond \"this\", says the board\nand more";
    entry.asked = TimePoint(1s);
    entry.ended = TimePoint(1s + 12300us);
    entry.requests = 3;
    entry.sent = {{0x11, 0x02}, {0x0A}};
    QCOMPARE(motionLogLine(entry, 7, "2024-05-06T07:08:09.123", "=kim, here"),
        std::string("7,2024-05-06T07:08:09.123,\"'=kim, here\",person,2,SPEED_RAMP,"
                    "'-1200 rpm in 500 ms,refused,\"beyond \"\"this\"\", says the board and "
                    "more\",12.3,11 02 | 0A | and 1 more"));
    QCOMPARE(motionLogHeading(),
        std::string("number,time,who,source,motor,command,detail,outcome,reason,took [ms],bytes"));
    entry = {};
    entry.act = MotionAct::Stop;
    entry.stop = StopWord::NotConfirmed; // before the outcome
    QCOMPARE(lineOf(entry), std::string("1,,,person,,STOP,,NOT confirmed,,0.0,"));
    entry.motor = 1;
    QVERIFY(lineOf(entry).starts_with("1,,,person,1,STOP,"));
}

void TestMotionLogFile::cellsAreNoFormulas()
{
    const std::pair<const char *, const char *> cells[] = {{"=1+1", "'=1+1"}, {"+1", "'+1"},
        {"-1", "'-1"}, {"@x", "'@x"}, {"\tx", "' x"}, {"1=1", "1=1"},
        {"a b\x1f"
         "c",
            "a b c"},
        {"a,b", "\"a,b\""}, {"a\"b", "\"a\"\"b\""}, {"\xC2\xB5", "\xC2\xB5"}, {"", ""}};
    for (const auto &[text, cell] : cells) {
        MotionEntry entry;
        entry.outcome = Outcome::Ok;
        entry.reason = text;
        QCOMPARE(lineOf(entry), "1,,,person,,START,,ok," + std::string(cell) + ",0.0,");
    }
}

void TestMotionLogFile::bytesAreInHex()
{
    MotionEntry entry;
    const auto bytes = [&] {
        const std::string line = lineOf(entry);
        return line.substr(line.rfind(',') + 1);
    };
    entry.sent = {{0x00, 0xA5, 0xFF}};
    entry.requests = 1;
    QCOMPARE(bytes(), std::string("00 A5 FF"));
    entry.sent.push_back({0x10});
    entry.requests = 2;
    QCOMPARE(bytes(), std::string("00 A5 FF | 10"));
    entry.requests = 5;
    QCOMPARE(bytes(), std::string("00 A5 FF | 10 | and 3 more"));
}

QTEST_APPLESS_MAIN(TestMotionLogFile)
#include "tst_motion_log_file.moc"
