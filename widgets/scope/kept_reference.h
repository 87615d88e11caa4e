// KeptReference: a reference as plain values, for a workspace: of each trace the samples that stood in the picture,
// with their gaps.
#pragma once

#include "widgets/scope/drawing/marks.h"

#include <QByteArray>
#include <QJsonArray>
#include <QString>

#include <vector>

namespace widgets {

/// Samples that the references of a workspace have room for: some 2 MB of its file.
constexpr std::size_t kMostReferenceSamples = 1'000'000;

struct KeptTrace {
    catalog::RegisterId registerId = 0;
    QString name;
    QString unit;
    QByteArray samples; ///< packed; see kept_reference.cpp
    std::size_t count = 0; ///< of them
    bool operator==(const KeptTrace &) const = default;
};

struct KeptReference {
    Reference which = Reference::A;
    bool trigger = false; ///< 0 s lay at the trigger, else at the left edge
    QString moment; ///< of the recording that lies there; empty: it comes from no recording
    std::vector<KeptTrace> traces;
    bool operator==(const KeptReference &) const = default;
};

/// @param picture  what of it is kept, in seconds of its own axis
/// @param zero     the time there that becomes 0 s
/// @return         nothing if it has more than so many samples
std::vector<KeptTrace> keptTraces(
    const capture::Snapshot &kept, capture::TimeSpan picture, double zero, std::size_t most);
/// As channels of values; a trace whose samples make no sense is left out.
capture::Snapshot snapshotOf(const std::vector<KeptTrace> &traces);
QJsonArray referencesJson(const std::vector<KeptReference> &references);
/// What makes no sense, and what there is no room for, is left out.
std::vector<KeptReference> referencesOf(const QJsonArray &array);

} // namespace widgets
