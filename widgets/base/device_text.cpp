#include "widgets/base/device_text.h"

#include "widgets/base/look/named.h"

#include <QFileInfo>
#include <QLabel>
#include <QTextDocument>

namespace widgets {
namespace {

bool hidesOrReorders(QChar c)
{
    const auto category = c.category();
    return category == QChar::Other_Control || category == QChar::Other_Format
        || category == QChar::Separator_Line || category == QChar::Separator_Paragraph
        || category == QChar::Other_PrivateUse;
}

} // namespace

QString deviceText(const QString &text)
{
    QString shown;
    for (const QChar c : text) {
        if (shown.size() >= kDeviceTextLength) {
            shown.truncate(kDeviceTextLength - 1);
            return shown + QChar(0x2026);
        }
        if (c == QLatin1Char('\t'))
            shown += QLatin1Char(' '); // vendors put one into their version texts
        else if (hidesOrReorders(c))
            shown += QStringLiteral("\\u%1").arg(ushort(c.unicode()), 4, 16, QLatin1Char('0'));
        else
            shown += c;
    }
    return shown.size() > kDeviceTextLength ? shown.left(kDeviceTextLength - 1) + QChar(0x2026)
                                            : shown;
}

QString deviceText(std::string_view text)
{
    // Four bytes a character at most: no need to decode more than can be shown.
    const auto size = std::min<std::size_t>(text.size(), std::size_t{4} * (kDeviceTextLength + 1));
    return deviceText(QString::fromUtf8(text.data(), static_cast<qsizetype>(size)));
}

QString deviceNames(const std::vector<std::string> &names)
{
    QStringList texts;
    for (const std::string &name : names)
        texts.append(deviceText(name));
    return texts.join(QStringLiteral(", "));
}

QString fileNameText(const QString &path) { return deviceText(QFileInfo(path).fileName()); }

QString deviceToolTip(std::string_view text) { return deviceText(text).toHtmlEscaped(); }

QString plainToolTip(const QString &text)
{
    return Qt::mightBeRichText(text) ? QStringLiteral("<span>%1</span>").arg(text.toHtmlEscaped())
                                     : text;
}

QLabel *wrappedLabel(const char *objectName, QWidget *parent)
{
    auto *label = named(new QLabel(parent), objectName);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

} // namespace widgets
