// What a register is and the group it stands in, in the person's language. The catalogue's own texts are English and serve
// as keys; the names of registers stay as the documents print them.
#pragma once

#include "catalog/register_info.h"

#include <QString>

namespace widgets {

/// A group that is not known keeps its name.
QString registerGroupText(const std::string &group);

/// One line, as long as it is; in English where there is no translation.
QString registerHelpText(const catalog::RegisterInfo &info);

} // namespace widgets
