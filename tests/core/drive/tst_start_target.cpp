// Where a START goes: the reference that the board's control follows, under each name that a board may have for it.
#include "drive/start_target.h"

#include "drive/mcb/commands.h"

#include <QTest>

#include <map>

using namespace drive;
using catalog::RegisterId;

namespace {

constexpr std::uint32_t kModeId = 0x10, kSpeedId = 0x20, kCurrentId = 0x30;

catalog::RegisterInfo reference(
    std::uint32_t id, const char *name, catalog::SetPoint what, const char *unit)
{
    catalog::RegisterInfo info;
    info.id = id;
    info.name = name;
    info.type = catalog::ValueType::S32;
    info.access = catalog::Access::ReadWrite;
    info.setPoint = what;
    info.unit = unit;
    info.perMotor = true;
    return info;
}

constexpr catalog::StartRegisters kStartNames{
    {"CONTROL_MODE"}, {"SPEED_RAMP"}, {"SPEED_REF"}, {"I_Q_REF"}};

std::shared_ptr<const catalog::Catalog> catalogOf(const char *mode, const char *speed,
    const char *current, const catalog::StartRegisters &start = kStartNames)
{
    std::vector<catalog::RegisterInfo> registers;
    if (mode != nullptr)
        registers.push_back(reference(kModeId, mode, catalog::SetPoint::None, ""));
    if (speed != nullptr)
        registers.push_back(reference(kSpeedId, speed, catalog::SetPoint::Speed, "rpm"));
    if (current != nullptr)
        registers.push_back(reference(kCurrentId, current, catalog::SetPoint::Current, "A"));
    return std::make_shared<const catalog::Catalog>(
        std::move(registers), 2, std::vector<catalog::Scales>{{}, {}}, start);
}

StartTarget targetOf(
    const catalog::Catalog &catalog, int motor, const std::map<RegisterId, double> &held)
{
    return startTarget(catalog, {}, motor, [&](RegisterId id) -> std::optional<catalog::Value> {
        const auto found = held.find(id);
        return found == held.end() ? std::nullopt : std::optional<catalog::Value>(found->second);
    });
}

} // namespace

class TestStartTarget : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theControlModeSaysWhichReferenceCounts()
    {
        const auto board = catalogOf("CONTROL_MODE", "SPEED_REF", "I_Q_REF");
        const auto id = [&](std::uint32_t bare) {
            return board->withMotor(*board->find(RegisterId{bare}), 2);
        };
        QVERIFY(
            (startRegisters(*board, 2) == std::vector{id(kModeId), id(kSpeedId), id(kCurrentId)}));
        const StartTarget speed = targetOf(
            *board, 2, {{id(kModeId), 3.0}, {id(kSpeedId), -1500.0}, {id(kCurrentId), 2.0}});
        QVERIFY(speed.control == catalog::ControlMode::Speed);
        QVERIFY(speed.rpm == -1500.0);
        QVERIFY(!speed.amps);
        const StartTarget torque = targetOf(
            *board, 2, {{id(kModeId), 4.0}, {id(kSpeedId), -1500.0}, {id(kCurrentId), 2.0}});
        QVERIFY(torque.control == catalog::ControlMode::Torque);
        QVERIFY(torque.amps == 2.0);
        QVERIFY(!torque.rpm);
        const StartTarget other = targetOf(
            *board, 2, {{id(kModeId), 7.0}, {id(kSpeedId), -1500.0}, {id(kCurrentId), 2.0}});
        QVERIFY(other.control == catalog::ControlMode::Other);
        QVERIFY(!other.rpm && !other.amps);
    }

    /// A speed that was asked for while the motor rests is in no reference yet.
    void theLastRampIsWhereAStartGoes()
    {
        constexpr std::uint32_t kRamp = 0x40;
        std::vector<catalog::RegisterInfo> registers{
            reference(kModeId, "CONTROL_MODE", catalog::SetPoint::None, ""),
            reference(kSpeedId, "SPEED_REF", catalog::SetPoint::Speed, "rpm"),
            reference(kRamp, "SPEED_RAMP", catalog::SetPoint::None, "")};
        registers.back().type = catalog::ValueType::Raw;
        const catalog::Catalog board(std::move(registers), 1, {{}}, kStartNames);
        const auto id = [&](std::uint32_t bare) {
            return board.withMotor(*board.find(RegisterId{bare}), 1);
        };
        QCOMPARE(startRegisters(board, 1), (std::vector{id(kModeId), id(kRamp), id(kSpeedId)}));
        std::map<RegisterId, catalog::Value> held{
            {id(kModeId), std::int64_t{3}}, {id(kSpeedId), std::int64_t{1380}}};
        const auto rpm = [&] {
            return startTarget(board, {}, 1, [&](RegisterId of) -> std::optional<catalog::Value> {
                const auto found = held.find(of);
                return found == held.end() ? std::nullopt : std::optional(found->second);
            }).rpm;
        };
        QCOMPARE(rpm(), 1380.0); // a board that does not tell its ramp
        held[id(kRamp)] = Bytes{0x30, 0xF8, 0xFF, 0xFF, 0, 0}; // -2000 rpm at once
        QCOMPARE(rpm(), -2000.0);
        held[id(kRamp)] = Bytes{0x30, 0xF8}; // no such structure
        QCOMPARE(rpm(), 1380.0);
        held[id(kModeId)] = std::int64_t{4};
        QVERIFY(!rpm());
    }

    /// Nor is a current, whose reference is 0 at rest.
    void theLastTorqueRampIsWhereAStartGoes()
    {
        constexpr std::uint32_t kRamp = 0x40;
        std::vector<catalog::RegisterInfo> registers{
            reference(kModeId, "CONTROL_MODE", catalog::SetPoint::None, ""),
            reference(kCurrentId, "I_Q_REF", catalog::SetPoint::Current, "A"),
            reference(kRamp, "TORQUE_RAMP", catalog::SetPoint::None, "")};
        registers.back().type = catalog::ValueType::Raw;
        const catalog::Catalog board(std::move(registers), 1, {{}},
            {{"CONTROL_MODE"}, {"SPEED_RAMP"}, {"SPEED_REF"}, {"I_Q_REF"}, catalog::controlModeOf,
                "TORQUE_RAMP"});
        const auto id = [&](std::uint32_t bare) {
            return board.withMotor(*board.find(RegisterId{bare}), 1);
        };
        QCOMPARE(startRegisters(board, 1), (std::vector{id(kModeId), id(kRamp), id(kCurrentId)}));
        std::map<RegisterId, catalog::Value> held{
            {id(kModeId), std::int64_t{4}}, {id(kCurrentId), std::int64_t{0}}};
        const auto amps = [&] {
            return startTarget(board, {}, 1, [&](RegisterId of) -> std::optional<catalog::Value> {
                const auto found = held.find(of);
                return found == held.end() ? std::nullopt : std::optional(found->second);
            }).amps;
        };
        QCOMPARE(amps(), 0.0); // a board that does not tell its ramp
        held[id(kRamp)] = Bytes{0xF0, 0xFF, 0x64, 0x00}; // -16 digits in 100 ms
        QCOMPARE(amps(), -16.0);
        held[id(kRamp)] = Bytes{0, 0, 0, 0};
        held[id(kCurrentId)] = std::int64_t{3};
        QCOMPARE(amps(), 3.0);
    }

    void whatIsNotThereOrNotReadIsNotGuessed()
    {
        const auto board = catalogOf("CONTROL_MODE", "SPEED_REF", nullptr);
        const auto id = [&](std::uint32_t bare) {
            return board->withMotor(*board->find(RegisterId{bare}), 1);
        };
        QVERIFY((startRegisters(*board, 1) == std::vector{id(kModeId), id(kSpeedId)}));
        QVERIFY(!targetOf(*board, 1, {{id(kSpeedId), 900.0}}).rpm); // the mode was not read
        QVERIFY(!targetOf(*board, 1, {{id(kModeId), 3.0}}).rpm);
        QVERIFY(targetOf(*board, 1, {{id(kModeId), 3.0}}).control == catalog::ControlMode::Speed);
        QVERIFY(!targetOf(*board, 1, {{id(kModeId), 4.0}, {id(kSpeedId), 900.0}}).amps);
        const auto none = catalogOf(nullptr, "SPEED_REF", nullptr);
        QVERIFY(targetOf(*none, 1, {{none->withMotor(*none->find(RegisterId{kSpeedId}), 1), 900.0}})
                    .control
            == catalog::ControlMode::Other);
    }

    void aServosModeWordCountsInItsOwnNumbers()
    {
        const auto board = catalogOf("DRV_OP_CMD", "CL_VEL_SET_POINT_VALUE", "CL_CUR_Q_SET_POINT",
            {{"DRV_OP_CMD"}, {}, {"CL_VEL_SET_POINT_VALUE"}, {"CL_CUR_Q_SET_POINT"}, mcbControlOf});
        const auto id = [&](std::uint32_t bare) {
            return board->withMotor(*board->find(RegisterId{bare}), 1);
        };
        const auto controlOf = [&](double mode) {
            return targetOf(
                *board, 1, {{id(kModeId), mode}, {id(kSpeedId), 600.0}, {id(kCurrentId), 1.5}});
        };
        QVERIFY(controlOf(0x03).control == catalog::ControlMode::Speed); // cyclic velocity
        QVERIFY(controlOf(0x03).rpm == 600.0);
        QVERIFY(controlOf(0x02).control == catalog::ControlMode::Torque); // cyclic current
        QVERIFY(controlOf(0x02).amps == 1.5);
    }
};

QTEST_GUILESS_MAIN(TestStartTarget)
#include "tst_start_target.moc"
