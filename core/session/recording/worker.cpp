#include "session/recording/worker.h"

#include <QFile>

#include <algorithm>
#include <utility>

namespace session {

namespace {

constexpr int kTick_ms = 250; ///< what was gathered is not older when it is written
constexpr qint64 kSync_ms = 1000;
constexpr qint64 kRate_ms = 900;

RecordingOutcome outcomeOf(recorded::End::Reason reason)
{
    switch (reason) {
    case recorded::End::Reason::Stopped:
        return RecordingOutcome::Stopped;
    case recorded::End::Reason::DiskFull:
        return RecordingOutcome::DiskFull;
    case recorded::End::Reason::WriteFailed:
        break;
    }
    return RecordingOutcome::WriteFailed;
}

} // namespace

void Inbox::put(ToldPtr told)
{
    auto sheet = std::make_unique<Sheet>(Sheet{std::move(told), m_top.load()});
    while (!m_top.compare_exchange_weak(sheet->below, sheet.get()))
        ;
    (void)sheet.release(); // take() has it from here on
}

std::vector<ToldPtr> Inbox::take()
{
    std::vector<ToldPtr> all;
    for (std::unique_ptr<Sheet> sheet(m_top.exchange(nullptr)); sheet; sheet.reset(sheet->below))
        all.push_back(std::move(sheet->told));
    std::ranges::reverse(all);
    return all;
}

RecordingWorker::RecordingWorker(
    std::shared_ptr<RecordingTap> tap, RecordingLimits limits, MakeSink makeSink)
    : m_tap(std::move(tap))
    , m_limits(limits)
    , m_makeSink(std::move(makeSink))
    , m_timer(this)
{
    qRegisterMetaType<ToldPtr>("session::ToldPtr");
    connect(
        m_tap.get(), &RecordingTap::told, this,
        [inbox = m_inbox](const ToldPtr &told) { inbox->put(told); }, Qt::DirectConnection);
    connect(m_tap.get(), &RecordingTap::dueNow, this, &RecordingWorker::processAll,
        Qt::QueuedConnection);
    connect(&m_timer, &QTimer::timeout, this, &RecordingWorker::tick);
}

void RecordingWorker::start(
    const QString &path, RecordingTap::Content content, const recorded::Begin &begin)
{
    m_path = path;
    m_lost = {};
    m_coverage = {};
    m_rate = 0.0;
    m_bytesThen = 0;
    QString systemText;
    auto sink = m_makeSink(path, systemText);
    if (!sink) {
        Q_EMIT finished({RecordingOutcome::CannotOpen, path, systemText, {}, {}});
        return;
    }
    m_free = sink->freeBytes();
    m_file = std::make_unique<RecordingFile>(std::move(sink), begin);
    if (!m_file->open()) {
        finish();
        return;
    }
    m_sinceSync.start();
    m_sinceRate.start();
    m_timer.start(kTick_ms);
    m_tap->switchOn(++m_number, content);
    Q_EMIT started(path);
}

void RecordingWorker::processAll()
{
    // Each is let go as soon as it counts as written.
    std::vector<ToldPtr> all = m_inbox->take();
    for (ToldPtr &told : all)
        accept(std::exchange(told, {}));
}

void RecordingWorker::accept(const ToldPtr &told)
{
    m_tap->release(told->bytes);
    if (!m_file || told->recording != m_number)
        return; // of a recording that is over
    for (const recorded::Entry &entry : told->entries) {
        if (const auto *lost = std::get_if<recorded::Lost>(&entry)) {
            m_lost.samples += lost->samples;
            m_lost.linkBytes += lost->linkBytes;
            m_lost.others += lost->others;
        }
        if (!m_file->add(told->at, entry))
            return finish();
        m_coverage.accept(entry);
    }
    if (!m_file->flush(told->at))
        finish();
}

void RecordingWorker::add(recorded::Nanos at, const recorded::Entry &entry)
{
    processAll();
    if (m_file && !m_file->add(at, entry))
        finish();
}

void RecordingWorker::tick()
{
    processAll();
    if (!m_file)
        return;
    bool goesOn = m_file->flushAll();
    if (goesOn && m_sinceSync.elapsed() >= kSync_ms) {
        goesOn = m_file->sync();
        m_sinceSync.start();
        m_free = m_file->freeBytes();
        if (goesOn && m_free >= 0 && m_free < m_limits.endBytes) {
            m_file->endForWantOfRoom();
            goesOn = false;
        }
    }
    if (!goesOn)
        return finish();
    Q_EMIT progressed(progress());
}

void RecordingWorker::stop()
{
    processAll();
    if (!m_file)
        return;
    (void)m_file->end();
    finish();
}

/// The file is closed, and waiting callers are told why.
void RecordingWorker::finish()
{
    m_tap->switchOff();
    m_timer.stop();
    RecordingResult result;
    result.path = m_path;
    result.last = progress();
    if (const auto &failure = m_file->failure()) {
        result.outcome = outcomeOf(failure->reason);
        result.systemText = QString::fromStdString(failure->text);
    }
    result.coverage = std::move(m_coverage);
    result.complete = result.outcome == RecordingOutcome::Stopped && m_lost == recorded::Lost{}
        && m_file->leftOut() == 0;
    m_file.reset();
    if (result.last.counts.bytes == 0)
        QFile::remove(m_path); // without its head it is none, and only in the way of the next one
    processAll(); // what was told meanwhile is in no file and holds no memory
    Q_EMIT finished(result);
}

RecordingProgress RecordingWorker::progress()
{
    RecordingProgress progress;
    progress.counts = m_file->counts();
    if (m_sinceRate.isValid() && m_sinceRate.elapsed() >= kRate_ms) {
        m_rate = static_cast<double>(progress.counts.bytes - m_bytesThen) * 1000.0
            / static_cast<double>(m_sinceRate.restart());
        m_bytesThen = progress.counts.bytes;
    }
    progress.bytesPerSecond = m_rate;
    progress.freeBytes = m_free;
    if (progress.freeBytes >= 0)
        progress.roomBytes = std::max<qint64>(0, progress.freeBytes - m_limits.endBytes);
    progress.lowSpace = progress.freeBytes >= 0 && progress.freeBytes < m_limits.warnBytes;
    progress.lost = m_lost;
    return progress;
}

} // namespace session
