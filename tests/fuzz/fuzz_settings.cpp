// Any text as the settings of the window: what does not make sense keeps its default, and what was read is the same
// after writing and reading it again.
#include "fuzz/script.h"
#include "widgets/window/settings.h"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray text(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    const widgets::Settings read = widgets::settingsFromJson(text);
    fuzz::require(std::isfinite(read.maxSpeedRpm) && read.maxSpeedRpm >= 0.0);
    fuzz::require(std::isfinite(read.maxCurrentAmps) && read.maxCurrentAmps >= 0.0);
    fuzz::require(read.ramps.size() <= widgets::kMostRampPresets);
    fuzz::require(read.workspace.formulas.size() <= widgets::kMostMathFormulas);
    for (const widgets::KeptReference &reference : read.workspace.references)
        fuzz::require(widgets::snapshotOf(reference.traces)->size() == reference.traces.size());
    const QByteArray ours = widgets::toJson(read);
    fuzz::require(widgets::toJson(widgets::settingsFromJson(ours)) == ours);
    return 0;
}
