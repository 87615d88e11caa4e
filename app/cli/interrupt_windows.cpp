// Windows has no signals to wait for here: Ctrl-C ends the program, and the motor is the user's to stop.
#include "interrupt.h"

namespace cli {

Interrupt::Interrupt(QObject *parent)
    : QObject(parent)
{
}

Interrupt::~Interrupt() = default;

const char *Interrupt::help() { return "Ctrl-C ends this program; it stops no motor."; }

void Interrupt::raise(int) { }

} // namespace cli
