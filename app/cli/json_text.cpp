#include "json_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QLocale>

#include <cmath>

namespace cli {

namespace {
QByteArray quoted(const QString &text)
{
    const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return list.mid(1, list.size() - 2);
}
} // namespace

void JsonText::separate()
{
    if (!m_first)
        m_text += ',';
    m_first = false;
}

void JsonText::open(char bracket)
{
    separate();
    m_text += bracket;
    m_first = true;
}

void JsonText::close(char bracket)
{
    m_text += bracket;
    m_first = false;
}

void JsonText::put(const QByteArray &token)
{
    separate();
    m_text += token;
}

void JsonText::key(const QString &name)
{
    put(quoted(name) + ':');
    m_first = true;
}

void JsonText::value(const QString &text) { put(quoted(text)); }

void JsonText::value(qint64 number) { put(QByteArray::number(number)); }

void JsonText::value(double number)
{
    put(std::isfinite(number) ? QByteArray::number(number, 'g', QLocale::FloatingPointShortest)
                              : QByteArray("null"));
}

void JsonText::value(bool truth) { put(truth ? "true" : "false"); }

} // namespace cli
