// Experiments of a session whose cable is pulled at any moment, and whose user stops, disarms or takes over: it ends
// once, what it drove is stopped as soon as the board is reached again, nothing starts again, and what it borrowed is
// as it was or is named. ROTORSCOPE_LONG=1 tries a thousand of them; support/seeds.h says which others.
#include "core/lab/drawn_plans.h"
#include "core/session/link/lab_world.h"
#include "drive/values.h"
#include "support/seeds.h"

#include <QtTest>

using namespace std::chrono_literals;
using drive::MotorState;
using support::LabWorld;

namespace {

enum class Deed : std::uint8_t { Nothing, Stop, Disarm, Command, Close };

struct Scenario {
    support::Random random;
    LabWorld world;
    const bool runs = random.chance(0.5); ///< the motor, before
    const bool pulls = random.chance(0.7); ///< the cable is pulled
    const Deed deed = static_cast<Deed>(random.below(pulls ? 2 : 5));
    const Duration at = std::chrono::milliseconds(random.below(8000));
    const Duration out = std::chrono::milliseconds(random.below(6000));
    lab::Plan plan;
    drive::WishId lastWish = 0;
    std::size_t compared = 0; ///< registers

    static simulation::BoardOptions board(support::Random &random, std::uint64_t seed)
    {
        constexpr std::array kMotors{"servo24", "pm24", "blower36", "prop12"};
        simulation::BoardOptions options;
        options.motor = kMotors[random.below(kMotors.size())];
        options.seed = seed;
        return options;
    }
    explicit Scenario(std::uint64_t seed)
        : random(seed)
        , world(board(random, seed))
    {
        world.line.verdictTaken = true;
        world.endpoint = {session::Endpoint::Kind::Serial, QStringLiteral("bench"), 1'843'200, {},
            true}; // it is opened again by itself
    }

    template <class What>
    bool ask(What what)
    {
        const drive::WishId id = ++lastWish;
        world.session.submit({.id = id, .what = std::move(what)});
        return world.runUntil(
            [&] {
                return std::any_of(
                    world.events.begin(), world.events.end(), [id](const drive::Event &event) {
                        const auto *ended = std::get_if<drive::Ended>(&event);
                        return ended != nullptr && ended->id == id;
                    });
            },
            5s);
    }
    bool prepare()
    {
        if (!world.connect())
            return false;
        plan = support::drawnPlan(random, *lab::subjectOf(*world.board(), 1));
        if (!runs)
            return true;
        return ask(drive::SpeedRamp{1, 1500, 500ms})
            && ask(drive::Command{drive::MotorAction::Start, 1})
            && world.runUntil([&] { return world.status->state == MotorState::Running; }, 10s)
            && ask(drive::SpeedRamp{1, 1500, 500ms}) && (world.run(2s), true);
    }
    /// As the board has it now; nothing if it does not answer.
    std::optional<catalog::Value> valueOf(const char *name)
    {
        const drive::RegisterId id =
            world.board()->catalog->withMotor(*world.board()->catalog->find(name), 1);
        const std::size_t before = world.events.size();
        if (!ask(drive::Read{{id}}))
            return std::nullopt;
        std::optional<catalog::Value> value;
        for (std::size_t i = before; i < world.events.size(); ++i)
            if (const auto *read = std::get_if<drive::RegistersRead>(&world.events[i]))
                for (const drive::Reading &reading : read->readings)
                    if (reading.id == id && reading.status == drive::ReadStatus::Ok)
                        value = reading.value;
        return value;
    }
    std::map<std::string, catalog::Value> held()
    {
        std::map<std::string, catalog::Value> values;
        for (const char *name : {"REVUP_DATA", "CONTROL_MODE", "SPEED_KP", "SPEED_KI"})
            if (const auto value = valueOf(name))
                values[name] = *value;
        return values;
    }
    void act()
    {
        switch (deed) {
        case Deed::Nothing:
            break;
        case Deed::Stop:
            world.session.stop();
            break;
        case Deed::Disarm:
            world.session.setArmed(false);
            break;
        case Deed::Command:
            world.session.submit(
                {.id = ++lastWish, .what = drive::Command{drive::MotorAction::StopRamp, 1}});
            break;
        case Deed::Close:
            world.session.stop();
            world.session.close();
            break;
        }
    }
};

/// Empty if nothing is.
std::string whatIsWrong(Scenario &scenario)
{
    LabWorld &world = scenario.world;
    const auto before = scenario.held();
    world.session.run({scenario.plan, *lab::subjectOf(*world.board(), 1)});
    const auto ended = [&] { return !world.outcomes.empty(); };
    (void)world.runUntil(ended, scenario.at);
    const bool inTime = !ended();
    if (inTime)
        scenario.act();
    if (scenario.pulls) {
        world.line.plugged = false;
        world.run(scenario.out);
        world.line.plugged = true;
    }
    if (!world.runUntil(ended, 60s))
        return "it does not end";
    world.run(10s);
    if (world.outcomes.size() != 1)
        return "it ends more than once";
    const lab::Outcome &outcome = world.outcomes.front();
    const std::string &reason = outcome.reason;
    if (outcome.end != lab::End::Complete && reason.empty())
        return "no reason";
    const bool driven = world.line.isDriven();
    const bool moved = outcome.end == lab::End::Aborted || outcome.end == lab::End::Lost;
    const bool takenOver =
        inTime && (scenario.deed == Deed::Disarm || scenario.deed == Deed::Command);
    if (driven && !scenario.runs && !takenOver)
        return "the judge: MS32: a motor that stood is driven: " + reason;
    if (driven && moved && reason.find("Stop") != std::string::npos)
        return "the judge: MS29: it was to be stopped and is driven: " + reason;
    if (driven && takenOver && reason.find("was told to stop") != std::string::npos)
        return "the judge: MS29: it was to be stopped and is driven: " + reason;
    if (driven && inTime && (scenario.deed == Deed::Stop || scenario.deed == Deed::Close))
        return "the judge: MS29: it was stopped by hand and is driven: " + reason;
    if (scenario.deed == Deed::Close)
        return world.line.verdict();
    if (!driven && scenario.runs && outcome.end == lab::End::Complete && !scenario.pulls)
        return "the judge: MS32: a motor that ran was left standing: " + reason;
    for (const auto &[name, value] : scenario.held()) {
        ++scenario.compared;
        const auto old = before.find(name);
        const std::string said = name == "CONTROL_MODE" ? " control now, it was" : name;
        if (old != before.end() && !drive::sameValue(old->second, value)
            && reason.find(said) == std::string::npos)
            return "the judge: MS32: " + name + " is not as it was, and nothing says so: " + reason;
    }
    return world.line.verdict();
}

} // namespace

class TestSessionExperimentFaults : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whateverIsPulledItEndsOnceAndNothingIsLeftUnsaid()
    {
        std::map<lab::End, int> ends;
        std::size_t compared = 0;
        const support::Seeds seeds = support::seedsOf(30, 1000);
        const std::string wrong =
            support::playSeeds(seeds, [&](std::uint64_t seed) -> std::optional<std::string> {
                Scenario scenario(seed);
                if (!scenario.prepare())
                    return std::nullopt; // the motor did not start
                std::string found = whatIsWrong(scenario);
                compared += scenario.compared;
                if (scenario.world.outcomes.size() == 1)
                    ++ends[scenario.world.outcomes.front().end];
                return found;
            });
        QVERIFY2(wrong.empty(), wrong.c_str());
        qInfo("complete %d, refused %d, aborted %d, interrupted %d, lost %d",
            ends[lab::End::Complete], ends[lab::End::Refused], ends[lab::End::Aborted],
            ends[lab::End::Interrupted], ends[lab::End::Lost]);
        if (!seeds.one && seeds.count >= 30)
            QVERIFY(compared > seeds.count && ends[lab::End::Complete] > 0
                && ends[lab::End::Interrupted] > 0 && ends[lab::End::Lost] > 0);
    }
};

QTEST_GUILESS_MAIN(TestSessionExperimentFaults)
#include "tst_session_experiment_faults.moc"
