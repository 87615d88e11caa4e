// Raw structures: captured ones, every size that exists, and no other.
#include "mcp/structures.h"
#include "support/virtual_link.h"

using namespace mcp;
using support::hex;

class TestStructures : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aCapturedBoardDescribesItself();
    void aRecordedMotorIsRead();
    void theShortApplicationConfigCountsInDigits();
    void sixStepFirmwareComesInThreeSizes();
    void torqueRampsAreReadShorterThanWritten();
    void everyStructureSurvivesTheRoundTrip();
    void noOtherSizeIsTaken();
    void aNameWithoutItsZeroEndsWithItsField();
    void startUpsHaveAtMostFiveStages();
};

namespace {

template <class T, class Decode>
void roundTrip(const T &value, std::size_t size, Decode decode)
{
    const Bytes bytes = encode(value);
    QCOMPARE(bytes.size(), size);
    const auto decoded = decode(bytes);
    QVERIFY(decoded.has_value());
    QVERIFY(*decoded == value);
}

/// Tries all sizes up to 80 bytes; gives those that were taken.
template <class Decode>
std::vector<std::size_t> sizesOf(Decode decode)
{
    std::vector<std::size_t> sizes;
    for (std::size_t size = 0; size <= 80; ++size) {
        if (decode(Bytes(size, 0)).has_value())
            sizes.push_back(size);
    }
    return sizes;
}

using Sizes = std::vector<std::size_t>;

} // namespace

void TestStructures::aCapturedBoardDescribesItself()
{
    const auto global = decodeGlobalConfig(hex("00 02 03 06 01 02 0A 00 00 00"));
    QVERIFY(global.has_value());
    QVERIFY((*global == GlobalConfig{0x06030200, 1, 2, 10, 0, 0}));
    const auto application =
        decodeApplicationConfig(hex("3C 06 00 00 42 B3 70 42 00 00 20 41 11 00 00 00"));
    QVERIFY(application.has_value());
    QCOMPARE(application->maxSpeedRpm, 1596U);
    QCOMPARE(application->maxReadableAmps, 60.175056F);
    QCOMPARE(application->nominalAmps, 10.0F);
    QCOMPARE(int(application->nominalVolts), 17);
}

void TestStructures::aRecordedMotorIsRead()
{
    const auto motor = decodeMotorConfig(
        hex("0000e0400000803f295c0f3e000000002829b0372829b0370000a04000000000000000004432383330"
            "20313030306b56000000000000000000000000"));
    QVERIFY(motor.has_value());
    QCOMPARE(motor->polePairs, 7.0F);
    QCOMPARE(motor->rs, 0.14F);
    QVERIFY(motor->name == "D2830 1000kV");
    const auto firmware = decodeFirmwareConfig(hex("01 00 00 02 40 9C 00 00 E8 03 00 06 00 04"));
    QVERIFY((*firmware == FirmwareConfig{false, 1, 0, 0, 2, 40000, 1000, 1536, 1024, {}}));
    QCOMPARE(decodeScaleConfig(hex("9a54813942b3f03a0000c040"))->frequency, 6.0F);
}

void TestStructures::theShortApplicationConfigCountsInDigits()
{
    ApplicationConfig config{3000, 60.0F, 0.0F, 24, 0, 16384};
    const auto decoded = decodeApplicationConfig(encode(config));
    QCOMPARE(encode(config).size(), std::size_t{14});
    QCOMPARE(decoded->nominalAmps, 30.0F);
    QCOMPARE(int(decoded->nominalVolts), 24);
}

void TestStructures::sixStepFirmwareComesInThreeSizes()
{
    FirmwareConfig config{true, 4, 0, 1, 1, 30000, 1000, 0x0200, {}, {}};
    roundTrip(config, 10, decodeFirmwareConfig);
    config.driveMode = 1;
    roundTrip(config, 11, decodeFirmwareConfig);
    config.flags2 = 0x0400;
    roundTrip(config, 13, decodeFirmwareConfig);
}

void TestStructures::torqueRampsAreReadShorterThanWritten()
{
    const TorqueRamp ramp{-1200, 500};
    roundTrip(ramp, 6, decodeTorqueRamp);
    QVERIFY(*decodeTorqueRamp(hex("50 FB F4 01")) == ramp);
}

void TestStructures::everyStructureSurvivesTheRoundTrip()
{
    roundTrip(GlobalConfig{0x06040000, 2, 3, 10, 4, 1}, 10, decodeGlobalConfig);
    roundTrip(MotorConfig{7, 1, 0.14F, 0, 2e-5F, 3e-5F, 5, 0, 0, "D2830"}, 60, decodeMotorConfig);
    roundTrip(ApplicationConfig{7500, 60, 5, 14, 0, {}}, 16, decodeApplicationConfig);
    roundTrip(
        FirmwareConfig{false, 1, 4, 2, 2, 40000, 1000, 1536, 1024, {}}, 14, decodeFirmwareConfig);
    roundTrip(ScaleConfig{0.1F, 0.2F, 6}, 12, decodeScaleConfig);
    roundTrip(SpeedRamp{-1500, 500}, 6, decodeSpeedRamp);
    roundTrip(CurrentRef{-250, 30}, 4, decodeCurrentRef);
    roundTrip(PositionRamp{3.14F, 2}, 8, decodePositionRamp);
    roundTrip(RevUpData{{0, 2720, 1000}, {3000, 2720, 6000}}, 16, decodeRevUpData);
    roundTrip(BemfAdcConf{{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13}}, 26, decodeBemfAdcConf);
    roundTrip(HallPins{{1, 2, 3}}, 4, decodeHallPins);
    roundTrip(HallPhaseShift{{-1, 2}}, 28, decodeHallPhaseShift);
    roundTrip(AdcOffset{{-70000, 2}}, 24, decodeAdcOffset);
}

void TestStructures::noOtherSizeIsTaken()
{
    QCOMPARE(sizesOf(decodeGlobalConfig), (Sizes{10}));
    QCOMPARE(sizesOf(decodeMotorConfig), (Sizes{60}));
    QCOMPARE(sizesOf(decodeApplicationConfig), (Sizes{14, 16}));
    QCOMPARE(sizesOf(decodeFirmwareConfig), (Sizes{10, 11, 13, 14}));
    QCOMPARE(sizesOf(decodeScaleConfig), (Sizes{12}));
    QCOMPARE(sizesOf(decodeSpeedRamp), (Sizes{6}));
    QCOMPARE(sizesOf(decodeTorqueRamp), (Sizes{4, 6}));
    QCOMPARE(sizesOf(decodeCurrentRef), (Sizes{4}));
    QCOMPARE(sizesOf(decodePositionRamp), (Sizes{8}));
    QCOMPARE(sizesOf(decodeRevUpData), (Sizes{0, 8, 16, 24, 32, 40}));
    QCOMPARE(sizesOf(decodeBemfAdcConf), (Sizes{26}));
    QCOMPARE(sizesOf(decodeHallPins), (Sizes{4}));
    QCOMPARE(sizesOf(decodeHallPhaseShift), (Sizes{28}));
    QCOMPARE(sizesOf(decodeAdcOffset), (Sizes{24}));
}

void TestStructures::aNameWithoutItsZeroEndsWithItsField()
{
    Bytes raw(60, 0);
    std::fill(raw.begin() + 36, raw.end(), std::uint8_t{'x'});
    QCOMPARE(decodeMotorConfig(raw)->name.size(), std::size_t{24});
    MotorConfig config;
    config.name = std::string(100, 'y');
    QCOMPARE(decodeMotorConfig(encode(config))->name.size(), std::size_t{23});
}

void TestStructures::startUpsHaveAtMostFiveStages()
{
    QCOMPARE(encode(RevUpData(9)).size(), std::size_t{40});
}

QTEST_APPLESS_MAIN(TestStructures)
#include "tst_structures.moc"
