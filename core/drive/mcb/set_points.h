// Set-points that travel in every cyclic frame, instead of as a write of their own: which registers, and the words that
// go out in them. It sends nothing itself.
//
// Only set-points whose zero is rest are mapped, the velocity and the currents: a program that meets a drive that
// cycles cannot know its mapping and has to send zeros until it has left that state, and a position of zero would be a
// journey.
//
// Before the mapping the words are read from the drive, so that mapping moves nothing. From then on they change by a
// user's wish alone, but go to zero with a stop and when a fault comes up. Disarming holds them: it is no act on the
// motor. A reset or a lost link ends all of it, and only the user begins it again.
#pragma once

#include "drive/mcb/requests.h"
#include "mcb/mapping.h"

namespace drive {

class McbSetPoints {
public:
    explicit McbSetPoints(const McbFacts &board)
        : m_board(board)
    {
    }

    /// In the order of the mapping; empty: this drive takes none of them so.
    std::vector<mcb::MappedRegister> entries() const
    {
        std::vector<mcb::MappedRegister> entries;
        for (const std::uint16_t address : {mcbreg::kVelocity, mcbreg::kIq, mcbreg::kId}) {
            const mcb::Info *info = m_board.infoOf(address);
            // Readable, because what goes out is read back.
            if (info != nullptr && info->cyclic == mcb::Cyclic::Rx && m_board.readable(address)
                && m_board.writable(address))
                entries.push_back({address, info->size});
        }
        return entries;
    }

    bool wanted() const { return m_wanted; } ///< asked for, and mapped
    void begin() { m_wanted = true; }
    /// Asked for no longer, or impossible now: the words are forgotten.
    void end()
    {
        m_wanted = false;
        m_words.clear();
    }

    /// What goes out for this register. @param words  as many as it has, at least
    void set(std::uint16_t address, mcb::WordView words)
    {
        m_words[address].assign(words.begin(), words.end());
    }
    /// Empty: zero.
    mcb::Words of(std::uint16_t address) const
    {
        const auto at = m_words.find(address);
        return at == m_words.end() ? mcb::Words() : at->second;
    }
    /// All of them zero.
    void rest() { m_words.clear(); }
    /// Of a frame with this mapping.
    mcb::Words output(const std::vector<mcb::MappedRegister> &rx) const
    {
        mcb::Words output;
        for (const mcb::MappedRegister &entry : rx) {
            mcb::Words words = of(entry.address);
            words.resize(mcb::wordsOf(entry.size));
            output.insert(output.end(), words.begin(), words.end());
        }
        return output;
    }

private:
    const McbFacts &m_board;
    bool m_wanted = false;
    std::map<std::uint16_t, mcb::Words> m_words;
};

} // namespace drive
