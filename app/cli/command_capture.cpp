// capture: starts the motor if asked to, records exactly the wanted time, stops what it started, writes the file.
#include "commands.h"
#include "recorder.h"
#include "recording_work.h"
#include "sentences.h"
#include "session/files/export_formats.h"
#include "session/files/motion_log_file.h"
#include "session/files/whole_file.h"
#include "snapshot_work.h"
#include "values.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonObject>
#include <QLoggingCategory>
#include <QTemporaryFile>

#include <cmath>

Q_LOGGING_CATEGORY(lcProgress, "cli.progress", QtWarningMsg)

namespace cli {

using namespace std::chrono_literals;
using drive::MotorState;

namespace {

constexpr auto kRunWithin = 10s; ///< from the start to RUN
constexpr auto kSettleWithin = 1s; ///< after the ramp, for the speed to follow
constexpr auto kStandstillWithin = 2s;
constexpr auto kFirstSampleWithin = 5s;
constexpr double kMostBytes = 1.2e9; ///< of samples, which are kept in memory until the end

/// Whatever came of a step that succeeded.
constexpr auto kAllDone = [](const auto &) -> int { return kDone; };

QString recordingAdvice()
{
    return QStringLiteral("record fewer signals, or --mf with a smaller --mf-rate");
}

/// Looks whether the file could be written, before a motor is started for it.
Outcome<int> checkTarget(const QString &path)
{
    const QFileInfo target(path);
    const auto refused = [&path](const QString &why) {
        return failure(kFileError,
            QStringLiteral("%1 cannot be written: %2; choose another place with -o.")
                .arg(path, why));
    };
    if (target.exists() && !target.isFile())
        return refused(QStringLiteral("it is no file"));
    QTemporaryFile probe(target.absolutePath() + QStringLiteral("/.rotorscope-XXXXXX"));
    if (!probe.open())
        return refused(probe.errorString());
    return kDone;
}

class CaptureRun {
public:
    explicit CaptureRun(Desk &desk)
        : m_desk(desk)
        , m_wanted(desk.arguments.capture)
        , m_recorder(desk.arguments.capture.seconds)
    {
    }
    /// Whichever way it ended, the conversation goes on: the farewell has events, too.
    ~CaptureRun() { m_desk.talk.listen({}); }
    CaptureRun(const CaptureRun &) = delete;
    CaptureRun &operator=(const CaptureRun &) = delete;

    Outcome<int> run();

private:
    Outcome<drive::Stream> stream();
    bool boardStreams() const
    {
        return m_desk.board.streaming.tickHz > 0 && m_desk.board.streaming.maxSignals > 0;
    }
    Outcome<drive::Stream> pollInstead(
        std::vector<catalog::RegisterId> registers, const std::vector<catalog::RegisterId> &more);
    Outcome<int> rehearse(const drive::Stream &stream);
    Outcome<int> prepare();
    Outcome<int> startMotor();
    Outcome<int> ramp();
    Outcome<int> startRecording();
    Outcome<int> begin(const drive::Stream &stream);
    Outcome<int> finish();
    Outcome<int> record(const drive::Stream &stream);
    Outcome<int> stopMotor();
    Failure abandon(Failure why);
    Failure salvage(Failure why);
    Outcome<int> writeMotionLog() const;
    Outcome<int> write();
    QString lengthText() const;
    QString lossAdvice() const;
    Outcome<int> verdict() const;
    /// How often a second each register could be read if the line carried nothing else.
    double possibleRate() const
    {
        return m_desk.board.streaming.readsPerSecond
            / static_cast<double>(std::max<std::size_t>(1, m_polled.size()));
    }

    Desk &m_desk;
    const CaptureArguments &m_wanted;
    Recorder m_recorder;
    std::vector<catalog::RegisterId> m_polled; ///< where the board records nothing itself
    std::optional<ConversationRecording> m_recording;
    bool m_started = false;
    drive::LinkCounters m_lineBefore, m_line; ///< at the beginning of the recording, and last
    std::optional<drive::MotorStatus> m_fault; ///< of the motor that this run started
};

Outcome<int> CaptureRun::run()
{
    const auto wanted = stream();
    if (!wanted)
        return tl::make_unexpected(wanted.error());
    if (!m_wanted.file.isEmpty())
        if (const auto possible = checkTarget(m_wanted.file); !possible)
            return possible;
    if (const auto possible = rehearse(*wanted); !possible)
        return possible;
    if (const auto begun = startRecording(); !begun)
        return begun;
    const Outcome<int> done = record(*wanted);
    if (!done)
        return tl::make_unexpected(salvage(abandon(done.error())));
    const auto stopped = stopMotor();
    // What was recorded is worth keeping even if the stop was not confirmed.
    const auto recorded = m_recording ? m_recording->finish() : Outcome<int>(kDone);
    const auto written = write();
    if (!stopped)
        return stopped;
    if (!written)
        return written;
    if (!recorded)
        return recorded;
    // Ctrl-C was not looked for while the file was written, and a motor may have been left running.
    const auto undisturbed = m_desk.talk.waitUntil([] { return false; }, 1ms);
    if (!undisturbed && undisturbed.error().status > kInterrupted)
        return tl::make_unexpected(abandon(undisturbed.error()));
    return verdict();
}

/// Boards that record nothing are read over and over, as often as the line gives.
Outcome<drive::Stream> CaptureRun::pollInstead(
    std::vector<catalog::RegisterId> registers, const std::vector<catalog::RegisterId> &more)
{
    registers.insert(registers.end(), more.begin(), more.end());
    for (const catalog::RegisterId id : registers) {
        const auto *info = m_desk.catalog().find(id);
        const bool number = info->type != catalog::ValueType::Raw
            && info->type != catalog::ValueType::Text && info->readable();
        if (!number)
            return failure(kUsage,
                QStringLiteral("%1 is no number that could be read over and over.")
                    .arg(QString::fromStdString(m_desk.catalog().nameOf(id))));
    }
    const auto readings = m_desk.talk.read(registers);
    if (!readings)
        return tl::make_unexpected(readings.error());
    for (const drive::Reading &reading : *readings)
        if (reading.status != drive::ReadStatus::Ok)
            return failure(kRefused,
                QStringLiteral("The board does not give %1; leave it out, or see rotorscope-cli "
                               "registers for what it gives.")
                    .arg(QString::fromStdString(m_desk.catalog().nameOf(reading.id))));
    m_polled = registers;
    m_recorder.poll(std::move(registers), m_desk.board.catalog);
    return drive::Stream{};
}

Outcome<drive::Stream> CaptureRun::stream()
{
    const catalog::Catalog &catalog = m_desk.catalog();
    const auto fast = resolveNames(catalog, m_wanted.fast);
    if (!fast)
        return tl::make_unexpected(fast.error());
    const auto slow = resolveNames(catalog, m_wanted.slow);
    if (!slow)
        return tl::make_unexpected(slow.error());
    if (!boardStreams() && m_desk.board.streaming.linkBytesPerSecond > 0.0)
        return pollInstead(*fast, *slow);
    for (const auto *list : {&*fast, &*slow}) {
        for (const catalog::RegisterId id : *list) {
            if (catalog.find(id)->streaming == catalog::Streaming::Polled)
                return failure(kUsage,
                    QStringLiteral("%1 cannot be recorded by the board; rotorscope-cli registers "
                                   "marks what streams.")
                        .arg(QString::fromStdString(catalog.nameOf(id))));
        }
    }
    const drive::StreamLimits &limits = m_desk.board.streaming;
    if (limits.tickHz <= 0 || limits.maxSignals == 0)
        return failure(kRefused, QStringLiteral("This board records no signals."));
    if (fast->size() + slow->size() > limits.maxSignals)
        return failure(kUsage,
            QStringLiteral("The board records at most %1 signals at a time; leave some out.")
                .arg(limits.maxSignals));
    const double rows = m_wanted.seconds * limits.tickHz / (m_wanted.fastRate + 1);
    if (!m_wanted.file.isEmpty()
        && rows * 2.0 * static_cast<double>(std::max<std::size_t>(1, fast->size())) > kMostBytes)
        return failure(kUsage,
            QStringLiteral("That is too much for one capture; take fewer seconds, fewer signals or "
                           "a larger --hf-rate."));
    return drive::Stream{.fast = *fast,
        .fastEvery = static_cast<unsigned>(m_wanted.fastRate + 1),
        .slow = *slow,
        .slowEvery = static_cast<unsigned>(m_wanted.slowRate + 1)};
}

/// No motor turns for a recording that the board then refuses: it is asked for the recording beforehand.
Outcome<int> CaptureRun::rehearse(const drive::Stream &stream)
{
    if ((!m_wanted.start && !m_wanted.ramp) || m_wanted.fromStart || !m_polled.empty())
        return kDone;
    auto agreed = m_desk.talk.command(stream, QStringLiteral("The recording"), recordingAdvice());
    return agreed ? m_desk.talk.ask(drive::Stream{}).map(kAllDone) : agreed;
}

Outcome<int> CaptureRun::prepare()
{
    if (m_wanted.start)
        if (const auto started = startMotor(); !started)
            return started;
    return m_wanted.ramp ? ramp() : kDone;
}

Outcome<int> CaptureRun::startMotor()
{
    const int motor = m_desk.arguments.motor;
    Conversation &talk = m_desk.talk;
    const auto before = talk.status(motor);
    if (!before)
        return tl::make_unexpected(before.error());
    if (before->state != MotorState::Idle)
        return failure(kRefused,
            drive::hasFault(before->state)
                ? QStringLiteral(
                    "The motor has a fault: %1; acknowledge it with rotorscope-cli ack.")
                      .arg(stateText(*before))
                : QStringLiteral("The motor is not idle (%1); stop it, or leave out --start.")
                      .arg(stateText(*before)));
    if (auto armed = talk.armToMove(); !armed)
        return armed;
    m_started = true; // from here on it may turn, whatever the answer says
    const drive::Command start{drive::MotorAction::Start, motor};
    if (auto ended = talk.command(start, QStringLiteral("The start")); !ended)
        return ended;
    qCInfo(lcProgress) << "started";
    const auto settled = [](MotorState state) {
        return state == MotorState::Running || drive::hasFault(state);
    };
    const auto until = std::chrono::steady_clock::now() + kRunWithin;
    auto status = talk.nextStatus(motor);
    while (status && !settled(status->state) && std::chrono::steady_clock::now() < until)
        status = talk.nextStatus(motor);
    if (!status)
        return tl::make_unexpected(status.error());
    if (status->state != MotorState::Running)
        return failure(kRefused,
            QStringLiteral("The motor does not run: %1; look for the cause of its fault.")
                .arg(stateText(*status)));
    return kDone;
}

Outcome<int> CaptureRun::ramp()
{
    const int motor = m_desk.arguments.motor;
    Conversation &talk = m_desk.talk;
    const RampArguments &ramp = *m_wanted.ramp;
    if (auto armed = talk.armToMove(); !armed)
        return armed;
    const std::chrono::milliseconds duration(ramp.milliseconds);
    const drive::SpeedRamp wish{.motor = motor, .rpm = ramp.rpm, .duration = duration};
    if (auto ended = talk.command(wish, QStringLiteral("The ramp")); !ended)
        return ended;
    const auto over = talk.waitUntil([] { return false; }, duration);
    if (!over)
        return tl::make_unexpected(over.error());
    const double tolerance = std::max(10.0, std::abs(ramp.rpm) * 0.02);
    const auto until = std::chrono::steady_clock::now() + kSettleWithin;
    while (std::chrono::steady_clock::now() < until) {
        const auto status = talk.nextStatus(motor);
        if (!status)
            return tl::make_unexpected(status.error());
        if (drive::hasFault(status->state))
            return failure(kRefused,
                QStringLiteral("The motor stopped by itself: %1; look for the cause of its fault.")
                    .arg(stateText(*status)));
        if (!status->speedRpm || std::abs(*status->speedRpm - ramp.rpm) <= tolerance)
            break;
    }
    return kDone;
}

Outcome<int> CaptureRun::record(const drive::Stream &stream)
{
    auto done = m_wanted.fromStart ? begin(stream) : prepare();
    if (done)
        done = m_wanted.fromStart ? prepare() : begin(stream);
    return done ? finish() : done;
}

/// Before anything moves: a recording that cannot be made moves nothing.
Outcome<int> CaptureRun::startRecording()
{
    if (m_wanted.recording.isEmpty())
        return kDone;
    m_recording.emplace(m_desk.talk, m_wanted.recording, m_wanted.recordLink);
    if (const auto started = m_recording->start(m_desk.arguments.port); !started)
        return started;
    const auto board = readBoard(m_desk, snapshots::Scope::All);
    if (!board)
        return tl::make_unexpected(salvage(abandon(board.error())));
    m_recording->add(board->at, board->snapshot);
    return kDone;
}

Outcome<int> CaptureRun::begin(const drive::Stream &stream)
{
    Conversation &talk = m_desk.talk;
    m_lineBefore = m_line = talk.lineCounters();
    talk.listen([this](const drive::Event &event) {
        m_recorder.accept(event);
        if (const auto *counters = std::get_if<drive::LinkCounters>(&event))
            m_line = *counters;
        const auto *status = std::get_if<drive::MotorStatus>(&event);
        if (m_started && status && drive::hasFault(status->state))
            m_fault = *status;
    });
    const auto ended = m_polled.empty()
        ? talk.command(stream, QStringLiteral("The recording"), recordingAdvice())
        : talk.command(drive::Watch{.registers = m_polled, .drawn = m_polled},
            QStringLiteral("The recording"), recordingAdvice());
    if (!ended)
        return ended;
    const auto begun = talk.waitUntil([this] { return !m_recorder.empty(); }, kFirstSampleWithin);
    if (!begun)
        return tl::make_unexpected(begun.error());
    if (*begun == Waited::TimeOver)
        return failure(kDataLost, QStringLiteral("No samples arrived; %1.").arg(lossAdvice()));
    qCInfo(lcProgress) << "recording";
    return kDone;
}

Outcome<int> CaptureRun::finish()
{
    Conversation &talk = m_desk.talk;
    const auto limit =
        std::chrono::milliseconds(static_cast<std::int64_t>(m_wanted.seconds * 1500.0))
        + kFirstSampleWithin;
    const auto complete = talk.waitUntil([this] { return m_recorder.complete(); }, limit);
    talk.listen({});
    if (!complete)
        return tl::make_unexpected(complete.error());
    return (m_polled.empty() ? talk.ask(drive::Stream{}) : talk.ask(drive::Watch{})).map(kAllDone);
}

Outcome<int> CaptureRun::stopMotor()
{
    if (!m_started || m_wanted.keepRunning)
        return kDone;
    return m_desk.talk.stop(kStandstillWithin).map(kAllDone);
}

/// The run ends early: a motor that it started does not go on.
Failure CaptureRun::abandon(Failure why)
{
    if (!m_started)
        return why;
    if (!m_desk.talk.stop(0ms))
        why.sentence.append(QLatin1Char(' ')).append(kStopNotConfirmed);
    else
        why.sentence += QStringLiteral(" The motor was stopped.");
    return why;
}

/// The run ended early, but what was recorded until then may be what was waited for. An older file stays.
Failure CaptureRun::salvage(Failure why)
{
    if (m_recording && m_recording->finish())
        why.sentence +=
            QStringLiteral(" What was recorded until then is in %1.").arg(m_wanted.recording);
    if (!m_wanted.file.isEmpty() && !m_recorder.empty() && !QFileInfo::exists(m_wanted.file)
        && write())
        why.sentence +=
            QStringLiteral(" What was recorded until then is in %1.").arg(m_wanted.file);
    return why;
}

/// What this run asked of the motors, beside what it recorded.
Outcome<int> CaptureRun::writeMotionLog() const
{
    const auto &log = m_desk.talk.motionLog();
    if (log.empty())
        return kDone;
    const QString file = m_wanted.file.isEmpty() ? m_wanted.recording : m_wanted.file;
    const QString beside = session::motionLogPath(file);
    const QByteArray text =
        session::motionLogText(log, session::motionLogWho(QCoreApplication::applicationName()));
    const QString wrong = session::writeWholeFile(beside, text);
    if (wrong.isEmpty())
        return kDone;
    return failure(kFileError,
        QStringLiteral(
            "%1 was written, but not its motion log %2: %3; choose another place with -o.")
            .arg(file, beside, wrong));
}

/// How much was recorded, and of how much where that is not all.
QString CaptureRun::lengthText() const
{
    const QString wanted = numberText(m_wanted.seconds);
    return m_recorder.complete()
        ? QStringLiteral("%1 s").arg(wanted)
        : QStringLiteral("%1 of %2 s")
              .arg(QString::number(m_recorder.recordedSeconds(), 'g', 4), wanted);
}

/// What lost samples: a line that spoils bytes, or one that is too slow for them.
QString CaptureRun::lossAdvice() const
{
    const auto bad = [](const drive::LinkCounters &counters) {
        return counters.badPackets + counters.nacks;
    };
    return bad(m_line) > bad(m_lineBefore)
        ? QStringLiteral("bytes were damaged on the line; check cable, ground and shield, or take "
                         "a smaller --baud")
        : QStringLiteral("record fewer signals, take a larger --hf-rate or a higher --baud");
}

Outcome<int> CaptureRun::write()
{
    std::uint64_t rows = 0;
    if (!m_wanted.file.isEmpty()) {
        const auto written = session::exportFormats().front().write(
            m_wanted.file, {m_recorder.capture().snapshot(m_recorder.channels()), {}}, {});
        if (written.file.error != session::FileError::None)
            return failure(kFileError, sentenceOf(written.file, m_wanted.file));
        rows = written.rows;
    }
    if (const auto logged = writeMotionLog(); !logged)
        return logged;
    if (m_desk.out.json()) {
        QJsonObject line{{QStringLiteral("seconds"), m_recorder.recordedSeconds()},
            {QStringLiteral("wanted_seconds"), m_wanted.seconds},
            {QStringLiteral("lost_ticks"), static_cast<qint64>(m_recorder.lostTicks())},
            {QStringLiteral("complete"), m_recorder.complete()}};
        if (!m_wanted.file.isEmpty()) {
            line.insert(QStringLiteral("file"), m_wanted.file);
            line.insert(QStringLiteral("rows"), static_cast<qint64>(rows));
        }
        if (m_recorder.polls()) {
            line.insert(QStringLiteral("values_per_second"), m_recorder.valuesPerSecond());
            line.insert(QStringLiteral("possible_values_per_second"), possibleRate());
            line.insert(QStringLiteral("time_uncertainty_s"), m_recorder.spreadSeconds());
        }
        if (m_recording) {
            const auto &counts = m_recording->last().counts;
            line.insert(QStringLiteral("recording"), m_wanted.recording);
            line.insert(QStringLiteral("recording_bytes"), static_cast<qint64>(counts.bytes));
            line.insert(QStringLiteral("recording_samples"), static_cast<qint64>(counts.samples));
        }
        m_desk.out.line(line);
        return kDone;
    }
    if (!m_wanted.file.isEmpty() && m_recorder.polls())
        m_desk.out.line(QStringLiteral("%1: %2 rows, %3, each signal read %4 times a second (%5 at "
                                       "best), times uncertain by up to %6 ms")
                            .arg(m_wanted.file, QString::number(rows), lengthText(),
                                numberText(std::round(m_recorder.valuesPerSecond())),
                                numberText(std::round(possibleRate())),
                                QString::number(m_recorder.spreadSeconds() * 1e3, 'f', 1)));
    else if (!m_wanted.file.isEmpty())
        m_desk.out.line(
            QStringLiteral("%1: %2 rows, %3, %4 lost")
                .arg(m_wanted.file, QString::number(rows), lengthText(), m_recorder.lostText()));
    if (m_recording) {
        const auto &counts = m_recording->last().counts;
        const QString held = m_recorder.polls()
            ? QStringLiteral("each signal read %1 times a second")
                  .arg(numberText(std::round(m_recorder.valuesPerSecond())))
            : QStringLiteral("%1 samples").arg(QString::number(counts.samples));
        m_desk.out.line(QStringLiteral("%1: %2, %3 bytes")
                            .arg(m_wanted.recording, held, QString::number(counts.bytes)));
    }
    return kDone;
}

Outcome<int> CaptureRun::verdict() const
{
    if (m_fault)
        return failure(kRefused,
            QStringLiteral(
                "The motor stopped by itself while recording: %1; look for the cause of its fault.")
                .arg(stateText(*m_fault)));
    if (!m_recorder.complete())
        return failure(kDataLost,
            QStringLiteral("The samples stopped coming before the time was over; check the link."));
    if (m_recorder.lostTicks() > 0)
        return failure(kDataLost,
            QStringLiteral("%1 were lost, and the file has gaps; %2.")
                .arg(m_recorder.lostText(), lossAdvice()));
    return kDone;
}

Outcome<int> runCapture(Desk &desk) { return CaptureRun(desk).run(); }

constexpr OptionText kCaptureOptions[] = {
    kCyclicOption,
    {"hf", "A,B", "Signals at the rate of the control loop."},
    {"hf-rate", "N", "One sample every N + 1 control periods, 0 if not given."},
    {"mf", "C,D", "Signals recorded less often."},
    {"mf-rate", "N",
        "One --mf group every N + 1 samples, 15 if not given; 254: one in each packet."},
    {"seconds", "S", "How long to record."},
    {"o,output", "FILE.csv", "The file to write."},
    {"record", "FILE.pcapng", "Records samples, values and events into this file while they come."},
    {"link", "", "With --record: the bytes of the line, too; twice the size."},
    {"start", "", "Starts the motor first, waits until it runs, and stops it at the end."},
    {"ramp", "RPM,MS", "Ramps to RPM within MS milliseconds before recording."},
    {"from-start", "", "Begins to record before --start and --ramp; --seconds count from then."},
    {"keep-running", "", "Leaves the motor running at the end."},
};

Outcome<bool> readCapture(const Given &given, Arguments &arguments)
{
    CaptureArguments &capture = arguments.capture;
    capture.fast = given.list("hf");
    capture.slow = given.list("mf");
    if (capture.fast.isEmpty() && capture.slow.isEmpty())
        return usage(QStringLiteral("Name the signals to record, for example --hf I_A,I_B."));
    const auto rates = readNumbers(
        given, {{"hf-rate", &capture.fastRate, 0, 255}, {"mf-rate", &capture.slowRate, 0, 254}});
    if (!rates)
        return rates;
    bool ok = false;
    capture.seconds = given.value("seconds").toDouble(&ok);
    if (!ok || !std::isfinite(capture.seconds) || capture.seconds <= 0 || capture.seconds > 86400)
        return usage(QStringLiteral(
            "Say how long to record with --seconds S, more than 0 and at most 86400."));
    capture.file = given.value("output");
    capture.recording = given.value("record");
    capture.recordLink = given.has("link");
    if (capture.file.isEmpty() && capture.recording.isEmpty())
        return usage(QStringLiteral(
            "Name the file to write with -o FILE.csv, or --record FILE.pcapng, or both."));
    if (capture.file.endsWith(QLatin1String(".pcapng"), Qt::CaseInsensitive))
        return usage(
            QStringLiteral("-o writes CSV; a recording is --record %1.").arg(capture.file));
    const auto *format = session::exportFormatOf(capture.file);
    if (format != nullptr && format != &session::exportFormats().front())
        return usage(QStringLiteral("-o writes CSV; for %1 record with --record FILE.pcapng, and "
                                    "export that.")
                         .arg(capture.file));
    if (given.has("record"))
        if (const auto named = checkRecordingName(capture.recording); !named)
            return named;
    if (capture.recordLink && capture.recording.isEmpty())
        return usage(QStringLiteral("--link belongs to --record FILE.pcapng."));
    capture.start = given.has("start");
    capture.fromStart = given.has("from-start");
    capture.keepRunning = given.has("keep-running");
    if (given.has("ramp")) {
        const QStringList parts = given.value("ramp").split(QLatin1Char(','));
        if (parts.size() != 2)
            return usage(
                QStringLiteral("Write the ramp as --ramp RPM,MS, for example --ramp 1500,500."));
        const auto ramp = rampOf(parts[0], parts[1]);
        if (!ramp)
            return tl::make_unexpected(ramp.error());
        capture.ramp = *ramp;
    }
    return true;
}

} // namespace

const Command kCapture{.name = "capture",
    .words = "--hf A,B --seconds S -o FILE.csv",
    .help = "Records signals into a CSV file, which appears whole or not at all.",
    .options = kCaptureOptions,
    .read = readCapture,
    .canMove = true,
    .ofOneMotor = true,
    .run = runCapture};

} // namespace cli
