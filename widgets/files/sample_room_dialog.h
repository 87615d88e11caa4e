// SampleRoomDialog: asks how much of the disk the scope's samples may take, and says what that means. It sets nothing.
#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace widgets {

class SampleRoom;

class SampleRoomDialog : public QDialog {
    Q_OBJECT
public:
    /// @param room  outlives it
    explicit SampleRoomDialog(const SampleRoom &room, QWidget *parent = nullptr);

Q_SIGNALS:
    void chosen(double gigabytes); ///< as SampleRoom::setWanted() takes it

private:
    void follow();
    void accept() override;

    const SampleRoom &m_room;
    QLineEdit *m_size;
    QLabel *m_meaning;
    QPushButton *m_ok;
    double m_free; ///< GB; negative: unknown
};

} // namespace widgets
