// FaultHelp: explains the faults of a motor in a window of its own: what was recorded around each, what it means, its
// likely causes and what to try. It stays open while one works, follows the motor, and has a stop button like every
// window.
#pragma once

#include "widgets/base/device.h"

#include <QDialog>

class QTextBrowser;

namespace widgets {

class FaultPicture;
class FaultRecords;

class FaultHelp : public QDialog {
    Q_OBJECT
public:
    /// Both outlive it.
    FaultHelp(Device &device, const FaultRecords &records, QWidget *parent = nullptr);

    void present(); ///< in front, with the newest fault of the motor

    QString plainText() const; ///< what it says, for tests

private:
    void update();

    Device &m_device;
    FaultPicture *m_picture;
    QTextBrowser *m_text;
    QString m_html; ///< as shown
};

} // namespace widgets
