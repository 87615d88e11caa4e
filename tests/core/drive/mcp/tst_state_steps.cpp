// The steps in which a drive tells the states of a run.
#include "catalog/names.h"
#include "drive/mcp/mcp_vitals.h"

#include <QTest>

#include <set>

using namespace drive;

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
};

QTEST_GUILESS_MAIN(TestStateSteps)
#include "tst_state_steps.moc"
