#include "widgets/measuring/measure_job.h"

#include "scope/measurer.h"
#include "scope/phase.h"

#include <algorithm>
#include <array>

namespace widgets {

namespace {
using scope::Quantity;

/// Those that ask for a step; the others describe a signal that repeats.
constexpr std::array kAboutSteps{Quantity::Overshoot, Quantity::Undershoot, Quantity::PeakTime,
    Quantity::Settling, Quantity::DeadTime, Quantity::SteadyStateError, Quantity::Ripple,
    Quantity::RippleRms, Quantity::AbsoluteError, Quantity::TimedError};

bool aboutStep(Quantity quantity)
{
    return std::find(kAboutSteps.begin(), kAboutSteps.end(), quantity) != kAboutSteps.end();
}

scope::Measurement measured(const MeasureJob &job, const MeasureJob::Piece &piece)
{
    if (piece.channel && !piece.channel->empty()) {
        if (piece.quantity == Quantity::Phase && piece.second)
            return scope::measurePhase(*piece.channel, *piece.second, job.from, job.to);
        if (piece.quantity != Quantity::Phase) {
            std::optional<scope::StepSettings> step;
            if (aboutStep(piece.quantity)) {
                step.emplace();
                // A record of the trigger has the step where the trigger is.
                if (job.trigger && *job.trigger > job.from && *job.trigger < job.to)
                    step->at = *job.trigger;
            }
            return scope::Measurer(*piece.channel, job.from, job.to, step).measure(piece.quantity);
        }
    }
    scope::Measurement none;
    none.quantity = piece.quantity;
    none.unit = scope::unitOf(piece.quantity);
    return none;
}
} // namespace

std::uint64_t samplesFor(
    Quantity quantity, const capture::Channel &channel, capture::Nanos from, capture::Nanos to)
{
    const std::uint64_t count = channel.countIn(capture::toSeconds(from), capture::toSeconds(to));
    switch (quantity) {
    case Quantity::Min:
    case Quantity::Max:
    case Quantity::PeakToPeak:
        return count / capture::ValueColumn::kBlockSamples; // of the envelope
    case Quantity::Phase:
        return 2 * count;
    default:
        return count;
    }
}

void MeasureJob::detach(const capture::Capture &capture)
{
    const auto copyOf = [&](const capture::Channel *channel) -> const capture::Channel * {
        if (!channel)
            return nullptr;
        const capture::ChannelId id = channel->info().id;
        for (const capture::Snapshot &copy : copies)
            if (copy->front().info().id == id)
                return &copy->front();
        copies.push_back(capture.snapshot({&id, 1}));
        return &copies.back()->front();
    };
    for (Piece &piece : pieces) {
        piece.channel = copyOf(piece.channel);
        piece.second = copyOf(piece.second);
    }
}

std::vector<MeasureJob::Result> MeasureJob::run(const std::function<bool()> &goesOn) const
{
    std::vector<Result> results;
    for (const Piece &piece : pieces) {
        if (!goesOn())
            break;
        results.push_back({piece.row, measured(*this, piece)});
    }
    return results;
}

} // namespace widgets
