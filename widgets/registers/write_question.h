// The question before a write that can move or harm something: which motor, which register, from what to what.
#pragma once

#include "widgets/registers/edits.h"

class QWidget;

namespace widgets {

/// Asks on top of `parent` and answers `edits`. Cancel is the default: neither Enter nor Esc writes.
void askBeforeWriting(QWidget *parent, RegisterEdits &edits, const QList<WriteLine> &lines);

} // namespace widgets
