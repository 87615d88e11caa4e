#include "drive/mcb/mcb_writes.h"

#include "drive/mcb/mcb_commands.h"
#include "drive/set_point_check.h"
#include "drive/values.h"
#include "drive/write_check.h"

namespace drive {

namespace {

const mcb::Master::Request &plain(const McbRequest &request)
{
    return std::get<mcb::Master::Request>(request);
}

} // namespace

std::string McbWriteTask::plan(const RegisterWrite &write)
{
    const std::uint16_t address = mcbAddressOf(write.id);
    if (isMcbMappingRegister(address))
        return "is set by streaming";
    if (address == mcbreg::kControl)
        return "the state machine is walked by start, stop and the acknowledging of faults";
    if (auto why = refuseWrite(m_board, write, m_reach); !why.empty())
        return why;
    std::uint16_t followed = 0; // the set-point that comes into force with a mode
    if (m_board.catalog->find(write.id)->effect == catalog::Effect::Mode) {
        const auto mode = static_cast<std::uint16_t>(asNumber(write.value).value_or(0.0));
        if (auto why = refuseControl(
                m_board, m_board.catalog->motorOf(write.id), mcbControlOf(mode), m_reach);
            !why.empty())
            return why;
        followed = mcbSetPointOf(mode);
    }
    auto words = mcbWordsOf(m_board, address, write.value);
    if (!words)
        return words.error();
    ask(mcbInfo(address));
    readBefore();
    if (followed != 0 && m_board.readable(followed))
        ask(mcbRead(followed));
    this->write(mcbWrite(address, std::move(*words)));
    return {};
}

std::string McbWriteTask::judgeAnswer(const McbRequest &question, const McbAnswer &answer)
{
    const std::uint16_t address = plain(question).address;
    if (plain(question).command == mcb::Command::GetInfo) {
        if (!answer.ok || answer.words.size() < 2)
            return mcbWordOf(answer.code);
        if (mcb::infoOf({answer.words[0], answer.words[1], 0, 0}) == *m_board.infoOf(address))
            return {};
        markBoardChanged();
        return "has another type than it had";
    }
    const auto there = answer.ok ? mcbValueOf(m_board, address, answer.words) : std::nullopt;
    const std::string why =
        there ? refuseNumber(m_board, {mcbIdOf(address), *there}) : "is not known";
    return why.empty()
        ? why
        : m_board.catalog->nameOf(mcbIdOf(address)) + ", which it would follow, is " + why;
}

std::string McbWriteTask::reasonWithout(const McbRequest &question) const
{
    return plain(question).command == mcb::Command::GetInfo ? "" : " about what it would follow";
}

} // namespace drive
