// How session's texts of problems are put into words: English, which the window translates piece by piece.
#pragma once

#include <QString>

namespace session {

using ProblemWords = QString (*)(const char *english);
inline QString englishWords(const char *english) { return QString::fromUtf8(english); }

} // namespace session
