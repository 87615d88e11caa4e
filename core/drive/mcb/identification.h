// Finds out which drive is on the other end, before anything is written: who it is, which registers it has (GET INFO of
// every one that the dictionary knows), and what bounds its motion. It only reads.
#pragma once

#include "drive/mcb/requests.h"
#include "drive/task.h"

#include <deque>

namespace drive {

class McbIdentification : public Task<McbProtocol> {
public:
    explicit McbIdentification(McbFacts &board)
        : m_board(board)
    {
    }

    void restart();

    std::optional<McbRequest> nextRequest(TimePoint now) override;
    void onResponse(const McbAnswer &answer, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    enum class Phase : std::uint8_t { Infos, Values };
    void next();
    void finish();
    void findTextOrder();
    std::optional<Value> valueAt(std::uint16_t address) const; ///< of those that were read
    double numberAt(std::uint16_t address) const; ///< 0: not told, or no sane number
    std::string textAt(std::uint16_t address) const;

    McbFacts &m_board;
    Phase m_phase = Phase::Infos;
    std::deque<std::uint16_t> m_waiting;
    std::map<std::uint16_t, mcb::Words> m_words;
    std::map<std::uint16_t, mcb::Info> m_infos;
    int m_losses = 0; ///< answers that never came, of the register in hand
};

/// Names of the states of DS402, from the bits of the status word.
struct McbState {
    MotorState state = MotorState::Unknown;
    std::string_view name;
    std::int64_t bits = 0; ///< of the status word that make it
};
McbState mcbStateOf(std::uint16_t statusWord);

} // namespace drive
