// A Controller on virtual time and what a test says to it. `now` moves only where a test moves it.
#pragma once

#include "aspep/controller.h"

#include <QtTest>

#include <string_view>

namespace support {

using namespace std::chrono_literals;
using aspep::Controller;

/// Bytes from hex digits; everything else between them is passed over.
inline Bytes hex(std::string_view text)
{
    Bytes bytes;
    int high = -1;
    for (const char c : text) {
        const int digit = c >= '0' && c <= '9' ? c - '0'
            : c >= 'a' && c <= 'f'             ? c - 'a' + 10
            : c >= 'A' && c <= 'F'             ? c - 'A' + 10
                                               : -1;
        if (digit < 0)
            continue;
        if (high < 0) {
            high = digit;
        } else {
            bytes.push_back(static_cast<std::uint8_t>(high << 4 | digit));
            high = -1;
        }
    }
    return bytes;
}

inline Bytes header(const aspep::Header &what)
{
    const auto bytes = aspep::encodeHeader(what);
    return {bytes.begin(), bytes.end()};
}

/// A Data packet from the Performer: an async packet, or a response.
inline Bytes packet(bool response, const Bytes &payload)
{
    Bytes bytes = header(aspep::Data{response, static_cast<std::uint16_t>(payload.size())});
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    return bytes;
}

inline Bytes operator+(Bytes left, const Bytes &right)
{
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

inline bool isPing(const Bytes &bytes) { return bytes.size() == 4 && (bytes[0] & 0xF) == 6; }

const Bytes kWidest = hex("05 FF FF 0F"); ///< the first offer
const Bytes kBoard = hex("05 C7 01 14"); ///< a board's answer: 256, 256, 2048
const Bytes kConfigured = hex("36 00 00 90"); ///< Ping reply: configured, parity 0
const Bytes kGetStatus = hex("10 00 49 00"); ///< of motor 1

struct VirtualLink {
    TimePoint now{};
    Controller controller;
    std::vector<Controller::Event> events; ///< all of them, in order

    explicit VirtualLink(Controller::Config config = {})
        : controller(config)
    {
    }

    /// All bytes that the Controller wants to send, as one run; they leave at once.
    Bytes sent()
    {
        Bytes bytes;
        for (const Output &output : controller.takeOutput())
            bytes.insert(bytes.end(), output.bytes.begin(), output.bytes.end());
        controller.handleSent(now);
        return bytes;
    }
    void hear(const Bytes &bytes)
    {
        controller.receive(bytes, now);
        collect();
    }
    void collect()
    {
        for (auto &event : controller.takeEvents())
            events.push_back(std::move(event));
    }
    void wait(Duration duration)
    {
        const TimePoint end = now + duration;
        for (auto due = controller.nextTimeout(); due && *due <= end;
             due = controller.nextTimeout()) {
            now = std::max(now, *due);
            controller.handleTimeout(now);
            collect();
        }
        now = end;
    }
    void sleepUntilTimeout()
    {
        now = std::max(now, *controller.nextTimeout());
        controller.handleTimeout(now);
        collect();
    }
    /// Runs timers until something is to be sent, and gives it; empty if the Controller has nothing
    /// left to do.
    Bytes nextSent()
    {
        for (int i = 0; i < 1000; ++i) {
            if (Bytes bytes = sent(); !bytes.empty())
                return bytes;
            if (!controller.nextTimeout())
                break;
            sleepUntilTimeout();
        }
        return {};
    }
    /// Through the usual first dialogue.
    void connect()
    {
        controller.connect(now);
        QCOMPARE(sent(), kWidest);
        hear(kBoard);
        QCOMPARE(sent(), kBoard);
        hear(kBoard);
        QCOMPARE(sent(), header(aspep::Ping{false, false, 0, 1}));
        hear(kConfigured);
        QCOMPARE(controller.state(), Controller::State::Connected);
        events.clear();
    }
    template <class T>
    int count() const
    {
        int n = 0;
        for (const auto &event : events)
            n += std::holds_alternative<T>(event) ? 1 : 0;
        return n;
    }
    template <class T>
    const T *last() const
    {
        for (auto it = events.rbegin(); it != events.rend(); ++it) {
            if (const T *found = std::get_if<T>(&*it))
                return found;
        }
        return nullptr;
    }
};

} // namespace support
