// RecordingControl: what the user has of recording to a disk: its actions, the line that says what is written where,
// and the events and marks on the clock of the traces. The file itself is session::Recording's, in a thread of its own.
#pragma once

#include "session/recording/recording.h"
#include "widgets/base/banner.h"
#include "widgets/base/device.h"
#include "widgets/scope/events/log.h"

#include <QObject>

class QAction;
class QModelIndex;

namespace widgets {

class EventLog;
class FilePrompt;
class Lamp;

class RecordingControl : public QObject {
    Q_OBJECT
public:
    struct Parts { ///< all outlive it
        session::Recording &recording;
        Device &device;
        EventLog &events;
        FilePrompt &files;
        std::function<double()> now; ///< seconds on the session's axis
    };
    RecordingControl(Parts parts, const QString &folder, QWidget *window);

    /// Ctrl+R: asks for a file and records; again: ends it.
    QAction *toggle() const { return m_toggle; }
    QAction *withLink() const { return m_withLink; }
    static QStringList signs(); ///< what the action shows where there is little room
    Lamp *line() const { return m_line; } ///< hidden until something is recorded
    QString folder() const { return m_folder; } ///< of the last recording
    /// True if all samples in it are in the last recording, which ended whole and is still on its disk.
    bool holds(const capture::Capture &capture) const;
    void markersSaved(const QString &path, qint64 bytes); ///< into that file, behind what it held
    /// The markers that the recording which runs was told; nullptr: none runs, or what is shown is not of it any more.
    const Markers *told() const;
    void tellMarkers(); ///< all that there are, also those that were set before it began

Q_SIGNALS:
    void said(widgets::Banner::Kind kind, const QString &sentence);
    /// A recording of what is shown has ended, and is on its disk.
    /// @param markers  that it surely has
    void ended(const QString &path, qint64 bytes, const widgets::Markers &markers);

private:
    void ask();
    void start(const QString &path);
    void started(const QString &path);
    void progressed(const session::RecordingProgress &progress);
    void finished(const session::RecordingResult &result);
    void update();
    void recordMarks(const QModelIndex &parent, int first, int last);
    void takeBackMarks(int first, int last);

    Parts m_parts;
    QString m_folder;
    QString m_name; ///< of the file, fit to be shown
    QAction *m_toggle;
    QAction *m_withLink;
    Lamp *m_line;
    double m_start = 0.0; ///< of the recording, on the session's axis
    struct Kept {
        QString path;
        qint64 bytes = 0;
        recorded::Coverage coverage;
    };
    std::optional<Kept> m_kept; ///< the last recording, if nothing is missing from it
    std::optional<Markers> m_told; ///< by the recording that runs or is ending
};

/// "2026-05-04_13-02-59_motor.pcapng"
QString suggestedRecordingName(const QDateTime &now);

/// "1:02:03" hours, minutes, seconds.
QString durationText(double seconds);

} // namespace widgets
