#include "session/recording/reader.h"

#include "recorded/overview.h"
#include "recorded/restore.h"

#include <QFile>

#include <map>
#include <utility>

namespace session {

namespace {

constexpr qint64 kPiece = 1 << 20;

std::size_t memoryOf(const std::string &text) { return sizeof(std::string) + text.size(); }

std::size_t memoryOf(const recorded::Happening &happening)
{
    std::size_t bytes = sizeof happening + memoryOf(happening.name);
    for (const auto &[key, value] : happening.fields)
        bytes += memoryOf(key) + memoryOf(value);
    return bytes;
}

std::size_t memoryOf(const recorded::RegisterSnapshot &snapshot)
{
    return memoryOf(snapshot.title) + memoryOf(snapshot.json);
}

std::size_t memoryOf(const recorded::Note &note)
{
    constexpr std::size_t kNode = 64; // of the map
    return kNode + sizeof note + memoryOf(note.text);
}

/// What is kept of the entries besides samples, within a bound of memory.
class Keeper {
public:
    explicit Keeper(RecordingReport &report)
        : m_report(report)
    {
    }

    void accept(const recorded::Item &item)
    {
        if (const auto *begin = std::get_if<recorded::Begin>(&item.entry)) {
            m_report.begin = *begin;
        } else if (const auto *block = std::get_if<capture::SampleBlock>(&item.entry)) {
            m_report.samples += capture::samplesOf(*block);
        } else if (const auto *link = std::get_if<recorded::LinkBytes>(&item.entry)) {
            m_report.linkBytes += link->bytes.size();
        } else if (const auto *happening = std::get_if<recorded::Happening>(&item.entry)) {
            const bool near = item.at > -recorded::kFarthest && item.at < recorded::kFarthest;
            if (near && hasRoom(memoryOf(*happening)))
                m_report.happenings.push_back({item.at, *happening});
        } else if (const auto *snapshot = std::get_if<recorded::RegisterSnapshot>(&item.entry)) {
            if (hasRoom(memoryOf(*snapshot)))
                m_report.snapshots.push_back({item.at, *snapshot});
        } else if (const auto *words = std::get_if<recorded::Note>(&item.entry)) {
            accept(*words);
        } else if (const auto *lost = std::get_if<recorded::Lost>(&item.entry)) {
            m_report.lost.samples += lost->samples;
            m_report.lost.linkBytes += lost->linkBytes;
            m_report.lost.others += lost->others;
        }
    }
    void finish()
    {
        for (auto &[from, words] : m_notes)
            m_report.notes.push_back(std::move(words));
    }

private:
    /// The last one said of each time counts.
    void accept(const recorded::Note &words)
    {
        if (const auto before = m_notes.find(words.from); before != m_notes.end()) {
            m_kept -= memoryOf(before->second);
            m_notes.erase(before);
        }
        if (!recorded::isTakenBack(words) && hasRoom(memoryOf(words)))
            m_notes[words.from] = words;
    }
    bool hasRoom(std::size_t bytes)
    {
        if (bytes > RecordingReport::kMostKeptBytes - m_kept) {
            ++m_report.leftOut;
            return false;
        }
        m_kept += bytes;
        return true;
    }

    RecordingReport &m_report;
    std::map<recorded::Nanos, recorded::Note> m_notes;
    std::size_t m_kept = 0;
};

/// One block of what stands behind the samples, where the last one comes first.
/// @param found   takes the overview, if it is one
/// @param passed  bytes of kinds that are not known: a later version's, or another program's
/// @return  false: the search is over, also because of damage
bool takeTail(const Bytes &block, std::vector<recorded::Overview> &found, qint64 &passed)
{
    constexpr qint64 kMostPassed = qint64{16} << 20;
    const recorded::Claim claim = recorded::claimOf(block);
    if (claim.type == recorded::kPacketBlock) {
        const auto head = recorded::packetHead(block, recorded::kMostPayload);
        const auto data = head ? recorded::packetData(*head, block) : std::nullopt;
        if (!data || head->interface != recorded::Interface::Entries)
            return false;
        auto overview = recorded::decodeOverview(*data);
        if (overview) {
            found.push_back(std::move(*overview));
            return true;
        }
        const auto entry = recorded::decodeEntry(*data);
        if (entry)
            return found.empty()
                && (std::holds_alternative<recorded::End>(entry->entry)
                    || std::holds_alternative<recorded::Note>(entry->entry));
        const auto unknown = recorded::PayloadError::UnknownKind;
        if (overview.error() != unknown || entry.error() != unknown)
            return false; // an overview that makes no sense
    } else if (claim.type == recorded::kSectionBlock || claim.length != block.size()) {
        return false; // it has no checksum of ours: both of its lengths have to agree
    }
    passed += static_cast<qint64>(block.size());
    return passed <= kMostPassed;
}

} // namespace

Result<RecordingReport, QString> readRecording(const QString &path,
    const std::function<void(recorded::Item &&)> &take, const std::function<bool(double)> &proceed)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return fail(file.errorString());
    recorded::Decoder decoder;
    RecordingReport report;
    Keeper keeper(report);
    const auto drain = [&] {
        while (auto step = decoder.next()) {
            if (auto *item = std::get_if<recorded::Item>(&*step)) {
                keeper.accept(*item);
                take(std::move(*item));
                continue;
            }
            ++report.damagedPlaces;
            if (report.damage.size() < RecordingReport::kMostDamage)
                report.damage.push_back(std::get<recorded::Damage>(*step));
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
        return fail(QStringLiteral("it is no recording of Rotorscope: no valid block is in it"));
    keeper.finish();
    report.blocks = decoder.blocks();
    report.bytes = file.pos();
    report.ending = decoder.ending();
    return report;
}

Result<RecordingReport, QString> readRecording(
    const QString &path, capture::Capture &capture, const std::function<bool(double)> &proceed)
{
    recorded::Restorer restorer(capture);
    return readRecording(
        path, [&restorer](recorded::Item &&item) { restorer.accept(item.entry); }, proceed);
}

bool readOverview(const QString &path, capture::Capture &capture)
{
    constexpr int kMostBlocks = 4096; // notes may be behind it, and many times ago
    constexpr qint64 kTrailer = 4, kLeastBlock = recorded::kClaimBytes + kTrailer;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return false;
    const auto read = [&file](qint64 at, qint64 size) {
        file.seek(at);
        const QByteArray bytes = file.read(size);
        return Bytes(bytes.begin(), bytes.end());
    };
    // From the last block to the one before it, by the length that stands at its end.
    std::vector<recorded::Overview> found;
    qint64 end = file.size(), passed = 0;
    for (int i = 0; i < kMostBlocks && end > kTrailer; ++i) {
        const Bytes trailer = read(end - kTrailer, kTrailer);
        const qint64 length = ByteReader(trailer).u32();
        if (length < kLeastBlock || length > end
            || length > qint64{recorded::blockSize(recorded::kMostPayload)})
            break;
        if (!takeTail(read(end - length, length), found, passed))
            break;
        end -= length;
    }
    for (auto overview = found.rbegin(); overview != found.rend(); ++overview)
        recorded::restore(*overview, capture);
    return !found.empty();
}

QString damageText(const recorded::Damage &damage)
{
    using Kind = recorded::Damage::Kind;
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
