// CurrentScaleDialog: asks for the full-scale current of a motor whose board does not tell it, as such or by shunt,
// amplifier and converter. It only asks; `chosen` tells the answer.
#pragma once

#include <QDialog>

class QGroupBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace widgets {

class CurrentScaleDialog : public QDialog {
    Q_OBJECT
public:
    /// @param fullScaleAmps  as it is now; 0: not known
    CurrentScaleDialog(int motor, double fullScaleAmps, QWidget *parent = nullptr);

Q_SIGNALS:
    void chosen(int motor, double fullScaleAmps); ///< 0: it is not known

private:
    QGroupBox *makeCircuit();
    void compute();
    void follow();
    void accept() override;

    int m_motor;
    QLineEdit *m_amps;
    QLineEdit *m_shunt;
    QLineEdit *m_gain;
    QLineEdit *m_reference;
    QLabel *m_says;
    QPushButton *m_ok = nullptr;
};

} // namespace widgets
