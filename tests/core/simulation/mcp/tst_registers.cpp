// Every register of the list, on every profile and on builds with every option: what GET and SET must answer. The list
// is the one that the Controller uses, resources/registers/mcp.csv; what its words mean on the wire stands here.
#include "catalog/catalog.h"
#include "catalog/csv.h"
#include "mcp/structures.h"
#include "simulation/plant/presets.h"
#include "support/board_bench.h"

#include <QTest>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

using namespace support;
using mcp::Status;
using simulation::Build;
using simulation::Family;
using simulation::SpeedSensor;

namespace {

constexpr std::string_view kProfiler = "profiler build (FOC, G4/F4 class MCU)";

using Predicate = std::function<bool(const Build &)>;

bool foc(const Build &b) { return b.family == Family::Foc; }
bool six(const Build &b) { return b.family == Family::SixStep; }

/// The words of the column available_when. A register with other words fails the test.
const std::map<std::string_view, Predicate> &conditions()
{
    const auto always = [](const Build &) { return true; };
    const auto never = [](const Build &) { return false; };
    const auto sensorless = [](const Build &b) {
        return (foc(b) && (b.observerPll || b.observerCordic)) || (six(b) && b.bemfSensing);
    };
    static const std::map<std::string_view, Predicate> kConditions{
        {"always", always},
        {"always (6.2+)", always},
        {"always (not ACIM V/f or IFOC)", always},
        {"always (value meaningful only with a sensor)", always},
        {"GET always; SET in FOC/ACIM; in six-step SET exists only with open-loop debug", always},
        {"never", never},
        {"FOC", foc},
        {"FOC or ACIM", foc},
        {"FOC or ACIM with state-observer FOC", foc},
        {"FOC with open-loop debug", [](const Build &b) { return foc(b) && b.openLoopDebug; }},
        {"FOC + position control enabled", [](const Build &b) { return b.positionControl; }},
        {"position control enabled", [](const Build &b) { return b.positionControl; }},
        {"CPU load measurement enabled (MCU with cycle counter)",
            [](const Build &b) { return b.cpuLoad; }},
        {"CPU load measurement enabled", [](const Build &b) { return b.cpuLoad; }},
        {"DAC debug enabled", [](const Build &b) { return b.dac; }},
        {"PFC enabled (never functional)", [](const Build &b) { return b.pfc; }},
        {"Hall sensors present, not six-step", [](const Build &b) { return b.hall; }},
        {"encoder present", [](const Build &b) { return b.encoder; }},
        {"feed-forward enabled", [](const Build &b) { return b.feedForward; }},
        {"flux weakening enabled", [](const Build &b) { return b.fluxWeakening; }},
        {"state observer + PLL present", [](const Build &b) { return b.observerPll; }},
        {"state observer + CORDIC present", [](const Build &b) { return b.observerCordic; }},
        {"sensorless start-up", sensorless},
        {"sensorless start-up (PLL, CORDIC or six-step sensorless ADC)", sensorless},
        {kProfiler, [](const Build &b) { return b.profiler; }},
        {"profiler build with Hall auxiliary sensor",
            [](const Build &b) { return b.profiler && b.auxiliarySensor == SpeedSensor::Hall; }},
        {"datalog enabled on this link; never in six-step", [](const Build &b) { return !six(b); }},
        {"datalog enabled on this link", always},
        {"datalog over ST-LINK enabled", never},
        {"six-step", six},
        {"six-step sensorless", [](const Build &b) { return six(b) && b.bemfSensing; }},
        {"six-step sensorless ADC", [](const Build &b) { return six(b) && b.bemfSensing; }},
        {"six-step with IPD start-up", [](const Build &b) { return b.ipd; }},
        {"six-step with current monitor", [](const Build &b) { return b.currentMonitor; }},
        {"six-step with open-loop debug", [](const Build &b) { return six(b) && b.openLoopDebug; }},
        {"six-step with open-loop debug, ADC sensing",
            [](const Build &b) { return six(b) && b.openLoopDebug; }},
        {"HSO/ZeST build", always},
        {"HSO profiler build", [](const Build &b) { return b.profiler; }},
        {"ZeST build", [](const Build &b) { return b.zest; }},
        {"ZeST build on a TxZ part", never},
        {"potentiometer enabled", [](const Build &b) { return b.potentiometer; }},
    };
    return kConditions;
}

struct Listed {
    std::string name, access, scope, when, description, since, until, format;
    mcp::RegisterId id;

    bool says(std::string_view words) const { return description.find(words) != std::string::npos; }
};

/// "6.1.2" as 0x060102; a last version without a patch includes all of them.
std::uint32_t version(const std::string &text, std::uint32_t missing)
{
    std::uint32_t value = 0;
    int parts = 0;
    for (std::size_t at = 0; at < text.size(); at += 2, ++parts)
        value = value << 8 | static_cast<std::uint32_t>(text[at] - '0');
    for (; parts < 3; ++parts)
        value = value << 8 | missing;
    return value;
}

std::vector<Listed> listed(std::string_view family, std::uint32_t sdk)
{
    const auto rows = catalog::readCsv(catalog::builtInTable("mcp"));
    if (!rows)
        return {};
    std::map<std::string, std::size_t> column;
    for (std::size_t i = 0; i < rows->front().fields.size(); ++i)
        column[rows->front().fields[i]] = i;
    std::vector<Listed> list;
    for (auto row = rows->begin() + 1; row != rows->end(); ++row) {
        const auto field = [&](const char *name) { return row->fields.at(column.at(name)); };
        if (field("family") != family || version(field("since"), 0) > sdk
            || (!field("until").empty() && version(field("until"), 0xFF) < sdk))
            continue;
        list.push_back({field("name"), field("access"), field("scope"), field("available_when"),
            field("description"), field("since"), field("until"), field("format"),
            {static_cast<std::uint16_t>(
                QByteArray::fromStdString(field("id_hex")).toUInt(nullptr, 16))}});
    }
    return list;
}

bool isRaw(mcp::RegisterId id) { return id.type() == 5; }
bool isText(mcp::RegisterId id) { return id.type() == 4; }
bool isDatalog(mcp::RegisterId id) { return isRaw(id) && id.element() >= 20 && id.element() <= 22; }

/// Bytes of a structure in GET; 0: not said here.
std::size_t structureSize(const Listed &reg, const Build &build, std::uint32_t sdk, bool asPrinted)
{
    if (reg.name == "TORQUE_RAMP")
        return asPrinted ? 6 : 4;
    if (reg.name == "APPLICATION_CONFIG")
        return sdk < 0x060200 ? 14 : 16;
    if (reg.name == "FOCFW_CONFIG")
        return six(build) ? 13 : 14;
    static const std::map<std::string_view, std::size_t> kSizes{{"GLOBAL_CONFIG", 10},
        {"MOTOR_CONFIG", 60}, {"SCALE_CONFIG", 12}, {"SPEED_RAMP", 6}, {"CURRENT_REF", 4},
        {"POSITION_RAMP", 8}, {"REVUP_DATA", 40}, {"BEMF_ADC_CONF", 26}, {"HT_HEW_PINS", 4},
        {"HT_CONNECTED_PINS", 4}, {"HT_PHASE_SHIFT", 28}, {"ADC_OFFSET", 24}};
    const auto found = kSizes.find(reg.name);
    return found == kSizes.end() ? 0 : found->second;
}

Status expectedRead(const Listed &reg, bool exists)
{
    if (!exists || reg.access == "none" || reg.access == "datalog-only" || reg.access == "setnoop")
        return Status::UnknownRegister;
    if (reg.access == "W")
        return reg.says("GET answers WO_REG") ? Status::WriteOnly : Status::UnknownRegister;
    if (reg.name == "ADC_OFFSET")
        return Status::RegisterAccess; // not calibrated before the first start
    return Status::Ok;
}

/// What SET refuses as read-only although this build lacks it, as shipped firmware does.
bool refusedThough(const Listed &reg, const Build &build, std::uint32_t sdk)
{
    if (!foc(build))
        return false;
    const bool observed = build.mainSensor == SpeedSensor::ObserverPll
        || build.mainSensor == SpeedSensor::ObserverCordic;
    const bool ofSixStep = reg.name == "PULSE_VALUE" || reg.name == "BEMF_ZCR"
        || reg.name == "BEMF_U" || reg.name == "BEMF_V" || reg.name == "BEMF_W";
    return reg.name == "FLUXWK_BUS_MEAS" || (ofSixStep && observed && sdk >= 0x060200);
}

/// What SET refuses as read-only for other motor bits, too.
bool refusedAnywhere(const Listed &reg, const Build &build, bool asPrinted)
{
    static const std::set<std::string_view> kNames{"STATUS", "BUS_VOLTAGE", "HEATS_TEMP",
        "FAULTS_FLAGS", "GLOBAL_CONFIG", "MOTOR_CONFIG", "APPLICATION_CONFIG", "FOCFW_CONFIG"};
    return kNames.contains(reg.name) && !build.hso() && !asPrinted;
}

Status expectedWrite(const Listed &reg, bool exists, const Build &build, std::uint32_t sdk)
{
    if (isText(reg.id))
        return Status::ReadOnly;
    if (!exists && refusedThough(reg, build, sdk))
        return Status::ReadOnly;
    if (!build.hso() && (reg.name.starts_with("HT_") || reg.name.starts_with("PERF_"))
        && reg.access == "R")
        return Status::UnknownRegister;
    if (!exists || reg.access == "none" || reg.access == "datalog-only")
        return Status::UnknownRegister;
    if (reg.access == "RW" || reg.access == "W" || reg.access == "stub"
        || reg.access.ends_with("setnoop") || reg.says("SET answers OK"))
        return reg.name == "CONTROL_MODE" && six(build) && !build.openLoopDebug
            ? Status::UnknownRegister
            : Status::Ok;
    if (reg.name == "FOC_VDREF") // listed as readable: not meant to be written
        return Status::Ok;
    const bool unknown = reg.name == "SCALE_CONFIG" || reg.says("SET is UNKNOWN_REG")
        || reg.says("SET is answered UNKNOWN_REG");
    return unknown ? Status::UnknownRegister : Status::ReadOnly;
}

Bytes readRequest(mcp::RegisterId id) { return ByteWriter().u16(2U << 3).u16(id.bits).take(); }

Bytes writeRequest(mcp::RegisterId id, std::size_t structure)
{
    ByteWriter out;
    out.u16(1U << 3).u16(id.bits);
    if (isText(id))
        return out.u8(0).take();
    if (isDatalog(id)) // a stop
        return out.u16(7).u16(0).u32(0).u8(0).take();
    if (isRaw(id)) {
        out.u16(static_cast<std::uint32_t>(structure));
        return out.bytes(Bytes(structure)).take();
    }
    return out.bytes(Bytes(mcp::scalarWidth(id.type()))).take();
}

/// Whatever FOC can have at once.
Build everything()
{
    Build b;
    b.observerPll = b.observerCordic = b.encoder = b.hall = true;
    b.auxiliarySensor = SpeedSensor::Hall;
    b.fluxWeakening = b.feedForward = b.mtpa = b.positionControl = b.openLoopDebug = true;
    b.profiler = b.cpuLoad = b.dac = b.pfc = true;
    return b;
}

Build everySixStep()
{
    Build b = simulation::buildFor("six-step", "");
    b.openLoopDebug = b.cpuLoad = b.dac = b.ipd = b.currentMonitor = true;
    return b;
}

Build everyHso()
{
    Build b = simulation::buildFor("hso", "");
    b.mainSensor = SpeedSensor::Zest;
    b.profiler = b.cpuLoad = b.dac = b.zest = b.potentiometer = true;
    return b;
}

std::string wrong(const Listed &reg, const char *what, Status expected, const Bytes &answer)
{
    return reg.name + ' ' + what + ": expected " + std::to_string(static_cast<int>(expected))
        + ", got " + (answer.empty() ? "nothing" : std::to_string(answer.back())) + " in "
        + std::to_string(answer.size()) + " bytes";
}

} // namespace

Q_DECLARE_METATYPE(simulation::Build)

class TestRegisters : public QObject {
    Q_OBJECT

private slots:
    void everyRegisterAnswersAsListed_data();
    void everyRegisterAnswersAsListed();
    void whatIsNotListedIsUnknown_data() { everyRegisterAnswersAsListed_data(); }
    void whatIsNotListedIsUnknown();
    void whatIsWrittenReadsBack();
    void theSecondMotorHasItsOwnValues();
    void singleMotorFirmwareBefore62IgnoresTheMotor();
    void positionRampsReadBackSwappedUpTo62();
    void sensorSpeedsAreFractionsUpTo63();
    void startTogglesAnswerByVersion();
    void commandsCameWithVersionsAndBuilds();
    void theLoadOfTheProcessorIsShownAndCleared();
    void eachOptionBringsItsRegister();
    void aSensorAloneHasNoObserverBesideIt();
    void sensorsAreSwitchedWithinTheMarginOnly();
    void profilerBuildsShowWhatTheyWereGiven();
    void stagesAreKeptInTenthsOfAHertz();
    void theStructuresTellTheMotor();
};

void TestRegisters::everyRegisterAnswersAsListed_data()
{
    QTest::addColumn<QString>("profile");
    QTest::addColumn<std::uint32_t>("sdk");
    QTest::addColumn<Build>("build");
    const std::vector<std::pair<const char *, std::uint32_t>> profiles{{"mcsdk-6.0", 0x060000},
        {"mcsdk-6.1", 0x060100}, {"mcsdk-6.2", 0x060200}, {"mcsdk-6.3", 0x060302},
        {"mcsdk-6.4", 0x060400}, {"six-step", 0x060402}, {"hso", 0x060402}, {"spec", 0x060100}};
    for (const auto &[profile, sdk] : profiles) {
        const Build plain = simulation::buildFor(profile, "");
        QTest::addRow("%s", profile) << profile << sdk << plain;
        if (foc(plain))
            QTest::addRow("%s, everything", profile) << profile << sdk << everything();
    }
    QTest::addRow("six-step, everything") << "six-step" << 0x060402U << everySixStep();
    QTest::addRow("hso, everything") << "hso" << 0x060402U << everyHso();
}

void TestRegisters::everyRegisterAnswersAsListed()
{
    QFETCH(QString, profile);
    QFETCH(std::uint32_t, sdk);
    QFETCH(Build, build);
    BoardOptions options;
    options.profile = profile.toStdString();
    options.build = build;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    const auto list = listed(build.hso() ? "hso" : "std", sdk);
    QVERIFY(list.size() > 100);
    for (const Listed &reg : list) {
        const auto condition = conditions().find(reg.when);
        QVERIFY2(condition != conditions().end(), reg.when.c_str());
        const bool ours = !isDatalog(reg.id) || reg.id.element() == 20; // UART A is the link
        const bool exists = condition->second(build) && ours;
        const bool board = reg.scope.starts_with("global");
        const mcp::RegisterId id = reg.id.withMotor(board ? 0 : 1);
        const std::size_t structure = structureSize(reg, build, sdk, profile == "spec");

        const Status read = expectedRead(reg, exists);
        Bytes answer = bench.ask(readRequest(id));
        QVERIFY2(!answer.empty() && answer.back() == static_cast<std::uint8_t>(read),
            wrong(reg, "GET", read, answer).c_str());
        if (read == Status::Ok && !isText(id)) {
            const std::size_t size = isRaw(id) ? structure + 2 : mcp::scalarWidth(id.type());
            QVERIFY2(answer.size() == size + 1, wrong(reg, "size", read, answer).c_str());
        }
        const bool asymmetric = reg.name == "TORQUE_RAMP";
        if (reg.name == "OVERVOLTAGETHRESHOLD" && exists)
            continue; // 0 V would be a fault from now on
        const Status write = expectedWrite(reg, exists, build, sdk);
        const Bytes request = writeRequest(id, asymmetric ? 6 : structure);
        answer = bench.ask(request);
        QVERIFY2(answer == Bytes{static_cast<std::uint8_t>(write)},
            wrong(reg, "SET", write, answer).c_str());

        // With the other scope it is unknown, but for those that answer in both.
        const bool both = reg.says("DAC") || (build.hso() && board);
        if (sdk < 0x060200 || both)
            continue;
        answer = bench.ask(readRequest(reg.id.withMotor(board ? 1 : 0)));
        QVERIFY2(answer == Bytes{5}, wrong(reg, "scope", Status::UnknownRegister, answer).c_str());
        if (isText(id) || isDatalog(id))
            continue;
        const Status elsewhere = refusedAnywhere(reg, build, profile == "spec")
            ? Status::ReadOnly
            : Status::UnknownRegister;
        answer = bench.ask(writeRequest(reg.id.withMotor(board ? 1 : 0), structure));
        QVERIFY2(answer == Bytes{static_cast<std::uint8_t>(elsewhere)},
            wrong(reg, "SET in the other scope", elsewhere, answer).c_str());
    }
}

void TestRegisters::whatIsNotListedIsUnknown()
{
    QFETCH(QString, profile);
    QFETCH(std::uint32_t, sdk);
    QFETCH(Build, build);
    BoardOptions options;
    options.profile = profile.toStdString();
    options.build = build;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    std::set<std::uint16_t> known;
    for (const Listed &reg : listed(build.hso() ? "hso" : "std", sdk))
        known.insert(reg.id.bits);
    for (unsigned type = 1; type <= 5; ++type) {
        for (unsigned element = 0; element < 140; ++element) {
            const auto id = mcp::registerId(element, static_cast<mcp::RegisterType>(type), 0);
            if (known.contains(id.bits))
                continue;
            const Bytes answer = bench.ask(readRequest(id.withMotor(1)));
            QVERIFY2(answer == Bytes{5}, QByteArray::number(id.bits, 16).constData());
        }
    }
}

void TestRegisters::whatIsWrittenReadsBack()
{
    for (const char *profile : {"mcsdk-6.4", "six-step", "hso"}) {
        BoardOptions options;
        options.profile = profile;
        options.build = options.profile == "hso" ? everyHso()
            : options.profile == "six-step"      ? everySixStep()
                                                 : everything();
        BoardBench bench(options);
        QVERIFY(bench.connect());
        // Commands in the shape of registers: they show a state, not what was written.
        const std::set<std::string> commands{"CONTROL_MODE", "FOC_CONTROLMODE", "SPEED_REF",
            "I_Q_REF", "I_D_REF", "FOC_IDREF", "FOC_IQREF", "FOC_TORQUE_REF_NM",
            "FOC_SPEEDREF_FREQ_PU", "FOC_SPEEDREF_RAMPED_FREQ_PU",
            "OVERVOLTAGETHRESHOLD"}; // and this one, of 3 V, is a fault at once
        int written = 0;
        for (const Listed &reg : listed(options.build->hso() ? "hso" : "std", 0x060402)) {
            if (reg.access != "RW" || mcp::scalarWidth(reg.id.type()) == 0
                || commands.contains(reg.name) || !conditions().at(reg.when)(*options.build))
                continue;
            const auto id = reg.id.withMotor(reg.scope.starts_with("global") ? 0 : 1);
            const std::size_t width = mcp::scalarWidth(id.type());
            Bytes value(width);
            value[0] = 3;
            QCOMPARE(
                bench.ask(ByteWriter().u16(1U << 3).u16(id.bits).bytes(value).take()), Bytes{0});
            value.push_back(0);
            QVERIFY2(bench.ask(readRequest(id)) == value, reg.name.c_str());
            ++written;
        }
        QVERIFY(written > 15);
    }
}

void TestRegisters::theSecondMotorHasItsOwnValues()
{
    BoardOptions options;
    options.motors = 2;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    const Bytes global = bench.ask(readRequest(mcp::reg::kGlobalConfig));
    QCOMPARE(global.at(6), 2);
    const auto kp = [](unsigned motor) {
        return mcp::registerId(2, mcp::RegisterType::Bits16, motor);
    };
    QCOMPARE(bench.ask(ByteWriter().u16(1U << 3).u16(kp(1).bits).u16(111).take()), Bytes{0});
    QCOMPARE(bench.ask(ByteWriter().u16(1U << 3).u16(kp(2).bits).u16(222).take()), Bytes{0});
    QCOMPARE(bench.ask(readRequest(kp(1))), (Bytes{111, 0, 0}));
    QCOMPARE(bench.ask(readRequest(kp(2))), (Bytes{222, 0, 0}));
    QCOMPARE(bench.ask(readRequest(kp(3))), Bytes{1}); // there is no third: NOK

    QCOMPARE(bench.ask(ByteWriter().u16(3U << 3 | 2U).take()), Bytes{0}); // START_MOTOR of motor 2
    bench.pass(200ms);
    QCOMPARE(bench.ask(readRequest(mcp::reg::kStatus.withMotor(1))), (Bytes{0, 0}));
    QVERIFY(bench.ask(readRequest(mcp::reg::kStatus.withMotor(2))).at(0) != 0);
    QCOMPARE(bench.ask(ByteWriter().u16(3U << 3 | 3U).take()), Bytes{1});
}

void TestRegisters::singleMotorFirmwareBefore62IgnoresTheMotor()
{
    for (const char *profile : {"mcsdk-6.0", "mcsdk-6.1", "mcsdk-6.2"}) {
        BoardOptions options;
        options.profile = profile;
        const bool ignores = options.profile != "mcsdk-6.2";
        BoardBench bench(options);
        QVERIFY(bench.connect());
        QCOMPARE(bench.ask(readRequest(mcp::reg::kStatus)), ignores ? (Bytes{0, 0}) : Bytes{5});
        QCOMPARE(bench.ask(readRequest(mcp::reg::kStatus.withMotor(2))),
            ignores ? (Bytes{0, 0}) : Bytes{1});
        // The datalog's register as the text prints it works for the same reason.
        QCOMPARE(bench.ask(writeRequest(mcp::reg::kAsyncUartA, 0)), ignores ? Bytes{0} : Bytes{5});
    }
}

void TestRegisters::positionRampsReadBackSwappedUpTo62()
{
    for (const char *profile : {"mcsdk-6.1", "mcsdk-6.2", "mcsdk-6.3", "mcsdk-6.4"}) {
        BoardOptions options;
        options.profile = profile;
        options.build = everything();
        BoardBench bench(options);
        QVERIFY(bench.connect());
        const auto id = mcp::reg::kPositionRamp.withMotor(1);
        QCOMPARE(
            bench.ask(ByteWriter().u16(1U << 3).u16(id.bits).u16(8).f32(2.0F).f32(0.5F).take()),
            Bytes{0});
        const bool swapped = options.profile < "mcsdk-6.3";
        const Bytes expected =
            ByteWriter().u16(8).f32(swapped ? 0.5F : 2.0F).f32(swapped ? 2.0F : 0.5F).u8(0).take();
        QCOMPARE(bench.ask(readRequest(id)), expected);
    }
}

void TestRegisters::sensorSpeedsAreFractionsUpTo63()
{
    for (const char *profile : {"mcsdk-6.0", "mcsdk-6.2", "mcsdk-6.3", "mcsdk-6.4"}) {
        BoardOptions options;
        options.profile = profile;
        BoardBench bench(options);
        QVERIFY(bench.connect());
        QCOMPARE(bench.command(3).back(), 0);
        QVERIFY(bench.waitForState(6));
        bench.pass(1s);
        const double rpm = bench.get(mcp::reg::kSpeedMeas);
        const auto digits =
            static_cast<std::int16_t>(bench.get(mcp::registerId(46, mcp::RegisterType::Bits16, 0)));
        const double perDigit = options.profile == "mcsdk-6.4" ? 6.0 : 1.15 * 4000.0 / 32768.0;
        QVERIFY2(std::abs(digits * perDigit - rpm) < 30.0, profile);
        QVERIFY(rpm > 1000.0);
    }
}

void TestRegisters::startTogglesAnswerByVersion()
{
    for (const char *profile : {"mcsdk-6.0", "mcsdk-6.1", "mcsdk-6.2", "mcsdk-6.3", "mcsdk-6.4"}) {
        BoardOptions options;
        options.profile = profile;
        BoardBench bench(options);
        QVERIFY(bench.connect());
        const Bytes expected{static_cast<std::uint8_t>(options.profile == "mcsdk-6.2" ? 1 : 0)};
        QCOMPARE(bench.command(6), expected);
        QVERIFY(bench.get(mcp::reg::kStatus) != 0);
    }
}

void TestRegisters::commandsCameWithVersionsAndBuilds()
{
    struct Row {
        const char *profile;
        bool all;
        Bytes cpuLoadClear, profiler, sensorSwitch;
    };
    const Bytes unknown{2}, ok{0}, refused{1};
    const std::vector<Row> rows{
        {"mcsdk-6.0", true, unknown, unknown, unknown},
        {"mcsdk-6.1", true, unknown, ok, unknown},
        {"mcsdk-6.2", true, ok, ok, unknown},
        {"mcsdk-6.3", true, ok, ok, unknown},
        {"mcsdk-6.4", true, ok, ok, refused},
        {"mcsdk-6.4", false, unknown, unknown, unknown},
    };
    for (const Row &row : rows) {
        BoardOptions options;
        options.profile = row.profile;
        if (row.all)
            options.build = everything();
        BoardBench bench(options);
        QVERIFY(bench.connect());
        QCOMPARE(bench.command(8), row.cpuLoadClear);
        QCOMPARE(bench.ask(ByteWriter().u16(13U << 3 | 1U).u8(1).take()), row.profiler);
        QCOMPARE(bench.ask(ByteWriter().u16(16U << 3 | 1U).u16(0).take()), row.sensorSwitch);
        QCOMPARE(bench.command(10), unknown);
        QCOMPARE(bench.command(14), unknown);
    }
}

void TestRegisters::theLoadOfTheProcessorIsShownAndCleared()
{
    BoardOptions options;
    options.build = everything();
    BoardBench bench(options);
    QVERIFY(bench.connect());
    const auto load = [&](unsigned element) {
        const Bytes answer =
            bench.ask(readRequest(mcp::registerId(element, mcp::RegisterType::Bits32, 0)));
        return ByteReader(answer).f32();
    };
    constexpr unsigned kNow = 88, kLeast = 89, kMost = 90;
    const float idle = load(kMost);
    QVERIFY(idle > 5.0F && idle < 50.0F);
    QCOMPARE(bench.command(3), Bytes{0});
    QVERIFY(bench.waitForState(6));
    QVERIFY(load(kNow) > idle && load(kMost) > idle);
    QVERIFY(load(kLeast) < idle);
    QCOMPARE(bench.command(8), Bytes{0}); // CPULOAD_CLEAR
    QVERIFY(load(kLeast) > idle);
}

void TestRegisters::eachOptionBringsItsRegister()
{
    const std::map<std::string_view, std::string_view> registers{{"cordic", "STOCORDIC_EL_ANGLE"},
        {"encoder", "ENCODER_SPEED"}, {"hall", "HALL_SPEED"}, {"flux-weakening", "FLUXWK_KP"},
        {"feed-forward", "FF_VQ"}, {"position", "POSITION_KP"}, {"open-loop", "FOC_VQREF"},
        {"profiler", "SC_CHECK"}, {"cpu-load", "PERF_CPU_LOAD"}, {"dac", "DAC_OUT1"},
        {"pfc", "PFC_STATUS"}, {"ipd", "IPD_ENABLE"}, {"current-monitor", "CURR_MONITOR"},
        {"zest", "FOC_ZEST_OUTD"}, {"potentiometer", "THROTTLE_POS"}};
    QCOMPARE(registers.size() + 1, simulation::buildOptions().size());
    for (const simulation::BuildOption &option : simulation::buildOptions()) {
        if (option.member == &Build::sensorAlone)
            continue; // brings none
        BoardOptions options;
        options.profile = option.fits(Family::Foc) ? "mcsdk-6.4"
            : option.fits(Family::SixStep)         ? "six-step"
                                                   : "hso";
        const auto list = listed(options.profile == "hso" ? "hso" : "std", 0x060400);
        const auto reg = std::find_if(list.begin(), list.end(),
            [&](const Listed &row) { return row.name == registers.at(option.name); });
        QVERIFY(reg != list.end());
        const auto id = reg->id.withMotor(reg->scope.starts_with("global") ? 0 : 1);
        for (const bool with : {false, true}) {
            if (with)
                options.with.push_back(&option);
            BoardBench bench(options);
            QVERIFY(bench.connect());
            QCOMPARE(bench.ask(readRequest(id)).back(), with ? 0 : 5);
        }
        // Another family does not know it.
        if (!option.fits(Family::SixStep)) {
            options.profile = "six-step";
            QVERIFY(simulation::buildOf(options) == simulation::buildFor("six-step", ""));
        }
    }
}

void TestRegisters::aSensorAloneHasNoObserverBesideIt()
{
    BoardOptions options;
    options.motor = "servo24";
    const auto given = [&](std::string_view name) {
        const auto list = listed("std", 0x060400);
        const auto reg = std::find_if(
            list.begin(), list.end(), [&](const Listed &row) { return row.name == name; });
        BoardBench bench(options);
        return bench.connect() && bench.ask(readRequest(reg->id.withMotor(1))).back() == 0;
    };
    const auto all = simulation::buildOptions();
    const auto alone = std::find_if(
        all.begin(), all.end(), [](const auto &option) { return option.name == "sensor-alone"; });
    QVERIFY(alone != all.end());
    for (const bool with : {false, true}) {
        if (with)
            options.with.push_back(&*alone);
        for (const char *observed :
            {"STOPLL_ROT_SPEED", "STOPLL_C1", "RUC_STAGE_NBR", "REVUP_DATA", "STOPLL_EST_BEMF"})
            QVERIFY2(given(observed) != with, observed);
        QVERIFY(given("ENCODER_SPEED"));
        QVERIFY(given("SPEED_MEAS"));
    }
    options.motor = "pm24"; // has nothing else
    QVERIFY(given("STOPLL_ROT_SPEED"));
}

void TestRegisters::sensorsAreSwitchedWithinTheMarginOnly()
{
    BoardOptions options;
    options.motor = "prop12"; // two observers
    BoardBench bench(options);
    QVERIFY(bench.connect());
    const auto ask = [&](unsigned margin) {
        return bench.ask(ByteWriter().u16(16U << 3 | 1U).u16(margin).take());
    };
    QCOMPARE(ask(65535), Bytes{1}); // not running
    QCOMPARE(bench.command(3), Bytes{0});
    QVERIFY(bench.waitForState(6));
    bench.pass(1s);
    QCOMPARE(ask(16384), Bytes{0}); // within 90 degrees
    QCOMPARE(ask(0), Bytes{1});
}

void TestRegisters::profilerBuildsShowWhatTheyWereGiven()
{
    BoardOptions options;
    options.build = everything();
    BoardBench bench(options);
    QVERIFY(bench.connect());
    QCOMPARE(bench.get(mcp::registerId(18, mcp::RegisterType::Bits8, 0)), 4); // SC_PP
    QCOMPARE(bench.get(mcp::registerId(77, mcp::RegisterType::Bits16, 0)), 16000);
    const auto current = mcp::registerId(96, mcp::RegisterType::Bits32, 1); // SC_CURRENT
    const Bytes write = ByteWriter().u16(1U << 3).u16(current.bits).f32(2.5F).take();
    QCOMPARE(bench.ask(write), Bytes{0});
    QCOMPARE(ByteReader(bench.ask(readRequest(current))).f32(), 2.5F);
    QCOMPARE(bench.command(3), Bytes{0});
    QCOMPARE(bench.ask(write), Bytes{4}); // only while nothing runs
}

/// What firmware makes of speeds that its arithmetic cannot hold, as it was measured.
void TestRegisters::stagesAreKeptInTenthsOfAHertz()
{
    BoardBench bench{BoardOptions{}};
    QVERIFY(bench.connect());
    for (const auto &[wrote, keeps] : std::initializer_list<std::pair<std::int32_t, std::int32_t>>{
             {1000, 996}, {-1000, -996}, {0x18110A03, -167'826}}) {
        ByteWriter write;
        write.u16(1U << 3).u16(mcp::reg::kRevUpData.withMotor(1).bits).u16(40);
        for (int stage = 0; stage < 5; ++stage)
            write.s32(wrote).s16(0).u16(100);
        QCOMPARE(bench.ask(write.take()), Bytes{0});
        const Bytes answer = bench.ask(readRequest(mcp::reg::kRevUpData.withMotor(1)));
        QCOMPARE(ByteReader(ByteView(answer).subspan(2)).s32(), keeps);
    }
}

void TestRegisters::theStructuresTellTheMotor()
{
    for (const char *profile : {"mcsdk-6.4", "hso"}) {
        BoardOptions options;
        options.profile = profile;
        options.motor = "ipm48";
        BoardBench bench(options);
        QVERIFY(bench.connect());
        const Bytes answer = bench.ask(readRequest(mcp::reg::kMotorConfig.withMotor(1)));
        QCOMPARE(answer.size(), std::size_t{63});
        const auto motor = mcp::decodeMotorConfig(ByteView(answer).subspan(2, 60));
        QVERIFY(motor.has_value());
        const bool hso = options.profile == "hso";
        const auto &figures = simulation::findPreset("ipm48")->motor;
        QCOMPARE(motor->polePairs, 4.0F);
        QCOMPARE(motor->rs, static_cast<float>(figures.rs_ohm));
        QCOMPARE(motor->lq, static_cast<float>(figures.lq_h));
        QCOMPARE(motor->ld, static_cast<float>(figures.ld_h));
        QCOMPARE(motor->name, figures.name);
        // 14 mWb and 4 pole pairs: 88 mV/Hz of a phase, 7.18 V rms between terminals at 1000 rpm.
        QVERIFY(std::abs(motor->ratedFlux - (hso ? 0.08796F : 7.182F)) < 0.001F);
        QCOMPARE(motor->copperMass, hso ? static_cast<float>(figures.copperMass_kg) : 0.0F);
    }
}

QTEST_APPLESS_MAIN(TestRegisters)
#include "tst_registers.moc"
