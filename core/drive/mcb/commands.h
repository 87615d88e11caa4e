// Motor commands and set-points as wishes: first what has to be known is read, then it is judged, then control word,
// mode and set-points are written, each once. A write whose answer is lost ends the wish Unknown. Writes that are asked
// for as such have rules of their own.
//
// The state machine is walked step by step (shutdown, switch on, enable), each step when the status word shows the one
// before. Where the mode is another one its own set-point goes first, so that no old one takes effect; where both modes
// share a set-point the mode goes first, so that a ramp does not begin with a step.
#pragma once

#include "drive/act_task.h"
#include "drive/mcb/requests.h"
#include "drive/set_point_check.h"
#include "drive/stepwise_write.h"

#include <deque>

namespace drive {

/// Which set-point a mode follows; 0: another one.
std::uint16_t mcbSetPointOf(std::uint16_t mode);
/// What a mode controls, of those that are started here: positions go by a move, which knows the way.
catalog::ControlMode mcbControlOf(std::int64_t mode);

using McbAct = std::variant<Command, SpeedRamp, CurrentReference, PositionRamp>;

class McbActTask final : public ActTask<McbProtocol> {
public:
    McbActTask(WishId id, const auto &act, const McbFacts &board)
        : ActTask(id, act, board)
        , m_act(act)
    {
    }

private:
    std::string refuse() const override { return refuseMotor(m_board, m_motor); }
    std::vector<RegisterId> needs() const override;
    std::string unread() const override { return "no answer about what it would change"; }
    std::string plan() override;
    bool passes(const McbRequest &asked, const McbAnswer &answer, TimePoint now) override;
    void conclude(const McbRequest &asked, AnswerEnd said) override;

    // With all values read: each gives the steps, or says why not.
    std::string plan(const Command &command);
    std::string plan(const SpeedRamp &ramp);
    std::string plan(const CurrentReference &reference);
    std::string plan(const PositionRamp &ramp);
    std::string planStart();

    std::optional<double> valueOf(std::uint16_t address) const
    {
        return numberHeld(mcbIdOf(address));
    }
    void write(std::uint16_t address, const Value &value);
    void control(std::uint16_t word) { request(mcbWrite(mcbreg::kControl, {word})); }
    void await(std::uint16_t mask, std::uint16_t bits)
    {
        request(mcbRead(mcbreg::kStatus));
        m_awaited.push_back({mask, bits});
    }
    void setMode(std::uint16_t mode, std::uint16_t setPoint, const Value &value);

    struct Awaited {
        std::uint16_t mask = 0, bits = 0;
    };
    McbAct m_act;
    std::deque<Awaited> m_awaited; ///< of the status word
    std::string m_problem; ///< of a step that was to be planned
    TimePoint m_written; ///< the last step before one that is awaited
};

/// Write wishes: a register's type is asked first, because a drive may have another one than it had, and of a mode the
/// set-point that comes into force with it.
class McbWriteTask final : public StepwiseWrite<McbProtocol> {
public:
    using StepwiseWrite::StepwiseWrite;

private:
    std::string plan(const RegisterWrite &write) override;
    std::string judgeAnswer(const McbRequest &question, const McbAnswer &answer) override;
    std::string reasonWithout(const McbRequest &question) const override;
};

} // namespace drive
