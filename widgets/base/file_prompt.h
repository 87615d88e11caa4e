// Asking for a file name, so that tests can give the answer. While a link is open the dialog is Qt's own: a native one
// can live in another process and hide the Esc key that stops the motors.
#pragma once

#include <QString>

#include <functional>

class QWidget;

namespace widgets {

struct SaveQuestion {
    QString title;
    QString folder;
    QString suggestedName;
    QString filter; ///< e.g. "CSV files (*.csv)"
    QString suffix; ///< added if the user typed none
};

struct OpenQuestion {
    QString title;
    QString folder;
    QString filter; ///< as in SaveQuestion
};

struct FolderQuestion {
    QString title;
    QString folder; ///< in which it is looked for
};

/// That folder; the user's own where there is none yet.
QString orHome(const QString &folder);

/// Calls back with the path chosen; not at all if the user gave up. Existing files are asked about.
class FilePrompt {
public:
    using Answer = std::function<void(const QString &path)>;

    virtual ~FilePrompt() = default;
    virtual void askSave(QWidget *parent, const SaveQuestion &question, Answer answer);
    /// A file that exists.
    virtual void askOpen(QWidget *parent, const OpenQuestion &question, Answer answer);
    /// One that exists.
    virtual void askFolder(QWidget *parent, const FolderQuestion &question, Answer answer);
};

} // namespace widgets
