// FirstSteps: one small card at a time that leads through the first minute. It follows what the person does and goes
// away for good when it is closed or finished; Help brings it back.
#pragma once

#include "widgets/base/device.h"

#include <QFrame>

class QLabel;
class QPushButton;

namespace widgets {

class FirstSteps : public QFrame {
    Q_OBJECT
public:
    enum class Step : std::uint8_t { Welcome, Start, Speed, Save, Done };

    explicit FirstSteps(Device &device, QWidget *parent = nullptr);

    Step step() const { return m_step; }
    void restart();
    void finish(); ///< as if closed
    void setCrowded(bool crowded); ///< others need the place: the card waits until it is free again

Q_SIGNALS:
    void simulatorWanted();
    void boardWanted();
    void exportWanted();
    void finished();

private:
    void show(Step step);
    void follow();
    void place();

    Device &m_device;
    QLabel *m_title;
    QLabel *m_text;
    QPushButton *m_first;
    QPushButton *m_second;
    QPushButton *m_close;
    Step m_step = Step::Done;
    bool m_crowded = false;
};

} // namespace widgets
