#include "widgets/base/register_texts.h"

#include <QCoreApplication>

namespace widgets {

// lupdate finds these texts in a file that CMake makes of what core knows.

QString registerGroupText(const std::string &group)
{
    return QCoreApplication::translate("RegisterGroups", group.c_str());
}

QString registerHelpText(const catalog::RegisterInfo &info)
{
    return QCoreApplication::translate("RegisterHelp", info.help.c_str()).simplified();
}

QString valueNameText(std::string_view name)
{
    return QCoreApplication::translate("RegisterValues", std::string(name).c_str());
}

QStringList valueNameTexts(const std::vector<std::string> &names)
{
    QStringList texts;
    for (const std::string &name : names)
        texts.append(valueNameText(name));
    return texts;
}

std::optional<std::int64_t> valueNamed(
    std::span<const catalog::NamedValue> values, const QString &word)
{
    for (const catalog::NamedValue &value : values) {
        const QString english = QString::fromUtf8(value.name);
        if (word.compare(valueNameText(value.name), Qt::CaseInsensitive) == 0
            || word.compare(english, Qt::CaseInsensitive) == 0)
            return value.value;
    }
    return {};
}

} // namespace widgets
