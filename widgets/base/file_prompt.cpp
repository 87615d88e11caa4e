#include "widgets/base/file_prompt.h"

#include <QFileDialog>

namespace widgets {

namespace {

void openDialog(QFileDialog *dialog, QWidget *parent, FilePrompt::Answer answer)
{
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    QObject::connect(dialog, &QFileDialog::fileSelected, parent,
        [answer = std::move(answer)](const QString &path) {
            if (!path.isEmpty())
                answer(path);
        });
    dialog->open();
}

} // namespace

void FilePrompt::askSave(QWidget *parent, const SaveQuestion &question, Answer answer)
{
    auto *dialog = new QFileDialog(parent, question.title, question.folder, question.filter);
    dialog->setObjectName(QStringLiteral("saveDialog"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(question.suffix);
    dialog->selectFile(question.suggestedName);
    openDialog(dialog, parent, std::move(answer));
}

void FilePrompt::askOpen(QWidget *parent, const OpenQuestion &question, Answer answer)
{
    auto *dialog = new QFileDialog(parent, question.title, question.folder, question.filter);
    dialog->setObjectName(QStringLiteral("openDialog"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    openDialog(dialog, parent, std::move(answer));
}

void FilePrompt::askFolder(QWidget *parent, const FolderQuestion &question, Answer answer)
{
    auto *dialog = new QFileDialog(parent, question.title, question.folder);
    dialog->setObjectName(QStringLiteral("folderDialog"));
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    openDialog(dialog, parent, std::move(answer));
}

} // namespace widgets
