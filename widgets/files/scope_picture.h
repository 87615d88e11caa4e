// Pictures of the scope as it is on the screen, as files.
#pragma once

#include "session/csv_file.h"
#include "widgets/files/export_order.h"

class QImage;

namespace widgets {

class ScopeView;

QImage scopeImage(ScopeView &scope); ///< all of it, in the screen's pixels

/// PNG of the whole view; SVG and PDF of its plots, traces and cursors as shapes.
session::CsvResult writePicture(ScopeView &scope, ExportFormat format, const QString &path);

} // namespace widgets
