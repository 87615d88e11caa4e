// StopOnTop: keeps the Stop buttons of a window, and of those that belong to it, working while a dialog blocks them. Qt
// throws away what is pressed in a blocked window before any filter sees it, but not what is pressed in a window of the
// dialog: such a one, a button like it, is laid over each that is seen, and goes with the dialog. It takes no focus,
// and leaves free what lies over the button itself, as the dialog may.
//
// Not under Wayland, where no program says where its windows stand; Esc stops there as everywhere.
#pragma once

#include <QObject>
#include <QPointer>
#include <QRegion>
#include <QTimer>

#include <memory>
#include <vector>

class QWidget;

namespace widgets {

class StopButton;

class StopOnTop : public QObject {
    Q_OBJECT
public:
    explicit StopOnTop(QWidget &window); ///< its parent
    ~StopOnTop() override;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// A Stop may withdraw the question that is asked, and with it the button that is being pressed.
    struct Late {
        void operator()(StopButton *button) const;
    };
    struct Cover {
        QPointer<StopButton> over;
        std::unique_ptr<StopButton, Late> button;
    };
    void lay();
    Cover coverOf(StopButton &over) const;
    QRegion seenOf(const StopButton &button) const;

    QWidget &m_window;
    QPointer<QWidget> m_dialog;
    std::vector<Cover> m_covers;
    QTimer m_soon; ///< a dialog that opens makes many events
};

} // namespace widgets
