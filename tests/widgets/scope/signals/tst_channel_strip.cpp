// What a recording costs, as the real window says it: before a set that does not fit starts, and beside what is
// measured.
#include "support/scope_window.h"
#include "widgets/scope/signals/channel_strip.h"
#include "widgets/scope/signals/selection.h"

#include <QLabel>
#include <QSignalSpy>
#include <QToolButton>

#include <cmath>
#include <set>

class TestChannelStrip : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        QLocale::setDefault(QLocale::c());
        m_rig = std::make_unique<facts::ScopeWindow>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        QCoreApplication::processEvents();
    }
    void cleanup() { m_rig.reset(); }

    void aSetThatFitsIsRecordedWithoutANotice();
    void aSetThatDoesNotFitIsSaidBeforeItStarts();
    void theNoticeComesAgainWithTheNextConnection();
    void theTipSaysWhatFits();
    void theMeasuredRateStandsBesideThePlan();
    void readSignalsSayHowOftenAndHowWellTheyAreTimed();
    void noReadValueIsHeldBeyondTheLink();
    void theSignalsOfAMotorAreReadWhileAnotherIsChosen();
    void whatAStopBrokeOffIsAskedForAgain();
    void whatADoubtedBoardWasNotAskedForIsLater();

private:
    QString banner() { return m_rig->find<QLabel>("bannerText")->text(); }
    QLabel &budget() { return *m_rig->find<QLabel>("linkBudget"); }
    /// A board behind a link of so many bytes a second.
    void connectBehind(double bytesPerSecond)
    {
        drive::Identified board = facts::identified();
        board.streaming.linkBytesPerSecond = bytesPerSecond;
        facts::feed(m_rig->device(), {board});
        QCoreApplication::processEvents();
    }

    std::unique_ptr<facts::ScopeWindow> m_rig;
};

void TestChannelStrip::aSetThatFitsIsRecordedWithoutANotice()
{
    auto *selection = m_rig->window.findChild<widgets::SignalSelection *>();
    QSignalSpy notices(&selection->plan(), &widgets::SignalPlan::noticed);
    connectBehind(184320.0); // once more
    QVERIFY(notices.isEmpty());
    QVERIFY(!selection->plan().planned().rateLowered);
    QVERIFY(budget().text().contains(QStringLiteral("of 184 kB/s")));
}

void TestChannelStrip::aSetThatDoesNotFitIsSaidBeforeItStarts()
{
    QStringList order;
    auto *selection = m_rig->window.findChild<widgets::SignalSelection *>();
    connect(&selection->plan(), &widgets::SignalPlan::noticed, this, [&](const QString &sentence) {
        order.append(QStringLiteral("notice"));
        QCOMPARE(banner(), sentence); // where the user sees it
        QVERIFY2(
            sentence.contains(QStringLiteral("the link carries 11.5 kB/s")), qPrintable(sentence));
    });
    connect(&m_rig->device(), &widgets::Device::wishMade, this, [&](const drive::Wish &wish) {
        if (std::holds_alternative<drive::Stream>(wish.what))
            order.append(QStringLiteral("stream"));
    });
    connectBehind(11520.0);
    QCOMPARE(order.value(0), QStringLiteral("notice"));
    QVERIFY(order.contains(QStringLiteral("stream")));
    QVERIFY(selection->plan().planned().rateLowered);
    QVERIFY(budget().text().contains(QStringLiteral("rate lowered")));
}

void TestChannelStrip::theNoticeComesAgainWithTheNextConnection()
{
    auto *selection = m_rig->window.findChild<widgets::SignalSelection *>();
    QSignalSpy notices(&selection->plan(), &widgets::SignalPlan::noticed);
    connectBehind(11520.0);
    QCOMPARE(notices.size(), 1);
    // The same plan, the same board.
    selection->plan().setRoute(facts::kCurrentA, widgets::Route::Fast);
    QCoreApplication::processEvents();
    QCOMPARE(notices.size(), 1);
    connectBehind(11520.0);
    QCOMPARE(notices.size(), 2);
    QVERIFY(selection->plan().planned().rateLowered);
}

void TestChannelStrip::theTipSaysWhatFits()
{
    QVERIFY(budget().toolTip().contains(QStringLiteral("4 HF signal"))); // the board takes no more
    connectBehind(92160.0);
    QVERIFY(budget().toolTip().contains(QStringLiteral("2 HF signal")));
    QVERIFY(budget().toolTip().contains(QStringLiteral("one packet every")));
    QCOMPARE(budget().accessibleDescription(),
        QString(budget().toolTip()).replace(QLatin1Char('\n'), QLatin1Char(' ')));
}

void TestChannelStrip::theMeasuredRateStandsBesideThePlan()
{
    using widgets::Milliseconds;
    const auto carry = [&](std::uint64_t bytes) {
        drive::LinkCounters counters;
        counters.bytesIn = bytes;
        facts::feed(m_rig->device(), {counters});
    };
    carry(1000);
    Q_EMIT m_rig->workbench.heartbeat(Milliseconds(10'000));
    QVERIFY(!budget().text().contains(QStringLiteral("measured")));
    carry(124'000);
    Q_EMIT m_rig->workbench.heartbeat(Milliseconds(12'000));
    QVERIFY2(budget().text().contains(QStringLiteral("measured 61.5 kB/s")),
        qPrintable(budget().text()));
    carry(500); // another link counts anew
    Q_EMIT m_rig->workbench.heartbeat(Milliseconds(14'000));
    QVERIFY(!budget().text().contains(QStringLiteral("measured")));
}

void TestChannelStrip::readSignalsSayHowOftenAndHowWellTheyAreTimed()
{
    using namespace std::chrono_literals;
    drive::Identified board = facts::identified(); // one that records nothing by itself
    board.streaming = {.linkBytesPerSecond = 11520.0, .readsPerSecond = 1000.0};
    facts::feed(m_rig->device(), {board});
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the chips of before
    auto *selection = m_rig->window.findChild<widgets::SignalSelection *>();
    const auto &polled = selection->plan().planned().polled;
    QVERIFY(polled.size() >= 2);
    const auto planned = QString::number(std::lround(1000.0 / double(polled.size())));
    QVERIFY2(budget().text().contains(
                 QStringLiteral("each signal read up to %1 times a second").arg(planned)),
        qPrintable(budget().text()));
    QVERIFY(!budget().text().contains(QStringLiteral("reached")));

    auto *strip = m_rig->find<widgets::ChannelStrip>("channelStrip");
    strip->measure(widgets::Milliseconds(100'000));
    for (int i = 0; i <= 30; ++i) // the first every 40 ms, the second half as often
        for (const std::size_t which : {std::size_t{0}, std::size_t{1}})
            if (which == 0 || i % 2 == 0)
                facts::feed(m_rig->device(),
                    {drive::RegistersRead{{{polled[which], drive::ReadStatus::Ok, std::int64_t{i},
                        TimePoint(10s + i * 40ms), 3500us}}}});
    strip->measure(widgets::Milliseconds(101'500));
    QVERIFY2(budget().text().endsWith(QStringLiteral("reached 13")), qPrintable(budget().text()));
    const auto tagOf = [&](std::size_t which) {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return m_rig->window
            .findChild<QWidget *>(QStringLiteral("chip_") + selection->nameOf(polled[which]))
            ->findChild<QToolButton *>();
    };
    QVERIFY2(tagOf(0)->text().contains(QStringLiteral("25/s")), qPrintable(tagOf(0)->text()));
    QVERIFY(tagOf(0)->toolTip().contains(QStringLiteral("3.5 ms")));
    QVERIFY(tagOf(1)->text().contains(QStringLiteral("13/s"))
        || tagOf(1)->text().contains(QStringLiteral("12/s")));

    strip->measure(widgets::Milliseconds(103'000)); // nothing more came: nothing is claimed
    QVERIFY(!tagOf(0)->text().contains(QStringLiteral("/s")));
}

/// The trace of a signal that is read in turn ends with the link: what the motor does then is not known.
void TestChannelStrip::noReadValueIsHeldBeyondTheLink()
{
    using namespace std::chrono_literals;
    facts::feed(m_rig->device(), {facts::identified()});
    QCoreApplication::processEvents();
    const auto &plan = m_rig->window.findChild<widgets::SignalSelection *>()->plan();
    const auto id = plan.planned().polled.at(0);
    for (int i = 0; i <= 10; ++i)
        facts::feed(m_rig->device(),
            {drive::RegistersRead{{{id, drive::ReadStatus::Ok, std::int64_t{650},
                TimePoint(10s + i * 40ms), 3500us}}}});
    const auto &capture = m_rig->workbench.capture();
    const auto channel = capture.find(id, capture::ChannelInfo::Kind::Polled);
    QVERIFY(channel && capture.valueAt(*channel, 11.0)); // 2 s, while it may come again
    facts::feed(
        m_rig->device(), {drive::LinkChanged{drive::LinkState::Lost, drive::LinkReason::None}});
    QVERIFY(!capture.valueAt(*channel, 11.0));
    QVERIFY(capture.valueAt(*channel, 10.43)); // as long as the one before it
}

void TestChannelStrip::theSignalsOfAMotorAreReadWhileAnotherIsChosen()
{
    drive::Identified board = facts::identified(); // one that records nothing by itself
    board.streaming = {.linkBytesPerSecond = 11520.0, .readsPerSecond = 1000.0};
    board.identity.motors = 2;
    board.limits.resize(2);
    auto registers = board.catalog->registers();
    for (catalog::RegisterInfo &info : registers)
        info.perMotor = info.id == facts::kSpeed;
    board.catalog = std::make_shared<const catalog::Catalog>(
        std::move(registers), 2, std::vector<catalog::Scales>(2));
    facts::feed(m_rig->device(), {board});
    std::set<catalog::RegisterId> drawn;
    connect(&m_rig->device(), &widgets::Device::wishMade, this, [&](const drive::Wish &wish) {
        if (const auto *watch = std::get_if<drive::Watch>(&wish.what))
            drawn = {watch->drawn.begin(), watch->drawn.end()};
    });
    const auto motors = [&drawn] { return drawn.count(facts::kSpeed | 1U); };
    QTRY_COMPARE(motors(), std::size_t{1});
    m_rig->device().setMotor(2);
    facts::feed(m_rig->device(), {facts::status(drive::MotorState::Idle)});
    drawn.clear();
    m_rig->workbench.watchList().forget(); // asked for anew
    QTRY_VERIFY(!drawn.empty());
    QCOMPARE(motors(), std::size_t{1});
}

void TestChannelStrip::whatAStopBrokeOffIsAskedForAgain()
{
    using widgets::Milliseconds;
    auto *selection = m_rig->window.findChild<widgets::SignalSelection *>();
    QSignalSpy failures(&selection->plan(), &widgets::SignalPlan::failed);
    std::vector<drive::WishId> asked;
    connect(&m_rig->device(), &widgets::Device::wishMade, this, [&](const drive::Wish &wish) {
        if (std::holds_alternative<drive::Stream>(wish.what))
            asked.push_back(wish.id);
    });
    connectBehind(184320.0);
    QCOMPARE(asked.size(), std::size_t{1});
    Milliseconds now(10'000);
    // @return how often it was asked for in the 3 s behind that end
    const auto ends = [&](drive::Outcome outcome) {
        const std::size_t before = asked.size();
        facts::feed(m_rig->device(), {drive::Ended{asked.back(), outcome, "stopped", {}}});
        for (int beat = 0; beat < 12; ++beat)
            Q_EMIT m_rig->workbench.heartbeat(now += Milliseconds(250));
        return asked.size() - before;
    };
    QCOMPARE(ends(drive::Outcome::NotSent), std::size_t{1});
    QCOMPARE(failures.size(), 0); // a Stop broke it off, which is not told
    QCOMPARE(ends(drive::Outcome::Unknown), std::size_t{1});
    QCOMPARE(failures.size(), 1); // it does not come to the board: told once
    QCOMPARE(ends(drive::Outcome::NotSent), std::size_t{1});
    QCOMPARE(failures.size(), 1);
    // Of the board, which will not have changed.
    QCOMPARE(ends(drive::Outcome::Refused), std::size_t{0});
    QCOMPARE(failures.size(), 2);
}

/// A program that stood still doubts its board until it has answered; who it is it may tell before.
void TestChannelStrip::whatADoubtedBoardWasNotAskedForIsLater()
{
    using widgets::Milliseconds;
    connectBehind(184320.0);
    const auto identified = *m_rig->device().identified();
    std::size_t asked = 0;
    connect(&m_rig->device(), &widgets::Device::wishMade, this, [&](const drive::Wish &wish) {
        asked += std::holds_alternative<drive::Stream>(wish.what) ? 1 : 0;
    });
    Milliseconds now(10'000);
    const auto beat = [&] {
        for (int i = 0; i < 12; ++i)
            Q_EMIT m_rig->workbench.heartbeat(now += Milliseconds(250));
    };
    using drive::LinkChanged, drive::LinkReason, drive::LinkState;
    facts::feed(m_rig->device(), {LinkChanged{LinkState::Suspect, LinkReason::None}, identified});
    beat();
    QCOMPARE(asked, std::size_t{0});
    facts::feed(m_rig->device(), {LinkChanged{LinkState::Connected, LinkReason::None}});
    beat();
    QCOMPARE(asked, std::size_t{1});
}

QTEST_MAIN(TestChannelStrip)
#include "tst_channel_strip.moc"
