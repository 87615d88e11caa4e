// autotune: measures the response of the speed, proposes gains from it, and with --apply writes them and proves them by
// a fresh response and a step; where they miss what was predicted, once more from that response. The motor is
// afterwards as it was, but for its gains.
#include "experiments/plan_entry.h"
#include "experiments/reports.h"
#include "experiments/run.h"
#include "lab/evaluation/speed_loop.h"
#include "lab/evaluation/step_series.h"
#include "session/files/json_text.h"

#include <QDir>
#include <QFileInfo>
#include <QLoggingCategory>

#include <algorithm>
#include <optional>

Q_LOGGING_CATEGORY(lcTuningProgress, "cli.progress", QtWarningMsg)

namespace cli {

using session::JsonText;

namespace {

constexpr double kMsPerSecond = 1e3;
constexpr int kWidth = 10; ///< of a column
constexpr int kPasses = 2; ///< with --apply, where the first ones miss their promise
constexpr QLatin1String kSuffix(".pcapng");
constexpr const char *kResponse = "response", *kSteps = "steps"; ///< in the names of recordings

Outcome<lab::SpeedLoop> readLoop(Desk &desk, const lab::Subject &subject)
{
    const auto loop = readSpeedLoop(desk, subject);
    if (!loop)
        return tl::make_unexpected(loop.error());
    if (!*loop)
        return failure(kRefused, QStringLiteral("This board has no gains of a speed loop."));
    return **loop;
}

/// Where the next part is kept, e.g. RUN-2-steps.pcapng of RUN.pcapng; empty: nowhere.
QString partFile(const QString &run, const char *part)
{
    if (run.isEmpty())
        return {};
    const auto file = [stem = run.chopped(kSuffix.size())](int number, const char *of) {
        return QStringLiteral("%1-%2-%3%4")
            .arg(stem, QString::number(number), QLatin1String(of), kSuffix);
    };
    int number = 1;
    while (QFileInfo::exists(file(number, kResponse)) || QFileInfo::exists(file(number, kSteps)))
        ++number;
    return file(number, part);
}

/// What a recording says, if there is one.
template <class Found>
Outcome<Found> evaluated(const Outcome<QString> &path,
    Result<Found, std::string> (*evaluate)(const capture::Capture &, const lab::Happenings &))
{
    if (!path)
        return tl::make_unexpected(path.error());
    const auto recording = openRecording(*path);
    if (!recording)
        return tl::make_unexpected(recording.error());
    auto found = evaluate((*recording)->capture, (*recording)->report.happenings);
    if (!found)
        return failure(kRefused,
            QStringLiteral("Not conclusive: %1.").arg(QString::fromStdString(found.error())));
    return *found;
}

/// @param calmed  if it swings by itself, its gains are lent smaller ones; empty: it is to be measured as it is
Outcome<lab::SpeedResponse> respond(
    Desk &desk, const lab::Subject &subject, const std::optional<lab::SpeedLoop> &calmed)
{
    lab::ResponsePlan plan = lab::responsePlanFor(subject, desk.arguments.limits);
    if (desk.arguments.autotune.seconds > 0)
        plan.length = std::chrono::seconds(desk.arguments.autotune.seconds);
    std::optional<ExperimentRun> run;
    const auto file = [&] { return partFile(desk.arguments.runFile, kResponse); };
    auto path = run.emplace(desk, file()).record(subject, {plan});
    while (!path && run->swings() && calmed) {
        const auto calmer = lab::calmer(plan, *calmed);
        if (!calmer)
            break;
        plan = *calmer;
        Output::error(
            QStringLiteral("%1 It swings with its gains, and is measured once more with "
                           "SPEED_KP=%2 SPEED_KI=%3, which are given back afterwards.")
                .arg(path.error().sentence, QString::number(plan.kp), QString::number(plan.ki)));
        path = run.emplace(desk, file()).record(subject, {plan});
    }
    return evaluated(path, lab::evaluateResponse);
}

Outcome<lab::StepSeries> step(Desk &desk, const lab::Subject &subject)
{
    ExperimentRun run(desk, partFile(desk.arguments.runFile, kSteps));
    const auto path = run.record(subject, {lab::proofStepsFor(subject, desk.arguments.limits)});
    return evaluated(path, lab::stepSeries);
}

/// The gains that the board had, and those that were written since.
class Gains {
public:
    Gains(const lab::Subject &subject, const lab::SpeedLoop &before)
        : m_subject(subject)
        , m_before(typed(before.proportional, before.integral))
    {
    }
    void written(const lab::GainCandidate &gains, const Conversation::Asked &asked)
    {
        using drive::Outcome;
        const auto stays = [](const drive::WriteResult &one) {
            return one.outcome == Outcome::Refused || one.outcome == Outcome::NotSent;
        };
        const bool told = asked.ended.has_value();
        m_sure = told && asked.ended->outcome == Outcome::Ok;
        const bool none = told && !m_sure && asked.ended->outcome != Outcome::Unknown
            && std::all_of(asked.ended->writes.begin(), asked.ended->writes.end(), stays);
        if (none)
            m_sure = true; // the ones of before
        else
            m_now = typed(gains.proportional, gains.integral);
    }
    /// Behind the first of them, with a blank before it: which are in force, and the way back. Empty: those of before.
    QString left() const
    {
        return m_now.isEmpty()
            ? QString()
            : QStringLiteral(" The gains %1 %2; the way back: rotorscope-cli set %3.")
                  .arg(m_sure ? QStringLiteral("are now") : QStringLiteral("may now be"), m_now,
                      m_before);
    }
    Failure with(Failure why) const
    {
        why.sentence += left();
        return why;
    }

private:
    QString typed(int proportional, int integral) const
    {
        const lab::Registers &registers = m_subject.registers;
        return QStringLiteral("%1=%2 %3=%4")
            .arg(QString::fromStdString(m_subject.nameOf(registers.gain)),
                QString::number(proportional),
                QString::fromStdString(m_subject.nameOf(registers.integral)),
                QString::number(integral));
    }

    const lab::Subject &m_subject;
    QString m_before, m_now;
    bool m_sure = true;
};

Outcome<bool> writeGains(
    Desk &desk, const lab::Subject &subject, const lab::GainCandidate &gains, Gains &held)
{
    const drive::Write write{
        lab::gainWrites(subject, gains.proportional, gains.integral), drive::Reach::Parameters};
    const Conversation::Asked asked = desk.talk.askToTheEnd(write);
    held.written(gains, asked);
    if (asked.broken)
        return tl::make_unexpected(*asked.broken);
    if (asked.ended->outcome == drive::Outcome::Ok) {
        qCInfo(lcTuningProgress) << "gains written";
        return true;
    }
    return failure(kRefused,
        QStringLiteral("The gains were not written: %1.")
            .arg(QString::fromStdString(asked.ended->reason)));
}

struct Proof {
    lab::SpeedResponse response;
    lab::StepSeries step;
};

/// The gains are written, and what became of them is measured.
Outcome<Proof> prove(
    Desk &desk, const lab::Subject &subject, const lab::GainCandidate &gains, Gains &held)
{
    if (const auto written = writeGains(desk, subject, gains, held); !written)
        return tl::make_unexpected(written.error());
    auto response = respond(desk, subject, std::nullopt);
    if (!response)
        return tl::make_unexpected(response.error());
    auto series = step(desk, subject);
    if (!series)
        return tl::make_unexpected(series.error());
    return Proof{std::move(*response), std::move(*series)};
}

struct Tuned {
    lab::SpeedLoop before;
    std::vector<lab::GainCandidate> candidates;
    lab::GainCandidate chosen;
    std::optional<Proof> proof; ///< if they were written
};

void put(JsonText &json, const lab::GainCandidate &one)
{
    json.beginObject();
    json.member("goal", lab::nameOf(one.goal));
    json.member("speed_kp", one.proportional);
    json.member("speed_ki", one.integral);
    json.member("crossover_hz", one.crossover_hz);
    json.member("phase_margin_deg", one.phaseMargin_deg);
    json.member("ms", one.ms);
    json.member("rise_s", one.rise_s.value_or(std::nan("")));
    json.member("overshoot_pct", one.overshoot_pct);
    json.endObject();
}

QByteArray jsonOf(const Tuned &tuned)
{
    JsonText json;
    json.beginObject();
    json.member("kind", "autotune");
    json.member("goal", lab::nameOf(tuned.chosen.goal));
    json.beginObject("before");
    json.member("speed_kp", tuned.before.proportional);
    json.member("speed_ki", tuned.before.integral);
    json.endObject();
    json.beginArray("candidates");
    for (const lab::GainCandidate &one : tuned.candidates)
        put(json, one);
    json.endArray();
    json.member("applied", tuned.proof.has_value());
    if (tuned.proof) {
        const auto mean = [](const std::optional<lab::Estimate> &known) {
            return known ? known->value : std::nan("");
        };
        json.beginObject("proof");
        json.member("crossover_hz", mean(tuned.proof->response.crossover_hz));
        json.member("phase_margin_deg", mean(tuned.proof->response.phaseMargin_deg));
        json.member("ms", mean(tuned.proof->response.ms));
        json.member("rise_s", mean(tuned.proof->step.rise_s));
        json.member("overshoot_pct", mean(tuned.proof->step.overshoot_pct));
        json.endObject();
    }
    json.endObject();
    return json.text();
}

using Known = std::optional<double>; ///< a dash where it is not

QString line(const char *name, int proportional, int integral, Known crossover_hz, Known margin_deg,
    Known ms, Known rise_s, Known overshoot_pct)
{
    const auto cellOf = [](Known value, int digits, double factor = 1.0) {
        return value ? QString::number(*value * factor, 'f', digits) : QStringLiteral("-");
    };
    QString text = QString::fromLatin1(name).leftJustified(kWidth);
    for (const QString &cell : {QString::number(proportional), QString::number(integral),
             cellOf(crossover_hz, 1), cellOf(margin_deg, 0), cellOf(ms, 2),
             cellOf(rise_s, 1, kMsPerSecond), cellOf(overshoot_pct, 1)})
        text += cell.rightJustified(kWidth);
    return text;
}

void print(const Tuned &tuned, Output &out)
{
    out.line(
        QStringLiteral("            speed_kp  speed_ki  cross Hz  margin \u00b0        Ms   rise "
                       "ms    over %"));
    for (const lab::GainCandidate &one : tuned.candidates)
        out.line(line(lab::nameOf(one.goal), one.proportional, one.integral, one.crossover_hz,
            one.phaseMargin_deg, one.ms, one.rise_s, one.overshoot_pct));
    if (!tuned.proof)
        return;
    out.line(QStringLiteral("before").leftJustified(kWidth)
        + QString::number(tuned.before.proportional).rightJustified(kWidth)
        + QString::number(tuned.before.integral).rightJustified(kWidth));
    const lab::SpeedResponse &got = tuned.proof->response;
    const lab::StepSeries &step = tuned.proof->step;
    const auto value = [](const std::optional<lab::Estimate> &known) {
        return known ? Known(known->value) : std::nullopt;
    };
    out.line(line("measured", tuned.chosen.proportional, tuned.chosen.integral,
        value(got.crossover_hz), value(got.phaseMargin_deg), value(got.ms), value(step.rise_s),
        value(step.overshoot_pct)));
}

/// Whether the loop keeps what was promised, and else the way back.
Outcome<int> verdict(const Tuned &tuned, const Gains &held)
{
    if (!tuned.proof)
        return kDone;
    const lab::Promise promised = lab::promiseOf(tuned.chosen, tuned.chosen.goal);
    const lab::SpeedResponse &got = tuned.proof->response;
    QString what;
    const std::optional<lab::Estimate> &overshoot_pct = tuned.proof->step.overshoot_pct;
    switch (lab::keptBy(got, overshoot_pct, promised)) {
    case lab::Kept::Yes:
        return kDone;
    case lab::Kept::TooLively:
        what = QStringLiteral("worse than predicted: Ms %1 instead of at most %2")
                   .arg(QString::number(got.ms->value, 'f', 2), QString::number(promised.ms));
        break;
    case lab::Kept::TooSlow:
        what = QStringLiteral("slower than predicted: crossover %1 Hz instead of %2 Hz")
                   .arg(QString::number(got.crossover_hz->value, 'f', 1),
                       QString::number(promised.crossover_hz, 'f', 1));
        break;
    case lab::Kept::Overshoots:
        what = QStringLiteral("worse than predicted: its steps overshoot by %1 % instead of %2 %")
                   .arg(QString::number(overshoot_pct->value, 'f', 0),
                       QString::number(promised.overshoot_pct, 'f', 0));
        break;
    case lab::Kept::Unclear:
        what = got.ms && got.crossover_hz
            ? QStringLiteral("not proved: the overshoot of its steps could not be measured")
            : QStringLiteral("not proved: its gain does not fall through 1 where it could be "
                             "measured");
        break;
    }
    return tl::make_unexpected(held.with({kRefused, QStringLiteral("The loop is %1.").arg(what)}));
}

/// Candidates from a response, and the one for the goal that was asked for.
Outcome<Tuned> propose(Desk &desk, const lab::Subject &subject, const lab::SpeedLoop &loop,
    const lab::SpeedResponse &response)
{
    const auto proposed =
        lab::proposeGains(response, loop.digits, subject.limits.nominalCurrentAmps);
    if (!proposed)
        return failure(kRefused,
            QStringLiteral("Not conclusive: %1.").arg(QString::fromStdString(proposed.error())));
    const auto chosen = std::find_if(proposed->begin(), proposed->end(),
        [&](const lab::GainCandidate &one) { return one.goal == desk.arguments.autotune.goal; });
    if (chosen == proposed->end())
        return failure(kRefused,
            QStringLiteral("Not conclusive: no gains keep the distance that is asked for."));
    return Tuned{loop, *proposed, *chosen, std::nullopt};
}

Outcome<int> runAutotune(Desk &desk)
{
    const auto subject = ExperimentRun(desk).subject();
    if (!subject)
        return tl::make_unexpected(subject.error());
    const auto loop = readLoop(desk, *subject);
    if (!loop)
        return tl::make_unexpected(loop.error());
    const auto measured = respond(desk, *subject, *loop);
    if (!measured)
        return tl::make_unexpected(measured.error());
    auto tuned = propose(desk, *subject, *loop, *measured);
    if (!tuned)
        return tl::make_unexpected(tuned.error());
    Gains held(*subject, *loop);
    for (int pass = 0; desk.arguments.autotune.apply && pass < kPasses; ++pass) {
        auto proof = prove(desk, *subject, tuned->chosen, held);
        if (!proof)
            return tl::make_unexpected(held.with(proof.error()));
        tuned->proof = std::move(*proof);
        const lab::Promise promised = lab::promiseOf(tuned->chosen, tuned->chosen.goal);
        const lab::Kept kept =
            lab::keptBy(tuned->proof->response, tuned->proof->step.overshoot_pct, promised);
        if (!lab::missed(kept) || pass + 1 == kPasses)
            break;
        auto nearer = propose(desk, *subject, *loop, tuned->proof->response);
        if (!nearer)
            break; // the verdict says what came of it
        Output::error(QStringLiteral("Those gains miss what was predicted; once more from their "
                                     "own response."));
        tuned = std::move(nearer);
    }
    if (desk.out.json())
        desk.out.json(jsonOf(*tuned));
    else
        print(*tuned, desk.out);
    return verdict(*tuned, held);
}

constexpr OptionText kAutotuneOptions[] = {
    {"goal", "GOAL", "stiff, medium or quick: how near to instability; medium if not given."},
    {"seconds", "S", "How long each response takes, 4 to 40; 16 if not given."},
    {"apply", "", "Writes the gains, and proves them by a fresh response and steps."},
    {"o,output", "RUN.pcapng",
        "Keeps the recordings, as RUN-1-response.pcapng, RUN-2-response.pcapng, RUN-3-steps.pcapng "
        "and so on, for rotorscope-cli evaluate."},
};

/// Nothing that is there of that name is mixed with this run's.
Outcome<bool> readPartFiles(const Given &given, Arguments &arguments)
{
    const auto named = readRunFile(given, arguments);
    if (!named || arguments.runFile.isEmpty())
        return named;
    const QFileInfo run(arguments.runFile);
    const QStringList there =
        run.dir().entryList({run.completeBaseName() + QStringLiteral("-*-response") + kSuffix,
                                run.completeBaseName() + QStringLiteral("-*-steps") + kSuffix},
            QDir::Files);
    if (there.isEmpty())
        return true;
    return failure(kFileError,
        QStringLiteral("%1 is there already; choose a name that is not.")
            .arg(run.dir().filePath(there.first())));
}

Outcome<bool> readAutotune(const Given &given, Arguments &arguments)
{
    arguments.autotune.apply = given.has("apply");
    const auto numbers = readNumbers(given, {{"seconds", &arguments.autotune.seconds, 4, 40}});
    if (!numbers)
        return numbers;
    if (const auto files = readPartFiles(given, arguments); !files || !given.has("goal"))
        return files;
    for (const lab::Goal goal : lab::kGoals)
        if (given.value("goal") == QLatin1String(lab::nameOf(goal))) {
            arguments.autotune.goal = goal;
            return true;
        }
    return usage(
        QStringLiteral("A --goal is stiff, medium or quick, not \"%1\".").arg(given.value("goal")));
}

} // namespace

const Command kAutotune{.name = "autotune",
    .help =
        "Proposes gains of the speed loop from its measured response; --apply writes and proves "
        "them.",
    .options = kAutotuneOptions,
    .read = readAutotune,
    .canMove = true,
    .ownsMotor = true,
    .ofOneMotor = true,
    .run = runAutotune};

} // namespace cli
