// A device together with the words that it obeys: all that the loop of rotorscope-sim has to know of it.
#pragma once

#include "control_words.h"
#include "options.h"
#include "simulation/device.h"

#include <functional>
#include <memory>

namespace sim {

struct Served {
    std::unique_ptr<simulation::ByteDevice> device;
    /// Does what one line of standard input says, as obey() of control_words.h.
    std::function<Result<Obeyed, std::string>(std::string_view)> obey;
};

// The device that the options ask for; a sentence if its rig file is none.
Result<Served, std::string> serveBoard(const Options &options); ///< of simulation::makeBoard()
Result<Served, std::string> serveFcp(const Options &options);
Result<Served, std::string> serveMcb(const Options &options);

} // namespace sim
