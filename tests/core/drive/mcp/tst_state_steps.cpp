// The steps in which a drive tells the states of a run, and what it makes of the numbers of ST's firmware.
#include "catalog/names.h"
#include "drive/mcp/vitals.h"

#include <QTest>

#include <set>

using namespace drive;

namespace {

constexpr NumberedStep kFewSteps[] = {{MotorState::Idle, {0}}, {MotorState::Starting, {4, 12}}};

std::string stateName(std::int64_t number) { return catalog::valueName("STATUS", number); }

} // namespace

class TestStateSteps : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyNamedStateIsInOneStep()
    {
        std::set<std::string> seen;
        for (const StateStep &step : McpProtocol::stateSteps()) {
            QVERIFY(step.state != MotorState::Unknown);
            QVERIFY(!step.names.empty());
            for (const std::string &name : step.names)
                QVERIFY2(seen.insert(name).second, name.c_str());
        }
        for (const catalog::NamedValue &value : catalog::namedValues("STATUS"))
            QVERIFY2(seen.contains(std::string(value.name)), std::string(value.name).c_str());
    }
    /// Faults: past ones in the low half, present ones in the high half (registers.csv, FAULTS_FLAGS).
    void numbersBecomeAStatus()
    {
        const MotorStatus waits = numberedStatus(kFewSteps, stateName, 12.0, double{0x00020004});
        QVERIFY(waits.state == MotorState::Starting && waits.waitsForBus);
        QCOMPARE(waits.rawState, std::int64_t{12});
        QCOMPARE(waits.stateName, "ICLWAIT");
        QCOMPARE(waits.faultsNow, std::vector<std::string>{"OVER_VOLT"});
        QCOMPARE(waits.faultsPast, std::vector<std::string>{"UNDER_VOLT"});
        const MotorStatus starts = numberedStatus(kFewSteps, stateName, 4.0, std::nullopt);
        QVERIFY(starts.state == MotorState::Starting && !starts.waitsForBus);
        QVERIFY(starts.faultsNow.empty() && starts.faultsPast.empty());
        // In no step, and refused.
        for (const auto state : {std::optional(6.0), std::optional<double>()}) {
            const MotorStatus unknown =
                numberedStatus(kFewSteps, stateName, state, double{0x80000000});
            QVERIFY(unknown.state == MotorState::Unknown && !unknown.waitsForBus);
            QCOMPARE(unknown.faultsNow.size(), std::size_t{1});
        }
    }
};

QTEST_GUILESS_MAIN(TestStateSteps)
#include "tst_state_steps.moc"
