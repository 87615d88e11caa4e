#include "experiments/experiment_run.h"

#include "experiments/reports.h"
#include "snapshot_work.h"

#include <QFileInfo>

namespace cli {

using namespace std::chrono_literals;

namespace {

constexpr auto kStandstillWithin = 2s;

QString text(const std::string &words) { return QString::fromStdString(words); }

} // namespace

ExperimentRun::ExperimentRun(Desk &desk)
    : m_desk(desk)
    , m_kept(!desk.arguments.runFile.isEmpty())
    , m_path(m_kept ? desk.arguments.runFile : m_folder.filePath(QStringLiteral("run.pcapng")))
{
}

Outcome<lab::Subject> ExperimentRun::subject() const
{
    const auto motor = m_desk.checkMotor();
    if (!motor)
        return tl::make_unexpected(motor.error());
    auto found = lab::subjectOf(m_desk.board, *motor);
    if (!found)
        return failure(
            kRefused, QStringLiteral("Nothing can be measured: %1.").arg(text(found.error())));
    return *found;
}

Outcome<int> ExperimentRun::run(const lab::Experiment &experiment, const record::Happening &entry)
{
    if (const std::string why = lab::objectionTo(experiment); !why.empty())
        return failure(kRefused, QStringLiteral("Not begun: %1.").arg(text(why)));
    const auto outcome = carryOut(experiment, entry);
    if (!outcome)
        return tl::make_unexpected(outcome.error());
    const QString reason = text(outcome->reason);
    switch (outcome->end) {
    case lab::End::Complete:
        if (!reason.isEmpty())
            Output::error(QStringLiteral("Afterwards: %1.").arg(reason));
        return evaluate(m_path, m_desk.out);
    case lab::End::Refused:
        return failure(kRefused, QStringLiteral("The experiment ended: %1.").arg(reason));
    case lab::End::Aborted:
        return tl::make_unexpected(
            stopped({kAborted, QStringLiteral("The experiment was ended: %1.").arg(reason)}));
    case lab::End::Lost:
        return tl::make_unexpected(
            stopped({kNoConnection, QStringLiteral("The experiment was ended: %1.").arg(reason)}));
    case lab::End::Interrupted:
        break;
    }
    return tl::make_unexpected(
        stopped({kRefused, QStringLiteral("The experiment was interrupted: %1.").arg(reason)}));
}

Outcome<lab::Outcome> ExperimentRun::carryOut(
    const lab::Experiment &experiment, const record::Happening &entry)
{
    Conversation &talk = m_desk.talk;
    ConversationRecording recording(talk, m_path, false);
    if (const auto started = recording.start(m_desk.arguments.port); !started)
        return tl::make_unexpected(started.error());
    const auto board = readBoard(m_desk, snapshots::Scope::All);
    if (!board)
        return tl::make_unexpected(board.error());
    recording.add(board->at, board->snapshot);
    recording.add(board->at, entry);
    if (const auto armed = talk.armToMove(); !armed)
        return tl::make_unexpected(armed.error());
    const auto outcome = talk.run(experiment);
    if (outcome)
        recording.add(
            outcome->at, lab::entryOfEnd(outcome->end == lab::End::Complete, outcome->reason));
    const auto finished = recording.finish();
    if (!outcome) // Ctrl-C, or the connection broke: the motor is this run's to stop
        return tl::make_unexpected(stopped(outcome.error()));
    if (!finished)
        return tl::make_unexpected(finished.error());
    return *outcome;
}

Failure ExperimentRun::stopped(Failure why)
{
    if (const auto stopped = m_desk.talk.stop(kStandstillWithin); !stopped) {
        why.sentence += QStringLiteral(" Stop NOT confirmed. Use the hardware stop.");
        if (stopped.error().status == kNoConnection) // the bound that broke was that of silence
            why.status = kNoConnection;
    } else {
        why.sentence += QStringLiteral(" The drive is idle.");
    }
    if (m_kept && QFileInfo::exists(m_path))
        why.sentence += QStringLiteral(" What was recorded until then is in %1.").arg(m_path);
    return why;
}

Outcome<bool> readNumbers(const Given &given, std::initializer_list<NumberOption> options)
{
    for (const NumberOption &option : options) {
        if (!given.has(option.name))
            continue;
        const auto number = wholeNumber(given.value(option.name), option.least, option.most,
            QStringLiteral("--") + QLatin1String(option.name));
        if (!number)
            return tl::make_unexpected(number.error());
        *option.value = *number;
    }
    return true;
}

Outcome<bool> readRunFile(const Given &given, Arguments &arguments)
{
    const QString path = arguments.runFile = given.value("output");
    if (path.isEmpty() || !QFileInfo::exists(path))
        return true;
    return failure(
        kFileError, QStringLiteral("%1 is there already; choose a name that is not.").arg(path));
}

} // namespace cli
