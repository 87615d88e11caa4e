// One plot of the scope as data: which channels it shows, on which axes, in which colours. The plot stack changes it,
// the waveform and the legend only read it. Includes the slow header: only for the scope's own files.
#pragma once

#include "capture/capture.h"
#include "widgets/scope/drawing/marks.h"

#include <qcustomplot.h>

#include <vector>

namespace widgets {

struct Trace {
    capture::ChannelId channel = 0;
    capture::ChannelInfo info;
    QCPAxis *valueAxis = nullptr;
    int colorSlot = 0;
    bool selected = false;
    // Since when nothing came; see PlotStack::beat().
    capture::Index end = 0; ///< of its samples at the last beat
    int beats = 0; ///< with the same end
};

/// Its last value counts no more: for 2.4 s, longer than a polled value is drawn (2 s), none came that was waited for.
/// Beats and arrivals are counted, not times: a window may stand still, and a board's clock and ours drift apart.
bool isOld(const Trace &trace, const capture::Capture &capture);

/// The step in which a trace's values are written out: as long as they keep it, their digits keep their places.
double readingStep(const Trace &trace);

/// A value axis and who decides its range.
struct ValueAxis {
    QCPAxis *axis = nullptr;
    QString unit;
    bool automatic = true; ///< grows with the data until it is moved by hand
    bool fitted = false; ///< has shown data at least once
};

class WaveformPlottable;
class TraceLegend;

struct ScopePlot {
    QCPAxisRect *rect = nullptr;
    WaveformPlottable *waveform = nullptr; ///< owned by the QCustomPlot
    TraceLegend *legend = nullptr; ///< owned by the QCustomPlot
    std::vector<ValueAxis> axes;
    std::vector<Trace> traces;
    std::vector<Ghost> ghosts; ///< behind the traces
    bool dark = false; ///< which set of colours
    bool zerosAligned = false; ///< also where that takes much room

    QCPAxis *timeAxis() const { return rect->axis(QCPAxis::atBottom); }
};

} // namespace widgets
