// A FcpDrive beside a simulated board of the older protocol.
#pragma once

#include "support/link_pair.h"

namespace support {

inline simulation::BoardOptions boardOf(const char *profile, int motors = 1)
{
    simulation::BoardOptions options;
    options.profile = profile;
    options.baud = 115200;
    options.motors = motors;
    return options;
}

/// Connected, identified, armed, and ready to be moved.
struct FcpBench : LinkPair {
    explicit FcpBench(const char *profile, int motors = 1)
        : LinkPair(boardOf(profile, motors))
    {
        connect();
        ready = runUntilIdentified();
        drive->arm();
        exchange();
    }
    void expert(int motor = 1)
    {
        submit(drive::UserLimits{3000.0, 0.0});
        submit(drive::ExpertMode{motor});
    }
    bool start()
    {
        expert();
        const drive::WishId wish = submit(drive::Command{drive::MotorAction::Start, 1});
        return runUntilEnded(wish) && outcome(wish) == drive::Outcome::Ok
            && runUntilState(drive::MotorState::Running);
    }
    const drive::Capability *capability(drive::Feature feature) const
    {
        for (const drive::Capability &one : identified->capabilities)
            if (one.feature == feature)
                return &one;
        return nullptr;
    }
    bool ready = false;
};

/// Of the older protocol: a frame that only asks.
inline bool isRead(const Bytes &frame)
{
    const unsigned code = frame.empty() ? 0 : frame[0] & 0x1FU;
    return code == 0x02 || code == 0x06 || code == 0x08 || code == 0x0C;
}

} // namespace support
