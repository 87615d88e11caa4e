// What an answer means for the request in hand, and the steps into and out of the cyclic state.
#include "mcb/master.h"

#include <algorithm>
#include <utility>

namespace mcb {
namespace {

using namespace std::chrono_literals;

constexpr int kMostTries = 3;
/// Where a frame was damaged the answer is most likely gone with it: the full time-out is not waited for.
constexpr Duration kAfterDamage = 20ms;
constexpr int kDrainAfterLoss = 4; ///< a late answer must not be taken for that of the next request
constexpr std::size_t kNoAnswerYet = 10; ///< frames; most answers come with the second one
constexpr int kDrainAfterError = 1; ///< as mcblib does

bool isError(Command command)
{
    return command == Command::ErrorOfInfo || command == Command::ErrorOfRead
        || command == Command::ErrorOfWrite;
}

/// Code 4 is a general error, too.
bool answers(Command error, Command request)
{
    return error == Command::ErrorOfInfo
        || error == (request == Command::Read ? Command::ErrorOfRead : Command::ErrorOfWrite);
}

} // namespace

void Master::begin(Request request)
{
    Operation operation;
    if (request.command == Command::Write)
        operation.pieces = fragmentsOf(request.address, Command::Write, request.words);
    else
        operation.pieces = {Frame{request.address, request.command, false, {}, {}}};
    operation.request = std::move(request);
    m_operation = std::move(operation);
}

/// What comes while the first piece goes out is left over from before, whatever it says.
void Master::onAnswer(const Exchange &exchange, const Frame &frame, TimePoint now)
{
    const Operation &operation = *m_operation;
    if (operation.sent == 0 || frame.command == Command::Idle
        || (exchange.piece && operation.sent == 1))
        return;
    if (isError(frame.command))
        return onRefusal(frame, now);
    if (frame.address != operation.request.address) {
        ++m_stats.strays;
        return;
    }
    if (!exchange.piece) // with a later piece comes the ACK of an earlier one
        onAck(frame, now);
}

void Master::onAck(const Frame &frame, TimePoint now)
{
    Operation &operation = *m_operation;
    if (operation.request.command != Command::Read)
        return end(End::Ok, now, {frame.config.begin(), frame.config.end()});
    switch (operation.gathered.add(frame)) {
    case Gatherer::Added::More:
        return;
    case Gatherer::Added::TooLong:
        return end(End::Unknown, now, {}, 0, Cause::TooLong);
    case Gatherer::Added::Whole:
        break;
    }
    if (!operation.spoilt)
        return end(End::Ok, now, operation.gathered.words());
    // A fragment may have been in the damaged frame.
    if (mayRepeat())
        repeat();
    else
        end(End::Unknown, now, {}, 0, Cause::Damaged);
}

void Master::onRefusal(const Frame &frame, TimePoint now)
{
    const Operation &operation = *m_operation;
    const std::uint32_t code = errorCodeOf(frame.config);
    const bool badCrc = code == static_cast<std::uint32_t>(ErrorCode::BadCrc);
    if (!badCrc
        && (frame.address != operation.request.address
            || !answers(frame.command, operation.request.command))) {
        ++m_stats.strays;
        return;
    }
    if (!badCrc) {
        end(End::Refused, now, {}, code);
        m_drain = kDrainAfterError;
        return;
    }
    // Which frame did it see? Surely the request, if there was no other one since.
    const bool ofRequest = operation.pieces.size() == 1 && operation.exchanges == 1;
    if (operation.tries < kMostTries
        && (ofRequest || operation.request.command != Command::Write
            || operation.request.repeatable))
        return repeat();
    end(ofRequest ? End::NotSent : End::Unknown, now, {}, code, Cause::Damaged);
    m_drain = kDrainAfterLoss;
}

void Master::spoil(TimePoint now)
{
    m_operation->spoilt = true;
    m_operation->deadline = std::min(
        m_operation->deadline.value_or(TimePoint::max()), now + kAfterDamage + m_config.patience);
}

bool Master::mayRepeat() const
{
    return m_operation->tries < kMostTries
        && (m_operation->request.command != Command::Write || m_operation->request.repeatable);
}

void Master::repeat()
{
    const int tries = m_operation->tries + 1;
    begin(m_operation->request);
    m_operation->tries = tries;
    m_drain = kDrainAfterLoss;
}

bool Master::recall(TimePoint now)
{
    if (!m_operation || m_way != Way::None)
        return false;
    if (m_operation->sent > 0) {
        m_operation->tries = kMostTries;
        return false;
    }
    end(End::NotSent, now, {}, 0, Cause::Cancelled);
    return true;
}

/// It has waited for the drive to be ready, or for its turn, until it is not expected any more.
bool Master::isLate(TimePoint now) const
{
    return m_operation && m_operation->sent == 0 && m_operation->request.leaveBy
        && now >= *m_operation->request.leaveBy;
}

/// Behind a byte stream a slave can be out of step by a byte too many. Then it takes no request, a Stop neither, and
/// yet what it answers are idle frames whose check is right. It drops what it holds where nothing comes for a while.
void Master::hush(TimePoint now)
{
    if (!m_hasLine && m_operation->exchanges >= kNoAnswerYet)
        m_notBefore = std::max(m_notBefore, now + m_config.quiet);
}

/// No answer came: it is asked for again where that does no harm.
void Master::giveUp(Cause cause, TimePoint now)
{
    const Request &request = m_operation->request;
    hush(now);
    if (request.command == Command::Write && request.address == kStateRegister) {
        m_doubtful = request;
        return seek(now);
    }
    if (mayRepeat())
        return repeat();
    end(End::Unknown, now, {}, 0, cause);
    m_drain = kDrainAfterLoss;
}

void Master::end(End end, TimePoint now, Words words, std::uint32_t code, Cause cause)
{
    Done done{std::move(m_operation->request), end, std::move(words), code, cause};
    m_operation.reset();
    if (end == End::Ok && done.request.command == Command::Write
        && done.request.address == kStateRegister && !done.request.words.empty())
        switched(done.request.words.front(), now);
    if (m_way == Way::None)
        m_events.emplace_back(std::move(done));
    else
        nextStep(std::move(done), now);
}

void Master::nextStep(Done done, TimePoint now)
{
    const bool more = done.end == End::Ok && ++m_step < m_steps.size();
    if (more && m_cancelled) {
        done.end = End::Unknown;
        done.cause = Cause::Cancelled;
    } else if (more) {
        begin({Command::Write, m_steps[m_step].address, m_steps[m_step].words, true});
        return;
    }
    const Way way = std::exchange(m_way, Way::None);
    m_steps.clear();
    if (way != Way::Leave) {
        m_events.emplace_back(std::move(done));
    } else if (done.end != End::Ok) {
        lose(Cause::NoAnswer, now);
    } else {
        meet();
    }
}

/// The frame behind the ACK has the new length.
void Master::switched(std::uint16_t state, TimePoint now)
{
    if (state == kCyclicState && m_way == Way::On) {
        m_state = State::Cyclic;
        m_words = m_mapping.words();
        m_cycleStart = now;
        m_nextTick = 0;
        m_leaving = false;
    } else {
        m_state = State::Config;
        m_words = 0;
    }
}

} // namespace mcb
