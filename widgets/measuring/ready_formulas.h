// Formulas that engineers want most, filled in with the signals that are there.
#pragma once

#include "scope/formula.h"

#include <QString>

#include <functional>
#include <string>
#include <vector>

namespace widgets {

// Names of a motor's signals: a board with several motors has the motor behind them, as in I_A@2.

/// The motor whose signals are meant; 0 where a file is shown, which says nothing about what is chosen.
using ChosenMotor = std::function<int()>;

/// What may stand behind the names of one motor's signals: nothing where there is but one, else the chosen motor; for a
/// file any, the lowest first.
inline std::vector<std::string> motorEndings(int chosen)
{
    constexpr int kMostMotors = 7;
    std::vector<std::string> endings{""};
    for (int motor = 1; motor <= kMostMotors; ++motor)
        if (chosen == 0 || chosen == motor)
            endings.push_back("@" + std::to_string(motor));
    return endings;
}

/// "@2" of "I_A@2"; empty if there is none.
inline std::string motorEndingOf(const std::string &name)
{
    const std::size_t at = name.rfind('@');
    return at == std::string::npos ? std::string() : name.substr(at);
}

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
/// The name that is not known, without brackets; empty: that is not what is wrong.
QString unknownName(const scope::FormulaFault &fault, const QString &formula);

} // namespace widgets
