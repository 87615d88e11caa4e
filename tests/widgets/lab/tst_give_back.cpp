// What an experiment has left on a board, and the button that gives it back: named until it is read back as it was, and
// nothing is written without a press.
#include "session/recording/lent_note.h"
#include "widgets/base/banner.h"
#include "widgets/lab/give_back.h"
#include "widgets/lab/lab_window.h"

#include <QDir>
#include <QToolButton>

using drive::LinkState;
using drive::MotorState;
using support::LabWindow;

namespace {

const QString kLeft = QStringLiteral("I_A may hold what the experiment wrote");

/// The window on a board that answers, with something left on it.
struct Left {
    facts::WindowRig rig;

    Left()
    {
        device().disconnect(SIGNAL(openWished(session::Endpoint)));
        device().disconnect(SIGNAL(closeWished()));
        session::Endpoint endpoint;
        endpoint.kind = session::Endpoint::Kind::Serial;
        endpoint.path = QStringLiteral("/dev/ttyACM0");
        device().open(endpoint);
        facts::connectBoard(device());
        tell(kLeft);
    }
    ~Left() { device().portChanged(session::PortState::Closed, {}); }

    widgets::Device &device() { return rig.workbench.device(); }
    widgets::Banner *banner() { return rig.find<widgets::Banner>("banner"); }
    QPushButton *button() { return rig.find<QPushButton>("giveBackButton"); }
    bool says(const QString &text)
    {
        return banner()->isVisible() && banner()->text().contains(text);
    }
    /// As the session's note does.
    void tell(const QString &texts)
    {
        std::vector<drive::RegisterWrite> back;
        if (!texts.isEmpty())
            back.push_back({facts::kCurrentA, std::int64_t{5}});
        Q_EMIT rig.workbench.lentNote().left(texts, back);
    }
    void link(LinkState state)
    {
        facts::feed(device(), {drive::LinkChanged{state, drive::LinkReason::Silence}});
    }
};

} // namespace

class TestGiveBack : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatAStopLeftComesBackByAPress()
    {
        LabWindow bench("pm24"); // its resistance is measured by a start-up that is borrowed
        bench.open(Qt::Key_I, Qt::ControlModifier);
        QVERIFY(bench.connectBoard());
        const auto *button = bench.find<QPushButton>("giveBackButton");
        QVERIFY(!button->isVisible());
        const auto id = bench.rig.workbench.registers().idOf("REVUP_DATA");
        QVERIFY(id);
        const auto held = [&] { return bench.rig.workbench.registers().known(*id); };
        bench.device().submit(drive::Read{{*id}});
        QTRY_VERIFY(held());
        const catalog::Value before = *held();
        QVERIFY(bench.arm("electricalRun"));
        bench.press("electricalRun");
        bench.agree();
        QTRY_VERIFY_WITH_TIMEOUT(bench.world.counts().starts > 0, 20'000);
        QVERIFY(!button->isVisible()); // it is borrowed, and not left
        QTest::keyClick(&bench.rig.window, Qt::Key_Escape);
        QTRY_VERIFY(!bench.running());
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), MotorState::Idle, 10'000);

        const auto *banner = bench.find<widgets::Banner>("banner");
        QTRY_VERIFY(button->isVisible());
        QVERIFY2(banner->text().contains(
                     QStringLiteral("REVUP_DATA may hold what the experiment wrote")),
            qPrintable(banner->text()));
        QVERIFY(!button->isEnabled() && !button->hasFocus());
        QVERIFY2(
            button->toolTip().contains(QStringLiteral("Arm first")), qPrintable(button->toolTip()));
        QVERIFY(bench.arm("giveBackButton"));
        const auto &steps = bench.rig.workbench.edits().steps();
        QCOMPARE(steps.count(), 0); // nothing without a press
        bench.press("giveBackButton");
        QTRY_VERIFY(!button->isVisible());
        QTRY_VERIFY2(
            banner->text().contains(QStringLiteral("verified")), qPrintable(banner->text()));
        QVERIFY(held() && *held() == before);
        QCOMPARE(steps.count(), 1); // the board held something else
        QCOMPARE(steps.undoText(), QStringLiteral("As before the experiment"));
        QVERIFY(QDir(session::lentFolder()).entryList(QDir::Files).isEmpty());
        QCOMPARE(bench.world.counts().starts, 1);
    }

    void whyItCannotBePressedIsSaid()
    {
        Left left;
        const auto *button = left.button();
        QVERIFY(left.says(kLeft) && button->isVisible());
        QVERIFY(!button->isEnabled());
        QVERIFY2(
            button->toolTip().contains(QStringLiteral("Arm first")), qPrintable(button->toolTip()));
        left.device().armedChanged(true);
        QVERIFY(button->isEnabled());
        facts::feed(left.device(), {facts::status(MotorState::Running)});
        QVERIFY(!button->isEnabled());
        QVERIFY2(button->toolTip().contains(QStringLiteral("has to rest")),
            qPrintable(button->toolTip()));
        for (const MotorState rest : {MotorState::FaultOver, MotorState::Idle}) {
            facts::feed(left.device(), {facts::status(rest)});
            QVERIFY(button->isEnabled());
        }
        left.link(LinkState::Suspect);
        QVERIFY(!button->isEnabled());
    }

    /// The link of this board leads nowhere: nothing is sent.
    void whatIsNotWrittenStaysNamed()
    {
        Left left;
        left.device().armedChanged(true);
        const QString before = left.banner()->text();
        QString said; // signals, which could not be recorded either, may have the last word
        const auto *act = left.rig.find<widgets::GiveBack>("giveBackButton");
        QObject::connect(act, &widgets::GiveBack::told, [&] { said = left.banner()->text(); });
        QTest::mouseClick(left.button(), Qt::LeftButton);
        QTRY_VERIFY(!said.isEmpty());
        QVERIFY2(said != before && said.endsWith(before), qPrintable(said));
        left.device().armedChanged(false);
        left.device().armedChanged(true); // tells it again
        QVERIFY(left.button()->isVisible());
        QTRY_VERIFY(left.button()->isEnabled());
        left.tell({}); // written by other means
        QVERIFY(!left.banner()->isVisible() && !left.button()->isVisible());
    }

    void itIsAskedAgainBehindALostLink()
    {
        Left left;
        left.link(LinkState::Lost);
        QVERIFY(left.says(QStringLiteral("Link lost")) && !left.button()->isVisible());
        left.tell(kLeft); // an experiment ends by that
        QVERIFY(left.says(QStringLiteral("Link lost")));
        left.link(LinkState::Connected);
        QVERIFY(left.says(kLeft) && left.button()->isVisible());
        left.tell({}); // another board, say
        QVERIFY(!left.banner()->isVisible());
    }

    /// What the board holds behind a reset is its own again: that is read first.
    void aResetStaysToldUntilTheBoardIsArmed()
    {
        Left left;
        facts::feed(left.device(),
            {drive::LinkChanged{LinkState::Connected, drive::LinkReason::BoardReset}});
        const QString reset = left.banner()->text();
        QVERIFY2(!reset.contains(kLeft) && !left.button()->isVisible(), qPrintable(reset));
        left.tell(kLeft); // it is met again
        QCOMPARE(left.banner()->text(), reset);
        left.device().armedChanged(true);
        QVERIFY(left.says(kLeft) && left.button()->isVisible());
    }

    void itIsAskedAgainWhenTheBoardIsArmed()
    {
        Left left;
        left.rig.window.warn(QStringLiteral("Look."));
        QVERIFY(left.says(QStringLiteral("Look.")) && !left.button()->isVisible());
        left.device().armedChanged(true);
        QVERIFY(left.says(kLeft) && left.button()->isVisible());
        left.banner()->findChild<QToolButton *>()->click();
        QVERIFY(!left.banner()->isVisible());
        left.device().armedChanged(false);
        QVERIFY(!left.banner()->isVisible());
        left.device().armedChanged(true);
        QVERIFY(left.says(kLeft) && left.button()->isVisible());
    }
};

QTEST_MAIN(TestGiveBack)
#include "tst_give_back.moc"
