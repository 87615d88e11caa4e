// Write wishes: a register's type is asked first, because a drive may have another one than it had, and of a mode the
// set-point that comes into force with it.
#pragma once

#include "drive/mcb/mcb_protocol.h"
#include "drive/stepwise_write.h"

namespace drive {

class McbWriteTask final : public StepwiseWrite<McbProtocol> {
public:
    using StepwiseWrite::StepwiseWrite;

private:
    std::string plan(const RegisterWrite &write) override;
    std::string judgeAnswer(const McbRequest &question, const McbAnswer &answer) override;
    std::string reasonWithout(const McbRequest &question) const override;
};

} // namespace drive
