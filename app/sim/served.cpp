#include "served.h"

#include "session/files/fcp_rig_file.h"
#include "session/files/mcb_rig_file.h"
#include "simulation/fcp/board.h"
#include "simulation/mcb/board.h"
#include "simulation/mcb/slave.h"

namespace sim {

namespace {

/// The words that a static board of the older serial protocol obeys besides those of every board:
/// `state N`, `faults HEX` (first motor), `execute`, `rx-timeout`, `rx-overrun`; all else as obey().
Result<Obeyed, std::string> obeyFcp(std::string_view line, simulation::FcpBoard &board)
{
    const std::string_view words = trimmed(line);
    const std::string_view word = words.substr(0, words.find_first_of(" \t"));
    const std::string_view rest = trimmed(words.substr(word.size()));
    if (word == "state") {
        const auto state = number(rest, 10);
        if (!state || *state > 0xFF)
            return fail(std::string("state takes a number up to 255"));
        board.setState(static_cast<std::uint8_t>(*state));
    } else if (word == "faults") {
        const auto flags = number(rest, 16);
        if (!flags || *flags > 0xFFFFFFFF)
            return fail(std::string("faults takes up to eight hexadecimal digits"));
        board.setFlags(static_cast<std::uint32_t>(*flags));
    } else if (word == "execute") {
        board.executeBuffered();
    } else if (word == "rx-timeout") {
        board.expireFrame();
    } else if (word == "rx-overrun") {
        board.overrun();
    } else {
        return obey(line, board);
    }
    return Obeyed::Done;
}

} // namespace

Result<Served, std::string> serveBoard(const Options &options)
{
    auto board = simulation::makeBoard(options.board);
    auto &known = *board;
    return Served{std::move(board), [&known](std::string_view line) { return obey(line, known); }};
}

Result<Served, std::string> serveFcp(const Options &options)
{
    if (options.rig.empty())
        return serveBoard(options);
    auto rig = session::readFcpRigFile(QString::fromStdString(options.rig));
    if (!rig)
        return fail(rig.error());
    auto board = std::make_unique<simulation::FcpBoard>(std::move(*rig));
    auto &known = *board;
    return Served{
        std::move(board), [&known](std::string_view line) { return obeyFcp(line, known); }};
}

Result<Served, std::string> serveMcb(const Options &options)
{
    if (options.rig.empty()) {
        simulation::McbBoardOptions wanted = options.mcb;
        wanted.board = options.board;
        auto board = simulation::makeMcbBoard(wanted);
        auto &servo = *board;
        return Served{
            std::move(board), [&servo](std::string_view line) { return obey(line, servo); }};
    }
    auto rig = session::readMcbRigFile(QString::fromStdString(options.rig));
    if (!rig)
        return fail(options.rig + ": " + rig.error().toStdString());
    auto stream = std::make_unique<simulation::McbStream>(std::move(*rig));
    auto &known = *stream;
    return Served{std::move(stream),
        [&known](std::string_view line) { return obeyStatic(line, [&known] { known.reset(); }); }};
}

} // namespace sim
