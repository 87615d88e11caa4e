// A replay through the real window and the real session thread: it looks like a board that cannot be touched.
#include "session/recording/file.h"
#include "session/recording/notes.h"
#include "support/recording_facts.h"
#include "support/window_rig.h"
#include "widgets/base/banner.h"
#include "widgets/base/lamp.h"
#include "widgets/base/messages.h"
#include "widgets/files/happening_text.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/trigger/control.h"
#include "widgets/scope/view.h"
#include "widgets/window/connect_bar.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QMessageBox>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTranslator>

using widgets::Banner;

namespace {

constexpr capture::Tick kSecondTicks = 16'000;
constexpr capture::Tick kTicks = 20 * kSecondTicks;
constexpr catalog::RegisterId kTemperature = (50U << 6) | 1U;
constexpr catalog::RegisterId kSquare = (9U << 6) | 1U;

/// Twenty seconds of a square wave of 10 Hz and a ramp at 16 kHz; a motor that runs, a command, a mark.
void writeRecording(const QString &path)
{
    QString text;
    session::RecordingFile file(session::makeDiskSink(path, text), {0, "test", "board"});
    file.open();
    file.add(0, recorded::Happening{"board", {{"firmware", "ST MC SDK"}, {"version", "6.4.0"}}});
    file.add(0,
        capture::StreamLayout{1, 16000.0, 0.0, 1,
            {{kSquare, "SQUARE", "A", 0.01, 0.0}, {(10U << 6) | 1U, "RAMP", "V", 1.0, 0.0}}, {}});
    file.add(0, recorded::PolledRegister{kTemperature, "TEMPERATURE", "\u00b0C"});
    file.add(0, recorded::PolledRegister{kSquare, "SQUARE", "A"}); // for a table
    file.add(0,
        recorded::Happening{
            "motor state", {{"motor", "1"}, {"state", "running"}, {"raw", "6"}, {"name", "RUN"}}});
    for (capture::Tick tick = 0; tick < kTicks; tick += 160) {
        const recorded::Nanos at = (tick + 160) * 62'500;
        capture::SampleBlock block{1, tick, 160, {}, {}, 0};
        for (capture::Tick i = tick; i < tick + 160; ++i)
            block.fast.push_back(i % 1600 < 800 ? -1000 : 1000);
        for (capture::Tick i = tick; i < tick + 160; ++i)
            block.fast.push_back(static_cast<std::int16_t>(i % 30'000));
        file.add(at, std::move(block));
        file.flush(at);
        if (tick == 7 * kSecondTicks || tick == 8 * kSecondTicks) { // the first one is refused
            const std::string wish = tick == 7 * kSecondTicks ? "6" : "7";
            file.add(at, recorded::Happening{"write", {{"SPEED_KP", "520"}, {"wish", wish}}});
            file.add(at + 10'000'000,
                recorded::Happening{"ended",
                    {{"wish", wish}, {"outcome", "ok"}, {"reason", ""},
                        {"SPEED_KP", wish == "6" ? "refused, was 400" : "ok, was 400, is 520"}}});
        }
        if (tick % kSecondTicks == 0)
            file.add(at, recorded::PolledValues{{{kTemperature, at, 25.5}, {kSquare, at, 10.0}}});
    }
    file.add(1'000'000'000,
        recorded::Happening{"speed ramp", {{"motor", "1"}, {"rpm", "500"}, {"ms", "1000"}}});
    file.add(1'500'000'000, recorded::Note{1'500'000'000, 1'500'000'000, "look here"});
    file.end();
}

} // namespace

class TestReplayWindow : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { writeRecording(m_path); }
    void init()
    {
        m_rig = std::make_unique<facts::WindowRig>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        m_rig->workbench.replay().setSpeed(0.0);
    }
    void cleanup() { m_rig.reset(); }

    void allOfItComesInTheWindowWhateverThePace()
    {
        replay();
        QTRY_VERIFY(text()->text().contains(QStringLiteral("its end")));
        QVERIFY(m_rig->find<QWidget>("replayBar")->isVisible());
        QCOMPARE(m_rig->find<QAction>("scopeRun")->text(), QStringLiteral("Replay"));
        for (const char *name : {"portLamp", "boardLamp"}) // no port, and no board
            QVERIFY(m_rig->find<widgets::Lamp>(name)->light() == widgets::Lamp::Light::Off);
        QCOMPARE(
            m_rig->find<widgets::Lamp>("boardLamp")->text(), QStringLiteral("board as recorded"));
        QVERIFY(text()->text().startsWith(QStringLiteral("a.pcapng: 0:00:")));
        QCOMPARE(device().droppedForDisplay(), 0U);
        QCOMPARE(scope()->channels().size(), 2); // what was streamed, a plot for each unit
        QCOMPARE(scope()->plotCount(), 2);
        const auto recorded = support::readRecording(m_path);
        for (const auto &info : recorded.capture.channels()) {
            const capture::Channel *from = recorded.capture.channel(info.id);
            QTRY_VERIFY(capture().find(info.registerId, info.kind));
            const auto found = capture().find(info.registerId, info.kind);
            QTRY_COMPARE(capture().size(*found), from->size());
            const capture::Channel *to = capture().channel(*found);
            const capture::Nanos shift = to->timeOf(to->begin()) - from->timeOf(from->begin());
            for (capture::Index i = 0; i < from->end(); ++i)
                if (to->at(i) != from->at(i) || to->timeOf(i) - shift != from->timeOf(i))
                    QFAIL("a sample differs");
        }
        QTRY_VERIFY(eventTexts().contains(QStringLiteral("look here")));
        QVERIFY(eventTexts().contains(QStringLiteral("Ramp to 500 rpm in 1000 ms")));
        QVERIFY(eventTexts().contains(QStringLiteral("RUN")));
    }

    void aStreamedRegisterIsFoundAtItsFullRate()
    {
        replay();
        QTRY_VERIFY(text()->text().contains(QStringLiteral("its end")));
        QTRY_VERIFY(capture().find(kSquare, capture::ChannelInfo::Kind::Polled));
        QVERIFY(capture().info(*capture().find(kSquare))->kind == capture::ChannelInfo::Kind::Fast);
        m_rig->window.connectBar()->connectOrDisconnect();
        QTRY_VERIFY(!device().portOpen());
        m_rig->files.answer = m_path;
        m_rig->find<QAction>("openRecording")->trigger();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Opened ")));
        QCOMPARE(m_rig->window.windowTitle(), QStringLiteral("a.pcapng \u2013 Rotorscope"));
        QVERIFY(capture().find(kSquare, capture::ChannelInfo::Kind::Polled));
        QVERIFY(capture().info(*capture().find(kSquare))->kind == capture::ChannelInfo::Kind::Fast);
    }

    void nothingCanBeArmedAndTheReasonIsSaid()
    {
        replay();
        QTRY_VERIFY(device().answering() && device().identified());
        auto *arm = m_rig->find<QCheckBox>("arm");
        QVERIFY(!arm->isEnabled());
        QVERIFY(arm->toolTip().contains(QStringLiteral("replay")));
        device().setArmed(true); // even so
        QTest::mouseClick(arm, Qt::LeftButton);
        QTRY_VERIFY(text()->text().contains(QStringLiteral("its end")));
        QVERIFY(!device().armed());
        QVERIFY(!m_rig->find<QWidget>("start")->isEnabled());
        QVERIFY(m_rig->window.windowTitle().contains(QStringLiteral("a.pcapng")));
    }

    void theTriggerWorksOnIt()
    {
        auto *trigger = m_rig->window.findChild<widgets::TriggerControl *>();
        m_rig->workbench.replay().setSpeed(4.0);
        replay();
        QTRY_COMPARE(scope()->channels().size(), 2);
        trigger->trigger().setSource(scope()->channels().first());
        widgets::TriggerSetup setup = trigger->trigger().setup();
        setup.mode = scope::Mode::Normal;
        setup.level = 0.0;
        setup.hysteresis = 1.0;
        setup.length = 0.05;
        trigger->setSetup(setup);
        QTRY_VERIFY(!trigger->trigger().history().records().empty());
        // The square wave rises at every 1600th tick and 800 more, half way between two samples.
        const auto first = *capture().timeSpan(scope()->channels().first());
        const double at = capture::toSeconds(trigger->trigger().history().records().back().trigger);
        QVERIFY(std::abs(std::remainder(at - first.from - 0.05 + 0.5 / 16000.0, 0.1)) < 1e-6);
    }

    void aWriteThatWasTakenTriggers_data()
    {
        QTest::addColumn<QString>("written");
        QTest::newRow("any register") << QString();
        QTest::newRow("this one") << QStringLiteral("SPEED_KP");
    }
    void aWriteThatWasTakenTriggers()
    {
        QFETCH(const QString, written);
        auto *trigger = m_rig->window.findChild<widgets::TriggerControl *>();
        m_rig->workbench.replay().setSpeed(4.0);
        replay();
        QTRY_COMPARE(scope()->channels().size(), 2);
        widgets::TriggerSetup setup = trigger->trigger().setup();
        setup.mode = scope::Mode::Normal;
        setup.type = widgets::TriggerType::RegisterWrite;
        setup.written = written;
        setup.length = 0.05;
        trigger->setSetup(setup);
        QTRY_VERIFY(!trigger->trigger().history().records().empty());
        const auto first = *capture().timeSpan(scope()->channels().first());
        const double at =
            capture::toSeconds(trigger->trigger().history().records().front().trigger);
        QVERIFY2(std::abs(at - first.from - 8.01) < 0.02, qPrintable(QString::number(at)));
    }

    void whatHappenedIsToldInWords_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("fields");
        QTest::addColumn<QString>("text");
        const auto row = [](const char *name, const char *fields, const QString &text) {
            QTest::addRow("%s %s", name, fields) << name << fields << text;
        };
        row("command", "motor=2;action=start", QStringLiteral("Motor 2: Start"));
        row("torque ramp", "A=1.5;ms=100", QStringLiteral("Ramp to 1.500 A in 100 ms"));
        row("torque ramp", "A=1.5", QStringLiteral("torque ramp A=1.5")); // not all of it
        row("write", "SPEED_KP=520;wish=7", QStringLiteral("SPEED_KP \u2192 520"));
        row("motor state", "motor=1;state=idle", widgets::motorStateText(drive::MotorState::Idle));
        row("motor state", "state=fault now;name=FAULT_NOW;faults now=OVER_VOLT",
            QStringLiteral("FAULT_NOW: OVER_VOLT"));
        row("link", "state=lost;reason=silence", widgets::linkStateText(drive::LinkState::Lost));
        row("link trouble", "bad packets=0;lost ticks=16",
            QStringLiteral("lost control periods: 16"));
        row("stop", "word=wanted", QStringLiteral("Stop motors"));
        row("ended", "wish=7;outcome=refused;reason=BUSY",
            widgets::outcomeText(drive::Outcome::Refused) + QStringLiteral(", BUSY"));
        row("weather", "rain=some", QStringLiteral("weather rain=some"));
    }
    void whatHappenedIsToldInWords()
    {
        QFETCH(QString, name);
        QFETCH(QString, fields);
        recorded::Happening happening{name.toStdString(), {}};
        for (const QString &field : fields.split(QLatin1Char(';')))
            happening.fields.emplace_back(field.section(QLatin1Char('='), 0, 0).toStdString(),
                field.section(QLatin1Char('='), 1).toStdString());
        QTEST(widgets::happeningText(happening), "text");
    }

    void aPauseHoldsIt()
    {
        m_rig->workbench.replay().setSpeed(1.0);
        replay();
        QTRY_VERIFY(capture().timeSpan());
        auto *pause = m_rig->find<QToolButton>("replayPause");
        QTest::mouseClick(pause, Qt::LeftButton);
        QVERIFY(m_rig->workbench.replay().paused());
        QTest::mouseClick(pause, Qt::LeftButton);
        QVERIFY(!m_rig->workbench.replay().paused());
        auto *speed = m_rig->find<QComboBox>("replaySpeed");
        speed->setCurrentIndex(1);
        QCOMPARE(m_rig->workbench.replay().speed(), 4.0);
        const double before = capture().timeSpan()->to;
        QTRY_VERIFY(capture().timeSpan()->to > before + 0.5);
        speed->setCurrentIndex(2);
        QTRY_VERIFY(text()->text().contains(QStringLiteral("its end")));
        QVERIFY(!pause->isEnabled());
    }

    void aPlaceInTheFileCanBeChosen()
    {
        m_rig->workbench.replay().setSpeed(1.0);
        replay();
        QTRY_VERIFY(capture().timeSpan());
        auto *place = m_rig->find<QSlider>("replayPlace");
        QVERIFY(place && place->isVisible());
        const double from = capture().timeSpan()->from;
        place->setValue(place->maximum() / 2); // as it is let go
        QTRY_VERIFY(capture().timeSpan()->to > from + 8.0);
        QVERIFY(capture().timeSpan()->to < from + 14.0); // not to the end
        QTRY_VERIFY(std::abs(place->value() - place->maximum() / 2) < place->maximum() / 5);
        const double until = capture().timeSpan()->to;
        QTest::keyClick(place, Qt::Key_Home); // back: it is told once more, behind
        QTRY_VERIFY(text()->text().contains(QStringLiteral("0:00:0")));
        QTRY_VERIFY(capture().timeSpan()->to > until + 1.0);
        QCOMPARE(capture().refused().backwards, 0U);
        QVERIFY(device().portOpen() && device().answering());
        m_rig->workbench.replay().setSpeed(0.0);
        QTRY_VERIFY(text()->text().contains(QStringLiteral("its end")));
        const auto recorded = support::readRecording(m_path);
        const std::uint64_t all = recorded.capture.size(recorded.capture.channels().front().id);
        QVERIFY(capture().size(scope()->channels().first()) > all + all / 3);
        place->setValue(0); // also behind the end
        QTRY_VERIFY(!text()->text().contains(QStringLiteral("its end"))
            || capture().size(scope()->channels().first()) > 2 * all);
    }

    void itIsPlainThatNothingOfItIsNow()
    {
        replay();
        auto *badge = m_rig->find<QLabel>("replayBadge");
        QTRY_VERIFY(badge->isVisible());
        QCOMPARE(badge->text(), QStringLiteral("REPLAY"));
        QVERIFY(badge->palette().color(QPalette::Window).lightness()
            > badge->palette().color(QPalette::WindowText).lightness() + 100);
        auto *state = m_rig->find<QLabel>("motorState");
        QTRY_VERIFY2(
            state->text().startsWith(QStringLiteral("Recorded: ")), qPrintable(state->text()));
        QVERIFY(state->palette().color(QPalette::WindowText).saturation() < 20); // no green
    }

    void aMotorThatRanThenAsksNobodyNow()
    {
        replay();
        QTRY_VERIFY(eventTexts().contains(QStringLiteral("RUN")));
        QVERIFY(device().allIdle());
        m_rig->window.connectBar()->connectOrDisconnect();
        QVERIFY(!m_rig->find<QMessageBox>("disconnectQuestion"));
        QTRY_VERIFY(!device().portOpen());
        QTRY_VERIFY(!m_rig->find<QWidget>("replayBar")->isVisible());
        QCOMPARE(m_rig->window.connectBar()->path(), QStringLiteral("sim"));
        QVERIFY(m_rig->window.close());
    }

    void aBoardAfterAReplayStartsAfresh()
    {
        replay();
        QTRY_VERIFY(text()->text().contains(QStringLiteral("its end")));
        m_rig->window.connectBar()->connectOrDisconnect();
        QTRY_VERIFY(!device().portOpen());
        m_rig->window.connectBar()->connectOrDisconnect();
        QTRY_COMPARE(scope()->channels().size(), 4);
        for (const auto &info : capture().channels())
            QVERIFY(info.name != "SQUARE");
        QVERIFY(!eventTexts().contains(QStringLiteral("look here")));
        QTRY_VERIFY(capture().size(scope()->channels().first()) > 1000);
        device().setArmed(true);
        QTRY_VERIFY(device().armed());
    }

    void notesThatWereSavedLaterAreAtTheirTime()
    {
        const recorded::Note later{500'000'000, 500'000'000, "said later"};
        const QString path = m_folder.filePath(QStringLiteral("noted.pcapng"));
        QCOMPARE(session::saveNotes(m_path, path, {later, recorded::noNote(1'500'000'000)}).why,
            QString());
        replay(path);
        QTRY_VERIFY(text()->text().contains(QStringLiteral("its end")));
        QTRY_VERIFY(eventTexts().contains(QStringLiteral("said later")));
        QVERIFY(!eventTexts().contains(QStringLiteral("look here")));
        for (const auto &event : scope()->events().events())
            if (event.text == QStringLiteral("said later"))
                QVERIFY(std::abs(event.seconds - capture().timeSpan()->from - 0.5) < 0.01);
    }

    void onlyMarkersThatAreNotInTheFileAreAskedAbout()
    {
        replay();
        QTRY_VERIFY(eventTexts().contains(QStringLiteral("look here")));
        QTRY_VERIFY(text()->text().contains(QStringLiteral("its end")));
        const auto *save = m_rig->find<QAction>("saveMarkers");
        QVERIFY(!save->isEnabled());
        m_rig->window.connectBar()->disconnectNow();
        QTRY_VERIFY(!device().portOpen());
        m_rig->files.answer.clear();
        m_rig->find<QAction>("openRecording")->trigger();
        QVERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        scope()->cursorActions().setMarkerAt(capture().timeSpan()->from);
        QVERIFY(save->isEnabled());
        m_rig->find<QAction>("openRecording")->trigger();
        QVERIFY(m_rig->find<QMessageBox>("markersQuestion"));
    }

    void whatWasDoneBeforeIsNotToldBesideIt()
    {
        m_rig->files.answer = m_path;
        m_rig->find<QAction>("openRecording")->trigger();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Opened ")));
        replay();
        QTRY_VERIFY(device().portOpen());
        QVERIFY2(banner()->text().isEmpty(), qPrintable(banner()->text()));
        QVERIFY(!banner()->isVisible());
    }

    void samplesOfABoardAreAskedAbout()
    {
        m_rig->window.connectBar()->connectOrDisconnect();
        QTRY_COMPARE(scope()->channels().size(), 4);
        QTRY_VERIFY(capture().size(scope()->channels().first()) > 1000);
        QSignalSpy states(&device(), &widgets::Device::statusChanged);
        replay();
        QTRY_VERIFY(states.size() > 2); // that the motor rests is no answer
        QVERIFY(m_rig->find<QWidget>("disconnectQuestion"));
        m_rig->find<QDialog>("disconnectQuestion")->reject();
        m_rig->window.connectBar()->disconnectNow();
        QTRY_VERIFY(!device().portOpen());
        replay();
        QVERIFY(m_rig->find<QMessageBox>("replaceQuestion"));
        QVERIFY(!device().portOpen());
    }

    void whatIsNoRecordingIsSaid()
    {
        QFile file(m_folder.filePath(QStringLiteral("b.pcapng")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("something else");
        file.close();
        m_rig->files.answer = file.fileName();
        m_rig->find<QAction>("replayRecording")->trigger();
        QVERIFY(banner()->text().contains(QStringLiteral("is no recording")));
        QVERIFY(!device().portOpen());
    }

    /// 1920 x 1080 at a scale of 2, with a title bar: the bar of the replay gives way, not the buttons that stop.
    void theWindowStaysOnALowScreen()
    {
        QTranslator german;
        QVERIFY(german.load(QStringLiteral(":/i18n/rotorscope_de")));
        QCoreApplication::installTranslator(&german);
        m_rig = std::make_unique<facts::WindowRig>();
        m_rig->workbench.replay().setSpeed(1.0);
        m_rig->window.resize(960, 515);
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        replay();
        QTRY_VERIFY(m_rig->find<QWidget>("replayBar")->isVisible());
        QTRY_VERIFY(device().answering());
        QCoreApplication::processEvents();
        QCOMPARE(m_rig->window.size(), QSize(960, 515));
        for (const char *name : {"replayBadge", "replayPause", "replayPlace", "stopMotors", "stop"})
            QVERIFY2(m_rig->find<QWidget>(name)->visibleRegion().boundingRect().size()
                    == m_rig->find<QWidget>(name)->size(),
                name);
    }

private:
    void replay(const QString &path = {})
    {
        m_rig->files.answer = path.isEmpty() ? m_path : path;
        m_rig->find<QAction>("replayRecording")->trigger();
    }
    QStringList eventTexts()
    {
        QStringList texts;
        for (const auto &event : scope()->events().events())
            texts.append(event.text);
        return texts;
    }
    QLabel *text() { return m_rig->find<QLabel>("replayText"); }
    Banner *banner() { return m_rig->window.findChild<Banner *>(); }
    widgets::Device &device() { return m_rig->workbench.device(); }
    widgets::ScopeView *scope() { return m_rig->window.scope(); }
    capture::Capture &capture() { return m_rig->workbench.capture(); }

    QTemporaryDir m_folder;
    QString m_path = m_folder.filePath(QStringLiteral("a.pcapng"));
    std::unique_ptr<facts::WindowRig> m_rig;
};

QTEST_MAIN(TestReplayWindow)
#include "tst_replay_window.moc"
