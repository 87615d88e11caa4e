// MarkerFile: where the markers of what is shown are kept, which of them are in no file, and saving those: Ctrl+S. Into
// an opened recording or a copy of it, into the recording of the connection, or, where there is none, into a list.
#pragma once

#include "session/recording/notes.h"
#include "widgets/base/banner.h"
#include "widgets/scope/events/log.h"

#include <QObject>

#include <functional>
#include <optional>

class QAction;

namespace widgets {

class EventLog;
class FilePrompt;
class RecordingControl;

class MarkerFile : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    MarkerFile(EventLog &events, FilePrompt &files, RecordingControl &record, QWidget *window);

    QAction *save() const { return m_save; }
    /// The log has just been filled from it; once the log is cleared it is no longer open.
    /// @param bytes  of it that were read
    void opened(const QString &path, qint64 bytes);
    void replayed(double seconds); ///< the marker of that time is in the file that is replayed

    enum class Place : std::uint8_t {
        Opened, ///< the recording that is open, or a copy
        Running, ///< the recording that runs
        Recorded, ///< the last recording of the connection
        List, ///< there is no recording for them
    };
    Place place() const; ///< where they would go now
    QString path() const { return m_path; } ///< of the recording, if it is open or has ended

    bool changed() const; ///< there are markers to be saved
    void leave(); ///< the user does not want them saved as they are now
    bool changedSinceLeft() const; ///< there are others to be saved than those
    void saveThen(std::function<void()> goOn); ///< which is not called unless they are saved

Q_SIGNALS:
    void said(widgets::Banner::Kind kind, const QString &sentence);

private:
    void update();
    void updateFor(const QModelIndex &parent, int first, int last);
    bool anyMarker(int first, int last) const;
    void ended(const QString &path, qint64 bytes, const Markers &markers);
    bool isThere() const;
    void askForCopy(std::function<void()> goOn);
    void askForList(std::function<void()> goOn);
    void saveAs(const QString &path, std::function<void()> goOn);
    void saved(const QString &source, const QString &path, const Markers &markers,
        const session::NotesResult &result, const std::function<void()> &goOn);
    QString refusal(const QString &path, const session::NotesResult &result) const;

    EventLog &m_events;
    FilePrompt &m_files;
    RecordingControl &m_record;
    QWidget *m_window;
    QAction *m_save;
    QString m_path; ///< empty: no recording
    bool m_opened = false; ///< by the user, not recorded here
    session::NotesSource m_known; ///< of that file
    Markers m_saved; ///< as the file has them
    Markers m_elsewhere; ///< in earlier recordings, in lists, and in what is replayed
    std::optional<Markers> m_left;
    bool m_markerGoes = false;
};

} // namespace widgets
