// What a recording costs, as the real window says it: before a set that does not fit starts, and beside what is measured.
#include "support/scope_window.h"
#include "widgets/scope/signal_selection.h"

#include <QLabel>
#include <QSignalSpy>

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
    void theTipSaysWhatFits();
    void theMeasuredRateStandsBesideThePlan();

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
    QSignalSpy notices(selection, &widgets::SignalSelection::noticed);
    connectBehind(184320.0); // once more
    QVERIFY(notices.isEmpty());
    QVERIFY(!selection->plan().rateLowered);
    QVERIFY(budget().text().contains(QStringLiteral("of 184 kB/s")));
}

void TestChannelStrip::aSetThatDoesNotFitIsSaidBeforeItStarts()
{
    QStringList order;
    auto *selection = m_rig->window.findChild<widgets::SignalSelection *>();
    connect(selection, &widgets::SignalSelection::noticed, this, [&](const QString &sentence) {
        order.append(QStringLiteral("notice"));
        QCOMPARE(banner(), sentence); // where a person sees it
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
    QVERIFY(selection->plan().rateLowered);
    QVERIFY(budget().text().contains(QStringLiteral("rate lowered")));
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

QTEST_MAIN(TestChannelStrip)
#include "tst_channel_strip.moc"
