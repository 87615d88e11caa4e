#include "widgets/forms/gain_number.h"

#include "widgets/base/setpoint_text.h"
#include "widgets/base/value_text.h"

#include <QKeyEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

constexpr qsizetype kLongest = 24;
constexpr double kFine = 1.02, kCoarse = 1.2;

} // namespace

QString significantText(double value, int digits)
{
    if (!std::isfinite(value))
        return {};
    if (value == 0.0)
        return numberText(0.0, 0);
    constexpr int kMostDecimals = 12;
    const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
    const int decimals = std::clamp(digits - 1 - magnitude, 0, kMostDecimals);
    QString text = numberText(value, decimals);
    if (decimals > 0) {
        while (text.endsWith(QLatin1Char('0')))
            text.chop(1);
        if (!text.back().isDigit())
            text.chop(1);
    }
    return text;
}

GainNumber::GainNumber(const char *name, const QString &label, const QString &unit, double least,
    double greatest, QWidget *parent)
    : QLineEdit(parent)
    , m_unit(unit)
    , m_least(least)
    , m_greatest(greatest)
{
    setObjectName(QLatin1String(name));
    setAccessibleName(unit.isEmpty() ? label : label + QLatin1String(", ") + unit);
    setAlignment(Qt::AlignRight);
    setFocusPolicy(Qt::StrongFocus);
    setMaxLength(int(kLongest));
    connect(this, &QLineEdit::textChanged, this, &GainNumber::showProblem);
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
    if (text() != shown)
        setText(shown);
    showProblem();
}

QString GainNumber::problem() const
{
    if (isEmpty())
        return {};
    const double number = m_set && text() == m_setText ? *m_set : 0.0;
    if (m_set && text() == m_setText && number >= m_least && number <= m_greatest)
        return {};
    const auto read = readPlainNumber(text(), kLongest);
    if (!read)
        return setpointErrorText(read.error());
    if (*read >= m_least && *read <= m_greatest)
        return {};
    return tr("From %1 to %2 %3.", "number number unit")
        .arg(significantText(m_least), significantText(m_greatest), m_unit);
}

void GainNumber::setBounds(double least, double greatest)
{
    m_least = least;
    m_greatest = greatest;
    showProblem();
}

void GainNumber::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Up:
        return stepBy(kFine);
    case Qt::Key_Down:
        return stepBy(1.0 / kFine);
    case Qt::Key_PageUp:
        return stepBy(kCoarse);
    case Qt::Key_PageDown:
        return stepBy(1.0 / kCoarse);
    default:
        QLineEdit::keyPressEvent(event);
    }
}

void GainNumber::wheelEvent(QWheelEvent *event)
{
    if (!hasFocus() || event->angleDelta().y() == 0)
        return event->ignore();
    stepBy(event->angleDelta().y() > 0 ? kFine : 1.0 / kFine);
    event->accept();
}

void GainNumber::stepBy(double factor)
{
    const auto now = value();
    if (!now || *now == 0.0)
        return;
    // Three digits are as fine as the steps are.
    const double digit = std::pow(10.0, std::floor(std::log10(std::abs(*now))) - 2.0);
    double next = std::round(*now * factor / digit) * digit;
    if (next == *now) // whole numbers of one digit
        next += factor > 1.0 ? digit : -digit;
    setText(significantText(std::clamp(next, m_least, m_greatest)));
    Q_EMIT valueEdited();
}

void GainNumber::showProblem()
{
    const QString sentence = problem();
    QPalette colors;
    if (!sentence.isEmpty()) {
        colors.setColor(QPalette::Base, QColor(0xff, 0x8f, 0x85));
        colors.setColor(QPalette::Text, Qt::black);
    }
    setPalette(colors);
    setAccessibleDescription(sentence);
    if (sentence.isEmpty())
        QToolTip::hideText();
    else if (isVisible() && hasFocus())
        QToolTip::showText(mapToGlobal(QPoint(0, height())), sentence.toHtmlEscaped(), this);
}

} // namespace widgets
