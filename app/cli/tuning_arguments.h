// Options of the commands that compare, restore and compute tuning.
#pragma once

#include "failure.h"

#include <QStringList>

class QCommandLineParser;

namespace cli {

struct TuningArguments {
    QString file; ///< -o of snapshot and header
    QStringList only; ///< groups and registers; empty: all
    bool all = false; ///< diff: measured registers too
    bool force = false; ///< restore: on other hardware, too
    bool device = false; ///< diff: one side is the board
};

/// The word of `diff` that means the board instead of a file.
inline bool isDevice(const QString &word) { return word == QLatin1String("device"); }

void addTuningOptions(QCommandLineParser &parser, const QString &command);

/// @param words  the command's own
Outcome<TuningArguments> tuningOf(
    const QCommandLineParser &parser, const QString &command, const QStringList &words);

} // namespace cli
