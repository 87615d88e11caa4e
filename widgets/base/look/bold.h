// inBold(): the font of a heading, and of what is to be seen first.
#pragma once

#include <QFont>

namespace widgets {

/// @param larger  than `font`, in its sizes
inline QFont inBold(QFont font, double larger = 1.0)
{
    font.setBold(true);
    if (larger > 1.0)
        font.setPointSizeF(font.pointSizeF() * larger);
    return font;
}

} // namespace widgets
