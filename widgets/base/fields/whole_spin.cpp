#include "widgets/base/fields/whole_spin.h"

#include "widgets/base/device_text.h"
#include "widgets/base/fields/stepped_edit.h"

#include <QLineEdit>

#include <utility>

namespace widgets {

WholeSpin::WholeSpin(QWidget *parent)
    : QSpinBox(parent)
{
    connect(lineEdit(), &QLineEdit::textChanged, this, &WholeSpin::textChanged);
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] { m_typing = true; });
    connect(this, &QSpinBox::editingFinished, this, [this] { m_before = value(); });
    connect(this, &QSpinBox::valueChanged, this, [this](int now) {
        if (!m_typing)
            m_before = now;
    });
}

void WholeSpin::textChanged()
{
    const QString sentence = problem();
    lineEdit()->setPalette(problemPalette(sentence));
    lineEdit()->setToolTip(plainToolTip(sentence));
    setAccessibleDescription(sentence);
    if (!std::exchange(m_typing, false) || sentence.isEmpty() || value() == m_before)
        return;
    // The good beginning of a text that has become bad does not count.
    const QString typed = lineEdit()->text();
    const int cursor = lineEdit()->cursorPosition();
    setValue(m_before);
    lineEdit()->setText(typed);
    lineEdit()->setCursorPosition(cursor);
}

QString WholeSpin::problem() const
{
    return isGood(lineEdit()->text())
        ? QString()
        : tr("A whole number from %1 to %2.")
              .arg(QString::number(minimum()), QString::number(maximum()));
}

bool WholeSpin::isGood(QString text) const
{
    if (!suffix().isEmpty() && text.endsWith(suffix()))
        text.chop(suffix().size());
    if (!specialValueText().isEmpty() && text == specialValueText())
        return true;
    bool whole = false;
    const int number = text.trimmed().toInt(&whole);
    return whole && number >= minimum() && number <= maximum();
}

QValidator::State WholeSpin::validate(QString &input, int &) const
{
    return isGood(input) ? QValidator::Acceptable : QValidator::Intermediate;
}

/// When it is left: the number of before.
void WholeSpin::fixup(QString &input) const { input = textFromValue(m_before) + suffix(); }

} // namespace widgets
