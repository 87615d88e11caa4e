// The names of register groups in the person's language. The catalogue's own are English and serve as keys; the names
// of registers stay as the documents print them.
#pragma once

#include <QString>

#include <string>

namespace widgets {

/// A group that is not known keeps its name.
QString registerGroupText(const std::string &group);

} // namespace widgets
