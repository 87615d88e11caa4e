// Moves of the shaft through the drive on a simulated board: bounded by the speed on the way, sent once.
#include "mcp/protocol.h"
#include "motor/ramp.h"
#include "support/link_pair.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>

using namespace std::chrono_literals;
using drive::Outcome;

namespace {

simulation::BoardOptions positions()
{
    simulation::BoardOptions options;
    options.motor = "servo24";
    for (const auto &option : simulation::buildOptions())
        if (option.name == "position")
            options.with.push_back(&option);
    return options;
}

struct Servo : support::Session {
    explicit Servo(bool toArm = true, const simulation::BoardOptions &options = positions())
        : Session(toArm, options)
    {
    }
    drive::Ended move(double radians, std::chrono::milliseconds time, int motor = 1)
    {
        const auto wish = submit(drive::PositionRamp{motor, radians, time});
        runUntilEnded(wish);
        return ended[wish].front();
    }
    double position()
    {
        const auto id = this->id("CURRENT_POSITION");
        runUntilEnded(submit(drive::Read{{id}}));
        const auto *value = std::get_if<double>(&values[id].value);
        return value ? *value : std::nan("");
    }
    /// How often POSITION_RAMP was set.
    int sets()
    {
        int count = 0;
        for (const Bytes &request : requests)
            if (const auto decoded = mcp::decodeRequest(request); decoded
                && decoded->command == static_cast<std::uint16_t>(mcp::CommandId::SetRegister))
                for (const auto &write : mcp::decodeSetList(decoded->content).writes)
                    count += write.id.element() == mcp::reg::kPositionRamp.element()
                            && write.id.type() == mcp::reg::kPositionRamp.type()
                        ? 1
                        : 0;
        return count;
    }
};

} // namespace

class TestMcpDrivePosition : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theShaftGoesThere()
    {
        Servo servo;
        QVERIFY(servo.startMotor());
        QVERIFY(servo.move(std::numbers::pi, 1000ms).outcome == Outcome::Ok);
        servo.runFor(2s);
        QVERIFY2(std::abs(servo.position() - std::numbers::pi) < 0.05,
            qPrintable(QString::number(servo.position())));
        QCOMPARE(servo.sets(), 1);
    }

    /// Up to 6.2.1 boards give duration and target in the other order.
    void itIsReadAsItWasWritten()
    {
        for (const char *profile : {"mcsdk-6.1", "mcsdk-6.2", "mcsdk-6.4"}) {
            simulation::BoardOptions options = positions();
            options.profile = profile;
            Servo servo(true, options);
            QVERIFY(servo.ready);
            const auto id = servo.id("POSITION_RAMP");
            const drive::Value ramp = ByteWriter().f32(1.0F).f32(5.0F).take();
            const auto write = servo.submit(drive::Write{{{id, ramp}}});
            QVERIFY(servo.runUntilEnded(write));
            const drive::Ended &written = servo.ended[write].front();
            QVERIFY2(written.outcome == Outcome::Ok, written.reason.c_str());
            QVERIFY(servo.runUntilEnded(servo.submit(drive::Read{{id}})));
            QVERIFY(servo.values[id].value == ramp);
        }
    }

    void whatWouldBeTooFastOrSenselessIsNotSent()
    {
        Servo servo;
        QVERIFY(servo.startMotor());
        const double turn = 2.0 * std::numbers::pi;
        for (const auto &[radians, time] :
            std::initializer_list<std::pair<double, std::chrono::milliseconds>>{{100 * turn, 500ms},
                {1.0, 0ms}, {1.0, 65536ms}, {-1.0, -5ms}, {std::nan(""), 500ms},
                {std::numeric_limits<double>::infinity(), 500ms}, {1e5, 65000ms}}) {
            const auto ended = servo.move(radians, time);
            QVERIFY2(ended.outcome == Outcome::Refused, ended.reason.c_str());
            QVERIFY(!ended.reason.empty());
        }
        QVERIFY(servo.move(1.0, 500ms, 2).outcome == Outcome::Refused);
        QCOMPARE(servo.sets(), 0);
    }

    void aPersonsOwnSpeedLimitBoundsItToo()
    {
        Servo servo;
        QVERIFY(servo.startMotor());
        servo.submit(drive::UserLimits{100.0, 0.0});
        // Half a turn in a second is 56 rpm half-way, in a quarter of that 225.
        QVERIFY(servo.move(std::numbers::pi, 250ms).outcome == Outcome::Refused);
        QVERIFY(servo.move(std::numbers::pi, 1000ms).outcome == Outcome::Ok);
    }

    void unarmedNothingIsSent()
    {
        Servo servo(false);
        QVERIFY(servo.move(1.0, 500ms).outcome == Outcome::NotSent);
        QCOMPARE(servo.sets(), 0);
    }

    void aStopOrDisarmWhileItLooksIsTheEndOfIt()
    {
        for (const bool stop : {false, true}) {
            Servo servo;
            QVERIFY(servo.startMotor());
            const auto wish = servo.submit(drive::PositionRamp{1, 1.0, 500ms});
            QVERIFY(!servo.ended.contains(wish)); // it has asked where the shaft is
            stop ? servo.drive->stop(servo.now) : servo.drive->disarm();
            servo.runFor(500ms);
            QCOMPARE(servo.ended[wish].size(), std::size_t{1});
            QVERIFY(servo.ended[wish].front().outcome == Outcome::NotSent);
            QCOMPARE(servo.sets(), 0);
        }
    }

    void aShaftThatIsNowhereIsNotMoved()
    {
        Servo servo;
        QVERIFY(servo.startMotor());
        servo.toDrive.cut = true;
        const auto wish = servo.submit(drive::PositionRamp{1, 1.0, 500ms});
        QVERIFY(servo.runUntilEnded(wish, 30s));
        QVERIFY(servo.ended[wish].front().outcome == Outcome::NotSent);
        servo.toDrive.cut = false;
        servo.runFor(2s);
        QCOMPARE(servo.sets(), 0);
    }

    void withoutPositionControlItIsRefusedWithTheReason()
    {
        Servo plain(true, {});
        const auto ended = plain.move(1.0, 500ms);
        QVERIFY(ended.outcome == Outcome::Refused);
        QVERIFY2(ended.reason.find("position control") != std::string::npos, ended.reason.c_str());
    }

    void theWayBeginsAndEndsAtRest()
    {
        QCOMPARE(motor::positionShare(0.0), 0.0);
        QCOMPARE(motor::positionShare(0.5), 0.5);
        QCOMPARE(motor::positionShare(1.0), 1.0);
        double fastest = 0.0;
        for (double t = 0.0; t < 1.0; t += 1e-3)
            fastest = std::max(
                fastest, (motor::positionShare(t + 1e-3) - motor::positionShare(t)) / 1e-3);
        // One radian in a second: its greatest speed is what is announced.
        QVERIFY(std::abs(fastest * 60.0 / (2.0 * std::numbers::pi)
                    - motor::positionPeakSpeed_rpm(-1.0, 1.0))
            < 1e-3);
        QVERIFY(std::isinf(motor::positionPeakSpeed_rpm(1.0, 0.0)));
    }
};

QTEST_GUILESS_MAIN(TestMcpDrivePosition)
#include "tst_mcp_drive_position.moc"
