#include "widgets/motion_question.h"

#include "widgets/confirmation.h"

#include <QCoreApplication>
#include <QDialog>
#include <QPointer>

namespace widgets {
namespace {

struct MotionQuestionText {
    Q_DECLARE_TR_FUNCTIONS(MotionQuestion)
};

} // namespace

void showMotionQuestions(MotionGate &gate, QWidget *parent)
{
    QObject::connect(
        &gate, &MotionGate::asked, parent, [&gate, parent](const MotionQuestion &asked) {
            Confirmation question;
            question.objectName = "motionQuestion";
            question.title = asked.action;
            question.text = MotionQuestionText::tr("This will move motor %1. Go on?")
                                .arg(QString::number(asked.motor));
            question.lines = asked.lines;
            question.yesName = "motionConfirm";
            question.yes = asked.action;
            QDialog *dialog = askToConfirm(parent, question, [gate = QPointer(&gate)](bool yes) {
                if (gate)
                    yes ? gate->confirm() : gate->decline();
            });
            QObject::connect(&gate, &MotionGate::withdrawn, dialog, &QDialog::reject);
        });
}

} // namespace widgets
