// step: brings the motor to one speed, steps it to another and back, and says how its speed loop followed. Afterwards the
// motor is as it was.
#include "commands.h"
#include "drive/values.h"
#include "experiments/step_report.h"
#include "snapshot_work.h"

#include <QFileInfo>
#include <QTemporaryDir>

namespace cli {

using namespace std::chrono_literals;

namespace {

constexpr auto kStandstillWithin = 2s;

class StepCommand {
public:
    explicit StepCommand(Desk &desk)
        : m_desk(desk)
    {
    }
    Outcome<int> run();

private:
    Outcome<lab::StepExperiment> experiment(int motor) const;
    Outcome<int> record(const lab::StepExperiment &experiment);
    Outcome<double> jump(const lab::StepBoard &board) const;
    Failure stopped(Failure why);

    Desk &m_desk;
    QTemporaryDir m_folder; ///< for a recording that is not kept
    QString m_path;
    std::optional<lab::StepOutcome> m_outcome;
};

Outcome<int> StepCommand::run()
{
    const auto motor = m_desk.checkMotor();
    if (!motor)
        return motor;
    const auto wanted = experiment(*motor);
    if (!wanted)
        return tl::make_unexpected(wanted.error());
    m_path = m_desk.arguments.step.recording;
    if (m_path.isEmpty())
        m_path = m_folder.filePath(QStringLiteral("run.pcapng"));
    const auto recorded = record(*wanted);
    if (!recorded)
        return recorded;
    const QString reason = QString::fromStdString(m_outcome->reason);
    switch (m_outcome->end) {
    case lab::StepEnd::Complete:
        if (!reason.isEmpty())
            Output::error(QStringLiteral("Afterwards: %1.").arg(reason));
        break;
    case lab::StepEnd::Refused:
        return failure(kRefused, QStringLiteral("The series ended: %1.").arg(reason));
    case lab::StepEnd::Aborted:
        return tl::make_unexpected(
            stopped({kAborted, QStringLiteral("The series was ended: %1.").arg(reason)}));
    case lab::StepEnd::Interrupted:
        return tl::make_unexpected(
            stopped({kRefused, QStringLiteral("The series was interrupted: %1.").arg(reason)}));
    }
    const auto opened = openRecording(m_path);
    if (!opened)
        return tl::make_unexpected(opened.error());
    const auto series = seriesIn(**opened, m_path);
    if (!series)
        return tl::make_unexpected(series.error());
    return report(*series, m_desk.out);
}

Outcome<lab::StepExperiment> StepCommand::experiment(int motor) const
{
    const StepArguments &asked = m_desk.arguments.step;
    const auto board = lab::stepBoardOf(m_desk.board, motor);
    if (!board)
        return failure(kRefused,
            QStringLiteral("No steps can be measured: %1.")
                .arg(QString::fromStdString(board.error())));
    lab::StepPlan plan;
    plan.motor = motor;
    plan.fromRpm = asked.fromRpm;
    plan.toRpm = asked.toRpm;
    plan.repeat = asked.repeat;
    plan.hold = std::chrono::milliseconds(asked.hold_ms);
    plan.maxRpm = m_desk.arguments.limits.maxSpeedRpm;
    plan.maxAmps = m_desk.arguments.limits.maxCurrentAmps;
    if (const std::string why = lab::objectionTo(plan, board->limits); !why.empty())
        return failure(
            kRefused, QStringLiteral("Not begun: %1.").arg(QString::fromStdString(why)));
    return lab::StepExperiment{plan, *board};
}

/// What the loop's gain makes of a step at once, by which the instant of each is found.
Outcome<double> StepCommand::jump(const lab::StepBoard &board) const
{
    if (board.gain == 0 || board.gainExponent == 0)
        return 0.0;
    const auto read = m_desk.talk.read({board.gain, board.gainExponent});
    if (!read)
        return tl::make_unexpected(read.error());
    const auto gain = drive::asNumber(read->at(0).value);
    const auto exponent = drive::asNumber(read->at(1).value);
    return gain && exponent ? lab::jumpPerRpm(board, *gain, *exponent) : 0.0;
}

Outcome<int> StepCommand::record(const lab::StepExperiment &experiment)
{
    Conversation &talk = m_desk.talk;
    ConversationRecording recording(talk, m_path, false);
    if (const auto started = recording.start(m_desk.arguments.port); !started)
        return started;
    const auto board = readBoard(m_desk, snapshots::Scope::All);
    if (!board)
        return tl::make_unexpected(board.error());
    recording.add(board->at, board->snapshot);
    const auto jumpSize = jump(experiment.board);
    if (!jumpSize)
        return tl::make_unexpected(jumpSize.error());
    recording.add(board->at, lab::entryOf(experiment, *jumpSize));
    if (const auto armed = talk.armToMove(); !armed)
        return tl::make_unexpected(armed.error());
    const auto outcome = talk.run(experiment);
    if (outcome) {
        m_outcome = *outcome;
        recording.add(outcome->at,
            lab::entryOfEnd(outcome->end == lab::StepEnd::Complete, outcome->reason));
    }
    const auto finished = recording.finish();
    if (!outcome) // Ctrl-C, or the connection broke: the motor is this run's to stop
        return tl::make_unexpected(stopped(outcome.error()));
    return finished;
}

Failure StepCommand::stopped(Failure why)
{
    if (!m_desk.talk.stop(kStandstillWithin))
        why.sentence += QStringLiteral(" Stop NOT confirmed. Use the hardware stop.");
    else
        why.sentence += QStringLiteral(" The drive is idle.");
    if (!m_desk.arguments.step.recording.isEmpty() && QFileInfo::exists(m_path))
        why.sentence += QStringLiteral(" What was recorded until then is in %1.").arg(m_path);
    return why;
}

Outcome<int> runStep(Desk &desk) { return StepCommand(desk).run(); }

constexpr OptionText kOptions[] = {
    {"from", "RPM", "The speed to step from."},
    {"to", "RPM", "The speed to step to."},
    {"repeat", "N", "Steps up, and as many down; 5 if not given."},
    {"hold", "MS", "How long each speed is held; 500 if not given."},
    {"o,output", "RUN.pcapng", "Keeps the recording, for rotorscope-cli evaluate."},
};

Outcome<bool> readStep(const Given &given, Arguments &arguments)
{
    StepArguments &step = arguments.step;
    if (given.words().first() != QLatin1String("speed"))
        return usage(QStringLiteral("Only speed can be stepped, not \"%1\": write step speed "
                                    "--from A --to B.")
                         .arg(given.words().first()));
    if (!given.has("from") || !given.has("to"))
        return usage(QStringLiteral("Say between which speeds, for example --from 1000 --to 1500."));
    constexpr int kMostRpm = 1'000'000;
    constexpr int kMostRepeats = 100, kMostHold_ms = 10'000;
    for (const auto &[option, value, least, most] :
        {std::tuple{"from", &step.fromRpm, -kMostRpm, kMostRpm},
            std::tuple{"to", &step.toRpm, -kMostRpm, kMostRpm},
            std::tuple{"repeat", &step.repeat, 1, kMostRepeats},
            std::tuple{"hold", &step.hold_ms, 50, kMostHold_ms}}) {
        if (!given.has(option))
            continue;
        const auto number = wholeNumber(
            given.value(option), least, most, QStringLiteral("--") + QLatin1String(option));
        if (!number)
            return tl::make_unexpected(number.error());
        *value = *number;
    }
    step.recording = given.value("output");
    if (!step.recording.isEmpty() && QFileInfo::exists(step.recording))
        return failure(kFileError,
            QStringLiteral("%1 is there already; choose a name that is not.").arg(step.recording));
    return true;
}

} // namespace

const Command kStep{.name = "step",
    .words = "speed --from A --to B",
    .help = "Steps the speed up and down and says how its loop followed; then all is as before.",
    .least = 1,
    .most = 1,
    .options = kOptions,
    .read = readStep,
    .canMove = true,
    .ownsMotor = true,
    .ofOneMotor = true,
    .run = runStep};

} // namespace cli
