// A formula that the user has named, to be computed as a channel of the scope, as it is kept between two runs.
#pragma once

#include <QJsonArray>
#include <QList>
#include <QString>

namespace widgets {

struct MathFormula {
    QString name;
    QString text;
    bool shown = true; ///< drawn; computed either way
    bool operator==(const MathFormula &) const = default;
};

constexpr qsizetype kMostMathFormulas = 16;
constexpr qsizetype kLongestMathName = 40;

/// Letters of A to Z, digits and _, no digit first: what a formula may use without brackets.
bool isMathName(const QString &name);

QJsonArray mathFormulasJson(const QList<MathFormula> &formulas);
/// What has no name or no text, or the name of one before it, is left out.
QList<MathFormula> mathFormulasOf(const QJsonArray &json);

} // namespace widgets
