// Exchanges: when the next frame goes, and what became of the one before.
#include "mcb/master.h"

#include <algorithm>
#include <utility>

namespace mcb {
namespace {

using namespace std::chrono_literals;

constexpr int kQuickIdles = 3; ///< behind a request; the next ones leave the drive some time
constexpr Duration kIdlePause = 1ms;
constexpr Duration kSlowCycle = 5ms; ///< what is hurried waits for the frames of a faster one
constexpr int kBadInRow = 4, kTornInRow = 2; ///< then the length is in doubt
constexpr int kMeetingTries = 3; ///< what a drive sends in its first frame is not known

Master::Cause causeOf(FrameError error)
{
    switch (error) {
    case FrameError::DeadLow:
        return Master::Cause::DeadLow;
    case FrameError::DeadHigh:
        return Master::Cause::DeadHigh;
    default:
        return Master::Cause::Garbage;
    }
}

bool leaves(const Master::Request &request)
{
    return request.command == Command::Write && request.address == kStateRegister
        && request.words.front() == kConfigState;
}

/// Frames of a slave in the config state in the place of a longer one: a slave that hears frames gives one, filled up
/// with zeros, one that hears bytes gives idle ones behind it. The CRC of either is right. A cyclic frame that looks
/// the same has that CRC as its first value and this behind it; it is lost.
bool isOfConfigState(ByteView received)
{
    if (received.size() <= kConfigFrameBytes || !decodeAnswer(received.first(kConfigFrameBytes)))
        return false;
    const Bytes idle = encodeFrame(Frame{0, Command::Idle, false, {}, {}});
    auto rest = received.subspan(kConfigFrameBytes);
    while (rest.size() >= idle.size() && std::equal(idle.begin(), idle.end(), rest.begin()))
        rest = rest.subspan(idle.size());
    return std::ranges::all_of(rest, [](auto byte) { return byte == 0; });
}

} // namespace

Master::Master(Config config)
    : m_config(config)
{
}

void Master::connect(TimePoint now)
{
    close();
    m_state = State::Meeting;
    m_notBefore = now;
    work(now);
}

void Master::close()
{
    const Stats stats = m_stats;
    const bool hasLine = m_hasLine, ready = m_ready;
    const std::size_t blindBytes = m_blindBytes;
    const TimePoint blindBy = m_blindBy;
    Mapping mapping = std::move(m_mapping); // the drive may still be cycling by it
    *this = Master(m_config);
    m_mapping = std::move(mapping);
    m_blindBytes = blindBytes;
    m_blindBy = blindBy;
    m_stats = stats;
    m_hasLine = hasLine;
    m_ready = ready;
}

bool Master::canSend() const
{
    return (m_state == State::Config || m_state == State::Cyclic) && !m_operation
        && m_way == Way::None;
}

void Master::send(Request request, TimePoint now)
{
    begin(std::move(request));
    work(now);
}

void Master::cancel(TimePoint now)
{
    if (!m_operation || m_way == Way::Leave)
        return;
    const bool asked = m_operation->sent > 0;
    if (asked && m_operation->request.command == Command::Write
        && m_operation->request.address == kStateRegister) {
        m_cancelled = true; // the length of the next frame hangs on its answer: no step behind that
        return;
    }
    hush(now);
    end(asked ? End::Unknown : End::NotSent, now, {}, 0, Cause::Cancelled);
    m_drain = 0; // a new request makes a slave drop what it had to say
}

void Master::switchOn(const Mapping &mapping, Duration period, TimePoint now, bool clearCounts)
{
    m_way = Way::On;
    m_steps = stepsOf(mapping, clearCounts);
    m_mapping = mapping;
    m_period = std::max<Duration>(period, 1us);
    m_step = 0;
    m_cancelled = false;
    begin({Command::Write, m_steps[0].address, m_steps[0].words, true});
    work(now);
}

void Master::switchOff(TimePoint now)
{
    m_way = Way::Off;
    m_steps = {{kStateRegister, {mcb::kConfigState}}};
    m_step = 0;
    begin({Command::Write, kStateRegister, m_steps[0].words, true});
    work(now);
}

void Master::sendBlind(std::vector<Output> frames, TimePoint now)
{
    if (m_exchange) // its bytes come before theirs; the answer in them is as good as lost
        m_blindBytes += m_exchange->length - m_exchange->received.size();
    if (std::exchange(m_exchange, std::nullopt) && m_operation && m_operation->sent > 0)
        spoil(now);
    m_blindBy = now + (m_hurried ? m_config.hurriedExchangeWithin : m_config.exchangeWithin)
        + m_config.patience;
    for (Output &frame : frames) {
        m_blindBy += frame.gapBefore;
        ++m_stats.exchanges;
        m_stats.bytesOut += frame.bytes.size();
        m_blindBytes += frame.bytes.size();
        m_output.push_back(std::move(frame));
    }
    if (m_hasLine)
        m_ready = false;
}

void Master::endBlind(TimePoint now)
{
    m_blindBytes = 0;
    m_notBefore = std::max(m_notBefore, now + m_config.quiet);
    if (m_state == State::Meeting && ++m_torn >= kTornInRow)
        seek(now);
}

void Master::setReady(bool high, TimePoint now)
{
    m_hasLine = true;
    m_ready = high;
    if (high)
        m_readyBy.reset();
    work(now);
}

bool Master::mayExchange(TimePoint now) const
{
    return !m_exchange && m_blindBytes == 0 && now >= m_notBefore && (!m_hasLine || m_ready);
}

Frame Master::idle(std::uint16_t address) const
{
    return Frame{address, Command::Idle, false, {}, {}};
}

/// The next piece of the request, or the IDLE that fetches its answer. mcblib names the register in that one, in the
/// config state only.
Frame Master::operationFrame(Exchange &exchange, TimePoint now)
{
    Operation &operation = *m_operation;
    if (operation.sent < operation.pieces.size()) {
        exchange.piece = true;
        operation.exchanges = 0;
        if (operation.sent == 0)
            operation.deadline = now + m_config.answerWithin + m_config.patience;
        m_leaving = m_leaving || leaves(operation.request);
        return operation.pieces[operation.sent++];
    }
    ++operation.exchanges;
    if (++operation.idles >= kQuickIdles && m_state == State::Config)
        m_notBefore = now + kIdlePause;
    return idle(m_state == State::Config ? operation.request.address : std::uint16_t{0});
}

void Master::setHurried(bool hurried, TimePoint now)
{
    m_hurried = hurried ? std::optional(m_hurried.value_or(now)) : std::nullopt;
}

TimePoint Master::exchangeDue() const
{
    if (!m_hurried)
        return m_exchange->by;
    return std::min(m_exchange->by,
        std::max(m_exchange->at, *m_hurried) + m_config.hurriedExchangeWithin + m_config.patience);
}

bool Master::betweenCycles() const { return m_hurried && m_operation && m_period >= kSlowCycle; }

/// Nothing if there is no reason for a frame now.
std::optional<Bytes> Master::nextBytes(TimePoint now, Exchange &exchange)
{
    switch (m_state) {
    case State::Closed:
    case State::Lost:
        return std::nullopt;
    case State::Seeking:
        return Bytes(kMostFrameBytes, 0xFF);
    case State::Meeting:
        return encodeFrame(idle(0));
    case State::Config:
        if (m_drain > 0)
            return encodeFrame(idle(0));
        return m_operation ? std::optional(encodeFrame(operationFrame(exchange, now)))
                           : std::nullopt;
    case State::Cyclic:
        break;
    }
    if (now >= m_cycleStart + m_nextTick * m_period) {
        exchange.tick = (now - m_cycleStart) / m_period;
        m_nextTick = *exchange.tick + 1;
    } else if (betweenCycles()) {
        m_notBefore = now + kIdlePause;
    } else {
        return std::nullopt;
    }
    Frame frame = m_operation && m_drain == 0 ? operationFrame(exchange, now) : idle(0);
    frame.cyclic = m_cyclicOutput;
    frame.cyclic.resize(m_words);
    m_cyclicSent = frame.cyclic;
    return encodeFrame(frame);
}

void Master::work(TimePoint now)
{
    // And no frame before that is known: what travels with every frame may be of that request.
    if (isLate(now))
        return end(End::NotSent, now, {}, 0, Cause::Cancelled);
    if (m_hasLine && !m_ready && !m_readyBy && !m_exchange
        && (m_operation || m_state == State::Meeting || m_state == State::Seeking
            || m_state == State::Cyclic))
        m_readyBy = now + m_config.readyWithin + m_config.patience;
    if (!mayExchange(now))
        return;
    Exchange exchange;
    auto bytes = nextBytes(now, exchange);
    if (!bytes)
        return;
    exchange.length = bytes->size();
    exchange.at = now;
    exchange.by = now + m_config.exchangeWithin + m_config.patience;
    ++m_stats.exchanges;
    m_stats.bytesOut += bytes->size();
    m_output.push_back({std::move(*bytes), {}});
    m_exchange = std::move(exchange);
    if (m_hasLine) // high again is said by an edge, never by the level right behind a frame
        m_ready = false;
}

void Master::receive(ByteView bytes, TimePoint now)
{
    m_stats.bytesIn += bytes.size();
    const std::size_t blind = std::min(m_blindBytes, bytes.size());
    m_blindBytes -= blind;
    bytes = bytes.subspan(blind);
    if (blind > 0 && bytes.empty())
        return work(now);
    if (!m_exchange) {
        m_stats.unexpected += bytes.size();
        return;
    }
    Bytes &received = m_exchange->received;
    const std::size_t room = m_exchange->length - received.size();
    const std::size_t taken = std::min(room, bytes.size());
    received.insert(received.end(), bytes.begin(), bytes.begin() + std::ptrdiff_t(taken));
    m_stats.unexpected += bytes.size() - taken;
    if (taken == room) {
        finish(now);
        // On a slow line the next frame is due already, and no timer comes between.
        checkOperation(now);
    }
    work(now);
}

void Master::finish(TimePoint now)
{
    const Exchange exchange = *std::exchange(m_exchange, std::nullopt);
    m_torn = 0;
    if (m_state == State::Seeking)
        return onProbe(exchange.received, now);
    auto frame = decodeAnswer(exchange.received);
    if (frame && isOfConfigState(exchange.received))
        frame = fail(FrameError::WrongLength);
    if (!frame) {
        if (exchange.tick)
            ++m_stats.cyclesLost;
        if (m_operation && m_operation->sent > 0 && !(exchange.piece && m_operation->sent == 1))
            spoil(now);
        return finishBad(frame.error(), now);
    }
    ++m_stats.goodFrames;
    m_bad = 0;
    finishGood(exchange, *frame, now);
}

void Master::finishGood(const Exchange &exchange, const Frame &frame, TimePoint now)
{
    if (m_state == State::Meeting) {
        m_state = State::Config;
        m_met = true;
        m_events.emplace_back(Met{});
        return;
    }
    if (exchange.tick && m_way != Way::Leave)
        m_events.emplace_back(Cycle{*exchange.tick, exchange.at, frame.cyclic});
    if (m_drain > 0) {
        if (frame.command == Command::Idle)
            m_drain = 0;
        else
            --m_drain;
    } else if (m_operation) {
        onAnswer(exchange, frame, now);
    }
}

void Master::finishBad(FrameError error, TimePoint now)
{
    m_lastBad = causeOf(error);
    ++(m_lastBad == Cause::Garbage ? m_stats.damaged : m_stats.dead);
    m_drain = std::max(0, m_drain - 1);
    if (++m_bad >= (m_state == State::Meeting ? kMeetingTries : kBadInRow))
        seek(now);
}

/// Fewer bytes came back than were sent: whatever is on its way belongs to nothing.
void Master::finishTorn(TimePoint now)
{
    const Exchange exchange = *std::exchange(m_exchange, std::nullopt);
    ++m_stats.torn;
    m_notBefore = now + m_config.quiet;
    if (m_state == State::Seeking)
        return onProbe(exchange.received, now);
    if (exchange.tick)
        ++m_stats.cyclesLost;
    m_lastBad = Cause::NoAnswer;
    if (m_operation && m_operation->sent > 0)
        spoil(now);
    if (++m_torn >= kTornInRow)
        seek(now);
}

void Master::checkReady(TimePoint now)
{
    if (!m_readyBy || now < *m_readyBy)
        return;
    m_readyBy.reset();
    ++m_stats.timeouts;
    lose(Cause::NotReady, now);
}

void Master::checkOperation(TimePoint now)
{
    if (m_exchange || !m_operation || !m_operation->deadline || now < *m_operation->deadline)
        return;
    if (m_hasLine && !m_ready && m_readyBy)
        return; // then that is what is wrong
    ++m_stats.timeouts;
    giveUp(m_operation->spoilt ? Cause::Damaged : Cause::NoAnswer, now);
}

void Master::handleTimeout(TimePoint now)
{
    if (m_blindBytes > 0 && now >= m_blindBy)
        endBlind(now);
    if (m_exchange && now >= exchangeDue())
        finishTorn(now);
    checkReady(now);
    checkOperation(now);
    work(now);
}

std::optional<TimePoint> Master::nextTimeout() const
{
    if (m_blindBytes > 0 && m_state != State::Closed)
        return m_hasLine && m_readyBy ? std::min(*m_readyBy, m_blindBy) : m_blindBy;
    if (m_state == State::Closed || m_state == State::Lost)
        return std::nullopt;
    if (m_exchange)
        return exchangeDue();
    std::optional<TimePoint> due;
    if (m_operation && m_operation->sent == 0)
        earliest(due, m_operation->request.leaveBy);
    if (m_hasLine && !m_ready && m_readyBy) {
        earliest(due, m_readyBy);
        return due;
    }
    if (m_operation)
        earliest(due, m_operation->deadline);
    if (m_hasLine && !m_ready)
        return due;
    if (m_state == State::Cyclic)
        earliest(due,
            betweenCycles() ? m_notBefore
                            : std::max(m_notBefore, m_cycleStart + m_nextTick * m_period));
    else if (m_operation || m_drain > 0 || m_state != State::Config)
        earliest(due, m_notBefore);
    return due;
}

} // namespace mcb
