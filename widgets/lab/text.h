// What core says of an experiment, in the user's language: why it was not carried out, what ended it, what has to be
// known of its result. Its words are English sentences with numbers and names in them, several of them with semicolons
// between.
#pragma once

#include <QStringList>

#include <string>
#include <vector>

namespace lab {
struct Outcome;
}

namespace widgets {

/// The words as they stand within a sentence; those without a translation stay English.
QString labText(const std::string &words);

/// The same as a sentence: begins with a capital, ends with a full stop.
QString labSentence(const std::string &words);
QStringList labSentences(const std::vector<std::string> &all);

/// How an experiment ended: a sentence, or two.
QString endText(const lab::Outcome &outcome);

} // namespace widgets
