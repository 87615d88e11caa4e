// What a protocol brings to the engine of drives; it passes the same test as the real ones (tst_drive_conformance).
#pragma once

#include "core/drive/toy_board.h"
#include "drive/act_task.h"
#include "drive/drawn_watch.h"
#include "drive/set_point_check.h"
#include "drive/stepwise_write.h"
#include "drive/task_drive.h"
#include "drive/vitals.h"
#include "drive/write_check.h"

namespace support::toy {

using namespace drive;

/// The machine of the link: one request at a time; met once the state has been answered.
class Link {
public:
    struct Config { };
    enum class What : std::uint8_t { Met, Answer, NoAnswer, Lost };
    struct Event {
        What what;
        Frame answer{};
    };
    explicit Link(const Config &) { }

    bool met() const { return m_met; }
    bool canSend() const { return m_met && !m_deadline; }
    void connect(TimePoint now)
    {
        close();
        send({'R', State, 0}, now);
    }
    void close()
    {
        m_met = false;
        m_losses = 0;
        m_deadline.reset();
    }
    void send(const Frame &frame, TimePoint now)
    {
        m_output.push_back({encode(frame)});
        m_asked = frame;
        m_deadline = now + 50ms;
    }
    void receive(ByteView bytes, TimePoint)
    {
        m_in.insert(m_in.end(), bytes.begin(), bytes.end());
        while (const auto frame = nextFrame(m_in)) {
            if (!m_deadline || frame->address != m_asked.address)
                continue;
            m_deadline.reset();
            m_losses = 0;
            m_events.push_back({std::exchange(m_met, true) ? What::Answer : What::Met, *frame});
        }
    }
    void handleTimeout(TimePoint now)
    {
        if (!m_deadline || now < *m_deadline)
            return;
        m_deadline.reset();
        const bool lost = !m_met || ++m_losses == 3;
        m_events.push_back({lost ? What::Lost : What::NoAnswer});
        if (lost)
            close();
    }
    std::vector<Output> takeOutput() { return std::exchange(m_output, {}); }
    std::vector<Event> takeEvents() { return std::exchange(m_events, {}); }
    std::optional<TimePoint> nextTimeout() const { return m_deadline; }

private:
    bool m_met = false;
    int m_losses = 0; ///< in a row
    Frame m_asked;
    std::optional<TimePoint> m_deadline; ///< of the answer
    Bytes m_in;
    std::vector<Output> m_output;
    std::vector<Event> m_events;
};

class Identification;
class Reads;
class States;
class WriteOne;

struct Protocol {
    using Request = Frame;
    using Answer = Frame;
    using Facts = BoardFacts;
    using Link = toy::Link;
    using Identification = toy::Identification;
    using Vitals = States;
    using Watch = DrawnWatch<Protocol>;
    using Reads = toy::Reads;
    using Writes = WriteOne;
    static constexpr int kAttempts = 2;
    static std::vector<StateStep> stateSteps() { return {}; }
    static AnswerEnd endIn(const Frame &answer)
    {
        return answer.kind == 'N' ? AnswerEnd{Outcome::Refused, "no"} : AnswerEnd{};
    }
};

constexpr RegisterId idOf(Address address) { return RegisterId{address} << 3 | 1U; }

class Reads : public PlainReads<BoardFacts> {
public:
    using PlainReads::PlainReads;
    static std::optional<ReadStatus> refuse(const BoardFacts &board, RegisterId id)
    {
        return board.catalog->find(id) ? std::nullopt : std::optional(ReadStatus::NotSupported);
    }
    static Frame request(std::span<const RegisterId> ids, std::size_t &count)
    {
        count = 1;
        return {'R', static_cast<std::uint8_t>(ids.front() >> 3), 0};
    }
    static std::optional<std::vector<Reading>> readings(
        std::span<const RegisterId> ids, const Frame &answer, TimePoint now)
    {
        const auto status = answer.kind == 'N' ? ReadStatus::Refused : ReadStatus::Ok;
        return std::vector<Reading>{{ids.front(), status, std::int64_t{answer.value}, now}};
    }
};

class Identification : public Task<Protocol> {
public:
    explicit Identification(BoardFacts &board)
        : m_board(board)
    {
    }
    void restart() { m_board.identified = false; }

    std::optional<Frame> nextRequest(TimePoint) override { return Frame{'R', MaxSpeed, 0}; }
    void onNoResponse(std::optional<bool>, TimePoint) override { }
    void onResponse(const Frame &answer, TimePoint) override
    {
        std::vector<catalog::RegisterInfo> registers;
        for (const auto &[address, name] :
            {std::pair{Speed, "SPEED_MEAS"}, {MaxSpeed, "MAX_SPEED"}, {Gain, "SPEED_KP"}}) {
            catalog::RegisterInfo info;
            info.id = RegisterId{address} << 3;
            info.name = name;
            info.type = catalog::ValueType::S16;
            info.effect = catalog::Effect::Kept;
            info.access = address == Gain ? catalog::Access::ReadWrite : catalog::Access::Read;
            registers.push_back(std::move(info));
        }
        m_board.catalog = std::make_shared<const catalog::Catalog>(
            std::move(registers), 1, std::vector<catalog::Scales>{{}});
        m_board.limits = {{double(answer.value), 1.0, 1.0}};
        m_board.identity.protocol = "toy";
        const std::set able{
            Feature::Start, Feature::Stop, Feature::SpeedRamp, Feature::WriteRegisters};
        m_board.capabilities.clear();
        for (const Capability &one : noFeatures("no"))
            m_board.tell(one.feature, able.contains(one.feature) ? "" : one.reason);
        m_board.motorsCounted = m_board.knownFirmware = m_board.identified = true;
    }

private:
    BoardFacts &m_board;
};

class States : public Vitals<Protocol> {
public:
    using Vitals::Vitals;

private:
    std::vector<RegisterId> idsToRead() override { return {idOf(Speed), idOf(State)}; }
    std::optional<MotorStatus> statusOf(int) const override
    {
        constexpr std::array kStates{
            MotorState::Idle, MotorState::Running, MotorState::Stopping, MotorState::FaultNow};
        const Value *state = valueOf(idOf(State)), *speed = valueOf(idOf(Speed));
        MotorStatus status;
        if (state == nullptr || speed == nullptr)
            return std::nullopt;
        status.rawState = std::get<std::int64_t>(*state);
        status.state = kStates.at(static_cast<std::size_t>(status.rawState));
        status.speedRpm = asNumber(*speed);
        status.speedMeasured = true;
        return status;
    }
};

class WriteOne : public StepwiseWrite<Protocol> {
public:
    using StepwiseWrite::StepwiseWrite;

private:
    std::string plan(const RegisterWrite &one) override
    {
        readBefore();
        write({'W', static_cast<std::uint8_t>(one.id >> 3),
            static_cast<std::int16_t>(asNumber(one.value).value_or(0.0))});
        return refuseWrite(m_board, one, m_reach);
    }
};

/// A write that leaves once.
class Act : public ActTask<Protocol> {
public:
    Act(WishId id, const auto &act, const BoardFacts &board, Frame frame, std::string why = {})
        : ActTask(id, act, board)
        , m_frame(frame)
        , m_why(std::move(why))
    {
    }

private:
    std::string refuse() const override { return m_why; }
    std::string plan() override
    {
        request(m_frame);
        return {};
    }

    Frame m_frame;
    std::string m_why;
};

class ToyDrive final : public TaskDrive<Protocol> {
public:
    ToyDrive()
        : TaskDrive({})
    {
    }
    std::vector<Output> stopScript() const override { return {{encode(kStop)}}; }

private:
    Made taskFor(const Wish &wish) override
    {
        const auto make = [&](const auto &act, Frame frame, std::string why = {}) -> Made {
            return std::make_unique<Act>(wish.id, act, m_board, frame, std::move(why));
        };
        if (const auto *ramp = std::get_if<SpeedRamp>(&wish.what))
            return make(*ramp, {'W', Target, static_cast<std::int16_t>(ramp->rpm)},
                refuseSpeed(m_board, ramp->motor, ramp->rpm));
        const auto *command = std::get_if<Command>(&wish.what);
        if (command != nullptr && command->action == MotorAction::Start)
            return make(*command, {'W', Control, toy::Start}, refuseStart(m_board, command->motor));
        if (command != nullptr && command->action == MotorAction::StopMotor)
            return make(*command, kStop);
        return nullptr;
    }
    void onLinkEvents(TimePoint now) override
    {
        for (const Link::Event &event : m_link.takeEvents()) {
            if (event.what == Link::What::Lost) {
                linkLost(LinkReason::NoAnswer, now);
            } else if (event.what == Link::What::Met) {
                linkFound();
                meet(LinkReason::None, now);
            } else if (m_task != nullptr) {
                event.what == Link::What::Answer ? passAnswer(event.answer, now)
                                                 : passLoss(std::nullopt, now);
            } else {
                onStopAnswer(event.what == Link::What::Answer, now);
            }
        }
    }
    bool connected() const override { return m_link.met(); }
    bool send(const Frame &request, WishTask<Protocol> *wish, TimePoint now) override
    {
        if (wish != nullptr && wish->motion() && request.kind == 'W')
            noteSent(*wish->motion(), encode(request));
        m_link.send(request, now);
        return true;
    }
    void sendStop(int motor, TimePoint now) override
    {
        if (m_task != nullptr)
            passLoss(std::nullopt, now); // whatever comes, the STOP has overtaken it
        noteStop(motor, encode(kStop), now);
        m_stopUnderWay = connected();
        m_stopSince = now;
        m_link.send(kStop, now);
    }
    void closeLink() override { m_link.close(); }
};

} // namespace support::toy
