// One run of a run book as its own file has it (docs/run-book.md), and where its files are.
#pragma once

#include "base/result.h"

#include <QByteArray>
#include <QJsonObject>
#include <QMap>
#include <QString>
#include <QStringList>

#include <utility>

namespace session {

constexpr const char *kStretch = "stretch"; ///< instead of a plan's name: part of a recording

struct Run {
    int number = 0; ///< from 1
    qint64 at = 0; ///< UTC since 1970, seconds: when it ended
    QString board; ///< its firmware
    QString motorName;
    int motor = 1;
    /// As a recording names its plan, e.g. "step plan"; kStretch: part of a recording.
    QString experiment;
    QList<std::pair<QString, QString>> plan; ///< its fields as the recording has them
    QString end; ///< "complete", "refused", "aborted", "interrupted", "lost"
    QString reason;
    QMap<QString, double> gains; ///< registers of the motor, digits
    bool registers = false; ///< they are in a file
    QJsonObject result; ///< as `rotorscope-cli evaluate --json --run 1` has it; empty: none
    QStringList notes; ///< what has to be known of the result; the first says why there is none
    QString note; ///< the user's
    bool starred = false;
    bool operator==(const Run &) const = default;
};

QString recordingOf(const QString &folder, int number);
QString registersOf(const QString &folder, int number);
QString runFileOf(const QString &folder, int number);
/// Of files of such a name; 0: it is another one's.
int runNumberOf(const QString &fileName);

QByteArray runJson(const Run &run);
/// Without its number. Or why it is none.
Result<Run, QString> readRunJson(const QByteArray &json);

} // namespace session
