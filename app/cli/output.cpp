#include "output.h"

#include "base/terminal_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include <cstdio>

namespace cli {

namespace {

QByteArray harmless(const QString &text)
{
    const QByteArray utf8 = text.toUtf8();
    return QByteArray::fromStdString(
        terminalText({utf8.constData(), static_cast<std::size_t>(utf8.size())}));
}

} // namespace

Output::Output(bool json)
    : m_json(json)
{
    m_ok = m_file.open(stdout, QIODevice::WriteOnly);
}

void Output::line(const QString &text) { write(harmless(text)); }

void Output::line(const QJsonValue &value)
{
    const QJsonDocument document =
        value.isArray() ? QJsonDocument(value.toArray()) : QJsonDocument(value.toObject());
    json(document.toJson(QJsonDocument::Compact));
}

void Output::json(const QByteArray &text)
{
    write(QByteArray::fromStdString(
        terminalJson({text.constData(), static_cast<std::size_t>(text.size())})));
}

void Output::ownText(const QString &text) { write(text.toUtf8()); }

void Output::write(QByteArray line)
{
    line += '\n';
    m_ok = m_file.write(line) == line.size() && m_ok;
}

bool Output::flush()
{
    m_ok = m_file.flush() && m_ok;
    return m_ok;
}

void Output::error(const QString &sentence)
{
    const QByteArray bytes = "rotorscope-cli: " + harmless(sentence) + '\n';
    std::fwrite(bytes.constData(), 1, static_cast<std::size_t>(bytes.size()), stderr);
}

QString numberText(double number)
{
    return QString::number(number, 'g', QLocale::FloatingPointShortest);
}

} // namespace cli
