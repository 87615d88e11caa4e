#include "widgets/write_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace widgets {
namespace {

constexpr qsizetype kMostLines = 12;

struct WriteQuestion {
    Q_DECLARE_TR_FUNCTIONS(WriteQuestion)
};

QString lineText(const WriteLine &line)
{
    const QString was =
        line.was.isEmpty() ? WriteQuestion::tr("not known", "the old value") : line.was;
    const QString change = QStringLiteral("%1: %2 \u2192 %3").arg(line.name, was, line.becomes);
    const QString where = line.motor > 0 ? WriteQuestion::tr("Motor %1, %2", "number, change")
                                               .arg(QString::number(line.motor), change)
                                         : WriteQuestion::tr("Board, %1", "change").arg(change);
    return line.caution == catalog::Caution::GainJump
        ? WriteQuestion::tr("%1 (a gain, by more than 2 while the motor runs)").arg(where)
        : where;
}

} // namespace

void askBeforeWriting(QWidget *parent, RegisterEdits &edits, const QList<WriteLine> &lines)
{
    QStringList texts;
    for (const WriteLine &line : lines.first(std::min(lines.size(), kMostLines)))
        texts.append(lineText(line));
    if (lines.size() > kMostLines)
        texts.append(
            WriteQuestion::tr("and %n more", nullptr, static_cast<int>(lines.size() - kMostLines)));
    auto *box = new QMessageBox(QMessageBox::Warning, WriteQuestion::tr("Write registers"),
        WriteQuestion::tr("This can move or harm a motor at once."), QMessageBox::NoButton, parent);
    box->setObjectName(QStringLiteral("writeQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(texts.join(QLatin1Char('\n')));
    QPushButton *write = box->addButton(WriteQuestion::tr("Write"), QMessageBox::DestructiveRole);
    QPushButton *cancel = box->addButton(QMessageBox::Cancel);
    write->setObjectName(QStringLiteral("writeAnyway"));
    write->setAutoDefault(false); // Enter does not press it, wherever the focus is
    box->setDefaultButton(cancel);
    box->setEscapeButton(cancel);
    QObject::connect(
        box, &QMessageBox::buttonClicked, &edits, [&edits, write](QAbstractButton *button) {
            button == write ? edits.confirm() : edits.decline();
        });
    box->open();
    cancel->setFocus();
}

} // namespace widgets
