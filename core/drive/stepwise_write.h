// A list of writes, one register after the other, each by its own steps: questions, the value before, the write, the
// value after. A write whose answer was lost is not sent again: what is read back decides.
#pragma once

#include "drive/reader.h"
#include "drive/write_task.h"

namespace drive {

/// @tparam P  with endIn(answer): how it ends what was asked
template <class P>
class StepwiseWrite : public WriteTask<P> {
public:
    using Request = typename P::Request;
    using Answer = typename P::Answer;
    using WriteTask<P>::WriteTask;

    std::optional<Request> nextRequest(TimePoint now) override;
    void onResponse(const Answer &answer, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

protected:
    /// Adds the steps of a register, without the last. @return  why it must not be written; empty if it may
    virtual std::string plan(const RegisterWrite &write) = 0;
    void ask(Request question) { m_steps.push_back({Kind::Ask, std::move(question)}); }
    void readBefore() { m_steps.push_back({Kind::Before, {}}); }
    void write(Request request) { m_steps.push_back({Kind::Write, std::move(request)}); }

    /// Why this answer to a question of the plan forbids the write; empty if it does not.
    virtual std::string judgeAnswer(const Request &, const Answer &) { return {}; }
    virtual std::string reasonWithout(const Request &) const { return {}; } ///< an answer to it
    /// A write that the board has certainly not carried out goes out once more.
    virtual bool repeats() const { return false; }
    /// An acknowledged write counts as done before it is read back.
    virtual bool acknowledgementCounts() const { return true; }

private:
    using typename WriteTask<P>::Item;
    using typename WriteTask<P>::State;
    enum class Kind : std::uint8_t { Ask, Before, Write, After };
    struct Step {
        Kind kind;
        Request request;
    };

    bool replaceable(const Item &item) const override
    {
        const bool atWork = !m_steps.empty() && &item == &this->m_items[m_at];
        return item.state == State::Waiting && !atWork;
    }
    Item &current() { return this->m_items[m_at]; }
    void begin(TimePoint now);
    void enter(std::size_t step);
    void advance()
    {
        if (m_step + 1 < m_steps.size())
            return enter(m_step + 1);
        if (current().state != State::Doubtful)
            this->endItem(current(), Outcome::Ok);
        next();
    }
    void close(Outcome outcome, const std::string &reason)
    {
        this->endItem(current(), outcome, reason);
        next();
    }
    void next()
    {
        m_steps.clear();
        ++m_at;
    }

    std::size_t m_at = 0, m_step = 0; ///< the register at work, and its step
    std::vector<Step> m_steps; ///< empty: not planned yet
    Reader<P> m_reader{this->m_board};
};

template <class P>
void StepwiseWrite<P>::begin(TimePoint now)
{
    if (current().state == State::Done)
        return next(); // a newer write has taken its place
    if (auto why = plan(current().write); !why.empty())
        return close(Outcome::Refused, why);
    m_steps.push_back({Kind::After, {}});
    this->recall(current(), now);
    enter(0);
}

template <class P>
void StepwiseWrite<P>::enter(std::size_t step)
{
    m_step = step;
    const Kind kind = m_steps[step].kind;
    if (kind != Kind::Before && kind != Kind::After)
        return;
    const auto *info = this->m_board.catalog->find(current().write.id);
    const bool known = kind == Kind::Before && current().result.before;
    const bool asks = info != nullptr && info->readable() && !known;
    m_reader.start(asks ? std::vector{current().write.id} : std::vector<RegisterId>());
}

template <class P>
std::optional<typename P::Request> StepwiseWrite<P>::nextRequest(TimePoint now)
{
    while (!this->finished()) {
        if (m_at >= this->m_items.size()) {
            this->finish();
        } else if (m_steps.empty()) {
            begin(now);
        } else if (const Step &step = m_steps[m_step]; step.kind == Kind::Ask) {
            return step.request;
        } else if (step.kind == Kind::Write) {
            this->markSent();
            current().state = State::Open;
            return step.request;
        } else if (!m_reader.finished()) {
            return m_reader.nextRequest();
        } else {
            advance();
        }
    }
    return std::nullopt;
}

template <class P>
void StepwiseWrite<P>::onResponse(const Answer &answer, TimePoint now)
{
    if (this->finished() || m_steps.empty())
        return;
    const Step &step = m_steps[m_step];
    WriteResult &result = current().result;
    switch (step.kind) {
    case Kind::Ask:
        if (auto why = judgeAnswer(step.request, answer); !why.empty())
            return close(Outcome::Refused, why);
        return advance();
    case Kind::Write:
        if (const AnswerEnd said = P::endIn(answer); said.outcome != Outcome::Ok)
            return close(said.outcome, said.reason);
        current().repeated = false;
        advance();
        if (m_steps[m_step].kind == Kind::After && acknowledgementCounts())
            this->endItem(current(), Outcome::Ok);
        return;
    case Kind::Before:
    case Kind::After:
        for (Reading &reading : m_reader.onResponse(answer, now)) {
            if (reading.status == ReadStatus::Ok)
                (step.kind == Kind::Before ? result.before : result.readBack) = reading.value;
            this->tell(std::move(reading));
        }
        if (m_reader.finished())
            advance();
    }
}

template <class P>
void StepwiseWrite<P>::onNoResponse(std::optional<bool> executed, TimePoint)
{
    if (this->finished() || m_steps.empty())
        return;
    const Step &step = m_steps[m_step];
    if (step.kind == Kind::Ask)
        return close(Outcome::NotSent, kNoAnswer + reasonWithout(step.request));
    if (step.kind != Kind::Write) {
        m_reader.onNoResponse();
        if (m_reader.finished())
            advance();
        return;
    }
    if (executed == false) {
        if (!repeats())
            return close(Outcome::NotSent, kNoAnswer);
        if (!std::exchange(current().repeated, true))
            return;
    }
    current().state = State::Doubtful;
    enter(m_steps.size() - 1);
}

} // namespace drive
