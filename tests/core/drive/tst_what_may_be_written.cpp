// What may be written from anywhere: each register's effect is decided, a restore moves nothing, and what leaves on the
// wire is exactly what was asked for and lies within the limits. On simulated boards of all protocols, by seeds.
#include "catalog/catalog.h"
#include "catalog/control_mode.h"
#include "catalog/csv.h"
#include "drive/mcp/requests.h"
#include "drive/motion_limits.h"
#include "fcp/register_table.h"
#include "mcb/dictionary.h"
#include "snapshots/restore.h"
#include "support/fcp_bench.h"
#include "support/mcb/pair.h"
#include "support/places.h"

#include <QFile>
#include <QTest>

using namespace std::chrono_literals;
using catalog::Effect;
using catalog::RegisterInfo;
using drive::Outcome;
using drive::Reach;
using support::Random;

class TestWhatMayBeWritten : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyWritableRegisterIsDecided();
    void whatIsMoreThanAParameterIsAskedAbout();
    void noRestoreMovesAnything_data();
    void noRestoreMovesAnything();
    void theWireHasWhatWasAskedWithinTheLimits_data();
    void theWireHasWhatWasAskedWithinTheLimits();
    void noSetPointBeyondTheLimitsLeaves_data();
    void noSetPointBeyondTheLimitsLeaves();
    void aStopARestoreAndAStartStayWithinOnesOwnLimit();
    void aRestoreDoesNotEnableAServo();
    void theStateMachineIsWalkedByCommandsAlone();
    void thePositionInRawBytesIsJudgedByTheWay();
    void whatNothingBoundsTakesAWord();
    void aPresentFaultIsNotAcknowledged_data();
    void aPresentFaultIsNotAcknowledged();
};

namespace {

constexpr drive::UserLimits kOwn{900.0, 0.5};

struct Decision {
    std::string table, name, effect;
    auto operator<=>(const Decision &) const = default;
};

std::set<Decision> decided()
{
    QFile file(support::dataFile(QStringLiteral("register_effects.txt")));
    std::set<Decision> all;
    if (!file.open(QIODevice::ReadOnly))
        return all;
    for (const QByteArray &line : file.readAll().split('\n')) {
        const auto words = line.split(' ');
        if (words.size() == 3)
            all.insert({words[0].toStdString(), words[1].toStdString(), words[2].toStdString()});
    }
    return all;
}

std::string wordOf(Effect effect)
{
    for (const char *word : {"kept", "reference", "mode", "unbounded", "command", "board"})
        if (catalog::effectOf(word) == effect)
            return word;
    return "unknown";
}

std::vector<std::pair<std::string, RegisterInfo>> allRegisters()
{
    std::vector<std::pair<std::string, RegisterInfo>> all;
    for (const char *family : {"std", "hso"})
        for (const std::uint32_t version :
            {0x060000U, 0x060100U, 0x060102U, 0x060200U, 0x060300U, 0x060400U, 0x060402U}) {
            const auto table =
                catalog::readTable(catalog::builtInTable("mcp"), family, version).value();
            for (const RegisterInfo &info : table)
                all.emplace_back(family, info);
        }
    for (const auto dialect : {fcp::Dialect::Stm32, fcp::Dialect::PowerPc})
        for (const fcp::Register &one : fcp::registersOf(dialect))
            all.emplace_back("legacy", one.info);
    for (const mcb::Entry &entry : mcb::dictionary()) {
        RegisterInfo info;
        info.name = entry.name;
        info.access = entry.info.access;
        info.effect = entry.effect;
        all.emplace_back("mcb", info);
    }
    return all;
}

/// A board of any protocol, met and armed, with the few verbs that these tests need.
struct WriteBench {
    virtual ~WriteBench() = default;
    virtual drive::Ended ask(decltype(drive::Wish::what) what) = 0;
    virtual const drive::Identified &board() const = 0;
    virtual const std::map<drive::RegisterId, drive::Reading> &values() const = 0;
    virtual drive::MotorState state() const = 0;
    virtual void arm() = 0;
    virtual void run(Duration time) = 0;
    /// Values that left for registers since the call before: id with motor and the bytes of the value.
    virtual std::vector<std::pair<drive::RegisterId, Bytes>> written() = 0;
    virtual Bytes bytesOf(const RegisterInfo &info, const drive::Value &value) const = 0;

    const catalog::Catalog &catalog() const { return *board().catalog; }
    std::map<drive::RegisterId, drive::Value> read(const std::vector<drive::RegisterId> &ids)
    {
        ask(drive::Read{ids});
        std::map<drive::RegisterId, drive::Value> all;
        for (const drive::RegisterId id : ids)
            if (const auto at = values().find(id);
                at != values().end() && at->second.status == drive::ReadStatus::Ok)
                all[id] = at->second.value;
        return all;
    }
};

struct LineBench : WriteBench {
    explicit LineBench(const std::string &profile)
        : isFcp(simulation::isFcpProfile(profile))
        , dialect(profile == "powerpc" ? fcp::Dialect::PowerPc : fcp::Dialect::Stm32)
    {
        simulation::BoardOptions options;
        options.profile = profile;
        if (isFcp)
            options.baud = 115200;
        pair.emplace(options);
        pair->connect();
        pair->runUntilIdentified();
        pair->drive->arm();
        pair->runUntil([&] { return pair->status.contains(1); }, 3s);
        written();
    }
    drive::Ended ask(decltype(drive::Wish::what) what) override
    {
        const auto id = pair->submit(std::move(what));
        return pair->runUntilEnded(id, 30s) ? pair->ended.at(id).front()
                                            : drive::Ended{id, Outcome::Unknown, "never", {}};
    }
    const drive::Identified &board() const override { return *pair->identified; }
    const std::map<drive::RegisterId, drive::Reading> &values() const override
    {
        return pair->values;
    }
    drive::MotorState state() const override { return pair->status.at(1).state; }
    void arm() override { pair->drive->arm(); }
    void run(Duration time) override { pair->runFor(time); }
    std::vector<std::pair<drive::RegisterId, Bytes>> written() override
    {
        std::vector<std::pair<drive::RegisterId, Bytes>> all;
        for (const Bytes &request : std::exchange(pair->requests, {}))
            isFcp ? noteFcp(request, all) : noteMcp(request, all);
        return all;
    }
    Bytes bytesOf(const RegisterInfo &info, const drive::Value &value) const override
    {
        if (!isFcp) {
            ByteWriter bytes;
            if (const auto wanted = drive::wireValue(info, value))
                static_cast<void>(
                    mcp::encodeValue({static_cast<std::uint16_t>(info.id)}, *wanted, bytes));
            return bytes.take();
        }
        const auto number = static_cast<std::uint8_t>(info.id >> 3);
        if (const auto *one = fcp::findRegister(dialect, number);
            one != nullptr && one->writeBytes > 0)
            return fcp::encodeValue(*one, catalog::onWire(info, value), one->writeBytes);
        return {};
    }
    static void noteMcp(const Bytes &request, std::vector<std::pair<drive::RegisterId, Bytes>> &all)
    {
        ByteReader reader(request);
        if (request.size() < 4
            || reader.u16() >> 3 != static_cast<unsigned>(mcp::CommandId::SetRegister))
            return;
        const drive::RegisterId id = reader.u16();
        all.emplace_back(id, Bytes(request.begin() + 4, request.end()));
    }
    static void noteFcp(const Bytes &frame, std::vector<std::pair<drive::RegisterId, Bytes>> &all)
    {
        if (frame.size() < 3)
            return;
        const auto request =
            fcp::decodeRequest({frame[0], Bytes(frame.begin() + 2, frame.end() - 1)});
        if (!request)
            return;
        if (const auto *set = std::get_if<fcp::SetRegister>(&request->command))
            all.emplace_back((drive::RegisterId{set->id} << 3) | request->motor, set->value);
        else if (!std::holds_alternative<fcp::GetRegister>(request->command)
            && !std::holds_alternative<fcp::GetRevUp>(request->command)
            && !std::holds_alternative<fcp::GetBoardInfo>(request->command)
            && !std::holds_alternative<fcp::GetFirmwareVersion>(request->command))
            all.emplace_back(0, frame);
    }
    bool isFcp;
    fcp::Dialect dialect;
    std::optional<support::LinkPair> pair;
};

struct ServoWriteBench : WriteBench {
    ServoWriteBench()
    {
        pair.meet();
        pair.drive->arm();
        written();
    }
    drive::Ended ask(decltype(drive::Wish::what) what) override
    {
        return pair.ask(std::move(what), 30s);
    }
    const drive::Identified &board() const override { return *pair.identified; }
    const std::map<drive::RegisterId, drive::Reading> &values() const override
    {
        return pair.values;
    }
    drive::MotorState state() const override { return pair.status->state; }
    void arm() override { pair.drive->arm(); }
    void run(Duration time) override { pair.runFor(time); }
    std::vector<std::pair<drive::RegisterId, Bytes>> written() override
    {
        std::vector<std::pair<drive::RegisterId, Bytes>> all;
        for (const mcb::Frame &frame : std::exchange(pair.writes, {})) {
            ByteWriter bytes;
            for (const std::uint16_t word : frame.config)
                bytes.u16(word);
            all.emplace_back((drive::RegisterId{frame.address} << 3) | 1U, bytes.take());
        }
        return all;
    }
    Bytes bytesOf(const RegisterInfo &info, const drive::Value &value) const override
    {
        const auto *entry = mcb::findEntry(static_cast<std::uint16_t>(info.id >> 3));
        ByteWriter bytes;
        std::size_t count = 0;
        if (entry != nullptr)
            for (const std::uint16_t word :
                mcb::encodeValue(entry->info, value).value_or(mcb::Words())) {
                bytes.u16(word);
                ++count;
            }
        for (; count < 4; ++count)
            bytes.u16(0);
        return bytes.take();
    }
    support::McbPair pair;
};

std::unique_ptr<WriteBench> benchOf(const QString &profile)
{
    if (profile == QLatin1String("mcb"))
        return std::make_unique<ServoWriteBench>();
    return std::make_unique<LineBench>(profile.toStdString());
}

void addProfiles()
{
    QTest::addColumn<QString>("profile");
    for (const std::string &name : simulation::profileNames())
        QTest::newRow(std::string(name).c_str()) << QString::fromStdString(std::string(name));
    for (const std::string_view name : simulation::fcpProfiles())
        QTest::newRow(std::string(name).c_str()) << QString::fromStdString(std::string(name));
    QTest::newRow("mcb") << QStringLiteral("mcb");
}

/// What a restore has to leave as it was.
std::vector<drive::RegisterId> references(const catalog::Catalog &catalog)
{
    std::vector<drive::RegisterId> ids;
    for (const RegisterInfo &info : catalog.registers())
        if (info.readable() && info.writable() && !info.stub && info.effect != Effect::Kept)
            ids.push_back(catalog.withMotor(info, 1));
    return ids;
}

/// Small, extreme, beyond, not a number, of another kind.
drive::Value anyValue(const RegisterInfo &info, Random &random)
{
    if (info.type == catalog::ValueType::Raw) {
        Bytes bytes(random.chance(0.7) ? 4 + 2 * random.below(3) : random.below(50));
        for (auto &byte : bytes)
            byte = static_cast<std::uint8_t>(random.chance(0.4) ? 0
                    : random.chance(0.3)                        ? 0xFF
                                                                : random.below(256));
        return bytes;
    }
    switch (random.below(9)) {
    case 0:
        return std::numeric_limits<double>::quiet_NaN();
    case 1:
        return std::numeric_limits<double>::infinity();
    case 2:
        return -1e39;
    case 3:
        return static_cast<std::int64_t>(random.next());
    case 4:
        return std::int64_t{1} << random.below(40);
    case 5:
        return -(std::int64_t{1} << random.below(40));
    case 6:
        return static_cast<double>(random.below(2000)) / 100.0;
    default:
        return static_cast<std::int64_t>(random.below(300)) - 100;
    }
}

} // namespace

void TestWhatMayBeWritten::everyWritableRegisterIsDecided()
{
    const auto decisions = decided();
    QVERIFY(decisions.size() > 300);
    std::set<Decision> found;
    for (const auto &[table, info] : allRegisters())
        if (info.writable())
            found.insert({table, info.name, wordOf(info.effect)});
    for (const Decision &one : found)
        QVERIFY2(decisions.contains(one), (one.table + ' ' + one.name + ' ' + one.effect).c_str());
    // Of the table, some are in no build that is read; but none is another one than decided.
    for (const Decision &one : decisions) {
        const auto other = std::find_if(found.begin(), found.end(),
            [&](const Decision &f) { return f.table == one.table && f.name == one.name; });
        QVERIFY2(other == found.end() || *other == one, one.name.c_str());
    }
}

void TestWhatMayBeWritten::whatIsMoreThanAParameterIsAskedAbout()
{
    for (const char *profile : {"mcsdk-6.4", "mcb"}) {
        const auto bench = benchOf(QString::fromLatin1(profile));
        for (const RegisterInfo &info : bench->catalog().registers())
            // Streaming's own.
            if (info.writable() && info.effect != Effect::Kept && !info.name.starts_with("ASYNC_"))
                QVERIFY2(info.dangerous, info.name.c_str());
    }
}

void TestWhatMayBeWritten::noRestoreMovesAnything_data() { addProfiles(); }

void TestWhatMayBeWritten::noRestoreMovesAnything()
{
    QFETCH(QString, profile);
    const auto bench = benchOf(profile);
    const auto &catalog = bench->catalog();
    const auto held = references(catalog);
    const auto all = snapshots::snapshotRegisters(catalog, snapshots::Scope::All);
    constexpr std::uint64_t kSeeds = 4;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        Random random(seed);
        const auto before = bench->read(held);
        const auto state = bench->state();
        bench->read(all);
        std::vector<drive::Reading> readings;
        for (const drive::RegisterId id : all)
            if (const auto at = bench->values().find(id); at != bench->values().end())
                readings.push_back(at->second);
        const snapshots::Snapshot now =
            snapshots::snapshotOf(bench->board().identity, catalog, readings);
        snapshots::Snapshot wanted = now;
        for (snapshots::Entry &entry : wanted.entries) {
            entry.tunable = random.chance(0.8); // whatever the file says
            if (random.chance(0.6))
                entry.value = anyValue(*catalog.find(entry.id), random);
        }
        const auto plan = snapshots::planRestore(wanted, now, catalog, {},
            random.chance(0.5) ? std::vector<int>{} : std::vector<int>{1});
        // The user's own limits refuse some of it, the board some more.
        bench->ask(random.chance(0.5) ? kOwn : drive::UserLimits{});
        bench->arm();
        bench->written();
        bench->ask(drive::Write{plan.writes, Reach::Parameters});
        // And its undo; and a plan of all registers, made elsewhere.
        std::vector<drive::RegisterWrite> back, everything;
        for (const drive::RegisterWrite &write : plan.writes)
            if (const auto at = bench->values().find(write.id); at != bench->values().end())
                back.insert(back.begin(), {write.id, at->second.value});
        for (const snapshots::Entry &entry : wanted.entries)
            everything.push_back({entry.id, entry.value});
        bench->ask(drive::Write{back, Reach::Parameters});
        bench->ask(drive::Write{everything, Reach::Parameters});
        for (const auto &[id, bytes] : bench->written()) {
            const RegisterInfo *info = catalog.find(id);
            // Of the frames of the older protocol only the stages of a start-up are no register.
            const bool stages = id == 0 && !bytes.empty() && (bytes[0] & 0x1FU) == 0x09;
            QVERIFY2(stages || (info != nullptr && info->effect == Effect::Kept),
                info != nullptr ? info->name.c_str() : "an act");
        }
        bench->run(300ms);
        QVERIFY2(bench->state() == state, profile.toUtf8().constData());
        QVERIFY(bench->read(held) == before);
    }
}

void TestWhatMayBeWritten::theWireHasWhatWasAskedWithinTheLimits_data() { addProfiles(); }

void TestWhatMayBeWritten::theWireHasWhatWasAskedWithinTheLimits()
{
    QFETCH(QString, profile);
    const auto bench = benchOf(profile);
    const auto &catalog = bench->catalog();
    const drive::MotorLimits limits = bench->board().limits.front();
    int left = 0;
    Random random(7);
    for (const RegisterInfo &info : catalog.registers()) {
        if (info.name == "DRV_BOOT_RESET" || info.name == "BOOT_MODE")
            continue; // the board would be another one
        for (int i = 0; i < 6; ++i) {
            const bool own = random.chance(0.5);
            const Reach reach = random.chance(0.5) ? Reach::Everything : Reach::References;
            const drive::UserLimits user = own ? kOwn : drive::UserLimits{};
            bench->ask(user);
            bench->arm();
            bench->written();
            const drive::RegisterId id = catalog.withMotor(info, 1);
            const drive::Value value = anyValue(info, random);
            bench->ask(drive::Write{{{id, value}}, reach});
            for (const auto &[where, bytes] : bench->written()) {
                ++left;
                const bool stages = where == 0 && (bytes[0] & 0x1FU) == 0x09;
                constexpr drive::RegisterId kMotor = 7;
                QVERIFY2((where | kMotor) == (id | kMotor) || stages, info.name.c_str());
                if (stages)
                    continue;
                QVERIFY2(bytes == bench->bytesOf(info, value), info.name.c_str());
                QVERIFY2(!info.takesWord() || (reach == Reach::Everything && !own)
                        || (info.effect == Effect::Board && reach == Reach::Everything),
                    info.name.c_str());
                const auto number = drive::asNumber(value);
                const drive::MotionBounds bounds = drive::boundsOf(limits, user, false);
                const double each = drive::setPointPerDigit(info, catalog.readScale(id), limits);
                if (info.setPoint != catalog::SetPoint::None && number) {
                    const double bound =
                        info.setPoint == catalog::SetPoint::Speed ? bounds.rpm : bounds.amps;
                    QVERIFY2(std::abs(*number * each) <= bound * 1.000001, info.name.c_str());
                }
                if (info.name == "SPEED_RAMP") {
                    ByteReader reader(std::get<Bytes>(value));
                    QVERIFY(std::abs(reader.s32()) <= std::min(bounds.rpm, 32767.0));
                }
                if (info.name == "POSITION_RAMP") {
                    ByteReader reader(std::get<Bytes>(value));
                    const float radians = reader.f32(), seconds = reader.f32();
                    QVERIFY(std::isfinite(radians) && std::isfinite(seconds) && seconds > 0.0F);
                }
            }
        }
    }
    QVERIFY2(left > 20, std::to_string(left).c_str());
}

void TestWhatMayBeWritten::noSetPointBeyondTheLimitsLeaves_data() { addProfiles(); }

void TestWhatMayBeWritten::noSetPointBeyondTheLimitsLeaves()
{
    QFETCH(QString, profile);
    const auto bench = benchOf(profile);
    bench->ask(kOwn);
    bench->arm();
    Random random(11);
    const auto number = [&]() -> double {
        switch (random.below(6)) {
        case 0:
            return std::numeric_limits<double>::quiet_NaN();
        case 1:
            return std::numeric_limits<double>::infinity();
        case 2:
            return -1e12;
        case 3:
            return 901.0 + static_cast<double>(random.below(100000));
        case 4:
            return -65536.0 - static_cast<double>(random.below(600));
        default:
            return 2e9;
        }
    };
    for (int i = 0; i < 60; ++i) {
        const double asked = number();
        const auto time = std::chrono::milliseconds(random.below(70000));
        const auto rpm =
            static_cast<std::int32_t>(std::isfinite(asked) ? std::clamp(asked, -2e9, 2e9) : 2e9);
        bench->written();
        for (const decltype(drive::Wish::what) &wish :
            std::initializer_list<decltype(drive::Wish::what)>{
                drive::SpeedRamp{1, std::abs(rpm) > 900 ? rpm : 901, time},
                drive::TorqueRamp{1, asked, time}, drive::CurrentReference{1, asked, 0.0},
                drive::CurrentReference{1, 0.4, 0.4}, // together beyond
                drive::PositionRamp{1, asked, 1ms}})
            QVERIFY(bench->ask(wish).outcome != Outcome::Ok);
        QVERIFY(bench->written().empty());
    }
}

void TestWhatMayBeWritten::aStopARestoreAndAStartStayWithinOnesOwnLimit()
{
    support::Session session;
    QVERIFY(session.runAt(3000));
    const auto &catalog = *session.identified->catalog;
    const auto all = snapshots::snapshotRegisters(catalog, snapshots::Scope::All);
    const auto take = [&] {
        session.runUntilEnded(session.submit(drive::Read{all}), 20s);
        std::vector<drive::Reading> readings;
        for (const drive::RegisterId id : all)
            readings.push_back(session.values.at(id));
        return snapshots::snapshotOf(session.identified->identity, catalog, readings);
    };
    snapshots::Snapshot snapshot = take();
    for (snapshots::Entry &entry : snapshot.entries)
        entry.tunable = catalog.find(entry.id)->writable(); // as older files have it
    session.runUntilEnded(session.submit(drive::SpeedRamp{1, 1000, 300ms}));
    session.drive->stop(session.now);
    QVERIFY(session.runUntilState(drive::MotorState::Idle));
    session.runFor(3s);

    session.runUntilEnded(session.submit(drive::UserLimits{1200.0, 0.0}));
    session.drive->arm();
    const snapshots::Snapshot stopped = take();
    const auto plan = snapshots::planRestore(snapshot, stopped, catalog);
    QVERIFY(!plan.left.empty());
    session.runUntilEnded(session.submit(drive::Write{plan.writes, Reach::Parameters}), 20s);
    session.runUntilEnded(session.submit(drive::Read{all}), 20s);
    QVERIFY(session.values.at(session.id("CONTROL_MODE")).value
        == drive::Value(catalog::kSpeedModeNumber));
    QVERIFY(
        session.values.at(session.id("SPEED_REF")).value == stopped.find("SPEED_REF", 1)->value);

    // And where torque control is set all the same, a start would keep no speed.
    session.runUntilEnded(session.submit(drive::UserLimits{}));
    session.runUntilEnded(session.submit(drive::TorqueRamp{1, 0.2, 0ms}));
    session.runUntilEnded(session.submit(drive::UserLimits{1200.0, 0.0}));
    const auto start = session.submit(drive::Command{drive::MotorAction::Start, 1});
    QVERIFY(session.runUntilEnded(start));
    QVERIFY(session.outcome(start) == Outcome::Refused);
    QVERIFY(session.ended.at(start).front().reason.find("1200 rpm") != std::string::npos);
    const auto mode =
        session.submit(drive::Write{{{session.id("CONTROL_MODE"), catalog::kTorqueModeNumber}}});
    QVERIFY(session.runUntilEnded(mode) && session.outcome(mode) == Outcome::Refused);
}

void TestWhatMayBeWritten::aRestoreDoesNotEnableAServo()
{
    support::McbPair pair;
    QVERIFY(pair.meet());
    pair.drive->arm();
    const auto &catalog = *pair.identified->catalog;
    pair.ask(drive::SpeedRamp{1, 300, 0ms});
    QVERIFY(pair.ask(drive::Command{drive::MotorAction::Start, 1}).outcome == Outcome::Ok);
    QVERIFY(pair.runUntilState(drive::MotorState::Running));
    const auto all = snapshots::snapshotRegisters(catalog, snapshots::Scope::All);
    const auto take = [&] {
        pair.ask(drive::Read{all}, 20s);
        std::vector<drive::Reading> readings;
        for (const drive::RegisterId id : all)
            if (const auto at = pair.values.find(id); at != pair.values.end())
                readings.push_back(at->second);
        return snapshots::snapshotOf(pair.identified->identity, catalog, readings);
    };
    snapshots::Snapshot snapshot = take();
    for (snapshots::Entry &entry : snapshot.entries)
        entry.tunable = catalog.find(entry.id)->writable();
    pair.drive->stop(pair.now);
    QVERIFY(pair.runUntilState(drive::MotorState::Idle));
    pair.runFor(3s);
    pair.drive->arm();
    const auto plan = snapshots::planRestore(snapshot, take(), catalog);
    QVERIFY(std::any_of(plan.left.begin(), plan.left.end(), [](const auto &left) {
        return left.name == "DRV_STATE_CONTROL" && left.why == snapshots::NotRestored::Moves;
    }));
    if (!plan.writes.empty())
        pair.ask(drive::Write{plan.writes, Reach::Parameters}, 20s);
    pair.runFor(1s);
    QVERIFY(pair.status->state == drive::MotorState::Idle);
}

void TestWhatMayBeWritten::theStateMachineIsWalkedByCommandsAlone()
{
    support::McbPair pair;
    QVERIFY(pair.meet());
    pair.drive->arm();
    pair.ask(drive::UserLimits{10.0, 0.0});
    for (const std::int64_t word : {6, 7, 15, 0, 128}) {
        pair.writes.clear();
        const auto ended =
            pair.ask(drive::Write{{{pair.id("DRV_STATE_CONTROL"), word}}, Reach::Everything});
        QVERIFY(ended.outcome == Outcome::Refused);
        QVERIFY(ended.reason.find("start") != std::string::npos);
        QVERIFY(pair.writes.empty());
    }
    // A mode that would follow what is beyond one's own limit at once.
    pair.ask(drive::UserLimits{});
    pair.ask(drive::Write{{{pair.id("CL_VEL_SET_POINT_VALUE"), 5.0}}});
    pair.ask(drive::UserLimits{100.0, 0.0});
    QVERIFY(pair.ask(drive::Write{{{pair.id("DRV_OP_CMD"), std::int64_t{3}}}}).outcome
        == Outcome::Refused);
}

void TestWhatMayBeWritten::thePositionInRawBytesIsJudgedByTheWay()
{
    simulation::BoardOptions options;
    options.motor = "servo24";
    for (const auto &option : simulation::buildOptions())
        if (option.name == "position")
            options.with.push_back(&option);
    support::Session session(true, options);
    QVERIFY(session.ready);
    const auto set = [&](float radians, float seconds) {
        const auto wish = session.submit(drive::Write{
            {{session.id("POSITION_RAMP"), ByteWriter().f32(radians).f32(seconds).take()}}});
        session.runUntilEnded(wish);
        return session.outcome(wish);
    };
    const std::size_t before = support::count(session.requests, mcp::CommandId::SetRegister);
    session.runUntilEnded(session.submit(drive::UserLimits{100.0, 0.0}));
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    for (const auto &[radians, seconds] :
        {std::pair{1000.0F, 0.1F}, {kNan, 1.0F}, {1.0F, kNan}, {1.0F, 0.0F}, {1.0F, -1.0F},
            {std::numeric_limits<float>::infinity(), 1.0F}, {1e6F, 60.0F}, {20.0F, 0.5F}})
        QVERIFY(set(radians, seconds) == Outcome::Refused);
    QCOMPARE(support::count(session.requests, mcp::CommandId::SetRegister), before);
    QVERIFY(set(1.0F, 5.0F) == Outcome::Ok);
}

void TestWhatMayBeWritten::whatNothingBoundsTakesAWord()
{
    const auto bench = benchOf(QStringLiteral("mcb"));
    const auto write = [&](const char *name, drive::Value value, Reach reach) {
        return bench->ask(drive::Write{{{*bench->catalog().resolve(name), value}}, reach}).outcome;
    };
    for (const char *name : {"CL_VOL_Q_SET_POINT", "CL_VEL_CMD_OFFSET"}) {
        QVERIFY2(write(name, 0.5, Reach::References) == Outcome::Refused, name);
        QVERIFY2(write(name, 0.5, Reach::Everything) == Outcome::Ok, name);
        bench->ask(kOwn);
        QVERIFY2(write(name, 0.25, Reach::Everything) == Outcome::Refused, name);
        bench->ask(drive::UserLimits{});
    }
}

void TestWhatMayBeWritten::aPresentFaultIsNotAcknowledged_data()
{
    QTest::addColumn<QString>("profile");
    for (const char *name : {"mcsdk-6.4", "legacy", "powerpc"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestWhatMayBeWritten::aPresentFaultIsNotAcknowledged()
{
    QFETCH(QString, profile);
    LineBench bench(profile.toStdString());
    constexpr std::uint16_t kOverVoltage = 2;
    bench.pair->board->setFaults(kOverVoltage);
    bench.run(1s);
    bench.arm();
    bench.written();
    const auto sentBefore = bench.pair->sent.size();
    const auto ended = bench.ask(drive::Command{drive::MotorAction::AcknowledgeFaults, 1});
    QVERIFY(ended.outcome == Outcome::Refused);
    QVERIFY(ended.reason.find("still present") != std::string::npos);
    QCOMPARE(bench.pair->sent.size(), sentBefore);
    bench.pair->board->setFaults(0);
    bench.run(1s);
    bench.arm();
    QVERIFY(
        bench.ask(drive::Command{drive::MotorAction::AcknowledgeFaults, 1}).outcome == Outcome::Ok);
}

QTEST_APPLESS_MAIN(TestWhatMayBeWritten)
#include "tst_what_may_be_written.moc"
