#include "widgets/base/setpoint_text.h"

#include "base/text.h"

#include <QCoreApplication>

#include <string>

namespace widgets {
namespace {

constexpr qsizetype kLongest = 12;

struct Setpoint {
    Q_DECLARE_TR_FUNCTIONS(Setpoint)
};

} // namespace

Result<double, SetpointError> readSetpoint(const QString &text)
{
    return readPlainNumber(text, kLongest);
}

Result<double, SetpointError> readPlainNumber(const QString &text, qsizetype longest)
{
    const QString trimmed = text.trimmed();
    if (trimmed.isEmpty())
        return fail(SetpointError::Empty);
    if (trimmed.size() > longest)
        return fail(SetpointError::TooLong);

    std::string plain;
    int digits = 0;
    int points = 0;
    for (qsizetype i = 0; i < trimmed.size(); ++i) {
        const char16_t c = trimmed[i].unicode();
        if (c >= u'0' && c <= u'9') {
            plain.push_back(static_cast<char>(c));
            ++digits;
        } else if (c == u'.' || c == u',') {
            plain.push_back('.');
            ++points;
        } else if (i == 0 && (c == u'-' || c == 0x2212)) {
            plain.push_back('-');
        } else if (!(i == 0 && c == u'+')) {
            return fail(SetpointError::NotANumber);
        }
    }
    if (points > 1)
        return fail(SetpointError::TwoPoints);
    if (digits == 0)
        return fail(SetpointError::NotANumber);
    const auto value = numberIn<double>(plain);
    if (!value)
        return fail(SetpointError::NotANumber);
    return *value + 0.0; // "-0" is 0
}

QString setpointErrorText(SetpointError error)
{
    switch (error) {
    case SetpointError::Empty:
        return Setpoint::tr("Type a number.");
    case SetpointError::NotANumber:
        return Setpoint::tr("Not a plain number: use digits, one decimal point and a sign.");
    case SetpointError::TwoPoints:
        return Setpoint::tr("Write the number without group marks.");
    case SetpointError::TooLong:
        return Setpoint::tr("Too many digits.");
    }
    return {};
}

} // namespace widgets
