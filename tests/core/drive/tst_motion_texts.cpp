// The words of the motion log: what was asked for, as an entry says it. No board.
#include "drive/event.h"
#include "drive/motion_entry.h"

#include <QTest>

using namespace drive;
using namespace std::chrono_literals;
using What = decltype(Wish::what);

namespace {

constexpr RegisterId kSpeedRef = 0x1000, kControlMode = 0x2000, kAnyGain = 0x3000, kBoard = 0x4000;

/// Two motors; a set-point, a register that can do harm, one that cannot, and one of the whole board.
const catalog::Catalog &registers()
{
    static const catalog::Catalog all = [] {
        std::vector<catalog::RegisterInfo> infos(4);
        const char *names[] = {"SPEED_REF", "MODE", "GAIN", "RESET"};
        for (std::size_t i = 0; i < infos.size(); ++i) {
            infos[i].id = kSpeedRef * static_cast<RegisterId>(i + 1);
            infos[i].name = names[i];
        }
        infos[0].setPoint = catalog::SetPoint::Speed;
        infos[0].unit = "rpm";
        infos[0].fractionBits = 1;
        infos[1].dangerous = infos[3].dangerous = true;
        infos[3].perMotor = false;
        return catalog::Catalog(infos, 2, std::vector<catalog::Scales>(2));
    }();
    return all;
}

RegisterId ofMotor(RegisterId id, int motor)
{
    return registers().withMotor(*registers().find(id), motor);
}

std::optional<MotionEntry> entryOf(const What &what)
{
    return motionOf(
        {.id = 7, .what = what, .source = Source::CommandLine}, registers(), TimePoint(3s));
}

Write writeOf(std::vector<RegisterWrite> writes)
{
    Write write;
    write.writes = std::move(writes);
    return write;
}

} // namespace

class TestMotionTexts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void eachActSaysWhatWasAskedFor();
    void writesNameWhatCanMoveSomething();
    void aLongListIsCut();
    void onlyTheFirstBytesAreKept();
    void everyWordIsItsOwn();
};

void TestMotionTexts::eachActSaysWhatWasAskedFor()
{
    struct Row {
        What what;
        MotionAct act = MotionAct::Start;
        int motor = 0;
        const char *detail = "";
    };
    const Row rows[] = {
        {Command{MotorAction::Start, 2}, MotionAct::Start, 2, ""},
        {Command{MotorAction::StopMotor, 2}, MotionAct::StopMotor, 2, ""},
        {Command{MotorAction::StopRamp, 2}, MotionAct::StopRamp, 2, ""},
        {Command{MotorAction::AcknowledgeFaults, 2}, MotionAct::AcknowledgeFaults, 2, ""},
        {SpeedRamp{2, -600, 250ms}, MotionAct::SpeedRamp, 2, "-600 rpm in 250 ms"},
        {TorqueRamp{2, 1.25, 100ms}, MotionAct::TorqueRamp, 2, "1.25 A in 100 ms"},
        {TorqueRamp{2, 1.23456789, 0ms}, MotionAct::TorqueRamp, 2, "1.23457 A in 0 ms"},
        {CurrentReference{2, 0.5, -1.5}, MotionAct::CurrentReference, 2, "Iq 0.5 A, Id -1.5 A"},
        {PositionRamp{2, 3.5, 750ms}, MotionAct::PositionRamp, 2, "3.5 rad in 750 ms"},
        {UserLimits{1500.0, 0.0}, MotionAct::Limits, 0, "1500 rpm, none"},
        {UserLimits{0.5, 0.5}, MotionAct::Limits, 0, "0.5 rpm, 0.5 A"},
        {UserLimits{}, MotionAct::Limits, 0, "none, none"},
        {ExpertMode{2}, MotionAct::Expert, 2, ""},
        {CurrentScale{2, 16.5}, MotionAct::CurrentScale, 2, "16.5 A"},
        {CurrentScale{2, 0.5}, MotionAct::CurrentScale, 2, "0.5 A"},
        {CurrentScale{2, 0.0}, MotionAct::CurrentScale, 2, "none"},
    };
    for (const Row &row : rows) {
        const auto entry = entryOf(row.what);
        QVERIFY2(entry.has_value(), row.detail);
        QVERIFY2(entry->act == row.act, row.detail);
        QCOMPARE(entry->motor, row.motor);
        QCOMPARE(entry->detail, std::string(row.detail));
        QVERIFY(entry->source == Source::CommandLine);
        QVERIFY(entry->asked == TimePoint(3s) && entry->ended == TimePoint(3s));
    }
    for (const What &what :
        std::initializer_list<What>{Read{}, Stream{}, Watch{}, CyclicSetPoints{}, Write{}})
        QVERIFY(!entryOf(what));
}

void TestMotionTexts::writesNameWhatCanMoveSomething()
{
    struct Row {
        std::vector<RegisterWrite> writes;
        int motor = 0;
        const char *detail = ""; ///< empty: no motion
    };
    const Row rows[] = {
        {{{ofMotor(kSpeedRef, 2), std::int64_t{1200}}}, 2, "SPEED_REF@2 = 600 rpm"},
        {{{ofMotor(kControlMode, 1), std::int64_t{3}}}, 1, "MODE@1 = 3"},
        {{{ofMotor(kAnyGain, 1), std::int64_t{3}}}, 0, ""},
        {{{0x7000, std::int64_t{3}}}, 0, ""}, // unknown
        {{{kBoard, std::int64_t{1}}}, 0, "RESET = 1"},
        {{{kBoard, std::int64_t{1}}, {ofMotor(kControlMode, 2), std::int64_t{3}}}, 0,
            "RESET = 1; MODE@2 = 3"},
        {{{ofMotor(kAnyGain, 1), std::int64_t{9}}, {ofMotor(kControlMode, 2), std::int64_t{3}},
             {ofMotor(kControlMode, 1), std::int64_t{4}}},
            2, "MODE@2 = 3; MODE@1 = 4"},
        {{{ofMotor(kControlMode, 1), Bytes{0x00, 0xA5, 0x1F}}}, 1, "MODE@1 = 0x00A51F"},
        {{{ofMotor(kControlMode, 1), std::string("text")}}, 1, "MODE@1 = ?"},
    };
    for (const Row &row : rows) {
        const auto entry = entryOf(writeOf(row.writes));
        QCOMPARE(entry.has_value(), *row.detail != 0);
        if (!entry)
            continue;
        QVERIFY(entry->act == MotionAct::Write);
        QCOMPARE(entry->detail, std::string(row.detail));
        QCOMPARE(entry->motor, row.motor);
    }
}

void TestMotionTexts::aLongListIsCut()
{
    for (const std::size_t count : {8U, 9U, 11U}) {
        const auto entry = entryOf(writeOf(
            std::vector<RegisterWrite>(count, {ofMotor(kControlMode, 1), std::int64_t{3}})));
        const QString detail = QString::fromStdString(entry->detail);
        QCOMPARE(detail.count(QLatin1String("MODE@1 = 3")), 8);
        QCOMPARE(detail.endsWith(QStringLiteral("3; and %1 more").arg(count - 8)), count > 8);
    }
}

void TestMotionTexts::onlyTheFirstBytesAreKept()
{
    MotionEntry entry;
    const Bytes request{1, 2};
    for (std::size_t i = 1; i <= MotionEntry::kMostSent + 2; ++i) {
        noteSent(entry, request);
        QCOMPARE(entry.sent.size(), std::min(i, std::size_t{MotionEntry::kMostSent}));
    }
    QCOMPARE(entry.sent.front(), request);
    QCOMPARE(std::size_t{entry.requests}, std::size_t{34});
}

void TestMotionTexts::everyWordIsItsOwn()
{
    const std::string_view acts[] = {"ARM", "DISARM", "LIMITS", "EXPERT_MODE", "CURRENT_SCALE",
        "START", "STOP", "STOP_MOTOR", "STOP_RAMP", "FAULT_ACK", "SPEED_RAMP", "TORQUE_RAMP",
        "CURRENT_REFERENCE", "POSITION_RAMP", "WRITE"};
    for (std::size_t i = 0; i < std::size(acts); ++i)
        QVERIFY(wordOf(static_cast<MotionAct>(i)) == acts[i]);
    QVERIFY(wordOf(Source::Person) == "person");
    QVERIFY(wordOf(Source::CommandLine) == "command line");
    QVERIFY(wordOf(Source::Script) == "script");
    QVERIFY(wordOf(Outcome::Ok) == "ok");
    QVERIFY(wordOf(Outcome::Refused) == "refused");
    QVERIFY(wordOf(Outcome::NotSent) == "not sent");
    QVERIFY(wordOf(Outcome::Unknown) == "unknown");
    QVERIFY(wordOf(StopWord::Requested) == "requested");
    QVERIFY(wordOf(StopWord::Accepted) == "accepted");
    QVERIFY(wordOf(StopWord::DriveIdle) == "drive idle");
    QVERIFY(wordOf(StopWord::Standstill) == "standstill measured");
    QVERIFY(wordOf(StopWord::MayCoast) == "speed not measurable");
    QVERIFY(wordOf(StopWord::NotConfirmed) == "NOT confirmed");
}

QTEST_APPLESS_MAIN(TestMotionTexts)
#include "tst_motion_texts.moc"
