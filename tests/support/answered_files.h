// File names for code that asks for one: those of the test.
#pragma once

#include "widgets/base/file_prompt.h"

namespace facts {

/// Answers every question for a file name with `answer`; an empty one gives up.
class AnsweredPrompt : public widgets::FilePrompt {
public:
    QString answer;
    widgets::SaveQuestion asked;

    void askSave(QWidget *, const widgets::SaveQuestion &question, Answer done) override
    {
        asked = question;
        if (!answer.isEmpty())
            done(answer);
    }
    void askOpen(QWidget *, const widgets::OpenQuestion &, Answer done) override
    {
        if (!answer.isEmpty())
            done(answer);
    }
    void askFolder(QWidget *, const widgets::FolderQuestion &, Answer done) override
    {
        if (!answer.isEmpty())
            done(answer);
    }
};

} // namespace facts
