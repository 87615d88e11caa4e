// A recording as a reference: behind the traces of now, so that a run of another day is compared with the running
// picture. What is connected, and what was recorded of it, stay as they are.
#pragma once

#include "capture/capture.h"
#include "widgets/scope/drawing/marks.h"

#include <QString>

namespace widgets {

class ScopeView;
struct OpenedRecording;

/// Lays it beside what the scope shows, as the first reference that is free, else as B.
/// @param good  whether it is; else nothing has changed
/// @return      one sentence
QString layReference(
    ScopeView &scope, const capture::Capture &shown, OpenedRecording &opened, bool &good);

/// Which of its moments lies where; of a reference from a file.
QString laidText(ScopeView &scope, Reference which);

/// That a reference was replaced, and how to have it back. @param back  it is
QString replacedText(Reference which, bool back);

} // namespace widgets
