// FcpDrive on a line that is being spoilt: seeded sessions in both dialects, with one motor or two. Whatever the line
// does, each wish ends once, every Stop is kept (the judge of the wire sees to that), nothing is written before the
// board is identified, and no value appears under a register's name that it does not have. Faults come singly: two that
// cancel each other in the sum of a frame are beyond what this protocol can notice. ROTORSCOPE_LONG=1 runs 10,000
// sessions a dialect; support/seeds.h says which others. A failure names its seed.
#include "support/link_pair.h"
#include "support/seeds.h"

#include <QTest>

using namespace drive;
using namespace std::chrono_literals;

namespace {

/// Registers of the board, each with a value that no other has: taken for another's it would be noticed.
constexpr std::int64_t kMarkBase = 4000;

struct FaultySession : support::LinkPair {
    FaultySession(const simulation::BoardOptions &options, std::uint64_t seed)
        : LinkPair(options, seed)
        , random(seed)
        , stalls(seed + 1)
    {
        verdictTaken = true;
        if (seed % 2 == 0)
            expectStalls(longestStall = 900ms);
        onEvent = [this](const Event &event) { look(event); };
        const double rate = 2e-5 * static_cast<double>(1 + random.below(10));
        for (support::LineFaults *faults : {&toBoard, &toDrive}) {
            faults->flip = random.below(2) != 0 ? rate : 0.0;
            faults->drop = random.below(2) != 0 ? rate : 0.0;
            faults->duplicate = random.below(3) == 0 ? rate : 0.0;
            faults->insert = random.below(3) == 0 ? rate : 0.0;
            faults->stall = random.below(4) == 0 ? rate : 0.0;
            faults->stallTime = std::chrono::milliseconds(1 + random.below(60));
        }
        loses = [this](const Bytes &frame) {
            if (!acts(frame))
                return false;
            if (!identified)
                complaints += " acted before the identification;";
            return false;
        };
    }

    /// Whether a frame is none of those that only read, nor what fills a hanging frame up.
    static bool acts(const Bytes &frame)
    {
        const unsigned code = frame[0] & 0x1FU;
        const bool reads = code == 0x02 || code == 0x06 || code == 0x08 || code == 0x0C;
        return frame.size() > 1 && !reads;
    }

    void look(const Event &event)
    {
        const auto *read = std::get_if<RegistersRead>(&event);
        if (read == nullptr || marks.empty())
            return;
        for (const Reading &reading : read->readings) {
            const auto mark = marks.find(reading.id);
            const auto *value = std::get_if<std::int64_t>(&reading.value);
            if (reading.status != ReadStatus::Ok || mark == marks.end() || value == nullptr)
                continue;
            ++values;
            if (mark->second.count(*value) == 0 && belongsToAnother(reading.id, *value))
                complaints += " a value under a wrong name;";
        }
    }
    bool belongsToAnother(RegisterId id, std::int64_t value) const
    {
        for (const auto &[other, known] : marks)
            if (other != id && known.count(value) > 0)
                return true;
        return false;
    }

    void work();

    support::Random random;
    support::Random stalls; ///< of their own, so that a session is the same without them
    Duration longestStall{}; ///< of a program on a busy computer, in every other session
    std::map<RegisterId, std::set<std::int64_t>> marks; ///< what each register may hold
    std::vector<WishId> wishes;
    std::string complaints;
    int values = 0;
};

void FaultySession::work()
{
    const char *const names[] = {"SPEED_KP", "SPEED_KI", "I_Q_KP", "I_Q_KI", "I_D_KP", "I_D_KI"};
    std::int64_t next = kMarkBase;
    Watch watch;
    for (const char *name : names) {
        watch.drawn.push_back(id(name));
        watch.registers.push_back(id(name));
        marks[id(name)] = {};
    }
    drive->arm();
    submit(UserLimits{3000.0, 0.0});
    submit(ExpertMode{1});
    submit(watch);
    for (int step = 0; step < 12; ++step) {
        const RegisterId which = watch.drawn[random.below(watch.drawn.size())];
        const int motor = 1 + static_cast<int>(random.below(2)); // which need not be there
        switch (random.below(11)) {
        case 9: // the board does not hear for a while, and so its motor really goes on
            toBoard.cut = true;
            if (random.below(2) == 0) {
                drive->stop(now);
                exchange();
            }
            runFor(std::chrono::milliseconds(random.below(900)));
            toBoard.cut = false;
            break;
        case 6:
        case 7:
            wishes.push_back(submit(Command{MotorAction::Start, motor}));
            break;
        case 8:
            wishes.push_back(submit(
                SpeedRamp{motor, static_cast<std::int32_t>(random.below(4000)) - 2000, 100ms}));
            break;
        case 0:
        case 1:
            marks[which].insert(++next);
            wishes.push_back(submit(Write{{{which, next}}}));
            break;
        case 2:
            wishes.push_back(submit(Read{{which, id("BUS_VOLTAGE")}}));
            break;
        case 3:
            wishes.push_back(submit(Command{MotorAction::AcknowledgeFaults, 1}));
            break;
        case 4:
            drive->stop(now);
            exchange();
            break;
        default:
            drive->arm();
            break;
        }
        if (longestStall > 0ms && stalls.chance(0.1))
            stall(longestStall * stalls.below(100) / 100);
        runFor(std::chrono::milliseconds(random.below(80)));
    }
}

simulation::BoardOptions boardOf(const QByteArray &profile, std::uint64_t seed)
{
    simulation::BoardOptions options;
    options.profile = profile.toStdString();
    options.baud = 115200;
    options.hfHz = 1000.0; // how well it turns is not looked at
    options.motors = seed % 4 == 0 ? 2 : 1;
    options.seed = seed;
    return options;
}

std::string runSession(const QByteArray &profile, std::uint64_t seed)
{
    FaultySession session(boardOf(profile, seed), seed);
    session.connect();
    if (session.runUntilIdentified(20s) && session.identified->identity.knownFirmware)
        session.work();
    session.runFor(3s); // what is under way ends by itself
    session.drive->disconnect(session.now);
    session.exchange();
    for (const WishId wish : session.wishes)
        if (!session.ended.contains(wish) || session.ended.at(wish).size() != 1)
            session.complaints += " a wish that did not end once;";
    session.complaints += session.judge.verdict();
    return session.complaints;
}

} // namespace

class TestFcpDriveFaults : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyWishEndsOnceAndNoValueGoesAstray_data();
    void everyWishEndsOnceAndNoValueGoesAstray();
    void onAGoodLineTheSameSessionsReadTheirValues();
};

void TestFcpDriveFaults::everyWishEndsOnceAndNoValueGoesAstray_data()
{
    QTest::addColumn<QByteArray>("profile");
    for (const std::string_view name : simulation::fcpProfiles())
        QTest::newRow(name.data()) << QByteArray(name.data());
}

void TestFcpDriveFaults::everyWishEndsOnceAndNoValueGoesAstray()
{
    QFETCH(QByteArray, profile);
    const std::string wrong = support::playSeeds(support::seedsOf(40, 10'000),
        [&](std::uint64_t seed) { return runSession(profile, seed); });
    QVERIFY2(wrong.empty(), wrong.c_str());
}

void TestFcpDriveFaults::onAGoodLineTheSameSessionsReadTheirValues()
{
    // Otherwise the campaign above could pass by reading nothing at all.
    FaultySession session(boardOf("legacy", 7), 7);
    session.toBoard = session.toDrive = {};
    session.connect();
    QVERIFY(session.runUntilIdentified());
    session.work();
    session.runFor(3s);
    QVERIFY(session.values > 500);
    QVERIFY(!session.wishes.empty());
    QVERIFY(session.complaints.empty());
}

QTEST_APPLESS_MAIN(TestFcpDriveFaults)
#include "tst_legacy_drive_faults.moc"
