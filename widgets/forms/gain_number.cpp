#include "widgets/forms/gain_number.h"

#include "widgets/base/setpoint_text.h"
#include "widgets/base/si_text.h"

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

constexpr qsizetype kLongest = 24;
constexpr double kFine = 1.02, kCoarse = 1.2;

} // namespace

QString significantText(double value, int digits)
{
    return std::isfinite(value) ? plainNumberText(value, digits) : QString();
}

GainNumber::GainNumber(const char *name, const QString &label, const QString &unit, double least,
    double greatest, QWidget *parent)
    : SteppedEdit(parent)
    , m_unit(unit)
    , m_least(least)
    , m_greatest(greatest)
{
    setObjectName(QLatin1String(name));
    setAccessibleName(unit.isEmpty() ? label : label + QLatin1String(", ") + unit);
    setMaxLength(int(kLongest));
    connect(this, &QLineEdit::textChanged, this, [this] { showProblem(); });
    connect(this, &QLineEdit::textEdited, this, &GainNumber::valueEdited);
}

std::optional<double> GainNumber::value() const
{
    if (m_set && text() == m_setText)
        return m_set;
    const auto read = readPlainNumber(text(), kLongest);
    if (!read || !(*read >= m_least && *read <= m_greatest))
        return {};
    return *read;
}

void GainNumber::setValue(std::optional<double> value)
{
    const bool good = value && std::isfinite(*value);
    const QString shown = good ? significantText(*value) : QString();
    m_set = good ? value : std::nullopt;
    m_setText = shown;
    setFollowed(shown);
    showProblem();
}

QString GainNumber::problem() const
{
    const auto fits = [this](double number) { return number >= m_least && number <= m_greatest; };
    const auto number = value();
    if (isEmpty() || (number && fits(*number)))
        return {};
    const auto read = readPlainNumber(text(), kLongest);
    if (!read)
        return setpointErrorText(read.error());
    if (fits(*read)) // rounded; the number that was set is outside
        return {};
    return tr("From %1 to %2 %3.", "number number unit")
        .arg(significantText(m_least), significantText(m_greatest), m_unit);
}

void GainNumber::stepBy(int steps)
{
    const auto now = value();
    if (!now || *now == 0.0)
        return;
    const double size = std::abs(steps) > 1 ? kCoarse : kFine;
    const double factor = steps > 0 ? size : 1.0 / size;
    // Three digits are as fine as the steps are.
    const double digit = std::pow(10.0, std::floor(std::log10(std::abs(*now))) - 2.0);
    double next = std::round(*now * factor / digit) * digit;
    if (next == *now) // whole numbers of one digit
        next += factor > 1.0 ? digit : -digit;
    setFollowed(significantText(std::clamp(next, m_least, m_greatest)));
    Q_EMIT valueEdited();
}

} // namespace widgets
