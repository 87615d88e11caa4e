// Snapshots as values: what they hold, how two differ, and what a restore would write.
#include "catalog/catalog.h"
#include "snapshots/restore.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace snapshots;
using catalog::Catalog;

class TestSnapshot : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void readsWhatCanBeReadAndNoStub();
    void keepsDigitsAndShownValues();
    void notANumberIsTheSameAsItself();
    void differencesAreExactlyTheChangedOnes();
    void measuredRegistersDifferOnlyIfAsked();
    void whatOneSideLacksIsADifference();
    void aSelectionTakesGroupsRegistersAndMotors();
    void aRestoreWritesOnlyWhatDiffersGainsFirst();
    void aRestoreLeavesWhatItMustNotWrite();
    void whatMovesAMotorIsNotTunableWhateverTheFileSays();
    void otherHardwareIsNamed();
};

namespace {

Catalog makeCatalog(int motors = 1)
{
    catalog::Scales scales;
    scales.ampsPerDigit = 0.002;
    return Catalog(catalog::readTable(catalog::builtInTable("mcp"), "std", 0x060400).value(),
        motors, std::vector(static_cast<std::size_t>(motors), scales));
}

/// Something in every register.
std::vector<drive::Reading> readingsOf(const Catalog &catalog)
{
    std::vector<drive::Reading> readings;
    std::int64_t digits = 1;
    for (const RegisterId id : snapshotRegisters(catalog, Scope::All)) {
        Value value = ++digits % 100;
        const auto type = catalog.find(id)->type;
        if (type == catalog::ValueType::Raw)
            value = Bytes(8, 1);
        else if (type == catalog::ValueType::Text)
            value = std::string("name");
        else if (type == catalog::ValueType::F32)
            value = std::numeric_limits<double>::quiet_NaN();
        readings.push_back({id, drive::ReadStatus::Ok, value, {}});
    }
    return readings;
}

Snapshot full(const Catalog &catalog) { return snapshotOf({}, catalog, readingsOf(catalog)); }

Entry &entry(Snapshot &snapshot, const char *name, int motor = 1)
{
    return const_cast<Entry &>(*snapshot.find(name, motor));
}

std::vector<std::string> namesOf(const std::vector<Difference> &list)
{
    std::vector<std::string> names;
    for (const Difference &difference : list)
        names.push_back(difference.either().name);
    return names;
}

std::vector<std::string> namesOf(const RestorePlan &plan, const Catalog &catalog)
{
    std::vector<std::string> names;
    for (const drive::RegisterWrite &write : plan.writes)
        names.push_back(catalog.nameOf(write.id));
    return names;
}

using Names = std::vector<std::string>;

} // namespace

void TestSnapshot::readsWhatCanBeReadAndNoStub()
{
    const Catalog catalog = makeCatalog();
    const auto all = snapshotRegisters(catalog, Scope::All);
    const auto some = snapshotRegisters(catalog, Scope::Tunable);
    QVERIFY(all.size() > some.size() && some.size() > 30);
    for (const RegisterId id : all)
        QVERIFY(catalog.find(id)->readable() && !catalog.find(id)->stub);
    for (const RegisterId id : some)
        QVERIFY(catalog.find(id)->writable());
    const Catalog two = makeCatalog(2);
    QCOMPARE(snapshotRegisters(two, Scope::All).size(),
        2 * all.size()
            - static_cast<std::size_t>(std::count_if(
                all.begin(), all.end(), [&](auto id) { return !catalog.find(id)->perMotor; })));
}

void TestSnapshot::keepsDigitsAndShownValues()
{
    const Catalog catalog = makeCatalog();
    const RegisterId iq = *catalog.resolve("I_Q_REF"), gone = *catalog.resolve("SPEED_KP");
    const Snapshot snapshot = snapshotOf({}, catalog,
        {{iq, drive::ReadStatus::Ok, std::int64_t{-500}, {}},
            {gone, drive::ReadStatus::NotSupported, {}, {}},
            {0xFFF1, drive::ReadStatus::Ok, {}, {}}});
    QCOMPARE(snapshot.entries.size(), 1U);
    const Entry &entry = snapshot.entries.front();
    QVERIFY(entry.value == Value(std::int64_t{-500}));
    QCOMPARE(entry.shown.value(), -1.0);
    QCOMPARE(entry.unit, "A");
    QCOMPARE(entry.motor, 1);
    QVERIFY(!entry.tunable);
}

void TestSnapshot::notANumberIsTheSameAsItself()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(sameValue(nan, -nan));
    QVERIFY(!sameValue(nan, 0.0));
    QVERIFY(!sameValue(0.0, nan));
    QVERIFY(!sameValue(0.0, std::int64_t{0}));
    const Catalog catalog = makeCatalog();
    QVERIFY(differences(full(catalog), full(catalog), Scope::All).empty());
}

void TestSnapshot::differencesAreExactlyTheChangedOnes()
{
    const Catalog catalog = makeCatalog();
    const Snapshot a = full(catalog);
    Snapshot b = full(catalog);
    const Names changed{"SPEED_KP", "I_D_KI", "STOPLL_C2", "REVUP_DATA"};
    for (const std::string &name : changed)
        entry(b, name.c_str()).value = std::int64_t{-7};
    QVERIFY(namesOf(differences(a, b, Scope::Tunable)) == changed);
    QVERIFY(namesOf(differences(a, b, Scope::All)) == changed);
    std::reverse(b.entries.begin(), b.entries.end());
    QVERIFY(namesOf(differences(a, b, Scope::Tunable)) == changed);
}

void TestSnapshot::measuredRegistersDifferOnlyIfAsked()
{
    const Catalog catalog = makeCatalog();
    const Snapshot a = full(catalog);
    Snapshot b = full(catalog);
    entry(b, "BUS_VOLTAGE").value = std::int64_t{-7};
    QVERIFY(differences(a, b, Scope::Tunable).empty());
    QVERIFY(namesOf(differences(a, b, Scope::All)) == Names{"BUS_VOLTAGE"});
}

void TestSnapshot::whatOneSideLacksIsADifference()
{
    const Catalog catalog = makeCatalog();
    const Snapshot a = full(catalog);
    Snapshot b = full(catalog);
    b.entries.erase(std::find_if(
        b.entries.begin(), b.entries.end(), [](const Entry &e) { return e.name == "SPEED_KP"; }));
    const auto less = differences(a, b, Scope::Tunable), more = differences(b, a, Scope::Tunable);
    QVERIFY(less.size() == 1 && less[0].b == nullptr && less[0].a->name == "SPEED_KP");
    QVERIFY(more.size() == 1 && more[0].a == nullptr && more[0].b->name == "SPEED_KP");
    QVERIFY(differences({}, {}, Scope::All).empty());
}

void TestSnapshot::aSelectionTakesGroupsRegistersAndMotors()
{
    const Catalog catalog = makeCatalog(2);
    const Snapshot a = full(catalog);
    Snapshot b = full(catalog);
    for (const int motor : {1, 2})
        for (const char *name : {"SPEED_KP", "SPEED_KI", "I_Q_KP"})
            entry(b, name, motor).value = std::int64_t{-7};
    const auto count = [&](const Names &names) {
        return differences(a, b, Scope::Tunable, Selection(names)).size();
    };
    QCOMPARE(count({}), 6U);
    QCOMPARE(count({"speed LOOP"}), 4U);
    QCOMPARE(count({"Speed_Kp"}), 2U);
    QCOMPARE(count({"SPEED_KP@2"}), 1U);
    QCOMPARE(count({"SPEED_KP@2", "Current loop"}), 3U);
    QVERIFY(Selection({"speed loop", "Nonsense"}).unmatched(a) == Names{"Nonsense"});
}

void TestSnapshot::aRestoreWritesOnlyWhatDiffersGainsFirst()
{
    const Catalog catalog = makeCatalog();
    Snapshot wanted = full(catalog);
    const Snapshot now = full(catalog);
    QVERIFY(planRestore(wanted, now, catalog).writes.empty());
    for (const char *name : {"CONTROL_MODE", "SPEED_REF", "FF_1Q", "QUASI_SYNCH", "SPEED_KP",
             "I_Q_KP", "STOPLL_KP_DIV"})
        entry(wanted, name).value = std::int64_t{77};
    entry(wanted, "REVUP_DATA").value = Bytes(40, 2);
    entry(wanted, "BUS_VOLTAGE").value = std::int64_t{77}; // measured
    const RestorePlan plan = planRestore(wanted, now, catalog);
    QCOMPARE(plan.left.size(), 2U);
    for (const auto &[name, why] : plan.left)
        QVERIFY((name == "SPEED_REF" || name == "CONTROL_MODE") && why == NotRestored::Moves);
    QVERIFY((namesOf(plan, catalog)
        == Names{"SPEED_KP", "I_Q_KP", "STOPLL_KP_DIV", "FF_1Q", "QUASI_SYNCH", "REVUP_DATA"}));
    QVERIFY((namesOf(planRestore(wanted, now, catalog, Selection({"Speed loop"})), catalog)
        == Names{"SPEED_KP"}));
}

void TestSnapshot::aRestoreLeavesWhatItMustNotWrite()
{
    const Catalog catalog = makeCatalog();
    Snapshot wanted = full(catalog), now = full(catalog);
    for (const char *name : {"SPEED_KP", "SPEED_KI", "SPEED_REF"})
        entry(wanted, name).value = std::int64_t{77};
    entry(wanted, "SC_PP").value = std::int64_t{77};
    entry(wanted, "SPEED_KI").type = catalog::ValueType::U8;
    std::erase_if(now.entries, [](const Entry &e) { return e.name == "SPEED_KP"; });
    std::erase_if(wanted.entries, [](const Entry &e) { return e.name == "I_D_KP"; });
    const RestorePlan plan = planRestore(wanted, now, catalog, {}, {1});
    QVERIFY(plan.writes.empty());
    std::map<std::string, NotRestored> left;
    for (const auto &[name, why] : plan.left)
        left[name] = why;
    QCOMPARE(left.size(), 4U);
    QVERIFY(left.at("SPEED_KP") == NotRestored::NotOnBoard);
    QVERIFY(left.at("SPEED_KI") == NotRestored::OtherType);
    QVERIFY(left.at("SPEED_REF") == NotRestored::Moves);
    QVERIFY(left.at("SC_PP") == NotRestored::MotorMoves);
    QVERIFY((namesOf(planRestore(wanted, now, catalog, {}, {2}), catalog) == Names{"SC_PP"}));
}

void TestSnapshot::whatMovesAMotorIsNotTunableWhateverTheFileSays()
{
    const Catalog catalog = makeCatalog();
    const Snapshot now = full(catalog);
    Snapshot wanted = full(catalog); // as programs wrote them that took these for tunable
    const std::vector<const char *> acting{"CONTROL_MODE", "SPEED_REF", "I_Q_REF", "I_D_REF",
        "SPEED_RAMP", "TORQUE_RAMP", "CURRENT_REF", "POSITION_RAMP", "FOC_VQREF", "OPENLOOP",
        "OPENLOOP_DC"};
    for (const char *name : acting) {
        QVERIFY2(!entry(wanted, name).tunable, name);
        entry(wanted, name).tunable = true;
        const bool raw = entry(wanted, name).type == catalog::ValueType::Raw;
        entry(wanted, name).value = raw ? Value(Bytes(6, 7)) : Value(std::int64_t{1234});
    }
    const RestorePlan plan = planRestore(wanted, now, catalog);
    QVERIFY(plan.writes.empty());
    QCOMPARE(plan.left.size(), acting.size());
    for (const auto &[name, why] : plan.left)
        QVERIFY2(why == NotRestored::Moves, name.c_str());
}

void TestSnapshot::otherHardwareIsNamed()
{
    drive::Identity a;
    a.controlBoard = "G4";
    a.powerBoards = {"24V"};
    a.motorNames = {"Fan"};
    drive::Identity b = a;
    b.version = "6.2.0"; // firmware may differ
    QVERIFY(otherHardware(a, b).empty());
    b.motorNames = {"Pump"};
    QVERIFY(otherHardware(a, b) == Names{"Fan"});
    b.powerBoards.clear();
    QVERIFY((otherHardware(a, b) == Names{"24V", "Fan"}));
}

QTEST_APPLESS_MAIN(TestSnapshot)
#include "tst_snapshot.moc"
