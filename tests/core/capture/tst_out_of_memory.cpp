// A capture for which there is no memory: whichever allocation fails, nothing breaks, what is drawn has a gap and goes
// on. The allocator of this program fails once, at the k-th call from a moment on, for every k until none fails any
// more; and from a moment on for good.
#include "capture/capture.h"

#include <QtTest>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <new>

namespace {

/// Of this thread: the calls that still succeed; negative: all do.
thread_local long s_left = -1;
thread_local bool s_forGood = false;
thread_local bool s_failed = false;

void *allocate(std::size_t size, std::size_t alignment)
{
    if (s_left == 0) {
        s_failed = true;
        if (!s_forGood)
            s_left = -1;
        throw std::bad_alloc();
    }
    if (s_left > 0)
        --s_left;
    const std::size_t whole =
        (std::max<std::size_t>(size, 1) + alignment - 1) / alignment * alignment;
    void *memory = std::aligned_alloc(alignment, whole);
    if (memory == nullptr)
        throw std::bad_alloc();
    return memory;
}

} // namespace

void *operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void *operator new(std::size_t size, std::align_val_t alignment)
{
    return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void *memory) noexcept { std::free(memory); }
void operator delete(void *memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void *memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void *memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

using namespace capture;

class TestOutOfMemory : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anyAllocationOfAnAppendMayFail_data();
    void anyAllocationOfAnAppendMayFail();
    void withoutAnyMemoryTheOldestGoesOn();
};

namespace {

constexpr std::uint32_t kRows = 4096;

/// An archive in memory.
class MemoryArchive final : public SampleArchive {
public:
    std::uint64_t budget() const override { return std::uint64_t{1} << 30; }
    std::size_t pieceBytes() const override { return 524288; }
    std::shared_ptr<const Deposit> store(std::vector<Stretch> stretches) override
    {
        auto deposit = std::make_shared<Deposit>();
        for (Stretch &stretch : stretches) {
            std::shared_ptr<std::byte[]> copy(new std::byte[stretch.size]);
            std::memcpy(copy.get(), stretch.data.get(), stretch.size);
            stretch.data = {copy, copy.get()};
        }
        deposit->settle(Deposit::State::Stored, std::move(stretches));
        return deposit;
    }
};

StreamLayout layout()
{
    return {1, 16000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}, {2, "B", "A", 0.1, 0.0}},
        {{3, "S", "rpm", 6.0, 0.0}}};
}

std::int16_t codeAt(Tick tick, std::uint32_t signal)
{
    return static_cast<std::int16_t>(tick * 31 + signal);
}

SampleBlock blockAt(Tick tick)
{
    SampleBlock block{1, tick, kRows, {}, {{tick + 5, {static_cast<std::int32_t>(tick % 997)}}}, 0};
    block.fast.reserve(std::size_t{2} * kRows);
    for (std::uint32_t signal = 0; signal < 2; ++signal)
        for (Tick i = 0; i < kRows; ++i)
            block.fast.push_back(codeAt(tick + i, signal));
    return block;
}

struct World {
    Capture capture;
    Tick next = 0;

    explicit World(bool archived)
        : capture({.maxBytes = 2'000'000,
            .archive = archived ? std::make_shared<MemoryArchive>() : nullptr})
    {
        capture.begin(layout());
    }
    /// @param left  allocations that succeed; @return whether one failed
    bool append(int blocks, long left = -1, bool forGood = false)
    {
        bool failed = false;
        for (int i = 0; i < blocks; ++i, next += kRows) {
            const SampleBlock block = blockAt(next);
            s_failed = false;
            s_forGood = forGood;
            s_left = left;
            capture.append(block);
            const long unused = std::exchange(s_left, -1);
            if (!forGood)
                left = s_failed ? -1 : unused;
            failed = failed || s_failed;
        }
        return failed;
    }
    /// Every sample that is there stands at its own time and has its own value.
    bool isTrue() const
    {
        const auto span = capture.timeSpan();
        if (!span)
            return true;
        for (std::uint32_t signal = 0; signal < 2; ++signal) {
            const auto id = capture.find(signal + 1);
            if (!id)
                return false;
            const auto samples = capture.channel(*id)->samples(span->from, span->to, 1'000'000);
            for (std::size_t i = 0; i < samples.size(); i += 7) {
                const auto tick = static_cast<Tick>(std::llround(samples[i].time * 16000.0));
                if (std::abs(samples[i].value - 0.1 * codeAt(tick, signal)) > 1e-9)
                    return false;
            }
            if (capture.columns(*id, span->from, span->to, 100).size() != 100)
                return false;
        }
        return true;
    }
};

} // namespace

void TestOutOfMemory::anyAllocationOfAnAppendMayFail_data()
{
    QTest::addColumn<bool>("archived");
    QTest::addColumn<int>("before");
    QTest::addRow("from the first block on") << false << 0;
    QTest::addRow("where a chunk ends") << false << 15;
    QTest::addRow("where the oldest is let go") << false << 150;
    QTest::addRow("where samples go to the archive") << true << 150;
}

void TestOutOfMemory::anyAllocationOfAnAppendMayFail()
{
    QFETCH(bool, archived);
    QFETCH(int, before);
    int failures = 0;
    for (long k = 0; k < 10'000; ++k) {
        const QByteArray place = "allocation " + QByteArray::number(qlonglong(k));
        World world(archived);
        world.append(before);
        const bool failed = world.append(40, k);
        failures += failed ? 1 : 0;
        QVERIFY2(world.isTrue(), place.constData());
        const auto ends = world.capture.timeSpan();
        world.append(20);
        QVERIFY2(world.isTrue(), place.constData());
        QVERIFY2(world.capture.timeSpan()->to > (ends ? ends->to : 0.0), place.constData());
        if (!failed)
            break;
    }
    QVERIFY2(failures > 3, qPrintable(QString::number(failures)));
}

void TestOutOfMemory::withoutAnyMemoryTheOldestGoesOn()
{
    World world(false);
    world.append(100);
    const auto revision = world.capture.revision();
    QVERIFY(world.append(60, 0, true));
    QVERIFY(world.isTrue());
    QVERIFY(world.capture.revision() > revision);
    QVERIFY(world.capture.released() > 0);
    world.append(60);
    QVERIFY(world.isTrue());
    const auto span = world.capture.timeSpan();
    QVERIFY(span->to > double(world.next - 2 * Tick{kRows}) / 16000.0);
}

QTEST_APPLESS_MAIN(TestOutOfMemory)
#include "tst_out_of_memory.moc"
