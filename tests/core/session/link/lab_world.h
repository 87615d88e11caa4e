// A session with a simulated board on a judged line, on virtual time, for experiments: the world goes on as the
// session's own timer would have it.
#pragma once

#include "lab/experiment.h"
#include "session/link/session.h"
#include "session/recording/lent_note.h"
#include "support/judged_line.h"

namespace support {

struct LabWorld {
    TimePoint now{1000s};
    support::JudgedWorld line;
    session::Session session;
    session::Endpoint endpoint;
    std::vector<drive::Event> events;
    std::vector<lab::Outcome> outcomes;
    std::vector<std::pair<TimePoint, capture::StreamLayout>> layouts;
    std::optional<drive::MotorStatus> status;

    static simulation::BoardOptions servo()
    {
        simulation::BoardOptions options;
        options.motor = "servo24";
        return options;
    }
    /// @param note  that the session keeps; nullptr: none
    explicit LabWorld(simulation::BoardOptions options = servo(),
        const std::shared_ptr<session::LentNote> &note = nullptr)
        : line(std::move(options), drive::Protocol::Mcp, [this] { return now; })
        , session(note ? session::noted(line.parts(), note) : line.parts())
    {
        QObject::connect(
            &session, &session::Session::batch, &session, [this](const session::BatchPtr &batch) {
                for (const drive::Event &event : batch->events) {
                    if (const auto *motor = std::get_if<drive::MotorStatus>(&event))
                        status = *motor;
                    else if (const auto *stream = std::get_if<drive::StreamStarted>(&event))
                        layouts.emplace_back(now, stream->layout);
                    if (!std::holds_alternative<capture::SampleBlock>(event))
                        events.push_back(event);
                }
                session.acknowledge();
            });
        QObject::connect(&session, &session::Session::experimentEnded, &session,
            [this](const lab::Outcome &outcome) { outcomes.push_back(outcome); });
    }

    bool runUntil(const std::function<bool()> &condition, Duration limit)
    {
        const TimePoint end = now + limit;
        while (!condition()) {
            const auto next = session.nextStep();
            if (!next || *next > end) {
                now = end;
                session.step(now);
                return condition();
            }
            now = std::max(*next, now + 1us);
            session.step(now);
        }
        return true;
    }
    void run(Duration time)
    {
        (void)runUntil([] { return false; }, time);
    }

    const drive::Identified *board() const
    {
        for (auto at = events.rbegin(); at != events.rend(); ++at)
            if (const auto *found = std::get_if<drive::Identified>(&*at))
                return found;
        return nullptr;
    }
    bool connect()
    {
        session.open(endpoint);
        if (!runUntil([this] { return board() != nullptr && status.has_value(); }, 5s))
            return false;
        session.setArmed(true);
        return true;
    }
    drive::RegisterId id(const char *name) const { return *board()->catalog->resolve(name); }
    lab::Experiment experiment(lab::StepPlan plan = {.fromRpm = 1000, .toRpm = 1500}) const
    {
        return {plan, *lab::subjectOf(*board(), 1)};
    }
    template <class Event>
    std::vector<Event> all() const
    {
        std::vector<Event> found;
        for (const drive::Event &event : events)
            if (const auto *match = std::get_if<Event>(&event))
                found.push_back(*match);
        return found;
    }
    bool steps(Duration limit = 20s)
    {
        return runUntil(
            [this] {
                return status->state == drive::MotorState::Running && status->speedRpm
                    && std::abs(*status->speedRpm - 1500.0) < 100.0;
            },
            limit);
    }
    bool ends(Duration limit = 30s)
    {
        return runUntil([this] { return !outcomes.empty(); }, limit);
    }
    bool idles(Duration limit = 5s)
    {
        return runUntil([this] { return status->state == drive::MotorState::Idle; }, limit);
    }
};

} // namespace support
