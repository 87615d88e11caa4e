// The start without a sensor: up to five stages of a forced speed and a forced current, each linear in time from where
// the last one ended. It says what to force; the virtual sensor and the current loops do it.
// Source: features 6.5; mcp-aspep section 8, REVUP_DATA.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace simulation {

struct StageDigits {
    std::int32_t rpm = 0; ///< at its end
    std::int16_t torque = 0; ///< at its end, digits
    std::uint16_t ms = 0;
};

class RevUp {
public:
    static constexpr std::size_t kStages = 5;
    using Stages = std::array<StageDigits, kStages>;

    /// What a tick asks of the others.
    struct Step {
        bool over = false; ///< the time of the last stage has passed: the start has failed
        bool begins = false; ///< a stage begins: accelerate to `speed_dHz` in `ticks`
        std::int32_t speed_dHz = 0;
        int ticks = 0;
        std::int16_t torque = 0; ///< now, digits
    };

    void begin(int direction); ///< 1 or -1
    Step step(const Stages &stages); ///< every millisecond; stages may be rewritten between two
    /// The observer is cleared where this stage begins and believed from it on.
    bool reached(std::size_t stage) const { return m_next > stage; }

private:
    int m_direction = 1;
    std::size_t m_next = 0; ///< the stage after the one that runs
    int m_left = 0;
    std::int64_t m_torque = 0, m_torqueTarget = 0; ///< with 16 more bits
};

} // namespace simulation
