// A board with two motors: the panel shows and moves the one that is chosen, and no other.
#include "support/edit_bench.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/control/motion_gate.h"
#include "widgets/control/panel.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>

using namespace std::chrono_literals;
using catalog::Value;
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
    drive::RegisterId idFor(const char *name, int motor) const
    {
        const auto catalog = device.catalog();
        return catalog->withMotor(*catalog->find(name), motor);
    }
    /// What the board itself holds, asked of it and of nothing that the window keeps.
    catalog::Value heldBy(const char *name, int motor)
    {
        const drive::WishId wish = 2000000 + ++m_asked;
        const drive::RegisterId id = idFor(name, motor);
        link.drive->submit({wish, drive::Read{{id}}}, link.now);
        link.runUntilEnded(wish);
        return link.values[id].value;
    }
    /// In the tree of the motor that is chosen.
    bool typeHere(const char *name, const QString &text)
    {
        return model.setData(
            model.indexOf(*model.idOf(name), widgets::RegisterModel::ValueColumn), text);
    }
    void choose(int motor)
    {
        device.setMotor(motor);
        heldBy("SPEED_KP", motor); // the tree of this motor learns what there is
        heldBy("SPEED_KI", motor);
        heldBy("I_Q_KP", motor);
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

private:
    drive::WishId m_asked = 0;
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

    void editsOfBothMotorsAreAppliedTogetherAndTakenBack()
    {
        PanelBench bench;
        bench.answerYes = true;
        bench.arm();
        const std::array<const char *, 3> names{"SPEED_KP", "SPEED_KI", "I_Q_KP"};
        std::map<std::pair<int, std::string>, Value> before, wanted;
        for (const int motor : {1, 2})
            for (const char *name : names)
                before[{motor, name}] = bench.heldBy(name, motor);
        wanted = before;
        const auto type = [&](int motor, const char *name, int value) {
            QCOMPARE(bench.device.motor(), motor);
            QVERIFY(bench.typeHere(name, QString::number(value)));
            wanted[{motor, name}] = Value(std::int64_t{value});
        };
        bench.choose(1);
        type(1, "SPEED_KP", 111);
        type(1, "I_Q_KP", 112);
        bench.choose(2);
        type(2, "SPEED_KP", 221);
        type(2, "SPEED_KI", 222);
        QCOMPARE(bench.edits.pendingCount(), 4);
        // Each tree shows its own motor's wishes and none of the other's.
        const auto wants = [&](const char *name) {
            return bench.model.wanted(*bench.model.idOf(name));
        };
        QVERIFY(wants("SPEED_KP") == Value(std::int64_t{221}));
        QVERIFY((wants("I_Q_KP") == before[{2, "I_Q_KP"}]));
        bench.choose(1);
        QVERIFY(wants("SPEED_KP") == Value(std::int64_t{111}));
        QVERIFY((wants("SPEED_KI") == before[{1, "SPEED_KI"}]));

        const auto board = [&](auto &expected) {
            for (const int motor : {1, 2})
                for (const char *name : names)
                    QVERIFY2((bench.heldBy(name, motor) == expected[{motor, name}]),
                        qPrintable(
                            QStringLiteral("%1 of motor %2").arg(QLatin1String(name)).arg(motor)));
        };
        board(before); // nothing was written yet
        QVERIFY(bench.apply());
        QCOMPARE(bench.edits.pendingCount(), 0);
        board(wanted);
        QCOMPARE(bench.edits.steps().count(), 1);
        bench.choose(2); // whichever motor is shown, the step knows whose its values are
        bench.edits.undo();
        QVERIFY(bench.settle());
        board(before);
        bench.edits.redo();
        QVERIFY(bench.settle());
        board(wanted);
    }

    void anyOrderOfEditsLandsWhereItWasTyped()
    {
        PanelBench bench;
        bench.answerYes = true;
        bench.arm();
        support::Random random(7);
        const std::array<const char *, 3> names{"SPEED_KP", "SPEED_KI", "I_Q_KP"};
        std::map<std::pair<int, std::string>, Value> start, wanted;
        for (const int motor : {1, 2})
            for (const char *name : names)
                start[{motor, name}] = bench.heldBy(name, motor);
        wanted = start;
        for (int round = 0; round < 60; ++round) {
            const int motor = 1 + static_cast<int>(random.below(2));
            if (motor != bench.device.motor())
                bench.choose(motor);
            const char *name = names[random.below(names.size())];
            const auto value = static_cast<std::int64_t>(1 + random.below(3000));
            QVERIFY(bench.typeHere(name, QString::number(value)));
            wanted[{motor, name}] = Value(value);
            if (!random.chance(0.2))
                continue;
            QVERIFY(bench.apply());
            for (const auto &[at, expected] : wanted)
                QVERIFY(bench.heldBy(at.second.c_str(), at.first) == expected);
        }
        bench.edits.revert(); // what was not applied
        while (bench.edits.steps().canUndo()) {
            const int left = bench.edits.steps().index();
            bench.edits.undo();
            QVERIFY(bench.settle());
            QVERIFY(bench.edits.steps().index() < left);
        }
        for (const auto &[at, expected] : start)
            QVERIFY(bench.heldBy(at.second.c_str(), at.first) == expected);
    }

    void aSetPointOfOneMotorIsNotTheNextOnes()
    {
        PanelBench bench;
        bench.arm();
        bench.control.speed()->setText(QStringLiteral("1800"));
        bench.device.setMotor(2);
        QVERIFY(bench.control.speed()->text() != QStringLiteral("1800"));
        bench.device.setMotor(1);
        QVERIFY(bench.control.speed()->text() != QStringLiteral("1800"));
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
