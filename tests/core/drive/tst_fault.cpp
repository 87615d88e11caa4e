// The names of faults and states that a drive tells.
#include "catalog/names.h"
#include "drive/fault.h"
#include "drive/mcp/mcp_vitals.h"

#include <QTest>

#include <set>

using namespace drive;

class TestFault : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyNamedFaultHasAKind()
    {
        for (unsigned bit = 0; bit < 16; ++bit)
            for (const std::string &name :
                catalog::faultNames(static_cast<std::uint16_t>(1U << bit)))
                QCOMPARE(faultKindOf(name) == FaultKind::Other, name.starts_with("bit "));
        QVERIFY(faultKindOf("") == FaultKind::Other);
        QVERIFY(faultKindOf("over_volt ") == FaultKind::Other);
    }

    void everyNamedStateIsInOneStep()
    {
        std::set<std::string> seen;
        for (const StateStep &step : stateSteps()) {
            QVERIFY(step.state != MotorState::Unknown);
            QVERIFY(!step.names.empty());
            for (const std::string &name : step.names)
                QVERIFY2(seen.insert(name).second, name.c_str());
        }
        for (const catalog::NamedValue &value : catalog::namedValues("STATUS"))
            QVERIFY2(seen.contains(std::string(value.name)), std::string(value.name).c_str());
    }
};

QTEST_GUILESS_MAIN(TestFault)
#include "tst_fault.moc"
