// Drive for servo drives that speak MCB on SPI. It joins the link (mcb::Master) with the pieces of work that want
// something of the drive (Task) and gives the link to the most urgent one whenever it is free:
//
//   the stop > identification > state poll > wishes that act > wishes that read > watched registers
//
// After every connection: which registers there are, who it is, what bounds it; only then anything else. No motion and
// no write is ever sent that a wish of this session did not ask for, but the return to the config state of a drive that
// is found cycling. Output is exchanges: as many bytes come in as go out, and handleReady() tells the ready line where
// there is one.
#include "drive/mcb/commands.h"
#include "drive/mcb/identification.h"
#include "drive/mcb/stream.h"
#include "drive/mcb/vitals.h"
#include "drive/protocol_table.h"
#include "drive/register_watch.h"
#include "drive/task_drive.h"
#include "mcb/dictionary.h"

#include <algorithm>

namespace drive {

namespace {

/// Of the link, between two STOPs that are sent blind: what they lack is given up before, and the drive asked behind
/// that, or the length of its frames found, without which no STOP may be of use.
constexpr Duration kOwnTurn = std::chrono::milliseconds(130);

constexpr std::int64_t kQuickStopActive = 0x07; ///< of the status word, masked

LinkReason reasonOf(mcb::Master::Cause cause)
{
    switch (cause) {
    case mcb::Master::Cause::NotReady:
        return LinkReason::NotReady;
    case mcb::Master::Cause::DeadLow:
    case mcb::Master::Cause::DeadHigh:
        return LinkReason::DeadLine;
    case mcb::Master::Cause::Garbage:
    case mcb::Master::Cause::Damaged:
        return LinkReason::OnlyGarbage;
    default:
        return LinkReason::NoAnswer;
    }
}

class McbDrive final : public TaskDrive<McbProtocol> {
public:
    explicit McbDrive(const LineOptions &line);

    void connect(TimePoint now) override
    {
        endSetPoints();
        TaskDrive::connect(now);
    }
    void handleReady(bool high, TimePoint now) override
    {
        m_link.setReady(high, now);
        work(now);
    }
    std::vector<Output> stopScript() const override;

private:
    Made taskFor(const Wish &wish) override;

    // what the link tells
    void onLinkEvents(TimePoint now) override
    {
        for (const Link::Event &event : m_link.takeEvents())
            std::visit([&](const auto &what) { on(what, now); }, event);
    }
    void on(const Link::Done &event, TimePoint now);
    void on(const Link::Met &, TimePoint now)
    {
        linkFound();
        beginAnew(LinkReason::None, now);
    }
    void on(const Link::Cycle &event, TimePoint)
    {
        const std::uint64_t lost = m_link.stats().cyclesLost;
        m_stream.receive(event, lost - std::exchange(m_cyclesLost, lost));
    }
    void on(const Link::Searching &, TimePoint) { m_stream.interrupted(); }
    void on(const Link::Back &event, TimePoint now);
    void on(const Link::Lost &event, TimePoint now);
    void beginAnew(LinkReason reason, TimePoint now);
    void onIdentified(TimePoint) override { streamAgain(); }
    void identifyAnew() override { m_identification.restart(); }
    void onStatuses(const std::vector<MotorStatus> &statuses) override;
    bool connected() const override
    {
        return m_link.state() == Link::State::Config || m_link.state() == Link::State::Cyclic;
    }
    bool recovering() const override { return m_link.state() == Link::State::Seeking; }
    LinkCounters counters() const override;

    // what goes out
    void streamAgain(); ///< unless nothing was streamed, or it runs
    void prepare(TimePoint now) override;
    bool send(const McbRequest &request, WishTask<McbProtocol> *wish, TimePoint now) override;
    bool recall(TimePoint now) override
    {
        const bool recalled = m_link.recall(now);
        onLinkEvents(now);
        return recalled;
    }
    void sendStop(int motor, TimePoint now) override;
    std::optional<TimePoint> nextStop() const override;
    bool travels(const Link::Request &request) const;
    Bytes frameWith(const Link::Request &request) const;
    void sendInFrames(
        const Link::Request &request, std::optional<TimePoint> leaveBy, TimePoint now);
    /// A set-point that travels and is being read back: the answer to its write.
    struct Travelling {
        mcb::Words before, wanted;
        bool rests = false; ///< all were put to rest since: nothing is put back
    };
    void setInFrames(std::uint16_t address, mcb::WordView words)
    {
        m_setPoints.set(address, words);
        m_link.setCyclicOutput(m_setPoints.output(m_link.mapping().rx));
    }
    bool tookAlong(std::uint16_t address, const mcb::Words &words) const;
    Link::Done confirmed(const Link::Done &read, const Travelling &travelling);
    void restSetPoints()
    {
        m_setPoints.rest();
        m_link.setCyclicOutput({});
        if (m_confirming)
            m_confirming->rests = true;
    }
    void endSetPoints()
    {
        m_setPoints.end();
        m_link.setCyclicOutput({});
        m_confirming.reset();
    }
    Duration closingTime() const override { return std::chrono::milliseconds(500); }
    void leave() override
    {
        m_setPoints.end(); // frames hold what they carry until the drive has left the cyclic state
        if (m_stream.running() && connected())
            m_wishes.add(std::make_unique<McbStreamTask>(0, Stream{}, m_stream, m_setPoints));
    }
    void closeLink() override
    {
        m_stream.close();
        endSetPoints();
        m_link.close();
    }
    void collect(TimePoint now) override;
    std::optional<TimePoint> nextOwn() const override { return m_stream.nextFlush(); }
    bool reconnectsBlind() const override { return true; }

    McbStreamControl m_stream{m_board};
    McbSetPoints m_setPoints{m_board};
    std::optional<Travelling> m_confirming;
    bool m_toldCyclic = false, m_faulty = false;
    /// Since then a STOP waits for the drive to be ready or frames to have their new length.
    std::optional<TimePoint> m_stopWaits;
    std::uint64_t m_cyclesLost = 0; ///< as last told by the link
};

McbDrive::McbDrive(const LineOptions &line)
    : TaskDrive({.patience = line.patience})
{
    m_board.motorsCounted = true; // one, always
    // What a stop needs before anything was told.
    for (const std::uint16_t address :
        {mcbreg::kControl, mcbreg::kStatus, mcbreg::kVelocityNow, mcbreg::kLastError})
        if (const mcb::Entry *entry = mcb::findEntry(address))
            m_board.infos[address] = entry->info;
    m_board.catalog = mcbCatalogOf(m_board.infos);
}

McbDrive::Made McbDrive::taskFor(const Wish &wish)
{
    return std::visit(
        [&]<class Act>(const Act &wanted) -> Made {
            if constexpr (std::is_constructible_v<McbAct, const Act &>)
                return std::make_unique<McbActTask>(wish.id, wanted, m_board);
            else if constexpr (std::is_same_v<Act, Stream> || std::is_same_v<Act, CyclicSetPoints>)
                return std::make_unique<McbStreamTask>(wish.id, wanted, m_stream, m_setPoints);
            else
                return nullptr;
        },
        wish.what);
}

void McbDrive::on(const Link::Done &event, TimePoint now)
{
    if (m_task == nullptr)
        return onStopAnswer(event.end == Link::End::Ok, now);
    const auto wanted = std::exchange(m_confirming, std::nullopt);
    const Link::Done done = wanted ? confirmed(event, *wanted) : event;
    if (done.end == Link::End::Ok || done.end == Link::End::Refused)
        passAnswer({done.end == Link::End::Ok, done.words, done.code}, now);
    else
        passLoss(done.end == Link::End::NotSent ? std::optional(false) : std::nullopt, now);
}

void McbDrive::beginAnew(LinkReason reason, TimePoint now)
{
    m_stream.ended();
    endSetPoints();
    m_faulty = false;
    m_board.quickStop = false;
    meet(reason, now);
}

void McbDrive::on(const Link::Back &event, TimePoint now)
{
    m_stream.interrupted();
    if (!event.afterReset)
        return;
    disarm();
    beginAnew(LinkReason::BoardReset, now);
}

void McbDrive::on(const Link::Lost &event, TimePoint now)
{
    linkLost(reasonOf(event.cause), now);
    m_stream.ended();
    endSetPoints();
    if (m_stop.blind(now))
        m_reconnectAt = now + StopSequence::kRepeat;
}

void McbDrive::streamAgain()
{
    m_stream.takeLeftOff();
    if (m_stream.wanted() && !m_stream.running() && m_mode == Mode::Open)
        m_wishes.addFirst(
            std::make_unique<McbStreamTask>(0, m_stream.wish(), m_stream, m_setPoints));
}

/// A motor that a fault has stopped does not go back to its set-point when the fault is over.
void McbDrive::onStatuses(const std::vector<MotorStatus> &statuses)
{
    for (const MotorStatus &status : statuses) {
        const bool fault = hasFault(status.state);
        if (fault && !std::exchange(m_faulty, fault))
            restSetPoints();
        m_faulty = fault;
        m_board.quickStop = status.rawState == kQuickStopActive;
    }
}

void McbDrive::prepare(TimePoint now)
{
    const bool stopping = m_mode == Mode::Open && m_stop.active();
    m_link.setHurried(stopping, now);
    if (stopping)
        return restSetPoints();
    m_stopWaits.reset();
    // A Stop breaks off everything, and so does a drive that refuses a mapping: what was streamed goes on.
    if (m_board.identified && connected() && m_stream.takeLeftOff())
        streamAgain();
}

/// In the length of frames that the drive has now, and in the other one: it may be changing.
std::vector<Output> McbDrive::stopScript() const
{
    constexpr Duration kBehindFrame = std::chrono::milliseconds(2); // to be ready again
    // Byte streams forget an unfinished frame, see Master::quiet.
    constexpr Duration kBehindWrongFrame = std::chrono::milliseconds(60);
    mcb::Frame stop{mcbreg::kControl, mcb::Command::Write, false, {mcbStopWord(m_board)}, {}};
    std::vector<Output> script{{mcb::encodeFrame(stop), kBehindFrame}};
    if (const std::size_t words = m_link.mapping().words(); words > 0) {
        stop.cyclic.resize(words);
        script.push_back({mcb::encodeFrame(stop), kBehindFrame});
        if (m_link.state() == Link::State::Cyclic)
            std::swap(script.front(), script.back());
        script.back().gapBefore = kBehindWrongFrame;
    }
    return script;
}

std::optional<TimePoint> McbDrive::nextStop() const
{
    // What is due already waits for the link, which has its own timer.
    const auto later = [this](std::optional<TimePoint> at) {
        return at && *at > m_workedAt ? at : std::nullopt;
    };
    auto next = later(TaskDrive::nextStop());
    if (m_stopWaits)
        earliest(next, later(*m_stopWaits + StopSequence::kRepeat));
    return next;
}

void McbDrive::sendStop(int motor, TimePoint now)
{
    if (connected() && !m_link.canSend()) {
        m_link.cancel(now);
        onLinkEvents(now);
    }
    if (m_link.canSend() && m_link.ready())
        m_stopWaits.reset();
    else
        m_stopWaits = m_stopWaits.value_or(connected() ? now : now - StopSequence::kRepeat);
    const bool blind = m_stopWaits && now >= *m_stopWaits + StopSequence::kRepeat;
    if (!blind && !m_link.canSend())
        return; // the length of frames is changing: in a moment it is known
    const Link::Request stop{mcb::Command::Write, mcbreg::kControl, {mcbStopWord(m_board)}};
    noteStop(motor, mcbChanges(stop), now);
    m_stopSince = now;
    m_stopUnderWay = !blind;
    if (!blind)
        return m_link.send(stop, now);
    m_link.sendBlind(stopScript(), now);
    m_stopWaits = now + kOwnTurn;
}

bool McbDrive::send(const McbRequest &request, WishTask<McbProtocol> *wish, TimePoint now)
{
    const auto *one = std::get_if<Link::Request>(&request);
    const auto leaveBy = wish != nullptr ? wish->leaveBy() : std::nullopt;
    if (leaveBy && now >= *leaveBy)
        return false;
    const bool inFrames = one != nullptr && travels(*one);
    if (const Bytes changes = mcbChanges(request);
        wish != nullptr && wish->motion() && !changes.empty())
        noteSent(*wish->motion(), inFrames ? frameWith(*one) : changes);
    if (inFrames) {
        sendInFrames(*one, leaveBy, now);
    } else if (one != nullptr) {
        Link::Request asked = *one;
        asked.leaveBy = leaveBy; // the drive may not be ready
        m_link.send(std::move(asked), now);
    } else if (const auto *map = std::get_if<McbMap>(&request)) {
        // In the config state, so that no frame goes out with words of another mapping.
        m_link.setCyclicOutput(m_setPoints.output(map->mapping.rx));
        m_link.switchOn(map->mapping, m_stream.period(), now);
    } else {
        m_link.switchOff(now);
    }
    return true;
}

/// Whether a set-point is one that goes out with every frame now.
bool McbDrive::travels(const Link::Request &request) const
{
    const auto &rx = m_link.mapping().rx;
    return request.command == mcb::Command::Write && m_link.state() == Link::State::Cyclic
        && std::ranges::find(rx, request.address, &mcb::MappedRegister::address) != rx.end();
}

/// The first one that has the new value.
Bytes McbDrive::frameWith(const Link::Request &request) const
{
    McbSetPoints after = m_setPoints;
    after.set(request.address, request.words);
    mcb::Frame frame{request.address, mcb::Command::Read, false, {}, {}};
    frame.cyclic = after.output(m_link.mapping().rx);
    frame.cyclic.resize(m_link.mapping().words());
    return mcb::encodeFrame(frame);
}

/// The frame that asks for the register has its new value already, and so has every one after it: what is read back is
/// the answer.
void McbDrive::sendInFrames(
    const Link::Request &request, std::optional<TimePoint> leaveBy, TimePoint now)
{
    m_confirming = {m_setPoints.of(request.address), request.words};
    setInFrames(request.address, request.words);
    Link::Request asked{mcb::Command::Read, request.address};
    asked.leaveBy = leaveBy;
    m_link.send(std::move(asked), now);
}

/// Whether the last frame had these words for the register.
bool McbDrive::tookAlong(std::uint16_t address, const mcb::Words &words) const
{
    const mcb::WordView sent(m_link.cyclicSent()), wanted(words);
    std::size_t at = 0;
    for (const mcb::MappedRegister &entry : m_link.mapping().rx) {
        const std::size_t count = mcb::wordsOf(entry.size);
        if (entry.address == address)
            return wanted.size() >= count && sent.size() >= at + count
                && std::ranges::equal(wanted.first(count), sent.subspan(at, count));
        at += count;
    }
    return false;
}

mcb::Master::Done McbDrive::confirmed(const Link::Done &read, const Travelling &travelling)
{
    const mcb::Words &wanted = travelling.wanted;
    Link::Done write = read;
    if (read.end == Link::End::NotSent) {
        if (tookAlong(read.request.address, wanted))
            write.end = Link::End::Unknown; // the question did not leave, but the value did
        else if (!travelling.rests)
            setInFrames(read.request.address, travelling.before);
    }
    if (read.end != Link::End::Ok)
        return write;
    const bool same = read.words.size() >= wanted.size()
        && std::equal(wanted.begin(), wanted.end(), read.words.begin());
    if (!same) { // the drive took another value: it is not written again
        write.end = Link::End::Refused;
        write.code = kOtherValueRead;
        if (!travelling.rests)
            setInFrames(read.request.address,
                mcb::WordView(read.words).first(std::min(wanted.size(), read.words.size())));
    }
    return write;
}

void McbDrive::collect(TimePoint now)
{
    TaskDrive::collect(now);
    if (m_setPoints.wanted() != m_toldCyclic)
        m_events.emplace_back(CyclicSetPointsChanged{m_toldCyclic = m_setPoints.wanted()});
    m_stream.flush(now);
    for (Event &event : m_stream.takeEvents())
        m_events.push_back(std::move(event));
}

LinkCounters McbDrive::counters() const
{
    const Link::Stats &link = m_link.stats();
    return {.bytesIn = link.bytesIn,
        .bytesOut = link.bytesOut,
        .packetsIn = link.goodFrames,
        .packetsOut = link.exchanges,
        .badPackets = link.damaged + link.dead + link.torn + link.strays,
        .timeouts = link.timeouts,
        .recoveries = link.searches,
        .streamPackets = m_stream.packets(),
        .streamLostTicks = m_stream.lost()};
}

} // namespace

std::unique_ptr<Drive> makeMcbDrive(const LineOptions &line, Search)
{
    return std::make_unique<McbDrive>(line);
}

} // namespace drive
