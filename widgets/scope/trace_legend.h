// The legend of one plot: a coloured mark, the name, the last value and the unit of each trace. Tells which trace is
// under the mouse. Includes the slow header: only for the scope's own files.
#pragma once

#include "widgets/scope/scope_plot.h"

namespace widgets {

class TraceLegend : public QCPLayerable {
public:
    TraceLegend(const ScopePlot &plot, const capture::Capture &capture);

    /// The channel whose entry is at `position` of the plot widget.
    std::optional<capture::ChannelId> channelAt(const QPointF &position) const;

protected:
    void applyDefaultAntialiasingHint(QCPPainter *painter) const override;
    void draw(QCPPainter *painter) override;

private:
    const ScopePlot &m_scopePlot;
    const capture::Capture &m_capture;
    std::vector<std::pair<QRectF, capture::ChannelId>> m_entries; ///< where they were drawn
};

} // namespace widgets
