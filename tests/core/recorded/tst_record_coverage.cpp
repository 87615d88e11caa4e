// What a recording holds of a capture: the same entries go to both, and some to one alone.
#include "recorded/coverage.h"
#include "recorded/restore.h"

#include <QtTest>

using recorded::Coverage;
using recorded::Entry;

namespace {

constexpr catalog::RegisterId kFast = (9U << 6) | 1U;
constexpr catalog::RegisterId kSlow = (1U << 6) | 1U;
constexpr catalog::RegisterId kPolled = (50U << 6) | 1U;

Entry layoutEntry(capture::StreamId id = 1, double origin = 0.0)
{
    return capture::StreamLayout{id, 16000.0, origin, 2, {{kFast, "I", "A", 0.01, 0.0}},
        {{kSlow, "SPEED", "rpm", 1.0, 0.0}}};
}

Entry blockEntry(capture::Tick first, capture::StreamId id = 1)
{
    return capture::SampleBlock{id, first, 4, {1, 2, 3, 4}, {{first, {100}}}, 0};
}

Entry polled(recorded::Nanos at) { return recorded::PolledValues{{{kPolled, at, 25.0}}}; }

} // namespace

class TestRecordCoverage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_capture = capture::Capture();
        m_restorer.emplace(m_capture);
        m_coverage = {};
        m_restorer->accept(recorded::PolledRegister{kPolled, "T", "C"});
    }

    void whatWentToBothIsHeld()
    {
        QVERIFY(m_coverage.holds(m_capture)); // nothing is held by everything
        both(layoutEntry());
        for (capture::Tick tick = 0; tick < 80; tick += 8)
            both(blockEntry(tick));
        both(polled(1'000'000));
        QVERIFY(m_coverage.holds(m_capture));
        m_coverage.accept(blockEntry(80)); // more in the file than was shown
        QVERIFY(m_coverage.holds(m_capture));
    }

    void aBlockBeforeItIsMissing()
    {
        both(layoutEntry());
        m_restorer->accept(blockEntry(0));
        both(blockEntry(8));
        QVERIFY(!m_coverage.holds(m_capture));
    }

    void aBlockAfterItIsMissing()
    {
        both(layoutEntry());
        both(blockEntry(0));
        m_restorer->accept(blockEntry(8));
        QVERIFY(!m_coverage.holds(m_capture));
    }

    void aSignalThatWasNotRecordedIsMissing()
    {
        both(layoutEntry());
        both(blockEntry(0));
        both(polled(5));
        QVERIFY(m_coverage.holds(m_capture));
        m_restorer->accept(polled(6));
        QVERIFY(!m_coverage.holds(m_capture));
    }

    void whatWasComputedDoesNotCount()
    {
        both(layoutEntry());
        both(blockEntry(0));
        const auto own = m_capture.addImported("POWER", "W", capture::kFirstOwnRegister);
        m_capture.appendImported(own, 1'000'000'000, 2.0, 1'000'000'001);
        QVERIFY(m_coverage.holds(m_capture));
    }

    void aBoardThatBeganToCountAnewIsNotHeld()
    {
        both(layoutEntry());
        both(blockEntry(16000));
        both(layoutEntry(2));
        both(blockEntry(0, 2)); // the capture moves it behind
        both(layoutEntry(3, 10.0));
        both(blockEntry(0, 3));
        QVERIFY(!m_coverage.holds(m_capture));
    }

private:
    void both(const Entry &entry)
    {
        m_restorer->accept(entry);
        m_coverage.accept(entry);
    }

    capture::Capture m_capture;
    std::optional<recorded::Restorer> m_restorer;
    Coverage m_coverage;
};

QTEST_APPLESS_MAIN(TestRecordCoverage)
#include "tst_record_coverage.moc"
