// Recorder: of everything a stream brings, exactly the wanted length, beginning with its first sample at 0 s.
#pragma once

#include "capture/capture.h"
#include "drive/event.h"

namespace cli {

class Recorder {
public:
    explicit Recorder(double seconds)
        : m_seconds(seconds)
    {
    }

    /// Layouts and blocks count, all else is passed over. A later layout is passed over, too.
    void take(const drive::Event &event);

    bool complete() const { return m_complete; }
    bool empty() const { return !m_origin; }
    capture::Tick lostTicks() const
    {
        return m_lost;
    } ///< control periods missing within the length
    double tickHz() const { return m_layout.tickHz; }
    const capture::Capture &capture() const { return m_capture; }

private:
    void takeBlock(capture::SampleBlock block);

    double m_seconds;
    capture::StreamLayout m_layout;
    capture::Capture m_capture;
    std::optional<capture::Tick> m_origin; ///< tick of the first sample
    capture::Tick m_length = 0; ///< ticks from the first sample to the end
    capture::Tick m_lost = 0;
    bool m_complete = false;
};

} // namespace cli
