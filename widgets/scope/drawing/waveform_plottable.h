// Draws all traces of one plot from the capture: extremes per pixel column when there are many samples, steps and
// dots when there are few, nothing where nothing is known. Cost follows the pixels, not the samples.
// Includes the slow header: only for the scope's own files.
#pragma once

#include "widgets/scope/drawing/record_picture.h"
#include "widgets/scope/drawing/trace_ink.h"
#include "widgets/scope/scope_plot.h"

namespace widgets {

class WaveformPlottable : public QCPAbstractPlottable {
public:
    /// @param plot  outlives the plottable; its axis rect has a time axis and a value axis already
    WaveformPlottable(const ScopePlot &plot, const capture::Capture &capture);

    /// The next picture shows what is there then; until it is told, an exposed window is painted as it was.
    void renew() { m_drawn.clear(); }

    // What the library can ask a plottable for, and nobody here does: the stack fits the ranges.
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
    struct View; ///< the picture's size and time range, for one redraw
    struct Place; ///< of the picture, on the screen
    static Place placeOf(const QRect &rect, const QPainter &painter);
    void shadeGaps(const std::function<void(double left, double width)> &shade) const;
    void paintGround(QRgb ground, const Place &place);
    using GhostColor = std::function<QRgb(std::size_t trace)>;
    GhostColor colorsOf(const Ghost &ghost, const View &view) const; ///< premultiplied
    void paintRecords(const View &view);
    void drawGhosts(std::span<const Ghost> ghosts, const View &view, TraceInk &ink) const;
    void drawGhost(
        const Ghost &ghost, const View &view, TraceInk &ink, const GhostColor &color) const;
    void drawMarks(QCPPainter *painter) const;
    void drawTraces(const View &view, TraceInk &ink) const;
    void drawShapes(QCPPainter *painter) const;
    void paintImage(const Place &place);
    std::vector<QCPRange> ranges() const; ///< of the axes, time first
    View viewOf(QSize size, int thickness) const;
    const capture::Channel *channelOf(const Ghost &ghost, const Trace &trace) const;
    /// A trace as pixels; of an angle the pieces beyond its end beside them, so that no stroke joins the two.
    struct Strokes {
        PixelColumns columns;
        PixelColumns beyond;
    };
    Strokes strokesOf(const View &view, const Trace &trace, const capture::Channel &channel) const;
    void splitTurns(const View &view, const Trace &trace, const capture::Channel &channel,
        const std::vector<capture::MinMax> &extremes, Strokes &strokes) const;
    void drawSteps(const View &view, const Trace &trace, const capture::Channel &channel,
        QRgb color, TraceInk &ink) const;
    void drawLastValues(QCPPainter *painter) const;

    const ScopePlot &m_scopePlot;
    const capture::Capture &m_capture;
    QImage m_image; ///< kept between redraws: allocating it anew costs more than clearing it
    std::vector<QCPRange> m_drawn; ///< the ranges of the axes that m_image shows; empty: it is old
    RecordPicture m_records;
};

} // namespace widgets
