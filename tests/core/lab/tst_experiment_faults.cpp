// Experiments while everything goes wrong: on the line, at the board, with the
// people around. Whatever happens, an experiment ends once, asks for nothing
// more, and leaves the motor as it was, stopped, or with a sentence that says
// what is not as it was. What the user agreed to holds: the truth of the board is
// held against the bounds that were shown, and its registers against those of
// before. ROTORSCOPE_LONG=1 tries ten thousand of them; support/seeds.h says which
// others.
#include "core/lab/drawn_plans.h"
#include "lab/caps.h"
#include "simulation/mcp/liars.h"
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
    Lies,
    Count
};

/// Whether the motor was ever driven beyond what was agreed to without a Stop. A poll takes 20 ms at most and the Stop
/// 25 ms from the arrival of what it is for; where nothing arrives, silence is broken half a second later.
class BoundsWatch {
public:
    BoundsWatch(const Caps &agreed, Duration within)
        : m_agreed(agreed)
        , m_within(within)
    {
    }

    void look(const simulation::MotorTruth &truth, TimePoint now)
    {
        constexpr double kRoom = 1.05; // of what is measured with noise
        // How a board brings its rotor up is its own matter.
        const bool runs = truth.driven && truth.state == simulation::MotorState::Run;
        const double room_rpm =
            (kRoom - 1.0) * std::max(std::abs(m_agreed.leastRpm), m_agreed.mostRpm);
        const bool speed = runs
            && (truth.measuredRpm < m_agreed.leastRpm - room_rpm
                || truth.measuredRpm > m_agreed.mostRpm + room_rpm);
        const bool current = truth.driven && m_agreed.mostAmps > 0.0
            && std::abs(truth.iqAmps) > kRoom * m_agreed.mostAmps;
        if (!speed && !current && now - m_seen > kLasts)
            m_since.reset(); // shorter than what is streamed
        if (!speed && !current)
            return;
        m_seen = now;
        if (!m_since)
            m_since = now;
        if (m_broken.empty() && now - *m_since > m_within)
            m_broken = "the judge: MS28: "
                + (speed ? std::to_string(truth.measuredRpm) + " rpm"
                         : std::to_string(truth.iqAmps) + " A")
                + " was not agreed to (" + std::to_string(std::lround(m_agreed.leastRpm)) + " to "
                + std::to_string(std::lround(m_agreed.mostRpm)) + " rpm, "
                + std::to_string(m_agreed.mostAmps) + " A), and no Stop came";
    }
    const std::string &broken() const { return m_broken; }

private:
    static constexpr Duration kLasts = 2ms;
    Caps m_agreed;
    Duration m_within;
    TimePoint m_seen{};
    std::optional<TimePoint> m_since;
    std::string m_broken;
};

struct Scenario {
    explicit Scenario(std::uint64_t seed)
        : random(seed)
        , troubles(draw(random))
        , lie(has(Trouble::Lies) ? &simulation::lies()[random.below(simulation::lies().size())]
                                 : nullptr)
        , bench(options(random, lie, seed), seed)
    {
        runs = random.chance(0.5);
        at = std::chrono::milliseconds(random.below(9000));
        bench.experiment.plan = support::drawnPlan(random, bench.experiment.subject);
        if (const auto *steps = std::get_if<StepPlan>(&bench.experiment.plan))
            bench.steps = *steps;
    }

    /// One, or two at the same time.
    static std::set<Trouble> draw(support::Random &random)
    {
        const auto one = [&] {
            return static_cast<Trouble>(random.below(std::uint64_t(Trouble::Count)));
        };
        std::set<Trouble> troubles{one()};
        if (random.chance(0.4))
            troubles.insert(one());
        return troubles;
    }
    std::string what() const
    {
        std::string all = "trouble";
        for (const Trouble trouble : troubles)
            all += " " + std::to_string(int(trouble));
        return all + (lie != nullptr ? " (" + std::string(lie->name) + ")" : "");
    }
    bool has(Trouble trouble) const { return troubles.contains(trouble); }

    static simulation::BoardOptions options(
        support::Random &random, const simulation::LieInfo *lie, std::uint64_t seed)
    {
        constexpr std::array kMotors{"servo24", "pm24", "blower36", "prop12"};
        simulation::BoardOptions options;
        options.motor = kMotors[random.below(kMotors.size())];
        options.seed = seed;
        for (const simulation::BuildOption &option : simulation::buildOptions())
            if (option.name == "position") // where there is an encoder
                options.with.push_back(&option);
        if (lie != nullptr)
            options.lies = {{lie->lie}};
        return options;
    }

    void strike(Trouble trouble)
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
            pair.board->setLoadTorque(
                1, (random.chance(0.5) ? 0.02 : -0.02) * double(1 + random.below(40)));
            break;
        case Trouble::PersonStops: // as a session does it
            bench.runner->stopped();
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
        case Trouble::Lies: // from the beginning
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

    /// What an experiment may write, as the board holds it; empty where it does not answer, or not the truth.
    std::map<std::string, catalog::Value> registers()
    {
        if (lie != nullptr)
            return {};
        const catalog::Catalog &catalog = *bench.experiment.subject.catalog;
        std::map<std::string, catalog::Value> values;
        for (const char *name : {"REVUP_DATA", "CONTROL_MODE", "SPEED_KP", "SPEED_KI", "I_Q_KP",
                 "I_Q_KI", "I_D_KP", "I_D_KI"}) {
            const auto known = catalog.find(name);
            if (!known)
                continue;
            const drive::RegisterId id = catalog.withMotor(*known, 1);
            const drive::WishId read = bench.pair.submit(drive::Read{{id}});
            if (bench.pair.runUntilEnded(read) && bench.pair.outcome(read) == drive::Outcome::Ok)
                values[name] = bench.pair.values[id].value;
        }
        return values;
    }

    /// Something was asked for that moves the motor: what it did before was not of the experiment.
    bool moved() const
    {
        return std::any_of(bench.wishes.begin(), bench.wishes.end(), [](const drive::Wish &wish) {
            return !std::holds_alternative<drive::Read>(wish.what)
                && !std::holds_alternative<drive::Write>(wish.what)
                && !std::holds_alternative<drive::Stream>(wish.what)
                && !std::holds_alternative<drive::Watch>(wish.what);
        });
    }

    /// From the beginning until it is over and everything is as quiet as it gets.
    void run()
    {
        const auto before = registers();
        const bool heard = lie == nullptr && !has(Trouble::Noise) && !has(Trouble::Mute)
            && !has(Trouble::Cut) && !has(Trouble::Reset);
        BoundsWatch bounds(agreementTo(bench.experiment, runs ? 1500.0 : 0.0).caps,
            heard ? Duration(45ms) : Duration(700ms));
        bench.eachTurn = [&] {
            if (bench.runner && !bench.runner->over() && moved())
                bounds.look(bench.pair.board->truth(1), bench.pair.now);
        };
        bench.begin();
        const TimePoint when = bench.pair.now + at;
        bool struck = false;
        over = bench.runUntil(
            [&] {
                if (!struck && bench.pair.now >= when && !bench.runner->over()) {
                    struck = true;
                    for (const Trouble trouble : troubles)
                        strike(trouble);
                }
                return bench.runner->over();
            },
            90s);
        const std::size_t asked = bench.wishes.size();
        bench.pair.toDrive = bench.pair.toBoard = {};
        (void)bench.runUntil([] { return false; }, 8s);
        askedAfterwards = bench.wishes.size() - asked;
        bench.eachTurn = nullptr;
        broken = bounds.broken();
        if (!over)
            return;
        const auto after = registers();
        for (const auto &[name, value] : before)
            if (const auto now = after.find(name); now != after.end()) {
                ++compared;
                if (!drive::sameValue(value, now->second))
                    changed.push_back(name);
            }
    }

    support::Random random;
    std::set<Trouble> troubles;
    const simulation::LieInfo *lie; ///< that the board tells; nullptr: it is honest
    LabBench bench;
    bool runs = false; ///< the motor, before
    Duration at{};
    bool over = false;
    std::size_t askedAfterwards = 0;
    std::string broken; ///< what was agreed to; empty: nothing
    std::size_t compared = 0; ///< registers
    std::vector<std::string> changed;
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
    const bool obeys = scenario.lie == nullptr || scenario.lie->lie != simulation::Lie::NeverStops;
    if (bench.stops > 0 && !truth.idle && obeys) // heard as soon as there is a link
        return "stopped, and the motor is driven";
    const bool bySpeed = outcome.reason.find(" control now, it was") == std::string::npos;
    if (outcome.end == End::Interrupted && !bySpeed && truth.driven && obeys)
        return "the judge: MS28: driven by a torque or a position that nothing bounds";
    const bool same = truth.driven == scenario.runs
        && (!scenario.runs || std::abs(truth.referenceRpm - 1500.0) <= 12.0);
    const bool says = outcome.reason.find("set-point") != std::string::npos
        || outcome.end == End::Aborted || outcome.end == End::Interrupted
        || outcome.end == End::Lost;
    using simulation::Lie;
    const bool byTheBoard = scenario.has(Trouble::Load) || scenario.has(Trouble::Fault)
        || scenario.has(Trouble::Reset)
        || (scenario.lie != nullptr
            && std::set{Lie::FaultInStart, Lie::FaultInRun, Lie::FaultStays, Lie::FaultFlickers,
                Lie::NeverStops, Lie::OkButIdle, Lie::Resets, Lie::ResetsInAnswer}
                   .contains(scenario.lie->lie));
    if (!same && !says && !byTheBoard)
        return "the judge: MS32: the motor is not as it was, and nothing says so";
    if (!scenario.broken.empty())
        return scenario.broken;
    // Where the payload has no CRC, noise makes one register of another: SPEED_RAMP 0x01a9 came as 0x03a9, a torque.
    const bool onlySpeeds = bench.asked<drive::TorqueRamp>().empty()
        && bench.asked<drive::CurrentReference>().empty()
        && bench.asked<drive::PositionRamp>().empty();
    for (const std::string &name : scenario.changed) {
        if (name == "CONTROL_MODE" && scenario.has(Trouble::Noise) && onlySpeeds)
            continue;
        const std::string said = name == "CONTROL_MODE" ? " control now, it was" : name;
        if (outcome.reason.find(said) == std::string::npos)
            return "the judge: MS32: " + name + " is not as it was, and nothing says so";
    }
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
        std::size_t compared = 0;
        const auto play = [&](std::uint64_t seed) -> std::optional<std::string> {
            Scenario scenario(seed);
            LabBench &bench = scenario.bench;
            bench.pair.verdictTaken = true;
            if (!scenario.bench.experiment.subject.catalog || !scenario.prepare())
                return std::nullopt; // the motor did not start
            scenario.run();
            if (scenario.over)
                ++ends[bench.runner->outcome().end];
            compared += scenario.compared;
            const std::string wrong = whatIsWrong(scenario);
            return wrong.empty() ? wrong
                                 : wrong + ", " + scenario.what() + " with plan "
                    + std::to_string(bench.experiment.plan.index()) + ", "
                    + support::outcomeText(
                        bench.runner->over() ? bench.runner->outcome() : Outcome())
                          .toStdString();
        };
        const std::string wrong = support::playSeeds(seeds, play);
        QVERIFY2(wrong.empty(), wrong.c_str());
        qInfo(
            "complete %d, refused %d, aborted %d, interrupted %d, lost %d; %zu registers compared",
            ends[End::Complete], ends[End::Refused], ends[End::Aborted], ends[End::Interrupted],
            ends[End::Lost], compared);
        if (seeds.count >= 60)
            QVERIFY(compared > seeds.count && ends[End::Complete] > 0 && ends[End::Aborted] > 0
                && ends[End::Interrupted] > 0);
    }
};

QTEST_APPLESS_MAIN(TestExperimentFaults)
#include "tst_experiment_faults.moc"
