#include "session/recording_reader.h"

#include "record/restore.h"

#include <QFile>

#include <map>
#include <utility>

namespace session {

namespace {

constexpr qint64 kPiece = 1 << 20;

/// What is kept of the entries besides samples.
void note(
    RecordingReport &report, std::map<record::Nanos, record::Note> &notes, const record::Item &item)
{
    const auto room = [](const auto &list) { return list.size() < RecordingReport::kMostKept; };
    if (const auto *begin = std::get_if<record::Begin>(&item.entry)) {
        report.begin = *begin;
    } else if (const auto *block = std::get_if<capture::SampleBlock>(&item.entry)) {
        report.samples += record::samplesOf(*block);
    } else if (const auto *link = std::get_if<record::LinkBytes>(&item.entry)) {
        report.linkBytes += link->bytes.size();
    } else if (const auto *happening = std::get_if<record::Happening>(&item.entry)) {
        if (room(report.happenings))
            report.happenings.push_back({item.at, *happening});
    } else if (const auto *snapshot = std::get_if<record::RegisterSnapshot>(&item.entry)) {
        if (room(report.snapshots))
            report.snapshots.push_back({item.at, *snapshot});
    } else if (const auto *words = std::get_if<record::Note>(&item.entry)) {
        if (record::isTakenBack(*words))
            notes.erase(words->from);
        else if (room(notes) || notes.contains(words->from))
            notes[words->from] = *words;
    } else if (const auto *lost = std::get_if<record::Lost>(&item.entry)) {
        report.lost.samples += lost->samples;
        report.lost.linkBytes += lost->linkBytes;
        report.lost.others += lost->others;
    }
}

} // namespace

Result<RecordingReport, QString> readRecording(const QString &path,
    const std::function<void(record::Item &&)> &take, const std::function<bool(double)> &proceed)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return fail(file.errorString());
    record::Decoder decoder;
    RecordingReport report;
    std::map<record::Nanos, record::Note> notes; // the last one said of each time
    const auto drain = [&] {
        while (auto step = decoder.next()) {
            if (auto *item = std::get_if<record::Item>(&*step)) {
                note(report, notes, *item);
                take(std::move(*item));
                continue;
            }
            ++report.damagedPlaces;
            if (report.damage.size() < RecordingReport::kMostDamage)
                report.damage.push_back(std::get<record::Damage>(*step));
        }
    };
    const double size = static_cast<double>(std::max<qint64>(1, file.size()));
    while (true) {
        const QByteArray piece = file.read(kPiece);
        if (file.error() != QFileDevice::NoError)
            return fail(file.errorString());
        if (piece.isEmpty())
            break;
        decoder.feed({reinterpret_cast<const std::uint8_t *>(piece.constData()),
            static_cast<std::size_t>(piece.size())});
        drain();
        if (proceed && !proceed(static_cast<double>(file.pos()) / size))
            return fail(QStringLiteral("cancelled"));
    }
    decoder.finish();
    drain();
    if (!decoder.isRecording())
        return fail(
            QStringLiteral("it is no recording of Rotorscope: no sound block in its %1 bytes")
                .arg(file.size()));
    for (auto &[from, words] : notes)
        report.notes.push_back(std::move(words));
    report.blocks = decoder.blocks();
    report.bytes = file.pos();
    report.ending = decoder.ending();
    return report;
}

Result<RecordingReport, QString> readRecording(
    const QString &path, capture::Capture &capture, const std::function<bool(double)> &proceed)
{
    record::Restorer restorer(capture);
    return readRecording(
        path, [&restorer](record::Item &&item) { restorer.take(item.entry); }, proceed);
}

QString damageText(const record::Damage &damage)
{
    using Kind = record::Damage::Kind;
    const auto number = [](std::uint64_t value) { return QString::number(value); };
    const QString last = number(damage.offset + std::max<std::uint64_t>(1, damage.bytes) - 1);
    switch (damage.kind) {
    case Kind::Missing:
        return QStringLiteral("at byte %1 %2 blocks are missing")
            .arg(number(damage.offset), number(damage.blocks));
    case Kind::CutShort:
        return QStringLiteral("it ends within a block, at byte %1").arg(damage.offset);
    case Kind::Undescribed:
        return QStringLiteral("bytes %1 to %2 are samples whose description is missing")
            .arg(number(damage.offset), last);
    case Kind::Unreadable:
        break;
    }
    const QString place =
        QStringLiteral("bytes %1 to %2 are unreadable").arg(number(damage.offset), last);
    return damage.blocks == 0
        ? place
        : QStringLiteral("%1, %2 blocks are missing").arg(place, number(damage.blocks));
}

} // namespace session
