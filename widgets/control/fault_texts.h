// What a fault means, what usually causes it and what to try, the likeliest first. The ranking follows what users of
// such drives found in the end; nothing here looks at the board.
#pragma once

#include "catalog/names.h"
#include "drive/event.h"

#include <QStringList>

namespace widgets {

struct FaultText {
    QString meaning; ///< one sentence
    struct Cause {
        QString cause; ///< what it may be
        QString remedy; ///< what to try
    };
    QList<Cause> causes; ///< the likeliest first
};

FaultText faultText(catalog::FaultKind kind);
/// Faults that are over and wait to be acknowledged: one that is still present is told as present, and not twice.
std::vector<std::string> faultsOver(const drive::MotorStatus &status);

} // namespace widgets
