// A simulated board on virtual time and the least of a Controller: it sends bytes, lets time pass and cuts what comes
// back into packets. `now` moves only where a test moves it.
#pragma once

#include "aspep/packet.h"
#include "mcp/protocol.h"
#include "simulation/simulated_board.h"

#include <memory>
#include <vector>

namespace support {

using namespace std::chrono_literals;
using simulation::BoardOptions;

/// A Controller that does the least: it sends bytes, lets time pass and cuts what comes back into packets.
struct BoardBench {
    explicit BoardBench(BoardOptions options = {})
        : board(simulation::makeBoard(options))
    {
        pass(1ms);
    }

    void pass(Duration time)
    {
        now += time;
        board->advance(now);
        const Bytes bytes = board->takeOutput();
        heard.insert(heard.end(), bytes.begin(), bytes.end());
    }
    void send(const aspep::Header &header)
    {
        const auto bytes = aspep::encodeHeader(header);
        board->receive(bytes, now);
    }
    void sendRequest(ByteView payload, Duration pause = 1500us)
    {
        send(aspep::Data{false, static_cast<std::uint16_t>(payload.size())});
        pass(pause);
        board->receive(payload, now);
    }
    std::vector<aspep::Packet> packets(Duration time)
    {
        pass(time);
        std::vector<aspep::Packet> out;
        std::size_t at = 0;
        while (at + 4 <= heard.size()) {
            const auto header =
                aspep::decodeHeader({heard[at], heard[at + 1], heard[at + 2], heard[at + 3]});
            if (!header)
                break;
            aspep::Packet packet{*header, {}};
            std::size_t size = 0;
            if (const auto *data = std::get_if<aspep::Data>(&*header))
                size = data->length;
            if (at + 4 + size > heard.size())
                break;
            const auto from = heard.begin() + static_cast<std::ptrdiff_t>(at + 4);
            packet.payload.assign(from, from + static_cast<std::ptrdiff_t>(size));
            out.push_back(packet);
            at += 4 + size;
        }
        heard.erase(heard.begin(), heard.begin() + static_cast<std::ptrdiff_t>(at));
        return out;
    }
    bool connect()
    {
        send(aspep::Beacon{});
        const auto offer = packets(3ms);
        if (offer.size() != 1)
            return false;
        send(offer[0].header);
        packets(3ms);
        send(aspep::Ping{.number = 1});
        const auto reply = packets(3ms);
        return reply.size() == 1 && std::get<aspep::Ping>(reply[0].header).configured;
    }
    /// The response's payload, status last; empty if there is none. Async packets are kept.
    Bytes ask(ByteView payload)
    {
        sendRequest(payload);
        Bytes answer;
        for (const auto &packet : packets(20ms)) {
            const auto *data = std::get_if<aspep::Data>(&packet.header);
            if (data != nullptr && data->response)
                answer = packet.payload;
            else
                async.push_back(packet.payload);
        }
        return answer;
    }
    std::int32_t get(mcp::RegisterId id)
    {
        ByteWriter request;
        request.u16(2U << 3).u16(id.withMotor(1).bits);
        const Bytes answer = ask(request.take());
        std::uint32_t value = 0;
        for (std::size_t i = 0; i + 1 < answer.size() && i < 4; ++i)
            value |= std::uint32_t{answer[i]} << (8 * i);
        return static_cast<std::int32_t>(value);
    }
    Bytes command(unsigned id) { return ask(ByteWriter().u16(id << 3 | 1U).take()); }
    /// A SET of ASYNC_UARTA.
    static Bytes datalog(unsigned size, unsigned hfRate, const std::vector<unsigned> &hf,
        unsigned mfRate, const std::vector<unsigned> &mf, unsigned mark)
    {
        ByteWriter out;
        out.u16(1U << 3).u16(0x0529).u16(static_cast<unsigned>(7 + 2 * (hf.size() + mf.size())));
        out.u16(size).u8(hfRate).u8(static_cast<unsigned>(hf.size()));
        out.u8(mfRate).u8(static_cast<unsigned>(mf.size()));
        for (const auto &list : {hf, mf}) {
            for (const unsigned id : list)
                out.u16(id);
        }
        return out.u8(mark).take();
    }
    bool waitForState(std::int32_t state)
    {
        for (int i = 0; i < 100; ++i) {
            if (get(mcp::reg::kStatus) == state)
                return true;
        }
        return false;
    }

    TimePoint now{};
    std::unique_ptr<simulation::SimulatedBoard> board;
    Bytes heard;
    std::vector<Bytes> async;
};

} // namespace support
