#include "widgets/control/fault_texts.h"

#include <QCoreApplication>

#include <algorithm>

namespace widgets {
namespace {

struct Fault {
    Q_DECLARE_TR_FUNCTIONS(Fault)
};

FaultText startUp()
{
    return {
        Fault::tr("The motor did not come up to a speed at which it can be seen without a sensor."),
        {{Fault::tr("The start-up is too short or too weak for rotor and load"),
             Fault::tr("Make the ramp longer and its current larger, within the motor's nominal "
                       "current; end it at 30 to 40 % of the greatest speed.")},
            {Fault::tr("The observer does not settle"),
                Fault::tr("Lower its gain G2; lower the least speed at which it is believed to "
                          "about 10 % of the greatest.")},
            {Fault::tr("The motor's values are not right"),
                Fault::tr("Check resistance, inductance, the back-EMF constant and the pole "
                          "pairs.")},
            {Fault::tr("The load is too large, or the rotor is blocked"),
                Fault::tr("Try without the load.")}}};
}

FaultText speedFeedback()
{
    return {Fault::tr("The measured or estimated speed is not to be relied on."),
        {{Fault::tr("The observer is too quick for this motor"), Fault::tr("Lower its gain G2.")},
            {Fault::tr("The speed changes too fast after the start"),
                Fault::tr("Take gentler ramps; go through low speeds quickly.")},
            {Fault::tr("The test of the speed is too strict"),
                Fault::tr("Allow 4 to 5 failed readings in a row.")},
            {Fault::tr("The sensor or its wiring"),
                Fault::tr("Check the order of phases and sensor wires, and the driver's fault "
                          "line.")}}};
}

FaultText overCurrent()
{
    return {Fault::tr("The power stage switched itself off because of too much current."),
        {{Fault::tr("Shunt, amplification or topology are set wrongly"),
             Fault::tr("Compare the current scale with the hardware.")},
            {Fault::tr("The current loop oscillates"),
                Fault::tr("Lower the bandwidth of the current loop.")},
            {Fault::tr("The step of current is too large"),
                Fault::tr("Take a slower ramp or a smaller current.")},
            {Fault::tr("A short circuit, or a damaged stage"),
                Fault::tr("Remove the power, then measure between the phases and to ground.")}}};
}

} // namespace

FaultText faultText(catalog::FaultKind kind)
{
    using catalog::FaultKind;
    switch (kind) {
    case FaultKind::StartUp:
        return startUp();
    case FaultKind::SpeedFeedback:
        return speedFeedback();
    case FaultKind::OverCurrent:
        return overCurrent();
    case FaultKind::Duration:
        return {Fault::tr("The control loop did not finish within its period."),
            {{Fault::tr("The control rate is too high for this processor"),
                 Fault::tr("Lower the PWM frequency or the control rate.")},
                {Fault::tr("Too many signals are recorded"),
                    Fault::tr("Record fewer signals, or only every second sample.")},
                {Fault::tr("The firmware was built without optimisation"),
                    Fault::tr("Build it for release.")}}};
    case FaultKind::OverVoltage:
        return {Fault::tr("The bus voltage is above its limit."),
            {{Fault::tr("The motor feeds energy back while it brakes"),
                 Fault::tr("Slow down more gently, or connect a brake resistor.")},
                {Fault::tr("The supply is set too high"),
                    Fault::tr("Compare its voltage with the limit of the board.")},
                {Fault::tr("The voltage is measured wrongly"),
                    Fault::tr("Compare the shown bus voltage with a meter.")}}};
    case FaultKind::UnderVoltage:
        return {Fault::tr("The bus voltage is below its limit."),
            {{Fault::tr("The supply's current limit is reached"),
                 Fault::tr("Raise it, or ask for less current.")},
                {Fault::tr("The supply is off or connected badly"),
                    Fault::tr("Measure at the board's terminals.")},
                {Fault::tr("The threshold is too high for this supply"),
                    Fault::tr("Compare it with the nominal voltage.")}}};
    case FaultKind::OverTemperature:
        return {Fault::tr("The power stage is too hot, or looks so."),
            {{Fault::tr("It is too hot"), Fault::tr("Let it cool; ask for less current.")},
                {Fault::tr("The temperature is measured wrongly"),
                    Fault::tr("Compare it with the room's while the motor is cold; check the "
                              "sensor's constants and the threshold.")}}};
    case FaultKind::Software:
        return {Fault::tr("The firmware found an error of its own."),
            {{Fault::tr("Its settings contradict one another"),
                 Fault::tr("Reset the board; undo the last changes.")},
                {Fault::tr("An error in the firmware"),
                    Fault::tr("Note what was done before and report it to its makers.")}}};
    case FaultKind::Sampling:
        return {Fault::tr("The phase currents could not be sampled in time."),
            {{Fault::tr("The modulation leaves no room for sampling"),
                Fault::tr("Lower the greatest modulation or the PWM frequency.")}}};
    case FaultKind::DriverProtection:
        return {Fault::tr("The gate driver reports a fault of its own."),
            {{Fault::tr("Its protection acted: too much current or too little supply"),
                 Fault::tr("Check its supply and the short-circuit threshold.")},
                {Fault::tr("The wire of its fault line is open"),
                    Fault::tr("Check jumpers and pull-up resistors.")}}};
    case FaultKind::Other:
        break;
    }
    return {Fault::tr("Nothing is known here about this fault."),
        {{Fault::tr("See the documentation of the firmware"), QString()}}};
}

std::vector<std::string> faultsOver(const drive::MotorStatus &status)
{
    std::vector<std::string> over;
    for (const std::string &name : status.faultsPast)
        if (std::find(status.faultsNow.begin(), status.faultsNow.end(), name)
            == status.faultsNow.end())
            over.push_back(name);
    return over;
}

} // namespace widgets
