// What the rev-up form says of mistakes: what is wrong at a stage and what to change, with numbers.
#pragma once

#include "widgets/forms/rev_up_model.h"

#include <QString>

namespace widgets {

/// One or two sentences.
QString revUpFindingText(const motor::RevUpFinding &finding, const RevUpModel &model);

/// "0.52 N·m" or "34.1 mN·m".
QString torqueText(double nm);

} // namespace widgets
