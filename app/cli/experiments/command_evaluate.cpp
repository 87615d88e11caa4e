// evaluate: the numbers of experiments, from their recording alone.
#include "commands.h"
#include "experiments/reports.h"

namespace cli {

namespace {

Outcome<int> runEvaluate(const Arguments &arguments, Output &out)
{
    const QString &path = arguments.words.first();
    return evaluate(path, path, out, arguments.runNumber);
}

constexpr OptionText kEvaluateOptions[] = {
    {"run", "N", "Only this one of several in the recording, from 1; all if not given."}};

Outcome<bool> readEvaluate(const Given &given, Arguments &arguments)
{
    constexpr int kMostRuns = 1'000'000;
    return readNumbers(given, {{"run", &arguments.runNumber, 1, kMostRuns}});
}

} // namespace

const Command kEvaluate{.name = "evaluate",
    .words = "RUN.pcapng",
    .help = "Prints what each experiment in a recording says, as its run did.",
    .least = 1,
    .most = 1,
    .options = kEvaluateOptions,
    .read = readEvaluate,
    .needsPort = false,
    .runAlone = runEvaluate};

} // namespace cli
