#include "widgets/file_prompt.h"

#include <QFileDialog>

namespace widgets {

void FilePrompt::askSave(QWidget *parent, const SaveQuestion &question, Answer answer)
{
    auto *dialog = new QFileDialog(parent, question.title, question.folder, question.filter);
    dialog->setObjectName(QStringLiteral("saveDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(question.suffix);
    dialog->selectFile(question.suggestedName);
    QObject::connect(dialog, &QFileDialog::fileSelected, parent,
        [answer = std::move(answer)](const QString &path) {
            if (!path.isEmpty())
                answer(path);
        });
    dialog->open();
}

} // namespace widgets
