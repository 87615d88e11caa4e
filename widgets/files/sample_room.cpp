#include "widgets/files/sample_room.h"

#include "widgets/base/device_text.h"
#include "widgets/base/value_text.h"

namespace widgets {

namespace {

constexpr double kGiga = 1e9;
constexpr Milliseconds kPeriod{1000};

/// Bytes that a sample takes where it stays.
constexpr double kFastBytes =
    double(capture::FastColumn::kArchivedBytes) / double(capture::FastColumn::kChunkSamples);
constexpr double kSlowBytes = double(capture::ValueColumn::kMostSampleBytes);

/// Five signals at 16 kHz: the answer when nothing is recorded.
constexpr double kUsualRate = 5 * 16000 * kFastBytes;

QString gigaText(double bytes)
{
    const double giga = bytes / kGiga;
    return numberText(giga, giga < 1.0 ? 2 : giga < 10.0 ? 1 : 0);
}

} // namespace

SampleRoom::SampleRoom(capture::Capture &capture, session::DiskArchive &archive, QObject *parent)
    : QObject(parent)
    , m_capture(capture)
    , m_archive(archive)
    , m_usual(session::usualArchiveBudget(archive.folder()))
{
    connect(&archive, &session::DiskArchive::failed, this, &SampleRoom::tellFailure);
    setWanted(m_wanted);
}

void SampleRoom::setWanted(double gigabytes)
{
    m_wanted = gigabytes;
    m_archive.setBudget(gigabytes < 0.0 ? m_usual : static_cast<std::uint64_t>(gigabytes * kGiga));
    m_capture.tryArchiveAgain();
}

double SampleRoom::usual() const { return static_cast<double>(m_usual) / kGiga; }

double SampleRoom::taken() const
{
    double bytes = 0.0;
    for (const capture::ChannelInfo &info : m_capture.channels()) {
        const capture::Channel *channel = m_capture.channel(info.id);
        bytes += static_cast<double>(channel->end()) * (channel->fast() ? kFastBytes : kSlowBytes);
    }
    return bytes;
}

void SampleRoom::refresh(Milliseconds now)
{
    if (now - m_then < kPeriod)
        return;
    const double bytes = taken();
    const double seconds = static_cast<double>((now - m_then).count()) / 1000.0;
    m_rate = std::max(0.0, (bytes - m_takenThen) / seconds);
    m_then = now;
    m_takenThen = bytes;
    Q_EMIT refreshed(heldText());
}

QString SampleRoom::heldText() const
{
    return tr("Samples: %1 GB in memory, %2 GB on disk")
        .arg(gigaText(static_cast<double>(m_capture.bytes())),
            gigaText(static_cast<double>(m_capture.archivedBytes())));
}

QString SampleRoom::meaningText(double gigabytes) const
{
    const bool memoryOnly = gigabytes <= 0.0;
    const double room = memoryOnly ? static_cast<double>(m_capture.maxBytes()) : gigabytes * kGiga;
    const double rate = m_rate > 0.0 ? m_rate : kUsualRate;
    const double hours = room / rate / 3600.0;
    const QString time = hours < 1.0 ? tr("%1 minutes").arg(numberText(hours * 60.0, 0))
                                     : tr("%1 hours").arg(numberText(hours, hours < 10.0 ? 1 : 0));
    const QString pace = m_rate > 0.0
        ? tr("at the present %1 kB/s").arg(numberText(rate / 1000.0, 0))
        : tr("of five signals at 16 kHz (%1 kB/s)").arg(numberText(rate / 1000.0, 0));
    return memoryOnly ? tr("Memory only, %1 GB: about %2 %3.", "size, time, at a rate")
                            .arg(gigaText(room), time, pace)
                      : tr("%1 GB on disk: about %2 %3.", "size, time, at a rate")
                            .arg(gigaText(room), time, pace);
}

QString SampleRoom::lessText(double gigabytes) const
{
    const double less = static_cast<double>(m_capture.archivedBytes()) - gigabytes * kGiga;
    if (less <= 0.0)
        return {};
    return tr("The oldest %1 GB of samples are let go as soon as new ones come.")
        .arg(gigaText(less));
}

QString SampleRoom::fullText() const
{
    const QString memory = gigaText(static_cast<double>(m_capture.maxBytes()));
    const auto disk = static_cast<double>(m_capture.archiveRoom());
    if (disk <= 0.0)
        return tr("The samples fill their memory (%1 GB): from now on the oldest ones are let go. "
                  "Record to disk (Ctrl+R) to keep what comes.")
            .arg(memory);
    return tr("The samples fill their room (%1 GB of memory, %2 GB on disk): from now on the "
              "oldest ones are let go. Record to disk (Ctrl+R) to keep what comes, or give them "
              "more room (Scope, Room for samples).")
        .arg(memory, gigaText(disk));
}

void SampleRoom::tellFailure(const session::ArchiveFailure &failure)
{
    using Reason = session::ArchiveFailure::Reason;
    const QString folder = deviceText(failure.folder);
    QString what;
    switch (failure.reason) {
    case Reason::NoFolder:
        what = tr("The folder for samples, %1, cannot be made.").arg(folder);
        break;
    case Reason::LittleRoom:
        what = tr("Less than 1 GB is free on the disk of %1, so no more samples go there.")
                   .arg(folder);
        break;
    case Reason::ReadFailed:
        what =
            tr("The disk of %1 cannot be read any more: the samples on it are let go.").arg(folder);
        break;
    case Reason::WriteFailed:
        what = tr("The disk of %1 takes no more samples (%2).")
                   .arg(folder, deviceText(failure.systemText));
        break;
    }
    Q_EMIT said(Banner::Kind::Warning,
        what + QLatin1Char(' ')
            + tr("The connection and the scope go on; when the room that is left is full, the "
                 "oldest samples are let go."));
}

} // namespace widgets
