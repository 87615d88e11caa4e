#include "session/files/json_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QLocale>

#include <cmath>
#include <utility>

namespace session {

namespace {
QByteArray quoted(const QString &text)
{
    const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return list.mid(1, list.size() - 2);
}
} // namespace

void JsonText::separate()
{
    if (std::exchange(m_keyed, false))
        return;
    if (!m_empty)
        m_text += ',';
    if (m_depth > 0)
        newLine();
    m_empty = false;
}

void JsonText::newLine()
{
    if (m_layout == Layout::Indented)
        m_text += '\n' + QByteArray(qsizetype{2} * m_depth, ' ');
}

void JsonText::open(char bracket)
{
    separate();
    m_text += bracket;
    ++m_depth;
    m_empty = true;
}

void JsonText::close(char bracket)
{
    --m_depth;
    if (!m_empty)
        newLine();
    m_text += bracket;
    m_empty = false;
}

void JsonText::put(const QByteArray &token)
{
    separate();
    m_text += token;
}

void JsonText::key(const QString &name)
{
    put(quoted(name) + (m_layout == Layout::Indented ? ": " : ":"));
    m_keyed = true;
}

void JsonText::value(const QString &text) { put(quoted(text)); }

void JsonText::value(std::string_view text) { put(quoted(QString::fromUtf8(text))); }

void JsonText::value(qint64 number) { put(QByteArray::number(number)); }

void JsonText::value(std::uint64_t number) { put(QByteArray::number(quint64{number})); }

void JsonText::value(double number)
{
    put(std::isfinite(number) ? QByteArray::number(number, 'g', QLocale::FloatingPointShortest)
                              : QByteArray("null"));
}

} // namespace session
