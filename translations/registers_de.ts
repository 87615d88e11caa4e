<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_US">
<context>
    <name>RegisterGroups</name>
    <message>
        <source>Motor state</source>
        <translation>Motorzustand</translation>
    </message>
    <message>
        <source>Start-up</source>
        <translation>Anlauf</translation>
    </message>
    <message>
        <source>PFC</source>
        <translation>PFC</translation>
    </message>
    <message>
        <source>Profiler</source>
        <translation>Profiler</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Six-step</source>
        <translation>Blockkommutierung</translation>
    </message>
    <message>
        <source>Speed loop</source>
        <translation>Drehzahlregler</translation>
    </message>
    <message>
        <source>Current loop</source>
        <translation>Stromregler</translation>
    </message>
    <message>
        <source>Observer + PLL</source>
        <translation>Beobachter + PLL</translation>
    </message>
    <message>
        <source>Observer + CORDIC</source>
        <translation>Beobachter + CORDIC</translation>
    </message>
    <message>
        <source>Flux weakening</source>
        <translation>Feldschwächung</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>DAC and debug</source>
        <translation>DAC und Fehlersuche</translation>
    </message>
    <message>
        <source>Ramps and references</source>
        <translation>Rampen und Sollwerte</translation>
    </message>
    <message>
        <source>Encoder and Hall</source>
        <translation>Encoder und Hall</translation>
    </message>
    <message>
        <source>Feed forward</source>
        <translation>Vorsteuerung</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>Identität</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>Konfiguration</translation>
    </message>
    <message>
        <source>Datalog</source>
        <translation>Datenaufzeichnung</translation>
    </message>
    <message>
        <source>Modulation</source>
        <translation>Modulation</translation>
    </message>
    <message>
        <source>Motor parameters</source>
        <translation>Motorparameter</translation>
    </message>
    <message>
        <source>Sensing and offsets</source>
        <translation>Messung und Offsets</translation>
    </message>
    <message>
        <source>HSO and ZeST observer</source>
        <translation>HSO- und ZeST-Beobachter</translation>
    </message>
</context>
<context>
    <name>RegisterHelp</name>
    <message>
        <source>Control modality. SET acts on 3 speed and 4 torque (plus 1/2 with open-loop debug); other values answer OK and do nothing</source>
        <translation>Regelungsart. SET wirkt bei 3 Drehzahl und 4 Drehmoment (dazu 1/2 mit Fehlersuche im gesteuerten Betrieb); andere Werte werden mit OK beantwortet und bewirken nichts</translation>
    </message>
    <message>
        <source>Number of rev-up stages</source>
        <translation>Anzahl der Anlaufstufen</translation>
    </message>
    <message>
        <source>PFC state; GET answers OK with a stale byte, SET answers RO</source>
        <translation>Zustand der PFC; GET antwortet OK mit einem veralteten Byte, SET antwortet RO</translation>
    </message>
    <message>
        <source>PFC on/off; SET and GET answer OK but carry no data</source>
        <translation>PFC ein/aus; SET und GET antworten OK, übertragen aber keine Daten</translation>
    </message>
    <message>
        <source>Always 1: profiler present</source>
        <translation>Immer 1: Profiler vorhanden</translation>
    </message>
    <message>
        <source>Profiler progress: self-commissioning state plus one-touch-tuning state (sum)</source>
        <translation>Fortschritt des Profilers: Zustand der Selbstinbetriebnahme plus Zustand der automatischen Einstellung (Summe)</translation>
    </message>
    <message>
        <source>Total number of profiler states (max value SC_STATE reaches)</source>
        <translation>Anzahl aller Profilerzustände (größter Wert, den SC_STATE erreicht)</translation>
    </message>
    <message>
        <source>Pole pair number used or found by the profiler; SET rewrites it in the speed sensors too</source>
        <translation>Polpaarzahl, die der Profiler benutzt oder gefunden hat; SET schreibt sie auch in die Drehzahlsensoren</translation>
    </message>
    <message>
        <source>FOC execution rate used by the profiler</source>
        <translation>Takt der FOC, den der Profiler benutzt</translation>
    </message>
    <message>
        <source>1 once the motor has been profiled</source>
        <translation>1, sobald der Motor vermessen ist</translation>
    </message>
    <message>
        <source>0 ready 1 moving 2 target reached 3 following</source>
        <translation>0 bereit 1 in Bewegung 2 Ziel erreicht 3 folgt</translation>
    </message>
    <message>
        <source>0 awaiting 1 zero-alignment running 2 completed 3 absolute not supported 4 absolute supported 5 error</source>
        <translation>0 wartet 1 Nullausrichtung läuft 2 fertig 3 Absolutlage nicht unterstützt 4 Absolutlage unterstützt 5 Fehler</translation>
    </message>
    <message>
        <source>Hall tuning state machine 0..19</source>
        <translation>Zustand der Hall-Einmessung 0..19</translation>
    </message>
    <message>
        <source>Hall tuning progress</source>
        <translation>Fortschritt der Hall-Einmessung</translation>
    </message>
    <message>
        <source>Detected Hall placement: 0 unknown or 60 or 120 degrees</source>
        <translation>Erkannte Anordnung der Hallsensoren: 0 unbekannt oder 60 oder 120 Grad</translation>
    </message>
    <message>
        <source>Wanted mechanical direction for Hall tuning</source>
        <translation>Gewünschte mechanische Drehrichtung für die Hall-Einmessung</translation>
    </message>
    <message>
        <source>Bit i (0..5): low-side modulation in step i+1. Id 27 was FAST_DEMAG up to 6.2</source>
        <translation>Bit i (0..5): Modulation der unteren Schalter in Schritt i+1. Id 27 war bis 6.2 FAST_DEMAG</translation>
    </message>
    <message>
        <source>Quasi-synchronous rectification; only the value 1 enables</source>
        <translation>Quasisynchrone Gleichrichtung; nur der Wert 1 schaltet sie ein</translation>
    </message>
    <message>
        <source>Selects power-board characterisation in the profiler (implementation not public)</source>
        <translation>Wählt die Vermessung des Leistungsteils im Profiler (Umsetzung nicht öffentlich)</translation>
    </message>
    <message>
        <source>Open-loop duty-cycle reference</source>
        <translation>Tastgrad-Sollwert im gesteuerten Betrieb</translation>
    </message>
    <message>
        <source>Averaging depth applied to the open-loop duty reference. Id 31 was COMMUTATION_STEPBUFSIZE in 6.3</source>
        <translation>Mittelungstiefe für den Tastgrad-Sollwert im gesteuerten Betrieb. Id 31 war in 6.3 COMMUTATION_STEPBUFSIZE</translation>
    </message>
    <message>
        <source>Open-loop on/off</source>
        <translation>Gesteuerter Betrieb ein/aus</translation>
    </message>
    <message>
        <source>Run the rev-up while in open loop</source>
        <translation>Den Anlauf im gesteuerten Betrieb durchfahren</translation>
    </message>
    <message>
        <source>Voltage-mode factor of open loop</source>
        <translation>Faktor des gesteuerten Betriebs bei Spannungsvorgabe</translation>
    </message>
    <message>
        <source>BEMF sensing during PWM on-time; GET ORs the request with the actual status</source>
        <translation>Messung der Gegen-EMK während der Einschaltzeit der PWM; GET verknüpft Anforderung und tatsächlichen Zustand durch ODER</translation>
    </message>
    <message>
        <source>Use initial position detection at start</source>
        <translation>Beim Start die Anfangslage des Rotors bestimmen</translation>
    </message>
    <message>
        <source>IPD debug mode</source>
        <translation>Fehlersuche bei der Anfangslagebestimmung (IPD)</translation>
    </message>
    <message>
        <source>Proportional gain numerator of the speed regulator; effective gain = value / 2^SPEED_KP_DIV</source>
        <translation>Zähler der Proportionalverstärkung des Drehzahlreglers; wirksame Verstärkung = Wert / 2^SPEED_KP_DIV</translation>
    </message>
    <message>
        <source>Integral gain numerator of the speed regulator; effective gain = value / 2^SPEED_KI_DIV</source>
        <translation>Zähler der Integralverstärkung des Drehzahlreglers; wirksame Verstärkung = Wert / 2^SPEED_KI_DIV</translation>
    </message>
    <message>
        <source>Derivative gain numerator of the speed regulator; effective gain = value / 2^SPEED_KD_DIV; stored but unused: the loop is PI</source>
        <translation>Zähler der Differentialverstärkung des Drehzahlreglers; wirksame Verstärkung = Wert / 2^SPEED_KD_DIV; gespeichert, aber ungenutzt: der Regler ist PI</translation>
    </message>
    <message>
        <source>Proportional gain numerator of the q current regulator; effective gain = value / 2^I_Q_KP_DIV</source>
        <translation>Zähler der Proportionalverstärkung des q-Stromreglers; wirksame Verstärkung = Wert / 2^I_Q_KP_DIV</translation>
    </message>
    <message>
        <source>Integral gain numerator of the q current regulator; effective gain = value / 2^I_Q_KI_DIV</source>
        <translation>Zähler der Integralverstärkung des q-Stromreglers; wirksame Verstärkung = Wert / 2^I_Q_KI_DIV</translation>
    </message>
    <message>
        <source>Derivative gain numerator of the q current regulator; effective gain = value / 2^I_Q_KD_DIV; stored but unused: the loop is PI</source>
        <translation>Zähler der Differentialverstärkung des q-Stromreglers; wirksame Verstärkung = Wert / 2^I_Q_KD_DIV; gespeichert, aber ungenutzt: der Regler ist PI</translation>
    </message>
    <message>
        <source>Proportional gain numerator of the d current regulator; effective gain = value / 2^I_D_KP_DIV</source>
        <translation>Zähler der Proportionalverstärkung des d-Stromreglers; wirksame Verstärkung = Wert / 2^I_D_KP_DIV</translation>
    </message>
    <message>
        <source>Integral gain numerator of the d current regulator; effective gain = value / 2^I_D_KI_DIV</source>
        <translation>Zähler der Integralverstärkung des d-Stromreglers; wirksame Verstärkung = Wert / 2^I_D_KI_DIV</translation>
    </message>
    <message>
        <source>Derivative gain numerator of the d current regulator; effective gain = value / 2^I_D_KD_DIV; stored but unused: the loop is PI</source>
        <translation>Zähler der Differentialverstärkung des d-Stromreglers; wirksame Verstärkung = Wert / 2^I_D_KD_DIV; gespeichert, aber ungenutzt: der Regler ist PI</translation>
    </message>
    <message>
        <source>State observer gain (STOPLL_C1)</source>
        <translation>Verstärkung des Zustandsbeobachters (STOPLL_C1)</translation>
    </message>
    <message>
        <source>State observer gain (STOPLL_C2)</source>
        <translation>Verstärkung des Zustandsbeobachters (STOPLL_C2)</translation>
    </message>
    <message>
        <source>State observer gain (STOCORDIC_C1)</source>
        <translation>Verstärkung des Zustandsbeobachters (STOCORDIC_C1)</translation>
    </message>
    <message>
        <source>State observer gain (STOCORDIC_C2)</source>
        <translation>Verstärkung des Zustandsbeobachters (STOCORDIC_C2)</translation>
    </message>
    <message>
        <source>PLL regulator gain numerator (STOPLL_KI)</source>
        <translation>Zähler der Verstärkung des PLL-Reglers (STOPLL_KI)</translation>
    </message>
    <message>
        <source>PLL regulator gain numerator (STOPLL_KP)</source>
        <translation>Zähler der Verstärkung des PLL-Reglers (STOPLL_KP)</translation>
    </message>
    <message>
        <source>Flux-weakening regulator gain numerator (FLUXWK_KP)</source>
        <translation>Zähler der Verstärkung des Feldschwächreglers (FLUXWK_KP)</translation>
    </message>
    <message>
        <source>Flux-weakening regulator gain numerator (FLUXWK_KI)</source>
        <translation>Zähler der Verstärkung des Feldschwächreglers (FLUXWK_KI)</translation>
    </message>
    <message>
        <source>Voltage level at which flux weakening acts</source>
        <translation>Spannungspegel, ab dem die Feldschwächung wirkt</translation>
    </message>
    <message>
        <source>Averaged DC bus voltage; a virtual sensor returns the configured value</source>
        <translation>Gemittelte Zwischenkreisspannung; ein virtueller Sensor liefert den eingestellten Wert</translation>
    </message>
    <message>
        <source>Averaged power-stage temperature</source>
        <translation>Gemittelte Temperatur des Leistungsteils</translation>
    </message>
    <message>
        <source>Id of the HF register shown on this DAC channel</source>
        <translation>Id des HF-Registers, das dieser DAC-Kanal zeigt</translation>
    </message>
    <message>
        <source>Defined but no handler in any version seen: UNKNOWN_REG</source>
        <translation>Definiert, aber in keiner bekannten Version behandelt: UNKNOWN_REG</translation>
    </message>
    <message>
        <source>Measured average voltage level</source>
        <translation>Gemessener mittlerer Spannungspegel</translation>
    </message>
    <message>
        <source>Measured phase current (I_A)</source>
        <translation>Gemessener Strangstrom (I_A)</translation>
    </message>
    <message>
        <source>Measured phase current (I_B)</source>
        <translation>Gemessener Strangstrom (I_B)</translation>
    </message>
    <message>
        <source>Stationary-frame current (I_ALPHA_MEAS)</source>
        <translation>Strom im statorfesten System (I_ALPHA_MEAS)</translation>
    </message>
    <message>
        <source>Stationary-frame current (I_BETA_MEAS)</source>
        <translation>Strom im statorfesten System (I_BETA_MEAS)</translation>
    </message>
    <message>
        <source>Measured rotor-frame current (I_Q_MEAS)</source>
        <translation>Gemessener Strom im rotorfesten System (I_Q_MEAS)</translation>
    </message>
    <message>
        <source>Measured rotor-frame current (I_D_MEAS)</source>
        <translation>Gemessener Strom im rotorfesten System (I_D_MEAS)</translation>
    </message>
    <message>
        <source>Rotor-frame current reference (I_Q_REF); SET applies both components at once with the other one kept</source>
        <translation>Stromsollwert im rotorfesten System (I_Q_REF); SET übernimmt beide Komponenten zugleich, die andere bleibt erhalten</translation>
    </message>
    <message>
        <source>Rotor-frame current reference (I_D_REF); SET applies both components at once with the other one kept</source>
        <translation>Stromsollwert im rotorfesten System (I_D_REF); SET übernimmt beide Komponenten zugleich, die andere bleibt erhalten</translation>
    </message>
    <message>
        <source>Rotor-frame voltage command (V_Q)</source>
        <translation>Spannungsvorgabe im rotorfesten System (V_Q)</translation>
    </message>
    <message>
        <source>Rotor-frame voltage command (V_D)</source>
        <translation>Spannungsvorgabe im rotorfesten System (V_D)</translation>
    </message>
    <message>
        <source>Stationary-frame voltage command (V_ALPHA)</source>
        <translation>Spannungsvorgabe im statorfesten System (V_ALPHA)</translation>
    </message>
    <message>
        <source>Stationary-frame voltage command (V_BETA)</source>
        <translation>Spannungsvorgabe im statorfesten System (V_BETA)</translation>
    </message>
    <message>
        <source>Encoder electrical angle</source>
        <translation>Elektrischer Winkel des Encoders</translation>
    </message>
    <message>
        <source>Encoder averaged mechanical speed</source>
        <translation>Gemittelte mechanische Drehzahl des Encoders</translation>
    </message>
    <message>
        <source>Estimated electrical angle</source>
        <translation>Geschätzter elektrischer Winkel</translation>
    </message>
    <message>
        <source>Estimated averaged mechanical speed</source>
        <translation>Geschätzte gemittelte mechanische Drehzahl</translation>
    </message>
    <message>
        <source>Observer estimated current (STOPLL_I_ALPHA)</source>
        <translation>Vom Beobachter geschätzter Strom (STOPLL_I_ALPHA)</translation>
    </message>
    <message>
        <source>Observer estimated current (STOPLL_I_BETA)</source>
        <translation>Vom Beobachter geschätzter Strom (STOPLL_I_BETA)</translation>
    </message>
    <message>
        <source>Observer estimated back-emf (STOPLL_BEMF_ALPHA)</source>
        <translation>Vom Beobachter geschätzte Gegen-EMK (STOPLL_BEMF_ALPHA)</translation>
    </message>
    <message>
        <source>Observer estimated back-emf (STOPLL_BEMF_BETA)</source>
        <translation>Vom Beobachter geschätzte Gegen-EMK (STOPLL_BEMF_BETA)</translation>
    </message>
    <message>
        <source>Observer estimated current (STOCORDIC_I_ALPHA)</source>
        <translation>Vom Beobachter geschätzter Strom (STOCORDIC_I_ALPHA)</translation>
    </message>
    <message>
        <source>Observer estimated current (STOCORDIC_I_BETA)</source>
        <translation>Vom Beobachter geschätzter Strom (STOCORDIC_I_BETA)</translation>
    </message>
    <message>
        <source>Observer estimated back-emf (STOCORDIC_BEMF_ALPHA)</source>
        <translation>Vom Beobachter geschätzte Gegen-EMK (STOCORDIC_BEMF_ALPHA)</translation>
    </message>
    <message>
        <source>Observer estimated back-emf (STOCORDIC_BEMF_BETA)</source>
        <translation>Vom Beobachter geschätzte Gegen-EMK (STOCORDIC_BEMF_BETA)</translation>
    </message>
    <message>
        <source>Placeholder for user DAC variables; SET/GET answer OK and carry no data</source>
        <translation>Platzhalter für eigene DAC-Größen; SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>Hall electrical angle</source>
        <translation>Elektrischer Winkel der Hallsensoren</translation>
    </message>
    <message>
        <source>Hall averaged mechanical speed</source>
        <translation>Gemittelte mechanische Drehzahl der Hallsensoren</translation>
    </message>
    <message>
        <source>Feed-forward voltage (FF_VQ)</source>
        <translation>Spannung der Vorsteuerung (FF_VQ)</translation>
    </message>
    <message>
        <source>Feed-forward voltage (FF_VD)</source>
        <translation>Spannung der Vorsteuerung (FF_VD)</translation>
    </message>
    <message>
        <source>Averaged current-regulator output without feed-forward (FF_VQ_PIOUT)</source>
        <translation>Gemittelter Ausgang des Stromreglers ohne Vorsteuerung (FF_VQ_PIOUT)</translation>
    </message>
    <message>
        <source>Averaged current-regulator output without feed-forward (FF_VD_PIOUT)</source>
        <translation>Gemittelter Ausgang des Stromreglers ohne Vorsteuerung (FF_VD_PIOUT)</translation>
    </message>
    <message>
        <source>PFC variable (PFC_DCBUS_REF); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_DCBUS_REF); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_DCBUS_MEAS); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_DCBUS_MEAS); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_ACBUS_FREQ); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_ACBUS_FREQ); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_ACBUS_RMS); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_ACBUS_RMS); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_I_KP); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_I_KP); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_I_KI); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_I_KI); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_I_KD); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_I_KD); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_V_KP); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_V_KP); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_V_KI); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_V_KI); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_V_KD); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_V_KD); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_STARTUP_DURATION); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_STARTUP_DURATION); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PWM frequency used by the profiler</source>
        <translation>PWM-Frequenz, die der Profiler benutzt</translation>
    </message>
    <message>
        <source>Proportional gain numerator of the position regulator</source>
        <translation>Zähler der Proportionalverstärkung des Positionsreglers</translation>
    </message>
    <message>
        <source>Integral gain numerator of the position regulator</source>
        <translation>Zähler der Integralverstärkung des Positionsreglers</translation>
    </message>
    <message>
        <source>Derivative gain numerator of the position regulator</source>
        <translation>Zähler der Differentialverstärkung des Positionsreglers</translation>
    </message>
    <message>
        <source>Divisor exponent of SPEED_KP</source>
        <translation>Exponent des Teilers von SPEED_KP</translation>
    </message>
    <message>
        <source>Divisor exponent of SPEED_KI; SET also rescales the integral limits</source>
        <translation>Exponent des Teilers von SPEED_KI; SET skaliert auch die Grenzen des Integrators um</translation>
    </message>
    <message>
        <source>Divisor exponent of SPEED_KD; unused: the loop is PI</source>
        <translation>Exponent des Teilers von SPEED_KD; ungenutzt: der Regler ist PI</translation>
    </message>
    <message>
        <source>Divisor exponent of I_D_KP</source>
        <translation>Exponent des Teilers von I_D_KP</translation>
    </message>
    <message>
        <source>Divisor exponent of I_D_KI; SET also rescales the integral limits</source>
        <translation>Exponent des Teilers von I_D_KI; SET skaliert auch die Grenzen des Integrators um</translation>
    </message>
    <message>
        <source>Divisor exponent of I_D_KD; unused: the loop is PI</source>
        <translation>Exponent des Teilers von I_D_KD; ungenutzt: der Regler ist PI</translation>
    </message>
    <message>
        <source>Divisor exponent of I_Q_KP</source>
        <translation>Exponent des Teilers von I_Q_KP</translation>
    </message>
    <message>
        <source>Divisor exponent of I_Q_KI; SET also rescales the integral limits</source>
        <translation>Exponent des Teilers von I_Q_KI; SET skaliert auch die Grenzen des Integrators um</translation>
    </message>
    <message>
        <source>Divisor exponent of I_Q_KD; unused: the loop is PI</source>
        <translation>Exponent des Teilers von I_Q_KD; ungenutzt: der Regler ist PI</translation>
    </message>
    <message>
        <source>Divisor exponent of POSITION_KP</source>
        <translation>Exponent des Teilers von POSITION_KP</translation>
    </message>
    <message>
        <source>Divisor exponent of POSITION_KI; SET also rescales the integral limits</source>
        <translation>Exponent des Teilers von POSITION_KI; SET skaliert auch die Grenzen des Integrators um</translation>
    </message>
    <message>
        <source>Divisor exponent of POSITION_KD</source>
        <translation>Exponent des Teilers von POSITION_KD</translation>
    </message>
    <message>
        <source>PFC variable (PFC_I_KP_DIV); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_I_KP_DIV); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_I_KI_DIV); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_I_KI_DIV); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_I_KD_DIV); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_I_KD_DIV); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_V_KP_DIV); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_V_KP_DIV); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_V_KI_DIV); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_V_KI_DIV); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PFC variable (PFC_V_KD_DIV); SET/GET answer OK and carry no data</source>
        <translation>PFC-Größe (PFC_V_KD_DIV); SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>PLL regulator gain divisor exponent (STOPLL_KI_DIV)</source>
        <translation>Exponent des Teilers der Verstärkung des PLL-Reglers (STOPLL_KI_DIV)</translation>
    </message>
    <message>
        <source>PLL regulator gain divisor exponent (STOPLL_KP_DIV)</source>
        <translation>Exponent des Teilers der Verstärkung des PLL-Reglers (STOPLL_KP_DIV)</translation>
    </message>
    <message>
        <source>Flux-weakening regulator gain divisor exponent (FLUXWK_KP_DIV)</source>
        <translation>Exponent des Teilers der Verstärkung des Feldschwächreglers (FLUXWK_KP_DIV)</translation>
    </message>
    <message>
        <source>Flux-weakening regulator gain divisor exponent (FLUXWK_KI_DIV)</source>
        <translation>Exponent des Teilers der Verstärkung des Feldschwächreglers (FLUXWK_KI_DIV)</translation>
    </message>
    <message>
        <source>Open-loop voltage reference (was FOC_VDREF in 6.0/6.1)</source>
        <translation>Spannungssollwert im gesteuerten Betrieb (in 6.0/6.1 FOC_VDREF)</translation>
    </message>
    <message>
        <source>Current-mode factor of open loop; only 8 bits are kept. Id 108 was BEMF_ZCR up to 6.2</source>
        <translation>Faktor des gesteuerten Betriebs bei Stromvorgabe; nur 8 Bit bleiben erhalten. Id 108 war bis 6.2 BEMF_ZCR</translation>
    </message>
    <message>
        <source>Monitored bus current. Id 109 was BEMF_U up to 6.2</source>
        <translation>Überwachter Zwischenkreisstrom. Id 109 war bis 6.2 BEMF_U</translation>
    </message>
    <message>
        <source>Sampling point distance from the PWM edge. Id 110 was BEMF_V up to 6.2</source>
        <translation>Abstand des Abtastpunkts von der PWM-Flanke. Id 110 war bis 6.2 BEMF_V</translation>
    </message>
    <message>
        <source>Averaging depth; only 8 bits are kept. Id 111 was BEMF_W up to 6.2</source>
        <translation>Mittelungstiefe; nur 8 Bit bleiben erhalten. Id 111 war bis 6.2 BEMF_W</translation>
    </message>
    <message>
        <source>Bus protection threshold (OVERVOLTAGETHRESHOLD)</source>
        <translation>Schutzschwelle des Zwischenkreises (OVERVOLTAGETHRESHOLD)</translation>
    </message>
    <message>
        <source>Bus protection threshold (UNDERVOLTAGETHRESHOLD)</source>
        <translation>Schutzschwelle des Zwischenkreises (UNDERVOLTAGETHRESHOLD)</translation>
    </message>
    <message>
        <source>BEMF samples required before RUN; SET uses only the low byte</source>
        <translation>Für RUN nötige Messwerte der Gegen-EMK; SET benutzt nur das untere Byte</translation>
    </message>
    <message>
        <source>Angle of the virtual (open-loop) speed sensor; GET and SET answer UNKNOWN_REG</source>
        <translation>Winkel des virtuellen Drehzahlsensors (gesteuerter Betrieb); GET und SET antworten UNKNOWN_REG</translation>
    </message>
    <message>
        <source>Valid zero-speed steps required before RUN; SET uses only the low byte</source>
        <translation>Für RUN nötige gültige Schritte bei Drehzahl null; SET benutzt nur das untere Byte</translation>
    </message>
    <message>
        <source>Low half: past unacknowledged faults; high half: faults present now</source>
        <translation>Untere Hälfte: vergangene, nicht quittierte Fehler; obere Hälfte: jetzt anliegende Fehler</translation>
    </message>
    <message>
        <source>Average mechanical speed</source>
        <translation>Mittlere mechanische Drehzahl</translation>
    </message>
    <message>
        <source>Speed reference; SET is a zero-duration ramp and keeps only 16 bits (+-32767 rpm, resolution 6 rpm)</source>
        <translation>Drehzahlsollwert; SET ist eine Rampe ohne Dauer und behält nur 16 Bit (+-32767 rpm, Auflösung 6 rpm)</translation>
    </message>
    <message>
        <source>Back-emf level for tuning the observer (STOPLL_EST_BEMF)</source>
        <translation>Pegel der Gegen-EMK zum Einstellen des Beobachters (STOPLL_EST_BEMF)</translation>
    </message>
    <message>
        <source>Back-emf level for tuning the observer (STOPLL_OBS_BEMF)</source>
        <translation>Pegel der Gegen-EMK zum Einstellen des Beobachters (STOPLL_OBS_BEMF)</translation>
    </message>
    <message>
        <source>Back-emf level for tuning the observer (STOCORDIC_EST_BEMF)</source>
        <translation>Pegel der Gegen-EMK zum Einstellen des Beobachters (STOCORDIC_EST_BEMF)</translation>
    </message>
    <message>
        <source>Back-emf level for tuning the observer (STOCORDIC_OBS_BEMF)</source>
        <translation>Pegel der Gegen-EMK zum Einstellen des Beobachters (STOCORDIC_OBS_BEMF)</translation>
    </message>
    <message>
        <source>Feed-forward constant (FF_1Q)</source>
        <translation>Konstante der Vorsteuerung (FF_1Q)</translation>
    </message>
    <message>
        <source>Feed-forward constant (FF_1D)</source>
        <translation>Konstante der Vorsteuerung (FF_1D)</translation>
    </message>
    <message>
        <source>Feed-forward constant (FF_2)</source>
        <translation>Konstante der Vorsteuerung (FF_2)</translation>
    </message>
    <message>
        <source>PFC fault bits; SET/GET answer OK and carry no data</source>
        <translation>Fehlerbits der PFC; SET/GET antworten OK und übertragen keine Daten</translation>
    </message>
    <message>
        <source>Current mechanical position</source>
        <translation>Jetzige mechanische Position</translation>
    </message>
    <message>
        <source>Motor-control CPU load (PERF_CPU_LOAD)</source>
        <translation>CPU-Last der Motorregelung (PERF_CPU_LOAD)</translation>
    </message>
    <message>
        <source>Motor-control CPU load (PERF_MIN_CPU_LOAD)</source>
        <translation>CPU-Last der Motorregelung (PERF_MIN_CPU_LOAD)</translation>
    </message>
    <message>
        <source>Motor-control CPU load (PERF_MAX_CPU_LOAD)</source>
        <translation>CPU-Last der Motorregelung (PERF_MAX_CPU_LOAD)</translation>
    </message>
    <message>
        <source>Measured stator resistance</source>
        <translation>Gemessener Statorwiderstand</translation>
    </message>
    <message>
        <source>Measured stator inductance</source>
        <translation>Gemessene Statorinduktivität</translation>
    </message>
    <message>
        <source>Measured back-emf constant; the unit is the usual one of ST tools and is not stated by the firmware</source>
        <translation>Gemessene Spannungskonstante; die Einheit ist die in Werkzeugen von ST übliche, die Firmware nennt sie nicht</translation>
    </message>
    <message>
        <source>Bus voltage measured by the profiler</source>
        <translation>Vom Profiler gemessene Zwischenkreisspannung</translation>
    </message>
    <message>
        <source>Nominal speed estimated by the profiler</source>
        <translation>Vom Profiler geschätzte Nenndrehzahl</translation>
    </message>
    <message>
        <source>Nominal current for the procedure; SET accepted only while idle or after calibration, else RO_REG</source>
        <translation>Nennstrom für den Vorgang; SET nur in Ruhe oder nach dem Abgleich, sonst RO_REG</translation>
    </message>
    <message>
        <source>Target speed-loop bandwidth</source>
        <translation>Angestrebte Bandbreite des Drehzahlreglers</translation>
    </message>
    <message>
        <source>Ld/Lq ratio</source>
        <translation>Verhältnis Ld/Lq</translation>
    </message>
    <message>
        <source>Nominal speed given to the profiler</source>
        <translation>Dem Profiler vorgegebene Nenndrehzahl</translation>
    </message>
    <message>
        <source>Target current-loop bandwidth</source>
        <translation>Angestrebte Bandbreite des Stromreglers</translation>
    </message>
    <message>
        <source>Estimated inertia</source>
        <translation>Geschätzte Trägheit</translation>
    </message>
    <message>
        <source>Estimated viscous friction</source>
        <translation>Geschätzte viskose Reibung</translation>
    </message>
    <message>
        <source>Start-up current used by the profiler</source>
        <translation>Anlaufstrom, den der Profiler benutzt</translation>
    </message>
    <message>
        <source>Estimated maximum open-loop speed</source>
        <translation>Geschätzte höchste Drehzahl im gesteuerten Betrieb</translation>
    </message>
    <message>
        <source>Estimated maximum acceleration</source>
        <translation>Geschätzte größte Beschleunigung</translation>
    </message>
    <message>
        <source>Power-board resistance offset</source>
        <translation>Widerstandsoffset des Leistungsteils</translation>
    </message>
    <message>
        <source>Average electrical motor power; a SET is answered UNKNOWN_REG (firmware lists it in the wrong switch)</source>
        <translation>Mittlere elektrische Motorleistung; ein SET wird mit UNKNOWN_REG beantwortet (die Firmware führt es an der falschen Stelle)</translation>
    </message>
    <message>
        <source>Firmware name</source>
        <translation>Name der Firmware</translation>
    </message>
    <message>
        <source>Control board name</source>
        <translation>Name der Steuerplatine</translation>
    </message>
    <message>
        <source>Power board name</source>
        <translation>Name der Leistungsplatine</translation>
    </message>
    <message>
        <source>Motor name</source>
        <translation>Name des Motors</translation>
    </message>
    <message>
        <source>Version, motor count, transports and stream counts; 10 bytes</source>
        <translation>Version, Anzahl der Motoren, Übertragungswege und Anzahl der Datenströme; 10 Byte</translation>
    </message>
    <message>
        <source>Motor parameters; 60 bytes</source>
        <translation>Motorparameter; 60 Byte</translation>
    </message>
    <message>
        <source>Operating limits and drive type; 16 bytes; 14 up to 6.1</source>
        <translation>Betriebsgrenzen und Antriebsart; 16 Byte; 14 bis 6.1</translation>
    </message>
    <message>
        <source>Firmware drive configuration; 14 bytes FOC/ACIM; six-step 10/11/13</source>
        <translation>Antriebskonfiguration der Firmware; 14 Byte bei FOC/ACIM; Blockkommutierung 10/11/13</translation>
    </message>
    <message>
        <source>Digit-to-unit factors for voltage, current, frequency; no SET case: UNKNOWN_REG; 12 bytes</source>
        <translation>Faktoren von Digits zu Einheiten für Spannung, Strom, Frequenz; kein SET: UNKNOWN_REG; 12 Byte</translation>
    </message>
    <message>
        <source>s32 rpm + u16 ms; SET starts a ramp, GET returns the last one; 6 bytes</source>
        <translation>s32 rpm + u16 ms; SET startet eine Rampe, GET liefert die letzte; 6 Byte</translation>
    </message>
    <message>
        <source>SET s32 s16A + u16 ms; GET s16 s16A + u16 ms; SET 6 bytes; GET 4 bytes</source>
        <translation>SET s32 s16A + u16 ms; GET s16 s16A + u16 ms; SET 6 Byte; GET 4 Byte</translation>
    </message>
    <message>
        <source>Rev-up stages: s32 rpm; u16 final torque (s16A) or pulse; u16 ms; n x 8 bytes; n &lt;= 5</source>
        <translation>Anlaufstufen: s32 rpm; u16 Endmoment (s16A) oder Puls; u16 ms; n x 8 Byte; n &lt;= 5</translation>
    </message>
    <message>
        <source>s16 Iq + s16 Id in s16A; 4 bytes</source>
        <translation>s16 Iq + s16 Id in s16A; 4 Byte</translation>
    </message>
    <message>
        <source>f32 target position rad + f32 duration s; GET swaps the two fields in 6.1/6.2; 8 bytes</source>
        <translation>f32 Zielposition rad + f32 Dauer s; GET vertauscht die beiden Felder in 6.1/6.2; 8 Byte</translation>
    </message>
    <message>
        <source>Datalog configuration (ASYNC_UARTA); GET is answered UNKNOWN_REG; 7+2n bytes</source>
        <translation>Konfiguration der Datenaufzeichnung (ASYNC_UARTA); GET wird mit UNKNOWN_REG beantwortet; 7+2n Byte</translation>
    </message>
    <message>
        <source>Datalog configuration (ASYNC_UARTB); GET is answered UNKNOWN_REG; 7+2n bytes</source>
        <translation>Konfiguration der Datenaufzeichnung (ASYNC_UARTB); GET wird mit UNKNOWN_REG beantwortet; 7+2n Byte</translation>
    </message>
    <message>
        <source>Datalog configuration for the ST-LINK link; 7+2n bytes</source>
        <translation>Konfiguration der Datenaufzeichnung für die ST-LINK-Verbindung; 7+2n Byte</translation>
    </message>
    <message>
        <source>New Hall input order: 3 u8 + pad; 4 bytes</source>
        <translation>Neue Reihenfolge der Hall-Eingänge: 3 u8 + Füllbyte; 4 Byte</translation>
    </message>
    <message>
        <source>Connected Hall inputs: 3 u8 + pad; 4 bytes</source>
        <translation>Angeschlossene Hall-Eingänge: 3 u8 + Füllbyte; 4 Byte</translation>
    </message>
    <message>
        <source>14 s16 Hall phase-shift values; 28 bytes</source>
        <translation>14 s16 Phasenverschiebungen der Hallsensoren; 28 Byte</translation>
    </message>
    <message>
        <source>13 u16 sensing and demagnetisation parameters; 26 bytes</source>
        <translation>13 u16 Parameter der Messung und Entmagnetisierung; 26 Byte</translation>
    </message>
    <message>
        <source>Fast demagnetisation; this id is LOWSIDE_MODULATION from 6.3 on. Shown read-only: its writing side was not read</source>
        <translation>Schnelle Entmagnetisierung; diese Id ist ab 6.3 LOWSIDE_MODULATION. Nur zum Lesen gezeigt: ihr Schreibpfad ist nicht untersucht</translation>
    </message>
    <message>
        <source>Commutation step buffer; this id is OPENLOOP_DC_FILTER from 6.4 on. Shown read-only: its writing side was not read</source>
        <translation>Puffer der Kommutierungsschritte; diese Id ist ab 6.4 OPENLOOP_DC_FILTER. Nur zum Lesen gezeigt: ihr Schreibpfad ist nicht untersucht</translation>
    </message>
    <message>
        <source>Pulse value; gone in 6.4.2. Shown read-only: its writing side was not read</source>
        <translation>Pulswert; entfallen in 6.4.2. Nur zum Lesen gezeigt: sein Schreibpfad ist nicht untersucht</translation>
    </message>
    <message>
        <source>Open-loop voltage reference; this id is FOC_VQREF from 6.2 on. Shown read-only: its writing side was not read</source>
        <translation>Spannungssollwert im gesteuerten Betrieb; diese Id ist ab 6.2 FOC_VQREF. Nur zum Lesen gezeigt: ihr Schreibpfad ist nicht untersucht</translation>
    </message>
    <message>
        <source>Back-emf zero crossing; this id is OPENLOOP_CURRFACTOR from 6.3 on</source>
        <translation>Nulldurchgang der Gegen-EMK; diese Id ist ab 6.3 OPENLOOP_CURRFACTOR</translation>
    </message>
    <message>
        <source>Back-emf of phase U; this id is CURR_MONITOR from 6.4 on</source>
        <translation>Gegen-EMK der Phase U; diese Id ist ab 6.4 CURR_MONITOR</translation>
    </message>
    <message>
        <source>Back-emf of phase V; this id is CURR_MONITOR_SAMPL_NS from 6.4 on</source>
        <translation>Gegen-EMK der Phase V; diese Id ist ab 6.4 CURR_MONITOR_SAMPL_NS</translation>
    </message>
    <message>
        <source>Back-emf of phase W; this id is CURR_MONITOR_AVG from 6.4 on</source>
        <translation>Gegen-EMK der Phase W; diese Id ist ab 6.4 CURR_MONITOR_AVG</translation>
    </message>
    <message>
        <source>Sensing parameters; this id is BEMF_ADC_CONF from 6.3 on</source>
        <translation>Messparameter; diese Id ist ab 6.3 BEMF_ADC_CONF</translation>
    </message>
    <message>
        <source>Sensing parameters while the PWM is on; gone in 6.3</source>
        <translation>Messparameter bei eingeschalteter PWM; entfallen in 6.3</translation>
    </message>
    <message>
        <source>Motor state; 30 = DC resistance estimation in addition to the common codes</source>
        <translation>Motorzustand; 30 = Schätzung des Gleichstromwiderstands, zusätzlich zu den üblichen Nummern</translation>
    </message>
    <message>
        <source>Control mode (same enum as CONTROL_MODE)</source>
        <translation>Regelungsart (dieselbe Aufzählung wie CONTROL_MODE)</translation>
    </message>
    <message>
        <source>Control mode as used by the core; SET is UNKNOWN_REG</source>
        <translation>Regelungsart, wie sie der Kern benutzt; SET ist UNKNOWN_REG</translation>
    </message>
    <message>
        <source>0 sine 1 centred 2 shifted centre 3 min-low 4 max-high 5 up-down; out-of-range SET becomes 0; 0..5</source>
        <translation>0 Sinus 1 zentriert 2 verschobene Mitte 3 min-low 4 max-high 5 auf-ab; SET außerhalb des Bereichs wird 0; 0..5</translation>
    </message>
    <message>
        <source>Defined but no handler</source>
        <translation>Definiert, aber nicht behandelt</translation>
    </message>
    <message>
        <source>0 speed reference from the protocol 1 from the potentiometer; 0..1</source>
        <translation>0 Drehzahlsollwert vom Protokoll 1 vom Potentiometer; 0..1</translation>
    </message>
    <message>
        <source>0 no resistance update 1 automatic (ZeST); 0..1</source>
        <translation>0 Widerstand wird nicht nachgeführt 1 automatisch (ZeST); 0..1</translation>
    </message>
    <message>
        <source>Oversampling sample used as single sample</source>
        <translation>Abtastwert der Überabtastung, der als Einzelwert dient</translation>
    </message>
    <message>
        <source>Current reconstruction enable</source>
        <translation>Rekonstruktion der Ströme einschalten</translation>
    </message>
    <message>
        <source>Profiler command; GET answers WO_REG; 0 none 1 start 2 reset</source>
        <translation>Befehl an den Profiler; GET antwortet WO_REG; 0 keiner 1 starten 2 zurücksetzen</translation>
    </message>
    <message>
        <source>Profiler state; 0..6</source>
        <translation>Zustand des Profilers; 0..6</translation>
    </message>
    <message>
        <source>Current reconstruction limit (motor 1 only)</source>
        <translation>Grenze der Rekonstruktion der Ströme (nur Motor 1)</translation>
    </message>
    <message>
        <source>bit0 DC resistance estimate, bit1 dynamic ZeST configuration, bit2 offset measurement, bit3 pole pulses, bit4 fast DC resistance</source>
        <translation>Bit 0 Schätzung des Gleichstromwiderstands, Bit 1 dynamische ZeST-Konfiguration, Bit 2 Offsetmessung, Bit 3 Polimpulse, Bit 4 schneller Gleichstromwiderstand</translation>
    </message>
    <message>
        <source>Id shown on DAC channel 1</source>
        <translation>Id, die DAC-Kanal 1 zeigt</translation>
    </message>
    <message>
        <source>Id shown on DAC channel 2</source>
        <translation>Id, die DAC-Kanal 2 zeigt</translation>
    </message>
    <message>
        <source>Pole pulse length</source>
        <translation>Länge des Polimpulses</translation>
    </message>
    <message>
        <source>Pole pulse decay length</source>
        <translation>Abklingdauer des Polimpulses</translation>
    </message>
    <message>
        <source>Power-stage temperature</source>
        <translation>Temperatur des Leistungsteils</translation>
    </message>
    <message>
        <source>Same layout as the standard family; a motor-scope SET answers OK and does nothing</source>
        <translation>Aufbau wie in der Standardfamilie; ein SET für einen Motor antwortet OK und bewirkt nichts</translation>
    </message>
    <message>
        <source>Phase current (ADC_I_U)</source>
        <translation>Strangstrom (ADC_I_U)</translation>
    </message>
    <message>
        <source>Phase current (ADC_I_V)</source>
        <translation>Strangstrom (ADC_I_V)</translation>
    </message>
    <message>
        <source>Phase current (ADC_I_W)</source>
        <translation>Strangstrom (ADC_I_W)</translation>
    </message>
    <message>
        <source>Phase voltage (ADC_U_U)</source>
        <translation>Strangspannung (ADC_U_U)</translation>
    </message>
    <message>
        <source>Phase voltage (ADC_U_V)</source>
        <translation>Strangspannung (ADC_U_V)</translation>
    </message>
    <message>
        <source>Phase voltage (ADC_U_W)</source>
        <translation>Strangspannung (ADC_U_W)</translation>
    </message>
    <message>
        <source>Stationary-frame current (I_ALPHA)</source>
        <translation>Strom im statorfesten System (I_ALPHA)</translation>
    </message>
    <message>
        <source>Stationary-frame current (I_BETA)</source>
        <translation>Strom im statorfesten System (I_BETA)</translation>
    </message>
    <message>
        <source>Stationary-frame voltage (U_ALPHA)</source>
        <translation>Spannung im statorfesten System (U_ALPHA)</translation>
    </message>
    <message>
        <source>Stationary-frame voltage (U_BETA)</source>
        <translation>Spannung im statorfesten System (U_BETA)</translation>
    </message>
    <message>
        <source>Rotor-frame current (I_D)</source>
        <translation>Strom im rotorfesten System (I_D)</translation>
    </message>
    <message>
        <source>Rotor-frame current (I_Q)</source>
        <translation>Strom im rotorfesten System (I_Q)</translation>
    </message>
    <message>
        <source>Rotor-frame voltage (U_D)</source>
        <translation>Spannung im rotorfesten System (U_D)</translation>
    </message>
    <message>
        <source>Rotor-frame voltage (U_Q)</source>
        <translation>Spannung im rotorfesten System (U_Q)</translation>
    </message>
    <message>
        <source>Unreconstructed phase current (ADC_I_RAW_U)</source>
        <translation>Nicht rekonstruierter Strangstrom (ADC_I_RAW_U)</translation>
    </message>
    <message>
        <source>Unreconstructed phase current (ADC_I_RAW_V)</source>
        <translation>Nicht rekonstruierter Strangstrom (ADC_I_RAW_V)</translation>
    </message>
    <message>
        <source>Unreconstructed phase current (ADC_I_RAW_W)</source>
        <translation>Nicht rekonstruierter Strangstrom (ADC_I_RAW_W)</translation>
    </message>
    <message>
        <source>Observer electrical frequency</source>
        <translation>Elektrische Frequenz des Beobachters</translation>
    </message>
    <message>
        <source>Observer flux (HSO_FLUX_A)</source>
        <translation>Fluss des Beobachters (HSO_FLUX_A)</translation>
    </message>
    <message>
        <source>Observer flux (HSO_FLUX_B)</source>
        <translation>Fluss des Beobachters (HSO_FLUX_B)</translation>
    </message>
    <message>
        <source>DC bus voltage</source>
        <translation>Zwischenkreisspannung</translation>
    </message>
    <message>
        <source>Calibrated offset (ADC_I_U_OFFSET); stale bytes when no calibration is available</source>
        <translation>Abgeglichener Offset (ADC_I_U_OFFSET); veraltete Bytes, wenn es keinen Abgleich gibt</translation>
    </message>
    <message>
        <source>Calibrated offset (ADC_I_V_OFFSET); stale bytes when no calibration is available</source>
        <translation>Abgeglichener Offset (ADC_I_V_OFFSET); veraltete Bytes, wenn es keinen Abgleich gibt</translation>
    </message>
    <message>
        <source>Calibrated offset (ADC_I_W_OFFSET); stale bytes when no calibration is available</source>
        <translation>Abgeglichener Offset (ADC_I_W_OFFSET); veraltete Bytes, wenn es keinen Abgleich gibt</translation>
    </message>
    <message>
        <source>Calibrated offset (ADC_U_U_OFFSET); stale bytes when no calibration is available</source>
        <translation>Abgeglichener Offset (ADC_U_U_OFFSET); veraltete Bytes, wenn es keinen Abgleich gibt</translation>
    </message>
    <message>
        <source>Calibrated offset (ADC_U_V_OFFSET); stale bytes when no calibration is available</source>
        <translation>Abgeglichener Offset (ADC_U_V_OFFSET); veraltete Bytes, wenn es keinen Abgleich gibt</translation>
    </message>
    <message>
        <source>Calibrated offset (ADC_U_W_OFFSET); stale bytes when no calibration is available</source>
        <translation>Abgeglichener Offset (ADC_U_W_OFFSET); veraltete Bytes, wenn es keinen Abgleich gibt</translation>
    </message>
    <message>
        <source>Open-loop angle</source>
        <translation>Winkel im gesteuerten Betrieb</translation>
    </message>
    <message>
        <source>Mechanical speed; SET is UNKNOWN_REG</source>
        <translation>Mechanische Drehzahl; SET ist UNKNOWN_REG</translation>
    </message>
    <message>
        <source>Open-loop d-axis duty reference</source>
        <translation>Tastgrad-Sollwert der d-Achse im gesteuerten Betrieb</translation>
    </message>
    <message>
        <source>Torque reference</source>
        <translation>Drehmomentsollwert</translation>
    </message>
    <message>
        <source>Throttle input (THROTTLE_ADC)</source>
        <translation>Fahrhebel-Eingang (THROTTLE_ADC)</translation>
    </message>
    <message>
        <source>Throttle input (THROTTLE_POS)</source>
        <translation>Fahrhebel-Eingang (THROTTLE_POS)</translation>
    </message>
    <message>
        <source>Deprecated alias of FOC_RS_ACTIVE</source>
        <translation>Veralteter Name von FOC_RS_ACTIVE</translation>
    </message>
    <message>
        <source>Deprecated alias of FOC_LS_ACTIVE</source>
        <translation>Veralteter Name von FOC_LS_ACTIVE</translation>
    </message>
    <message>
        <source>Regulator gain (FOC_KP_IDQ)</source>
        <translation>Verstärkung des Reglers (FOC_KP_IDQ)</translation>
    </message>
    <message>
        <source>Regulator gain (FOC_WI_IDQ)</source>
        <translation>Verstärkung des Reglers (FOC_WI_IDQ)</translation>
    </message>
    <message>
        <source>Regulator gain (FOC_KP_SPD)</source>
        <translation>Verstärkung des Reglers (FOC_KP_SPD)</translation>
    </message>
    <message>
        <source>Regulator gain (FOC_KI_SPD)</source>
        <translation>Verstärkung des Reglers (FOC_KI_SPD)</translation>
    </message>
    <message>
        <source>Speed reference</source>
        <translation>Drehzahlsollwert</translation>
    </message>
    <message>
        <source>Ramped speed reference</source>
        <translation>Drehzahlsollwert hinter der Rampe</translation>
    </message>
    <message>
        <source>Speed ramp rate</source>
        <translation>Steilheit der Drehzahlrampe</translation>
    </message>
    <message>
        <source>Not implemented</source>
        <translation>Nicht umgesetzt</translation>
    </message>
    <message>
        <source>Torque estimate; SET is UNKNOWN_REG</source>
        <translation>Geschätztes Drehmoment; SET ist UNKNOWN_REG</translation>
    </message>
    <message>
        <source>Average electrical frequency</source>
        <translation>Mittlere elektrische Frequenz</translation>
    </message>
    <message>
        <source>ZeST injected current</source>
        <translation>Von ZeST eingeprägter Strom</translation>
    </message>
    <message>
        <source>Deprecated active resistance</source>
        <translation>Wirksamer Widerstand, veraltet</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>Stromgrenze</translation>
    </message>
    <message>
        <source>Deprecated active inductance</source>
        <translation>Wirksame Induktivität, veraltet</translation>
    </message>
    <message>
        <source>Rated flux</source>
        <translation>Nennfluss</translation>
    </message>
    <message>
        <source>Active flux; SET is UNKNOWN_REG</source>
        <translation>Wirksamer Fluss; SET ist UNKNOWN_REG</translation>
    </message>
    <message>
        <source>ZeST injection frequency</source>
        <translation>Einprägefrequenz von ZeST</translation>
    </message>
    <message>
        <source>ZeST feedback gain (FOC_GAIN_D)</source>
        <translation>Rückführverstärkung von ZeST (FOC_GAIN_D)</translation>
    </message>
    <message>
        <source>ZeST feedback gain (FOC_GAIN_Q)</source>
        <translation>Rückführverstärkung von ZeST (FOC_GAIN_Q)</translation>
    </message>
    <message>
        <source>Filtered duty (FOC_DUTYCYCLE_D); SET is UNKNOWN_REG</source>
        <translation>Gefilterter Tastgrad (FOC_DUTYCYCLE_D); SET ist UNKNOWN_REG</translation>
    </message>
    <message>
        <source>Filtered duty (FOC_DUTYCYCLE_Q); SET is UNKNOWN_REG</source>
        <translation>Gefilterter Tastgrad (FOC_DUTYCYCLE_Q); SET ist UNKNOWN_REG</translation>
    </message>
    <message>
        <source>Park angle</source>
        <translation>Winkel der Park-Transformation</translation>
    </message>
    <message>
        <source>Rated resistance; SET also retunes the current regulator</source>
        <translation>Nennwiderstand; SET stellt auch den Stromregler neu ein</translation>
    </message>
    <message>
        <source>Active resistance</source>
        <translation>Wirksamer Widerstand</translation>
    </message>
    <message>
        <source>Rated inductance; SET also retunes the current regulator</source>
        <translation>Nenninduktivität; SET stellt auch den Stromregler neu ein</translation>
    </message>
    <message>
        <source>Active inductance</source>
        <translation>Wirksame Induktivität</translation>
    </message>
    <message>
        <source>Maximum modulation index</source>
        <translation>Größter Modulationsgrad</translation>
    </message>
    <message>
        <source>ZeST output (FOC_ZEST_OUTD)</source>
        <translation>Ausgang von ZeST (FOC_ZEST_OUTD)</translation>
    </message>
    <message>
        <source>ZeST output (FOC_ZEST_OUTQ)</source>
        <translation>Ausgang von ZeST (FOC_ZEST_OUTQ)</translation>
    </message>
    <message>
        <source>Angle compensation factor</source>
        <translation>Faktor der Winkelkompensation</translation>
    </message>
    <message>
        <source>q current reference from the speed loop; SET is UNKNOWN_REG</source>
        <translation>q-Stromsollwert vom Drehzahlregler; SET ist UNKNOWN_REG</translation>
    </message>
    <message>
        <source>Current reference (FOC_IDREF)</source>
        <translation>Stromsollwert (FOC_IDREF)</translation>
    </message>
    <message>
        <source>Current reference (FOC_IQREF)</source>
        <translation>Stromsollwert (FOC_IQREF)</translation>
    </message>
    <message>
        <source>Pole pairs</source>
        <translation>Polpaare</translation>
    </message>
    <message>
        <source>Profiled resistance (PROFILER_RS_DC)</source>
        <translation>Vom Profiler bestimmter Widerstand (PROFILER_RS_DC)</translation>
    </message>
    <message>
        <source>Profiled resistance (PROFILER_RS_AC)</source>
        <translation>Vom Profiler bestimmter Widerstand (PROFILER_RS_AC)</translation>
    </message>
    <message>
        <source>Profiled inductance</source>
        <translation>Vom Profiler bestimmte Induktivität</translation>
    </message>
    <message>
        <source>Profiled flux</source>
        <translation>Vom Profiler bestimmter Fluss</translation>
    </message>
    <message>
        <source>Power used while profiling</source>
        <translation>Leistung während der Vermessung</translation>
    </message>
    <message>
        <source>Frequency used for flux estimation</source>
        <translation>Frequenz für die Flussschätzung</translation>
    </message>
    <message>
        <source>Phase duty (FOC_DUTYCYCLE_R)</source>
        <translation>Tastgrad des Strangs (FOC_DUTYCYCLE_R)</translation>
    </message>
    <message>
        <source>Phase duty (FOC_DUTYCYCLE_S)</source>
        <translation>Tastgrad des Strangs (FOC_DUTYCYCLE_S)</translation>
    </message>
    <message>
        <source>Phase duty (FOC_DUTYCYCLE_T)</source>
        <translation>Tastgrad des Strangs (FOC_DUTYCYCLE_T)</translation>
    </message>
    <message>
        <source>Pole pulse current goal</source>
        <translation>Zielstrom des Polimpulses</translation>
    </message>
    <message>
        <source>Pole pulse duty</source>
        <translation>Tastgrad des Polimpulses</translation>
    </message>
    <message>
        <source>Angle found by the pole pulses</source>
        <translation>Winkel, den die Polimpulse ergaben</translation>
    </message>
    <message>
        <source>Sample delay factor</source>
        <translation>Faktor der Abtastverzögerung</translation>
    </message>
    <message>
        <source>Resistance estimate (RSEST_RSOHM); 0.0 without ZeST</source>
        <translation>Geschätzter Widerstand (RSEST_RSOHM); 0.0 ohne ZeST</translation>
    </message>
    <message>
        <source>Resistance estimate (RSEST_RSPOWEROHM); 0.0 without ZeST</source>
        <translation>Geschätzter Widerstand (RSEST_RSPOWEROHM); 0.0 ohne ZeST</translation>
    </message>
    <message>
        <source>Skin factor; without ZeST GET is 0.0 and SET is ignored</source>
        <translation>Faktor des Skineffekts; ohne ZeST liefert GET 0.0, und SET wird ignoriert</translation>
    </message>
    <message>
        <source>ZeST angle correction; 0 without ZeST</source>
        <translation>Winkelkorrektur von ZeST; 0 ohne ZeST</translation>
    </message>
    <message>
        <source>ZeST internal signal (ANG_SPEED)</source>
        <translation>Internes Signal von ZeST (ANG_SPEED)</translation>
    </message>
    <message>
        <source>ZeST internal signal (ZEST_CORR_LP)</source>
        <translation>Internes Signal von ZeST (ZEST_CORR_LP)</translation>
    </message>
    <message>
        <source>ZeST internal signal (DEMOD_EQDQRIP_D)</source>
        <translation>Internes Signal von ZeST (DEMOD_EQDQRIP_D)</translation>
    </message>
    <message>
        <source>ZeST internal signal (DEMOD_EQDQRIP_Q)</source>
        <translation>Internes Signal von ZeST (DEMOD_EQDQRIP_Q)</translation>
    </message>
    <message>
        <source>ZeST internal signal (ZEST_FRACTION)</source>
        <translation>Internes Signal von ZeST (ZEST_FRACTION)</translation>
    </message>
    <message>
        <source>Resistance seen by the algorithm (FOC_RS_TEMP_ALGO)</source>
        <translation>Widerstand, wie ihn der Algorithmus sieht (FOC_RS_TEMP_ALGO)</translation>
    </message>
    <message>
        <source>Resistance seen by the algorithm (FOC_RS_EST_ALGO)</source>
        <translation>Widerstand, wie ihn der Algorithmus sieht (FOC_RS_EST_ALGO)</translation>
    </message>
    <message>
        <source>ZeST revision</source>
        <translation>Revision von ZeST</translation>
    </message>
    <message>
        <source>ZeST library version</source>
        <translation>Version der ZeST-Bibliothek</translation>
    </message>
    <message>
        <source>Name (FW_NAME)</source>
        <translation>Name (FW_NAME)</translation>
    </message>
    <message>
        <source>Name (CTRL_STAGE_NAME)</source>
        <translation>Name (CTRL_STAGE_NAME)</translation>
    </message>
    <message>
        <source>Name (PWR_STAGE_NAME)</source>
        <translation>Name (PWR_STAGE_NAME)</translation>
    </message>
    <message>
        <source>Name (MOTOR_NAME)</source>
        <translation>Name (MOTOR_NAME)</translation>
    </message>
    <message>
        <source>As in the standard family; 10 bytes</source>
        <translation>Wie in der Standardfamilie; 10 Byte</translation>
    </message>
    <message>
        <source>As in the standard family; 60 bytes</source>
        <translation>Wie in der Standardfamilie; 60 Byte</translation>
    </message>
    <message>
        <source>As in the standard family; 16 bytes</source>
        <translation>Wie in der Standardfamilie; 16 Byte</translation>
    </message>
    <message>
        <source>As in the standard family; primary sensor 5 HSO or 6 ZeST; 14 bytes</source>
        <translation>Wie in der Standardfamilie; erster Sensor 5 HSO oder 6 ZeST; 14 Byte</translation>
    </message>
    <message>
        <source>Per-unit base voltage, current and frequency; 12 bytes</source>
        <translation>Bezugsgrößen (per unit) für Spannung, Strom und Frequenz; 12 Byte</translation>
    </message>
    <message>
        <source>6 x s32: three current offsets then three voltage offsets; status 0x0C when not calibrated; 24 bytes</source>
        <translation>6 x s32: drei Stromoffsets, dann drei Spannungsoffsets; Status 0x0C, wenn nicht abgeglichen; 24 Byte</translation>
    </message>
    <message>
        <source>Datalog configuration (ASYNC_UARTA); 7+2n bytes</source>
        <translation>Konfiguration der Datenaufzeichnung (ASYNC_UARTA); 7+2n Byte</translation>
    </message>
    <message>
        <source>Datalog configuration (ASYNC_UARTB); 7+2n bytes</source>
        <translation>Konfiguration der Datenaufzeichnung (ASYNC_UARTB); 7+2n Byte</translation>
    </message>
    <message>
        <source>Datalog configuration (ASYNC_STLNK); 7+2n bytes</source>
        <translation>Konfiguration der Datenaufzeichnung (ASYNC_STLNK); 7+2n Byte</translation>
    </message>
    <message>
        <source>Defined in the HSO header only; no handler: UNKNOWN_REG</source>
        <translation>Nur im HSO-Header definiert; nicht behandelt: UNKNOWN_REG</translation>
    </message>
    <message>
        <source>State of the motor</source>
        <translation>Zustand des Motors</translation>
    </message>
    <message>
        <source>Motor that frames without a motor number are for, counted from 0</source>
        <translation>Motor, dem Rahmen ohne Motornummer gelten, ab 0 gezählt</translation>
    </message>
    <message>
        <source>Faults: those present now in the upper half, those not acknowledged yet in the lower</source>
        <translation>Fehler: die jetzt anliegenden in der oberen Hälfte, die noch nicht quittierten in der unteren</translation>
    </message>
    <message>
        <source>What is controlled: torque (0) or speed (1)</source>
        <translation>Was geregelt wird: Drehmoment (0) oder Drehzahl (1)</translation>
    </message>
    <message>
        <source>Speed that the speed loop follows now, ramps included</source>
        <translation>Drehzahl, der der Drehzahlregler jetzt folgt, Rampen eingeschlossen</translation>
    </message>
    <message>
        <source>Reference of Iq in force; a write changes to torque control and waits until the motor runs</source>
        <translation>Geltender Sollwert von Iq; Schreiben wechselt zur Drehmomentregelung und wartet, bis der Motor läuft</translation>
    </message>
    <message>
        <source>Loop of Iq: proportional gain</source>
        <translation>Iq-Regler: Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Loop of Iq: integral gain</source>
        <translation>Iq-Regler: Integralverstärkung</translation>
    </message>
    <message>
        <source>Loop of Iq: derivative gain</source>
        <translation>Iq-Regler: Differentialverstärkung</translation>
    </message>
    <message>
        <source>Reference of Id in force; a write changes to torque control and waits until the motor runs</source>
        <translation>Geltender Sollwert von Id; Schreiben wechselt zur Drehmomentregelung und wartet, bis der Motor läuft</translation>
    </message>
    <message>
        <source>Loop of Id: proportional gain</source>
        <translation>Id-Regler: Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Loop of Id: integral gain</source>
        <translation>Id-Regler: Integralverstärkung</translation>
    </message>
    <message>
        <source>Loop of Id: derivative gain</source>
        <translation>Id-Regler: Differentialverstärkung</translation>
    </message>
    <message>
        <source>Observer: gain C1; written with 4 bytes of which the lower 2 count</source>
        <translation>Beobachter: Verstärkung C1; mit 4 Byte geschrieben, von denen die unteren 2 zählen</translation>
    </message>
    <message>
        <source>Observer: gain C2; written with 4 bytes of which the lower 2 count</source>
        <translation>Beobachter: Verstärkung C2; mit 4 Byte geschrieben, von denen die unteren 2 zählen</translation>
    </message>
    <message>
        <source>CORDIC observer: gain C1; firmware refuses writes</source>
        <translation>CORDIC-Beobachter: Verstärkung C1; die Firmware weist Schreiben ab</translation>
    </message>
    <message>
        <source>CORDIC observer: gain C2; firmware refuses writes</source>
        <translation>CORDIC-Beobachter: Verstärkung C2; die Firmware weist Schreiben ab</translation>
    </message>
    <message>
        <source>Observer&apos;s PLL: integral gain</source>
        <translation>PLL des Beobachters: Integralverstärkung</translation>
    </message>
    <message>
        <source>Observer&apos;s PLL: proportional gain</source>
        <translation>PLL des Beobachters: Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Flux weakening: proportional gain</source>
        <translation>Feldschwächung: Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Flux weakening: integral gain</source>
        <translation>Feldschwächung: Integralverstärkung</translation>
    </message>
    <message>
        <source>Voltage that flux weakening leaves to the drive, in tenths of a percent of the bus</source>
        <translation>Spannung, die die Feldschwächung dem Antrieb lässt, in Zehntelprozent der Zwischenkreisspannung</translation>
    </message>
    <message>
        <source>Bus voltage</source>
        <translation>Zwischenkreisspannung</translation>
    </message>
    <message>
        <source>Temperature of the heat sink; signed from STM32 boards, unsigned by the text</source>
        <translation>Temperatur des Kühlkörpers; von STM32-Boards mit Vorzeichen, laut Beschreibung ohne</translation>
    </message>
    <message>
        <source>Electrical power into the motor; signed from STM32 boards (negative when braking), unsigned by the text</source>
        <translation>Elektrische Leistung in den Motor; von STM32-Boards mit Vorzeichen (negativ beim Bremsen), laut Beschreibung ohne</translation>
    </message>
    <message>
        <source>Number of the register that DAC channel 1 shows</source>
        <translation>Nummer des Registers, das DAC-Kanal 1 zeigt</translation>
    </message>
    <message>
        <source>Number of the register that DAC channel 2 shows</source>
        <translation>Nummer des Registers, das DAC-Kanal 2 zeigt</translation>
    </message>
    <message>
        <source>Mean speed measured</source>
        <translation>Gemessene mittlere Drehzahl</translation>
    </message>
    <message>
        <source>Iq measured</source>
        <translation>Iq, gemessen</translation>
    </message>
    <message>
        <source>Id measured</source>
        <translation>Id, gemessen</translation>
    </message>
    <message>
        <source>Voltage in use, in tenths of a percent of the bus</source>
        <translation>Genutzte Spannung in Zehntelprozent der Zwischenkreisspannung</translation>
    </message>
    <message>
        <source>Stages of the start-up without sensor; 0 where there is none</source>
        <translation>Stufen des Anlaufs ohne Sensor; 0, wo es keinen gibt</translation>
    </message>
    <message>
        <source>Current of phase A</source>
        <translation>Strom der Phase A</translation>
    </message>
    <message>
        <source>Current of phase B</source>
        <translation>Strom der Phase B</translation>
    </message>
    <message>
        <source>Stator current, alpha</source>
        <translation>Statorstrom, Alpha</translation>
    </message>
    <message>
        <source>Stator current, beta</source>
        <translation>Statorstrom, Beta</translation>
    </message>
    <message>
        <source>Reference of Iq</source>
        <translation>Sollwert von Iq</translation>
    </message>
    <message>
        <source>Reference of Id</source>
        <translation>Sollwert von Id</translation>
    </message>
    <message>
        <source>Voltage of the q axis</source>
        <translation>Spannung der q-Achse</translation>
    </message>
    <message>
        <source>Voltage of the d axis</source>
        <translation>Spannung der d-Achse</translation>
    </message>
    <message>
        <source>Voltage, alpha</source>
        <translation>Spannung, Alpha</translation>
    </message>
    <message>
        <source>Voltage, beta</source>
        <translation>Spannung, Beta</translation>
    </message>
    <message>
        <source>Electrical angle of the position sensor</source>
        <translation>Elektrischer Winkel des Lagesensors</translation>
    </message>
    <message>
        <source>Speed of the position sensor</source>
        <translation>Drehzahl des Lagesensors</translation>
    </message>
    <message>
        <source>Electrical angle as the PLL observer sees it</source>
        <translation>Elektrischer Winkel, wie ihn der PLL-Beobachter sieht</translation>
    </message>
    <message>
        <source>Speed as the PLL observer sees it</source>
        <translation>Drehzahl, wie sie der PLL-Beobachter sieht</translation>
    </message>
    <message>
        <source>Current, alpha, as the PLL observer sees it</source>
        <translation>Strom, Alpha, wie ihn der PLL-Beobachter sieht</translation>
    </message>
    <message>
        <source>Current, beta, as the PLL observer sees it</source>
        <translation>Strom, Beta, wie ihn der PLL-Beobachter sieht</translation>
    </message>
    <message>
        <source>Back-EMF, alpha, as the PLL observer sees it</source>
        <translation>Gegen-EMK, Alpha, wie sie der PLL-Beobachter sieht</translation>
    </message>
    <message>
        <source>Back-EMF, beta, as the PLL observer sees it</source>
        <translation>Gegen-EMK, Beta, wie sie der PLL-Beobachter sieht</translation>
    </message>
    <message>
        <source>Electrical angle as the CORDIC observer sees it</source>
        <translation>Elektrischer Winkel, wie ihn der CORDIC-Beobachter sieht</translation>
    </message>
    <message>
        <source>Speed as the CORDIC observer sees it</source>
        <translation>Drehzahl, wie sie der CORDIC-Beobachter sieht</translation>
    </message>
    <message>
        <source>Current, alpha, as the CORDIC observer sees it</source>
        <translation>Strom, Alpha, wie ihn der CORDIC-Beobachter sieht</translation>
    </message>
    <message>
        <source>Current, beta, as the CORDIC observer sees it</source>
        <translation>Strom, Beta, wie ihn der CORDIC-Beobachter sieht</translation>
    </message>
    <message>
        <source>Back-EMF, alpha, as the CORDIC observer sees it</source>
        <translation>Gegen-EMK, Alpha, wie sie der CORDIC-Beobachter sieht</translation>
    </message>
    <message>
        <source>Back-EMF, beta, as the CORDIC observer sees it</source>
        <translation>Gegen-EMK, Beta, wie sie der CORDIC-Beobachter sieht</translation>
    </message>
    <message>
        <source>Number from the application for channel 1</source>
        <translation>Zahl der Anwendung für Kanal 1</translation>
    </message>
    <message>
        <source>Number from the application for channel 2</source>
        <translation>Zahl der Anwendung für Kanal 2</translation>
    </message>
    <message>
        <source>Highest speed of the application; firmware 5.4.3 does not answer it</source>
        <translation>Höchste Drehzahl der Anwendung; Firmware 5.4.3 beantwortet das nicht</translation>
    </message>
    <message>
        <source>Lowest speed of the application; firmware 5.4.3 does not answer it</source>
        <translation>Niedrigste Drehzahl der Anwendung; Firmware 5.4.3 beantwortet das nicht</translation>
    </message>
    <message>
        <source>Reference of Id, in spite of its name</source>
        <translation>Sollwert von Id, trotz des Namens</translation>
    </message>
    <message>
        <source>Back-EMF expected of this speed</source>
        <translation>Gegen-EMK, die bei dieser Drehzahl zu erwarten ist</translation>
    </message>
    <message>
        <source>Back-EMF observed</source>
        <translation>Beobachtete Gegen-EMK</translation>
    </message>
    <message>
        <source>Feed forward: constant 1 of the q axis</source>
        <translation>Vorsteuerung: Konstante 1 der q-Achse</translation>
    </message>
    <message>
        <source>Feed forward: constant 1 of the d axis</source>
        <translation>Vorsteuerung: Konstante 1 der d-Achse</translation>
    </message>
    <message>
        <source>Feed forward: constant 2</source>
        <translation>Vorsteuerung: Konstante 2</translation>
    </message>
    <message>
        <source>Part of Vq that is fed forward</source>
        <translation>Anteil der Vorsteuerung an Vq</translation>
    </message>
    <message>
        <source>Part of Vd that is fed forward</source>
        <translation>Anteil der Vorsteuerung an Vd</translation>
    </message>
    <message>
        <source>Part of Vq that the current loop adds</source>
        <translation>Anteil des Stromreglers an Vq</translation>
    </message>
    <message>
        <source>Part of Vd that the current loop adds</source>
        <translation>Anteil des Stromreglers an Vd</translation>
    </message>
    <message>
        <source>State of the power-factor corrector</source>
        <translation>Zustand der Leistungsfaktorkorrektur</translation>
    </message>
    <message>
        <source>Faults of the power-factor corrector</source>
        <translation>Fehler der Leistungsfaktorkorrektur</translation>
    </message>
    <message>
        <source>Bus voltage that the corrector keeps</source>
        <translation>Zwischenkreisspannung, die die Leistungsfaktorkorrektur hält</translation>
    </message>
    <message>
        <source>Bus voltage that the corrector measures</source>
        <translation>Zwischenkreisspannung, die die Leistungsfaktorkorrektur misst</translation>
    </message>
    <message>
        <source>Frequency of the mains</source>
        <translation>Netzfrequenz</translation>
    </message>
    <message>
        <source>Peak voltage of the mains, in spite of its name</source>
        <translation>Scheitelwert der Netzspannung, trotz des Namens</translation>
    </message>
    <message>
        <source>Corrector&apos;s current loop: proportional gain</source>
        <translation>Stromregler der Leistungsfaktorkorrektur: Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Corrector&apos;s current loop: integral gain</source>
        <translation>Stromregler der Leistungsfaktorkorrektur: Integralverstärkung</translation>
    </message>
    <message>
        <source>Corrector&apos;s current loop: derivative gain</source>
        <translation>Stromregler der Leistungsfaktorkorrektur: Differentialverstärkung</translation>
    </message>
    <message>
        <source>Corrector&apos;s voltage loop: proportional gain</source>
        <translation>Spannungsregler der Leistungsfaktorkorrektur: Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Corrector&apos;s voltage loop: integral gain</source>
        <translation>Spannungsregler der Leistungsfaktorkorrektur: Integralverstärkung</translation>
    </message>
    <message>
        <source>Corrector&apos;s voltage loop: derivative gain</source>
        <translation>Spannungsregler der Leistungsfaktorkorrektur: Differentialverstärkung</translation>
    </message>
    <message>
        <source>Time of the corrector&apos;s start-up</source>
        <translation>Dauer des Hochlaufs der Leistungsfaktorkorrektur</translation>
    </message>
    <message>
        <source>Whether the corrector is on</source>
        <translation>Ob die Leistungsfaktorkorrektur eingeschaltet ist</translation>
    </message>
    <message>
        <source>Last final speed asked for; a write is a ramp of 0 ms</source>
        <translation>Zuletzt verlangte Enddrehzahl; Schreiben ist eine Rampe von 0 ms</translation>
    </message>
    <message>
        <source>Duration of ramps that a write of RAMP_FINAL_SPEED starts; STM32 boards do not answer it</source>
        <translation>Dauer der Rampen, die ein Schreiben von RAMP_FINAL_SPEED startet; STM32-Boards beantworten das nicht</translation>
    </message>
    <message>
        <source>Angle found by injection</source>
        <translation>Durch Einprägung gefundener Winkel</translation>
    </message>
    <message>
        <source>Speed found by injection</source>
        <translation>Durch Einprägung gefundene Drehzahl</translation>
    </message>
    <message>
        <source>Current injected</source>
        <translation>Eingeprägter Strom</translation>
    </message>
    <message>
        <source>Angle at the start found by injection</source>
        <translation>Durch Einprägung gefundener Winkel beim Start</translation>
    </message>
    <message>
        <source>Difference of saturation that decides the polarity</source>
        <translation>Unterschied der Sättigung, der über die Polarität entscheidet</translation>
    </message>
    <message>
        <source>Injection&apos;s PLL: proportional gain; firmware 5.4.3 has nothing behind it</source>
        <translation>PLL der Einprägung: Proportionalverstärkung; in Firmware 5.4.3 ohne Wirkung</translation>
    </message>
    <message>
        <source>Injection&apos;s PLL: integral gain; firmware 5.4.3 has nothing behind it</source>
        <translation>PLL der Einprägung: Integralverstärkung; in Firmware 5.4.3 ohne Wirkung</translation>
    </message>
    <message>
        <source>Injection&apos;s tracking: proportional gain</source>
        <translation>Nachführung der Einprägung: Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Injection&apos;s tracking: integral gain</source>
        <translation>Nachführung der Einprägung: Integralverstärkung</translation>
    </message>
    <message>
        <source>Whether the profiler is there</source>
        <translation>Ob der Profiler vorhanden ist</translation>
    </message>
    <message>
        <source>State of the profiler</source>
        <translation>Zustand des Profilers</translation>
    </message>
    <message>
        <source>Resistance found</source>
        <translation>Gefundener Widerstand</translation>
    </message>
    <message>
        <source>Inductance found</source>
        <translation>Gefundene Induktivität</translation>
    </message>
    <message>
        <source>Back-EMF constant found</source>
        <translation>Gefundene Spannungskonstante</translation>
    </message>
    <message>
        <source>Bus voltage during the profile</source>
        <translation>Zwischenkreisspannung während der Vermessung</translation>
    </message>
    <message>
        <source>Nominal speed found</source>
        <translation>Gefundene Nenndrehzahl</translation>
    </message>
    <message>
        <source>Steps of the profile</source>
        <translation>Schritte der Vermessung</translation>
    </message>
    <message>
        <source>Divisor of SPEED_KP</source>
        <translation>Teiler von SPEED_KP</translation>
    </message>
    <message>
        <source>Divisor of SPEED_KI</source>
        <translation>Teiler von SPEED_KI</translation>
    </message>
    <message>
        <source>Number of the firmware build</source>
        <translation>Nummer des Firmware-Builds</translation>
    </message>
    <message>
        <source>In the list only, nothing behind it</source>
        <translation>Nur in der Liste, nichts dahinter</translation>
    </message>
    <message>
        <source>Number of the control board; 2 bytes from firmware, 4 by the text</source>
        <translation>Nummer der Steuerplatine; 2 Byte von der Firmware, laut Beschreibung 4</translation>
    </message>
    <message>
        <source>Number of the power board; 2 bytes from firmware, 4 by the text</source>
        <translation>Nummer der Leistungsplatine; 2 Byte von der Firmware, laut Beschreibung 4</translation>
    </message>
    <message>
        <source>Pole pairs for the profile</source>
        <translation>Polpaare für die Vermessung</translation>
    </message>
    <message>
        <source>Current for the profile</source>
        <translation>Strom für die Vermessung</translation>
    </message>
    <message>
        <source>Bandwidth wanted of the speed loop</source>
        <translation>Gewünschte Bandbreite des Drehzahlreglers</translation>
    </message>
    <message>
        <source>Ratio of Ld to Lq for the profile</source>
        <translation>Verhältnis von Ld zu Lq für die Vermessung</translation>
    </message>
    <message>
        <source>Nominal speed for the profile</source>
        <translation>Nenndrehzahl für die Vermessung</translation>
    </message>
    <message>
        <source>Bandwidth wanted of the current loops</source>
        <translation>Gewünschte Bandbreite der Stromregler</translation>
    </message>
    <message>
        <source>Inertia found</source>
        <translation>Gefundene Trägheit</translation>
    </message>
    <message>
        <source>Friction found</source>
        <translation>Gefundene Reibung</translation>
    </message>
    <message>
        <source>Greatest current of the profile</source>
        <translation>Größter Strom der Vermessung</translation>
    </message>
    <message>
        <source>Speed at which the profile starts</source>
        <translation>Drehzahl, mit der die Vermessung beginnt</translation>
    </message>
    <message>
        <source>Acceleration at which the profile starts</source>
        <translation>Beschleunigung, mit der die Vermessung beginnt</translation>
    </message>
    <message>
        <source>Frequency of the PWM</source>
        <translation>PWM-Frequenz</translation>
    </message>
    <message>
        <source>PWM periods to one step of the current loops</source>
        <translation>PWM-Perioden je Schritt der Stromregler</translation>
    </message>
    <message>
        <source>Number of the power board of motor 2; firmware 5.4.3 does not answer it</source>
        <translation>Nummer der Leistungsplatine von Motor 2; Firmware 5.4.3 beantwortet das nicht</translation>
    </message>
    <message>
        <source>Whether the profile is done</source>
        <translation>Ob die Vermessung abgeschlossen ist</translation>
    </message>
    <message>
        <source>Position measured</source>
        <translation>Gemessene Position</translation>
    </message>
    <message>
        <source>Position wanted</source>
        <translation>Gewünschte Position</translation>
    </message>
    <message>
        <source>Time of the move</source>
        <translation>Dauer der Bewegung</translation>
    </message>
    <message>
        <source>Position loop: proportional gain</source>
        <translation>Positionsregler: Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Position loop: integral gain</source>
        <translation>Positionsregler: Integralverstärkung</translation>
    </message>
    <message>
        <source>Position loop: derivative gain</source>
        <translation>Positionsregler: Differentialverstärkung</translation>
    </message>
    <message>
        <source>Code of the latest error</source>
        <translation>Code des letzten Fehlers</translation>
    </message>
    <message>
        <source>Control word of the drive state machine (DS402 bits)</source>
        <translation>Steuerwort der Zustandsmaschine des Antriebs (DS402-Bits)</translation>
    </message>
    <message>
        <source>Status word of the drive state machine (DS402 bits)</source>
        <translation>Statuswort der Zustandsmaschine des Antriebs (DS402-Bits)</translation>
    </message>
    <message>
        <source>Operation mode wanted</source>
        <translation>Gewünschte Betriebsart</translation>
    </message>
    <message>
        <source>Operation mode in force</source>
        <translation>Geltende Betriebsart</translation>
    </message>
    <message>
        <source>Set-point of the quadrature voltage</source>
        <translation>Sollwert der Querspannung</translation>
    </message>
    <message>
        <source>Set-point of the direct voltage</source>
        <translation>Sollwert der Längsspannung</translation>
    </message>
    <message>
        <source>Set-point of the quadrature (torque) current</source>
        <translation>Sollwert des Querstroms (Moment)</translation>
    </message>
    <message>
        <source>Set-point of the direct (flux) current</source>
        <translation>Sollwert des Längsstroms (Fluss)</translation>
    </message>
    <message>
        <source>Set-point of phase A current</source>
        <translation>Sollwert des Stroms der Phase A</translation>
    </message>
    <message>
        <source>Set-point of phase B current</source>
        <translation>Sollwert des Stroms der Phase B</translation>
    </message>
    <message>
        <source>Position set-point</source>
        <translation>Positionssollwert</translation>
    </message>
    <message>
        <source>Velocity set-point</source>
        <translation>Drehzahlsollwert</translation>
    </message>
    <message>
        <source>Torque set-point</source>
        <translation>Drehmomentsollwert</translation>
    </message>
    <message>
        <source>Options of the position profiler</source>
        <translation>Optionen des Positionsprofilgebers</translation>
    </message>
    <message>
        <source>Highest velocity of the profiler</source>
        <translation>Höchste Drehzahl des Profilgebers</translation>
    </message>
    <message>
        <source>Highest acceleration of the profiler</source>
        <translation>Höchste Beschleunigung des Profilgebers</translation>
    </message>
    <message>
        <source>Highest deceleration of the profiler</source>
        <translation>Höchste Verzögerung des Profilgebers</translation>
    </message>
    <message>
        <source>Measured position</source>
        <translation>Gemessene Position</translation>
    </message>
    <message>
        <source>Measured velocity</source>
        <translation>Gemessene Drehzahl</translation>
    </message>
    <message>
        <source>Value of the auxiliary sensor</source>
        <translation>Wert des Hilfssensors</translation>
    </message>
    <message>
        <source>Raw converter reading of the bus current</source>
        <translation>Rohwert des Wandlers für den Zwischenkreisstrom</translation>
    </message>
    <message>
        <source>Measured phase A current</source>
        <translation>Gemessener Strom der Phase A</translation>
    </message>
    <message>
        <source>Measured phase B current</source>
        <translation>Gemessener Strom der Phase B</translation>
    </message>
    <message>
        <source>Measured phase C current</source>
        <translation>Gemessener Strom der Phase C</translation>
    </message>
    <message>
        <source>Measured quadrature current</source>
        <translation>Gemessener Querstrom</translation>
    </message>
    <message>
        <source>Measured direct current</source>
        <translation>Gemessener Längsstrom</translation>
    </message>
    <message>
        <source>Raw converter reading of phase A</source>
        <translation>Rohwert des Wandlers für Phase A</translation>
    </message>
    <message>
        <source>Raw converter reading of phase B</source>
        <translation>Rohwert des Wandlers für Phase B</translation>
    </message>
    <message>
        <source>Raw converter reading of phase C</source>
        <translation>Rohwert des Wandlers für Phase C</translation>
    </message>
    <message>
        <source>Commutation angle in use</source>
        <translation>Benutzter Kommutierungswinkel</translation>
    </message>
    <message>
        <source>Reference angle</source>
        <translation>Referenzwinkel</translation>
    </message>
    <message>
        <source>Position of absolute encoder 1 (BiSS-C or SSI)</source>
        <translation>Position des Absolutwertgebers 1 (BiSS-C oder SSI)</translation>
    </message>
    <message>
        <source>Present value of the internal generator</source>
        <translation>Jetziger Wert des internen Generators</translation>
    </message>
    <message>
        <source>Position of the second SSI encoder</source>
        <translation>Position des zweiten SSI-Gebers</translation>
    </message>
    <message>
        <source>Position of the second BiSS-C encoder in the chain</source>
        <translation>Position des zweiten BiSS-C-Gebers in der Kette</translation>
    </message>
    <message>
        <source>Raw converter reading of the bus voltage</source>
        <translation>Rohwert des Wandlers für die Zwischenkreisspannung</translation>
    </message>
    <message>
        <source>Measured DC bus voltage</source>
        <translation>Gemessene Zwischenkreisspannung</translation>
    </message>
    <message>
        <source>Temperature of the power stage, first sensor</source>
        <translation>Temperatur des Leistungsteils, erster Sensor</translation>
    </message>
    <message>
        <source>Raw converter reading of that temperature</source>
        <translation>Rohwert des Wandlers für diese Temperatur</translation>
    </message>
    <message>
        <source>Motor temperature</source>
        <translation>Motortemperatur</translation>
    </message>
    <message>
        <source>Temperature of the redundant sensor</source>
        <translation>Temperatur des redundanten Sensors</translation>
    </message>
    <message>
        <source>Power stage temperature used for protection</source>
        <translation>Temperatur des Leistungsteils, die dem Schutz dient</translation>
    </message>
    <message>
        <source>Phase A voltage share</source>
        <translation>Spannungsanteil der Phase A</translation>
    </message>
    <message>
        <source>Phase B voltage share</source>
        <translation>Spannungsanteil der Phase B</translation>
    </message>
    <message>
        <source>Phase C voltage share</source>
        <translation>Spannungsanteil der Phase C</translation>
    </message>
    <message>
        <source>Quadrature voltage demanded</source>
        <translation>Verlangte Querspannung</translation>
    </message>
    <message>
        <source>Direct voltage demanded</source>
        <translation>Verlangte Längsspannung</translation>
    </message>
    <message>
        <source>Quadrature current demanded</source>
        <translation>Verlangter Querstrom</translation>
    </message>
    <message>
        <source>Direct current demanded</source>
        <translation>Verlangter Längsstrom</translation>
    </message>
    <message>
        <source>Phase A current demanded</source>
        <translation>Verlangter Strom der Phase A</translation>
    </message>
    <message>
        <source>Phase B current demanded</source>
        <translation>Verlangter Strom der Phase B</translation>
    </message>
    <message>
        <source>Modulus of the measured current</source>
        <translation>Betrag des gemessenen Stroms</translation>
    </message>
    <message>
        <source>Modulus of the commanded current</source>
        <translation>Betrag des vorgegebenen Stroms</translation>
    </message>
    <message>
        <source>Position demanded by the profiler</source>
        <translation>Vom Profilgeber verlangte Position</translation>
    </message>
    <message>
        <source>Velocity demanded</source>
        <translation>Verlangte Drehzahl</translation>
    </message>
    <message>
        <source>Acceleration demanded</source>
        <translation>Verlangte Beschleunigung</translation>
    </message>
    <message>
        <source>Offset added at the velocity loop input</source>
        <translation>Offset am Eingang des Drehzahlreglers</translation>
    </message>
    <message>
        <source>Offset added at the quadrature current loop input</source>
        <translation>Offset am Eingang des Querstromreglers</translation>
    </message>
    <message>
        <source>Offset added at the direct current loop input</source>
        <translation>Offset am Eingang des Längsstromreglers</translation>
    </message>
    <message>
        <source>Raw reading of analog input 1</source>
        <translation>Rohwert des Analogeingangs 1</translation>
    </message>
    <message>
        <source>Raw reading of analog input 2</source>
        <translation>Rohwert des Analogeingangs 2</translation>
    </message>
    <message>
        <source>Command into the position loop</source>
        <translation>Vorgabe an den Positionsregler</translation>
    </message>
    <message>
        <source>Command into the velocity loop</source>
        <translation>Vorgabe an den Drehzahlregler</translation>
    </message>
    <message>
        <source>Command into the quadrature current loop</source>
        <translation>Vorgabe an den Querstromregler</translation>
    </message>
    <message>
        <source>Command into the direct current loop</source>
        <translation>Vorgabe an den Längsstromregler</translation>
    </message>
    <message>
        <source>Rated motor current</source>
        <translation>Nennstrom des Motors</translation>
    </message>
    <message>
        <source>Peak current</source>
        <translation>Spitzenstrom</translation>
    </message>
    <message>
        <source>Time the peak current may last</source>
        <translation>Zulässige Dauer des Spitzenstroms</translation>
    </message>
    <message>
        <source>Pole pairs of the motor</source>
        <translation>Polpaare des Motors</translation>
    </message>
    <message>
        <source>Highest motor voltage</source>
        <translation>Höchste Motorspannung</translation>
    </message>
    <message>
        <source>Motor temperature limit</source>
        <translation>Temperaturgrenze des Motors</translation>
    </message>
    <message>
        <source>Kind of motor temperature sensor</source>
        <translation>Art des Temperatursensors im Motor</translation>
    </message>
    <message>
        <source>Bus voltage that switches the brake resistor on</source>
        <translation>Zwischenkreisspannung, die den Bremswiderstand einschaltet</translation>
    </message>
    <message>
        <source>Bus voltage that switches the brake resistor off</source>
        <translation>Zwischenkreisspannung, die den Bremswiderstand ausschaltet</translation>
    </message>
    <message>
        <source>Duty cycle that holds the brake open</source>
        <translation>Tastgrad, der die Bremse offen hält</translation>
    </message>
    <message>
        <source>Delay before the brake acts</source>
        <translation>Verzögerung, bevor die Bremse wirkt</translation>
    </message>
    <message>
        <source>Delay after the brake has acted</source>
        <translation>Verzögerung, nachdem die Bremse gewirkt hat</translation>
    </message>
    <message>
        <source>Kind of commutation</source>
        <translation>Art der Kommutierung</translation>
    </message>
    <message>
        <source>Offset of the commutation angle</source>
        <translation>Offset des Kommutierungswinkels</translation>
    </message>
    <message>
        <source>Sensor used for commutation</source>
        <translation>Sensor für die Kommutierung</translation>
    </message>
    <message>
        <source>Sensor used as angle reference</source>
        <translation>Sensor als Winkelreferenz</translation>
    </message>
    <message>
        <source>Way of finding the start angle</source>
        <translation>Verfahren zur Bestimmung des Startwinkels</translation>
    </message>
    <message>
        <source>Current used to find the start angle</source>
        <translation>Strom zur Bestimmung des Startwinkels</translation>
    </message>
    <message>
        <source>Time limit for finding the start angle</source>
        <translation>Zeitgrenze für die Bestimmung des Startwinkels</translation>
    </message>
    <message>
        <source>Accuracy wanted for the start angle</source>
        <translation>Gewünschte Genauigkeit des Startwinkels</translation>
    </message>
    <message>
        <source>Velocity limit</source>
        <translation>Drehzahlgrenze</translation>
    </message>
    <message>
        <source>Lowest position allowed</source>
        <translation>Kleinste zulässige Position</translation>
    </message>
    <message>
        <source>Highest position allowed</source>
        <translation>Größte zulässige Position</translation>
    </message>
    <message>
        <source>Largest tracking error allowed</source>
        <translation>Größter zulässiger Schleppfehler</translation>
    </message>
    <message>
        <source>Time the tracking error may last</source>
        <translation>Zulässige Dauer des Schleppfehlers</translation>
    </message>
    <message>
        <source>Tracking error now</source>
        <translation>Jetziger Schleppfehler</translation>
    </message>
    <message>
        <source>Window for position reached</source>
        <translation>Fenster, in dem die Position als erreicht gilt</translation>
    </message>
    <message>
        <source>Time inside the window for position reached</source>
        <translation>Zeit im Fenster, bis die Position als erreicht gilt</translation>
    </message>
    <message>
        <source>Window for velocity reached</source>
        <translation>Fenster, in dem die Drehzahl als erreicht gilt</translation>
    </message>
    <message>
        <source>Time inside the window for velocity reached</source>
        <translation>Zeit im Fenster, bis die Drehzahl als erreicht gilt</translation>
    </message>
    <message>
        <source>Deceleration of a quick stop</source>
        <translation>Verzögerung beim Schnellhalt</translation>
    </message>
    <message>
        <source>Where the set-point comes from</source>
        <translation>Woher der Sollwert kommt</translation>
    </message>
    <message>
        <source>Sensors that the drive offers, one bit each</source>
        <translation>Sensoren, die der Antrieb bietet, je ein Bit</translation>
    </message>
    <message>
        <source>Sensor used for velocity</source>
        <translation>Sensor für die Drehzahl</translation>
    </message>
    <message>
        <source>Sensor used for position</source>
        <translation>Sensor für die Position</translation>
    </message>
    <message>
        <source>Sensor used as auxiliary</source>
        <translation>Hilfssensor</translation>
    </message>
    <message>
        <source>Ratio from position sensor to velocity sensor</source>
        <translation>Verhältnis von Positionssensor zu Drehzahlsensor</translation>
    </message>
    <message>
        <source>Protocol of absolute encoder 1</source>
        <translation>Protokoll des Absolutwertgebers 1</translation>
    </message>
    <message>
        <source>Frame length of absolute encoder 1</source>
        <translation>Rahmenlänge des Absolutwertgebers 1</translation>
    </message>
    <message>
        <source>Direction of absolute encoder 1</source>
        <translation>Zählrichtung des Absolutwertgebers 1</translation>
    </message>
    <message>
        <source>Position bits of absolute encoder 1</source>
        <translation>Positionsbits des Absolutwertgebers 1</translation>
    </message>
    <message>
        <source>Single-turn bits of absolute encoder 1</source>
        <translation>Singleturn-Bits des Absolutwertgebers 1</translation>
    </message>
    <message>
        <source>Kind of signal of the internal generator</source>
        <translation>Signalart des internen Generators</translation>
    </message>
    <message>
        <source>Frequency of the internal generator</source>
        <translation>Frequenz des internen Generators</translation>
    </message>
    <message>
        <source>Gain of the internal generator</source>
        <translation>Verstärkung des internen Generators</translation>
    </message>
    <message>
        <source>Offset of the internal generator</source>
        <translation>Offset des internen Generators</translation>
    </message>
    <message>
        <source>Number of cycles of the internal generator</source>
        <translation>Anzahl der Perioden des internen Generators</translation>
    </message>
    <message>
        <source>Starts the internal generator again</source>
        <translation>Startet den internen Generator neu</translation>
    </message>
    <message>
        <source>Counts per turn of digital encoder 1</source>
        <translation>Inkremente je Umdrehung des Inkrementalgebers 1</translation>
    </message>
    <message>
        <source>Direction of digital encoder 1</source>
        <translation>Zählrichtung des Inkrementalgebers 1</translation>
    </message>
    <message>
        <source>Filter of digital encoder 1</source>
        <translation>Filter des Inkrementalgebers 1</translation>
    </message>
    <message>
        <source>Count of digital encoder 1</source>
        <translation>Zählerstand des Inkrementalgebers 1</translation>
    </message>
    <message>
        <source>Counts per turn of digital encoder 2</source>
        <translation>Inkremente je Umdrehung des Inkrementalgebers 2</translation>
    </message>
    <message>
        <source>Direction of digital encoder 2</source>
        <translation>Zählrichtung des Inkrementalgebers 2</translation>
    </message>
    <message>
        <source>Count of digital encoder 2</source>
        <translation>Zählerstand des Inkrementalgebers 2</translation>
    </message>
    <message>
        <source>Direction of the Hall sensors</source>
        <translation>Zählrichtung der Hallsensoren</translation>
    </message>
    <message>
        <source>Filter of the Hall sensors</source>
        <translation>Filter der Hallsensoren</translation>
    </message>
    <message>
        <source>Pole pairs of the Hall sensors</source>
        <translation>Polpaare der Hallsensoren</translation>
    </message>
    <message>
        <source>State of the Hall sensors</source>
        <translation>Zustand der Hallsensoren</translation>
    </message>
    <message>
        <source>Homing method</source>
        <translation>Verfahren der Referenzfahrt</translation>
    </message>
    <message>
        <source>Offset of the home position</source>
        <translation>Offset der Referenzposition</translation>
    </message>
    <message>
        <source>Time limit of homing</source>
        <translation>Zeitgrenze der Referenzfahrt</translation>
    </message>
    <message>
        <source>Search speed of homing</source>
        <translation>Suchdrehzahl der Referenzfahrt</translation>
    </message>
    <message>
        <source>Final speed of homing</source>
        <translation>Enddrehzahl der Referenzfahrt</translation>
    </message>
    <message>
        <source>Input of the positive homing switch</source>
        <translation>Eingang des positiven Referenzschalters</translation>
    </message>
    <message>
        <source>Source of the index pulse</source>
        <translation>Quelle des Indeximpulses</translation>
    </message>
    <message>
        <source>Range of the current measurement</source>
        <translation>Messbereich des Stroms</translation>
    </message>
    <message>
        <source>Quadrature current loop, proportional gain</source>
        <translation>Querstromregler, Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Quadrature current loop, integral gain</source>
        <translation>Querstromregler, Integralverstärkung</translation>
    </message>
    <message>
        <source>Quadrature current loop, highest output</source>
        <translation>Querstromregler, größte Ausgangsgröße</translation>
    </message>
    <message>
        <source>Quadrature current loop, lowest output</source>
        <translation>Querstromregler, kleinste Ausgangsgröße</translation>
    </message>
    <message>
        <source>Direct current loop, proportional gain</source>
        <translation>Längsstromregler, Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Direct current loop, integral gain</source>
        <translation>Längsstromregler, Integralverstärkung</translation>
    </message>
    <message>
        <source>Direct current loop, highest output</source>
        <translation>Längsstromregler, größte Ausgangsgröße</translation>
    </message>
    <message>
        <source>Direct current loop, lowest output</source>
        <translation>Längsstromregler, kleinste Ausgangsgröße</translation>
    </message>
    <message>
        <source>Velocity loop, proportional gain</source>
        <translation>Drehzahlregler, Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Velocity loop, integral gain</source>
        <translation>Drehzahlregler, Integralverstärkung</translation>
    </message>
    <message>
        <source>Velocity loop, derivative gain</source>
        <translation>Drehzahlregler, Differentialverstärkung</translation>
    </message>
    <message>
        <source>Velocity loop, filter of the derivative part</source>
        <translation>Drehzahlregler, Filter des Differentialanteils</translation>
    </message>
    <message>
        <source>Velocity loop, highest output</source>
        <translation>Drehzahlregler, größte Ausgangsgröße</translation>
    </message>
    <message>
        <source>Velocity loop, lowest output</source>
        <translation>Drehzahlregler, kleinste Ausgangsgröße</translation>
    </message>
    <message>
        <source>Position loop, proportional gain</source>
        <translation>Positionsregler, Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Position loop, integral gain</source>
        <translation>Positionsregler, Integralverstärkung</translation>
    </message>
    <message>
        <source>Position loop, derivative gain</source>
        <translation>Positionsregler, Differentialverstärkung</translation>
    </message>
    <message>
        <source>Position loop, filter of the derivative part</source>
        <translation>Positionsregler, Filter des Differentialanteils</translation>
    </message>
    <message>
        <source>Position loop, highest output</source>
        <translation>Positionsregler, größte Ausgangsgröße</translation>
    </message>
    <message>
        <source>Position loop, lowest output</source>
        <translation>Positionsregler, kleinste Ausgangsgröße</translation>
    </message>
    <message>
        <source>State of the current loop</source>
        <translation>Zustand des Stromreglers</translation>
    </message>
    <message>
        <source>State of the velocity loop</source>
        <translation>Zustand des Drehzahlreglers</translation>
    </message>
    <message>
        <source>State of the position loop</source>
        <translation>Zustand des Positionsreglers</translation>
    </message>
    <message>
        <source>State of safe torque off</source>
        <translation>Zustand der sicheren Momentenabschaltung (STO)</translation>
    </message>
    <message>
        <source>Rate of the position and velocity loops</source>
        <translation>Takt von Positions- und Drehzahlregler</translation>
    </message>
    <message>
        <source>Choice of the PWM frequency (index into 0x700-0x703)</source>
        <translation>Wahl der PWM-Frequenz (Index in 0x700-0x703)</translation>
    </message>
    <message>
        <source>Filter 1 of the position feedback: kind</source>
        <translation>Filter 1 des Positionsistwerts: Art</translation>
    </message>
    <message>
        <source>Filter 1 of the position feedback: frequency</source>
        <translation>Filter 1 des Positionsistwerts: Frequenz</translation>
    </message>
    <message>
        <source>Filter 1 of the position feedback: quality factor</source>
        <translation>Filter 1 des Positionsistwerts: Güte</translation>
    </message>
    <message>
        <source>Filter 1 of the position feedback: gain</source>
        <translation>Filter 1 des Positionsistwerts: Verstärkung</translation>
    </message>
    <message>
        <source>Filter 2 of the position feedback: kind</source>
        <translation>Filter 2 des Positionsistwerts: Art</translation>
    </message>
    <message>
        <source>Filter 2 of the position feedback: frequency</source>
        <translation>Filter 2 des Positionsistwerts: Frequenz</translation>
    </message>
    <message>
        <source>Filter 2 of the position feedback: quality factor</source>
        <translation>Filter 2 des Positionsistwerts: Güte</translation>
    </message>
    <message>
        <source>Filter 2 of the position feedback: gain</source>
        <translation>Filter 2 des Positionsistwerts: Verstärkung</translation>
    </message>
    <message>
        <source>Filter 1 of the position reference: kind</source>
        <translation>Filter 1 des Positionssollwerts: Art</translation>
    </message>
    <message>
        <source>Filter 1 of the position reference: frequency</source>
        <translation>Filter 1 des Positionssollwerts: Frequenz</translation>
    </message>
    <message>
        <source>Filter 1 of the position reference: quality factor</source>
        <translation>Filter 1 des Positionssollwerts: Güte</translation>
    </message>
    <message>
        <source>Filter 1 of the position reference: gain</source>
        <translation>Filter 1 des Positionssollwerts: Verstärkung</translation>
    </message>
    <message>
        <source>Filter 2 of the position reference: kind</source>
        <translation>Filter 2 des Positionssollwerts: Art</translation>
    </message>
    <message>
        <source>Filter 2 of the position reference: frequency</source>
        <translation>Filter 2 des Positionssollwerts: Frequenz</translation>
    </message>
    <message>
        <source>Filter 2 of the position reference: quality factor</source>
        <translation>Filter 2 des Positionssollwerts: Güte</translation>
    </message>
    <message>
        <source>Filter 2 of the position reference: gain</source>
        <translation>Filter 2 des Positionssollwerts: Verstärkung</translation>
    </message>
    <message>
        <source>Filter 1 of the velocity feedback: kind</source>
        <translation>Filter 1 des Drehzahlistwerts: Art</translation>
    </message>
    <message>
        <source>Filter 1 of the velocity feedback: frequency</source>
        <translation>Filter 1 des Drehzahlistwerts: Frequenz</translation>
    </message>
    <message>
        <source>Filter 1 of the velocity feedback: quality factor</source>
        <translation>Filter 1 des Drehzahlistwerts: Güte</translation>
    </message>
    <message>
        <source>Filter 1 of the velocity feedback: gain</source>
        <translation>Filter 1 des Drehzahlistwerts: Verstärkung</translation>
    </message>
    <message>
        <source>Filter 2 of the velocity feedback: kind</source>
        <translation>Filter 2 des Drehzahlistwerts: Art</translation>
    </message>
    <message>
        <source>Filter 2 of the velocity feedback: frequency</source>
        <translation>Filter 2 des Drehzahlistwerts: Frequenz</translation>
    </message>
    <message>
        <source>Filter 2 of the velocity feedback: quality factor</source>
        <translation>Filter 2 des Drehzahlistwerts: Güte</translation>
    </message>
    <message>
        <source>Filter 2 of the velocity feedback: gain</source>
        <translation>Filter 2 des Drehzahlistwerts: Verstärkung</translation>
    </message>
    <message>
        <source>Filter 1 of the velocity reference: kind</source>
        <translation>Filter 1 des Drehzahlsollwerts: Art</translation>
    </message>
    <message>
        <source>Filter 1 of the velocity reference: frequency</source>
        <translation>Filter 1 des Drehzahlsollwerts: Frequenz</translation>
    </message>
    <message>
        <source>Filter 1 of the velocity reference: quality factor</source>
        <translation>Filter 1 des Drehzahlsollwerts: Güte</translation>
    </message>
    <message>
        <source>Filter 1 of the velocity reference: gain</source>
        <translation>Filter 1 des Drehzahlsollwerts: Verstärkung</translation>
    </message>
    <message>
        <source>Filter 2 of the velocity reference: kind</source>
        <translation>Filter 2 des Drehzahlsollwerts: Art</translation>
    </message>
    <message>
        <source>Filter 2 of the velocity reference: frequency</source>
        <translation>Filter 2 des Drehzahlsollwerts: Frequenz</translation>
    </message>
    <message>
        <source>Filter 2 of the velocity reference: quality factor</source>
        <translation>Filter 2 des Drehzahlsollwerts: Güte</translation>
    </message>
    <message>
        <source>Filter 2 of the velocity reference: gain</source>
        <translation>Filter 2 des Drehzahlsollwerts: Verstärkung</translation>
    </message>
    <message>
        <source>Filter 1 of the current feedback: kind</source>
        <translation>Filter 1 des Stromistwerts: Art</translation>
    </message>
    <message>
        <source>Filter 1 of the current feedback: frequency</source>
        <translation>Filter 1 des Stromistwerts: Frequenz</translation>
    </message>
    <message>
        <source>Filter 1 of the current feedback: quality factor</source>
        <translation>Filter 1 des Stromistwerts: Güte</translation>
    </message>
    <message>
        <source>Filter 1 of the current feedback: gain</source>
        <translation>Filter 1 des Stromistwerts: Verstärkung</translation>
    </message>
    <message>
        <source>Filter 2 of the current feedback: kind</source>
        <translation>Filter 2 des Stromistwerts: Art</translation>
    </message>
    <message>
        <source>Filter 2 of the current feedback: frequency</source>
        <translation>Filter 2 des Stromistwerts: Frequenz</translation>
    </message>
    <message>
        <source>Filter 2 of the current feedback: quality factor</source>
        <translation>Filter 2 des Stromistwerts: Güte</translation>
    </message>
    <message>
        <source>Filter 2 of the current feedback: gain</source>
        <translation>Filter 2 des Stromistwerts: Verstärkung</translation>
    </message>
    <message>
        <source>Filter 1 of the current reference: kind</source>
        <translation>Filter 1 des Stromsollwerts: Art</translation>
    </message>
    <message>
        <source>Filter 1 of the current reference: frequency</source>
        <translation>Filter 1 des Stromsollwerts: Frequenz</translation>
    </message>
    <message>
        <source>Filter 1 of the current reference: quality factor</source>
        <translation>Filter 1 des Stromsollwerts: Güte</translation>
    </message>
    <message>
        <source>Filter 1 of the current reference: gain</source>
        <translation>Filter 1 des Stromsollwerts: Verstärkung</translation>
    </message>
    <message>
        <source>Filter 2 of the current reference: kind</source>
        <translation>Filter 2 des Stromsollwerts: Art</translation>
    </message>
    <message>
        <source>Filter 2 of the current reference: frequency</source>
        <translation>Filter 2 des Stromsollwerts: Frequenz</translation>
    </message>
    <message>
        <source>Filter 2 of the current reference: quality factor</source>
        <translation>Filter 2 des Stromsollwerts: Güte</translation>
    </message>
    <message>
        <source>Filter 2 of the current reference: gain</source>
        <translation>Filter 2 des Stromsollwerts: Verstärkung</translation>
    </message>
    <message>
        <source>Velocity loop, acceleration feed-forward</source>
        <translation>Drehzahlregler, Beschleunigungsvorsteuerung</translation>
    </message>
    <message>
        <source>Position loop, velocity feed-forward</source>
        <translation>Positionsregler, Drehzahlvorsteuerung</translation>
    </message>
    <message>
        <source>Position loop, acceleration feed-forward</source>
        <translation>Positionsregler, Beschleunigungsvorsteuerung</translation>
    </message>
    <message>
        <source>Function of digital output 1</source>
        <translation>Funktion des Digitalausgangs 1</translation>
    </message>
    <message>
        <source>Function of digital output 2</source>
        <translation>Funktion des Digitalausgangs 2</translation>
    </message>
    <message>
        <source>Function of digital output 3</source>
        <translation>Funktion des Digitalausgangs 3</translation>
    </message>
    <message>
        <source>Function of digital output 4</source>
        <translation>Funktion des Digitalausgangs 4</translation>
    </message>
    <message>
        <source>Digital inputs, one bit each</source>
        <translation>Digitaleingänge, je ein Bit</translation>
    </message>
    <message>
        <source>Digital outputs as they are, one bit each</source>
        <translation>Digitalausgänge, wie sie sind, je ein Bit</translation>
    </message>
    <message>
        <source>Digital outputs wanted, one bit each</source>
        <translation>Gewünschte Digitalausgänge, je ein Bit</translation>
    </message>
    <message>
        <source>Polarity of the digital outputs</source>
        <translation>Polarität der Digitalausgänge</translation>
    </message>
    <message>
        <source>Input of the positive limit switch</source>
        <translation>Eingang des positiven Endschalters</translation>
    </message>
    <message>
        <source>Input of the negative limit switch</source>
        <translation>Eingang des negativen Endschalters</translation>
    </message>
    <message>
        <source>Input of the quick stop</source>
        <translation>Eingang des Schnellhalts</translation>
    </message>
    <message>
        <source>What a quick stop does</source>
        <translation>Was ein Schnellhalt bewirkt</translation>
    </message>
    <message>
        <source>What happens on position out of limits</source>
        <translation>Was geschieht, wenn die Position ihre Grenzen verlässt</translation>
    </message>
    <message>
        <source>What happens on velocity out of limits</source>
        <translation>Was geschieht, wenn die Drehzahl ihre Grenzen verlässt</translation>
    </message>
    <message>
        <source>What happens on a tracking error</source>
        <translation>Was bei einem Schleppfehler geschieht</translation>
    </message>
    <message>
        <source>What happens on power stage over-temperature</source>
        <translation>Was bei Übertemperatur des Leistungsteils geschieht</translation>
    </message>
    <message>
        <source>What happens on motor over-temperature</source>
        <translation>Was bei Übertemperatur des Motors geschieht</translation>
    </message>
    <message>
        <source>What happens on over-voltage</source>
        <translation>Was bei Überspannung geschieht</translation>
    </message>
    <message>
        <source>What happens on under-voltage</source>
        <translation>Was bei Unterspannung geschieht</translation>
    </message>
    <message>
        <source>What happens on over-current</source>
        <translation>Was bei Überstrom geschieht</translation>
    </message>
    <message>
        <source>User over-voltage limit</source>
        <translation>Überspannungsgrenze des Anwenders</translation>
    </message>
    <message>
        <source>User under-voltage limit</source>
        <translation>Unterspannungsgrenze des Anwenders</translation>
    </message>
    <message>
        <source>User over-temperature limit</source>
        <translation>Übertemperaturgrenze des Anwenders</translation>
    </message>
    <message>
        <source>User under-temperature limit</source>
        <translation>Untertemperaturgrenze des Anwenders</translation>
    </message>
    <message>
        <source>Communication state: 1 = config access, 2 = cyclic access</source>
        <translation>Zustand der Kommunikation: 1 = Konfigurationszugriff, 2 = zyklischer Zugriff</translation>
    </message>
    <message>
        <source>Synchronisation signal: 0 none, 1 SYNC0, 2 SYNC1, 3 both</source>
        <translation>Synchronisationssignal: 0 keines, 1 SYNC0, 2 SYNC1, 3 beide</translation>
    </message>
    <message>
        <source>Number of errors stored</source>
        <translation>Anzahl der gespeicherten Fehler</translation>
    </message>
    <message>
        <source>Index into the error list</source>
        <translation>Index in der Fehlerliste</translation>
    </message>
    <message>
        <source>Error code at that index</source>
        <translation>Fehlercode an diesem Index</translation>
    </message>
    <message>
        <source>Number of mapped registers from master to drive (0-15)</source>
        <translation>Anzahl der abgebildeten Register vom Master zum Antrieb (0-15)</translation>
    </message>
    <message>
        <source>Mapping entry 1 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 1 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 2 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 2 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 3 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 3 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 4 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 4 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 5 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 5 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 6 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 6 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 7 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 7 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 8 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 8 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 9 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 9 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 10 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 10 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 11 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 11 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 12 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 12 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 13 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 13 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 14 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 14 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 15 from master to drive: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 15 vom Master zum Antrieb: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Number of mapped registers from drive to master (0-15)</source>
        <translation>Anzahl der abgebildeten Register vom Antrieb zum Master (0-15)</translation>
    </message>
    <message>
        <source>Mapping entry 1 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 1 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 2 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 2 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 3 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 3 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 4 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 4 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 5 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 5 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 6 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 6 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 7 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 7 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 8 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 8 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 9 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 9 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 10 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 10 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 11 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 11 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 12 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 12 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 13 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 13 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 14 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 14 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Mapping entry 15 from drive to master: size in bytes in the upper word, address in the lower</source>
        <translation>Abbildungseintrag 15 vom Antrieb zum Master: Größe in Byte im oberen Wort, Adresse im unteren</translation>
    </message>
    <message>
        <source>Stores all settings when the right key is written</source>
        <translation>Speichert alle Einstellungen, wenn der richtige Schlüssel geschrieben wird</translation>
    </message>
    <message>
        <source>Restores default settings when the right key is written</source>
        <translation>Stellt die Voreinstellungen her, wenn der richtige Schlüssel geschrieben wird</translation>
    </message>
    <message>
        <source>Password for protected registers</source>
        <translation>Passwort für geschützte Register</translation>
    </message>
    <message>
        <source>Enters the boot loader</source>
        <translation>Startet den Bootloader</translation>
    </message>
    <message>
        <source>Resets the drive</source>
        <translation>Setzt den Antrieb zurück</translation>
    </message>
    <message>
        <source>Vendor id</source>
        <translation>Herstellernummer</translation>
    </message>
    <message>
        <source>Product code</source>
        <translation>Produktcode</translation>
    </message>
    <message>
        <source>Revision number</source>
        <translation>Revisionsnummer</translation>
    </message>
    <message>
        <source>Firmware version, text</source>
        <translation>Firmwareversion, Text</translation>
    </message>
    <message>
        <source>Web address of the maker, text</source>
        <translation>Webadresse des Herstellers, Text</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>PWM frequency choice 1</source>
        <translation>Wählbare PWM-Frequenz 1</translation>
    </message>
    <message>
        <source>PWM frequency choice 2</source>
        <translation>Wählbare PWM-Frequenz 2</translation>
    </message>
    <message>
        <source>PWM frequency choice 3</source>
        <translation>Wählbare PWM-Frequenz 3</translation>
    </message>
    <message>
        <source>PWM frequency choice 4</source>
        <translation>Wählbare PWM-Frequenz 4</translation>
    </message>
    <message>
        <source>Dead time of the power stage</source>
        <translation>Totzeit des Leistungsteils</translation>
    </message>
    <message>
        <source>Over-temperature limit of the maker</source>
        <translation>Übertemperaturgrenze des Herstellers</translation>
    </message>
    <message>
        <source>Under-temperature limit of the maker</source>
        <translation>Untertemperaturgrenze des Herstellers</translation>
    </message>
    <message>
        <source>Over-voltage limit of the maker</source>
        <translation>Überspannungsgrenze des Herstellers</translation>
    </message>
    <message>
        <source>Under-voltage limit of the maker</source>
        <translation>Unterspannungsgrenze des Herstellers</translation>
    </message>
    <message>
        <source>Highest continuous current of the drive</source>
        <translation>Höchster Dauerstrom des Antriebs</translation>
    </message>
    <message>
        <source>Highest peak current of the drive</source>
        <translation>Höchster Spitzenstrom des Antriebs</translation>
    </message>
    <message>
        <source>Current measuring range 1</source>
        <translation>Strommessbereich 1</translation>
    </message>
    <message>
        <source>Bus voltage measuring range</source>
        <translation>Messbereich der Zwischenkreisspannung</translation>
    </message>
    <message>
        <source>How safe torque off is built</source>
        <translation>Wie die sichere Momentenabschaltung (STO) ausgeführt ist</translation>
    </message>
    <message>
        <source>Input of the negative homing switch</source>
        <translation>Eingang des negativen Referenzschalters</translation>
    </message>
    <message>
        <source>Speed loop: proportional gain in s16A per unit of the speed, to be divided by SPEED_KP_DIV</source>
        <translation>Drehzahlregler: Proportionalverstärkung in s16A je Einheit der Drehzahl, durch SPEED_KP_DIV zu teilen</translation>
    </message>
    <message>
        <source>Speed loop: integral gain in s16A per unit of the speed, to be divided by SPEED_KI_DIV</source>
        <translation>Drehzahlregler: Integralverstärkung in s16A je Einheit der Drehzahl, durch SPEED_KI_DIV zu teilen</translation>
    </message>
    <message>
        <source>Speed loop: derivative gain in s16A per unit of the speed</source>
        <translation>Drehzahlregler: Differentialverstärkung in s16A je Einheit der Drehzahl</translation>
    </message>
</context>
<context>
    <name>RegisterValues</name>
    <message>
        <source>observing</source>
        <translation>beobachten</translation>
    </message>
    <message>
        <source>open-loop voltage</source>
        <translation>gesteuerte Spannung</translation>
    </message>
    <message>
        <source>open-loop current</source>
        <translation>gesteuerter Strom</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>profiling</source>
        <translation>Vermessung</translation>
    </message>
    <message>
        <source>shorted</source>
        <translation>kurzgeschlossen</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>Tastgrad</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>in Bewegung</translation>
    </message>
    <message>
        <source>target reached</source>
        <translation>Ziel erreicht</translation>
    </message>
    <message>
        <source>following</source>
        <translation>folgt</translation>
    </message>
    <message>
        <source>awaiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>aligning</source>
        <translation>richtet aus</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>absolute not supported</source>
        <translation>Absolutlage nicht unterstützt</translation>
    </message>
    <message>
        <source>absolute supported</source>
        <translation>Absolutlage unterstützt</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>centred</source>
        <translation>zentriert</translation>
    </message>
    <message>
        <source>shifted centre</source>
        <translation>verschobene Mitte</translation>
    </message>
    <message>
        <source>min-low</source>
        <translation>min-low</translation>
    </message>
    <message>
        <source>max-high</source>
        <translation>max-high</translation>
    </message>
    <message>
        <source>up-down</source>
        <translation>auf-ab</translation>
    </message>
    <message>
        <source>protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>potentiometer</source>
        <translation>Potentiometer</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ohne</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>start</source>
        <translation>starten</translation>
    </message>
    <message>
        <source>reset</source>
        <translation>zurücksetzen</translation>
    </message>
    <message>
        <source>software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>hardware</source>
        <translation>Hardware</translation>
    </message>
    <message>
        <source>software over-voltage</source>
        <translation>Überspannung (Software)</translation>
    </message>
    <message>
        <source>software over-current</source>
        <translation>Überstrom (Software)</translation>
    </message>
    <message>
        <source>mains frequency</source>
        <translation>Netzfrequenz</translation>
    </message>
    <message>
        <source>mains voltage</source>
        <translation>Netzspannung</translation>
    </message>
    <message>
        <source>DC resistance estimate</source>
        <translation>Schätzung des Gleichstromwiderstands</translation>
    </message>
    <message>
        <source>dynamic ZeST configuration</source>
        <translation>dynamische ZeST-Konfiguration</translation>
    </message>
    <message>
        <source>offset measurement</source>
        <translation>Offsetmessung</translation>
    </message>
    <message>
        <source>pole pulses</source>
        <translation>Polimpulse</translation>
    </message>
    <message>
        <source>fast DC resistance</source>
        <translation>schneller Gleichstromwiderstand</translation>
    </message>
    <message>
        <source>step 1</source>
        <translation>Schritt 1</translation>
    </message>
    <message>
        <source>step 2</source>
        <translation>Schritt 2</translation>
    </message>
    <message>
        <source>step 3</source>
        <translation>Schritt 3</translation>
    </message>
    <message>
        <source>step 4</source>
        <translation>Schritt 4</translation>
    </message>
    <message>
        <source>step 5</source>
        <translation>Schritt 5</translation>
    </message>
    <message>
        <source>step 6</source>
        <translation>Schritt 6</translation>
    </message>
    <message>
        <source>six-step</source>
        <translation>Blockkommutierung</translation>
    </message>
    <message>
        <source>observer + PLL</source>
        <translation>Beobachter + PLL</translation>
    </message>
    <message>
        <source>observer + CORDIC</source>
        <translation>Beobachter + CORDIC</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>Encoder</translation>
    </message>
    <message>
        <source>Hall</source>
        <translation>Hall</translation>
    </message>
    <message>
        <source>ZeST</source>
        <translation>ZeST</translation>
    </message>
    <message>
        <source>three shunts</source>
        <translation>drei Shunts</translation>
    </message>
    <message>
        <source>single shunt, active window</source>
        <translation>ein Shunt, aktives Fenster</translation>
    </message>
    <message>
        <source>single shunt, phase shift</source>
        <translation>ein Shunt, Phasenverschiebung</translation>
    </message>
    <message>
        <source>isolated sensors</source>
        <translation>isolierte Sensoren</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>flux weakening</source>
        <translation>Feldschwächung</translation>
    </message>
    <message>
        <source>feed forward</source>
        <translation>Vorsteuerung</translation>
    </message>
    <message>
        <source>inrush limiter</source>
        <translation>Einschaltstrombegrenzung</translation>
    </message>
    <message>
        <source>resistive brake</source>
        <translation>Bremswiderstand</translation>
    </message>
    <message>
        <source>over-current protection disable</source>
        <translation>Überstromschutz abschaltbar</translation>
    </message>
    <message>
        <source>STGAP drivers</source>
        <translation>STGAP-Treiber</translation>
    </message>
    <message>
        <source>position control</source>
        <translation>Positionsregelung</translation>
    </message>
    <message>
        <source>bus voltage sensing</source>
        <translation>Messung der Zwischenkreisspannung</translation>
    </message>
    <message>
        <source>temperature sensing</source>
        <translation>Temperaturmessung</translation>
    </message>
    <message>
        <source>phase voltage sensing</source>
        <translation>Messung der Strangspannungen</translation>
    </message>
    <message>
        <source>flash configuration</source>
        <translation>Konfiguration im Flash</translation>
    </message>
    <message>
        <source>DAC channel 1</source>
        <translation>DAC-Kanal 1</translation>
    </message>
    <message>
        <source>DAC channel 2</source>
        <translation>DAC-Kanal 2</translation>
    </message>
    <message>
        <source>on-the-fly start-up</source>
        <translation>Start bei drehendem Motor</translation>
    </message>
    <message>
        <source>over-modulation</source>
        <translation>Übermodulation</translation>
    </message>
    <message>
        <source>discontinuous PWM</source>
        <translation>diskontinuierliche PWM</translation>
    </message>
    <message>
        <source>quasi-synchronous</source>
        <translation>quasisynchron</translation>
    </message>
    <message>
        <source>IPD start-up</source>
        <translation>Anlauf mit IPD</translation>
    </message>
    <message>
        <source>current monitor</source>
        <translation>Stromüberwachung</translation>
    </message>
    <message>
        <source>profiler</source>
        <translation>Profiler</translation>
    </message>
    <message>
        <source>CPU load measurement</source>
        <translation>Messung der CPU-Last</translation>
    </message>
    <message>
        <source>open-loop debug</source>
        <translation>Fehlersuche im gesteuerten Betrieb</translation>
    </message>
</context>
</TS>
