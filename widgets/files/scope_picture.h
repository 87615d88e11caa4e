// Pictures of the scope as it is on the screen, as files and to be copied; in the light colours, whatever the theme:
// they go on paper.
#pragma once

#include "session/files/whole_file.h"

#include <QByteArray>

#include <span>

class QImage;

namespace widgets {

class ScopeView;

QImage scopeImage(ScopeView &scope); ///< all of it, in the screen's pixels

/// PNG is of the whole view; SVG and PDF of its plots, traces and cursors as shapes.
struct PictureFormat {
    const char *suffix = ""; ///< of the file, without a point
    const char *title = ""; ///< for a choice; can be translated ("ExportFormat")
    QByteArray (*draw)(ScopeView &scope) = nullptr;
};

std::span<const PictureFormat> pictureFormats();
session::FileResult writePicture(
    ScopeView &scope, const PictureFormat &format, const QString &path);

} // namespace widgets
