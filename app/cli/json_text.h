// JSON with its keys in the order in which they are written: QJsonObject sorts them, and the fields of a structure are
// read by position.
#pragma once

#include <QByteArray>
#include <QString>

namespace cli {

class JsonText {
public:
    void beginObject() { open('{'); }
    void endObject() { close('}'); }
    void beginArray() { open('['); }
    void endArray() { close(']'); }

    void key(const QString &name);
    void value(const QString &text);
    void value(const char *text) { value(QString::fromUtf8(text)); }
    void value(qint64 number);
    void value(double number); ///< null if it is not finite: JSON has no word for that
    void value(bool truth);

    /// key() and value().
    template <class T>
    void member(const char *name, const T &content)
    {
        key(QString::fromLatin1(name));
        value(content);
    }

    const QByteArray &text() const { return m_text; }

private:
    void separate();
    void open(char bracket);
    void close(char bracket);
    void put(const QByteArray &token);

    QByteArray m_text;
    bool m_first = true; ///< nothing in the innermost bracket yet, or a key was written last
};

} // namespace cli
