<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en_US">
<context>
    <name>About</name>
    <message>
        <source>A program on a PC over a serial line is no replacement for a switch that removes the power: have one at hand. &quot;Stop motors&quot; takes the motor out of control; it may coast for a long time. If Rotorscope crashes, freezes or is killed, a guardian process tells the motors to stop (not on Windows). If the link is lost or the computer fails, nothing is sent and the motor goes on turning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Rotorscope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A workbench for engineers who tune electric motors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later, without any warranty. Built with Qt %1 and QCustomPlot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the list: add to the scope. In a set-point: send it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the picture, let it run (never starts a motor)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the cursor by a sample, else the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beside the menus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel</source>
        <comment>of the mouse</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom in, out</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Channels</name>
    <message>
        <source>HF</source>
        <comment>high frequency: recorded at the control rate</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MF</source>
        <comment>medium frequency: 1 of 16 samples</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>polled</source>
        <comment>asked for again and again</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board cannot record this register: it is polled and drawn at that rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board records no more signals at once: this one is polled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link is too slow to record it: it is polled.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Colors</name>
    <message>
        <source>Blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Purple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <comment>a colour is chosen</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Confirmation</name>
    <message>
        <source>Type &quot;%1&quot; to continue:</source>
        <comment>a word</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Entry</name>
    <message>
        <source>none</source>
        <comment>no flag is set</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unit here is %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <comment>no unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not less than %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too large a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From %1 to %2.</source>
        <comment>the range of a value</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has no such value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write pairs of hexadecimal digits, one pair for each byte.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It cannot be edited here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ExportFormat</name>
    <message>
        <source>Picture of the scope, PNG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture of the plots, SVG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture of the plots, PDF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV, decimal point and commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV, decimal comma and semicolons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MATLAB file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NumPy array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>WAV, the fast signals as sound</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Exports</name>
    <message>
        <source>The export was cancelled. Written before: %1.</source>
        <comment>files</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written before: %1.</source>
        <comment>files</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>The motor did not come up to a speed at which it can be seen without a sensor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The start-up is too short or too weak for rotor and load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the ramp longer and its current larger, within the motor&apos;s nominal current; end it at 30 to 40 % of the greatest speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The observer does not settle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower its gain G2; lower the least speed at which it is believed to about 10 % of the greatest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor&apos;s values are not right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check resistance, inductance, the back-EMF constant and the pole pairs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The load is too large, or the rotor is blocked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try without the load.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measured or estimated speed is not to be relied on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The observer is too quick for this motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower its gain G2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The speed changes too fast after the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take gentler ramps; go through low speeds quickly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The test of the speed is too strict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow 4 to 5 failed readings in a row.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sensor or its wiring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the order of phases and sensor wires, and the driver&apos;s fault line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The power stage switched itself off because of too much current.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shunt, amplification or topology are set wrongly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare the current scale with the hardware.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The current loop oscillates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower the bandwidth of the current loop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The step of current is too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a slower ramp or a smaller current.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A short circuit, or a damaged stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the power, then measure between the phases and to ground.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The control loop did not finish within its period.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The control rate is too high for this processor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower the PWM frequency or the control rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many signals are recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record fewer signals, or only every second sample.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The firmware was built without optimisation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Build it for release.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bus voltage is above its limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor feeds energy back while it brakes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slow down more gently, or connect a brake resistor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The supply is set too high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare its voltage with the limit of the board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The voltage is measured wrongly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare the shown bus voltage with a meter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bus voltage is below its limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The supply&apos;s current limit is reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raise it, or ask for less current.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The supply is off or connected badly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure at the board&apos;s terminals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The threshold is too high for this supply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare it with the nominal voltage.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The power stage is too hot, or looks so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is too hot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let it cool; ask for less current.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The temperature is measured wrongly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare it with the room&apos;s while the motor is cold; check the sensor&apos;s constants and the threshold.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The firmware found an error of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its settings contradict one another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset the board; undo the last changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An error in the firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note what was done before and report it to its makers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The phase currents could not be sampled in time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The modulation leaves no room for sampling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower the greatest modulation or the PWM frequency.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gate driver reports a fault of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its protection acted: too much current or too little supply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check its supply and the short-circuit threshold.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The wire of its fault line is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check jumpers and pull-up resistors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is known here about this fault.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See the documentation of the firmware</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FileProblem</name>
    <message>
        <source>2 GiB of numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>64 signals and 4 GiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no heading with the names of signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is one column only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are too many columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the line is too long for a line of numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the line has another number of fields than the heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the time %1 is before the one above it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is a heading and nothing else</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No %1 file: it holds at most %2. Choose fewer signals or a shorter range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No %1 file: there is no time at which all fast signals were recorded. Choose fewer of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No %1 file: the signals have different rates. Choose some of one rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no stages, or more than five</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the numbers of its stage %1 do not fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no rev-up: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 byte of the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bytes of the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 other entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 other entries</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GainTexts</name>
    <message>
        <source>unit not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amperes of Iq for radians per second.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it makes at the motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amperes of Id for volts that are missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amperes of Iq for radians of the shaft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The observer&apos;s own full scales are not told by the board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(ST&apos;s rule: %1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where ST&apos;s rule puts it for this motor: poles at a quarter of the motor&apos;s own. %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Gains</name>
    <message>
        <source>Rs, Lq and Ld are needed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board does not say its bus voltage or what a digit of current is worth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board does not say its control rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rad/s is beyond %2 rad/s, what the control rate allows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not fit 16 bits with any divisor: ask for less bandwidth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is so small that it rounds to zero: ask for more bandwidth or less damping.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 times the largest error overflows 32 bits: ask for less bandwidth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The speed loop stays as it is: flux and pole pairs are needed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The speed loop stays as it is: type the inertia of rotor and load.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The speed loop stays as it is: the board does not say its rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above %1 rad/s, boards that measure currents this way often trip: watch for over-current.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The current loop has only %1° of phase margin: it will overshoot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The speed loop has only %1° of phase margin: it will ring.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is rounded by %2 %: the loop is not quite the one asked for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ld is above Lq: are they swapped?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Happenings</name>
    <message>
        <source>bad packets: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused packets: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unanswered: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recoveries: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost control periods: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>skipped packets: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Imports</name>
    <message>
        <source>Importing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be imported (%2).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Lab</name>
    <message>
        <source>a current of %1 A is above the %2 A that are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a speed of %1 rpm is above the %2 rpm that are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a speed of %1 rpm is below the %2 rpm that are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a speed of %1 rpm is above the %2 rpm that are allowed, and the wrong way: its sensor may be aligned wrongly, or two phases exchanged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a bus voltage of %1 V is above the %2 V that are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a bus voltage of %1 V is below the %2 V that are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a temperature of %1 °C is above the %2 °C that are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no samples came for %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the bus voltage was not read for %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the temperature was not read for %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the link to the board was lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board&apos;s answer was lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board&apos;s answer was lost (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it was not sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it was not sent (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading the motor&apos;s state: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recording its signals: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading its bus voltage: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what it writes: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the start goes to: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the start: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the way to the first speed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a step of it: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the way back: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what was there before: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading what is there afterwards: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>then %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board reports a fault: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>something else stopped the motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the start-up went on to turn the motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor did not come to run within %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed did not come to rest at %1 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed did not come back to %1 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor was not seen to stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer came in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor neither runs nor rests: it is in %1 (%2): acknowledge the fault first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor neither runs nor rests: it is in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor turns, and this is measured while it rests: stop it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board does not give %1, which would be written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor is not in speed control: ask for a speed first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor does not turn at its set-point of %1 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not 0, and would be afterwards: bring it to 0 first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the set-point is %1 rpm now, it was %2 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the set-point may be %1 rpm or %2 rpm now, it was %3 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the set-point may be %1 rpm now, it was %2 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 shows %2 rpm until the next start, it showed %3 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 may hold what the experiment wrote</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what it held before comes back with: rotorscope-cli set %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no stage with a speed, as an experiment leaves it that was ended early: write the motor&apos;s own stages first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor is in torque control now, it was in speed control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what comes next is not agreed to any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what comes next was not begun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the way to the first speed takes 1 ms to 10 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing says how fast this motor may turn: give the greatest speed that it may have</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rpm are more than the %2 rpm that are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 A are more than the %2 A that are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stay above %1 rpm: this motor has no sensor, and at %2 rpm its rotor might be lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keep both speeds at %1 rpm or above: this motor has no sensor, and a step to %2 rpm goes on below the %3 rpm that are needed to see its rotor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it could take %1 s, and what moves a motor by itself ends within %2 s: take fewer repetitions, or a shorter time for each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both speeds are the same: there is no step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both currents are the same: there is no step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a series has 1 to %1 repetitions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a speed is held for 50 ms to 10 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a current is held for 10 to 500 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a current rises within 10 ms to 2 s and is held for 100 ms to 2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor has to turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a torque against the way that the motor turns would brake it, and nothing says that its supply takes what comes back: both currents have to push the same way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this board does not record the angle of its rotor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this board does not record the current along its magnets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this board does not record voltages, currents and the angle of its rotor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this board does not record its voltage and both of its currents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this board holds no current through a motor that rests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board does not tell the nominal current of its motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board does not tell the strength of the magnets, without which no torque is known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it needs two currents, the second at least 1.5 times as strong as the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 A are more than the %2 A of your own limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 A are more than the %2 A that a motor at rest is given here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most %1 A flow along the magnets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it takes 1 to 30 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it takes 4 to 40 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it needs two speeds in one direction, the lower one first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed has to go to and fro by 1 rpm or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed may go to and fro by less than half of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no such motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run ended early: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the series ended early: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording ends before the series does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording ends before the experiment does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no recording of an experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no recording of a series of steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no recording of a series of current steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no recording of a mechanical identification</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no recording of an electrical identification</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no recording of a speed&apos;s frequency response</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no recording of a current loop&apos;s frequency response</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds no samples of the signals that it needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds no samples of the signals of its series of steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds no samples of that time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor was never driven by a torque in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor was never driven by a current while it turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the set-point was never moved in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor turned for only %1 s of it without a gap; %2 s are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too little of it is without a gap: stretches of two seconds are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too little of it is without a gap: a second is needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed hardly changed: no inertia follows from it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this motor changes its speed too fast for its Hall sensors: between two of their edges their angle is too far from the rotor&apos;s to tell a torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>part of the friction may be a fan&apos;s: the angle of Hall sensors at these speeds does not tell the one from the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the rotor turns by up to %1 electrical degrees within a control period: what its current does meanwhile is not seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the voltages tell magnets of %1 mWb, the board of %2 mWb (%3 %): the voltages were believed; perhaps the angle of its rotor is off, as after an alignment against friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by what its currents do to its speed, the board takes its rotor for more than 60 electrical degrees beside where it is: its flux is not told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the rotor nearly stood still for %1 s: that time was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % of the samples do not fit the others and count for nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the rotor turned where it was to rest: neither its resistance nor the angle that it was aligned to is sure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at rest no two different currents were held for long enough</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at rest no resistance follows from the voltages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it does not tell the nominal current of the motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds too few samples of the turning motor without a gap, or they are too far apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>while it turned the current along the magnets hardly changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>while it turned no inductance follows from the voltages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its samples are too far apart to tell the inductance across the magnets, which only jumps of the current tell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it turned too slowly to tell the inductance along the magnets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the dead time takes cannot be told from the resistance: currents swung through zero within a PWM period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing follows from it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not conclusive: no step of this series could be measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not conclusive: not all of it could be measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the loop&apos;s gain does not fall through 1 where it could be measured: no margin is told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>above 10 Hz the motor&apos;s own response is not told: what is taken for the angle of a rotor without an encoder follows its current, too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what is taken for the angle of a rotor without an encoder follows its current, by %1 electrical degrees an ampere if all that turns is one inertia: that is taken out, and above 25 Hz the motor&apos;s own response is not told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing in it follows the set-point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the current does not follow its reference in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the gains were changed while it was measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is the loop at %1 A: what a bridge loses by its dead time damps it the more the smaller the current is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board does not tell its gains, so its loop is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no speed loop has the period that the board tells</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too few frequencies of the response are clear enough</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no gains keep the distance from instability that is asked for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rise time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>settling time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>peak current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the step is only %1 digits of the set-point; %2 rpm or more say more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples are missing in %1: nothing is told of its speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples are missing in %1: nothing is told of its current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the instant of %1 is uncertain by %2 ms: its settling time is not told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not settle while its speed is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not settle while its current is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the current was at its limit in %1 % of %2: it does not show the loop alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the noise of the measured current is %1 % of the step: overshoot and settling are told from noise, too; a larger step says more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the port was closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the port was lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another command went to the motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the drive was disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the drive is not armed any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every motor was stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no port is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another experiment is running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the drive is not armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too late: it was asked for more than half a second ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor was started all the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor may be in torque control now, it was in speed control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board takes its rotor for %1 electrical degrees beside where it is, as after an alignment against friction: its torque was counted by that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board takes its rotor for %1 electrical degrees beside where it is, as after an alignment against friction: its magnets were counted by that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this board has no gains of a speed loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gains are 0 to %1 digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor turns, and its gains are written while it rests: stop it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor was started meanwhile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it was refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it was refused (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the drive was disarmed, and the motor that was started is driven on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Stop goes out as soon as the board is reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was cut short: nothing is told of its speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was cut short: nothing is told of its current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor did not get to its first speed: the board reports a fault: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed did not come to rest before the first torque: its speed loop swings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every motor was told to stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1 (up) stands apart from the others by its %2; it is part of the mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1 (down) stands apart from the others by its %2; it is part of the mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mean %1 is that of %2 of %3 steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mean %1, %2, %3 and %4 are those of %5 of %6 steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mean %1, %2 and %3 are those of %4 of %5 steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mean %1 and %2 are those of %3 of %4 steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 steps do not settle while their speed is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 steps do not settle while their current is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not seen in the speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not seen in the current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1 (up)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1 (down)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board does not give %1, and without it nothing bounds its bus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board is at %1 °C, and %2 °C end an experiment: let it cool down first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it was not over within %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board does not record the speed that its main sensor tells.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board does not record both the current of its motor and what it is to be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board records %1 signals at a time, and experiments need %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples of %1 s are missing in it: only what is without a gap counts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its samples are %1 ms apart, too far for the response of a speed: %2 ms are the most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its samples are %1 ms apart, too far for the response of a current: %2 ms are the most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed was not read for %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the current was not read for %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board does not tell the speed of its motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing tells its current in A, so that none could be held against your limit: say what the full scale of its currents is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no recording of a motor&apos;s power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>resistance or dead time is not known: what it takes is not told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Electrical power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copper losses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Efficiency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board records nothing: its speed was read once in up to %1 ms, so that rise times are uncertain by as much, and peaks may be higher than is told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 steps rise in less than three times the time between two of their values: nothing is told of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An experiment was cut off before it gave back what it had borrowed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the inertia that its two directions tell is %1 % apart: perhaps its load is another one backwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a torque of %1 N m is always there and drives it backwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a torque of %1 N m is always there and drives it forwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor turns the other way: stop it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it was driven in one of its two directions only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor still turns the other way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this board records nothing by itself: only steps of the speed, inertia and friction are told from values that are read one after the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this board records nothing by itself: inductances are not told from values that are read one after the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing tells its current in A, and so no torque: say what the full scale of its currents is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its ramps take %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing tells which torque an ampere makes: it follows from pole pairs and flux of a motor file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this board does not tell which pole pairs it counts by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an encoder tells this board the turns of its rotor, which say nothing of pole pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor does not turn: let it run at a constant speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rpm of the board, which counts by %2 pole pairs, and %3 rpm of the shaft make %4, which is no whole number: read both again, at a constant speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>set-points with every exchange: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its board records nothing by itself, and its torques are counted by %1 N m for an ampere, as was given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board sends its samples once an exchange: this is measured by samples at the rate of its control loop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this board sends its samples once an exchange: only steps and response of the speed, inertia and friction are told from them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this drive does not send its speed, its current and what they are to be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor turns, and its set-points can begin to leave with every exchange only while it rests: stop it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>set-points leave with every exchange still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque of the load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The speed gives way by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For each ampere by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak Iq</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it takes 2 to 30 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no recording of a load that changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no load came or went while the speed was held: nothing moved it out of its noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the load came %1 times and went %2 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>for %1 % of the time no exchange came for 5 ms or longer: straight lines stand there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor is in position control now, it was in speed control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motor may be in position control now, it was in speed control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this board does not control the position of its shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a shaft is moved by 1 to 3600 degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a move takes 1 ms to 10 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a position is held for 100 ms to 10 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no recording of moves of a shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was cut short: nothing is told of its position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 steps do not settle while their position is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples are missing in %1: nothing is told of its position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not seen in the position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not settle while its position is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a speed is no number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a current is no number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>set-points may leave with every exchange now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the load changed, and the speed did not come back before the end, or before it went again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a change of the load was not over at the end, or where samples are missing: it does not count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a load came and went before the speed was back: it does not count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the shaft moved by %1 degrees instead of %2 at the worst</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the shaft does not come to rest without a current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board does not tell where its shaft is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the shaft is too far from where the board was switched on, and positions count from there: switch the board off and on</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Laid</name>
    <message>
        <source>its beginning</source>
        <comment>of a recording</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of the signals on the scope is in %1.</source>
        <comment>a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is reference %2, with %3 of the %4 signals on the scope.</source>
        <comment>file, A or B, numbers</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the trigger lies: %1.</source>
        <comment>a moment of a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the left edge lies: %1.</source>
        <comment>a moment of a file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference %1 is again the one before.</source>
        <comment>a letter</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There was a reference %1 already. It is replaced; %2 brings it back.</source>
        <comment>a letter, a key</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Link</name>
    <message>
        <source>The port is open but no board answers. Check the baud rate, the cable and the board&apos;s power.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes arrive but make no sense. The baud rate or the protocol is probably not the board&apos;s: try another one, and check the board&apos;s firmware.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board answers but does not agree on the settings of the link. Reset the board and connect again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board went silent. Check the cable and the board&apos;s power.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact to the board could not be restored. Check the cable and the board&apos;s power, reset the board and connect again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board was reset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board speaks the protocol of older firmware.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drive does not say that it is ready. Check its power and the ready line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing drives the line to this computer. Check the wiring, the chip select and the drive&apos;s power.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asking whether the board speaks the protocol of newer firmware; if no answer comes, that of older firmware is next.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer in the protocol of newer firmware: asking in that of older firmware.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board speaks the protocol of newer firmware.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no port %1. Plug the board in, or choose another port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is in use%2. Close what uses it, then connect again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 refuses this baud rate. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was unplugged. Check the cable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This program did not run for a while. Its guardian has told every motor on %1 to stop, without evidence that they did.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording %1 cannot be read. Choose another file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be opened%2. Check the cable, then connect again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You may not use %1. Join the group that owns it (serial ports: &quot;sudo usermod -aG dialout $USER&quot;), then log out and in again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Measures</name>
    <message>
        <source>Minimum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smallest sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum minus minimum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean of all samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The root of the mean square of all samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycle mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean over whole periods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycle RMS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The RMS over whole periods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of whole periods, between upward crossings of the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean of whole periods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of a period above the middle level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 to 90 % of the first complete upward edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fall time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>90 to 10 % of the first complete downward edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Past the final value, in percent of the step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undershoot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the wrong side of the initial value, in percent of the step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the step to the largest deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the step to the last entry into 2 % of the step around the final value, which is the mean of the last 20 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dead time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the step to 5 % of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ripple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak to peak once settled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ripple RMS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS around the mean once settled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By how much the second trace is ahead of the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples are missing inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no full period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no complete edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not settled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no set-point given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not the same frequency</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connecting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>board answering</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>board silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recovering</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sent, but the answer was lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused by this program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused by the board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown</source>
        <comment>state of a motor</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Idle</source>
        <comment>state of a motor</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting</source>
        <comment>state of a motor</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running</source>
        <comment>state of a motor</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping</source>
        <comment>state of a motor</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fault present</source>
        <comment>state of a motor</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stop requested</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>accepted</source>
        <comment>the board accepted the stop</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drive idle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standstill measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not confirmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop NOT confirmed. Use the hardware stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond your own limit of %1 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond your own limit of %1 A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond the limit of %1 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond the limit of %1 A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is beyond your own limit of %2 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is beyond your own limit of %2 A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is beyond the limit of %2 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is beyond the limit of %2 A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed on the way is beyond your own limit of %1 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed on the way is beyond the limit of %1 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is on, and then no limit of your own holds: turn it off first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in this control mode no limit of your own holds: take yours away first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in torque control nothing keeps the speed within your own limit of %1 rpm: take that limit away first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the fault is still present; remove its cause first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer about what it would start to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped; arm again first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too late: it was asked for more than half a second ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>action: how it ended</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 (%3).</source>
        <comment>action: how it ended (the board&apos;s word)</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The export was cancelled; no file was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a file. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written (%2). Choose another folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be replaced (%2). Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is the first start since the board was connected or stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The set-point moves by more than 20 % of the limit of %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is not known from where the set-point moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It acts against the way the motor turns now (%1).</source>
        <comment>speed</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The control changes between speed and torque while the motor runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is not known whether its speed or its torque is controlled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It ends the experiment that is running; where nothing else bounds the motor, as in torque control, every motor is stopped instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expert mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <comment>of a motor</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop one motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge faults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write</source>
        <comment>a register that can move something</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>user</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>command line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>greatest speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>greatest current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nominal current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shaft goes to an angle by itself, and is held there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In torque control nothing keeps the speed within your own limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current scale</source>
        <comment>a person says it</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All motors were told to stop. Look at them, then arm again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was disarmed; the motors go on as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This window stood still for %1 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This program or the computer stood still for %1 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The jog was ended: this window stood still while it was held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not armed: it was asked for while this window stood still. Arm again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed not measurable: the rotor may coast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fault latched</source>
        <comment>state of a motor; acknowledge to go on</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no board found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not written: %1. Make room or choose another folder; nothing was replaced.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No motor was driven when the board was last heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor may still be turning; the drive is to stop it by itself after %1 ms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor may still be turning (this drive has no communication time-out).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is connected again; arm it before you go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose that one, or Auto, and connect again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotorscope reconnects; arm again to move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in torque control this board does not tell to which current a start goes; take your own limit of current away first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond the %1 rpm that this protocol can hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond what 16 bits hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scale of motor %1 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the board does not tell where the shaft is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the limits have changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too many wishes wait already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a register of it is lent to an experiment until that ends</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Motion</name>
    <message>
        <source>Connect to a board first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge the faults first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor has to be idle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fault is still present: remove its cause first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no fault to acknowledge.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MotionQuestion</name>
    <message>
        <source>This will move motor %1. Go on?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expert mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board does not tell all limits of motor %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not known: %1</source>
        <comment>list of limits</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Until the connection ends, set-points of this motor are bounded only by what is known and by your own limits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motor %1</source>
        <comment>to be typed</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Motor</name>
    <message>
        <source>Pole pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Electrical turns for each turn of the shaft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rated flux</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength of the magnets, as the board has it: Ke (V rms between two terminals at 1000 rpm) in standard firmware, V/Hz in HSO firmware. Which of both is judged by the flux that it makes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resistance Rs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of one phase: half of what is measured between two terminals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 in standard firmware: not used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inductance Lq</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across the magnets, of one phase.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inductance Ld</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the magnets, of one phase. Smaller than Lq where the magnets are buried.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor&apos;s greatest current, peak.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copper mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cooling time constant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greatest speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No speed set-point goes beyond it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greatest readable current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The end of the current converters&apos; range; more is not seen and not controlled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No current set-point goes beyond it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal bus voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What gains and the voltage scale were made for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Main speed sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auxiliary speed sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current sensing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PWM periods a control period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switching frequency (PWM)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed loop rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built with, too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What one digit of a phase voltage is worth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What one digit of a current is worth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What one digit of a speed is worth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firmware version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Streams over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals at once, UART A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals at once, UART B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals at once, ST-LINK</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It takes true or false.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It takes a text of at most %1 bytes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It takes a whole number from %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It takes a number from %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits of the drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scales</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flux of the magnets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Viscous friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pole pairs are no whole number from 1 to 50: count the magnets and halve, and set them in the firmware&apos;s project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The resistance is missing or no motor&apos;s: measure between two terminals and take half.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An inductance is missing or no motor&apos;s: check whether millihenry were given as henry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The strength of the magnets is missing or no motor&apos;s: the converter gives Ke from KV or from a measurement.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor&apos;s current is missing or no motor&apos;s: take the nominal current of the data sheet, times 1.414 if that is rms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ld is greater than Lq, which no magnet motor is: ST&apos;s generator may have swapped them. Measure both before gains are made of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L / R is outside 10 µs to 1 s: one of them has the wrong unit, or one is between terminals and the other of a phase.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor&apos;s current is more than the drive can measure: keep set-points below, or take another shunt or gain.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The greatest speed is beyond the base speed: with nominal current and bus voltage it needs flux weakening.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It cannot be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is larger than any description of a motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1 is no JSON: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is no JSON object with %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At “%1” there has to be an object with %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no key “%1”; there are %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its preset is none of the simulator&apos;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value of “%1” cannot be used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is below the supply voltage.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“ls” was taken as millihenry: as henry it would be no motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only one inductance was measured: of a motor with buried magnets, measure Ld and Lq.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys that are not known were passed over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dry friction</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Opening</name>
    <message>
        <source>Opening %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be opened (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) in it are damaged; what lies before and after is shown.</source>
        <translation>
            <numerusform>One place in it is damaged; what lies before and after is shown.</numerusform>
            <numerusform>%n places in it are damaged; what lies before and after is shown.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of its events, snapshots and notes are left out: they take more than %2 MiB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording was interrupted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It ends where the disk was full.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It ends where the disk failed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is larger than the %1 GB of room for it: %2 samples before %3 s are not shown, and marked as a gap.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It lacks %1, because the disk was too slow.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlanQuestion</name>
    <message>
        <source>rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n time(s): at once to %1, and at once back to %2, each held for %3.</source>
        <translation>
            <numerusform>%n time: at once to %1, and at once back to %2, each held for %3.</numerusform>
            <numerusform>%n times: at once to %1, and at once back to %2, each held for %3.</numerusform>
        </translation>
    </message>
    <message>
        <source>For %1 its torque jumps and drives it or lets it coast, between %2 and %3; the current along the magnets jumps within ±%4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For %1 its torque drives it or lets it coast, between %2 and %3; it is never braked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For %1 its speed jumps at random between %2 and %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At rest: currents from %1 to %2 along the magnets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In its start-up, whose stages are borrowed and do not turn: currents of %1 and %2; then it is stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n time(s): its current jumps from %1 to %2 and back.</source>
        <translation>
            <numerusform>%n time: its current jumps from %1 to %2 and back.</numerusform>
            <numerusform>%n times: its current jumps from %1 to %2 and back.</numerusform>
        </translation>
    </message>
    <message>
        <source>no bound</source>
        <comment>of the current</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It rests.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It runs: from %1 to %2 in %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It rests: start, then to %1 in %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then back to %1 in %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then the motor is stopped, and its old set-point comes back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped at once: below %1 or above %2, beyond %3 of Iq, and where the bus voltage, the temperature or the link is not as it should be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While it starts, only %1 and the current bound it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It runs: from %1, and back there after each of these.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. %2 Stopped below %3, above %4, beyond %5.</source>
        <comment>number, what is done, caps</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also stopped where the bus voltage, the temperature or the link is not as it should be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inductances and flux</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inertia and friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Response of the current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Response of the speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resistance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps of the current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This will move motor %1 by itself. Go on?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its gains are Kp %1 and Ki %2 meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It rests: it is started for each of these, and stopped afterwards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 times the nominal current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 times the greatest current of the board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>your own limit of the current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The limits in the control panel bound what is asked for, these caps what is measured: up to %1 beyond the plan, and %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board does not tell its bus voltage: nothing bounds it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A step down brakes the motor, which feeds the bus: only the cap of the bus voltage bounds that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A step down brakes the motor, which feeds the bus.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The like within these caps and this time is not asked about again until disarmed. Esc stops every motor at any time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For %1 it is held at %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While it starts, only %1 bound it.</source>
        <comment>a speed</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backwards, for %1: its torque drives it or lets it coast, between %2 and %3; it is never braked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For %1 ramps lead it from %2 to %3 and back; an ampere is taken for %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A ramp down brakes a heavy rotor, which feeds the bus.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For %1 it is held at %2, while you change its load.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes of the load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its set-points leave with every exchange meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n time(s): its shaft is moved by %1 and back, each way in %2.</source>
        <translation>
            <numerusform>%n time: its shaft is moved by %1 and back, each way in %2.</numerusform>
            <numerusform>%n times: its shaft is moved by %1 and back, each way in %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Each move ends by braking, which feeds the bus.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps of the position</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message numerus="yes">
        <source>%n byte(s)</source>
        <translation>
            <numerusform>%n byte</numerusform>
            <numerusform>%n bytes</numerusform>
        </translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <comment>no flag is set</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>now: %1</source>
        <comment>faults that are present</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>past: %1</source>
        <comment>faults that occurred</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>digits</source>
        <comment>unit of a raw number</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 digits are the full scale of the current sensor, which this board does not tell.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Readings</name>
    <message>
        <source>no sample</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RevUp</name>
    <message>
        <source>Begin with a stage at 0&#x202f;rpm that brings the current, at least %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raise the current here and before to at least %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage %1 needs %2, its current gives %3: the rotor does not follow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage %1 ends at %2, where the observer does not see the rotor yet. Let it end above %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage %1 takes no time: speed or current jump, the rotor is left behind. Give it time, or remove it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage %1 goes to %2; firmware keeps 16 bits of it, at most %3. Lower it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage %1 turns against the stage before. Give all the same sign; backwards starts come from the sign of the speed set-point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No stage takes any time: the motor would not start. Add a stage, or begin with the start values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage %1 takes %2, more than the limit of %3. Lower it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage %1 goes to %2, beyond the limit of %3. Lower it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it at least %1; so much current is not allowed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it at least %1, or a current of at least %2 here and before.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RunMark</name>
    <message>
        <source>circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diamond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cross</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>triangle upside down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>star</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RunText</name>
    <message>
        <source>Not carried out: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interrupted: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rise %1 ms, overshoot %2 %, settling %3 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>J %1 kg m², friction %2 and %3</source>
        <comment>inertia, dry, viscous</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rs %1, Ld %2, Lq %3, flux %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crossover %1 Hz, phase margin %2°, Ms %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed step %1 rpm</source>
        <comment>from to</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flux step %1 A</source>
        <comment>from to</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque step %1 A</source>
        <comment>from to</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mechanics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Electrics, turning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Response of the speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Response of the current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 to %3 s</source>
        <comment>a recording, seconds</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Electrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>electrical %1 W, shaft %2 W, efficiency %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power at %1 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ended: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>load %1 A, gives way by %2 rpm, back in %3 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load at %1 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position step %1°</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Setpoint</name>
    <message>
        <source>Type a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not a plain number: use digits, one decimal point and a sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the number without group marks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many digits.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SettingsFile</name>
    <message>
        <source>The settings could not be read, so all are as at first. The damaged file is kept as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The settings could not be read, so all are as at first. The damaged file %1 is replaced when Rotorscope ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings and notes cannot be saved (%1): what is changed now is lost when Rotorscope ends.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Shaft</name>
    <message>
        <source>A move to an angle needs a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the way %1 rpm would be needed: the limit is %2 rpm. Give it more time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most %1 rpm on the way</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Snapshot</name>
    <message>
        <source>none</source>
        <comment>no flag is set</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is no snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is of a newer version than this program knows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no list of registers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has more registers than any board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board does not have it, or it cannot be written there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It holds something else in this firmware.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not restored: it moves a motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing it can move something, and its motor is not idle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firmware gives it in another form than it takes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no motor from 0 to 7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no known type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its raw number does not fit its type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has neither bits nor a raw number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no raw text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its bytes are no pairs of hexadecimal digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is there twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be used: in line %2 %3 (%4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be used: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be used: line %2, register %3: %4.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Ticks</name>
    <message>
        <source>%1/div</source>
        <comment>what is between two lines of the grid</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2/div</source>
        <comment>number, unit: what is between two lines of the grid</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ToldFigures</name>
    <message>
        <source>%1: %2 (%3 to %4).</source>
        <comment>a number and its interval</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not conclusive: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>a number</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Trigger</name>
    <message>
        <source>Edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulse width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dropout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N-th edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Register write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rising</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>falling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>either way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at or above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at or below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leaves the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>enters the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>positive pulse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>negative pulse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto</source>
        <comment>mode of the trigger</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <comment>mode of the trigger</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Single</source>
        <comment>mode of the trigger</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll</source>
        <comment>mode of the trigger</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed</source>
        <comment>state of the trigger</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trig&apos;d</source>
        <comment>state of the trigger</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto</source>
        <comment>state of the trigger</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll</source>
        <comment>state of the trigger</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A level or a time is no number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hysteresis is below zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The upper level has to be above the lower one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These times leave nothing to wait for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The count has to be at least 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold</source>
        <comment>state of the trigger</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set-point</source>
        <comment>type of the trigger</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WorkspaceFile</name>
    <message>
        <source>Line %1 is not JSON: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is no workspace: it has no &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was written by a later version of Rotorscope (its form is %1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its value of %1 cannot be.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WriteQuestion</name>
    <message>
        <source>not known</source>
        <comment>the old value</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1, %2</source>
        <comment>number, change</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Board, %1</source>
        <comment>change</comment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message>
        <source>Write registers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (gain changes by more than a factor of 2 while running)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This can move or harm a motor immediately.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WriteReport</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message>
        <source>The board made another value of: %1.</source>
        <comment>list of registers</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not written: %1</source>
        <comment>list of registers with reasons</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>register: reason</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) restored and verified.</source>
        <translation>
            <numerusform>%n register restored and verified.</numerusform>
            <numerusform>%n registers restored and verified.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) written and verified.</source>
        <translation>
            <numerusform>%n register written and verified.</numerusform>
            <numerusform>%n registers written and verified.</numerusform>
        </translation>
    </message>
    <message>
        <source>Sent, outcome unknown: %1.</source>
        <comment>list of registers</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written, not verified: %1.</source>
        <comment>list of registers with reasons</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::AutoSnapshots</name>
    <message>
        <source>What the board held before is kept in memory only: %1 was not written (%2). Save a snapshot to another place before you leave.</source>
        <comment>file, the system&apos;s words</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was written: the board did not tell what it holds first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was written: the board did not tell what it holds first (%1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The snapshot before the write is without: %1.</source>
        <comment>list of registers</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::Banner</name>
    <message>
        <source>Close this message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::BigNumbers</name>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current Iq</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bus voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Large numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <comment>number, state</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::BodePlot</name>
    <message>
        <source>No response yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dB of %1</source>
        <comment>a unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coh.</source>
        <comment>coherence, short</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hz</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ChannelStrip</name>
    <message>
        <source>Drag registers here or onto the scope, or press Enter in the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate of the fast signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples a second of each HF signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HF rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How %1 is recorded: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How this signal is recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it off the scope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 kB/s (%3 %)</source>
        <comment>used, available, percent</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rate lowered to fit the link</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s) polled, see the chips</source>
        <translation>
            <numerusform>%n signal polled, see the chips</numerusform>
            <numerusform>%n signals polled, see the chips</numerusform>
        </translation>
    </message>
    <message>
        <source>, measured %1 kB/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planned: %1 kB/s of %2 kB/s; one packet every %3 ms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>This link carries %n HF signal(s) at every control period.</source>
        <translation>
            <numerusform>This link carries %n HF signal at every control period.</numerusform>
            <numerusform>This link carries %n HF signals at every control period.</numerusform>
        </translation>
    </message>
    <message>
        <source>At the chosen rate it would be %1 kB/s: recorded at one period in %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1/s</source>
        <comment>times a second</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read %1 times a second.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each value is one of the %1 ms before the time at which it is drawn: question and answer lie so far apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each signal read up to %1 times a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, reached %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board records nothing by itself. Its line of %1 kB/s is shared by the signals, the registers that are seen and the motor&apos;s state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How %1 is computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s)</source>
        <translation>
            <numerusform>%n signal</numerusform>
            <numerusform>%n signals</numerusform>
        </translation>
    </message>
    <message>
        <source>Shows the signals as chips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folds the chips away: more room for the plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Formula…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HF: every sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>MF: 1 of %n samples</source>
        <translation>
            <numerusform>MF: 1 of %n sample</numerusform>
            <numerusform>MF: 1 of %n samples</numerusform>
        </translation>
    </message>
    <message>
        <source>Polled: read in turn</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::CommandBox</name>
    <message>
        <source>Arm: allow commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start → %1</source>
        <comment>speed or current</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge faults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts the motor (Ctrl+Enter).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledges the faults that are over (Ctrl+Backspace).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Until it is armed, nothing that writes or moves leaves Rotorscope. A stop, a lost link and a new connection disarm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ConnectBar</name>
    <message>
        <source>Simulated board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A port of the list, or a path that you type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a port, or type its path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a baud rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>port open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>port not open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>port closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes the port (Ctrl+D)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens the port and looks for a board (Ctrl+D)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <comment>number, name</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated board (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds out what the board speaks; nothing that is sent for it can move a motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the board speaks; Auto finds it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replay, no port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>board as recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clock [Hz]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an SPI clock from 10 kHz to 100 MHz, in Hz.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ControlPanel</name>
    <message>
        <source>rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change…</source>
        <comment>the limits</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change own limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known</source>
        <comment>a limit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <comment>a limit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (yours)</source>
        <comment>a limit of the person&apos;s own</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits: none (expert mode)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expert mode: the board does not tell all limits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the current scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current scale: %1 (yours)</source>
        <comment>with unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current scale: not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The current of %1 digits, which the board does not tell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits: not known yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits: %1,
%2</source>
        <comment>speed, current, below each other</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale…</source>
        <comment>of the currents</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits: %1, %2</source>
        <comment>speed, current</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits: not known</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::CurrentScaleDialog</name>
    <message>
        <source>Current scale of motor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known</source>
        <comment>the current scale</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board does not tell the scale of its currents. Without it they are shown in digits and none can be asked for; with a wrong one the motor gets a wrong current. Setting it disarms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Full-scale current [A] (peak, %1 digits)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Or from the measuring circuit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Shunt [mΩ]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Gain of the amplifier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reference of the converter [V]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 digit is %1 mA; 1 A is %2 digits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Currents are shown in digits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A full-scale current is a plain number from 0.001 to %1 A, or nothing.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::CurrentScales</name>
    <message>
        <source>Setting the current scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: currents in A by the scale that was entered for this board before, %2 A at full scale. See Current scale in the control panel.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::CursorPanel</name>
    <message>
        <source>Values at the cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pair of cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pair that is read out; type to give it a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another pair of cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this pair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the values as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide the cursors (C)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::CursorTable</name>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::Cursors</name>
    <message>
        <source>Pair %1</source>
        <comment>of cursors</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::EditBar</name>
    <message>
        <source>Revert</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Apply %n edit(s)</source>
        <translation>
            <numerusform>Apply %n edit</numerusform>
            <numerusform>Apply %n edits</numerusform>
        </translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for a motor that is not shown: %1.</source>
        <comment>list of registers</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply (%1)</source>
        <comment>so many edits</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::EventLane</name>
    <message>
        <source>Events</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <comment>events</comment>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message>
        <source>%1  %2: %3</source>
        <comment>time, kind of event, what happened</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What happened, on the clock of the traces. Double-click sets a marker.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::EventLog</name>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write</source>
        <comment>an event: a register was written</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <comment>heading of a column: the kind of an event</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Event or note</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::EventPanel</name>
    <message>
        <source>Events and markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter shows an event on the scope, F2 edits a marker&apos;s note, Delete removes a marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set a mar&amp;ker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Markers on&amp;ly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete m&amp;arkers</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::EventRecorder</name>
    <message>
        <source>Motor %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge faults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ramp to %1 rpm in %2 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ramp to %1 A in %2 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Currents Iq %1 A, Id %2 A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a command and how it ended</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <comment>a register, its value before and after</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disconnected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of samples lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft to %1° in %2 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; at the board within %2</source>
        <comment>a command, a time</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, for %2</source>
        <comment>trouble of the link, how long</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another board: %1</source>
        <comment>its names</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiment: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ExperimentBar</name>
    <message>
        <source>Done; the motor is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done; afterwards: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not carried out: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interrupted: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not begun: the gains were not written in time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops every motor and disarms, as Esc does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is measured at rest: stop the motor first.</source>
        <comment>Resistance</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor is in torque control: ask for a speed first, with Go or a speed ramp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was measured is being evaluated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not continued: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What comes next is not agreed to any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not begun: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 s of about %3 s</source>
        <comment>what is measured, times</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>text of a button, why it is greyed</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ended: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both directions begin at rest: stop the motor first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::Experiments</name>
    <message>
        <source>An experiment is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board does not tell all limits of the motor: start it by hand once, and agree to expert mode.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge the faults first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor has to rest or to run.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ExportDialog</name>
    <message>
        <source>What the scope shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One file; slower signals keep their last value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One file for each rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has been recorded yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 exists already. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between the cursors A and B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;ates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scope as it is on the screen now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s). The first column is the time in seconds. Lost samples have no row.</source>
        <translation>
            <numerusform>One signal. The first column is the time in seconds. Lost samples have no row.</numerusform>
            <numerusform>%n signals. The first column is the time in seconds. Lost samples have no row.</numerusform>
        </translation>
    </message>
    <message>
        <source>The 16-bit codes of the fast signals, a channel each, at their own rate; where samples were lost the next ones follow at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No trace is shown. Choose everything recorded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s), every sample with its time; what is unknown is NaN.</source>
        <translation>
            <numerusform>One signal, every sample with its time; what is unknown is NaN.</numerusform>
            <numerusform>%n signals, every sample with its time; what is unknown is NaN.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::Exporting</name>
    <message>
        <source>Exporting %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motion log is in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motion log %1 could not be written (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture of the scope is in the clipboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An export is under way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without it there is no file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close when it is written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording is still being read: its outline is not exported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds no samples: there are none in the chosen range.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::FaultHelp</name>
    <message>
        <source>Faults and their causes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faults are not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1 has no fault.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Present at motor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over, to be acknowledged</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::FaultPicture</name>
    <message>
        <source>%1, motor %2: %3</source>
        <comment>time, number, faults</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording what follows…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No signal was recorded when this fault came. Drag signals onto the scope: then the next one has a picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When it was told (0 s): %1</source>
        <comment>values of signals</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals around the fault</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::FileJob</name>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Being cancelled…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: about %2 s left</source>
        <comment>what is done, a number</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::FirstSteps</name>
    <message>
        <source>Hide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help &gt; First steps brings these cards back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Welcome to Rotorscope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try everything on a simulated board, or choose the port of your own board above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to simulated board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect my board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected: the scope shows live signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick &quot;Arm&quot; on the right, then press Start. The Esc key stops every motor, wherever you are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor is running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type another speed and press Enter. Drag a register from the list onto the scope to see it too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save what you see</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The export writes the visible part, or all of it, as a CSV file with units.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::GainForecast</name>
    <message>
        <source>%1 to %2</source>
        <comment>percent</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No prediction yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asked %1, at the motor %2 rad/s (%3 Hz). Rise %4 ms, overshoot %5 %, margin %6°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rise with a timer that takes the new voltage at once, as on the simulated board. One that takes it a period later rises quicker and overshoots more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The speed loop stays as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rise %1 ms, margin %2°. Overshoot %3 %, behind a ramp %4 %.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For steps up to %1 rpm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything between the wish and the measured speed is %1 ms late. A larger step needs more than the nominal current, and rises more slowly.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::GainLab</name>
    <message>
        <source>Current bandwidth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed damping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As ST&apos;s rule counts it; the loop at the motor is 15 % faster.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Also plan the speed loop. Damping 2 is quick and rings, 4 is calm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delay of the measured speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How late the measured speed is: half the length of its average. The board does not say it; this is what ST&apos;s generator takes for its sensor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the &amp;board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect a board: the gains are for its registers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board&apos;s firmware does not let %1 be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a bandwidth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>field, what is wrong with it</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a damping from 1.05 to 20, or leave the speed loop out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes edits of the new numbers, numerator and divisor together. Nothing is written before Apply.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This drive&apos;s gains are numbers in units, and its current loop is not the one whose rule is used here: set them among the regulators.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forgets what was typed here and what was measured, and takes the board&apos;s numbers again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::GainMotor</name>
    <message>
        <source>Rs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lq</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ld</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pole pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flux</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of a phase: half of what is measured between two wires.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the magnets, linked with a phase, peak.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volts rms between two wires at 1000 rpm. The same as the flux: one follows the other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of rotor and load together; boards rarely know it. It is remembered for motors of this name. 1 kg·m² = 10,000,000 g·cm².</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>field, what is wrong with it</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <comment>quantity, least and greatest value</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured, with 95 %: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured, without an interval: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::GainPlanTable</name>
    <message>
        <source>Planned gains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rounding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many times larger the number could be before it, or its product with the largest error, overflows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::GainPlot</name>
    <message>
        <source>100 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>— new   - - board</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::GainTable</name>
    <message>
        <source>Torque (Iq)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flux (Id)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flux weakening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observer&apos;s PLL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observer (C1, C2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CORDIC observer (C1, C2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Currents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gains: connect a board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Proportional</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Integral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Derivative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board&apos;s firmware has no gains to be tuned.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>≈ %1 rad/s, damping %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Natural frequency of the PLL at half the highest speed, if the observer&apos;s full scale is 1.2 times that speed, as ST&apos;s generator has it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This firmware counts per unit and does not say of what.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not read yet.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::GainsForm</name>
    <message>
        <source>Pages of the gains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Regulators</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gain &amp;lab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Board: %1 V, %2 digits per A, %3 kHz, speed loop %4 kHz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board does not say what its digits are worth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A write is under way: preview again when it has ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be edited now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n edit(s) wait: Apply writes them as one step.</source>
        <translation>
            <numerusform>%n edit waits: Apply writes it.</numerusform>
            <numerusform>%n edits wait: Apply writes them as one step.</numerusform>
        </translation>
    </message>
    <message>
        <source>The board has these gains already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n other edit(s) waited already and would be written with them: %1.</source>
        <translation>
            <numerusform>%n other edit waited already and would be written with them: %1.</numerusform>
            <numerusform>%n other edits waited already and would be written with them: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The gains of this drive are in the units that stand beside them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The form has changed: the edits of its preview were dropped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edited by hand, not as planned here: %1. Apply writes what was edited.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::GiveBack</name>
    <message>
        <source>Give back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As before the experiment</source>
        <comment>name of a step of the list of edits</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An experiment is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor has to rest: stop it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes what the registers held before the experiment, and reads it back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::Identification</name>
    <message>
        <source>Not conclusive: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::IdentifyPage</name>
    <message>
        <source>What was measured of the motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures resistance and dead time at rest, then inductances and flux while it turns; then the motor is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Use in motor file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the measured figures into the description beside the board&apos;s, in Motor and drive; nothing is written to the board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take &amp;back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes them out of it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;lectrical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mecha&amp;nical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Po&amp;wer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures what goes into the motor and what its shaft gives, at the speed that it has.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In both di&amp;rections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mechanics backwards, too, from rest: only that tells friction from a torque that is always there. Not for loads that must not turn backwards, or that turn the motor by themselves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed by a tachometer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For the pole pairs: let the motor run at a constant speed, type what a tachometer reads at its shaft, and press Enter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By a tach&amp;ometer [rpm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures inertia and friction while the motor gets faster and slower; then it is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::Jog</name>
    <message>
        <source>Jog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jogging needs a limit of speed: set one of your own.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::JogBox</name>
    <message>
        <source>hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog backwards while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog forwards while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog speed in rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog [rpm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns the motor while it is held, with the pointer or the Enter key; letting go stops it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor is being jogged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a speed to jog at.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::KeyedPlot</name>
    <message>
        <source>Wheel or + and −: zoom. Drag or arrows: move. F: everything.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::Leaving</name>
    <message>
        <source>Stop motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotorscope has told every motor to stop, but there is no evidence that they did. A motor may still be turning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No port is open that could carry a stop. A motor may still be turning, and nothing tells how fast.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave running?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the motors as they are?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They may go on turning, and nothing will watch them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The experiment leaves something on the board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave it so</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping the motors before the port is closed…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disconnect all the same…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A motor is not idle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without a connection nothing watches it, and this program cannot stop it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop motors, then disconnect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stay connected</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::LimitsDialog</name>
    <message>
        <source>Own limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <comment>no limit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No set-point beyond these is sent, to any motor and any board. Where the board&apos;s own limits are lower, those count. Leave a field empty for no limit of your own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greatest &amp;speed [rpm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greatest &amp;current [A]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A limit is a plain number above 0, or nothing.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::LinkNews</name>
    <message>
        <source>This firmware is not known: registers are shown raw and nothing is written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link lost. %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::LiveGain</name>
    <message>
        <source>Arrow keys or the wheel: 5 % a notch, written at once. Undo takes it back.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::LoopRows</name>
    <message>
        <source>Loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ki</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crossover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::LoopTuning</name>
    <message>
        <source>Kp %1, Ki %2</source>
        <comment>digits</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gains are being read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not conclusive: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the response of the speed first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An experiment is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board holds these gains.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gains of the speed loop, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gains were written from here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The loop keeps what was predicted: Ms %1, at most %2 promised.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Neither proved nor refuted: the loop&apos;s gain does not fall through 1 where it could be measured. &quot;Back to the old gains&quot; brings them back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It swings with its gains. The next response is measured with %1, and the old gains come back afterwards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worse than predicted: Ms %1, at most %2 promised. Nearer gains are proposed from this response; &quot;Back to the old gains&quot; brings those back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slower than predicted: crossover %1 Hz instead of %2 Hz. Nearer gains are proposed from this response; &quot;Back to the old gains&quot; brings those back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is proved: response and steps did not both come to their end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worse than predicted: its steps overshoot by %1 % instead of %2 %. Nearer gains are proposed from this response; &quot;Back to the old gains&quot; brings those back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Neither proved nor refuted: the overshoot of its steps could not be measured. &quot;Back to the old gains&quot; brings them back.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MainWindow</name>
    <message>
        <source>Registers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Connect or disconnect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Refresh the list of ports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Scope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clear what was recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Rotorscope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find a register</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Like the &amp;system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>St&amp;op motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;rm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Acknowledge faults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Go to the set-point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;top the ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 – Rotorscope</source>
        <comment>what is connected</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping the motors before Rotorscope ends…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End Rotorscope all the same…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not live: %1</source>
        <comment>state of the link, e.g. board silent</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Large &amp;numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes samples or a picture to a file (Ctrl+Shift+E)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open a recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;play a recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;oom for samples…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Faults and their causes…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a &amp;workspace…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the wor&amp;kspace…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Arrange for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tuning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trigger&apos;s mode was %1 and is Roll now: the newest samples are followed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open as a re&amp;ference…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recen&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals of t&amp;he file</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MarkerFile</name>
    <message>
        <source>&amp;Save the markers…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the markers into the recording, or into a copy of it (Ctrl+S)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the recording with its markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (*.pcapng)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The markers could not be saved to %1 (%2). What was there is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved with its markers: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no markers; M sets one (Ctrl+S)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All markers are saved as they are (Ctrl+S)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the markers into the recording of the connection (Ctrl+S)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes times and words of the markers to a list, because there is no recording that takes them (Ctrl+S)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording is just being ended. Save the markers again when it has.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The markers are in the recording that runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the markers as a list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The markers are in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is still being recorded, as it seems, and what comes would be lost. Save a copy under another name, or wait until the recording has ended.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MathPanel</name>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Math channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Letters of A to Z, digits and _; other formulas use it by this name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no signal in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name has to be of letters A to Z, digits and _.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name is taken by a signal or a function.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no room for more than %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Valid, unit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Valid, unit not known or a plain number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record it</source>
        <comment>a signal</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ne&amp;w</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read&amp;y formulas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ormula</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where a formula needs a signal of the board that is not on the scope, this puts it there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board has %1: puts it on the scope.</source>
        <comment>a signal</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Change</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MathTable</name>
    <message>
        <source>waits for its signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no value yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tick draws it. It is computed either way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Formula</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last value</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MeasurePanel</name>
    <message>
        <source>Measurements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>between the cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clear statistics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;gainst</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rem&amp;ove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Co&amp;py</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;race</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meas&amp;ure</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MeasureTable</name>
    <message>
        <source>%1 to %2</source>
        <comment>a phase between two traces</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too many samples: zoom in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (samples are missing)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <comment>of a measurement over records</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records</source>
        <comment>number of records counted</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MotionGate</name>
    <message>
        <source>rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known</source>
        <comment>the old value</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 → start, then to %2</source>
        <comment>state now, speed it will go to</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed %1 → %2 in %3 ms</source>
        <comment>old, new, time</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current Iq %1 → %2 in %3 ms</source>
        <comment>old, new, time</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <comment>number, change</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing moves now: press and hold again after you have agreed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position %1 → %2 in %3 ms</source>
        <comment>old, new, time</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The question was withdrawn, and nothing was sent: the board stopped answering for a moment. Press again to be asked again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was sent: the board stopped answering for a moment, and the motor is not as it was asked about. Press again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not ask about steps up to %1 again until disarmed</source>
        <comment>set-point with unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iq %1 → %2, Id %3 → %4, immediately</source>
        <comment>old, new, old, new</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MotionLogModel</name>
    <message>
        <source>%1 (%2)</source>
        <comment>outcome, the board&apos;s word</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Act</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes sent</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MotionLogPanel</name>
    <message>
        <source>Motion log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the motion log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 earlier acts are left out.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MotorConverter</name>
    <message>
        <source>Between two terminals, as a meter shows it: twice the phase.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of one phase of the star, as boards and formulas use it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pole pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half the number of magnets. Forgetting them is the usual mistake: λ is wrong by that factor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Ke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V rms between two terminals at 1000 rpm, as ST gives it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rpm per volt, peak, between two terminals, as model motors are sold.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>λ (f&amp;lux)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>λ = Ke · √2 / √3 / (p · 104.72 rad/s). Peak, of a phase.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kt = 3/2 · p · λ, per peak ampere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A voltmeter between two terminals while the shaft is turned: gives Ke and decides which of two data sheets is right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the shaft while the voltage was measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;R, phase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>terminals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L, phase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <comment>name, unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has to be greater than 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pole pairs are a whole number up to 100.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>λ needs the pole pairs.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MotorFindings</name>
    <message>
        <source>of a phase with its switches, as warm as it is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the bridge loses; a motor file does not hold it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>viscous and dry friction and a fan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>viscous and dry friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model: %1; it leaves %2 % of the torque.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a motor file does not hold it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none seen; at most %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resistance Rs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inductance Ld</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inductance Lq</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flux of the magnets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inertia J</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Viscous friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dry friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>least and greatest value</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With 95 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the motor file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voltage of dead times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 forwards, %2 backwards.</source>
        <comment>inertia</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beside it %1 that is always there; above 0 it hinders forwards</source>
        <comment>torque</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pole pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 by a tachometer</source>
        <comment>pole pairs</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MotorForm</name>
    <message>
        <source>Reading the motor&apos;s values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read a&amp;gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads these values from the board again; they are not polled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lays a motor file beside the board: of Rotorscope, of its simulator, or of ST&apos;s profiler.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends the comparison with the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;ave…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor and drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Converter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the &amp;board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begins again with the board&apos;s values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected: this is what the board said last.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to a board to see what it says of its motor. A file can be looked at without.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board does not describe its motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board is asked…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board&apos;s motor looks plausible.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a motor file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor files (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not opened. %2</source>
        <comment>file, sentence</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a motor from ST&apos;s tools.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a motor file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing differs from the board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) differ from the board.</source>
        <translation>
            <numerusform>%n value differs from the board.</numerusform>
            <numerusform>%n values differ from the board.</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not saved: %2</source>
        <comment>file, reason</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the measured figures out of the description again that came into it last.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes what the board says of its motor to a file, which the simulator takes, too; where measured figures are in use, the description that has them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The description beside the board holds measured figures; Save writes them to a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::MotorModel</name>
    <message>
        <source>not read yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) of an unknown form</source>
        <translation>
            <numerusform>%n byte of an unknown form</numerusform>
            <numerusform>%n bytes of an unknown form</numerusform>
        </translation>
    </message>
    <message>
        <source>can be written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read-only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing of it</source>
        <comment>no flag is set</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flux of the magnets λ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>λ = Ke · √2 / √3 / (p · 104.72 rad/s), p: pole pairs. Peak, linked with a phase.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque constant Kt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kt = 3/2 · p · λ, per peak ampere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voltage constant Ke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ke = λ · p · 104.72 rad/s · √3 / √2: V rms between two terminals at 1000 rpm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed constant KV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>KV = 1 / (√3 · λ · p · 2π / 60): rpm per volt, peak, between two terminals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time constant, q</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>τq = Lq / Rs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time constant, d</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>τd = Ld / Rs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque at motor current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M = Kt · I</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where motor current and nominal bus voltage are used up without flux weakening: (Rs I + ω λ)² + (ω Lq I)² = Vbus² / 3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Derived values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>computed from the motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Board and file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no board to compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n difference(s)</source>
        <translation>
            <numerusform>%n difference</numerusform>
            <numerusform>%n differences</numerusform>
        </translation>
    </message>
    <message>
        <source>The file has another value; in %1: %2</source>
        <comment>unit, number</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built into the firmware: it is changed in the firmware&apos;s project, not over the link.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the file</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::NotesPanel</name>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is tried, and what came of it. Kept with the workspace.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::NumberEdit</name>
    <message>
        <source>From %1 to %2 %3.</source>
        <comment>number number unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It cannot be negative.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The limit is %1 %2.</source>
        <comment>number unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>= %1 %2</source>
        <comment>number unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 becomes %2 %3 (steps of %4)</source>
        <comment>typed number, sent number, unit, step</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::Opening</name>
    <message numerus="yes">
        <source>%n signal(s) of it are not shown: see Scope, Signals of the file.</source>
        <translation>
            <numerusform>%n signal of it is not shown: see Scope, Signals of the file.</numerusform>
            <numerusform>%n signals of it are not shown: see Scope, Signals of the file.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopping the motors before something else is opened…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open it all the same…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (*.pcapng)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV files (*.csv *.txt)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no recording of Rotorscope.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Imported %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) have the time of the row before and were left out.</source>
        <translation>
            <numerusform>%n row has the time of the row before and was left out.</numerusform>
            <numerusform>%n rows have the time of the row before and were left out.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Disconnect and go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recording takes the place of what the scope shows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A replay takes the place of a board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is imported takes the place of what the scope shows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open as a &amp;reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a recording as a reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is being read. Until then its outline is shown: the extremes of its fast signals.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::OwnLimits</name>
    <message>
        <source>The file with your own limits, %1, cannot be read (%2). Those of the last time that Rotorscope ended are in force: look at them in the control panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file with your own limits, %1, cannot be read (%2). NO limit of your own is in force: set them again in the control panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your own limits hold now, but could not be stored in %1 (%2).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::PlanPicture</name>
    <message>
        <source>Picture of the plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time without the start [s]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed [rpm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cap %1 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current at rest [A]</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RampForm</name>
    <message>
        <source>Name of a ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choosing one fills the fields; it sends nothing. To keep the ramp that you look at, type a name and save.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <comment>a ramp under a name</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <comment>a named ramp</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Named</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No ramp was sent yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To %1: taken over; it goes when the motor runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To %1: %2 % of the time, %3 s left; measured %4.</source>
        <comment>target, number, number</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The set-point is at %1; measured %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrived at %1 after %2 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ramp to %1 was ended on its way; measured %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor runs no more; the ramp to %1 has ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link was lost on the way to %1; what became of it is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends a ramp where it is; the motor goes on turning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps this under the name: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a name first, and values that can be sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forgets the ramp of this name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RampLine</name>
    <message>
        <source>rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1/s</source>
        <comment>unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send</source>
        <comment>a ramp to the board</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Iq (torque)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed to go to, in rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque current Iq to go to, in A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current reference Iq, in A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current reference Id, in A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration of the ramp in ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send: %1</source>
        <comment>kind of ramp</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in</source>
        <comment>a time</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Together %1 A: the limit is %2 A.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sends it (Enter in a field does the same).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft (&amp;x)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of the shaft to go to, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>immediately</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I&amp;q immediately</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) of %1 rpm</source>
        <translation>
            <numerusform>%n step of %1 rpm</numerusform>
            <numerusform>%n steps of %1 rpm</numerusform>
        </translation>
    </message>
    <message>
        <source>Iq = %1 A, Id = %2 A, together %3 A, immediately</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RampPreview</name>
    <message>
        <source>Preview of the ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed [rpm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft [°]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iq [A]</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ReadoutBox</name>
    <message>
        <source>Measured speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current Iq</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bus voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board does not tell it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ReadyFormulas</name>
    <message>
        <source>needs I_A and I_B in the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needs two phase currents and an electrical angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needs a signal in the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clarke: current α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clarke: current β</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Park: current d</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Park: current q</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Electrical power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needs the voltages and currents of d and q</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Derivative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Integral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low-pass, 100 Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High-pass, 10 Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median of 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle without jumps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needs an angle in the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No formula yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The formula is too long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many parentheses inside one another, or too many functions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This sign is not known here: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is no number: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something is missing at the end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The formula cannot be read from here on: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number of arguments is wrong: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This has to be a number, not a signal: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This number is outside what makes sense: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This has to be an angle, in degrees or rad: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At character %1: %2</source>
        <comment>a place in the formula, and what is wrong there</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What opens here is not closed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No signal on the scope and no function is called %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RecordPanel</name>
    <message>
        <source>Records of the trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter shows a record, the tick keeps it, F2 gives it a label. Page up and page down go through the records.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Persistence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the traces of the picture dashed and paler behind those that come (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep as &amp;reference A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep as reference &amp;B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dr&amp;op B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So many earlier records stay paler behind the newest one, while the trigger is the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the persistence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the earlier records out of the picture; those to come stay again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop &amp;A</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RecordTable</name>
    <message>
        <source>samples are gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>forced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Age</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pinned, trigger time</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RecordingControl</name>
    <message>
        <source>With the bytes of the &amp;line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Twice the size; keeps what was on the line byte for byte</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;nd the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Record to disk…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends the file on the disk (Ctrl+R)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes all samples, values and events to a file while they come (Ctrl+R)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect first: a recording is of a connection (Ctrl+R)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record to disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (*.pcapng)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 MB</source>
        <comment>duration, size</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, disk full in %1</source>
        <comment>duration</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 GB free</source>
        <comment>on the disk</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be recorded (%2). Choose a name that is not there yet, in a folder that takes files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording ended: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded to %1: %2 MB.</source>
        <comment>path, size</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ended, disk full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording ended: disk full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The disk is full: the recording %1 ends here, with %2 MB. What was recorded is in it, and the connection goes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ended, disk failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording ended: disk failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The disk failed (%3): the recording %1 ends here, with %2 MB. What was recorded is in it, and the connection goes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>REC</source>
        <comment>a recording can begin</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End</source>
        <comment>the recording</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded to %1: %2 MB, without %3, because the disk was too slow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 lost</source>
        <comment>samples and more</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RegisterEdits</name>
    <message>
        <source>No board is answering.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm first: nothing is written to a board that is not armed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last write is still under way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A question is open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was edited.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n register(s)</source>
        <comment>how many were written</comment>
        <translation>
            <numerusform>%n register</numerusform>
            <numerusform>%n registers</numerusform>
        </translation>
    </message>
    <message>
        <source>Undo is not available after a reconnect.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to undo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to redo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was written: the board was disarmed meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RegisterModel</name>
    <message>
        <source>Pinned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other registers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scope only</source>
        <comment>a register that cannot be read, only recorded</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not supported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused</source>
        <comment>the board refused to read a register</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This value is old: it is not being read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board does not have it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag it to the scope or press Enter: it is drawn at the rate at which it can be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag it to the scope or press Enter: it is recorded at the full control rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Register</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw</source>
        <comment>the number as it is on the wire</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write only</source>
        <comment>a register that cannot be read, only written</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sent: %1</source>
        <comment>the reason</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written, but the board holds %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <comment>the board&apos;s reason</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click its value or press F2 to edit it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board holds %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not written yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On its way to the board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written and read back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RW</source>
        <comment>access: read and write</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R</source>
        <comment>access: read</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W</source>
        <comment>access: write</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scope</source>
        <comment>access: recorded only</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>least and greatest value</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hex</source>
        <comment>the number as it is on the wire, in hexadecimal digits</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Access</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <comment>what a register is</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sent, outcome unknown: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last value</source>
        <comment>heading of values that are not read any more</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written, not verified.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written, not verified: %1</source>
        <comment>the reason</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RegisterPanel</name>
    <message>
        <source>Search registers (Ctrl+K)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search registers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Registers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add to scope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pinned</source>
        <comment>menu entry of a register</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not taken over: %1</source>
        <comment>what is wrong with a typed value</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo the last write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo the write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Apply edits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;vert edits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit the register&apos;s value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy registers as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes what was edited and reads it back (Ctrl+Shift+A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the old value of: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes again: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was edited.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forgets the edits that were not written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Register &amp;columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pin the register or let it go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the selected register is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No register has &quot;%1&quot; in its name or its help.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::Replacing</name>
    <message>
        <source>Replace what was recorded?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was recorded to a disk stays there. The scope&apos;s own samples cannot be brought back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export first…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Markers that are not saved are lost, too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the &amp;markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the markers unsaved?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Leave unsaved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save first…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Markers of this recording were changed and are not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording %1 does not hold all markers as they are now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording that runs does not hold all markers: some were set before it began.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear what was recorded?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scope holds samples that were not exported. They cannot be brought back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was recorded to a disk stays there, and markers stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The markers are not saved. They can be saved as a list of times and words (CSV).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scope holds samples that were not exported. A file that is opened takes their place.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ReplayBar</name>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds the replay; nothing is left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pace of the replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1×, as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as fast as possible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2, %3 %</source>
        <comment>file name, duration, part of the file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>, %n damaged place(s)</source>
        <translation>
            <numerusform>, one damaged place</numerusform>
            <numerusform>, %n damaged places</numerusform>
        </translation>
    </message>
    <message>
        <source> – its end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place in the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes to another place in the recording. Going back restarts it, after what the scope already has.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ResponsePage</name>
    <message>
        <source>stiff</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>medium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The longer, the narrower the error bars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed loop, open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current loop, open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current loop, closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What if &amp;Kp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the predicted loop; nothing is written until Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three candidates from the measured motor: stiff, medium, quick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Back to the old gains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures how motor and speed loop follow each frequency; then the motor is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures how the current follows its reference; then the motor is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;rove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures the response and steps of 200 rpm with the gains that were applied, and compares.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply gains first: they are what is proved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not conclusive: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the gains that the board held then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what if</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the gains in the fields, by the measured motor; its step is that of a fitted one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ms at most %1, phase margin at least %2°, at the worst end of each error bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>proved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As measured, at the current that flowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the response of the speed first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the gains in the fields as one step, which can be undone, and reads them back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the gains from before the first Apply, as one step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pr&amp;opose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;icture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ki</source>
        <comment>a gain</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what if: unstable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With these gains the loop would be unstable: its speed would swing ever more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loops: measured, what if, proposed, proved</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RevUpChart</name>
    <message>
        <source>Picture of the rev-up: speed and current over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed, rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a point, or select one with Page Up and Page Down and move it with the arrow keys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage %1: %2&#x202f;rpm at %3&#x202f;s (lasts %4&#x202f;ms)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage %1: %2 %3 digits at %4&#x202f;s (lasts %5&#x202f;ms)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage %1: Iq %2 (%3 digits) at %4&#x202f;s (lasts %5&#x202f;ms)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>observer sees from %1&#x202f;rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RevUpForm</name>
    <message>
        <source>Stages of the rev-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not taken over: %1</source>
        <comment>what is wrong with a typed value</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a stage after the selected one (Insert)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes the selected stage (Delete)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <comment>move a stage</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the selected stage up (Alt+Up)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dow&amp;n</source>
        <comment>move a stage</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the selected stage down (Alt+Down)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start va&amp;lues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ST&apos;s start values: 2 s of half the nominal current, then 3 s to 30 % of the highest speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads the stages from a file, as rotorscope-cli revup writes them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the stages to a file that rotorscope-cli revup reads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of rotor and load together. Only for the judgement here; it is not sent anywhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque that holds the motor back. Only for the judgement here; it is not sent anywhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is wrong with the rev-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inertia, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Friction, mN·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes %1&#x202f;s in all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest speed %1&#x202f;rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal current %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kt %1 per A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque is not judged: the board does not say its magnets&apos; flux (MOTOR_CONFIG).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque is not judged: type the inertia.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scale of the current is not known: digits only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next start is drawn over the plan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start under way…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last start: the drive took over after %1&#x202f;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last start: failed after %1&#x202f;s (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last start: stopped after %1&#x202f;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No speed was recorded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No Iq was recorded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured: thin lines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a rev-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rev-ups (*.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not taken: its stage %2 is beyond this board&apos;s limits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stages of %1. Apply writes them to the board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the rev-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured: thin lines, mirrored, for it turned backwards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ No problems found.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RevUpModel</name>
    <message>
        <source>No board is connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This firmware has no rev-up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board starts without a rev-up: it has a sensor of the rotor&apos;s angle, or its firmware is a reduced one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This drive starts by its sensor (%1) and runs no rev-up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stages have not been read yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pulse</source>
        <comment>of a six-step drive: the duty that its timer holds</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iq</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not used</source>
        <comment>a stage of a rev-up</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque that the stage needs, and that its current gives.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not used: it takes no time. Give it a duration to use it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board holds %1&#x202f;ms, %2&#x202f;rpm, %3 digits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage %1, %2: %3</source>
        <comment>a cell of the rev-up table, for a screen reader</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time
ms</source>
        <comment>duration of a stage</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration of the stage, ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed
rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed at the end of the stage, rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iq
A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iq at the end of the stage, A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulse
digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulse at the end of the stage, digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iq
digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iq at the end of the stage, digits of the register</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque
mN·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque needed / given, mN·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1&#x202f;rpm became %2&#x202f;rpm: drives count speeds in steps of %3&#x202f;rpm.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RunBookModel</name>
    <message>
        <source>Its registers were not read to the end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, with a star</source>
        <comment>number</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digits of the proportional and the integral gain of the speed loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kp / Ki</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RunBookPanel</name>
    <message numerus="yes">
        <source>%n file(s) make no sense: </source>
        <translation>
            <numerusform>%n file makes no sense: </numerusform>
            <numerusform>%n files make no sense: </numerusform>
        </translation>
    </message>
    <message>
        <source>Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tick gives a run its star, F2 its note.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps each experiment of a recording, and each stretch between two changes of its gains, as a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run %1 is kept.</source>
        <comment>number</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep experiments in a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a recording to the run book</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (*.pcapng)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adding %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not added: %2.</source>
        <comment>file, reason</comment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n run(s) are added.</source>
        <translation>
            <numerusform>%n run is added.</numerusform>
            <numerusform>%n runs are added.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es) are left out, because they are short.</source>
        <translation>
            <numerusform>%n stretch is left out, because it is short.</numerusform>
            <numerusform>%n stretches are left out, because they are short.</numerusform>
        </translation>
    </message>
    <message>
        <source>Experiments are not kept: choose a folder for them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every experiment is kept in %1</source>
        <comment>folder</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the run book</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <comment>folder, reason</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The note of run %1 is not kept: %2.</source>
        <comment>number, reason</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare registers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to this run…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows which registers differ between both runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what the board holds otherwise than behind this run; Restore writes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lays one or two runs behind what the scope shows, as references</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens the recording of the run, in place of what is shown</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::RunKeeper</name>
    <message>
        <source>Keeping a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run was not kept in %1: %2.</source>
        <comment>folder, reason</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::SampleRoom</name>
    <message>
        <source>Samples: %1 GB in memory, %2 GB on disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 hours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at the present %1 kB/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of five signals at 16 kHz (%1 kB/s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory only, %1 GB: about %2 %3.</source>
        <comment>size, time, at a rate</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 GB on disk: about %2 %3.</source>
        <comment>size, time, at a rate</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The oldest %1 GB of samples are let go as soon as new ones come.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The samples fill their memory (%1 GB): from now on the oldest ones are let go. Record to disk (Ctrl+R) to keep what comes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The samples fill their room (%1 GB of memory, %2 GB on disk): from now on the oldest ones are let go. Record to disk (Ctrl+R) to keep what comes, or give them more room (Scope, Room for samples).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder for samples, %1, cannot be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less than 1 GB is free on the disk of %1, so no more samples go there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The disk of %1 takes no more samples (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connection and the scope go on; when the room that is left is full, the oldest samples are let go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The disk of %1 cannot be read any more: the samples on it are let go.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::SampleRoomDialog</name>
    <message>
        <source>Room for samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 GB are free on the disk of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Room on disk [GB]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The room is a plain number of 0 or more, or nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That is more than is free: the last 1 GB is left free.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When the memory for samples is full, the oldest ones are moved to the disk and stay on the scope. When the room there is used up too, the oldest are let go. They are gone when Rotorscope ends: what is to be kept has to be recorded (Ctrl+R) or exported. 0 keeps samples in memory only; an empty field lets Rotorscope choose.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ScopeOverview</name>
    <message>
        <source>Whole recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole recording; the box is what the plots show. Drag it or its edges.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ScopePage</name>
    <message>
        <source>Run</source>
        <comment>the scope&apos;s picture moves</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lets the picture run or holds it; recording goes on (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the newest samples in view (End)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <comment>show all samples</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows everything (F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fits the value axes only (Shift+F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows half the time (+)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows twice the time (−)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay</source>
        <comment>the scope shows it</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <comment>the scope shows it</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record to disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold</source>
        <comment>the scope&apos;s picture stands still</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws each set-point from the instant at which its bytes left. How soon the board had it stands with the command among the events.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set-po&amp;ints as sent</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ScopeTools</name>
    <message>
        <source>Cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two times, their distance and the values there (C). 1 and 2 give a cursor to the mouse, arrows move it by a sample.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take cursor &amp;A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set a &amp;marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the mouse, else at the active cursor, else at the newest sample (M)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Single record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force a &amp;trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Previous record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Whole recording below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A strip with everything recorded, and a box around what the plots show (O)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Drop reference A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep as reference &amp;B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next e&amp;vent of reference B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lays another moment of its file at the trigger, or at the left edge of a picture that rolls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take c&amp;ursor B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep as reference A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D&amp;rop reference B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next event o&amp;f reference A</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ScopeView</name>
    <message>
        <source>Scope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a signal here, or select one in the tree and press Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run	Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the newest sample	End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid	G</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit everything	F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit values	Shift+F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cursors	C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole recording below	O</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zeros of the axes at one height</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::Searching</name>
    <message>
        <source>Ne&amp;xt where the trigger is met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes on to the next place in what was recorded where the trigger&apos;s condition is met (N)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This trigger waits for an event: the list of events has them all (Ctrl+7).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Searching %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trigger&apos;s condition is not met in what follows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trigger&apos;s condition is met at %1.</source>
        <comment>a time</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::SetpointBox</name>
    <message>
        <source>Speed set-point in rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque set-point in ampere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference of the current Iq in ampere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference of the current Id in ampere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go</source>
        <comment>send the set-point</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind of set-point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <comment>kind of set-point</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque (Iq)</source>
        <comment>kind of set-point</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Currents (Iq, Id)</source>
        <comment>kind of set-point</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ramp time in milliseconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Id [A]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed [rpm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iq [A]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends a ramp where it is; the motor goes on turning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets both currents at once (Enter in a field does the same).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sends the set-point as a ramp (Enter in the field does the same).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ramp time [ms]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send with every exchange</source>
        <comment>set-points</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor has to be idle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speeds and currents travel in every frame that is exchanged with the drive, instead of as a write of their own. Stop and a fault set them to zero; a reset or a lost link ends it. Positions are always written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set-points with every exchange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>name of a field, what is wrong with its text</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drive mode: speed</source>
        <comment>the board does now</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drive mode: torque</source>
        <comment>the board does now</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of the shaft to go to, in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <comment>kind of set-point</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft is at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position [°]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drive mode: position</source>
        <comment>the board does now</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A move to an angle has no end on its way: Stop ends it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns the shaft to that angle (Enter in the field does the same).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move to an angle</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::SignalPlan</name>
    <message>
        <source>Recording signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These signals would need %1 kB/s, the link carries %2 kB/s: they are recorded at %3 Hz.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s) do not fit into the recording and are polled.</source>
        <translation>
            <numerusform>%n signal does not fit into the recording and is polled.</numerusform>
            <numerusform>%n signals do not fit into the recording and are polled.</numerusform>
        </translation>
    </message>
    <message>
        <source>This board does not have %1.</source>
        <comment>names of signals</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::SignalSelection</name>
    <message>
        <source>The scope shows up to %1 signals of a file: take one off to see another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, polled</source>
        <comment>a signal</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::SnapshotActions</name>
    <message>
        <source>&amp;Save a snapshot…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export C header…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No board is answering.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves every register that can be read, with the names of board and firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves gains and start-up of the motor in the names of the SDK&apos;s drive_parameters.h</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) saved to %1.</source>
        <translation>
            <numerusform>%n register saved to %1.</numerusform>
            <numerusform>%n registers saved to %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::SnapshotDialog</name>
    <message>
        <source>Save a snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export C header of motor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading what the board holds…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board could not be read to the end; nothing was saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) were read. The board never answered for: %1.</source>
        <translation>
            <numerusform>%n register was read. The board never answered for: %1.</numerusform>
            <numerusform>%n registers were read. The board never answered for: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) were read.</source>
        <translation>
            <numerusform>%n register was read.</numerusform>
            <numerusform>%n registers were read.</numerusform>
        </translation>
    </message>
    <message>
        <source>Snapshots (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C headers (*.h)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not written: %2. Choose another place.</source>
        <comment>file, the system&apos;s words</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::SnapshotModel</name>
    <message>
        <source>Only B has it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only A has it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not restored: %1</source>
        <comment>the reason</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Register</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A</source>
        <comment>the first of two snapshots</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B</source>
        <comment>the second of two snapshots</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A raw</source>
        <comment>digits of the first of two snapshots</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B raw</source>
        <comment>digits of the second of two snapshots</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::SnapshotPanel</name>
    <message>
        <source>Before a write, %1</source>
        <comment>date and time</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board, as it is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshots (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <comment>file, the system&apos;s words</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No board is answering.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board never answered for: %1.</source>
        <comment>list of registers</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board could not be read to the end; the table shows what it held before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A was taken of other hardware; restore it all the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a snapshot as A.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the board as B.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board is being read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board holds these values already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing that can be written is chosen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A was taken of other hardware.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore %1</source>
        <comment>a snapshot</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written and read back:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board made another value of:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not written:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was restored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshot %1</source>
        <comment>A or B</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a snapshot…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a file as snapshot %1</source>
        <comment>A or B</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A</source>
        <comment>the first of two snapshots</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B</source>
        <comment>the second of two snapshots</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads every register of the board again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter by name or group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter the differences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Differences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>&amp;Restore %n register(s) of A</source>
        <translation>
            <numerusform>&amp;Restore %n register of A</numerusform>
            <numerusform>&amp;Restore %n registers of A</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes what is checked and shown to the board and reads it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the board…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No differences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) differ</source>
        <translation>
            <numerusform>%n register differs</numerusform>
            <numerusform>%n registers differ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them shown</source>
        <translation>
            <numerusform>, %n of them shown</numerusform>
            <numerusform>, %n of them shown</numerusform>
        </translation>
    </message>
    <message>
        <source>Check the selected rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncheck the selected rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2 s</source>
        <comment>recording, seconds</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is not known whether these were written:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the b&amp;oard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;ave…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meas&amp;ured values, too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written, not verified:</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::SpectrumPanel</name>
    <message>
        <source>Peaks of the spectrum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>between the cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hann</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To look around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To read amplitudes: true to 0.1 % everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blackman-Harris</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To see small lines beside large ones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectangular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For whole periods only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n sample</numerusform>
            <numerusform>%n samples</numerusform>
        </translation>
    </message>
    <message>
        <source>Samples of a transform. With fewer than there are, the transforms overlap by half and are averaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>decibels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forgets what was averaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;opy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The table of peaks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frequency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No trace is shown on the scope.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The samples of this trace are not at equal distances, so it has no spectrum.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fewer than 16 samples in one piece: no spectrum.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No orders: the speed or the motor&apos;s pole pairs are not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples a transform, a line every %2</source>
        <comment>a number of samples; a distance of frequencies</comment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>mean of %n transforms</source>
        <translation>
            <numerusform>mean of %n transform</numerusform>
            <numerusform>mean of %n transforms</numerusform>
        </translation>
    </message>
    <message>
        <source>only the newest samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean of so many spectra, one after the other, of samples that do not overlap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a trace.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orders: largest peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orders: %1</source>
        <comment>name of a speed</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;race</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Avera&amp;ge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;cale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rest&amp;art</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::SpectrumPeaks</name>
    <message>
        <source>Frequency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order</source>
        <comment>a multiple of the electrical frequency</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative</source>
        <comment>a peak compared with the largest one, in decibels</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::SpectrumPlot</name>
    <message>
        <source>Spectrum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order</source>
        <comment>a multiple of the electrical frequency</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dB re 1 %1</source>
        <comment>level above one of the unit</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::SpeedGains</name>
    <message>
        <source>&amp;Kp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>K&amp;i</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the speed loop</source>
        <comment>Kp or Ki</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 digits</source>
        <comment>a gain whose unit is not known</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the torque loop</source>
        <comment>Kp or Ki</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the flux loop</source>
        <comment>Kp or Ki</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the position loop</source>
        <comment>Kp or Ki</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::StateBox</name>
    <message>
        <source>Causes…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What these faults mean and what to try</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <comment>number, state</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faults are not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No fault present</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Present: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To acknowledge: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded: %1</source>
        <comment>state</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::StateStrip</name>
    <message>
        <source>State of the motor: not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the motor: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::StatusStrip</name>
    <message>
        <source>Link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Negotiated packet sizes: request / answer / stream</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes received a second, and their share of what the link can carry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulated board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 / %2 / %3 B</source>
        <comment>sizes in bytes: request, answer, stream</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <comment>number, state</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faults: %1</source>
        <comment>how many</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lost: %1</source>
        <comment>control periods without samples</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control periods that no packet holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples were recorded by the board but came too fast to be shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bad packets: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kB/s (%2 %)</source>
        <comment>received, percent of the link</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This drive has no communication time-out: when the link is gone, the motor goes on turning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive watchdog: %1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive watchdog: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replay of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This drive stops its motor by itself when it has not been fed for that time. It needs a sign of life from a window that responds and is armed: disarming stops what turns. It is not a safety function.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>baud</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::StepFields</name>
    <message>
        <source>How long each speed is held: longer than the loop takes to settle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the ramp to the first speed, and of the way back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So many steps up, and as many down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, rpm</source>
        <comment>a field</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fr&amp;om</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <comment>a speed</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at</source>
        <comment>a speed</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast the motor turns meanwhile, negative for torques that push it backwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is stepped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long each current is held: nothing holds the speed meanwhile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long each position is held: longer than the loop takes to settle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in</source>
        <comment>a time</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time of each move, there and back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B&amp;y</source>
        <comment>an angle</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the shaft is moved from where it rests, and back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a field, its unit</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::StepOverlay</name>
    <message>
        <source>No step yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps over one another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time since the step [ms]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed [rpm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not drawn: samples are missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iq [A]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Id [A]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position [°]</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::StepPage</name>
    <message>
        <source>Steps in the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steps up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steps down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Series of steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The others show their difference to the chosen series (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the chosen series out of the table and the picture (Delete)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gains are being read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the way to the first speed…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <comment>numbers</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gains were changed meanwhile: the row has the first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps up and down; then the motor is as it was (Ctrl+Shift+T).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The speed is held: put the load on, and take it off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds the speed that the motor has for 10 s, in which you put a load on it and take it off: says how far the speed gives way, and when it is back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board does not control the position of its shaft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing holds your own limit of the speed in position control: take it away first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::StepRuns</name>
    <message>
        <source>rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1× up, %2× down</source>
        <comment>numbers of steps</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ki</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak Iq</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>least and greatest voltage</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1, up: %2</source>
        <comment>number, what was measured</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1, down: %2</source>
        <comment>number, what was measured</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, ref.</source>
        <comment>number of the run that others are compared with</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flux</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::StopAlarm</name>
    <message>
        <source>Stop motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no connection that could carry the stop, and the motor was not at rest when it was last heard. Closing this message starts nothing again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the Stop &amp;back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The port is open again, and the stop goes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: meanwhile standstill was measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: meanwhile its drive is idle. Its speed is not measurable: the rotor may coast.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: meanwhile its drive is idle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1 was told to stop, but neither its state nor its speed shows that it did.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotorscope goes on trying. Closing this message starts nothing again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not open any more, and no evidence of the stop had come. The motor may still be turning. As soon as a port is open again, what is found there is stopped before anything else. Closing this message starts nothing again and takes nothing back.</source>
        <comment>one or more ports</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At first nothing confirmed the stop. Closing this message starts nothing again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confirmed late: standstill was measured.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::StopButton</name>
    <message>
        <source>Stop motors (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops every motor at once, from anywhere: press it or the Esc key.
A program on a PC is no replacement for a switch that removes the power.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::StopWords</name>
    <message>
        <source>%1 s ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <comment>number, word of a stop</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ToolDocks</name>
    <message>
        <source>&amp;Close all tools</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::Tools</name>
    <message>
        <source>Events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Math</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>XY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rev-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ramps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor and drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Step response</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Trigger on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Spectrum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;XY, upward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Identify</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Response</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run book</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::TourPage</name>
    <message>
        <source>Stations of the tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How near to instability the proposed gains go: Ms at most 1.4, 1.7, 2.0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stiff</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>medium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of each response; the longer, the narrower its error bars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Goal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures windings, mechanics and the response of the speed, one after the other, and proposes gains; nothing is written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Apply and prove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the proposed gains as one step, which can be undone, reads them back, and measures the response and steps with them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Back to the old gains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board sees its rotor and is armed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board observes its rotor without a sensor, and is armed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crossover %1 Hz, Ms %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the gains from before the first Apply, as one step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gains keep the distance of this goal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kp %1, Ki %2: crossover %3 Hz, phase margin %4°, Ms %5 predicted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; the board holds them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; not written yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sta&amp;rt the tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the tour first: it proposes the gains.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The response was not conclusive: no gains follow from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no gains to prove.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with the tou&amp;r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with the tour: it begins there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures the response, and proposes gains from it. Instead of the gains with which the speed swung it takes gentler ones meanwhile, and asks about them; others are taken as they are.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::TourSteps</name>
    <message>
        <source>1. Check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2. Rs, L, flux</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3. Inertia, friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4. Response</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>5. Gains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>6. Proof</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▶ runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>? not conclusive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>– not possible here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>– passed over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✖ ended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::TriggerBar</name>
    <message>
        <source>Roll: the newest samples. Auto: records, also without a trigger. Normal: keeps the last record. Single: one record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the trigger waits for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trace that is watched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode of the trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Single</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes one record, then stops (S)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A trigger now (T)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All settings of the trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Upper level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hysteresis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>between these times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all but between them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At &amp;least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At &amp;most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold-&amp;off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which way: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; also the arrow at the right edge of the plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the trigger, and how old the shown record is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File: replay it to trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trigger waits for samples, and a file has none to come. A replay of it (Ctrl+Shift+R) has.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre-trig&amp;ger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Record length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set level to &amp;50 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The register whose write is waited for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any register</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::ValueEdit</name>
    <message>
        <source>Not understood: a number from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::WholeSpin</name>
    <message>
        <source>A whole number from %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::Workspaces</name>
    <message>
        <source>Workspaces (*.workspace)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a workspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the workspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not opened: %2</source>
        <comment>a file, the reason</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not written: %2</source>
        <comment>a file, the reason</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The workspace is in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference %1 is not in it: there is room for %2 samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace the notes?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The notes that are shown are in no workspace file. Those of %1 take their place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They cannot be brought back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Replace the notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep these notes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::XyPanel</name>
    <message>
        <source>E&amp;qual scales</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Currents α β</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Currents d q</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voltages α β</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voltages d q</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two traces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its newest 100 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>between the cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the older the paler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all alike</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the newest only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record I_A and I_B, or the currents α and β, to see this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record the measured currents d and q to see this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record V_ALPHA and V_BETA to see this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record V_D and V_Q to see this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No trace is shown on the scope.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <comment>a signal and its unit</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is recorded of both at the same time in this stretch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newest: %1 at %2°</source>
        <comment>the length and the angle of a vector</comment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message>
        <source>, each of %1 instants</source>
        <comment>a number, such as 4</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computed from I_A and I_B, β as the board counts it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only the newest samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dashed: what the bus allows; dotted: without distortion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bus voltage is not known, so its limits are not drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a trace for X and for Y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dra&amp;w</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;rail</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>widgets::XyPlot</name>
    <message>
        <source>XY picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bus %1 V</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
