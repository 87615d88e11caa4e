// Formulas that engineers want most, filled in with the signals that are there.
#pragma once

#include "scope/formula.h"

#include <QString>

#include <vector>

namespace widgets {

struct ReadyFormula {
    QString title;
    QString text; ///< empty: `missing` says what it needs
    QString missing;
};

/// @param names   that a formula may use
/// @param chosen  the signal that those of one signal are filled with; else the first of `names`
/// @param motor   whose signals those of several are filled with; 0: of any, but all of one
std::vector<ReadyFormula> readyFormulas(
    const std::vector<scope::FormulaName> &names, const QString &chosen, int motor);

/// A name as it stands in a formula: in brackets if it has to be.
QString inFormula(const QString &name);

/// What is wrong with a formula and where, in words.
QString faultText(const scope::FormulaFault &fault, const QString &formula);

} // namespace widgets
