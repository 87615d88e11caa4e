// Headings, all of them alike: their font, which is also that of what is to be seen first, and the head of a section of
// a panel: its name, and a line from there to the edge.
#pragma once

#include <QFont>
#include <QWidget>

namespace widgets {

/// @param larger  than `font`, in its sizes
inline QFont inBold(QFont font, double larger = 1.0)
{
    font.setBold(true);
    if (larger > 1.0)
        font.setPointSizeF(font.pointSizeF() * larger);
    return font;
}

class SectionHead : public QWidget {
public:
    SectionHead(const QString &name, QWidget *parent);
};

} // namespace widgets
