// Where the shaft is, by what boards hold: radians, or counts with what a turn has of them.
#include "drive/set_points/shaft_position.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace {

constexpr drive::RegisterId kShaft = 0x40, kCounts = 0x80;

catalog::Catalog catalogWith(const char *position, bool readable = true)
{
    std::vector<catalog::RegisterInfo> registers(2);
    registers[0].id = kShaft;
    registers[0].name = position;
    registers[0].access = readable ? catalog::Access::Read : catalog::Access::Write;
    registers[1].id = kCounts;
    registers[1].name = "FBK_DIGENC1_RESOLUTION";
    registers[1].access = catalog::Access::Read;
    for (catalog::RegisterInfo &info : registers)
        info.perMotor = false;
    return {std::move(registers), 1, std::vector<catalog::Scales>(1)};
}

drive::ValueSource holds(drive::Value position, std::optional<std::int64_t> counts = {})
{
    return [=](drive::RegisterId id) {
        return id == kShaft ? std::optional(position)
            : counts        ? std::optional<drive::Value>(*counts)
                            : std::nullopt;
    };
}

} // namespace

class TestShaftPosition : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void radiansAreTakenAsTheyAre()
    {
        const auto catalog = catalogWith("CURRENT_POSITION");
        QCOMPARE(drive::shaftRegisters(catalog, 1), std::vector<drive::RegisterId>{kShaft});
        QCOMPARE(drive::shaftAngle_rad(catalog, 1, holds(-2.5)), std::optional(-2.5));
    }
    void countsNeedATurn()
    {
        const auto catalog = catalogWith("CL_POS_FBK_VALUE");
        QCOMPARE(
            drive::shaftRegisters(catalog, 1), (std::vector<drive::RegisterId>{kShaft, kCounts}));
        QVERIFY(!drive::shaftAngle_rad(catalog, 1, holds(std::int64_t{1024})));
        QVERIFY(!drive::shaftAngle_rad(catalog, 1, holds(std::int64_t{1024}, 0)));
        const auto angle = drive::shaftAngle_rad(catalog, 1, holds(std::int64_t{-1024}, 4096));
        QVERIFY(angle && std::abs(*angle + std::numbers::pi / 2) < 1e-12);
    }
    void whatIsNotToldIsNotMadeUp()
    {
        const auto catalog = catalogWith("CURRENT_POSITION");
        QVERIFY(!drive::shaftAngle_rad(catalog, 1, [](auto) { return std::nullopt; }));
        QVERIFY(!drive::shaftAngle_rad(catalog, 1, holds(NAN)));
        QVERIFY(drive::shaftRegisters(catalogWith("CURRENT_POSITION", false), 1).empty());
        QVERIFY(drive::shaftRegisters(catalogWith("SPEED_MEAS"), 1).empty());
    }
};

QTEST_APPLESS_MAIN(TestShaftPosition)
#include "tst_shaft_position.moc"
