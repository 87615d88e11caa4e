// The plots of the scope, one above the other on one time axis: adds and removes traces, gives each unit its axis
// and each trace its colour, and sets ranges. Knows no mouse, no keys and no following.
// Includes the slow header: only for the scope's own files.
#pragma once

#include "widgets/scope/plot.h"

#include <QMap>

#include <map>
#include <memory>

namespace widgets {

class PlotStack {
public:
    /// Value axes a plot can have; a further unit shares the last one.
    static constexpr int kMostAxes = 4;

    PlotStack(QCustomPlot &plot, const capture::Capture &capture);
    ~PlotStack();
    PlotStack(const PlotStack &) = delete;
    PlotStack &operator=(const PlotStack &) = delete;

    int count() const { return static_cast<int>(m_plots.size()); }
    ScopePlot &plot(int index) { return *m_plots[std::size_t(index)]; }
    const ScopePlot &plot(int index) const { return *m_plots[std::size_t(index)]; }
    int plotAt(const QPointF &position) const; ///< axes included; -1 if there is none
    ValueAxis *valueAxisAt(const QPointF &position); ///< nullptr if it is not over a value axis

    /// @param index  of the plot, clipped; count() makes a new one
    /// @param alone  in a new plot that takes this place
    void add(const capture::ChannelInfo &channel, int index, bool alone = false);
    void remove(capture::ChannelId channel);
    /// @param index  as in add(); a plot that loses its last trace vanishes
    /// @return  false if it is not shown, or there already
    bool move(capture::ChannelId channel, int index);
    const Trace *trace(capture::ChannelId channel) const;
    std::vector<capture::ChannelId> channels() const;
    int plotOf(capture::ChannelId channel) const;
    QColor colorOf(capture::ChannelId channel) const;
    /// By the user, for every signal of this name; empty: one is found for it again.
    void setColor(const QString &name, std::optional<int> slot);
    void setChosenColors(const QMap<QString, int> &slotsByName) { m_chosen = slotsByName; }
    const QMap<QString, int> &chosenColors() const { return m_chosen; }
    std::optional<double> newestSample() const; ///< seconds; of the traces shown
    /// Follows registers into their new channels after the capture was cleared; drops those that have none.
    bool adoptChannels(); ///< true if anything changed
    /// Five times a second. @param waits  for samples: no file. @return  the last value of a trace counts no more
    bool beat(bool waits);
    void select(std::optional<capture::ChannelId> channel);
    std::optional<capture::ChannelId> selected() const;

    void setTimeRange(double from, double to);
    void setTimeOrigin(double seconds); ///< what the labels of the time axis call zero
    /// Fits automatic axes to what is visible: they grow, and never shrink by themselves.
    void growAxes();
    void fitValues(); ///< all axes, exactly what is visible
    void fitAxis(ValueAxis &axis);
    /// Of the axes that were set by hand, by the name of a signal on each; those of signals that were never shown, too.
    QMap<QString, ValueRange> heldRanges() const;
    /// Once their signals are shown; the other axes fit themselves.
    void setHeldRanges(const QMap<QString, ValueRange> &ranges);
    /// The zeros of a plot's axes stand at one height by themselves where that takes little room; this way in any case.
    void setZerosAligned(int plot, bool aligned);

    void setGhosts(std::vector<Ghost> ghosts); ///< drawn in every plot that shows their registers
    /// Room left of the plots, at least, for what stands above and below there.
    void setLeastLeft(int pixels);
    void setGrid(bool visible);
    bool grid() const { return m_grid; }
    void applyPalette(const QPalette &palette);
    /// As many ticks as there is room for, what is between two of them in the axes' labels, and room above each plot
    /// for its legend; before each redraw.
    void layOut();
    void renew(); ///< the traces, with the next picture
    double timeStep() const; ///< seconds between two ticks of the time axis

private:
    std::vector<Trace *> traces() const; ///< of all plots, from the top
    ScopePlot &insert(int index);
    void removePlot(std::size_t index);
    void showTimeLabels();
    QMargins margins() const; ///< the least around a plot without a legend
    void makeRoom(ScopePlot &plot) const;
    void labelAxis(const ScopePlot &plot, const ValueAxis &axis) const;
    int ticksOf(const ScopePlot &plot) const; ///< of its value axes, at most
    int timeTicks() const;
    ValueAxis &axisFor(ScopePlot &plot, const QString &unit);
    void adoptHeldRange(const Trace &trace, ValueAxis &axis);
    void dropUnusedAxes(ScopePlot &plot);
    void styleAxis(QCPAxis &axis) const;
    void labelAxes(ScopePlot &plot);
    int slotFor(const capture::ChannelInfo &channel);
    void forgetColor();
    double leastSpanOf(const ScopePlot &plot, const ValueAxis &axis) const;
    static void alignZeros(ScopePlot &plot);
    capture::MinMax extremes(const ScopePlot &plot, const QCPAxis *axis) const;

    QCustomPlot &m_plot;
    const capture::Capture &m_capture;
    std::vector<std::unique_ptr<ScopePlot>> m_plots;
    /// A register keeps its colour, even while it is not shown.
    std::map<catalog::RegisterId, int> m_slots;
    QMap<QString, int> m_chosen; ///< slots that the user chose, by the name of the signal
    QMap<QString, ValueRange> m_held; ///< of axes that wait for their signal, by its name
    QCPMarginGroup *m_margins = nullptr;
    QPalette m_palette;
    double m_origin = 0.0;
    int m_leastLeft = 8; ///< pixels
    QRect m_laidOut; ///< the viewport that the plots were laid out for
    bool m_grid = true;
};

} // namespace widgets
