#include "fcp/client.h"

#include "base/overloaded.h"
#include "fcp/register_table.h"

#include <algorithm>
#include <array>

namespace fcp {

namespace {

/// How a board of the newer protocol refuses what it takes for a damaged header.
constexpr std::array<std::uint8_t, 4> kNewerRefusal{0x0F, 0x04, 0x04, 0xC0};

bool isWidth(std::size_t size) { return size == 1 || size == 2 || size == 4; }

/// The board did not understand, so nothing was executed.
bool wasDamaged(const Nack &nack)
{
    const auto code = static_cast<ErrorCode>(nack.error.value_or(0));
    return code == ErrorCode::BadChecksum || code == ErrorCode::Timeout
        || code == ErrorCode::Overrun;
}

} // namespace

bool fits(const Command &command, ByteView data, Dialect dialect)
{
    return std::visit(
        Overloaded{
            [&](const GetRegister &get) {
                const Register *which = findRegister(dialect, get.id);
                return which == nullptr ? isWidth(data.size())
                                        : decodeValue(*which, data).has_value();
            },
            [&](const Execute &execute) {
                return decodeExecuteAck(execute.command, data).has_value();
            },
            [&](const GetBoardInfo &) { return decodeBoardInfo(data).has_value(); },
            [&](const GetFirmwareVersion &) { return decodeFirmwareVersion(data).has_value(); },
            [&](const GetRevUp &) { return decodeRevUp(data).has_value(); },
            [&](const GetProfilerInfo &) { return true; },
            [&](const auto &) { return data.empty(); },
        },
        command);
}

void Client::connect(TimePoint now)
{
    close();
    m_heard = false;
    m_refused = 0;
    m_gentle = true;
    m_round = 0;
    silence(now);
    m_state = State::Connecting;
}

void Client::close()
{
    m_state = State::Closed;
    m_connected = m_suspected = m_urgentOpen = false;
    m_unanswered.reset();
    m_request.reset();
    m_urgent.reset();
    m_framer.reset();
    m_output.clear();
    m_events.clear();
}

void Client::put(Bytes frame, TimePoint now)
{
    m_stats.bytesOut += frame.size();
    ++m_stats.framesOut;
    m_asked = now;
    m_unanswered = m_unanswered.value_or(now);
    m_output.push_back({std::move(frame), {}});
}

void Client::send(const Request &request, TimePoint now)
{
    auto frame = encodeRequest(request);
    if (!frame || !canSend()) {
        m_events.emplace_back(NoAnswer{false}); // it cannot be sent
        return;
    }
    m_framer.reset();
    m_deadline = now + wireTime(frame->size(), m_config.baud) + kAnswerTime + m_config.patience;
    put(std::move(*frame), now);
    m_request = request;
    m_urgentOpen = false;
    m_state = State::Waiting;
}

void Client::sendUrgent(const Request &request, TimePoint now)
{
    m_urgent = request;
    m_urgentBy = now + kGrace;
    if (m_state != State::Waiting)
        leaveUrgent(now);
}

void Client::leaveUrgent(TimePoint now)
{
    const Request request = *std::exchange(m_urgent, std::nullopt);
    if (m_state == State::Ready) {
        send(request, now);
        m_urgentOpen = true;
        return;
    }
    // The line is not clean: it goes out all the same, and what comes back proves nothing.
    put(encodeRequest(request).value_or(Bytes()), now);
    m_output.back().dropsEarlier = true;
    if (m_state == State::Waiting) {
        settle(now);
        if (now >= *m_unanswered + kAnswerTime + m_config.patience)
            recover(now); // urgent requests that come one after the other hide no silence
    }
    if (m_state == State::Settling && std::exchange(m_owed, kShortestAnswer) == 0)
        m_deadline = now + kAnswerTime + m_config.patience;
}

void Client::receive(ByteView bytes, TimePoint now)
{
    if (bytes.empty())
        return;
    m_stats.bytesIn += bytes.size();
    m_lastByte = now;
    if (m_state == State::Closed)
        return;
    m_suspected = m_suspected && m_state != State::Ready;
    if (!m_connected) {
        m_heard = true;
        if (hearsRefusal(bytes))
            return giveUp(now);
    }
    const bool quiet =
        (m_state == State::Connecting || m_state == State::Recovering) && m_step == Step::Silence;
    if (quiet || m_state == State::Settling) {
        m_owed -= std::min(m_owed, bytes.size());
        if (m_owed == 0)
            m_deadline = now + kSettle;
        ++m_stats.bad;
        if (now >= m_noisyUntil)
            restless(now);
        return;
    }
    while (!bytes.empty())
        accept(m_framer.next(bytes, m_frame), now);
    // Behind all that has come: none of it answers what leaves now.
    if (m_urgent && (m_state == State::Ready || m_state == State::Settling))
        leaveUrgent(now);
}

/// Whether a board of the newer protocol has refused what was sent, also where its first bytes were lost.
bool Client::hearsRefusal(ByteView bytes)
{
    for (const std::uint8_t byte : bytes) {
        m_refused = byte == kNewerRefusal[m_refused] ? m_refused + 1
            : byte == kNewerRefusal[0]               ? 1
                                                     : 0;
        if (m_refused == kNewerRefusal.size())
            return true;
    }
    return false;
}

void Client::accept(Framer::Step step, TimePoint now)
{
    if (step == Framer::Step::NeedBytes)
        return;
    const auto reply =
        step == Framer::Step::Frame ? decodeReply(m_frame) : fail(ReplyError::BadLength);
    const bool recovering = m_state == State::Connecting || m_state == State::Recovering;
    if (reply)
        m_unanswered.reset();
    if (reply && std::holds_alternative<StartNotice>(*reply)) {
        m_events.emplace_back(Restarted{});
        return;
    }
    if (!reply || m_state == State::Ready || m_state == State::Settling) {
        ++m_stats.bad;
        if (m_state == State::Ready) { // not asked for
            m_strayFrames = true;
            m_state = State::Settling;
            rest(kSettle, now);
        } else if (m_state == State::Waiting) {
            settle(now); // a damaged answer
        } // while recovering: noise
        return;
    }
    ++m_stats.framesIn;
    if (recovering)
        onReplyWhileRecovering(*reply, now);
    else if (m_state == State::Waiting)
        onReply(*reply, now);
}

void Client::onReply(const Reply &reply, TimePoint now)
{
    const auto *ack = std::get_if<Ack>(&reply);
    if (ack != nullptr && !fits(m_request->command, ack->data, m_dialect)) {
        ++m_stats.bad;
        return settle(now);
    }
    const bool urgent = std::exchange(m_urgentOpen, false);
    m_suspected = false;
    m_request.reset();
    m_state = m_strayFrames ? State::Settling : State::Ready;
    rest(kFillPause, now);
    const auto *nack = std::get_if<Nack>(&reply);
    m_stats.nacks += nack != nullptr ? 1 : 0;
    if (nack == nullptr || !wasDamaged(*nack))
        m_events.emplace_back(Answer{reply, m_asked});
    else if (!urgent)
        m_events.emplace_back(NoAnswer{false});
}

void Client::endRequest()
{
    if (!m_request)
        return;
    m_request.reset();
    if (!std::exchange(m_urgentOpen, false))
        m_events.emplace_back(NoAnswer{});
}

/// What was asked is not answered any more; the line has to come to rest.
void Client::settle(TimePoint now)
{
    endRequest();
    m_framer.reset();
    m_state = State::Settling;
    rest(kSettle, now);
    if (m_urgent)
        leaveUrgent(now);
}

void Client::silence(TimePoint now)
{
    m_step = Step::Silence;
    m_framer.reset();
    rest(kSettle, now);
}

void Client::rest(Duration howLong, TimePoint now)
{
    m_owed = 0;
    m_deadline = now + howLong;
    m_noisyUntil = now + kNoisyAtMost;
}

/// The line babbles on and on.
void Client::restless(TimePoint now)
{
    if (m_state == State::Settling && m_connected)
        return recover(now);
    giveUp(now);
}

void Client::recover(TimePoint now)
{
    ++m_stats.recoveries;
    m_round = 0;
    m_gentle = m_motorDriven;
    m_state = State::Recovering;
    silence(now);
}

void Client::fill(TimePoint now)
{
    m_step = Step::Fill;
    if (m_filled++ >= kFillBytes)
        return ask(now);
    m_deadline = now + wireTime(1, m_config.baud) + kFillPause;
    put({0xFF}, now);
}

void Client::ask(TimePoint now)
{
    m_step = Step::Ask;
    m_framer.reset();
    Bytes frame = encodeRequest({0, GetBoardInfo{}}).value_or(Bytes());
    m_deadline = now + wireTime(frame.size(), m_config.baud) + kAnswerTime + m_config.patience;
    put(std::move(frame), now);
}

void Client::askFailed(TimePoint now)
{
    if (!std::exchange(m_gentle, false) && ++m_round >= 2)
        return giveUp(now);
    m_filled = 0;
    m_framer.reset();
    fill(now);
}

void Client::giveUp(TimePoint)
{
    const bool other = m_refused == kNewerRefusal.size();
    const Lost lost{m_heard, other, !m_connected};
    m_refused = 0;
    m_state = State::Closed;
    m_connected = false;
    m_events.emplace_back(lost);
}

void Client::onReplyWhileRecovering(const Reply &reply, TimePoint now)
{
    const auto *ack = std::get_if<Ack>(&reply);
    if (m_step == Step::Fill) {
        if (ack == nullptr)
            ask(now); // what hung was refused: the next byte is a header
        return;
    }
    if (ack == nullptr)
        return askFailed(now);
    // While connecting nothing else was asked: any length will do, because the text of one dialect describes none.
    auto info = decodeBoardInfo(ack->data);
    if (!info || (m_state == State::Recovering && ack->data.size() != m_infoSize))
        return; // a late answer to what was asked before
    m_infoSize = ack->data.size();
    const bool again = std::exchange(m_connected, true);
    m_suspected = false;
    m_state = State::Settling;
    rest(m_infoSize == kInfoSize ? kFillPause : kSettle, now); // else more may be on its way
    m_events.emplace_back(Connected{std::move(*info), again});
}

void Client::answerTimeOver(TimePoint now)
{
    ++m_stats.timeouts;
    endRequest();
    recover(now);
    if (m_urgent)
        leaveUrgent(now);
}

std::optional<TimePoint> Client::suspectAt() const
{
    if (!m_connected || m_suspected || !m_unanswered || m_state == State::Ready)
        return std::nullopt;
    return std::max(*m_unanswered + kLeastOpen, m_lastByte + kSuspectAfter);
}

bool Client::asking() const
{
    return m_state == State::Waiting
        || ((m_state == State::Recovering || m_state == State::Connecting) && m_step == Step::Ask);
}

void Client::handleTimeout(TimePoint now)
{
    if (const auto at = suspectAt(); at && now >= *at) {
        m_suspected = true;
        m_events.emplace_back(Suspect{});
    }
    if (m_urgent && now >= m_urgentBy)
        return leaveUrgent(now);
    if (asking() && m_framer.midFrame() && now >= m_lastByte + kSettle) {
        ++m_stats.bad;
        m_framer.reset();
        if (m_state == State::Waiting)
            return settle(now); // it breaks off
    }
    if (now < m_deadline)
        return;
    switch (m_state) {
    case State::Closed:
    case State::Ready:
        return;
    case State::Waiting:
        return answerTimeOver(now);
    case State::Settling:
        if (m_owed > 0)
            return answerTimeOver(now);
        m_state = State::Ready;
        return;
    case State::Connecting:
    case State::Recovering:
        break;
    }
    if (m_step == Step::Silence) {
        m_filled = 0;
        m_gentle ? ask(now) : fill(now);
    } else if (m_step == Step::Fill) {
        fill(now);
    } else {
        ++m_stats.timeouts;
        askFailed(now);
    }
}

void Client::handleSent(TimePoint now)
{
    if (m_state == State::Waiting && m_lastByte <= m_asked)
        m_asked = std::max(m_asked, now);
}

std::optional<TimePoint> Client::nextTimeout() const
{
    if (m_state == State::Closed || m_state == State::Ready)
        return std::nullopt;
    TimePoint due = m_deadline;
    if (m_urgent)
        due = std::min(due, m_urgentBy);
    if (asking() && m_framer.midFrame())
        due = std::min(due, m_lastByte + kSettle);
    return std::min(due, suspectAt().value_or(due));
}

} // namespace fcp
