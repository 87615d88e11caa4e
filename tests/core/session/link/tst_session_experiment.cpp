// A series of steps carried out by a session, on virtual time and judged on the wire: what the user does meanwhile
// counts, its Stop leaves in the turn in which a cap breaks, and what was recorded before is recorded again.
#include "core/session/link/lab_world.h"

#include <QtTest>

using namespace std::chrono_literals;
using drive::MotorState;
using lab::End;
using session::Session;
using World = support::LabWorld;

namespace {

#define VERIFY_END(world, wanted)                                                                  \
    do {                                                                                           \
        QCOMPARE((world).outcomes.size(), 1U);                                                     \
        QVERIFY2((world).outcomes[0].end == (wanted),                                              \
            qPrintable(QStringLiteral("%1: %2")                                                    \
                           .arg(int((world).outcomes[0].end))                                      \
                           .arg(QString::fromStdString((world).outcomes[0].reason))));             \
    } while (false)

/// A mechanical identification, until the motor is driven by its second torque.
bool pushes(World &world)
{
    const lab::Subject subject = *lab::subjectOf(*world.board(), 1);
    world.session.run({lab::spinPlanFor(subject, {}), subject});
    return world.runUntil(
        [&] {
            const auto acts = world.all<drive::MotionEntry>();
            return std::count_if(acts.begin(), acts.end(), [](const drive::MotionEntry &one) {
                return one.act == drive::MotionAct::TorqueRamp;
            }) >= 2;
        },
        40s);
}

bool saysStop(const lab::Outcome &outcome)
{
    return outcome.reason.find("every motor was told to stop") != std::string::npos;
}

} // namespace

class TestSessionExperiment : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itEndsOnceAndLeavesAllAsItWas()
    {
        World world;
        QVERIFY(world.connect());
        const drive::Stream own{.fast = {world.id("I_A")}, .slow = {}};
        world.session.submit({.id = 5, .what = own});
        world.run(500ms);
        world.session.run(world.experiment());
        QVERIFY(world.ends());
        VERIFY_END(world, End::Complete);
        QCOMPARE(world.outcomes[0].reason, std::string());
        QVERIFY(world.idles());
        world.run(1s);
        QVERIFY(!world.layouts.empty());
        const auto &last = world.layouts.back().second;
        QCOMPARE(last.fast.size(), 1U);
        QCOMPARE(last.fast[0].id, world.id("I_A"));
        QCOMPARE(world.outcomes.size(), 1U);
    }

    /// Stored while it runs, and in effect afterwards: its wish ends at once.
    void whatIsAskedToBeRecordedMeanwhileIsRecordedAfterwards()
    {
        World world;
        QVERIFY(world.connect());
        world.session.run(world.experiment());
        QVERIFY(world.steps());
        const drive::Stream own{.fast = {world.id("I_B")}, .slow = {}};
        world.session.submit({.id = 6, .what = own});
        QVERIFY(world.ends());
        VERIFY_END(world, End::Complete);
        world.run(1s);
        QCOMPARE(world.layouts.back().second.fast.at(0).id, world.id("I_B"));
        const auto ended = world.all<drive::Ended>();
        QCOMPARE(std::count_if(ended.begin(), ended.end(),
                     [](const drive::Ended &one) { return one.id == 6; }),
            1);
    }

    void notArmedOrASecondOneIsRefused()
    {
        World world;
        QVERIFY(world.connect());
        world.session.setArmed(false);
        world.session.run(world.experiment());
        VERIFY_END(world, End::Refused);
        world.session.setArmed(true);
        world.outcomes.clear();
        world.session.run(world.experiment());
        world.run(100ms);
        world.session.run(world.experiment());
        VERIFY_END(world, End::Refused);
        world.outcomes.clear();
        QVERIFY(world.ends());
        VERIFY_END(world, End::Complete);
    }

    void aPersonsStopEndsIt()
    {
        World world;
        QVERIFY(world.connect());
        world.session.run(world.experiment());
        QVERIFY(world.steps());
        world.session.stop();
        QVERIFY(world.ends(100ms));
        VERIFY_END(world, End::Interrupted);
        QVERIFY(world.idles());
        world.run(3s);
        QVERIFY(world.status->state == MotorState::Idle);
    }

    void disarmingEndsItAndTheMotorGoesOn()
    {
        World world;
        QVERIFY(world.connect());
        world.session.run(world.experiment());
        QVERIFY(world.steps());
        world.session.setArmed(false);
        QVERIFY(world.ends(100ms));
        VERIFY_END(world, End::Interrupted);
        QVERIFY(
            QString::fromStdString(world.outcomes[0].reason).contains(QStringLiteral("1500 rpm")));
        const auto before = world.all<drive::MotionEntry>().size();
        world.run(2s);
        QVERIFY(world.status->state == MotorState::Running);
        for (std::size_t i = before; i < world.all<drive::MotionEntry>().size(); ++i)
            QVERIFY(world.all<drive::MotionEntry>()[i].act != drive::MotionAct::SpeedRamp);
        world.session.stop();
        QVERIFY(world.idles());
    }

    void somebodyElsesCommandTakesTheMotorOver()
    {
        World world;
        QVERIFY(world.connect());
        world.session.run(world.experiment());
        QVERIFY(world.steps());
        world.session.submit({.id = 7, .what = drive::SpeedRamp{1, 2000, 100ms}});
        QVERIFY(world.ends(100ms));
        VERIFY_END(world, End::Interrupted);
        QVERIFY(world.runUntil(
            [&] {
                return world.status->speedRpm && std::abs(*world.status->speedRpm - 2000.0) < 100.0;
            },
            5s));
        world.run(2s);
        QVERIFY(std::abs(*world.status->speedRpm - 2000.0) < 100.0);
        world.session.stop();
        QVERIFY(world.idles());
    }

    void whoEndsATorqueEndsItWithAStop_data()
    {
        QTest::addColumn<QString>("deed");
        for (const char *deed : {"Stop ramp", "a speed", "disarming", "closing"})
            QTest::newRow(deed) << QString::fromLatin1(deed);
    }
    /// It would accelerate the rotor further, and nothing would bound that any more.
    void whoEndsATorqueEndsItWithAStop()
    {
        QFETCH(const QString, deed);
        World world;
        QVERIFY(world.connect());
        QVERIFY(pushes(world));
        const TimePoint at = world.now;
        if (deed == QLatin1String("Stop ramp"))
            world.session.submit(
                {.id = 7, .what = drive::Command{drive::MotorAction::StopRamp, 1}});
        else if (deed == QLatin1String("a speed"))
            world.session.submit({.id = 7, .what = drive::SpeedRamp{1, 2000, 100ms}});
        else if (deed == QLatin1String("disarming"))
            world.session.setArmed(false);
        else
            world.session.close();
        QVERIFY(world.ends(100ms));
        VERIFY_END(world, End::Interrupted);
        QVERIFY2(saysStop(world.outcomes[0]), world.outcomes[0].reason.c_str());
        world.run(3s);
        QVERIFY(!world.line.isDriven());
        QCOMPARE(world.session.closed(), deed == QLatin1String("closing"));
        for (const drive::MotionEntry &one : world.all<drive::MotionEntry>())
            QVERIFY(one.asked < at || one.act == drive::MotionAct::Stop || one.requests == 0);
    }

    /// What is told of the gap then is not that the motors go on as they are.
    void aGapEndsATorqueWithAStop()
    {
        World world;
        world.line.verdictTaken = true; // the board is unheard for long, and it is not told
        QVERIFY(world.connect());
        QVERIFY(pushes(world));
        QSignalSpy told(&world.session, &Session::interrupted);
        world.now += 1500ms;
        world.session.step(world.now);
        QVERIFY(world.ends(100ms));
        QVERIFY2(saysStop(world.outcomes[0]), world.outcomes[0].reason.c_str());
        QCOMPARE(told.size(), 1);
        const auto what = told[0][0].value<session::Interruption>();
        QVERIFY(what.disarmed && what.stopped);
        world.run(3s);
        QVERIFY(!world.line.isDriven());
    }

    void aGainMayBeWrittenMeanwhile()
    {
        World world;
        QVERIFY(world.connect());
        world.session.run(world.experiment());
        QVERIFY(world.steps());
        world.session.submit(
            {.id = 8, .what = drive::Write{{{world.id("SPEED_KP"), std::int64_t{2000}}}}});
        QVERIFY(world.ends());
        VERIFY_END(world, End::Complete);
    }

    /// At its end the old value comes back, over what was written meanwhile: so nothing of such a write leaves.
    void whatItHasBorrowedIsNotWrittenMeanwhile()
    {
        World world;
        QVERIFY(world.connect());
        const drive::RegisterId kp = world.id("SPEED_KP"), ki = world.id("SPEED_KI"),
                                other = world.id("SPEED_KD");
        const auto write = [&](drive::WishId wish, std::vector<drive::RegisterWrite> writes) {
            world.session.submit({.id = wish, .what = drive::Write{std::move(writes)}});
            const auto end = [&] {
                for (const drive::Ended &ended : world.all<drive::Ended>())
                    if (ended.id == wish)
                        return std::optional(ended);
                return std::optional<drive::Ended>();
            };
            return world.runUntil([&] { return end().has_value(); }, 5s) ? end() : std::nullopt;
        };
        const auto first = write(6, {{kp, std::int64_t{1900}}, {ki, std::int64_t{150}}});
        QVERIFY(first && first->writes.size() == 2 && first->writes[0].id == kp);
        const auto ownKp = std::get<std::int64_t>(first->writes[0].before.value());
        const auto ownKi = std::get<std::int64_t>(first->writes[1].before.value());
        const auto set = write(7, {{kp, ownKp + 1}, {ki, ownKi}});
        QVERIFY(set && set->writes.at(0).verified == true);

        const lab::Subject subject = *lab::subjectOf(*world.board(), 1);
        lab::ResponsePlan plan = lab::responsePlanFor(subject, {});
        plan.kp = 3 * int(ownKp) / 4;
        plan.ki = 3 * int(ownKi) / 4;
        plan.length = 4s;
        world.session.run({plan, subject});
        QVERIFY(world.runUntil([&] { return world.status->state == MotorState::Running; }, 20s));
        // Of a list, all of it.
        const auto refused = write(8, {{other, std::int64_t{0}}, {kp, ownKp + 2}});
        QVERIFY(refused && refused->outcome == drive::Outcome::Refused && refused->byProgram);
        QVERIFY2(refused->reason.find("lent") != std::string::npos, refused->reason.c_str());
        QVERIFY(refused->writes.empty());
        const auto taken = write(9, {{other, std::int64_t{0}}});
        QVERIFY(taken && taken->outcome == drive::Outcome::Ok);
        QVERIFY(world.ends(60s));
        VERIFY_END(world, End::Complete);

        const auto after = write(10, {{kp, ownKp + 2}});
        QVERIFY(after && after->writes.at(0).verified == true);
        QVERIFY(after->writes.at(0).before == catalog::Value(ownKp + 1)); // which came back
    }

    /// The Stop leaves within 25 ms; a session that lost it between two turns would let the motor run on.
    void aBrokenCapStopsTheMotor()
    {
        World world;
        QVERIFY(world.connect());
        world.session.run(world.experiment(
            {.fromRpm = 1000, .toRpm = 1500, .caps = {.maxSpeedRpm = 1500.0}})); // any overshoot
        QVERIFY(world.ends());
        VERIFY_END(world, End::Aborted);
        const TimePoint at = world.outcomes[0].at;
        QVERIFY(world.runUntil(
            [&] {
                const auto stops = world.all<drive::StopProgress>();
                return !stops.empty() && stops.back().word >= drive::StopWord::DriveIdle
                    && stops.back().word != drive::StopWord::NotConfirmed;
            },
            2s));
        const auto entries = world.all<drive::MotionEntry>();
        const auto stop = std::find_if(entries.begin(), entries.end(),
            [](const auto &entry) { return entry.act == drive::MotionAct::Stop; });
        QVERIFY(stop != entries.end());
        QVERIFY2(stop->asked - at <= 1ms, qPrintable(QString::number(toSeconds(stop->asked - at))));
        QVERIFY(world.idles());
        QVERIFY(!world.session.nextStep() || world.status->state == MotorState::Idle);
    }

    /// Two trips in a row end a series: here the first one does.
    void aTripDisarmsSoThatNothingFollowsIt()
    {
        World world;
        QVERIFY(world.connect());
        const auto tooTight =
            world.experiment({.fromRpm = 1000, .toRpm = 1500, .caps = {.maxSpeedRpm = 1500.0}});
        world.session.run(tooTight);
        QVERIFY(world.ends());
        VERIFY_END(world, End::Aborted);
        QVERIFY(world.idles());
        world.outcomes.clear();
        world.session.run(tooTight);
        QVERIFY(world.ends(10ms));
        VERIFY_END(world, End::Refused);
        QVERIFY(world.outcomes[0].reason.find("not armed") != std::string::npos);
        world.run(5s);
        QVERIFY(world.status->state == MotorState::Idle);
    }

    void closingEndsIt()
    {
        World world;
        QVERIFY(world.connect());
        world.session.run(world.experiment());
        QVERIFY(world.steps());
        world.session.stop();
        world.session.close();
        QVERIFY(world.runUntil([&] { return world.session.closed(); }, 5s));
        VERIFY_END(world, End::Interrupted);
    }

    /// What it drove is wanted stopped when the port is back, before anything else.
    void aLostPortLeavesAStopBehind()
    {
        World world;
        world.endpoint.kind = session::Endpoint::Kind::Serial;
        world.endpoint.path = QStringLiteral("bench");
        QVERIFY(world.connect());
        world.session.run(world.experiment());
        QVERIFY(world.steps());
        QSignalSpy wanted(&world.session, &Session::stopsWanted);
        world.line.plugged = false;
        QVERIFY(world.ends(5s));
        VERIFY_END(world, End::Lost);
        QVERIFY2(!wanted.isEmpty(), world.outcomes[0].reason.c_str());
        QVERIFY(world.outcomes[0].reason.find("told to stop") == std::string::npos); // not true
        QVERIFY(!wanted.last().first().toStringList().isEmpty());
        world.line.plugged = true; // it is opened again by itself
        QVERIFY(world.idles(10s));
    }
};

QTEST_GUILESS_MAIN(TestSessionExperiment)
#include "tst_session_experiment.moc"
