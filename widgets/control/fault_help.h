// FaultHelp: explains the faults of a motor in a window of its own: what each means, its likely causes and what to try.
// It stays open while one works, follows the motor, and has a stop button like every window.
#pragma once

#include "widgets/base/device.h"

#include <QDialog>

class QTextBrowser;

namespace widgets {

class FaultHelp : public QDialog {
    Q_OBJECT
public:
    explicit FaultHelp(Device &device, QWidget *parent = nullptr);

    QString plainText() const; ///< what it says, for tests

private:
    void update();

    Device &m_device;
    QTextBrowser *m_text;
    QString m_html; ///< as shown
};

} // namespace widgets
