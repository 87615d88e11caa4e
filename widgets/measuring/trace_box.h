// A box of the traces that the scope shows. It stays with its signal when that gets another channel: a formula that was
// changed, another rate, a recording that was cleared. A signal that is gone leaves it empty, and no other takes its
// place.
#pragma once

#include "capture/capture.h"

class QComboBox;

namespace widgets {

class ScopeView;

/// px, of a panel's list and choices: "orders: STOPLL_ROT_SPEED" fits.
constexpr int kSideWidth = 270;

/// Of a box with the stretches that are measured.
enum MeasuredRange { Picture, BetweenCursors };

/// The data of its entries are the channels.
/// @param first  entry of a box in which nothing was chosen yet; the last one, if there are fewer
void fillTraceBox(
    QComboBox &box, const ScopeView &scope, const capture::Capture &capture, int first = 0);

} // namespace widgets
