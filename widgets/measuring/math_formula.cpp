#include "widgets/measuring/math_formula.h"

#include "scope/formula.h"

#include <QJsonObject>

#include <algorithm>

namespace widgets {

bool isMathName(const QString &name)
{
    const auto letter = [](QChar c) {
        return (c >= QLatin1Char('a') && c <= QLatin1Char('z'))
            || (c >= QLatin1Char('A') && c <= QLatin1Char('Z')) || c == QLatin1Char('_');
    };
    const auto digit = [](QChar c) { return c >= QLatin1Char('0') && c <= QLatin1Char('9'); };
    return !name.isEmpty() && name.size() <= kLongestMathName && letter(name.front())
        && std::all_of(name.begin(), name.end(), [&](QChar c) { return letter(c) || digit(c); });
}

QJsonArray mathFormulasJson(const QList<MathFormula> &formulas)
{
    QJsonArray array;
    for (const MathFormula &formula : formulas)
        array.append(QJsonObject{{QStringLiteral("name"), formula.name},
            {QStringLiteral("formula"), formula.text}, {QStringLiteral("shown"), formula.shown}});
    return array;
}

QList<MathFormula> mathFormulasOf(const QJsonArray &json)
{
    QList<MathFormula> formulas;
    for (const auto &value : json) {
        if (formulas.size() >= kMostMathFormulas)
            break;
        const QJsonObject object = value.toObject();
        MathFormula formula;
        formula.name = object[QStringLiteral("name")].toString();
        formula.text = object[QStringLiteral("formula")].toString();
        formula.shown = object[QStringLiteral("shown")].toBool(true);
        const bool twice = std::any_of(formulas.begin(), formulas.end(),
            [&formula](const MathFormula &other) { return other.name == formula.name; });
        const bool fits = !formula.text.trimmed().isEmpty()
            && formula.text.size() <= qsizetype(scope::Formula::kMostBytes);
        if (isMathName(formula.name) && fits && !twice)
            formulas.append(formula);
    }
    return formulas;
}

} // namespace widgets
