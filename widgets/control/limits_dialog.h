// LimitsDialog: the user's own limits of speed and current, for every motor and every board. The lower of these and
// the board's counts; the drive enforces them, this only asks.
#pragma once

#include "drive/wish.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace widgets {

class LimitsDialog : public QDialog {
    Q_OBJECT
public:
    explicit LimitsDialog(const drive::UserLimits &limits, QWidget *parent = nullptr);

Q_SIGNALS:
    void chosen(const drive::UserLimits &limits);

private:
    void follow();
    void accept() override;

    QLineEdit *m_speed;
    QLineEdit *m_current;
    QLabel *m_wrong;
    QPushButton *m_ok;
};

} // namespace widgets
