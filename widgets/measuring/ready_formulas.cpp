#include "widgets/measuring/ready_formulas.h"

#include "catalog/motor_signals.h"
#include "widgets/base/device_text.h"
#include "widgets/measuring/math_formula.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <span>

namespace widgets {

namespace {

struct Ready {
    Q_DECLARE_TR_FUNCTIONS(widgets::ReadyFormulas)
};

/// As they stand in a formula, and the motor that they are of, as in "@2".
struct Found {
    QStringList names; ///< empty ones: some are missing
    std::string motor;
    bool there() const { return !names.contains(QString()); }
};

using Names = std::span<const std::string_view>;

/// Finds signals by what boards call them.
class Signals {
public:
    Signals(const std::vector<scope::FormulaName> &names, int motor)
        : m_names(names)
        , m_endings(motorEndings(motor))
        , m_chosen(motor > 0 ? m_endings.back() : std::string())
    {
    }
    /// Of each list the first that is there; all of one motor.
    Found together(std::initializer_list<Names> wanted) const
    {
        for (const std::string &ending : m_endings) {
            Found found{{}, ending};
            for (const Names one : wanted)
                found.names.append(any(one, ending));
            if (found.there())
                return found;
        }
        return {QStringList(static_cast<qsizetype>(wanted.size()), QString()), {}};
    }
    /// The first electrical angle of the chosen motor, or else its first signal in degrees or radians.
    QString angle() const { return angle(m_chosen); }
    QString angle(const std::string &motor) const
    {
        const scope::FormulaName *best = nullptr;
        for (const scope::FormulaName &one : m_names) {
            const std::string its = motorEndingOf(one.name);
            if (!its.empty() && !motor.empty() && its != motor)
                continue;
            const bool turns = one.unit == "°" || one.unit == "rad";
            const bool electrical = one.name.find(catalog::kElectricalAngle) != std::string::npos;
            if (turns
                && (!best
                    || (electrical && best->name.find(catalog::kElectrical) == std::string::npos)))
                best = &one;
        }
        return best ? inFormula(QString::fromStdString(best->name)) : QString();
    }
    QString first() const
    {
        return m_names.empty() ? QString()
                               : inFormula(QString::fromStdString(m_names.front().name));
    }

private:
    QString any(Names wanted, const std::string &ending) const
    {
        for (const std::string_view name : wanted) {
            const auto found =
                std::ranges::find(m_names, std::string(name) + ending, &scope::FormulaName::name);
            if (found != m_names.end())
                return inFormula(QString::fromStdString(found->name));
        }
        return {};
    }

    const std::vector<scope::FormulaName> &m_names;
    std::vector<std::string> m_endings;
    std::string m_chosen;
};

ReadyFormula made(
    const QString &title, const QStringList &inputs, const QString &missing, const QString &text)
{
    const bool there = !inputs.contains(QString());
    return {title, there ? text : QString(), there ? QString() : missing};
}

QString call(const char *function, const QStringList &arguments)
{
    return QLatin1String(function) + QLatin1Char('(') + arguments.join(QStringLiteral(", "))
        + QLatin1Char(')');
}

} // namespace

QString inFormula(const QString &name)
{
    const bool plain = std::all_of(name.begin(), name.end(), [](QChar c) {
        return c == QLatin1Char('.') || c == QLatin1Char('_')
            || (c.isLetterOrNumber() && c < QChar(128));
    });
    return plain && !name.isEmpty() && isMathName(name.left(1)) ? name
                                                                : QStringLiteral("[%1]").arg(name);
}

std::vector<ReadyFormula> readyFormulas(
    const std::vector<scope::FormulaName> &names, const QString &chosen, int motor)
{
    const Signals all(names, motor);
    const Found both = all.together({{&catalog::kCurrentA, 1}, {&catalog::kCurrentB, 1}});
    const QStringList &phases = both.names;
    const QString needPhases = Ready::tr("needs I_A and I_B in the recording");
    Found turned = all.together({catalog::kCurrentAlpha, catalog::kCurrentBeta});
    if (!turned.there() && both.there())
        turned = {{call("clarke_alpha", phases), call("clarke_beta", phases)}, both.motor};
    const QString angle = all.angle();
    const QString its = turned.motor.empty() ? angle : all.angle(turned.motor);
    const QStringList park = turned.names + QStringList{its};
    const QString needPark = Ready::tr("needs two phase currents and an electrical angle");
    const QStringList powers =
        all.together({Names(catalog::kVoltageD).first(1), catalog::kCurrentD,
                         Names(catalog::kVoltageQ).first(1), catalog::kCurrentQ})
            .names;
    const QString one = chosen.isEmpty() ? all.first() : inFormula(chosen);
    const QString needOne = Ready::tr("needs a signal in the recording");
    const auto ofOne = [&](const QString &title, const QString &text) {
        return made(title, {one}, needOne, text);
    };
    return {
        made(Ready::tr("Clarke: current \u03b1"), phases, needPhases, call("clarke_alpha", phases)),
        made(Ready::tr("Clarke: current \u03b2"), phases, needPhases, call("clarke_beta", phases)),
        made(Ready::tr("Park: current d"), park, needPark, call("park_d", park)),
        made(Ready::tr("Park: current q"), park, needPark, call("park_q", park)),
        made(Ready::tr("Electrical power"), powers,
            Ready::tr("needs the voltages and currents of d and q"), call("power", powers)),
        ofOne(Ready::tr("Derivative"), call("derivative", {one})),
        ofOne(Ready::tr("Integral"), call("integral", {one})),
        ofOne(Ready::tr("Low-pass, 100 Hz"), call("lowpass", {one, QStringLiteral("100")})),
        ofOne(Ready::tr("High-pass, 10 Hz"), call("highpass", {one, QStringLiteral("10")})),
        ofOne(Ready::tr("Median of 5"), call("median", {one, QStringLiteral("5")})),
        made(Ready::tr("Angle without jumps"), {angle},
            Ready::tr("needs an angle in the recording"), call("unwrap", {angle})),
    };
}

namespace {
/// It begins with a parenthesis or bracket that nothing closes.
bool isOpen(const QString &rest)
{
    if (rest.startsWith(QLatin1Char('[')))
        return !rest.contains(QLatin1Char(']'));
    return rest.startsWith(QLatin1Char('('))
        && rest.count(QLatin1Char('(')) > rest.count(QLatin1Char(')'));
}

/// A name in brackets, or what can stand without them.
QString nameAtBeginningOf(const QString &rest)
{
    static const QRegularExpression name(QStringLiteral("^(\\[[^\\]]*\\]|[A-Za-z0-9_@]+)"));
    const auto match = name.match(rest);
    return match.hasMatch() ? match.captured(0) : rest;
}

/// In the order of scope::FormulaError; %1 is what stands there.
constexpr std::array kFormulaErrors{QT_TRANSLATE_NOOP("widgets::ReadyFormulas", "No formula yet."),
    QT_TRANSLATE_NOOP("widgets::ReadyFormulas", "The formula is too long."),
    QT_TRANSLATE_NOOP("widgets::ReadyFormulas",
        "Too many parentheses inside one another, or too many functions."),
    QT_TRANSLATE_NOOP("widgets::ReadyFormulas", "This sign is not known here: %1"),
    QT_TRANSLATE_NOOP("widgets::ReadyFormulas", "This is no number: %1"),
    QT_TRANSLATE_NOOP(
        "widgets::ReadyFormulas", "No signal on the scope and no function is called %1."),
    QT_TRANSLATE_NOOP("widgets::ReadyFormulas", "The formula cannot be read from here on: %1"),
    QT_TRANSLATE_NOOP("widgets::ReadyFormulas", "The number of arguments is wrong: %1"),
    QT_TRANSLATE_NOOP("widgets::ReadyFormulas", "This has to be a number, not a signal: %1"),
    QT_TRANSLATE_NOOP("widgets::ReadyFormulas", "This number is outside what makes sense: %1"),
    QT_TRANSLATE_NOOP("widgets::ReadyFormulas", "This has to be an angle, in degrees or rad: %1")};

QString whatIsWrong(scope::FormulaError error, const QString &rest)
{
    if (error == scope::FormulaError::Syntax && rest.isEmpty())
        return Ready::tr("Something is missing at the end.");
    QString what = Ready::tr(kFormulaErrors.at(static_cast<std::size_t>(error)));
    return what.replace(QLatin1String("%1"), rest);
}

/// In characters.
qsizetype placeOf(const scope::FormulaFault &fault, const QString &formula)
{
    const QByteArray bytes = formula.toUtf8();
    return QString::fromUtf8(bytes.left(std::min(qsizetype(fault.position), bytes.size()))).size();
}
} // namespace

QString unknownName(const scope::FormulaFault &fault, const QString &formula)
{
    if (fault.error != scope::FormulaError::UnknownName)
        return {};
    const QString name = nameAtBeginningOf(formula.mid(placeOf(fault, formula)));
    const bool bracketed = name.startsWith(QLatin1Char('[')) && name.endsWith(QLatin1Char(']'));
    return bracketed ? name.mid(1, name.size() - 2) : name;
}

QString faultText(const scope::FormulaFault &fault, const QString &formula)
{
    constexpr int kShown = 24;
    const qsizetype character = placeOf(fault, formula);
    QString rest = formula.mid(character);
    if (fault.error == scope::FormulaError::UnknownName)
        rest = nameAtBeginningOf(rest);
    const QString shown =
        deviceText(rest.size() > kShown ? rest.left(kShown) + QStringLiteral("\u2026") : rest);
    const bool open = fault.error == scope::FormulaError::Syntax && isOpen(rest);
    const QString sentence = open ? Ready::tr("What opens here is not closed: %1").arg(shown)
                                  : whatIsWrong(fault.error, shown);
    if (fault.error == scope::FormulaError::Empty || rest.isEmpty())
        return sentence;
    return Ready::tr("At character %1: %2", "a place in the formula, and what is wrong there")
        .arg(QString::number(character + 1), sentence);
}

} // namespace widgets
