// Pole pairs from what a board without an encoder tells of a speed, and what a tachometer reads.
#include "lab/pole_pairs.h"

#include <QtTest>

using drive::MotorState;

namespace {

drive::Identified boardThatBelieves(double polePairs, const char *speed)
{
    drive::Identified board;
    board.limits.resize(1);
    board.limits[0].polePairs = polePairs;
    board.identity.speedSignals = {speed};
    return board;
}

drive::MotorStatus turning(double rpm, MotorState state = MotorState::Running)
{
    drive::MotorStatus status;
    status.state = state;
    status.speedRpm = rpm;
    return status;
}

} // namespace

class TestPolePairs : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theyAreCounted_data();
    void theyAreCounted();
    void whatDoesNotTellThemIsRefused_data();
    void whatDoesNotTellThemIsRefused();
};

/// A rotor of `truth` pole pairs is told as slower or faster by a board that believes in others.
void TestPolePairs::theyAreCounted_data()
{
    QTest::addColumn<int>("truth");
    QTest::addColumn<double>("believed");
    QTest::addColumn<double>("off"); // of the tachometer
    QTest::newRow("as believed") << 7 << 7.0 << 1.0;
    QTest::newRow("one more") << 8 << 7.0 << 1.01;
    QTest::newRow("one less") << 1 << 2.0 << 0.99;
    QTest::newRow("many") << 21 << 7.0 << 1.005;
}

void TestPolePairs::theyAreCounted()
{
    QFETCH(const int, truth);
    QFETCH(const double, believed);
    QFETCH(const double, off);
    constexpr double kShaft_rpm = 1490.0;
    for (const double way : {1.0, -1.0}) {
        const auto found = lab::polePairsBy(boardThatBelieves(believed, "STOPLL_SPEED"),
            turning(way * kShaft_rpm * truth / believed), kShaft_rpm * off);
        QVERIFY2(found, found ? "" : found.error().c_str());
        QCOMPARE(found->count, truth);
        QVERIFY(std::abs(found->measured - truth) < 0.2);
    }
}

void TestPolePairs::whatDoesNotTellThemIsRefused_data()
{
    QTest::addColumn<QString>("speed");
    QTest::addColumn<double>("believed");
    QTest::addColumn<double>("told");
    QTest::addColumn<bool>("runs");
    QTest::addColumn<double>("shaft");
    QTest::addColumn<QString>("why");
    const QString observer = QStringLiteral("STOPLL_SPEED");
    QTest::newRow("between two") << observer << 4.0 << 1500.0 << true << 1380.0
                                 << "make 4.35, which is no whole number";
    QTest::newRow("none") << observer << 4.0 << 1500.0 << true << 60000.0 << "no whole number";
    QTest::newRow("no shaft turns so")
        << observer << 4.0 << 1500.0 << true << 0.0 << "no whole number";
    QTest::newRow("at rest") << observer << 4.0 << 1500.0 << false << 1500.0 << "does not turn";
    QTest::newRow("at 0") << observer << 4.0 << 0.0 << true << 1500.0 << "does not turn";
    QTest::newRow("an encoder") << QStringLiteral("ENCODER_SPEED") << 4.0 << 1500.0 << true
                                << 1500.0 << "say nothing of pole pairs";
    QTest::newRow("not told") << observer << 0.0 << 1500.0 << true << 1500.0
                              << "does not tell which pole pairs";
}

void TestPolePairs::whatDoesNotTellThemIsRefused()
{
    QFETCH(const QString, speed);
    QFETCH(const double, believed);
    QFETCH(const double, told);
    QFETCH(const bool, runs);
    QFETCH(const double, shaft);
    QFETCH(const QString, why);
    const auto found = lab::polePairsBy(boardThatBelieves(believed, speed.toUtf8().constData()),
        turning(told, runs ? MotorState::Running : MotorState::Idle), shaft);
    QVERIFY(!found);
    QVERIFY2(found.error().find(why.toStdString()) != std::string::npos, found.error().c_str());
}

QTEST_APPLESS_MAIN(TestPolePairs)
#include "tst_pole_pairs.moc"
