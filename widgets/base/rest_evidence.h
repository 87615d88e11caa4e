// RestEvidence: whether a connection may be left without a word. It may if nothing in it can have set a motor in
// motion, or if every motor was seen at rest a moment ago, after whatever was asked for last had ended. Silence is no
// evidence, and neither is a state that was read before. Values go in, nothing is asked for; times are those of the
// session.
#pragma once

#include "drive/event.h"

#include <map>
#include <set>

namespace widgets {

class RestEvidence {
public:
    static constexpr Duration kFresh = std::chrono::milliseconds(500);

    void opened() { *this = {}; } ///< a connection begins
    void armed(); ///< what is asked for from now on can move a motor
    void asked(const drive::Wish &wish);
    void ended(const drive::Ended &ended);
    void accept(const drive::MotorStatus &status);
    /// The user's choice: the motors stay as they are. Until the next arming or connection.
    void leftAsTheyAre() { m_left = true; }

    /// A motor may turn, for all that was seen.
    bool mayTurn(int motors, TimePoint now) const;
    /// All motors were seen at rest for half a second, however long ago, after whatever was asked for last had ended: a
    /// motor that was just told to start may be found idle once more.
    bool wereAtRest(int motors) const;
    /// The board has told of each motor what it does, or the user has said that it does not matter.
    bool heardOfAll(int motors) const;

private:
    bool m_moved = false; ///< armed, or a motor was seen that is not at rest
    bool m_left = false;
    std::set<drive::WishId> m_underWay; ///< of those that can move or change something
    std::set<int> m_heard; ///< motors
    struct Rest {
        TimePoint first, last; ///< times at which it was seen
    };
    std::map<int, Rest> m_atRest; ///< by motor, since the last of those ended
};

} // namespace widgets
