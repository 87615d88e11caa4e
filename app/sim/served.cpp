#include "served.h"

#include "aspep/packet.h"
#include "fcp_words.h"
#include "session/files/fcp_rig_file.h"
#include "session/files/mcb_rig_file.h"
#include "simulation/fcp/fcp_board.h"
#include "simulation/mcb/mcb_board.h"
#include "simulation/mcb/mcb_slave.h"

namespace sim {

namespace {

Served boardOf(const Options &options, std::size_t headerBytes)
{
    auto board = simulation::makeBoard(options.board);
    auto &known = *board;
    return {std::move(board), headerBytes,
        [&known](std::string_view line) { return obey(line, known); }};
}

Served servoOf(const Options &options)
{
    simulation::McbBoardOptions wanted = options.mcb;
    wanted.board = options.board;
    auto board = simulation::makeMcbBoard(wanted);
    auto &known = *board;
    return {std::move(board), 0, [&known](std::string_view line) { return obey(line, known); }};
}

Result<Served, std::string> mcbOf(const Options &options)
{
    if (options.rig.empty())
        return servoOf(options);
    auto rig = session::readMcbRigFile(QString::fromStdString(options.rig));
    if (!rig)
        return fail(options.rig + ": " + rig.error().toStdString());
    auto stream = std::make_unique<simulation::McbStream>(std::move(*rig));
    auto &known = *stream;
    return Served{std::move(stream), 0,
        [&known](std::string_view line) { return obeyStatic(line, [&known] { known.reset(); }); }};
}

Result<Served, std::string> fcpOf(const Options &options)
{
    if (options.rig.empty())
        return boardOf(options, 0);
    auto rig = session::readFcpRigFile(QString::fromStdString(options.rig));
    if (!rig)
        return fail(rig.error());
    auto board = std::make_unique<simulation::FcpBoard>(std::move(*rig));
    auto &known = *board;
    return Served{
        std::move(board), 0, [&known](std::string_view line) { return obeyFcp(line, known); }};
}

} // namespace

Result<Served, std::string> makeServed(const Options &options)
{
    switch (options.protocol) {
    case Protocol::Mcb:
        return mcbOf(options);
    case Protocol::Fcp:
        return fcpOf(options);
    case Protocol::Mcp:
        break;
    }
    return boardOf(options, aspep::kHeaderSize);
}

} // namespace sim
