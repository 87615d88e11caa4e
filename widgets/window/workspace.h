// A workspace: what the user has set up to work with, as plain values: which signals are where, how long the picture
// is, the ranges of axes, the trigger, what is measured and computed, references, colours, notes, where the docks are.
// As text in JSON it is a file of its own, and the last one is among the settings. Names stand for registers, so that
// it suits each board that has them.
#pragma once

#include "base/result.h"
#include "widgets/measuring/math_formula.h"
#include "widgets/measuring/measure_text.h"
#include "widgets/scope/drawing/marks.h"
#include "widgets/scope/kept_reference.h"
#include "widgets/scope/signals/channel_plan.h"
#include "widgets/scope/trigger/setup.h"

#include <QByteArray>
#include <QJsonObject>
#include <QList>
#include <QMap>
#include <QString>

namespace widgets {

struct Workspace {
    std::vector<NamedSignal> signalList; ///< empty: those of a first look
    unsigned fastEvery = 1; ///< control periods a sample
    double span = 5.0; ///< seconds that a picture shows that rolls
    TriggerSetup trigger;
    QString triggerSource; ///< name of a signal
    QList<NamedMeasure> measures;
    QList<MathFormula> formulas;
    QMap<QString, ValueRange> axes; ///< that were set by hand, by the name of a signal on each
    std::vector<KeptReference> references;
    QMap<QString, int> traceColors; ///< slots that the user chose, by the names of signals
    QString notes;
    QByteArray layout; ///< of the docks, as Qt saves it
    bool operator==(const Workspace &) const = default;
};

constexpr qsizetype kLongestNotes = 100'000;

QJsonObject workspaceJson(const Workspace &workspace);
/// Fields that are missing or make no sense keep their defaults.
Workspace workspaceOf(const QJsonObject &object);

QByteArray toJson(const Workspace &workspace); ///< a file
/// The workspace, or what is wrong with the file, to be shown. What is missing keeps its default, keys that are not
/// known are passed over; a value that cannot be is named by its place.
Result<Workspace, QString> readWorkspace(const QByteArray &json);

} // namespace widgets
