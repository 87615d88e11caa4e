// SetPointTrace: the set-points as they were sent, computed: each begins at the instant at which its bytes left, on the
// axis of the samples, and goes its way in the time that was asked for. A reference that is read from the board comes
// up to 100 ms late. What the board makes of it is the board's.
//
// Where what was sent does not tell the value there is a gap: on a ramp whose start was not sent, behind a stop, behind
// what may not have arrived. A motor that stands ramps nothing: what waits for its start is a step.
//
// It stays a moment behind, because when a set-point left is known only when its answer has come.
#pragma once

#include "capture/capture.h"
#include "drive/set_points/times.h"

#include <QObject>

#include <map>
#include <optional>
#include <vector>

namespace widgets {

class ScopeView;

class SetPointTrace : public QObject {
    Q_OBJECT
public:
    static constexpr double kBehind_s = 0.3;

    /// Both outlive it.
    SetPointTrace(capture::Capture &capture, ScopeView &scope, QObject *parent = nullptr);

    bool shown() const { return m_shown; }

public Q_SLOTS:
    void accept(const drive::SentSetPoint &sent);
    void finish(const drive::SetPointsEnd &end);
    void advance(double now); ///< of the session's clock
    void end(); ///< the connection's
    void setShown(bool shown);

Q_SIGNALS:
    void shownChanged(bool shown);

private:
    using Kind = drive::SentSetPoint::Kind;
    using Key = std::pair<Kind, int>; ///< what, of which motor
    struct Way {
        std::optional<double> from, to; ///< empty: not known
        double begin_s = 0.0, ramp_s = 0.0;
        bool runs = true; ///< the board goes it
        std::optional<double> at(double seconds) const;
    };
    struct Drawn {
        capture::ChannelId channel = 0;
        double until_s = 0.0; ///< it is drawn
        Way now;
        std::vector<Way> next; ///< those that begin later
        const Way &last() const { return next.empty() ? now : next.back(); }
    };
    static void stay(Drawn &drawn, double from_s, std::optional<double> value);
    void draw(const Key &key, Drawn &drawn, double until_s);
    void follow(Drawn &drawn, double until_s);
    void makeChannel(const Key &key, Drawn &drawn);
    void takenOff(quint32 channel);

    capture::Capture &m_capture;
    ScopeView &m_scope;
    std::map<Key, Drawn> m_drawn;
    std::map<int, double> m_ended; ///< of each motor; 0: of all
    double m_ahead_s = 0.0; ///< of the samples' axis
    bool m_shown = false;
};

} // namespace widgets
