// What the program prints: text for people or JSON for programs on standard output, one line of error on standard
// error. Whatever a board or a file wrote into these words, a terminal is given no control character of it. And how a
// run ends.
#pragma once

#include "base/result.h"

#include <QFile>
#include <QJsonValue>
#include <QString>

#include <optional>

namespace cli {

/// How a run of the program ends. Scripts depend on these numbers.
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

class Output {
public:
    explicit Output(bool json);

    bool json() const { return m_json; }
    void line(const QString &text); ///< one line, whatever is in it
    void line(const QJsonValue &value); ///< an object or an array, in one line
    void json(const QByteArray &text); ///< finished JSON, in one line
    void ownText(const QString &text); ///< lines of the program itself: help and version
    /// False if something could not be written, say because a disk is full.
    bool flush();

    static void error(const QString &sentence);

private:
    void write(QByteArray line);

    QFile m_file;
    bool m_json;
    bool m_ok = true;
};

/// null for what is not known.
template <class T>
QJsonValue orNull(const std::optional<T> &value)
{
    return value ? QJsonValue(*value) : QJsonValue();
}

/// Shortest text that is the same number again, with a point.
QString numberText(double number);

} // namespace cli
