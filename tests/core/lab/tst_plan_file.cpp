// Plans from files, which are foreign: what they say is taken, and what they cannot mean is refused by its name.
#include "lab/plan_file.h"
#include "support/lab_bench.h"

using namespace lab;

class TestPlanFile : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itsNumbersStandOverTheUsualOnes()
    {
        const Subject &subject = m_bench.experiment.subject;
        const auto step =
            planOf("step", {{"from_rpm", 1000}, {"to_rpm", -500}, {"hold_ms", 300}}, subject, {});
        QVERIFY(step);
        QCOMPARE(std::get<StepPlan>(*step),
            (StepPlan{.fromRpm = 1000, .toRpm = -500, .hold = std::chrono::milliseconds(300)}));
        const auto spin = planOf("spin", {{"flux_a", 1.5}, {"seed", 7}}, subject, {});
        QVERIFY(spin);
        SpinPlan expected = spinPlanFor(subject, {});
        expected.fluxAmps = 1.5;
        expected.seed = 7;
        QCOMPARE(std::get<SpinPlan>(*spin), expected);
        const auto flux = planOf("current_step",
            {{"flux", 1}, {"from_a", 0.5}, {"to_a", -1}, {"rpm", 900}}, subject, {});
        QVERIFY(flux);
        CurrentStepPlan wanted = currentStepPlanFor(subject, true, 0.5, -1.0, {});
        wanted.rpm = 900;
        QCOMPARE(std::get<CurrentStepPlan>(*flux), wanted);
        const auto current = planOf("current_response", {{"length_ms", 8000}}, subject, {});
        QVERIFY(current);
        ResponsePlan loop = currentResponsePlanFor(subject, {});
        loop.length = std::chrono::milliseconds(8000);
        QCOMPARE(std::get<ResponsePlan>(*current), loop);
        const auto rest = planOf("rest", {}, subject, {});
        QVERIFY(rest);
        QCOMPARE(std::get<RestPlan>(*rest), restPlanFor(subject, {}));
        const auto response = planOf("response", {{"amplitude_rpm", 90}}, subject, {});
        QVERIFY(response);
        QCOMPARE(std::get<ResponsePlan>(*response).amplitudeRpm, 90);
        const auto power = planOf("power",
            {{"rpm", -900}, {"length_ms", 3000}, {"rs_ohm", 0.3}, {"dead_time_v", 0.4}}, subject,
            {});
        QVERIFY(power);
        PowerPlan held = powerPlanFor(subject, {});
        held.fromRpm = held.toRpm = -900;
        held.hold = std::chrono::milliseconds(1500);
        held.rsOhm = 0.3;
        held.deadVolts = 0.4;
        QCOMPARE(std::get<PowerPlan>(*power), held);
        const auto load = planOf("load", {{"rpm", 900}, {"length_ms", 4000}}, subject, {});
        QVERIFY(load);
        QCOMPARE(std::get<LoadPlan>(*load).toRpm, 900);
        QCOMPARE(std::get<LoadPlan>(*load).hold, std::chrono::milliseconds(2000));
        for (const char *key : {"rs_ohm", "dead_time_v"}) { // who does not know it leaves it out
            const auto below = planOf("power", {{key, -0.1}}, subject, {});
            QVERIFY(!below && below.error().find(key) != std::string::npos);
        }
    }

    /// As `step torque` has it: a motor that has no speed in the file turns the way that its torques push.
    void aTorqueBackwardsTurnsTheMotorBackwards()
    {
        const Subject &subject = m_bench.experiment.subject;
        const PlanNumbers torques{{"from_a", -0.5}, {"to_a", -1.5}};
        const auto backwards = planOf("current_step", torques, subject, {});
        QVERIFY(backwards);
        QCOMPARE(std::get<CurrentStepPlan>(*backwards),
            currentStepPlanFor(subject, false, -0.5, -1.5, {}));
        QVERIFY(std::get<CurrentStepPlan>(*backwards).rpm < 0);
        QCOMPARE(objectionTo(Experiment{*backwards, subject}), std::string());
        PlanNumbers withSpeed = torques;
        withSpeed.emplace_back("rpm", 900);
        const auto told = planOf("current_step", withSpeed, subject, {});
        QVERIFY(told);
        QCOMPARE(std::get<CurrentStepPlan>(*told).rpm, 900);
        PlanNumbers alongMagnets = torques;
        alongMagnets.emplace_back("flux", 1);
        const auto flux = planOf("current_step", alongMagnets, subject, {});
        QVERIFY(flux);
        QVERIFY(std::get<CurrentStepPlan>(*flux).rpm > 0);
    }

    void theUsualAmplitudeIsThatOfTheFilesSpeed()
    {
        const Subject &subject = m_bench.experiment.subject;
        const auto amplitude = [&](const char *kind, const PlanNumbers &numbers) {
            const auto plan = planOf(kind, numbers, subject, {});
            return plan ? std::get<ResponsePlan>(*plan).amplitudeRpm : -1;
        };
        for (const char *kind : {"response", "current_response"}) {
            QCOMPARE(amplitude(kind, {{"rpm", 3000}}), 90); // 3 %
            QCOMPARE(amplitude(kind, {{"rpm", -3000}}), 90);
            QCOMPARE(amplitude(kind, {{"rpm", 1000}}), 60); // ten digits
            QCOMPARE(amplitude(kind, {{"rpm", 3000}, {"amplitude_rpm", 70}}), 70);
        }
    }

    /// A plan whose proportional gain is 0 is one without gains: the board's own would be measured without a word.
    void gainsNeedAProportionalOne()
    {
        const Subject &subject = m_bench.experiment.subject;
        for (const char *kind : {"response", "current_response"}) {
            for (const double integral : {0.0, 500.0}) {
                const auto none =
                    planOf(kind, {{"speed_kp", 0}, {"speed_ki", integral}}, subject, {});
                QVERIFY(!none);
                QCOMPARE(
                    none.error(), std::string("its \"speed_kp\" is no number that can be meant"));
            }
            const auto both = planOf(kind, {{"speed_kp", 1}, {"speed_ki", 0}}, subject, {});
            QVERIFY(both);
            QCOMPARE(std::get<ResponsePlan>(*both).kp, 1);
        }
    }

    void ofTwoBoundsTheLowerOneCounts()
    {
        const Subject &subject = m_bench.experiment.subject;
        const drive::UserLimits own{.maxSpeedRpm = 2000.0, .maxCurrentAmps = 3.0};
        const auto wider = planOf("rest", {{"max_rpm", 9000}, {"max_a", 100}}, subject, own);
        QVERIFY(wider);
        QCOMPARE(std::get<RestPlan>(*wider).caps, own);
        const auto narrower = planOf("rest", {{"max_rpm", 1000}}, subject, own);
        QVERIFY(narrower);
        QCOMPARE(std::get<RestPlan>(*narrower).caps.maxSpeedRpm, 1000.0);
        const drive::UserLimits both{.maxSpeedRpm = 1000.0, .maxCurrentAmps = 0.3};
        const auto within = planOf("rest", {{"max_rpm", 1000}, {"max_a", 0.3}}, subject, own);
        QVERIFY(within);
        // What it leaves out, too.
        QCOMPARE(std::get<RestPlan>(*within), restPlanFor(subject, both));
        QCOMPARE(objectionTo(Experiment{*within, subject}), std::string());
    }

    void itsObjectionsNameTheBound()
    {
        const Subject &subject = m_bench.experiment.subject;
        const auto objection = [&](const char *kind, const PlanNumbers &numbers) {
            const auto plan = planOf(kind, numbers, subject, {});
            return plan ? objectionTo(Experiment{*plan, subject}) : plan.error();
        };
        QCOMPARE(objection("rest", {{"low_a", 0.1}, {"high_a", 0.5}, {"max_a", 0.3}}),
            std::string("0.5 A are more than the 0.3 A of your own limit"));
        QVERIFY(objection("rest", {{"low_a", 1}, {"high_a", 1e5}})
                    .ends_with(" A that a motor at rest is given here"));
        QCOMPARE(objection("response", {{"amplitude_rpm", 0}}),
            std::string("the speed has to go to and fro by 1 rpm or more"));
    }

    void whatHasNoUsualNumberIsNeeded_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("given");
        QTest::addColumn<QString>("needed");
        QTest::newRow("a speed to go to") << "step"
                                          << "from_rpm"
                                          << "to_rpm";
        QTest::newRow("a speed to come from") << "step"
                                              << "to_rpm"
                                              << "from_rpm";
        QTest::newRow("a current to go to") << "current_step"
                                            << "from_a"
                                            << "to_a";
        QTest::newRow("a current to come from") << "current_step"
                                                << "to_a"
                                                << "from_a";
        QTest::newRow("the other gain") << "response"
                                        << "speed_kp"
                                        << "speed_ki";
        QTest::newRow("of the current's, too") << "current_response"
                                               << "speed_ki"
                                               << "speed_kp";
    }
    void whatHasNoUsualNumberIsNeeded()
    {
        QFETCH(const QString, kind);
        QFETCH(const QString, given);
        QFETCH(const QString, needed);
        const Subject &subject = m_bench.experiment.subject;
        const auto planWith = [&](const PlanNumbers &numbers) {
            return planOf(kind.toStdString(), numbers, subject, {});
        };
        const auto plan = planWith({{given.toStdString(), 1}});
        QVERIFY(!plan);
        QCOMPARE(plan.error(), "its plan needs \"" + needed.toStdString() + '"');
        QVERIFY(planWith({{given.toStdString(), 1}, {needed.toStdString(), 2}}));
    }

    void whatIsNotKnownIsNamedWithWhatIs()
    {
        const Subject &subject = m_bench.experiment.subject;
        QCOMPARE(planOf("step", {{"from", 1500}, {"to_rpm", 1800}}, subject, {}).error(),
            std::string(
                "the key \"from\" is not known, its plan may have from_rpm, to_rpm, repeat, "
                "hold_ms, approach_ms, max_rpm, max_a"));
        const std::string kinds = planOf("autotune", {}, subject, {}).error();
        for (const char *kind : {"step", "current_step", "spin", "rest", "response",
                 "current_response", "power", "load", "position"}) {
            QVERIFY2(kinds.find(kind) != std::string::npos, kinds.c_str());
            const auto known = planOf(kind, {{"x", 1}}, subject, {}).error();
            QVERIFY2(known.starts_with("the key \"x\""), known.c_str());
        }
    }

    void whatItCannotMeanIsNamed_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("key");
        QTest::addColumn<double>("number");
        QTest::addColumn<QString>("named");
        QTest::newRow("kind") << "stop"
                              << "from_rpm" << 1.0 << "\"stop\"";
        QTest::newRow("key") << "step"
                             << "speed" << 1.0 << "\"speed\"";
        QTest::newRow("a register") << "rest"
                                    << "SPEED_KP" << 1.0 << "\"SPEED_KP\"";
        QTest::newRow("half a step") << "step"
                                     << "repeat" << 2.5 << "\"repeat\"";
        QTest::newRow("no number") << "step"
                                   << "from_rpm" << std::nan("") << "\"from_rpm\"";
        QTest::newRow("endless") << "rest"
                                 << "max_a" << 1e300 << "\"max_a\"";
        QTest::newRow("a bound of nothing") << "step"
                                            << "max_a" << 0.0 << "\"max_a\"";
        QTest::newRow("a bound below nothing") << "spin"
                                               << "max_rpm" << -1.0 << "\"max_rpm\"";
        QTest::newRow("a bound that is no number") << "response"
                                                   << "max_rpm" << std::nan("") << "\"max_rpm\"";
        QTest::newRow("neither yes nor no") << "current_step"
                                            << "flux" << 2.0 << "\"flux\"";
        QTest::newRow("no loop") << "response"
                                 << "current_loop" << -1.0 << "\"current_loop\"";
        QTest::newRow("a seed below 0") << "spin"
                                        << "seed" << -1.0 << "\"seed\"";
        QTest::newRow("half a seed") << "response"
                                     << "seed" << 0.5 << "\"seed\"";
        QTest::newRow("more than whole numbers hold") << "spin"
                                                      << "seed" << 1e12 << "\"seed\"";
        QTest::newRow("a time below 0") << "rest"
                                        << "hold_ms" << -400.0 << "\"hold_ms\"";
        QTest::newRow("a speed of nothing") << "step"
                                            << "from_rpm" << 2e6 << "\"from_rpm\"";
        QTest::newRow("a current of nothing") << "rest"
                                              << "high_a" << -1e300 << "\"high_a\"";
    }
    void whatItCannotMeanIsNamed()
    {
        QFETCH(const QString, kind);
        QFETCH(const QString, key);
        QFETCH(const double, number);
        QFETCH(const QString, named);
        const auto plan = planOf(
            kind.toStdString(), {{key.toStdString(), number}}, m_bench.experiment.subject, {});
        QVERIFY(!plan);
        QVERIFY2(plan.error().find(named.toStdString()) != std::string::npos, plan.error().c_str());
        if (key.toStdString() != "speed" && key.toStdString() != "SPEED_KP" && kind != "stop")
            QCOMPARE(
                plan.error(), "its " + named.toStdString() + " is no number that can be meant");
    }

private:
    const support::LabBench m_bench;
};

QTEST_APPLESS_MAIN(TestPlanFile)
#include "tst_plan_file.moc"
