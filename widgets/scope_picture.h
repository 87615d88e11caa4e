// Pictures of the scope as it is on the screen, as files.
#pragma once

#include "session/csv_file.h"
#include "widgets/export_order.h"

class QImage;

namespace widgets {

class ScopeView;

QImage scopeImage(ScopeView &scope); ///< all of it, in the screen's pixels

/// PNG of the whole view; SVG and PDF of its plots, with axes and words as such and the traces as an image.
session::CsvResult writePicture(ScopeView &scope, ExportFormat format, const QString &path);

} // namespace widgets
