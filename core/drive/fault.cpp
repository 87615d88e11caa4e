#include "drive/fault.h"

#include <utility>

namespace drive {

FaultKind faultKindOf(std::string_view name)
{
    using enum FaultKind;
    static constexpr std::pair<std::string_view, FaultKind> kKinds[] = {{"DURATION", Duration},
        {"OVER_VOLT", OverVoltage}, {"UNDER_VOLT", UnderVoltage}, {"OVER_TEMP", OverTemperature},
        {"START_UP", StartUp}, {"SPEED_FDBK", SpeedFeedback}, {"OVER_CURR", OverCurrent},
        {"OVER_CURR_SW", OverCurrent}, {"BREAK_IN", OverCurrent}, {"SW_ERROR", Software},
        {"SAMPLE_FAULT", Sampling}, {"DP_FAULT", DriverProtection},
        {"DRIVER_PROTECTION", DriverProtection}};
    for (const auto &[known, kind] : kKinds)
        if (known == name)
            return kind;
    return Other;
}

} // namespace drive
