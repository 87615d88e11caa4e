// Options of the commands that compare, restore and compute tuning.
#pragma once

#include "failure.h"

#include <QStringList>

#include <optional>

class QCommandLineParser;

namespace cli {

struct TuningArguments {
    QString file; ///< -o of snapshot, header and motor
    QStringList only; ///< groups and registers; empty: all
    bool all = false; ///< diff: measured registers too
    bool force = false; ///< restore: on other hardware, too
    bool device = false; ///< diff: one side is the board
    bool set = false; ///< revup: the words are to be written
    bool apply = false; ///< gains: write them
    double bandwidth_radps = 0.0; ///< gains
    double damping = 0.0; ///< gains: of the speed loop; 0: leave it alone
    double inertia_kgm2 = 0.0; ///< gains; 0: the board has to say
    double ke_vrmsPerKrpm = 0.0; ///< gains; 0: the board has to say
    std::optional<double> speedDelay_s; ///< gains; empty: what the board's sensor usually has
    double amps = 0.0; ///< torque
    int milliseconds = 0; ///< torque
};

/// The word of `diff` that means the board instead of a file.
inline bool isDevice(const QString &word) { return word == QLatin1String("device"); }

/// A number with a point, no more and no less than the whole word; empty if it is none, or not finite.
std::optional<double> plainNumber(const QString &text);

void addTuningOptions(QCommandLineParser &parser, const QString &command);

/// @param words  the command's own
Outcome<TuningArguments> tuningOf(
    const QCommandLineParser &parser, const QString &command, const QStringList &words);

} // namespace cli
