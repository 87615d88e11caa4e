// Snapshots as files: the same values give the same bytes, what is read is what was written, and nonsense is refused.
#include "session/files/snapshot_json.h"
#include "session/files/whole_file.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <limits>

using snapshots::Entry;

class TestSnapshotJson : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsWrittenIsReadAgain();
    void theSameValuesGiveTheSameBytes();
    void oneRegisterIsOneLine();
    void nonsenseIsRefused_data();
    void nonsenseIsRefused();
    void theErrorNamesThePlace();
    void brokenBytesNeverCrashTheReader();
    void aFileIsReplacedWholeOrNotAtAll();
};

namespace {

using catalog::ValueType;

Entry entry(const char *name, ValueType type, catalog::Value value)
{
    Entry made;
    made.name = name;
    made.motor = 1;
    made.id = 0x0091;
    made.group = "Speed loop";
    made.type = type;
    made.tunable = true;
    if (const auto *whole = std::get_if<std::int64_t>(&value))
        made.shown = 0.1 * static_cast<double>(*whole);
    else if (const auto *number = std::get_if<double>(&value))
        made.shown = *number;
    made.value = std::move(value);
    made.unit = "°C";
    return made;
}

snapshots::Snapshot sample()
{
    snapshots::Snapshot snapshot;
    snapshot.board.firmware = "ST MC SDK\t\"6.4\"";
    snapshot.board.version = "6.4.0";
    snapshot.board.controlBoard = "G4";
    snapshot.board.powerBoards = {"24V"};
    snapshot.board.motorNames = {"Fan \xC3\xA4"};
    const double infinite = std::numeric_limits<double>::infinity();
    snapshot.entries = {entry("BYTE", ValueType::U8, std::int64_t{255}),
        entry("WORD", ValueType::S16, std::int64_t{-32768}),
        entry("LONG", ValueType::U32, std::int64_t{4294967295}),
        entry("THIRD", ValueType::F32, static_cast<double>(1.0F / 3.0F)),
        entry("NAN", ValueType::F32, std::nan("")), entry("INF", ValueType::F32, -infinite),
        entry("TEXT", ValueType::Text, std::string("a \"b\"\n\x01")),
        entry("LATIN", ValueType::Text, std::string("\xE4\xF6")),
        entry("BYTES", ValueType::Raw, Bytes{0x00, 0xFF, 0x7F}),
        entry("EMPTY", ValueType::Raw, Bytes{})};
    snapshot.entries[7].id = 0x0229;
    return snapshot;
}

} // namespace

void TestSnapshotJson::whatIsWrittenIsReadAgain()
{
    const snapshots::Snapshot snapshot = sample();
    const auto read = session::readSnapshotJson(session::snapshotJson(snapshot));
    QVERIFY(read.has_value());
    QCOMPARE(read->board.firmware, snapshot.board.firmware);
    QVERIFY(read->board.powerBoards == snapshot.board.powerBoards);
    QVERIFY(read->board.motorNames == snapshot.board.motorNames);
    QCOMPARE(read->entries.size(), snapshot.entries.size());
    for (std::size_t i = 0; i < read->entries.size(); ++i) {
        const Entry &is = read->entries[i], &was = snapshot.entries[i];
        QVERIFY(is.isSame(was) && is.id == was.id && is.group == was.group && is.type == was.type);
        QVERIFY2(snapshots::sameValue(is.value, was.value), was.name.c_str());
        QVERIFY(is.tunable);
        QCOMPARE(is.shown.has_value(), was.shown.has_value());
        if (was.shown && std::isfinite(*was.shown)) {
            QCOMPARE(*is.shown, *was.shown);
            QCOMPARE(is.unit, was.unit);
        }
    }
    QVERIFY(snapshots::differences(*read, snapshot, snapshots::Scope::All).empty());
}

void TestSnapshotJson::theSameValuesGiveTheSameBytes()
{
    const QByteArray text = session::snapshotJson(sample());
    QCOMPARE(session::snapshotJson(sample()), text);
    QCOMPARE(session::snapshotJson(*session::readSnapshotJson(text)), text);
    QVERIFY(!text.toLower().contains("nan,") && !text.toLower().contains(":inf"));
}

void TestSnapshotJson::oneRegisterIsOneLine()
{
    const QByteArray text = session::snapshotJson(sample());
    QCOMPARE(text.count('\n'), static_cast<qsizetype>(sample().entries.size()) + 4);
    QVERIFY(text.endsWith("\n]}\n"));
    QVERIFY(session::readSnapshotJson(session::snapshotJson({}))->entries.empty());
}

void TestSnapshotJson::nonsenseIsRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("problem");
    using Problem = session::SnapshotProblem;
    const auto file = [](const char *name, Problem problem, const QByteArray &oneRegister) {
        QTest::newRow(name) << "{\"format\":\"rotorscope-snapshot\",\"version\":1,\"registers\":["
                + oneRegister
                + "]}" << int(problem);
    };
    const auto changed = [&](const char *name, Problem problem, const char *from, const char *to) {
        QByteArray text =
            R"({"name":"A","motor":1,"id":"0x0091","type":"s16","tunable":true,"raw":5})";
        text.replace(from, to);
        file(name, problem, text);
    };
    QTest::newRow("nothing") << QByteArray() << int(Problem::NotJson);
    QTest::newRow("no JSON") << QByteArray("{\"format\"") << int(Problem::NotJson);
    QTest::newRow("a list") << QByteArray("[]") << int(Problem::NotASnapshot);
    QTest::newRow("something else")
        << QByteArray("{\"format\":\"x\"}") << int(Problem::NotASnapshot);
    QTest::newRow("newer") << QByteArray(R"({"format":"rotorscope-snapshot","version":2})")
                           << int(Problem::NewerVersion);
    QTest::newRow("no registers") << QByteArray(R"({"format":"rotorscope-snapshot","version":1})")
                                  << int(Problem::NoRegisters);
    QTest::newRow("deep") << QByteArray(100'000, '[') << int(Problem::NotJson);
    file("no object", Problem::NoName, "5");
    changed("no name", Problem::NoName, "\"A\"", "\"\"");
    changed("motor 8", Problem::NoMotor, "\"motor\":1", "\"motor\":8");
    changed("no id", Problem::NoId, "0x0091", "0xZZ");
    changed("another type", Problem::NoType, "s16", "s17");
    changed("too large", Problem::NumberDoesNotFit, ":5}", ":32768}");
    changed("half", Problem::NumberDoesNotFit, ":5}", ":0.5}");
    changed("a text for a number", Problem::NumberDoesNotFit, ":5}", ":\"5\"}");
    changed("a number for bytes", Problem::NoText, "s16", "raw");
    changed("half a byte", Problem::NotBytes, R"(s16","tunable":true,"raw":5)",
        R"(raw","tunable":true,"raw":"123")");
    changed(
        "a float without a number", Problem::NoNumber, "s16\",\"tunable\":true,\"raw\":5", "f32\"");
    file("twice", Problem::Twice,
        R"({"name":"A","motor":1,"id":"0x91","type":"s16","raw":5},)"
        R"({"name":"A","motor":1,"id":"0x91","type":"s16","raw":6})");
}

void TestSnapshotJson::nonsenseIsRefused()
{
    QFETCH(QByteArray, text);
    QFETCH(int, problem);
    const auto read = session::readSnapshotJson(text);
    QVERIFY(!read.has_value());
    QCOMPARE(int(read.error().problem), problem);
    QCOMPARE(read.error().number > 0, problem >= int(session::SnapshotProblem::NoName));
}

void TestSnapshotJson::theErrorNamesThePlace()
{
    const QByteArray good = session::snapshotJson(sample());
    const auto lines = good.split('\n');
    // The registers begin in line 4, one a line; each in turn loses its id.
    for (qsizetype at = 3; at + 2 < lines.size(); ++at) {
        auto broken = lines;
        broken[at].replace("\"id\":\"0x", "\"id\":\"{[");
        const auto read = session::readSnapshotJson(broken.join('\n'));
        QVERIFY(!read.has_value());
        QVERIFY(read.error().problem == session::SnapshotProblem::NoId);
        QCOMPARE(read.error().line, int(at + 1));
        QCOMPARE(read.error().number, int(at - 2));
        QVERIFY(lines[at].contains(read.error().name.toUtf8()));
    }
    auto cut = lines;
    cut[5].chop(4);
    const auto read = session::readSnapshotJson(cut.join('\n'));
    QVERIFY(!read.has_value());
    QVERIFY(read.error().problem == session::SnapshotProblem::NotJson);
    QCOMPARE(read.error().line, 7); // what is missing in line 6 is noticed in the next
}

void TestSnapshotJson::brokenBytesNeverCrashTheReader()
{
    const QByteArray text = session::snapshotJson(sample());
    quint32 random = 1;
    int accepted = 0;
    for (int round = 0; round < 3000; ++round) {
        QByteArray broken = text;
        for (int flips = 0; flips < 3; ++flips) {
            random = random * 1664525U + 1013904223U;
            broken[static_cast<qsizetype>((random >> 8) % static_cast<quint32>(text.size()))] =
                static_cast<char>(random >> 24);
        }
        if (const auto read = session::readSnapshotJson(broken)) {
            ++accepted;
            for (const Entry &one : read->entries)
                QVERIFY(!one.name.empty());
        }
    }
    QVERIFY(accepted < 3000);
}

void TestSnapshotJson::aFileIsReplacedWholeOrNotAtAll()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("s.json"));
    QCOMPARE(session::writeWholeFile(path, "old"), QString());
    QCOMPARE(session::writeWholeFile(path, "new"), QString());
    QCOMPARE(*session::readWholeFile(path), QByteArray("new"));
    QVERIFY(!session::writeWholeFile(folder.path(), "x").isEmpty());
    QVERIFY(
        !session::writeWholeFile(folder.filePath(QStringLiteral("no/such.json")), "x").isEmpty());
    QVERIFY(!session::writeWholeFile(QStringLiteral("/dev/null"), "x").isEmpty());
    QVERIFY(!session::readWholeFile(path, 2).has_value());
    QVERIFY(!session::readWholeFile(folder.path()).has_value());
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
}

QTEST_GUILESS_MAIN(TestSnapshotJson)
#include "tst_snapshot_json.moc"
