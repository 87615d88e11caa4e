// Signals side by side without a gap, the flux from voltages, and what ends a link in a recording.
#include "lab/evaluation/flux_fit.h"
#include "lab/happenings.h"
#include "support/link_pair.h"

#include <QTest>

#include <numbers>

using namespace lab;

namespace {

constexpr double kTick_hz = 8000.0;

/// Angle, current and voltage of a motor whose speed rises from 300 to 900 rad/s (electrical) in two seconds.
struct Recording {
    double flux_wb = 6e-3, rs_ohm = 0.2, dead_v = 0.4;
    double least = 300.0, most = 900.0;
    std::vector<std::pair<int, int>> gaps; ///< ticks
    capture::Capture capture = {};

    void make()
    {
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = kTick_hz;
        layout.fast = {{1, "angle", "deg", 360.0 / 65536.0}, {2, "current", "A", 1e-3},
            {3, "voltage", "V", 1e-3}};
        capture.begin(layout);
        double turned = 0.0;
        std::vector<std::int16_t> columns[3];
        capture::Tick first = 0, lost = 0;
        const auto flush = [&](int next) {
            if (!columns[0].empty()) {
                capture::SampleBlock block;
                block.stream = 1;
                block.firstTick = first;
                block.count = static_cast<std::uint32_t>(columns[0].size());
                block.lostTicks = lost;
                for (auto &column : columns) {
                    block.fast.insert(block.fast.end(), column.begin(), column.end());
                    column.clear();
                }
                capture.append(block);
                lost = 0;
            }
            first = next;
        };
        for (int tick = 0; tick < 16000; ++tick) {
            const double speed = least + (most - least) * tick / 16000.0;
            turned += speed / kTick_hz;
            const double amps = tick / 2000 % 2 == 0 ? 3.0 : 1.5;
            const double volts = rs_ohm * amps + dead_v + speed * flux_wb;
            const bool missing = std::any_of(gaps.begin(), gaps.end(),
                [tick](const auto &gap) { return tick >= gap.first && tick < gap.second; });
            if (missing) {
                flush(tick + 1);
                first = tick + 1;
                ++lost;
                continue;
            }
            columns[0].push_back(static_cast<std::int16_t>(
                std::int64_t(std::floor(turned / (2.0 * std::numbers::pi) * 65536.0)) & 0xFFFF));
            columns[1].push_back(static_cast<std::int16_t>(std::lround(amps * 1e3)));
            columns[2].push_back(static_cast<std::int16_t>(std::lround(volts * 1e3)));
        }
        flush(16000);
    }
    std::vector<Segment> segments(double from_s = 0.0, double to_s = 2.0) const
    {
        const std::array others{
            capture.channel(*capture.find(2)), capture.channel(*capture.find(3))};
        return segmentsOf(*capture.channel(*capture.find(1)), others, capture::toNanos(from_s),
            capture::toNanos(to_s));
    }
};

recorded::Happening linkState(const char *state) { return {"link", {{"state", state}}}; }

} // namespace

class TestSegments : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void gapsPartThem()
    {
        Recording whole;
        whole.make();
        QCOMPARE(whole.segments().size(), 1U);
        QCOMPARE(whole.segments()[0].turned_deg.size(), 16000U);
        QVERIFY(std::abs(whole.segments()[0].step_s * kTick_hz - 1.0) < 1e-9);
        // 600 rad/s on average for two seconds.
        QVERIFY(std::abs(whole.segments()[0].turned_deg.back() - 1200.0 * 180.0 / std::numbers::pi)
            < 30.0);
        Recording parted;
        parted.gaps = {{4000, 4100}, {4102, 8000}};
        parted.make();
        const auto segments = parted.segments();
        QCOMPARE(segments.size(), 2U); // two samples between the gaps are none
        QCOMPARE(segments[0].turned_deg.size(), 4000U);
        QCOMPARE(segments[1].at, capture::toNanos(1.0));
        QCOMPARE(segments[1].turned_deg.front(), 0.0);
        QCOMPARE(segments[1].values[0].size(), segments[1].turned_deg.size());
        QVERIFY(parted.segments(0.51, 0.99).empty());
    }

    /// Also the two samples between two gaps, which are of no use.
    void whatIsMissingBetweenThemIsSaid()
    {
        Recording whole;
        whole.make();
        std::vector<std::string> notes;
        noteGaps(notes, missingIn(whole.segments()));
        noteGaps(notes, missingIn({}));
        QVERIFY(notes.empty());
        Recording parted;
        parted.gaps = {{2000, 2200}, {4000, 4100}, {4102, 8000}};
        parted.make();
        QVERIFY(std::abs(missingIn(parted.segments()) - 0.525) < 1e-6);
        noteGaps(notes, missingIn(parted.segments(0.4, 2.0)));
        QCOMPARE(notes,
            (std::vector<std::string>{
                "samples of 0.5 s are missing in it: only what is without a gap counts"}));
    }

    void theFluxIsTheSlopeOfTheVoltage()
    {
        Recording recording;
        recording.gaps = {{7000, 7100}};
        recording.make();
        const auto flux = fitFlux(recording.segments());
        QVERIFY(flux);
        QVERIFY2(std::abs(flux->q.value / recording.flux_wb - 1.0) < 2e-3,
            qPrintable(QString::number(flux->q.value)));
    }

    void aSpeedThatStaysTellsNoFlux()
    {
        Recording recording;
        recording.least = recording.most = 600.0;
        recording.make();
        QVERIFY(!fitFlux(recording.segments()));
        QVERIFY(!fitFlux({}));
    }

    void onlyALinkThatIsGoneEndsWhatWasMeasured()
    {
        for (const char *state : {"suspect", "recovering", "connected", "connecting"})
            QVERIFY(!endsLink(linkState(state)));
        QVERIFY(endsLink(linkState("lost")) && endsLink(linkState("closed")));
        QVERIFY(!endsLink({"stop", {{"state", "lost"}}}));
    }
};

QTEST_APPLESS_MAIN(TestSegments)
#include "tst_segments.moc"
