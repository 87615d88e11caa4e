<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_US">
<context>
    <name>About</name>
    <message>
        <source>A program on a PC over a serial line is no replacement for a switch that removes the power: have one at hand. &quot;Stop motors&quot; takes the motor out of control; it may coast for a long time. If Rotorscope crashes, freezes or is killed, a guardian process tells the motors to stop (not on Windows). If the link is lost or the computer fails, nothing is sent and the motor goes on turning.</source>
        <translation>Ein Programm auf einem PC an einer seriellen Leitung ersetzt keinen Schalter, der die Spannung wegnimmt: Halten Sie einen griffbereit. „Motoren stoppen“ schaltet die Regelung ab; der Motor kann noch lange auslaufen. Wenn Rotorscope abstürzt, einfriert oder beendet wird, befiehlt ein Wächterprozess den Motoren anzuhalten (nicht unter Windows). Geht die Verbindung verloren oder fällt der Rechner aus, wird nichts gesendet, und der Motor dreht weiter.</translation>
    </message>
    <message>
        <source>About Rotorscope</source>
        <translation>Über Rotorscope</translation>
    </message>
    <message>
        <source>A workbench for engineers who tune electric motors.</source>
        <translation>Eine Werkbank für alle, die Elektromotoren abstimmen.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later, without any warranty. Built with Qt %1 and QCustomPlot.</source>
        <translation>Freie Software unter der GNU General Public License, Version 3 oder neuer, ohne jede Gewährleistung. Erstellt mit Qt %1 und QCustomPlot.</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>In the list: add to the scope. In a set-point: send it</source>
        <translation>In der Liste: zum Oszilloskop hinzufügen. Im Sollwert: senden</translation>
    </message>
    <message>
        <source>Hold the picture, let it run (never starts a motor)</source>
        <translation>Das Bild anhalten oder laufen lassen (startet nie einen Motor)</translation>
    </message>
    <message>
        <source>Move the cursor by a sample, else the picture</source>
        <translation>Den Cursor um einen Messwert bewegen, sonst das Bild</translation>
    </message>
    <message>
        <source>Beside the menus</source>
        <translation>Neben den Menüs</translation>
    </message>
    <message>
        <source>Wheel</source>
        <comment>of the mouse</comment>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>Zoom in, out</source>
        <translation>Vergrößern, verkleinern</translation>
    </message>
</context>
<context>
    <name>Channels</name>
    <message>
        <source>HF</source>
        <comment>high frequency: recorded at the control rate</comment>
        <translation>HF</translation>
    </message>
    <message>
        <source>MF</source>
        <comment>medium frequency: 1 of 16 samples</comment>
        <translation>MF</translation>
    </message>
    <message>
        <source>polled</source>
        <comment>asked for again and again</comment>
        <translation>abgefragt</translation>
    </message>
    <message>
        <source>The board cannot record this register: it is polled and drawn at that rate.</source>
        <translation>Das Board kann dieses Register nicht aufzeichnen: Es wird abgefragt und in diesem Takt gezeichnet.</translation>
    </message>
    <message>
        <source>The board records no more signals at once: this one is polled.</source>
        <translation>Mehr Signale zeichnet das Board nicht gleichzeitig auf: Dieses wird abgefragt.</translation>
    </message>
    <message>
        <source>The link is too slow to record it: it is polled.</source>
        <translation>Die Verbindung ist zu langsam, um es aufzuzeichnen: Es wird abgefragt.</translation>
    </message>
</context>
<context>
    <name>Colors</name>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>Zinnober</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Purple</source>
        <translation>Purpur</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>Himmelblau</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tinte</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <comment>a colour is chosen</comment>
        <translation>&amp;Automatisch</translation>
    </message>
</context>
<context>
    <name>Confirmation</name>
    <message>
        <source>Type &quot;%1&quot; to continue:</source>
        <comment>a word</comment>
        <translation>Zum Fortfahren „%1“ eingeben:</translation>
    </message>
</context>
<context>
    <name>Entry</name>
    <message>
        <source>none</source>
        <comment>no flag is set</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>The unit here is %1.</source>
        <translation>Die Einheit ist hier %1.</translation>
    </message>
    <message>
        <source>none</source>
        <comment>no unit</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>Not less than %1.</source>
        <translation>Nicht kleiner als %1.</translation>
    </message>
    <message>
        <source>Too large a number.</source>
        <translation>Die Zahl ist zu groß.</translation>
    </message>
    <message>
        <source>From %1 to %2.</source>
        <comment>the range of a value</comment>
        <translation>Von %1 bis %2.</translation>
    </message>
    <message>
        <source>It has no such value.</source>
        <translation>Diesen Wert hat es nicht.</translation>
    </message>
    <message>
        <source>Write pairs of hexadecimal digits, one pair for each byte.</source>
        <translation>Schreiben Sie Paare hexadezimaler Ziffern, eines für jedes Byte.</translation>
    </message>
    <message>
        <source>It cannot be edited here.</source>
        <translation>Es kann hier nicht bearbeitet werden.</translation>
    </message>
</context>
<context>
    <name>ExportFormat</name>
    <message>
        <source>Picture of the scope, PNG</source>
        <translation>Bild des Oszilloskops, PNG</translation>
    </message>
    <message>
        <source>Picture of the plots, SVG</source>
        <translation>Bild der Diagramme, SVG</translation>
    </message>
    <message>
        <source>Picture of the plots, PDF</source>
        <translation>Bild der Diagramme, PDF</translation>
    </message>
    <message>
        <source>CSV, decimal point and commas</source>
        <translation>CSV, Dezimalpunkt und Kommas</translation>
    </message>
    <message>
        <source>CSV, decimal comma and semicolons</source>
        <translation>CSV, Dezimalkomma und Semikolons</translation>
    </message>
    <message>
        <source>MATLAB file</source>
        <translation>MATLAB-Datei</translation>
    </message>
    <message>
        <source>NumPy array</source>
        <translation>NumPy-Feld</translation>
    </message>
    <message>
        <source>WAV, the fast signals as sound</source>
        <translation>WAV, die schnellen Signale als Ton</translation>
    </message>
</context>
<context>
    <name>Exports</name>
    <message>
        <source>The export was cancelled. Written before: %1.</source>
        <comment>files</comment>
        <translation>Der Export wurde abgebrochen. Vorher geschrieben: %1.</translation>
    </message>
    <message>
        <source>Written before: %1.</source>
        <comment>files</comment>
        <translation>Vorher geschrieben: %1.</translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>The motor did not come up to a speed at which it can be seen without a sensor.</source>
        <translation>Der Motor kam nicht auf eine Drehzahl, bei der man ihn ohne Sensor erkennt.</translation>
    </message>
    <message>
        <source>The start-up is too short or too weak for rotor and load</source>
        <translation>Der Anlauf ist für Rotor und Last zu kurz oder zu schwach</translation>
    </message>
    <message>
        <source>Make the ramp longer and its current larger, within the motor&apos;s nominal current; end it at 30 to 40 % of the greatest speed.</source>
        <translation>Die Rampe verlängern und ihren Strom erhöhen, höchstens bis zum Nennstrom des Motors; bei 30 bis 40 % der höchsten Drehzahl enden lassen.</translation>
    </message>
    <message>
        <source>The observer does not settle</source>
        <translation>Der Beobachter schwingt nicht ein</translation>
    </message>
    <message>
        <source>Lower its gain G2; lower the least speed at which it is believed to about 10 % of the greatest.</source>
        <translation>Seine Verstärkung G2 verringern; die kleinste Drehzahl, ab der man ihm glaubt, auf etwa 10 % der höchsten senken.</translation>
    </message>
    <message>
        <source>The motor&apos;s values are not right</source>
        <translation>Die Werte des Motors stimmen nicht</translation>
    </message>
    <message>
        <source>Check resistance, inductance, the back-EMF constant and the pole pairs.</source>
        <translation>Widerstand, Induktivität, Spannungskonstante und Polpaare prüfen.</translation>
    </message>
    <message>
        <source>The load is too large, or the rotor is blocked</source>
        <translation>Die Last ist zu groß, oder der Rotor ist blockiert</translation>
    </message>
    <message>
        <source>Try without the load.</source>
        <translation>Ohne Last versuchen.</translation>
    </message>
    <message>
        <source>The measured or estimated speed is not to be relied on.</source>
        <translation>Auf die gemessene oder geschätzte Drehzahl ist kein Verlass.</translation>
    </message>
    <message>
        <source>The observer is too quick for this motor</source>
        <translation>Der Beobachter ist für diesen Motor zu schnell</translation>
    </message>
    <message>
        <source>Lower its gain G2.</source>
        <translation>Seine Verstärkung G2 verringern.</translation>
    </message>
    <message>
        <source>The speed changes too fast after the start</source>
        <translation>Die Drehzahl ändert sich nach dem Start zu schnell</translation>
    </message>
    <message>
        <source>Take gentler ramps; go through low speeds quickly.</source>
        <translation>Sanftere Rampen wählen; niedrige Drehzahlen rasch durchfahren.</translation>
    </message>
    <message>
        <source>The test of the speed is too strict</source>
        <translation>Die Prüfung der Drehzahl ist zu streng</translation>
    </message>
    <message>
        <source>Allow 4 to 5 failed readings in a row.</source>
        <translation>4 bis 5 fehlerhafte Messungen in Folge zulassen.</translation>
    </message>
    <message>
        <source>The sensor or its wiring</source>
        <translation>Der Sensor oder seine Verdrahtung</translation>
    </message>
    <message>
        <source>Check the order of phases and sensor wires, and the driver&apos;s fault line.</source>
        <translation>Die Reihenfolge der Phasen und Sensorleitungen und die Fehlerleitung des Treibers prüfen.</translation>
    </message>
    <message>
        <source>The power stage switched itself off because of too much current.</source>
        <translation>Das Leistungsteil hat sich wegen zu hohen Stroms selbst abgeschaltet.</translation>
    </message>
    <message>
        <source>Shunt, amplification or topology are set wrongly</source>
        <translation>Messwiderstand, Verstärkung oder Topologie sind falsch eingestellt</translation>
    </message>
    <message>
        <source>Compare the current scale with the hardware.</source>
        <translation>Die Stromskala mit der Hardware vergleichen.</translation>
    </message>
    <message>
        <source>The current loop oscillates</source>
        <translation>Der Stromregler schwingt</translation>
    </message>
    <message>
        <source>Lower the bandwidth of the current loop.</source>
        <translation>Die Bandbreite des Stromreglers verringern.</translation>
    </message>
    <message>
        <source>The step of current is too large</source>
        <translation>Der Stromsprung ist zu groß</translation>
    </message>
    <message>
        <source>Take a slower ramp or a smaller current.</source>
        <translation>Eine langsamere Rampe oder einen kleineren Strom wählen.</translation>
    </message>
    <message>
        <source>A short circuit, or a damaged stage</source>
        <translation>Ein Kurzschluss oder ein beschädigtes Leistungsteil</translation>
    </message>
    <message>
        <source>Remove the power, then measure between the phases and to ground.</source>
        <translation>Die Spannung abschalten, dann zwischen den Phasen und gegen Masse messen.</translation>
    </message>
    <message>
        <source>The control loop did not finish within its period.</source>
        <translation>Der Regler wurde in seiner Periode nicht fertig.</translation>
    </message>
    <message>
        <source>The control rate is too high for this processor</source>
        <translation>Der Regeltakt ist für diesen Prozessor zu hoch</translation>
    </message>
    <message>
        <source>Lower the PWM frequency or the control rate.</source>
        <translation>Die PWM-Frequenz oder den Regeltakt senken.</translation>
    </message>
    <message>
        <source>Too many signals are recorded</source>
        <translation>Es werden zu viele Signale aufgezeichnet</translation>
    </message>
    <message>
        <source>Record fewer signals, or only every second sample.</source>
        <translation>Weniger Signale aufzeichnen oder nur jeden zweiten Wert.</translation>
    </message>
    <message>
        <source>The firmware was built without optimisation</source>
        <translation>Die Firmware wurde ohne Optimierung gebaut</translation>
    </message>
    <message>
        <source>Build it for release.</source>
        <translation>Mit Optimierung bauen.</translation>
    </message>
    <message>
        <source>The bus voltage is above its limit.</source>
        <translation>Die Zwischenkreisspannung liegt über ihrer Grenze.</translation>
    </message>
    <message>
        <source>The motor feeds energy back while it brakes</source>
        <translation>Der Motor speist beim Bremsen zurück</translation>
    </message>
    <message>
        <source>Slow down more gently, or connect a brake resistor.</source>
        <translation>Sanfter bremsen oder einen Bremswiderstand anschließen.</translation>
    </message>
    <message>
        <source>The supply is set too high</source>
        <translation>Das Netzteil ist zu hoch eingestellt</translation>
    </message>
    <message>
        <source>Compare its voltage with the limit of the board.</source>
        <translation>Seine Spannung mit der Grenze des Boards vergleichen.</translation>
    </message>
    <message>
        <source>The voltage is measured wrongly</source>
        <translation>Die Spannung wird falsch gemessen</translation>
    </message>
    <message>
        <source>Compare the shown bus voltage with a meter.</source>
        <translation>Die angezeigte Zwischenkreisspannung mit einem Messgerät vergleichen.</translation>
    </message>
    <message>
        <source>The bus voltage is below its limit.</source>
        <translation>Die Zwischenkreisspannung liegt unter ihrer Grenze.</translation>
    </message>
    <message>
        <source>The supply&apos;s current limit is reached</source>
        <translation>Die Strombegrenzung des Netzteils ist erreicht</translation>
    </message>
    <message>
        <source>Raise it, or ask for less current.</source>
        <translation>Sie erhöhen oder weniger Strom verlangen.</translation>
    </message>
    <message>
        <source>The supply is off or connected badly</source>
        <translation>Das Netzteil ist aus oder schlecht angeschlossen</translation>
    </message>
    <message>
        <source>Measure at the board&apos;s terminals.</source>
        <translation>An den Klemmen des Boards messen.</translation>
    </message>
    <message>
        <source>The threshold is too high for this supply</source>
        <translation>Die Schwelle ist für dieses Netzteil zu hoch</translation>
    </message>
    <message>
        <source>Compare it with the nominal voltage.</source>
        <translation>Sie mit der Nennspannung vergleichen.</translation>
    </message>
    <message>
        <source>The power stage is too hot, or looks so.</source>
        <translation>Das Leistungsteil ist zu heiß oder scheint es zu sein.</translation>
    </message>
    <message>
        <source>It is too hot</source>
        <translation>Sie ist zu heiß</translation>
    </message>
    <message>
        <source>Let it cool; ask for less current.</source>
        <translation>Abkühlen lassen; weniger Strom verlangen.</translation>
    </message>
    <message>
        <source>The temperature is measured wrongly</source>
        <translation>Die Temperatur wird falsch gemessen</translation>
    </message>
    <message>
        <source>Compare it with the room&apos;s while the motor is cold; check the sensor&apos;s constants and the threshold.</source>
        <translation>Bei kaltem Motor mit der Raumtemperatur vergleichen; die Konstanten des Sensors und die Schwelle prüfen.</translation>
    </message>
    <message>
        <source>The firmware found an error of its own.</source>
        <translation>Die Firmware hat einen eigenen Fehler gefunden.</translation>
    </message>
    <message>
        <source>Its settings contradict one another</source>
        <translation>Ihre Einstellungen widersprechen sich</translation>
    </message>
    <message>
        <source>Reset the board; undo the last changes.</source>
        <translation>Das Board zurücksetzen; die letzten Änderungen zurücknehmen.</translation>
    </message>
    <message>
        <source>An error in the firmware</source>
        <translation>Ein Fehler in der Firmware</translation>
    </message>
    <message>
        <source>Note what was done before and report it to its makers.</source>
        <translation>Notieren, was davor geschah, und den Herstellern melden.</translation>
    </message>
    <message>
        <source>The phase currents could not be sampled in time.</source>
        <translation>Die Phasenströme konnten nicht rechtzeitig abgetastet werden.</translation>
    </message>
    <message>
        <source>The modulation leaves no room for sampling</source>
        <translation>Die Modulation lässt keine Zeit zum Abtasten</translation>
    </message>
    <message>
        <source>Lower the greatest modulation or the PWM frequency.</source>
        <translation>Die höchste Modulation oder die PWM-Frequenz senken.</translation>
    </message>
    <message>
        <source>The gate driver reports a fault of its own.</source>
        <translation>Der Gate-Treiber meldet selbst einen Fehler.</translation>
    </message>
    <message>
        <source>Its protection acted: too much current or too little supply</source>
        <translation>Sein Schutz hat angesprochen: zu viel Strom oder zu wenig Versorgung</translation>
    </message>
    <message>
        <source>Check its supply and the short-circuit threshold.</source>
        <translation>Seine Versorgung und die Kurzschlussschwelle prüfen.</translation>
    </message>
    <message>
        <source>The wire of its fault line is open</source>
        <translation>Seine Fehlerleitung ist unterbrochen</translation>
    </message>
    <message>
        <source>Check jumpers and pull-up resistors.</source>
        <translation>Steckbrücken und Pull-up-Widerstände prüfen.</translation>
    </message>
    <message>
        <source>Nothing is known here about this fault.</source>
        <translation>Über diesen Fehler ist hier nichts bekannt.</translation>
    </message>
    <message>
        <source>See the documentation of the firmware</source>
        <translation>Siehe Dokumentation der Firmware</translation>
    </message>
</context>
<context>
    <name>FileProblem</name>
    <message>
        <source>2 GiB of numbers</source>
        <translation>2 GiB an Zahlen</translation>
    </message>
    <message>
        <source>64 signals and 4 GiB</source>
        <translation>64 Signale und 4 GiB</translation>
    </message>
    <message>
        <source>there is no heading with the names of signals</source>
        <translation>es gibt keine Kopfzeile mit Signalnamen</translation>
    </message>
    <message>
        <source>there is one column only</source>
        <translation>es gibt nur eine Spalte</translation>
    </message>
    <message>
        <source>there are too many columns</source>
        <translation>es sind zu viele Spalten</translation>
    </message>
    <message>
        <source>the line is too long for a line of numbers</source>
        <translation>die Zeile ist zu lang für eine Zeile von Zahlen</translation>
    </message>
    <message>
        <source>the line has another number of fields than the heading</source>
        <translation>die Zeile hat eine andere Zahl von Feldern als die Kopfzeile</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no time</source>
        <translation>„%1“ ist keine Zeit</translation>
    </message>
    <message>
        <source>the time %1 is before the one above it</source>
        <translation>die Zeit %1 liegt vor der darüber</translation>
    </message>
    <message>
        <source>there is a heading and nothing else</source>
        <translation>es gibt eine Kopfzeile und sonst nichts</translation>
    </message>
    <message>
        <source>No %1 file: it holds at most %2. Choose fewer signals or a shorter range.</source>
        <translation>Keine %1-Datei: Sie fasst höchstens %2. Wählen Sie weniger Signale oder einen kürzeren Bereich.</translation>
    </message>
    <message>
        <source>No %1 file: there is no time at which all fast signals were recorded. Choose fewer of them.</source>
        <translation>Keine %1-Datei: Es gibt keine Zeit, zu der alle schnellen Signale aufgezeichnet wurden. Wählen Sie weniger davon.</translation>
    </message>
    <message>
        <source>No %1 file: the signals have different rates. Choose some of one rate.</source>
        <translation>Keine %1-Datei: Die Signale haben verschiedene Raten. Wählen Sie solche mit gleicher Rate.</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>it is not JSON</source>
        <translation>sie ist kein JSON</translation>
    </message>
    <message>
        <source>it has no stages, or more than five</source>
        <translation>sie enthält keine Stufen oder mehr als fünf</translation>
    </message>
    <message>
        <source>the numbers of its stage %1 do not fit</source>
        <translation>die Zahlen der Stufe %1 passen nicht</translation>
    </message>
    <message>
        <source>%1 is no rev-up: %2.</source>
        <translation>%1 ist kein Anlauf: %2.</translation>
    </message>
    <message>
        <source>%1 sample</source>
        <translation>%1 Abtastwert</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 Abtastwerte</translation>
    </message>
    <message>
        <source>%1 byte of the line</source>
        <translation>%1 Byte der Leitung</translation>
    </message>
    <message>
        <source>%1 bytes of the line</source>
        <translation>%1 Bytes der Leitung</translation>
    </message>
    <message>
        <source>%1 other entry</source>
        <translation>%1 anderer Eintrag</translation>
    </message>
    <message>
        <source>%1 other entries</source>
        <translation>%1 andere Einträge</translation>
    </message>
</context>
<context>
    <name>GainTexts</name>
    <message>
        <source>unit not known</source>
        <translation>Einheit unbekannt</translation>
    </message>
    <message>
        <source>Amperes of Iq for radians per second.</source>
        <translation>Ampere Iq je Radiant pro Sekunde.</translation>
    </message>
    <message>
        <source>What it makes at the motor.</source>
        <translation>Was davon am Motor ankommt.</translation>
    </message>
    <message>
        <source>Amperes of Id for volts that are missing.</source>
        <translation>Ampere Id je fehlendem Volt.</translation>
    </message>
    <message>
        <source>Amperes of Iq for radians of the shaft.</source>
        <translation>Ampere Iq je Radiant der Welle.</translation>
    </message>
    <message>
        <source>The observer&apos;s own full scales are not told by the board.</source>
        <translation>Die Vollausschläge des Beobachters nennt das Board nicht.</translation>
    </message>
    <message>
        <source>(ST&apos;s rule: %1)</source>
        <translation>(Regel von ST: %1)</translation>
    </message>
    <message>
        <source>Where ST&apos;s rule puts it for this motor: poles at a quarter of the motor&apos;s own. %1</source>
        <translation>Wohin die Regel von ST ihn für diesen Motor legt: Pole bei einem Viertel derer des Motors. %1</translation>
    </message>
</context>
<context>
    <name>Gains</name>
    <message>
        <source>Rs, Lq and Ld are needed.</source>
        <translation>Rs, Lq und Ld werden gebraucht.</translation>
    </message>
    <message>
        <source>The board does not say its bus voltage or what a digit of current is worth.</source>
        <translation>Das Board nennt weder seine Zwischenkreisspannung noch, was ein Digit Strom bedeutet.</translation>
    </message>
    <message>
        <source>The board does not say its control rate.</source>
        <translation>Das Board nennt seinen Regeltakt nicht.</translation>
    </message>
    <message>
        <source>%1 rad/s is beyond %2 rad/s, what the control rate allows.</source>
        <translation>%1 rad/s liegt über %2 rad/s, mehr lässt der Regeltakt nicht zu.</translation>
    </message>
    <message>
        <source>%1 does not fit 16 bits with any divisor: ask for less bandwidth.</source>
        <translation>%1 passt mit keinem Teiler in 16 Bit: weniger Bandbreite verlangen.</translation>
    </message>
    <message>
        <source>%1 is so small that it rounds to zero: ask for more bandwidth or less damping.</source>
        <translation>%1 ist so klein, dass es auf null gerundet wird: mehr Bandbreite oder weniger Dämpfung verlangen.</translation>
    </message>
    <message>
        <source>%1 times the largest error overflows 32 bits: ask for less bandwidth.</source>
        <translation>%1 mal dem größten Fehler läuft über 32 Bit hinaus: weniger Bandbreite verlangen.</translation>
    </message>
    <message>
        <source>The speed loop stays as it is: flux and pole pairs are needed.</source>
        <translation>Der Drehzahlregler bleibt, wie er ist: Fluss und Polpaare fehlen.</translation>
    </message>
    <message>
        <source>The speed loop stays as it is: type the inertia of rotor and load.</source>
        <translation>Der Drehzahlregler bleibt, wie er ist: die Trägheit von Rotor und Last eingeben.</translation>
    </message>
    <message>
        <source>The speed loop stays as it is: the board does not say its rate.</source>
        <translation>Der Drehzahlregler bleibt, wie er ist: Das Board nennt seinen Takt nicht.</translation>
    </message>
    <message>
        <source>Above %1 rad/s, boards that measure currents this way often trip: watch for over-current.</source>
        <translation>Über %1 rad/s schalten Boards mit dieser Strommessung oft ab: auf Überstrom achten.</translation>
    </message>
    <message>
        <source>The current loop has only %1° of phase margin: it will overshoot.</source>
        <translation>Der Stromregler hat nur %1° Phasenreserve: Er wird überschwingen.</translation>
    </message>
    <message>
        <source>The speed loop has only %1° of phase margin: it will ring.</source>
        <translation>Der Drehzahlregler hat nur %1° Phasenreserve: Er wird nachschwingen.</translation>
    </message>
    <message>
        <source>%1 is rounded by %2 %: the loop is not quite the one asked for.</source>
        <translation>%1 wird um %2 % gerundet: Der Regler ist nicht ganz der verlangte.</translation>
    </message>
    <message>
        <source>Ld is above Lq: are they swapped?</source>
        <translation>Ld ist größer als Lq: vertauscht?</translation>
    </message>
</context>
<context>
    <name>Happenings</name>
    <message>
        <source>bad packets: %1</source>
        <translation>schlechte Pakete: %1</translation>
    </message>
    <message>
        <source>refused packets: %1</source>
        <translation>abgelehnte Pakete: %1</translation>
    </message>
    <message>
        <source>unanswered: %1</source>
        <translation>unbeantwortet: %1</translation>
    </message>
    <message>
        <source>recoveries: %1</source>
        <translation>Wiederherstellungen: %1</translation>
    </message>
    <message>
        <source>lost control periods: %1</source>
        <translation>verlorene Regelperioden: %1</translation>
    </message>
    <message>
        <source>skipped packets: %1</source>
        <translation>ausgelassene Pakete: %1</translation>
    </message>
</context>
<context>
    <name>Imports</name>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
    <message>
        <source>%1 cannot be imported (%2).</source>
        <translation>%1 kann nicht importiert werden (%2).</translation>
    </message>
</context>
<context>
    <name>Lab</name>
    <message>
        <source>a current of %1 A is above the %2 A that are allowed</source>
        <translation>ein Strom von %1 A liegt über den erlaubten %2 A</translation>
    </message>
    <message>
        <source>a speed of %1 rpm is above the %2 rpm that are allowed</source>
        <translation>eine Drehzahl von %1 rpm liegt über den erlaubten %2 rpm</translation>
    </message>
    <message>
        <source>a speed of %1 rpm is below the %2 rpm that are allowed</source>
        <translation>eine Drehzahl von %1 rpm liegt unter den erlaubten %2 rpm</translation>
    </message>
    <message>
        <source>a speed of %1 rpm is above the %2 rpm that are allowed, and the wrong way: its sensor may be aligned wrongly, or two phases exchanged</source>
        <translation>eine Drehzahl von %1 rpm liegt über den erlaubten %2 rpm, und in der falschen Richtung: vielleicht ist der Sensor falsch ausgerichtet, oder zwei Phasen sind vertauscht</translation>
    </message>
    <message>
        <source>a bus voltage of %1 V is above the %2 V that are allowed</source>
        <translation>eine Zwischenkreisspannung von %1 V liegt über den erlaubten %2 V</translation>
    </message>
    <message>
        <source>a bus voltage of %1 V is below the %2 V that are allowed</source>
        <translation>eine Zwischenkreisspannung von %1 V liegt unter den erlaubten %2 V</translation>
    </message>
    <message>
        <source>a temperature of %1 °C is above the %2 °C that are allowed</source>
        <translation>eine Temperatur von %1 °C liegt über den erlaubten %2 °C</translation>
    </message>
    <message>
        <source>no samples came for %1 s</source>
        <translation>%1 s lang kamen keine Messwerte</translation>
    </message>
    <message>
        <source>the bus voltage was not read for %1 s</source>
        <translation>die Zwischenkreisspannung wurde %1 s lang nicht gelesen</translation>
    </message>
    <message>
        <source>the temperature was not read for %1 s</source>
        <translation>die Temperatur wurde %1 s lang nicht gelesen</translation>
    </message>
    <message>
        <source>the link to the board was lost</source>
        <translation>die Verbindung zum Board ging verloren</translation>
    </message>
    <message>
        <source>the board&apos;s answer was lost</source>
        <translation>die Antwort des Boards ging verloren</translation>
    </message>
    <message>
        <source>the board&apos;s answer was lost (%1)</source>
        <translation>die Antwort des Boards ging verloren (%1)</translation>
    </message>
    <message>
        <source>it was not sent</source>
        <translation>es wurde nicht gesendet</translation>
    </message>
    <message>
        <source>it was not sent (%1)</source>
        <translation>es wurde nicht gesendet (%1)</translation>
    </message>
    <message>
        <source>reading the motor&apos;s state: %1</source>
        <translation>Lesen des Motorzustands: %1</translation>
    </message>
    <message>
        <source>recording its signals: %1</source>
        <translation>Aufnehmen seiner Signale: %1</translation>
    </message>
    <message>
        <source>reading its bus voltage: %1</source>
        <translation>Lesen der Zwischenkreisspannung: %1</translation>
    </message>
    <message>
        <source>what it writes: %1</source>
        <translation>was geschrieben wird: %1</translation>
    </message>
    <message>
        <source>what the start goes to: %1</source>
        <translation>das Ziel des Starts: %1</translation>
    </message>
    <message>
        <source>the start: %1</source>
        <translation>der Start: %1</translation>
    </message>
    <message>
        <source>the way to the first speed: %1</source>
        <translation>der Weg zur ersten Drehzahl: %1</translation>
    </message>
    <message>
        <source>a step of it: %1</source>
        <translation>ein Schritt davon: %1</translation>
    </message>
    <message>
        <source>the way back: %1</source>
        <translation>der Weg zurück: %1</translation>
    </message>
    <message>
        <source>what was there before: %1</source>
        <translation>was vorher war: %1</translation>
    </message>
    <message>
        <source>reading what is there afterwards: %1</source>
        <translation>Lesen dessen, was nachher ist: %1</translation>
    </message>
    <message>
        <source>then %1</source>
        <translation>danach: %1</translation>
    </message>
    <message>
        <source>the board reports a fault: %1</source>
        <translation>das Board meldet einen Fehler: %1</translation>
    </message>
    <message>
        <source>something else stopped the motor</source>
        <translation>etwas anderes hat den Motor gestoppt</translation>
    </message>
    <message>
        <source>the start-up went on to turn the motor</source>
        <translation>der Anlauf drehte den Motor weiter</translation>
    </message>
    <message>
        <source>the motor did not come to run within %1 s</source>
        <translation>der Motor lief nach %1 s noch nicht</translation>
    </message>
    <message>
        <source>the speed did not come to rest at %1 rpm</source>
        <translation>die Drehzahl kam bei %1 rpm nicht zur Ruhe</translation>
    </message>
    <message>
        <source>the speed did not come back to %1 rpm</source>
        <translation>die Drehzahl kam nicht auf %1 rpm zurück</translation>
    </message>
    <message>
        <source>the motor was not seen to stop</source>
        <translation>dass der Motor steht, wurde nicht gesehen</translation>
    </message>
    <message>
        <source>no answer came in time</source>
        <translation>es kam keine Antwort zur rechten Zeit</translation>
    </message>
    <message>
        <source>the motor neither runs nor rests: it is in %1 (%2): acknowledge the fault first</source>
        <translation>der Motor läuft nicht und ruht nicht: er ist in %1 (%2): zuerst den Fehler quittieren</translation>
    </message>
    <message>
        <source>the motor neither runs nor rests: it is in %1</source>
        <translation>der Motor läuft nicht und ruht nicht: er ist in %1</translation>
    </message>
    <message>
        <source>the motor turns, and this is measured while it rests: stop it first</source>
        <translation>der Motor dreht, und gemessen wird in Ruhe: erst stoppen</translation>
    </message>
    <message>
        <source>the board does not give %1, which would be written</source>
        <translation>das Board liefert %1 nicht, das geschrieben würde</translation>
    </message>
    <message>
        <source>the motor is not in speed control: ask for a speed first</source>
        <translation>der Motor ist nicht in Drehzahlregelung: erst eine Drehzahl vorgeben</translation>
    </message>
    <message>
        <source>the motor does not turn at its set-point of %1 rpm</source>
        <translation>der Motor dreht nicht mit seinem Sollwert von %1 rpm</translation>
    </message>
    <message>
        <source>%1 is not 0, and would be afterwards: bring it to 0 first</source>
        <translation>%1 ist nicht 0 und wäre es nachher: erst auf 0 bringen</translation>
    </message>
    <message>
        <source>the set-point is %1 rpm now, it was %2 rpm</source>
        <translation>der Sollwert ist jetzt %1 rpm, er war %2 rpm</translation>
    </message>
    <message>
        <source>the set-point may be %1 rpm or %2 rpm now, it was %3 rpm</source>
        <translation>der Sollwert ist jetzt vielleicht %1 rpm oder %2 rpm, er war %3 rpm</translation>
    </message>
    <message>
        <source>the set-point may be %1 rpm now, it was %2 rpm</source>
        <translation>der Sollwert ist jetzt vielleicht %1 rpm, er war %2 rpm</translation>
    </message>
    <message>
        <source>%1 shows %2 rpm until the next start, it showed %3 rpm</source>
        <translation>%1 zeigt bis zum nächsten Start %2 rpm, vorher waren es %3 rpm</translation>
    </message>
    <message>
        <source>%1 may hold what the experiment wrote</source>
        <translation>%1 enthält vielleicht, was der Versuch geschrieben hat</translation>
    </message>
    <message>
        <source>what it held before comes back with: rotorscope-cli set %1</source>
        <translation>was vorher darin stand, kommt zurück mit: rotorscope-cli set %1</translation>
    </message>
    <message>
        <source>%1 has no stage with a speed, as an experiment leaves it that was ended early: write the motor&apos;s own stages first</source>
        <translation>%1 hat keine Stufe mit einer Drehzahl, wie ein Versuch es hinterlässt, der vorzeitig beendet wurde: erst die eigenen Stufen des Motors schreiben</translation>
    </message>
    <message>
        <source>the motor is in torque control now, it was in speed control</source>
        <translation>der Motor ist jetzt in Drehmomentregelung, er war in Drehzahlregelung</translation>
    </message>
    <message>
        <source>what comes next is not agreed to any more</source>
        <translation>was folgt, ist nicht mehr vereinbart</translation>
    </message>
    <message>
        <source>what comes next was not begun</source>
        <translation>was folgt, wurde nicht begonnen</translation>
    </message>
    <message>
        <source>the way to the first speed takes 1 ms to 10 s</source>
        <translation>der Weg zur ersten Drehzahl dauert 1 ms bis 10 s</translation>
    </message>
    <message>
        <source>nothing says how fast this motor may turn: give the greatest speed that it may have</source>
        <translation>nichts sagt, wie schnell dieser Motor drehen darf: seine höchste Drehzahl angeben</translation>
    </message>
    <message>
        <source>%1 rpm are more than the %2 rpm that are allowed</source>
        <translation>%1 rpm sind mehr als die erlaubten %2 rpm</translation>
    </message>
    <message>
        <source>%1 A are more than the %2 A that are allowed</source>
        <translation>%1 A sind mehr als die erlaubten %2 A</translation>
    </message>
    <message>
        <source>stay above %1 rpm: this motor has no sensor, and at %2 rpm its rotor might be lost</source>
        <translation>über %1 rpm bleiben: dieser Motor hat keinen Sensor, und bei %2 rpm könnte sein Rotor verloren gehen</translation>
    </message>
    <message>
        <source>keep both speeds at %1 rpm or above: this motor has no sensor, and a step to %2 rpm goes on below the %3 rpm that are needed to see its rotor</source>
        <translation>beide Drehzahlen bei %1 rpm oder darüber wählen: dieser Motor hat keinen Sensor, und ein Sprung auf %2 rpm geht noch unter die %3 rpm, die nötig sind, um seinen Rotor zu sehen</translation>
    </message>
    <message>
        <source>it could take %1 s, and what moves a motor by itself ends within %2 s: take fewer repetitions, or a shorter time for each</source>
        <translation>es könnte %1 s dauern, und was einen Motor von selbst bewegt, endet nach %2 s: weniger Wiederholungen nehmen oder für jede weniger Zeit</translation>
    </message>
    <message>
        <source>both speeds are the same: there is no step</source>
        <translation>beide Drehzahlen sind gleich: es gibt keinen Sprung</translation>
    </message>
    <message>
        <source>both currents are the same: there is no step</source>
        <translation>beide Ströme sind gleich: es gibt keinen Sprung</translation>
    </message>
    <message>
        <source>a series has 1 to %1 repetitions</source>
        <translation>eine Reihe hat 1 bis %1 Wiederholungen</translation>
    </message>
    <message>
        <source>a speed is held for 50 ms to 10 s</source>
        <translation>eine Drehzahl wird 50 ms bis 10 s gehalten</translation>
    </message>
    <message>
        <source>a current is held for 10 to 500 ms</source>
        <translation>ein Strom wird 10 bis 500 ms gehalten</translation>
    </message>
    <message>
        <source>a current rises within 10 ms to 2 s and is held for 100 ms to 2 s</source>
        <translation>ein Strom steigt in 10 ms bis 2 s und wird 100 ms bis 2 s gehalten</translation>
    </message>
    <message>
        <source>the motor has to turn</source>
        <translation>der Motor muss drehen</translation>
    </message>
    <message>
        <source>a torque against the way that the motor turns would brake it, and nothing says that its supply takes what comes back: both currents have to push the same way</source>
        <translation>ein Drehmoment gegen die Drehrichtung würde den Motor bremsen, und nichts sagt, dass seine Versorgung aufnimmt, was zurückkommt: beide Ströme müssen in dieselbe Richtung treiben</translation>
    </message>
    <message>
        <source>this board does not record the angle of its rotor</source>
        <translation>dieses Board zeichnet den Winkel seines Rotors nicht auf</translation>
    </message>
    <message>
        <source>this board does not record the current along its magnets</source>
        <translation>dieses Board zeichnet den Strom längs der Magnete nicht auf</translation>
    </message>
    <message>
        <source>this board does not record voltages, currents and the angle of its rotor</source>
        <translation>dieses Board zeichnet Spannungen, Ströme und den Winkel seines Rotors nicht auf</translation>
    </message>
    <message>
        <source>this board does not record its voltage and both of its currents</source>
        <translation>dieses Board zeichnet seine Spannung und seine beiden Ströme nicht auf</translation>
    </message>
    <message>
        <source>this board holds no current through a motor that rests</source>
        <translation>dieses Board hält keinen Strom durch einen ruhenden Motor</translation>
    </message>
    <message>
        <source>the board does not tell the nominal current of its motor</source>
        <translation>das Board nennt den Nennstrom seines Motors nicht</translation>
    </message>
    <message>
        <source>the board does not tell the strength of the magnets, without which no torque is known</source>
        <translation>das Board nennt die Stärke der Magnete nicht, ohne die kein Drehmoment bekannt ist</translation>
    </message>
    <message>
        <source>it needs two currents, the second at least 1.5 times as strong as the first</source>
        <translation>es braucht zwei Ströme, der zweite mindestens 1,5-mal so stark wie der erste</translation>
    </message>
    <message>
        <source>%1 A are more than the %2 A of your own limit</source>
        <translation>%1 A sind mehr als die %2 A Ihrer eigenen Grenze</translation>
    </message>
    <message>
        <source>%1 A are more than the %2 A that a motor at rest is given here</source>
        <translation>%1 A sind mehr als die %2 A, die ein ruhender Motor hier bekommt</translation>
    </message>
    <message>
        <source>at most %1 A flow along the magnets</source>
        <translation>längs der Magnete fließen höchstens %1 A</translation>
    </message>
    <message>
        <source>it takes 1 to 30 s</source>
        <translation>es dauert 1 bis 30 s</translation>
    </message>
    <message>
        <source>it takes 4 to 40 s</source>
        <translation>es dauert 4 bis 40 s</translation>
    </message>
    <message>
        <source>it needs two speeds in one direction, the lower one first</source>
        <translation>es braucht zwei Drehzahlen in einer Richtung, die niedrigere zuerst</translation>
    </message>
    <message>
        <source>the speed has to go to and fro by 1 rpm or more</source>
        <translation>die Drehzahl muss um mindestens 1 rpm hin und her gehen</translation>
    </message>
    <message>
        <source>the speed may go to and fro by less than half of it</source>
        <translation>die Drehzahl darf um weniger als ihre Hälfte hin und her gehen</translation>
    </message>
    <message>
        <source>There is no such motor.</source>
        <translation>Einen solchen Motor gibt es nicht.</translation>
    </message>
    <message>
        <source>the run ended early: %1</source>
        <translation>der Lauf endete vorzeitig: %1</translation>
    </message>
    <message>
        <source>the series ended early: %1</source>
        <translation>die Reihe endete vorzeitig: %1</translation>
    </message>
    <message>
        <source>the recording ends before the series does</source>
        <translation>die Aufzeichnung endet vor der Reihe</translation>
    </message>
    <message>
        <source>the recording ends before the experiment does</source>
        <translation>die Aufzeichnung endet vor dem Versuch</translation>
    </message>
    <message>
        <source>it is no recording of an experiment</source>
        <translation>es ist keine Aufzeichnung eines Versuchs</translation>
    </message>
    <message>
        <source>it is no recording of a series of steps</source>
        <translation>es ist keine Aufzeichnung einer Reihe von Sprüngen</translation>
    </message>
    <message>
        <source>it is no recording of a series of current steps</source>
        <translation>es ist keine Aufzeichnung einer Reihe von Stromsprüngen</translation>
    </message>
    <message>
        <source>it is no recording of a mechanical identification</source>
        <translation>es ist keine Aufzeichnung einer mechanischen Identifikation</translation>
    </message>
    <message>
        <source>it is no recording of an electrical identification</source>
        <translation>es ist keine Aufzeichnung einer elektrischen Identifikation</translation>
    </message>
    <message>
        <source>it is no recording of a speed&apos;s frequency response</source>
        <translation>es ist keine Aufzeichnung eines Frequenzgangs der Drehzahl</translation>
    </message>
    <message>
        <source>it is no recording of a current loop&apos;s frequency response</source>
        <translation>es ist keine Aufzeichnung eines Frequenzgangs des Stromreglers</translation>
    </message>
    <message>
        <source>it holds no samples of the signals that it needs</source>
        <translation>sie enthält keine Messwerte der Signale, die gebraucht werden</translation>
    </message>
    <message>
        <source>it holds no samples of the signals of its series of steps</source>
        <translation>sie enthält keine Messwerte der Signale ihrer Sprünge</translation>
    </message>
    <message>
        <source>it holds no samples of that time</source>
        <translation>sie enthält keine Messwerte dieser Zeit</translation>
    </message>
    <message>
        <source>the motor was never driven by a torque in it</source>
        <translation>der Motor wurde darin nie von einem Drehmoment getrieben</translation>
    </message>
    <message>
        <source>the motor was never driven by a current while it turned</source>
        <translation>der Motor wurde nie von einem Strom getrieben, während er drehte</translation>
    </message>
    <message>
        <source>the set-point was never moved in it</source>
        <translation>der Sollwert wurde darin nie bewegt</translation>
    </message>
    <message>
        <source>the motor turned for only %1 s of it without a gap; %2 s are needed</source>
        <translation>der Motor drehte nur %1 s davon ohne Lücke; %2 s sind nötig</translation>
    </message>
    <message>
        <source>too little of it is without a gap: stretches of two seconds are needed</source>
        <translation>zu wenig davon ist ohne Lücke: Strecken von zwei Sekunden sind nötig</translation>
    </message>
    <message>
        <source>too little of it is without a gap: a second is needed</source>
        <translation>zu wenig davon ist ohne Lücke: eine Sekunde ist nötig</translation>
    </message>
    <message>
        <source>the speed did not come to rest before the first torque: its speed loop swings</source>
        <translation>die Drehzahl kam vor dem ersten Drehmoment nicht zur Ruhe: ihr Regler schwingt</translation>
    </message>
    <message>
        <source>the speed hardly changed: no inertia follows from it</source>
        <translation>die Drehzahl änderte sich kaum: daraus folgt kein Trägheitsmoment</translation>
    </message>
    <message>
        <source>this motor changes its speed too fast for its Hall sensors: between two of their edges their angle is too far from the rotor&apos;s to tell a torque</source>
        <translation>dieser Motor ändert seine Drehzahl zu schnell für seine Hallsensoren: zwischen zweien ihrer Flanken ist ihr Winkel zu weit von dem des Rotors, um ein Drehmoment zu nennen</translation>
    </message>
    <message>
        <source>part of the friction may be a fan&apos;s: the angle of Hall sensors at these speeds does not tell the one from the other</source>
        <translation>ein Teil der Reibung ist vielleicht die eines Lüfters: der Winkel von Hallsensoren unterscheidet das eine bei diesen Drehzahlen nicht vom anderen</translation>
    </message>
    <message>
        <source>the rotor turns by up to %1 electrical degrees within a control period: what its current does meanwhile is not seen</source>
        <translation>der Rotor dreht sich innerhalb einer Regelperiode um bis zu %1 elektrische Grad: was sein Strom dabei tut, ist nicht zu sehen</translation>
    </message>
    <message>
        <source>the voltages tell magnets of %1 mWb, the board of %2 mWb (%3 %): the voltages were believed; perhaps the angle of its rotor is off, as after an alignment against friction</source>
        <translation>die Spannungen sprechen für Magnete von %1 mWb, das Board nennt %2 mWb (%3 %): den Spannungen wurde geglaubt; vielleicht stimmt der Winkel des Rotors nicht, wie nach einem Ausrichten gegen Reibung</translation>
    </message>
    <message>
        <source>by what its currents do to its speed, the board takes its rotor for more than 60 electrical degrees beside where it is: its flux is not told</source>
        <translation>gemessen an dem, was seine Ströme mit der Drehzahl machen, hält das Board seinen Rotor für mehr als 60 elektrische Grad neben dem, wo er ist: sein Fluss wird nicht genannt</translation>
    </message>
    <message>
        <source>the rotor nearly stood still for %1 s: that time was left out</source>
        <translation>der Rotor stand %1 s lang fast still: diese Zeit zählt nicht</translation>
    </message>
    <message>
        <source>%1 % of the samples do not fit the others and count for nothing</source>
        <translation>%1 % der Messwerte passen nicht zu den anderen und zählen nicht</translation>
    </message>
    <message>
        <source>the rotor turned where it was to rest: neither its resistance nor the angle that it was aligned to is sure</source>
        <translation>der Rotor drehte, wo er ruhen sollte: weder der Widerstand noch der Winkel, auf den ausgerichtet wurde, ist sicher</translation>
    </message>
    <message>
        <source>at rest no two different currents were held for long enough</source>
        <translation>in Ruhe wurden keine zwei verschiedenen Ströme lange genug gehalten</translation>
    </message>
    <message>
        <source>at rest no resistance follows from the voltages</source>
        <translation>in Ruhe folgt aus den Spannungen kein Widerstand</translation>
    </message>
    <message>
        <source>it does not tell the nominal current of the motor</source>
        <translation>sie nennt den Nennstrom des Motors nicht</translation>
    </message>
    <message>
        <source>it holds too few samples of the turning motor without a gap, or they are too far apart</source>
        <translation>sie enthält zu wenige Messwerte des drehenden Motors ohne Lücke, oder sie liegen zu weit auseinander</translation>
    </message>
    <message>
        <source>while it turned the current along the magnets hardly changed</source>
        <translation>während er drehte, änderte sich der Strom längs der Magnete kaum</translation>
    </message>
    <message>
        <source>while it turned no inductance follows from the voltages</source>
        <translation>während er drehte, folgt aus den Spannungen keine Induktivität</translation>
    </message>
    <message>
        <source>its samples are too far apart to tell the inductance across the magnets, which only jumps of the current tell</source>
        <translation>ihre Messwerte liegen zu weit auseinander, um die Induktivität quer zu den Magneten zu zeigen, die nur Sprünge des Stroms verraten</translation>
    </message>
    <message>
        <source>it turned too slowly to tell the inductance along the magnets</source>
        <translation>er drehte zu langsam, um die Induktivität längs der Magnete zu zeigen</translation>
    </message>
    <message>
        <source>what the dead time takes cannot be told from the resistance: currents swung through zero within a PWM period</source>
        <translation>was die Totzeit nimmt, ist vom Widerstand nicht zu unterscheiden: Ströme schwangen innerhalb einer PWM-Periode durch null</translation>
    </message>
    <message>
        <source>nothing follows from it</source>
        <translation>daraus folgt nichts</translation>
    </message>
    <message>
        <source>not conclusive: no step of this series could be measured</source>
        <translation>nicht schlüssig: kein Sprung dieser Reihe konnte gemessen werden</translation>
    </message>
    <message>
        <source>not conclusive: not all of it could be measured</source>
        <translation>nicht schlüssig: nicht alles davon konnte gemessen werden</translation>
    </message>
    <message>
        <source>the loop&apos;s gain does not fall through 1 where it could be measured: no margin is told</source>
        <translation>die Kreisverstärkung fällt nicht durch 1, wo sie gemessen werden konnte: keine Reserve wird genannt</translation>
    </message>
    <message>
        <source>above 10 Hz the motor&apos;s own response is not told: what is taken for the angle of a rotor without an encoder follows its current, too</source>
        <translation>über 10 Hz wird der Frequenzgang des Motors selbst nicht genannt: was ohne Encoder für den Winkel des Rotors gehalten wird, folgt auch seinem Strom</translation>
    </message>
    <message>
        <source>what is taken for the angle of a rotor without an encoder follows its current, by %1 electrical degrees an ampere if all that turns is one inertia: that is taken out, and above 25 Hz the motor&apos;s own response is not told</source>
        <translation>was ohne Encoder für den Winkel des Rotors gehalten wird, folgt seinem Strom, um %1 elektrische Grad je Ampere, wenn alles, was sich dreht, eine Masse ist: das ist herausgerechnet, und über 25 Hz wird der Frequenzgang des Motors selbst nicht genannt</translation>
    </message>
    <message>
        <source>nothing in it follows the set-point</source>
        <translation>nichts darin folgt dem Sollwert</translation>
    </message>
    <message>
        <source>the current does not follow its reference in it</source>
        <translation>der Strom folgt darin seinem Sollwert nicht</translation>
    </message>
    <message>
        <source>the gains were changed while it was measured</source>
        <translation>die Verstärkungen wurden während der Messung geändert</translation>
    </message>
    <message>
        <source>it is the loop at %1 A: what a bridge loses by its dead time damps it the more the smaller the current is</source>
        <translation>es ist der Regelkreis bei %1 A: was eine Brücke durch ihre Totzeit verliert, dämpft ihn umso mehr, je kleiner der Strom ist</translation>
    </message>
    <message>
        <source>the board does not tell its gains, so its loop is not known</source>
        <translation>das Board nennt seine Verstärkungen nicht, also ist sein Regelkreis nicht bekannt</translation>
    </message>
    <message>
        <source>no speed loop has the period that the board tells</source>
        <translation>kein Drehzahlregler hat die Periode, die das Board nennt</translation>
    </message>
    <message>
        <source>too few frequencies of the response are clear enough</source>
        <translation>zu wenige Frequenzen des Frequenzgangs sind deutlich genug</translation>
    </message>
    <message>
        <source>no gains keep the distance from instability that is asked for</source>
        <translation>keine Verstärkungen halten den verlangten Abstand von der Instabilität</translation>
    </message>
    <message>
        <source>rise time</source>
        <translation>Anstiegszeit</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>settling time</source>
        <translation>Ausregelzeit</translation>
    </message>
    <message>
        <source>peak current</source>
        <translation>Spitzenstrom</translation>
    </message>
    <message>
        <source>the step is only %1 digits of the set-point; %2 rpm or more say more</source>
        <translation>der Sprung ist nur %1 Digits des Sollwerts; %2 rpm oder mehr sagen mehr</translation>
    </message>
    <message>
        <source>samples are missing in %1: nothing is told of its speed</source>
        <translation>in %1 fehlen Messwerte: von der Drehzahl wird nichts gesagt</translation>
    </message>
    <message>
        <source>samples are missing in %1: nothing is told of its current</source>
        <translation>in %1 fehlen Messwerte: vom Strom wird nichts gesagt</translation>
    </message>
    <message>
        <source>the instant of %1 is uncertain by %2 ms: its settling time is not told</source>
        <translation>der Zeitpunkt von %1 ist um %2 ms unsicher: die Ausregelzeit wird nicht genannt</translation>
    </message>
    <message>
        <source>%1 does not settle while its speed is held</source>
        <translation>%1 regelt nicht aus, solange die Drehzahl gehalten wird</translation>
    </message>
    <message>
        <source>%1 does not settle while its current is held</source>
        <translation>%1 regelt nicht aus, solange der Strom gehalten wird</translation>
    </message>
    <message>
        <source>the current was at its limit in %1 % of %2: it does not show the loop alone</source>
        <translation>der Strom war in %1 % von %2 an seiner Grenze: er zeigt nicht den Regler allein</translation>
    </message>
    <message>
        <source>the noise of the measured current is %1 % of the step: overshoot and settling are told from noise, too; a larger step says more</source>
        <translation>das Rauschen des gemessenen Stroms ist %1 % des Sprungs: Überschwingen und Ausregelzeit kommen auch aus dem Rauschen; ein größerer Sprung sagt mehr</translation>
    </message>
    <message>
        <source>the port was closed</source>
        <translation>die Schnittstelle wurde geschlossen</translation>
    </message>
    <message>
        <source>the port was lost</source>
        <translation>die Schnittstelle ging verloren</translation>
    </message>
    <message>
        <source>another command went to the motor</source>
        <translation>ein anderer Befehl ging an den Motor</translation>
    </message>
    <message>
        <source>the drive was disarmed</source>
        <translation>die Freigabe wurde zurückgenommen</translation>
    </message>
    <message>
        <source>the drive is not armed any more</source>
        <translation>der Antrieb ist nicht mehr freigegeben</translation>
    </message>
    <message>
        <source>every motor was stopped</source>
        <translation>jeder Motor wurde gestoppt</translation>
    </message>
    <message>
        <source>no port is open</source>
        <translation>keine Schnittstelle ist offen</translation>
    </message>
    <message>
        <source>another experiment is running</source>
        <translation>ein anderer Versuch läuft</translation>
    </message>
    <message>
        <source>the drive is not armed</source>
        <translation>der Antrieb ist nicht freigegeben</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>too late: it was asked for more than half a second ago</source>
        <translation>zu spät: es wurde vor mehr als einer halben Sekunde verlangt</translation>
    </message>
    <message>
        <source>the motor was started all the same</source>
        <translation>der Motor wurde trotzdem gestartet</translation>
    </message>
    <message>
        <source>the motor may be in torque control now, it was in speed control</source>
        <translation>der Motor ist jetzt vielleicht in Drehmomentregelung, er war in Drehzahlregelung</translation>
    </message>
    <message>
        <source>the board takes its rotor for %1 electrical degrees beside where it is, as after an alignment against friction: its torque was counted by that</source>
        <translation>das Board hält seinen Rotor für %1 elektrische Grad neben dem, wo er ist, wie nach einem Ausrichten gegen Reibung: sein Drehmoment wurde danach gezählt</translation>
    </message>
    <message>
        <source>the board takes its rotor for %1 electrical degrees beside where it is, as after an alignment against friction: its magnets were counted by that</source>
        <translation>das Board hält seinen Rotor für %1 elektrische Grad neben dem, wo er ist, wie nach einem Ausrichten gegen Reibung: sein Magnetfluss wurde danach gezählt</translation>
    </message>
    <message>
        <source>this board has no gains of a speed loop</source>
        <translation>dieses Board hat keine Verstärkungen eines Drehzahlreglers</translation>
    </message>
    <message>
        <source>gains are 0 to %1 digits</source>
        <translation>Verstärkungen sind 0 bis %1 Digits</translation>
    </message>
    <message>
        <source>the motor turns, and its gains are written while it rests: stop it first</source>
        <translation>der Motor dreht, und seine Verstärkungen werden geschrieben, während er ruht: zuerst anhalten</translation>
    </message>
    <message>
        <source>the motor was started meanwhile</source>
        <translation>der Motor wurde inzwischen gestartet</translation>
    </message>
    <message>
        <source>it was refused</source>
        <translation>es wurde abgelehnt</translation>
    </message>
    <message>
        <source>it was refused (%1)</source>
        <translation>es wurde abgelehnt (%1)</translation>
    </message>
    <message>
        <source>the drive was disarmed, and the motor that was started is driven on</source>
        <translation>die Freigabe wurde zurückgenommen, und der gestartete Motor wird weiter angetrieben</translation>
    </message>
    <message>
        <source>a Stop goes out as soon as the board is reached</source>
        <translation>ein Stopp geht hinaus, sobald das Board erreicht wird</translation>
    </message>
    <message>
        <source>%1 was cut short: nothing is told of its speed</source>
        <translation>%1 wurde abgebrochen: von seiner Drehzahl wird nichts genannt</translation>
    </message>
    <message>
        <source>%1 was cut short: nothing is told of its current</source>
        <translation>%1 wurde abgebrochen: von seinem Strom wird nichts genannt</translation>
    </message>
    <message>
        <source>the motor did not get to its first speed: the board reports a fault: %1</source>
        <translation>der Motor kam nicht auf seine erste Drehzahl: das Board meldet einen Fehler: %1</translation>
    </message>
    <message>
        <source>every motor was told to stop</source>
        <translation>jedem Motor wurde der Stopp befohlen</translation>
    </message>
    <message>
        <source>step %1 (up) stands apart from the others by its %2; it is part of the mean</source>
        <translation>Sprung %1 (hoch) weicht von den anderen ab: %2; er gehört zum Mittel</translation>
    </message>
    <message>
        <source>step %1 (down) stands apart from the others by its %2; it is part of the mean</source>
        <translation>Sprung %1 (herunter) weicht von den anderen ab: %2; er gehört zum Mittel</translation>
    </message>
    <message>
        <source>the mean %1 is that of %2 of %3 steps</source>
        <translation>Mittel aus %2 von %3 Sprüngen: %1</translation>
    </message>
    <message>
        <source>the mean %1, %2, %3 and %4 are those of %5 of %6 steps</source>
        <translation>Mittel aus %5 von %6 Sprüngen: %1, %2, %3 und %4</translation>
    </message>
    <message>
        <source>the mean %1, %2 and %3 are those of %4 of %5 steps</source>
        <translation>Mittel aus %4 von %5 Sprüngen: %1, %2 und %3</translation>
    </message>
    <message>
        <source>the mean %1 and %2 are those of %3 of %4 steps</source>
        <translation>Mittel aus %3 von %4 Sprüngen: %1 und %2</translation>
    </message>
    <message>
        <source>%1 of %2 steps do not settle while their speed is held</source>
        <translation>%1 von %2 Sprüngen regeln nicht aus, solange ihre Drehzahl gehalten wird</translation>
    </message>
    <message>
        <source>%1 of %2 steps do not settle while their current is held</source>
        <translation>%1 von %2 Sprüngen regeln nicht aus, solange ihr Strom gehalten wird</translation>
    </message>
    <message>
        <source>%1 is not seen in the speed</source>
        <translation>%1 ist in der Drehzahl nicht zu sehen</translation>
    </message>
    <message>
        <source>%1 is not seen in the current</source>
        <translation>%1 ist im Strom nicht zu sehen</translation>
    </message>
    <message>
        <source>step %1 (up)</source>
        <translation>Sprung %1 (hoch)</translation>
    </message>
    <message>
        <source>step %1 (down)</source>
        <translation>Sprung %1 (herunter)</translation>
    </message>
    <message>
        <source>the board does not give %1, and without it nothing bounds its bus</source>
        <translation>das Board gibt %1 nicht her, und ohne das begrenzt nichts seinen Zwischenkreis</translation>
    </message>
    <message>
        <source>the board is at %1 °C, and %2 °C end an experiment: let it cool down first</source>
        <translation>das Board hat %1 °C, und %2 °C beenden einen Versuch: erst abkühlen lassen</translation>
    </message>
    <message>
        <source>it was not over within %1 s</source>
        <translation>es war nach %1 s nicht zu Ende</translation>
    </message>
    <message>
        <source>This board does not record the speed that its main sensor tells.</source>
        <translation>Dieses Board zeichnet die Drehzahl seines Hauptsensors nicht auf.</translation>
    </message>
    <message>
        <source>This board does not record both the current of its motor and what it is to be.</source>
        <translation>Dieses Board zeichnet nicht beides auf, den Strom seines Motors und dessen Sollwert.</translation>
    </message>
    <message>
        <source>This board records %1 signals at a time, and experiments need %2.</source>
        <translation>Dieses Board zeichnet %1 Signale gleichzeitig auf, und Versuche brauchen %2.</translation>
    </message>
    <message>
        <source>samples of %1 s are missing in it: only what is without a gap counts</source>
        <translation>darin fehlen Abtastwerte von %1 s: nur was lückenlos ist, zählt</translation>
    </message>
    <message>
        <source>its samples are %1 ms apart, too far for the response of a speed: %2 ms are the most</source>
        <translation>ihre Abtastwerte liegen %1 ms auseinander, zu weit für den Frequenzgang einer Drehzahl: höchstens %2 ms</translation>
    </message>
    <message>
        <source>its samples are %1 ms apart, too far for the response of a current: %2 ms are the most</source>
        <translation>ihre Abtastwerte liegen %1 ms auseinander, zu weit für den Frequenzgang eines Stroms: höchstens %2 ms</translation>
    </message>
    <message>
        <source>the speed was not read for %1 s</source>
        <translation>die Drehzahl wurde %1 s lang nicht gelesen</translation>
    </message>
    <message>
        <source>the current was not read for %1 s</source>
        <translation>der Strom wurde %1 s lang nicht gelesen</translation>
    </message>
    <message>
        <source>This board does not tell the speed of its motor.</source>
        <translation>Dieses Board meldet die Drehzahl seines Motors nicht.</translation>
    </message>
    <message>
        <source>nothing tells its current in A, so that none could be held against your limit: say what the full scale of its currents is</source>
        <translation>nichts sagt seinen Strom in A, sodass keiner an Ihrer Grenze gemessen werden könnte: die volle Skala seiner Ströme angeben</translation>
    </message>
    <message>
        <source>it is no recording of a motor&apos;s power</source>
        <translation>es ist keine Aufzeichnung der Leistung eines Motors</translation>
    </message>
    <message>
        <source>resistance or dead time is not known: what it takes is not told</source>
        <translation>Widerstand oder Totzeit ist nicht bekannt: was sie nehmen, wird nicht angegeben</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Electrical power</source>
        <translation>Elektrische Leistung</translation>
    </message>
    <message>
        <source>Copper losses</source>
        <translation>Kupferverluste</translation>
    </message>
    <message>
        <source>Shaft power</source>
        <translation>Wellenleistung</translation>
    </message>
    <message>
        <source>Efficiency</source>
        <translation>Wirkungsgrad</translation>
    </message>
    <message>
        <source>the board records nothing: its speed was read once in up to %1 ms, so that rise times are uncertain by as much, and peaks may be higher than is told</source>
        <translation>das Board zeichnet nichts auf: seine Drehzahl wurde nur alle bis zu %1 ms gelesen, sodass Anstiegszeiten um so viel unsicher sind und Spitzen höher sein können als angegeben</translation>
    </message>
    <message>
        <source>%1 of %2 steps rise in less than three times the time between two of their values: nothing is told of them</source>
        <translation>%1 von %2 Sprüngen steigen in weniger als dem Dreifachen der Zeit zwischen zwei ihrer Werte: über sie wird nichts gesagt</translation>
    </message>
    <message>
        <source>An experiment was cut off before it gave back what it had borrowed: %1</source>
        <translation>Ein Versuch wurde abgebrochen, bevor er zurückgab, was er geliehen hatte: %1</translation>
    </message>
    <message>
        <source>the inertia that its two directions tell is %1 % apart: perhaps its load is another one backwards</source>
        <translation>die Trägheiten aus beiden Richtungen liegen %1 % auseinander: vielleicht ist seine Last rückwärts eine andere</translation>
    </message>
    <message>
        <source>a torque of %1 N m is always there and drives it backwards</source>
        <translation>ein Drehmoment von %1 N m ist immer da und treibt ihn rückwärts an</translation>
    </message>
    <message>
        <source>a torque of %1 N m is always there and drives it forwards</source>
        <translation>ein Drehmoment von %1 N m ist immer da und treibt ihn vorwärts an</translation>
    </message>
    <message>
        <source>the motor turns the other way: stop it first</source>
        <translation>der Motor dreht sich andersherum: erst anhalten</translation>
    </message>
    <message>
        <source>it was driven in one of its two directions only</source>
        <translation>er wurde nur in einer seiner beiden Richtungen angetrieben</translation>
    </message>
    <message>
        <source>the motor still turns the other way</source>
        <translation>der Motor dreht sich noch andersherum</translation>
    </message>
    <message>
        <source>this board records nothing by itself: only steps of the speed, inertia and friction are told from values that are read one after the other</source>
        <translation>dieses Board zeichnet selbst nichts auf: nur Drehzahlsprünge, Trägheit und Reibung folgen aus nacheinander gelesenen Werten</translation>
    </message>
    <message>
        <source>this board records nothing by itself: inductances are not told from values that are read one after the other</source>
        <translation>dieses Board zeichnet selbst nichts auf: aus nacheinander gelesenen Werten folgen keine Induktivitäten</translation>
    </message>
    <message>
        <source>nothing tells its current in A, and so no torque: say what the full scale of its currents is</source>
        <translation>nichts sagt seinen Strom in A, also auch kein Drehmoment: geben Sie den Vollausschlag seiner Ströme an</translation>
    </message>
    <message>
        <source>its ramps take %1 s</source>
        <translation>seine Rampen dauern %1 s</translation>
    </message>
    <message>
        <source>nothing tells which torque an ampere makes: it follows from pole pairs and flux of a motor file</source>
        <translation>nichts sagt, welches Drehmoment ein Ampere erzeugt: es folgt aus Polpaarzahl und Fluss einer Motordatei</translation>
    </message>
    <message>
        <source>this board does not tell which pole pairs it counts by</source>
        <translation>dieses Board sagt nicht, mit welcher Polpaarzahl es zählt</translation>
    </message>
    <message>
        <source>an encoder tells this board the turns of its rotor, which say nothing of pole pairs</source>
        <translation>ein Encoder sagt diesem Board die Umdrehungen des Rotors; daraus folgt keine Polpaarzahl</translation>
    </message>
    <message>
        <source>the motor does not turn: let it run at a constant speed</source>
        <translation>der Motor dreht sich nicht: lassen Sie ihn mit gleichbleibender Drehzahl laufen</translation>
    </message>
    <message>
        <source>%1 rpm of the board, which counts by %2 pole pairs, and %3 rpm of the shaft make %4, which is no whole number: read both again, at a constant speed</source>
        <translation>%1 rpm des Boards, das mit %2 Polpaaren zählt, und %3 rpm der Welle ergeben %4, keine ganze Zahl: beide bei gleichbleibender Drehzahl noch einmal ablesen</translation>
    </message>
    <message>
        <source>set-points with every exchange: %1</source>
        <translation>Sollwerte mit jedem Austausch: %1</translation>
    </message>
    <message>
        <source>its board records nothing by itself, and its torques are counted by %1 N m for an ampere, as was given</source>
        <translation>die Karte zeichnet selbst nichts auf, und die Drehmomente sind mit den angegebenen %1 N m je Ampere gerechnet</translation>
    </message>
    <message>
        <source>This board sends its samples once an exchange: this is measured by samples at the rate of its control loop.</source>
        <translation>Diese Karte sendet ihre Messwerte einmal je Austausch: Das wird mit Messwerten im Takt ihrer Regelung gemessen.</translation>
    </message>
    <message>
        <source>this board sends its samples once an exchange: only steps and response of the speed, inertia and friction are told from them</source>
        <translation>diese Karte sendet ihre Messwerte einmal je Austausch: daraus folgen nur Sprünge und Frequenzgang der Drehzahl, Trägheit und Reibung</translation>
    </message>
    <message>
        <source>this drive does not send its speed, its current and what they are to be</source>
        <translation>dieser Antrieb sendet nicht Drehzahl, Strom und was sie sein sollen</translation>
    </message>
    <message>
        <source>the motor turns, and its set-points can begin to leave with every exchange only while it rests: stop it first</source>
        <translation>der Motor dreht sich, und nur im Stillstand kann damit begonnen werden, dass Sollwerte mit jedem Austausch gehen: Halten Sie ihn zuerst an</translation>
    </message>
    <message>
        <source>set-points leave with every exchange still</source>
        <translation>Sollwerte gehen immer noch mit jedem Austausch</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>Torque of the load</source>
        <translation>Drehmoment der Last</translation>
    </message>
    <message>
        <source>The speed gives way by</source>
        <translation>Die Drehzahl gibt nach um</translation>
    </message>
    <message>
        <source>For each ampere by</source>
        <translation>Je Ampere um</translation>
    </message>
    <message>
        <source>Back within</source>
        <translation>Zurück nach</translation>
    </message>
    <message>
        <source>Peak Iq</source>
        <translation>Spitze Iq</translation>
    </message>
    <message>
        <source>it takes 2 to 30 s</source>
        <translation>es dauert 2 bis 30 s</translation>
    </message>
    <message>
        <source>it is no recording of a load that changes</source>
        <translation>es ist keine Aufzeichnung einer wechselnden Last</translation>
    </message>
    <message>
        <source>no load came or went while the speed was held: nothing moved it out of its noise</source>
        <translation>keine Last kam oder ging, während die Drehzahl gehalten wurde: nichts bewegte sie aus ihrem Rauschen</translation>
    </message>
    <message>
        <source>the load came %1 times and went %2 times</source>
        <translation>die Last kam %1-mal und ging %2-mal</translation>
    </message>
    <message>
        <source>for %1 % of the time no exchange came for 5 ms or longer: straight lines stand there</source>
        <translation>für %1 % der Zeit kam 5 ms oder länger kein Austausch: dort stehen gerade Linien</translation>
    </message>
    <message>
        <source>the motor is in position control now, it was in speed control</source>
        <translation>der Motor ist jetzt in Positionsregelung, er war in Drehzahlregelung</translation>
    </message>
    <message>
        <source>the motor may be in position control now, it was in speed control</source>
        <translation>der Motor ist jetzt vielleicht in Positionsregelung, er war in Drehzahlregelung</translation>
    </message>
    <message>
        <source>this board does not control the position of its shaft</source>
        <translation>dieses Board regelt die Position ihrer Welle nicht</translation>
    </message>
    <message>
        <source>a shaft is moved by 1 to 3600 degrees</source>
        <translation>eine Welle wird um 1 bis 3600 Grad bewegt</translation>
    </message>
    <message>
        <source>a move takes 1 ms to 10 s</source>
        <translation>eine Bewegung dauert 1 ms bis 10 s</translation>
    </message>
    <message>
        <source>a position is held for 100 ms to 10 s</source>
        <translation>eine Position wird 100 ms bis 10 s gehalten</translation>
    </message>
    <message>
        <source>it is no recording of moves of a shaft</source>
        <translation>es ist keine Aufnahme von Bewegungen einer Welle</translation>
    </message>
    <message>
        <source>%1 was cut short: nothing is told of its position</source>
        <translation>%1 wurde abgebrochen: von seiner Position wird nichts genannt</translation>
    </message>
    <message>
        <source>%1 of %2 steps do not settle while their position is held</source>
        <translation>%1 von %2 Sprüngen regeln nicht aus, solange ihre Position gehalten wird</translation>
    </message>
    <message>
        <source>samples are missing in %1: nothing is told of its position</source>
        <translation>in %1 fehlen Messwerte: von der Position wird nichts gesagt</translation>
    </message>
    <message>
        <source>%1 is not seen in the position</source>
        <translation>%1 ist in der Position nicht zu sehen</translation>
    </message>
    <message>
        <source>%1 does not settle while its position is held</source>
        <translation>%1 regelt nicht aus, solange die Position gehalten wird</translation>
    </message>
    <message>
        <source>a speed is no number</source>
        <translation>eine Drehzahl ist keine Zahl</translation>
    </message>
    <message>
        <source>a current is no number</source>
        <translation>ein Strom ist keine Zahl</translation>
    </message>
    <message>
        <source>set-points may leave with every exchange now</source>
        <translation>Sollwerte gehen jetzt vielleicht mit jedem Austausch</translation>
    </message>
    <message>
        <source>the load changed, and the speed did not come back before the end, or before it went again</source>
        <translation>die Last änderte sich, und die Drehzahl kam vor dem Ende, oder bevor sie wieder ging, nicht zurück</translation>
    </message>
    <message>
        <source>a change of the load was not over at the end, or where samples are missing: it does not count</source>
        <translation>eine Änderung der Last war am Ende, oder wo Messwerte fehlen, nicht vorbei: sie zählt nicht</translation>
    </message>
    <message>
        <source>a load came and went before the speed was back: it does not count</source>
        <translation>eine Last kam und ging, bevor die Drehzahl zurück war: sie zählt nicht</translation>
    </message>
    <message>
        <source>the shaft moved by %1 degrees instead of %2 at the worst</source>
        <translation>die Welle bewegte sich im schlechtesten Fall um %1 Grad statt um %2</translation>
    </message>
    <message>
        <source>the shaft does not come to rest without a current</source>
        <translation>die Welle kommt ohne Strom nicht zur Ruhe</translation>
    </message>
    <message>
        <source>the board does not tell where its shaft is</source>
        <translation>das Board sagt nicht, wo seine Welle steht</translation>
    </message>
    <message>
        <source>the shaft is too far from where the board was switched on, and positions count from there: switch the board off and on</source>
        <translation>die Welle ist zu weit von der Stelle, an der das Board eingeschaltet wurde, und Positionen zählen von dort: Board aus- und wieder einschalten</translation>
    </message>
</context>
<context>
    <name>Laid</name>
    <message>
        <source>its beginning</source>
        <comment>of a recording</comment>
        <translation>ihr Anfang</translation>
    </message>
    <message>
        <source>None of the signals on the scope is in %1.</source>
        <comment>a file</comment>
        <translation>Keines der Signale auf dem Oszilloskop ist in %1.</translation>
    </message>
    <message>
        <source>%1 is reference %2, with %3 of the %4 signals on the scope.</source>
        <comment>file, A or B, numbers</comment>
        <translation>%1 ist Referenz %2, mit %3 der %4 Signale auf dem Oszilloskop.</translation>
    </message>
    <message>
        <source>At the trigger lies: %1.</source>
        <comment>a moment of a file</comment>
        <translation>Am Trigger liegt: %1.</translation>
    </message>
    <message>
        <source>At the left edge lies: %1.</source>
        <comment>a moment of a file</comment>
        <translation>Am linken Rand liegt: %1.</translation>
    </message>
    <message>
        <source>Reference %1 is again the one before.</source>
        <comment>a letter</comment>
        <translation>Referenz %1 ist wieder die vorige.</translation>
    </message>
    <message>
        <source>There was a reference %1 already. It is replaced; %2 brings it back.</source>
        <comment>a letter, a key</comment>
        <translation>Eine Referenz %1 gab es schon. Sie ist ersetzt; %2 holt sie zurück.</translation>
    </message>
</context>
<context>
    <name>Link</name>
    <message>
        <source>The port is open but no board answers. Check the baud rate, the cable and the board&apos;s power.</source>
        <translation>Die Schnittstelle ist offen, aber kein Board antwortet. Prüfen Sie Baudrate, Kabel und Versorgung des Boards.</translation>
    </message>
    <message>
        <source>Bytes arrive but make no sense. The baud rate or the protocol is probably not the board&apos;s: try another one, and check the board&apos;s firmware.</source>
        <translation>Es kommen Bytes an, aber sie ergeben keinen Sinn. Die Baudrate oder das Protokoll ist vermutlich nicht das des Boards: Versuchen Sie ein anderes und prüfen Sie die Firmware des Boards.</translation>
    </message>
    <message>
        <source>The board answers but does not agree on the settings of the link. Reset the board and connect again.</source>
        <translation>Das Board antwortet, einigt sich aber nicht auf die Einstellungen der Verbindung. Setzen Sie das Board zurück und verbinden Sie erneut.</translation>
    </message>
    <message>
        <source>The board went silent. Check the cable and the board&apos;s power.</source>
        <translation>Das Board ist verstummt. Prüfen Sie Kabel und Versorgung des Boards.</translation>
    </message>
    <message>
        <source>Contact to the board could not be restored. Check the cable and the board&apos;s power, reset the board and connect again.</source>
        <translation>Der Kontakt zum Board ließ sich nicht wiederherstellen. Prüfen Sie Kabel und Versorgung des Boards, setzen Sie das Board zurück und verbinden Sie erneut.</translation>
    </message>
    <message>
        <source>The board was reset.</source>
        <translation>Das Board wurde zurückgesetzt.</translation>
    </message>
    <message>
        <source>The board speaks the protocol of older firmware.</source>
        <translation>Das Board spricht das Protokoll älterer Firmware.</translation>
    </message>
    <message>
        <source>The drive does not say that it is ready. Check its power and the ready line.</source>
        <translation>Der Antrieb meldet nicht, dass er bereit ist. Bitte Versorgung und Bereit-Leitung prüfen.</translation>
    </message>
    <message>
        <source>Nothing drives the line to this computer. Check the wiring, the chip select and the drive&apos;s power.</source>
        <translation>Nichts treibt die Leitung zu diesem Rechner. Bitte Verdrahtung, Chip-Select und Versorgung des Antriebs prüfen.</translation>
    </message>
    <message>
        <source>Asking whether the board speaks the protocol of newer firmware; if no answer comes, that of older firmware is next.</source>
        <translation>Gefragt wird im Protokoll neuerer Firmware; ohne Antwort danach in dem älterer.</translation>
    </message>
    <message>
        <source>No answer in the protocol of newer firmware: asking in that of older firmware.</source>
        <translation>Keine Antwort im Protokoll neuerer Firmware: Gefragt wird in dem älterer.</translation>
    </message>
    <message>
        <source>The board speaks the protocol of newer firmware.</source>
        <translation>Das Board spricht das Protokoll neuerer Firmware.</translation>
    </message>
    <message>
        <source>There is no port %1. Plug the board in, or choose another port.</source>
        <translation>Es gibt keine Schnittstelle %1. Schließen Sie das Board an oder wählen Sie eine andere Schnittstelle.</translation>
    </message>
    <message>
        <source>%1 is in use%2. Close what uses it, then connect again.</source>
        <translation>%1 wird benutzt%2. Schließen Sie, was sie benutzt, und verbinden Sie dann erneut.</translation>
    </message>
    <message>
        <source>%1 refuses this baud rate. Choose another one.</source>
        <translation>%1 lehnt diese Baudrate ab. Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>%1 was unplugged. Check the cable.</source>
        <translation>%1 wurde abgezogen. Prüfen Sie das Kabel.</translation>
    </message>
    <message>
        <source>This program did not run for a while. Its guardian has told every motor on %1 to stop, without evidence that they did.</source>
        <translation>Dieses Programm lief eine Weile nicht. Sein Wächter hat jedem Motor an %1 befohlen anzuhalten; dass sie es taten, ist nicht belegt.</translation>
    </message>
    <message>
        <source>The recording %1 cannot be read. Choose another file.</source>
        <translation>Die Aufzeichnung %1 kann nicht gelesen werden. Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>%1 cannot be opened%2. Check the cable, then connect again.</source>
        <translation>%1 kann nicht geöffnet werden%2. Prüfen Sie das Kabel und verbinden Sie dann erneut.</translation>
    </message>
    <message>
        <source>You may not use %1. Join the group that owns it (serial ports: &quot;sudo usermod -aG dialout $USER&quot;), then log out and in again.</source>
        <translation>Sie dürfen %1 nicht benutzen. Treten Sie der Gruppe bei, der es gehört (serielle Schnittstellen: „sudo usermod -aG dialout $USER“), melden Sie sich dann ab und wieder an.</translation>
    </message>
</context>
<context>
    <name>Measures</name>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>The smallest sample</source>
        <translation>Der kleinste Messwert</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>The largest sample</source>
        <translation>Der größte Messwert</translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation>Spitze-Spitze</translation>
    </message>
    <message>
        <source>Maximum minus minimum</source>
        <translation>Maximum minus Minimum</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>The mean of all samples</source>
        <translation>Der Mittelwert aller Messwerte</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Effektivwert</translation>
    </message>
    <message>
        <source>The root of the mean square of all samples</source>
        <translation>Die Wurzel aus dem Mittel der Quadrate aller Messwerte</translation>
    </message>
    <message>
        <source>Cycle mean</source>
        <translation>Periodenmittel</translation>
    </message>
    <message>
        <source>The mean over whole periods</source>
        <translation>Der Mittelwert über ganze Perioden</translation>
    </message>
    <message>
        <source>Cycle RMS</source>
        <translation>Perioden-Effektivwert</translation>
    </message>
    <message>
        <source>The RMS over whole periods</source>
        <translation>Der Effektivwert über ganze Perioden</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Of whole periods, between upward crossings of the middle</source>
        <translation>Ganzer Perioden, zwischen steigenden Durchgängen durch die Mitte</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>The mean of whole periods</source>
        <translation>Das Mittel ganzer Perioden</translation>
    </message>
    <message>
        <source>Duty</source>
        <translation>Tastgrad</translation>
    </message>
    <message>
        <source>Share of a period above the middle level</source>
        <translation>Anteil einer Periode über dem mittleren Pegel</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>Anstiegszeit</translation>
    </message>
    <message>
        <source>10 to 90 % of the first complete upward edge</source>
        <translation>10 bis 90 % der ersten vollständigen steigenden Flanke</translation>
    </message>
    <message>
        <source>Fall time</source>
        <translation>Abfallzeit</translation>
    </message>
    <message>
        <source>90 to 10 % of the first complete downward edge</source>
        <translation>90 bis 10 % der ersten vollständigen fallenden Flanke</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>Past the final value, in percent of the step</source>
        <translation>Über den Endwert hinaus, in Prozent des Sprungs</translation>
    </message>
    <message>
        <source>Undershoot</source>
        <translation>Unterschwingen</translation>
    </message>
    <message>
        <source>To the wrong side of the initial value, in percent of the step</source>
        <translation>Auf der falschen Seite des Anfangswerts, in Prozent des Sprungs</translation>
    </message>
    <message>
        <source>Peak time</source>
        <translation>Zeit bis zum Scheitel</translation>
    </message>
    <message>
        <source>From the step to the largest deviation</source>
        <translation>Vom Sprung bis zur größten Abweichung</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Ausregelzeit</translation>
    </message>
    <message>
        <source>From the step to the last entry into 2 % of the step around the final value, which is the mean of the last 20 %</source>
        <translation>Vom Sprung bis zum letzten Eintritt in 2 % des Sprungs um den Endwert, das Mittel der letzten 20 %</translation>
    </message>
    <message>
        <source>Dead time</source>
        <translation>Totzeit</translation>
    </message>
    <message>
        <source>From the step to 5 % of it</source>
        <translation>Vom Sprung bis zu 5 % davon</translation>
    </message>
    <message>
        <source>Ripple</source>
        <translation>Welligkeit</translation>
    </message>
    <message>
        <source>Peak to peak once settled</source>
        <translation>Spitze-Spitze im eingeschwungenen Zustand</translation>
    </message>
    <message>
        <source>Ripple RMS</source>
        <translation>Welligkeit (effektiv)</translation>
    </message>
    <message>
        <source>RMS around the mean once settled</source>
        <translation>Effektivwert um das Mittel im eingeschwungenen Zustand</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>By how much the second trace is ahead of the first</source>
        <translation>Um wie viel die zweite Kurve der ersten voraus ist</translation>
    </message>
    <message>
        <source>no samples</source>
        <translation>keine Messwerte</translation>
    </message>
    <message>
        <source>samples are missing inside</source>
        <translation>darin fehlen Messwerte</translation>
    </message>
    <message>
        <source>no full period</source>
        <translation>keine ganze Periode</translation>
    </message>
    <message>
        <source>no complete edge</source>
        <translation>keine vollständige Flanke</translation>
    </message>
    <message>
        <source>no step</source>
        <translation>kein Sprung</translation>
    </message>
    <message>
        <source>not settled</source>
        <translation>nicht eingeschwungen</translation>
    </message>
    <message>
        <source>no set-point given</source>
        <translation>kein Sollwert angegeben</translation>
    </message>
    <message>
        <source>not the same frequency</source>
        <translation>nicht dieselbe Frequenz</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>verbindet</translation>
    </message>
    <message>
        <source>board answering</source>
        <translation>Board antwortet</translation>
    </message>
    <message>
        <source>board silent</source>
        <translation>Board schweigt</translation>
    </message>
    <message>
        <source>recovering</source>
        <translation>stellt wieder her</translation>
    </message>
    <message>
        <source>link lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>not sent</source>
        <translation>nicht gesendet</translation>
    </message>
    <message>
        <source>sent, but the answer was lost</source>
        <translation>gesendet, aber die Antwort ging verloren</translation>
    </message>
    <message>
        <source>refused by this program</source>
        <translation>von diesem Programm abgelehnt</translation>
    </message>
    <message>
        <source>refused by the board</source>
        <translation>vom Board abgelehnt</translation>
    </message>
    <message>
        <source>Unknown</source>
        <comment>state of a motor</comment>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>Idle</source>
        <comment>state of a motor</comment>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>Starting</source>
        <comment>state of a motor</comment>
        <translation>Anlauf</translation>
    </message>
    <message>
        <source>Running</source>
        <comment>state of a motor</comment>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Stopping</source>
        <comment>state of a motor</comment>
        <translation>Stoppt</translation>
    </message>
    <message>
        <source>Fault present</source>
        <comment>state of a motor</comment>
        <translation>Fehler liegt an</translation>
    </message>
    <message>
        <source>stop requested</source>
        <translation>Stopp angefordert</translation>
    </message>
    <message>
        <source>accepted</source>
        <comment>the board accepted the stop</comment>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>drive idle</source>
        <translation>Antrieb in Ruhe</translation>
    </message>
    <message>
        <source>standstill measured</source>
        <translation>Stillstand gemessen</translation>
    </message>
    <message>
        <source>not confirmed</source>
        <translation>nicht bestätigt</translation>
    </message>
    <message>
        <source>Stop NOT confirmed. Use the hardware stop.</source>
        <translation>Stopp NICHT bestätigt. Benutzen Sie den Hardware-Stopp.</translation>
    </message>
    <message>
        <source>beyond your own limit of %1 rpm</source>
        <translation>jenseits Ihrer eigenen Grenze von %1 rpm</translation>
    </message>
    <message>
        <source>beyond your own limit of %1 A</source>
        <translation>jenseits Ihrer eigenen Grenze von %1 A</translation>
    </message>
    <message>
        <source>beyond the limit of %1 rpm</source>
        <translation>jenseits der Grenze von %1 rpm</translation>
    </message>
    <message>
        <source>beyond the limit of %1 A</source>
        <translation>jenseits der Grenze von %1 A</translation>
    </message>
    <message>
        <source>%1 is beyond your own limit of %2 rpm</source>
        <translation>%1 ist jenseits Ihrer eigenen Grenze von %2 rpm</translation>
    </message>
    <message>
        <source>%1 is beyond your own limit of %2 A</source>
        <translation>%1 ist jenseits Ihrer eigenen Grenze von %2 A</translation>
    </message>
    <message>
        <source>%1 is beyond the limit of %2 rpm</source>
        <translation>%1 ist jenseits der Grenze von %2 rpm</translation>
    </message>
    <message>
        <source>%1 is beyond the limit of %2 A</source>
        <translation>%1 ist jenseits der Grenze von %2 A</translation>
    </message>
    <message>
        <source>the speed on the way is beyond your own limit of %1 rpm</source>
        <translation>die Drehzahl auf dem Weg ist jenseits Ihrer eigenen Grenze von %1 rpm</translation>
    </message>
    <message>
        <source>the speed on the way is beyond the limit of %1 rpm</source>
        <translation>die Drehzahl auf dem Weg ist jenseits der Grenze von %1 rpm</translation>
    </message>
    <message>
        <source>%1 is on, and then no limit of your own holds: turn it off first</source>
        <translation>%1 ist an, und dann gilt keine Ihrer eigenen Grenzen: erst ausschalten</translation>
    </message>
    <message>
        <source>in this control mode no limit of your own holds: take yours away first</source>
        <translation>in dieser Regelungsart gilt keine Ihrer eigenen Grenzen: erst diese wegnehmen</translation>
    </message>
    <message>
        <source>in torque control nothing keeps the speed within your own limit of %1 rpm: take that limit away first</source>
        <translation>in der Drehmomentregelung hält nichts die Drehzahl in Ihrer eigenen Grenze von %1 rpm: erst diese Grenze wegnehmen</translation>
    </message>
    <message>
        <source>the fault is still present; remove its cause first</source>
        <translation>der Fehler liegt noch vor; erst seine Ursache beseitigen</translation>
    </message>
    <message>
        <source>no answer about what it would start to</source>
        <translation>keine Antwort darauf, wohin der Start ginge</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>not armed</source>
        <translation>nicht freigegeben</translation>
    </message>
    <message>
        <source>stopped; arm again first</source>
        <translation>gestoppt; erst wieder freigeben</translation>
    </message>
    <message>
        <source>too late: it was asked for more than half a second ago</source>
        <translation>zu spät: es wurde vor mehr als einer halben Sekunde verlangt</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>action: how it ended</comment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1: %2 (%3).</source>
        <comment>action: how it ended (the board&apos;s word)</comment>
        <translation>%1: %2 (%3).</translation>
    </message>
    <message>
        <source>The export was cancelled; no file was written.</source>
        <translation>Der Export wurde abgebrochen; es wurde keine Datei geschrieben.</translation>
    </message>
    <message>
        <source>%1 is not a file. Choose another name.</source>
        <translation>%1 ist keine Datei. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1 cannot be written (%2). Choose another folder.</source>
        <translation>%1 kann nicht geschrieben werden (%2). Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>%1 cannot be replaced (%2). Choose another name.</source>
        <translation>%1 kann nicht ersetzt werden (%2). Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>It is the first start since the board was connected or stopped.</source>
        <translation>Es ist der erste Start, seit das Board verbunden oder gestoppt wurde.</translation>
    </message>
    <message>
        <source>The set-point moves by more than 20 % of the limit of %1.</source>
        <translation>Der Sollwert ändert sich um mehr als 20 % der Grenze von %1.</translation>
    </message>
    <message>
        <source>It is not known from where the set-point moves.</source>
        <translation>Von wo sich der Sollwert ändert, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>It acts against the way the motor turns now (%1).</source>
        <comment>speed</comment>
        <translation>Es wirkt gegen die jetzige Drehrichtung des Motors (%1).</translation>
    </message>
    <message>
        <source>In torque control nothing keeps the speed within your own limit.</source>
        <translation>In der Drehmomentregelung hält nichts die Drehzahl innerhalb Ihrer eigenen Grenze.</translation>
    </message>
    <message>
        <source>The control changes between speed and torque while the motor runs.</source>
        <translation>Die Regelung wechselt zwischen Drehzahl und Drehmoment, während der Motor läuft.</translation>
    </message>
    <message>
        <source>It is not known whether its speed or its torque is controlled.</source>
        <translation>Ob seine Drehzahl oder sein Drehmoment geregelt wird, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>It ends the experiment that is running; where nothing else bounds the motor, as in torque control, every motor is stopped instead.</source>
        <translation>Es beendet den laufenden Versuch; wo nichts anderes den Motor in Grenzen hält, wie in der Drehmomentregelung, wird stattdessen jeder Motor gestoppt.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Own limits</source>
        <translation>Eigene Grenzen</translation>
    </message>
    <message>
        <source>Expert mode</source>
        <translation>Expertenmodus</translation>
    </message>
    <message>
        <source>Start</source>
        <comment>of a motor</comment>
        <translation>Start</translation>
    </message>
    <message>
        <source>Stop motors</source>
        <translation>Motoren stoppen</translation>
    </message>
    <message>
        <source>Stop one motor</source>
        <translation>Einen Motor stoppen</translation>
    </message>
    <message>
        <source>Stop ramp</source>
        <translation>Rampe anhalten</translation>
    </message>
    <message>
        <source>Acknowledge faults</source>
        <translation>Fehler quittieren</translation>
    </message>
    <message>
        <source>Speed ramp</source>
        <translation>Drehzahlrampe</translation>
    </message>
    <message>
        <source>Torque ramp</source>
        <translation>Drehmomentrampe</translation>
    </message>
    <message>
        <source>Current reference</source>
        <translation>Stromsollwert</translation>
    </message>
    <message>
        <source>Write</source>
        <comment>a register that can move something</comment>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>user</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>command line</source>
        <translation>Kommandozeile</translation>
    </message>
    <message>
        <source>script</source>
        <translation>Skript</translation>
    </message>
    <message>
        <source>greatest speed</source>
        <translation>höchste Drehzahl</translation>
    </message>
    <message>
        <source>greatest current</source>
        <translation>höchster Strom</translation>
    </message>
    <message>
        <source>nominal current</source>
        <translation>Nennstrom</translation>
    </message>
    <message>
        <source>The shaft goes to an angle by itself, and is held there.</source>
        <translation>Die Welle fährt von selbst zu einem Winkel und wird dort gehalten.</translation>
    </message>
    <message>
        <source>Position ramp</source>
        <translation>Positionsrampe</translation>
    </message>
    <message>
        <source>Current scale</source>
        <comment>a person says it</comment>
        <translation>Stromskala</translation>
    </message>
    <message>
        <source>All motors were told to stop. Look at them, then arm again.</source>
        <translation>Alle Motoren haben den Befehl zum Stopp bekommen. Sehen Sie nach ihnen, dann geben Sie wieder frei.</translation>
    </message>
    <message>
        <source>It was disarmed; the motors go on as they are.</source>
        <translation>Die Freigabe wurde aufgehoben; die Motoren laufen weiter wie zuvor.</translation>
    </message>
    <message>
        <source>This window stood still for %1 s.</source>
        <translation>Dieses Fenster stand %1 s lang still.</translation>
    </message>
    <message>
        <source>This program or the computer stood still for %1 s.</source>
        <translation>Dieses Programm oder der Rechner stand %1 s lang still.</translation>
    </message>
    <message>
        <source>The jog was ended: this window stood still while it was held.</source>
        <translation>Das Tippen wurde beendet: Das Fenster stand still, während gehalten wurde.</translation>
    </message>
    <message>
        <source>Not armed: it was asked for while this window stood still. Arm again.</source>
        <translation>Nicht freigegeben: Es wurde verlangt, während dieses Fenster stillstand. Geben Sie noch einmal frei.</translation>
    </message>
    <message>
        <source>speed not measurable: the rotor may coast</source>
        <translation>Drehzahl nicht messbar: der Rotor läuft vielleicht aus</translation>
    </message>
    <message>
        <source>Fault latched</source>
        <comment>state of a motor; acknowledge to go on</comment>
        <translation>Fehler gespeichert</translation>
    </message>
    <message>
        <source>no board found</source>
        <translation>kein Board gefunden</translation>
    </message>
    <message>
        <source>Not written: %1. Make room or choose another folder; nothing was replaced.</source>
        <translation>Nicht geschrieben: %1. Platz schaffen oder anderen Ordner wählen; nichts wurde ersetzt.</translation>
    </message>
    <message>
        <source>No motor was driven when the board was last heard.</source>
        <translation>Kein Motor war angetrieben, als das Board zuletzt antwortete.</translation>
    </message>
    <message>
        <source>The motor may still be turning; the drive is to stop it by itself after %1 ms.</source>
        <translation>Der Motor dreht vielleicht noch; der Antrieb soll ihn nach %1 ms selbst anhalten.</translation>
    </message>
    <message>
        <source>The motor may still be turning (this drive has no communication time-out).</source>
        <translation>Der Motor dreht vielleicht noch (dieser Antrieb hat keine Zeitüberwachung der Kommunikation).</translation>
    </message>
    <message>
        <source>It is connected again; arm it before you go on.</source>
        <translation>Es ist wieder verbunden; geben Sie es frei, bevor Sie weitermachen.</translation>
    </message>
    <message>
        <source>Choose that one, or Auto, and connect again.</source>
        <translation>Wählen Sie dieses oder „Auto“ und verbinden Sie neu.</translation>
    </message>
    <message>
        <source>Rotorscope reconnects; arm again to move.</source>
        <translation>Rotorscope verbindet sich neu; zum Bewegen erneut freigeben.</translation>
    </message>
    <message>
        <source>in torque control this board does not tell to which current a start goes; take your own limit of current away first</source>
        <translation>bei Drehmomentregelung meldet dieses Board nicht, auf welchen Strom ein Start geht; zuerst die eigene Stromgrenze wegnehmen</translation>
    </message>
    <message>
        <source>beyond the %1 rpm that this protocol can hold</source>
        <translation>jenseits der %1 rpm, die dieses Protokoll fasst</translation>
    </message>
    <message>
        <source>beyond what 16 bits hold</source>
        <translation>jenseits dessen, was 16 Bit fassen</translation>
    </message>
    <message>
        <source>the scale of motor %1 is not known</source>
        <translation>die Skalierung von Motor %1 ist nicht bekannt</translation>
    </message>
    <message>
        <source>the board does not tell where the shaft is</source>
        <translation>das Board meldet nicht, wo die Welle steht</translation>
    </message>
    <message>
        <source>the limits have changed</source>
        <translation>die Grenzen haben sich geändert</translation>
    </message>
    <message>
        <source>too many wishes wait already</source>
        <translation>es warten schon zu viele Aufträge</translation>
    </message>
    <message>
        <source>a register of it is lent to an experiment until that ends</source>
        <translation>ein Register davon ist bis zu dessen Ende an einen Versuch verliehen</translation>
    </message>
</context>
<context>
    <name>Motion</name>
    <message>
        <source>Connect to a board first.</source>
        <translation>Verbinden Sie zuerst ein Board.</translation>
    </message>
    <message>
        <source>Arm first.</source>
        <translation>Geben Sie zuerst frei.</translation>
    </message>
    <message>
        <source>Acknowledge the faults first.</source>
        <translation>Quittieren Sie zuerst die Fehler.</translation>
    </message>
    <message>
        <source>The motor has to be idle.</source>
        <translation>Der Motor muss in Ruhe sein.</translation>
    </message>
    <message>
        <source>The fault is still present: remove its cause first.</source>
        <translation>Der Fehler liegt noch an: Beseitigen Sie zuerst seine Ursache.</translation>
    </message>
    <message>
        <source>There is no fault to acknowledge.</source>
        <translation>Es gibt keinen Fehler zu quittieren.</translation>
    </message>
</context>
<context>
    <name>MotionQuestion</name>
    <message>
        <source>This will move motor %1. Go on?</source>
        <translation>Dies bewegt Motor %1. Fortfahren?</translation>
    </message>
    <message>
        <source>Expert mode</source>
        <translation>Expertenmodus</translation>
    </message>
    <message>
        <source>The board does not tell all limits of motor %1.</source>
        <translation>Das Board nennt nicht alle Grenzen von Motor %1.</translation>
    </message>
    <message>
        <source>Not known: %1</source>
        <comment>list of limits</comment>
        <translation>Nicht bekannt: %1</translation>
    </message>
    <message>
        <source>Until the connection ends, set-points of this motor are bounded only by what is known and by your own limits.</source>
        <translation>Bis die Verbindung endet, begrenzen nur das Bekannte und Ihre eigenen Grenzen die Sollwerte dieses Motors.</translation>
    </message>
    <message>
        <source>motor %1</source>
        <comment>to be typed</comment>
        <translation>Motor %1</translation>
    </message>
</context>
<context>
    <name>Motor</name>
    <message>
        <source>Pole pairs</source>
        <translation>Polpaare</translation>
    </message>
    <message>
        <source>Electrical turns for each turn of the shaft.</source>
        <translation>Elektrische Umdrehungen je Umdrehung der Welle.</translation>
    </message>
    <message>
        <source>Rated flux</source>
        <translation>Nennfluss</translation>
    </message>
    <message>
        <source>Strength of the magnets, as the board has it: Ke (V rms between two terminals at 1000 rpm) in standard firmware, V/Hz in HSO firmware. Which of both is judged by the flux that it makes.</source>
        <translation>Stärke der Magnete, wie das Board sie hat: Ke (V effektiv zwischen zwei Klemmen bei 1000 rpm) in Standard-Firmware, V/Hz in HSO-Firmware. Welches von beiden, wird am Fluss erkannt, der daraus folgt.</translation>
    </message>
    <message>
        <source>Resistance Rs</source>
        <translation>Widerstand Rs</translation>
    </message>
    <message>
        <source>Of one phase: half of what is measured between two terminals.</source>
        <translation>Einer Phase: die Hälfte dessen, was zwischen zwei Klemmen gemessen wird.</translation>
    </message>
    <message>
        <source>Skin factor</source>
        <translation>Skin-Faktor</translation>
    </message>
    <message>
        <source>0 in standard firmware: not used.</source>
        <translation>0 in Standard-Firmware: wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Inductance Lq</source>
        <translation>Induktivität Lq</translation>
    </message>
    <message>
        <source>Across the magnets, of one phase.</source>
        <translation>Quer zu den Magneten, einer Phase.</translation>
    </message>
    <message>
        <source>Inductance Ld</source>
        <translation>Induktivität Ld</translation>
    </message>
    <message>
        <source>Along the magnets, of one phase. Smaller than Lq where the magnets are buried.</source>
        <translation>Längs der Magnete, einer Phase. Kleiner als Lq, wo die Magnete vergraben sind.</translation>
    </message>
    <message>
        <source>Motor current</source>
        <translation>Motorstrom</translation>
    </message>
    <message>
        <source>The motor&apos;s greatest current, peak.</source>
        <translation>Größter Strom des Motors, Scheitelwert.</translation>
    </message>
    <message>
        <source>Copper mass</source>
        <translation>Kupfermasse</translation>
    </message>
    <message>
        <source>Cooling time constant</source>
        <translation>Abkühl-Zeitkonstante</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Greatest speed</source>
        <translation>Größte Drehzahl</translation>
    </message>
    <message>
        <source>No speed set-point goes beyond it.</source>
        <translation>Kein Drehzahl-Sollwert geht darüber hinaus.</translation>
    </message>
    <message>
        <source>Greatest readable current</source>
        <translation>Größter messbarer Strom</translation>
    </message>
    <message>
        <source>The end of the current converters&apos; range; more is not seen and not controlled.</source>
        <translation>Das Ende des Messbereichs; mehr wird nicht gesehen und nicht geregelt.</translation>
    </message>
    <message>
        <source>Nominal current</source>
        <translation>Nennstrom</translation>
    </message>
    <message>
        <source>No current set-point goes beyond it.</source>
        <translation>Kein Strom-Sollwert geht darüber hinaus.</translation>
    </message>
    <message>
        <source>Nominal bus voltage</source>
        <translation>Nennspannung</translation>
    </message>
    <message>
        <source>What gains and the voltage scale were made for.</source>
        <translation>Wofür Verstärkungen und Spannungsskala gemacht sind.</translation>
    </message>
    <message>
        <source>Drive type</source>
        <translation>Antriebsart</translation>
    </message>
    <message>
        <source>Main speed sensor</source>
        <translation>Haupt-Drehzahlgeber</translation>
    </message>
    <message>
        <source>Auxiliary speed sensor</source>
        <translation>Zweiter Drehzahlgeber</translation>
    </message>
    <message>
        <source>Current sensing</source>
        <translation>Strommessung</translation>
    </message>
    <message>
        <source>PWM periods a control period</source>
        <translation>PWM-Perioden je Regelperiode</translation>
    </message>
    <message>
        <source>Switching frequency (PWM)</source>
        <translation>Schaltfrequenz (PWM)</translation>
    </message>
    <message>
        <source>Speed loop rate</source>
        <translation>Takt des Drehzahlreglers</translation>
    </message>
    <message>
        <source>Built with</source>
        <translation>Gebaut mit</translation>
    </message>
    <message>
        <source>Built with, too</source>
        <translation>Auch gebaut mit</translation>
    </message>
    <message>
        <source>Drive mode</source>
        <translation>Betriebsart</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>What one digit of a phase voltage is worth.</source>
        <translation>Was ein Digit einer Phasenspannung wert ist.</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>What one digit of a current is worth.</source>
        <translation>Was ein Digit eines Stroms wert ist.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>What one digit of a speed is worth.</source>
        <translation>Was ein Digit einer Drehzahl wert ist.</translation>
    </message>
    <message>
        <source>Firmware version</source>
        <translation>Firmware-Version</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>Streams over</source>
        <translation>Überträgt über</translation>
    </message>
    <message>
        <source>Signals at once, UART A</source>
        <translation>Signale zugleich, UART A</translation>
    </message>
    <message>
        <source>Signals at once, UART B</source>
        <translation>Signale zugleich, UART B</translation>
    </message>
    <message>
        <source>Signals at once, ST-LINK</source>
        <translation>Signale zugleich, ST-LINK</translation>
    </message>
    <message>
        <source>It takes true or false.</source>
        <translation>Dort steht true oder false.</translation>
    </message>
    <message>
        <source>It takes a text of at most %1 bytes.</source>
        <translation>Dort steht ein Text von höchstens %1 Bytes.</translation>
    </message>
    <message>
        <source>It takes a whole number from %1 to %2.</source>
        <translation>Dort steht eine ganze Zahl von %1 bis %2.</translation>
    </message>
    <message>
        <source>It takes a number from %1 to %2.</source>
        <translation>Dort steht eine Zahl von %1 bis %2.</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Limits of the drive</source>
        <translation>Grenzen des Antriebs</translation>
    </message>
    <message>
        <source>Control firmware</source>
        <translation>Regelung</translation>
    </message>
    <message>
        <source>Scales</source>
        <translation>Skalen</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Board</translation>
    </message>
    <message>
        <source>Flux of the magnets</source>
        <translation>Fluss der Magnete</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Trägheitsmoment</translation>
    </message>
    <message>
        <source>Viscous friction</source>
        <translation>Viskose Reibung</translation>
    </message>
    <message>
        <source>The pole pairs are no whole number from 1 to 50: count the magnets and halve, and set them in the firmware&apos;s project.</source>
        <translation>Die Polpaare sind keine ganze Zahl von 1 bis 50: Magnete zählen und halbieren, und im Projekt der Firmware eintragen.</translation>
    </message>
    <message>
        <source>The resistance is missing or no motor&apos;s: measure between two terminals and take half.</source>
        <translation>Der Widerstand fehlt oder passt zu keinem Motor: zwischen zwei Klemmen messen und die Hälfte nehmen.</translation>
    </message>
    <message>
        <source>An inductance is missing or no motor&apos;s: check whether millihenry were given as henry.</source>
        <translation>Eine Induktivität fehlt oder passt zu keinem Motor: prüfen, ob Millihenry als Henry angegeben wurden.</translation>
    </message>
    <message>
        <source>The strength of the magnets is missing or no motor&apos;s: the converter gives Ke from KV or from a measurement.</source>
        <translation>Die Stärke der Magnete fehlt oder passt zu keinem Motor: der Umrechner macht Ke aus KV oder aus einer Messung.</translation>
    </message>
    <message>
        <source>The motor&apos;s current is missing or no motor&apos;s: take the nominal current of the data sheet, times 1.414 if that is rms.</source>
        <translation>Der Motorstrom fehlt oder passt zu keinem Motor: den Nennstrom des Datenblatts nehmen, mal 1,414, wenn er ein Effektivwert ist.</translation>
    </message>
    <message>
        <source>Ld is greater than Lq, which no magnet motor is: ST&apos;s generator may have swapped them. Measure both before gains are made of them.</source>
        <translation>Ld ist größer als Lq, was bei keinem Magnetmotor so ist: STs Generator hat sie vielleicht vertauscht. Beide messen, bevor daraus Verstärkungen werden.</translation>
    </message>
    <message>
        <source>L / R is outside 10 µs to 1 s: one of them has the wrong unit, or one is between terminals and the other of a phase.</source>
        <translation>L / R liegt außerhalb von 10 µs bis 1 s: eines hat die falsche Einheit, oder eines gilt zwischen Klemmen und das andere für eine Phase.</translation>
    </message>
    <message>
        <source>The motor&apos;s current is more than the drive can measure: keep set-points below, or take another shunt or gain.</source>
        <translation>Der Motorstrom ist größer, als der Antrieb messen kann: Sollwerte darunter halten, oder anderer Shunt oder andere Verstärkung.</translation>
    </message>
    <message>
        <source>The greatest speed is beyond the base speed: with nominal current and bus voltage it needs flux weakening.</source>
        <translation>Die größte Drehzahl liegt über der Eckdrehzahl: mit Nennstrom und Nennspannung braucht sie Feldschwächung.</translation>
    </message>
    <message>
        <source>It cannot be read: %1</source>
        <translation>Sie kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>It is larger than any description of a motor.</source>
        <translation>Sie ist größer als jede Beschreibung eines Motors.</translation>
    </message>
    <message>
        <source>Line %1 is no JSON: %2</source>
        <translation>Zeile %1 ist kein JSON: %2</translation>
    </message>
    <message>
        <source>It is no JSON object with %1.</source>
        <translation>Sie ist kein JSON-Objekt mit %1.</translation>
    </message>
    <message>
        <source>At “%1” there has to be an object with %2.</source>
        <translation>Bei „%1“ muss ein Objekt mit %2 stehen.</translation>
    </message>
    <message>
        <source>There is no key “%1”; there are %2.</source>
        <translation>Einen Schlüssel „%1“ gibt es nicht; es gibt %2.</translation>
    </message>
    <message>
        <source>Its preset is none of the simulator&apos;s.</source>
        <translation>Ihre Vorlage (preset) hat der Simulator nicht.</translation>
    </message>
    <message>
        <source>The value of “%1” cannot be used.</source>
        <translation>Der Wert von „%1“ ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>“%1” is missing.</source>
        <translation>„%1“ fehlt.</translation>
    </message>
    <message>
        <source>“%1” is below the supply voltage.</source>
        <translation>„%1“ liegt unter der Versorgungsspannung.</translation>
    </message>
    <message>
        <source>“ls” was taken as millihenry: as henry it would be no motor.</source>
        <translation>„ls“ wurde als Millihenry gelesen: als Henry wäre es kein Motor.</translation>
    </message>
    <message>
        <source>Only one inductance was measured: of a motor with buried magnets, measure Ld and Lq.</source>
        <translation>Nur eine Induktivität wurde gemessen: bei vergrabenen Magneten Ld und Lq messen.</translation>
    </message>
    <message>
        <source>Keys that are not known were passed over.</source>
        <translation>Unbekannte Schlüssel wurden übergangen.</translation>
    </message>
    <message>
        <source>Dry friction</source>
        <translation>Trockene Reibung</translation>
    </message>
</context>
<context>
    <name>Opening</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>%1 cannot be opened (%2).</source>
        <translation>%1 kann nicht geöffnet werden (%2).</translation>
    </message>
    <message>
        <source>Opened %1.</source>
        <translation>%1 ist geöffnet.</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) in it are damaged; what lies before and after is shown.</source>
        <translation>
            <numerusform>Eine Stelle darin ist beschädigt; was davor und dahinter liegt, wird gezeigt.</numerusform>
            <numerusform>%n Stellen darin sind beschädigt; was davor und dahinter liegt, wird gezeigt.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of its events, snapshots and notes are left out: they take more than %2 MiB.</source>
        <translation>%1 der Ereignisse, Schnappschüsse und Notizen darin fehlen: Sie brauchen mehr als %2 MiB.</translation>
    </message>
    <message>
        <source>The recording was interrupted.</source>
        <translation>Die Aufzeichnung wurde unterbrochen.</translation>
    </message>
    <message>
        <source>It ends where the disk was full.</source>
        <translation>Sie endet, wo die Platte voll war.</translation>
    </message>
    <message>
        <source>It ends where the disk failed.</source>
        <translation>Sie endet, wo die Platte versagte.</translation>
    </message>
    <message>
        <source>It is larger than the %1 GB of room for it: %2 samples before %3 s are not shown, and marked as a gap.</source>
        <translation>Sie ist größer als die %1 GB Platz dafür: %2 Messwerte vor %3 s werden nicht gezeigt und sind als Lücke markiert.</translation>
    </message>
    <message>
        <source>It lacks %1, because the disk was too slow.</source>
        <translation>Es fehlen %1, weil die Platte zu langsam war.</translation>
    </message>
</context>
<context>
    <name>PlanQuestion</name>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message numerus="yes">
        <source>%n time(s): at once to %1, and at once back to %2, each held for %3.</source>
        <translation>
            <numerusform>%n-mal: sofort auf %1 und sofort zurück auf %2, jede %3 lang gehalten.</numerusform>
            <numerusform>%n-mal: sofort auf %1 und sofort zurück auf %2, jede %3 lang gehalten.</numerusform>
        </translation>
    </message>
    <message>
        <source>For %1 its torque jumps and drives it or lets it coast, between %2 and %3; the current along the magnets jumps within ±%4.</source>
        <translation>%1 lang springt sein Drehmoment, treibt ihn an oder lässt ihn auslaufen, zwischen %2 und %3; der Strom längs der Magnete springt innerhalb von ±%4.</translation>
    </message>
    <message>
        <source>For %1 its torque drives it or lets it coast, between %2 and %3; it is never braked.</source>
        <translation>%1 lang treibt ihn sein Drehmoment an oder lässt ihn auslaufen, zwischen %2 und %3; gebremst wird er nie.</translation>
    </message>
    <message>
        <source>For %1 its speed jumps at random between %2 and %3.</source>
        <translation>%1 lang springt seine Drehzahl zufällig zwischen %2 und %3.</translation>
    </message>
    <message>
        <source>At rest: currents from %1 to %2 along the magnets.</source>
        <translation>Im Stillstand: Ströme von %1 bis %2 längs der Magnete.</translation>
    </message>
    <message>
        <source>In its start-up, whose stages are borrowed and do not turn: currents of %1 and %2; then it is stopped.</source>
        <translation>Im Anlauf, dessen Stufen geliehen sind und nicht drehen: Ströme von %1 und %2; danach wird er gestoppt.</translation>
    </message>
    <message numerus="yes">
        <source>%n time(s): its current jumps from %1 to %2 and back.</source>
        <translation>
            <numerusform>%n-mal: sein Strom springt von %1 auf %2 und zurück.</numerusform>
            <numerusform>%n-mal: sein Strom springt von %1 auf %2 und zurück.</numerusform>
        </translation>
    </message>
    <message>
        <source>no bound</source>
        <comment>of the current</comment>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>%1 times the nominal current</source>
        <translation>das %1-fache des Nennstroms</translation>
    </message>
    <message>
        <source>%1 times the greatest current of the board</source>
        <translation>das %1-fache des größten Stroms des Boards</translation>
    </message>
    <message>
        <source>your own limit of the current</source>
        <translation>Ihre eigene Grenze des Stroms</translation>
    </message>
    <message>
        <source>The limits in the control panel bound what is asked for, these caps what is measured: up to %1 beyond the plan, and %2.</source>
        <translation>Die Grenzen in der Steuerung gelten für das Verlangte, diese hier für das Gemessene: bis zu %1 über den Plan hinaus, und %2.</translation>
    </message>
    <message>
        <source>It rests.</source>
        <translation>Er steht.</translation>
    </message>
    <message>
        <source>It runs: from %1 to %2 in %3.</source>
        <translation>Er läuft: von %1 auf %2 in %3.</translation>
    </message>
    <message>
        <source>It rests: start, then to %1 in %2.</source>
        <translation>Er steht: Start, dann auf %1 in %2.</translation>
    </message>
    <message>
        <source>Then back to %1 in %2.</source>
        <translation>Danach zurück auf %1 in %2.</translation>
    </message>
    <message>
        <source>Then the motor is stopped, and its old set-point comes back.</source>
        <translation>Danach wird der Motor gestoppt und bekommt seinen alten Sollwert zurück.</translation>
    </message>
    <message>
        <source>Stopped at once: below %1 or above %2, beyond %3 of Iq, and where the bus voltage, the temperature or the link is not as it should be.</source>
        <translation>Sofort gestoppt wird unter %1 oder über %2, jenseits von %3 Iq, und wenn Zwischenkreisspannung, Temperatur oder Verbindung nicht sind, wie sie sein sollen.</translation>
    </message>
    <message>
        <source>While it starts, only %1 and the current bound it.</source>
        <translation>Während des Starts begrenzen ihn nur %1 und der Strom.</translation>
    </message>
    <message>
        <source>It runs: from %1, and back there after each of these.</source>
        <translation>Er läuft: von %1, und nach jedem von diesen dorthin zurück.</translation>
    </message>
    <message>
        <source>%1. %2 Stopped below %3, above %4, beyond %5.</source>
        <comment>number, what is done, caps</comment>
        <translation>%1. %2 Gestoppt unter %3, über %4, jenseits von %5.</translation>
    </message>
    <message>
        <source>Also stopped where the bus voltage, the temperature or the link is not as it should be.</source>
        <translation>Gestoppt wird auch, wenn Zwischenkreisspannung, Temperatur oder Verbindung nicht sind, wie sie sein sollen.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Sprünge</translation>
    </message>
    <message>
        <source>Inductances and flux</source>
        <translation>Induktivitäten und Fluss</translation>
    </message>
    <message>
        <source>Inertia and friction</source>
        <translation>Trägheit und Reibung</translation>
    </message>
    <message>
        <source>Response of the current</source>
        <translation>Frequenzgang des Stroms</translation>
    </message>
    <message>
        <source>Response of the speed</source>
        <translation>Frequenzgang der Drehzahl</translation>
    </message>
    <message>
        <source>Resistance</source>
        <translation>Widerstand</translation>
    </message>
    <message>
        <source>Steps of the current</source>
        <translation>Sprünge des Stroms</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>This will move motor %1 by itself. Go on?</source>
        <translation>Dies bewegt Motor %1 von selbst. Fortfahren?</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ausführen</translation>
    </message>
    <message>
        <source>Its gains are Kp %1 and Ki %2 meanwhile.</source>
        <translation>Seine Verstärkungen sind dabei Kp %1 und Ki %2.</translation>
    </message>
    <message>
        <source>It rests: it is started for each of these, and stopped afterwards.</source>
        <translation>Er ruht: er wird für jedes davon gestartet und danach gestoppt.</translation>
    </message>
    <message>
        <source>This board does not tell its bus voltage: nothing bounds it.</source>
        <translation>Dieses Board nennt seine Zwischenkreisspannung nicht: nichts begrenzt sie.</translation>
    </message>
    <message>
        <source>A step down brakes the motor, which feeds the bus: only the cap of the bus voltage bounds that.</source>
        <translation>Ein Sprung nach unten bremst den Motor, und der speist den Zwischenkreis: nur die Schranke der Zwischenkreisspannung begrenzt das.</translation>
    </message>
    <message>
        <source>A step down brakes the motor, which feeds the bus.</source>
        <translation>Ein Sprung nach unten bremst den Motor, und der speist den Zwischenkreis.</translation>
    </message>
    <message>
        <source>The like within these caps and this time is not asked about again until disarmed. Esc stops every motor at any time.</source>
        <translation>Nach Gleichem innerhalb dieser Schranken und dieser Zeit wird bis zum Entzug der Freigabe nicht mehr gefragt. Esc stoppt jederzeit jeden Motor.</translation>
    </message>
    <message>
        <source>For %1 it is held at %2.</source>
        <translation>%1 lang wird er auf %2 gehalten.</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>While it starts, only %1 bound it.</source>
        <comment>a speed</comment>
        <translation>Während er anläuft, begrenzen ihn nur %1.</translation>
    </message>
    <message>
        <source>Backwards, for %1: its torque drives it or lets it coast, between %2 and %3; it is never braked.</source>
        <translation>Rückwärts, %1 lang: Sein Drehmoment treibt ihn an oder lässt ihn auslaufen, zwischen %2 und %3; gebremst wird er nie.</translation>
    </message>
    <message>
        <source>For %1 ramps lead it from %2 to %3 and back; an ampere is taken for %4.</source>
        <translation>%1 lang führen Rampen ihn von %2 auf %3 und zurück; ein Ampere zählt als %4.</translation>
    </message>
    <message>
        <source>A ramp down brakes a heavy rotor, which feeds the bus.</source>
        <translation>Eine Rampe nach unten bremst einen schweren Rotor, was den Zwischenkreis speist.</translation>
    </message>
    <message>
        <source>For %1 it is held at %2, while you change its load.</source>
        <translation>Für %1 wird er bei %2 gehalten, während Sie seine Last ändern.</translation>
    </message>
    <message>
        <source>Changes of the load</source>
        <translation>Lastwechsel</translation>
    </message>
    <message>
        <source>Its set-points leave with every exchange meanwhile.</source>
        <translation>Seine Sollwerte gehen währenddessen mit jedem Austausch.</translation>
    </message>
    <message numerus="yes">
        <source>%n time(s): its shaft is moved by %1 and back, each way in %2.</source>
        <translation>
            <numerusform>%n-mal: seine Welle wird um %1 bewegt und zurück, jeder Weg in %2.</numerusform>
            <numerusform>%n-mal: seine Welle wird um %1 bewegt und zurück, jeder Weg in %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Each move ends by braking, which feeds the bus.</source>
        <translation>Jede Bewegung endet mit Bremsen, und das speist den Zwischenkreis.</translation>
    </message>
    <message>
        <source>Steps of the position</source>
        <translation>Sprünge der Position</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message numerus="yes">
        <source>%n byte(s)</source>
        <translation>
            <numerusform>%n Byte</numerusform>
            <numerusform>%n Bytes</numerusform>
        </translation>
    </message>
    <message>
        <source>digits</source>
        <comment>unit of a raw number</comment>
        <translation>Digits</translation>
    </message>
    <message>
        <source>%1 digits are the full scale of the current sensor, which this board does not tell.</source>
        <translation>%1 Digits sind der Vollausschlag des Stromsensors, den dieses Board nicht nennt.</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>none</source>
        <comment>no flag is set</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>now: %1</source>
        <comment>faults that are present</comment>
        <translation>jetzt: %1</translation>
    </message>
    <message>
        <source>past: %1</source>
        <comment>faults that occurred</comment>
        <translation>früher: %1</translation>
    </message>
</context>
<context>
    <name>Readings</name>
    <message>
        <source>no sample</source>
        <translation>kein Messwert</translation>
    </message>
</context>
<context>
    <name>RevUp</name>
    <message>
        <source>Begin with a stage at 0&#x202f;rpm that brings the current, at least %1.</source>
        <translation>Beginnen Sie mit einer Stufe bei 0&#x202f;rpm, die den Strom bringt, mindestens %1.</translation>
    </message>
    <message>
        <source>Raise the current here and before to at least %1.</source>
        <translation>Heben Sie den Strom hier und davor auf mindestens %1.</translation>
    </message>
    <message>
        <source>Stage %1 needs %2, its current gives %3: the rotor does not follow.</source>
        <translation>Stufe %1 braucht %2, ihr Strom gibt %3: Der Rotor folgt nicht.</translation>
    </message>
    <message>
        <source>Stage %1 ends at %2, where the observer does not see the rotor yet. Let it end above %3.</source>
        <translation>Stufe %1 endet bei %2, dort sieht der Beobachter den Rotor noch nicht. Lassen Sie sie über %3 enden.</translation>
    </message>
    <message>
        <source>Stage %1 takes no time: speed or current jump, the rotor is left behind. Give it time, or remove it.</source>
        <translation>Stufe %1 dauert 0&#x202f;ms: Drehzahl oder Strom springen, der Rotor bleibt zurück. Geben Sie ihr Zeit, oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>Stage %1 goes to %2; firmware keeps 16 bits of it, at most %3. Lower it.</source>
        <translation>Stufe %1 geht auf %2; die Firmware behält 16 Bit davon, höchstens %3. Verringern Sie sie.</translation>
    </message>
    <message>
        <source>Stage %1 turns against the stage before. Give all the same sign; backwards starts come from the sign of the speed set-point.</source>
        <translation>Stufe %1 dreht gegen die Stufe davor. Geben Sie allen dasselbe Vorzeichen; rückwärts wird durch das Vorzeichen der Solldrehzahl gestartet.</translation>
    </message>
    <message>
        <source>No stage takes any time: the motor would not start. Add a stage, or begin with the start values.</source>
        <translation>Keine Stufe dauert eine Zeit: Der Motor liefe nicht an. Fügen Sie eine Stufe hinzu, oder beginnen Sie mit den Startwerten.</translation>
    </message>
    <message>
        <source>Stage %1 takes %2, more than the limit of %3. Lower it.</source>
        <translation>Stufe %1 nimmt %2, mehr als die Grenze von %3. Verringern Sie den Strom.</translation>
    </message>
    <message>
        <source>Stage %1 goes to %2, beyond the limit of %3. Lower it.</source>
        <translation>Stufe %1 geht auf %2, über die Grenze von %3. Verringern Sie sie.</translation>
    </message>
    <message>
        <source>Give it at least %1; so much current is not allowed.</source>
        <translation>Geben Sie ihr mindestens %1; so viel Strom ist nicht erlaubt.</translation>
    </message>
    <message>
        <source>Give it at least %1, or a current of at least %2 here and before.</source>
        <translation>Geben Sie ihr mindestens %1, oder hier und davor mindestens %2 Strom.</translation>
    </message>
</context>
<context>
    <name>RunMark</name>
    <message>
        <source>circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>diamond</source>
        <translation>Raute</translation>
    </message>
    <message>
        <source>cross</source>
        <translation>Kreuz</translation>
    </message>
    <message>
        <source>triangle upside down</source>
        <translation>Dreieck auf der Spitze</translation>
    </message>
    <message>
        <source>plus</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>star</source>
        <translation>Stern</translation>
    </message>
</context>
<context>
    <name>RunText</name>
    <message>
        <source>Not carried out: %1.</source>
        <translation>Nicht ausgeführt: %1.</translation>
    </message>
    <message>
        <source>Interrupted: %1.</source>
        <translation>Unterbrochen: %1.</translation>
    </message>
    <message>
        <source>rise %1 ms, overshoot %2 %, settling %3 ms</source>
        <translation>Anstieg %1 ms, Überschwingen %2 %, Ausregelzeit %3 ms</translation>
    </message>
    <message>
        <source>J %1 kg m², friction %2 and %3</source>
        <comment>inertia, dry, viscous</comment>
        <translation>J %1 kg m², Reibung %2 und %3</translation>
    </message>
    <message>
        <source>Rs %1, Ld %2, Lq %3, flux %4</source>
        <translation>Rs %1, Ld %2, Lq %3, Fluss %4</translation>
    </message>
    <message>
        <source>crossover %1 Hz, phase margin %2°, Ms %3</source>
        <translation>Durchtritt %1 Hz, Phasenreserve %2°, Ms %3</translation>
    </message>
    <message>
        <source>Speed step %1 rpm</source>
        <comment>from to</comment>
        <translation>Drehzahlsprung %1 rpm</translation>
    </message>
    <message>
        <source>Flux step %1 A</source>
        <comment>from to</comment>
        <translation>Flusssprung %1 A</translation>
    </message>
    <message>
        <source>Torque step %1 A</source>
        <comment>from to</comment>
        <translation>Momentensprung %1 A</translation>
    </message>
    <message>
        <source>Mechanics</source>
        <translation>Mechanik</translation>
    </message>
    <message>
        <source>Electrics, turning</source>
        <translation>Elektrik, drehend</translation>
    </message>
    <message>
        <source>Response of the speed</source>
        <translation>Frequenzgang der Drehzahl</translation>
    </message>
    <message>
        <source>Response of the current</source>
        <translation>Frequenzgang des Stroms</translation>
    </message>
    <message>
        <source>%1, %2 to %3 s</source>
        <comment>a recording, seconds</comment>
        <translation>%1, %2 bis %3 s</translation>
    </message>
    <message>
        <source>Electrics</source>
        <translation>Elektrik</translation>
    </message>
    <message>
        <source>electrical %1 W, shaft %2 W, efficiency %3</source>
        <translation>elektrisch %1 W, Welle %2 W, Wirkungsgrad %3</translation>
    </message>
    <message>
        <source>Power at %1 rpm</source>
        <translation>Leistung bei %1 rpm</translation>
    </message>
    <message>
        <source>Ended: %1.</source>
        <translation>Beendet: %1.</translation>
    </message>
    <message>
        <source>load %1 A, gives way by %2 rpm, back in %3 ms</source>
        <translation>Last %1 A, gibt nach um %2 rpm, zurück nach %3 ms</translation>
    </message>
    <message>
        <source>Load at %1 rpm</source>
        <translation>Last bei %1 rpm</translation>
    </message>
    <message>
        <source>Position step %1°</source>
        <translation>Positionssprung %1°</translation>
    </message>
</context>
<context>
    <name>Setpoint</name>
    <message>
        <source>Type a number.</source>
        <translation>Geben Sie eine Zahl ein.</translation>
    </message>
    <message>
        <source>Not a plain number: use digits, one decimal point and a sign.</source>
        <translation>Keine einfache Zahl: Verwenden Sie Ziffern, ein Dezimalzeichen und ein Vorzeichen.</translation>
    </message>
    <message>
        <source>Write the number without group marks.</source>
        <translation>Schreiben Sie die Zahl ohne Tausendertrennzeichen.</translation>
    </message>
    <message>
        <source>Too many digits.</source>
        <translation>Zu viele Ziffern.</translation>
    </message>
</context>
<context>
    <name>SettingsFile</name>
    <message>
        <source>The settings could not be read, so all are as at first. The damaged file is kept as %1.</source>
        <translation>Die Einstellungen waren nicht lesbar, alle sind wie am Anfang. Die beschädigte Datei bleibt als %1 erhalten.</translation>
    </message>
    <message>
        <source>The settings could not be read, so all are as at first. The damaged file %1 is replaced when Rotorscope ends.</source>
        <translation>Die Einstellungen waren nicht lesbar, alle sind wie am Anfang. Die beschädigte Datei %1 wird beim Beenden von Rotorscope ersetzt.</translation>
    </message>
    <message>
        <source>Settings and notes cannot be saved (%1): what is changed now is lost when Rotorscope ends.</source>
        <translation>Einstellungen und Notizen lassen sich nicht speichern (%1): Was jetzt geändert wird, geht beim Beenden von Rotorscope verloren.</translation>
    </message>
</context>
<context>
    <name>Shaft</name>
    <message>
        <source>A move to an angle needs a time.</source>
        <translation>Die Fahrt zu einem Winkel braucht eine Zeit.</translation>
    </message>
    <message>
        <source>On the way %1 rpm would be needed: the limit is %2 rpm. Give it more time.</source>
        <translation>Unterwegs wären %1 rpm nötig: die Grenze ist %2 rpm. Geben Sie ihr mehr Zeit.</translation>
    </message>
    <message>
        <source>at most %1 rpm on the way</source>
        <translation>unterwegs höchstens %1 rpm</translation>
    </message>
</context>
<context>
    <name>Snapshot</name>
    <message>
        <source>none</source>
        <comment>no flag is set</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>it is no JSON</source>
        <translation>ist es kein JSON</translation>
    </message>
    <message>
        <source>it is no snapshot</source>
        <translation>sie ist kein Schnappschuss</translation>
    </message>
    <message>
        <source>it is of a newer version than this program knows</source>
        <translation>sie ist von einer neueren Fassung, als dieses Programm kennt</translation>
    </message>
    <message>
        <source>it has no list of registers</source>
        <translation>sie hat keine Liste von Registern</translation>
    </message>
    <message>
        <source>it has more registers than any board</source>
        <translation>sie hat mehr Register als jedes Board</translation>
    </message>
    <message>
        <source>This board does not have it, or it cannot be written there.</source>
        <translation>Dieses Board hat es nicht, oder es ist dort nicht zu schreiben.</translation>
    </message>
    <message>
        <source>It holds something else in this firmware.</source>
        <translation>Es hält in dieser Firmware etwas anderes.</translation>
    </message>
    <message>
        <source>Not restored: it moves a motor.</source>
        <translation>Nicht wiederhergestellt: Es bewegt einen Motor.</translation>
    </message>
    <message>
        <source>Writing it can move something, and its motor is not idle.</source>
        <translation>Es zu schreiben kann etwas bewegen, und sein Motor ruht nicht.</translation>
    </message>
    <message>
        <source>Firmware gives it in another form than it takes it.</source>
        <translation>Firmware gibt es in anderer Form aus, als sie es annimmt.</translation>
    </message>
    <message>
        <source>it has no name</source>
        <translation>es hat keinen Namen</translation>
    </message>
    <message>
        <source>it has no motor from 0 to 7</source>
        <translation>es hat keinen Motor von 0 bis 7</translation>
    </message>
    <message>
        <source>it has no id</source>
        <translation>es hat keine Nummer</translation>
    </message>
    <message>
        <source>it has no known type</source>
        <translation>es hat keinen bekannten Typ</translation>
    </message>
    <message>
        <source>its raw number does not fit its type</source>
        <translation>seine Rohzahl passt nicht in seinen Typ</translation>
    </message>
    <message>
        <source>it has neither bits nor a raw number</source>
        <translation>es hat weder Bits noch eine Rohzahl</translation>
    </message>
    <message>
        <source>it has no raw text</source>
        <translation>es hat keinen Rohtext</translation>
    </message>
    <message>
        <source>its bytes are no pairs of hexadecimal digits</source>
        <translation>seine Bytes sind keine Paare von Hexadezimalziffern</translation>
    </message>
    <message>
        <source>it is there twice</source>
        <translation>es ist zweimal da</translation>
    </message>
    <message>
        <source>%1 cannot be used: in line %2 %3 (%4).</source>
        <translation>%1 ist nicht zu gebrauchen: In Zeile %2 %3 (%4).</translation>
    </message>
    <message>
        <source>%1 cannot be used: %2.</source>
        <translation>%1 ist nicht zu gebrauchen: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be used: line %2, register %3: %4.</source>
        <translation>%1 ist nicht zu gebrauchen: Zeile %2, Register %3: %4.</translation>
    </message>
</context>
<context>
    <name>Ticks</name>
    <message>
        <source>%1/div</source>
        <comment>what is between two lines of the grid</comment>
        <translation>%1/div</translation>
    </message>
    <message>
        <source>%1 %2/div</source>
        <comment>number, unit: what is between two lines of the grid</comment>
        <translation>%1 %2/div</translation>
    </message>
</context>
<context>
    <name>ToldFigures</name>
    <message>
        <source>%1: %2 (%3 to %4).</source>
        <comment>a number and its interval</comment>
        <translation>%1: %2 (%3 bis %4).</translation>
    </message>
    <message>
        <source>Not conclusive: %1</source>
        <translation>Nicht schlüssig: %1</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>a number</comment>
        <translation>%1: %2.</translation>
    </message>
</context>
<context>
    <name>Trigger</name>
    <message>
        <source>Edge</source>
        <translation>Flanke</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Pegel</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Pulse width</source>
        <translation>Pulsbreite</translation>
    </message>
    <message>
        <source>Slew</source>
        <translation>Steilheit</translation>
    </message>
    <message>
        <source>Dropout</source>
        <translation>Aussetzer</translation>
    </message>
    <message>
        <source>N-th edge</source>
        <translation>N-te Flanke</translation>
    </message>
    <message>
        <source>State change</source>
        <translation>Zustandswechsel</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Register write</source>
        <translation>Registerschreiben</translation>
    </message>
    <message>
        <source>rising</source>
        <translation>steigend</translation>
    </message>
    <message>
        <source>falling</source>
        <translation>fallend</translation>
    </message>
    <message>
        <source>either way</source>
        <translation>beide Richtungen</translation>
    </message>
    <message>
        <source>at or above</source>
        <translation>ab dem Pegel aufwärts</translation>
    </message>
    <message>
        <source>at or below</source>
        <translation>ab dem Pegel abwärts</translation>
    </message>
    <message>
        <source>leaves the window</source>
        <translation>verlässt das Fenster</translation>
    </message>
    <message>
        <source>enters the window</source>
        <translation>betritt das Fenster</translation>
    </message>
    <message>
        <source>positive pulse</source>
        <translation>positiver Puls</translation>
    </message>
    <message>
        <source>negative pulse</source>
        <translation>negativer Puls</translation>
    </message>
    <message>
        <source>Lower level</source>
        <translation>Unterer Pegel</translation>
    </message>
    <message>
        <source>Auto</source>
        <comment>mode of the trigger</comment>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Normal</source>
        <comment>mode of the trigger</comment>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Single</source>
        <comment>mode of the trigger</comment>
        <translation>Einzeln</translation>
    </message>
    <message>
        <source>Roll</source>
        <comment>mode of the trigger</comment>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Armed</source>
        <comment>state of the trigger</comment>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Trig&apos;d</source>
        <comment>state of the trigger</comment>
        <translation>Getriggert</translation>
    </message>
    <message>
        <source>Auto</source>
        <comment>state of the trigger</comment>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Roll</source>
        <comment>state of the trigger</comment>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation>vor %1 s</translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation>vor %1 min</translation>
    </message>
    <message>
        <source>A level or a time is no number.</source>
        <translation>Ein Pegel oder eine Zeit ist keine Zahl.</translation>
    </message>
    <message>
        <source>The hysteresis is below zero.</source>
        <translation>Die Hysterese ist kleiner als null.</translation>
    </message>
    <message>
        <source>The upper level has to be above the lower one.</source>
        <translation>Der obere Pegel muss über dem unteren liegen.</translation>
    </message>
    <message>
        <source>These times leave nothing to wait for.</source>
        <translation>Diese Zeiten lassen nichts übrig, worauf zu warten wäre.</translation>
    </message>
    <message>
        <source>The count has to be at least 1.</source>
        <translation>Die Anzahl muss mindestens 1 sein.</translation>
    </message>
    <message>
        <source>Hold</source>
        <comment>state of the trigger</comment>
        <translation>Halt</translation>
    </message>
    <message>
        <source>Set-point</source>
        <comment>type of the trigger</comment>
        <translation>Sollwert</translation>
    </message>
</context>
<context>
    <name>WorkspaceFile</name>
    <message>
        <source>Line %1 is not JSON: %2.</source>
        <translation>Zeile %1 ist kein JSON: %2.</translation>
    </message>
    <message>
        <source>This is no workspace: it has no &quot;%1&quot;.</source>
        <translation>Das ist kein Arbeitsplatz: „%1“ fehlt.</translation>
    </message>
    <message>
        <source>It was written by a later version of Rotorscope (its form is %1).</source>
        <translation>Eine spätere Version von Rotorscope hat sie geschrieben (Form %1).</translation>
    </message>
    <message>
        <source>Its value of %1 cannot be.</source>
        <translation>Der Wert von %1 ist nicht möglich.</translation>
    </message>
</context>
<context>
    <name>WriteQuestion</name>
    <message>
        <source>not known</source>
        <comment>the old value</comment>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Motor %1, %2</source>
        <comment>number, change</comment>
        <translation>Motor %1, %2</translation>
    </message>
    <message>
        <source>Board, %1</source>
        <comment>change</comment>
        <translation>Board, %1</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiteres</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Write registers</source>
        <translation>Register schreiben</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>%1 (gain changes by more than a factor of 2 while running)</source>
        <translation>%1 (Verstärkung ändert sich im Lauf um mehr als Faktor 2)</translation>
    </message>
    <message>
        <source>This can move or harm a motor immediately.</source>
        <translation>Das kann einen Motor sofort bewegen oder beschädigen.</translation>
    </message>
</context>
<context>
    <name>WriteReport</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiteres</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>The board made another value of: %1.</source>
        <comment>list of registers</comment>
        <translation>Das Board machte einen anderen Wert aus: %1.</translation>
    </message>
    <message>
        <source>Not written: %1</source>
        <comment>list of registers with reasons</comment>
        <translation>Nicht geschrieben: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>register: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) restored and verified.</source>
        <translation>
            <numerusform>%n Register wiederhergestellt und geprüft.</numerusform>
            <numerusform>%n Register wiederhergestellt und geprüft.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) written and verified.</source>
        <translation>
            <numerusform>%n Register geschrieben und geprüft.</numerusform>
            <numerusform>%n Register geschrieben und geprüft.</numerusform>
        </translation>
    </message>
    <message>
        <source>Sent, outcome unknown: %1.</source>
        <comment>list of registers</comment>
        <translation>Gesendet, Ergebnis unbekannt: %1.</translation>
    </message>
    <message>
        <source>Written, not verified: %1.</source>
        <comment>list of registers with reasons</comment>
        <translation>Geschrieben, nicht geprüft: %1.</translation>
    </message>
</context>
<context>
    <name>widgets::AutoSnapshots</name>
    <message>
        <source>What the board held before is kept in memory only: %1 was not written (%2). Save a snapshot to another place before you leave.</source>
        <comment>file, the system&apos;s words</comment>
        <translation>Was das Board vorher hielt, steht nur im Arbeitsspeicher: %1 wurde nicht geschrieben (%2). Sichern Sie vor dem Beenden einen Schnappschuss an anderer Stelle.</translation>
    </message>
    <message>
        <source>Nothing was written: the board did not tell what it holds first.</source>
        <translation>Nichts wurde geschrieben: Das Board sagte nicht, was es vorher hält.</translation>
    </message>
    <message>
        <source>Nothing was written: the board did not tell what it holds first (%1).</source>
        <translation>Nichts wurde geschrieben: Das Board sagte nicht, was es vorher hält (%1).</translation>
    </message>
    <message>
        <source>The snapshot before the write is without: %1.</source>
        <comment>list of registers</comment>
        <translation>Dem Schnappschuss vor dem Schreiben fehlt: %1.</translation>
    </message>
</context>
<context>
    <name>widgets::Banner</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>widgets::BigNumbers</name>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Current Iq</source>
        <translation>Strom Iq</translation>
    </message>
    <message>
        <source>Bus voltage</source>
        <translation>Zwischenkreisspannung</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Power stage</source>
        <translation>Leistungsteil</translation>
    </message>
    <message>
        <source>Large numbers</source>
        <translation>Große Zahlen</translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <comment>number, state</comment>
        <translation>Motor %1: %2</translation>
    </message>
</context>
<context>
    <name>widgets::BodePlot</name>
    <message>
        <source>No response yet.</source>
        <translation>Noch kein Frequenzgang.</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>dB of %1</source>
        <comment>a unit</comment>
        <translation>dB von %1</translation>
    </message>
    <message>
        <source>Coh.</source>
        <comment>coherence, short</comment>
        <translation>Koh.</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
</context>
<context>
    <name>widgets::ChannelStrip</name>
    <message>
        <source>Drag registers here or onto the scope, or press Enter in the list.</source>
        <translation>Ziehen Sie Register hierher oder auf das Oszilloskop, oder drücken Sie in der Liste die Eingabetaste.</translation>
    </message>
    <message>
        <source>Rate of the fast signals</source>
        <translation>Takt der schnellen Signale</translation>
    </message>
    <message>
        <source>Samples a second of each HF signal</source>
        <translation>Abtastwerte je Sekunde und HF-Signal</translation>
    </message>
    <message>
        <source>HF rate</source>
        <translation>HF-Takt</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>How %1 is recorded: %2</source>
        <translation>Wie %1 aufgezeichnet wird: %2</translation>
    </message>
    <message>
        <source>How this signal is recorded</source>
        <translation>Wie dieses Signal aufgezeichnet wird</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Take it off the scope</source>
        <translation>Vom Oszilloskop nehmen</translation>
    </message>
    <message>
        <source>%1 of %2 kB/s (%3 %)</source>
        <comment>used, available, percent</comment>
        <translation>%1 von %2 kB/s (%3 %)</translation>
    </message>
    <message>
        <source>rate lowered to fit the link</source>
        <translation>Takt gesenkt, damit er zur Verbindung passt</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s) polled, see the chips</source>
        <translation>
            <numerusform>%n Signal abgefragt, siehe Kanalleiste</numerusform>
            <numerusform>%n Signale abgefragt, siehe Kanalleiste</numerusform>
        </translation>
    </message>
    <message>
        <source>, measured %1 kB/s</source>
        <translation>, gemessen %1 kB/s</translation>
    </message>
    <message>
        <source>Planned: %1 kB/s of %2 kB/s; one packet every %3 ms.</source>
        <translation>Geplant: %1 kB/s von %2 kB/s; alle %3 ms ein Paket.</translation>
    </message>
    <message numerus="yes">
        <source>This link carries %n HF signal(s) at every control period.</source>
        <translation>
            <numerusform>Diese Verbindung trägt %n HF-Signal in jeder Regelperiode.</numerusform>
            <numerusform>Diese Verbindung trägt %n HF-Signale in jeder Regelperiode.</numerusform>
        </translation>
    </message>
    <message>
        <source>At the chosen rate it would be %1 kB/s: recorded at one period in %2.</source>
        <translation>Mit der gewünschten Rate wären es %1 kB/s: aufgezeichnet wird eine von %2 Perioden.</translation>
    </message>
    <message>
        <source>%1/s</source>
        <comment>times a second</comment>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>Read %1 times a second.</source>
        <translation>%1-mal in der Sekunde gelesen.</translation>
    </message>
    <message>
        <source>Each value is one of the %1 ms before the time at which it is drawn: question and answer lie so far apart.</source>
        <translation>Jeder Wert stammt aus den %1 ms vor der Zeit, zu der er gezeichnet wird: So weit liegen Frage und Antwort auseinander.</translation>
    </message>
    <message>
        <source>each signal read up to %1 times a second</source>
        <translation>jedes Signal bis zu %1-mal in der Sekunde gelesen</translation>
    </message>
    <message>
        <source>, reached %1</source>
        <translation>, erreicht %1</translation>
    </message>
    <message>
        <source>This board records nothing by itself. Its line of %1 kB/s is shared by the signals, the registers that are seen and the motor&apos;s state.</source>
        <translation>Dieses Board zeichnet selbst nichts auf. Seine Leitung mit %1 kB/s teilen sich die Signale, die sichtbaren Register und der Zustand des Motors.</translation>
    </message>
    <message>
        <source>How %1 is computed</source>
        <translation>Wie %1 berechnet wird</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s)</source>
        <translation>
            <numerusform>%n Signal</numerusform>
            <numerusform>%n Signale</numerusform>
        </translation>
    </message>
    <message>
        <source>Shows the signals as chips</source>
        <translation>Zeigt die Signale als Plättchen</translation>
    </message>
    <message>
        <source>Folds the chips away: more room for the plots</source>
        <translation>Klappt die Plättchen ein: mehr Platz für die Kurven</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Farbe</translation>
    </message>
    <message>
        <source>&amp;Formula…</source>
        <translation>&amp;Formel…</translation>
    </message>
    <message>
        <source>HF: every sample</source>
        <translation>HF: jede Abtastung</translation>
    </message>
    <message numerus="yes">
        <source>MF: 1 of %n samples</source>
        <translation>
            <numerusform>MF: 1 von %n Abtastung</numerusform>
            <numerusform>MF: 1 von %n Abtastungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Polled: read in turn</source>
        <translation>Abgefragt: reihum gelesen</translation>
    </message>
</context>
<context>
    <name>widgets::CommandBox</name>
    <message>
        <source>Arm: allow commands</source>
        <translation>Freigeben: Befehle zulassen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Start → %1</source>
        <comment>speed or current</comment>
        <translation>Start → %1</translation>
    </message>
    <message>
        <source>Acknowledge faults</source>
        <translation>Fehler quittieren</translation>
    </message>
    <message>
        <source>Start motor</source>
        <translation>Motor starten</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>Stopp (Esc)</translation>
    </message>
    <message>
        <source>Starts the motor (Ctrl+Enter).</source>
        <translation>Startet den Motor (Strg+Eingabe).</translation>
    </message>
    <message>
        <source>Acknowledges the faults that are over (Ctrl+Backspace).</source>
        <translation>Quittiert die Fehler, die vorbei sind (Strg+Rücktaste).</translation>
    </message>
    <message>
        <source>Until it is armed, nothing that writes or moves leaves Rotorscope. A stop, a lost link and a new connection disarm.</source>
        <translation>Ohne Freigabe verlässt nichts Rotorscope, was schreibt oder bewegt. Ein Stopp, eine verlorene und eine neue Verbindung heben die Freigabe auf.</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
</context>
<context>
    <name>widgets::ConnectBar</name>
    <message>
        <source>Simulated board</source>
        <translation>Simuliertes Board</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Schnittstelle</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Board</translation>
    </message>
    <message>
        <source>A port of the list, or a path that you type</source>
        <translation>Eine Schnittstelle aus der Liste oder ein eingegebener Pfad</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>Baudrate</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Choose a port, or type its path.</source>
        <translation>Wählen Sie eine Schnittstelle oder geben Sie ihren Pfad ein.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a baud rate.</source>
        <translation>„%1“ ist keine Baudrate.</translation>
    </message>
    <message>
        <source>port open</source>
        <translation>Schnittstelle offen</translation>
    </message>
    <message>
        <source>port not open</source>
        <translation>Schnittstelle nicht offen</translation>
    </message>
    <message>
        <source>port closed</source>
        <translation>Schnittstelle geschlossen</translation>
    </message>
    <message>
        <source>no board</source>
        <translation>kein Board</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Closes the port (Ctrl+D)</source>
        <translation>Schließt die Schnittstelle (Strg+D)</translation>
    </message>
    <message>
        <source>Opens the port and looks for a board (Ctrl+D)</source>
        <translation>Öffnet die Schnittstelle und sucht ein Board (Strg+D)</translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation>Motor %1</translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <comment>number, name</comment>
        <translation>Motor %1: %2</translation>
    </message>
    <message>
        <source>Simulated board (%1)</source>
        <translation>Simuliertes Board (%1)</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Finds out what the board speaks; nothing that is sent for it can move a motor</source>
        <translation>Findet heraus, was das Board spricht; nichts, was dafür gesendet wird, kann einen Motor bewegen</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>What the board speaks; Auto finds it out</source>
        <translation>Was das Board spricht; „Auto“ findet es heraus</translation>
    </message>
    <message>
        <source>replay, no port</source>
        <translation>Wiedergabe, keine Schnittstelle</translation>
    </message>
    <message>
        <source>board as recorded</source>
        <translation>Board wie aufgezeichnet</translation>
    </message>
    <message>
        <source>Clock [Hz]</source>
        <translation>Takt [Hz]</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an SPI clock from 10 kHz to 100 MHz, in Hz.</source>
        <translation>„%1“ ist kein SPI-Takt von 10 kHz bis 100 MHz, in Hz.</translation>
    </message>
</context>
<context>
    <name>widgets::ControlPanel</name>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>Change…</source>
        <comment>the limits</comment>
        <translation>Ändern…</translation>
    </message>
    <message>
        <source>Change own limits</source>
        <translation>Eigene Grenzen ändern</translation>
    </message>
    <message>
        <source>not known</source>
        <comment>a limit</comment>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>none</source>
        <comment>a limit</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 (yours)</source>
        <comment>a limit of the person&apos;s own</comment>
        <translation>%1 (Ihre)</translation>
    </message>
    <message>
        <source>Limits: none (expert mode)</source>
        <translation>Grenzen: keine (Expertenmodus)</translation>
    </message>
    <message>
        <source>Expert mode: the board does not tell all limits.</source>
        <translation>Expertenmodus: Das Board nennt nicht alle Grenzen.</translation>
    </message>
    <message>
        <source>Change the current scale</source>
        <translation>Stromskala ändern</translation>
    </message>
    <message>
        <source>Current scale: %1 (yours)</source>
        <comment>with unit</comment>
        <translation>Stromskala: %1 (Ihre)</translation>
    </message>
    <message>
        <source>Current scale: not known</source>
        <translation>Stromskala: nicht bekannt</translation>
    </message>
    <message>
        <source>The current of %1 digits, which the board does not tell.</source>
        <translation>Der Strom bei %1 Digits, den das Board nicht nennt.</translation>
    </message>
    <message>
        <source>Limits: not known yet</source>
        <translation>Grenzen: noch nicht bekannt</translation>
    </message>
    <message>
        <source>Limits: %1,
%2</source>
        <comment>speed, current, below each other</comment>
        <translation>Grenzen: %1,
%2</translation>
    </message>
    <message>
        <source>Scale…</source>
        <comment>of the currents</comment>
        <translation>Skala …</translation>
    </message>
    <message>
        <source>Limits: %1, %2</source>
        <comment>speed, current</comment>
        <translation>Grenzen: %1, %2</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>Limits: not known</source>
        <translation>Grenzen: nicht bekannt</translation>
    </message>
</context>
<context>
    <name>widgets::CurrentScaleDialog</name>
    <message>
        <source>Current scale of motor %1</source>
        <translation>Stromskala von Motor %1</translation>
    </message>
    <message>
        <source>not known</source>
        <comment>the current scale</comment>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>This board does not tell the scale of its currents. Without it they are shown in digits and none can be asked for; with a wrong one the motor gets a wrong current. Setting it disarms.</source>
        <translation>Dieses Board nennt die Skala seiner Ströme nicht. Ohne sie werden Ströme in Digits gezeigt und können nicht vorgegeben werden; mit einer falschen bekommt der Motor einen falschen Strom. Das Setzen hebt die Freigabe auf.</translation>
    </message>
    <message>
        <source>&amp;Full-scale current [A] (peak, %1 digits)</source>
        <translation>&amp;Vollausschlag [A] (Spitze, %1 Digits)</translation>
    </message>
    <message>
        <source>Or from the measuring circuit</source>
        <translation>Oder aus der Messschaltung</translation>
    </message>
    <message>
        <source>&amp;Shunt [mΩ]</source>
        <translation>&amp;Shunt [mΩ]</translation>
    </message>
    <message>
        <source>&amp;Gain of the amplifier</source>
        <translation>V&amp;erstärkung</translation>
    </message>
    <message>
        <source>&amp;Reference of the converter [V]</source>
        <translation>&amp;Referenz des Wandlers [V]</translation>
    </message>
    <message>
        <source>1 digit is %1 mA; 1 A is %2 digits.</source>
        <translation>1 Digit ist %1 mA; 1 A sind %2 Digits.</translation>
    </message>
    <message>
        <source>Currents are shown in digits.</source>
        <translation>Ströme werden in Digits gezeigt.</translation>
    </message>
    <message>
        <source>A full-scale current is a plain number from 0.001 to %1 A, or nothing.</source>
        <translation>Der Vollausschlag ist eine einfache Zahl von 0,001 bis %1 A, oder nichts.</translation>
    </message>
</context>
<context>
    <name>widgets::CurrentScales</name>
    <message>
        <source>Setting the current scale</source>
        <translation>Setzen der Stromskala</translation>
    </message>
    <message>
        <source>Motor %1: currents in A by the scale that was entered for this board before, %2 A at full scale. See Current scale in the control panel.</source>
        <translation>Motor %1: Ströme in A nach der Skala, die für dieses Board schon eingegeben wurde, %2 A Vollausschlag. Siehe Stromskala in der Steuerung.</translation>
    </message>
</context>
<context>
    <name>widgets::CursorPanel</name>
    <message>
        <source>Values at the cursors</source>
        <translation>Werte an den Cursorn</translation>
    </message>
    <message>
        <source>Pair of cursors</source>
        <translation>Cursorpaar</translation>
    </message>
    <message>
        <source>The pair that is read out; type to give it a name</source>
        <translation>Das Paar, das abgelesen wird; zum Umbenennen tippen</translation>
    </message>
    <message>
        <source>Another pair of cursors</source>
        <translation>Weiteres Cursorpaar</translation>
    </message>
    <message>
        <source>Remove this pair</source>
        <translation>Dieses Paar entfernen</translation>
    </message>
    <message>
        <source>Copy the values as text</source>
        <translation>Die Werte als Text kopieren</translation>
    </message>
    <message>
        <source>Hide the cursors (C)</source>
        <translation>Cursor ausblenden (C)</translation>
    </message>
</context>
<context>
    <name>widgets::CursorTable</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
</context>
<context>
    <name>widgets::Cursors</name>
    <message>
        <source>Pair %1</source>
        <comment>of cursors</comment>
        <translation>Paar %1</translation>
    </message>
</context>
<context>
    <name>widgets::EditBar</name>
    <message>
        <source>Revert</source>
        <translation>Verwerfen</translation>
    </message>
    <message numerus="yes">
        <source>Apply %n edit(s)</source>
        <translation>
            <numerusform>%n Änderung anwenden</numerusform>
            <numerusform>%n Änderungen anwenden</numerusform>
        </translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Waiting for a motor that is not shown: %1.</source>
        <comment>list of registers</comment>
        <translation>Warten für einen Motor, der nicht gezeigt wird: %1.</translation>
    </message>
    <message>
        <source>Apply (%1)</source>
        <comment>so many edits</comment>
        <translation>Anwenden (%1)</translation>
    </message>
</context>
<context>
    <name>widgets::EventLane</name>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <comment>events</comment>
        <translation>
            <numerusform>und %n weiteres</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1  %2: %3</source>
        <comment>time, kind of event, what happened</comment>
        <translation>%1  %2: %3</translation>
    </message>
    <message>
        <source>What happened, on the clock of the traces. Double-click sets a marker.</source>
        <translation>Was geschah, auf der Uhr der Kurven. Ein Doppelklick setzt eine Markierung.</translation>
    </message>
</context>
<context>
    <name>widgets::EventLog</name>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Write</source>
        <comment>an event: a register was written</comment>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Markierung</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Wiederherstellung</translation>
    </message>
    <message>
        <source>Loss</source>
        <translation>Verlust</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation>Markierung %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>What</source>
        <comment>heading of a column: the kind of an event</comment>
        <translation>Art</translation>
    </message>
    <message>
        <source>Event or note</source>
        <translation>Ereignis oder Notiz</translation>
    </message>
</context>
<context>
    <name>widgets::EventPanel</name>
    <message>
        <source>Events and markers</source>
        <translation>Ereignisse und Markierungen</translation>
    </message>
    <message>
        <source>Enter shows an event on the scope, F2 edits a marker&apos;s note, Delete removes a marker</source>
        <translation>Eingabetaste zeigt ein Ereignis im Oszilloskop, F2 ändert die Notiz einer Markierung, Entf löscht eine Markierung</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Set a mar&amp;ker</source>
        <translation>Markierung set&amp;zen</translation>
    </message>
    <message>
        <source>Markers on&amp;ly</source>
        <translation>N&amp;ur Markierungen</translation>
    </message>
    <message>
        <source>Delete m&amp;arkers</source>
        <translation>Markierungen &amp;löschen</translation>
    </message>
</context>
<context>
    <name>widgets::EventRecorder</name>
    <message>
        <source>Motor %1: %2</source>
        <translation>Motor %1: %2</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Stop ramp</source>
        <translation>Rampe anhalten</translation>
    </message>
    <message>
        <source>Acknowledge faults</source>
        <translation>Fehler quittieren</translation>
    </message>
    <message>
        <source>Ramp to %1 rpm in %2 ms</source>
        <translation>Rampe auf %1 rpm in %2 ms</translation>
    </message>
    <message>
        <source>Ramp to %1 A in %2 ms</source>
        <translation>Rampe auf %1 A in %2 ms</translation>
    </message>
    <message>
        <source>Currents Iq %1 A, Id %2 A</source>
        <translation>Ströme Iq %1 A, Id %2 A</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a command and how it ended</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <comment>a register, its value before and after</comment>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>Disconnected</source>
        <translation>Getrennt</translation>
    </message>
    <message>
        <source>%1 of samples lost</source>
        <translation>%1 an Messwerten verloren</translation>
    </message>
    <message>
        <source>Stop motors</source>
        <translation>Motoren stoppen</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Shaft to %1° in %2 ms</source>
        <translation>Welle auf %1° in %2 ms</translation>
    </message>
    <message>
        <source>%1; at the board within %2</source>
        <comment>a command, a time</comment>
        <translation>%1; nach höchstens %2 beim Board</translation>
    </message>
    <message>
        <source>%1, for %2</source>
        <comment>trouble of the link, how long</comment>
        <translation>%1, %2 lang</translation>
    </message>
    <message>
        <source>Another board: %1</source>
        <comment>its names</comment>
        <translation>Anderes Board: %1</translation>
    </message>
    <message>
        <source>Experiment: %1</source>
        <translation>Versuch: %1</translation>
    </message>
</context>
<context>
    <name>widgets::ExperimentBar</name>
    <message>
        <source>Done; the motor is as it was.</source>
        <translation>Fertig; der Motor ist wie zuvor.</translation>
    </message>
    <message>
        <source>Done; afterwards: %1.</source>
        <translation>Fertig; danach: %1.</translation>
    </message>
    <message>
        <source>Not carried out: %1.</source>
        <translation>Nicht ausgeführt: %1.</translation>
    </message>
    <message>
        <source>Interrupted: %1.</source>
        <translation>Unterbrochen: %1.</translation>
    </message>
    <message>
        <source>Not begun: the gains were not written in time.</source>
        <translation>Nicht begonnen: Die Verstärkungen wurden nicht rechtzeitig geschrieben.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops every motor and disarms, as Esc does.</source>
        <translation>Stoppt jeden Motor und hebt die Freigabe auf, wie Esc.</translation>
    </message>
    <message>
        <source>Progress of the experiment</source>
        <translation>Fortschritt des Versuchs</translation>
    </message>
    <message>
        <source>%1 is measured at rest: stop the motor first.</source>
        <comment>Resistance</comment>
        <translation>%1: wird im Stillstand gemessen, den Motor zuerst stoppen.</translation>
    </message>
    <message>
        <source>The motor is in torque control: ask for a speed first, with Go or a speed ramp.</source>
        <translation>Der Motor ist in Drehmomentregelung: zuerst eine Drehzahl verlangen, mit Anfahren oder einer Drehzahlrampe.</translation>
    </message>
    <message>
        <source>What was measured is being evaluated.</source>
        <translation>Das Gemessene wird ausgewertet.</translation>
    </message>
    <message>
        <source>Not continued: %1</source>
        <translation>Nicht fortgesetzt: %1</translation>
    </message>
    <message>
        <source>What comes next is not agreed to any more.</source>
        <translation>Dem Folgenden ist nicht mehr zugestimmt.</translation>
    </message>
    <message>
        <source>Not begun: %1</source>
        <translation>Nicht begonnen: %1</translation>
    </message>
    <message>
        <source>%1: %2 s of about %3 s</source>
        <comment>what is measured, times</comment>
        <translation>%1: %2 s von etwa %3 s</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>text of a button, why it is greyed</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Ended: %1.</source>
        <translation>Beendet: %1.</translation>
    </message>
    <message>
        <source>Both directions begin at rest: stop the motor first.</source>
        <translation>Beide Richtungen beginnen im Stillstand: erst den Motor anhalten.</translation>
    </message>
</context>
<context>
    <name>widgets::Experiments</name>
    <message>
        <source>An experiment is running.</source>
        <translation>Ein Versuch läuft.</translation>
    </message>
    <message>
        <source>This board does not tell all limits of the motor: start it by hand once, and agree to expert mode.</source>
        <translation>Dieses Board nennt nicht alle Grenzen des Motors: Starten Sie ihn einmal von Hand und stimmen Sie dem Expertenmodus zu.</translation>
    </message>
    <message>
        <source>Acknowledge the faults first.</source>
        <translation>Quittieren Sie zuerst die Fehler.</translation>
    </message>
    <message>
        <source>The motor has to rest or to run.</source>
        <translation>Der Motor muss stehen oder laufen.</translation>
    </message>
</context>
<context>
    <name>widgets::ExportDialog</name>
    <message>
        <source>What the scope shows</source>
        <translation>Was das Oszilloskop zeigt</translation>
    </message>
    <message>
        <source>Everything recorded</source>
        <translation>Alles Aufgezeichnete</translation>
    </message>
    <message>
        <source>One file; slower signals keep their last value</source>
        <translation>Eine Datei; langsamere Signale behalten ihren letzten Wert</translation>
    </message>
    <message>
        <source>One file for each rate</source>
        <translation>Eine Datei je Takt</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Nothing has been recorded yet.</source>
        <translation>Es wurde noch nichts aufgezeichnet.</translation>
    </message>
    <message>
        <source>No trace is shown. Choose everything recorded.</source>
        <translation>Es wird keine Kurve gezeigt. Wählen Sie alles Aufgezeichnete.</translation>
    </message>
    <message>
        <source>%1 exists already. Choose another name.</source>
        <translation>%1 gibt es schon. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Between the cursors A and B</source>
        <translation>Zwischen den Cursorn A und B</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Range</source>
        <translation>&amp;Bereich</translation>
    </message>
    <message>
        <source>R&amp;ates</source>
        <translation>&amp;Takte</translation>
    </message>
    <message>
        <source>The scope as it is on the screen now.</source>
        <translation>Das Oszilloskop, wie es jetzt auf dem Bildschirm ist.</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s). The first column is the time in seconds. Lost samples have no row.</source>
        <translation>
            <numerusform>Ein Signal. Die erste Spalte ist die Zeit in Sekunden. Verlorene Werte haben keine Zeile.</numerusform>
            <numerusform>%n Signale. Die erste Spalte ist die Zeit in Sekunden. Verlorene Werte haben keine Zeile.</numerusform>
        </translation>
    </message>
    <message>
        <source>The 16-bit codes of the fast signals, a channel each, at their own rate; where samples were lost the next ones follow at once.</source>
        <translation>Die 16-Bit-Werte der schnellen Signale, je ein Kanal, in ihrer eigenen Rate; wo Werte verloren gingen, folgen sofort die nächsten.</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s), every sample with its time; what is unknown is NaN.</source>
        <translation>
            <numerusform>Ein Signal, jeder Wert mit seiner Zeit; Unbekanntes ist NaN.</numerusform>
            <numerusform>%n Signale, jeder Wert mit seiner Zeit; Unbekanntes ist NaN.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1-Dateien (*.%2)</translation>
    </message>
</context>
<context>
    <name>widgets::Exporting</name>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>Exportiert nach %1.</translation>
    </message>
    <message>
        <source>The motion log is in %1.</source>
        <translation>Das Bewegungsprotokoll liegt in %1.</translation>
    </message>
    <message>
        <source>The motion log %1 could not be written (%2).</source>
        <translation>Das Bewegungsprotokoll %1 konnte nicht geschrieben werden (%2).</translation>
    </message>
    <message>
        <source>The picture of the scope is in the clipboard.</source>
        <translation>Das Bild des Oszilloskops ist in der Zwischenablage.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>An export is under way.</source>
        <translation>Ein Export läuft.</translation>
    </message>
    <message>
        <source>Without it there is no file.</source>
        <translation>Ohne ihn gibt es keine Datei.</translation>
    </message>
    <message>
        <source>Close when it is written</source>
        <translation>Schließen, wenn er geschrieben ist</translation>
    </message>
    <message>
        <source>Close without it</source>
        <translation>Ohne ihn schließen</translation>
    </message>
    <message>
        <source>The recording is still being read: its outline is not exported.</source>
        <translation>Die Aufzeichnung wird noch gelesen: ihr Umriss wird nicht exportiert.</translation>
    </message>
    <message>
        <source>%1 holds no samples: there are none in the chosen range.</source>
        <translation>%1 enthält keine Abtastwerte: Im gewählten Bereich gibt es keine.</translation>
    </message>
</context>
<context>
    <name>widgets::FaultHelp</name>
    <message>
        <source>Faults and their causes</source>
        <translation>Fehler und ihre Ursachen</translation>
    </message>
    <message>
        <source>Faults are not known</source>
        <translation>Fehler sind nicht bekannt</translation>
    </message>
    <message>
        <source>Motor %1 has no fault.</source>
        <translation>Motor %1 hat keinen Fehler.</translation>
    </message>
    <message>
        <source>Present at motor %1</source>
        <translation>An Motor %1 vorhanden</translation>
    </message>
    <message>
        <source>Over, to be acknowledged</source>
        <translation>Vorbei, zu quittieren</translation>
    </message>
</context>
<context>
    <name>widgets::FaultPicture</name>
    <message>
        <source>%1, motor %2: %3</source>
        <comment>time, number, faults</comment>
        <translation>%1, Motor %2: %3</translation>
    </message>
    <message>
        <source>Recorded fault</source>
        <translation>Aufgezeichneter Fehler</translation>
    </message>
    <message>
        <source>Recording what follows…</source>
        <translation>Zeichnet auf, was folgt …</translation>
    </message>
    <message>
        <source>No signal was recorded when this fault came. Drag signals onto the scope: then the next one has a picture.</source>
        <translation>Als dieser Fehler kam, wurde kein Signal aufgezeichnet. Ziehen Sie Signale auf das Oszilloskop: dann hat der nächste ein Bild.</translation>
    </message>
    <message>
        <source>When it was told (0 s): %1</source>
        <comment>values of signals</comment>
        <translation>Als er gemeldet wurde (0 s): %1</translation>
    </message>
    <message>
        <source>Signals around the fault</source>
        <translation>Signale um den Fehler</translation>
    </message>
</context>
<context>
    <name>widgets::FileJob</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Being cancelled…</source>
        <translation>Wird abgebrochen …</translation>
    </message>
    <message>
        <source>%1: about %2 s left</source>
        <comment>what is done, a number</comment>
        <translation>%1: noch etwa %2 s</translation>
    </message>
</context>
<context>
    <name>widgets::FirstSteps</name>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Help &gt; First steps brings these cards back.</source>
        <translation>Hilfe &gt; Erste Schritte zeigt diese Karten wieder.</translation>
    </message>
    <message>
        <source>Welcome to Rotorscope</source>
        <translation>Willkommen bei Rotorscope</translation>
    </message>
    <message>
        <source>Try everything on a simulated board, or choose the port of your own board above.</source>
        <translation>Probieren Sie alles an einem simulierten Board aus, oder wählen Sie oben die Schnittstelle Ihres eigenen Boards.</translation>
    </message>
    <message>
        <source>Connect to simulated board</source>
        <translation>Mit dem simulierten Board verbinden</translation>
    </message>
    <message>
        <source>Connect my board</source>
        <translation>Mein Board verbinden</translation>
    </message>
    <message>
        <source>Connected: the scope shows live signals</source>
        <translation>Verbunden: Das Oszilloskop zeigt Signale live</translation>
    </message>
    <message>
        <source>Tick &quot;Arm&quot; on the right, then press Start. The Esc key stops every motor, wherever you are.</source>
        <translation>Setzen Sie rechts den Haken bei „Freigeben“ und drücken Sie dann Starten. Die Esc-Taste stoppt jeden Motor, wo immer Sie sind.</translation>
    </message>
    <message>
        <source>The motor is running</source>
        <translation>Der Motor läuft</translation>
    </message>
    <message>
        <source>Type another speed and press Enter. Drag a register from the list onto the scope to see it too.</source>
        <translation>Geben Sie eine andere Drehzahl ein und drücken Sie die Eingabetaste. Ziehen Sie ein Register aus der Liste auf das Oszilloskop, um es ebenfalls zu sehen.</translation>
    </message>
    <message>
        <source>Save what you see</source>
        <translation>Speichern, was Sie sehen</translation>
    </message>
    <message>
        <source>The export writes the visible part, or all of it, as a CSV file with units.</source>
        <translation>Der Export schreibt den sichtbaren Teil oder alles als CSV-Datei mit Einheiten.</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>CSV exportieren</translation>
    </message>
</context>
<context>
    <name>widgets::GainForecast</name>
    <message>
        <source>%1 to %2</source>
        <comment>percent</comment>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>No prediction yet.</source>
        <translation>Noch keine Vorhersage.</translation>
    </message>
    <message>
        <source>Asked %1, at the motor %2 rad/s (%3 Hz). Rise %4 ms, overshoot %5 %, margin %6°.</source>
        <translation>Verlangt %1, am Motor %2 rad/s (%3 Hz). Anstieg %4 ms, Überschwingen %5 %, Reserve %6°.</translation>
    </message>
    <message>
        <source>Rise with a timer that takes the new voltage at once, as on the simulated board. One that takes it a period later rises quicker and overshoots more.</source>
        <translation>Anstieg mit einem Timer, der die neue Spannung sofort übernimmt, wie auf dem simulierten Board. Einer, der sie eine Periode später übernimmt, steigt schneller und schwingt weiter über.</translation>
    </message>
    <message>
        <source>The speed loop stays as it is.</source>
        <translation>Der Drehzahlregler bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>Rise %1 ms, margin %2°. Overshoot %3 %, behind a ramp %4 %.</source>
        <translation>Anstieg %1 ms, Reserve %2°. Überschwingen %3 %, hinter einer Rampe %4 %.</translation>
    </message>
    <message>
        <source>For steps up to %1 rpm.</source>
        <translation>Für Sprünge bis %1 rpm.</translation>
    </message>
    <message>
        <source>Everything between the wish and the measured speed is %1 ms late. A larger step needs more than the nominal current, and rises more slowly.</source>
        <translation>Alles zwischen Wunsch und gemessener Drehzahl kommt %1 ms spät. Ein größerer Sprung braucht mehr als den Nennstrom und steigt langsamer.</translation>
    </message>
</context>
<context>
    <name>widgets::GainLab</name>
    <message>
        <source>Current bandwidth</source>
        <translation>Strombandbreite</translation>
    </message>
    <message>
        <source>Speed damping</source>
        <translation>Dämpfung Drehzahl</translation>
    </message>
    <message>
        <source>As ST&apos;s rule counts it; the loop at the motor is 15 % faster.</source>
        <translation>So, wie die Regel von ST sie zählt; am Motor ist der Regler 15 % schneller.</translation>
    </message>
    <message>
        <source>Also plan the speed loop. Damping 2 is quick and rings, 4 is calm.</source>
        <translation>Auch den Drehzahlregler auslegen. Dämpfung 2 ist flink und schwingt nach, 4 ist ruhig.</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzug</translation>
    </message>
    <message>
        <source>Delay of the measured speed</source>
        <translation>Verzug der gemessenen Drehzahl</translation>
    </message>
    <message>
        <source>How late the measured speed is: half the length of its average. The board does not say it; this is what ST&apos;s generator takes for its sensor.</source>
        <translation>Wie spät die gemessene Drehzahl kommt: die halbe Länge ihrer Mittelung. Das Board sagt es nicht; das hier nimmt der Generator von ST für seinen Sensor.</translation>
    </message>
    <message>
        <source>From the &amp;board</source>
        <translation>Vom Boa&amp;rd</translation>
    </message>
    <message>
        <source>&amp;Preview</source>
        <translation>&amp;Vorschau</translation>
    </message>
    <message>
        <source>Connect a board: the gains are for its registers.</source>
        <translation>Verbinden Sie ein Board: Die Verstärkungen sind für seine Register.</translation>
    </message>
    <message>
        <source>This board&apos;s firmware does not let %1 be written.</source>
        <translation>Die Firmware dieses Boards lässt %1 nicht schreiben.</translation>
    </message>
    <message>
        <source>Type a bandwidth.</source>
        <translation>Geben Sie eine Bandbreite ein.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>field, what is wrong with it</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Type a damping from 1.05 to 20, or leave the speed loop out.</source>
        <translation>Geben Sie eine Dämpfung von 1,05 bis 20 ein, oder lassen Sie den Drehzahlregler weg.</translation>
    </message>
    <message>
        <source>Makes edits of the new numbers, numerator and divisor together. Nothing is written before Apply.</source>
        <translation>Macht aus den neuen Zahlen Änderungen, Zähler und Teiler gemeinsam. Geschrieben wird erst beim Anwenden.</translation>
    </message>
    <message>
        <source>This drive&apos;s gains are numbers in units, and its current loop is not the one whose rule is used here: set them among the regulators.</source>
        <translation>Die Verstärkungen dieses Antriebs sind Zahlen mit Einheit, und sein Stromregler ist nicht der, dessen Regel hier gilt: Stellen Sie sie unter „Regler“ ein.</translation>
    </message>
    <message>
        <source>Forgets what was typed here and what was measured, and takes the board&apos;s numbers again.</source>
        <translation>Vergisst, was hier getippt und was gemessen wurde, und nimmt wieder die Zahlen des Boards.</translation>
    </message>
</context>
<context>
    <name>widgets::GainMotor</name>
    <message>
        <source>Rs</source>
        <translation>Rs</translation>
    </message>
    <message>
        <source>Lq</source>
        <translation>Lq</translation>
    </message>
    <message>
        <source>Ld</source>
        <translation>Ld</translation>
    </message>
    <message>
        <source>Pole pairs</source>
        <translation>Polpaare</translation>
    </message>
    <message>
        <source>Flux</source>
        <translation>Fluss</translation>
    </message>
    <message>
        <source>Ke</source>
        <translation>Ke</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>Of a phase: half of what is measured between two wires.</source>
        <translation>Einer Phase: die Hälfte dessen, was zwischen zwei Drähten gemessen wird.</translation>
    </message>
    <message>
        <source>Of the magnets, linked with a phase, peak.</source>
        <translation>Der Magnete, verkettet mit einer Phase, Scheitelwert.</translation>
    </message>
    <message>
        <source>Volts rms between two wires at 1000 rpm. The same as the flux: one follows the other.</source>
        <translation>Volt effektiv zwischen zwei Drähten bei 1000 rpm. Dasselbe wie der Fluss: Eins folgt dem anderen.</translation>
    </message>
    <message>
        <source>Of rotor and load together; boards rarely know it. It is remembered for motors of this name. 1 kg·m² = 10,000,000 g·cm².</source>
        <translation>Von Rotor und Last zusammen; Boards kennen sie selten. Sie wird für Motoren dieses Namens gemerkt. 1 kg·m² = 10.000.000 g·cm².</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>field, what is wrong with it</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <comment>quantity, least and greatest value</comment>
        <translation>%1 von %2 bis %3</translation>
    </message>
    <message>
        <source>Measured, with 95 %: %1.</source>
        <translation>Gemessen, mit 95 %: %1.</translation>
    </message>
    <message>
        <source>Measured, without an interval: %1.</source>
        <translation>Gemessen, ohne Intervall: %1.</translation>
    </message>
</context>
<context>
    <name>widgets::GainPlanTable</name>
    <message>
        <source>Planned gains</source>
        <translation>Geplante Verstärkungen</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Board</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>At the motor</source>
        <translation>Am Motor</translation>
    </message>
    <message>
        <source>Rounding</source>
        <translation>Rundung</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>How many times larger the number could be before it, or its product with the largest error, overflows.</source>
        <translation>Wievielmal größer die Zahl sein dürfte, bevor sie oder ihr Produkt mit dem größten Fehler überläuft.</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>bleibt</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>widgets::GainPlot</name>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>— new   - - board</source>
        <translation>— neu   - - Board</translation>
    </message>
</context>
<context>
    <name>widgets::GainTable</name>
    <message>
        <source>Torque (Iq)</source>
        <translation>Drehmoment (Iq)</translation>
    </message>
    <message>
        <source>Flux (Id)</source>
        <translation>Fluss (Id)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Flux weakening</source>
        <translation>Feldschwächung</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Observer&apos;s PLL</source>
        <translation>PLL des Beobachters</translation>
    </message>
    <message>
        <source>Observer (C1, C2)</source>
        <translation>Beobachter (C1, C2)</translation>
    </message>
    <message>
        <source>CORDIC observer (C1, C2)</source>
        <translation>CORDIC-Beobachter (C1, C2)</translation>
    </message>
    <message>
        <source>Currents</source>
        <translation>Ströme</translation>
    </message>
    <message>
        <source>No gains: connect a board.</source>
        <translation>Keine Verstärkungen: Verbinden Sie ein Board.</translation>
    </message>
    <message>
        <source>Proportional</source>
        <translation>Proportional</translation>
    </message>
    <message>
        <source>Integral</source>
        <translation>Integral</translation>
    </message>
    <message>
        <source>Derivative</source>
        <translation>Differential</translation>
    </message>
    <message>
        <source>This board&apos;s firmware has no gains to be tuned.</source>
        <translation>Die Firmware dieses Boards hat keine einstellbaren Verstärkungen.</translation>
    </message>
    <message>
        <source>≈ %1 rad/s, damping %2</source>
        <translation>≈ %1 rad/s, Dämpfung %2</translation>
    </message>
    <message>
        <source>Natural frequency of the PLL at half the highest speed, if the observer&apos;s full scale is 1.2 times that speed, as ST&apos;s generator has it.</source>
        <translation>Eigenfrequenz der PLL bei halber Höchstdrehzahl, wenn der Vollausschlag des Beobachters beim 1,2-Fachen der Höchstdrehzahl liegt, wie beim Generator von ST.</translation>
    </message>
    <message>
        <source>This firmware counts per unit and does not say of what.</source>
        <translation>Diese Firmware rechnet in bezogenen Größen und sagt nicht, worauf.</translation>
    </message>
    <message>
        <source>Not read yet.</source>
        <translation>Noch nicht gelesen.</translation>
    </message>
</context>
<context>
    <name>widgets::GainsForm</name>
    <message>
        <source>Pages of the gains</source>
        <translation>Seiten der Verstärkungen</translation>
    </message>
    <message>
        <source>&amp;Regulators</source>
        <translation>Regl&amp;er</translation>
    </message>
    <message>
        <source>Gain &amp;lab</source>
        <translation>&amp;Labor</translation>
    </message>
    <message>
        <source>Board: %1 V, %2 digits per A, %3 kHz, speed loop %4 kHz</source>
        <translation>Board: %1 V, %2 Digits je A, %3 kHz, Drehzahlregler %4 kHz</translation>
    </message>
    <message>
        <source>This board does not say what its digits are worth.</source>
        <translation>Dieses Board sagt nicht, was seine Digits bedeuten.</translation>
    </message>
    <message>
        <source>A write is under way: preview again when it has ended.</source>
        <translation>Es wird gerade geschrieben: danach noch einmal Vorschau.</translation>
    </message>
    <message>
        <source>%1 cannot be edited now.</source>
        <translation>%1 kann gerade nicht geändert werden.</translation>
    </message>
    <message numerus="yes">
        <source>%n edit(s) wait: Apply writes them as one step.</source>
        <translation>
            <numerusform>%n Änderung wartet: Anwenden schreibt sie.</numerusform>
            <numerusform>%n Änderungen warten: Anwenden schreibt sie in einem Schritt.</numerusform>
        </translation>
    </message>
    <message>
        <source>The board has these gains already.</source>
        <translation>Das Board hat diese Verstärkungen schon.</translation>
    </message>
    <message numerus="yes">
        <source>%n other edit(s) waited already and would be written with them: %1.</source>
        <translation>
            <numerusform>%n andere Änderung wartete schon und würde mitgeschrieben: %1.</numerusform>
            <numerusform>%n andere Änderungen warteten schon und würden mitgeschrieben: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The gains of this drive are in the units that stand beside them.</source>
        <translation>Die Verstärkungen dieses Antriebs haben die Einheiten, die neben ihnen stehen.</translation>
    </message>
    <message>
        <source>The form has changed: the edits of its preview were dropped.</source>
        <translation>Das Formular hat sich geändert: Die Änderungen seiner Vorschau wurden verworfen.</translation>
    </message>
    <message>
        <source>Edited by hand, not as planned here: %1. Apply writes what was edited.</source>
        <translation>Von Hand geändert, nicht wie hier geplant: %1. Anwenden schreibt das Geänderte.</translation>
    </message>
</context>
<context>
    <name>widgets::GiveBack</name>
    <message>
        <source>Give back</source>
        <translation>Zurückgeben</translation>
    </message>
    <message>
        <source>As before the experiment</source>
        <comment>name of a step of the list of edits</comment>
        <translation>Wie vor dem Versuch</translation>
    </message>
    <message>
        <source>An experiment is running.</source>
        <translation>Ein Versuch läuft.</translation>
    </message>
    <message>
        <source>The motor has to rest: stop it first.</source>
        <translation>Der Motor muss ruhen: erst stoppen.</translation>
    </message>
    <message>
        <source>Writes what the registers held before the experiment, and reads it back</source>
        <translation>Schreibt, was vor dem Versuch in den Registern stand, und liest es zurück</translation>
    </message>
</context>
<context>
    <name>widgets::Identification</name>
    <message>
        <source>Not conclusive: %1</source>
        <translation>Nicht schlüssig: %1</translation>
    </message>
</context>
<context>
    <name>widgets::IdentifyPage</name>
    <message>
        <source>What was measured of the motor</source>
        <translation>Was am Motor gemessen wurde</translation>
    </message>
    <message>
        <source>Measures resistance and dead time at rest, then inductances and flux while it turns; then the motor is as it was.</source>
        <translation>Misst Widerstand und Totzeit im Stillstand, dann Induktivitäten und Fluss im Lauf; danach ist der Motor wie zuvor.</translation>
    </message>
    <message>
        <source>&amp;Use in motor file</source>
        <translation>In Motordatei &amp;übernehmen</translation>
    </message>
    <message>
        <source>Puts the measured figures into the description beside the board&apos;s, in Motor and drive; nothing is written to the board.</source>
        <translation>Übernimmt die gemessenen Werte in die Beschreibung neben der des Boards, in „Motor und Antrieb“; auf das Board wird nichts geschrieben.</translation>
    </message>
    <message>
        <source>Take &amp;back</source>
        <translation>&amp;Zurücknehmen</translation>
    </message>
    <message>
        <source>Takes them out of it again.</source>
        <translation>Nimmt sie dort wieder heraus.</translation>
    </message>
    <message>
        <source>E&amp;lectrical</source>
        <translation>E&amp;lektrisch</translation>
    </message>
    <message>
        <source>Mecha&amp;nical</source>
        <translation>Mecha&amp;nisch</translation>
    </message>
    <message>
        <source>Po&amp;wer</source>
        <translation>Leis&amp;tung</translation>
    </message>
    <message>
        <source>Measures what goes into the motor and what its shaft gives, at the speed that it has.</source>
        <translation>Misst, was in den Motor hineingeht und was seine Welle abgibt, bei der Drehzahl, die er hat.</translation>
    </message>
    <message>
        <source>In both di&amp;rections</source>
        <translation>In beide &amp;Richtungen</translation>
    </message>
    <message>
        <source>The mechanics backwards, too, from rest: only that tells friction from a torque that is always there. Not for loads that must not turn backwards, or that turn the motor by themselves.</source>
        <translation>Die Mechanik auch rückwärts, aus dem Stillstand: Nur das unterscheidet Reibung von einem Drehmoment, das immer da ist. Nicht für Lasten, die sich nicht rückwärts drehen dürfen oder den Motor von selbst drehen.</translation>
    </message>
    <message>
        <source>Speed by a tachometer</source>
        <translation>Drehzahl nach einem Drehzahlmesser</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>For the pole pairs: let the motor run at a constant speed, type what a tachometer reads at its shaft, and press Enter.</source>
        <translation>Für die Polpaarzahl: den Motor mit gleichbleibender Drehzahl laufen lassen, eingeben, was ein Drehzahlmesser an der Welle anzeigt, und Enter drücken.</translation>
    </message>
    <message>
        <source>By a tach&amp;ometer [rpm]</source>
        <translation>Na&amp;ch Drehzahlmesser [rpm]</translation>
    </message>
    <message>
        <source>Measures inertia and friction while the motor gets faster and slower; then it is as it was.</source>
        <translation>Misst Trägheit und Reibung, während der Motor schneller und langsamer wird; danach ist er, wie er war.</translation>
    </message>
</context>
<context>
    <name>widgets::Jog</name>
    <message>
        <source>Jog</source>
        <translation>Tippen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Jogging needs a limit of speed: set one of your own.</source>
        <translation>Tippen braucht eine Grenze der Drehzahl: legen Sie eine eigene fest.</translation>
    </message>
</context>
<context>
    <name>widgets::JogBox</name>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>Jog backwards while held</source>
        <translation>Tippen rückwärts, solange gehalten</translation>
    </message>
    <message>
        <source>Jog forwards while held</source>
        <translation>Tippen vorwärts, solange gehalten</translation>
    </message>
    <message>
        <source>Jog speed in rpm</source>
        <translation>Drehzahl beim Tippen in rpm</translation>
    </message>
    <message>
        <source>Jog [rpm]</source>
        <translation>Tippen [rpm]</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>Turns the motor while it is held, with the pointer or the Enter key; letting go stops it.</source>
        <translation>Dreht den Motor, solange gehalten wird, mit dem Zeiger oder der Eingabetaste; Loslassen stoppt ihn.</translation>
    </message>
    <message>
        <source>The motor is being jogged.</source>
        <translation>Der Motor läuft im Tippbetrieb.</translation>
    </message>
    <message>
        <source>Give a speed to jog at.</source>
        <translation>Geben Sie eine Drehzahl zum Tippen an.</translation>
    </message>
</context>
<context>
    <name>widgets::KeyedPlot</name>
    <message>
        <source>Wheel or + and −: zoom. Drag or arrows: move. F: everything.</source>
        <translation>Rad oder + und −: Zoom. Ziehen oder Pfeile: verschieben. F: alles.</translation>
    </message>
</context>
<context>
    <name>widgets::Leaving</name>
    <message>
        <source>Stop motors</source>
        <translation>Motoren stoppen</translation>
    </message>
    <message>
        <source>Rotorscope has told every motor to stop, but there is no evidence that they did. A motor may still be turning.</source>
        <translation>Rotorscope hat jedem Motor den Stopp gesagt, aber nichts belegt, dass sie stehen. Vielleicht dreht sich noch ein Motor.</translation>
    </message>
    <message>
        <source>No port is open that could carry a stop. A motor may still be turning, and nothing tells how fast.</source>
        <translation>Keine Schnittstelle ist offen, die einen Stopp übertragen könnte. Vielleicht dreht sich noch ein Motor, und nichts sagt, wie schnell.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
    <message>
        <source>Leave running?</source>
        <translation>Laufen lassen?</translation>
    </message>
    <message>
        <source>Leave the motors as they are?</source>
        <translation>Die Motoren lassen, wie sie sind?</translation>
    </message>
    <message>
        <source>They may go on turning, and nothing will watch them.</source>
        <translation>Sie drehen vielleicht weiter, und nichts überwacht sie.</translation>
    </message>
    <message>
        <source>Leave running</source>
        <translation>Laufen lassen</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>The experiment leaves something on the board.</source>
        <translation>Der Versuch hinterlässt etwas auf dem Board.</translation>
    </message>
    <message>
        <source>Leave it so</source>
        <translation>So lassen</translation>
    </message>
    <message>
        <source>Stopping the motors before the port is closed…</source>
        <translation>Die Motoren werden gestoppt, bevor die Schnittstelle geschlossen wird …</translation>
    </message>
    <message>
        <source>Disconnect all the same…</source>
        <translation>Trotzdem trennen …</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>A motor is not idle.</source>
        <translation>Ein Motor ist nicht in Ruhe.</translation>
    </message>
    <message>
        <source>Without a connection nothing watches it, and this program cannot stop it.</source>
        <translation>Ohne Verbindung überwacht ihn nichts, und dieses Programm kann ihn nicht stoppen.</translation>
    </message>
    <message>
        <source>Stop motors, then disconnect</source>
        <translation>Motoren stoppen, dann trennen</translation>
    </message>
    <message>
        <source>Stay connected</source>
        <translation>Verbunden bleiben</translation>
    </message>
</context>
<context>
    <name>widgets::LimitsDialog</name>
    <message>
        <source>Own limits</source>
        <translation>Eigene Grenzen</translation>
    </message>
    <message>
        <source>none</source>
        <comment>no limit</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>No set-point beyond these is sent, to any motor and any board. Where the board&apos;s own limits are lower, those count. Leave a field empty for no limit of your own.</source>
        <translation>Kein Sollwert über diesen Grenzen wird gesendet, an keinen Motor und kein Board. Wo die Grenzen des Boards niedriger sind, gelten diese. Ein leeres Feld heißt: keine eigene Grenze.</translation>
    </message>
    <message>
        <source>Greatest &amp;speed [rpm]</source>
        <translation>Höchste &amp;Drehzahl [rpm]</translation>
    </message>
    <message>
        <source>Greatest &amp;current [A]</source>
        <translation>Höchster &amp;Strom [A]</translation>
    </message>
    <message>
        <source>A limit is a plain number above 0, or nothing.</source>
        <translation>Eine Grenze ist eine einfache Zahl über 0 oder nichts.</translation>
    </message>
</context>
<context>
    <name>widgets::LinkNews</name>
    <message>
        <source>This firmware is not known: registers are shown raw and nothing is written.</source>
        <translation>Diese Firmware ist nicht bekannt: Register werden roh gezeigt, und nichts wird geschrieben.</translation>
    </message>
    <message>
        <source>Link lost. %1 %2</source>
        <translation>Verbindung verloren. %1 %2</translation>
    </message>
</context>
<context>
    <name>widgets::LiveGain</name>
    <message>
        <source>Arrow keys or the wheel: 5 % a notch, written at once. Undo takes it back.</source>
        <translation>Pfeiltasten oder Rad: 5 % je Raste, sofort geschrieben. Rückgängig nimmt es zurück.</translation>
    </message>
</context>
<context>
    <name>widgets::LoopRows</name>
    <message>
        <source>Loop</source>
        <translation>Regelkreis</translation>
    </message>
    <message>
        <source>Kp</source>
        <translation>Kp</translation>
    </message>
    <message>
        <source>Ki</source>
        <translation>Ki</translation>
    </message>
    <message>
        <source>Crossover</source>
        <translation>Durchtritt</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>Ms</source>
        <translation>Ms</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>Anstieg</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
</context>
<context>
    <name>widgets::LoopTuning</name>
    <message>
        <source>Kp %1, Ki %2</source>
        <comment>digits</comment>
        <translation>Kp %1, Ki %2</translation>
    </message>
    <message>
        <source>The gains are being read.</source>
        <translation>Die Verstärkungen werden gelesen.</translation>
    </message>
    <message>
        <source>Not conclusive: %1</source>
        <translation>Nicht schlüssig: %1</translation>
    </message>
    <message>
        <source>Measure the response of the speed first.</source>
        <translation>Zuerst den Frequenzgang der Drehzahl messen.</translation>
    </message>
    <message>
        <source>An experiment is running.</source>
        <translation>Ein Versuch läuft.</translation>
    </message>
    <message>
        <source>The board holds these gains.</source>
        <translation>Das Board hat diese Verstärkungen.</translation>
    </message>
    <message>
        <source>gains of the speed loop, %1</source>
        <translation>Verstärkungen des Drehzahlreglers, %1</translation>
    </message>
    <message>
        <source>No gains were written from here.</source>
        <translation>Von hier wurden keine Verstärkungen geschrieben.</translation>
    </message>
    <message>
        <source>back to %1</source>
        <translation>zurück zu %1</translation>
    </message>
    <message>
        <source>The loop keeps what was predicted: Ms %1, at most %2 promised.</source>
        <translation>Der Regelkreis hält, was vorhergesagt war: Ms %1, zugesagt höchstens %2.</translation>
    </message>
    <message>
        <source>Neither proved nor refuted: the loop&apos;s gain does not fall through 1 where it could be measured. &quot;Back to the old gains&quot; brings them back.</source>
        <translation>Weder bestätigt noch widerlegt: Die Verstärkung des Regelkreises fällt nicht dort durch 1, wo sie gemessen werden konnte. „Zurück zu den alten Verstärkungen“ holt die alten Verstärkungen zurück.</translation>
    </message>
    <message>
        <source>It swings with its gains. The next response is measured with %1, and the old gains come back afterwards.</source>
        <translation>Mit diesen Verstärkungen schwingt er. Der nächste Frequenzgang wird mit %1 gemessen; danach kommen die alten zurück.</translation>
    </message>
    <message>
        <source>Worse than predicted: Ms %1, at most %2 promised. Nearer gains are proposed from this response; &quot;Back to the old gains&quot; brings those back.</source>
        <translation>Schlechter als vorhergesagt: Ms %1, versprochen höchstens %2. Aus diesem Frequenzgang werden nähere vorgeschlagen; „Zurück zu den alten Verstärkungen“ holt die alten zurück.</translation>
    </message>
    <message>
        <source>Slower than predicted: crossover %1 Hz instead of %2 Hz. Nearer gains are proposed from this response; &quot;Back to the old gains&quot; brings those back.</source>
        <translation>Langsamer als vorhergesagt: Durchtritt %1 Hz statt %2 Hz. Aus diesem Frequenzgang werden nähere vorgeschlagen; „Zurück zu den alten Verstärkungen“ holt die alten zurück.</translation>
    </message>
    <message>
        <source>Nothing is proved: response and steps did not both come to their end.</source>
        <translation>Nichts ist nachgewiesen: Frequenzgang und Sprünge kamen nicht beide zu ihrem Ende.</translation>
    </message>
    <message>
        <source>Worse than predicted: its steps overshoot by %1 % instead of %2 %. Nearer gains are proposed from this response; &quot;Back to the old gains&quot; brings those back.</source>
        <translation>Schlechter als vorhergesagt: Die Sprünge schwingen um %1 % über statt um %2 %. Aus diesem Frequenzgang werden passendere Verstärkungen vorgeschlagen; „Zurück zu den alten Verstärkungen“ stellt jene wieder her.</translation>
    </message>
    <message>
        <source>Neither proved nor refuted: the overshoot of its steps could not be measured. &quot;Back to the old gains&quot; brings them back.</source>
        <translation>Weder nachgewiesen noch widerlegt: Das Überschwingen der Sprünge war nicht messbar. „Zurück zu den alten Verstärkungen“ stellt sie wieder her.</translation>
    </message>
</context>
<context>
    <name>widgets::MainWindow</name>
    <message>
        <source>Registers</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>&amp;Gerät</translation>
    </message>
    <message>
        <source>&amp;Connect or disconnect</source>
        <translation>&amp;Verbinden oder trennen</translation>
    </message>
    <message>
        <source>&amp;Refresh the list of ports</source>
        <translation>Liste der Schnittstellen au&amp;ffrischen</translation>
    </message>
    <message>
        <source>&amp;Motor</source>
        <translation>&amp;Motor</translation>
    </message>
    <message>
        <source>&amp;Scope</source>
        <translation>&amp;Oszilloskop</translation>
    </message>
    <message>
        <source>&amp;Earlier</source>
        <translation>&amp;Früher</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>&amp;Clear what was recorded</source>
        <translation>Aufgezeichnetes &amp;löschen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>&amp;Erste Schritte</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>&amp;About Rotorscope</source>
        <translation>Ü&amp;ber Rotorscope</translation>
    </message>
    <message>
        <source>&amp;Find a register</source>
        <translation>Ein Register &amp;suchen</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>Like the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>St&amp;op motors</source>
        <translation>Motoren st&amp;oppen</translation>
    </message>
    <message>
        <source>A&amp;rm</source>
        <translation>F&amp;reigeben</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>&amp;Acknowledge faults</source>
        <translation>Fehler &amp;quittieren</translation>
    </message>
    <message>
        <source>&amp;Go to the set-point</source>
        <translation>Den Sollwert &amp;anfahren</translation>
    </message>
    <message>
        <source>S&amp;top the ramp</source>
        <translation>Die Ram&amp;pe anhalten</translation>
    </message>
    <message>
        <source>%1 – Rotorscope</source>
        <comment>what is connected</comment>
        <translation>%1 – Rotorscope</translation>
    </message>
    <message>
        <source>Simulated board</source>
        <translation>Simuliertes Board</translation>
    </message>
    <message>
        <source>Stopping the motors before Rotorscope ends…</source>
        <translation>Die Motoren werden gestoppt, bevor Rotorscope endet…</translation>
    </message>
    <message>
        <source>End Rotorscope all the same…</source>
        <translation>Rotorscope trotzdem beenden…</translation>
    </message>
    <message>
        <source>Not live: %1</source>
        <comment>state of the link, e.g. board silent</comment>
        <translation>Nicht aktuell: %1</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Large &amp;numbers</source>
        <translation>Große &amp;Zahlen</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export…</translation>
    </message>
    <message>
        <source>Writes samples or a picture to a file (Ctrl+Shift+E)</source>
        <translation>Schreibt Abtastwerte oder ein Bild in eine Datei (Strg+Umschalt+E)</translation>
    </message>
    <message>
        <source>&amp;Open a recording…</source>
        <translation>Aufzeichnung ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>&amp;Import CSV…</source>
        <translation>CSV &amp;importieren …</translation>
    </message>
    <message>
        <source>&amp;Copy the picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Replay of %1</source>
        <translation>Wiedergabe von %1</translation>
    </message>
    <message>
        <source>Re&amp;play a recording…</source>
        <translation>Aufzeichnung &amp;wiedergeben…</translation>
    </message>
    <message>
        <source>R&amp;oom for samples…</source>
        <translation>&amp;Platz für Messwerte…</translation>
    </message>
    <message>
        <source>&amp;Faults and their causes…</source>
        <translation>&amp;Fehler und ihre Ursachen …</translation>
    </message>
    <message>
        <source>Open a &amp;workspace…</source>
        <translation>Arbeits&amp;platz öffnen …</translation>
    </message>
    <message>
        <source>Save the wor&amp;kspace…</source>
        <translation>Arbeitsplatz speic&amp;hern …</translation>
    </message>
    <message>
        <source>&amp;Arrange for</source>
        <translation>&amp;Anordnen für</translation>
    </message>
    <message>
        <source>&amp;Tuning</source>
        <translation>&amp;Abgleich</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>Au&amp;fzeichnung</translation>
    </message>
    <message>
        <source>&amp;Start-up</source>
        <translation>An&amp;lauf</translation>
    </message>
    <message>
        <source>The trigger&apos;s mode was %1 and is Roll now: the newest samples are followed.</source>
        <translation>Der Trigger stand auf %1 und steht jetzt auf Rollen: Das Bild folgt den neuesten Abtastwerten.</translation>
    </message>
    <message>
        <source>Open as a re&amp;ference…</source>
        <translation>Als &amp;Referenz öffnen …</translation>
    </message>
    <message>
        <source>Open recen&amp;t</source>
        <translation>Z&amp;uletzt verwendet</translation>
    </message>
    <message>
        <source>Signals of t&amp;he file</source>
        <translation>Signale der &amp;Datei</translation>
    </message>
</context>
<context>
    <name>widgets::MarkerFile</name>
    <message>
        <source>&amp;Save the markers…</source>
        <translation>&amp;Markierungen speichern…</translation>
    </message>
    <message>
        <source>Writes the markers into the recording, or into a copy of it (Ctrl+S)</source>
        <translation>Schreibt die Markierungen in die Aufzeichnung oder in eine Kopie davon (Strg+S)</translation>
    </message>
    <message>
        <source>Save the recording with its markers</source>
        <translation>Aufzeichnung mit ihren Markierungen speichern</translation>
    </message>
    <message>
        <source>Recordings (*.pcapng)</source>
        <translation>Aufzeichnungen (*.pcapng)</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Speichern von %1</translation>
    </message>
    <message>
        <source>The markers could not be saved to %1 (%2). What was there is as it was.</source>
        <translation>Die Markierungen konnten nicht in %1 gespeichert werden (%2). Was dort war, ist unverändert.</translation>
    </message>
    <message>
        <source>Saved with its markers: %1.</source>
        <translation>Mit ihren Markierungen gespeichert: %1.</translation>
    </message>
    <message>
        <source>There are no markers; M sets one (Ctrl+S)</source>
        <translation>Es gibt keine Markierungen; M setzt eine (Strg+S)</translation>
    </message>
    <message>
        <source>All markers are saved as they are (Ctrl+S)</source>
        <translation>Alle Markierungen sind so gespeichert, wie sie sind (Strg+S)</translation>
    </message>
    <message>
        <source>Writes the markers into the recording of the connection (Ctrl+S)</source>
        <translation>Schreibt die Markierungen in die Aufzeichnung der Verbindung (Strg+S)</translation>
    </message>
    <message>
        <source>Writes times and words of the markers to a list, because there is no recording that takes them (Ctrl+S)</source>
        <translation>Schreibt Zeiten und Worte der Markierungen in eine Liste, weil keine Aufzeichnung sie aufnehmen kann (Strg+S)</translation>
    </message>
    <message>
        <source>The recording is just being ended. Save the markers again when it has.</source>
        <translation>Die Aufzeichnung wird gerade beendet. Speichern Sie die Markierungen noch einmal, wenn sie beendet ist.</translation>
    </message>
    <message>
        <source>The markers are in the recording that runs.</source>
        <translation>Die Markierungen sind in der laufenden Aufzeichnung.</translation>
    </message>
    <message>
        <source>Save the markers as a list</source>
        <translation>Markierungen als Liste speichern</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSV-Dateien (*.csv)</translation>
    </message>
    <message>
        <source>The markers are in %1.</source>
        <translation>Die Markierungen sind in %1.</translation>
    </message>
    <message>
        <source>%1 is still being recorded, as it seems, and what comes would be lost. Save a copy under another name, or wait until the recording has ended.</source>
        <translation>%1 wird anscheinend noch aufgezeichnet, und was noch kommt, ginge verloren. Speichern Sie eine Kopie unter einem anderen Namen, oder warten Sie, bis die Aufzeichnung beendet ist.</translation>
    </message>
</context>
<context>
    <name>widgets::MathPanel</name>
    <message>
        <source>&amp;Remove</source>
        <translation>Ent&amp;fernen</translation>
    </message>
    <message>
        <source>Math channels</source>
        <translation>Mathematik-Kanäle</translation>
    </message>
    <message>
        <source>Letters of A to Z, digits and _; other formulas use it by this name.</source>
        <translation>Buchstaben A bis Z, Ziffern und _; andere Formeln benutzen den Kanal unter diesem Namen.</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>E&amp;infügen</translation>
    </message>
    <message>
        <source>There is no signal in it.</source>
        <translation>Es kommt kein Signal darin vor.</translation>
    </message>
    <message>
        <source>The name has to be of letters A to Z, digits and _.</source>
        <translation>Der Name muss aus Buchstaben A bis Z, Ziffern und _ bestehen.</translation>
    </message>
    <message>
        <source>The name is taken by a signal or a function.</source>
        <translation>So heißt schon ein Signal oder eine Funktion.</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>Hin&amp;zufügen</translation>
    </message>
    <message>
        <source>There is no room for more than %1.</source>
        <translation>Mehr als %1 haben nicht Platz.</translation>
    </message>
    <message>
        <source>Valid, unit %1</source>
        <translation>Gültig, Einheit %1</translation>
    </message>
    <message>
        <source>Valid, unit not known or a plain number</source>
        <translation>Gültig, Einheit unbekannt oder reine Zahl</translation>
    </message>
    <message>
        <source>Record it</source>
        <comment>a signal</comment>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Ne&amp;w</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Read&amp;y formulas</source>
        <translation>Fer&amp;tige Formeln</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>Nam&amp;e</translation>
    </message>
    <message>
        <source>F&amp;ormula</source>
        <translation>Forme&amp;l</translation>
    </message>
    <message>
        <source>Where a formula needs a signal of the board that is not on the scope, this puts it there.</source>
        <translation>Wo einer Formel ein Signal des Boards fehlt, das nicht im Oszilloskop ist, holt es dies dorthin.</translation>
    </message>
    <message>
        <source>The board has %1: puts it on the scope.</source>
        <comment>a signal</comment>
        <translation>Das Board hat %1: holt es ins Oszilloskop.</translation>
    </message>
    <message>
        <source>&amp;Change</source>
        <translation>Ände&amp;rn</translation>
    </message>
</context>
<context>
    <name>widgets::MathTable</name>
    <message>
        <source>waits for its signals</source>
        <translation>wartet auf seine Signale</translation>
    </message>
    <message>
        <source>no value yet</source>
        <translation>noch kein Wert</translation>
    </message>
    <message>
        <source>The tick draws it. It is computed either way.</source>
        <translation>Das Häkchen zeichnet den Kanal. Berechnet wird er so oder so.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Formel</translation>
    </message>
    <message>
        <source>Last value</source>
        <translation>Letzter Wert</translation>
    </message>
</context>
<context>
    <name>widgets::MeasurePanel</name>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>dem Bild</translation>
    </message>
    <message>
        <source>between the cursors</source>
        <translation>zwischen den Cursorn</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>Hin&amp;zufügen</translation>
    </message>
    <message>
        <source>&amp;Clear statistics</source>
        <translation>&amp;Statistik leeren</translation>
    </message>
    <message>
        <source>A&amp;gainst</source>
        <translation>Gege&amp;n</translation>
    </message>
    <message>
        <source>&amp;In</source>
        <translation>&amp;In</translation>
    </message>
    <message>
        <source>Rem&amp;ove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Co&amp;py</source>
        <translation>Ko&amp;pieren</translation>
    </message>
    <message>
        <source>T&amp;race</source>
        <translation>&amp;Kurve</translation>
    </message>
    <message>
        <source>Meas&amp;ure</source>
        <translation>Mess&amp;ung</translation>
    </message>
</context>
<context>
    <name>widgets::MeasureTable</name>
    <message>
        <source>%1 to %2</source>
        <comment>a phase between two traces</comment>
        <translation>%1 zu %2</translation>
    </message>
    <message>
        <source>too many samples: zoom in</source>
        <translation>zu viele Messwerte: hineinzoomen</translation>
    </message>
    <message>
        <source>%1 (samples are missing)</source>
        <translation>%1 (Messwerte fehlen)</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Mean</source>
        <comment>of a measurement over records</comment>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Records</source>
        <comment>number of records counted</comment>
        <translation>Aufnahmen</translation>
    </message>
</context>
<context>
    <name>widgets::MotionGate</name>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>not known</source>
        <comment>the old value</comment>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>%1 → start, then to %2</source>
        <comment>state now, speed it will go to</comment>
        <translation>%1 → Start, dann auf %2</translation>
    </message>
    <message>
        <source>speed %1 → %2 in %3 ms</source>
        <comment>old, new, time</comment>
        <translation>Drehzahl %1 → %2 in %3 ms</translation>
    </message>
    <message>
        <source>current Iq %1 → %2 in %3 ms</source>
        <comment>old, new, time</comment>
        <translation>Strom Iq %1 → %2 in %3 ms</translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <comment>number, change</comment>
        <translation>Motor %1: %2</translation>
    </message>
    <message>
        <source>Nothing moves now: press and hold again after you have agreed.</source>
        <translation>Jetzt bewegt sich nichts: Nach dem Zustimmen erneut drücken und halten.</translation>
    </message>
    <message>
        <source>position %1 → %2 in %3 ms</source>
        <comment>old, new, time</comment>
        <translation>Position %1 → %2 in %3 ms</translation>
    </message>
    <message>
        <source>The question was withdrawn, and nothing was sent: the board stopped answering for a moment. Press again to be asked again.</source>
        <translation>Die Frage wurde zurückgezogen, und nichts wurde gesendet: Das Board antwortete einen Moment nicht. Drücken Sie noch einmal, um wieder gefragt zu werden.</translation>
    </message>
    <message>
        <source>Nothing was sent: the board stopped answering for a moment, and the motor is not as it was asked about. Press again.</source>
        <translation>Nichts wurde gesendet: Das Board hat einen Moment nicht geantwortet, und der Motor ist nicht mehr so, wie gefragt wurde. Drücken Sie noch einmal.</translation>
    </message>
    <message>
        <source>Do not ask about steps up to %1 again until disarmed</source>
        <comment>set-point with unit</comment>
        <translation>Bis die Freigabe aufgehoben wird, nach Sprüngen bis %1 nicht mehr fragen</translation>
    </message>
    <message>
        <source>Iq %1 → %2, Id %3 → %4, immediately</source>
        <comment>old, new, old, new</comment>
        <translation>Iq %1 → %2, Id %3 → %4, sofort</translation>
    </message>
</context>
<context>
    <name>widgets::MotionLogModel</name>
    <message>
        <source>%1 (%2)</source>
        <comment>outcome, the board&apos;s word</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Act</source>
        <translation>Handlung</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Bytes sent</source>
        <translation>Gesendete Bytes</translation>
    </message>
</context>
<context>
    <name>widgets::MotionLogPanel</name>
    <message>
        <source>Motion log</source>
        <translation>Bewegungsprotokoll</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save the motion log</source>
        <translation>Bewegungsprotokoll speichern</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSV-Dateien (*.csv)</translation>
    </message>
    <message>
        <source>%1 earlier acts are left out.</source>
        <translation>%1 frühere Handlungen sind weggelassen.</translation>
    </message>
</context>
<context>
    <name>widgets::MotorConverter</name>
    <message>
        <source>Between two terminals, as a meter shows it: twice the phase.</source>
        <translation>Zwischen zwei Klemmen, wie ein Messgerät es zeigt: das Doppelte der Phase.</translation>
    </message>
    <message>
        <source>Of one phase of the star, as boards and formulas use it.</source>
        <translation>Einer Phase des Sterns, wie Boards und Formeln es verwenden.</translation>
    </message>
    <message>
        <source>&amp;Pole pairs</source>
        <translation>&amp;Polpaare</translation>
    </message>
    <message>
        <source>Half the number of magnets. Forgetting them is the usual mistake: λ is wrong by that factor.</source>
        <translation>Die halbe Zahl der Magnete. Sie zu vergessen ist der übliche Fehler: λ ist um diesen Faktor falsch.</translation>
    </message>
    <message>
        <source>&amp;Ke</source>
        <translation>&amp;Ke</translation>
    </message>
    <message>
        <source>V rms between two terminals at 1000 rpm, as ST gives it.</source>
        <translation>V effektiv zwischen zwei Klemmen bei 1000 rpm, wie ST es angibt.</translation>
    </message>
    <message>
        <source>rpm per volt, peak, between two terminals, as model motors are sold.</source>
        <translation>Umdrehungen je Minute und Volt, Scheitelwert zwischen zwei Klemmen, wie Modellmotoren verkauft werden.</translation>
    </message>
    <message>
        <source>λ (f&amp;lux)</source>
        <translation>λ (F&amp;luss)</translation>
    </message>
    <message>
        <source>λ = Ke · √2 / √3 / (p · 104.72 rad/s). Peak, of a phase.</source>
        <translation>λ = Ke · √2 / √3 / (p · 104,72 rad/s). Scheitelwert, einer Phase.</translation>
    </message>
    <message>
        <source>Kt = 3/2 · p · λ, per peak ampere.</source>
        <translation>Kt = 3/2 · p · λ, je Ampere Scheitelwert.</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>A voltmeter between two terminals while the shaft is turned: gives Ke and decides which of two data sheets is right.</source>
        <translation>Ein Voltmeter zwischen zwei Klemmen, während die Welle gedreht wird: ergibt Ke und entscheidet, welches von zwei Datenblättern stimmt.</translation>
    </message>
    <message>
        <source>at</source>
        <translation>bei</translation>
    </message>
    <message>
        <source>Speed of the shaft while the voltage was measured.</source>
        <translation>Drehzahl der Welle, während die Spannung gemessen wurde.</translation>
    </message>
    <message>
        <source>&amp;R, phase</source>
        <translation>&amp;R, Phase</translation>
    </message>
    <message>
        <source>terminals</source>
        <translation>Klemmen</translation>
    </message>
    <message>
        <source>L, phase</source>
        <translation>L, Phase</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <comment>name, unit</comment>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>It has to be greater than 0.</source>
        <translation>Es muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>Pole pairs are a whole number up to 100.</source>
        <translation>Polpaare sind eine ganze Zahl bis 100.</translation>
    </message>
    <message>
        <source>λ needs the pole pairs.</source>
        <translation>λ braucht die Polpaare.</translation>
    </message>
</context>
<context>
    <name>widgets::MotorFindings</name>
    <message>
        <source>of a phase with its switches, as warm as it is now</source>
        <translation>eines Strangs mit seinen Schaltern, so warm wie jetzt</translation>
    </message>
    <message>
        <source>what the bridge loses; a motor file does not hold it</source>
        <translation>was die Brücke verliert; steht in keiner Motordatei</translation>
    </message>
    <message>
        <source>viscous and dry friction and a fan</source>
        <translation>viskose und trockene Reibung und ein Lüfter</translation>
    </message>
    <message>
        <source>viscous and dry friction</source>
        <translation>viskose und trockene Reibung</translation>
    </message>
    <message>
        <source>Model: %1; it leaves %2 % of the torque.</source>
        <translation>Modell: %1; es lässt %2 % des Drehmoments offen.</translation>
    </message>
    <message>
        <source>a motor file does not hold it</source>
        <translation>steht in keiner Motordatei</translation>
    </message>
    <message>
        <source>none seen; at most %1</source>
        <translation>keiner zu sehen; höchstens %1</translation>
    </message>
    <message>
        <source>Resistance Rs</source>
        <translation>Widerstand Rs</translation>
    </message>
    <message>
        <source>Inductance Ld</source>
        <translation>Induktivität Ld</translation>
    </message>
    <message>
        <source>Inductance Lq</source>
        <translation>Induktivität Lq</translation>
    </message>
    <message>
        <source>Flux of the magnets</source>
        <translation>Fluss der Magnete</translation>
    </message>
    <message>
        <source>Inertia J</source>
        <translation>Trägheit J</translation>
    </message>
    <message>
        <source>Viscous friction</source>
        <translation>Viskose Reibung</translation>
    </message>
    <message>
        <source>Dry friction</source>
        <translation>Trockene Reibung</translation>
    </message>
    <message>
        <source>Fan</source>
        <translation>Lüfter</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>least and greatest value</comment>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>With 95 %</source>
        <translation>Mit 95 %</translation>
    </message>
    <message>
        <source>On the board</source>
        <translation>Auf dem Board</translation>
    </message>
    <message>
        <source>In the motor file</source>
        <translation>In der Motordatei</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Anmerkungen</translation>
    </message>
    <message>
        <source>Voltage of dead times</source>
        <translation>Spannung der Totzeiten</translation>
    </message>
    <message>
        <source>%1 forwards, %2 backwards.</source>
        <comment>inertia</comment>
        <translation>%1 vorwärts, %2 rückwärts.</translation>
    </message>
    <message>
        <source>beside it %1 that is always there; above 0 it hinders forwards</source>
        <comment>torque</comment>
        <translation>daneben %1, das immer da ist; über 0 hemmt es vorwärts</translation>
    </message>
    <message>
        <source>Pole pairs</source>
        <translation>Polpaare</translation>
    </message>
    <message>
        <source>%1 by a tachometer</source>
        <comment>pole pairs</comment>
        <translation>%1 nach einem Drehzahlmesser</translation>
    </message>
</context>
<context>
    <name>widgets::MotorForm</name>
    <message>
        <source>Reading the motor&apos;s values</source>
        <translation>Lesen der Motorwerte</translation>
    </message>
    <message>
        <source>Read a&amp;gain</source>
        <translation>&amp;Neu lesen</translation>
    </message>
    <message>
        <source>Reads these values from the board again; they are not polled.</source>
        <translation>Liest diese Werte erneut vom Board; sie werden nicht laufend abgefragt.</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>Datei ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Lays a motor file beside the board: of Rotorscope, of its simulator, or of ST&apos;s profiler.</source>
        <translation>Legt eine Motordatei neben das Board: von Rotorscope, von seinem Simulator oder von STs Profiler.</translation>
    </message>
    <message>
        <source>&amp;Close file</source>
        <translation>Datei s&amp;chließen</translation>
    </message>
    <message>
        <source>Ends the comparison with the file.</source>
        <translation>Beendet den Vergleich mit der Datei.</translation>
    </message>
    <message>
        <source>S&amp;ave…</source>
        <translation>Sp&amp;eichern …</translation>
    </message>
    <message>
        <source>Motor and drive</source>
        <translation>Motor und Antrieb</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Converter</source>
        <translation>Umrechner</translation>
    </message>
    <message>
        <source>From the &amp;board</source>
        <translation>&amp;Vom Board</translation>
    </message>
    <message>
        <source>Begins again with the board&apos;s values.</source>
        <translation>Beginnt wieder mit den Werten des Boards.</translation>
    </message>
    <message>
        <source>Not connected: this is what the board said last.</source>
        <translation>Nicht verbunden: das hat das Board zuletzt gesagt.</translation>
    </message>
    <message>
        <source>Connect to a board to see what it says of its motor. A file can be looked at without.</source>
        <translation>Mit einem Board verbinden, um zu sehen, was es von seinem Motor sagt. Eine Datei lässt sich auch so ansehen.</translation>
    </message>
    <message>
        <source>This board does not describe its motor.</source>
        <translation>Dieses Board beschreibt seinen Motor nicht.</translation>
    </message>
    <message>
        <source>The board is asked…</source>
        <translation>Das Board wird gefragt …</translation>
    </message>
    <message>
        <source>The board&apos;s motor looks plausible.</source>
        <translation>Der Motor des Boards sieht stimmig aus.</translation>
    </message>
    <message>
        <source>Open a motor file</source>
        <translation>Motordatei öffnen</translation>
    </message>
    <message>
        <source>Motor files (*.json)</source>
        <translation>Motordateien (*.json)</translation>
    </message>
    <message>
        <source>%1 was not opened. %2</source>
        <comment>file, sentence</comment>
        <translation>%1 wurde nicht geöffnet. %2</translation>
    </message>
    <message>
        <source>%1: a motor from ST&apos;s tools.</source>
        <translation>%1: ein Motor aus STs Werkzeugen.</translation>
    </message>
    <message>
        <source>%1: a motor file.</source>
        <translation>%1: eine Motordatei.</translation>
    </message>
    <message>
        <source>Nothing differs from the board.</source>
        <translation>Nichts weicht vom Board ab.</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) differ from the board.</source>
        <translation>
            <numerusform>%n Wert weicht vom Board ab.</numerusform>
            <numerusform>%n Werte weichen vom Board ab.</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the motor</source>
        <translation>Motor speichern</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>%1 was not saved: %2</source>
        <comment>file, reason</comment>
        <translation>%1 wurde nicht gespeichert: %2</translation>
    </message>
    <message>
        <source>Takes the measured figures out of the description again that came into it last.</source>
        <translation>Nimmt die zuletzt übernommenen gemessenen Werte wieder aus der Beschreibung.</translation>
    </message>
    <message>
        <source>Writes what the board says of its motor to a file, which the simulator takes, too; where measured figures are in use, the description that has them.</source>
        <translation>Schreibt in eine Datei, was das Board von seinem Motor sagt; auch der Simulator liest sie. Sind gemessene Werte übernommen, wird die Beschreibung mit ihnen geschrieben.</translation>
    </message>
    <message>
        <source>The description beside the board holds measured figures; Save writes them to a file.</source>
        <translation>Die Beschreibung neben dem Board hat gemessene Werte; Speichern schreibt sie in eine Datei.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
</context>
<context>
    <name>widgets::MotorModel</name>
    <message>
        <source>not read yet</source>
        <translation>noch nicht gelesen</translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) of an unknown form</source>
        <translation>
            <numerusform>%n Byte unbekannter Form</numerusform>
            <numerusform>%n Bytes unbekannter Form</numerusform>
        </translation>
    </message>
    <message>
        <source>can be written</source>
        <translation>kann geschrieben werden</translation>
    </message>
    <message>
        <source>read-only</source>
        <translation>nur lesbar</translation>
    </message>
    <message>
        <source>nothing of it</source>
        <comment>no flag is set</comment>
        <translation>nichts davon</translation>
    </message>
    <message>
        <source>Flux of the magnets λ</source>
        <translation>Fluss der Magnete λ</translation>
    </message>
    <message>
        <source>λ = Ke · √2 / √3 / (p · 104.72 rad/s), p: pole pairs. Peak, linked with a phase.</source>
        <translation>λ = Ke · √2 / √3 / (p · 104,72 rad/s), p: Polpaare. Scheitelwert, mit einer Phase verkettet.</translation>
    </message>
    <message>
        <source>Torque constant Kt</source>
        <translation>Drehmomentkonstante Kt</translation>
    </message>
    <message>
        <source>Kt = 3/2 · p · λ, per peak ampere.</source>
        <translation>Kt = 3/2 · p · λ, je Ampere Scheitelwert.</translation>
    </message>
    <message>
        <source>Voltage constant Ke</source>
        <translation>Spannungskonstante Ke</translation>
    </message>
    <message>
        <source>Ke = λ · p · 104.72 rad/s · √3 / √2: V rms between two terminals at 1000 rpm.</source>
        <translation>Ke = λ · p · 104,72 rad/s · √3 / √2: V effektiv zwischen zwei Klemmen bei 1000 rpm.</translation>
    </message>
    <message>
        <source>Speed constant KV</source>
        <translation>Drehzahlkonstante KV</translation>
    </message>
    <message>
        <source>KV = 1 / (√3 · λ · p · 2π / 60): rpm per volt, peak, between two terminals.</source>
        <translation>KV = 1 / (√3 · λ · p · 2π / 60): Umdrehungen je Minute und Volt, Scheitelwert zwischen zwei Klemmen.</translation>
    </message>
    <message>
        <source>Time constant, q</source>
        <translation>Zeitkonstante, q</translation>
    </message>
    <message>
        <source>τq = Lq / Rs</source>
        <translation>τq = Lq / Rs</translation>
    </message>
    <message>
        <source>Time constant, d</source>
        <translation>Zeitkonstante, d</translation>
    </message>
    <message>
        <source>τd = Ld / Rs</source>
        <translation>τd = Ld / Rs</translation>
    </message>
    <message>
        <source>Torque at motor current</source>
        <translation>Drehmoment bei Motorstrom</translation>
    </message>
    <message>
        <source>M = Kt · I</source>
        <translation>M = Kt · I</translation>
    </message>
    <message>
        <source>Base speed</source>
        <translation>Eckdrehzahl</translation>
    </message>
    <message>
        <source>Where motor current and nominal bus voltage are used up without flux weakening: (Rs I + ω λ)² + (ω Lq I)² = Vbus² / 3.</source>
        <translation>Wo Motorstrom und Nennspannung ohne Feldschwächung aufgebraucht sind: (Rs I + ω λ)² + (ω Lq I)² = Vbus² / 3.</translation>
    </message>
    <message>
        <source>Derived values</source>
        <translation>Abgeleitete Werte</translation>
    </message>
    <message>
        <source>computed from the motor</source>
        <translation>aus dem Motor berechnet</translation>
    </message>
    <message>
        <source>Board and file</source>
        <translation>Board und Datei</translation>
    </message>
    <message>
        <source>no board to compare with</source>
        <translation>kein Board zum Vergleichen</translation>
    </message>
    <message>
        <source>no difference</source>
        <translation>kein Unterschied</translation>
    </message>
    <message numerus="yes">
        <source>%n difference(s)</source>
        <translation>
            <numerusform>%n Unterschied</numerusform>
            <numerusform>%n Unterschiede</numerusform>
        </translation>
    </message>
    <message>
        <source>The file has another value; in %1: %2</source>
        <comment>unit, number</comment>
        <translation>Die Datei hat einen anderen Wert; in %1: %2</translation>
    </message>
    <message>
        <source>Built into the firmware: it is changed in the firmware&apos;s project, not over the link.</source>
        <translation>In die Firmware eingebaut: es wird in ihrem Projekt geändert, nicht über die Verbindung.</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>On the board</source>
        <translation>Auf dem Board</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Roh</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>In der Datei</translation>
    </message>
</context>
<context>
    <name>widgets::NotesPanel</name>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>What is tried, and what came of it. Kept with the workspace.</source>
        <translation>Was versucht wird und was dabei herauskam. Bleibt beim Arbeitsplatz.</translation>
    </message>
</context>
<context>
    <name>widgets::NumberEdit</name>
    <message>
        <source>From %1 to %2 %3.</source>
        <comment>number number unit</comment>
        <translation>Von %1 bis %2 %3.</translation>
    </message>
    <message>
        <source>It cannot be negative.</source>
        <translation>Es kann nicht negativ sein.</translation>
    </message>
    <message>
        <source>The limit is %1 %2.</source>
        <comment>number unit</comment>
        <translation>Die Grenze ist %1 %2.</translation>
    </message>
    <message>
        <source>= %1 %2</source>
        <comment>number unit</comment>
        <translation>= %1 %2</translation>
    </message>
    <message>
        <source>%1 becomes %2 %3 (steps of %4)</source>
        <comment>typed number, sent number, unit, step</comment>
        <translation>Aus %1 wird %2 %3 (Schritte von %4)</translation>
    </message>
</context>
<context>
    <name>widgets::Opening</name>
    <message numerus="yes">
        <source>%n signal(s) of it are not shown: see Scope, Signals of the file.</source>
        <translation>
            <numerusform>%n Signal daraus wird nicht gezeigt: siehe Oszilloskop, Signale der Datei.</numerusform>
            <numerusform>%n Signale daraus werden nicht gezeigt: siehe Oszilloskop, Signale der Datei.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopping the motors before something else is opened…</source>
        <translation>Die Motoren werden gestoppt, bevor etwas anderes geöffnet wird …</translation>
    </message>
    <message>
        <source>Open it all the same…</source>
        <translation>Trotzdem öffnen …</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Recordings (*.pcapng)</source>
        <translation>Aufzeichnungen (*.pcapng)</translation>
    </message>
    <message>
        <source>Replay a recording</source>
        <translation>Aufzeichnung wiedergeben</translation>
    </message>
    <message>
        <source>Import CSV</source>
        <translation>CSV importieren</translation>
    </message>
    <message>
        <source>CSV files (*.csv *.txt)</source>
        <translation>CSV-Dateien (*.csv *.txt)</translation>
    </message>
    <message>
        <source>%1 is no recording of Rotorscope.</source>
        <translation>%1 ist keine Aufzeichnung von Rotorscope.</translation>
    </message>
    <message>
        <source>Imported %1.</source>
        <translation>%1 ist importiert.</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) have the time of the row before and were left out.</source>
        <translation>
            <numerusform>%n Zeile hat die Zeit der Zeile davor und wurde ausgelassen.</numerusform>
            <numerusform>%n Zeilen haben die Zeit der Zeile davor und wurden ausgelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Disconnect and go on</source>
        <translation>&amp;Trennen und weiter</translation>
    </message>
    <message>
        <source>A recording takes the place of what the scope shows.</source>
        <translation>Eine Aufzeichnung tritt an die Stelle dessen, was das Oszilloskop zeigt.</translation>
    </message>
    <message>
        <source>A replay takes the place of a board.</source>
        <translation>Eine Wiedergabe tritt an die Stelle eines Boards.</translation>
    </message>
    <message>
        <source>What is imported takes the place of what the scope shows.</source>
        <translation>Das Importierte tritt an die Stelle dessen, was das Oszilloskop zeigt.</translation>
    </message>
    <message>
        <source>Open as a &amp;reference</source>
        <translation>Als &amp;Referenz öffnen</translation>
    </message>
    <message>
        <source>Open a recording as a reference</source>
        <translation>Aufzeichnung als Referenz öffnen</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>%1 is being read. Until then its outline is shown: the extremes of its fast signals.</source>
        <translation>%1 wird gelesen. Bis dahin ist der Umriss zu sehen: die Extremwerte der schnellen Signale.</translation>
    </message>
</context>
<context>
    <name>widgets::OwnLimits</name>
    <message>
        <source>The file with your own limits, %1, cannot be read (%2). Those of the last time that Rotorscope ended are in force: look at them in the control panel.</source>
        <translation>Die Datei mit Ihren eigenen Grenzen, %1, ist nicht lesbar (%2). Es gelten die vom letzten Ende von Rotorscope: prüfen Sie sie in der Steuerung.</translation>
    </message>
    <message>
        <source>The file with your own limits, %1, cannot be read (%2). NO limit of your own is in force: set them again in the control panel.</source>
        <translation>Die Datei mit Ihren eigenen Grenzen, %1, ist nicht lesbar (%2). KEINE eigene Grenze gilt: setzen Sie sie in der Steuerung neu.</translation>
    </message>
    <message>
        <source>Your own limits hold now, but could not be stored in %1 (%2).</source>
        <translation>Ihre eigenen Grenzen gelten jetzt, konnten aber nicht in %1 gespeichert werden (%2).</translation>
    </message>
</context>
<context>
    <name>widgets::PlanPicture</name>
    <message>
        <source>Picture of the plan</source>
        <translation>Bild des Plans</translation>
    </message>
    <message>
        <source>Time without the start [s]</source>
        <translation>Zeit ohne den Start [s]</translation>
    </message>
    <message>
        <source>Speed [rpm]</source>
        <translation>Drehzahl [rpm]</translation>
    </message>
    <message>
        <source>cap %1 rpm</source>
        <translation>Grenze %1 rpm</translation>
    </message>
    <message>
        <source>Current at rest [A]</source>
        <translation>Strom im Stillstand [A]</translation>
    </message>
</context>
<context>
    <name>widgets::RampForm</name>
    <message>
        <source>Name of a ramp</source>
        <translation>Name einer Rampe</translation>
    </message>
    <message>
        <source>Choosing one fills the fields; it sends nothing. To keep the ramp that you look at, type a name and save.</source>
        <translation>Eine zu wählen füllt die Felder und sendet nichts. Um die Rampe zu behalten, die Sie ansehen: Namen eingeben und speichern.</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Save</source>
        <comment>a ramp under a name</comment>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Delete</source>
        <comment>a named ramp</comment>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>&amp;Named</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Progress of the ramp</source>
        <translation>Fortschritt der Rampe</translation>
    </message>
    <message>
        <source>Stop ramp</source>
        <translation>Rampe anhalten</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>No ramp was sent yet.</source>
        <translation>Noch wurde keine Rampe gesendet.</translation>
    </message>
    <message>
        <source>To %1: taken over; it goes when the motor runs.</source>
        <translation>Auf %1: angenommen; sie läuft, sobald der Motor läuft.</translation>
    </message>
    <message>
        <source>To %1: %2 % of the time, %3 s left; measured %4.</source>
        <comment>target, number, number</comment>
        <translation>Auf %1: %2 % der Zeit, noch %3 s; gemessen %4.</translation>
    </message>
    <message>
        <source>The set-point is at %1; measured %2.</source>
        <translation>Der Sollwert ist bei %1; gemessen %2.</translation>
    </message>
    <message>
        <source>Arrived at %1 after %2 s.</source>
        <translation>Nach %2 s bei %1 angekommen.</translation>
    </message>
    <message>
        <source>The ramp to %1 was ended on its way; measured %2.</source>
        <translation>Die Rampe auf %1 wurde unterwegs beendet; gemessen %2.</translation>
    </message>
    <message>
        <source>The motor runs no more; the ramp to %1 has ended.</source>
        <translation>Der Motor läuft nicht mehr; die Rampe auf %1 ist zu Ende.</translation>
    </message>
    <message>
        <source>The link was lost on the way to %1; what became of it is not known.</source>
        <translation>Die Verbindung ging auf dem Weg zu %1 verloren; was daraus wurde, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Ends a ramp where it is; the motor goes on turning.</source>
        <translation>Beendet eine Rampe, wo sie gerade ist; der Motor dreht weiter.</translation>
    </message>
    <message>
        <source>Keeps this under the name: %1</source>
        <translation>Behält dies unter dem Namen: %1</translation>
    </message>
    <message>
        <source>Type a name first, and values that can be sent.</source>
        <translation>Zuerst einen Namen eingeben, und Werte, die gesendet werden können.</translation>
    </message>
    <message>
        <source>Forgets the ramp of this name.</source>
        <translation>Vergisst die Rampe dieses Namens.</translation>
    </message>
    <message>
        <source>Choose one first.</source>
        <translation>Zuerst eine wählen.</translation>
    </message>
</context>
<context>
    <name>widgets::RampLine</name>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>%1/s</source>
        <comment>unit</comment>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>Send</source>
        <comment>a ramp to the board</comment>
        <translation>Senden</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>D&amp;rehzahl</translation>
    </message>
    <message>
        <source>&amp;Iq (torque)</source>
        <translation>&amp;Iq (Moment)</translation>
    </message>
    <message>
        <source>Speed to go to, in rpm</source>
        <translation>Anzufahrende Drehzahl in rpm</translation>
    </message>
    <message>
        <source>Torque current Iq to go to, in A</source>
        <translation>Anzufahrender Momentenstrom Iq in A</translation>
    </message>
    <message>
        <source>Current reference Iq, in A</source>
        <translation>Stromsollwert Iq in A</translation>
    </message>
    <message>
        <source>Current reference Id, in A</source>
        <translation>Stromsollwert Id in A</translation>
    </message>
    <message>
        <source>Duration of the ramp in ms</source>
        <translation>Dauer der Rampe in ms</translation>
    </message>
    <message>
        <source>Send: %1</source>
        <comment>kind of ramp</comment>
        <translation>Senden: %1</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>in</source>
        <comment>a time</comment>
        <translation>in</translation>
    </message>
    <message>
        <source>Speed ramp</source>
        <translation>Drehzahlrampe</translation>
    </message>
    <message>
        <source>Torque ramp</source>
        <translation>Drehmomentrampe</translation>
    </message>
    <message>
        <source>Current reference</source>
        <translation>Stromsollwert</translation>
    </message>
    <message>
        <source>Together %1 A: the limit is %2 A.</source>
        <translation>Zusammen %1 A: die Grenze ist %2 A.</translation>
    </message>
    <message>
        <source>Sends it (Enter in a field does the same).</source>
        <translation>Sendet es (wie die Eingabetaste in einem Feld).</translation>
    </message>
    <message>
        <source>Shaft (&amp;x)</source>
        <translation>Welle (&amp;x)</translation>
    </message>
    <message>
        <source>Angle of the shaft to go to, in degrees</source>
        <translation>Anzufahrender Winkel der Welle in Grad</translation>
    </message>
    <message>
        <source>Position ramp</source>
        <translation>Positionsrampe</translation>
    </message>
    <message>
        <source>immediately</source>
        <translation>sofort</translation>
    </message>
    <message>
        <source>I&amp;q immediately</source>
        <translation>I&amp;q sofort</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) of %1 rpm</source>
        <translation>
            <numerusform>%n Stufe von %1 rpm</numerusform>
            <numerusform>%n Stufen von %1 rpm</numerusform>
        </translation>
    </message>
    <message>
        <source>Iq = %1 A, Id = %2 A, together %3 A, immediately</source>
        <translation>Iq = %1 A, Id = %2 A, zusammen %3 A, sofort</translation>
    </message>
</context>
<context>
    <name>widgets::RampPreview</name>
    <message>
        <source>Preview of the ramp</source>
        <translation>Vorschau der Rampe</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Speed [rpm]</source>
        <translation>Drehzahl [rpm]</translation>
    </message>
    <message>
        <source>Shaft [°]</source>
        <translation>Welle [°]</translation>
    </message>
    <message>
        <source>Iq [A]</source>
        <translation>Iq [A]</translation>
    </message>
</context>
<context>
    <name>widgets::ReadoutBox</name>
    <message>
        <source>Measured speed</source>
        <translation>Istdrehzahl</translation>
    </message>
    <message>
        <source>Speed reference</source>
        <translation>Drehzahlsollwert</translation>
    </message>
    <message>
        <source>Current Iq</source>
        <translation>Strom Iq</translation>
    </message>
    <message>
        <source>Bus voltage</source>
        <translation>Zwischenkreisspannung</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Power stage</source>
        <translation>Leistungsteil</translation>
    </message>
    <message>
        <source>This board does not tell it.</source>
        <translation>Dieses Board nennt das nicht.</translation>
    </message>
</context>
<context>
    <name>widgets::ReadyFormulas</name>
    <message>
        <source>needs I_A and I_B in the recording</source>
        <translation>braucht I_A und I_B in der Aufzeichnung</translation>
    </message>
    <message>
        <source>needs two phase currents and an electrical angle</source>
        <translation>braucht zwei Phasenströme und einen elektrischen Winkel</translation>
    </message>
    <message>
        <source>needs a signal in the recording</source>
        <translation>braucht ein Signal in der Aufzeichnung</translation>
    </message>
    <message>
        <source>Clarke: current α</source>
        <translation>Clarke: Strom α</translation>
    </message>
    <message>
        <source>Clarke: current β</source>
        <translation>Clarke: Strom β</translation>
    </message>
    <message>
        <source>Park: current d</source>
        <translation>Park: Strom d</translation>
    </message>
    <message>
        <source>Park: current q</source>
        <translation>Park: Strom q</translation>
    </message>
    <message>
        <source>Electrical power</source>
        <translation>Elektrische Leistung</translation>
    </message>
    <message>
        <source>needs the voltages and currents of d and q</source>
        <translation>braucht die Spannungen und Ströme von d und q</translation>
    </message>
    <message>
        <source>Derivative</source>
        <translation>Ableitung</translation>
    </message>
    <message>
        <source>Integral</source>
        <translation>Integral</translation>
    </message>
    <message>
        <source>Low-pass, 100 Hz</source>
        <translation>Tiefpass, 100 Hz</translation>
    </message>
    <message>
        <source>High-pass, 10 Hz</source>
        <translation>Hochpass, 10 Hz</translation>
    </message>
    <message>
        <source>Median of 5</source>
        <translation>Median von 5</translation>
    </message>
    <message>
        <source>Angle without jumps</source>
        <translation>Winkel ohne Sprünge</translation>
    </message>
    <message>
        <source>needs an angle in the recording</source>
        <translation>braucht einen Winkel in der Aufzeichnung</translation>
    </message>
    <message>
        <source>No formula yet.</source>
        <translation>Noch keine Formel.</translation>
    </message>
    <message>
        <source>The formula is too long.</source>
        <translation>Die Formel ist zu lang.</translation>
    </message>
    <message>
        <source>Too many parentheses inside one another, or too many functions.</source>
        <translation>Zu viele Klammern ineinander oder zu viele Funktionen.</translation>
    </message>
    <message>
        <source>This sign is not known here: %1</source>
        <translation>Dieses Zeichen ist hier nicht bekannt: %1</translation>
    </message>
    <message>
        <source>This is no number: %1</source>
        <translation>Das ist keine Zahl: %1</translation>
    </message>
    <message>
        <source>Something is missing at the end.</source>
        <translation>Am Ende fehlt etwas.</translation>
    </message>
    <message>
        <source>The formula cannot be read from here on: %1</source>
        <translation>Ab hier ist die Formel nicht zu lesen: %1</translation>
    </message>
    <message>
        <source>The number of arguments is wrong: %1</source>
        <translation>Die Anzahl der Argumente stimmt nicht: %1</translation>
    </message>
    <message>
        <source>This has to be a number, not a signal: %1</source>
        <translation>Hier muss eine Zahl stehen, kein Signal: %1</translation>
    </message>
    <message>
        <source>This number is outside what makes sense: %1</source>
        <translation>Diese Zahl ergibt hier keinen Sinn: %1</translation>
    </message>
    <message>
        <source>This has to be an angle, in degrees or rad: %1</source>
        <translation>Das muss ein Winkel sein, in Grad oder rad: %1</translation>
    </message>
    <message>
        <source>At character %1: %2</source>
        <comment>a place in the formula, and what is wrong there</comment>
        <translation>Bei Zeichen %1: %2</translation>
    </message>
    <message>
        <source>What opens here is not closed: %1</source>
        <translation>Was hier aufgeht, wird nicht geschlossen: %1</translation>
    </message>
    <message>
        <source>No signal on the scope and no function is called %1.</source>
        <translation>Kein Signal auf dem Oszilloskop und keine Funktion heißt %1.</translation>
    </message>
</context>
<context>
    <name>widgets::RecordPanel</name>
    <message>
        <source>Records of the trigger</source>
        <translation>Aufnahmen des Triggers</translation>
    </message>
    <message>
        <source>Enter shows a record, the tick keeps it, F2 gives it a label. Page up and page down go through the records.</source>
        <translation>Eingabetaste zeigt eine Aufnahme, das Häkchen behält sie, F2 gibt ihr einen Namen. Bild auf und Bild ab gehen durch die Aufnahmen.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>&amp;Persistence</source>
        <translation>Nach&amp;leuchten</translation>
    </message>
    <message>
        <source>Keeps the traces of the picture dashed and paler behind those that come (%1)</source>
        <translation>Behält die Kurven des Bildes gestrichelt und blasser hinter denen, die kommen (%1)</translation>
    </message>
    <message>
        <source>Keep as &amp;reference A</source>
        <translation>Als &amp;Referenz A behalten</translation>
    </message>
    <message>
        <source>Keep as reference &amp;B</source>
        <translation>Als Re&amp;ferenz B behalten</translation>
    </message>
    <message>
        <source>Dr&amp;op B</source>
        <translation>B verwerfe&amp;n</translation>
    </message>
    <message>
        <source>So many earlier records stay paler behind the newest one, while the trigger is the same</source>
        <translation>So viele frühere Aufnahmen bleiben blasser hinter der neuesten, solange der Trigger derselbe ist</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>L&amp;eeren</translation>
    </message>
    <message>
        <source>Clear the persistence</source>
        <translation>Nachleuchten leeren</translation>
    </message>
    <message>
        <source>Takes the earlier records out of the picture; those to come stay again</source>
        <translation>Nimmt die früheren Aufnahmen aus dem Bild; die nächsten bleiben wieder stehen</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Drop &amp;A</source>
        <translation>A &amp;verwerfen</translation>
    </message>
</context>
<context>
    <name>widgets::RecordTable</name>
    <message>
        <source>samples are gone</source>
        <translation>Messwerte sind fort</translation>
    </message>
    <message>
        <source>trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>forced</source>
        <translation>erzwungen</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Ursache</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Pinned, trigger time</source>
        <translation>Behalten, Triggerzeit</translation>
    </message>
</context>
<context>
    <name>widgets::RecordingControl</name>
    <message>
        <source>With the bytes of the &amp;line</source>
        <translation>Mit den Bytes der &amp;Leitung</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Twice the size; keeps what was on the line byte for byte</source>
        <translation>Doppelt so groß; bewahrt Byte für Byte, was auf der Leitung war</translation>
    </message>
    <message>
        <source>E&amp;nd the recording</source>
        <translation>Aufzeichnung been&amp;den</translation>
    </message>
    <message>
        <source>&amp;Record to disk…</source>
        <translation>Auf Platte auf&amp;zeichnen …</translation>
    </message>
    <message>
        <source>Ends the file on the disk (Ctrl+R)</source>
        <translation>Beendet die Datei auf der Platte (Strg+R)</translation>
    </message>
    <message>
        <source>Writes all samples, values and events to a file while they come (Ctrl+R)</source>
        <translation>Schreibt alle Abtastwerte, Werte und Ereignisse laufend in eine Datei (Strg+R)</translation>
    </message>
    <message>
        <source>Connect first: a recording is of a connection (Ctrl+R)</source>
        <translation>Zuerst verbinden: Aufgezeichnet wird eine Verbindung (Strg+R)</translation>
    </message>
    <message>
        <source>Record to disk</source>
        <translation>Auf Platte aufzeichnen</translation>
    </message>
    <message>
        <source>Recordings (*.pcapng)</source>
        <translation>Aufzeichnungen (*.pcapng)</translation>
    </message>
    <message>
        <source>Recording to %1</source>
        <translation>Aufzeichnung nach %1</translation>
    </message>
    <message>
        <source>%1, %2 MB</source>
        <comment>duration, size</comment>
        <translation>%1, %2 MB</translation>
    </message>
    <message>
        <source>, disk full in %1</source>
        <comment>duration</comment>
        <translation>, Platte voll in %1</translation>
    </message>
    <message>
        <source>, %1 GB free</source>
        <comment>on the disk</comment>
        <translation>, %1 GB frei</translation>
    </message>
    <message>
        <source>%1 cannot be recorded (%2). Choose a name that is not there yet, in a folder that takes files.</source>
        <translation>%1 kann nicht aufgezeichnet werden (%2). Wählen Sie einen Namen, den es noch nicht gibt, in einem beschreibbaren Ordner.</translation>
    </message>
    <message>
        <source>Recording ended: %1</source>
        <translation>Aufzeichnung beendet: %1</translation>
    </message>
    <message>
        <source>Recorded to %1: %2 MB.</source>
        <comment>path, size</comment>
        <translation>Aufgezeichnet in %1: %2 MB.</translation>
    </message>
    <message>
        <source>ended, disk full</source>
        <translation>beendet, Platte voll</translation>
    </message>
    <message>
        <source>Recording ended: disk full</source>
        <translation>Aufzeichnung beendet: Platte voll</translation>
    </message>
    <message>
        <source>The disk is full: the recording %1 ends here, with %2 MB. What was recorded is in it, and the connection goes on.</source>
        <translation>Die Platte ist voll: Die Aufzeichnung %1 endet hier, mit %2 MB. Was bis dahin kam, ist in ihr, und die Verbindung läuft weiter.</translation>
    </message>
    <message>
        <source>ended, disk failed</source>
        <translation>beendet, Plattenfehler</translation>
    </message>
    <message>
        <source>Recording ended: disk failed</source>
        <translation>Aufzeichnung beendet: Plattenfehler</translation>
    </message>
    <message>
        <source>The disk failed (%3): the recording %1 ends here, with %2 MB. What was recorded is in it, and the connection goes on.</source>
        <translation>Die Platte versagt (%3): Die Aufzeichnung %1 endet hier, mit %2 MB. Was bis dahin kam, ist in ihr, und die Verbindung läuft weiter.</translation>
    </message>
    <message>
        <source>REC</source>
        <comment>a recording can begin</comment>
        <translation>REC</translation>
    </message>
    <message>
        <source>End</source>
        <comment>the recording</comment>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Recorded to %1: %2 MB, without %3, because the disk was too slow.</source>
        <translation>Aufgezeichnet nach %1: %2 MB, es fehlen %3, weil die Platte zu langsam war.</translation>
    </message>
    <message>
        <source>, %1 lost</source>
        <comment>samples and more</comment>
        <translation>, %1 verloren</translation>
    </message>
</context>
<context>
    <name>widgets::RegisterEdits</name>
    <message>
        <source>No board is answering.</source>
        <translation>Kein Board antwortet.</translation>
    </message>
    <message>
        <source>Arm first: nothing is written to a board that is not armed.</source>
        <translation>Zuerst freigeben: Auf ein nicht freigegebenes Board wird nichts geschrieben.</translation>
    </message>
    <message>
        <source>The last write is still under way.</source>
        <translation>Das letzte Schreiben läuft noch.</translation>
    </message>
    <message>
        <source>A question is open.</source>
        <translation>Eine Frage ist noch offen.</translation>
    </message>
    <message>
        <source>Nothing was edited.</source>
        <translation>Nichts wurde bearbeitet.</translation>
    </message>
    <message numerus="yes">
        <source>%n register(s)</source>
        <comment>how many were written</comment>
        <translation>
            <numerusform>%n Register</numerusform>
            <numerusform>%n Register</numerusform>
        </translation>
    </message>
    <message>
        <source>Undo is not available after a reconnect.</source>
        <translation>Nach dem Wiederverbinden ist Rückgängig nicht verfügbar.</translation>
    </message>
    <message>
        <source>Nothing to undo.</source>
        <translation>Nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>Nothing to redo.</source>
        <translation>Nichts zu wiederholen.</translation>
    </message>
    <message>
        <source>Nothing was written: the board was disarmed meanwhile.</source>
        <translation>Nichts wurde geschrieben: Die Freigabe wurde inzwischen zurückgenommen.</translation>
    </message>
</context>
<context>
    <name>widgets::RegisterModel</name>
    <message>
        <source>Pinned</source>
        <translation>Angeheftet</translation>
    </message>
    <message>
        <source>Other registers</source>
        <translation>Weitere Register</translation>
    </message>
    <message>
        <source>scope only</source>
        <comment>a register that cannot be read, only recorded</comment>
        <translation>nur Oszilloskop</translation>
    </message>
    <message>
        <source>not supported</source>
        <translation>nicht unterstützt</translation>
    </message>
    <message>
        <source>refused</source>
        <comment>the board refused to read a register</comment>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>This value is old: it is not being read.</source>
        <translation>Dieser Wert ist alt: Er wird gerade nicht gelesen.</translation>
    </message>
    <message>
        <source>This board does not have it.</source>
        <translation>Dieses Board hat es nicht.</translation>
    </message>
    <message>
        <source>Drag it to the scope or press Enter: it is drawn at the rate at which it can be read.</source>
        <translation>Ziehen Sie es auf das Oszilloskop oder drücken Sie die Eingabetaste: Es wird in dem Takt gezeichnet, in dem es gelesen werden kann.</translation>
    </message>
    <message>
        <source>Drag it to the scope or press Enter: it is recorded at the full control rate.</source>
        <translation>Ziehen Sie es auf das Oszilloskop oder drücken Sie die Eingabetaste: Es wird im vollen Regeltakt aufgezeichnet.</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Raw</source>
        <comment>the number as it is on the wire</comment>
        <translation>Roh</translation>
    </message>
    <message>
        <source>write only</source>
        <comment>a register that cannot be read, only written</comment>
        <translation>nur schreibbar</translation>
    </message>
    <message>
        <source>Not sent: %1</source>
        <comment>the reason</comment>
        <translation>Nicht gesendet: %1</translation>
    </message>
    <message>
        <source>Written, but the board holds %1.</source>
        <translation>Geschrieben, aber das Board hält %1.</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <comment>the board&apos;s reason</comment>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source>Double-click its value or press F2 to edit it.</source>
        <translation>Zum Bearbeiten den Wert doppelt anklicken oder F2 drücken.</translation>
    </message>
    <message>
        <source>The board holds %1.</source>
        <translation>Das Board hält %1.</translation>
    </message>
    <message>
        <source>Not written yet.</source>
        <translation>Noch nicht geschrieben.</translation>
    </message>
    <message>
        <source>On its way to the board.</source>
        <translation>Auf dem Weg zum Board.</translation>
    </message>
    <message>
        <source>Written and read back.</source>
        <translation>Geschrieben und zurückgelesen.</translation>
    </message>
    <message>
        <source>RW</source>
        <comment>access: read and write</comment>
        <translation>RW</translation>
    </message>
    <message>
        <source>R</source>
        <comment>access: read</comment>
        <translation>R</translation>
    </message>
    <message>
        <source>W</source>
        <comment>access: write</comment>
        <translation>W</translation>
    </message>
    <message>
        <source>scope</source>
        <comment>access: recorded only</comment>
        <translation>Oszi</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>least and greatest value</comment>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Hex</source>
        <comment>the number as it is on the wire, in hexadecimal digits</comment>
        <translation>Hex</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Zugriff</translation>
    </message>
    <message>
        <source>Help</source>
        <comment>what a register is</comment>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Sent, outcome unknown: %1</source>
        <translation>Gesendet, Ergebnis unbekannt: %1</translation>
    </message>
    <message>
        <source>Last value</source>
        <comment>heading of values that are not read any more</comment>
        <translation>Letzter Wert</translation>
    </message>
    <message>
        <source>Written, not verified.</source>
        <translation>Geschrieben, nicht geprüft.</translation>
    </message>
    <message>
        <source>Written, not verified: %1</source>
        <comment>the reason</comment>
        <translation>Geschrieben, nicht geprüft: %1</translation>
    </message>
</context>
<context>
    <name>widgets::RegisterPanel</name>
    <message>
        <source>Search registers (Ctrl+K)</source>
        <translation>Register suchen (Strg+K)</translation>
    </message>
    <message>
        <source>Search registers</source>
        <translation>Register suchen</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>Add to scope</source>
        <translation>Zum Oszilloskop hinzufügen</translation>
    </message>
    <message>
        <source>Pinned</source>
        <comment>menu entry of a register</comment>
        <translation>Angeheftet</translation>
    </message>
    <message>
        <source>Not taken over: %1</source>
        <comment>what is wrong with a typed value</comment>
        <translation>Nicht übernommen: %1</translation>
    </message>
    <message>
        <source>&amp;Undo the last write</source>
        <translation>Letztes Schreiben &amp;zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo the write</source>
        <translation>Schreiben &amp;wiederholen</translation>
    </message>
    <message>
        <source>&amp;Apply edits</source>
        <translation>Änderungen &amp;anwenden</translation>
    </message>
    <message>
        <source>Re&amp;vert edits</source>
        <translation>Änderungen &amp;verwerfen</translation>
    </message>
    <message>
        <source>&amp;Edit the register&apos;s value</source>
        <translation>Wert des Registers &amp;bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Copy registers as text</source>
        <translation>Register als Text &amp;kopieren</translation>
    </message>
    <message>
        <source>Writes what was edited and reads it back (Ctrl+Shift+A)</source>
        <translation>Schreibt die Änderungen und liest sie zurück (Strg+Umschalt+A)</translation>
    </message>
    <message>
        <source>Writes the old value of: %1</source>
        <translation>Schreibt den alten Wert von: %1</translation>
    </message>
    <message>
        <source>Writes again: %1</source>
        <translation>Schreibt noch einmal: %1</translation>
    </message>
    <message>
        <source>Nothing was edited.</source>
        <translation>Nichts wurde bearbeitet.</translation>
    </message>
    <message>
        <source>Forgets the edits that were not written</source>
        <translation>Vergisst die Änderungen, die nicht geschrieben wurden</translation>
    </message>
    <message>
        <source>Edit value</source>
        <translation>Wert bearbeiten</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Register &amp;columns</source>
        <translation>S&amp;palten der Register</translation>
    </message>
    <message>
        <source>&amp;Pin the register or let it go</source>
        <translation>Register an&amp;heften oder lösen</translation>
    </message>
    <message>
        <source>What the selected register is</source>
        <translation>Was das gewählte Register ist</translation>
    </message>
    <message>
        <source>No register has &quot;%1&quot; in its name or its help.</source>
        <translation>Kein Register hat „%1“ im Namen oder in der Hilfe.</translation>
    </message>
</context>
<context>
    <name>widgets::Replacing</name>
    <message>
        <source>Replace what was recorded?</source>
        <translation>Aufgezeichnetes ersetzen?</translation>
    </message>
    <message>
        <source>What was recorded to a disk stays there. The scope&apos;s own samples cannot be brought back.</source>
        <translation>Was auf einen Datenträger aufgezeichnet wurde, bleibt dort. Die Messwerte des Oszilloskops selbst sind nicht wiederzubringen.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>E&amp;rsetzen</translation>
    </message>
    <message>
        <source>&amp;Export first…</source>
        <translation>Erst &amp;exportieren…</translation>
    </message>
    <message>
        <source>Markers that are not saved are lost, too.</source>
        <translation>Nicht gespeicherte Markierungen gehen ebenfalls verloren.</translation>
    </message>
    <message>
        <source>Save the &amp;markers</source>
        <translation>&amp;Markierungen speichern</translation>
    </message>
    <message>
        <source>Leave the markers unsaved?</source>
        <translation>Die Markierungen nicht speichern?</translation>
    </message>
    <message>
        <source>&amp;Leave unsaved</source>
        <translation>&amp;Nicht speichern</translation>
    </message>
    <message>
        <source>&amp;Save first…</source>
        <translation>Erst &amp;speichern…</translation>
    </message>
    <message>
        <source>&amp;Save first</source>
        <translation>Erst &amp;speichern</translation>
    </message>
    <message>
        <source>Markers of this recording were changed and are not saved.</source>
        <translation>Markierungen dieser Aufzeichnung wurden geändert und sind nicht gespeichert.</translation>
    </message>
    <message>
        <source>The recording %1 does not hold all markers as they are now.</source>
        <translation>Die Aufzeichnung %1 enthält nicht alle Markierungen so, wie sie jetzt sind.</translation>
    </message>
    <message>
        <source>The recording that runs does not hold all markers: some were set before it began.</source>
        <translation>Die laufende Aufzeichnung enthält nicht alle Markierungen: einige wurden gesetzt, bevor sie begann.</translation>
    </message>
    <message>
        <source>Clear what was recorded?</source>
        <translation>Aufgezeichnetes löschen?</translation>
    </message>
    <message>
        <source>The scope holds samples that were not exported. They cannot be brought back.</source>
        <translation>Das Oszilloskop hält Messwerte, die nicht exportiert wurden. Sie lassen sich nicht zurückholen.</translation>
    </message>
    <message>
        <source>What was recorded to a disk stays there, and markers stay.</source>
        <translation>Was auf einen Datenträger aufgezeichnet wurde, bleibt dort, und Markierungen bleiben.</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>The markers are not saved. They can be saved as a list of times and words (CSV).</source>
        <translation>Die Markierungen sind nicht gespeichert. Sie können als Liste von Zeiten und Texten (CSV) gespeichert werden.</translation>
    </message>
    <message>
        <source>The scope holds samples that were not exported. A file that is opened takes their place.</source>
        <translation>Im Oszilloskop sind Messwerte, die nicht exportiert wurden. Eine Datei, die geöffnet wird, tritt an ihre Stelle.</translation>
    </message>
</context>
<context>
    <name>widgets::ReplayBar</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pause the replay</source>
        <translation>Wiedergabe anhalten</translation>
    </message>
    <message>
        <source>Holds the replay; nothing is left out</source>
        <translation>Hält die Wiedergabe an; nichts wird ausgelassen</translation>
    </message>
    <message>
        <source>Pace of the replay</source>
        <translation>Tempo der Wiedergabe</translation>
    </message>
    <message>
        <source>1×, as it was</source>
        <translation>1×, wie es war</translation>
    </message>
    <message>
        <source>4×</source>
        <translation>4×</translation>
    </message>
    <message>
        <source>as fast as possible</source>
        <translation>so schnell wie möglich</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>%1: %2, %3 %</source>
        <comment>file name, duration, part of the file</comment>
        <translation>%1: %2, %3 %</translation>
    </message>
    <message numerus="yes">
        <source>, %n damaged place(s)</source>
        <translation>
            <numerusform>, %n beschädigte Stelle</numerusform>
            <numerusform>, %n beschädigte Stellen</numerusform>
        </translation>
    </message>
    <message>
        <source> – its end</source>
        <translation> – zu Ende</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>WIEDERGABE</translation>
    </message>
    <message>
        <source>Place in the recording</source>
        <translation>Stelle in der Aufzeichnung</translation>
    </message>
    <message>
        <source>Goes to another place in the recording. Going back restarts it, after what the scope already has.</source>
        <translation>Geht zu einer anderen Stelle der Aufzeichnung. Zurück beginnt sie von vorn, nach dem, was das Oszilloskop schon hat.</translation>
    </message>
</context>
<context>
    <name>widgets::ResponsePage</name>
    <message>
        <source>stiff</source>
        <translation>ruhig</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>quick</source>
        <translation>schnell</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Länge</translation>
    </message>
    <message>
        <source>The longer, the narrower the error bars</source>
        <translation>Je länger, desto schmaler die Fehlerbalken</translation>
    </message>
    <message>
        <source>speed loop, open</source>
        <translation>Drehzahlregelkreis, offen</translation>
    </message>
    <message>
        <source>motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>current loop, open</source>
        <translation>Stromregelkreis, offen</translation>
    </message>
    <message>
        <source>current loop, closed</source>
        <translation>Stromregelkreis, geschlossen</translation>
    </message>
    <message>
        <source>What if &amp;Kp</source>
        <translation>Was wäre mit &amp;Kp</translation>
    </message>
    <message>
        <source>Moves the predicted loop; nothing is written until Apply</source>
        <translation>Bewegt den vorhergesagten Regelkreis; geschrieben wird erst mit „Anwenden“</translation>
    </message>
    <message>
        <source>Three candidates from the measured motor: stiff, medium, quick</source>
        <translation>Drei Vorschläge aus dem gemessenen Motor: ruhig, mittel, schnell</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>A&amp;nwenden</translation>
    </message>
    <message>
        <source>&amp;Back to the old gains</source>
        <translation>&amp;Zurück zu den alten Verstärkungen</translation>
    </message>
    <message>
        <source>Measures how motor and speed loop follow each frequency; then the motor is as it was.</source>
        <translation>Misst, wie Motor und Drehzahlregelung jeder Frequenz folgen; danach ist der Motor wie zuvor.</translation>
    </message>
    <message>
        <source>&amp;Current</source>
        <translation>&amp;Strom</translation>
    </message>
    <message>
        <source>Measures how the current follows its reference; then the motor is as it was.</source>
        <translation>Misst, wie der Strom seinem Sollwert folgt; danach ist der Motor wie zuvor.</translation>
    </message>
    <message>
        <source>P&amp;rove</source>
        <translation>&amp;Prüfen</translation>
    </message>
    <message>
        <source>Measures the response and steps of 200 rpm with the gains that were applied, and compares.</source>
        <translation>Misst Frequenzgang und Sprünge von 200 rpm mit den angewendeten Verstärkungen und vergleicht.</translation>
    </message>
    <message>
        <source>Apply gains first: they are what is proved.</source>
        <translation>Zuerst Verstärkungen anwenden: Sie werden geprüft.</translation>
    </message>
    <message>
        <source>Not conclusive: %1</source>
        <translation>Nicht schlüssig: %1</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>With the gains that the board held then</source>
        <translation>Mit den Verstärkungen, die das Board da hatte</translation>
    </message>
    <message>
        <source>what if</source>
        <translation>was wäre wenn</translation>
    </message>
    <message>
        <source>With the gains in the fields, by the measured motor; its step is that of a fitted one</source>
        <translation>Mit den Verstärkungen in den Feldern, am gemessenen Motor; der Sprung ist der eines angepassten</translation>
    </message>
    <message>
        <source>Ms at most %1, phase margin at least %2°, at the worst end of each error bar</source>
        <translation>Ms höchstens %1, Phasenreserve mindestens %2°, am schlechteren Ende jedes Fehlerbalkens</translation>
    </message>
    <message>
        <source>proved</source>
        <translation>nachgewiesen</translation>
    </message>
    <message>
        <source>current loop</source>
        <translation>Stromregelkreis</translation>
    </message>
    <message>
        <source>As measured, at the current that flowed</source>
        <translation>Wie gemessen, bei dem Strom, der floss</translation>
    </message>
    <message>
        <source>Measure the response of the speed first.</source>
        <translation>Zuerst den Frequenzgang der Drehzahl messen.</translation>
    </message>
    <message>
        <source>Writes the gains in the fields as one step, which can be undone, and reads them back</source>
        <translation>Schreibt die Verstärkungen in den Feldern als einen Schritt, der rückgängig zu machen ist, und liest sie zurück</translation>
    </message>
    <message>
        <source>Writes the gains from before the first Apply, as one step</source>
        <translation>Schreibt die Verstärkungen von vor dem ersten Anwenden, als einen Schritt</translation>
    </message>
    <message>
        <source>Pr&amp;opose</source>
        <translation>&amp;Vorschlagen</translation>
    </message>
    <message>
        <source>P&amp;icture</source>
        <translation>B&amp;ild</translation>
    </message>
    <message>
        <source>Ki</source>
        <comment>a gain</comment>
        <translation>Ki</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>D&amp;rehzahl</translation>
    </message>
    <message>
        <source>what if: unstable</source>
        <translation>was wäre wenn: instabil</translation>
    </message>
    <message>
        <source>With these gains the loop would be unstable: its speed would swing ever more.</source>
        <translation>Mit diesen Verstärkungen wäre der Regelkreis instabil: seine Drehzahl würde immer stärker schwingen.</translation>
    </message>
    <message>
        <source>Loops: measured, what if, proposed, proved</source>
        <translation>Regelkreise: gemessen, was wäre wenn, vorgeschlagen, nachgewiesen</translation>
    </message>
</context>
<context>
    <name>widgets::RevUpChart</name>
    <message>
        <source>Picture of the rev-up: speed and current over time</source>
        <translation>Bild des Anlaufs: Drehzahl und Strom über der Zeit</translation>
    </message>
    <message>
        <source>Speed, rpm</source>
        <translation>Drehzahl, rpm</translation>
    </message>
    <message>
        <source>%1, digits</source>
        <translation>%1, Digits</translation>
    </message>
    <message>
        <source>%1, A</source>
        <translation>%1, A</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Drag a point, or select one with Page Up and Page Down and move it with the arrow keys.</source>
        <translation>Ziehen Sie einen Punkt, oder wählen Sie einen mit Bild auf und Bild ab und schieben Sie ihn mit den Pfeiltasten.</translation>
    </message>
    <message>
        <source>Stage %1: %2&#x202f;rpm at %3&#x202f;s (lasts %4&#x202f;ms)</source>
        <translation>Stufe %1: %2&#x202f;rpm bei %3&#x202f;s (dauert %4&#x202f;ms)</translation>
    </message>
    <message>
        <source>Stage %1: %2 %3 digits at %4&#x202f;s (lasts %5&#x202f;ms)</source>
        <translation>Stufe %1: %2 %3 Digits bei %4&#x202f;s (dauert %5&#x202f;ms)</translation>
    </message>
    <message>
        <source>Stage %1: Iq %2 (%3 digits) at %4&#x202f;s (lasts %5&#x202f;ms)</source>
        <translation>Stufe %1: Iq %2 (%3 Digits) bei %4&#x202f;s (dauert %5&#x202f;ms)</translation>
    </message>
    <message>
        <source>observer sees from %1&#x202f;rpm</source>
        <translation>Beobachter sieht ab %1&#x202f;rpm</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>Grenze %1</translation>
    </message>
</context>
<context>
    <name>widgets::RevUpForm</name>
    <message>
        <source>Stages of the rev-up</source>
        <translation>Stufen des Anlaufs</translation>
    </message>
    <message>
        <source>Not taken over: %1</source>
        <comment>what is wrong with a typed value</comment>
        <translation>Nicht übernommen: %1</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Adds a stage after the selected one (Insert)</source>
        <translation>Fügt hinter der gewählten eine Stufe ein (Einfg)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>Ent&amp;fernen</translation>
    </message>
    <message>
        <source>Removes the selected stage (Delete)</source>
        <translation>Entfernt die gewählte Stufe (Entf)</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <comment>move a stage</comment>
        <translation>Ra&amp;uf</translation>
    </message>
    <message>
        <source>Moves the selected stage up (Alt+Up)</source>
        <translation>Schiebt die gewählte Stufe nach oben (Alt+Auf)</translation>
    </message>
    <message>
        <source>Dow&amp;n</source>
        <comment>move a stage</comment>
        <translation>Runte&amp;r</translation>
    </message>
    <message>
        <source>Moves the selected stage down (Alt+Down)</source>
        <translation>Schiebt die gewählte Stufe nach unten (Alt+Ab)</translation>
    </message>
    <message>
        <source>Start va&amp;lues</source>
        <translation>S&amp;tartwerte</translation>
    </message>
    <message>
        <source>ST&apos;s start values: 2 s of half the nominal current, then 3 s to 30 % of the highest speed</source>
        <translation>STs Startwerte: 2 s halber Nennstrom, dann 3 s auf 30 % der Höchstdrehzahl</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öffnen…</translation>
    </message>
    <message>
        <source>Reads the stages from a file, as rotorscope-cli revup writes them</source>
        <translation>Liest die Stufen aus einer Datei, wie rotorscope-cli revup sie schreibt</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Writes the stages to a file that rotorscope-cli revup reads</source>
        <translation>Schreibt die Stufen in eine Datei, die rotorscope-cli revup liest</translation>
    </message>
    <message>
        <source>Of rotor and load together. Only for the judgement here; it is not sent anywhere.</source>
        <translation>Von Rotor und Last zusammen. Nur für das Urteil hier; wird nirgendwohin gesendet.</translation>
    </message>
    <message>
        <source>Torque that holds the motor back. Only for the judgement here; it is not sent anywhere.</source>
        <translation>Moment, das den Motor bremst. Nur für das Urteil hier; wird nirgendwohin gesendet.</translation>
    </message>
    <message>
        <source>What is wrong with the rev-up</source>
        <translation>Was am Anlauf falsch ist</translation>
    </message>
    <message>
        <source>Inertia, %1</source>
        <translation>Trägheit, %1</translation>
    </message>
    <message>
        <source>Friction, mN·m</source>
        <translation>Reibung, mN·m</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation>Motor %1</translation>
    </message>
    <message>
        <source>Takes %1&#x202f;s in all</source>
        <translation>Dauert zusammen %1&#x202f;s</translation>
    </message>
    <message>
        <source>Highest speed %1&#x202f;rpm</source>
        <translation>Höchstdrehzahl %1&#x202f;rpm</translation>
    </message>
    <message>
        <source>Nominal current %1</source>
        <translation>Nennstrom %1</translation>
    </message>
    <message>
        <source>Kt %1 per A</source>
        <translation>Kt %1 je A</translation>
    </message>
    <message>
        <source>Torque is not judged: the board does not say its magnets&apos; flux (MOTOR_CONFIG).</source>
        <translation>Moment unbeurteilt: Das Board nennt den Fluss der Magnete nicht (MOTOR_CONFIG).</translation>
    </message>
    <message>
        <source>Torque is not judged: type the inertia.</source>
        <translation>Moment unbeurteilt: Tippen Sie die Trägheit ein.</translation>
    </message>
    <message>
        <source>The scale of the current is not known: digits only.</source>
        <translation>Die Stromskala ist nicht bekannt: nur Digits.</translation>
    </message>
    <message>
        <source>The next start is drawn over the plan.</source>
        <translation>Der nächste Start wird über den Plan gezeichnet.</translation>
    </message>
    <message>
        <source>Start under way…</source>
        <translation>Start läuft…</translation>
    </message>
    <message>
        <source>Last start: the drive took over after %1&#x202f;s.</source>
        <translation>Letzter Start: Der Regler übernahm nach %1&#x202f;s.</translation>
    </message>
    <message>
        <source>Last start: failed after %1&#x202f;s (%2).</source>
        <translation>Letzter Start: nach %1&#x202f;s gescheitert (%2).</translation>
    </message>
    <message>
        <source>Last start: stopped after %1&#x202f;s.</source>
        <translation>Letzter Start: nach %1&#x202f;s gestoppt.</translation>
    </message>
    <message>
        <source>No speed was recorded.</source>
        <translation>Keine Drehzahl aufgezeichnet.</translation>
    </message>
    <message>
        <source>No Iq was recorded.</source>
        <translation>Kein Iq aufgezeichnet.</translation>
    </message>
    <message>
        <source>Measured: thin lines.</source>
        <translation>Gemessen: dünne Linien.</translation>
    </message>
    <message>
        <source>Open a rev-up</source>
        <translation>Anlauf öffnen</translation>
    </message>
    <message>
        <source>Rev-ups (*.json);;All files (*)</source>
        <translation>Anläufe (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 ist nicht lesbar: %2.</translation>
    </message>
    <message>
        <source>%1 was not taken: its stage %2 is beyond this board&apos;s limits.</source>
        <translation>%1 wurde nicht übernommen: Stufe %2 liegt jenseits der Grenzen dieses Boards.</translation>
    </message>
    <message>
        <source>Stages of %1. Apply writes them to the board.</source>
        <translation>Stufen aus %1. „Anwenden“ schreibt sie auf das Board.</translation>
    </message>
    <message>
        <source>Save the rev-up</source>
        <translation>Anlauf speichern</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 lässt sich nicht schreiben: %2.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Als %1 gespeichert.</translation>
    </message>
    <message>
        <source>Measured: thin lines, mirrored, for it turned backwards.</source>
        <translation>Gemessen: dünne Linien, gespiegelt, denn er lief rückwärts.</translation>
    </message>
    <message>
        <source>✓ No problems found.</source>
        <translation>✓ Keine Fehler gefunden.</translation>
    </message>
</context>
<context>
    <name>widgets::RevUpModel</name>
    <message>
        <source>No board is connected.</source>
        <translation>Kein Board ist verbunden.</translation>
    </message>
    <message>
        <source>This firmware has no rev-up.</source>
        <translation>Diese Firmware hat keinen Anlauf.</translation>
    </message>
    <message>
        <source>This board starts without a rev-up: it has a sensor of the rotor&apos;s angle, or its firmware is a reduced one.</source>
        <translation>Dieses Board startet ohne gesteuerten Anlauf: Es hat einen Sensor für den Rotorwinkel, oder seine Firmware ist eine verkleinerte.</translation>
    </message>
    <message>
        <source>This drive starts by its sensor (%1) and runs no rev-up.</source>
        <translation>Dieser Antrieb startet mit seinem Sensor (%1), ohne gesteuerten Anlauf.</translation>
    </message>
    <message>
        <source>The stages have not been read yet.</source>
        <translation>Die Stufen sind noch nicht gelesen.</translation>
    </message>
    <message>
        <source>pulse</source>
        <comment>of a six-step drive: the duty that its timer holds</comment>
        <translation>Puls</translation>
    </message>
    <message>
        <source>Iq</source>
        <translation>Iq</translation>
    </message>
    <message>
        <source>not used</source>
        <comment>a stage of a rev-up</comment>
        <translation>unbenutzt</translation>
    </message>
    <message>
        <source>Torque that the stage needs, and that its current gives.</source>
        <translation>Moment, das die Stufe braucht, und das ihr Strom gibt.</translation>
    </message>
    <message>
        <source>Not used: it takes no time. Give it a duration to use it.</source>
        <translation>Unbenutzt: Sie dauert 0&#x202f;ms. Eine Dauer nimmt sie in Gebrauch.</translation>
    </message>
    <message>
        <source>The board holds %1&#x202f;ms, %2&#x202f;rpm, %3 digits.</source>
        <translation>Das Board hat %1&#x202f;ms, %2&#x202f;rpm, %3 Digits.</translation>
    </message>
    <message>
        <source>Stage %1, %2: %3</source>
        <comment>a cell of the rev-up table, for a screen reader</comment>
        <translation>Stufe %1, %2: %3</translation>
    </message>
    <message>
        <source>Time
ms</source>
        <comment>duration of a stage</comment>
        <translation>Zeit
ms</translation>
    </message>
    <message>
        <source>Duration of the stage, ms</source>
        <translation>Dauer der Stufe, ms</translation>
    </message>
    <message>
        <source>Speed
rpm</source>
        <translation>Drehzahl
rpm</translation>
    </message>
    <message>
        <source>Speed at the end of the stage, rpm</source>
        <translation>Drehzahl am Ende der Stufe, rpm</translation>
    </message>
    <message>
        <source>Iq
A</source>
        <translation>Iq
A</translation>
    </message>
    <message>
        <source>Iq at the end of the stage, A</source>
        <translation>Iq am Ende der Stufe, A</translation>
    </message>
    <message>
        <source>Pulse
digits</source>
        <translation>Puls
Digits</translation>
    </message>
    <message>
        <source>Pulse at the end of the stage, digits</source>
        <translation>Puls am Ende der Stufe, Digits</translation>
    </message>
    <message>
        <source>Iq
digits</source>
        <translation>Iq
Digits</translation>
    </message>
    <message>
        <source>Iq at the end of the stage, digits of the register</source>
        <translation>Iq am Ende der Stufe, Digits des Registers</translation>
    </message>
    <message>
        <source>Torque
mN·m</source>
        <translation>Moment
mN·m</translation>
    </message>
    <message>
        <source>Torque needed / given, mN·m</source>
        <translation>Moment gebraucht / gegeben, mN·m</translation>
    </message>
    <message>
        <source>%1&#x202f;rpm became %2&#x202f;rpm: drives count speeds in steps of %3&#x202f;rpm.</source>
        <translation>Aus %1&#x202f;rpm wurden %2&#x202f;rpm: Antriebe zählen Drehzahlen in Schritten von %3&#x202f;rpm.</translation>
    </message>
</context>
<context>
    <name>widgets::RunBookModel</name>
    <message>
        <source>Its registers were not read to the end.</source>
        <translation>Seine Register wurden nicht zu Ende gelesen.</translation>
    </message>
    <message>
        <source>%1, with a star</source>
        <comment>number</comment>
        <translation>%1, mit Stern</translation>
    </message>
    <message>
        <source>Digits of the proportional and the integral gain of the speed loop</source>
        <translation>Digits der Proportional- und der Integralverstärkung des Drehzahlreglers</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Kp / Ki</source>
        <translation>Kp / Ki</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
</context>
<context>
    <name>widgets::RunBookPanel</name>
    <message numerus="yes">
        <source>%n file(s) make no sense: </source>
        <translation>
            <numerusform>%n Datei ergibt keinen Sinn: </numerusform>
            <numerusform>%n Dateien ergeben keinen Sinn: </numerusform>
        </translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>The tick gives a run its star, F2 its note.</source>
        <translation>Das Häkchen gibt einem Lauf seinen Stern, F2 seine Notiz.</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner…</translation>
    </message>
    <message>
        <source>Add a recording…</source>
        <translation>Aufzeichnung aufnehmen…</translation>
    </message>
    <message>
        <source>Keeps each experiment of a recording, and each stretch between two changes of its gains, as a run</source>
        <translation>Bewahrt jeden Versuch einer Aufzeichnung und jeden Abschnitt zwischen zwei Änderungen ihrer Verstärkungen als Lauf auf</translation>
    </message>
    <message>
        <source>As reference</source>
        <translation>Als Referenz</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Run %1 is kept.</source>
        <comment>number</comment>
        <translation>Lauf %1 ist aufbewahrt.</translation>
    </message>
    <message>
        <source>Keep experiments in a folder</source>
        <translation>Versuche in einem Ordner aufbewahren</translation>
    </message>
    <message>
        <source>Add a recording to the run book</source>
        <translation>Aufzeichnung in das Versuchsbuch aufnehmen</translation>
    </message>
    <message>
        <source>Recordings (*.pcapng)</source>
        <translation>Aufzeichnungen (*.pcapng)</translation>
    </message>
    <message>
        <source>Adding %1</source>
        <translation>%1 wird aufgenommen</translation>
    </message>
    <message>
        <source>%1 is not added: %2.</source>
        <comment>file, reason</comment>
        <translation>%1 ist nicht aufgenommen: %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s) are added.</source>
        <translation>
            <numerusform>%n Lauf ist aufgenommen.</numerusform>
            <numerusform>%n Läufe sind aufgenommen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stretch(es) are left out, because they are short.</source>
        <translation>
            <numerusform>%n Abschnitt fehlt, weil er kurz ist.</numerusform>
            <numerusform>%n Abschnitte fehlen, weil sie kurz sind.</numerusform>
        </translation>
    </message>
    <message>
        <source>Experiments are not kept: choose a folder for them.</source>
        <translation>Versuche werden nicht aufbewahrt: bitte einen Ordner wählen.</translation>
    </message>
    <message>
        <source>Every experiment is kept in %1</source>
        <comment>folder</comment>
        <translation>Jeder Versuch wird aufbewahrt in %1</translation>
    </message>
    <message>
        <source>Reading the run book</source>
        <translation>Versuchsbuch wird gelesen</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <comment>folder, reason</comment>
        <translation>%1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>The note of run %1 is not kept: %2.</source>
        <comment>number, reason</comment>
        <translation>Die Notiz von Lauf %1 ist nicht aufbewahrt: %2.</translation>
    </message>
    <message>
        <source>Compare registers</source>
        <translation>Register vergleichen</translation>
    </message>
    <message>
        <source>Back to this run…</source>
        <translation>Zurück zu diesem Lauf…</translation>
    </message>
    <message>
        <source>Shows which registers differ between both runs</source>
        <translation>Zeigt, welche Register sich zwischen beiden Läufen unterscheiden</translation>
    </message>
    <message>
        <source>Shows what the board holds otherwise than behind this run; Restore writes it</source>
        <translation>Zeigt, was das Board anders hält als nach diesem Lauf; Wiederherstellen schreibt es</translation>
    </message>
    <message>
        <source>Lays one or two runs behind what the scope shows, as references</source>
        <translation>Legt einen oder zwei Läufe als Referenzen hinter das Bild des Oszilloskops</translation>
    </message>
    <message>
        <source>Opens the recording of the run, in place of what is shown</source>
        <translation>Öffnet die Aufzeichnung des Laufs anstelle dessen, was gezeigt wird</translation>
    </message>
</context>
<context>
    <name>widgets::RunKeeper</name>
    <message>
        <source>Keeping a run</source>
        <translation>Lauf wird aufbewahrt</translation>
    </message>
    <message>
        <source>The run was not kept in %1: %2.</source>
        <comment>folder, reason</comment>
        <translation>Der Lauf wurde nicht in %1 aufbewahrt: %2.</translation>
    </message>
</context>
<context>
    <name>widgets::SampleRoom</name>
    <message>
        <source>Samples: %1 GB in memory, %2 GB on disk</source>
        <translation>Messwerte: %1 GB im Arbeitsspeicher, %2 GB auf der Platte</translation>
    </message>
    <message>
        <source>%1 minutes</source>
        <translation>%1 Minuten</translation>
    </message>
    <message>
        <source>%1 hours</source>
        <translation>%1 Stunden</translation>
    </message>
    <message>
        <source>at the present %1 kB/s</source>
        <translation>bei derzeit %1 kB/s</translation>
    </message>
    <message>
        <source>of five signals at 16 kHz (%1 kB/s)</source>
        <translation>mit fünf Signalen bei 16 kHz (%1 kB/s)</translation>
    </message>
    <message>
        <source>Memory only, %1 GB: about %2 %3.</source>
        <comment>size, time, at a rate</comment>
        <translation>Nur Arbeitsspeicher, %1 GB: etwa %2 %3.</translation>
    </message>
    <message>
        <source>%1 GB on disk: about %2 %3.</source>
        <comment>size, time, at a rate</comment>
        <translation>%1 GB auf der Platte: etwa %2 %3.</translation>
    </message>
    <message>
        <source>The oldest %1 GB of samples are let go as soon as new ones come.</source>
        <translation>Die ältesten %1 GB Messwerte werden verworfen, sobald neue kommen.</translation>
    </message>
    <message>
        <source>The samples fill their memory (%1 GB): from now on the oldest ones are let go. Record to disk (Ctrl+R) to keep what comes.</source>
        <translation>Die Messwerte füllen ihren Speicher (%1 GB): Ab jetzt werden die ältesten verworfen. Aufzeichnen (Strg+R) behält, was kommt.</translation>
    </message>
    <message>
        <source>The samples fill their room (%1 GB of memory, %2 GB on disk): from now on the oldest ones are let go. Record to disk (Ctrl+R) to keep what comes, or give them more room (Scope, Room for samples).</source>
        <translation>Die Messwerte füllen ihren Platz (%1 GB Arbeitsspeicher, %2 GB auf der Platte): Ab jetzt werden die ältesten verworfen. Aufzeichnen (Strg+R) behält, was kommt; mehr Platz gibt es unter Oszilloskop, Platz für Messwerte.</translation>
    </message>
    <message>
        <source>The folder for samples, %1, cannot be made.</source>
        <translation>Der Ordner für Messwerte, %1, lässt sich nicht anlegen.</translation>
    </message>
    <message>
        <source>Less than 1 GB is free on the disk of %1, so no more samples go there.</source>
        <translation>Auf der Platte von %1 ist weniger als 1 GB frei, darum kommen keine Messwerte mehr dorthin.</translation>
    </message>
    <message>
        <source>The disk of %1 takes no more samples (%2).</source>
        <translation>Die Platte von %1 nimmt keine Messwerte mehr an (%2).</translation>
    </message>
    <message>
        <source>The connection and the scope go on; when the room that is left is full, the oldest samples are let go.</source>
        <translation>Verbindung und Oszilloskop laufen weiter; ist der verbleibende Platz voll, werden die ältesten Messwerte verworfen.</translation>
    </message>
    <message>
        <source>The disk of %1 cannot be read any more: the samples on it are let go.</source>
        <translation>Die Platte von %1 ist nicht mehr lesbar: Die Messwerte darauf werden verworfen.</translation>
    </message>
</context>
<context>
    <name>widgets::SampleRoomDialog</name>
    <message>
        <source>Room for samples</source>
        <translation>Platz für Messwerte</translation>
    </message>
    <message>
        <source>%1 GB are free on the disk of %2</source>
        <translation>%1 GB sind frei auf der Platte von %2</translation>
    </message>
    <message>
        <source>&amp;Room on disk [GB]</source>
        <translation>&amp;Platz auf der Platte [GB]</translation>
    </message>
    <message>
        <source>The room is a plain number of 0 or more, or nothing.</source>
        <translation>Der Platz ist eine einfache Zahl ab 0, oder leer.</translation>
    </message>
    <message>
        <source>That is more than is free: the last 1 GB is left free.</source>
        <translation>Das ist mehr, als frei ist: Das letzte 1 GB bleibt frei.</translation>
    </message>
    <message>
        <source>automatic: %1</source>
        <translation>automatisch: %1</translation>
    </message>
    <message>
        <source>When the memory for samples is full, the oldest ones are moved to the disk and stay on the scope. When the room there is used up too, the oldest are let go. They are gone when Rotorscope ends: what is to be kept has to be recorded (Ctrl+R) or exported. 0 keeps samples in memory only; an empty field lets Rotorscope choose.</source>
        <translation>Ist der Arbeitsspeicher für Messwerte voll, kommen die ältesten auf die Platte und bleiben im Oszilloskop. Ist auch der Platz dort verbraucht, werden die ältesten verworfen. Mit dem Ende von Rotorscope sind sie weg: Was bleiben soll, muss aufgezeichnet (Strg+R) oder exportiert werden. 0 hält Messwerte nur im Arbeitsspeicher; ein leeres Feld überlässt Rotorscope die Wahl.</translation>
    </message>
</context>
<context>
    <name>widgets::ScopeOverview</name>
    <message>
        <source>Whole recording</source>
        <translation>Ganze Aufzeichnung</translation>
    </message>
    <message>
        <source>The whole recording; the box is what the plots show. Drag it or its edges.</source>
        <translation>Die ganze Aufzeichnung; der Rahmen ist, was die Diagramme zeigen. Ihn oder seine Ränder ziehen.</translation>
    </message>
</context>
<context>
    <name>widgets::ScopePage</name>
    <message>
        <source>Run</source>
        <comment>the scope&apos;s picture moves</comment>
        <translation>Laufen</translation>
    </message>
    <message>
        <source>Lets the picture run or holds it; recording goes on (Space)</source>
        <translation>Lässt das Bild laufen oder hält es an; die Aufzeichnung läuft weiter (Leertaste)</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Keeps the newest samples in view (End)</source>
        <translation>Behält die neuesten Werte im Bild (Ende)</translation>
    </message>
    <message>
        <source>Fit</source>
        <comment>show all samples</comment>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Shows everything (F)</source>
        <translation>Zeigt alles (F)</translation>
    </message>
    <message>
        <source>Fit values</source>
        <translation>Werte einpassen</translation>
    </message>
    <message>
        <source>Fits the value axes only (Shift+F)</source>
        <translation>Passt nur die Werteachsen ein (Umschalt+F)</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Shows half the time (+)</source>
        <translation>Zeigt die halbe Zeit (+)</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Shows twice the time (−)</source>
        <translation>Zeigt die doppelte Zeit (−)</translation>
    </message>
    <message>
        <source>Replay</source>
        <comment>the scope shows it</comment>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>File</source>
        <comment>the scope shows it</comment>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Record to disk</source>
        <translation>Auf Platte aufzeichnen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Hold</source>
        <comment>the scope&apos;s picture stands still</comment>
        <translation>Halt</translation>
    </message>
    <message>
        <source>Draws each set-point from the instant at which its bytes left. How soon the board had it stands with the command among the events.</source>
        <translation>Zeichnet jeden Sollwert ab dem Augenblick, in dem seine Bytes abgingen. Wie bald das Board ihn hatte, steht beim Befehl unter den Ereignissen.</translation>
    </message>
    <message>
        <source>Set-po&amp;ints as sent</source>
        <translation>S&amp;ollwerte, wie sie gesendet wurden</translation>
    </message>
</context>
<context>
    <name>widgets::ScopeTools</name>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>Two times, their distance and the values there (C). 1 and 2 give a cursor to the mouse, arrows move it by a sample.</source>
        <translation>Zwei Zeitpunkte, ihr Abstand und die Werte dort (C). 1 und 2 geben einen Cursor an die Maus, die Pfeiltasten bewegen ihn um einen Messwert.</translation>
    </message>
    <message>
        <source>Take cursor &amp;A</source>
        <translation>Cursor &amp;A nehmen</translation>
    </message>
    <message>
        <source>Set a &amp;marker</source>
        <translation>&amp;Markierung setzen</translation>
    </message>
    <message>
        <source>At the mouse, else at the active cursor, else at the newest sample (M)</source>
        <translation>An der Maus, sonst am aktiven Cursor, sonst am neuesten Messwert (M)</translation>
    </message>
    <message>
        <source>&amp;Single record</source>
        <translation>&amp;Einzelne Aufnahme</translation>
    </message>
    <message>
        <source>Force a &amp;trigger</source>
        <translation>&amp;Trigger erzwingen</translation>
    </message>
    <message>
        <source>&amp;Previous record</source>
        <translation>&amp;Vorige Aufnahme</translation>
    </message>
    <message>
        <source>&amp;Next record</source>
        <translation>&amp;Nächste Aufnahme</translation>
    </message>
    <message>
        <source>&amp;Whole recording below</source>
        <translation>&amp;Ganze Aufzeichnung darunter</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>G&amp;itter</translation>
    </message>
    <message>
        <source>A strip with everything recorded, and a box around what the plots show (O)</source>
        <translation>Ein Streifen mit allem Aufgezeichneten und ein Rahmen um das, was die Diagramme zeigen (O)</translation>
    </message>
    <message>
        <source>&amp;Drop reference A</source>
        <translation>Referen&amp;z A verwerfen</translation>
    </message>
    <message>
        <source>Keep as reference &amp;B</source>
        <translation>Als Referenz &amp;B behalten</translation>
    </message>
    <message>
        <source>Next e&amp;vent of reference B</source>
        <translation>Näc&amp;hstes Ereignis der Referenz B</translation>
    </message>
    <message>
        <source>Lays another moment of its file at the trigger, or at the left edge of a picture that rolls</source>
        <translation>Legt einen anderen Augenblick ihrer Datei an den Trigger oder an den linken Rand eines laufenden Bildes</translation>
    </message>
    <message>
        <source>Take c&amp;ursor B</source>
        <translation>C&amp;ursor B nehmen</translation>
    </message>
    <message>
        <source>&amp;Keep as reference A</source>
        <translation>Als &amp;Referenz A behalten</translation>
    </message>
    <message>
        <source>D&amp;rop reference B</source>
        <translation>Referenz B ver&amp;werfen</translation>
    </message>
    <message>
        <source>Next event o&amp;f reference A</source>
        <translation>Nä&amp;chstes Ereignis der Referenz A</translation>
    </message>
</context>
<context>
    <name>widgets::ScopeView</name>
    <message>
        <source>Scope</source>
        <translation>Oszilloskop</translation>
    </message>
    <message>
        <source>Drag a signal here, or select one in the tree and press Enter</source>
        <translation>Ziehen Sie ein Signal hierher, oder wählen Sie eines im Baum und drücken Sie die Eingabetaste</translation>
    </message>
    <message>
        <source>Run	Space</source>
        <translation>Laufen	Leertaste</translation>
    </message>
    <message>
        <source>Follow the newest sample	End</source>
        <translation>Dem neuesten Wert folgen	Ende</translation>
    </message>
    <message>
        <source>Grid	G</source>
        <translation>Gitter	G</translation>
    </message>
    <message>
        <source>Fit everything	F</source>
        <translation>Alles einpassen	F</translation>
    </message>
    <message>
        <source>Fit values	Shift+F</source>
        <translation>Werte einpassen	Umschalt+F</translation>
    </message>
    <message>
        <source>Shows %1</source>
        <translation>Zeigt %1</translation>
    </message>
    <message>
        <source>Cursors	C</source>
        <translation>Cursor	C</translation>
    </message>
    <message>
        <source>Whole recording below	O</source>
        <translation>Ganze Aufzeichnung darunter	O</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Farbe</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Zeros of the axes at one height</source>
        <translation>Nullpunkte der Achsen auf einer Höhe</translation>
    </message>
</context>
<context>
    <name>widgets::Searching</name>
    <message>
        <source>Ne&amp;xt where the trigger is met</source>
        <translation>Nächste Stelle mit erf&amp;ülltem Trigger</translation>
    </message>
    <message>
        <source>Goes on to the next place in what was recorded where the trigger&apos;s condition is met (N)</source>
        <translation>Geht zur nächsten Stelle der Aufzeichnung, an der die Bedingung des Triggers erfüllt ist (N)</translation>
    </message>
    <message>
        <source>This trigger waits for an event: the list of events has them all (Ctrl+7).</source>
        <translation>Dieser Trigger wartet auf ein Ereignis: Die Liste der Ereignisse enthält sie alle (Strg+7).</translation>
    </message>
    <message>
        <source>Searching %1</source>
        <translation>%1 wird durchsucht</translation>
    </message>
    <message>
        <source>The trigger&apos;s condition is not met in what follows.</source>
        <translation>Die Bedingung des Triggers ist danach nirgends erfüllt.</translation>
    </message>
    <message>
        <source>The trigger&apos;s condition is met at %1.</source>
        <comment>a time</comment>
        <translation>Die Bedingung des Triggers ist bei %1 erfüllt.</translation>
    </message>
</context>
<context>
    <name>widgets::SetpointBox</name>
    <message>
        <source>Speed set-point in rpm</source>
        <translation>Drehzahlsollwert in rpm</translation>
    </message>
    <message>
        <source>Torque set-point in ampere</source>
        <translation>Drehmomentsollwert in Ampere</translation>
    </message>
    <message>
        <source>Reference of the current Iq in ampere</source>
        <translation>Sollwert des Stroms Iq in Ampere</translation>
    </message>
    <message>
        <source>Reference of the current Id in ampere</source>
        <translation>Sollwert des Stroms Id in Ampere</translation>
    </message>
    <message>
        <source>Go</source>
        <comment>send the set-point</comment>
        <translation>Anfahren</translation>
    </message>
    <message>
        <source>Stop ramp</source>
        <translation>Rampe anhalten</translation>
    </message>
    <message>
        <source>Kind of set-point</source>
        <translation>Art des Sollwerts</translation>
    </message>
    <message>
        <source>Speed</source>
        <comment>kind of set-point</comment>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Torque (Iq)</source>
        <comment>kind of set-point</comment>
        <translation>Drehmoment (Iq)</translation>
    </message>
    <message>
        <source>Currents (Iq, Id)</source>
        <comment>kind of set-point</comment>
        <translation>Ströme (Iq, Id)</translation>
    </message>
    <message>
        <source>Ramp time in milliseconds</source>
        <translation>Rampenzeit in Millisekunden</translation>
    </message>
    <message>
        <source>Id [A]</source>
        <translation>Id [A]</translation>
    </message>
    <message>
        <source>Speed [rpm]</source>
        <translation>Drehzahl [rpm]</translation>
    </message>
    <message>
        <source>Iq [A]</source>
        <translation>Iq [A]</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>Ends a ramp where it is; the motor goes on turning.</source>
        <translation>Beendet eine Rampe, wo sie gerade ist; der Motor dreht weiter.</translation>
    </message>
    <message>
        <source>Sets both currents at once (Enter in a field does the same).</source>
        <translation>Setzt beide Ströme sofort (ebenso die Eingabetaste in einem Feld).</translation>
    </message>
    <message>
        <source>Sends the set-point as a ramp (Enter in the field does the same).</source>
        <translation>Sendet den Sollwert als Rampe (die Eingabetaste im Feld tut dasselbe).</translation>
    </message>
    <message>
        <source>Speed ramp</source>
        <translation>Drehzahlrampe</translation>
    </message>
    <message>
        <source>Torque ramp</source>
        <translation>Drehmomentrampe</translation>
    </message>
    <message>
        <source>Current reference</source>
        <translation>Stromsollwert</translation>
    </message>
    <message>
        <source>Ramp time [ms]</source>
        <translation>Rampenzeit [ms]</translation>
    </message>
    <message>
        <source>Send with every exchange</source>
        <comment>set-points</comment>
        <translation>Mit jedem Austausch senden</translation>
    </message>
    <message>
        <source>The motor has to be idle.</source>
        <translation>Der Motor muss in Ruhe sein.</translation>
    </message>
    <message>
        <source>Speeds and currents travel in every frame that is exchanged with the drive, instead of as a write of their own. Stop and a fault set them to zero; a reset or a lost link ends it. Positions are always written.</source>
        <translation>Drehzahlen und Ströme werden in jedem Telegramm mitgesendet, das mit dem Antrieb ausgetauscht wird, statt einzeln geschrieben zu werden. Stopp und ein Fehler setzen sie auf null; ein Neustart des Antriebs oder eine verlorene Verbindung beendet es. Positionen werden immer geschrieben.</translation>
    </message>
    <message>
        <source>Set-points with every exchange</source>
        <translation>Sollwerte mit jedem Austausch</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>name of a field, what is wrong with its text</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>drive mode: speed</source>
        <comment>the board does now</comment>
        <translation>Betriebsart: Drehzahl</translation>
    </message>
    <message>
        <source>drive mode: torque</source>
        <comment>the board does now</comment>
        <translation>Betriebsart: Drehmoment</translation>
    </message>
    <message>
        <source>Angle of the shaft to go to, in degrees</source>
        <translation>Anzufahrender Winkel der Welle in Grad</translation>
    </message>
    <message>
        <source>Position</source>
        <comment>kind of set-point</comment>
        <translation>Position</translation>
    </message>
    <message>
        <source>Shaft is at</source>
        <translation>Welle steht bei</translation>
    </message>
    <message>
        <source>Position [°]</source>
        <translation>Position [°]</translation>
    </message>
    <message>
        <source>drive mode: position</source>
        <comment>the board does now</comment>
        <translation>Betriebsart: Position</translation>
    </message>
    <message>
        <source>A move to an angle has no end on its way: Stop ends it.</source>
        <translation>Eine Fahrt zu einem Winkel lässt sich unterwegs nicht beenden, nur mit Stopp.</translation>
    </message>
    <message>
        <source>Turns the shaft to that angle (Enter in the field does the same).</source>
        <translation>Dreht die Welle zu diesem Winkel (die Eingabetaste im Feld tut dasselbe).</translation>
    </message>
    <message>
        <source>Move to an angle</source>
        <translation>Fahrt zu einem Winkel</translation>
    </message>
</context>
<context>
    <name>widgets::SignalPlan</name>
    <message>
        <source>Recording signals</source>
        <translation>Signale aufzeichnen</translation>
    </message>
    <message>
        <source>These signals would need %1 kB/s, the link carries %2 kB/s: they are recorded at %3 Hz.</source>
        <translation>Diese Signale bräuchten %1 kB/s, die Verbindung trägt %2 kB/s: sie werden mit %3 Hz aufgezeichnet.</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s) do not fit into the recording and are polled.</source>
        <translation>
            <numerusform>%n Signal passt nicht in die Aufzeichnung und wird abgefragt.</numerusform>
            <numerusform>%n Signale passen nicht in die Aufzeichnung und werden abgefragt.</numerusform>
        </translation>
    </message>
    <message>
        <source>This board does not have %1.</source>
        <comment>names of signals</comment>
        <translation>Dieses Board hat %1 nicht.</translation>
    </message>
</context>
<context>
    <name>widgets::SignalSelection</name>
    <message>
        <source>The scope shows up to %1 signals of a file: take one off to see another.</source>
        <translation>Das Oszilloskop zeigt bis zu %1 Signale einer Datei: Nehmen Sie eines weg, um ein anderes zu sehen.</translation>
    </message>
    <message>
        <source>%1, polled</source>
        <comment>a signal</comment>
        <translation>%1, abgefragt</translation>
    </message>
</context>
<context>
    <name>widgets::SnapshotActions</name>
    <message>
        <source>&amp;Save a snapshot…</source>
        <translation>&amp;Schnappschuss sichern …</translation>
    </message>
    <message>
        <source>&amp;Export C header…</source>
        <translation>&amp;C-Header exportieren …</translation>
    </message>
    <message>
        <source>No board is answering.</source>
        <translation>Kein Board antwortet.</translation>
    </message>
    <message>
        <source>Saves every register that can be read, with the names of board and firmware</source>
        <translation>Sichert jedes lesbare Register mit den Namen von Board und Firmware</translation>
    </message>
    <message>
        <source>Saves gains and start-up of the motor in the names of the SDK&apos;s drive_parameters.h</source>
        <translation>Sichert Verstärkungen und Anlauf des Motors mit den Namen der drive_parameters.h des SDK</translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) saved to %1.</source>
        <translation>
            <numerusform>%n Register in %1 gesichert.</numerusform>
            <numerusform>%n Register in %1 gesichert.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::SnapshotDialog</name>
    <message>
        <source>Save a snapshot</source>
        <translation>Schnappschuss sichern</translation>
    </message>
    <message>
        <source>Export C header of motor %1</source>
        <translation>C-Header von Motor %1 exportieren</translation>
    </message>
    <message>
        <source>Progress of reading</source>
        <translation>Fortschritt des Lesens</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Sichern …</translation>
    </message>
    <message>
        <source>Reading what the board holds…</source>
        <translation>Liest, was das Board hält …</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>The board could not be read to the end; nothing was saved.</source>
        <translation>Das Board war nicht zu Ende zu lesen; nichts wurde gesichert.</translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) were read. The board never answered for: %1.</source>
        <translation>
            <numerusform>%n Register wurde gelesen. Keine Antwort kam für: %1.</numerusform>
            <numerusform>%n Register wurden gelesen. Keine Antwort kam für: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) were read.</source>
        <translation>
            <numerusform>%n Register wurde gelesen.</numerusform>
            <numerusform>%n Register wurden gelesen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Snapshots (*.json)</source>
        <translation>Schnappschüsse (*.json)</translation>
    </message>
    <message>
        <source>C headers (*.h)</source>
        <translation>C-Header (*.h)</translation>
    </message>
    <message>
        <source>%1 was not written: %2. Choose another place.</source>
        <comment>file, the system&apos;s words</comment>
        <translation>%1 wurde nicht geschrieben: %2. Wählen Sie einen anderen Ort.</translation>
    </message>
</context>
<context>
    <name>widgets::SnapshotModel</name>
    <message>
        <source>Only B has it.</source>
        <translation>Nur B hat es.</translation>
    </message>
    <message>
        <source>Only A has it.</source>
        <translation>Nur A hat es.</translation>
    </message>
    <message>
        <source>Not restored: %1</source>
        <comment>the reason</comment>
        <translation>Nicht wiederhergestellt: %1</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>A</source>
        <comment>the first of two snapshots</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <comment>the second of two snapshots</comment>
        <translation>B</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>A raw</source>
        <comment>digits of the first of two snapshots</comment>
        <translation>A roh</translation>
    </message>
    <message>
        <source>B raw</source>
        <comment>digits of the second of two snapshots</comment>
        <translation>B roh</translation>
    </message>
</context>
<context>
    <name>widgets::SnapshotPanel</name>
    <message>
        <source>Before a write, %1</source>
        <comment>date and time</comment>
        <translation>Vor einem Schreiben, %1</translation>
    </message>
    <message>
        <source>The board, as it is now</source>
        <translation>Das Board, wie es jetzt ist</translation>
    </message>
    <message>
        <source>Open a snapshot</source>
        <translation>Schnappschuss öffnen</translation>
    </message>
    <message>
        <source>Snapshots (*.json)</source>
        <translation>Schnappschüsse (*.json)</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <comment>file, the system&apos;s words</comment>
        <translation>%1 ist nicht zu lesen: %2.</translation>
    </message>
    <message>
        <source>No board is answering.</source>
        <translation>Kein Board antwortet.</translation>
    </message>
    <message>
        <source>The board never answered for: %1.</source>
        <comment>list of registers</comment>
        <translation>Keine Antwort des Boards kam für: %1.</translation>
    </message>
    <message>
        <source>The board could not be read to the end; the table shows what it held before.</source>
        <translation>Das Board war nicht zu Ende zu lesen; die Tabelle zeigt, was es vorher hielt.</translation>
    </message>
    <message>
        <source>A was taken of other hardware; restore it all the same</source>
        <translation>A stammt von anderer Hardware; trotzdem wiederherstellen</translation>
    </message>
    <message>
        <source>Choose a snapshot as A.</source>
        <translation>Wählen Sie einen Schnappschuss als A.</translation>
    </message>
    <message>
        <source>Choose the board as B.</source>
        <translation>Wählen Sie das Board als B.</translation>
    </message>
    <message>
        <source>The board is being read.</source>
        <translation>Das Board wird gelesen.</translation>
    </message>
    <message>
        <source>The board holds these values already.</source>
        <translation>Das Board hält diese Werte schon.</translation>
    </message>
    <message>
        <source>Nothing that can be written is chosen.</source>
        <translation>Nichts, was zu schreiben ist, ist ausgewählt.</translation>
    </message>
    <message>
        <source>A was taken of other hardware.</source>
        <translation>A stammt von anderer Hardware.</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <comment>a snapshot</comment>
        <translation>%1 wiederherstellen</translation>
    </message>
    <message>
        <source>Written and read back:</source>
        <translation>Geschrieben und zurückgelesen:</translation>
    </message>
    <message>
        <source>The board made another value of:</source>
        <translation>Das Board machte einen anderen Wert aus:</translation>
    </message>
    <message>
        <source>Not written:</source>
        <translation>Nicht geschrieben:</translation>
    </message>
    <message>
        <source>What was restored</source>
        <translation>Was wiederhergestellt wurde</translation>
    </message>
    <message>
        <source>Snapshot %1</source>
        <comment>A or B</comment>
        <translation>Schnappschuss %1</translation>
    </message>
    <message>
        <source>Choose a snapshot…</source>
        <translation>Schnappschuss wählen …</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Open a file as snapshot %1</source>
        <comment>A or B</comment>
        <translation>Datei als Schnappschuss %1 öffnen</translation>
    </message>
    <message>
        <source>A</source>
        <comment>the first of two snapshots</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <comment>the second of two snapshots</comment>
        <translation>B</translation>
    </message>
    <message>
        <source>Reads every register of the board again</source>
        <translation>Liest jedes Register des Boards noch einmal</translation>
    </message>
    <message>
        <source>Filter by name or group</source>
        <translation>Nach Name oder Gruppe filtern</translation>
    </message>
    <message>
        <source>Filter the differences</source>
        <translation>Unterschiede filtern</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Progress of reading</source>
        <translation>Fortschritt des Lesens</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Restore %n register(s) of A</source>
        <translation>
            <numerusform>%n &amp;Register von A wiederherstellen</numerusform>
            <numerusform>%n &amp;Register von A wiederherstellen</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>W&amp;iederherstellen</translation>
    </message>
    <message>
        <source>Writes what is checked and shown to the board and reads it back</source>
        <translation>Schreibt, was angehakt und zu sehen ist, auf das Board und liest es zurück</translation>
    </message>
    <message>
        <source>Reading the board…</source>
        <translation>Liest das Board …</translation>
    </message>
    <message>
        <source>No differences.</source>
        <translation>Keine Unterschiede.</translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) differ</source>
        <translation>
            <numerusform>%n Register unterscheidet sich</numerusform>
            <numerusform>%n Register unterscheiden sich</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them shown</source>
        <translation>
            <numerusform>, %n davon zu sehen</numerusform>
            <numerusform>, %n davon zu sehen</numerusform>
        </translation>
    </message>
    <message>
        <source>Check the selected rows</source>
        <translation>Ausgewählte Zeilen anhaken</translation>
    </message>
    <message>
        <source>Uncheck the selected rows</source>
        <translation>Haken der ausgewählten Zeilen entfernen</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alle auswählen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>%1 at %2 s</source>
        <comment>recording, seconds</comment>
        <translation>%1 bei %2 s</translation>
    </message>
    <message>
        <source>Save a snapshot</source>
        <translation>Schnappschuss sichern</translation>
    </message>
    <message>
        <source>It is not known whether these were written:</source>
        <translation>Es ist nicht bekannt, ob diese geschrieben wurden:</translation>
    </message>
    <message>
        <source>Read the b&amp;oard</source>
        <translation>Board &amp;lesen</translation>
    </message>
    <message>
        <source>Meas&amp;ured values, too</source>
        <translation>Auch M&amp;esswerte</translation>
    </message>
    <message>
        <source>S&amp;ave…</source>
        <translation>&amp;Sichern…</translation>
    </message>
    <message>
        <source>Written, not verified:</source>
        <translation>Geschrieben, nicht geprüft:</translation>
    </message>
</context>
<context>
    <name>widgets::SpectrumPanel</name>
    <message>
        <source>Peaks of the spectrum</source>
        <translation>Spitzen des Spektrums</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>dem Bild</translation>
    </message>
    <message>
        <source>between the cursors</source>
        <translation>zwischen den Cursorn</translation>
    </message>
    <message>
        <source>Hann</source>
        <translation>Hann</translation>
    </message>
    <message>
        <source>To look around</source>
        <translation>Zum Umsehen</translation>
    </message>
    <message>
        <source>Flat top</source>
        <translation>Flat Top</translation>
    </message>
    <message>
        <source>To read amplitudes: true to 0.1 % everywhere</source>
        <translation>Um Amplituden abzulesen: überall auf 0,1 % genau</translation>
    </message>
    <message>
        <source>Blackman-Harris</source>
        <translation>Blackman-Harris</translation>
    </message>
    <message>
        <source>To see small lines beside large ones</source>
        <translation>Um kleine Linien neben großen zu sehen</translation>
    </message>
    <message>
        <source>Rectangular</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>For whole periods only</source>
        <translation>Nur für ganze Perioden</translation>
    </message>
    <message>
        <source>all samples</source>
        <translation>alle Messwerte</translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n Messwert</numerusform>
            <numerusform>%n Messwerte</numerusform>
        </translation>
    </message>
    <message>
        <source>Samples of a transform. With fewer than there are, the transforms overlap by half and are averaged.</source>
        <translation>Messwerte einer Transformation. Sind es weniger als vorhanden, überlappen sich die Transformationen zur Hälfte und werden gemittelt.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>decibels</source>
        <translation>Dezibel</translation>
    </message>
    <message>
        <source>&amp;In</source>
        <translation>&amp;In</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Länge</translation>
    </message>
    <message>
        <source>Forgets what was averaged</source>
        <translation>Vergisst, was gemittelt wurde</translation>
    </message>
    <message>
        <source>C&amp;opy</source>
        <translation>Ko&amp;pieren</translation>
    </message>
    <message>
        <source>The table of peaks</source>
        <translation>Die Tabelle der Spitzen</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>No trace is shown on the scope.</source>
        <translation>Das Oszilloskop zeigt keine Kurve.</translation>
    </message>
    <message>
        <source>Choose a trace.</source>
        <translation>Wählen Sie eine Kurve.</translation>
    </message>
    <message>
        <source>The samples of this trace are not at equal distances, so it has no spectrum.</source>
        <translation>Die Messwerte dieser Kurve haben keine gleichen Abstände, also hat sie kein Spektrum.</translation>
    </message>
    <message>
        <source>Fewer than 16 samples in one piece: no spectrum.</source>
        <translation>Weniger als 16 Messwerte am Stück: kein Spektrum.</translation>
    </message>
    <message>
        <source>No orders: the speed or the motor&apos;s pole pairs are not known.</source>
        <translation>Keine Ordnungen: Die Drehzahl oder die Polpaare des Motors sind nicht bekannt.</translation>
    </message>
    <message>
        <source>%1 samples a transform, a line every %2</source>
        <comment>a number of samples; a distance of frequencies</comment>
        <translation>%1 Messwerte je Transformation, alle %2 eine Linie</translation>
    </message>
    <message numerus="yes">
        <source>mean of %n transforms</source>
        <translation>
            <numerusform>Mittel von %n Transformation</numerusform>
            <numerusform>Mittel von %n Transformationen</numerusform>
        </translation>
    </message>
    <message>
        <source>only the newest samples</source>
        <translation>nur die neuesten Messwerte</translation>
    </message>
    <message>
        <source>The mean of so many spectra, one after the other, of samples that do not overlap</source>
        <translation>Der Mittelwert so vieler Spektren nacheinander, aus Abtastwerten, die sich nicht überlappen</translation>
    </message>
    <message>
        <source>orders: largest peak</source>
        <translation>Ordnungen: höchste Spitze</translation>
    </message>
    <message>
        <source>orders: %1</source>
        <comment>name of a speed</comment>
        <translation>Ordn.: %1</translation>
    </message>
    <message>
        <source>T&amp;race</source>
        <translation>&amp;Kurve</translation>
    </message>
    <message>
        <source>Avera&amp;ge</source>
        <translation>Mi&amp;ttelung</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>A&amp;chse</translation>
    </message>
    <message>
        <source>S&amp;cale</source>
        <translation>&amp;Skala</translation>
    </message>
    <message>
        <source>Rest&amp;art</source>
        <translation>&amp;Neu starten</translation>
    </message>
</context>
<context>
    <name>widgets::SpectrumPeaks</name>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Order</source>
        <comment>a multiple of the electrical frequency</comment>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Relative</source>
        <comment>a peak compared with the largest one, in decibels</comment>
        <translation>Relativ</translation>
    </message>
</context>
<context>
    <name>widgets::SpectrumPlot</name>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Order</source>
        <comment>a multiple of the electrical frequency</comment>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>dB re 1 %1</source>
        <comment>level above one of the unit</comment>
        <translation>dB re 1 %1</translation>
    </message>
</context>
<context>
    <name>widgets::SpeedGains</name>
    <message>
        <source>&amp;Kp</source>
        <translation>&amp;Kp</translation>
    </message>
    <message>
        <source>K&amp;i</source>
        <translation>K&amp;i</translation>
    </message>
    <message>
        <source>%1 of the speed loop</source>
        <comment>Kp or Ki</comment>
        <translation>%1 des Drehzahlreglers</translation>
    </message>
    <message>
        <source>%1 digits</source>
        <comment>a gain whose unit is not known</comment>
        <translation>%1 Digits</translation>
    </message>
    <message>
        <source>%1 of the torque loop</source>
        <comment>Kp or Ki</comment>
        <translation>%1 des Momentenreglers</translation>
    </message>
    <message>
        <source>%1 of the flux loop</source>
        <comment>Kp or Ki</comment>
        <translation>%1 des Flussreglers</translation>
    </message>
    <message>
        <source>%1 of the position loop</source>
        <comment>Kp or Ki</comment>
        <translation>%1 des Positionsreglers</translation>
    </message>
</context>
<context>
    <name>widgets::StateBox</name>
    <message>
        <source>Causes…</source>
        <translation>Ursachen…</translation>
    </message>
    <message>
        <source>What these faults mean and what to try</source>
        <translation>Was diese Fehler bedeuten und was zu versuchen ist</translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <comment>number, state</comment>
        <translation>Motor %1: %2</translation>
    </message>
    <message>
        <source>Faults are not known</source>
        <translation>Fehler sind nicht bekannt</translation>
    </message>
    <message>
        <source>No fault present</source>
        <translation>Kein Fehler liegt an</translation>
    </message>
    <message>
        <source>Present: %1</source>
        <translation>Liegt an: %1</translation>
    </message>
    <message>
        <source>To acknowledge: %1</source>
        <translation>Zu quittieren: %1</translation>
    </message>
    <message>
        <source>Recorded: %1</source>
        <comment>state</comment>
        <translation>Aufgezeichnet: %1</translation>
    </message>
</context>
<context>
    <name>widgets::StateStrip</name>
    <message>
        <source>State of the motor: not known</source>
        <translation>Zustand des Motors: nicht bekannt</translation>
    </message>
    <message>
        <source>State of the motor: %1</source>
        <translation>Zustand des Motors: %1</translation>
    </message>
</context>
<context>
    <name>widgets::StatusStrip</name>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Negotiated packet sizes: request / answer / stream</source>
        <translation>Ausgehandelte Paketgrößen: Anfrage / Antwort / Strom</translation>
    </message>
    <message>
        <source>Bytes received a second, and their share of what the link can carry</source>
        <translation>Empfangene Bytes je Sekunde und ihr Anteil an dem, was die Verbindung trägt</translation>
    </message>
    <message>
        <source>simulated board</source>
        <translation>simuliertes Board</translation>
    </message>
    <message>
        <source>%1 / %2 / %3 B</source>
        <comment>sizes in bytes: request, answer, stream</comment>
        <translation>%1 / %2 / %3 B</translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <comment>number, state</comment>
        <translation>Motor %1: %2</translation>
    </message>
    <message>
        <source>Faults: %1</source>
        <comment>how many</comment>
        <translation>Fehler: %1</translation>
    </message>
    <message>
        <source>Lost: %1</source>
        <comment>control periods without samples</comment>
        <translation>Verloren: %1</translation>
    </message>
    <message>
        <source>Control periods that no packet holds</source>
        <translation>Regelperioden, die in keinem Paket stehen</translation>
    </message>
    <message>
        <source>%1 samples were recorded by the board but came too fast to be shown.</source>
        <translation>%1 Abtastwerte hat das Board aufgezeichnet, aber sie kamen zu schnell, um gezeigt zu werden.</translation>
    </message>
    <message>
        <source>Bad packets: %1</source>
        <translation>Schlechte Pakete: %1</translation>
    </message>
    <message>
        <source>%1 kB/s (%2 %)</source>
        <comment>received, percent of the link</comment>
        <translation>%1 kB/s (%2 %)</translation>
    </message>
    <message>
        <source>This drive has no communication time-out: when the link is gone, the motor goes on turning.</source>
        <translation>Dieser Antrieb hat keine Zeitüberwachung der Kommunikation: Reißt die Verbindung ab, dreht der Motor weiter.</translation>
    </message>
    <message>
        <source>Drive watchdog: %1 ms</source>
        <translation>Überwachung im Antrieb: %1 ms</translation>
    </message>
    <message>
        <source>Drive watchdog: none</source>
        <translation>Überwachung im Antrieb: keine</translation>
    </message>
    <message>
        <source>replay of %1</source>
        <translation>Wiedergabe von %1</translation>
    </message>
    <message>
        <source>This drive stops its motor by itself when it has not been fed for that time. It needs a sign of life from a window that responds and is armed: disarming stops what turns. It is not a safety function.</source>
        <translation>Dieser Antrieb hält seinen Motor von selbst an, wenn er so lange kein Lebenszeichen bekommt. Das sendet nur ein Fenster, das reagiert und freigegeben ist: Ohne Freigabe hält er an. Das ist keine Sicherheitsfunktion.</translation>
    </message>
    <message>
        <source>baud</source>
        <translation>Baud</translation>
    </message>
</context>
<context>
    <name>widgets::StepFields</name>
    <message>
        <source>How long each speed is held: longer than the loop takes to settle</source>
        <translation>Wie lange jede Drehzahl gehalten wird: länger, als der Regler zum Ausregeln braucht</translation>
    </message>
    <message>
        <source>Of the ramp to the first speed, and of the way back</source>
        <translation>Der Rampe zur ersten Drehzahl und des Rückwegs</translation>
    </message>
    <message>
        <source>So many steps up, and as many down</source>
        <translation>So viele Sprünge aufwärts und ebenso viele abwärts</translation>
    </message>
    <message>
        <source>%1, rpm</source>
        <comment>a field</comment>
        <translation>%1, rpm</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>Fr&amp;om</source>
        <translation>Vo&amp;n</translation>
    </message>
    <message>
        <source>to</source>
        <comment>a speed</comment>
        <translation>auf</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>at</source>
        <comment>a speed</comment>
        <translation>bei</translation>
    </message>
    <message>
        <source>How fast the motor turns meanwhile, negative for torques that push it backwards</source>
        <translation>Wie schnell der Motor dabei dreht, negativ für Momente, die ihn rückwärts treiben</translation>
    </message>
    <message>
        <source>What is stepped</source>
        <translation>Was springt</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>How long each current is held: nothing holds the speed meanwhile</source>
        <translation>Wie lange jeder Strom gehalten wird: nichts hält dabei die Drehzahl</translation>
    </message>
    <message>
        <source>How long each position is held: longer than the loop takes to settle</source>
        <translation>Wie lange jede Position gehalten wird: länger, als der Regler zum Ausregeln braucht</translation>
    </message>
    <message>
        <source>in</source>
        <comment>a time</comment>
        <translation>in</translation>
    </message>
    <message>
        <source>The time of each move, there and back</source>
        <translation>Die Zeit jeder Bewegung, hin und zurück</translation>
    </message>
    <message>
        <source>B&amp;y</source>
        <comment>an angle</comment>
        <translation>&amp;um</translation>
    </message>
    <message>
        <source>How far the shaft is moved from where it rests, and back</source>
        <translation>Wie weit die Welle von ihrer Ruhestellung bewegt wird, und zurück</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a field, its unit</comment>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>widgets::StepOverlay</name>
    <message>
        <source>No step yet.</source>
        <translation>Noch kein Sprung.</translation>
    </message>
    <message>
        <source>Steps over one another</source>
        <translation>Sprünge übereinander</translation>
    </message>
    <message>
        <source>Time since the step [ms]</source>
        <translation>Zeit seit dem Sprung [ms]</translation>
    </message>
    <message>
        <source>Speed [rpm]</source>
        <translation>Drehzahl [rpm]</translation>
    </message>
    <message>
        <source>Not drawn: samples are missing.</source>
        <translation>Nicht gezeichnet: es fehlen Messwerte.</translation>
    </message>
    <message>
        <source>Iq [A]</source>
        <translation>Iq [A]</translation>
    </message>
    <message>
        <source>Id [A]</source>
        <translation>Id [A]</translation>
    </message>
    <message>
        <source>Position [°]</source>
        <translation>Position [°]</translation>
    </message>
</context>
<context>
    <name>widgets::StepPage</name>
    <message>
        <source>Steps in the picture</source>
        <translation>Sprünge im Bild</translation>
    </message>
    <message>
        <source>steps up</source>
        <translation>Sprünge aufwärts</translation>
    </message>
    <message>
        <source>steps down</source>
        <translation>Sprünge abwärts</translation>
    </message>
    <message>
        <source>Series of steps</source>
        <translation>Reihen von Sprüngen</translation>
    </message>
    <message>
        <source>The others show their difference to the chosen series (Enter)</source>
        <translation>Die anderen zeigen ihren Unterschied zur gewählten Reihe (Eingabetaste)</translation>
    </message>
    <message>
        <source>Takes the chosen series out of the table and the picture (Delete)</source>
        <translation>Nimmt die gewählten Reihen aus Tabelle und Bild (Entf)</translation>
    </message>
    <message>
        <source>The gains are being read.</source>
        <translation>Die Verstärkungen werden gelesen.</translation>
    </message>
    <message>
        <source>On the way to the first speed…</source>
        <translation>Auf dem Weg zur ersten Drehzahl…</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <comment>numbers</comment>
        <translation>Sprung %1 von %2</translation>
    </message>
    <message>
        <source>The gains were changed meanwhile: the row has the first.</source>
        <translation>Die Verstärkungen wurden unterdessen geändert: Die Zeile nennt die ersten.</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>Im Bild</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Run steps</source>
        <translation>Springen</translation>
    </message>
    <message>
        <source>Steps up and down; then the motor is as it was (Ctrl+Shift+T).</source>
        <translation>Springt auf und ab; danach ist der Motor wie zuvor (Strg+Umschalt+T).</translation>
    </message>
    <message>
        <source>The speed is held: put the load on, and take it off.</source>
        <translation>Die Drehzahl wird gehalten: Last aufbringen und wegnehmen.</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>Holds the speed that the motor has for 10 s, in which you put a load on it and take it off: says how far the speed gives way, and when it is back.</source>
        <translation>Hält die Drehzahl des Motors für 10 s, in denen Sie eine Last aufbringen und wegnehmen: sagt, wie weit die Drehzahl nachgibt und wann sie zurück ist.</translation>
    </message>
    <message>
        <source>This board does not control the position of its shaft.</source>
        <translation>Dieses Board regelt die Position ihrer Welle nicht.</translation>
    </message>
    <message>
        <source>Nothing holds your own limit of the speed in position control: take it away first.</source>
        <translation>In der Positionsregelung hält nichts Ihre eigene Grenze der Drehzahl ein: Nehmen Sie diese zuerst weg.</translation>
    </message>
</context>
<context>
    <name>widgets::StepRuns</name>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>%1× up, %2× down</source>
        <comment>numbers of steps</comment>
        <translation>%1× aufwärts, %2× abwärts</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Reihe</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>Kp</source>
        <translation>Kp</translation>
    </message>
    <message>
        <source>Ki</source>
        <translation>Ki</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>Anstieg</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Ausregeln</translation>
    </message>
    <message>
        <source>Peak Iq</source>
        <translation>Spitze Iq</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Zwischenkreis</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>least and greatest voltage</comment>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Step %1, up: %2</source>
        <comment>number, what was measured</comment>
        <translation>Sprung %1, aufwärts: %2</translation>
    </message>
    <message>
        <source>Step %1, down: %2</source>
        <comment>number, what was measured</comment>
        <translation>Sprung %1, abwärts: %2</translation>
    </message>
    <message>
        <source>%1, ref.</source>
        <comment>number of the run that others are compared with</comment>
        <translation>%1, Ref.</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>Flux</source>
        <translation>Fluss</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
</context>
<context>
    <name>widgets::StopAlarm</name>
    <message>
        <source>Stop motors</source>
        <translation>Motoren stoppen</translation>
    </message>
    <message>
        <source>Take the Stop &amp;back</source>
        <translation>Stopp &amp;zurücknehmen</translation>
    </message>
    <message>
        <source>The port is open again, and the stop goes on.</source>
        <translation>Die Schnittstelle ist wieder offen, und der Stopp geht weiter.</translation>
    </message>
    <message>
        <source>Motor %1: meanwhile standstill was measured.</source>
        <translation>Motor %1: Inzwischen wurde Stillstand gemessen.</translation>
    </message>
    <message>
        <source>Motor %1: meanwhile its drive is idle. Its speed is not measurable: the rotor may coast.</source>
        <translation>Motor %1: Inzwischen treibt ihn nichts mehr an. Seine Drehzahl ist nicht messbar: der Rotor läuft vielleicht aus.</translation>
    </message>
    <message>
        <source>Motor %1: meanwhile its drive is idle.</source>
        <translation>Motor %1: Inzwischen treibt ihn nichts mehr an.</translation>
    </message>
    <message>
        <source>Motor %1 was told to stop, but neither its state nor its speed shows that it did.</source>
        <translation>Motor %1 wurde der Stopp befohlen, aber weder Zustand noch Drehzahl zeigen, dass er steht.</translation>
    </message>
    <message>
        <source>Rotorscope goes on trying. Closing this message starts nothing again.</source>
        <translation>Rotorscope versucht es weiter. Das Schließen dieser Meldung startet nichts.</translation>
    </message>
    <message>
        <source>%1 is not open any more, and no evidence of the stop had come. The motor may still be turning. As soon as a port is open again, what is found there is stopped before anything else. Closing this message starts nothing again and takes nothing back.</source>
        <comment>one or more ports</comment>
        <translation>%1 ist nicht mehr offen, und bis dahin gab es keinen Beleg für den Stopp. Der Motor dreht sich womöglich noch. Sobald wieder eine Schnittstelle offen ist, wird vor allem anderen gestoppt, was dort gefunden wird. Das Schließen dieser Meldung startet nichts und nimmt nichts zurück.</translation>
    </message>
    <message>
        <source>There is no connection that could carry the stop, and the motor was not at rest when it was last heard. Closing this message starts nothing again.</source>
        <translation>Es besteht keine Verbindung, die den Stopp übertragen könnte, und der Motor war nicht in Ruhe, als er zuletzt zu hören war. Das Schließen dieser Meldung startet nichts.</translation>
    </message>
    <message>
        <source>At first nothing confirmed the stop. Closing this message starts nothing again.</source>
        <translation>Zuerst hat nichts den Stopp bestätigt. Das Schließen dieser Meldung startet nichts.</translation>
    </message>
    <message>
        <source>Confirmed late: standstill was measured.</source>
        <translation>Spät bestätigt: Stillstand wurde gemessen.</translation>
    </message>
</context>
<context>
    <name>widgets::StopButton</name>
    <message>
        <source>Stop motors (Esc)</source>
        <translation>Motoren stoppen (Esc)</translation>
    </message>
    <message>
        <source>Stop motors</source>
        <translation>Motoren stoppen</translation>
    </message>
    <message>
        <source>Stops every motor at once, from anywhere: press it or the Esc key.
A program on a PC is no replacement for a switch that removes the power.</source>
        <translation>Stoppt sofort jeden Motor, von überall: Drücken Sie den Knopf oder die Esc-Taste.
Ein Programm auf einem PC ersetzt keinen Schalter, der die Spannung wegnimmt.</translation>
    </message>
</context>
<context>
    <name>widgets::StopWords</name>
    <message>
        <source>%1 s ago</source>
        <translation>vor %1 s</translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation>Motor %1</translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <comment>number, word of a stop</comment>
        <translation>Motor %1: %2</translation>
    </message>
</context>
<context>
    <name>widgets::ToolDocks</name>
    <message>
        <source>&amp;Close all tools</source>
        <translation>Alle Werkzeuge &amp;schließen</translation>
    </message>
</context>
<context>
    <name>widgets::Tools</name>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Records</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Math</source>
        <translation>Mathematik</translation>
    </message>
    <message>
        <source>XY</source>
        <translation>XY</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>Schnappschüsse</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Verstärkungen</translation>
    </message>
    <message>
        <source>Rev-up</source>
        <translation>Anlauf</translation>
    </message>
    <message>
        <source>Ramps</source>
        <translation>Rampen</translation>
    </message>
    <message>
        <source>Motor and drive</source>
        <translation>Motor und Antrieb</translation>
    </message>
    <message>
        <source>Motion log</source>
        <translation>Bewegungsprotokoll</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>Exportiert nach %1.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Step response</source>
        <translation>&amp;Sprungantwort</translation>
    </message>
    <message>
        <source>&amp;Trigger on it</source>
        <translation>Darauf &amp;triggern</translation>
    </message>
    <message>
        <source>&amp;Spectrum</source>
        <translation>&amp;Spektrum</translation>
    </message>
    <message>
        <source>&amp;XY, upward</source>
        <translation>&amp;XY, nach oben</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identifizieren</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Run book</source>
        <translation>Versuchsbuch</translation>
    </message>
</context>
<context>
    <name>widgets::TourPage</name>
    <message>
        <source>Stations of the tour</source>
        <translation>Stationen des Rundgangs</translation>
    </message>
    <message>
        <source>How near to instability the proposed gains go: Ms at most 1.4, 1.7, 2.0</source>
        <translation>Wie nahe die Vorschläge an die Instabilität gehen: Ms höchstens 1,4, 1,7, 2,0</translation>
    </message>
    <message>
        <source>stiff</source>
        <translation>ruhig</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>quick</source>
        <translation>schnell</translation>
    </message>
    <message>
        <source>Of each response; the longer, the narrower its error bars</source>
        <translation>Jedes Frequenzgangs; je länger, desto schmaler seine Fehlerbalken</translation>
    </message>
    <message>
        <source>&amp;Goal</source>
        <translation>Z&amp;iel</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Länge</translation>
    </message>
    <message>
        <source>Measures windings, mechanics and the response of the speed, one after the other, and proposes gains; nothing is written.</source>
        <translation>Misst Wicklungen, Mechanik und den Frequenzgang der Drehzahl, nacheinander, und schlägt Verstärkungen vor; geschrieben wird nichts.</translation>
    </message>
    <message>
        <source>&amp;Apply and prove</source>
        <translation>A&amp;nwenden und nachweisen</translation>
    </message>
    <message>
        <source>Writes the proposed gains as one step, which can be undone, reads them back, and measures the response and steps with them.</source>
        <translation>Schreibt die vorgeschlagenen Verstärkungen als einen Schritt, der rückgängig zu machen ist, liest sie zurück und misst Frequenzgang und Sprünge mit ihnen.</translation>
    </message>
    <message>
        <source>&amp;Back to the old gains</source>
        <translation>&amp;Zurück zu den alten Verstärkungen</translation>
    </message>
    <message>
        <source>The board sees its rotor and is armed.</source>
        <translation>Das Board sieht seinen Rotor und ist freigegeben.</translation>
    </message>
    <message>
        <source>The board observes its rotor without a sensor, and is armed.</source>
        <translation>Das Board beobachtet seinen Rotor ohne Sensor und ist freigegeben.</translation>
    </message>
    <message>
        <source>Crossover %1 Hz, Ms %2</source>
        <translation>Durchtritt %1 Hz, Ms %2</translation>
    </message>
    <message>
        <source>Writes the gains from before the first Apply, as one step</source>
        <translation>Schreibt die Verstärkungen von vor dem ersten Anwenden, als einen Schritt</translation>
    </message>
    <message>
        <source>No gains keep the distance of this goal.</source>
        <translation>Keine Verstärkungen halten den Abstand dieses Ziels.</translation>
    </message>
    <message>
        <source>Kp %1, Ki %2: crossover %3 Hz, phase margin %4°, Ms %5 predicted</source>
        <translation>Kp %1, Ki %2: Durchtritt %3 Hz, Phasenreserve %4°, Ms %5 vorhergesagt</translation>
    </message>
    <message>
        <source>%1; the board holds them.</source>
        <translation>%1; das Board hat sie.</translation>
    </message>
    <message>
        <source>%1; not written yet.</source>
        <translation>%1; noch nicht geschrieben.</translation>
    </message>
    <message>
        <source>Sta&amp;rt the tour</source>
        <translation>&amp;Rundgang beginnen</translation>
    </message>
    <message>
        <source>Make the tour first: it proposes the gains.</source>
        <translation>Zuerst den Rundgang machen: er schlägt die Verstärkungen vor.</translation>
    </message>
    <message>
        <source>The response was not conclusive: no gains follow from it.</source>
        <translation>Der Frequenzgang war nicht schlüssig: Aus ihm folgen keine Verstärkungen.</translation>
    </message>
    <message>
        <source>There are no gains to prove.</source>
        <translation>Es gibt keine Verstärkungen zu prüfen.</translation>
    </message>
    <message>
        <source>Go on with the tou&amp;r</source>
        <translation>&amp;Rundgang fortsetzen</translation>
    </message>
    <message>
        <source>Go on with the tour: it begins there.</source>
        <translation>Rundgang fortsetzen: Er beginnt dort.</translation>
    </message>
    <message>
        <source>Measures the response, and proposes gains from it. Instead of the gains with which the speed swung it takes gentler ones meanwhile, and asks about them; others are taken as they are.</source>
        <translation>Misst den Frequenzgang und schlägt daraus Verstärkungen vor. Statt derer, mit denen die Drehzahl schwang, nimmt es währenddessen sanftere und fragt danach; andere werden genommen, wie sie sind.</translation>
    </message>
</context>
<context>
    <name>widgets::TourSteps</name>
    <message>
        <source>1. Check</source>
        <translation>1. Prüfung</translation>
    </message>
    <message>
        <source>2. Rs, L, flux</source>
        <translation>2. Rs, L, Fluss</translation>
    </message>
    <message>
        <source>3. Inertia, friction</source>
        <translation>3. Trägheit, Reibung</translation>
    </message>
    <message>
        <source>4. Response</source>
        <translation>4. Frequenzgang</translation>
    </message>
    <message>
        <source>5. Gains</source>
        <translation>5. Verstärkungen</translation>
    </message>
    <message>
        <source>6. Proof</source>
        <translation>6. Nachweis</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>▶ runs</source>
        <translation>▶ läuft</translation>
    </message>
    <message>
        <source>✓ done</source>
        <translation>✓ fertig</translation>
    </message>
    <message>
        <source>? not conclusive</source>
        <translation>? nicht schlüssig</translation>
    </message>
    <message>
        <source>– not possible here</source>
        <translation>– hier nicht möglich</translation>
    </message>
    <message>
        <source>– passed over</source>
        <translation>– übergangen</translation>
    </message>
    <message>
        <source>✖ ended</source>
        <translation>✖ beendet</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Was dabei herauskam</translation>
    </message>
</context>
<context>
    <name>widgets::TriggerBar</name>
    <message>
        <source>Roll: the newest samples. Auto: records, also without a trigger. Normal: keeps the last record. Single: one record</source>
        <translation>Rollen: die neuesten Messwerte. Auto: Aufnahmen, auch ohne Trigger. Normal: behält die letzte Aufnahme. Einzeln: eine Aufnahme</translation>
    </message>
    <message>
        <source>What the trigger waits for</source>
        <translation>Worauf der Trigger wartet</translation>
    </message>
    <message>
        <source>The trace that is watched</source>
        <translation>Die beobachtete Kurve</translation>
    </message>
    <message>
        <source>Mode of the trigger</source>
        <translation>Betriebsart des Triggers</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Einzeln</translation>
    </message>
    <message>
        <source>Takes one record, then stops (S)</source>
        <translation>Nimmt einmal auf und hält an (S)</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>A trigger now (T)</source>
        <translation>Jetzt triggern (T)</translation>
    </message>
    <message>
        <source>All settings of the trigger</source>
        <translation>Alle Einstellungen des Triggers</translation>
    </message>
    <message>
        <source>&amp;Upper level</source>
        <translation>&amp;Oberer Pegel</translation>
    </message>
    <message>
        <source>&amp;Hysteresis</source>
        <translation>&amp;Hysterese</translation>
    </message>
    <message>
        <source>between these times</source>
        <translation>zwischen diesen Zeiten</translation>
    </message>
    <message>
        <source>all but between them</source>
        <translation>alle außer dazwischen</translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation>&amp;Dauer</translation>
    </message>
    <message>
        <source>At &amp;least</source>
        <translation>&amp;Mindestens</translation>
    </message>
    <message>
        <source>At &amp;most</source>
        <translation>Höchste&amp;ns</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>&amp;Flanken</translation>
    </message>
    <message>
        <source>Hold-&amp;off</source>
        <translation>&amp;Sperrzeit</translation>
    </message>
    <message>
        <source>Which way: %1</source>
        <translation>Richtung: %1</translation>
    </message>
    <message>
        <source>%1; also the arrow at the right edge of the plot</source>
        <translation>%1; auch der Pfeil am rechten Rand des Diagramms</translation>
    </message>
    <message>
        <source>File: replay it to trigger</source>
        <translation>Datei: zum Triggern wiedergeben</translation>
    </message>
    <message>
        <source>State of the trigger, and how old the shown record is</source>
        <translation>Zustand des Triggers und Alter der gezeigten Aufnahme</translation>
    </message>
    <message>
        <source>The trigger waits for samples, and a file has none to come. A replay of it (Ctrl+Shift+R) has.</source>
        <translation>Der Trigger wartet auf Messwerte, und eine Datei bekommt keine mehr. Bei ihrer Wiedergabe (Strg+Umschalt+R) kommen sie.</translation>
    </message>
    <message>
        <source>Pre-trig&amp;ger</source>
        <translation>&amp;Vortrigger</translation>
    </message>
    <message>
        <source>&amp;Record length</source>
        <translation>Aufnahme&amp;länge</translation>
    </message>
    <message>
        <source>Set level to &amp;50 %</source>
        <translation>Pegel auf &amp;50 % setzen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>The register whose write is waited for</source>
        <translation>Das Register, auf dessen Schreiben gewartet wird</translation>
    </message>
    <message>
        <source>Any register</source>
        <translation>Jedes Register</translation>
    </message>
</context>
<context>
    <name>widgets::ValueEdit</name>
    <message>
        <source>Not understood: a number from %1 to %2</source>
        <translation>Nicht verstanden: eine Zahl von %1 bis %2</translation>
    </message>
</context>
<context>
    <name>widgets::WholeSpin</name>
    <message>
        <source>A whole number from %1 to %2.</source>
        <translation>Eine ganze Zahl von %1 bis %2.</translation>
    </message>
</context>
<context>
    <name>widgets::Workspaces</name>
    <message>
        <source>Workspaces (*.workspace)</source>
        <translation>Arbeitsplätze (*.workspace)</translation>
    </message>
    <message>
        <source>Open a workspace</source>
        <translation>Arbeitsplatz öffnen</translation>
    </message>
    <message>
        <source>Save the workspace</source>
        <translation>Arbeitsplatz speichern</translation>
    </message>
    <message>
        <source>bench</source>
        <translation>pruefstand</translation>
    </message>
    <message>
        <source>%1 was not opened: %2</source>
        <comment>a file, the reason</comment>
        <translation>%1 wurde nicht geöffnet: %2</translation>
    </message>
    <message>
        <source>%1 was not written: %2</source>
        <comment>a file, the reason</comment>
        <translation>%1 wurde nicht geschrieben: %2</translation>
    </message>
    <message>
        <source>The workspace is in %1.</source>
        <translation>Der Arbeitsplatz ist in %1.</translation>
    </message>
    <message>
        <source>Reference %1 is not in it: there is room for %2 samples.</source>
        <translation>Referenz %1 ist nicht darin: Platz ist für %2 Abtastwerte.</translation>
    </message>
    <message>
        <source>Replace the notes?</source>
        <translation>Notizen ersetzen?</translation>
    </message>
    <message>
        <source>The notes that are shown are in no workspace file. Those of %1 take their place.</source>
        <translation>Die gezeigten Notizen stehen in keiner Arbeitsplatz-Datei. Die von %1 treten an ihre Stelle.</translation>
    </message>
    <message>
        <source>They cannot be brought back.</source>
        <translation>Sie lassen sich nicht zurückholen.</translation>
    </message>
    <message>
        <source>&amp;Replace the notes</source>
        <translation>Notizen &amp;ersetzen</translation>
    </message>
    <message>
        <source>&amp;Keep these notes</source>
        <translation>Diese Notizen &amp;behalten</translation>
    </message>
</context>
<context>
    <name>widgets::XyPanel</name>
    <message>
        <source>E&amp;qual scales</source>
        <translation>Glei&amp;che Maßstäbe</translation>
    </message>
    <message>
        <source>Currents α β</source>
        <translation>Ströme α β</translation>
    </message>
    <message>
        <source>Currents d q</source>
        <translation>Ströme d q</translation>
    </message>
    <message>
        <source>Voltages α β</source>
        <translation>Spannungen α β</translation>
    </message>
    <message>
        <source>Voltages d q</source>
        <translation>Spannungen d q</translation>
    </message>
    <message>
        <source>Two traces</source>
        <translation>Zwei Kurven</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>dem Bild</translation>
    </message>
    <message>
        <source>its newest 100 ms</source>
        <translation>seinen neuesten 100 ms</translation>
    </message>
    <message>
        <source>between the cursors</source>
        <translation>zwischen den Cursorn</translation>
    </message>
    <message>
        <source>the older the paler</source>
        <translation>je älter, desto blasser</translation>
    </message>
    <message>
        <source>all alike</source>
        <translation>überall gleich</translation>
    </message>
    <message>
        <source>the newest only</source>
        <translation>nur das Neueste</translation>
    </message>
    <message>
        <source>&amp;X</source>
        <translation>&amp;X</translation>
    </message>
    <message>
        <source>&amp;Y</source>
        <translation>&amp;Y</translation>
    </message>
    <message>
        <source>&amp;In</source>
        <translation>&amp;In</translation>
    </message>
    <message>
        <source>Record I_A and I_B, or the currents α and β, to see this.</source>
        <translation>Dafür I_A und I_B oder die Ströme α und β aufzeichnen.</translation>
    </message>
    <message>
        <source>Record the measured currents d and q to see this.</source>
        <translation>Dafür die gemessenen Ströme d und q aufzeichnen.</translation>
    </message>
    <message>
        <source>Record V_ALPHA and V_BETA to see this.</source>
        <translation>Dafür V_ALPHA und V_BETA aufzeichnen.</translation>
    </message>
    <message>
        <source>Record V_D and V_Q to see this.</source>
        <translation>Dafür V_D und V_Q aufzeichnen.</translation>
    </message>
    <message>
        <source>No trace is shown on the scope.</source>
        <translation>Auf dem Oszilloskop ist keine Kurve zu sehen.</translation>
    </message>
    <message>
        <source>Choose a trace for X and for Y.</source>
        <translation>Wählen Sie je eine Kurve für X und für Y.</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <comment>a signal and its unit</comment>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>Nothing is recorded of both at the same time in this stretch.</source>
        <translation>In diesem Abschnitt ist von beiden nichts zur selben Zeit aufgezeichnet.</translation>
    </message>
    <message>
        <source>Newest: %1 at %2°</source>
        <comment>the length and the angle of a vector</comment>
        <translation>Neuester: %1 bei %2°</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>, each of %1 instants</source>
        <comment>a number, such as 4</comment>
        <translation>, je einer für %1 Zeitpunkte</translation>
    </message>
    <message>
        <source>Computed from I_A and I_B, β as the board counts it.</source>
        <translation>Berechnet aus I_A und I_B, β wie es das Board zählt.</translation>
    </message>
    <message>
        <source>only the newest samples</source>
        <translation>nur die neuesten Messwerte</translation>
    </message>
    <message>
        <source>Dashed: what the bus allows; dotted: without distortion.</source>
        <translation>Gestrichelt: was der Zwischenkreis zulässt; gepunktet: ohne Verzerrung.</translation>
    </message>
    <message>
        <source>The bus voltage is not known, so its limits are not drawn.</source>
        <translation>Die Zwischenkreisspannung ist nicht bekannt, darum fehlen ihre Grenzen.</translation>
    </message>
    <message>
        <source>Dra&amp;w</source>
        <translation>&amp;Zeichnen</translation>
    </message>
    <message>
        <source>T&amp;rail</source>
        <translation>S&amp;pur</translation>
    </message>
</context>
<context>
    <name>widgets::XyPlot</name>
    <message>
        <source>XY picture</source>
        <translation>XY-Bild</translation>
    </message>
    <message>
        <source>bus %1 V</source>
        <translation>Zwischenkreis %1 V</translation>
    </message>
</context>
</TS>
