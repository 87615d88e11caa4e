#include "widgets/base/confirmation.h"

#include "widgets/base/look/named.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QKeySequence>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>

namespace widgets {
namespace {

struct ConfirmationText {
    Q_DECLARE_TR_FUNCTIONS(Confirmation)
};

/// With a letter of its own, which Cancel does not have.
QString withKey(const QString &text, const QPushButton &cancel)
{
    const QString taken = QKeySequence::mnemonic(cancel.text()).toString().right(1);
    for (qsizetype i = 0; i < text.size() && !text.contains(QLatin1Char('&')); ++i)
        if (text[i].isLetter() && text[i].unicode() < 128
            && QString(text[i]).compare(taken, Qt::CaseInsensitive) != 0)
            return QString(text).insert(i, QLatin1Char('&'));
    return text;
}

/// A key that was held before the question came must not answer it; Enter behind the word that had to be typed does. A
/// letter alone answers nothing: a box of messages would take it for Alt and the letter, and single letters are keys of
/// the scope.
class HeldKeys : public QObject {
public:
    HeldKeys(QPushButton *yes, QObject *parent)
        : QObject(parent)
        , m_yes(yes)
    {
    }
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() != QEvent::KeyPress)
            return false;
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
        if (key->isAutoRepeat())
            return enter || key->key() == Qt::Key_Space;
        if (watched->inherits("QMessageBox") && !key->text().isEmpty() && key->text()[0].isPrint()
            && (key->modifiers() & (Qt::AltModifier | Qt::ControlModifier | Qt::MetaModifier)) == 0)
            return true;
        if (!enter || qobject_cast<QLineEdit *>(watched) == nullptr)
            return false;
        if (m_yes->isEnabled()) // the word was typed: that is no Enter by mistake
            m_yes->click();
        return true;
    }

private:
    QPushButton *m_yes;
};

/// Above the buttons, which the box keeps in its last row.
void addAboveButtons(QMessageBox *box, std::initializer_list<QWidget *> widgets)
{
    auto *grid = qobject_cast<QGridLayout *>(box->layout());
    auto *buttons = box->findChild<QDialogButtonBox *>();
    if (!grid || !buttons)
        return;
    grid->removeWidget(buttons);
    int row = grid->rowCount();
    for (QWidget *widget : widgets)
        grid->addWidget(widget, row++, 0, 1, grid->columnCount());
    grid->addWidget(buttons, row, 0, 1, grid->columnCount());
}

/// A line that enables `yes` once it holds the word.
QLineEdit *addTypedLine(QMessageBox *box, QPushButton *yes, const QString &word)
{
    auto *label =
        new QLabel(ConfirmationText::tr("Type \"%1\" to continue:", "a word").arg(word), box);
    label->setTextFormat(Qt::PlainText);
    auto *edit = named(new QLineEdit(box), "confirmationTyped", label->text());
    label->setBuddy(edit);
    yes->setEnabled(false);
    QObject::connect(edit, &QLineEdit::textChanged, yes,
        [yes, word](const QString &text) { yes->setEnabled(text.trimmed() == word); });
    addAboveButtons(box, {label, edit});
    return edit;
}

} // namespace

QDialog *askToConfirm(
    QWidget *parent, const Confirmation &question, std::function<void(bool yes)> answer)
{
    auto *box = named(new QMessageBox(QMessageBox::Warning, question.title, question.text,
                          QMessageBox::NoButton, parent),
        question.objectName);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(question.lines.join(QLatin1Char('\n')));
    QPushButton *cancel = box->addButton(QMessageBox::Cancel);
    QPushButton *yes = box->addButton(withKey(question.yes, *cancel), QMessageBox::DestructiveRole);
    yes->setObjectName(QLatin1String(question.yesName));
    yes->setAutoDefault(false); // Enter does not press it, wherever the focus is
    box->setDefaultButton(cancel);
    box->setEscapeButton(cancel);
    if (!question.offer.isEmpty())
        box->setCheckBox(named(new QCheckBox(question.offer), "confirmationOffer"));
    if (question.picture != nullptr)
        addAboveButtons(box, {question.picture});
    QWidget *first = cancel;
    if (!question.typed.isEmpty())
        first = addTypedLine(box, yes, question.typed);
    auto *held = new HeldKeys(yes, box);
    for (QWidget *widget : std::initializer_list<QWidget *>{box, yes, cancel, first})
        widget->installEventFilter(held);
    QObject::connect(box, &QDialog::finished, box,
        [box, yes, onOffer = question.onOffer, answer = std::move(answer)] {
            const bool agreed = box->clickedButton() == yes;
            if (agreed && box->checkBox() && box->checkBox()->isChecked())
                onOffer();
            answer(agreed);
        });
    box->open();
    first->setFocus();
    return box;
}

} // namespace widgets
