// The icons of bars, buttons and menus: one family of lines, drawn by us as SVG on a grid of 16 (resources/icons/line).
// They are coloured when they are painted, with the colour that the palette then has for text: one drawing serves both
// themes, and what cannot be used is paler.
#pragma once

#include <QIcon>

class QAbstractButton;
class QAction;

namespace widgets {

/// @param name  of the file, without its folder and ending; it has to be there
QIcon lineIcon(const char *name);

/// For menus and buttons alike; a box that can be ticked has none in a menu, where the tick has its place.
void setLineIcon(QAction &action, const char *name);
void setLineIcon(QAbstractButton &button, const char *name);

} // namespace widgets
