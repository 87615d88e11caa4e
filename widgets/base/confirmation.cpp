#include "widgets/base/confirmation.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>

namespace widgets {
namespace {

struct ConfirmationText {
    Q_DECLARE_TR_FUNCTIONS(Confirmation)
};

/// A key that was held before the question came must not answer it.
class HeldKeys : public QObject {
public:
    using QObject::QObject;
    bool eventFilter(QObject *, QEvent *event) override
    {
        if (event->type() != QEvent::KeyPress)
            return false;
        const auto *key = static_cast<QKeyEvent *>(event);
        return key->isAutoRepeat()
            && (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter
                || key->key() == Qt::Key_Space);
    }
};

/// A line that enables `yes` once it holds the word.
QLineEdit *addTypedLine(QMessageBox *box, QPushButton *yes, const QString &word)
{
    auto *label = new QLabel(ConfirmationText::tr("Type %1 to go on:", "a word").arg(word), box);
    label->setTextFormat(Qt::PlainText);
    auto *edit = new QLineEdit(box);
    edit->setObjectName(QStringLiteral("confirmationTyped"));
    edit->setAccessibleName(label->text());
    label->setBuddy(edit);
    yes->setEnabled(false);
    QObject::connect(edit, &QLineEdit::textChanged, yes,
        [yes, word](const QString &text) { yes->setEnabled(text.trimmed() == word); });
    if (auto *grid = qobject_cast<QGridLayout *>(box->layout())) {
        const int above = grid->rowCount();
        grid->addWidget(label, above, 0, 1, grid->columnCount());
        grid->addWidget(edit, above + 1, 0, 1, grid->columnCount());
    }
    return edit;
}

} // namespace

QDialog *askToConfirm(
    QWidget *parent, const Confirmation &question, std::function<void(bool yes)> answer)
{
    auto *box = new QMessageBox(
        QMessageBox::Warning, question.title, question.text, QMessageBox::NoButton, parent);
    box->setObjectName(QLatin1String(question.objectName));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(question.lines.join(QLatin1Char('\n')));
    QPushButton *yes = box->addButton(question.yes, QMessageBox::DestructiveRole);
    QPushButton *cancel = box->addButton(QMessageBox::Cancel);
    yes->setObjectName(QLatin1String(question.yesName));
    yes->setAutoDefault(false); // Enter does not press it, wherever the focus is
    box->setDefaultButton(cancel);
    box->setEscapeButton(cancel);
    QWidget *first = cancel;
    if (!question.typed.isEmpty())
        first = addTypedLine(box, yes, question.typed);
    auto *held = new HeldKeys(box);
    for (QWidget *widget : std::initializer_list<QWidget *>{box, yes, cancel, first})
        widget->installEventFilter(held);
    QObject::connect(box, &QDialog::finished, box,
        [box, yes, answer = std::move(answer)] { answer(box->clickedButton() == yes); });
    box->open();
    first->setFocus();
    return box;
}

} // namespace widgets
