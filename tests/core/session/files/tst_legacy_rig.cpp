// Static boards of the older serial protocol, made from rig files: every vector byte for byte on virtual time, and
// files with flaws.
#include "session/files/fcp_rig_file.h"
#include "simulation/fcp/board.h"
#include "support/fcp_vectors.h"
#include "support/places.h"

#include <QJsonArray>
#include <QTest>

using support::FcpConversation;
using support::FcpVector;

class TestFcpRig : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theBoardAnswersEveryVector_data();
    void theBoardAnswersEveryVector();
    void aRigWithAFlawIsOneSentence_data();
    void aRigWithAFlawIsOneSentence();
    void theTimerOfARigIsTaken();
};

namespace {

constexpr Duration kPatience = std::chrono::milliseconds(100);

QString rigPath(const QString &name)
{
    return support::dataFile(QStringLiteral("rigs/legacy-")) + name + QStringLiteral(".json");
}

void tell(simulation::FcpBoard &board, const QString &event)
{
    const QString word = event.section(u'=', 0, 0);
    const QString argument = event.section(u'=', 1);
    if (word == QLatin1String("state"))
        board.setState(static_cast<std::uint8_t>(argument.toUInt()));
    else if (word == QLatin1String("faults"))
        board.setFlags(argument.toUInt(nullptr, 16));
    else if (word == QLatin1String("execute_buffered"))
        board.executeBuffered();
    else if (word == QLatin1String("rx_timeout"))
        board.expireFrame();
    else if (word == QLatin1String("rx_overrun"))
        board.overrun();
    else
        QVERIFY2(word.isEmpty(), qPrintable(word));
}

QByteArray rigText(const char *key, const QJsonValue &value)
{
    QFile file(rigPath(QStringLiteral("A")));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QJsonObject rig = QJsonDocument::fromJson(file.readAll()).object();
    if (QLatin1String(key).startsWith(QLatin1String("motor."))) {
        QJsonArray motors = rig[QLatin1String("motors")].toArray();
        QJsonObject motor = motors[0].toObject();
        motor[QString::fromLatin1(key).mid(6)] = value;
        motors[0] = motor;
        rig[QLatin1String("motors")] = motors;
    } else {
        rig[QLatin1String(key)] = value;
    }
    return QJsonDocument(rig).toJson();
}

} // namespace

void TestFcpRig::theBoardAnswersEveryVector_data()
{
    QTest::addColumn<int>("index");
    const auto all = support::readFcpVectors();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].front().exchange)
            QTest::addRow("%s", qPrintable(all[i].front().name)) << int(i);
    }
}

void TestFcpRig::theBoardAnswersEveryVector()
{
    QFETCH(int, index);
    const FcpConversation rows = support::readFcpVectors()[std::size_t(index)];
    const auto rig = session::readFcpRigFile(rigPath(rows.front().rig));
    QVERIFY2(rig, rig ? "" : rig.error().c_str());
    simulation::FcpBoard board(*rig);
    TimePoint now{};
    for (const FcpVector &row : rows) {
        tell(board, row.event);
        board.receive(row.request, now);
        now += kPatience;
        board.advance(now);
        const Bytes got = board.takeOutput();
        board.advance(now += kPatience);
        QVERIFY2(board.takeOutput().empty(), qPrintable(row.name));
        QVERIFY2(got == row.reply, qPrintable(row.name));
    }
}

void TestFcpRig::aRigWithAFlawIsOneSentence_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("names");
    const auto row = [](const char *key, const QJsonValue &value, const char *names) {
        QTest::addRow("%s %d", key, int(value.type()))
            << rigText(key, value) << QString::fromLatin1(names);
    };
    QTest::newRow("no JSON") << QByteArray("{") << QStringLiteral("JSON");
    QTest::newRow("empty") << QByteArray("{}") << QStringLiteral("protocol");
    row("protocol", QStringLiteral("mcb"), "protocol");
    row("dialect", QStringLiteral("latin"), "dialect");
    row("dialect", 3, "dialect");
    row("motors", QJsonArray(), "motors");
    row("speed_step", 0, "speed_step");
    row("frame_timer", QStringLiteral("slow"), "frame_timer");
    row("frame_timer", 0, "frame_timer");
    row("firmware_string", 5, "firmware_string");
    row("features", QJsonObject{{QStringLiteral("pfc"), 1}}, "pfc");
    row("motor.state", 256, "state");
    row("motor.state", 1.5, "state");
    row("motor.sensing", QStringLiteral("smell"), "sensing");
    row("motor.registers", QJsonObject{{QStringLiteral("0x100"), 1}}, "0x100");
    row("motor.registers", QJsonObject{{QStringLiteral("SPEED"), 1}}, "SPEED");
    row("motor.registers", QJsonObject{{QStringLiteral("0x05"), 1e12}}, "0x05");
    row("motor.revup", QJsonArray{QJsonArray{1, 2}}, "revup");
    row("motor.revup", QJsonArray{QJsonArray{1, 40000, 3}}, "revup torque");
    row("motor.revup", QJsonArray{1, 2, 3, 4, 5, 6}, "revup");
}

void TestFcpRig::aRigWithAFlawIsOneSentence()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, names);
    const auto rig = session::readFcpRig(text);
    QVERIFY(!rig);
    const QString sentence = QString::fromStdString(rig.error());
    QVERIFY2(sentence.contains(names), qPrintable(sentence));
    QCOMPARE(sentence.count(u'\n'), 0);
}

void TestFcpRig::theTimerOfARigIsTaken()
{
    QVERIFY(!session::readFcpRig(rigText("frame_timer", QStringLiteral("dead")))->frameTimer);
    QVERIFY(session::readFcpRig(rigText("frame_timer", 25))->frameTimer
        == Duration(std::chrono::milliseconds(25)));
    QVERIFY(!session::readFcpRigFile(QStringLiteral("/nowhere/rig.json")));
}

QTEST_GUILESS_MAIN(TestFcpRig)
#include "tst_legacy_rig.moc"
