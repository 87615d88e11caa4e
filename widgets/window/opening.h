// Opening: what takes the place of a connection and of what it recorded: a recording, a replay, a CSV file, another
// port. It leaves what is there first, asks about what is in no file, reads, and shows what it read.
#pragma once

#include "capture/capture.h"
#include "widgets/base/banner.h"
#include "widgets/snapshots/panel.h"

#include <QObject>

#include <functional>

namespace widgets {

class FilePrompt;
class Leaving;
class MarkerFile;
class Replacing;
class SignalSelection;
class Workbench;
struct OpenedRecording;
struct OpenQuestion;
class QuestionPrompt;

class Opening : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    struct Parts {
        Workbench &workbench;
        SignalSelection &selection;
        MarkerFile &markers;
        Leaving &leaving;
        Replacing &replacing;
        FilePrompt &files;
        std::function<bool()> connecting; ///< a connection is open or looked for
        std::function<QString()> recordFolder, exportFolder; ///< of the last files
        QuestionPrompt &prompt;
        QWidget *window; ///< dialogs are over it; tests do without
        /// Lays a recording beside what is shown; a sentence, and in `good` whether it is. None: it cannot.
        std::function<QString(OpenedRecording &, bool &good)> lay = {};
        /// Bytes of a file whose outline is shown until it is read.
        qint64 outlineFrom = 64'000'000;
    };
    explicit Opening(Parts parts, QObject *parent = nullptr);

    /// Of the recording that was opened last.
    const RecordedSnapshots &snapshots() const { return m_snapshots; }
    QString shown() const { return m_shown; } ///< path of the file that took the scope's place last
    void beforeConnecting(std::function<void()> goOn); ///< to a port

    /// Goes on as soon as no connection is open.
    void whenDisconnected(std::function<void()> goOn);

public Q_SLOTS:
    void askForRecording(); ///< Ctrl+O
    void askForReference(); ///< a recording behind what is shown, also of a board
    void askForReplay(); ///< as if its board were there
    void askForCsv();
    void openPath(const QString &path); ///< a recording, or CSV by its suffix
    void layBeside(const QString &path); ///< a recording as a reference

Q_SIGNALS:
    void said(widgets::Banner::Kind kind, const QString &sentence);
    void replayWanted(const QString &path);
    /// With what whenDisconnected() is to be given.
    void disconnectWanted(std::function<void()> goOn);
    void snapshotsChanged();
    void used(const QString &path); ///< was opened
    /// Extremes of what is being read, which are no samples to be kept.
    void outlineShown(bool there);

private:
    using Opened = std::function<void(const QString &path)>;
    void ask(const OpenQuestion &question, Opened open);
    bool isFree(const QString &title, const QString &text, const std::function<void()> &again,
        const std::function<void()> &lay = {});
    void leaveThen(std::function<void()> go);
    void replaceThen(std::function<void()> go);
    void open(const QString &path);
    void read(const QString &path);
    void showOutline(const QString &path, capture::Capture &outline);
    void replay(const QString &path);
    void import(const QString &path);
    void show(OpenedRecording &opened);
    void showImported(const QString &path, capture::Capture &imported, std::uint64_t leftOut);
    capture::Capture::Config forFiles() const;
    void warn(const QString &sentence);

    Parts m_parts;
    RecordedSnapshots m_snapshots;
    QString m_shown;
    bool m_outline = false; ///< is shown, of what is being read
    std::function<void()> m_next; ///< once the connection is closed
    bool m_agreed = false; ///< before that: what the scope holds may go
};

} // namespace widgets
