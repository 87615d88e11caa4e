#include "session/recording/notes.h"

#include "recorded/decoder.h"
#include "recorded/entry_codec.h"
#include "session/files/whole_file.h"
#include "session/recording/file.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>

namespace session {

namespace {

constexpr qint64 kCopied = 1 << 20;

/// Longer than what a block that is cut may miss while both of its checksums still fit: that must not be taken from
/// the block behind it.
constexpr std::size_t kApart = 12;

/// What must be known of the blocks before, to write further ones.
struct Tail {
    recorded::Nanos newest = 0; ///< of all entries: what follows must not seem to come before
    bool cut = false; ///< within a block

    void follow(recorded::Decoder &decoder)
    {
        while (const auto step = decoder.next()) {
            if (const auto *item = std::get_if<recorded::Item>(&*step))
                newest = std::max(newest, item->at);
            else
                cut = std::get<recorded::Damage>(*step).kind == recorded::Damage::Kind::CutShort;
        }
    }
};

NotesResult failed(const QString &why) { return {NotesResult::Outcome::Failed, why, {}}; }

NotesResult beingWritten()
{
    return {NotesResult::Outcome::BeingWritten, QStringLiteral("it is still being written"), {}};
}

/// Whether a recorder that could make no lock may still have the file open; it writes several times a second while
/// anything comes.
/// @param file  as it was before it was read
bool changedLately(const QFileInfo &file, qint64 read, const NotesSource &known)
{
    if (known.bytes >= 0 && read > known.bytes)
        return true;
    const QDateTime time = file.lastModified();
    if (time == known.ownTime)
        return false;
    return !known.now.isValid() || time.msecsTo(known.now) < kQuietBefore_ms;
}

} // namespace

NotesResult saveNotes(const QString &source, const QString &target,
    const std::vector<recorded::Note> &notes, const std::function<bool(double)> &proceed,
    const NotesSource &known)
{
    const QFileInfo before(source);
    (void)before.lastModified(); // now: later it would be asked for later
    QFile from(source);
    if (!from.open(QIODevice::ReadOnly))
        return failed(from.errorString());
    const QFileInfo existing(target);
    if (existing.exists() && !existing.isFile()) // QSaveFile would take the place of a device
        return failed(QStringLiteral("it is no file"));
    QSaveFile to(target);
    if (!to.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        return failed(to.errorString());
    const auto lock = recordingLock(source); // meanwhile no recording begins in it, either
    if (existing == before && !lock->tryLock() && lock->error() == QLockFile::LockFailedError)
        return beingWritten();
    recorded::Decoder decoder;
    Tail tail;
    const double size = static_cast<double>(std::max<qint64>(1, from.size()));
    while (true) {
        const QByteArray piece = from.read(kCopied);
        if (from.error() != QFileDevice::NoError)
            return failed(from.errorString());
        if (piece.isEmpty())
            break;
        const ByteView bytes(reinterpret_cast<const std::uint8_t *>(piece.constData()),
            static_cast<std::size_t>(piece.size()));
        if (!writeAll(to, bytes))
            return failed(to.errorString());
        decoder.feed(bytes);
        tail.follow(decoder);
        if (proceed && !proceed(static_cast<double>(from.pos()) / size))
            return failed(QStringLiteral("cancelled"));
    }
    const qint64 read = from.pos();
    from.close(); // where an open file cannot be replaced
    decoder.finish();
    tail.follow(decoder);
    if (!decoder.isRecording())
        return failed(QStringLiteral("it is no recording of Rotorscope"));
    if (!decoder.ending() && existing == before && changedLately(before, read, known))
        return beingWritten();
    if (tail.cut && !writeAll(to, Bytes(kApart)))
        return failed(to.errorString());
    std::uint32_t number = decoder.nextNumber();
    for (const recorded::Note &note : notes) {
        auto payload = recorded::encodeEntry(note);
        if (!payload)
            return failed(QStringLiteral("a note is too long"));
        const Bytes block = recorded::packetBlock(
            {recorded::Interface::Entries, tail.newest, 0, number++, 0}, std::move(*payload));
        if (!writeAll(to, block))
            return failed(to.errorString());
    }
    if (!to.commit())
        return failed(to.errorString());
    const QFileInfo written(target);
    return {NotesResult::Outcome::Saved, {}, {written.size(), written.lastModified(), {}}};
}

} // namespace session
