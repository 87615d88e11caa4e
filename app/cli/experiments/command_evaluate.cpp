// evaluate: the numbers of an experiment, from its recording alone.
#include "commands.h"
#include "experiments/step_report.h"

namespace cli {

namespace {

Outcome<int> runEvaluate(const Arguments &arguments, Output &out)
{
    const QString &path = arguments.words.first();
    const auto recording = openRecording(path);
    if (!recording)
        return tl::make_unexpected(recording.error());
    const auto series = seriesIn(**recording, path);
    if (!series)
        return tl::make_unexpected(series.error());
    if (const QString lack = lackText(**recording); !lack.isEmpty())
        Output::error(path + QStringLiteral(": ") + lack + QLatin1Char('.'));
    return report(*series, out);
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
