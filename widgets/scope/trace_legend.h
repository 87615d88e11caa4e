// The legend of one plot: a coloured mark, the name, the last value (a dash once it counts no more) and the unit of
// each trace, in lines above the plot so that it covers no trace. Tells which trace is under the mouse. Includes the
// slow header: only for the scope's own files.
#pragma once

#include "widgets/scope/plot.h"

namespace widgets {

class TraceLegend : public QCPLayerable {
public:
    TraceLegend(const ScopePlot &plot, const capture::Capture &capture);

    void setNote(const QString &note) { m_note = note; } ///< at the right end of the first line
    int height() const; ///< pixels that its lines need above a plot as wide as this one is now

    /// The channel whose entry is at `position` of the plot widget.
    std::optional<capture::ChannelId> channelAt(const QPointF &position) const;

protected:
    void applyDefaultAntialiasingHint(QCPPainter *painter) const override;
    void draw(QCPPainter *painter) override;

private:
    struct Entry {
        const Trace *trace;
        QString text;
        QRectF box; ///< from the corner above which the legend begins
    };
    std::vector<Entry> entries() const;
    double lineHeight() const;

    const ScopePlot &m_scopePlot;
    const capture::Capture &m_capture;
    QString m_note;
    std::vector<std::pair<QRectF, capture::ChannelId>> m_entries; ///< where they were drawn
};

} // namespace widgets
