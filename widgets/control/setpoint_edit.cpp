#include "widgets/control/setpoint_edit.h"

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

} // namespace

SetpointEdit::SetpointEdit(QWidget *parent)
    : SteppedEdit(parent)
{
    setText(QStringLiteral("0"));
    connect(this, &QLineEdit::textChanged, this, &SetpointEdit::echoChanged);
    connect(this, &QLineEdit::textEdited, this, &SetpointEdit::showProblem);
    connect(this, &SetpointEdit::echoChanged, this, [this] {
        if (problem().isEmpty())
            showProblem();
    });
}

QString SetpointEdit::problem() const { return text().isEmpty() || value() ? QString() : echo(); }

void SetpointEdit::setLimits(double limit, double step, const QString &unit)
{
    m_limit = limit;
    m_step = step;
    m_unit = unit;
    Q_EMIT echoChanged();
}

void SetpointEdit::setNegativeAllowed(bool allowed)
{
    m_negativeAllowed = allowed;
    Q_EMIT echoChanged();
}

double SetpointEdit::least() const
{
    return m_negativeAllowed ? -std::floor(m_limit / m_step) * m_step : 0.0;
}

std::optional<double> SetpointEdit::value() const
{
    const auto read = readSetpoint(text());
    if (!read || std::abs(*read) > m_limit || (*read < 0.0 && !m_negativeAllowed))
        return {};
    return *read;
}

std::optional<double> SetpointEdit::sentValue() const
{
    const auto typed = value();
    if (!typed)
        return {};
    const double inside = std::floor(m_limit / m_step) * m_step;
    const double rounded = std::round(*typed / m_step) * m_step;
    return std::clamp(rounded, least(), inside) + 0.0;
}

void SetpointEdit::setValue(double value)
{
    if (!std::isfinite(value))
        return;
    setFollowed(numberText(value, decimalsFor(m_step)));
    setModified(false);
}

void SetpointEdit::beginAnew()
{
    setValue(0.0);
    if (focusIsIn(*this))
        selectAll();
}

QString SetpointEdit::echo() const
{
    const auto read = readSetpoint(text());
    if (!read)
        return setpointErrorText(read.error());
    if (*read < 0.0 && !m_negativeAllowed)
        return tr("It cannot be negative.");
    if (std::abs(*read) > m_limit)
        return tr("The limit is %1 %2.", "number unit")
            .arg(numberText(m_limit, decimalsFor(m_step)), m_unit);
    const QString sent = numberText(*sentValue(), decimalsFor(m_step));
    if (*sentValue() == *read)
        return tr("= %1 %2", "number unit").arg(sent, m_unit);
    const QString typed = plainNumberText(*read, kTypedDigits);
    return tr("%1 becomes %2 %3 (steps of %4)", "typed number, sent number, unit, step")
        .arg(typed, sent, m_unit, numberText(m_step, decimalsFor(m_step)));
}

void SetpointEdit::keyPressEvent(QKeyEvent *event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!enter
        || (event->modifiers() & Qt::ControlModifier)) // Ctrl+Enter starts the motor: not ours
        return SteppedEdit::keyPressEvent(event);
    event->accept();
    const auto sent = sentValue();
    if (!sent)
        QToolTip::showText(mapToGlobal(QPoint(0, height())), echo().toHtmlEscaped(), this);
    else if (!event->isAutoRepeat())
        Q_EMIT committed(*sent);
}

void SetpointEdit::stepBy(int steps)
{
    const auto from = sentValue();
    if (!from)
        return;
    const double inside = std::floor(m_limit / m_step) * m_step;
    setValue(std::clamp(*from + steps * std::max(m_step, m_notch), least(), inside));
}

} // namespace widgets
