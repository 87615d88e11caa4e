// What a run book says of a run: which experiment it was and what came of it, in words.
#pragma once

#include "session/files/run_book.h"

namespace widgets {

QString experimentText(const session::Run &run);
/// Its numbers, or why there are none; and how it ended, if it did not come to its end.
QString resultText(const session::Run &run);
QString gainsText(const session::Run &run); ///< of the speed loop: proportional, integral

} // namespace widgets
