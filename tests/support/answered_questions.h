// Questions kept for a test, which gives the answers: no box, no window.
#pragma once

#include "widgets/base/question.h"

#include <algorithm>
#include <vector>

namespace facts {

class AnsweredQuestions : public widgets::QuestionPrompt {
public:
    std::vector<widgets::Question> open; ///< the oldest first

    void ask(const widgets::Question &question) override { open.push_back(question); }
    bool asks(const char *name) const override { return find(name) != open.end(); }
    void withdraw(const char *name) override
    {
        if (const auto found = find(name); found != open.end())
            open.erase(found);
    }

    /// Gives the answer of that text to the newest question; false if it has none such.
    bool answer(const QString &text)
    {
        if (open.empty())
            return false;
        const widgets::Question question = open.back();
        for (const widgets::Answer &one : question.answers)
            if (one.text == text) {
                open.pop_back();
                if (one.act)
                    one.act();
                return true;
            }
        return false;
    }
    /// What Enter does.
    QString usual() const { return open.back().answers[open.back().usual].text; }

private:
    std::vector<widgets::Question>::const_iterator find(const char *name) const
    {
        return std::find_if(open.begin(), open.end(), [name](const widgets::Question &question) {
            return QLatin1String(question.name) == QLatin1String(name);
        });
    }
};

} // namespace facts
