// The bounds within which a motor may be moved by a program alone: what breaks them ends the experiment with a Stop.
// Looked at with every packet of samples and every reading, in the thread of the link. It sends nothing.
//
// Bounds of speed and current are absolute and of one sample each: none is averaged away. Silence is a bound, too,
// because a motor that tells nothing is not under control: of samples, and of each polled figure that is bounded. A
// bound of zero holds nothing.
#pragma once

#include "drive/event.h"

#include <optional>
#include <string>

namespace lab {

struct Caps {
    double leastRpm = 0.0, mostRpm = 0.0;
    double mostAmps = 0.0; ///< magnitude of Iq, and of Id
    double leastBus_v = 0.0, mostBus_v = 0.0;
    double mostTemperature_c = 0.0;
    Duration silence = std::chrono::milliseconds(500);
};

/// What the envelope has to know of the motor's signals; registers of this motor, 0: not there.
struct Watched {
    int motor = 1;
    drive::RegisterId speed = 0, current = 0, currentD = 0; ///< streamed, but for `polled`
    drive::RegisterId bus = 0, temperature = 0; ///< polled
    /// Streamed; where the speed is not, it is how far this goes in a packet.
    drive::RegisterId angle = 0;
    double polePairs = 0.0;
    bool polled = false; ///< speed and current are, and their samples are readings
};

class Envelope {
public:
    explicit Envelope(Watched watched)
        : m_watched(watched)
    {
    }

    /// From now on these bounds hold; silence of samples counts from now, of a reading from when it was first bounded.
    void set(const Caps &caps, TimePoint now);

    /// @param catalog  of the board: units of what is polled
    /// @return  which bound is broken, in words with its numbers; empty: none
    std::optional<std::string> accept(
        const drive::Event &event, const catalog::Catalog &catalog, TimePoint now);
    /// What has not come for too long.
    std::optional<std::string> silence(TimePoint now) const;
    /// When silence breaks it; empty: it does not.
    std::optional<TimePoint> silentAt() const;

    std::optional<double> rpm() const { return m_rpm; } ///< the newest
    std::optional<double> amps() const { return m_amps; } ///< over the newest packet
    /// The newest reading of the bus, if it came later than this.
    std::optional<double> busSince(TimePoint when) const
    {
        return m_bus_v && m_busRead > when ? m_bus_v : std::nullopt;
    }

private:
    std::optional<std::string> samples(const capture::SampleBlock &block);
    std::optional<std::string> speed(double rpm);
    std::optional<std::string> current(double amps) const;
    bool readsCurrent() const;
    std::optional<double> turnedRpm(const capture::SampleBlock &block) const;
    std::optional<std::string> reading(
        const drive::Reading &reading, const catalog::Catalog &catalog, TimePoint now);

    /// Where a signal is in the blocks of the stream.
    struct Column {
        std::size_t place = 0;
        capture::StreamSignal signal;
        bool slow = false; ///< in groups, not in columns
        double valueOf(std::int32_t stored) const;
    };

    Watched m_watched;
    Caps m_caps;
    capture::StreamId m_stream = 0;
    std::optional<Column> m_speed, m_current, m_currentD, m_angle;
    double m_sampleHz = 0.0;
    std::optional<double> m_rpm, m_amps, m_bus_v;
    TimePoint m_heard{}, m_currentRead{}, m_busRead{}, m_temperatureRead{};
};

} // namespace lab
