// Steps of the speed on boards that record nothing by themselves: values are read one after the other, and bound what
// is known of a step as they bound the motor.
#include "core/lab/older_bench.h"
#include "fcp/request.h"
#include "lab/evaluation/finding.h"

using lab::End;
using lab::Nanos;
using support::OlderBench;
using support::olderServo;
using namespace std::chrono_literals;

namespace {

constexpr double kHold_s = 0.5, kTook_s = 2e-3;

/// What is read at odd times of a speed that follows its steps exactly by 1 - exp(-t / tau), and what is asked for.
struct ReadSteps {
    capture::Capture capture;
    lab::Happenings happenings;
    std::vector<double> instants_s; ///< at which the board had them, somewhere before its answer

    /// @param unread_s  from when to when nothing was read
    ReadSteps(double tau_s, std::uint64_t seed, std::pair<double, double> unread_s = {})
    {
        support::Random random(seed);
        const auto between = [&random](double least, double most) {
            return least + (most - least) * static_cast<double>(random.below(1001)) / 1000.0;
        };
        const auto add = [this](double at_s, recorded::Happening what) {
            happenings.emplace_back(capture::toNanos(at_s), std::move(what));
        };
        constexpr int kSteps = 6;
        add(0.9,
            {lab::StepPlan::kEntry,
                {{"motor", "1"}, {"speed", "SPEED_MEAS"}, {"from rpm", "1000"}, {"to rpm", "2000"},
                    {"repeat", "3"}, {"hold ms", "500"}}});
        for (int step = 0; step < kSteps; ++step) {
            const double asked_s = 1.0 + step * kHold_s;
            instants_s.push_back(asked_s + between(0.0, kTook_s));
            add(asked_s,
                {"speed ramp",
                    {{"motor", "1"}, {"rpm", step % 2 == 0 ? "2000" : "1000"}, {"ms", "0"}}});
            add(asked_s + kTook_s,
                {"motion",
                    {{"act", "SPEED_RAMP"}, {"asked s", decimalText(asked_s)}, {"took ms", "2"},
                        {"outcome", "ok"}}});
        }
        add(1.0 + kSteps * kHold_s, {lab::kEndEntry, {{"outcome", "complete"}}});
        for (double at_s = 0.5; at_s < 1.1 + kSteps * kHold_s; at_s += between(1e-3, 6e-3)) {
            double rpm = 1000.0, to_rpm = 2000.0;
            for (std::size_t step = 0; step < instants_s.size(); ++step) {
                if (at_s < instants_s[step])
                    break;
                const double until_s =
                    step + 1 < instants_s.size() ? std::min(at_s, instants_s[step + 1]) : at_s;
                rpm = to_rpm + (rpm - to_rpm) * std::exp((instants_s[step] - until_s) / tau_s);
                to_rpm = 3000.0 - to_rpm;
            }
            if (at_s < unread_s.first || at_s > unread_s.second)
                capture.appendPolled(7, "SPEED_MEAS", "rpm", at_s, rpm);
        }
    }
};

bool told(const lab::StepRun &run)
{
    return run.rise_s || run.overshoot_pct || run.settling_s || run.peakIq_a;
}

bool notes(const lab::MeasuredSteps &series, const char *words)
{
    return std::ranges::any_of(series.notes,
        [words](const std::string &note) { return note.find(words) != std::string::npos; });
}

} // namespace

class TestPolledSteps : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theTruthIsWithinWhatIsStated();
    void whatIsOverTooFastIsNotTold();
    void aStepThatWasReadTooRarelyTakesNothingFromTheOthers();
    void theNumbersAreThoseOfTheRotor();
    void aLineTooSlowForTheMotorIsNotConclusive();
    void aPeakIsToldWhereTheCurrentHasItsScale();
    void digitsOfBeforeTheScaleWasToldAreNoCurrent();
    void aBrokenBoundIsAStopWithinAPoll_data();
    void aBrokenBoundIsAStopWithinAPoll();
    void aSpeedThatIsNotReadAnyMoreBreaksIt();
    void aRunningMotorIsBrakedGentlyBeforeItsSpeedCame();
    void aBoardThatDoesNotSayHowItStartsMayHaveNoSensor();
    void theBoundsAreAgreedToAsOfAnyBoard();
    void nothingElseIsMeasuredFromPolls();
};

/// Of an exact first-order step: 10 to 90 % in tau ln 9, within 2 % in tau ln 50.
void TestPolledSteps::theTruthIsWithinWhatIsStated()
{
    constexpr double kTau_s = 0.04;
    constexpr double kLeft_s = 1e-4; // of a step that is not quite over when the next one comes
    const double rise_s = kTau_s * std::log(9.0), settling_s = kTau_s * std::log(50.0);
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const ReadSteps read(kTau_s, seed);
        const auto series = lab::stepSeries(read.capture, read.happenings);
        QVERIFY2(series, series ? "" : series.error().c_str());
        QCOMPARE(series->runs.size(), read.instants_s.size());
        for (std::size_t i = 0; i < series->runs.size(); ++i) {
            const lab::StepRun &run = series->runs[i];
            QCOMPARE(run.up, i % 2 == 0);
            QVERIFY(run.rise_s && run.settling_s && run.instantError_s && !run.peakIq_a);
            QVERIFY(run.pollDistance_s > 3e-3 && run.pollDistance_s < 6.001e-3);
            QVERIFY(*run.instantError_s >= run.pollDistance_s);
            QVERIFY(std::abs(*run.rise_s - rise_s) <= run.pollDistance_s + kLeft_s);
            QVERIFY(std::abs(*run.settling_s - settling_s) <= *run.instantError_s + kLeft_s);
            QVERIFY(
                std::abs(capture::toSeconds(run.at) - read.instants_s[i]) <= *run.instantError_s);
        }
        QVERIFY(*series->rise_s->low <= rise_s && *series->rise_s->high >= rise_s);
        QVERIFY(*series->settling_s->low <= settling_s && *series->settling_s->high >= settling_s);
        QVERIFY(notes(*series, "its speed was read once in up to"));
    }
}

/// Values up to 6 ms apart say nothing of a rise of 7 ms.
void TestPolledSteps::whatIsOverTooFastIsNotTold()
{
    for (const double tau_s : {3.2e-3, 0.5e-3}) {
        const ReadSteps read(tau_s, 1);
        const auto finding = lab::findingIn(read.capture, read.happenings);
        QVERIFY2(finding, finding ? "" : finding.error().c_str());
        const auto &series = std::get<lab::MeasuredSteps>(*finding);
        std::size_t untold = 0;
        for (const lab::StepRun &run : series.runs) {
            const bool few = !run.rise_s;
            QCOMPARE(few, run.tooFast);
            QVERIFY(!few || !told(run));
            QVERIFY(few || *run.rise_s >= 3.0 * run.pollDistance_s);
            untold += few ? 1U : 0U;
        }
        QVERIFY(untold > 0);
        QVERIFY(notes(
            series, " steps rise in less than three times the time between two of their values"));
        QVERIFY(!notes(series, "does not settle"));
        if (untold == series.runs.size())
            QVERIFY(lab::lackOf(*finding).starts_with("not conclusive"));
    }
}

/// A computer that stood still for 0.3 s in the third one.
void TestPolledSteps::aStepThatWasReadTooRarelyTakesNothingFromTheOthers()
{
    constexpr double kTau_s = 0.04;
    const ReadSteps read(kTau_s, 1, {2.005, 2.305});
    const auto series = lab::stepSeries(read.capture, read.happenings);
    QVERIFY2(series, series ? "" : series.error().c_str());
    QCOMPARE(series->runs.size(), 6U);
    for (std::size_t i = 0; i < series->runs.size(); ++i)
        QCOMPARE(series->runs[i].rise_s.has_value(), i != 2);
    const double rise_s = kTau_s * std::log(9.0), settling_s = kTau_s * std::log(50.0);
    constexpr double kWidest_s = 0.2; // some distances of 6 ms, and none of 300 ms
    for (const auto &[mean, truth_s] :
        {std::pair(series->rise_s, rise_s), std::pair(series->settling_s, settling_s)}) {
        QVERIFY(mean && mean->low && mean->high);
        QVERIFY(*mean->low <= truth_s && *mean->high >= truth_s);
        QVERIFY2(*mean->high - *mean->low < kWidest_s,
            qPrintable(QString::number(*mean->high - *mean->low)));
    }
}

/// The board knows its rotor, which is looked at every 250 us.
void TestPolledSteps::theNumbersAreThoseOfTheRotor()
{
    OlderBench bench;
    QVERIFY(bench.pair.ready && bench.slower());
    bench.steps.repeat = 2;
    bench.steps.hold = 3s;
    std::vector<std::pair<Nanos, simulation::MotorTruth>> truth;
    bench.eachTurn = [&] {
        truth.emplace_back(bench.pair.now.time_since_epoch().count(), bench.pair.board->truth(1));
    };
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Complete);
    QVERIFY2(!outcome.leaves, outcome.reason.c_str());
    QCOMPARE(bench.stops, 0);
    QVERIFY(bench.asked<drive::Stream>().empty());
    QVERIFY(bench.pair.runUntilState(drive::MotorState::Idle));
    const auto series = bench.series();
    QVERIFY2(series, series ? "" : series.error().c_str());
    QCOMPARE(series->runs.size(), 4U);
    for (const lab::StepRun &run : series->runs) {
        QVERIFY(run.rise_s && run.instantError_s && !run.peakIq_a);
        const double from = run.up ? 1000.0 : 2000.0, way = run.up ? 1000.0 : -1000.0;
        const auto when = [&](double simulation::MotorTruth::*what, double share) {
            constexpr Nanos kBefore = 50'000'000;
            const auto at = std::find_if(truth.begin(), truth.end(), [&](const auto &one) {
                return one.first > run.at - kBefore && (one.second.*what - from) / way >= share;
            });
            return at == truth.end() ? Nanos{0} : at->first;
        };
        constexpr double kDigit_s = 2e-3; // at 90 % the speed rises by a digit of 6 rpm in so long
        const double rise_s = capture::toSeconds(
            when(&simulation::MotorTruth::rpm, 0.9) - when(&simulation::MotorTruth::rpm, 0.1));
        QVERIFY2(std::abs(*run.rise_s - rise_s) <= *run.instantError_s + kDigit_s,
            qPrintable(QStringLiteral("%1 %2 %3")
                           .arg(QString::number(*run.rise_s), QString::number(rise_s),
                               QString::number(*run.instantError_s))));
        const Nanos stepped = when(&simulation::MotorTruth::referenceRpm, 0.99);
        QVERIFY2(std::abs(capture::toSeconds(run.at - stepped)) <= *run.instantError_s,
            qPrintable(QString::number(capture::toSeconds(run.at - stepped))));
        // An exchange takes a millisecond; the states are read at times as well.
        QVERIFY2(run.pollDistance_s > 1e-3 && run.pollDistance_s < 20e-3,
            qPrintable(QString::number(run.pollDistance_s)));
    }
}

/// Half a millisecond a byte: 6 ms for each value.
void TestPolledSteps::aLineTooSlowForTheMotorIsNotConclusive()
{
    OlderBench bench(olderServo(19200));
    QVERIFY(bench.pair.ready);
    VERIFY_END(bench.run(), End::Complete);
    const auto finding = lab::findingIn(bench.capture, bench.happenings);
    QVERIFY2(finding, finding ? "" : finding.error().c_str());
    const auto &series = std::get<lab::MeasuredSteps>(*finding);
    QCOMPARE(series.runs.size(), 2U);
    for (const lab::StepRun &run : series.runs) {
        QVERIFY(run.tooFast && !told(run));
        QVERIFY(run.pollDistance_s > 10e-3);
    }
    QVERIFY(lab::lackOf(*finding).starts_with("not conclusive"));
    QVERIFY(notes(
        series, "2 of 2 steps rise in less than three times the time between two of their values"));
}

void TestPolledSteps::aPeakIsToldWhereTheCurrentHasItsScale()
{
    const simulation::BoardOptions options = olderServo();
    OlderBench bench(options, options.plant->inverter.maxReadable_a());
    QVERIFY(bench.pair.ready && bench.slower());
    bench.steps.hold = 3s;
    VERIFY_END(bench.run(), End::Complete);
    const auto series = bench.series();
    QVERIFY2(series, series ? "" : series.error().c_str());
    QCOMPARE(series->runs.size(), 2U);
    for (const lab::StepRun &run : series->runs)
        QVERIFY(run.peakIq_a && *run.peakIq_a > 0.1 && *run.peakIq_a < 10.0);
}

/// Of a recording that goes on over many experiments.
void TestPolledSteps::digitsOfBeforeTheScaleWasToldAreNoCurrent()
{
    ReadSteps read(0.04, 1);
    read.happenings.front().second.fields.emplace_back("current", "I_Q_MEAS");
    read.capture.appendPolled(8, "I_Q_MEAS", "s16A", 0.1, 500.0);
    for (double at_s = 0.6; at_s < 4.0; at_s += 0.01)
        read.capture.appendPolled(8, "I_Q_MEAS", "A", at_s, -2.5);
    const auto series = lab::stepSeries(read.capture, read.happenings);
    QVERIFY2(series, series ? "" : series.error().c_str());
    for (const lab::StepRun &run : series->runs)
        QVERIFY(run.peakIq_a && *run.peakIq_a == 2.5);
}

void TestPolledSteps::aBrokenBoundIsAStopWithinAPoll_data()
{
    QTest::addColumn<QString>("cap");
    for (const char *cap : {"speed", "current", "bus", "temperature"})
        QTest::addRow("%s", cap) << cap;
}

void TestPolledSteps::aBrokenBoundIsAStopWithinAPoll()
{
    QFETCH(const QString, cap);
    const bool speed = cap == QLatin1String("speed"), current = cap == QLatin1String("current");
    const simulation::BoardOptions options = olderServo();
    OlderBench bench(options, current ? options.plant->inverter.maxReadable_a() : 0.0);
    QVERIFY(bench.pair.ready);
    if (speed)
        bench.steps.caps.maxSpeedRpm = 2000.0; // any overshoot
    if (current)
        bench.steps.caps.maxCurrentAmps = 1.0;
    const lab::Registers &registers = bench.experiment.subject.registers;
    const drive::RegisterId looked = speed ? registers.speed
        : current                          ? registers.current
        : cap == QLatin1String("bus")      ? registers.bus
                                           : registers.temperature;
    QVERIFY(looked != 0);
    const double factor = bench.experiment.subject.catalog->readScale(looked).factor;
    const double bound = speed ? 2000.0 : current ? 1.0 : 85.0;
    std::optional<TimePoint> broken;
    std::size_t before = 0; // frames that had left
    bench.pair.onEvent = [&, handOn = bench.pair.onEvent](drive::Event event) {
        // The first step is the third ramp; a current flows from the start on.
        const bool counts = current ? !bench.asked<drive::Command>().empty()
                                    : bench.asked<drive::SpeedRamp>().size() >= 3;
        if (auto *read = std::get_if<drive::RegistersRead>(&event); read != nullptr && counts)
            for (drive::Reading &reading : read->readings) {
                if (reading.id != looked)
                    continue;
                if (!speed && !current)
                    reading.value = std::int64_t{90};
                if (!broken
                    && std::abs(drive::asNumber(reading.value).value_or(0.0)) * factor > bound) {
                    broken = bench.pair.now;
                    before = bench.pair.requests.size();
                }
            }
        handOn(event);
    };
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Aborted);
    QVERIFY2(outcome.reason.find("allowed") != std::string::npos, outcome.reason.c_str());
    QVERIFY2(broken, outcome.reason.c_str());
    QCOMPARE(bench.stops, 1);
    const Bytes stop =
        fcp::encodeRequest({1, fcp::Execute{static_cast<std::uint8_t>(fcp::CommandId::StopMotor)}})
            .value();
    const auto polls = [&] { // that left before the STOP
        const auto &all = bench.pair.requests;
        const auto from = all.begin() + static_cast<std::ptrdiff_t>(before);
        const auto at = std::find(from, all.end(), stop);
        return at == all.end() ? std::ptrdiff_t{-1} : at - from;
    };
    QVERIFY(bench.pair.runUntil([&] { return polls() >= 0; }, 25ms));
    QVERIFY2(polls() <= 1, qPrintable(QString::number(polls())));
    QVERIFY2(bench.pair.now - *broken <= 25ms,
        qPrintable(QString::number(toSeconds(bench.pair.now - *broken))));
    const std::size_t wishes = bench.wishes.size();
    QVERIFY(bench.pair.runUntil([&] { return bench.pair.board->truth(1).idle; }, 2s));
    QCOMPARE(bench.wishes.size(), wishes);
}

/// The state goes on telling a speed, ten times a second: that bounds nothing.
void TestPolledSteps::aSpeedThatIsNotReadAnyMoreBreaksIt()
{
    OlderBench bench;
    QVERIFY(bench.pair.ready);
    bench.steps.hold = 2s;
    bench.pair.onEvent = [&, handOn = bench.pair.onEvent](drive::Event event) {
        if (auto *read = std::get_if<drive::RegistersRead>(&event);
            read != nullptr && bench.asked<drive::SpeedRamp>().size() >= 3)
            for (drive::Reading &reading : read->readings)
                if (reading.id == bench.experiment.subject.registers.speed)
                    reading.status = drive::ReadStatus::Refused;
        handOn(event);
    };
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Aborted);
    QVERIFY2(
        outcome.reason.starts_with("the speed was not read for 0.5 s"), outcome.reason.c_str());
    QCOMPARE(bench.stops, 1);
    QVERIFY(bench.pair.runUntil([&] { return bench.pair.board->truth(1).idle; }, 2s));
}

/// Where nothing has shown that the bus takes what comes back: from the set-point, as its first value comes later.
void TestPolledSteps::aRunningMotorIsBrakedGentlyBeforeItsSpeedCame()
{
    OlderBench bench;
    QVERIFY(bench.pair.ready);
    QVERIFY(bench.pair.runUntilEnded(bench.pair.submit(drive::SpeedRamp{1, 2000, 0ms})));
    QVERIFY(bench.pair.runAt(2000));
    bench.pair.runFor(1s);
    bench.steps.toRpm = 1600;
    VERIFY_END(bench.run(), End::Complete);
    const drive::SpeedRamp first = bench.asked<drive::SpeedRamp>().front();
    QCOMPARE(first.rpm, 1000);
    QVERIFY(first.duration == 3s);
}

void TestPolledSteps::aBoardThatDoesNotSayHowItStartsMayHaveNoSensor()
{
    OlderBench bench;
    QVERIFY(bench.pair.ready && bench.experiment.subject.seesRotor());
    drive::Identified silent = *bench.pair.identified;
    std::vector<catalog::RegisterInfo> registers = silent.catalog->registers();
    const auto isTheirNumber = [](const catalog::RegisterInfo &one) {
        return one.name == "RUC_STAGE_NBR";
    };
    QCOMPARE(std::erase_if(registers, isTheirNumber), std::size_t{1});
    const std::vector<catalog::Scales> scales(1, silent.catalog->scales(1));
    silent.catalog = std::make_shared<const catalog::Catalog>(
        std::move(registers), 1, scales, silent.catalog->start());
    const auto subject = lab::pollableSubjectOf(silent, 1);
    QVERIFY2(subject, subject ? "" : subject.error().c_str());
    QVERIFY(!subject->seesRotor());
    QVERIFY(subject->leastObservedRpm(3000.0) > 0.0);
}

void TestPolledSteps::theBoundsAreAgreedToAsOfAnyBoard()
{
    simulation::BoardOptions options;
    options.profile = "legacy";
    options.baud = 115200;
    OlderBench bench(options); // without a sensor
    QVERIFY(bench.pair.ready);
    const lab::Subject &subject = bench.experiment.subject;
    QVERIFY(subject.polled && !subject.seesRotor());
    QCOMPARE(lab::jumpPerRpm(subject, 1000.0, 4.0), 0.0); // of no reference that was recorded
    QVERIFY(OlderBench().experiment.subject.seesRotor());
    const auto objection = [&](const lab::StepPlan &plan) {
        return lab::objectionTo({plan, subject});
    };
    lab::StepPlan plan{.fromRpm = 1200, .toRpm = 1500, .caps = {3000.0, 0.0}};
    QCOMPARE(objection(plan), std::string());
    plan.caps = {};
    QVERIFY(objection(plan).starts_with("nothing says how fast this motor may turn"));
    plan.caps = {1400.0, 0.0};
    QVERIFY(objection(plan).find("rpm that are allowed") != std::string::npos);
    // 0.3 of what the user allows, where the board tells nothing.
    plan = {.fromRpm = 800, .toRpm = 1500, .caps = {3000.0, 0.0}};
    QVERIFY(objection(plan).starts_with("stay above 900 rpm"));
    plan = {.fromRpm = 1200, .toRpm = 1500, .caps = {3000.0, 2.0}};
    QVERIFY(objection(plan).starts_with("nothing tells its current in A"));
    bench.steps = plan;
    VERIFY_END(bench.run(), End::Refused);
    QVERIFY(bench.wishes.empty());
}

void TestPolledSteps::nothingElseIsMeasuredFromPolls()
{
    OlderBench bench;
    QVERIFY(bench.pair.ready);
    QVERIFY(!lab::subjectOf(*bench.pair.identified, 1));
    QVERIFY(!lab::pollableSubjectOf(*bench.pair.identified, 2));
    for (const lab::Plan &plan :
        {lab::Plan(lab::SpinPlan{.fluxAmps = 1.0}), lab::Plan(lab::ResponsePlan()),
            lab::Plan(lab::RestPlan()), lab::Plan(lab::CurrentStepPlan())}) {
        bench.experiment.plan = plan;
        QVERIFY(lab::objectionTo(bench.experiment).starts_with("this board records nothing"));
    }
}

QTEST_APPLESS_MAIN(TestPolledSteps)
#include "tst_polled_steps.moc"
