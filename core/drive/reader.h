// Reads a list of registers, as many a request as the protocol can. What is lost is asked for again, until it is given
// up.
#pragma once

#include "drive/board_facts.h"

#include <optional>
#include <vector>

namespace drive {

/// What a protocol's way of reading may leave out.
template <class Facts>
class PlainReads {
public:
    explicit PlainReads(const Facts &board)
        : m_board(board)
    {
    }

    void begin(std::vector<RegisterId> & /*ids*/) { } ///< may bring them into another order
    void drop() { } ///< the first ones are given up
    /// How a register that is not asked ends; nothing if it is, as what is in no catalogue.
    static std::optional<ReadStatus> refuse(const BoardFacts &board, RegisterId id)
    {
        const auto *info = board.catalog->find(id);
        if (info != nullptr && !info->readable())
            return ReadStatus::NotSupported;
        return info == nullptr || board.reasonWithout(id).empty()
            ? std::nullopt
            : std::optional(ReadStatus::Refused);
    }

protected:
    const Facts &m_board;
};

/// @tparam P  kAttempts for each request; Reads, made with the facts, a PlainReads with
///            Request request(ids, count): for the first of these; says how many
///            optional<vector<Reading>> readings(ids, answer, now): of those asked, from the first on, as many as the
///            answer tells of; nothing: it fits none of them, and counts as lost
template <class P>
class Reader {
public:
    explicit Reader(const typename P::Facts &board)
        : m_reads(board)
    {
    }

    /// Forgets what it was doing and begins with these ids.
    void start(std::vector<RegisterId> ids)
    {
        m_reads.begin(ids);
        m_waiting = std::move(ids);
        m_asked = 0;
        m_losses = 0;
        m_gaveUp = false;
    }
    void clear() { start({}); }

    bool finished() const { return m_waiting.empty(); }
    bool gaveUp() const { return m_gaveUp; } ///< some were never answered: no Reading for those

    /// Nothing when finished.
    std::optional<typename P::Request> nextRequest()
    {
        if (m_waiting.empty())
            return std::nullopt;
        return m_reads.request(m_waiting, m_asked);
    }
    std::vector<Reading> onResponse(const typename P::Answer &answer, TimePoint now)
    {
        if (m_asked == 0)
            return {};
        auto readings = m_reads.readings({m_waiting.data(), m_asked}, answer, now);
        if (!readings) {
            onNoResponse();
            return {};
        }
        drop(readings->size());
        return std::move(*readings);
    }
    void onNoResponse()
    {
        if (m_asked == 0 || ++m_losses < P::kAttempts)
            return;
        m_gaveUp = true;
        m_reads.drop();
        drop(m_asked);
    }

private:
    void drop(std::size_t count)
    {
        m_waiting.erase(m_waiting.begin(), m_waiting.begin() + static_cast<std::ptrdiff_t>(count));
        m_asked = 0;
        m_losses = 0;
    }

    typename P::Reads m_reads;
    std::vector<RegisterId> m_waiting; ///< the first m_asked are asked
    std::size_t m_asked = 0;
    int m_losses = 0; ///< of those, in a row
    bool m_gaveUp = false;
};

} // namespace drive
