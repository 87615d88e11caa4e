#include "widgets/base/file_prompt.h"

#include <QDir>
#include <QFileDialog>

namespace widgets {

namespace {

void openDialog(QFileDialog *dialog, const char *name, QWidget *parent, FilePrompt::Answer answer)
{
    dialog->setObjectName(QLatin1String(name));
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

QString orHome(const QString &folder) { return folder.isEmpty() ? QDir::homePath() : folder; }

void FilePrompt::askSave(QWidget *parent, const SaveQuestion &question, Answer answer)
{
    auto *dialog = new QFileDialog(parent, question.title, question.folder, question.filter);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(question.suffix);
    dialog->selectFile(question.suggestedName);
    openDialog(dialog, "saveDialog", parent, std::move(answer));
}

void FilePrompt::askOpen(QWidget *parent, const OpenQuestion &question, Answer answer)
{
    auto *dialog = new QFileDialog(parent, question.title, question.folder, question.filter);
    dialog->setFileMode(QFileDialog::ExistingFile);
    openDialog(dialog, "openDialog", parent, std::move(answer));
}

void FilePrompt::askFolder(QWidget *parent, const FolderQuestion &question, Answer answer)
{
    auto *dialog = new QFileDialog(parent, question.title, question.folder);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    openDialog(dialog, "folderDialog", parent, std::move(answer));
}

} // namespace widgets
