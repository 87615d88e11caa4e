// The firmware's arithmetic and the simulated motors together, without a state machine: currents controlled in the
// angle that a sensor gives, speed held by a plain loop. What a sensor says is compared with the true rotor.
#include "simulation/maths/encoder_sensor.h"
#include "simulation/maths/gains.h"
#include "simulation/maths/hall_sensor.h"
#include "simulation/maths/sensorless.h"
#include "simulation/maths/transforms.h"
#include "simulation/maths/voltage.h"
#include "simulation/plant/plant.h"
#include "simulation/plant/presets.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace simulation;

namespace {

constexpr double kHf_hz = 16000.0;
constexpr std::uint16_t kTimerPeriod = 5312; // 170 MHz

CurrentSensing sensingOf(const InverterParameters &inverter)
{
    return {.bus_v = inverter.supply_v,
        .shunt_ohm = inverter.shunt_ohm,
        .amplifierGain = inverter.amplifierGain,
        .reference_v = inverter.converterReference_v};
}

ObserverPll::Parameters observerFor(const PlantParameters &p)
{
    const double max_radps = p.motor.maxSpeed_rpm * kTurn / 60.0 * p.motor.polePairs;
    const ObserverDesign design{.rs_ohm = p.motor.rs_ohm,
        .ls_h = p.motor.lq_h,
        .hfHz = kHf_hz,
        .maxCurrent_a = p.inverter.maxReadable_a(),
        .maxBemf_v = 1.2 * max_radps * p.motor.flux_wb,
        .maxVoltage_v = p.inverter.busRange_v / std::numbers::sqrt3};
    return {.observer = observerGains(design),
        .speed = {.polePairs = p.motor.polePairs,
            .maxReliable_dHz = static_cast<std::uint16_t>(1.15 * p.motor.maxSpeed_rpm / 6.0)},
        .pll = pllGains(960.0, 0.85, 27300.0, kHf_hz)};
}

HallSensor::Parameters hallFor(const PlantParameters &p)
{
    const double placed = std::remainder(p.sensors.hallPlacement_deg, 360.0);
    return {.polePairs = p.motor.polePairs,
        .phaseShift = static_cast<std::int16_t>(std::lround(placed * 65536.0 / 360.0))};
}

EncoderSensor::Parameters encoderFor(const PlantParameters &p)
{
    const int counts = std::max(4, 4 * p.sensors.encoderPulses);
    return {.countsPerTurn = counts, .counterRange = counts, .polePairs = p.motor.polePairs};
}

/// A drive that turns at one speed: half of what the motor is made for.
class Drive {
public:
    explicit Drive(const PlantParameters &parameters)
        : plant(parameters, 7)
        , observer(observerFor(parameters))
        , encoder(encoderFor(parameters))
        , hall(hallFor(parameters))
        , m_sensing(sensingOf(parameters.inverter))
        , m_q(currentGains(
              parameters.motor.lq_h, parameters.motor.rs_ohm, 1500.0, m_sensing, kHf_hz))
        , m_d(currentGains(
              parameters.motor.ld_h, parameters.motor.rs_ohm, 1500.0, m_sensing, kHf_hz))
        , m_speed_radps(0.5 * parameters.motor.maxSpeed_rpm * kTurn / 60.0)
    {
        plant.place(1.0, m_speed_radps);
        observer.setDirection(1);
        encoder.step(plant.encoderCount());
        encoder.align(trueAngle());
    }

    std::int16_t trueAngle() const
    {
        return wrapAngle(
            static_cast<std::int32_t>(std::lround(plant.angle_rad() * (65536.0 / kTurn))));
    }
    double degreesOff(std::int16_t angle) const
    {
        return wrapAngle(angle - trueAngle()) * (360.0 / 65536.0);
    }

    /// One control period with the currents turned by `angle`, valid at its end.
    template <class Angle>
    void step(Angle angle)
    {
        plant.advance(1.0 / kHf_hz);
        encoder.step(plant.encoderCount());
        const HallReading h = plant.hall();
        hall.step({h.code, h.edges, h.sinceEdge_s, h.lastPeriod_s});
        const AlphaBeta current = clarke({digits(plant.currentA()), digits(plant.currentB())});
        const Trig t = trig(angle());
        const Qd i = park(current, t);
        if (m_tick++ % 16 == 0)
            mediumTask();
        const Qd v = circleLimit({m_q.step(m_reference - i.q), m_d.step(-i.d)}, circleOf(31128));
        const AlphaBeta voltage = reversePark(v, t);
        const Duties duties = dutiesOf(modulate(voltage, kTimerPeriod), kTimerPeriod);
        plant.setBridge({.on = true, .a = duties.a, .b = duties.b, .c = duties.c});
        const double range = plant.parameters().inverter.busRange_v;
        observer.step({voltage, current,
            static_cast<std::uint16_t>(std::lround(plant.bus_v() / range * 65536.0))});
    }

    Plant plant;
    ObserverPll observer;
    EncoderSensor encoder;
    HallSensor hall;

private:
    static std::int16_t digits(std::uint16_t reading) { return saturate16(32768 - int{reading}); }
    void mediumTask()
    {
        observer.mediumTask();
        encoder.mediumTask();
        hall.mediumTask();
        const MotorParameters &m = plant.parameters().motor;
        const double error = m_speed_radps - plant.speed_radps();
        const double kp = m.inertia_kgm2 * 20.0 / (1.5 * m.polePairs * m.flux_wb);
        m_sum_a = std::clamp(m_sum_a + kp * 5.0 * error * 1e-3, -m.nominal_a, m.nominal_a);
        const double wanted = std::clamp(kp * error + m_sum_a, -m.nominal_a, m.nominal_a);
        m_reference = static_cast<std::int32_t>(std::lround(wanted * m_sensing.digitsPerAmp()));
    }

    CurrentSensing m_sensing;
    Pi m_q, m_d;
    double m_speed_radps;
    double m_sum_a = 0.0;
    std::int32_t m_reference = 0;
    int m_tick = 0;
};

void eachPreset()
{
    QTest::addColumn<QByteArray>("preset");
    for (const Preset &preset : presets()) {
        const QByteArray name(preset.name.data(), static_cast<qsizetype>(preset.name.size()));
        QTest::newRow(name.constData()) << name;
    }
}

} // namespace

class TestMathsPlant : public QObject {
    Q_OBJECT

private slots:
    void theObserverHoldsEveryMotorAtHalfSpeed_data() { eachPreset(); }
    void theObserverHoldsEveryMotorAtHalfSpeed();
    void theEncoderKnowsWhereTheServoIs();
    void theHallSensorsTurnTheBlower();
};

void TestMathsPlant::theObserverHoldsEveryMotorAtHalfSpeed()
{
    QFETCH(QByteArray, preset);
    const PlantParameters &parameters = *findPreset(preset.toStdString());
    Drive drive(parameters);
    for (int i = 0; i < 8000; ++i)
        drive.step([&] { return drive.trueAngle(); });
    double worst = 0.0;
    for (int i = 0; i < 16000; ++i) {
        drive.step([&] {
            worst = std::max(worst, std::abs(drive.degreesOff(drive.observer.angle())));
            return drive.observer.angle();
        });
    }
    QVERIFY2(worst < 3.0, QByteArray::number(worst).constData());
    QVERIFY(drive.observer.speed().reliable());
    const double speed_dHz = drive.plant.speed_radps() / kTurn * 10.0;
    QVERIFY(std::abs(speed_dHz * 12.0 / parameters.motor.maxSpeed_rpm - 1.0) < 0.02);
    QVERIFY(std::abs(drive.observer.speed_dHz() - speed_dHz) < 6.0);
}

void TestMathsPlant::theEncoderKnowsWhereTheServoIs()
{
    Drive drive(*findPreset("servo24"));
    double worst = 0.0;
    for (int i = 0; i < 16000; ++i) {
        drive.step([&] {
            worst = std::max(worst, std::abs(drive.degreesOff(drive.encoder.angle())));
            return drive.encoder.angle();
        });
    }
    QVERIFY2(worst < 1.0, QByteArray::number(worst).constData());
    QVERIFY(std::abs(drive.encoder.speed_dHz() - drive.plant.speed_radps() / kTurn * 10.0) < 3.0);
}

void TestMathsPlant::theHallSensorsTurnTheBlower()
{
    Drive drive(*findPreset("blower36"));
    for (int i = 0; i < 1600; ++i) // until its average is full
        drive.step([&] { return drive.trueAngle(); });
    double worst = 0.0;
    for (int i = 0; i < 16000; ++i) {
        drive.step([&] {
            worst = std::max(worst, std::abs(drive.degreesOff(drive.hall.angle())));
            return drive.hall.angle();
        });
    }
    QVERIFY2(worst < 6.0, QByteArray::number(worst).constData());
    QVERIFY(drive.hall.reliable());
    QVERIFY(std::abs(drive.hall.speed_dHz() - drive.plant.speed_radps() / kTurn * 10.0) < 6.0);
}

QTEST_APPLESS_MAIN(TestMathsPlant)
#include "tst_maths_plant.moc"
