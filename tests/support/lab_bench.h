// An experiment on a simulated board, on virtual time: the runner between a judged drive and its wishes, as a session
// has it, and what a recording of it would hold.
#pragma once

#include "drive/stop_sequence.h"
#include "drive/values.h"
#include "lab/evaluation/step_series.h"
#include "lab/runner.h"
#include "recorded/drive_entries.h"
#include "recorded/restore.h"
#include "support/link_pair.h"

// Runs `ended` once. A macro, so that the test ends where it stands, as with QVERIFY.
#define VERIFY_END(ended, wanted)                                                                  \
    do {                                                                                           \
        const lab::Outcome it = ended;                                                             \
        QVERIFY2(it.end == (wanted), qPrintable(support::outcomeText(it)));                        \
    } while (false)

namespace support {

/// A board with an encoder.
inline simulation::BoardOptions servo(std::uint64_t seed = 1)
{
    simulation::BoardOptions options;
    options.motor = "servo24";
    options.seed = seed;
    return options;
}

inline QString outcomeText(const lab::Outcome &outcome)
{
    return QStringLiteral("%1: %2")
        .arg(int(outcome.end))
        .arg(QString::fromStdString(outcome.reason));
}

/// @tparam Pair  the drive and its board: a Session, or what is as one
template <class Pair>
struct LabBenchOn {
    Pair pair;
    lab::Experiment experiment;
    lab::StepPlan steps{
        .fromRpm = 1000, .toRpm = 1500, .repeat = 2}; ///< unless told otherwise, what is tried
    std::optional<lab::Runner> runner;
    capture::Capture capture;
    lab::Happenings happenings;
    std::vector<drive::Wish> wishes; ///< all that it asked for
    int stops = 0;
    std::optional<TimePoint> ranAt; ///< as a session knows it
    Duration held{}; ///< a wish waits so long before it is handed on: a host that stalls
    std::function<void()> eachTurn; ///< as the world goes on
    std::function<void(recorded::Nanos, const recorded::Entry &)> eachEntry; ///< for a file of it
    std::function<bool(const recorded::Entry &)> loses; ///< and keeps out of the capture

    template <class... Args>
    explicit LabBenchOn(const Args &...args)
        : pair(args...)
        , restorer(capture)
    {
        const auto subject = pair.ready ? lab::pollableSubjectOf(*pair.identified, 1)
                                        : Result<lab::Subject, std::string>(fail(std::string()));
        if (subject)
            experiment.subject = *subject;
        if (pair.ready)
            (void)entries.accept(drive::Event(*pair.identified)); // so that registers have names
        pair.onEvent = [this](const drive::Event &event) {
            if (const auto *status = std::get_if<drive::MotorStatus>(&event);
                status != nullptr && !drive::isDriveIdle(*status))
                ranAt = pair.now;
            for (recorded::Entry &entry : entries.accept(event))
                keep(entry);
            if (runner)
                runner->accept(event, pair.now);
        };
    }

    double number(drive::RegisterId id)
    {
        if (id == 0)
            return 0.0;
        const drive::WishId read = pair.submit(drive::Read{{id}});
        return pair.runUntilEnded(read) ? drive::asNumber(pair.values[id].value).value_or(0.0)
                                        : 0.0;
    }

    void begin()
    {
        if (std::holds_alternative<lab::StepPlan>(experiment.plan))
            experiment.plan = steps;
        const lab::Registers &registers = experiment.subject.registers;
        const auto gainOf = [&](drive::RegisterId id, drive::RegisterId exponent) {
            return lab::jumpPerRpm(experiment.subject, number(id), number(exponent));
        };
        if (const auto *response = std::get_if<lab::ResponsePlan>(&experiment.plan))
            keep(lab::entryOf(*response, experiment.subject,
                response->kp > 0
                    ? lab::SpeedRegulator{lab::jumpPerRpm(experiment.subject, response->kp,
                                              number(registers.gainExponent)),
                        lab::jumpPerRpm(
                            experiment.subject, response->ki, number(registers.integralExponent)),
                        1e-3}
                    : lab::SpeedRegulator{gainOf(registers.gain, registers.gainExponent),
                        gainOf(registers.integral, registers.integralExponent), 1e-3}));
        else if (std::holds_alternative<lab::StepPlan>(experiment.plan))
            keep(lab::entryOf(
                experiment, {.proportional = gainOf(registers.gain, registers.gainExponent)}));
        else
            keep(lab::entryOf(experiment, {}));
        runner.emplace(experiment);

        runner->begin(pair.now, ranAt);
    }

    /// One turn of a session: what the runner wants is handed to the drive.
    void turn()
    {
        runner->advance(pair.now);
        if (runner->takeStop()) {
            ++stops;
            pair.drive->stop(pair.now);
        }
        for (drive::Wish &wish : runner->takeWishes())
            waiting.push_back({pair.now + held, std::move(wish)});
        if (runner->over())
            waiting.clear(); // a host that stalls does so as a whole
        while (!waiting.empty() && waiting.front().first <= pair.now) {
            drive::Wish wish = std::move(waiting.front().second);
            waiting.pop_front();
            wishes.push_back(wish);
            for (recorded::Entry &entry : entries.accept(wish))
                keep(entry);
            wish.madeAt = pair.now;
            pair.drive->submit(std::move(wish), pair.now);
        }
        pair.exchange();
        if (eachTurn)
            eachTurn();
    }

    bool runUntil(const std::function<bool()> &condition, Duration limit = 60s)
    {
        return pair.runUntil(
            [&] {
                turn();
                return condition();
            },
            limit);
    }
    /// From begin() to the end.
    lab::Outcome run()
    {
        begin();
        if (!runUntil([this] { return runner->over(); }))
            return {lab::End::Refused, "it never ended", {}};
        const lab::Outcome outcome = runner->outcome();
        keep(lab::entryOfEnd(outcome));
        return outcome;
    }
    Result<lab::StepSeries, std::string> series() const
    {
        return lab::stepSeries(capture, happenings);
    }

    template <class What>
    std::vector<What> asked() const
    {
        std::vector<What> found;
        for (const drive::Wish &wish : wishes)
            if (const auto *what = std::get_if<What>(&wish.what))
                found.push_back(*what);
        return found;
    }

private:
    void keep(const recorded::Entry &entry)
    {
        const recorded::Nanos at = pair.now.time_since_epoch().count();
        if (eachEntry)
            eachEntry(at, entry);
        if (const auto *happening = std::get_if<recorded::Happening>(&entry))
            happenings.emplace_back(at, *happening);
        else if (!loses || !loses(entry))
            restorer.accept(entry);
    }

    recorded::DriveEntries entries;
    recorded::Restorer restorer;
    std::deque<std::pair<TimePoint, drive::Wish>> waiting;
};

struct LabBench : LabBenchOn<Session> {
    explicit LabBench(const simulation::BoardOptions &options = servo(), std::uint64_t seed = 1)
        : LabBenchOn(true, options, seed)
    {
    }
};

} // namespace support
