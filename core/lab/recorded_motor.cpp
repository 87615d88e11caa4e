#include "lab/recorded_motor.h"

#include "lab/plan_fields.h"

#include <array>

namespace lab {

namespace {

struct Signal {
    const char *name;
    drive::RegisterId Registers::*of;
    std::string RecordedMotor::*recorded;
};
constexpr std::array kSignals{
    Signal{"reference", &Registers::reference, &RecordedMotor::reference},
    Signal{"reference d", &Registers::referenceD, &RecordedMotor::referenceD},
    Signal{"current", &Registers::current, &RecordedMotor::current},
    Signal{"current d", &Registers::currentD, &RecordedMotor::currentD},
    Signal{"voltage", &Registers::voltage, &RecordedMotor::voltage},
    Signal{"voltage d", &Registers::voltageD, &RecordedMotor::voltageD},
    Signal{"speed", &Registers::speed, &RecordedMotor::speed},
    Signal{"speed reference", &Registers::speedReference, &RecordedMotor::speedReference},
    Signal{"angle", &Registers::angle, &RecordedMotor::angle},
};

template <class Motor, class Field>
void eachField(Motor &motor, Field &&field)
{
    field("motor", motor.motor);
    field("pole pairs", motor.polePairs);
    field("nominal A", motor.nominalAmps);
    field("torque Nm per A", motor.torquePerAmp);
    field("Lq less Ld H", motor.saliency_h);
    field("speed step rpm", motor.speedStepRpm);
}

} // namespace

void putMotor(recorded::Happening &into, const Subject &subject)
{
    RecordedMotor motor;
    motor.motor = subject.motor;
    motor.polePairs = subject.limits.polePairs;
    motor.nominalAmps = subject.limits.nominalCurrentAmps;
    motor.torquePerAmp = subject.limits.torquePerAmp;
    motor.saliency_h = subject.limits.saliency_h;
    motor.speedStepRpm = subject.limits.speedStepRpm;
    eachField(motor, PutFields(into));
    for (const Signal &signal : kSignals)
        into.fields.emplace_back(signal.name, subject.nameOf(subject.registers.*signal.of));
}

RecordedMotor recordedMotor(const recorded::Happening &from)
{
    RecordedMotor motor;
    eachField(motor, TakeFields(from));
    for (const Signal &signal : kSignals)
        motor.*signal.recorded = from.field(signal.name);
    return motor;
}

} // namespace lab
