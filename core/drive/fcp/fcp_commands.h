// Motor commands and set-points of the older serial protocol as wishes, each one frame that is sent once: if its answer is
// lost it ends Unknown (NotSent, if the board said that it did not understand), and the state is read instead.
//
// An acknowledgement here proves nothing: START is acknowledged in any state. What the motor does is read by others.
#pragma once

#include "drive/fcp/fcp_protocol.h"
#include "drive/set_point_check.h"
#include "drive/task.h"

namespace drive {

class FcpCommandTask : public WishTask<FcpProtocol> {
public:
    FcpCommandTask(WishId id, const Command &command, const FcpFacts &board);

    std::optional<fcp::Request> nextRequest(TimePoint now) override;
    void onResponse(const fcp::Reply &response, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    bool looking(); ///< at what a start would go to, because of the user's own limits
    std::string refuseStart() const;

    const FcpFacts &m_board;
    Command m_command;
    Reader<FcpProtocol> m_reader{m_board};
    std::vector<Reading> m_found;
    bool m_looked = false;
};

/// Speed ramp, torque ramp or current reference.
class FcpSetPointTask : public WishTask<FcpProtocol> {
public:
    FcpSetPointTask(WishId id, const SetPoint &wanted, const FcpFacts &board);

    std::optional<fcp::Request> nextRequest(TimePoint now) override;
    void onResponse(const fcp::Reply &response, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    fcp::Command encode() const;

    const FcpFacts &m_board;
    SetPoint m_wanted;
};

} // namespace drive
