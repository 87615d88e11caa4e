#include "drive/fault.h"

#include "base/text.h"

namespace drive {

FaultKind faultKindOf(std::string_view name)
{
    using enum FaultKind;
    static constexpr Word<FaultKind> kKinds[] = {{"DURATION", Duration}, {"OVER_VOLT", OverVoltage},
        {"UNDER_VOLT", UnderVoltage}, {"OVER_TEMP", OverTemperature}, {"START_UP", StartUp},
        {"SPEED_FDBK", SpeedFeedback}, {"OVER_CURR", OverCurrent}, {"OVER_CURR_SW", OverCurrent},
        {"BREAK_IN", OverCurrent}, {"SW_ERROR", Software}, {"SAMPLE_FAULT", Sampling},
        {"DP_FAULT", DriverProtection}, {"DRIVER_PROTECTION", DriverProtection}};
    const FaultKind *kind = findWord(kKinds, name);
    return kind == nullptr ? Other : *kind;
}

} // namespace drive
