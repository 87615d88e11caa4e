// The scalar registers of the standard family: FOC and six-step. The comments name them as the protocol does where the
// variable does not.
// Source: registers.csv (element, type, access, build, version) and mcp-aspep facts 5 and 9.
#include "simulation/mcp/register_table.h"

#include <array>

namespace simulation {

namespace {

using Row = RegisterRow;
using enum mcp::RegisterType;
using enum RegisterRow::Scope;
using mcp::Status;
using At = const RegisterContext;

// Builds --------------------------------------------------------------------------------------------------------------

constexpr bool foc(const Build &b) { return !b.sixStep(); }
constexpr bool pll(const Build &b) { return b.observerPll; }
constexpr bool cordic(const Build &b) { return b.observerCordic; }
constexpr bool encoder(const Build &b) { return b.encoder; }
constexpr bool hall(const Build &b) { return b.hall && foc(b); }
constexpr bool startsSensorless(const Build &b)
{
    return b.observerPll || b.observerCordic || (b.sixStep() && b.bemfSensing);
}
constexpr bool fluxWeakening(const Build &b) { return b.fluxWeakening; }
constexpr bool feedForward(const Build &b) { return b.feedForward; }
constexpr bool position(const Build &b) { return b.positionControl; }
constexpr bool focOpenLoop(const Build &b) { return foc(b) && b.openLoopDebug; }
constexpr bool profiler(const Build &b) { return foc(b) && b.profiler; }
constexpr bool hallTuning(const Build &b)
{
    return profiler(b) && b.auxiliarySensor == SpeedSensor::Hall;
}
constexpr bool cpuLoad(const Build &b) { return b.cpuLoad; }
constexpr bool dac(const Build &b) { return b.dac; }
constexpr bool pfc(const Build &b) { return b.pfc; }
constexpr bool sixStep(const Build &b) { return b.sixStep(); }
constexpr bool sixStepOpenLoop(const Build &b) { return b.sixStep() && b.openLoopDebug; }
constexpr bool ipd(const Build &b) { return b.ipd; }
constexpr bool currentMonitor(const Build &b) { return b.currentMonitor; }
constexpr bool noFluxWeakening(const Build &b) { return foc(b) && !b.fluxWeakening; }
constexpr bool sensorlessFoc(const Build &b) { return foc(b) && b.sensorless(); }

// What is more than a variable ----------------------------------------------------------------------------------------

Status setControlMode(RegisterContext &at, std::uint32_t value)
{
    if (at.build.sixStep() && !at.build.openLoopDebug)
        return Status::UnknownRegister;
    at.firmware.setControlMode(static_cast<std::uint8_t>(value));
    return Status::Ok;
}

Status setSpeedReference(RegisterContext &at, std::uint32_t value)
{
    at.firmware.rampSpeed({static_cast<std::int16_t>(value), 0}); // the firmware cuts it to 16 bits
    return Status::Ok;
}

Status setIq(RegisterContext &at, std::uint32_t value)
{
    at.firmware.setCurrentReferences(
        static_cast<std::int16_t>(value), at.firmware.variables().iDRef);
    return Status::Ok;
}

Status setId(RegisterContext &at, std::uint32_t value)
{
    at.firmware.setCurrentReferences(
        at.firmware.variables().iQRef, static_cast<std::int16_t>(value));
    return Status::Ok;
}

/// SC_CURRENT: only while nothing runs.
Status setProfilerCurrent(RegisterContext &at, std::uint32_t value)
{
    if (at.firmware.state() != MotorState::Idle)
        return Status::ReadOnly;
    at.firmware.commissioning().current_a = fromWire<float>(value);
    return Status::Ok;
}

/// Registers whose writes keep 8 of their 16 bits.
constexpr std::uint32_t kLowByte = 0xFF;
Status keepLowByte(RegisterContext &at, mcp::RegisterId id, std::uint32_t value)
{
    at.kept[id.bits] = value & kLowByte;
    return Status::Ok;
}

template <unsigned Element>
constexpr Row keptByte()
{
    return kept(Element, Bits16).settable([](RegisterContext &at, std::uint32_t value) {
        return keepLowByte(at, mcp::registerId(Element, Bits16, 0), value);
    });
}

constexpr Row pfcStub(unsigned element, mcp::RegisterType type = Bits16)
{
    return stub(element, type).in(pfc).at(Board);
}

// The table -----------------------------------------------------------------------------------------------------------

constexpr std::array kBytes{
    computed(1, Bits8, [](At &at) { return asWire(at.firmware.state()); })
        .refusesAnywhere(), // STATUS
    computed(2, Bits8, [](At &at) { return asWire(at.firmware.controlMode()); })
        .settable(setControlMode),
    computed(
        3, Bits8, [](At &) { return asWire(static_cast<std::uint8_t>(Firmware::kRevUpStages)); })
        .in(startsSensorless), // RUC_STAGE_NBR
    computed(13, Bits8, [](At &) { return 0U; }).in(pfc).at(Board), // PFC_STATUS
    pfcStub(14, Bits8), // PFC_ENABLED
    computed(15, Bits8, [](At &) { return 1U; }).in(profiler), // SC_CHECK
    measured<&Commissioning::state>(16).in(profiler),
    measured<&Commissioning::steps>(17).in(profiler),
    setting<&Commissioning::polePairs>(18).in(profiler),
    measured<&Commissioning::focRate>(19).in(profiler),
    measured<&Commissioning::completed>(20).in(profiler),
    measured<&Signals::positionState>(21).in(position),
    measured<&Signals::alignState>(22).in(position),
    computed(23, Bits8, [](At &) { return 0U; }).in(hallTuning).silent(), // HT_STATE
    computed(24, Bits8, [](At &) { return 0U; }).in(hallTuning).silent(), // HT_PROGRESS
    computed(25, Bits8, [](At &) { return 0U; }).in(hallTuning).silent(), // HT_PLACEMENT: unknown
    writeOnly(26, Bits8).in(hallTuning), // HT_MECH_WANTED_DIRECTION
    kept(27, Bits8).in(sixStep), // LOWSIDE_MODULATION; FAST_DEMAG up to 6.2
    kept(28, Bits8).in(sixStep), // QUASI_SYNCH
    writeOnly(29, Bits8).in(profiler).from(0x060200), // PB_CHARACTERIZATION
    kept(30, Bits8).in(sixStepOpenLoop).from(0x060300), // OPENLOOP_DC
    kept(31, Bits8, 1).in(sixStepOpenLoop).from(0x060400), // OPENLOOP_DC_FILTER
    kept(32, Bits8).in(sixStepOpenLoop).from(0x060300), // OPENLOOP
    kept(33, Bits8).in(sixStepOpenLoop).from(0x060300), // OPENLOOP_REVUP
    kept(34, Bits8).in(sixStepOpenLoop).from(0x060300), // OPENLOOP_VOLTFACTOR
    kept(35, Bits8).in(sixStepOpenLoop).from(0x060300), // OPENLOOP_SENSING
    kept(36, Bits8).in(ipd).from(0x060400), // IPD_ENABLE
    kept(37, Bits8).in(ipd).from(0x060400), // IPD_DEBUG
};

constexpr std::array kWords{
    setting<&Tuning::speedKp>(2), setting<&Tuning::speedKi>(3), setting<&Tuning::speedKd>(4),
    setting<&Tuning::qKp>(6).in(foc), setting<&Tuning::qKi>(7).in(foc),
    setting<&Tuning::qKd>(8).in(foc), setting<&Tuning::dKp>(10).in(foc),
    setting<&Tuning::dKi>(11).in(foc), setting<&Tuning::dKd>(12).in(foc),
    setting<&Tuning::pllC1>(13).in(pll), setting<&Tuning::pllC2>(14).in(pll),
    setting<&Tuning::cordicC1>(15).in(cordic), setting<&Tuning::cordicC2>(16).in(cordic),
    setting<&Tuning::pllKi>(17).in(pll), setting<&Tuning::pllKp>(18).in(pll),
    setting<&Tuning::fluxKp>(19).in(fluxWeakening), setting<&Tuning::fluxKi>(20).in(fluxWeakening),
    setting<&Tuning::fluxBus>(21).in(fluxWeakening),
    measured<&Signals::busVoltage_v>(22).refusesAnywhere(),
    measured<&Signals::temperature_c>(23).refusesAnywhere(),
    kept(25, Bits16).in(dac).at(Board), // DAC_OUT1
    kept(26, Bits16).in(dac).at(Board), // DAC_OUT2
    measured<&Signals::fluxWeakeningBus>(30).in(fluxWeakening),
    onlyRefused(30, Bits16).in(noFluxWeakening), measured<&Signals::iA>(31).in(foc).forDatalog(),
    measured<&Signals::iB>(32).in(foc).forDatalog(),
    measured<&Signals::iAlpha>(33).in(foc).forDatalog(),
    measured<&Signals::iBeta>(34).in(foc).forDatalog(),
    measured<&Signals::iQ>(35).in(foc).forDatalog(),
    measured<&Signals::iD>(36).in(foc).forDatalog(),
    measured<&Signals::iQRef>(37).in(foc).forDatalog().settable(setIq),
    measured<&Signals::iDRef>(38).in(foc).forDatalog().settable(setId),
    measured<&Signals::vQ>(39).in(foc).forDatalog(),
    measured<&Signals::vD>(40).in(foc).forDatalog(),
    measured<&Signals::vAlpha>(41).in(foc).forDatalog(),
    measured<&Signals::vBeta>(42).in(foc).forDatalog(),
    measured<&Signals::encoderAngle>(43).in(encoder).forDatalog(),
    measured<&Signals::encoderSpeed>(44).in(encoder).ofSpeed(),
    measured<&Signals::pllAngle>(45).in(pll).forDatalog(),
    measured<&Signals::pllSpeed>(46).in(pll).ofSpeed(), measured<&Signals::pllIAlpha>(47).in(pll),
    measured<&Signals::pllIBeta>(48).in(pll),
    measured<&Signals::pllBemfAlpha>(49).in(pll).forDatalog(),
    measured<&Signals::pllBemfBeta>(50).in(pll).forDatalog(),
    measured<&Signals::cordicAngle>(51).in(cordic).forDatalog(),
    measured<&Signals::cordicSpeed>(52).in(cordic).ofSpeed(),
    measured<&Signals::cordicIAlpha>(53).in(cordic), measured<&Signals::cordicIBeta>(54).in(cordic),
    measured<&Signals::cordicBemfAlpha>(55).in(cordic).forDatalog(),
    measured<&Signals::cordicBemfBeta>(56).in(cordic).forDatalog(),
    stub(57, Bits16).at(Both), // DAC_USER1
    stub(58, Bits16).at(Both), // DAC_USER2
    measured<&Signals::hallAngle>(59).in(hall).forDatalog(),
    measured<&Signals::hallSpeed>(60).in(hall).ofSpeed(),
    measured<&Signals::ffVq>(62).in(feedForward), measured<&Signals::ffVd>(63).in(feedForward),
    measured<&Signals::ffVqPi>(64).in(feedForward), measured<&Signals::ffVdPi>(65).in(feedForward),
    pfcStub(66), // PFC_DCBUS_REF and on to PFC_STARTUP_DURATION
    pfcStub(67), pfcStub(68), pfcStub(69), pfcStub(70), pfcStub(71), pfcStub(72), pfcStub(73),
    pfcStub(74), pfcStub(75), pfcStub(76), measured<&Commissioning::pwm_hz>(77).in(profiler),
    setting<&Tuning::positionKp>(78).in(position), setting<&Tuning::positionKi>(79).in(position),
    setting<&Tuning::positionKd>(80).in(position), setting<&Tuning::speedKpDiv>(81),
    setting<&Tuning::speedKiDiv>(82), setting<&Tuning::speedKdDiv>(83),
    setting<&Tuning::dKpDiv>(84).in(foc), setting<&Tuning::dKiDiv>(85).in(foc),
    setting<&Tuning::dKdDiv>(86).in(foc), setting<&Tuning::qKpDiv>(87).in(foc),
    setting<&Tuning::qKiDiv>(88).in(foc), setting<&Tuning::qKdDiv>(89).in(foc),
    setting<&Tuning::positionKpDiv>(90).in(position),
    setting<&Tuning::positionKiDiv>(91).in(position),
    setting<&Tuning::positionKdDiv>(92).in(position),
    pfcStub(93), // PFC_I_KP_DIV and on to PFC_V_KD_DIV
    pfcStub(94), pfcStub(95), pfcStub(96), pfcStub(97), pfcStub(98),
    setting<&Tuning::pllKiDiv>(99).in(pll), setting<&Tuning::pllKpDiv>(100).in(pll),
    setting<&Tuning::fluxKpDiv>(101).in(fluxWeakening),
    setting<&Tuning::fluxKiDiv>(102).in(fluxWeakening),
    kept(106, Bits16).in(sixStep).upTo(0x060401), // PULSE_VALUE
    onlyRefused(106, Bits16).in(sensorlessFoc).from(0x060200).upTo(0x060401),
    setting<&Tuning::openLoopVq>(107).in(focOpenLoop), // FOC_VQREF; FOC_VDREF up to 6.1
    keptByte<108>().in(sixStepOpenLoop).from(0x060300), // OPENLOOP_CURRFACTOR
    onlyRefused(108, Bits16).in(sensorlessFoc).from(0x060200).upTo(0x0602FF),
    onlyRefused(109, Bits16).in(sensorlessFoc).from(0x060200).upTo(0x0602FF),
    onlyRefused(110, Bits16).in(sensorlessFoc).from(0x060200).upTo(0x0602FF),
    onlyRefused(111, Bits16).in(sensorlessFoc).from(0x060200).upTo(0x0602FF),
    computed(109, Bits16, [](At &) { return 0U; })
        .in(currentMonitor)
        .from(0x060400), // CURR_MONITOR
    kept(110, Bits16).in(currentMonitor).from(0x060400), // CURR_MONITOR_SAMPL_NS
    keptByte<111>().in(currentMonitor).from(0x060400), // CURR_MONITOR_AVG
    setting<&Tuning::overVoltage_v>(112).in(profiler).from(0x060102),
    setting<&Tuning::underVoltage_v>(113).in(profiler).from(0x060102),
    keptByte<114>().in(ipd).from(0x060400), // IPD_VSTR
    measured<&Signals::openLoopAngle>(115).in(foc).from(0x060400).onlyForDatalog(),
    keptByte<116>().in(ipd).from(0x060400), // IPD_VSTPTR
};

constexpr std::array kLongs{
    computed(0, Bits32, [](At &at) { return at.firmware.faultFlags(); })
        .refusesAnywhere(), // FAULTS_FLAGS
    computed(1, Bits32, [](At &at) { return asWire(at.firmware.speed_rpm()); }), // SPEED_MEAS
    computed(2, Bits32, [](At &at) { return asWire(at.firmware.speedReference_rpm()); })
        .settable(setSpeedReference), // SPEED_REF
    measured<&Signals::pllEstimatedBemf>(3).in(pll),
    measured<&Signals::pllObservedBemf>(4).in(pll),
    measured<&Signals::cordicEstimatedBemf>(5).in(cordic),
    measured<&Signals::cordicObservedBemf>(6).in(cordic),
    setting<&Tuning::ff1Q>(7).in(feedForward),
    setting<&Tuning::ff1D>(8).in(feedForward),
    setting<&Tuning::ff2>(9).in(feedForward),
    pfcStub(40, Bits32), // PFC_FAULTS
    measured<&Signals::position_rad>(41).in(position),
    measured<&Signals::cpuLoad>(88).in(cpuLoad).at(Board).from(0x060200).silent(),
    measured<&Signals::cpuLoadMin>(89).in(cpuLoad).at(Board).from(0x060200).silent(),
    measured<&Signals::cpuLoadMax>(90).in(cpuLoad).at(Board).from(0x060200).silent(),
    measured<&Commissioning::rs_ohm>(91).in(profiler),
    measured<&Commissioning::ls_h>(92).in(profiler),
    measured<&Commissioning::ke_vrmsPerKrpm>(93).in(profiler),
    measured<&Commissioning::bus_v>(94).in(profiler),
    measured<&Commissioning::speed_rpm>(95).in(profiler),
    measured<&Commissioning::current_a>(96).in(profiler).settable(setProfilerCurrent),
    setting<&Commissioning::speedBandwidth_radps>(97).in(profiler),
    setting<&Commissioning::ldLqRatio>(98).in(profiler),
    setting<&Commissioning::nominalSpeed_rpm>(99).in(profiler),
    setting<&Commissioning::currentBandwidth_radps>(100).in(profiler),
    measured<&Commissioning::inertia_kgm2>(101).in(profiler),
    measured<&Commissioning::friction_nms>(102).in(profiler),
    measured<&Commissioning::startUp_a>(103).in(profiler),
    measured<&Commissioning::startUpSpeed_rpm>(104).in(profiler),
    measured<&Commissioning::startUpAcceleration_rpmps>(105).in(profiler),
    computed(109, Bits32, [](At &at) { return asWire(static_cast<float>(at.firmware.power_w())); })
        .in(foc)
        .silent(), // MOTOR_POWER: the firmware lists it in the wrong switch
    setting<&Commissioning::resistorOffset_ohm>(116).in(profiler).from(0x060200),
};

} // namespace

std::span<const RegisterRow> standardRegisters()
{
    static constexpr auto kAll = [] {
        std::array<RegisterRow, kBytes.size() + kWords.size() + kLongs.size()> all{};
        std::size_t at = 0;
        for (const Row &row : kBytes)
            all[at++] = row;
        for (const Row &row : kWords)
            all[at++] = row;
        for (const Row &row : kLongs)
            all[at++] = row;
        return all;
    }();
    return kAll;
}

const RegisterRow *findRegister(mcp::RegisterId id, const Traits &traits, const Build &build)
{
    for (const RegisterRow &row : build.hso() ? hsoRegisters() : standardRegisters()) {
        if (row.id == id.withMotor(0) && traits.registerVersion >= row.first
            && traits.registerVersion <= row.last && (row.exists == nullptr || row.exists(build)))
            return &row;
    }
    return nullptr;
}

} // namespace simulation
