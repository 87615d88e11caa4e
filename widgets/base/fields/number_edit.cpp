#include "widgets/base/fields/number_edit.h"

#include "widgets/base/setpoint_text.h"
#include "widgets/base/si_text.h"
#include "widgets/base/value_text.h"

#include <QKeyEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

constexpr int kTypedDigits = 9;
constexpr int kMostStepless = 24; ///< characters
constexpr double kFineNotch = 1.02, kCoarseNotch = 1.2;

Result<double, SetpointError> readNumber(const QString &text, bool stepless)
{
    return stepless ? readPlainNumber(text, kMostStepless) : readSetpoint(text);
}

} // namespace

NumberEdit::NumberEdit(QWidget *parent)
    : SteppedEdit(parent)
{
    setText(QStringLiteral("0"));
    connect(this, &QLineEdit::textChanged, this, &NumberEdit::echoChanged);
    connect(this, &QLineEdit::textEdited, this, &NumberEdit::showProblem);
    connect(this, &QLineEdit::textEdited, this, &NumberEdit::valueEdited);
    connect(this, &NumberEdit::echoChanged, this, [this] {
        if (problem().isEmpty())
            showProblem();
    });
}

NumberEdit::NumberEdit(const char *name, const QString &label, const QString &unit, double least,
    double greatest, QWidget *parent)
    : NumberEdit(parent)
{
    setObjectName(QLatin1String(name));
    setAccessibleName(unit.isEmpty() ? label : label + QLatin1String(", ") + unit);
    setMaxLength(kMostStepless);
    setRange(least, greatest, 0.0, unit);
    setWheelAllowed(true);
    setText({}); // clear() could be undone, and Undo would be the field's
}

void NumberEdit::setRange(double least, double greatest, double step, const QString &unit)
{
    m_least = least;
    m_greatest = greatest;
    m_step = step;
    m_unit = unit;
    Q_EMIT echoChanged();
}

std::optional<double> NumberEdit::value() const
{
    if (stepless() && m_set && text() == m_setText)
        return m_set;
    const auto read = readNumber(text(), stepless());
    return read && holds(*read) ? std::optional(*read) : std::nullopt;
}

double NumberEdit::inside(double value) const
{
    return std::clamp(value, std::ceil(m_least / m_step) * m_step,
               std::floor(m_greatest / m_step) * m_step)
        + 0.0;
}

std::optional<double> NumberEdit::sentValue() const
{
    const auto typed = value();
    return stepless() || !typed ? typed : inside(std::round(*typed / m_step) * m_step);
}

QString NumberEdit::textOf(double value) const
{
    return stepless() ? significantText(value) : numberText(value, decimalsFor(m_step));
}

void NumberEdit::setValue(std::optional<double> value)
{
    const bool number = value && std::isfinite(*value);
    if (!number && !stepless())
        return;
    m_set = number ? value : std::nullopt;
    m_setText = number ? textOf(*value) : QString();
    setFollowed(m_setText);
    setModified(false);
    if (stepless())
        showProblem();
}

void NumberEdit::beginAnew()
{
    setValue(0.0);
    if (focusIsIn(*this))
        selectAll();
}

QString NumberEdit::wrong() const
{
    const auto read = readNumber(text(), stepless());
    if (!read)
        return setpointErrorText(read.error());
    if (holds(*read))
        return {};
    if (stepless())
        return tr("From %1 to %2 %3.", "number number unit")
            .arg(textOf(m_least), textOf(m_greatest), m_unit);
    if (*read < 0.0 && m_least == 0.0)
        return tr("It cannot be negative.");
    return tr("The limit is %1 %2.", "number unit").arg(textOf(m_greatest), m_unit);
}

QString NumberEdit::problem() const { return text().trimmed().isEmpty() ? QString() : wrong(); }

QString NumberEdit::echo() const
{
    if (const QString why = wrong(); !why.isEmpty())
        return why;
    const double typed = *value(), sent = *sentValue();
    if (sent == typed)
        return tr("= %1 %2", "number unit").arg(textOf(sent), m_unit);
    return tr("%1 becomes %2 %3 (steps of %4)", "typed number, sent number, unit, step")
        .arg(plainNumberText(typed, kTypedDigits), textOf(sent), m_unit, textOf(m_step));
}

void NumberEdit::keyPressEvent(QKeyEvent *event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    // Ctrl+Enter starts the motor: not ours.
    if (!enter || stepless() || (event->modifiers() & Qt::ControlModifier))
        return SteppedEdit::keyPressEvent(event);
    event->accept();
    const auto sent = sentValue();
    if (!sent)
        QToolTip::showText(mapToGlobal(QPoint(0, height())), echo().toHtmlEscaped(), this);
    else if (!event->isAutoRepeat())
        Q_EMIT committed(*sent);
}

void NumberEdit::stepBy(int steps)
{
    const auto from = sentValue();
    if (!from || (stepless() && *from == 0.0))
        return;
    if (stepless()) {
        const double notch = std::abs(steps) > 1 ? kCoarseNotch : kFineNotch;
        const double factor = steps > 0 ? notch : 1.0 / notch;
        // Three digits are as fine as the steps are.
        const double digit = std::pow(10.0, std::floor(std::log10(std::abs(*from))) - 2.0);
        double next = std::round(*from * factor / digit) * digit;
        if (next == *from) // whole numbers of one digit
            next += factor > 1.0 ? digit : -digit;
        setFollowed(textOf(std::clamp(next, m_least, m_greatest)));
    } else {
        setValue(inside(*from + steps * std::max(m_step, m_notch)));
    }
    Q_EMIT valueEdited();
}

} // namespace widgets
