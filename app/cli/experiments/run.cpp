#include "experiments/run.h"

#include "experiments/plan_entry.h"
#include "experiments/reports.h"
#include "snapshot_work.h"

#include <QFileInfo>

#include <utility>

namespace cli {

using namespace std::chrono_literals;

namespace {

constexpr auto kStandstillWithin = 2s;

QString text(const std::string &words) { return QString::fromStdString(words); }

} // namespace

ExperimentRun::ExperimentRun(Desk &desk, const QString &file)
    : m_desk(desk)
    , m_kept(!file.isEmpty())
    , m_path(m_kept ? file : m_folder.filePath(QStringLiteral("run.pcapng")))
{
}

Outcome<lab::Subject> ExperimentRun::subject(bool pollable) const
{
    const auto find = pollable ? lab::pollableSubjectOf : lab::subjectOf;
    auto found = find(m_desk.board, m_desk.arguments.motor);
    if (!found)
        return failure(
            kRefused, QStringLiteral("Nothing can be measured. %1").arg(text(found.error())));
    return *found;
}

Outcome<int> ExperimentRun::run(const lab::Subject &subject, const std::vector<lab::Plan> &plans)
{
    const auto path = record(subject, plans);
    if (!path)
        return tl::make_unexpected(path.error());
    // It takes this thread, which on a slow computer would be taken for one that froze: the guardian would stop a motor
    // that goes on.
    m_desk.talk.close();
    return evaluate(*path, recordingName(m_path, m_kept), m_desk.out);
}

Outcome<QString> ExperimentRun::record(
    const lab::Subject &subject, const std::vector<lab::Plan> &plans)
{
    std::vector<Part> parts;
    std::vector<lab::Experiment> experiments;
    for (const lab::Plan &plan : plans) {
        const lab::Experiment experiment{plan, subject};
        if (const std::string why = lab::objectionTo(experiment); !why.empty())
            return failure(kRefused, QStringLiteral("Not begun: %1.").arg(text(why)));
        const auto entry = entryOf(m_desk, experiment);
        if (!entry)
            return tl::make_unexpected(entry.error());
        parts.push_back({experiment, *entry});
        experiments.push_back(experiment);
    }
    auto running = runningMotor(m_desk, subject, experiments);
    if (!running)
        return tl::make_unexpected(running.error());
    if (*running)
        m_ran.emplace(**running);
    const auto outcome = carryOut(parts);
    if (!outcome)
        return notGoingOn(outcome.error());
    m_swings = outcome->swings;
    return told(*outcome);
}

/// What is said of its end; a motor that ran goes on behind a whole one.
Outcome<QString> ExperimentRun::told(const lab::Outcome &outcome)
{
    const QString reason = text(outcome.reason);
    QStringList all{reason};
    if (!m_ran || outcome.end != lab::End::Complete)
        all.append(text(lab::shownText(outcome))); // where the motor came back
    all.removeAll(QString());
    const QString said = all.join(QStringLiteral("; "));
    switch (outcome.end) {
    case lab::End::Complete:
        if (m_ran && outcome.leaves)
            return notGoingOn({kRefused, QStringLiteral("Afterwards: %1.").arg(said)});
        if (!said.isEmpty())
            Output::error(QStringLiteral("Afterwards: %1.").arg(said));
        if (m_ran)
            if (const auto goesOn = m_ran->goOn(); !goesOn)
                return tl::make_unexpected(stopped(goesOn.error()));
        return m_path;
    case lab::End::Refused:
        return notGoingOn({kRefused, QStringLiteral("The experiment ended: %1.").arg(said)});
    case lab::End::Aborted:
        return notGoingOn(
            stopped({kAborted, QStringLiteral("The experiment was ended: %1.").arg(reason)}));
    case lab::End::Lost:
        return notGoingOn(
            stopped({kNoConnection, QStringLiteral("The experiment was ended: %1.").arg(reason)}));
    case lab::End::Interrupted:
        break;
    }
    return notGoingOn(
        stopped({kRefused, QStringLiteral("The experiment was interrupted: %1.").arg(reason)}));
}

tl::unexpected<Failure> ExperimentRun::notGoingOn(Failure why) const
{
    if (m_rests)
        why.sentence += QStringLiteral(" The motor ran before; it is not started again.");
    return tl::make_unexpected(std::move(why));
}

Outcome<lab::Outcome> ExperimentRun::carryOut(const std::vector<Part> &parts)
{
    Conversation &talk = m_desk.talk;
    ConversationRecording recording(talk, m_path, false, m_kept);
    if (const auto started = recording.start(m_desk.arguments.port); !started)
        return tl::make_unexpected(started.error());
    m_rests = m_ran.has_value();
    if (m_ran)
        if (const auto rests = m_ran->stop(); !rests)
            return tl::make_unexpected(broken(rests.error(), recording));
    const auto board = readBoard(m_desk, snapshots::Scope::All);
    if (!board)
        return tl::make_unexpected(board.error());
    recording.add(board->at, board->snapshot);
    recording.add(board->at, parts.front().entry);
    if (const auto armed = talk.armToMove(); !armed)
        return tl::make_unexpected(armed.error());
    const auto outcome = runAll(parts, recording);
    if (!outcome)
        return tl::make_unexpected(broken(outcome.error(), recording));
    if (const auto finished = recording.finish(); !finished)
        return tl::make_unexpected(finished.error());
    return *outcome;
}

/// @return  the last one's; those before it were complete, and what is to be said of them is said with it
Outcome<lab::Outcome> ExperimentRun::runAll(
    const std::vector<Part> &parts, ConversationRecording &recording)
{
    m_soFar = {};
    for (const Part &part : parts) {
        if (&part != &parts.front())
            recording.add(m_soFar.at, part.entry);
        auto outcome = m_desk.talk.run(part.experiment);
        if (!outcome)
            return outcome;
        recording.add(outcome->at, lab::entryOfEnd(*outcome));
        m_soFar = lab::inRow(m_soFar, *outcome, &part != &parts.back());
        if (m_soFar.end != lab::End::Complete)
            break;
    }
    return m_soFar;
}

/// Ctrl-C, or the connection broke: the motor is this run's to stop, before anything else. That ends the experiment,
/// which reports what it leaves behind.
Failure ExperimentRun::broken(const Failure &why, ConversationRecording &recording)
{
    Failure all = stopped(why);
    if (const auto &ended = m_desk.talk.experimentEnded()) {
        recording.add(ended->at, lab::entryOfEnd(*ended));
        const lab::Outcome told = lab::inRow(m_soFar, *ended, false);
        if (told.leaves)
            all.sentence += QStringLiteral(" The experiment was ended: %1.").arg(text(told.reason));
    }
    (void)recording.finish();
    return all;
}

Failure ExperimentRun::stopped(Failure why)
{
    if (const auto stopped = m_desk.talk.stop(kStandstillWithin); !stopped) {
        why.sentence.append(QLatin1Char(' ')).append(kStopNotConfirmed);
        if (stopped.error().status == kNoConnection) // the bound that broke was that of silence
            why.status = kNoConnection;
    } else {
        why.sentence += QStringLiteral(" The drive is idle.");
    }
    if (m_kept && QFileInfo::exists(m_path))
        why.sentence += QStringLiteral(" What was recorded until then is in %1.").arg(m_path);
    return why;
}

Outcome<bool> readRunFile(const Given &given, Arguments &arguments)
{
    if (!given.hasValue("output"))
        return true;
    const QString path = arguments.runFile = given.value("output");
    if (const auto named = checkRecordingName(path); !named || !QFileInfo::exists(path))
        return named;
    return failure(
        kFileError, QStringLiteral("%1 is there already; choose a name that is not.").arg(path));
}

} // namespace cli
