#include "lab/envelope.h"

#include "drive/values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <utility>

namespace lab {

namespace {

std::string text(double value)
{
    std::array<char, 32> buffer{};
    constexpr int kDigits = 4;
    constexpr double kWhole = 1e4; // from there on whole numbers have more digits than these
    const bool whole = std::abs(value) >= kWhole && std::abs(value) < 1e9;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
        whole ? std::chars_format::fixed : std::chars_format::general, whole ? 0 : kDigits);
    return {buffer.data(), end.ptr};
}

std::string broken(const char *what, double value, double bound, const char *unit)
{
    if (!std::isfinite(value))
        return std::string(what) + " is no number";
    return std::string(what) + " of " + text(value) + ' ' + unit
        + (std::abs(value) < std::abs(bound) ? " is below the " : " is above the ") + text(bound)
        + ' ' + unit + " that are allowed";
}

/// Than samples: of a board that says nothing the samples are told.
constexpr Duration kReadsLater = std::chrono::milliseconds(100);

bool boundsBus(const Caps &caps) { return caps.leastBus_v > 0.0 || caps.mostBus_v > 0.0; }

} // namespace

void Envelope::set(const Caps &caps, TimePoint now)
{
    if (!boundsBus(m_caps))
        m_busRead = now;
    if (!(m_caps.mostTemperature_c > 0.0))
        m_temperatureRead = now;
    if (!readsCurrent())
        m_currentRead = now;
    m_caps = caps;
    m_heard = now;
}

std::optional<std::string> Envelope::accept(
    const drive::Event &event, const catalog::Catalog &catalog, TimePoint now)
{
    if (const auto *started = std::get_if<drive::StreamStarted>(&event)) {
        m_stream = started->layout.id;
        m_sampleHz = started->layout.tickHz / std::max(1U, started->layout.fastStep);
        const capture::StreamLayout &layout = started->layout;
        for (const auto &[id, column] :
            {std::pair(m_watched.speed, &m_speed), std::pair(m_watched.current, &m_current),
                std::pair(m_watched.currentD, &m_currentD), std::pair(m_watched.angle, &m_angle)}) {
            column->reset();
            for (const bool groups : {true, false}) {
                const auto &signals = groups ? layout.slow : layout.fast;
                for (std::size_t i = 0; i < signals.size(); ++i)
                    if (signals[i].id == id)
                        *column = {i, signals[i], groups};
            }
        }
    } else if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
        if (block->stream != m_stream || (block->count == 0 && block->slow.empty()))
            return std::nullopt;
        m_heard = now;
        return samples(*block);
    } else if (const auto *read = std::get_if<drive::RegistersRead>(&event)) {
        for (const drive::Reading &one : read->readings)
            if (auto found = reading(one, catalog, now))
                return found;
    }
    return std::nullopt;
}

std::optional<std::string> Envelope::samples(const capture::SampleBlock &block)
{
    const auto visit = [&block](const Column &column, auto look) -> std::optional<std::string> {
        const std::size_t count = column.slow ? block.slow.size() : block.count;
        for (std::size_t i = 0; i < count; ++i) {
            const std::int32_t stored = column.slow ? block.slow[i].values[column.place]
                                                    : block.fast[column.place * count + i];
            if (auto found = look(column.valueOf(stored)))
                return found;
        }
        return std::nullopt;
    };
    double sum = 0.0;
    std::size_t count = 0;
    const auto current = [&](double amps) {
        sum += amps;
        ++count;
        return this->current(amps);
    };
    if (m_currentD)
        if (auto found = visit(*m_currentD, current))
            return found;
    if (m_current) {
        sum = 0.0;
        count = 0;
        if (auto found = visit(*m_current, current))
            return found;
        if (count > 0)
            m_amps = sum / static_cast<double>(count);
    }
    if (m_speed)
        return visit(*m_speed, [this](double rpm) { return speed(rpm); });
    const auto rpm = turnedRpm(block);
    return rpm ? speed(*rpm) : std::nullopt;
}

double Envelope::Column::valueOf(std::int32_t stored) const
{
    const double number =
        signal.real ? double{std::bit_cast<float>(stored)} : static_cast<double>(stored);
    return (number + signal.offset) * signal.factor;
}

/// Over the whole packet.
std::optional<double> Envelope::turnedRpm(const capture::SampleBlock &block) const
{
    constexpr double kTurn_deg = 360.0, kSeconds = 60.0;
    if (!m_angle || m_angle->slow || block.count < 2 || !(m_watched.polePairs > 0.0))
        return std::nullopt;
    const std::int16_t *stored = block.fast.data() + m_angle->place * block.count;
    double turned_deg = 0.0;
    for (std::size_t i = 1; i < block.count; ++i)
        turned_deg += std::remainder(
            (stored[i] - stored[i - 1]) * std::abs(m_angle->signal.factor), kTurn_deg);
    return turned_deg / kTurn_deg / m_watched.polePairs * m_sampleHz / (block.count - 1) * kSeconds;
}

std::optional<std::string> Envelope::speed(double rpm)
{
    if (std::isfinite(rpm))
        m_rpm = rpm;
    if (m_caps.mostRpm == m_caps.leastRpm)
        return std::nullopt;
    if (!(rpm <= m_caps.mostRpm)) // nor what is no number
        return broken("a speed", rpm, m_caps.mostRpm, "rpm");
    if (rpm < m_caps.leastRpm)
        return broken("a speed", rpm, m_caps.leastRpm, "rpm");
    return std::nullopt;
}

std::optional<std::string> Envelope::current(double amps) const
{
    return m_caps.mostAmps > 0.0 && !(std::abs(amps) <= m_caps.mostAmps)
        ? std::optional(broken("a current", std::abs(amps), m_caps.mostAmps, "A"))
        : std::nullopt;
}

/// It is bounded, and seen only where it is read.
bool Envelope::readsCurrent() const
{
    return m_watched.polled && m_watched.current != 0 && m_caps.mostAmps > 0.0;
}

std::optional<std::string> Envelope::reading(
    const drive::Reading &reading, const catalog::Catalog &catalog, TimePoint now)
{
    const auto number = drive::asNumber(reading.value);
    if (reading.status != drive::ReadStatus::Ok || !number || reading.id == 0)
        return std::nullopt;
    const double value = *number * catalog.readScale(reading.id).factor;
    if (m_watched.polled && reading.id == m_watched.speed) {
        m_heard = now;
        return speed(value);
    }
    if (m_watched.polled && reading.id == m_watched.current) {
        m_currentRead = now;
        return current(value);
    }
    if (!std::isfinite(value))
        return std::nullopt; // not read: silence bounds it
    if (reading.id == m_watched.bus) {
        m_busRead = now;
        m_bus_v = value;
        if (m_caps.mostBus_v > 0.0 && value > m_caps.mostBus_v)
            return broken("a bus voltage", value, m_caps.mostBus_v, "V");
        if (m_caps.leastBus_v > 0.0 && value < m_caps.leastBus_v)
            return broken("a bus voltage", value, m_caps.leastBus_v, "V");
    }
    if (reading.id == m_watched.temperature) {
        m_temperatureRead = now;
        if (m_caps.mostTemperature_c > 0.0 && value > m_caps.mostTemperature_c)
            return broken("a temperature", value, m_caps.mostTemperature_c, "\u00b0C");
    }
    return std::nullopt;
}

std::optional<std::string> Envelope::silence(TimePoint now) const
{
    if (m_caps.silence == Duration::zero())
        return std::nullopt;
    const auto missing = [](const char *what, Duration time) {
        return std::optional(std::string(what) + " for " + text(toSeconds(time)) + " s");
    };
    if (now >= m_heard + m_caps.silence)
        return missing(
            m_watched.polled ? "the speed was not read" : "no samples came", m_caps.silence);
    const Duration unread = m_caps.silence + kReadsLater;
    if (readsCurrent() && now >= m_currentRead + unread)
        return missing("the current was not read", unread);
    if (boundsBus(m_caps) && now >= m_busRead + unread)
        return missing("the bus voltage was not read", unread);
    if (m_caps.mostTemperature_c > 0.0 && now >= m_temperatureRead + unread)
        return missing("the temperature was not read", unread);
    return std::nullopt;
}

std::optional<TimePoint> Envelope::silentAt() const
{
    if (m_caps.silence == Duration::zero())
        return std::nullopt;
    TimePoint oldest = m_heard;
    if (readsCurrent())
        oldest = std::min(oldest, m_currentRead + kReadsLater);
    if (boundsBus(m_caps))
        oldest = std::min(oldest, m_busRead + kReadsLater);
    if (m_caps.mostTemperature_c > 0.0)
        oldest = std::min(oldest, m_temperatureRead + kReadsLater);
    return oldest + m_caps.silence;
}

} // namespace lab
