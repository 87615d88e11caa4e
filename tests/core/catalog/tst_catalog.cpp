// The register table and the names of its numbers.
#include "catalog/catalog.h"
#include "catalog/motor_signals.h"
#include "catalog/names.h"

#include <QTest>

#include <charconv>
#include <set>

using namespace catalog;

namespace {

constexpr std::uint32_t k642 = 0x060402;

std::vector<RegisterInfo> table(std::string_view family, std::uint32_t version)
{
    const auto registers = readTable(builtInTable("mcp"), family, version);
    return registers ? *registers : std::vector<RegisterInfo>{};
}

Catalog catalogOf(std::uint32_t version, int motors = 1, Scales scales = {})
{
    return Catalog(table("std", version), motors,
        std::vector<Scales>(static_cast<std::size_t>(motors), scales));
}

const std::string kHeader =
    "family,name,aliases,id_hex,format,scope,access,unit,quantity,meaning,group,dangerous,"
    "datalog,since,until,description\n";

TableError errorOf(const std::string &rows)
{
    const auto result = readTable(kHeader + rows, "std", k642);
    return result ? TableError{} : result.error();
}

} // namespace

class TestCatalog : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyIdAgreesWithElementAndType();
    void version642HasAll323Rows();
    void namesAreUniqueInEveryVersion();
    void idsThatChangedMeaningFollowTheVersion();
    void namesResolveWithMotorAliasAndAnyCase();
    void namesForPeopleShowTheMotorOnlyWhereThereAreSeveral();
    void scalesTurnDigitsIntoUnits();
    void fixedPointAndUpperHalvesAreScaled();
    void unknownScalesLeaveDigits();
    void brokenTablesNameTheLine();
    void quotesHoldSeparatorsAndLineEnds();
    void statesFaultsAndFlagsHaveNames();
    void everyNamedFaultHasAKind();
    void signalsOfVectorsAreRegisters();
};

void TestCatalog::everyIdAgreesWithElementAndType()
{
    const auto rows = readCsv(builtInTable("mcp"));
    QVERIFY(rows);
    const auto &header = rows->front().fields;
    const auto column = [&](const char *name) {
        return static_cast<std::size_t>(
            std::find(header.begin(), header.end(), name) - header.begin());
    };
    const std::size_t element = column("element_id"), type = column("type_id"),
                      id = column("id_hex");
    for (std::size_t i = 1; i < rows->size(); ++i) {
        const auto &fields = (*rows)[i].fields;
        const int expected = QString::fromStdString(fields[element]).toInt() * 64
            + QString::fromStdString(fields[type]).toInt() * 8;
        QCOMPARE(QString::fromStdString(fields[id]).toInt(nullptr, 16), expected);
    }
}

void TestCatalog::version642HasAll323Rows()
{
    QCOMPARE(table("std", k642).size() + table("hso", k642).size(), 323U);
}

void TestCatalog::namesAreUniqueInEveryVersion()
{
    for (const std::uint32_t version :
        {0x060000U, 0x060100U, 0x060102U, 0x060200U, 0x060302U, 0x060400U, k642}) {
        for (const char *family : {"std", "hso"}) {
            std::set<std::string> names;
            std::set<RegisterId> ids;
            for (const RegisterInfo &info : table(family, version)) {
                QVERIFY2(names.insert(info.name).second, info.name.c_str());
                QVERIFY2(ids.insert(info.id).second, info.name.c_str());
                QVERIFY2(!info.group.empty(), info.name.c_str());
                for (const std::string &alias : info.aliases)
                    QVERIFY2(names.insert(alias).second, alias.c_str());
            }
            QVERIFY(!names.empty());
        }
    }
}

void TestCatalog::idsThatChangedMeaningFollowTheVersion()
{
    const auto nameAt = [](std::uint32_t version, RegisterId id) {
        return catalogOf(version).nameOf(id | 1U);
    };
    const RegisterId k8Bit27 = 27 << 6 | 1 << 3, k8Bit31 = 31 << 6 | 1 << 3,
                     k16Bit106 = 106 << 6 | 2 << 3, k16Bit107 = 107 << 6 | 2 << 3,
                     k16Bit108 = 108 << 6 | 2 << 3, k16Bit109 = 109 << 6 | 2 << 3,
                     kRaw31 = 31 << 6 | 5 << 3, kRaw32 = 32 << 6 | 5 << 3;
    QCOMPARE(nameAt(0x060201, k8Bit27), "FAST_DEMAG");
    QCOMPARE(nameAt(0x060302, k8Bit27), "LOWSIDE_MODULATION");
    QCOMPARE(nameAt(0x060201, k8Bit31), "0x07C9");
    QCOMPARE(nameAt(0x060302, k8Bit31), "COMMUTATION_STEPBUFSIZE");
    QCOMPARE(nameAt(0x060400, k8Bit31), "OPENLOOP_DC_FILTER");
    QCOMPARE(nameAt(0x060401, k16Bit106), "PULSE_VALUE");
    QCOMPARE(nameAt(k642, k16Bit106), "0x1A91");
    QCOMPARE(nameAt(0x060102, k16Bit107), "FOC_VDREF");
    QCOMPARE(nameAt(0x060200, k16Bit107), "FOC_VQREF");
    QCOMPARE(nameAt(0x060201, k16Bit108), "BEMF_ZCR");
    QCOMPARE(nameAt(0x060302, k16Bit108), "OPENLOOP_CURRFACTOR");
    QCOMPARE(nameAt(0x060302, k16Bit109), "0x1B51");
    QCOMPARE(nameAt(0x060400, k16Bit109), "CURR_MONITOR");
    QCOMPARE(nameAt(0x060200, kRaw31), "BEMF_ADC_CONFIG");
    QCOMPARE(nameAt(0x060302, kRaw31), "BEMF_ADC_CONF");
    QCOMPARE(nameAt(0x060200, kRaw32), "BEMF_ONTIME_ADC_CONFIG");
    QCOMPARE(nameAt(0x060302, kRaw32), "0x0829");
}

void TestCatalog::namesResolveWithMotorAliasAndAnyCase()
{
    const Catalog two = catalogOf(k642, 2);
    QCOMPARE(two.resolve("I_Q_MEAS"), std::optional<RegisterId>(0x08D1));
    QCOMPARE(two.resolve("i_q"), std::optional<RegisterId>(0x08D1));
    QCOMPARE(two.resolve("I_Q@2"), std::optional<RegisterId>(0x08D2));
    QCOMPARE(two.resolve("DATALOG_UARTA"), std::optional<RegisterId>(0x0529));
    QCOMPARE(two.resolve("FOC_FIRMWARE_CFG"), std::optional<RegisterId>(0x00E9));
    QCOMPARE(two.resolve("GLOBAL_CONFIG"), std::optional<RegisterId>(0x0028));
    for (const char *bad :
        {"I_Q@3", "I_Q@0", "I_Q@", "I_Q@1x", "GLOBAL_CONFIG@1", "NO_SUCH", "", "@1"})
        QVERIFY2(!two.resolve(bad), bad);
}

void TestCatalog::namesForPeopleShowTheMotorOnlyWhereThereAreSeveral()
{
    QCOMPARE(catalogOf(k642).nameOf(0x08D1), "I_Q_MEAS");
    QCOMPARE(catalogOf(k642, 2).nameOf(0x08D2), "I_Q_MEAS@2");
    QCOMPARE(catalogOf(k642, 2).nameOf(0x0028), "GLOBAL_CONFIG");
    QCOMPARE(catalogOf(k642).nameOf(0xFFF1), "0xFFF1");
}

void TestCatalog::scalesTurnDigitsIntoUnits()
{
    const Catalog board = catalogOf(k642, 1, Scales{0.0018364, 0.0003, 0.0, 6.0, 0.056012});
    QCOMPARE(board.readScale(0x08D1), (Scale{0.0018364, "A"})); // I_Q_MEAS
    QCOMPARE(board.readScale(0x09D1), (Scale{0.0003, "V"})); // V_Q
    QCOMPARE(board.readScale(0x0B51), (Scale{360.0 / 65536.0, "°"})); // STOPLL_EL_ANGLE
    QCOMPARE(board.readScale(0x0B91), (Scale{0.056012, "rpm"})); // STOPLL_ROT_SPEED
    QCOMPARE(board.streamScale(0x0B91), (Scale{6.0, "rpm"}));
    QCOMPARE(board.readScale(0x0591), (Scale{1.0, "V"})); // BUS_VOLTAGE
    QCOMPARE(board.readScale(0x05D1), (Scale{1.0, "°C"})); // HEATS_TEMP
    QCOMPARE(board.readScale(0x0059), (Scale{1.0, "rpm"})); // SPEED_MEAS
    QCOMPARE(board.readScale(0x0049), (Scale{1.0, ""})); // STATUS
    QCOMPARE(board.readScale(0xFFF1), Scale{});
}

void TestCatalog::fixedPointAndUpperHalvesAreScaled()
{
    const Catalog board(table("hso", k642), 1, {Scales{40.0, 50.0, 1000.0, 6.0, 6.0}});
    const RegisterId iq = *board.resolve("I_Q"), angle = *board.resolve("FOC_ANGLE_PU");
    QCOMPARE(board.readScale(iq), (Scale{40.0 / 1073741824.0, "A"}));
    QCOMPARE(board.streamScale(iq), (Scale{40.0 / 16384.0, "A"}));
    QCOMPARE(board.streamScale(angle), (Scale{360.0 / 16384.0, "°"}));
    QCOMPARE(board.readScale(*board.resolve("FOC_RS_RATED")), (Scale{1.0 / 1048576.0, "Ω"}));
    QCOMPARE(board.streamScale(*board.resolve("FE_HSO")), (Scale{1000.0 / 16384.0, "Hz"}));
}

void TestCatalog::unknownScalesLeaveDigits()
{
    const Catalog board = catalogOf(k642);
    QCOMPARE(board.readScale(0x08D1), (Scale{1.0, "s16A"}));
    QCOMPARE(board.readScale(0x0B51).unit, "°");
}

void TestCatalog::brokenTablesNameTheLine()
{
    const std::string good = "std,A,,0x0048,u8,motor,R,,plain,number,G,,none,6.0,,x\n";
    QCOMPARE(errorOf(good).what, "");
    QCOMPARE(errorOf(good + "std,B\n").line, 3U);
    QCOMPARE(errorOf(good + "std,B,,0xZZ,u8,motor,R,,plain,number,G,,none,6.0,,x\n").line, 3U);
    QCOMPARE(errorOf(good + "\nstd,B,,0x48,u9,motor,R,,plain,number,G,,none,6.0,,x\n").line, 4U);
    QCOMPARE(errorOf(good + "std,B,,0x48,u8,motor,Q,,plain,number,G,,none,6.0,,x\n").line, 3U);
    QCOMPARE(errorOf(good + "std,B,,0x48,u8,motor,R,,plain,number,G,,none,six,,x\n").line, 3U);
    QCOMPARE(errorOf(good + "std,B,,0x48,u8,motor,R,,plain,number,G,,none,6.0,6.x,x\n").line, 3U);
    QCOMPARE(errorOf(good + "std,\"B,,0x48\n\n").line, 3U);
    QCOMPARE(errorOf(good + "std,\"B\"x,,0x48\n").line, 3U);
    QCOMPARE(readTable("", "std", k642).error().line, 1U);
    QCOMPARE(readTable("family,name\n", "std", k642).error().line, 1U);
}

void TestCatalog::quotesHoldSeparatorsAndLineEnds()
{
    const auto rows = readCsv("a,\"b,\"\"c\"\"\r\nd\"\r\n\r\ne,f");
    QVERIFY(rows);
    QCOMPARE(rows->size(), 2U);
    QCOMPARE(rows->at(0).fields.at(1), "b,\"c\"\r\nd");
    QCOMPARE(rows->at(1).fields.at(1), "f");
    QCOMPARE(rows->at(1).line, 4U);
}

void TestCatalog::statesFaultsAndFlagsHaveNames()
{
    QCOMPARE(valueName("STATUS", 6), "RUN");
    QCOMPARE(valueName("STATUS", 16), "CHARGE_BOOT_CAP");
    QCOMPARE(valueName("STATUS", 13), "13");
    QCOMPARE(valueName("CONTROL_MODE", 4), "torque");
    QCOMPARE(faultNames(0x0006), (std::vector<std::string>{"OVER_VOLT", "UNDER_VOLT"}));
    QCOMPARE(faultNames(0x0800), std::vector<std::string>{"bit 11"});
    QCOMPARE(flagNames("FAULTS_FLAGS", 0x40), std::vector<std::string>{"OVER_CURR"});
    QCOMPARE(valueName("primary sensor", 1), "observer + PLL");
    QCOMPARE(valueName("drive type", 0), "FOC");
    QCOMPARE(valueName("topology", 0), "three shunts");
    QCOMPARE(flagNames("flags 1", 0x0201),
        (std::vector<std::string>{"flux weakening", "bus voltage sensing"}));
    QCOMPARE(flagNames("flags 2", 0x2000), std::vector<std::string>{"profiler"});
    for (const RegisterInfo &info : table("std", k642))
        if (info.meaning == Meaning::Enumeration && info.name != "PFC_STATUS"
            && info.name != "HT_STATE")
            QVERIFY2(!namedValues(info.name).empty(), info.name.c_str());
}

void TestCatalog::everyNamedFaultHasAKind()
{
    for (unsigned bit = 0; bit < 16; ++bit)
        for (const std::string &name : faultNames(static_cast<std::uint16_t>(1U << bit)))
            QCOMPARE(faultKindOf(name) == FaultKind::Other, name.starts_with("bit "));
    QVERIFY(faultKindOf("") == FaultKind::Other);
    QVERIFY(faultKindOf("over_volt ") == FaultKind::Other);
}

/// The first of two names is the standard firmware's, the second that of HSO; recordings have no aliases.
void TestCatalog::signalsOfVectorsAreRegisters()
{
    const Catalog standard = catalogOf(k642), hso(table("hso", k642), 1, {Scales{}});
    const auto isName = [](const Catalog &catalog, std::string_view name) {
        const RegisterInfo *info = catalog.find(name);
        return info != nullptr && info->name == name;
    };
    for (const SignalNames &names : {kCurrentAlpha, kCurrentBeta, kCurrentD, kCurrentQ,
             kVoltageAlpha, kVoltageBeta, kVoltageD, kVoltageQ}) {
        QVERIFY2(isName(standard, names[0]), names[0].data());
        QVERIFY2(isName(hso, names[1]), names[1].data());
    }
    for (const std::string_view name : {kCurrentA, kCurrentB, kBusVoltage})
        QVERIFY2(isName(standard, name), name.data());
    const auto isAngle = [](const RegisterInfo &info) {
        return info.name.find(kElectricalAngle) != std::string::npos;
    };
    QVERIFY(std::ranges::any_of(standard.registers(), isAngle));
}

QTEST_APPLESS_MAIN(TestCatalog)
#include "tst_catalog.moc"
