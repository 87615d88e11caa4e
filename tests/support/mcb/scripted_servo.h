// A drive of MCB reduced to what a stop needs, as the boards of scripted_boards.h. Both sides of this bus send at once:
// what a request brings comes in a later exchange, so what fares badly there happens to that one.
#pragma once

#include "drive/protocol_table.h"
#include "mcb/frame.h"
#include "support/mcb/quick_servo.h"
#include "support/scripted_boards.h"

namespace support {

class ScriptedServo final : public ScriptedBoard {
public:
    std::unique_ptr<drive::Drive> makeDrive() const override { return drive::makeMcbDrive({}); }
    int motors() const override { return 1; }
    bool needsExpert() const override { return false; }
    bool beginsStartsWithStop() const override { return true; }
    Duration late() const override { return std::chrono::milliseconds(700); }
    bool accept(const Bytes &output) override
    {
        m_frame = output;
        return true;
    }
    Asked asked() const override
    {
        const auto frame = mcb::decodeFrame(m_frame);
        if (!frame) // all ones, which look for the length of frames
            return {Asked::What::Link, 0};
        switch (frame->command) {
        case mcb::Command::Idle:
            return {Asked::What::Fetch, 0};
        case mcb::Command::Read:
        case mcb::Command::GetInfo:
            return {Asked::What::Read, 1};
        default:
            break;
        }
        if (frame->address != drive::mcbreg::kControl)
            return {Asked::What::Other, 1};
        return {(frame->config[0] & 1U) != 0 ? Asked::What::Start : Asked::What::Stop, 1};
    }
    char fares(char fate) override
    {
        const Asked::What what = asked().what;
        if (what == Asked::What::Fetch)
            return std::exchange(m_lose, false) ? 'a' : 'd';
        if (what == Asked::What::Link) // its answer comes at once
            return fate == 'q' ? 'q' : fate == 'd' || fate == 't' ? 'd' : 'a';
        m_lose = fate == 'a';
        m_twice = fate == 't';
        if (fate == 'l')
            m_held = kLateFetches;
        return fate == 'q' ? 'q' : 'd';
    }
    Bytes answer() override
    {
        const bool fetches = asked().what == Asked::What::Fetch;
        if (m_held > 0 && fetches) {
            --m_held;
            return mcb::encodeFrame({});
        }
        m_servo.obeys = obeys;
        Bytes mine = m_slave.exchange(m_frame);
        drives[0] = m_servo.driven();
        if (m_held > 0)
            return mcb::encodeFrame({});
        if (!m_again.empty())
            return std::exchange(m_again, {});
        if (fetches && std::exchange(m_twice, false))
            m_again = mine;
        return mine;
    }
    Bytes reset() override
    {
        m_servo.restart();
        m_slave = simulation::McbSlave(QuickServo::rig(), &m_servo);
        m_lose = m_twice = false;
        m_held = 0;
        m_again.clear();
        drives = {};
        return {};
    }

private:
    /// Exchanges of 2 ms each, at least: longer than a drive waits.
    static constexpr int kLateFetches = 300;

    QuickServo m_servo;
    simulation::McbSlave m_slave{QuickServo::rig(), &m_servo};
    Bytes m_frame, m_again;
    bool m_lose = false, m_twice = false;
    int m_held = 0;
};

} // namespace support
