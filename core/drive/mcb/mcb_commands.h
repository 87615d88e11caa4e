// Motor commands and set-points as wishes: first what has to be known is read, then it is judged, then control word, mode
// and set-points are written, each once. A write whose answer is lost ends the wish Unknown. Writes that
// are asked for as such have rules of their own.
//
// The state machine is walked step by step (shutdown, switch on, enable), each step when the status word shows the one
// before. Where the mode is another one its own set-point goes first, so that no old one takes effect; where both modes
// share a set-point the mode goes first, so that a ramp does not begin with a step.
#pragma once

#include "drive/control_mode.h"
#include "drive/mcb/mcb_protocol.h"
#include "drive/stepwise_write.h"
#include "drive/task.h"

#include <deque>

namespace drive {

/// Which set-point a mode follows; 0: another one.
std::uint16_t mcbSetPointOf(std::uint16_t mode);
/// What a mode controls, of those that are started here: positions go by a move, which knows the way.
ControlMode mcbControlOf(std::int64_t mode);

using McbAct = std::variant<Command, SpeedRamp, CurrentReference, PositionRamp>;

class McbActTask : public WishTask<McbProtocol> {
public:
    McbActTask(WishId id, const McbAct &act, const McbFacts &board);

    std::optional<McbRequest> nextRequest(TimePoint now) override;
    void onResponse(const McbAnswer &answer, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    struct Step {
        std::uint16_t address = 0;
        mcb::Words words; ///< to be written; none: wait for the status word
        std::uint16_t mask = 0, bits = 0;
    };

    // With all values read: each fills the steps, or says why not.
    std::string plan(const Command &command);
    std::string plan(const SpeedRamp &ramp);
    std::string plan(const CurrentReference &reference);
    std::string plan(const PositionRamp &ramp);
    std::string planStart();

    std::optional<double> valueOf(std::uint16_t address) const;
    void write(std::uint16_t address, const Value &value);
    void control(std::uint16_t word) { m_steps.push_back({0x010, {word}, 0, 0}); }
    void await(std::uint16_t mask, std::uint16_t bits) { m_steps.push_back({0, {}, mask, bits}); }
    void setMode(std::uint16_t mode, std::uint16_t setPoint, const Value &value);

    const McbFacts &m_board;
    McbAct m_act;
    int m_motor;
    Reader<McbProtocol> m_reader{m_board};
    std::map<std::uint16_t, double> m_values;
    std::deque<Step> m_steps;
    std::string m_problem; ///< of a step that was to be planned
    std::optional<TimePoint> m_waitingSince;
    bool m_planned = false, m_unread = false;
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
