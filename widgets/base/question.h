// Asking what is to be done, so that tests can give the answer: a question as a value, with what each answer does. Esc
// is the answer that stays.
#pragma once

#include <QList>
#include <QString>

#include <cstdint>
#include <functional>

class QWidget;

namespace widgets {

struct Answer {
    enum class Kind : std::uint8_t {
        Go,
        Force, ///< what the question warns of
        Lose, ///< something goes that cannot be brought back: Enter does not do it even where it has the focus
        Stay, ///< without a text: Cancel
    };
    Kind kind = Kind::Stay;
    QString text{};
    std::function<void()> act{};
    const char *name = ""; ///< its button's
};

struct Question {
    const char *name = ""; ///< its box's
    QString title;
    QString text;
    QString more;
    QList<Answer> answers;
    qsizetype usual = 0; ///< what Enter does
};

class QuestionPrompt {
public:
    virtual ~QuestionPrompt() = default;
    virtual void ask(const Question &question) = 0;
    virtual bool asks(const char *name) const = 0; ///< it waits for its answer
    virtual void withdraw(const char *name) = 0; ///< there is nothing to be asked any more
};

/// In boxes over a window, which outlives it.
class QuestionBoxes : public QuestionPrompt {
public:
    explicit QuestionBoxes(QWidget &window)
        : m_window(window)
    {
    }
    void ask(const Question &question) override;
    bool asks(const char *name) const override;
    void withdraw(const char *name) override;

private:
    QWidget &m_window;
};

} // namespace widgets
