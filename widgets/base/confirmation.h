// The one dialog that asks before something that can move or harm a motor. Cancel is the default: neither Enter nor Esc
// says yes (but for Enter behind a word that had to be typed), and Esc stops the motors first, as everywhere.
#pragma once

#include <QStringList>

#include <functional>

class QDialog;
class QWidget;

namespace widgets {

struct Confirmation {
    const char *objectName = "confirmation";
    QString title;
    QString text; ///< why it is asked, one sentence
    QStringList lines; ///< what is to be done; plain text
    QWidget *picture = nullptr; ///< of what is to be done; the box takes it. nullptr: none
    const char *yesName = "confirmationYes"; ///< of the button
    QString yes; ///< its text, a verb
    QString typed; ///< has to be typed before yes can be pressed; empty: nothing
    QString offer; ///< may be ticked along with yes; empty: nothing
    std::function<void()> onOffer; ///< it was, before the answer
};

/// Opens it on top of `parent`; exactly one answer follows, also when the dialog is closed some other way.
QDialog *askToConfirm(
    QWidget *parent, const Confirmation &question, std::function<void(bool yes)> answer);

} // namespace widgets
