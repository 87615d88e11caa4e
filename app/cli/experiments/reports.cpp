#include "experiments/reports.h"

#include "session/files/finding_json.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cli {

namespace {

QString sentence(const std::string &words)
{
    QString text = QString::fromStdString(words);
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text + QLatin1Char('.');
}

QString number(const std::optional<double> &value, double factor, int digits)
{
    return value ? QString::number(*value * factor, 'f', digits) : QStringLiteral("-");
}

QString row(const QString &name, const QStringList &cells)
{
    QString line = name.leftJustified(12);
    for (const QString &cell : cells)
        line += cell.rightJustified(20);
    return line;
}

QString meanText(const std::optional<lab::Estimate> &mean, double factor, int digits)
{
    if (!mean)
        return QStringLiteral("-");
    const QString value = number(mean->value, factor, digits);
    return mean->low
        ? value + QStringLiteral(" +- ") + number(mean->value - *mean->low, factor, digits)
        : value;
}

constexpr double kMilli = 1e3;
constexpr double kPercent = 100.0;

void print(const lab::MeasuredSteps &series, Output &out)
{
    out.line(row({},
        {QStringLiteral("rise ms"), QStringLiteral("overshoot %"), QStringLiteral("settling ms"),
            QStringLiteral("peak Iq A"), QStringLiteral("instant +- ms")}));
    int count = 0;
    for (const lab::StepRun &run : series.runs)
        out.line(row(
            QString::number(++count) + (run.up ? QStringLiteral(" up") : QStringLiteral(" down")),
            {number(run.rise_s, kMilli, 2), number(run.overshoot_pct, 1.0, 1),
                number(run.settling_s, kMilli, 1), number(run.peakIq_a, 1.0, 2),
                number(run.instantError_s, kMilli, 2)}));
    out.line(row(QStringLiteral("mean (95 %)"),
        {meanText(series.rise_s, kMilli, 2), meanText(series.overshoot_pct, 1.0, 1),
            meanText(series.settling_s, kMilli, 1), meanText(series.peakIq_a, 1.0, 2), {}}));
}

/// @param place  the last decimal one that is told; 0: four digits
QString digitsText(double value, double place)
{
    constexpr int kDigits = 4, kMost = 9;
    if (!(place > 0.0) || std::abs(value) < place / 2.0)
        return QString::number(place > 0.0 ? 0.0 : value, 'g', kDigits);
    const auto last = static_cast<int>(std::round(std::log10(place)));
    const double rounded = std::round(value / place) * place;
    const auto first = static_cast<int>(std::floor(std::log10(std::abs(rounded)) + 1e-9));
    constexpr int kLeastFixed = -4; // as printf's %g has it
    return first < kLeastFixed
        ? QString::number(rounded, 'e', std::clamp(first - last, 0, kMost))
        : QString::number(rounded, 'f', std::clamp(-last, 0, kMost - kLeastFixed));
}

QString line(const char *name, const lab::Estimate &estimate, const char *unit)
{
    const double place = lab::lastPlaceOf(estimate);
    const auto text = [place](double value) { return digitsText(value, place); };
    return QStringLiteral("%1 %2 %3 (%4 to %5)")
        .arg(QString::fromLatin1(name).leftJustified(17), text(estimate.value),
            QString::fromUtf8(unit), text(estimate.low.value_or(0.0)),
            text(estimate.high.value_or(0.0)));
}

void print(const lab::Mechanics &found, Output &out)
{
    constexpr const char *kInertiaUnit = "kg m\u00b2";
    out.line(line("Inertia", found.inertia_kgm2, kInertiaUnit));
    if (found.both) {
        out.line(line("  forwards", found.both->forwards_kgm2, kInertiaUnit));
        out.line(line("  backwards", found.both->backwards_kgm2, kInertiaUnit));
    }
    out.line(line("Viscous friction", found.viscous_nms, "N m s"));
    out.line(line("Dry friction", found.dry_nm, "N m"));
    if (found.fan)
        out.line(line("Fan", found.fan_nms2, "N m s\u00b2"));
    if (found.both)
        out.line(line("Always there", found.both->always_nm, "N m"));
    out.line(QStringLiteral("Model: %1; it leaves %2 % of the torque")
                 .arg(QLatin1String(session::modelOf(found)),
                     QString::number(found.share * kPercent, 'g', 2)));
}

template <lab::HasFigures Found>
void print(const Found &found, Output &out)
{
    for (const lab::Figure &one : figuresOf(found))
        if (one.value)
            out.line(line(one.name, *one.value, one.unit));
}

void print(const lab::FrequencyResponse &found, const QString &unit, Output &out)
{
    out.line(row(QStringLiteral("Hz"),
        {unit, QStringLiteral("+- %"), QStringLiteral("degrees"), QStringLiteral("loop dB"),
            QStringLiteral("loop degrees"), QStringLiteral("coherence")}));
    constexpr double kDegrees = 180.0 / std::numbers::pi, kDecibel = 20.0;
    for (const lab::ResponsePoint &point : found.points) {
        const auto known = [&](double value) {
            return point.plantKnown ? std::optional(value) : std::nullopt;
        };
        const auto loop = [&](double value) {
            return found.ms ? std::optional(value) : std::nullopt;
        };
        out.line(row(QString::number(point.hz, 'f', 1),
            {number(known(std::abs(point.plant)), 1.0, 3),
                number(known(session::halfInterval(point) / std::abs(point.plant)), kPercent, 1),
                number(known(std::arg(point.plant)), kDegrees, 1),
                number(loop(std::log10(std::abs(point.loop))), kDecibel, 1),
                number(loop(std::arg(point.loop)), kDegrees, 1),
                QString::number(point.coherence, 'f', 3)}));
    }
    out.line(QStringLiteral("Loop: crossover %1 Hz, phase margin %2 degrees, Ms %3")
                 .arg(meanText(found.crossover_hz, 1.0, 2), meanText(found.phaseMargin_deg, 1.0, 1),
                     meanText(found.ms, 1.0, 2)));
}

void print(const lab::SpeedResponse &found, Output &out)
{
    print(found, QStringLiteral("(rad/s)/A"), out);
}

void print(const lab::FrequencyResponse &found, Output &out)
{
    print(found, QStringLiteral("A/A"), out);
}

/// Why the experiment did not come to its end, in a sentence with a blank behind it; empty: it did, or nothing says so.
QString endedEarlyText(const lab::Happenings &all)
{
    for (const auto &[at, what] : all)
        if (what.name == lab::kEndEntry && what.field("outcome") != "complete")
            return QStringLiteral("The experiment ended early: %1. ")
                .arg(QString::fromStdString(what.field("reason")));
    return {};
}

/// Of one run. @param head  in front of what has to be known of it; empty: it is the only one that is meant
/// @param failed  in front of why nothing follows from it
Outcome<int> tell(const Result<lab::Finding, std::string> &found, const lab::Happenings &run,
    const QString &head, const QString &failed, Output &out)
{
    if (!found) // what could not be measured was mostly not begun
        return failure(kRefused, failed + endedEarlyText(run) + sentence(found.error()));
    if (out.json())
        out.json(session::findingJson(*found));
    else
        std::visit([&out](const auto &one) { print(one, out); }, *found);
    for (const std::string &note : lab::notesOf(*found))
        Output::error(head + sentence(note));
    if (const std::string lack = lab::lackOf(*found); !lack.empty())
        return failure(kRefused, head + sentence(lack));
    return kDone;
}

/// Of several, by their numbers: one that says nothing keeps its place.
Outcome<int> tellAll(const QString &name, const capture::Capture &capture,
    const std::vector<lab::Happenings> &runs, Output &out)
{
    const QString count = QString::number(runs.size());
    QStringList lacking;
    for (const lab::Happenings &run : runs) {
        const QString number = QString::number(&run - runs.data() + 1);
        if (!out.json())
            out.line(QStringLiteral("Run %1 of %2: %3, at %4 s")
                         .arg(number, count, QString::fromStdString(lab::nameOfRun(run)),
                             QString::number(capture::toSeconds(run.front().first), 'f', 1)));
        const auto found = lab::findingIn(capture, run);
        if (!found && out.json())
            out.json("null");
        const QString head = QStringLiteral("Run %1: ").arg(number);
        const auto told = tell(found, run, head, head, out);
        if (told)
            continue;
        Output::error(told.error().sentence);
        lacking.append(number);
    }
    if (lacking.isEmpty())
        return kDone;
    return failure(kRefused,
        QStringLiteral("%1: not conclusive: %2 %3 of %4.")
            .arg(name, lacking.size() == 1 ? QStringLiteral("run") : QStringLiteral("runs"),
                lacking.join(QStringLiteral(", ")), count));
}

/// Of the recording of that name, whole or not.
Outcome<int> tellRuns(
    const QString &name, const OpenedRecording &recording, Output &out, int number)
{
    const lab::Happenings &all = recording.report.happenings;
    const std::vector<lab::Happenings> runs = lab::runsIn(all);
    const auto count = static_cast<int>(runs.size());
    if (count > 0 && number > count)
        return failure(kUsage,
            QStringLiteral("%1 has no run %2, only %3.")
                .arg(name, QString::number(number), QString::number(count)));
    if (count > 1 && number == 0)
        return tellAll(name, recording.capture, runs, out);
    // Without any, that is said.
    const lab::Happenings &run = count > 1 ? runs[static_cast<std::size_t>(number - 1)] : all;
    return tell(lab::findingIn(recording.capture, run), run, {}, name + QStringLiteral(": "), out);
}

} // namespace

Outcome<int> evaluate(const QString &path, const QString &name, Output &out, int number)
{
    const auto recording = openRecording(path);
    if (!recording)
        return tl::make_unexpected(recording.error());
    auto told = tellRuns(name, **recording, out, number);
    const QString lack = lackText(**recording);
    if (lack.isEmpty())
        return told;
    const QString missing = QStringLiteral("%1 is not whole: %2.").arg(name, lack);
    if (told)
        return failure(kDataLost, missing);
    Output::error(missing);
    return told;
}

} // namespace cli
