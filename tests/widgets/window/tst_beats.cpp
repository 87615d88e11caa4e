// The watchdog of the tests: what it counts, and what it tells.
#include "support/watchdog/beats.h"
#include "support/watchdog/running_code.h"

#include <QEventLoop>
#include <QTimer>
#include <QWidget>

using support::Beat;

/// Named in what the watchdog tells. The system looks at its timer when it looks at the thread, which is a little
/// later.
void computeForLong()
{
    const double start = support::threadSeconds();
    if (start == 0.0)
        return; // no system of which this can be told
    double took = 0.0;
    while (took < 1.5 * Beat::kLong_s
        || (support::codeThatRan().empty() && took < 4.0 * Beat::kLong_s))
        took = support::threadSeconds() - start;
}

class TestBeats : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        if (support::threadSeconds() == 0.0)
            m_told = false; // nor is there anything to be seen
    }
    void init()
    {
        settled();
        Beat::forget();
    }

    void shortOnesAreNotTold()
    {
        post([] {});
        settled();
        QCOMPARE(Beat::told().beats, 0);
        QVERIFY(!m_told || Beat::told().longest_s > 0.0);
    }

    void aLongOneIsToldWithWhatRan()
    {
        m_receiver.setObjectName(QStringLiteral("slow one"));
        post(&computeForLong);
        settled();
        QCOMPARE(Beat::told().beats, m_told ? 1 : 0);
        QCOMPARE(Beat::told().longest_s > Beat::kLong_s, m_told);
        for (const char *part : {"MetaCall", "slow one", "computeForLong"})
            QCOMPARE(Beat::told().what.contains(QLatin1String(part)), m_told);
    }

    void whatWaitsIsNotLong()
    {
        post([] {
            QEventLoop loop;
            QTimer::singleShot(int(2e3 * Beat::kLong_s), &loop, &QEventLoop::quit);
            loop.exec();
        });
        settled();
        QCOMPARE(Beat::told().beats, 0);
    }

    void aBeatInALoopInsideIsItsOwn()
    {
        m_receiver.setObjectName(QStringLiteral("outer"));
        QObject inner;
        inner.setObjectName(QStringLiteral("inner"));
        post([&inner] {
            QEventLoop loop;
            QMetaObject::invokeMethod(
                &inner,
                [&loop] {
                    computeForLong();
                    loop.quit();
                },
                Qt::QueuedConnection);
            loop.exec();
        });
        settled();
        QCOMPARE(Beat::told().beats, m_told ? 1 : 0);
        QCOMPARE(Beat::told().what.contains(QLatin1String("inner")), m_told);
    }

    void whatATestDoesItselfIsNoBeat()
    {
        computeForLong();
        QCOMPARE(Beat::told().beats, 0);
    }

private:
    template <class Work>
    void post(Work work)
    {
        QMetaObject::invokeMethod(&m_receiver, work, Qt::QueuedConnection);
    }
    static void settled()
    {
        for (int round = 0; round < 5; ++round)
            QCoreApplication::processEvents();
    }

    QObject m_receiver;
    bool m_told = true;
};

QTEST_MAIN(TestBeats)
#include "tst_beats.moc"
