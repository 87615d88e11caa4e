// Options of the commands about recordings: show and export.
#pragma once

#include "failure.h"

#include <QStringList>

#include <optional>

class QCommandLineParser;

namespace cli {

struct RecordingArguments {
    QString file; ///< export: what to write; its ending says the format
    QStringList only; ///< names of signals; empty: all
    std::optional<double> from, to; ///< seconds of the session
    bool continental = false; ///< CSV for spreadsheets with a decimal comma
    bool events = false; ///< show: line by line
};

void addRecordingOptions(QCommandLineParser &parser, const QString &command);

Outcome<RecordingArguments> recordingOf(const QCommandLineParser &parser, const QString &command);

} // namespace cli
