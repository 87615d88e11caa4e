// MarkerFile: the markers of an opened recording as its file has them, what a person changed of them since, and saving
// that: Ctrl+S. What is not of a recording, such as an imported CSV file, has none.
#pragma once

#include "session/recording_notes.h"
#include "widgets/window/banner.h"

#include <QObject>

#include <functional>
#include <map>
#include <optional>

class QAction;

namespace widgets {

class EventLog;
class FilePrompt;

class MarkerFile : public QObject {
    Q_OBJECT
public:
    /// Log and prompt outlive it. @param shown  true while the scope shows a file
    MarkerFile(EventLog &events, FilePrompt &files, std::function<bool()> shown, QWidget *window);

    QAction *save() const { return m_save; }
    /// The log has just been filled from it; once the log is cleared it is no longer open.
    /// @param bytes  of it that were read
    void opened(const QString &path, qint64 bytes);
    bool changed() const; ///< there are markers to be saved
    void leave(); ///< a person does not want them saved as they are now
    bool changedSinceLeft() const; ///< there are others to be saved than those
    void update(); ///< the action, when what is shown has changed

Q_SIGNALS:
    void said(widgets::Banner::Kind kind, const QString &sentence);

private:
    using Markers = std::map<record::Nanos, QString>;
    Markers markers() const; ///< of the log
    void ask();
    void saveAs(const QString &path);
    QString refusal(const QString &path, const session::NotesResult &result) const;

    EventLog &m_events;
    FilePrompt &m_files;
    std::function<bool()> m_shown;
    QWidget *m_window;
    QAction *m_save;
    QString m_path; ///< empty: no recording
    session::NotesSource m_known; ///< of that file
    Markers m_saved; ///< as the file has them
    std::optional<Markers> m_left;
};

} // namespace widgets
