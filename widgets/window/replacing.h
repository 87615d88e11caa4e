// Replacing: what is asked before samples and markers that are in no file go: when a file takes their place, with a
// connection, and at the end.
#pragma once

#include "widgets/base/question.h"

#include <QObject>

namespace widgets {

class MarkerFile;
class RecordingControl;
class Workbench;

class Replacing : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    struct Parts {
        Workbench &workbench;
        MarkerFile &markers;
        const RecordingControl &record;
        QuestionPrompt &prompt;
    };
    explicit Replacing(const Parts &parts, QObject *parent = nullptr);

    /// Asks before samples of a board or markers go that are in no file; goes on at once if there are none.
    void before(std::function<void()> goOn);
    /// Asks before changed markers go; goes on at once if there are none, and once they are saved.
    void beforeMarkersGo(const std::function<void()> &goOn);
    /// Asks before samples go that are in no file. What happened in a file goes with it; markers of a connection and of
    /// a replay stay.
    void clear();
    void exported(std::uint64_t revision) { m_exported = revision; } ///< all of the capture

Q_SIGNALS:
    void exportWanted(); ///< first

private:
    bool samplesAreKept() const;
    QString markersText() const;

    Parts m_parts;
    std::uint64_t m_exported = 0; ///< revision of the capture, when all of it was exported
};

} // namespace widgets
