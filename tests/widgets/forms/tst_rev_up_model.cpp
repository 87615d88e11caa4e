// The stages of a rev-up as a table: the same thing as the register's bytes, whatever is done to either.
#include "support/rev_up_bench.h"

#include <QAbstractItemModelTester>

#include <random>

using facts::RevUpBench;
using motor::RevUp;
using motor::RevUpStage;
using widgets::RegisterModel;
using Column = widgets::RevUpModel::Column;

namespace {

simulation::BoardOptions withSensor(const char *motor)
{
    simulation::BoardOptions options;
    options.motor = motor;
    return options;
}

bool withinBounds(const RevUp &stages, const motor::RevUpBounds &bounds)
{
    return std::all_of(stages.begin(), stages.end(), [&](const RevUpStage &stage) {
        return std::abs(stage.speed_rpm) <= bounds.speed_rpm
            && std::abs(int{stage.current_digits}) <= bounds.digits
            && (!bounds.pulse || stage.current_digits >= 0);
    });
}

} // namespace

class TestRevUpModel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void isAModelThroughEverythingThatHappens()
    {
        RevUpBench rig;
        const QAbstractItemModelTester tester(&rig.model);
        QCOMPARE(rig.model.rowCount(), 5);
        QVERIFY(rig.type(1, Column::SpeedColumn, QStringLiteral("120 rpm")));
        QVERIFY(rig.model.addAfter(0));
        QVERIFY(rig.model.move(0, 1));
        QVERIFY(rig.model.remove(0));
        rig.bench.arm();
        QVERIFY(rig.bench.apply());
        rig.bench.model.refresh(rig.bench.ms() + std::chrono::seconds(9)); // the flash ends
        rig.bench.model.setCatalog(rig.bench.device.catalog(), 1);
        QCOMPARE(rig.model.rowCount(), 0); // another board, nothing read
        rig.readWatched();
        QCOMPARE(rig.model.rowCount(), 5);
        rig.bench.model.setCatalog(nullptr, 1);
        QCOMPARE(rig.model.rowCount(), 0);
        QVERIFY(!rig.model.unavailable().isEmpty());
        QVERIFY(!rig.model.setStages(RevUp(5)));
    }

    void showsWhatTheBoardHoldsWithUnits()
    {
        RevUpBench rig;
        const RevUp board = motor::revUpOfBytes(rig.heldBytes()).value();
        QVERIFY(rig.stages() == board);
        QCOMPARE(rig.model.used(), 4);
        QVERIFY(rig.model.unavailable().isEmpty());
        for (int column = 0; column < rig.model.columnCount(); ++column) {
            const QString said =
                rig.model.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString();
            const QString units[] = {QStringLiteral("ms"), QStringLiteral("rpm"),
                QStringLiteral("A"), QStringLiteral("digits"), QStringLiteral("mN\u00b7m")};
            QVERIFY2(said.contains(units[column]), qPrintable(said));
        }
        QCOMPARE(rig.model.index(2, Column::SpeedColumn).data().toString(), QStringLiteral("1200"));
        QCOMPARE(
            rig.model.index(2, Column::CurrentColumn).data().toString(), QStringLiteral("2.499"));
        QCOMPARE(
            rig.model.index(2, Column::DigitsColumn).data().toString(), QStringLiteral("1361"));
    }

    void tableToBytesToTableIsIdentity()
    {
        RevUpBench rig;
        std::mt19937 random(11);
        const auto bounds = rig.model.bounds();
        for (int round = 0; round < 300; ++round) {
            RevUp wanted(5);
            for (RevUpStage &stage : wanted)
                stage = {6 * (static_cast<int>(random() % 1333) - 666),
                    static_cast<std::int16_t>(
                        static_cast<int>(random() % (2U * unsigned(bounds.digits) + 1U))
                        - bounds.digits),
                    static_cast<std::uint16_t>(1 + random() % 65535)};
            // As bytes into the register ...
            QVERIFY(rig.bench.model.setPending(rig.bench.id("REVUP_DATA"), motor::bytesOf(wanted)));
            QVERIFY(rig.stages() == wanted);
            QList<QStringList> texts;
            for (int row = 0; row < 5; ++row) {
                const auto text = [&](int column) {
                    return rig.model.index(row, column).data(Qt::EditRole).toString();
                };
                // ... the current by turns in amperes and in digits ...
                texts.append({text(Column::DurationColumn), text(Column::SpeedColumn),
                    text(round % 2 == 0 ? Column::CurrentColumn : Column::DigitsColumn)});
            }
            // ... and as typed text back from something else.
            QVERIFY(rig.setAll(RevUp(5, {600, 5, 77})));
            for (int row = 0; row < 5; ++row) {
                QVERIFY(rig.type(row, Column::DurationColumn, texts[row][0]));
                QVERIFY(rig.type(row, Column::SpeedColumn, texts[row][1]));
                QVERIFY2(
                    rig.type(row, round % 2 == 0 ? Column::CurrentColumn : Column::DigitsColumn,
                        texts[row][2]),
                    qPrintable(texts[row][2]));
            }
            QVERIFY(rig.wantedBytes() == motor::bytesOf(wanted));
        }
    }

    void noTypedTextLeavesTheLimits_data()
    {
        QTest::addColumn<QString>("locale");
        for (const char *name : {"C", "de_DE", "tr_TR"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void noTypedTextLeavesTheLimits()
    {
        QFETCH(QString, locale);
        const QLocale before;
        QLocale::setDefault(QLocale(locale));
        RevUpBench rig;
        std::mt19937 random(5);
        const QString letters =
            QStringLiteral("0123456789.,-+eExX nanif rpmAs\u2212\u0661%'\u00a0");
        const auto bounds = rig.model.bounds();
        QCOMPARE(bounds.speed_rpm, 4000 / 6 * 6);
        int taken = 0;
        for (int round = 0; round < 10000; ++round) {
            QString text;
            const auto length = random() % 9;
            for (unsigned i = 0; i < length; ++i)
                text.append(
                    letters[random() % (random() % 2 == 0 ? 10U : unsigned(letters.size()))]);
            const RevUp old = rig.stages();
            const bool done = rig.type(int(random() % 5), int(random() % 5), text);
            taken += done ? 1 : 0;
            QVERIFY2(withinBounds(rig.stages(), bounds), qPrintable(text));
            QVERIFY2(done || rig.stages() == old, qPrintable(text));
        }
        QVERIFY(taken > 500);
        for (const char *bad :
            {"", "1.234,5", "1e3", "nan", "inf", "1000 A", "99999", "-1", "1 000"})
            QVERIFY2(!rig.type(0, Column::DurationColumn, QString::fromLatin1(bad)), bad);
        QVERIFY(rig.type(0, Column::CurrentColumn, QStringLiteral("2,5")));
        const auto digits = rig.stages()[0].current_digits;
        QVERIFY(rig.type(0, Column::CurrentColumn, QStringLiteral("2.5 A")));
        QCOMPARE(rig.stages()[0].current_digits, digits);
        QLocale::setDefault(before);
    }

    void speedsThatDrivesCannotHoldAreSaid()
    {
        RevUpBench rig;
        QStringList said;
        connect(&rig.model, &widgets::RevUpModel::adjusted, &rig.form,
            [&said](const QString &sentence) { said.append(sentence); });
        QVERIFY(rig.type(2, Column::SpeedColumn, QStringLiteral("1000")));
        QCOMPARE(rig.stages()[2].speed_rpm, 1002);
        QCOMPARE(said.size(), 1);
        QVERIFY(said[0].contains(QStringLiteral("1002")));
        QVERIFY2(said[0].endsWith(QStringLiteral("steps of 6\u202frpm.")), qPrintable(said[0]));
        QVERIFY(rig.type(2, Column::SpeedColumn, QStringLiteral("1200")));
        QVERIFY(rig.type(2, Column::DurationColumn, QStringLiteral("1001")));
        QCOMPARE(said.size(), 1);
        QVERIFY(!rig.type(2, Column::SpeedColumn, QStringLiteral("4002")));
    }

    void theStepOfASpeedIsTheOneThatTheDriveTells()
    {
        RevUpBench rig;
        drive::Identified board = *rig.bench.link.identified;
        board.limits.front().speedStepRpm = 10.0;
        facts::feed(rig.bench.device, {board});
        rig.readWatched();
        QStringList said;
        connect(&rig.model, &widgets::RevUpModel::adjusted, &rig.form,
            [&said](const QString &sentence) { said.append(sentence); });
        QVERIFY(rig.type(2, Column::SpeedColumn, QStringLiteral("1003")));
        QCOMPARE(rig.stages()[2].speed_rpm, 1000);
        QCOMPARE(said.size(), 1);
        QVERIFY2(said[0].endsWith(QStringLiteral("steps of 10\u202frpm.")), qPrintable(said[0]));
    }

    void aPersonsOwnLimitsBoundItToo()
    {
        RevUpBench rig;
        rig.bench.device.setUserLimits({1500.0, 2.0});
        const auto bounds = rig.model.bounds();
        QCOMPARE(bounds.speed_rpm, 1500);
        QVERIFY(bounds.digits * rig.model.shownPerDigit() <= 2.0);
        QVERIFY(!rig.model.findings().empty()); // the board's own stages take 2.5 A
        QVERIFY(!rig.type(2, Column::SpeedColumn, QStringLiteral("1506")));
        QVERIFY(!rig.type(2, Column::CurrentColumn, QStringLiteral("2.1")));
        rig.form.findChild<QPushButton *>(QStringLiteral("revUpUsual"))->click();
        QCOMPARE(rig.stages()[1].speed_rpm, 1200); // still 30 % of what the motor can
        QVERIFY(withinBounds(rig.stages(), bounds));
        rig.bench.device.setUserLimits({900.0, 0.0});
        rig.form.findChild<QPushButton *>(QStringLiteral("revUpUsual"))->click();
        QCOMPARE(rig.stages()[1].speed_rpm, 900);
        QCOMPARE(rig.stages()[1].current_digits, 1361);
    }

    void editsAreAmberThenGreenAndOnlyWhereTheyAre()
    {
        RevUpBench rig;
        const auto back = [&](int row, int column) {
            return rig.model.index(row, column).data(Qt::BackgroundRole).value<QColor>();
        };
        QVERIFY(rig.type(0, Column::DurationColumn, QStringLiteral("70")));
        const QColor amber = back(0, Column::DurationColumn);
        QVERIFY(amber.isValid());
        QVERIFY(!back(0, Column::SpeedColumn).isValid());
        QVERIFY(!back(1, Column::DurationColumn).isValid());
        QVERIFY(rig.bench.writes.empty());
        rig.bench.arm();
        QVERIFY(rig.bench.apply());
        QCOMPARE(rig.bench.writes.size(), 1U);
        QVERIFY(rig.heldBytes() == rig.wantedBytes());
        QVERIFY(back(0, Column::DurationColumn).isValid());
        QVERIFY(back(0, Column::DurationColumn) != amber);
        QVERIFY(!back(1, Column::DurationColumn).isValid());
        rig.bench.edits.undo();
        QVERIFY(rig.bench.settle());
        QCOMPARE(rig.stages()[0].duration_ms, 60);
    }

    void aSixStepBoardHasAPulseInPlaceOfTheCurrent()
    {
        simulation::BoardOptions options;
        options.profile = "six-step";
        RevUpBench rig(options);
        QVERIFY(rig.model.unavailable().isEmpty());
        QVERIFY(rig.model.facts().sixStep);
        QVERIFY(rig.model.headerData(Column::DigitsColumn, Qt::Horizontal)
                    .toString()
                    .contains(QStringLiteral("Pulse")));
        QVERIFY(!rig.model.flags(rig.model.index(0, Column::CurrentColumn))
                     .testFlag(Qt::ItemIsEditable));
        QVERIFY(!rig.type(0, Column::CurrentColumn, QStringLiteral("1")));
        QVERIFY(!rig.type(0, Column::DigitsColumn, QStringLiteral("-1")));
        QVERIFY(rig.type(0, Column::DigitsColumn, QStringLiteral("1200")));
        QCOMPARE(rig.stages()[0].current_digits, 1200);
        QVERIFY(rig.table->isColumnHidden(Column::CurrentColumn));
        QVERIFY(rig.table->isColumnHidden(Column::TorqueColumn));
        QVERIFY(!rig.form.findChild<QPushButton *>(QStringLiteral("revUpUsual"))->isEnabled());
        for (const auto &finding : rig.model.findings()) {
            QVERIFY(finding.mistake != motor::RevUpMistake::TooMuchCurrent);
            QVERIFY(finding.mistake != motor::RevUpMistake::TooLittleTorque);
        }
    }

    void boardsWithoutARevUpSayWhy()
    {
        simulation::BoardOptions hso;
        hso.profile = "hso";
        for (const auto &options : {withSensor("servo24"), withSensor("blower36"), hso}) {
            RevUpBench rig(options);
            QVERIFY2(rig.model.rowCount() == 0,
                qPrintable(QString::fromStdString(options.motor + options.profile)));
            QVERIFY(!rig.model.unavailable().isEmpty());
            const auto *reason = rig.form.findChild<QLabel *>(QStringLiteral("revUpReason"));
            QCOMPARE(reason->text(), rig.model.unavailable());
            QVERIFY(!reason->isHidden());
            QVERIFY(!rig.table->isEnabled());
            QVERIFY(rig.form.findChild<QLabel *>(QStringLiteral("revUpLastStart"))->isHidden());
            QVERIFY(!rig.chart.isEnabled());
            for (const auto *button :
                rig.form.findChildren<QPushButton *>(QRegularExpression(QStringLiteral("^revUp"))))
                QVERIFY2(!button->isEnabled(), qPrintable(button->objectName()));
        }
    }

    void ofTwoMotorsItIsTheOneThatIsShown()
    {
        simulation::BoardOptions options;
        options.motors = 2;
        RevUpBench rig(options);
        QVERIFY(rig.model.unavailable().isEmpty());
        const auto *title = rig.form.findChild<QLabel *>(QStringLiteral("revUpReason"));
        QVERIFY(title->text().contains(QLatin1Char('1')));
        const auto first = *rig.model.registerId();
        rig.bench.device.setMotor(2);
        rig.bench.model.setCatalog(rig.bench.device.catalog(), 2);
        rig.readWatched();
        QVERIFY(*rig.model.registerId() != first);
        QVERIFY(title->text().contains(QLatin1Char('2')));
        QVERIFY(rig.type(0, Column::DurationColumn, QStringLiteral("123")));
        QCOMPARE(rig.bench.model.pending().size(), 1U);
        QCOMPARE(rig.bench.model.pending().front().id, *rig.model.registerId());
    }
};

QTEST_MAIN(TestRevUpModel)
#include "tst_rev_up_model.moc"
