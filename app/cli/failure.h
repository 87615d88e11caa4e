// How a run of the program ends. Scripts depend on these numbers.
#pragma once

#include "base/result.h"

#include <QString>

namespace cli {

enum ExitStatus : int {
    kDone = 0,
    kRefused = 1, ///< by the board
    kUsage = 2,
    kNoConnection = 3,
    kDataLost = 4,
    kFileError = 5,
    kAborted = 6, ///< what moved a motor by itself was stopped by its envelope
    kInterrupted = 128, ///< plus the number of the signal, as a shell counts
};

/// Why a run ends early, and one sentence that says what to do about it. Plain English, one line.
struct Failure {
    int status = kRefused;
    QString sentence;
};

template <class T>
using Outcome = Result<T, Failure>;

inline auto failure(int status, const QString &sentence) { return fail(Failure{status, sentence}); }

} // namespace cli
