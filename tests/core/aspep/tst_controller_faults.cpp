// A Controller and a simulated board over a line that spoils bytes: whatever it does, the promises hold. Seeded and on
// virtual time; a failure prints its seed. ROTORSCOPE_LONG=1 multiplies the seeds by 100; support/seeds.h says which
// others.
#include "mcp/datalog.h"
#include "mcp/request.h"
#include "support/controller_pair.h"
#include "support/seeds.h"

#include <QtTest>

using namespace support;
using aspep::Controller;

class TestControllerFaults : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyRequestEndsOnceAndTheLinkComesBack_data();
    void everyRequestEndsOnceAndTheLinkComesBack();
    void theSameSeedGivesTheSameRun();
};

namespace {

/// Asks all the time, streams if told to, connects again when the link is lost; notes what must not be.
class Talker {
public:
    Talker(ControllerPair &pair, bool stream)
        : m_pair(pair)
        , m_stream(stream)
    {
        m_pair.controller.connect(m_pair.now);
    }

    int answered() const { return m_answered; }
    QStringList complaints() const { return m_complaints; }
    bool connected() const { return m_pair.controller.state() == Controller::State::Connected; }

    void operator()()
    {
        for (const auto &event : m_pair.takeEvents())
            hear(event);
        if (!m_pair.controller.canSend() || m_pair.now < m_next)
            return;
        if (m_open)
            complain("may send although a request is open");
        m_pair.controller.sendRequest(request(), m_pair.now);
        m_open = true;
    }

private:
    void complain(const char *what) { m_complaints << QString::fromLatin1(what); }

    void hear(const Controller::Event &event)
    {
        if (std::holds_alternative<Controller::Response>(event)
            || std::holds_alternative<Controller::NoResponse>(event)) {
            if (!m_open)
                complain("an end without a request");
            m_open = false;
            m_answered += std::holds_alternative<Controller::Response>(event) ? 1 : 0;
        } else if (std::holds_alternative<Controller::Connected>(event)
            || std::holds_alternative<Controller::Recovered>(event)) {
            m_step = 0;
            if (m_open)
                complain("connected while a request is open");
        } else if (std::holds_alternative<Controller::Lost>(event)) {
            if (m_open)
                complain("lost while a request is open");
            m_pair.controller.connect(m_pair.now);
        }
    }

    Bytes request()
    {
        if (m_step++ == 0)
            return datalog(mcp::datalogStop(2048));
        if (m_step == 2 && m_stream) {
            mcp::DatalogConfig config;
            config.bufferSize = 1024;
            config.fast = {{0x07D1}, {0x0811}};
            config.mark = static_cast<std::uint8_t>(m_mark++ % 255 + 1);
            return datalog(config);
        }
        m_next = m_pair.now + 10ms;
        const std::vector<mcp::RegisterId> ids{{0x0059}, {0x0019}, {0x0591}, {0x0049}};
        return *mcp::encodeGet(ids, 256);
    }

    static Bytes datalog(const mcp::DatalogConfig &config)
    {
        const mcp::RegisterValue write{mcp::datalogRegister(0), *mcp::encodeDatalog(config)};
        return *mcp::encodeSet(std::vector{write}, 256);
    }

    ControllerPair &m_pair;
    bool m_stream;
    bool m_open = false;
    int m_step = 0;
    int m_mark = 0;
    int m_answered = 0;
    TimePoint m_next{};
    QStringList m_complaints;
};

struct Kind {
    const char *name = nullptr;
    SpoiltFaults faults;
    bool stream = false;
};

const Kind kKinds[] = {
    {"bit flips", {.flip = 1e-3}},
    {"lost bytes", {.drop = 1e-3}},
    {"doubled bytes", {.duplicate = 1e-3}},
    {"strange bytes", {.insert = 1e-3}},
    {"stalls", {.stall = 1e-3, .stallTime = 200ms}},
    {"cuts", {.cut = 1e-3, .cutTime = 100ms}},
    {"bit flips in a stream", {.flip = 3e-5}, true},
    {"lost bytes in a stream", {.drop = 3e-5}, true},
    {"strange bytes in a stream", {.insert = 3e-5}, true},
    {"cuts in a stream", {.cut = 1e-5, .cutTime = 100ms}, true},
};

} // namespace

void TestControllerFaults::everyRequestEndsOnceAndTheLinkComesBack_data()
{
    QTest::addColumn<int>("kind");
    for (int i = 0; i < int(std::size(kKinds)); ++i)
        QTest::newRow(kKinds[i].name) << i;
}

void TestControllerFaults::everyRequestEndsOnceAndTheLinkComesBack()
{
    QFETCH(int, kind);
    const std::string wrong = playSeeds(seedsOf(10, 1000), [&](std::uint64_t seed) {
        ControllerPair pair({}, kKinds[kind].faults, seed);
        Talker talker(pair, kKinds[kind].stream);
        pair.run(1500ms, [&talker] { talker(); });
        pair.setFaults({});
        const int before = talker.answered();
        pair.run(5s, [&talker] { talker(); });
        if (!talker.complaints().isEmpty())
            return talker.complaints().join(", ").toStdString();
        if (!talker.connected())
            return std::string("not connected when the faults were over");
        return std::string(talker.answered() > before + 100 ? "" : "hardly an answer");
    });
    QVERIFY2(wrong.empty(), wrong.c_str());
}

void TestControllerFaults::theSameSeedGivesTheSameRun()
{
    const auto run = [](std::uint64_t seed) {
        ControllerPair pair({}, {.flip = 1e-3, .drop = 5e-4}, seed);
        Bytes seen;
        pair.tap = [&seen](TimePoint, bool, ByteView bytes) {
            seen.insert(seen.end(), bytes.begin(), bytes.end());
        };
        Talker talker(pair, false);
        pair.run(1s, [&talker] { talker(); });
        return seen;
    };
    QCOMPARE(run(7), run(7));
    QVERIFY(run(7) != run(8));
}

QTEST_APPLESS_MAIN(TestControllerFaults)
#include "tst_controller_faults.moc"
