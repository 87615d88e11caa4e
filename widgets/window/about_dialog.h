// What Rotorscope is, under which licence, and what it cannot do: stop a motor by itself when it is gone. And its keys.
#pragma once

#include <QString>

class QMainWindow;
class QWidget;

namespace widgets {

void showAbout(QWidget *parent);
/// As the menus and the tools of the window have them.
void showKeys(QMainWindow &window);

/// The sentences about stopping, as in About.
QString stopLimitsText();

} // namespace widgets
