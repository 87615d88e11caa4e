#include "widgets/control/motion_question.h"

#include "widgets/base/confirmation.h"
#include "widgets/base/messages.h"

#include <QCoreApplication>
#include <QDialog>
#include <QPointer>

namespace widgets {
namespace {

struct MotionQuestionText {
    Q_DECLARE_TR_FUNCTIONS(MotionQuestion)
};

} // namespace

void askForExpert(Device &device, int motor, QWidget *parent)
{
    QStringList names;
    for (const drive::LimitGap gap : drive::gapsIn(device.limits(motor)))
        names.append(limitGapText(gap));
    const QString number = QString::number(motor);
    Confirmation question;
    question.objectName = "expertQuestion";
    question.title = MotionQuestionText::tr("Expert mode");
    question.text =
        MotionQuestionText::tr("The board does not tell all limits of motor %1.").arg(number);
    question.lines = {MotionQuestionText::tr("Not known: %1", "list of limits")
                          .arg(names.join(QLatin1String(", "))),
        MotionQuestionText::tr("Until the connection ends, set-points of this motor are bounded "
                               "only by what is known and by your own limits.")};
    question.yesName = "expertConfirm";
    question.yes = MotionQuestionText::tr("Expert mode");
    question.typed = MotionQuestionText::tr("motor %1", "to be typed").arg(number);
    askToConfirm(parent, question, [device = QPointer(&device), motor](bool yes) {
        if (yes && device)
            device->becomeExpert(motor);
    });
}

void showMotionQuestions(MotionGate &gate, Device &device, QWidget *parent)
{
    QObject::connect(&gate, &MotionGate::expertNeeded, parent,
        [&device, parent](int motor) { askForExpert(device, motor, parent); });
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
            question.offer = asked.offer;
            question.onOffer = [gate = QPointer(&gate)] {
                if (gate)
                    gate->agreeToSteps();
            };
            QDialog *dialog = askToConfirm(parent, question, [gate = QPointer(&gate)](bool yes) {
                if (gate)
                    yes ? gate->confirm() : gate->decline();
            });
            QObject::connect(&gate, &MotionGate::withdrawn, dialog, &QDialog::reject);
        });
}

} // namespace widgets
