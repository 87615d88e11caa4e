// Raw structures: captured ones, every size that exists, and no other.
#include "mcp/structures.h"

#include "mcp/structure_fields.h"
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
    void everyNumberIsReadFromItsPlace();
    void noOtherSizeIsTaken();
    void aNameWithoutItsZeroEndsWithItsField();
};

namespace {

/// "name value" of each field, joined by "; ".
std::string shown(RegisterId id, std::string_view bytes)
{
    std::string text;
    for (const Field &field : fieldsOf(id.withMotor(1), hex(bytes))) {
        text += (text.empty() ? "" : "; ") + field.name + ' ';
        if (const auto *whole = std::get_if<std::int64_t>(&field.value))
            text += std::to_string(*whole);
        else
            text += std::to_string(std::get<double>(field.value));
    }
    return text;
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

Sizes sizesShown(RegisterId id)
{
    return sizesOf([&](const Bytes &raw) {
        return fieldsOf(id, raw).empty() ? std::nullopt : std::optional(true);
    });
}

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
    const auto decoded = decodeApplicationConfig(hex("B8 0B 00 00 00 00 70 42 00 40 18 00 00 00"));
    QVERIFY((*decoded == ApplicationConfig{3000, 60.0F, 30.0F, 24, 0, 16384}));
}

void TestStructures::sixStepFirmwareComesInThreeSizes()
{
    FirmwareConfig config{true, 4, 0, 1, 1, 30000, 1000, 0x0200, {}, {}};
    QVERIFY(*decodeFirmwareConfig(hex("04 01 30 75 00 00 E8 03 00 02")) == config);
    config.driveMode = 1;
    QVERIFY(*decodeFirmwareConfig(hex("04 01 30 75 00 00 E8 03 00 02 01")) == config);
    config.flags2 = 0x0400;
    QVERIFY(*decodeFirmwareConfig(hex("04 01 30 75 00 00 E8 03 00 02 00 04 01")) == config);
}

void TestStructures::torqueRampsAreReadShorterThanWritten()
{
    QCOMPARE(shown(reg::kTorqueRamp, "50 FB FF FF F4 01"), "torque -1200; duration 500");
    QCOMPARE(shown(reg::kTorqueRamp, "50 FB F4 01"), "torque -1200; duration 500");
}

void TestStructures::everyNumberIsReadFromItsPlace()
{
    QVERIFY((*decodeGlobalConfig(hex("00 00 04 06 02 03 0A 04 01 00"))
        == GlobalConfig{0x06040000, 2, 3, 10, 4, 1}));
    QVERIFY((*decodeMotorConfig(hex("00 00 E0 40 00 00 80 3F 29 5C 0F 3E 00 00 00 00 AC C5 A7 37 "
                                    "82 A8 FB 37 00 00 A0 40 00 00 00 00 00 00 00 00 "
                                    "44 32 38 33 30 00 00 00 00 00 00 00 "
                                    "00 00 00 00 00 00 00 00 00 00 00 00"))
        == MotorConfig{7, 1, 0.14F, 0, 2e-5F, 3e-5F, 5, 0, 0, "D2830"}));
    QVERIFY((*decodeApplicationConfig(hex("4C 1D 00 00 00 00 70 42 00 00 A0 40 0E 00 00 00"))
        == ApplicationConfig{7500, 60, 5, 14, 0, {}}));
    QVERIFY((*decodeFirmwareConfig(hex("01 04 02 02 40 9C 00 00 E8 03 00 06 00 04"))
        == FirmwareConfig{false, 1, 4, 2, 2, 40000, 1000, 1536, 1024, {}}));
    QVERIFY((*decodeScaleConfig(hex("CD CC CC 3D CD CC 4C 3E 00 00 C0 40"))
        == ScaleConfig{0.1F, 0.2F, 6}));
    QCOMPARE(shown(reg::kSpeedRamp, "24 FA FF FF F4 01"), "speed -1500; duration 500");
    QCOMPARE(shown(reg::kCurrentRef, "06 FF 1E 00"), "Iq -250; Id 30");
    QCOMPARE(
        shown(reg::kPositionRamp, "00 00 50 40 00 00 00 40"), "target 3.250000; duration 2.000000");
    QCOMPARE(shown(reg::kRevUpData, "00 00 00 00 A0 0A E8 03 B8 0B 00 00 A0 0A 70 17"),
        "stage 1 speed 0; stage 1 torque 2720; stage 1 duration 1000; "
        "stage 2 speed 3000; stage 2 torque 2720; stage 2 duration 6000");
    QCOMPARE(shown(reg::kBemfAdcConf,
                 "01 00 02 00 03 00 04 00 05 00 06 00 07 00 08 00 09 00 0A 00 0B 00 0C 00 0D FF"),
        "word 1 1; word 2 2; word 3 3; word 4 4; word 5 5; word 6 6; word 7 7; word 8 8; word 9 9; "
        "word 10 10; word 11 11; word 12 12; word 13 65293");
    for (const RegisterId pins : {reg::kHallHewPins, reg::kHallConnectedPins})
        QCOMPARE(shown(pins, "01 02 FF 00"), "pin 1 1; pin 2 2; pin 3 255");
    QCOMPARE(
        shown(reg::kHallPhaseShift,
            "FF FF 02 00 03 00 04 00 05 00 06 00 07 00 08 00 09 00 0A 00 0B 00 0C 00 0D 00 0E 00"),
        "shift 1 -1; shift 2 2; shift 3 3; shift 4 4; shift 5 5; shift 6 6; shift 7 7; shift 8 8; "
        "shift 9 9; shift 10 10; shift 11 11; shift 12 12; shift 13 13; shift 14 14");
    QCOMPARE(shown(reg::kAdcOffset,
                 "90 EE FE FF 02 00 00 00 03 00 00 00 04 00 00 00 05 00 00 00 06 00 00 00"),
        "offset 1 -70000; offset 2 2; offset 3 3; offset 4 4; offset 5 5; offset 6 6");
}

void TestStructures::noOtherSizeIsTaken()
{
    QCOMPARE(sizesOf(decodeGlobalConfig), (Sizes{10}));
    QCOMPARE(sizesOf(decodeMotorConfig), (Sizes{60}));
    QCOMPARE(sizesOf(decodeApplicationConfig), (Sizes{14, 16}));
    QCOMPARE(sizesOf(decodeFirmwareConfig), (Sizes{10, 11, 13, 14}));
    QCOMPARE(sizesOf(decodeScaleConfig), (Sizes{12}));
    QCOMPARE(sizesShown(reg::kSpeedRamp), (Sizes{6}));
    QCOMPARE(sizesShown(reg::kTorqueRamp), (Sizes{4, 6}));
    QCOMPARE(sizesShown(reg::kCurrentRef), (Sizes{4}));
    QCOMPARE(sizesShown(reg::kPositionRamp), (Sizes{8}));
    QCOMPARE(sizesShown(reg::kRevUpData), (Sizes{8, 16, 24, 32, 40}));
    QCOMPARE(sizesShown(reg::kBemfAdcConf), (Sizes{26}));
    QCOMPARE(sizesShown(reg::kHallHewPins), (Sizes{4}));
    QCOMPARE(sizesShown(reg::kHallConnectedPins), (Sizes{4}));
    QCOMPARE(sizesShown(reg::kHallPhaseShift), (Sizes{28}));
    QCOMPARE(sizesShown(reg::kAdcOffset), (Sizes{24}));
}

void TestStructures::aNameWithoutItsZeroEndsWithItsField()
{
    Bytes raw(60, 0);
    std::fill(raw.begin() + 36, raw.end(), std::uint8_t{'x'});
    QCOMPARE(decodeMotorConfig(raw)->name.size(), std::size_t{24});
}

QTEST_APPLESS_MAIN(TestStructures)
#include "tst_structures.moc"
