// Experiments on a simulated board: what it measures, what bounds it, and what it leaves behind on every way out.
#include "simulation/plant/presets.h"
#include "support/lab_bench.h"

using namespace drive;
using lab::End;
using support::LabBench;
using namespace std::chrono_literals;

class TestRunner : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aStandingMotorIsStartedSteppedAndStopped();
    void aRunningMotorGoesBackToItsSpeed();
    void whatABoardAtRestGoesOnShowingIsSaid();
    void severalInARowShowWhatTheLastShows();
    void aStepThatIsAskedForTwiceIsOneRun();
    void whatMovedNothingIsLeftOut();
    void theSetPointOfBeforeIsNoStep();
    void theNumbersAreThoseOfTheRotor();
    void stepsArePlacedWithinAMillisecondHoweverTheHostStalls();
    void theWayToTheEnvelopeIsShort_data();
    void theWayToTheEnvelopeIsShort();
    void whatRunsTheWrongWayIsToldSo();
    void silenceBreaksIt();
    void aBoundThatIsNotLookedAtBreaksIt();
    void aHotBoardMovesNothing_data();
    void aHotBoardMovesNothing();
    void aTemperatureAtItsBoundIsBoundedFurther();
    void aBusThatIsNotReadMovesNothing();
    void aSeriesEndsInTimeHoweverSlowItsAnswersAre();
    void withoutASensorTheSpeedStaysAboveWhatItsObserverNeeds();
    void aStepToTheLevelThatIsProposedIsCarriedOut();
    void onlyABusThatWasSeenToTakeItIsBrakedOntoFast();
    void aFaultEndsItAndIsNamed();
    void aFaultOfTheStartIsNotOfTheExperiment();
    void whatWasBorrowedComesBackWhereNothingDisarms_data();
    void whatWasBorrowedComesBackWhereNothingDisarms();
    void whatEndsTheGivingBackIsSaidBehindTheFault();
    void whatIsNotReadAgainIsNotTakenForGivenBack();
    void aSetPointThatAFaultOvertookIsNamedAsItIsKnown_data();
    void aSetPointThatAFaultOvertookIsNamedAsItIsKnown();
    void aFaultWhileARotorCoastsIsNoStart();
    void aLostLinkStopsWhatMoves();
    void severalInARowEndBehindWhatOneLeaves();
    void whatIsNotAPlanMovesNothing_data();
    void whatIsNotAPlanMovesNothing();
    void aMotorInTorqueControlIsLeftAlone();
    void aMotorThatIsNotAtItsSetPointIsLeftAlone();
    void aRefusedStartLeavesTheMotorAlone();
    void aStartThatWasTakenAndAnsweredOtherwiseIsStopped();
    void aTorqueThatMayStillBeInForceIsSaid();
    void aWayBackThatWasOnlyAskedForIsSaid();
    void aStepThatWasOnlyAskedForIsSaid();
    void aBoardThatDoesNotObeyIsToldAtTheEnd();
    void aRotorThatTurnsOnIsWaitedFor_data();
    void aRotorThatTurnsOnIsWaitedFor();
    void somebodyElsesActEndsItWithoutAnother();
    void whatOnlyTheEnvelopeBoundsEndsWithAStop();
    void aStepThatIsCutShortTellsNothing();
    void whoDisarmsIsToldWhatDrivesOn();
    void boardsThatRecordNothingSayWhy();
    void whatABoardsSamplesLackIsNamed();
};

namespace {

/// What a start goes to.
Bytes setPoint(LabBench &bench)
{
    const RegisterId id = bench.pair.id("SPEED_RAMP");
    const WishId read = bench.pair.submit(Read{{id}});
    if (!bench.pair.runUntilEnded(read))
        return {};
    const auto *bytes = std::get_if<Bytes>(&bench.pair.values[id].value);
    return bytes == nullptr ? Bytes{} : *bytes;
}

/// The last ramp but one: behind it that of before is written again.
SpeedRamp wayBack(const LabBench &bench)
{
    const std::vector<SpeedRamp> ramps = bench.asked<SpeedRamp>();
    return ramps[ramps.size() - 2];
}

/// The runner is told something else of this register than the board says.
void retell(LabBench &bench, RegisterId id, std::function<void(Reading &)> change)
{
    bench.pair.onEvent = [id, change = std::move(change), handOn = bench.pair.onEvent](
                             Event event) {
        if (auto *read = std::get_if<RegistersRead>(&event))
            for (Reading &reading : read->readings)
                if (reading.id == id)
                    change(reading);
        handOn(event);
    };
}

/// Until its response is measured with three quarters of the gains that the board has.
bool respondsWithOtherGains(LabBench &bench)
{
    const lab::Registers &registers = bench.experiment.subject.registers;
    lab::ResponsePlan plan = lab::responsePlanFor(bench.experiment.subject, {});
    plan.kp = 3 * int(bench.number(registers.gain)) / 4;
    plan.ki = 3 * int(bench.number(registers.integral)) / 4;
    bench.experiment.plan = plan;
    bench.begin();
    return bench.runUntil([&] { return bench.asked<SpeedRamp>().size() >= 4; }, 40s);
}

bool askedForMotion(const LabBench &bench)
{
    return !bench.asked<SpeedRamp>().empty() || !bench.asked<Command>().empty();
}

} // namespace

void TestRunner::aStandingMotorIsStartedSteppedAndStopped()
{
    LabBench bench;
    const Bytes before = setPoint(bench);
    QCOMPARE(before.size(), 6U);
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Complete);
    QVERIFY2(outcome.reason.empty(), outcome.reason.c_str());
    QCOMPARE(bench.stops, 0);
    std::vector<int> steps;
    for (const SpeedRamp &ramp : bench.asked<SpeedRamp>())
        if (ramp.duration == 0ms)
            steps.push_back(ramp.rpm);
    steps.erase(steps.end() - 1); // the set-point of before
    QCOMPARE(steps, (std::vector<int>{1500, 1000, 1500, 1000}));
    QVERIFY(bench.pair.runUntilState(MotorState::Idle));
    QVERIFY(bench.pair.board->truth(1).idle);
    QCOMPARE(setPoint(bench), before);
    const auto series = bench.series();
    QVERIFY2(series, series ? "" : series.error().c_str());
    QCOMPARE(series->runs.size(), 4U);
    for (const lab::StepRun &run : series->runs)
        QVERIFY(run.found && run.rise_s && run.settling_s);
    QVERIFY(series->rise_s->low && *series->rise_s->low < *series->rise_s->high);
}

void TestRunner::aRunningMotorGoesBackToItsSpeed()
{
    LabBench bench;
    QVERIFY(bench.pair.runAt(1800));
    bench.pair.runFor(1s);
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Complete);
    QCOMPARE(outcome.reason, std::string());
    QVERIFY(!outcome.shows);
    QVERIFY(bench.pair.board->truth(1).driven);
    QVERIFY2(std::abs(bench.pair.board->truth(1).rpm - 1800.0) < 60.0,
        qPrintable(QString::number(bench.pair.board->truth(1).rpm)));
    for (const Command &command : bench.asked<Command>())
        QVERIFY(command.action != MotorAction::Start && command.action != MotorAction::StopMotor);
}

/// Its start goes where it went before, and nothing is moved for the sake of a register.
void TestRunner::whatABoardAtRestGoesOnShowingIsSaid()
{
    LabBench bench;
    const RegisterId reference = bench.experiment.subject.registers.speedReference;
    const Bytes before = setPoint(bench);
    const double showed = bench.number(reference);
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Complete);
    QVERIFY(outcome.reason.empty() && !outcome.leaves);
    QVERIFY(bench.pair.runUntilState(MotorState::Idle));
    QCOMPARE(setPoint(bench), before);
    const double shows = bench.number(reference);
    QCOMPARE(shows, 996.0); // the last step, in digits of 6 rpm
    QVERIFY(showed != shows);
    QVERIFY((outcome.shows == lab::ShownReference{"SPEED_REF", showed, shows}));
    QVERIFY2(lab::shownText(outcome).starts_with("SPEED_REF shows 996 rpm until the next start"),
        lab::shownText(outcome).c_str());

    const lab::Outcome again = bench.run(); // it shows the same before and afterwards
    VERIFY_END(again, End::Complete);
    QVERIFY(again.shows && lab::shownText(again).empty());
}

void TestRunner::severalInARowShowWhatTheLastShows()
{
    const auto shows = [](double before_rpm, double now_rpm) {
        lab::Outcome outcome;
        outcome.shows = lab::ShownReference{"SPEED_REF", before_rpm, now_rpm};
        return outcome;
    };
    QVERIFY(lab::inRow(shows(0, 900), shows(900, 1200), false) == shows(0, 1200));
    QVERIFY(lab::inRow({}, shows(0, 900), false) == shows(0, 900));
    QVERIFY(!lab::inRow(shows(0, 900), {}, false).shows); // it was not read since
    QCOMPARE(lab::shownText(shows(900, 1200)),
        std::string("SPEED_REF shows 1200 rpm until the next start, it showed 900 rpm"));
    QCOMPARE(lab::shownText(lab::inRow(shows(900, 0), shows(0, 900), false)), std::string());
}

/// What is read before it is sent got no answer: it is asked for again. That moved nothing, and is no run of the
/// series.
void TestRunner::aStepThatIsAskedForTwiceIsOneRun()
{
    LabBench bench;
    std::optional<TimePoint> since;
    bench.pair.loses = [&](const Bytes &bytes) { // requests only: the link stays
        if (!since && bench.asked<SpeedRamp>().size() == 4)
            since = bench.pair.now;
        const bool request = (bytes.front() & 0x0FU) == 0x09U;
        return request && since && bench.pair.now - *since < 400ms;
    };
    VERIFY_END(bench.run(), End::Complete);
    // Twice to the first speed, four steps, the set-point of before.
    constexpr std::size_t kWithout = 7;
    QVERIFY(bench.asked<SpeedRamp>().size() > kWithout);
    const auto series = bench.series();
    QVERIFY(series);
    QCOMPARE(series->runs.size(), 4U);
    for (const lab::StepRun &run : series->runs) // samples were lost with the requests
        QVERIFY(run.found || run.unusable == scope::WhyNot::GapInside);
}

void TestRunner::whatMovedNothingIsLeftOut()
{
    const recorded::Happening ramp{"speed ramp", {{"wish", "7"}}};
    const auto ended = [](const char *outcome) {
        return recorded::Happening{"ended", {{"wish", "7"}, {"outcome", outcome}}};
    };
    const lab::Happenings carried = lab::carriedOut({{1, ramp}, {2, ended("refused")}, {3, ramp},
        {4, {"motion", {{"outcome", "not sent"}}}}, {5, ended("not sent")}, {6, ramp},
        {7, {"motion", {{"outcome", "ok"}}}}, {8, ended("unknown")}, {9, ramp}});
    std::vector<lab::Nanos> left;
    for (const auto &[at, what] : carried)
        left.push_back(at);
    QCOMPARE(left, (std::vector<lab::Nanos>{2, 5, 6, 7, 8, 9}));
}

void TestRunner::theSetPointOfBeforeIsNoStep()
{
    LabBench bench;
    QVERIFY(bench.pair.runUntilEnded(bench.pair.submit(SpeedRamp{1, 1500, 0ms})));
    VERIFY_END(bench.run(), End::Complete);
    QCOMPARE(bench.asked<SpeedRamp>().back().duration, 0ms);
    const auto series = bench.series();
    QVERIFY(series);
    QCOMPARE(series->runs.size(), 4U);
}

/// The board knows its rotor: looked at every 250 us, its rise and overshoot are those that were measured.
void TestRunner::theNumbersAreThoseOfTheRotor()
{
    LabBench bench;
    bench.steps.repeat = 1;
    std::vector<std::pair<TimePoint, simulation::MotorTruth>> truth;
    bench.eachTurn = [&] { truth.emplace_back(bench.pair.now, bench.pair.board->truth(1)); };
    VERIFY_END(bench.run(), End::Complete);
    const auto series = bench.series();
    QVERIFY(series && series->runs.size() == 2);
    const auto stepped = std::find_if(truth.begin(), truth.end(),
        [](const auto &one) { return one.second.referenceRpm > 1400.0; });
    QVERIFY(stepped != truth.end());
    const auto when = [&](double rpm) {
        return std::find_if(stepped, truth.end(), [rpm](const auto &one) {
            return one.second.rpm >= rpm;
        })->first;
    };
    const double base = 1000.0, size = 500.0;
    const double rise = toSeconds(when(base + 0.9 * size) - when(base + 0.1 * size));
    double highest = 0.0;
    for (auto at = stepped; at != truth.end(); ++at)
        highest = std::max(highest, at->second.rpm);
    const lab::StepRun &up = series->runs.front();
    QVERIFY2(std::abs(*up.rise_s - rise) < 0.05 * rise,
        qPrintable(QStringLiteral("%1 %2").arg(*up.rise_s).arg(rise)));
    const double overshoot = (highest - base - size) / size * 100.0;
    QVERIFY2(std::abs(*up.overshoot_pct - overshoot) < 2.0,
        qPrintable(QStringLiteral("%1 %2").arg(*up.overshoot_pct).arg(overshoot)));
}

/// The time of a sample lags the board's clock by the same in a whole stream: what differs from step to step is how
/// well each was placed.
void TestRunner::stepsArePlacedWithinAMillisecondHoweverTheHostStalls()
{
    std::vector<double> late_ms;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        LabBench bench(support::servo(seed), seed);
        support::Random random(seed);
        bench.steps.repeat = 4;
        std::vector<TimePoint> instants;
        double reference = 0.0;
        bench.eachTurn = [&] {
            bench.held = std::chrono::milliseconds(random.below(300));
            const double now = bench.pair.board->truth(1).referenceRpm;
            if (std::abs(now - reference) > 400.0 && std::min(now, reference) > 900.0)
                instants.push_back(bench.pair.now);
            reference = now;
        };
        VERIFY_END(bench.run(), End::Complete);
        const auto series = bench.series();
        QVERIFY(series && series->runs.size() == 8);
        QVERIFY(instants.size() >= 8);
        std::vector<double> offsets;
        for (std::size_t i = 0; i < 8; ++i) {
            QVERIFY(series->runs[i].found);
            offsets.push_back(
                double(series->runs[i].at - instants[i].time_since_epoch().count()) * 1e-6);
        }
        const auto [least, most] = std::minmax_element(offsets.begin(), offsets.end());
        late_ms.push_back(*most - *least);
    }
    for (const double spread : late_ms)
        QVERIFY2(spread <= 2.0, qPrintable(QString::number(spread))); // 1 ms to either side
}

void TestRunner::theWayToTheEnvelopeIsShort_data()
{
    QTest::addColumn<QString>("cap");
    for (const char *cap : {"current", "speed", "bus"})
        QTest::addRow("%s", cap) << cap;
}

/// From the sample that breaks a cap to the STOP on the wire.
void TestRunner::theWayToTheEnvelopeIsShort()
{
    QFETCH(const QString, cap);
    LabBench bench;
    bench.steps.toRpm = 2500;
    if (cap == QLatin1String("current"))
        bench.steps.caps.maxCurrentAmps = 2.0;
    else if (cap == QLatin1String("speed"))
        bench.steps.caps.maxSpeedRpm = 2500.0; // any overshoot
    else
        bench.steps.toRpm = 3400; // braking from there lifts the bus
    std::optional<TimePoint> broken;
    const auto isBroken = [&](const Event &event) {
        if (const auto *read = std::get_if<RegistersRead>(&event)) {
            for (const Reading &reading : read->readings)
                if (reading.id == bench.experiment.subject.registers.bus
                    && asNumber(reading.value).value_or(0.0) > 27.5) // 1.1 of 25 V: 24 are read
                    return cap == QLatin1String("bus");
            return false;
        }
        const auto *block = std::get_if<capture::SampleBlock>(&event);
        if (block == nullptr || cap == QLatin1String("bus"))
            return false;
        const std::size_t column = cap == QLatin1String("current") ? 1 : 2;
        const auto scale = bench.experiment.subject.catalog->streamScale(column == 1
                ? bench.experiment.subject.registers.current
                : bench.experiment.subject.registers.speed);
        const double most = column == 1 ? 2.0 : 2500.0;
        for (std::size_t i = 0; i < block->count; ++i)
            if (std::abs(block->fast[column * block->count + i] * scale.factor) > most)
                return true;
        return false;
    };
    const auto listen = bench.pair.onEvent;
    bench.pair.onEvent = [&](const Event &event) {
        if (!broken && bench.runner && !bench.asked<Command>().empty() && isBroken(event))
            broken = bench.pair.now;
        listen(event);
    };
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Aborted);
    QCOMPARE(bench.stops, 1);
    QVERIFY2(broken, qPrintable(support::outcomeText(outcome)));
    const std::size_t asked = support::count(bench.pair.requests, mcp::CommandId::StopMotor);
    QVERIFY(bench.pair.runUntil(
        [&] { return support::count(bench.pair.requests, mcp::CommandId::StopMotor) > asked; },
        100ms));
    QVERIFY2(bench.pair.now - *broken <= 25ms,
        qPrintable(QString::number(toSeconds(bench.pair.now - *broken))));
    QVERIFY(bench.pair.runUntil([&] { return bench.pair.hasStopWord(StopWord::DriveIdle); }, 2s));
    const std::size_t wishes = bench.wishes.size();
    bench.runUntil([] { return false; }, 500ms);
    QCOMPARE(bench.wishes.size(), wishes); // it is over
    QVERIFY(QString::fromStdString(outcome.reason).contains(QStringLiteral("allowed")));
}

/// An encoder that a brake has kept from being aligned turns its motor backward.
void TestRunner::whatRunsTheWrongWayIsToldSo()
{
    simulation::BoardOptions options = support::servo();
    options.plant = *simulation::findPreset(options.motor);
    const auto &motor = options.plant->motor;
    options.plant->load.constant_nm +=
        0.25 * 1.5 * motor.polePairs * motor.flux_wb * motor.nominal_a;
    int backward = 0;
    for (options.seed = 1; options.seed <= 20 && backward == 0; ++options.seed) {
        LabBench bench(options, options.seed);
        bench.pair.verdictTaken = true;
        bench.experiment.plan = lab::spinPlanFor(bench.experiment.subject, {});
        const lab::Outcome outcome = bench.run();
        const QString reason = QString::fromStdString(outcome.reason);
        const bool back = reason.startsWith(QStringLiteral("a speed of -"));
        QCOMPARE(
            reason.contains(QStringLiteral("rpm that are allowed, and the wrong way: ")), back);
        backward += back ? 1 : 0;
    }
    QCOMPARE(backward, 1);
}

void TestRunner::silenceBreaksIt()
{
    LabBench bench;
    bench.begin();
    QVERIFY(bench.runUntil([&] { return bench.asked<SpeedRamp>().size() >= 3; }, 20s));
    bench.pair.board->mute(5s);
    const TimePoint since = bench.pair.now;
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 5s));
    VERIFY_END(bench.runner->outcome(), End::Aborted);
    QVERIFY2(bench.runner->outcome().reason.starts_with("no samples came for 0.5 s"),
        bench.runner->outcome().reason.c_str());
    QVERIFY2(bench.pair.now - since <= 510ms,
        qPrintable(QString::number(toSeconds(bench.pair.now - since))));
    bench.turn();
    QCOMPARE(bench.stops, 1);
    bench.pair.runFor(6s);
}

/// A bus that is not read may be at any voltage.
void TestRunner::aBoundThatIsNotLookedAtBreaksIt()
{
    LabBench bench;
    bench.begin();
    QVERIFY(bench.runUntil([&] { return bench.asked<SpeedRamp>().size() >= 3; }, 20s));
    bench.pair.submit(Watch{});
    const TimePoint since = bench.pair.now;
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 5s));
    VERIFY_END(bench.runner->outcome(), End::Aborted);
    QVERIFY2(bench.pair.now - since <= 610ms,
        qPrintable(QString::number(toSeconds(bench.pair.now - since))));
    QVERIFY2(bench.runner->outcome().reason.starts_with("the bus voltage was not read for 0.6 s"),
        bench.runner->outcome().reason.c_str());
    bench.turn();
    QCOMPARE(bench.stops, 1);
}

void TestRunner::aHotBoardMovesNothing_data()
{
    QTest::addColumn<int>("celsius");
    QTest::addColumn<bool>("refused");
    QTest::newRow("hot") << 84 << false;
    QTest::newRow("too hot") << 85 << true;
    QTest::newRow("about to burn") << 199 << true;
    QTest::newRow("without a sensor") << 200 << false;
}

void TestRunner::aHotBoardMovesNothing()
{
    QFETCH(const int, celsius);
    QFETCH(const bool, refused);
    LabBench bench;
    bench.steps.repeat = 1;
    retell(bench, bench.experiment.subject.registers.temperature,
        [&](Reading &reading) { reading.value = std::int64_t{celsius}; });
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, refused ? End::Refused : End::Complete);
    QCOMPARE(askedForMotion(bench), !refused);
    QCOMPARE(bench.stops, 0);
    if (refused)
        QCOMPARE(outcome.reason,
            "the board is at " + std::to_string(celsius)
                + " \u00b0C, and 85 \u00b0C end an experiment: let it cool down first");
}

/// It warms up to its bound while the motor starts, and beyond it later.
void TestRunner::aTemperatureAtItsBoundIsBoundedFurther()
{
    LabBench bench;
    retell(bench, bench.experiment.subject.registers.temperature, [&](Reading &reading) {
        reading.value = std::int64_t{bench.asked<SpeedRamp>().size() >= 4 ? 86
                : !bench.asked<Command>().empty()                         ? 85
                                                                          : 84};
    });
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Aborted);
    QVERIFY2(outcome.reason.starts_with("a temperature of 86 \u00b0C is above the 85 \u00b0C"),
        outcome.reason.c_str());
    bench.turn();
    QCOMPARE(bench.stops, 1);
}

/// The board has the register and does not give it: nothing would bound what a step down lifts.
void TestRunner::aBusThatIsNotReadMovesNothing()
{
    LabBench bench;
    retell(bench, bench.experiment.subject.registers.bus,
        [](Reading &reading) { reading.status = ReadStatus::Refused; });
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Refused);
    QCOMPARE(outcome.reason,
        std::string("the board does not give BUS_VOLTAGE, and without it nothing bounds its bus"));
    QVERIFY(!askedForMotion(bench));
    QCOMPARE(bench.stops, 0);
}

/// A speed is held from its answer on: 200 answers of 0.3 s each would take a minute more than the plan.
void TestRunner::aSeriesEndsInTimeHoweverSlowItsAnswersAre()
{
    LabBench bench;
    bench.steps.repeat = 100;
    bench.steps.hold = 50ms;
    bench.held = 300ms;
    std::optional<TimePoint> runs;
    bench.eachTurn = [&] {
        if (!runs && bench.asked<SpeedRamp>().size() == 2) // to the first speed
            runs = bench.pair.now;
    };
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Aborted);
    // Ten for the steps, sixteen for the ways there and back, five for the answers.
    QVERIFY2(outcome.reason.starts_with("it was not over within 31 s; "), outcome.reason.c_str());
    QVERIFY(runs && bench.pair.now - *runs <= 31s && bench.pair.now - *runs > 30s);
    bench.turn();
    QCOMPARE(bench.stops, 1);
    QVERIFY(bench.pair.runUntil([&] { return bench.pair.board->truth(1).idle; }, 2s));
}

/// Refused, with a level that would do.
static void noStepEndsWhereItUndershootsThat(LabBench &bench)
{
    const auto least = static_cast<int>(bench.experiment.subject.leastObservedRpm());
    const auto objection = [&](int from, int to) {
        return lab::objectionTo(
            {lab::StepPlan{.fromRpm = from, .toRpm = to}, bench.experiment.subject});
    };
    for (const int way : {1, -1}) {
        QVERIFY(objection(way * (least + 41), way * (least + 341))
                    .starts_with("keep both speeds at " + std::to_string(least + 84) + " rpm"));
        QVERIFY(objection(way * (least + 341), way * (least + 41)).find("a step to 1241 rpm")
            != std::string::npos);
        QCOMPARE(objection(way * (least + 43), way * (least + 343)), std::string());
        QCOMPARE(objection(way * (least + 84), way * (least + 300)), std::string());
    }
    bench.steps = {.fromRpm = least, .toRpm = least + 300};
    VERIFY_END(bench.run(), End::Refused);
    QVERIFY(bench.wishes.empty());
    const LabBench seen; // an encoder sees it at any speed
    QCOMPARE(
        lab::objectionTo({lab::StepPlan{.fromRpm = 10, .toRpm = 300}, seen.experiment.subject}),
        std::string());
}

/// The level that is proposed does.
void TestRunner::aStepToTheLevelThatIsProposedIsCarriedOut()
{
    simulation::BoardOptions options;
    options.motor = "pm24";
    LabBench bench(options);
    const auto least = static_cast<int>(bench.experiment.subject.leastObservedRpm());
    bench.steps = {.fromRpm = least + 84, .toRpm = least + 384};
    VERIFY_END(bench.run(), End::Complete);
}

/// Twice the least speed at which it starts: 0.3 of the greatest, where nothing else is told.
void TestRunner::withoutASensorTheSpeedStaysAboveWhatItsObserverNeeds()
{
    simulation::BoardOptions options;
    options.motor = "pm24";
    {
        LabBench bench(options);
        const double least = bench.experiment.subject.leastObservedRpm();
        QCOMPARE(least, 0.3 * bench.experiment.subject.limits.maxSpeedRpm);
        for (const auto &[from, to] :
            {std::pair(least - 10.0, least + 600.0), std::pair(-least - 600.0, -least + 10.0),
                std::pair(least + 600.0, -least - 600.0)}) {
            bench.steps.fromRpm = static_cast<int>(from);
            bench.steps.toRpm = static_cast<int>(to);
            VERIFY_END(bench.run(), End::Refused);
            QVERIFY2(bench.runner->outcome().reason.find("has no sensor") != std::string::npos,
                bench.runner->outcome().reason.c_str());
        }
        QVERIFY(bench.wishes.empty());
        noStepEndsWhereItUndershootsThat(bench);
        const lab::SpinPlan spin = lab::spinPlanFor(bench.experiment.subject, {});
        QVERIFY(spin.lowRpm > least && lab::objectionTo({spin, bench.experiment.subject}).empty());
        QCOMPARE(LabBench().experiment.subject.leastObservedRpm(), 0.0); // an encoder sees it
    }
    LabBench bench(options);
    const double least = bench.experiment.subject.leastObservedRpm();
    bench.steps.fromRpm = static_cast<int>(least) + 300;
    bench.steps.toRpm = bench.steps.fromRpm + 600;
    bench.begin();
    QVERIFY(bench.runUntil([&] { return bench.asked<SpeedRamp>().size() >= 4; }, 30s));
    bench.pair.board->setLoadTorque(1, 0.5); // the motor slows down, whatever it is asked for
    double slowest = 1e9;
    bench.eachTurn = [&] { slowest = std::min(slowest, bench.pair.board->truth(1).rpm); };
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 30s));
    VERIFY_END(bench.runner->outcome(), End::Aborted);
    const std::string bound =
        "is below the " + std::to_string(std::lround(least)) + " rpm that are allowed";
    QVERIFY2(bench.runner->outcome().reason.find(bound) != std::string::npos,
        bench.runner->outcome().reason.c_str());
    bench.turn();
    QCOMPARE(bench.stops, 1);
}

void TestRunner::onlyABusThatWasSeenToTakeItIsBrakedOntoFast()
{
    {
        LabBench bench; // steps between 1000 and 1500 rpm brake more than the way to 1400 and back
        QVERIFY(bench.pair.runAt(1400));
        bench.pair.runFor(1s);
        VERIFY_END(bench.run(), End::Complete);
        QVERIFY(wayBack(bench).duration == 500ms);
    }
    LabBench bench;
    QVERIFY(bench.pair.runAt(600)); // from 1000 to there more is given back than by any step
    bench.pair.runFor(1s);
    bench.steps.toRpm = 1100;
    VERIFY_END(bench.run(), End::Complete);
    QVERIFY(wayBack(bench).duration == 3s);
}

void TestRunner::aFaultEndsItAndIsNamed()
{
    LabBench bench;
    bench.begin();
    QVERIFY(bench.runUntil([&] { return bench.asked<SpeedRamp>().size() >= 3; }, 20s));
    bench.runUntil([] { return false; }, 100ms); // the step was answered
    bench.pair.board->setFaults(0x0040);
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 5s));
    VERIFY_END(bench.runner->outcome(), End::Aborted);
    QVERIFY2(bench.runner->outcome().reason.find("BREAK_IN") != std::string::npos
            || bench.runner->outcome().reason.find("OVER_CURR") != std::string::npos,
        bench.runner->outcome().reason.c_str());
    QVERIFY(bench.runner->outcome().reason.find("set-point is 1500 rpm now") != std::string::npos);
    QVERIFY(bench.runner->outcome().reason.starts_with("the board reports a fault: "));
}

void TestRunner::aFaultOfTheStartIsNotOfTheExperiment()
{
    LabBench bench;
    bench.begin();
    QVERIFY(bench.runUntil([&] { return bench.pair.board->truth(1).driven; }, 20s));
    bench.pair.board->setFaults(0x0040);
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 5s));
    VERIFY_END(bench.runner->outcome(), End::Aborted);
    QVERIFY2(bench.runner->outcome().reason.starts_with(
                 "the motor did not get to its first speed: the board reports a fault: "),
        bench.runner->outcome().reason.c_str());
}

void TestRunner::whatWasBorrowedComesBackWhereNothingDisarms_data()
{
    QTest::addColumn<bool>("fault");
    QTest::newRow("a fault") << true;
    QTest::newRow("somebody else's stop") << false;
}

/// The set-point does not: behind a fault only a fresh act changes it.
void TestRunner::whatWasBorrowedComesBackWhereNothingDisarms()
{
    QFETCH(const bool, fault);
    LabBench bench;
    const lab::Registers registers = bench.experiment.subject.registers;
    const double kp = bench.number(registers.gain), ki = bench.number(registers.integral);
    QVERIFY(respondsWithOtherGains(bench));
    QCOMPARE(bench.asked<Write>().size(), 1U);
    if (fault)
        bench.pair.board->setFaults(0x0040);
    else
        bench.pair.submit(Command{MotorAction::StopMotor, 1});
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 10s));
    const lab::Outcome outcome = bench.runner->outcome();
    VERIFY_END(outcome, fault ? End::Aborted : End::Interrupted);
    QVERIFY2(outcome.reason.starts_with(
                 fault ? "the board reports a fault: " : "something else stopped the motor"),
        outcome.reason.c_str());
    QVERIFY2(outcome.reason.find("may hold") == std::string::npos, outcome.reason.c_str());
    QCOMPARE(bench.stops, 0);
    QVERIFY(std::holds_alternative<Read>(bench.wishes.back().what)); // and looks at it
    QVERIFY(std::holds_alternative<Write>(bench.wishes[bench.wishes.size() - 2].what));
    QCOMPARE(bench.asked<Write>().size(), 2U);
    QCOMPARE(bench.number(registers.gain), kp);
    QCOMPARE(bench.number(registers.integral), ki);
}

/// And it stays what ended it.
void TestRunner::whatEndsTheGivingBackIsSaidBehindTheFault()
{
    for (const bool lost : {false, true}) {
        LabBench bench;
        QVERIFY(respondsWithOtherGains(bench));
        bench.pair.board->setFaults(0x0040);
        QVERIFY(bench.runUntil([&] { return bench.asked<Write>().size() == 2; }, 5s));
        QVERIFY(!bench.runner->over());
        if (lost)
            bench.runner->lose("the port was lost");
        else
            bench.runner->stopped();
        const lab::Outcome outcome = bench.runner->outcome();
        VERIFY_END(outcome, End::Aborted);
        const char *then = lost ? "; then the port was lost; " : "; then every motor was stopped; ";
        QVERIFY2(outcome.reason.starts_with("the board reports a fault: ")
                && outcome.reason.find(then) != std::string::npos
                && outcome.reason.find("SPEED_KP may hold what the experiment wrote")
                    != std::string::npos,
            outcome.reason.c_str());
        QVERIFY(!bench.runner->takeStop());
    }
}

/// The board tells the gain before, and from then on no more.
void TestRunner::whatIsNotReadAgainIsNotTakenForGivenBack()
{
    int told = 0; // outlives the bench, which asks for it
    LabBench bench;
    retell(bench, bench.experiment.subject.registers.gain, [&](Reading &reading) {
        if (bench.runner && ++told > 1)
            reading.status = ReadStatus::Refused;
    });
    QVERIFY(respondsWithOtherGains(bench));
    bench.pair.board->setFaults(0x0040);
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 10s));
    const lab::Outcome outcome = bench.runner->outcome();
    VERIFY_END(outcome, End::Aborted);
    QCOMPARE(bench.asked<Write>().size(), 2U);
    QVERIFY2(outcome.leaves
            && outcome.reason.find("SPEED_KP may hold what the experiment wrote")
                != std::string::npos,
        outcome.reason.c_str());
}

void TestRunner::aSetPointThatAFaultOvertookIsNamedAsItIsKnown_data()
{
    QTest::addColumn<bool>("reads");
    QTest::newRow("the giving back is refused") << false;
    QTest::newRow("it is read behind it") << true;
}

/// The fault comes while a ramp is on its way; how that ends is not waited for.
void TestRunner::aSetPointThatAFaultOvertookIsNamedAsItIsKnown()
{
    QFETCH(const bool, reads);
    LabBench bench;
    QVERIFY(respondsWithOtherGains(bench));
    const auto *ramp = std::get_if<SpeedRamp>(&bench.wishes.back().what);
    QVERIFY(ramp != nullptr && !bench.pair.ended.contains(bench.wishes.back().id));
    const std::string rpm = std::to_string(ramp->rpm) + " rpm";
    drive::MotorStatus fault = bench.pair.status[1];
    fault.state = MotorState::FaultNow;
    fault.faultsNow = {"OVER_CURR"};
    bench.runner->accept(fault, bench.pair.now);
    QVERIFY(!bench.runner->over());
    if (reads) {
        QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 10s));
    } else {
        const std::vector<drive::Wish> wishes = bench.runner->takeWishes();
        QVERIFY(wishes.size() == 1 && std::holds_alternative<Write>(wishes.front().what));
        bench.runner->accept(
            drive::Ended{wishes.front().id, drive::Outcome::Refused, "RO_REG", {}}, bench.pair.now);
    }
    const lab::Outcome outcome = bench.runner->outcome();
    VERIFY_END(outcome, End::Aborted);
    QVERIFY2(outcome.reason.find("the set-point " + std::string(reads ? "is " : "may be ") + rpm)
            != std::string::npos,
        outcome.reason.c_str());
}

/// Without a sensor four seconds are waited before its start.
void TestRunner::aFaultWhileARotorCoastsIsNoStart()
{
    simulation::BoardOptions options;
    options.motor = "pm24";
    LabBench bench(options);
    const auto least = static_cast<int>(bench.experiment.subject.leastObservedRpm());
    bench.steps = {.fromRpm = least + 84, .toRpm = least + 384};
    bench.ranAt = bench.pair.now;
    bench.begin();
    bench.runUntil([&] { return bench.runner->over(); }, 1s);
    QVERIFY(!bench.runner->over() && !askedForMotion(bench));
    bench.pair.board->setFaults(0x0040);
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 2s));
    const lab::Outcome outcome = bench.runner->outcome();
    VERIFY_END(outcome, End::Refused);
    QVERIFY2(outcome.reason.starts_with("the board reports a fault: "), outcome.reason.c_str());
    QVERIFY(!askedForMotion(bench));
}

void TestRunner::aLostLinkStopsWhatMoves()
{
    LabBench bench;
    bench.begin();
    QVERIFY(bench.runUntil([&] { return bench.asked<SpeedRamp>().size() >= 3; }, 20s));
    bench.pair.toDrive.cut = bench.pair.toBoard.cut = true;
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 10s));
    VERIFY_END(bench.runner->outcome(), End::Aborted);
    bench.turn();
    QCOMPARE(bench.stops, 1);
    bench.pair.toDrive.cut = bench.pair.toBoard.cut = false;
    QVERIFY(bench.pair.runUntil([&] { return bench.pair.board->truth(1).idle; }, 10s));
}

void TestRunner::severalInARowEndBehindWhatOneLeaves()
{
    const lab::Outcome fine{.reason = "no answer came in time"};
    const lab::Outcome left{
        .reason = "REVUP_DATA may hold what the experiment wrote", .leaves = true};
    const lab::Outcome first = lab::inRow({}, fine, true);
    QVERIFY(first.end == End::Complete && first.reason == fine.reason && !first.leaves);
    const lab::Outcome ended = lab::inRow(first, left, true);
    QVERIFY(ended.end == End::Interrupted && ended.leaves);
    QCOMPARE(ended.reason, fine.reason + "; " + left.reason + "; what comes next was not begun");
    const lab::Outcome last = lab::inRow(first, left, false); // nothing comes next
    QVERIFY(last.end == End::Complete && last.leaves);
    QCOMPARE(last.reason, fine.reason + "; " + left.reason);
    const lab::Outcome stopped =
        lab::inRow(first, {End::Interrupted, "every motor was stopped"}, true);
    QVERIFY(stopped.end == End::Interrupted && !stopped.leaves);
    QCOMPARE(stopped.reason, fine.reason + "; every motor was stopped");
}

void TestRunner::whatIsNotAPlanMovesNothing_data()
{
    QTest::addColumn<lab::StepPlan>("plan");
    QTest::newRow("no step") << lab::StepPlan{.fromRpm = 1000, .toRpm = 1000};
    QTest::newRow("too fast") << lab::StepPlan{.fromRpm = 1000, .toRpm = 100'000};
    QTest::newRow("backwards too fast") << lab::StepPlan{.fromRpm = 1000, .toRpm = -100'000};
    QTest::newRow("beyond one's own")
        << lab::StepPlan{.fromRpm = 1000, .toRpm = 1500, .caps = {.maxSpeedRpm = 1400.0}};
    QTest::newRow("none") << lab::StepPlan{.fromRpm = 1000, .toRpm = 1500, .repeat = 0};
    QTest::newRow("too many") << lab::StepPlan{.fromRpm = 1000, .toRpm = 1500, .repeat = 1'000'000};
    QTest::newRow("too long") << lab::StepPlan{
        .fromRpm = 1000, .toRpm = 1500, .repeat = 20, .hold = 5s};
    QTest::newRow("held for nothing") << lab::StepPlan{.fromRpm = 1000, .toRpm = 1500, .hold = 0ms};
    QTest::newRow("reached at once")
        << lab::StepPlan{.fromRpm = 1000, .toRpm = 1500, .approach = 0ms};
}

void TestRunner::whatIsNotAPlanMovesNothing()
{
    QFETCH(const lab::StepPlan, plan);
    LabBench bench;
    bench.steps = plan;
    VERIFY_END(bench.run(), End::Refused);
    QVERIFY(!bench.runner->outcome().reason.empty());
    QVERIFY(bench.wishes.empty());
    QCOMPARE(bench.stops, 0);
}

void TestRunner::aMotorInTorqueControlIsLeftAlone()
{
    LabBench bench;
    QVERIFY(bench.pair.runAt(1500));
    QVERIFY(bench.pair.runUntilEnded(bench.pair.submit(TorqueRamp{1, 1.0, 100ms})));
    VERIFY_END(bench.run(), End::Refused);
    QVERIFY(bench.asked<SpeedRamp>().empty() && bench.asked<Command>().empty());
    QVERIFY(bench.pair.board->truth(1).driven);
}

/// Where it was to go is not known: it could not be brought back.
void TestRunner::aMotorThatIsNotAtItsSetPointIsLeftAlone()
{
    LabBench bench;
    QVERIFY(bench.pair.runAt(1000));
    bench.pair.runFor(500ms);
    QVERIFY(bench.pair.runUntilEnded(bench.pair.submit(SpeedRamp{1, 3000, 3s})));
    VERIFY_END(bench.run(), End::Refused);
    QVERIFY(bench.asked<SpeedRamp>().empty() && bench.asked<Command>().empty());
}

void TestRunner::aRefusedStartLeavesTheMotorAlone()
{
    LabBench bench;
    bench.pair.drive->disarm();
    VERIFY_END(bench.run(), End::Refused);
    QCOMPARE(bench.stops, 0);
    QVERIFY(bench.pair.board->truth(1).idle);
}

void TestRunner::aStartThatWasTakenAndAnsweredOtherwiseIsStopped()
{
    LabBench bench;
    const auto handOn = bench.pair.onEvent;
    bench.pair.onEvent = [&](drive::Event event) {
        auto *ended = std::get_if<drive::Ended>(&event);
        const auto *command =
            bench.wishes.empty() ? nullptr : std::get_if<Command>(&bench.wishes.back().what);
        if (ended != nullptr && command != nullptr && ended->id == bench.wishes.back().id
            && command->action == MotorAction::Start)
            ended->outcome = drive::Outcome::Refused;
        handOn(event);
    };
    VERIFY_END(bench.run(), End::Aborted);
    QVERIFY(bench.runner->outcome().reason.find("started all the same") != std::string::npos);
    bench.turn();
    QCOMPARE(bench.stops, 1);
    bench.pair.runFor(3s);
    QVERIFY(bench.pair.board->truth(1).idle);
}

/// The way back from it was asked for and never arrived.
void TestRunner::aTorqueThatMayStillBeInForceIsSaid()
{
    LabBench bench;
    bench.pair.verdictTaken = true; // a cut line
    QVERIFY(bench.pair.runAt(1500));
    lab::SpinPlan plan = lab::spinPlanFor(bench.experiment.subject, {});
    plan.length = 2s;
    bench.experiment.plan = plan;
    bool torque = false;
    bench.pair.loses = [&](const Bytes &) {
        const bool ramp =
            !bench.wishes.empty() && std::holds_alternative<SpeedRamp>(bench.wishes.back().what);
        torque = torque || !bench.asked<drive::TorqueRamp>().empty()
            || !bench.asked<drive::CurrentReference>().empty();
        return torque && ramp;
    };
    VERIFY_END(bench.run(), End::Aborted);
    QVERIFY2(bench.runner->outcome().reason.find("in torque control now") != std::string::npos,
        bench.runner->outcome().reason.c_str());
}

/// As where the port is closed meanwhile: what was asked for last may not have been taken.
void TestRunner::aWayBackThatWasOnlyAskedForIsSaid()
{
    constexpr int kBefore_rpm = 1380; // firmware counts in 6 rpm
    LabBench bench;
    QVERIFY(bench.pair.runAt(kBefore_rpm));
    bench.pair.runFor(1s);
    bench.begin();
    QVERIFY(bench.runUntil(
        [&] {
            const auto ramps = bench.asked<SpeedRamp>();
            return !ramps.empty() && ramps.back().rpm == kBefore_rpm;
        },
        30s));
    bench.runner->interrupt("the port was closed");
    QVERIFY2(
        bench.runner->outcome().reason.find("the set-point may be 1000 rpm now, it was 1380 rpm")
            != std::string::npos,
        bench.runner->outcome().reason.c_str());
}

/// A step that is on its way, behind one that was taken: it is at one of both.
void TestRunner::aStepThatWasOnlyAskedForIsSaid()
{
    LabBench bench;
    QVERIFY(bench.pair.runAt(1380));
    bench.pair.runFor(1s);
    bench.begin();
    QVERIFY(bench.runUntil(
        [&] {
            const auto ramps = bench.asked<SpeedRamp>();
            return !ramps.empty() && ramps.back().rpm != 1000;
        },
        30s));
    bench.runner->interrupt("the port was closed");
    const std::string expected = "the set-point may be "
        + std::to_string(bench.asked<SpeedRamp>().back().rpm)
        + " rpm or 1000 rpm now, it was 1380 rpm";
    QVERIFY2(bench.runner->outcome().reason.find(expected) != std::string::npos,
        bench.runner->outcome().reason.c_str());
}

/// Its STOPs are answered and do nothing: the series ends with a Stop that goes on, and says so.
void TestRunner::aBoardThatDoesNotObeyIsToldAtTheEnd()
{
    LabBench bench;
    bench.pair.verdictTaken = true; // the board goes on on purpose
    bench.begin();
    QVERIFY(bench.runUntil(
        [&] {
            return !bench.asked<Command>().empty()
                && bench.asked<Command>().back().action == MotorAction::StopMotor;
        },
        30s));
    // The answer came; now the board runs on as if it had not heard it.
    bench.pair.toDrive.cut = true;
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 10s));
    VERIFY_END(bench.runner->outcome(), End::Aborted);
    bench.turn();
    QCOMPARE(bench.stops, 1);
    bench.pair.toDrive.cut = false;
    bench.pair.runFor(3s);
}

void TestRunner::aRotorThatTurnsOnIsWaitedFor_data()
{
    QTest::addColumn<QString>("motor");
    for (const char *motor : {"servo24", "blower36", "pm24"})
        QTest::newRow(motor) << QString::fromLatin1(motor);
}

/// An idle motor is not at rest: an encoder would be aligned to a rotor that runs away from it.
void TestRunner::aRotorThatTurnsOnIsWaitedFor()
{
    QFETCH(const QString, motor);
    simulation::BoardOptions options;
    options.plant = *simulation::findPreset(motor.toStdString());
    options.plant->motor.inertia_kgm2 *= 4.0;
    options.plant->inverter.supplyAbsorbs = true;
    LabBench bench(options);
    bench.pair.submit(SpeedRamp{1, 1500, 500ms});
    bench.pair.submit(Command{MotorAction::Start, 1});
    QVERIFY(bench.pair.runUntil([&] { return bench.pair.board->truth(1).rpm > 1400.0; }, 20s));
    bench.pair.submit(Command{MotorAction::StopMotor, 1});
    QVERIFY(bench.pair.runUntil(
        [&] { return bench.pair.board->truth(1).idle && bench.pair.board->truth(1).rpm > 500.0; },
        20s));
    bench.wishes.clear();
    std::optional<double> atStart;
    bench.eachTurn = [&] {
        if (!atStart && !bench.asked<Command>().empty())
            atStart = bench.pair.board->truth(1).rpm;
    };
    bench.experiment.plan = lab::spinPlanFor(bench.experiment.subject, {});
    bench.begin();
    QVERIFY(bench.runUntil([&] { return atStart || bench.runner->over(); }));
    QVERIFY(atStart);
    QVERIFY2(std::abs(*atStart) < 60.0, qPrintable(QString::number(*atStart)));
}

void TestRunner::somebodyElsesActEndsItWithoutAnother()
{
    LabBench bench;
    bench.begin();
    QVERIFY(bench.runUntil([&] { return bench.asked<SpeedRamp>().size() >= 3; }, 20s));
    bench.runner->interrupt("another command went to the motor");
    QVERIFY(bench.runner->over());
    VERIFY_END(bench.runner->outcome(), End::Interrupted);
    QVERIFY(bench.runner->takeWishes().empty());
    QVERIFY(!bench.runner->takeStop());
    QVERIFY(!bench.runner->nextTimeout());
}

/// A torque would go on to accelerate the rotor, and a start-up that was to turn nothing to turn it.
void TestRunner::whatOnlyTheEnvelopeBoundsEndsWithAStop()
{
    const auto pushes = [](LabBench &bench) {
        bench.experiment.plan = lab::spinPlanFor(bench.experiment.subject, {});
        bench.begin();
        return bench.runUntil([&] { return !bench.asked<TorqueRamp>().empty(); }, 40s);
    };
    LabBench disarmed;
    QVERIFY(pushes(disarmed));
    disarmed.runner->disarm();
    VERIFY_END(disarmed.runner->outcome(), End::Interrupted);
    QVERIFY2(disarmed.runner->outcome().reason.starts_with(
                 "the drive was disarmed; every motor was told to stop"),
        disarmed.runner->outcome().reason.c_str());
    disarmed.turn();
    QCOMPARE(disarmed.stops, 1);
    QVERIFY(disarmed.pair.runUntil([&] { return disarmed.pair.board->truth(1).idle; }, 1s));

    LabBench stopped; // by the user already
    QVERIFY(pushes(stopped));
    stopped.runner->stopped();
    VERIFY_END(stopped.runner->outcome(), End::Interrupted);
    QVERIFY(stopped.runner->outcome().reason.starts_with("every motor was stopped; "));
    QVERIFY(stopped.runner->outcome().reason.find("told to stop") == std::string::npos);
    QVERIFY(!stopped.runner->takeStop());

    simulation::BoardOptions sensorless;
    sensorless.motor = "pm24";
    LabBench starting(sensorless);
    starting.experiment.plan = lab::restPlanFor(starting.experiment.subject, {});
    starting.begin();
    QVERIFY(starting.runUntil([&] { return starting.pair.board->truth(1).driven; }, 20s));
    starting.runner->interrupt("another command went to the motor");
    starting.turn();
    QCOMPARE(starting.stops, 1);
    QVERIFY(starting.pair.runUntil([&] { return starting.pair.board->truth(1).idle; }, 1s));
}

/// What overshoots or settles comes later: its numbers looked better than those of the whole ones.
void TestRunner::aStepThatIsCutShortTellsNothing()
{
    LabBench bench;
    bench.begin();
    QVERIFY(bench.runUntil([&] { return bench.asked<SpeedRamp>().size() >= 4; }, 20s));
    bench.pair.runFor(60ms);
    bench.runner->interrupt("the drive was disarmed");
    bench.happenings.emplace_back(bench.pair.now.time_since_epoch().count(),
        lab::entryOfEnd({End::Interrupted, "the drive was disarmed"}));
    const auto series = bench.series();
    QVERIFY2(series, series ? "" : series.error().c_str());
    QVERIFY(series->runs.size() >= 2);
    const lab::StepRun &whole = series->runs.front(), &cut = series->runs.back();
    QVERIFY(!whole.cut && whole.rise_s && whole.overshoot_pct);
    QVERIFY(cut.cut && !cut.rise_s && !cut.overshoot_pct && !cut.settling_s && !cut.peakIq_a);
    QVERIFY(whole.instantError_s && !cut.instantError_s);
    QVERIFY(std::any_of(series->notes.begin(), series->notes.end(), [](const std::string &note) {
        return note.find("was cut short: nothing is told of its speed") != std::string::npos;
    }));
}

void TestRunner::whoDisarmsIsToldWhatDrivesOn()
{
    LabBench bench;
    bench.begin();
    QVERIFY(bench.runUntil([&] { return bench.asked<SpeedRamp>().size() >= 3; }, 20s));
    bench.runner->disarm();
    VERIFY_END(bench.runner->outcome(), End::Interrupted);
    const std::string &reason = bench.runner->outcome().reason;
    QVERIFY2(reason.find("is driven on") != std::string::npos, reason.c_str());
    LabBench early;
    early.begin();
    early.runner->disarm(); // nothing was started yet
    QCOMPARE(early.runner->outcome().reason, std::string("the drive was disarmed"));
}

void TestRunner::boardsThatRecordNothingSayWhy()
{
    simulation::BoardOptions older;
    older.profile = "legacy";
    older.baud = 115200;
    support::Session pair(false, older);
    QVERIFY(pair.ready);
    const auto board = lab::subjectOf(*pair.identified, 1);
    QVERIFY(!board && !board.error().empty() && board.error().back() == '.');
    QVERIFY(!lab::subjectOf(*pair.identified, 2));
}

void TestRunner::whatABoardsSamplesLackIsNamed()
{
    const LabBench bench;
    const auto lacks = [&](auto change) {
        Identified board = *bench.pair.identified;
        change(board);
        const auto subject = lab::subjectOf(board, 1);
        return subject ? std::string() : subject.error();
    };
    QCOMPARE(lacks([](Identified &) {}), std::string());
    QVERIFY(lacks([](Identified &board) {
        board.streaming.frameOverhead = 10;
    }).starts_with("This board sends its samples once an exchange"));
    QVERIFY(lacks([](Identified &board) {
        board.identity.speedSignals = {""};
    }).ends_with("the speed that its main sensor tells."));
    QCOMPARE(lacks([](Identified &board) { board.streaming.maxSignals = 3; }),
        std::string("This board records 3 signals at a time, and experiments need 4."));
}

QTEST_APPLESS_MAIN(TestRunner)
#include "tst_runner.moc"
