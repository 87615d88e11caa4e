// Experiments while everything goes wrong: on the line, at the board, with the
// people around. Whatever happens, an experiment ends once, asks for nothing
// more, and leaves the motor as it was, stopped, or with a sentence that says
// what is not as it was. ROTORSCOPE_LONG=1 tries ten thousand of them;
// support/seeds.h says which others.
#include "support/lab_bench.h"
#include "support/seeds.h"

using namespace lab;
using support::LabBench;
using namespace std::chrono_literals;

namespace {

enum class Trouble : std::uint8_t {
    None,
    Noise,
    Mute,
    Cut,
    Fault,
    Load,
    PersonStops,
    PersonDisarms,
    Stalls,
    Reset,
    Count
};

struct Scenario {
    explicit Scenario(std::uint64_t seed)
        : random(seed)
        , trouble(static_cast<Trouble>(random.below(std::uint64_t(Trouble::Count))))
        , bench(options(random, seed), seed)
    {
        runs = random.chance(0.5);
        at = std::chrono::milliseconds(random.below(9000));
        const Subject &subject = bench.experiment.subject;
        switch (random.below(4)) {
        case 0: {
            // Without a sensor: with room above what its observer needs.
            const auto least =
                static_cast<int>(std::max(1000.0, subject.leastObservedRpm() + 300.0));
            const int from = least + static_cast<int>(random.below(500));
            bench.steps = {.fromRpm = from,
                .toRpm = from + static_cast<int>(200 + random.below(600)),
                .repeat = static_cast<int>(1 + random.below(3))};
            break;
        }
        case 1: {
            SpinPlan plan = spinPlanFor(subject, {});
            plan.length = 3s;
            bench.experiment.plan = plan;
            break;
        }
        case 2: {
            const bool flux = random.chance(0.5);
            const double share = 0.05 + 0.002 * double(random.below(100));
            CurrentStepPlan plan = currentStepPlanFor(
                subject, flux, 0.0, share * subject.limits.nominalCurrentAmps, {});
            plan.repeat = static_cast<int>(1 + random.below(3));
            bench.experiment.plan = plan;
            break;
        }
        default: {
            ResponsePlan plan = random.chance(0.5) ? currentResponsePlanFor(subject, {})
                                                   : responsePlanFor(subject, {});
            plan.length = 4s;
            bench.experiment.plan = plan;
        }
        }
    }

    static simulation::BoardOptions options(support::Random &random, std::uint64_t seed)
    {
        constexpr std::array kMotors{"servo24", "pm24", "blower36", "prop12"};
        simulation::BoardOptions options;
        options.motor = kMotors[random.below(kMotors.size())];
        options.seed = seed;
        return options;
    }

    void strike()
    {
        support::Session &pair = bench.pair;
        switch (trouble) {
        case Trouble::Noise:
            pair.toDrive.flip = pair.toBoard.flip = 2e-4;
            pair.toDrive.drop = pair.toBoard.drop = 1e-4;
            break;
        case Trouble::Mute:
            pair.board->mute(std::chrono::milliseconds(50 + random.below(3000)));
            break;
        case Trouble::Cut:
            pair.toDrive.cut = pair.toBoard.cut = true;
            break;
        case Trouble::Fault:
            pair.board->setFaults(static_cast<std::uint16_t>(1U << random.below(7)));
            break;
        case Trouble::Load:
            pair.board->setLoadTorque(1, 0.02 + 0.002 * double(random.below(100)));
            break;
        case Trouble::PersonStops: // as a session does it
            bench.runner->interrupt("every motor was stopped");
            pair.drive->stop(pair.now);
            break;
        case Trouble::PersonDisarms:
            bench.runner->interrupt("the drive was disarmed");
            pair.drive->disarm();
            break;
        case Trouble::Stalls:
            bench.held = std::chrono::milliseconds(random.below(900));
            break;
        case Trouble::Reset:
            pair.board->reset();
            break;
        case Trouble::None:
        case Trouble::Count:
            break;
        }
    }

    bool prepare()
    {
        if (!runs)
            return bench.pair.ready;
        if (!bench.pair.startMotor())
            return false;
        bench.pair.submit(drive::SpeedRamp{1, 1500, 500ms});
        bench.pair.runFor(2s);
        return true;
    }

    /// From the beginning until it is over and everything is as quiet as it gets.
    void run()
    {
        bench.begin();
        const TimePoint when = bench.pair.now + at;
        bool struck = false;
        over = bench.runUntil(
            [&] {
                if (!struck && bench.pair.now >= when && !bench.runner->over()) {
                    struck = true;
                    strike();
                }
                return bench.runner->over();
            },
            90s);
        const std::size_t asked = bench.wishes.size();
        bench.pair.toDrive = bench.pair.toBoard = {};
        (void)bench.runUntil([] { return false; }, 8s);
        askedAfterwards = bench.wishes.size() - asked;
    }

    support::Random random;
    Trouble trouble;
    LabBench bench;
    bool runs = false; ///< the motor, before
    Duration at{};
    bool over = false;
    std::size_t askedAfterwards = 0;
};

/// Empty if nothing is.
std::string whatIsWrong(const Scenario &scenario)
{
    const LabBench &bench = scenario.bench;
    if (!scenario.over)
        return "it does not end";
    const Outcome &outcome = bench.runner->outcome();
    if (scenario.askedAfterwards > 0)
        return "it asks for something after its end";
    if (bench.stops > 1)
        return "more than one Stop";
    if (outcome.end != End::Complete && outcome.reason.empty())
        return "no reason";
    const simulation::MotorTruth truth = bench.pair.board->truth(1);
    if (bench.stops > 0 && !truth.idle) // heard as soon as there is a link
        return "stopped, and the motor is driven";
    const bool same = truth.driven == scenario.runs
        && (!scenario.runs || std::abs(truth.referenceRpm - 1500.0) <= 12.0);
    const bool says = outcome.reason.find("set-point") != std::string::npos
        || outcome.end == End::Aborted || outcome.end == End::Interrupted
        || outcome.end == End::Lost;
    const bool byTheBoard = scenario.trouble == Trouble::Load || scenario.trouble == Trouble::Fault
        || scenario.trouble == Trouble::Reset;
    if (!same && !says && !byTheBoard)
        return "the motor is not as it was, and nothing says so";
    return bench.pair.judge.verdict();
}

} // namespace

class TestExperimentFaults : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whateverHappensNothingIsLeftWithoutASentence()
    {
        const support::Seeds seeds = support::seedsOf(60, 10'000);
        std::map<End, int> ends;
        const auto play = [&](std::uint64_t seed) -> std::optional<std::string> {
            Scenario scenario(seed);
            LabBench &bench = scenario.bench;
            bench.pair.verdictTaken = true;
            if (!scenario.prepare())
                return std::nullopt; // the motor did not start
            scenario.run();
            if (scenario.over)
                ++ends[bench.runner->outcome().end];
            const std::string wrong = whatIsWrong(scenario);
            return wrong.empty()
                ? wrong
                : "trouble " + std::to_string(int(scenario.trouble)) + ", " + wrong + ", "
                    + support::outcomeText(
                        bench.runner->over() ? bench.runner->outcome() : Outcome())
                          .toStdString();
        };
        const std::string wrong = support::playSeeds(seeds, play);
        QVERIFY2(wrong.empty(), wrong.c_str());
        qInfo("complete %d, refused %d, aborted %d, interrupted %d", ends[End::Complete],
            ends[End::Refused], ends[End::Aborted], ends[End::Interrupted]);
        if (seeds.count >= 60)
            QVERIFY(
                ends[End::Complete] > 0 && ends[End::Aborted] > 0 && ends[End::Interrupted] > 0);
    }
};

QTEST_APPLESS_MAIN(TestExperimentFaults)
#include "tst_experiment_faults.moc"
