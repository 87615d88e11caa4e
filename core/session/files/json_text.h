// JSON with its keys in the order in which they are written: QJsonObject sorts them, and the fields of a structure are
// read by position. And its numbers, read as what they should be: files are foreign.
#pragma once

#include <QByteArray>
#include <QString>

#include <cmath>
#include <optional>
#include <string_view>

namespace session {

/// A key of a QJsonObject.
inline QString keyOf(const char *name) { return QString::fromLatin1(name); }

/// A whole number within the range; empty for any other, and for NaN, which stands for a member that is none.
template <class Number>
std::optional<Number> wholeIn(double value, double least, double most)
{
    if (!(value >= least && value <= most) || value != std::nearbyint(value))
        return std::nullopt;
    return static_cast<Number>(value);
}

class JsonText {
public:
    enum class Layout : bool { OneLine, Indented };
    explicit JsonText(Layout layout = Layout::OneLine)
        : m_layout(layout)
    {
    }

    void beginObject() { open('{'); }
    void endObject() { close('}'); }
    void beginArray() { open('['); }
    void endArray() { close(']'); }

    void key(const QString &name);
    void value(const QString &text);
    void value(std::string_view text);
    void value(const char *text) { value(std::string_view(text)); }
    void value(int number) { value(qint64{number}); }
    void value(std::uint32_t number) { value(qint64{number}); }
    void value(qint64 number);
    void value(std::uint64_t number);
    void value(double number); ///< null if it is not finite: JSON has no word for that
    void value(bool truth) { put(truth ? "true" : "false"); }

    /// key() and value().
    template <class T>
    void member(std::string_view name, const T &content)
    {
        key(name);
        value(content);
    }
    void beginObject(std::string_view name)
    {
        key(name);
        beginObject();
    }
    void beginArray(std::string_view name)
    {
        key(name);
        beginArray();
    }

    const QByteArray &text() const { return m_text; }

private:
    void key(std::string_view name) { key(QString::fromUtf8(name)); }
    void separate();
    void newLine();
    void open(char bracket);
    void close(char bracket);
    void put(const QByteArray &token);

    Layout m_layout;
    QByteArray m_text;
    int m_depth = 0; ///< open brackets
    bool m_empty = true; ///< nothing in the innermost bracket yet
    bool m_keyed = false; ///< a key was written last
};

} // namespace session
