// FirstSteps: one small card at a time that leads through the first minute. It follows what the user does and goes away
// for good when it is closed or finished; Help brings it back. All cards are as high as the highest of them, and the
// place of one that has nothing to say stays free: what is below does not move until then.
#pragma once

#include "widgets/base/device.h"

#include <QFrame>

class QBoxLayout;
class QLabel;
class QPushButton;

namespace widgets {

class SteadyLabel;

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

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    struct Card {
        QString title, text;
        QString first, second; ///< what its buttons say; empty: it has none
    };
    static Card cardOf(Step step);
    void fitHeight();
    int heightWith(bool beside, bool inLine, int whole) const;
    void show(Step step);
    void follow();
    void place();

    Device &m_device;
    SteadyLabel *m_title;
    QLabel *m_text;
    QPushButton *m_first;
    QPushButton *m_second;
    QPushButton *m_close;
    QWidget *m_answers; ///< the buttons of a card
    QBoxLayout *m_between = nullptr; ///< the buttons
    QBoxLayout *m_rest = nullptr; ///< its text, and they beside or below it
    Step m_step = Step::Done;
    bool m_crowded = false;
};

} // namespace widgets
