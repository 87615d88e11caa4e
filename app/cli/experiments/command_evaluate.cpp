// evaluate: the numbers of an experiment, from its recording alone.
#include "commands.h"
#include "experiments/reports.h"

namespace cli {

namespace {

Outcome<int> runEvaluate(const Arguments &arguments, Output &out)
{
    return evaluate(arguments.words.first(), out);
}

} // namespace

const Command kEvaluate{.name = "evaluate",
    .words = "RUN.pcapng",
    .help = "Prints what the experiment in a recording says, as its run did.",
    .least = 1,
    .most = 1,
    .needsPort = false,
    .runAlone = runEvaluate};

} // namespace cli
