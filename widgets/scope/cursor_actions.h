// CursorActions: what is done with the scope's cursors and markers: brings them into view, hands them to the mouse,
// moves them sample by sample, sets them.
#pragma once

#include "widgets/scope/cursors.h"

#include <QObject>

#include <functional>

namespace capture {
class Capture;
class Channel;
} // namespace capture

namespace widgets {

class EventLog;
class PlotStack;
class ScopeMouse;
class TimeWindow;

class CursorActions : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    struct Parts {
        Cursors &cursors;
        EventLog &events;
        TimeWindow &time;
        const PlotStack &stack;
        const capture::Capture &capture;
        ScopeMouse &mouse;
        std::function<void(double)> show; ///< moves the picture, unless it moves by itself
    };
    explicit CursorActions(Parts parts, QObject *parent = nullptr);

public Q_SLOTS:
    void toggle(); ///< C: shows the cursors, inside the picture, or hides them
    /// 1 and 2: the mouse takes this cursor along until the next click or the same key; without a mouse on the
    /// plots it comes into view. Either way arrow keys move it.
    void accept(widgets::CursorEnd end);
    /// Moves the active cursor by so many samples of the selected trace, or of the first one.
    void nudge(int samples);
    /// M: sets a marker at the mouse, else at the active cursor, else at the newest sample or in the middle.
    void setMarker();
    void setMarkerAt(double seconds);

private:
    void place(CursorEnd end, double share);
    const capture::Channel *nudged() const;
    std::optional<double> timeUnderMouse() const;

    Parts m_parts;
};

} // namespace widgets
