#include "output.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include <cstdio>

namespace cli {

Output::Output(bool json)
    : m_json(json)
{
    m_ok = m_file.open(stdout, QIODevice::WriteOnly);
}

void Output::line(const QString &text) { write(text.toUtf8()); }

void Output::line(const QJsonValue &value)
{
    const QJsonDocument document =
        value.isArray() ? QJsonDocument(value.toArray()) : QJsonDocument(value.toObject());
    write(document.toJson(QJsonDocument::Compact));
}

void Output::write(const QByteArray &bytes)
{
    const QByteArray whole = bytes + '\n';
    m_ok = m_file.write(whole) == whole.size() && m_ok;
}

bool Output::flush()
{
    m_ok = m_file.flush() && m_ok;
    return m_ok;
}

void Output::error(const QString &sentence)
{
    QString oneLine = sentence;
    oneLine.replace(QLatin1Char('\n'), QLatin1Char(' '));
    const QByteArray bytes = "rotorscope-cli: " + oneLine.toUtf8() + '\n';
    std::fwrite(bytes.constData(), 1, static_cast<std::size_t>(bytes.size()), stderr);
}

QString numberText(double number)
{
    return QString::number(number, 'g', QLocale::FloatingPointShortest);
}

} // namespace cli
