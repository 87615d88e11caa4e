#include "served.h"

#include "session/mcb_rig_file.h"
#include "simulation/mcb_slave.h"

namespace sim {

namespace {

Served boardOf(const Options &options)
{
    auto board = simulation::makeBoard(options.board);
    auto &known = *board;
    return {std::move(board), [&known](std::string_view line) { return obey(line, known); }};
}

Result<Served, std::string> mcbOf(const Options &options)
{
    auto rig = session::readMcbRigFile(QString::fromStdString(options.rig));
    if (!rig)
        return fail(options.rig + ": " + rig.error().toStdString());
    auto stream = std::make_unique<simulation::McbStream>(std::move(*rig));
    auto &known = *stream;
    return Served{std::move(stream),
        [&known](std::string_view line) { return obeyStatic(line, [&known] { known.reset(); }); }};
}

} // namespace

Result<Served, std::string> makeServed(const Options &options)
{
    switch (options.protocol) {
    case Protocol::Mcb:
        return mcbOf(options);
    case Protocol::Mcp:
        break;
    }
    return boardOf(options);
}

} // namespace sim
