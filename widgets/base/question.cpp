#include "widgets/base/question.h"

#include <QMessageBox>
#include <QPushButton>

namespace widgets {
namespace {

QMessageBox::ButtonRole roleOf(Answer::Kind kind)
{
    switch (kind) {
    case Answer::Kind::Go:
        return QMessageBox::AcceptRole;
    case Answer::Kind::Force:
    case Answer::Kind::Lose:
        return QMessageBox::DestructiveRole;
    case Answer::Kind::Stay:
        break;
    }
    return QMessageBox::RejectRole;
}

QMessageBox *boxOf(const QWidget &window, const char *name)
{
    return window.findChild<QMessageBox *>(QLatin1String(name), Qt::FindDirectChildrenOnly);
}

} // namespace

void QuestionBoxes::ask(const Question &question)
{
    auto *box = new QMessageBox(
        QMessageBox::Warning, question.title, question.text, QMessageBox::NoButton, &m_window);
    box->setObjectName(QLatin1String(question.name));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(question.more);
    QList<QAbstractButton *> buttons;
    for (const Answer &answer : question.answers) {
        QPushButton *button = answer.text.isEmpty()
            ? box->addButton(QMessageBox::Cancel)
            : box->addButton(answer.text, roleOf(answer.kind));
        button->setObjectName(QLatin1String(answer.name));
        if (answer.kind == Answer::Kind::Stay)
            box->setEscapeButton(button);
        else if (answer.kind == Answer::Kind::Lose)
            button->setAutoDefault(false);
        if (buttons.size() == question.usual)
            box->setDefaultButton(button);
        buttons.append(button);
    }
    QObject::connect(box, &QMessageBox::buttonClicked, &m_window,
        [buttons, answers = question.answers](QAbstractButton *button) {
            const qsizetype chosen = buttons.indexOf(button);
            if (chosen >= 0 && answers[chosen].act)
                answers[chosen].act();
        });
    box->open();
}

bool QuestionBoxes::asks(const char *name) const
{
    const auto *box = boxOf(m_window, name);
    return box && box->isVisible();
}

void QuestionBoxes::withdraw(const char *name)
{
    if (auto *box = boxOf(m_window, name))
        box->reject();
}

} // namespace widgets
