// Read and write wishes of the older serial protocol. Each register of a write is read, set in its full width, and read
// again, because an acknowledgement proves nothing; then comes the next.
//
// A SET whose answer was lost is not sent again: what is read back decides.
#pragma once

#include "drive/legacy/legacy_reader.h"
#include "drive/task.h"

#include <vector>

namespace drive {

class LegacyWriteTask : public WishTask<LegacyProtocol> {
public:
    LegacyWriteTask(WishId id, const Write &write, const LegacyFacts &board);

    std::optional<legacy::Request> nextRequest(TimePoint now) override;
    void takeResponse(const legacy::Reply &response, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;
    void cut(const std::string &reason) override;
    void supersede(const Write &newer) override;
    std::vector<Reading> takeReadings() override { return std::exchange(m_readings, {}); }

private:
    enum class Phase : std::uint8_t { Check, Before, Setting, After };
    struct Item {
        RegisterWrite write;
        std::vector<legacy::Request> requests; ///< one; of the rev-up one for each stage
        bool done = false;
        WriteResult result;
    };

    void check(Item &item) const;
    void addRequests(Item &item) const;
    void beginReading(Phase phase);
    void afterReading();
    void takeAnswer(const legacy::Reply &response);
    void finishItem(Outcome outcome, const std::string &reason);
    void judge(const std::string &doubt);
    void finish();
    Item &current() { return m_items[m_at]; }

    const LegacyFacts &m_board;
    Reach m_reach;
    std::vector<Item> m_items;
    std::size_t m_at = 0, m_request = 0; ///< the register at work, and its next request
    Phase m_phase = Phase::Check;
    LegacyReader m_reader{m_board};
    std::string m_doubt; ///< why it is not known whether the board took it
    bool m_setSent = false; ///< of the register at work
    bool m_repeated = false; ///< that request has been sent twice
    std::vector<Reading> m_readings;
};

} // namespace drive
