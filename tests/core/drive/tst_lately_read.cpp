// LatelyRead across a gap in time: what was asked before it tells nothing of now, also where the answer comes behind
// it.
#include "core/drive/toy_drive.h"

#include <QTest>

using namespace drive;
using namespace std::chrono_literals;
namespace toy = support::toy;

namespace {

constexpr RegisterId kGain = toy::idOf(toy::Gain);

/// The toy and its board, on a line without delay.
struct ToyBench {
    toy::ToyDrive drive;
    toy::Board board;
    TimePoint now{1s};
    Bytes held; ///< a question about the gain that has left, while it is to be held back
    bool holds = false;
    int asked = 0; ///< the gain
    std::optional<Ended> ended;

    void step()
    {
        now += 1ms;
        drive.handleTimeout(now);
        for (Output &output : drive.takeOutput()) {
            Bytes copy = output.bytes;
            const auto frame = toy::nextFrame(copy);
            const bool asks = frame && frame->kind == 'R' && frame->address == toy::Gain;
            asked += asks ? 1 : 0;
            if (asks && holds)
                held = output.bytes;
            else
                board.receive(output.bytes, now);
        }
        drive.receive(board.takeOutput(), now);
        for (const Event &event : drive.takeEvents())
            if (const auto *end = std::get_if<Ended>(&event); end != nullptr && end->id != 0)
                ended = *end;
    }
    bool arms()
    {
        for (int i = 0; i < 200 && !drive.armed(); ++i) {
            step();
            drive.arm();
        }
        return drive.armed();
    }
};

} // namespace

class TestLatelyRead : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anAnswerFromBeforeAGapIsNoValueOfNow_data();
    void anAnswerFromBeforeAGapIsNoValueOfNow();
};

void TestLatelyRead::anAnswerFromBeforeAGapIsNoValueOfNow_data()
{
    QTest::addColumn<bool>("gap");
    QTest::newRow("no gap") << false;
    QTest::newRow("a gap") << true;
}

void TestLatelyRead::anAnswerFromBeforeAGapIsNoValueOfNow()
{
    QFETCH(bool, gap);
    ToyBench bench;
    bench.drive.connect(bench.now);
    QVERIFY(bench.arms());
    bench.holds = true;
    bench.drive.submit({0, Watch{{kGain}, 10s}}, bench.now);
    for (int i = 0; i < 200 && bench.held.empty(); ++i)
        bench.step();
    QVERIFY(!bench.held.empty());
    bench.holds = false;
    if (gap)
        bench.drive.doubt(bench.now);
    bench.board.receive(bench.held, bench.now); // its answer comes with the next step
    bench.step();
    QVERIFY(bench.arms());
    bench.asked = 0;
    bench.drive.submit({1, Write{{{kGain, std::int64_t{7}}}}}, bench.now);
    for (int i = 0; i < 200 && !bench.ended; ++i)
        bench.step();
    QVERIFY(bench.ended && bench.ended->writes.front().verified == true);
    QVERIFY(bench.ended->writes.front().before == Value(std::int64_t{100}));
    QCOMPARE(bench.asked, gap ? 2 : 1); // the last one is what is read back
}

QTEST_APPLESS_MAIN(TestLatelyRead)
#include "tst_lately_read.moc"
