#include "widgets/register_texts.h"

#include <QCoreApplication>

namespace widgets {

// lupdate finds these texts in a file that CMake makes of resources/registers.

QString registerGroupText(const std::string &group)
{
    return QCoreApplication::translate("RegisterGroups", group.c_str());
}

QString registerHelpText(const catalog::RegisterInfo &info)
{
    return QCoreApplication::translate("RegisterHelp", info.help.c_str()).simplified();
}

} // namespace widgets
