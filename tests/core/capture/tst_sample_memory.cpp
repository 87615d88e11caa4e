// Slices of sample memory: not shared, alive as long as one is held, and given back then.
#include "capture/capture.h"

#include <QtTest>

#include <set>

using namespace capture;

class TestSampleMemory : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void slicesDoNotOverlap();
    void anArenaGoesWithItsLastSlice();
    void channelsOfACaptureShareArenas();
    void aSnapshotOutlivesTheCapture();
    void releasedChunksGiveTheirMemoryBack();
};

namespace {

/// Counts the arenas that are there.
class CountingMemory : public SampleMemory {
public:
    explicit CountingMemory(int &alive)
        : m_alive(alive)
    {
    }

protected:
    std::shared_ptr<std::byte> makeArena() override
    {
        ++m_alive;
        auto arena = SampleMemory::makeArena();
        std::byte *memory = arena.get();
        int &alive = m_alive;
        return {memory, [arena = std::move(arena), &alive](std::byte *) mutable {
                    arena.reset();
                    --alive;
                }};
    }

private:
    int &m_alive;
};

StreamLayout layoutOf(int signalCount)
{
    StreamLayout layoutOf{1, 16000.0, 0.0, 1, {}, {}};
    for (int i = 0; i < signalCount; ++i)
        layoutOf.fast.push_back({catalog::RegisterId(i + 1), "S", "A", 1.0, 0.0});
    return layoutOf;
}

void record(Capture &capture, int signalCount, Tick from, Tick to)
{
    constexpr Tick kBlock = 4096;
    for (Tick tick = from; tick < to; tick += kBlock) {
        SampleBlock block{1, tick, kBlock, {}, {}, 0};
        for (int s = 0; s < signalCount; ++s)
            for (Tick i = 0; i < kBlock; ++i)
                block.fast.push_back(static_cast<std::int16_t>((tick + i) * (s + 1)));
        capture.append(block);
    }
}

} // namespace

void TestSampleMemory::slicesDoNotOverlap()
{
    SampleMemory memory;
    std::vector<Slice> slices;
    std::set<std::int16_t *> places;
    for (std::int16_t i = 0; i < 50; ++i) {
        slices.push_back(memory.take());
        std::fill_n(slices.back().get(), kSliceSamples, i);
        QCOMPARE(reinterpret_cast<std::uintptr_t>(slices.back().get()) % 4096, std::uintptr_t(0));
        places.insert(slices.back().get());
    }
    QCOMPARE(places.size(), std::size_t(50));
    for (std::int16_t i = 0; i < 50; ++i) {
        const auto *codes = slices[std::size_t(i)].get();
        QCOMPARE(std::count(codes, codes + kSliceSamples, i), std::ptrdiff_t(kSliceSamples));
    }
}

void TestSampleMemory::anArenaGoesWithItsLastSlice()
{
    int alive = 0;
    CountingMemory memory(alive);
    std::vector<Slice> slices;
    constexpr std::size_t kInArena = kArenaBytes / kSliceBytes;
    for (std::size_t i = 0; i < kInArena; ++i)
        slices.push_back(memory.take());
    QCOMPARE(alive, 1);
    slices.push_back(memory.take());
    QCOMPARE(alive, 2);
    slices.erase(slices.begin(), slices.begin() + kInArena - 1);
    QCOMPARE(alive, 2);
    slices.erase(slices.begin());
    QCOMPARE(alive, 1);
}

void TestSampleMemory::channelsOfACaptureShareArenas()
{
    int alive = 0;
    {
        Capture capture({.memory = std::make_shared<CountingMemory>(alive)});
        capture.begin(layoutOf(8));
        record(capture, 8, 0, 4096);
        QCOMPARE(alive, 2); // a slice of codes each, and one of extremes
    }
    QCOMPARE(alive, 0);
}

void TestSampleMemory::aSnapshotOutlivesTheCapture()
{
    int alive = 0;
    Snapshot snapshot;
    {
        Capture capture({.memory = std::make_shared<CountingMemory>(alive)});
        capture.begin(layoutOf(2));
        record(capture, 2, 0, Tick{4096} * 40);
        const std::vector<ChannelId> ids = capture.streaming();
        snapshot = capture.snapshot(ids);
    }
    QVERIFY(alive > 0);
    const FastColumn *column = snapshot->at(1).fast();
    for (Index i = 0; i < column->end(); i += 97)
        QCOMPARE(column->at(i), static_cast<std::int16_t>(i * 2));
    snapshot.reset();
    QCOMPARE(alive, 0);
}

void TestSampleMemory::releasedChunksGiveTheirMemoryBack()
{
    int alive = 0;
    Capture capture({.maxBytes = 8'000'000, .memory = std::make_shared<CountingMemory>(alive)});
    capture.begin(layoutOf(4));
    record(capture, 4, 0, Tick{4096} * 1000);
    QVERIFY(capture.bytes() <= 8'600'000);
    QVERIFY2(alive <= 6, qPrintable(QString::number(alive)));
    const FastColumn *column = capture.channel(capture.streaming()[3])->fast();
    QVERIFY(column->begin() > 0);
    QCOMPARE(column->at(column->begin()), static_cast<std::int16_t>(column->begin() * 4));
}

QTEST_APPLESS_MAIN(TestSampleMemory)
#include "tst_sample_memory.moc"
