// What the guardian and the program share, and how the motors are stopped from it. What is here allocates nothing and
// takes no lock: it runs in a signal handler, too.
#pragma once

#include "base/time.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace session {

using Nanoseconds = std::int64_t;

constexpr Nanoseconds kMillisecond = 1'000'000, kSecond = 1'000'000'000;
constexpr std::size_t kMostParts = 48, kMostBytes = 1024;

/// Bytes and the pauses before them, without a pointer.
struct StopScript {
    struct Part {
        std::uint32_t pause_us = 0;
        std::uint16_t size = 0;
        std::uint16_t unused = 0; ///< so that two scripts can be compared as bytes
    };
    std::uint32_t parts = 0;
    std::array<Part, kMostParts> part{};
    std::array<std::uint8_t, kMostBytes> bytes{};
};

/// Written by the program, read by the child, but for what the child did. The script that counts is never written to,
/// so that a program that dies while it writes leaves a whole one; the reader checks afterwards that it still counts.
struct StopPage {
    std::atomic<std::uint32_t> scripts{
        0}; ///< published so far; the lowest bit says where the last one is
    std::array<StopScript, 2> script{};
    std::atomic<std::uint32_t> driven{0};
    std::atomic<Nanoseconds> stamp{0};
    std::atomic<std::uint32_t> stopping{0}, stopped{0}; ///< port, by number, that was acted upon
};
static_assert(std::atomic<Nanoseconds>::is_always_lock_free, "shared by two processes");

/// Nanoseconds of the monotonic clock, which stands still while the computer sleeps.
Nanoseconds monotonicNow();
/// Not at all for a time below zero: the system takes none.
void pauseFor(Nanoseconds time);

/// Sends the script again and again, every Guardian::kRepeat. What still waits to leave would be heard first, perhaps a
/// start: it is taken back.
/// @param port  of a terminal or an SPI bus
void stopMotors(const StopPage &page, int port, int repetitions);

} // namespace session
