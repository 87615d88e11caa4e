// A master and a slave of MCB, joined by wires that can be spoilt, on a virtual clock. The same seed gives the same
// run.
#pragma once

#include "mcb/master.h"
#include "simulation/mcb/slave.h"
#include "support/judge_speaks.h"
#include "support/wire/mcb.h"

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace support {

using namespace std::chrono_literals;

class McbBus {
public:
    explicit McbBus(simulation::McbRig rig, mcb::Master::Config config = {})
        : master(config)
        , m_rig(std::move(rig))
    {
        resetSlave();
        judge::Line line;
        line.suspect = line.lost = {};
        judge.watch(std::make_unique<judge::WireMcb>(), line);
        judge.excuse("looks first", "no drive is above the master, to look at anything");
    }
    ~McbBus() { speak(judge, true); }
    McbBus(const McbBus &) = delete;
    McbBus &operator=(const McbBus &) = delete;

    judge::MsRules judge; ///< of the wire: what was asked for is what leaves
    mcb::Master master;
    std::unique_ptr<simulation::McbSlave> slave;
    TimePoint now{1s};
    std::vector<mcb::Master::Event> events;
    std::vector<mcb::Master::Done> ended;
    std::vector<mcb::Master::Cycle> cycles;
    std::vector<Bytes> sent; ///< frames of the master
    /// What becomes of a frame to the slave, and of its answer; an answer that is shorter is torn.
    std::function<void(Bytes &)> toSlave, toMaster;
    Duration frameTime{}; ///< of an exchange

    void resetSlave() { slave = std::make_unique<simulation::McbSlave>(m_rig); }

    void exchange()
    {
        take();
        for (int round = 0; round < 1000; ++round) {
            auto outputs = master.takeOutput();
            if (outputs.empty())
                break;
            for (const Output &output : outputs) {
                sent.push_back(output.bytes);
                judge.sent(output.bytes, now);
                Bytes out = output.bytes;
                if (toSlave)
                    toSlave(out);
                Bytes in = slave->exchange(out);
                if (toMaster)
                    toMaster(in);
                now += frameTime;
                master.receive(in, now);
                take();
            }
        }
    }
    bool runUntil(const std::function<bool()> &condition, Duration limit)
    {
        const TimePoint end = now + limit;
        exchange();
        while (!condition()) {
            const auto next = master.nextTimeout();
            if (!next || *next > end) {
                now = end;
                return condition();
            }
            now = std::max(now, *next);
            master.handleTimeout(now);
            exchange();
        }
        return true;
    }
    void runFor(Duration time)
    {
        runUntil([] { return false; }, time);
    }
    bool meet()
    {
        tell(judge::Act::Kind::Open, 0);
        tell(judge::Act::Kind::Arm, 0);
        master.connect(now);
        return runUntil([this] { return master.canSend(); }, 5s);
    }
    /// How a request ends; nothing if it does not.
    std::optional<mcb::Master::Done> ask(mcb::Master::Request request, Duration limit = 5s)
    {
        const std::size_t before = ended.size();
        if (request.command == mcb::Command::Write)
            tell(judge::Act::Kind::Write, std::uint32_t{request.address} << 3 | 1U);
        master.send(std::move(request), now);
        return runUntil([&] { return ended.size() > before; }, limit) ? std::optional(ended.back())
                                                                      : std::nullopt;
    }
    std::optional<mcb::Master::Done> read(std::uint16_t address)
    {
        return ask({mcb::Command::Read, address});
    }
    std::optional<mcb::Master::Done> write(std::uint16_t address, mcb::Words words)
    {
        return ask({mcb::Command::Write, address, std::move(words)});
    }
    std::optional<mcb::Master::Done> map(const mcb::Mapping &mapping, Duration period = 1ms)
    {
        const std::size_t before = ended.size();
        master.switchOn(mapping, period, now);
        return runUntil([&] { return ended.size() > before; }, 5s) ? std::optional(ended.back())
                                                                   : std::nullopt;
    }
    /// What is to travel from now on, by the user's wish.
    void carry(mcb::Words words, const mcb::Mapping &mapping)
    {
        for (const mcb::MappedRegister &one : mapping.rx)
            tell(judge::Act::Kind::Write, std::uint32_t{one.address} << 3 | 1U);
        master.setCyclicOutput(std::move(words));
    }
    template <class What>
    std::size_t count() const
    {
        std::size_t number = 0;
        for (const auto &event : events)
            number += std::holds_alternative<What>(event) ? 1 : 0;
        return number;
    }
    template <class What>
    const What *last() const
    {
        for (auto event = events.rbegin(); event != events.rend(); ++event)
            if (const auto *what = std::get_if<What>(&*event))
                return what;
        return nullptr;
    }

private:
    void tell(judge::Act::Kind kind, std::uint32_t target)
    {
        judge::Act act;
        act.kind = kind;
        act.target = target;
        act.at = now;
        judge.act(act);
    }
    void take()
    {
        for (auto &event : master.takeEvents()) {
            if (const auto *done = std::get_if<mcb::Master::Done>(&event))
                ended.push_back(*done);
            else if (const auto *cycle = std::get_if<mcb::Master::Cycle>(&event))
                cycles.push_back(*cycle);
            else
                events.push_back(std::move(event));
        }
    }

    simulation::McbRig m_rig;
};

} // namespace support
