// TimeWindow: which time the scope's plots show, where in them a time is, what is called zero, and whether the right
// edge follows the newest sample. Times are seconds on the session's axis.
#pragma once

#include <QObject>

#include <optional>

namespace widgets {

class PlotStack;

class TimeWindow : public QObject {
    Q_OBJECT
public:
    struct Range {
        double from = 0.0, to = 1.0;
        double span() const { return to - from; }
        bool has(double seconds) const { return seconds >= from && seconds <= to; }
    };
    static constexpr double kLeastSpan = 1e-6;

    /// The plots outlive it.
    explicit TimeWindow(PlotStack &stack, QObject *parent = nullptr);

    Range range() const { return m_range; }
    double origin() const { return m_origin; } ///< what the axis and the cursors call zero
    bool following() const { return m_following; } ///< the right edge stays at the newest sample
    double step() const; ///< between two lines of the grid
    double timeAt(double x) const; ///< `x` in pixels of the plots' widget
    double xOf(double seconds) const;
    /// This time stays where it is when the picture is zoomed, if it is in it.
    void setAnchor(std::optional<double> seconds) { m_anchor = seconds; }

public Q_SLOTS:
    void set(double from, double to); ///< ends following
    void setFollowing(bool following);
    void follow(); ///< the newest sample comes to the right edge
    /// > 1 shows less time; around the centre, or the right edge while following.
    void zoom(double factor);
    void pan(double fraction); ///< of what is shown, positive to later
    void centerOn(double seconds); ///< ends following
    void show(double seconds); ///< moves just so far
    void setOrigin(double seconds);

Q_SIGNALS:
    void changed(double from, double to);
    void followingChanged(bool following);
    void originChanged(double seconds);
    void redrawWanted();

private:
    void apply(Range range);

    PlotStack &m_stack;
    Range m_range{0.0, 5.0};
    std::optional<double> m_anchor;
    double m_origin = 0.0;
    bool m_following = true;
};

} // namespace widgets
