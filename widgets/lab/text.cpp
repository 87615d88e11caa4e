#include "widgets/lab/text.h"

#include "lab/experiment.h"
#include "widgets/base/messages.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <vector>

namespace widgets {
namespace {

/// Known by their words, because recordings and run books hold no more of them; a test holds these against the sources
/// of core. A place holder takes whatever stands there up to a semicolon, which may be another of these.
constexpr const char *kLabTexts[] = {
    // NOLINTBEGIN(bugprone-suspicious-missing-comma): long ones stand in several pieces
    QT_TRANSLATE_NOOP("Lab", "a current of %1 A is above the %2 A that are allowed"),
    QT_TRANSLATE_NOOP("Lab", "a speed of %1 rpm is above the %2 rpm that are allowed"),
    QT_TRANSLATE_NOOP("Lab", "a speed of %1 rpm is below the %2 rpm that are allowed"),
    QT_TRANSLATE_NOOP("Lab",
        "a speed of %1 rpm is above the %2 rpm that are allowed, and the wrong way: its sensor may "
        "be aligned wrongly, or two phases exchanged"),
    QT_TRANSLATE_NOOP("Lab", "a speed is no number"),
    QT_TRANSLATE_NOOP("Lab", "a current is no number"),
    QT_TRANSLATE_NOOP("Lab", "a bus voltage of %1 V is above the %2 V that are allowed"),
    QT_TRANSLATE_NOOP("Lab", "a bus voltage of %1 V is below the %2 V that are allowed"),
    QT_TRANSLATE_NOOP("Lab", "a temperature of %1 °C is above the %2 °C that are allowed"),
    QT_TRANSLATE_NOOP("Lab", "no samples came for %1 s"),
    QT_TRANSLATE_NOOP("Lab", "the speed was not read for %1 s"),
    QT_TRANSLATE_NOOP("Lab", "the current was not read for %1 s"),
    QT_TRANSLATE_NOOP("Lab", "the bus voltage was not read for %1 s"),
    QT_TRANSLATE_NOOP("Lab", "the temperature was not read for %1 s"),
    QT_TRANSLATE_NOOP("Lab", "the link to the board was lost"),
    QT_TRANSLATE_NOOP("Lab", "the board's answer was lost"),
    QT_TRANSLATE_NOOP("Lab", "the board's answer was lost (%1)"),
    QT_TRANSLATE_NOOP("Lab", "it was not sent"), QT_TRANSLATE_NOOP("Lab", "it was not sent (%1)"),
    QT_TRANSLATE_NOOP("Lab", "it was refused"), QT_TRANSLATE_NOOP("Lab", "it was refused (%1)"),
    QT_TRANSLATE_NOOP("Lab", "reading the motor's state: %1"),
    QT_TRANSLATE_NOOP("Lab", "recording its signals: %1"),
    QT_TRANSLATE_NOOP("Lab", "reading its bus voltage: %1"),
    QT_TRANSLATE_NOOP("Lab", "set-points with every exchange: %1"),
    QT_TRANSLATE_NOOP("Lab", "what it writes: %1"),
    QT_TRANSLATE_NOOP("Lab", "what the start goes to: %1"),
    QT_TRANSLATE_NOOP("Lab", "the start: %1"),
    QT_TRANSLATE_NOOP("Lab", "the way to the first speed: %1"),
    QT_TRANSLATE_NOOP("Lab", "a step of it: %1"), QT_TRANSLATE_NOOP("Lab", "the way back: %1"),
    QT_TRANSLATE_NOOP("Lab", "what was there before: %1"),
    QT_TRANSLATE_NOOP("Lab", "reading what is there afterwards: %1"),
    QT_TRANSLATE_NOOP("Lab", "the port was closed"), QT_TRANSLATE_NOOP("Lab", "the port was lost"),
    QT_TRANSLATE_NOOP("Lab", "another command went to the motor"),
    QT_TRANSLATE_NOOP("Lab", "the drive was disarmed"),
    QT_TRANSLATE_NOOP("Lab", "the drive was disarmed, and the motor that was started is driven on"),
    QT_TRANSLATE_NOOP("Lab", "the drive is not armed any more"),
    QT_TRANSLATE_NOOP("Lab", "every motor was stopped"),
    QT_TRANSLATE_NOOP("Lab", "no port is open"),
    QT_TRANSLATE_NOOP("Lab", "another experiment is running"),
    QT_TRANSLATE_NOOP("Lab", "the drive is not armed"), QT_TRANSLATE_NOOP("Lab", "no answer"),
    QT_TRANSLATE_NOOP("Lab", "too late: it was asked for more than half a second ago"),
    QT_TRANSLATE_NOOP("Lab", "then %1"), QT_TRANSLATE_NOOP("Lab", "the board reports a fault: %1"),
    QT_TRANSLATE_NOOP(
        "Lab", "the motor did not get to its first speed: the board reports a fault: %1"),
    QT_TRANSLATE_NOOP("Lab", "something else stopped the motor"),
    QT_TRANSLATE_NOOP("Lab", "the start-up went on to turn the motor"),
    QT_TRANSLATE_NOOP("Lab", "the motor did not come to run within %1 s"),
    QT_TRANSLATE_NOOP("Lab", "the speed did not come to rest at %1 rpm"),
    QT_TRANSLATE_NOOP("Lab", "the speed did not come back to %1 rpm"),
    QT_TRANSLATE_NOOP("Lab", "the motor was not seen to stop"),
    QT_TRANSLATE_NOOP("Lab", "no answer came in time"),
    QT_TRANSLATE_NOOP(
        "Lab", "the motor neither runs nor rests: it is in %1 (%2): acknowledge the fault first"),
    QT_TRANSLATE_NOOP("Lab", "the motor neither runs nor rests: it is in %1"),
    QT_TRANSLATE_NOOP("Lab", "the motor turns, and this is measured while it rests: stop it first"),
    QT_TRANSLATE_NOOP("Lab", "the board does not give %1, which would be written"),
    QT_TRANSLATE_NOOP("Lab", "the board does not give %1, and without it nothing bounds its bus"),
    QT_TRANSLATE_NOOP(
        "Lab", "the board is at %1 °C, and %2 °C end an experiment: let it cool down first"),
    QT_TRANSLATE_NOOP("Lab", "it was not over within %1 s"),
    QT_TRANSLATE_NOOP("Lab", "the motor is not in speed control: ask for a speed first"),
    QT_TRANSLATE_NOOP("Lab", "the motor does not turn at its set-point of %1 rpm"),
    QT_TRANSLATE_NOOP("Lab", "%1 is not 0, and would be afterwards: bring it to 0 first"),
    QT_TRANSLATE_NOOP("Lab", "a Stop goes out as soon as the board is reached"),
    QT_TRANSLATE_NOOP("Lab", "every motor was told to stop"),
    QT_TRANSLATE_NOOP("Lab", "the set-point is %1 rpm now, it was %2 rpm"),
    QT_TRANSLATE_NOOP("Lab", "the set-point may be %1 rpm or %2 rpm now, it was %3 rpm"),
    QT_TRANSLATE_NOOP("Lab", "the set-point may be %1 rpm now, it was %2 rpm"),
    QT_TRANSLATE_NOOP("Lab", "%1 shows %2 rpm until the next start, it showed %3 rpm"),
    // Before what stands behind its colon.
    QT_TRANSLATE_NOOP(
        "Lab", "An experiment was cut off before it gave back what it had borrowed: %1"),
    QT_TRANSLATE_NOOP("Lab", "%1 may hold what the experiment wrote"),
    QT_TRANSLATE_NOOP("Lab", "what it held before comes back with: rotorscope-cli set %1"),
    QT_TRANSLATE_NOOP("Lab",
        "%1 has no stage with a speed, as an experiment leaves it that was ended early: write the "
        "motor's own stages first"),
    QT_TRANSLATE_NOOP("Lab", "the motor is in torque control now, it was in speed control"),
    QT_TRANSLATE_NOOP("Lab", "the motor may be in torque control now, it was in speed control"),
    QT_TRANSLATE_NOOP("Lab", "the motor is in position control now, it was in speed control"),
    QT_TRANSLATE_NOOP("Lab", "the motor may be in position control now, it was in speed control"),
    QT_TRANSLATE_NOOP("Lab", "this board does not control the position of its shaft"),
    QT_TRANSLATE_NOOP("Lab", "a shaft is moved by 1 to 3600 degrees"),
    QT_TRANSLATE_NOOP("Lab", "a move takes 1 ms to 10 s"),
    QT_TRANSLATE_NOOP("Lab", "a position is held for 100 ms to 10 s"),
    QT_TRANSLATE_NOOP("Lab", "it is no recording of moves of a shaft"),
    QT_TRANSLATE_NOOP("Lab", "the shaft moved by %1 degrees instead of %2 at the worst"),
    QT_TRANSLATE_NOOP("Lab", "the shaft does not come to rest without a current"),
    QT_TRANSLATE_NOOP("Lab", "the board does not tell where its shaft is"),
    QT_TRANSLATE_NOOP("Lab",
        "the shaft is too far from where the board was switched on, and positions count from "
        "there: switch the board off and on"),
    QT_TRANSLATE_NOOP("Lab", "the motor was started all the same"),
    QT_TRANSLATE_NOOP("Lab", "what comes next is not agreed to any more"),
    QT_TRANSLATE_NOOP("Lab", "what comes next was not begun"),
    QT_TRANSLATE_NOOP("Lab", "the way to the first speed takes 1 ms to 10 s"),
    QT_TRANSLATE_NOOP("Lab",
        "nothing says how fast this motor may turn: give the greatest speed that it may have"),
    QT_TRANSLATE_NOOP("Lab", "%1 rpm are more than the %2 rpm that are allowed"),
    QT_TRANSLATE_NOOP("Lab", "%1 A are more than the %2 A that are allowed"),
    QT_TRANSLATE_NOOP("Lab",
        "stay above %1 rpm: this motor has no sensor, and at %2 rpm its rotor might be lost"),
    QT_TRANSLATE_NOOP("Lab",
        "keep both speeds at %1 rpm or above: this motor has no sensor, and a step to %2 rpm goes "
        "on below the %3 rpm that are needed to see its rotor"),
    QT_TRANSLATE_NOOP("Lab",
        "it could take %1 s, and what moves a motor by itself ends within %2 s: take fewer "
        "repetitions, or a shorter time for each"),
    QT_TRANSLATE_NOOP("Lab", "both speeds are the same: there is no step"),
    QT_TRANSLATE_NOOP("Lab", "both currents are the same: there is no step"),
    QT_TRANSLATE_NOOP("Lab", "a series has 1 to %1 repetitions"),
    QT_TRANSLATE_NOOP("Lab", "a speed is held for 50 ms to 10 s"),
    QT_TRANSLATE_NOOP("Lab", "a current is held for 10 to 500 ms"),
    QT_TRANSLATE_NOOP("Lab", "a current rises within 10 ms to 2 s and is held for 100 ms to 2 s"),
    QT_TRANSLATE_NOOP("Lab", "the motor has to turn"),
    QT_TRANSLATE_NOOP("Lab",
        "a torque against the way that the motor turns would brake it, and nothing says that its "
        "supply takes what comes back: both currents have to push the same way"),
    QT_TRANSLATE_NOOP("Lab", "this board does not record the angle of its rotor"),
    QT_TRANSLATE_NOOP("Lab", "this board does not record the current along its magnets"),
    QT_TRANSLATE_NOOP(
        "Lab", "this board does not record voltages, currents and the angle of its rotor"),
    QT_TRANSLATE_NOOP("Lab", "this board does not record its voltage and both of its currents"),
    QT_TRANSLATE_NOOP("Lab", "this board holds no current through a motor that rests"),
    QT_TRANSLATE_NOOP("Lab", "the board does not tell the nominal current of its motor"),
    QT_TRANSLATE_NOOP("Lab",
        "the board does not tell the strength of the magnets, without which no torque is known"),
    QT_TRANSLATE_NOOP(
        "Lab", "it needs two currents, the second at least 1.5 times as strong as the first"),
    QT_TRANSLATE_NOOP("Lab", "%1 A are more than the %2 A of your own limit"),
    QT_TRANSLATE_NOOP("Lab", "%1 A are more than the %2 A that a motor at rest is given here"),
    QT_TRANSLATE_NOOP("Lab", "at most %1 A flow along the magnets"),
    QT_TRANSLATE_NOOP("Lab", "it takes 1 to 30 s"), QT_TRANSLATE_NOOP("Lab", "it takes 4 to 40 s"),
    QT_TRANSLATE_NOOP("Lab", "it needs two speeds in one direction, the lower one first"),
    QT_TRANSLATE_NOOP("Lab", "the speed has to go to and fro by 1 rpm or more"),
    QT_TRANSLATE_NOOP("Lab", "the speed may go to and fro by less than half of it"),
    QT_TRANSLATE_NOOP("Lab", "There is no such motor."),
    QT_TRANSLATE_NOOP("Lab", "This board does not tell the speed of its motor."),
    QT_TRANSLATE_NOOP("Lab",
        "this board records nothing by itself: only steps of the speed, inertia and friction are "
        "told from values that are read one after the other"),
    QT_TRANSLATE_NOOP("Lab",
        "this board records nothing by itself: inductances are not told from values that are read "
        "one after the other"),
    QT_TRANSLATE_NOOP("Lab",
        "nothing tells its current in A, and so no torque: say what the full scale of its currents "
        "is"),
    QT_TRANSLATE_NOOP("Lab",
        "nothing tells which torque an ampere makes: it follows from pole pairs and flux of "
        "a motor file"),
    QT_TRANSLATE_NOOP("Lab", "its ramps take %1 s"),
    QT_TRANSLATE_NOOP("Lab", "this board does not tell which pole pairs it counts by"),
    QT_TRANSLATE_NOOP("Lab",
        "an encoder tells this board the turns of its rotor, which say nothing of pole pairs"),
    QT_TRANSLATE_NOOP("Lab", "the motor does not turn: let it run at a constant speed"),
    QT_TRANSLATE_NOOP("Lab",
        "%1 rpm of the board, which counts by %2 pole pairs, and %3 rpm of the shaft make %4, "
        "which is no whole number: read both again, at a constant speed"),
    QT_TRANSLATE_NOOP("Lab",
        "its board records nothing by itself, and its torques are counted by %1 N m for an ampere, "
        "as was given"),
    QT_TRANSLATE_NOOP("Lab",
        "nothing tells its current in A, so that none could be held against your limit: say what "
        "the full scale of its currents is"),
    QT_TRANSLATE_NOOP("Lab",
        "This board sends its samples once an exchange: this is measured by samples at the rate of "
        "its control loop."),
    QT_TRANSLATE_NOOP("Lab",
        "this board sends its samples once an exchange: only steps and response of the speed, "
        "inertia and friction are told from them"),
    QT_TRANSLATE_NOOP(
        "Lab", "this drive does not send its speed, its current and what they are to be"),
    QT_TRANSLATE_NOOP("Lab",
        "the motor turns, and its set-points can begin to leave with every exchange only while it "
        "rests: stop it first"),
    QT_TRANSLATE_NOOP("Lab", "set-points leave with every exchange still"),
    QT_TRANSLATE_NOOP("Lab", "set-points may leave with every exchange now"),
    QT_TRANSLATE_NOOP("Lab", "This board does not record the speed that its main sensor tells."),
    QT_TRANSLATE_NOOP(
        "Lab", "This board does not record both the current of its motor and what it is to be."),
    QT_TRANSLATE_NOOP("Lab", "This board records %1 signals at a time, and experiments need %2."),
    QT_TRANSLATE_NOOP("Lab", "the run ended early: %1"),
    QT_TRANSLATE_NOOP("Lab", "the series ended early: %1"),
    QT_TRANSLATE_NOOP("Lab", "the recording ends before the series does"),
    QT_TRANSLATE_NOOP("Lab", "the recording ends before the experiment does"),
    QT_TRANSLATE_NOOP("Lab", "it is no recording of an experiment"),
    QT_TRANSLATE_NOOP("Lab", "it is no recording of a series of steps"),
    QT_TRANSLATE_NOOP("Lab", "it is no recording of a series of current steps"),
    QT_TRANSLATE_NOOP("Lab", "it is no recording of a mechanical identification"),
    QT_TRANSLATE_NOOP("Lab", "it is no recording of an electrical identification"),
    QT_TRANSLATE_NOOP("Lab", "it is no recording of a motor's power"),
    QT_TRANSLATE_NOOP("Lab", "it is no recording of a speed's frequency response"),
    QT_TRANSLATE_NOOP("Lab", "it is no recording of a current loop's frequency response"),
    QT_TRANSLATE_NOOP("Lab", "it holds no samples of the signals that it needs"),
    QT_TRANSLATE_NOOP("Lab", "it holds no samples of the signals of its series of steps"),
    QT_TRANSLATE_NOOP("Lab", "it holds no samples of that time"),
    QT_TRANSLATE_NOOP("Lab", "the motor was never driven by a torque in it"),
    QT_TRANSLATE_NOOP("Lab", "the motor was never driven by a current while it turned"),
    QT_TRANSLATE_NOOP("Lab", "the set-point was never moved in it"),
    QT_TRANSLATE_NOOP("Lab", "the motor turned for only %1 s of it without a gap; %2 s are needed"),
    QT_TRANSLATE_NOOP(
        "Lab", "too little of it is without a gap: stretches of two seconds are needed"),
    QT_TRANSLATE_NOOP("Lab", "too little of it is without a gap: a second is needed"),
    QT_TRANSLATE_NOOP(
        "Lab", "samples of %1 s are missing in it: only what is without a gap counts"),
    QT_TRANSLATE_NOOP("Lab",
        "its samples are %1 ms apart, too far for the response of a speed: %2 ms are the most"),
    QT_TRANSLATE_NOOP("Lab",
        "its samples are %1 ms apart, too far for the response of a current: %2 ms are the most"),
    QT_TRANSLATE_NOOP(
        "Lab", "the speed did not come to rest before the first torque: its speed loop swings"),
    QT_TRANSLATE_NOOP("Lab", "the speed hardly changed: no inertia follows from it"),
    QT_TRANSLATE_NOOP("Lab",
        "this motor changes its speed too fast for its Hall sensors: between two of their edges "
        "their angle is too far from the rotor's to tell a torque"),
    QT_TRANSLATE_NOOP("Lab",
        "part of the friction may be a fan's: the angle of Hall sensors at these speeds does not "
        "tell the one from the other"),
    QT_TRANSLATE_NOOP("Lab",
        "the rotor turns by up to %1 electrical degrees within a control period: what its current "
        "does meanwhile is not seen"),
    QT_TRANSLATE_NOOP("Lab",
        "the voltages tell magnets of %1 mWb, the board of %2 mWb (%3 %): the voltages were "
        "believed; perhaps the angle of its rotor is off, as after an alignment against friction"),
    QT_TRANSLATE_NOOP("Lab",
        "the board takes its rotor for %1 electrical degrees beside where it is, as after an "
        "alignment against friction: its torque was counted by that"),
    QT_TRANSLATE_NOOP("Lab",
        "the board takes its rotor for %1 electrical degrees beside where it is, as after an "
        "alignment against friction: its magnets were counted by that"),
    QT_TRANSLATE_NOOP("Lab",
        "by what its currents do to its speed, the board takes its rotor for more than 60 "
        "electrical degrees beside where it is: its flux is not told"),
    QT_TRANSLATE_NOOP("Lab",
        "the inertia that its two directions tell is %1 % apart: perhaps its load is another one "
        "backwards"),
    QT_TRANSLATE_NOOP("Lab", "it was driven in one of its two directions only"),
    QT_TRANSLATE_NOOP("Lab", "a torque of %1 N m is always there and drives it backwards"),
    QT_TRANSLATE_NOOP("Lab", "a torque of %1 N m is always there and drives it forwards"),
    QT_TRANSLATE_NOOP("Lab", "the rotor nearly stood still for %1 s: that time was left out"),
    QT_TRANSLATE_NOOP("Lab", "%1 % of the samples do not fit the others and count for nothing"),
    QT_TRANSLATE_NOOP("Lab",
        "the rotor turned where it was to rest: neither its resistance nor the angle that it was "
        "aligned to is sure"),
    QT_TRANSLATE_NOOP("Lab", "%1 was cut short: nothing is told of its speed"),
    QT_TRANSLATE_NOOP("Lab", "%1 was cut short: nothing is told of its current"),
    QT_TRANSLATE_NOOP("Lab", "%1 was cut short: nothing is told of its position"),
    QT_TRANSLATE_NOOP("Lab", "this board has no gains of a speed loop"),
    QT_TRANSLATE_NOOP("Lab", "gains are 0 to %1 digits"),
    QT_TRANSLATE_NOOP(
        "Lab", "the motor turns, and its gains are written while it rests: stop it first"),
    QT_TRANSLATE_NOOP("Lab", "the motor turns the other way: stop it first"),
    QT_TRANSLATE_NOOP("Lab", "the motor still turns the other way"),
    QT_TRANSLATE_NOOP("Lab", "the motor was started meanwhile"),
    QT_TRANSLATE_NOOP("Lab", "at rest no two different currents were held for long enough"),
    QT_TRANSLATE_NOOP("Lab", "at rest no resistance follows from the voltages"),
    QT_TRANSLATE_NOOP("Lab", "it does not tell the nominal current of the motor"),
    QT_TRANSLATE_NOOP("Lab",
        "it holds too few samples of the turning motor without a gap, or they are too far apart"),
    QT_TRANSLATE_NOOP("Lab", "while it turned the current along the magnets hardly changed"),
    QT_TRANSLATE_NOOP("Lab", "while it turned no inductance follows from the voltages"),
    QT_TRANSLATE_NOOP("Lab",
        "its samples are too far apart to tell the inductance across the magnets, which only jumps "
        "of the current tell"),
    QT_TRANSLATE_NOOP("Lab", "it turned too slowly to tell the inductance along the magnets"),
    QT_TRANSLATE_NOOP("Lab",
        "what the dead time takes cannot be told from the resistance: currents swung through zero "
        "within a PWM period"),
    QT_TRANSLATE_NOOP("Lab", "nothing follows from it"),
    QT_TRANSLATE_NOOP("Lab", "resistance or dead time is not known: what it takes is not told"),
    QT_TRANSLATE_NOOP("Lab", "Speed"), QT_TRANSLATE_NOOP("Lab", "Electrical power"),
    QT_TRANSLATE_NOOP("Lab", "Copper losses"), QT_TRANSLATE_NOOP("Lab", "Shaft power"),
    QT_TRANSLATE_NOOP("Lab", "Efficiency"), QT_TRANSLATE_NOOP("Lab", "Load"),
    QT_TRANSLATE_NOOP("Lab", "Torque of the load"),
    QT_TRANSLATE_NOOP("Lab", "The speed gives way by"),
    QT_TRANSLATE_NOOP("Lab", "For each ampere by"), QT_TRANSLATE_NOOP("Lab", "Back within"),
    QT_TRANSLATE_NOOP("Lab", "Peak Iq"), QT_TRANSLATE_NOOP("Lab", "it takes 2 to 30 s"),
    QT_TRANSLATE_NOOP("Lab", "it is no recording of a load that changes"),
    QT_TRANSLATE_NOOP(
        "Lab", "no load came or went while the speed was held: nothing moved it out of its noise"),
    QT_TRANSLATE_NOOP("Lab",
        "the load changed, and the speed did not come back before the end, or before it went "
        "again"),
    QT_TRANSLATE_NOOP("Lab", "the load came %1 times and went %2 times"),
    QT_TRANSLATE_NOOP("Lab",
        "a change of the load was not over at the end, or where samples are missing: it does not "
        "count"),
    QT_TRANSLATE_NOOP("Lab", "a load came and went before the speed was back: it does not count"),
    QT_TRANSLATE_NOOP("Lab", "not conclusive: no step of this series could be measured"),
    QT_TRANSLATE_NOOP("Lab", "not conclusive: not all of it could be measured"),
    QT_TRANSLATE_NOOP("Lab",
        "the loop's gain does not fall through 1 where it could be measured: no margin is told"),
    QT_TRANSLATE_NOOP("Lab",
        "above 10 Hz the motor's own response is not told: what is taken for the angle of a rotor "
        "without an encoder follows its current, too"),
    QT_TRANSLATE_NOOP("Lab",
        "what is taken for the angle of a rotor without an encoder follows its current, by %1 "
        "electrical degrees an ampere if all that turns is one inertia: that is taken out, and "
        "above 25 Hz the motor's own response is not told"),
    QT_TRANSLATE_NOOP("Lab", "nothing in it follows the set-point"),
    QT_TRANSLATE_NOOP("Lab",
        "for %1 % of the time no exchange came for 5 ms or longer: straight lines stand there"),
    QT_TRANSLATE_NOOP("Lab", "the current does not follow its reference in it"),
    QT_TRANSLATE_NOOP("Lab", "the gains were changed while it was measured"),
    QT_TRANSLATE_NOOP("Lab",
        "it is the loop at %1 A: what a bridge loses by its dead time damps it the more the "
        "smaller the current is"),
    QT_TRANSLATE_NOOP("Lab", "the board does not tell its gains, so its loop is not known"),
    QT_TRANSLATE_NOOP("Lab", "no speed loop has the period that the board tells"),
    QT_TRANSLATE_NOOP("Lab", "too few frequencies of the response are clear enough"),
    QT_TRANSLATE_NOOP("Lab", "no gains keep the distance from instability that is asked for"),
    QT_TRANSLATE_NOOP(
        "Lab", "step %1 (up) stands apart from the others by its %2; it is part of the mean"),
    QT_TRANSLATE_NOOP(
        "Lab", "step %1 (down) stands apart from the others by its %2; it is part of the mean"),
    QT_TRANSLATE_NOOP("Lab", "the mean %1 is that of %2 of %3 steps"),
    // The longest list first: the others would take part of it for one word.
    QT_TRANSLATE_NOOP("Lab", "the mean %1, %2, %3 and %4 are those of %5 of %6 steps"),
    QT_TRANSLATE_NOOP("Lab", "the mean %1, %2 and %3 are those of %4 of %5 steps"),
    QT_TRANSLATE_NOOP("Lab", "the mean %1 and %2 are those of %3 of %4 steps"),
    QT_TRANSLATE_NOOP("Lab", "rise time"), QT_TRANSLATE_NOOP("Lab", "overshoot"),
    QT_TRANSLATE_NOOP("Lab", "settling time"), QT_TRANSLATE_NOOP("Lab", "peak current"),
    QT_TRANSLATE_NOOP("Lab",
        "the board records nothing: its speed was read once in up to %1 ms, so that rise times are "
        "uncertain by as much, and peaks may be higher than is told"),
    QT_TRANSLATE_NOOP("Lab",
        "%1 of %2 steps rise in less than three times the time between two of their values: "
        "nothing is told of them"),
    QT_TRANSLATE_NOOP(
        "Lab", "the step is only %1 digits of the set-point; %2 rpm or more say more"),
    QT_TRANSLATE_NOOP("Lab", "%1 of %2 steps do not settle while their speed is held"),
    QT_TRANSLATE_NOOP("Lab", "%1 of %2 steps do not settle while their current is held"),
    QT_TRANSLATE_NOOP("Lab", "%1 of %2 steps do not settle while their position is held"),
    QT_TRANSLATE_NOOP("Lab", "samples are missing in %1: nothing is told of its speed"),
    QT_TRANSLATE_NOOP("Lab", "samples are missing in %1: nothing is told of its current"),
    QT_TRANSLATE_NOOP("Lab", "samples are missing in %1: nothing is told of its position"),
    QT_TRANSLATE_NOOP("Lab", "%1 is not seen in the speed"),
    QT_TRANSLATE_NOOP("Lab", "%1 is not seen in the current"),
    QT_TRANSLATE_NOOP("Lab", "%1 is not seen in the position"),
    QT_TRANSLATE_NOOP(
        "Lab", "the instant of %1 is uncertain by %2 ms: its settling time is not told"),
    QT_TRANSLATE_NOOP("Lab", "%1 does not settle while its speed is held"),
    QT_TRANSLATE_NOOP("Lab", "%1 does not settle while its current is held"),
    QT_TRANSLATE_NOOP("Lab", "%1 does not settle while its position is held"),
    QT_TRANSLATE_NOOP("Lab", "step %1 (up)"), QT_TRANSLATE_NOOP("Lab", "step %1 (down)"),
    QT_TRANSLATE_NOOP(
        "Lab", "the current was at its limit in %1 % of %2: it does not show the loop alone"),
    QT_TRANSLATE_NOOP("Lab",
        "the noise of the measured current is %1 % of the step: overshoot and settling are told "
        "from noise, too; a larger step says more"),
    // NOLINTEND(bugprone-suspicious-missing-comma)
};

struct LabPattern {
    const char *english;
    QRegularExpression words;
    int places;
};

const std::vector<LabPattern> &labPatterns()
{
    static const std::vector<LabPattern> all = [] {
        static const QRegularExpression place(QStringLiteral("%\\d"));
        std::vector<LabPattern> made;
        for (const char *english : kLabTexts) {
            const QStringList pieces = QString::fromUtf8(english).split(place);
            QString pattern;
            for (const QString &piece : pieces)
                pattern +=
                    (&piece == &pieces.front() ? QString() : QStringLiteral("((?:(?!; ).)+?)"))
                    + QRegularExpression::escape(piece);
            made.push_back(
                {english, QRegularExpression(QRegularExpression::anchoredPattern(pattern)),
                    int(pieces.size()) - 1});
        }
        return made;
    }();
    return all;
}

QString labWords(const QString &english);

/// Numbers are written as everywhere else in the window.
QString filledIn(const QString &word)
{
    static const QRegularExpression number(QStringLiteral("^-?\\d+\\.\\d+$"));
    return number.match(word).hasMatch()
        ? QString(word).replace(QLatin1Char('.'), QLocale().decimalPoint())
        : labWords(word);
}

QString labWords(const QString &english)
{
    for (const LabPattern &pattern : labPatterns()) {
        const auto match = pattern.words.match(english);
        if (!match.hasMatch())
            continue;
        QString text = QCoreApplication::translate("Lab", pattern.english);
        for (int place = pattern.places; place > 0; --place)
            text.replace(QStringLiteral("%%1").arg(place), filledIn(match.captured(place)));
        return text;
    }
    const auto end = english.indexOf(QLatin1String("; "));
    return end < 0
        ? reasonText(english).value_or(english)
        : labWords(english.left(end)) + QLatin1String("; ") + labWords(english.mid(end + 2));
}

/// In the context where its translations are.
struct EndText {
    Q_DECLARE_TR_FUNCTIONS(widgets::ExperimentBar)
};

} // namespace

QString labText(const std::string &words) { return labWords(QString::fromStdString(words)); }

QString labSentence(const std::string &words)
{
    QString text = labText(words);
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text + QLatin1Char('.');
}

QStringList labSentences(const std::vector<std::string> &all)
{
    QStringList sentences;
    for (const std::string &words : all)
        sentences.append(labSentence(words));
    return sentences;
}

QString endText(const lab::Outcome &outcome)
{
    const QString reason = labText(outcome.reason);
    const std::string shown = lab::shownText(outcome);
    const QString behind = shown.empty() ? QString() : QLatin1Char(' ') + labSentence(shown);
    switch (outcome.end) {
    case lab::End::Complete:
        return (reason.isEmpty() ? EndText::tr("Done; the motor is as it was.")
                                 : EndText::tr("Done; afterwards: %1.").arg(reason))
            + behind;
    case lab::End::Refused:
        return EndText::tr("Not carried out: %1.").arg(reason) + behind;
    case lab::End::Aborted:
        return EndText::tr("Ended: %1.").arg(reason);
    case lab::End::Interrupted:
    case lab::End::Lost:
        break;
    }
    return EndText::tr("Interrupted: %1.").arg(reason);
}

} // namespace widgets
