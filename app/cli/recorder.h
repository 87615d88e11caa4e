// Recorder: of everything a stream brings, or of the registers that are read over and over where a board streams
// nothing, exactly the wanted length, beginning with its first sample at 0 s.
#pragma once

#include "capture/capture.h"
#include "drive/event.h"

#include <QString>

namespace cli {

class Recorder {
public:
    explicit Recorder(double seconds)
        : m_seconds(seconds)
    {
    }

    /// From now on the readings of these registers count instead of a stream.
    void poll(std::vector<catalog::RegisterId> registers,
        std::shared_ptr<const catalog::Catalog> catalog);
    /// The longest time between a question and its answer: a value was true within so long before its time.
    double spreadSeconds() const { return m_spread; }
    /// How often each of them was read.
    double valuesPerSecond() const;
    /// How much of the wanted length has come; all of it once it is complete.
    double recordedSeconds() const { return m_complete ? m_seconds : m_recorded_s; }

    /// Layouts and blocks count, all else is passed over. A later layout is passed over, too.
    void accept(const drive::Event &event);

    bool complete() const { return m_complete; }
    bool empty() const { return !m_origin && !m_firstSeconds; }
    bool polls() const { return m_catalog != nullptr; }
    std::vector<capture::ChannelId> channels() const;
    /// Control periods missing within the length.
    capture::Tick lostTicks() const { return m_lost; }
    double tickHz() const { return m_layout.tickHz; }
    /// What is missing in the words of the drive: "3 control periods", or a time where it counts no periods.
    QString lostText() const;
    const capture::Capture &capture() const { return m_capture; }

private:
    void onBlock(capture::SampleBlock block);
    void onReading(const drive::Reading &reading);

    double m_seconds;
    double m_recorded_s = 0.0; ///< so far
    capture::StreamLayout m_layout;
    capture::Capture m_capture;
    std::optional<capture::Tick> m_origin; ///< tick of the first sample
    std::vector<catalog::RegisterId> m_polled;
    std::shared_ptr<const catalog::Catalog> m_catalog; ///< with polled registers only
    std::optional<double> m_firstSeconds; ///< of the first reading
    std::size_t m_polledValues = 0;
    double m_spread = 0.0;
    capture::Tick m_length = 0; ///< ticks from the first sample to the end
    capture::Tick m_lost = 0;
    bool m_complete = false;
};

} // namespace cli
