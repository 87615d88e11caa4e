// Draws all traces of one plot from the capture: extremes per pixel column when there are many samples, steps and
// dots when there are few, nothing where nothing is known. Cost follows the pixels, not the samples.
// Includes the slow header: only for the scope's own files.
#pragma once

#include "widgets/scope/drawing/drawn_trace.h"
#include "widgets/scope/drawing/record_picture.h"
#include "widgets/scope/drawing/trace_ink.h"
#include "widgets/scope/plot.h"

#include <memory>

namespace widgets {

class WaveformPlottable : public QCPAbstractPlottable {
public:
    /// @param plot  outlives the plottable; its axis rect has a time axis and a value axis already
    WaveformPlottable(const ScopePlot &plot, const capture::Capture &capture);
    ~WaveformPlottable() override;
    WaveformPlottable(const WaveformPlottable &) = delete;
    WaveformPlottable &operator=(const WaveformPlottable &) = delete;

    /// The next picture shows what is there then; until it is told, an exposed window is painted as it was. Moves the
    /// time axis by half a pixel of the screen at most.
    void renew();

    // What the library can ask a plottable for, but is not asked here: the stack fits the ranges.
    double selectTest(const QPointF &, bool, QVariant *) const override { return -1; }
    QCPRange getKeyRange(bool &found, QCP::SignDomain) const override
    {
        found = false;
        return {};
    }
    QCPRange getValueRange(bool &found, QCP::SignDomain domain, const QCPRange &) const override
    {
        return getKeyRange(found, domain);
    }

protected:
    void draw(QCPPainter *painter) override;
    void drawLegendIcon(QCPPainter *, const QRectF &) const override { }

private:
    struct Place; ///< of the picture, on the screen
    struct Ground; ///< what is behind the traces
    struct Picture; ///< what is in m_image
    using Columns = std::vector<ColumnRange>;
    static Place placeOf(const QRect &rect, const QPainter &painter);
    void paintImage(const Place &place);
    Columns goOn(Picture &now);
    void forParts(ColumnRange columns, const std::function<void(int at, QImage &part)> &use);
    std::vector<QCPRange> ranges() const; ///< of the axes, time first
    PictureView viewOf(QSize size, int thickness) const;
    std::vector<DrawnTrace> tracesOf(const PictureView &view) const;
    Ground groundOf(const PictureView &view, const Place &place) const;
    std::vector<capture::TimeSpan> gapsIn(const QCPRange &range, double pixels) const;
    using GhostColor = std::function<QRgb(std::size_t trace)>;
    GhostColor colorsOf(const Ghost &ghost, const PictureView &view) const; ///< premultiplied
    void paintRecords(const PictureView &view);
    void drawGhosts(std::span<const Ghost> ghosts, const PictureView &view, TraceInk &ink) const;
    void drawGhost(
        const Ghost &ghost, const PictureView &view, TraceInk &ink, const GhostColor &color) const;
    void drawMarks(QCPPainter *painter) const;
    void drawTraces(
        const PictureView &view, std::span<const DrawnTrace> traces, TraceInk &ink) const;
    void drawShapes(QCPPainter *painter) const;
    const capture::Channel *channelOf(const Ghost &ghost, const Trace &trace) const;
    void drawSteps(const PictureView &view, const Trace &trace, const capture::Channel &channel,
        QRgb color, TraceInk &ink) const;
    void drawLastValues(QCPPainter *painter) const;

    const ScopePlot &m_scopePlot;
    const capture::Capture &m_capture;
    QImage m_image;
    int m_start = 0; ///< where in it the left column is
    std::unique_ptr<Picture> m_picture;
    std::vector<QCPRange> m_drawn; ///< the ranges of the axes that m_image shows; empty: it is old
    RecordPicture m_records;
};

} // namespace widgets
