// One session of a user with each kind of board, through the real window, the real session thread and a simulated
// board: connect by Auto, arm, set-points with every exchange where the board can, start, two signals on the scope,
// change a gain, undo it, turn the shaft to an angle where the board can, ramp, stop, write a CSV file. The steps name
// no kind of board: a new one is a row.
#include "support/window_rig.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/control/panel.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/view.h"
#include "widgets/window/connect_bar.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

using drive::MotorState;

class TestBoardsSession : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyBoardIsDrivenInTheSameWindow_data();
    void everyBoardIsDrivenInTheSameWindow();
    void theSpeedIsBelowTheCurrentsWhicheverComesFirst();
    void aBoardThatIsSilentWhenThePortOpensIsFoundInOneCall_data();
    void aBoardThatIsSilentWhenThePortOpensIsFoundInOneCall();
    void anotherBoardIsToldInThePicture();
    void theSpeedIsThatOfTheNextBoardsSensor();
    void theToolsShareWhatTheyAreTold();

private:
    void lookAtTheFirstPicture();
    void disconnectNow();
    void connectByAuto(const QString &path, const QByteArray &protocol);
    void armTheMotor();
    void sendWithEveryExchange();
    void startTheMotor();
    void drawTwoSignals();
    void changeAGainAndUndo(const char *name);
    void findTheGainInItsForm(const char *name);
    void turnTheShaft();
    void rampAndStop();
    void writeCsv();

    widgets::Device &device() { return m_rig->workbench.device(); }
    MotorState state() { return device().status(1).state; }
    catalog::RegisterId idOf(const char *name) { return *device().catalog()->resolve(name); }
    double shown(const char *name)
    {
        return m_rig->workbench.registers().shownValue(idOf(name)).value_or(0.0);
    }
    std::uint64_t samplesOf(const char *name)
    {
        const auto &capture = m_rig->workbench.capture();
        return capture.size(capture.find(idOf(name)).value_or(0));
    }

    std::unique_ptr<facts::WindowRig> m_rig;
};

void TestBoardsSession::everyBoardIsDrivenInTheSameWindow_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QByteArray>("protocol");
    QTest::addColumn<QByteArray>("gain");
    QTest::newRow("newer serial protocol")
        << QStringLiteral("sim") << QByteArray("MCP over ASPEP") << QByteArray("SPEED_KI");
    QTest::newRow("older serial protocol")
        << QStringLiteral("sim:legacy") << QByteArray("MCP legacy") << QByteArray("SPEED_KI");
    QTest::newRow("its PowerPC dialect")
        << QStringLiteral("sim:powerpc") << QByteArray("MCP PowerPC") << QByteArray("SPEED_KI");
    // Its gains are numbers in physical units, so they have names of their own.
    QTest::newRow("SPI protocol") << QStringLiteral("sim:mcb") << QByteArray("MCB over SPI")
                                  << QByteArray("CL_VEL_PID_KI");
}

void TestBoardsSession::everyBoardIsDrivenInTheSameWindow()
{
    QFETCH(QString, path);
    QFETCH(QByteArray, protocol);
    QFETCH(QByteArray, gain);
    m_rig = std::make_unique<facts::WindowRig>();
    m_rig->sayYesToMotion();
    m_rig->window.resize(1280, 720);
    QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
    for (const auto &step : {std::function<void()>([&] { connectByAuto(path, protocol); }),
             std::function<void()>([&] { lookAtTheFirstPicture(); }),
             std::function<void()>([&] { armTheMotor(); }),
             std::function<void()>([&] { sendWithEveryExchange(); }),
             std::function<void()>([&] { startTheMotor(); }),
             std::function<void()>([&] { drawTwoSignals(); }),
             std::function<void()>([&] { changeAGainAndUndo(gain.constData()); }),
             std::function<void()>([&] { findTheGainInItsForm(gain.constData()); }),
             std::function<void()>([&] { turnTheShaft(); }),
             std::function<void()>([&] { rampAndStop(); }),
             std::function<void()>([&] { writeCsv(); })}) {
        step();
        if (QTest::currentTestFailed())
            break;
    }
    m_rig.reset();
}

/// An inertia that is typed into one form stands in the other; the page of snapshots has the Save of the menu.
void TestBoardsSession::theToolsShareWhatTheyAreTold()
{
    m_rig = std::make_unique<facts::WindowRig>();
    QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
    connectByAuto(QStringLiteral("sim"), "MCP over ASPEP");
    for (const char *tool : {"gainsDockOpen", "revUpDockOpen", "snapshotsDockOpen"})
        m_rig->find<QAction>(tool)->trigger();
    auto *typed = m_rig->find<QLineEdit>("labInertia");
    QTRY_VERIFY(typed->isEnabled());
    const auto isTold = [&] { // once the name of the motor is known
        typed->selectAll();
        QTest::keyClicks(typed, QStringLiteral("512.5"));
        QTest::keyClick(typed, Qt::Key_Return);
        return m_rig->find<QLineEdit>("revUpInertia")->placeholderText() == QStringLiteral("512.5");
    };
    QTRY_VERIFY(isTold());
    const auto *save = m_rig->find<QPushButton>("snapshotSave");
    QVERIFY(save != nullptr && save->isEnabled());
    m_rig.reset();
}

void TestBoardsSession::connectByAuto(const QString &path, const QByteArray &protocol)
{
    auto *bar = m_rig->find<widgets::ConnectBar>("connectBar");
    QCOMPARE(m_rig->find<QComboBox>("protocol")->currentText(), QStringLiteral("Auto"));
    bar->setEndpoint(path, 1843200);
    QTest::mouseClick(m_rig->find<QPushButton>("connect"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(device().answering() && device().identified(), 20000);
    const drive::Identity &identity = device().identified()->identity;
    QVERIFY2(identity.protocol.starts_with(protocol.toStdString()), identity.protocol.c_str());
    QVERIFY(!identity.evidence.empty() || protocol.contains("SPI")); // its port says it all
    QVERIFY(!device().armed());
    QTRY_COMPARE(state(), MotorState::Idle);
}

/// The speed of the sensor that closes the loop, at the full rate where the board streams, below the currents.
void TestBoardsSession::lookAtTheFirstPicture()
{
    const auto &plan = m_rig->workbench.signalPlan();
    const auto &told = device().identified()->identity.speedSignals;
    const std::string name = told.empty() || told[0].empty() ? "SPEED_MEAS" : told[0];
    const auto speed = idOf(name.c_str());
    const auto *wanted = plan.find(speed);
    QVERIFY2(wanted != nullptr, name.c_str());
    const bool streams = device().capability(drive::Feature::Stream).available;
    const auto &planned = plan.planned().signalList;
    const auto its = std::find_if(
        planned.begin(), planned.end(), [speed](const auto &one) { return one.id == speed; });
    QVERIFY(its != planned.end());
    QCOMPARE(its->route == widgets::Route::Fast, streams);
    const auto plotOf = [&](catalog::RegisterId id) {
        const auto channel = plan.channelOf(id);
        return channel ? m_rig->window.scope()->plotOf(*channel) : -1;
    };
    for (const widgets::WantedSignal &signal : plan.wanted())
        QTRY_VERIFY(plotOf(signal.id) >= 0);
    for (const widgets::WantedSignal &signal : plan.wanted())
        if (signal.id != speed)
            QVERIFY(plotOf(signal.id) < plotOf(speed));
}

void TestBoardsSession::armTheMotor()
{
    device().setUserLimits({3000.0, 0.0});
    if (!gapsIn(device().limits(1)).empty()) { // a board that does not tell all its limits
        device().becomeExpert(1);
        QTRY_VERIFY(device().expert(1));
    }
    QTest::keyClick(m_rig->find<QCheckBox>("arm"), Qt::Key_Space);
    QTRY_VERIFY(device().armed());
}

/// Where it cannot, the box says why.
void TestBoardsSession::sendWithEveryExchange()
{
    auto *box = m_rig->find<QCheckBox>("cyclicSetPoints");
    const auto can = device().capability(drive::Feature::CyclicSetPoints);
    QVERIFY(!box->isChecked());
    if (!can.available) {
        QVERIFY(!box->isEnabled());
        QVERIFY(!can.reason.empty());
        QVERIFY(box->toolTip().contains(QString::fromStdString(can.reason).left(20)));
        return;
    }
    QTRY_VERIFY(box->isEnabled());
    QTest::keyClick(box, Qt::Key_Space);
    QVERIFY(!box->isChecked()); // until the drive does
    QTRY_VERIFY(box->isChecked());
    QVERIFY(device().cyclicSetPoints());
}

void TestBoardsSession::startTheMotor()
{
    QTRY_VERIFY(m_rig->find<QPushButton>("start")->isEnabled());
    QTest::mouseClick(m_rig->find<QPushButton>("start"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(state(), MotorState::Running, 15000);
}

void TestBoardsSession::drawTwoSignals()
{
    for (const char *name : {"SPEED_MEAS", "I_Q_MEAS"})
        m_rig->window.selection()->add(idOf(name), 0);
    for (const char *name : {"SPEED_MEAS", "I_Q_MEAS"}) {
        QTRY_VERIFY(samplesOf(name) > 0);
        const auto before = samplesOf(name);
        QTRY_VERIFY(samplesOf(name) > before + 5);
    }
}

void TestBoardsSession::changeAGainAndUndo(const char *name)
{
    auto &registers = m_rig->workbench.registers();
    auto &edits = m_rig->workbench.edits();
    const auto gain = idOf(name);
    m_rig->find<QLineEdit>("registerSearch")->setText(QLatin1String(name)); // what is seen is read
    QTRY_VERIFY(registers.known(gain).has_value());
    const catalog::Value before = *registers.known(gain);
    const auto *digits = std::get_if<std::int64_t>(&before);
    const catalog::Value after =
        digits ? catalog::Value(*digits + 1) : catalog::Value(std::get<double>(before) * 2.0);
    registers.setPending(gain, after);
    edits.apply();
    QTRY_VERIFY(!edits.underWay() && registers.known(gain) == after);
    QCOMPARE(edits.steps().count(), 1);
    edits.undo();
    QTRY_VERIFY(!edits.underWay() && registers.known(gain) == before);
}

/// With what it is worth, or why that cannot be said; where the lab has no rule for it, it says so and offers nothing.
void TestBoardsSession::findTheGainInItsForm(const char *name)
{
    auto *worth = m_rig->find<QLabel>((QByteArray("physical_") + name).constData());
    QTRY_VERIFY(!worth->isHidden());
    QTRY_VERIFY(!worth->text().isEmpty());
    const std::string unit = device().catalog()->find(name)->unit;
    if (device().catalog()->find("SPEED_KI") == nullptr) {
        QCOMPARE(worth->text(), QString::fromStdString(unit));
        QVERIFY(m_rig->find<QLabel>("physical_POSITION_KP")->isHidden()); // one row a loop
        QVERIFY(!m_rig->find<QPushButton>("labPreview")->isEnabled());
        QVERIFY(
            m_rig->find<QPushButton>("labPreview")->toolTip().contains(QStringLiteral("units")));
        auto *ramp = m_rig->find<widgets::NumberEdit>("rampSpeed"); // a number with fractions
        ramp->setText(QStringLiteral("2000"));
        QCOMPARE(ramp->sentValue(), std::optional(2000.0));
        QVERIFY(!m_rig->find<QLabel>("rampSpeedNote")->text().contains(QStringLiteral("6 rpm")));
    }
}

/// Where it cannot, the list says why.
void TestBoardsSession::turnTheShaft()
{
    auto *mode = m_rig->find<QComboBox>("setpointMode");
    const int row = mode->findText(QStringLiteral("Position"));
    const auto can = device().capability(drive::Feature::PositionRamp);
    const auto flags = mode->model()->flags(mode->model()->index(row, 0));
    QCOMPARE(flags.testFlag(Qt::ItemIsEnabled), can.available);
    if (!can.available) {
        QVERIFY(mode->itemData(row, Qt::ToolTipRole)
                    .toString()
                    .contains(QString::fromStdString(can.reason).left(20)));
        return;
    }
    mode->setCurrentIndex(row);
    const auto degrees = [now = m_rig->find<QLabel>("shaftNow")] {
        bool read = false;
        const double number = now->text().section(QChar(0x202f), 0, 0).toDouble(&read);
        return read ? std::optional(number) : std::nullopt;
    };
    QTRY_VERIFY(degrees());
    const double target = std::round(*degrees()) + 90.0;
    auto *field = m_rig->find<widgets::NumberEdit>("position");
    auto *time = m_rig->find<widgets::NumberEdit>("rampTime");
    const QString before = time->text();
    field->setValue(target);
    time->setValue(800.0);
    const int asked = m_rig->questions;
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(degrees() && std::abs(*degrees() - target) < 3.0, 15000);
    QCOMPARE(m_rig->questions, asked + 1); // it goes there by itself, and stays
    time->setText(before);
    mode->setCurrentIndex(0);
}

void TestBoardsSession::rampAndStop()
{
    auto *speed = m_rig->window.findChild<widgets::ControlPanel *>()->speed();
    speed->setText(QStringLiteral("1200"));
    QTest::keyClick(speed, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(shown("SPEED_MEAS") - 1200.0) < 60.0, 15000);
    QTest::keyClick(&m_rig->window, Qt::Key_Escape);
    QVERIFY(!device().armed());
    QTRY_COMPARE_WITH_TIMEOUT(state(), MotorState::Idle, 5000);
}

void TestBoardsSession::writeCsv()
{
    // As this board calls it.
    const std::string speed = device().catalog()->nameOf(idOf("SPEED_MEAS"));
    QTest::mouseClick(m_rig->find<QPushButton>("connect"), Qt::LeftButton); // nothing more is added
    QTRY_VERIFY(!device().portOpen());
    QTemporaryDir folder;
    m_rig->files.answer = folder.filePath(QStringLiteral("capture.csv"));
    m_rig->window.findChild<widgets::Exporting *>()->ask();
    QTest::mouseClick(m_rig->find<QPushButton>("exportSave"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(m_rig->files.answer), 20000);
    QFile file(m_rig->files.answer);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray heading = file.readLine();
    QVERIFY2(heading.contains(speed.c_str()), heading.constData());
    QVERIFY(!file.readLine().isEmpty());
}

void TestBoardsSession::disconnectNow()
{
    m_rig->find<widgets::ConnectBar>("connectBar")->disconnectNow();
    QTRY_VERIFY(!device().portOpen());
}

void TestBoardsSession::theSpeedIsBelowTheCurrentsWhicheverComesFirst()
{
    for (const bool speedFirst : {true, false}) {
        m_rig = std::make_unique<facts::WindowRig>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        facts::connectBoard(device());
        const auto read = [this] {
            facts::feed(device(),
                {drive::RegistersRead{{facts::reading(facts::kSpeed, std::int64_t{100})}}});
        };
        const auto stream = [this] {
            facts::feed(device(),
                {drive::StreamStarted{capture::StreamLayout{1, 1000.0, 0.0, 1,
                     {{facts::kCurrentA, "I_A", "A", 0.002, 0.0},
                         {facts::kCurrentB, "I_B", "A", 0.002, 0.0}},
                     {}}},
                    capture::SampleBlock{1, 0, 2, {1, 2, 3, 4}, {}, 0}});
        };
        speedFirst ? read() : stream();
        QCoreApplication::processEvents();
        speedFirst ? stream() : read();
        const auto plotOf = [this](catalog::RegisterId id) {
            const auto channel = m_rig->workbench.signalPlan().channelOf(id);
            return channel ? m_rig->window.scope()->plotOf(*channel) : -1;
        };
        QTRY_COMPARE(plotOf(facts::kSpeed), 1);
        QCOMPARE(plotOf(facts::kCurrentA), 0);
        QCOMPARE(plotOf(facts::kCurrentB), 0);
        device().portChanged(session::PortState::Closed, {});
        m_rig.reset();
    }
}

void TestBoardsSession::aBoardThatIsSilentWhenThePortOpensIsFoundInOneCall_data()
{
    QTest::addColumn<int>("silent_ms");
    for (const int silent : {200, 1700, 3300})
        QTest::addRow("%d ms", silent) << silent;
}

/// Reset by the port's lines, booting, held by a debugger: one click, and no word of a failure.
void TestBoardsSession::aBoardThatIsSilentWhenThePortOpensIsFoundInOneCall()
{
    QFETCH(int, silent_ms);
    m_rig = std::make_unique<facts::WindowRig>();
    m_rig->boards.silentAtFirst = std::chrono::milliseconds(silent_ms);
    QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
    bool lost = false;
    connect(&device(), &widgets::Device::linkStateChanged, this,
        [&] { lost = lost || device().link().state == drive::LinkState::Lost; });
    connectByAuto(QStringLiteral("sim"), QByteArray("MCP over ASPEP"));
    QVERIFY(!lost);
    m_rig.reset();
}

/// Firmware takes a sensor's speed that it does not have, and sends zeros.
void TestBoardsSession::theSpeedIsThatOfTheNextBoardsSensor()
{
    m_rig = std::make_unique<facts::WindowRig>();
    QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
    const auto names = [this] {
        QStringList all;
        for (const auto &signal : m_rig->workbench.signalPlan().wanted())
            all.append(QString::fromStdString(device().catalog()->nameOf(signal.id))
                + QLatin1Char(' ') + QString::number(static_cast<int>(signal.route)));
        return all;
    };
    const auto meet = [&](const char *sensor) {
        drive::Identified board = facts::identified();
        board.identity.controlBoard = sensor;
        board.identity.speedSignals = {sensor};
        std::vector<catalog::RegisterInfo> registers = board.catalog->registers();
        for (const auto &[name, id] :
            {std::pair("STOPLL_ROT_SPEED", 0xB90U), std::pair("ENCODER_SPEED", 0xB10U)}) {
            registers.push_back(facts::makeRegister(id, name, "Measurements"));
            registers.back().streaming = catalog::Streaming::Fast;
        }
        board.catalog = std::make_shared<const catalog::Catalog>(
            std::move(registers), 1, std::vector<catalog::Scales>(1));
        device().portChanged(session::PortState::Open, {});
        facts::feed(device(),
            {drive::LinkChanged{drive::LinkState::Connected, drive::LinkReason::None}, board});
    };
    meet("STOPLL_ROT_SPEED");
    const QStringList pll = names();
    QVERIFY2(pll.last().startsWith(QStringLiteral("STOPLL_ROT_SPEED")),
        qPrintable(pll.join(QLatin1Char(','))));
    device().portChanged(session::PortState::Closed, {});
    meet("ENCODER_SPEED");
    QCOMPARE(names(),
        QStringList(pll).replaceInStrings(
            QStringLiteral("STOPLL_ROT_SPEED"), QStringLiteral("ENCODER_SPEED")));
    // And over a restart: a workspace keeps what it is, not what it was called.
    const auto kept = m_rig->workbench.signalPlan().named();
    QCOMPARE(QString::fromStdString(kept.back().name), QStringLiteral("main-speed@1"));
    device().portChanged(session::PortState::Closed, {});
    m_rig = std::make_unique<facts::WindowRig>();
    m_rig->workbench.signalPlan().setNamed(kept);
    meet("STOPLL_ROT_SPEED");
    QCOMPARE(names(), pll);
    m_rig.reset();
}

void TestBoardsSession::anotherBoardIsToldInThePicture()
{
    m_rig = std::make_unique<facts::WindowRig>();
    QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
    const auto told = [this] {
        QStringList lines;
        for (const widgets::ScopeEvent &event : m_rig->workbench.events().events())
            if (event.text.startsWith(QStringLiteral("Another board: ")))
                lines.append(event.text);
        return lines;
    };
    for (int again = 0; again < 2; ++again) { // the same one, after its cable was out
        connectByAuto(QStringLiteral("sim"), QByteArray("MCP over ASPEP"));
        QTRY_VERIFY(m_rig->window.scope()->channels().size() >= 4);
        disconnectNow();
    }
    QCOMPARE(told(), QStringList());
    connectByAuto(QStringLiteral("sim:legacy"), QByteArray("MCP legacy"));
    QCOMPARE(told().size(), 1);
    const auto &identity = device().identified()->identity;
    QVERIFY2(told().front().contains(QString::fromStdString(identity.firmware)),
        qPrintable(told().front()));
    disconnectNow();
    // What is polled holds for seconds, and not beyond its link.
    const auto board = [](const char *name) {
        drive::Identified one = facts::identified();
        one.identity.controlBoard = name;
        return one;
    };
    const auto meet = [&](const char *name, double seconds) {
        device().portChanged(session::PortState::Open, {});
        facts::feed(device(),
            {drive::LinkChanged{drive::LinkState::Connected, drive::LinkReason::None},
                board(name)});
        drive::Reading speed = facts::reading(facts::kSpeed, std::int64_t{100});
        speed.at = TimePoint(fromSeconds(seconds));
        facts::feed(device(), {drive::RegistersRead{{speed}}});
        device().portChanged(session::PortState::Closed, {});
    };
    m_rig->workbench.signalPlan().clear();
    const double begin = 1000.0;
    meet("one", begin);
    meet("one", begin + 1.0);
    meet("other", begin + 2.0);
    const auto &capture = m_rig->workbench.capture();
    const auto channel = capture.find(facts::kSpeed, capture::ChannelInfo::Kind::Polled);
    QVERIFY(channel);
    QVERIFY(!capture.valueAt(*channel, begin + 0.5).has_value());
    QCOMPARE(capture.channel(*channel)->values()->runs().size(), std::size_t{3});
    QVERIFY(told().back().endsWith(QStringLiteral("other")));
    m_rig.reset();
}

QTEST_MAIN(TestBoardsSession)
#include "tst_boards_session.moc"
