// What Rotorscope is, under which licence, and what it cannot do: stop a motor by itself when it is gone.
#pragma once

#include <QString>

class QWidget;

namespace widgets {

void showAbout(QWidget *parent);
void showKeys(QWidget *parent);

/// The sentences about stopping, as in About.
QString stopLimitsText();

} // namespace widgets
