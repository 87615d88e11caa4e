// A board with two motors: the panel shows and moves the one that is chosen, and no other.
#include "support/edit_bench.h"
#include "widgets/control_panel.h"
#include "widgets/motion_gate.h"
#include "widgets/setpoint_edit.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>

using namespace std::chrono_literals;
using drive::MotorState;

namespace {

simulation::BoardOptions twoMotors()
{
    simulation::BoardOptions options;
    options.motors = 2;
    return options;
}

struct PanelBench : facts::EditBench {
    widgets::MotionGate gate{device, model};
    widgets::ControlPanel control{device, model, gate};

    PanelBench()
        : EditBench(twoMotors())
    {
        QObject::connect(&gate, &widgets::MotionGate::asked, &gate, &widgets::MotionGate::confirm);
        QObject::connect(&device, &widgets::Device::motorChanged, &control,
            [this] { model.setCatalog(device.catalog(), device.motor()); });
        QObject::connect(&device, &widgets::Device::stopWished, &control, [this] {
            link.drive->stop(link.now);
            link.exchange();
        });
        control.show();
    }
    ~PanelBench() { link.onEvent = nullptr; }

    MotorState state(int motor) { return link.status[motor].state; }
    double speed(int motor) { return link.status[motor].speedRpm.value_or(0.0); }
    QString text(const char *name) const
    {
        return control.findChild<QLabel *>(QLatin1String(name))->text();
    }
    /// The motors of all motor commands and set-points that have left since `since`.
    std::set<unsigned> motorsCommanded(std::size_t since) const
    {
        std::set<unsigned> motors;
        for (std::size_t i = since; i < link.requests.size(); ++i) {
            const auto request = mcp::decodeRequest(link.requests[i]);
            if (!request || !support::changesSomething(link.requests[i]))
                continue;
            if (mcp::isMotorCommand(request->command))
                motors.insert(request->motor);
            else if (request->command == static_cast<std::uint16_t>(mcp::CommandId::SetRegister))
                for (const auto &write : mcp::decodeSetList(request->content).writes)
                    motors.insert(write.id.motor());
        }
        return motors;
    }
};

} // namespace

class TestTwoMotors : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void thePanelMovesTheChosenMotorOnly()
    {
        PanelBench bench;
        QCOMPARE(bench.device.identified()->identity.motors, 2);
        bench.device.setMotor(2);
        bench.arm();
        const std::size_t before = bench.link.requests.size();
        bench.control.start();
        QVERIFY(bench.link.runUntil([&] { return bench.state(2) == MotorState::Running; }, 15s));
        bench.control.speed()->setText(QStringLiteral("1200"));
        QTest::keyClick(bench.control.speed(), Qt::Key_Return);
        QVERIFY(bench.link.runUntil([&] { return std::abs(bench.speed(2) - 1200) < 60; }, 10s));
        QVERIFY(bench.state(1) == MotorState::Idle);
        QVERIFY(std::abs(bench.speed(1)) < 10.0);
        QCOMPARE(bench.motorsCommanded(before), std::set<unsigned>{2});
    }

    void whatIsShownIsTheChosenMotors()
    {
        PanelBench bench;
        bench.device.setMotor(2);
        bench.arm();
        bench.control.start();
        QVERIFY(bench.link.runUntil([&] { return bench.state(2) == MotorState::Running; }, 15s));
        QVERIFY(bench.text("motorState").contains(QStringLiteral("Motor 2")));
        QVERIFY(bench.text("motorState").contains(QStringLiteral("Running")));
        bench.device.setMotor(1);
        QVERIFY(bench.text("motorState").contains(QStringLiteral("Motor 1")));
        QVERIFY(bench.text("motorState").contains(QStringLiteral("Idle")));
        QVERIFY(bench.control.findChild<QPushButton *>(QStringLiteral("start"))->isEnabled());
        for (const catalog::RegisterId id : bench.control.watchedRegisters())
            if (bench.device.catalog()->find(id)->perMotor)
                QCOMPARE(bench.device.catalog()->motorOf(id), 1);
    }

    void stopIsForBoth()
    {
        PanelBench bench;
        bench.arm();
        for (const int motor : {1, 2}) {
            bench.device.setMotor(motor);
            bench.control.start();
            QVERIFY(bench.link.runUntil(
                [&] { return bench.state(motor) == MotorState::Running; }, 15s));
        }
        bench.device.stop();
        QVERIFY(bench.link.runUntil(
            [&] {
                return bench.state(1) == MotorState::Idle && bench.state(2) == MotorState::Idle;
            },
            5s));
    }

    void eachMotorsFirstStartIsAskedAbout()
    {
        PanelBench bench;
        int asked = 0;
        connect(&bench.gate, &widgets::MotionGate::asked, this, [&] { ++asked; });
        bench.arm();
        for (const int motor : {1, 2}) {
            bench.device.setMotor(motor);
            bench.control.start();
            QVERIFY(bench.link.runUntil(
                [&] { return bench.state(motor) == MotorState::Running; }, 15s));
        }
        QCOMPARE(asked, 2);
    }
};

QTEST_MAIN(TestTwoMotors)
#include "tst_two_motors.moc"
