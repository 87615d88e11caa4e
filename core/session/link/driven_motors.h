// DrivenMotors: whether this session may have set a motor going that it has not seen at rest since. It says yes too
// often rather than too late: from the moment a wish that can move is submitted, until every motor was seen idle twice
// by readings well behind the end of the last such wish. It sends nothing.
#pragma once

#include "drive/event.h"
#include "drive/wish.h"

#include <map>
#include <set>

namespace session {

class DrivenMotors {
public:
    static constexpr Duration kSettle = std::chrono::milliseconds(300);
    static constexpr int kIdleReadings = 2;

    /// Before it goes to the drive. @param armed  the drive is; else it moves nothing
    void submitted(const drive::Wish &wish, bool armed, TimePoint now);
    void told(const drive::Event &event, TimePoint now);
    /// The user leaves them as they are.
    void leave() { *this = {}; }

    bool any() const { return m_driven; }

private:
    void accept(const drive::MotorStatus &status);

    bool m_driven = false;
    int m_motors = 1;
    std::set<drive::WishId> m_open; ///< wishes that can move and have not ended
    TimePoint m_lastAct{};
    std::map<int, int> m_idle; ///< readings in a row behind it, by motor
};

} // namespace session
