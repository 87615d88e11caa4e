// What a recording tells that happened, in the window's words. A recording has words of its own, in English, and the
// raw codes of registers; what has no other words here is told in those.
#pragma once

#include "recorded/entry.h"

#include <QString>

namespace widgets {

QString happeningText(const recorded::Happening &happening);

} // namespace widgets
