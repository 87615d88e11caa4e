// What the program prints: text for people or JSON for programs on standard output, one line of error on standard error.
#pragma once

#include <QFile>
#include <QJsonValue>
#include <QString>

namespace cli {

class Output {
public:
    explicit Output(bool json);

    bool json() const { return m_json; }
    void line(const QString &text);
    void line(const QJsonValue &value); ///< an object or an array, in one line
    void write(const QByteArray &bytes); ///< a line that is made already, without its end
    /// False if something could not be written, say because a disk is full.
    bool flush();

    static void error(const QString &sentence);

private:
    QFile m_file;
    bool m_json;
    bool m_ok = true;
};

/// Shortest text that is the same number again, with a point.
QString numberText(double number);

} // namespace cli
