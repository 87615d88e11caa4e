// What went over a line lately, for the report of a finding: pieces with their times, the newest last. Ones that begin
// alike, as a stream's do, are told once with how many they were.
#pragma once

#include "base/bytes.h"
#include "base/time.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <deque>
#include <string>
#include <utility>

namespace support {

class WireTape {
public:
    static constexpr std::size_t kKept = 120; ///< pieces

    /// @param byUs  the Controller's bytes, not the board's
    void add(bool byUs, ByteView bytes, TimePoint at, bool arrives)
    {
        if (bytes.empty())
            return;
        Piece &last = m_last[byUs ? 1 : 0];
        const bool alike = last.arrives == arrives && last.size == bytes.size()
            && last.begins.size() == std::min(bytes.size(), kBegins)
            && std::equal(last.begins.begin(), last.begins.end(), bytes.begin());
        if (alike) {
            ++m_alike[byUs ? 1 : 0];
            return;
        }
        last.at = at;
        last.byUs = byUs;
        last.arrives = arrives;
        last.size = bytes.size();
        last.alike = std::exchange(m_alike[byUs ? 1 : 0], 0);
        last.begins.assign(bytes.begin(),
            bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), kBegins)));
        last.bytes.assign(bytes.begin(),
            bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), kShown)));
        m_pieces.push_back(last);
        if (m_pieces.size() > kKept)
            m_pieces.pop_front();
    }

    /// A line each. @param now  times are told before it
    std::string text(TimePoint now) const
    {
        std::string all;
        std::array<char, 64> number{};
        for (const Piece &piece : m_pieces) {
            std::snprintf(number.data(), number.size(), "%9.4f s ", -toSeconds(now - piece.at));
            all += number.data();
            all += piece.byUs ? "->" : "<-";
            for (const std::uint8_t byte : piece.bytes) {
                std::snprintf(number.data(), number.size(), " %02X", unsigned{byte});
                all += number.data();
            }
            if (piece.size > kShown)
                all += " ... of " + std::to_string(piece.size);
            if (!piece.arrives)
                all += " (lost)";
            if (piece.alike > 0)
                all += " (behind " + std::to_string(piece.alike) + " like the one before)";
            all += '\n';
        }
        return all;
    }

private:
    static constexpr std::size_t kBegins = 4, kShown = 40;
    struct Piece {
        TimePoint at{};
        bool byUs = false, arrives = true;
        std::size_t size = 0;
        int alike = 0; ///< that were not told, before it and in its direction
        Bytes begins, bytes;
    };
    std::array<Piece, 2> m_last; ///< of each direction
    std::array<int, 2> m_alike{};
    std::deque<Piece> m_pieces;
};

} // namespace support
