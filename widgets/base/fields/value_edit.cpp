#include "widgets/base/fields/value_edit.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/base/fields/stepped_edit.h"
#include "widgets/base/reading_text.h"
#include "widgets/base/setpoint_text.h"
#include "widgets/base/value_text.h"

#include <QKeyEvent>
#include <QToolTip>

#include <cmath>

namespace widgets {

namespace {
constexpr qsizetype kMostDigits = 16;

struct TimeUnit {
    const char *name;
    double seconds;
};
// The longer ones first: "ms" ends in "s".
constexpr TimeUnit kTimeUnits[] = {
    {"min", 60.0}, {"ms", 1e-3}, {"\u00b5s", 1e-6}, {"us", 1e-6}, {"s", 1.0}};
} // namespace

ValueEdit::ValueEdit(QWidget *parent)
    : QLineEdit(parent)
{
    setMaxLength(32);
    setAlignment(Qt::AlignRight);
}

void ValueEdit::setPlain(const QString &unit, double step)
{
    const bool same = !m_time && unit == m_unit && step == m_step;
    m_time = false;
    m_unit = unit;
    m_step = step > 0 ? step : 1e-3;
    if (!same)
        show();
}

void ValueEdit::setTime()
{
    m_time = true;
    show();
}

void ValueEdit::setBounds(double least, double most)
{
    m_least = least;
    m_most = most;
}

void ValueEdit::setValue(double value)
{
    m_value = value;
    if (!(hasFocus() && isModified()))
        show();
}

QString ValueEdit::textOf(double value) const
{
    const QLocale plain = plainLocale(locale());
    return m_time ? exactTime(value, plain) : readingText(value, m_step, m_unit, plain);
}

void ValueEdit::show()
{
    const QString text = textOf(m_value);
    setModified(false);
    if (focusIsIn(*this))
        return followText(*this, text);
    setText(text);
    setCursorPosition(0);
}

std::optional<double> ValueEdit::understood() const
{
    QString text = this->text().simplified();
    text.replace(QChar(0x2212), QLatin1Char('-'));
    double scale = 1.0;
    if (m_time) {
        for (const TimeUnit &unit : kTimeUnits) {
            const QString name = QString::fromUtf8(unit.name);
            if (text.endsWith(name)) {
                text.chop(name.size());
                scale = unit.seconds;
                break;
            }
        }
    } else {
        // As it is shown, and as files have it.
        for (const QString &known : {unitText(m_unit), m_unit}) {
            if (!known.isEmpty() && text.endsWith(known, Qt::CaseInsensitive)) {
                text.chop(known.size());
                break;
            }
        }
    }
    const auto number = readPlainNumber(text.trimmed(), kMostDigits);
    if (!number)
        return std::nullopt;
    const double value = *number * scale;
    // What a field shows is rounded: a bound that it shows may be typed.
    const double slack = std::abs(value) * 1e-9;
    if (value < m_least - slack || value > m_most + slack)
        return std::nullopt;
    return std::clamp(value, m_least, m_most);
}

void ValueEdit::commit()
{
    if (!isModified())
        return;
    const auto value = understood();
    if (!value) {
        QToolTip::showText(mapToGlobal(QPoint(0, height())),
            tr("Not understood: a number from %1 to %2").arg(textOf(m_least), textOf(m_most)),
            this);
        show(); // what was there stays
        return;
    }
    m_value = *value;
    show();
    Q_EMIT committed(m_value);
}

void ValueEdit::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        commit();
        selectAll();
        return;
    }
    QLineEdit::keyPressEvent(event);
}

void ValueEdit::focusOutEvent(QFocusEvent *event)
{
    commit();
    QLineEdit::focusOutEvent(event);
}

} // namespace widgets
