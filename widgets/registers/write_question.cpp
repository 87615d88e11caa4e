#include "widgets/registers/write_question.h"

#include "widgets/base/confirmation.h"

#include <QCoreApplication>
#include <QPointer>

#include <algorithm>

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
        ? WriteQuestion::tr("%1 (gain changes by more than a factor of 2 while running)").arg(where)
        : where;
}

} // namespace

void askBeforeWriting(QWidget *parent, RegisterEdits &edits, const QList<WriteLine> &lines)
{
    // What acts stands first and is never folded away behind gains.
    QList<WriteLine> sorted = lines;
    const auto parameters = std::stable_partition(
        sorted.begin(), sorted.end(), [](const WriteLine &line) { return line.acts; });
    const auto shown =
        std::min(sorted.size(), std::max(kMostLines, qsizetype(parameters - sorted.begin())));
    QStringList texts;
    for (const WriteLine &line : sorted.first(shown))
        texts.append(lineText(line));
    if (sorted.size() > shown)
        texts.append(
            WriteQuestion::tr("and %n more", nullptr, static_cast<int>(sorted.size() - shown)));
    Confirmation question;
    question.objectName = "writeQuestion";
    question.title = WriteQuestion::tr("Write registers");
    question.text = WriteQuestion::tr("This can move or harm a motor immediately.");
    question.lines = texts;
    question.yesName = "writeAnyway";
    question.yes = WriteQuestion::tr("Write");
    askToConfirm(parent, question, [edits = QPointer(&edits)](bool yes) {
        if (edits)
            yes ? edits->confirm() : edits->decline();
    });
}

} // namespace widgets
