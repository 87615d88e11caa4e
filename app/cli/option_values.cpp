#include "option_values.h"

#include "base/text.h"

#include <cmath>

namespace cli {

void addOption(QCommandLineParser &parser, const OptionText &option)
{
    parser.addOption({QString::fromLatin1(option.names).split(QLatin1Char(',')),
        QString::fromLatin1(option.help), QString::fromLatin1(option.value)});
}

bool Given::has(const char *option) const
{
    return m_parser.optionNames().contains(QLatin1String(option));
}

bool Given::hasValue(const char *option) const
{
    return !m_parser.values(QString::fromLatin1(option)).isEmpty();
}

QString Given::value(const char *option) const
{
    return m_parser.value(QString::fromLatin1(option));
}

QStringList Given::list(const char *option) const
{
    QStringList names = value(option).split(QLatin1Char(','), Qt::SkipEmptyParts);
    for (QString &name : names)
        name = name.trimmed();
    return names;
}

std::optional<double> plainNumber(const QString &text)
{
    const auto number = numberIn<double>(text.trimmed().toLatin1().toStdString());
    return number && std::isfinite(*number) ? number : std::nullopt;
}

Outcome<int> wholeNumber(const QString &text, int least, int most, const QString &what)
{
    bool ok = false;
    const int number = text.trimmed().toInt(&ok);
    if (!ok || number < least || number > most)
        return usage(QStringLiteral("%1 must be a whole number from %2 to %3, not \"%4\".")
                         .arg(what, QString::number(least), QString::number(most), text));
    return number;
}

Outcome<bool> readNumbers(const Given &given, std::initializer_list<NumberOption> options)
{
    for (const NumberOption &option : options) {
        if (!given.has(option.name))
            continue;
        const auto number = wholeNumber(given.value(option.name), option.least, option.most,
            QStringLiteral("--") + QLatin1String(option.name));
        if (!number)
            return tl::make_unexpected(number.error());
        *option.value = *number;
    }
    return true;
}

} // namespace cli
