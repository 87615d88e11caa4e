// pole-pairs: how many a running motor has, by what a tachometer reads. It moves nothing.
#include "commands.h"
#include "lab/pole_pairs.h"
#include "sentences.h"
#include "session/files/json_text.h"

#include <algorithm>
#include <cmath>

namespace cli {

namespace {

constexpr int kStatuses = 10; ///< a second of them
constexpr double kVaries = 0.03, kSpeedSteps = 2.0; ///< no more; of the board's

/// With the mean of its speed, which has to be constant.
Outcome<drive::MotorStatus> steadyStatus(Desk &desk)
{
    auto status = desk.talk.status(desk.arguments.motor);
    double sum_rpm = 0.0, least_rpm = 0.0, most_rpm = 0.0;
    for (int left = kStatuses; status && left > 0; --left) {
        status = desk.talk.nextStatus(desk.arguments.motor);
        const double rpm = status ? status->speedRpm.value_or(0.0) : 0.0;
        sum_rpm += rpm;
        least_rpm = left == kStatuses ? rpm : std::min(least_rpm, rpm);
        most_rpm = left == kStatuses ? rpm : std::max(most_rpm, rpm);
    }
    if (!status)
        return status;
    const double mean_rpm = sum_rpm / kStatuses;
    const auto at = static_cast<std::size_t>(desk.arguments.motor - 1);
    const double step_rpm =
        at < desk.board.limits.size() ? desk.board.limits[at].speedStepRpm : 0.0;
    if (most_rpm - least_rpm > std::max(kSpeedSteps * step_rpm, kVaries * std::abs(mean_rpm)))
        return failure(kRefused,
            QStringLiteral("Not conclusive: its speed goes from %1 to %2 rpm within a second; it "
                           "has to be constant.")
                .arg(numberText(std::round(least_rpm)), numberText(std::round(most_rpm))));
    status->speedRpm = mean_rpm;
    return status;
}

Outcome<int> runPolePairs(Desk &desk)
{
    const auto status = steadyStatus(desk);
    if (!status)
        return tl::make_unexpected(status.error());
    const double tachometer_rpm = desk.arguments.tachometer_rpm;
    const auto found = lab::polePairsBy(desk.board, *status, tachometer_rpm);
    if (!found)
        return failure(kRefused,
            QStringLiteral("Not conclusive: %1.").arg(QString::fromStdString(found.error())));
    if (!desk.out.json()) {
        desk.out.line(
            QStringLiteral("Pole pairs: %1 (%2)")
                .arg(QString::number(found->count), QString::number(found->measured, 'f', 2)));
        return kDone;
    }
    session::JsonText json;
    json.beginObject();
    json.member("kind", "pole pairs");
    json.member("pole_pairs", found->count);
    json.member("measured", found->measured);
    json.member("board_rpm", *status->speedRpm);
    json.member("tachometer_rpm", tachometer_rpm);
    json.endObject();
    desk.out.json(json.text());
    return kDone;
}

Outcome<bool> readPolePairs(const Given &given, Arguments &arguments)
{
    const auto number = plainNumber(given.words().first());
    if (!number || !(*number > 0.0))
        return usage(QStringLiteral("Write the speed that a tachometer reads, in rpm above 0, for "
                                    "example pole-pairs 1490."));
    arguments.tachometer_rpm = *number;
    return true;
}

} // namespace

const Command kPolePairs{.name = "pole-pairs",
    .words = "RPM",
    .help = "Counts the pole pairs of a motor that runs, by the speed that a tachometer reads.",
    .least = 1,
    .most = 1,
    .read = readPolePairs,
    .ofOneMotor = true,
    .run = runPolePairs};

} // namespace cli
