// A drive with the judge of the wire beside it: hands everything on and tells the judge what the user asked for through
// the drive's verbs, what arrived, and what the drive says. What leaves is told by the bench, with its time.
#pragma once

#include "drive/drive.h"
#include "support/ms_rules.h"

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace support {

class JudgedDrive : public drive::Drive {
public:
    /// @param judge  outlives the drive
    JudgedDrive(std::unique_ptr<drive::Drive> drive, judge::MsRules &judge)
        : m_drive(std::move(drive))
        , m_judge(judge)
    {
    }

    void connect(TimePoint now) override
    {
        tell(judge::Act::Kind::Open, now);
        m_drive->connect(now);
    }
    void disconnect(TimePoint now) override
    {
        tell(judge::Act::Kind::Close, now);
        m_drive->disconnect(now);
    }
    void receive(ByteView bytes, TimePoint now) override
    {
        m_now = now;
        m_judge.heard(bytes, now);
        m_drive->receive(bytes, now);
    }
    void handleTimeout(TimePoint now) override
    {
        m_now = now;
        m_drive->handleTimeout(now);
    }
    void handleSent(TimePoint now) override
    {
        m_now = now;
        m_drive->handleSent(now);
    }
    void handleReady(bool high, TimePoint now) override
    {
        m_now = now;
        m_drive->handleReady(high, now);
    }
    [[nodiscard]] std::vector<Output> takeOutput() override { return m_drive->takeOutput(); }
    [[nodiscard]] std::vector<drive::Event> takeEvents() override
    {
        auto events = m_drive->takeEvents();
        for (const drive::Event &event : events)
            hear(event);
        return events;
    }
    [[nodiscard]] std::optional<TimePoint> nextTimeout() const override
    {
        return m_drive->nextTimeout();
    }
    void submit(drive::Wish wish, TimePoint now) override
    {
        m_now = now;
        m_judge.asked(wish.id, now);
        m_madeAt = std::min(wish.madeAt.value_or(now), now);
        std::visit([&](const auto &what) { ask(wish.id, what); }, wish.what);
        m_drive->submit(std::move(wish), now);
    }
    void stop(TimePoint now) override
    {
        tell(judge::Act::Kind::Stop, now);
        m_drive->stop(now);
    }
    void arm() override
    {
        tell(judge::Act::Kind::Arm, m_now);
        m_drive->arm();
    }
    void disarm() override
    {
        tell(judge::Act::Kind::Disarm, m_now);
        m_drive->disarm();
    }
    void doubt(TimePoint now) override
    {
        tell(judge::Act::Kind::Disarm, now);
        m_drive->doubt(now);
    }
    bool armed() const override { return m_drive->armed(); }
    Duration gathersFor() const override { return m_drive->gathersFor(); }
    bool stopOpen() const override { return m_drive->stopOpen(); }
    [[nodiscard]] std::vector<Output> stopScript() const override { return m_drive->stopScript(); }
    void remember(const drive::LineMemory &memory) override { m_drive->remember(memory); }
    drive::LineMemory memory() const override { return m_drive->memory(); }

private:
    using Act = judge::Act;

    void tell(Act::Kind kind, TimePoint now)
    {
        m_now = now;
        Act act;
        act.kind = kind;
        act.at = now;
        m_judge.act(act);
    }
    Act of(Act::Kind kind, drive::WishId id, int motor) const
    {
        Act act;
        act.kind = kind;
        act.id = id;
        act.motor = motor;
        act.at = m_madeAt;
        return act;
    }

    // What a wish means as an act of the user.
    template <class Other>
    void ask(drive::WishId, const Other &)
    {
    }
    void ask(drive::WishId id, const drive::Write &write)
    {
        // As of a restore: nothing else, whatever it holds.
        if (write.reach == drive::Reach::Parameters)
            return m_judge.act(of(Act::Kind::Restore, id, 0));
        for (const drive::RegisterWrite &one : write.writes) {
            Act act = of(Act::Kind::Write, id, 0);
            act.target = one.id;
            m_judge.act(act);
        }
    }
    void ask(drive::WishId id, const drive::Command &command)
    {
        using enum drive::MotorAction;
        m_judge.act(of(command.action == Start ? Act::Kind::Start
                : command.action == StopMotor  ? Act::Kind::StopMotor
                : command.action == StopRamp   ? Act::Kind::StopRamp
                                               : Act::Kind::Acknowledge,
            id, command.motor));
    }
    void ask(drive::WishId id, const drive::SpeedRamp &ramp)
    {
        Act act = of(Act::Kind::SetPoint, id, ramp.motor);
        act.rpm = ramp.rpm;
        m_judge.act(act);
    }
    void ask(drive::WishId id, const drive::TorqueRamp &ramp)
    {
        Act act = of(Act::Kind::SetPoint, id, ramp.motor);
        act.amps = ramp.amps;
        m_judge.act(act);
    }
    void ask(drive::WishId id, const drive::CurrentReference &reference)
    {
        Act act = of(Act::Kind::SetPoint, id, reference.motor);
        act.amps = std::hypot(reference.iqAmps, reference.idAmps);
        m_judge.act(act);
    }
    void ask(drive::WishId id, const drive::PositionRamp &ramp)
    {
        m_judge.act(of(Act::Kind::SetPoint, id, ramp.motor));
    }
    void ask(drive::WishId id, const drive::UserLimits &limits)
    {
        Act act = of(Act::Kind::Limits, id, 0);
        act.rpm = limits.maxSpeedRpm;
        act.amps = limits.maxCurrentAmps;
        m_judge.act(act);
    }
    void ask(drive::WishId id, const drive::CurrentScale &scale)
    {
        Act act = of(Act::Kind::Scale, id, scale.motor);
        act.amps = scale.fullScaleAmps;
        m_judge.act(act);
    }

    void hear(const drive::Event &event)
    {
        if (const auto *link = std::get_if<drive::LinkChanged>(&event)) {
            m_judge.said(linkOf(link->state), m_now);
            if (link->reason == drive::LinkReason::BoardReset)
                m_judge.saidIdentified(0, m_now); // it is met anew
        } else if (const auto *found = std::get_if<drive::Identified>(&event)) {
            m_judge.saidIdentified(found->identity.motors, m_now);
        } else if (const auto *end = std::get_if<drive::Ended>(&event)) {
            m_judge.saidEnded(end->id, m_now);
        } else if (const auto *status = std::get_if<drive::MotorStatus>(&event)) {
            m_judge.saidStatus(status->at, m_now);
        } else if (const auto *stop = std::get_if<drive::StopProgress>(&event)) {
            m_judge.said(wordOf(stop->word), stop->motor, m_now);
        }
    }
    static judge::LinkState linkOf(drive::LinkState state)
    {
        switch (state) {
        case drive::LinkState::Closed:
            return judge::LinkState::Closed;
        case drive::LinkState::Connecting:
            return judge::LinkState::Connecting;
        case drive::LinkState::Connected:
            return judge::LinkState::Connected;
        case drive::LinkState::Suspect:
            return judge::LinkState::Suspect;
        case drive::LinkState::Recovering:
            return judge::LinkState::Recovering;
        case drive::LinkState::Lost:
            break;
        }
        return judge::LinkState::Lost;
    }
    static judge::Word wordOf(drive::StopWord word)
    {
        switch (word) {
        case drive::StopWord::Requested:
            return judge::Word::Requested;
        case drive::StopWord::Accepted:
            return judge::Word::Accepted;
        case drive::StopWord::DriveIdle:
        case drive::StopWord::MayCoast: // says no more of the rotor
            return judge::Word::DriveIdle;
        case drive::StopWord::Standstill:
            return judge::Word::Standstill;
        case drive::StopWord::NotConfirmed:
            break;
        }
        return judge::Word::NotConfirmed;
    }

    std::unique_ptr<drive::Drive> m_drive;
    judge::MsRules &m_judge;
    TimePoint m_now{};
    TimePoint m_madeAt{}; ///< of the act behind the wish that is being submitted
};

} // namespace support
