// What is kept around a fault, and for how long.
#include "widgets/scope/events/fault_records.h"

#include <QSignalSpy>
#include <QTest>

using capture::toNanos;
using widgets::FaultRecords;

class TestFaultRecords : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_capture = std::make_unique<capture::Capture>();
        m_channel = m_capture->addImported("I_Q", "A");
        m_records = std::make_unique<FaultRecords>(*m_capture);
    }
    void cleanup() { m_records.reset(); }

    void aSecondBeforeAndAHalfBehindAreKept()
    {
        QSignalSpy changed(m_records.get(), &FaultRecords::changed);
        record(0.0, 10.0);
        m_records->faulted(5.0, 1, QStringLiteral("OVER_CURR"));
        QCOMPARE(changed.size(), 1);
        m_records->advance(5.5); // what was taken then may still be on its way
        QVERIFY(m_records->records().front().samples == nullptr);
        m_records->advance(5.81);
        QCOMPARE(changed.size(), 2);
        const widgets::FaultRecord &record = m_records->records().front();
        QCOMPARE(record.faults, QStringLiteral("OVER_CURR"));
        const auto span = record.samples->timeSpan();
        QVERIFY(span);
        QCOMPARE(span->from, 4.0);
        QCOMPARE(span->to, 5.5);
    }

    void itOutlivesItsSamples()
    {
        record(0.0, 2.0);
        m_records->faulted(1.5, 1, QStringLiteral("OVER_CURR"));
        m_records->finish(); // before its time: what there is
        m_capture->clear();
        QCOMPARE(m_records->records().front().samples->timeSpan()->from, 0.5);
        m_records->advance(100.0);
        QCOMPARE(m_records->records().front().samples->timeSpan()->from, 0.5);
    }

    void faultsThatComeTogetherAreOneRecordAndMotorsAreApart()
    {
        m_records->faulted(1.0, 1, QStringLiteral("OVER_CURR"));
        m_records->faulted(1.1, 2, QStringLiteral("OVER_TEMP"));
        m_records->faulted(1.2, 1, QStringLiteral("SPEED_FDBK"));
        QCOMPARE(m_records->records().size(), std::size_t(2));
        QCOMPARE(m_records->records().front().faults, QStringLiteral("OVER_CURR, SPEED_FDBK"));
        QCOMPARE(m_records->records().front().seconds, 1.0);
        m_records->advance(2.0);
        m_records->faulted(2.0, 1, QStringLiteral("OVER_CURR"));
        QCOMPARE(m_records->records().size(), std::size_t(3));
    }

    void theOldestGoes()
    {
        for (std::size_t i = 0; i <= FaultRecords::kMost; ++i) {
            m_records->faulted(double(i), 1, QStringLiteral("OVER_CURR"));
            m_records->finish();
        }
        QCOMPARE(m_records->records().size(), FaultRecords::kMost);
        QVERIFY(m_records->find(1) == nullptr);
        QVERIFY(m_records->find(2) != nullptr);
    }

private:
    void record(double from, double to)
    {
        for (int i = 0; i < int((to - from) * 1000.0); ++i) {
            const double at = from + i / 1000.0;
            m_capture->appendImported(m_channel, toNanos(at), at, toNanos(at + 0.001));
        }
    }

    std::unique_ptr<capture::Capture> m_capture;
    capture::ChannelId m_channel = 0;
    std::unique_ptr<FaultRecords> m_records;
};

QTEST_GUILESS_MAIN(TestFaultRecords)
#include "tst_fault_records.moc"
