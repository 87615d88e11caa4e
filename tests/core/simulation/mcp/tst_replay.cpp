// The recorded sessions, played against the simulated board on virtual time: what came back then has to come back now.
// BEACON, PING and ERROR byte by byte; RESPONSE by status and by the length of every value; ASYNC by length, mark,
// time and what was lost. Nothing here depends on how fast the machine is.
#include "base/crc.h"
#include "mcp/protocol.h"
#include "support/places.h"
#include "support/transcript.h"

#include <QDir>
#include <QTest>

#include <algorithm>
#include <deque>
#include <map>

using namespace std::chrono_literals;
using support::Transcript;
using support::TranscriptRow;
using From = TranscriptRow::From;

namespace {

constexpr Duration kPause = 1500us; ///< header to payload, where the note says nothing else
constexpr Duration kStep = 100us;
constexpr std::uint8_t kResponse = 0xA, kAsync = 9, kBeacon = 5, kPing = 6;

bool hasNoPause(const TranscriptRow &row)
{
    static const QRegularExpression words(QStringLiteral("no pause|burst|garbage|^payload "),
        QRegularExpression::CaseInsensitiveOption);
    return words.match(row.note).hasMatch();
}

bool isRace(const TranscriptRow &row)
{
    return row.note.contains(QLatin1String("no pause"), Qt::CaseInsensitive);
}

QByteArray hex(ByteView bytes)
{
    return QByteArray(
        reinterpret_cast<const char *>(bytes.data()), static_cast<qsizetype>(bytes.size()))
        .toHex();
}

/// One thing the Controller or the user did, and what came back before the next.
struct Segment {
    const TranscriptRow *action = nullptr;
    std::vector<const TranscriptRow *> rows;
    Duration gap{};
};

std::vector<Segment> segmentsOf(const Transcript &transcript)
{
    std::vector<Segment> segments;
    Duration end{};
    for (const TranscriptRow &row : transcript.rows) {
        if (row.from != From::Board) {
            segments.push_back({&row, {}, std::max(Duration(0), row.time - end)});
        } else if (!segments.empty()) {
            segments.back().rows.push_back(&row);
        }
        end = row.time;
    }
    return segments;
}

/// Cuts what the board sends into packets; bytes that start none are collected.
class Splitter {
public:
    void feed(ByteView bytes) { m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end()); }
    bool payloadCrc = false;
    Bytes stray;

    /// What a Controller does when the line has been silent for long: it forgets the rest of a spoilt packet.
    void drop()
    {
        m_bytes.clear();
        stray.clear();
    }

    std::optional<Bytes> next()
    {
        while (m_bytes.size() >= 4) {
            const std::uint32_t word = ByteReader(ByteView(m_bytes).first(4)).u32();
            if (crc4(word & 0x0FFFFFFFU) != word >> 28) {
                stray.push_back(m_bytes.front());
                m_bytes.erase(m_bytes.begin());
                continue;
            }
            std::size_t size = 4;
            if (const auto type = word & 0xFU; type == kResponse || type == kAsync) {
                const std::size_t length = word >> 4 & 0x1FFFU;
                size += length + (payloadCrc && length > 0 ? 2U : 0U);
            }
            if (m_bytes.size() < size)
                return std::nullopt;
            const auto end = m_bytes.begin() + static_cast<std::ptrdiff_t>(size);
            Bytes packet(m_bytes.begin(), end);
            m_bytes.erase(m_bytes.begin(), end);
            return packet;
        }
        return std::nullopt;
    }

private:
    Bytes m_bytes;
};

/// Lengths of the values of a GET answer, as far as they go; empty where they do not fit.
std::vector<std::size_t> valueLengths(ByteView ids, ByteView values)
{
    std::vector<std::size_t> lengths;
    ByteReader names(ids), data(values);
    while (data.left() > 0 && names.left() >= 2) {
        const mcp::RegisterId id{names.u16()};
        const std::size_t before = data.left();
        if (id.type() == 4)
            data.zeroTerminated();
        else if (id.type() == 5)
            data.take(data.u16());
        else
            data.take(mcp::scalarWidth(id.type()));
        if (!data.ok())
            return {};
        lengths.push_back(id.type() == 4 ? 0 : before - data.left()); // texts may differ in length
    }
    return data.left() == 0 ? lengths : std::vector<std::size_t>{};
}

/// What is wrong with a response to `request`; empty if nothing.
QString compareResponse(ByteView request, ByteView want, ByteView got)
{
    const QString both = QStringLiteral("%1, expected %2");
    const QString texts = both.arg(QLatin1String(hex(got)), QLatin1String(hex(want)));
    if (want.empty() || got.empty() || want.back() != got.back())
        return texts;
    const unsigned command =
        request.size() < 2 ? 0xFFFF : (request[0] | unsigned{request[1]} << 8) >> 3;
    if (command == 2 && request.size() > 2) {
        const auto ids = request.subspan(2);
        const auto before = valueLengths(ids, want.first(want.size() - 1));
        const auto now = valueLengths(ids, got.first(got.size() - 1));
        return before == now ? QString() : texts;
    }
    if (want.size() != got.size())
        return texts;
    if (command == 1)
        return std::equal(want.begin(), want.end(), got.begin()) ? QString() : texts;
    return {};
}

/// ASYNC packets of one mark, in the order in which they came.
struct ReplayedStream {
    std::vector<std::uint32_t> stamps; ///< of full packets
    std::size_t fullLength = 0;
    int packets = 0;

    void add(ByteView payload, bool full)
    {
        ++packets;
        if (!full)
            return;
        stamps.push_back(ByteReader(payload).u32());
        fullLength = payload.size();
    }
    std::uint32_t step() const
    {
        std::uint32_t least = 0;
        for (std::size_t i = 1; i < stamps.size(); ++i) {
            const std::uint32_t step = stamps[i] - stamps[i - 1];
            least = least == 0 ? step : std::min(least, step);
        }
        return least;
    }
    /// Share of the time between the first and the last packet that no packet covers.
    double lostShare(std::uint32_t step) const
    {
        if (stamps.size() < 2)
            return 0.0;
        const double span = stamps.back() - stamps.front();
        return 1.0 - static_cast<double>(step) * static_cast<double>(stamps.size() - 1) / span;
    }
};

class Player {
public:
    explicit Player(const Transcript &transcript)
        : m_transcript(transcript)
        , m_board(simulation::makeBoard(transcript.board))
    {
        pass(250ms);
        for (const TranscriptRow &row : transcript.rows) {
            if (row.type == QLatin1String("ASYNC"))
                m_recorded[mark(row)].add(payloadOf(row.bytes), !row.partial);
        }
    }

    /// The first difference; empty if there is none.
    QString play()
    {
        const auto segments = segmentsOf(m_transcript);
        for (const Segment &segment : segments) {
            wait(segment.gap);
            act(*segment.action);
            collect(segment);
            if (!m_problem.isEmpty())
                return m_problem;
        }
        wait(50ms);
        if (m_lostThen > 0 && m_lostNow == 0)
            note(QStringLiteral("every packet without a pause was answered"));
        if (m_problem.isEmpty())
            compareStreams();
        return m_problem;
    }

private:
    static ByteView payloadOf(ByteView packet)
    {
        const std::size_t length = ByteReader(packet).u32() >> 4 & 0x1FFFU;
        return packet.subspan(4, length);
    }
    static int mark(const TranscriptRow &row)
    {
        const ByteView payload = payloadOf(row.bytes);
        return payload[payload.size() - 2];
    }
    void note(const QString &problem)
    {
        if (m_problem.isEmpty())
            m_problem = problem;
    }
    void pass(Duration time)
    {
        m_now += time;
        m_board->advance(m_now);
        m_splitter.feed(m_board->takeOutput());
        while (auto packet = m_splitter.next())
            m_heard.push_back(*packet);
    }
    void wait(Duration time);
    void act(const TranscriptRow &row);
    void person(const TranscriptRow &row);
    void collect(const Segment &segment);
    void reply(const Segment &segment, const TranscriptRow &want, const Bytes &got);
    void heardAsync(const Bytes &packet);
    void compareStreams();

    const Transcript &m_transcript;
    std::unique_ptr<simulation::SimulatedBoard> m_board;
    TimePoint m_now{};
    Splitter m_splitter;
    std::deque<Bytes> m_heard;
    QString m_problem;
    std::map<int, ReplayedStream> m_recorded, m_played;
    bool m_offeredCrc = false;
    bool m_parityUnknown = false; ///< a race went another way than in the recording
    int m_lostThen = 0, m_lostNow = 0;
};

void Player::wait(Duration time)
{
    const TimePoint due = m_now + time;
    while (m_now < due) {
        pass(std::min(kStep, due - m_now));
        for (const Bytes &packet : m_heard) {
            if ((packet[0] & 0xFU) == kAsync)
                heardAsync(packet);
            else
                note(QStringLiteral("unexpected %1").arg(QLatin1String(hex(packet))));
        }
        m_heard.clear();
    }
}

void Player::act(const TranscriptRow &row)
{
    if (row.from == From::Person)
        return person(row);
    const ByteView bytes = row.bytes;
    if (bytes.size() == 4 && (bytes[0] & 0xFU) == kBeacon)
        m_offeredCrc = (bytes[0] & 0x80U) != 0;
    if (bytes.size() <= 4 || hasNoPause(row)) {
        m_board->receive(bytes, m_now);
        return;
    }
    m_board->receive(bytes.first(4), m_now);
    pass(kPause + wireTime(4, m_transcript.board.baud));
    m_board->receive(bytes.subspan(4), m_now);
}

void Player::person(const TranscriptRow &row)
{
    const auto number =
        QRegularExpression(QStringLiteral("\\d+")).match(row.note).captured().toInt();
    if (row.note.contains(QLatin1String("reset")))
        m_board->reset();
    else if (row.note.contains(QLatin1String("output lost")))
        m_board->mute(std::chrono::milliseconds(number));
    else if (row.note.contains(QLatin1String("over-current fault")))
        m_board->setFaults(0x0040);
    else if (row.note.contains(QLatin1String("fault gone")))
        m_board->setFaults(0);
    else if (row.note.contains(QLatin1String("inverted")))
        m_board->corruptAfter(1);
    else
        note(QStringLiteral("nobody knows how to do \"%1\"").arg(row.note));
}

void Player::collect(const Segment &segment)
{
    std::deque<const TranscriptRow *> replies;
    int asyncs = 0;
    Bytes strays;
    for (const TranscriptRow *row : segment.rows) {
        if (row->type == QLatin1String("ASYNC"))
            ++asyncs;
        else if (row->type == QLatin1String("not a valid packet"))
            strays.insert(strays.end(), row->bytes.begin(), row->bytes.end());
        else
            replies.push_back(row);
    }
    const bool race = isRace(*segment.action);
    const Duration recorded =
        segment.rows.empty() ? Duration(0) : segment.rows.back()->time - segment.action->time;
    const TimePoint patience = m_now + 2 * recorded + (race ? 150ms : 700ms);
    bool answered = false;
    while (m_now < patience && m_problem.isEmpty()
        && (race || !replies.empty() || asyncs > 0 || m_splitter.stray.size() < strays.size())) {
        if (m_heard.empty())
            pass(kStep);
        if (m_heard.empty())
            continue;
        const Bytes packet = m_heard.front();
        m_heard.pop_front();
        const unsigned type = packet[0] & 0xFU;
        answered = answered || type == kResponse;
        if (type == kAsync) {
            heardAsync(packet);
            --asyncs;
        } else if (race && (replies.empty() || (replies.front()->bytes[0] & 0xFU) != type)) {
            m_parityUnknown = true;
        } else if (replies.empty()) {
            note(QStringLiteral("unexpected %1").arg(QLatin1String(hex(packet))));
        } else {
            reply(segment, *replies.front(), packet);
            replies.pop_front();
        }
    }
    if (race) {
        const bool answeredThen = std::any_of(segment.rows.begin(), segment.rows.end(),
            [](const TranscriptRow *row) { return row->type == QLatin1String("RESPONSE"); });
        m_lostThen += answeredThen ? 0 : 1;
        m_lostNow += answered ? 0 : 1;
        m_parityUnknown = m_parityUnknown || answered != answeredThen;
    } else if (!replies.empty()) {
        note(QStringLiteral("no answer to \"%1\"").arg(segment.action->note));
    }
    const Bytes &stray = m_splitter.stray;
    const bool fits =
        stray.size() >= strays.size() && std::equal(strays.begin(), strays.end(), stray.begin());
    if (!fits || (strays.empty() && !stray.empty()))
        note(QStringLiteral("bytes that are no packet: %1").arg(QLatin1String(hex(stray))));
    if (!strays.empty()) {
        pass(5ms);
        m_splitter.drop();
    }
}

void Player::reply(const Segment &segment, const TranscriptRow &want, const Bytes &got)
{
    const unsigned type = got[0] & 0xFU;
    const QString where = QStringLiteral("\"%1\": ").arg(segment.action->note);
    if (type == kResponse && (want.bytes[0] & 0xFU) == kResponse) {
        const ByteView request = segment.action->bytes;
        const QString problem =
            compareResponse(request.size() > 4 ? request.subspan(4) : ByteView{},
                payloadOf(want.bytes), payloadOf(got));
        if (!problem.isEmpty())
            note(where + problem);
        return;
    }
    Bytes a = want.bytes, b = got;
    if (type == kPing && m_parityUnknown && (a[0] & 0xFU) == kPing) {
        for (Bytes *bytes : {&a, &b}) {
            (*bytes)[0] &= 0x3FU;
            (*bytes)[3] &= 0x0FU;
        }
    }
    if (a != b)
        note(where
            + QStringLiteral("%1, expected %2")
                  .arg(QLatin1String(hex(got)), QLatin1String(hex(want.bytes))));
    if (type == kBeacon)
        m_splitter.payloadCrc = m_offeredCrc && (got[0] & 0x80U) != 0;
}

void Player::heardAsync(const Bytes &packet)
{
    const ByteView payload = payloadOf(packet);
    if (payload.size() < 6 || payload.back() != 0)
        return note(QStringLiteral("ASYNC of %1 bytes").arg(payload.size()));
    const int mark = payload[payload.size() - 2];
    const auto recorded = m_recorded.find(mark);
    if (recorded == m_recorded.end())
        return note(QStringLiteral("ASYNC with mark %1").arg(mark));
    const std::size_t full = recorded->second.fullLength;
    if (full != 0 && payload.size() > full)
        note(QStringLiteral("ASYNC of %1 bytes, expected %2").arg(payload.size()).arg(full));
    m_played[mark].add(payload, payload.size() == full);
}

void Player::compareStreams()
{
    for (const auto &[mark, then] : m_recorded) {
        const ReplayedStream &now = m_played[mark];
        const int tolerance = std::max(3, then.packets * 35 / 100);
        if (std::abs(now.packets - then.packets) > tolerance)
            note(QStringLiteral("%1 packets with mark %2, expected %3")
                     .arg(now.packets)
                     .arg(mark)
                     .arg(then.packets));
        const std::uint32_t step = then.step();
        const double lostThen = then.lostShare(step), lostNow = now.lostShare(step);
        if (lostThen == 0.0 ? now.stamps.size() > 1 && lostNow != 0.0
                            : std::abs(lostNow - lostThen) > 0.05)
            note(QStringLiteral("mark %1: %2 of the time lost, expected %3")
                     .arg(mark)
                     .arg(lostNow)
                     .arg(lostThen));
    }
}

} // namespace

class TestReplay : public QObject {
    Q_OBJECT

private slots:
    void answersAsTheFirmwareDid_data();
    void answersAsTheFirmwareDid();
};

void TestReplay::answersAsTheFirmwareDid_data()
{
    QTest::addColumn<QString>("path");
    const QDir folder(support::dataFile(QStringLiteral("transcripts")));
    const QStringList names =
        folder.entryList({QStringLiteral("*.jsonl")}, QDir::Files, QDir::Name);
    QVERIFY(names.size() >= 45);
    for (const QString &name : names)
        QTest::newRow(qPrintable(name)) << folder.filePath(name);
}

void TestReplay::answersAsTheFirmwareDid()
{
    QFETCH(QString, path);
    const auto transcript = support::readTranscript(path);
    QVERIFY(transcript.has_value());
    QVERIFY(!transcript->rows.empty());
    const QString problem = Player(*transcript).play();
    QVERIFY2(problem.isEmpty(), qPrintable(problem));
}

QTEST_APPLESS_MAIN(TestReplay)
#include "tst_replay.moc"
