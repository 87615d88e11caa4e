// An hour with the simulated board, on virtual time: starts, speed steps, load steps, faults and acknowledgements while
// four signals are recorded. Nothing is lost, nothing grows, and the board's count of time stays in step.
// Fast: 36 s of it; ROTORSCOPE_LONG=1 runs the hour.
#include "support/link_pair.h"

#include <QFile>
#include <QTest>

#include <algorithm>

using namespace drive;
using support::Session;
using namespace std::chrono_literals;

namespace {

constexpr std::uint16_t kOverCurrent = 0x40;

bool inFull() { return qEnvironmentVariableIntValue("ROTORSCOPE_LONG") != 0; }

// A sanitizer keeps what was freed for a while.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMemoryTells = false;
#else
constexpr bool kMemoryTells = true;
#endif

/// Resident memory, in pages; 0 where the system does not say, or it would mean nothing.
std::int64_t residentPages()
{
    if (!kMemoryTells)
        return 0;
    QFile statm(QStringLiteral("/proc/self/statm"));
    if (!statm.open(QIODevice::ReadOnly))
        return 0;
    return statm.readAll().split(' ').value(1).toLongLong();
}

class Hour {
public:
    Hour()
        : m_session(true)
        , m_random(3)
    {
        m_session.onEvent = [this](const Event &event) { look(event); };
    }

    /// One round of what a day at a bench is made of; what went wrong, if anything did.
    std::string round()
    {
        m_lag = Duration::max();
        if (!m_session.startMotor())
            return "no start";
        for (int step = 0; step < 3; ++step) {
            const auto rpm = static_cast<std::int32_t>(800 + m_random.below(2000));
            m_session.submit(SpeedRamp{1, rpm, 300ms});
            m_session.board->setLoadTorque(1, 0.01 * static_cast<double>(m_random.below(4)));
            m_session.runFor(2s);
            const double speed = m_session.status[1].speedRpm.value_or(0.0);
            if (std::abs(speed - rpm) > 0.05 * rpm)
                return std::to_string(speed) + " rpm instead of " + std::to_string(rpm);
        }
        m_session.board->setLoadTorque(1, 0.0);
        return m_random.chance(0.5) ? endByFault() : endByStop();
    }

    bool stream()
    {
        Stream stream;
        for (const char *name : {"I_A", "I_B", "I_Q_MEAS", "STOPLL_ROT_SPEED"})
            stream.fast.push_back(m_session.id(name));
        const WishId wish = m_session.submit(stream);
        return m_session.ready && m_session.runUntilEnded(wish)
            && m_session.outcome(wish) == Outcome::Ok;
    }

    void forget() // what a test alone keeps
    {
        m_session.events.clear();
        m_session.ended.clear();
        m_session.sent = {};
        m_session.requests.clear();
        m_session.stops.clear();
    }

    TimePoint now() const { return m_session.now; }
    /// How far the newest sample was behind the clock when it came: the least of the round.
    Duration lag() const { return m_lag; }

    std::int64_t samples = 0, lostTicks = 0;

private:
    std::string endByStop()
    {
        m_session.drive->stop(m_session.now);
        m_session.exchange();
        if (!m_session.runUntilState(MotorState::Idle))
            return "no stop";
        if (!m_session.runUntil([&] { return m_session.hasStopWord(StopWord::MayCoast); }, 20s))
            return "no end of the stop";
        m_session.drive->arm();
        return {};
    }

    std::string endByFault()
    {
        m_session.board->setFaults(kOverCurrent);
        if (!m_session.runUntilState(MotorState::FaultNow))
            return "no fault";
        m_session.board->setFaults(0);
        if (!m_session.runUntilState(MotorState::FaultOver))
            return "the fault stays";
        m_session.runFor(4s); // the rotor runs out
        m_session.submit(Command{MotorAction::AcknowledgeFaults, 1});
        return m_session.runUntilState(MotorState::Idle) ? "" : "not acknowledged";
    }

    void look(const Event &event)
    {
        if (const auto *started = std::get_if<StreamStarted>(&event)) {
            m_layout = started->layout;
        } else if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
            samples += block->count;
            lostTicks += block->lostTicks;
            const auto behind = block->firstTick + static_cast<capture::Tick>(block->count);
            const double at =
                m_layout.originSeconds + static_cast<double>(behind) / m_layout.tickHz;
            m_lag = std::min(m_lag, m_session.now.time_since_epoch() - fromSeconds(at));
        }
    }

    Session m_session;
    support::Random m_random;
    capture::StreamLayout m_layout;
    Duration m_lag{};
};

} // namespace

class TestSoak : public QObject {
    Q_OBJECT

private slots:
    void anHourLosesNothingAndKeepsNothing();
};

void TestSoak::anHourLosesNothingAndKeepsNothing()
{
    constexpr double kRate_hz = 16000.0;
    constexpr std::int64_t kMostPages = 512; // 2 MiB
    const Duration length = inFull() ? Duration(1h) : Duration(36s);
    Hour hour;
    QVERIFY(hour.stream());
    const TimePoint start = hour.now();
    const std::int64_t before = hour.samples;
    std::optional<Duration> firstLag;
    std::optional<std::int64_t> pages;
    while (hour.now() - start < length) {
        const std::string wrong = hour.round();
        const std::string when = std::to_string(toSeconds(hour.now() - start)) + " s: ";
        QVERIFY2(wrong.empty(), (when + wrong).c_str());
        QVERIFY2(hour.lostTicks == 0, (when + "ticks were lost").c_str());
        hour.forget();
        firstLag = firstLag.value_or(hour.lag());
        if (hour.now() - start > length / 3)
            pages = pages.value_or(residentPages());
    }
    const double expected = toSeconds(hour.now() - start) * kRate_hz;
    const auto seen = static_cast<double>(hour.samples - before);
    QVERIFY2(std::abs(seen - expected) < 0.1 * kRate_hz,
        qPrintable(QStringLiteral("%1 samples instead of %2").arg(seen).arg(expected)));
    const Duration drift = hour.lag() - *firstLag;
    QVERIFY2(drift > -1ms && drift < 1ms,
        qPrintable(QString::number(drift.count()) + QLatin1String(" ns")));
    QVERIFY(pages.has_value());
    QVERIFY2(residentPages() - *pages < kMostPages,
        qPrintable(QString::number(residentPages() - *pages)));
}

QTEST_APPLESS_MAIN(TestSoak)
#include "tst_soak.moc"
