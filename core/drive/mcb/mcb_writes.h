// Write wishes, one register after the other: its type is asked first, because a drive may have another one than it had,
// then its value, for undo; then it is written, once, and read back.
#pragma once

#include "drive/mcb/mcb_reader.h"
#include "drive/task.h"

namespace drive {

class McbWriteTask : public WishTask<McbProtocol> {
public:
    McbWriteTask(WishId id, const Write &write, const McbBoard &board);

    std::optional<McbRequest> nextRequest(TimePoint now) override;
    void takeResponse(const McbAnswer &answer, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;
    void cut(const std::string &reason) override;
    void supersede(const Write &newer) override;
    std::vector<Reading> takeReadings() override { return std::exchange(m_readings, {}); }

private:
    enum class Step : std::uint8_t { Check, Info, Before, Followed, Set, After };
    struct Item {
        RegisterWrite write;
        WriteResult result;
        bool done = false, sent = false;
    };
    Item &item() { return m_items[m_at]; }
    std::string check();
    void close(Outcome outcome, const std::string &reason = {});
    void finish();

    const McbBoard &m_board;
    Reach m_reach;
    std::uint16_t m_followed =
        0; ///< the set-point that comes into force with the mode that is written; 0: none
    std::vector<Item> m_items;
    std::size_t m_at = 0;
    Step m_step = Step::Check;
    mcb::Words m_words;
    std::vector<Reading> m_readings;
};

} // namespace drive
