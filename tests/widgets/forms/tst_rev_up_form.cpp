// The drawing board for rev-ups: its picture and its table are one thing, by mouse and by keyboard, and nothing reaches
// the board before it is applied.
#include "support/rev_up_bench.h"

#include <QGraphicsTextItem>
#include <QListWidget>
#include <QScopeGuard>
#include <QScrollArea>
#include <QSet>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <cmath>
#include <random>

using facts::RevUpBench;
using motor::RevUp;
using motor::RevUpMistake;
using motor::RevUpStage;
using Column = widgets::RevUpModel::Column;
using Quantity = RevUpBench::Quantity;
using Point = RevUpBench::Chart::Point;

namespace {

/// What table, drawing and register say is the same: empty. Otherwise what differs.
QString disagreement(const RevUpBench &rig)
{
    const RevUp &stages = rig.stages();
    if (rig.wantedBytes() != motor::bytesOf(stages))
        return QStringLiteral("the register");
    const auto speed = rig.chart.drawn(Quantity::Speed),
               current = rig.chart.drawn(Quantity::Current);
    if (speed.size() != rig.model.used() + 1 || current.size() != speed.size())
        return QStringLiteral("the number of points");
    double time_ms = 0.0;
    for (int row = 0; row < rig.model.used(); ++row) {
        const auto number = [&](int column) {
            return rig.model.index(row, column).data(Qt::EditRole).toString().toDouble();
        };
        time_ms += number(Column::DurationColumn);
        const double amps = number(Column::DigitsColumn) * rig.model.shownPerDigit();
        for (const auto &[point, value] : {std::pair(speed[row + 1], number(Column::SpeedColumn)),
                 std::pair(current[row + 1], amps)})
            if (std::abs(1e3 * point.x() - time_ms) > 1e-6 || std::abs(point.y() - value) > 1e-9)
                return QStringLiteral("stage %1").arg(row + 1);
        const QPointF handle = rig.chart.handle({row, Quantity::Speed});
        if (!std::isfinite(handle.x()) || !std::isfinite(handle.y()))
            return QStringLiteral("a point that is nowhere");
    }
    return {};
}

QString findingsOf(const RevUpBench &rig)
{
    const auto *list = rig.form.findChild<QListWidget *>(QStringLiteral("revUpFindings"));
    QStringList texts;
    for (int i = 0; i < list->count(); ++i)
        texts.append(list->item(i)->text());
    return texts.join(QLatin1Char('\n'));
}

void typeInto(RevUpBench &rig, const char *name, const char *text)
{
    auto *edit = rig.form.findChild<QLineEdit *>(QLatin1String(name));
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, QLatin1String(text));
}

} // namespace

class TestRevUpForm : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void drawingAndTableAgreeAfterThousandsOfDrags()
    {
        RevUpBench rig;
        QVERIFY(rig.show());
        std::mt19937 random(20250801);
        const auto bounds = rig.model.bounds();
        const Bytes board = rig.heldBytes();
        int moved = 0;
        for (int round = 0; round < 3000; ++round) {
            if (round % 500 == 499)
                QVERIFY(rig.setAll(motor::revUpOfBytes(board).value())); // not for ever in a corner
            const Point point{int(random() % unsigned(rig.model.used())),
                random() % 2 == 0 ? Quantity::Speed : Quantity::Current};
            const RevUp before = rig.stages();
            const QPointF from = rig.chart.handle(point)
                + QPointF(double(random() % 9) - 4.0, double(random() % 9) - 4.0);
            rig.press(from);
            const int taken = rig.chart.selected()->stage;
            QPointF to = from;
            for (unsigned step = random() % 4 + 1; step > 0; --step) {
                to += QPointF(double(random() % 200) - 100.0, double(random() % 160) - 80.0);
                rig.move(to);
                const QString differs = disagreement(rig);
                QVERIFY2(differs.isEmpty(),
                    qPrintable(QStringLiteral("%1 in round %2").arg(differs).arg(round)));
            }
            rig.release(to);
            const RevUp left = rig.stages();
            rig.move(to + QPointF(40.0, 40.0)); // nothing is held any more
            QVERIFY(rig.stages() == left);
            if (round % 16 == 0)
                QCoreApplication::
                    processEvents(); // a layout that comes later must not move a point
            const QString differs = disagreement(rig);
            QVERIFY2(differs.isEmpty(),
                qPrintable(QStringLiteral("%1 after round %2").arg(differs).arg(round)));
            // One stage changed, to what the register can hold.
            RevUp others = rig.stages();
            const RevUpStage now = others[std::size_t(taken)];
            moved += others != before ? 1 : 0;
            QVERIFY(motor::withStage(before, std::size_t(taken), now) == others);
            const bool faster = now.speed_rpm != before[std::size_t(taken)].speed_rpm;
            QVERIFY(!faster || now.speed_rpm % 6 == 0);
            QVERIFY(std::abs(now.speed_rpm) <= bounds.speed_rpm);
            QVERIFY(std::abs(int{now.current_digits}) <= bounds.digits);
            QVERIFY(now.duration_ms > 0);
        }
        QVERIFY(moved > 2500);
        QVERIFY(rig.bench.writes.empty());
        QVERIFY(rig.heldBytes() == board);
    }

    void aPointGoesWhereItIsDraggedTo()
    {
        RevUpBench rig;
        QVERIFY(rig.show());
        const RevUp before = rig.stages();
        const Point third{2, Quantity::Speed};
        const QPointF from = rig.chart.handle(third);
        rig.press(from);
        QCOMPARE(*rig.chart.selected(), third);
        rig.move(from + QPointF(2, 0)); // a trembling hand
        QVERIFY(rig.stages() == before);
        rig.move(from + QPointF(1, 60));
        QCOMPARE(rig.stages()[2].duration_ms, before[2].duration_ms); // only up or down
        QVERIFY(rig.stages()[2].speed_rpm < before[2].speed_rpm);
        QVERIFY(QLineF(rig.chart.handle(third), from + QPointF(0, 60)).length() < 3.0);
        const QString hint = rig.form.findChild<QLabel *>(QStringLiteral("revUpHint"))->text();
        QVERIFY2(
            hint.contains(QString::number(rig.stages()[2].speed_rpm) + QStringLiteral("\u202frpm")),
            qPrintable(hint));
        rig.move(from + QPointF(40, 60));
        QVERIFY(rig.stages()[2].duration_ms > before[2].duration_ms);
        QVERIFY(QLineF(rig.chart.handle(third), from + QPointF(40, 60)).length() < 3.0);
        rig.release(from + QPointF(40, 60));
        QCOMPARE(rig.bench.model.pending().size(), 1U);
        QCOMPARE(rig.table->currentIndex().row(), 2);
        rig.bench.edits.revert();
        QVERIFY(rig.stages() == before);
        QCOMPARE(disagreement(rig), QString());
    }

    void theWholeIsInViewAfterEveryChange()
    {
        RevUpBench rig;
        QVERIFY(rig.show());
        const auto inView = [&] {
            const QRectF plot = rig.chart.chart()->plotArea().adjusted(-1, -1, 1, 1);
            for (int i = 0; i < rig.model.used(); ++i)
                for (const Quantity quantity : {Quantity::Speed, Quantity::Current})
                    if (!plot.contains(rig.chart.handle({i, quantity})))
                        return false;
            return true;
        };
        QVERIFY(rig.setAll({{0, 2000, 65535}, {3996, 2722, 65535}, {3996, 1, 65535}}));
        QVERIFY(inView());
        QVERIFY(rig.setAll({{-6, -2, 1}, {-3996, -2722, 3}}));
        QVERIFY(inView());
        QVERIFY(rig.setAll({{600, 100, 10}, {-600, -100, 20}}));
        QVERIFY(inView());
    }

    void everythingIsDoneByKeyboardAlone()
    {
        RevUpBench rig;
        QVERIFY(rig.show());
        rig.form.activateWindow();
        rig.form.focusFirst();
        QTRY_COMPARE(QApplication::focusWidget(), rig.table);
        const RevUp before = rig.stages();
        // The table: a number begins an edit, Enter takes it over and begins one, too.
        QTest::keyClick(rig.table, Qt::Key_9);
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("00"));
        const auto enter = [] {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
            QCoreApplication::processEvents(); // editors close in the next turn
        };
        enter();
        QCOMPARE(rig.stages()[0].duration_ms, 900);
        QTest::keyClick(rig.table, Qt::Key_Return);
        QVERIFY(qobject_cast<widgets::EntryEdit *>(QApplication::focusWidget()));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Up);
        enter();
        QCOMPARE(rig.stages()[0].duration_ms, 901);
        QTest::keyClick(rig.table, Qt::Key_Right);
        QTest::keyClick(rig.table, Qt::Key_Down);
        QTest::keyClick(rig.table, Qt::Key_F2);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Up); // one step of the drive
        enter();
        QCOMPARE(rig.stages()[1].speed_rpm, before[1].speed_rpm + 6);
        QTest::keyClick(rig.table, Qt::Key_Insert);
        QCOMPARE(rig.model.used(), 5);
        QTest::keyClick(rig.table, Qt::Key_Up, Qt::AltModifier);
        QTest::keyClick(rig.table, Qt::Key_Delete);
        QCOMPARE(rig.model.used(), 4);
        rig.bench.edits.revert();

        // Tab goes through everything and comes back.
        rig.table->setFocus();
        QSet<QString> reached;
        for (int i = 0; i < 30; ++i) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            reached.insert(QApplication::focusWidget()->objectName());
        }
        for (const char *name :
            {"revUpTable", "revUpChart", "revUpInertia", "revUpFriction", "revUpFindings",
                "revUpAdd", "revUpRemove", "revUpDown", "revUpUsual", "revUpOpen", "revUpSave"})
            QVERIFY2(reached.contains(QLatin1String(name)), name);

        // The picture: stages, speed or current, one quantum a key.
        rig.chart.setFocus(Qt::TabFocusReason);
        QTest::keyClick(&rig.chart, Qt::Key_Home);
        QTest::keyClick(&rig.chart, Qt::Key_PageDown);
        QCOMPARE(*rig.chart.selected(), (Point{1, Quantity::Speed}));
        QCOMPARE(rig.table->currentIndex().row(), 1);
        RevUpStage wanted = before[1];
        const auto press = [&](Qt::Key key, Qt::KeyboardModifiers with = {}) {
            QTest::keyClick(&rig.chart, key, with);
        };
        press(Qt::Key_Up);
        press(Qt::Key_Up, Qt::ShiftModifier);
        wanted.speed_rpm += 66;
        press(Qt::Key_Left);
        press(Qt::Key_Right, Qt::ShiftModifier);
        wanted.duration_ms = std::uint16_t(wanted.duration_ms + 9);
        press(Qt::Key_Return);
        QCOMPARE(*rig.chart.selected(), (Point{1, Quantity::Current}));
        press(Qt::Key_Down);
        wanted.current_digits = std::int16_t(wanted.current_digits - 1);
        QVERIFY(rig.stages()[1] == wanted);
        QVERIFY(rig.chart.accessibleDescription().contains(QStringLiteral("digits")));
        QVERIFY(rig.chart.accessibleDescription().contains(QString::number(wanted.current_digits)));
        for (int i = 0; i < 40; ++i)
            press(Qt::Key_Left, Qt::ShiftModifier | Qt::ControlModifier);
        QCOMPARE(rig.stages()[1].duration_ms, 1); // a stage does not vanish under the hand
        press(Qt::Key_Insert);
        QCOMPARE(rig.model.used(), 5);
        press(Qt::Key_Delete);
        QCOMPARE(rig.model.used(), 4);
        QVERIFY(rig.bench.writes.empty());
        QCOMPARE(disagreement(rig), QString());
    }

    void theFourMistakesAreMarkedAndExplained()
    {
        RevUpBench rig;
        QVERIFY(rig.show());
        QVERIFY(findingsOf(rig).contains(QStringLiteral("No problems")));
        const auto *facts = rig.form.findChild<QLabel *>(QStringLiteral("revUpFacts"));
        QVERIFY(facts->text().contains(QStringLiteral("type the inertia")));
        QVERIFY(facts->text().contains(QStringLiteral("39.0\u202fmN\u00b7m per A")));
        typeInto(rig, "revUpInertia", "500");
        typeInto(rig, "revUpFriction", "25");
        QVERIFY(!facts->text().contains(QStringLiteral("type the inertia")));
        QVERIFY(findingsOf(rig).contains(QStringLiteral("No problems")));

        const auto wrong = [&](const RevUp &stages, int row, int column) {
            if (!rig.setAll(stages))
                return QStringLiteral("not taken");
            const bool cell = rig.model.index(row, column).data(Qt::DecorationRole).isValid();
            const bool head =
                rig.model.headerData(row, Qt::Vertical).toString().contains(QChar(0x26a0));
            return cell && head ? findingsOf(rig) : QStringLiteral("not marked");
        };
        // 1200 rpm in 40 ms: 5e-5 kg m2 * 125.7 / 0.04 + 25 mN m; with 72.5 mN m left it takes 87 ms.
        const QString torque = wrong({{0, 1361, 1000}, {1200, 1361, 40}}, 1, Column::TorqueColumn);
        QVERIFY2(torque.contains(QStringLiteral("182\u202fmN\u00b7m")), qPrintable(torque));
        QVERIFY2(torque.contains(QStringLiteral("87\u202fms")), qPrintable(torque));
        QVERIFY2(torque.contains(QStringLiteral("4.67\u202fA")), qPrintable(torque));
        rig.bench.device.setUserLimits({0.0, 3.0}); // advice that is not allowed is none
        QVERIFY(!findingsOf(rig).contains(QStringLiteral("4.67\u202fA")));
        QVERIFY(findingsOf(rig).contains(QStringLiteral("87\u202fms")));
        rig.bench.device.setUserLimits({});
        QVERIFY(rig.setAll({{0, 1361, 1000}, {1200, 1361, 87}}));
        QVERIFY2(rig.model.findings().empty(), "the advice does not help");
        QVERIFY(rig.setAll({{0, 1361, 1000}, {1200, 1361, 86}}));
        QVERIFY2(!rig.model.findings().empty(), "the advice is too careful");

        QVERIFY(wrong({{0, 1361, 1000}, {540, 1361, 1500}}, 1, Column::SpeedColumn)
                    .contains(QStringLiteral("600\u202frpm")));
        QVERIFY(wrong({{0, 3000, 1000}, {1200, 1361, 1500}}, 0, Column::CurrentColumn)
                    .contains(QStringLiteral("5.00\u202fA")));
        QVERIFY(wrong({{0, 1361, 0}, {1200, 1361, 1500}}, 0, Column::DurationColumn)
                    .contains(QStringLiteral("no time")));
        QVERIFY(
            wrong({{0, 0, 0}}, 0, Column::DurationColumn).contains(QStringLiteral("Add a stage")));
        QVERIFY(wrong({{600, 1361, 1000}, {-900, 1361, 1500}}, 1, Column::SpeedColumn)
                    .contains(QStringLiteral("sign")));

        // Choosing a line leads to its stage.
        QVERIFY(rig.setAll({{0, 1361, 1000}, {540, 1361, 1500}}));
        rig.table->setCurrentIndex(rig.model.index(0, 0));
        rig.form.findChild<QListWidget *>(QStringLiteral("revUpFindings"))->setCurrentRow(0);
        QCOMPARE(rig.table->currentIndex().row(), 1);
        QCOMPARE(rig.chart.selected()->stage, 1);
    }

    void aMistakeIsSeenInThePicture()
    {
        RevUpBench rig;
        QVERIFY(rig.show());
        const QColor sign(0xff, 0xc1, 0x4d);
        const auto seen = [&] {
            const QImage picture = rig.chart.viewport()->grab().toImage();
            int dots = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    dots += picture.pixelColor(x, y) == sign ? 1 : 0;
            return dots;
        };
        QVERIFY(rig.setAll({{0, 1361, 1000}, {1200, 1361, 1500}}));
        QCOMPARE(seen(), 0);
        QVERIFY(rig.setAll({{0, 1361, 1000}, {540, 1361, 1500}}));
        QVERIFY(seen() > 20);
    }

    void startValuesAreABeginning()
    {
        RevUpBench rig;
        auto *usual = rig.form.findChild<QPushButton *>(QStringLiteral("revUpUsual"));
        QVERIFY(usual->isEnabled());
        usual->click();
        QVERIFY(rig.stages()
            == (RevUp{{0, 1361, 2000}, {1200, 1361, 3000}, {1200, 1361, 0}, {1200, 1361, 0},
                {1200, 1361, 0}}));
        QVERIFY(rig.model.findings().empty());
        QVERIFY(rig.bench.writes.empty());
    }

    void filesAreThoseOfTheCommandLine()
    {
        const QTemporaryDir folder;
        RevUpBench rig;
        rig.files.answer = folder.filePath(QStringLiteral("start.json"));
        const RevUp wanted{
            {0, 1400, 800}, {1200, 1400, 1600}, {1200, 1400, 0}, {1200, 1400, 0}, {1200, 1400, 0}};
        QVERIFY(rig.setAll(wanted));
        auto *save = rig.form.findChild<QPushButton *>(QStringLiteral("revUpSave"));
        auto *open = rig.form.findChild<QPushButton *>(QStringLiteral("revUpOpen"));
        save->click();
        rig.bench.edits.revert();
        QVERIFY(rig.stages() != wanted);
        open->click();
        QVERIFY(rig.stages() == wanted);
        QVERIFY(rig.failures.isEmpty());

        // What does not fit changes nothing and says why.
        const auto refused = [&](const char *text) {
            QFile file(rig.files.answer);
            if (!file.open(QIODevice::WriteOnly))
                return false;
            file.write(text);
            file.close();
            const auto failures = rig.failures.size();
            open->click();
            return rig.failures.size() == failures + 1 && rig.stages() == wanted;
        };
        QVERIFY(refused("not json"));
        QVERIFY(refused("{}"));
        QVERIFY(refused(R"({"stages":[{"speed_rpm":9000,"current_a":1,"duration_ms":5}]})"));
        QVERIFY(refused(R"({"stages":[{"speed_rpm":900,"current_a":40,"duration_ms":5}]})"));
        QVERIFY(refused(R"({"stages":[{"speed_rpm":900,"duration_ms":5}]})"));
        rig.files.answer = folder.filePath(QStringLiteral("none/none.json"));
        open->click();
        save->click();
        QCOMPARE(rig.failures.size(), 7);
    }

    /// One that was typed in the lab of gains is known here, and the other way round.
    void theInertiaOfAMotorIsTypedOnce()
    {
        RevUpBench rig;
        QVERIFY(rig.show());
        const auto inertia = [&] { return rig.model.facts().limits.load.inertia_kgm2; };
        QSignalSpy spy(&rig.form, &widgets::RevUpForm::inertiaRemembered);
        typeInto(rig, "revUpInertia", "512,5");
        auto *edit = rig.form.findChild<QLineEdit *>(QStringLiteral("revUpInertia"));
        QTest::keyClick(edit, Qt::Key_Return);
        QVERIFY(!spy.isEmpty());
        const QString motor = spy.last().at(0).toString();
        QVERIFY(!motor.isEmpty());
        QVERIFY(std::abs(spy.last().at(1).toDouble() - 512.5e-7) < 1e-12);
        edit->clear();
        rig.form.setInertias({{motor, 400e-7}});
        QCOMPARE(edit->placeholderText(), QStringLiteral("400.0"));
        QVERIFY(std::abs(inertia() - 400e-7) < 1e-12);
        rig.form.setInertias({{QStringLiteral("Another motor"), 400e-7}});
        QCOMPARE(inertia(), 0.0);
        QCOMPARE(edit->placeholderText(), QStringLiteral("not known"));
    }
    void whatWasTypedForOneMotorIsNotTakenForAnother()
    {
        simulation::BoardOptions options;
        options.motors = 2;
        RevUpBench rig(options);
        QVERIFY(rig.show());
        QSignalSpy spy(&rig.form, &widgets::RevUpForm::inertiaRemembered);
        auto *inertia = rig.form.findChild<QLineEdit *>(QStringLiteral("revUpInertia"));
        typeInto(rig, "revUpFriction", "20");
        typeInto(rig, "revUpInertia", "512,5");
        QTest::keyClick(inertia, Qt::Key_Return);
        QVERIFY(!spy.isEmpty());
        spy.clear();
        rig.readWatched(); // what is told of the same motor changes nothing
        QCOMPARE(inertia->text(), QStringLiteral("512,5"));
        rig.bench.device.setMotor(2);
        rig.bench.model.setCatalog(rig.bench.device.catalog(), 2);
        rig.readWatched();
        QCOMPARE(inertia->text(), QString());
        QCOMPARE(
            rig.form.findChild<QLineEdit *>(QStringLiteral("revUpFriction"))->text(), QString());
        // Both are of one name, for which the inertia is remembered; friction is not.
        QCOMPARE(rig.model.facts().limits.load.inertia_kgm2, 512.5e-7);
        QCOMPARE(rig.model.facts().limits.load.coulomb_nm, 0.0);
        inertia->setFocus();
        QTest::keyClick(inertia, Qt::Key_Return);
        QCOMPARE(spy.size(), 0);
    }
    void theInertiaFieldIsStrict()
    {
        RevUpBench rig;
        QVERIFY(rig.show());
        const auto inertia = [&] { return rig.model.facts().limits.load.inertia_kgm2; };
        typeInto(rig, "revUpInertia", "512,5");
        QVERIFY(std::abs(inertia() - 512.5e-7) < 1e-12);
        for (const char *bad : {"1e3", "1.000,5", "-5", "nan", "5 kg"}) {
            typeInto(rig, "revUpInertia", bad);
            QVERIFY2(inertia() == 0.0, bad);
        }
        auto *edit = rig.form.findChild<widgets::EntryEdit *>(QStringLiteral("revUpInertia"));
        QVERIFY(!edit->problem().isEmpty());
        edit->clear();
        QVERIFY(edit->problem().isEmpty()); // not known is an answer
    }

    void theWheelMovesNothingThatHasNoFocus()
    {
        RevUpBench rig;
        QVERIFY(rig.show());
        const RevUp before = rig.stages();
        for (QWidget *widget :
            std::initializer_list<QWidget *>{rig.chart.viewport(), rig.table->viewport(),
                rig.form.findChild<QWidget *>(QStringLiteral("revUpInertia"))}) {
            const QPointF at = widget->rect().center();
            QWheelEvent wheel(at, widget->mapToGlobal(at), {}, {0, 120}, Qt::NoButton,
                Qt::NoModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(widget, &wheel);
        }
        QVERIFY(rig.stages() == before);
        QVERIFY(rig.form.findChild<QLineEdit *>(QStringLiteral("revUpInertia"))->text().isEmpty());
    }

    /// As in a window of 1280x720: the page scrolls, what is in it is whole, and what only explains gives way.
    void whereThereIsLittleRoomThePictureIsStillRead()
    {
        RevUpBench rig;
        QScrollArea area;
        area.setFrameShape(QFrame::NoFrame);
        area.setWidgetResizable(true);
        area.setWidget(&rig.form);
        const auto giveBack = qScopeGuard([&area] { area.takeWidget(); }); // it is the bench's
        area.resize(936, 150);
        area.show();
        QVERIFY(QTest::qWaitForWindowExposed(&area));
        const auto *hint = rig.form.findChild<QLabel *>(QStringLiteral("revUpHint"));
        const auto *start = rig.form.findChild<QLabel *>(QStringLiteral("revUpLastStart"));
        const auto titlesAreWhole = [&rig] {
            int whole = 0;
            for (const QGraphicsItem *item : rig.chart.scene()->items()) {
                const auto *text = dynamic_cast<const QGraphicsTextItem *>(item);
                if (text != nullptr && text->rotation() != 0.0 && !text->toPlainText().isEmpty())
                    whole += text->toPlainText().endsWith(QLatin1String("...")) ? 0 : 1;
            }
            return whole == 2;
        };
        QTRY_VERIFY(hint->isHidden());
        QTRY_VERIFY(titlesAreWhole());
        QVERIFY(rig.chart.geometry().bottom() < start->y());
        QVERIFY(start->height() >= start->heightForWidth(start->width()));
        for (const char *name : {"revUpAdd", "revUpRemove", "revUpUp", "revUpDown"}) {
            const auto *button = rig.form.findChild<QPushButton *>(QLatin1String(name));
            QVERIFY2(button->visibleRegion().boundingRect().size() == button->size(), name);
        }
        area.resize(936, 420);
        QTRY_VERIFY(hint->isVisible() && rig.chart.geometry().bottom() < hint->y());
        QVERIFY(hint->height() >= hint->heightForWidth(hint->width()));
    }

    void wordsInThePictureLeaveThePlanFree_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("turns");
        for (const int width : {900, 1000, 1400})
            for (const int turns : {1, -1})
                QTest::addRow("%d wide, %d", width, turns) << width << turns;
    }
    void wordsInThePictureLeaveThePlanFree()
    {
        QFETCH(int, width);
        QFETCH(int, turns);
        RevUpBench rig;
        rig.form.resize(width, 320);
        QVERIFY(rig.show());
        RevUp stages = rig.stages();
        for (RevUpStage &stage : stages)
            stage.speed_rpm *= turns;
        QVERIFY(turns > 0 || rig.setAll(stages));
        const QRectF words = rig.chart.observerWords();
        QVERIFY(!words.isEmpty() && QRectF(rig.chart.viewport()->rect()).contains(words));
        for (int stage = 1; stage < rig.model.used(); ++stage) {
            const QLineF part(rig.chart.handle({stage - 1, Quantity::Speed}),
                rig.chart.handle({stage, Quantity::Speed}));
            for (int i = 0; i <= 100; ++i)
                QVERIFY2(
                    !words.contains(part.pointAt(i / 100.0)), qPrintable(QString::number(stage)));
        }
    }

    void itIsAToolOfTheWindow()
    {
        facts::WindowRig rig;
        QVERIFY(QTest::qWaitForWindowExposed(&rig.window));
        auto *form = rig.find<widgets::RevUpForm>("revUpForm");
        QVERIFY(form && !form->isVisible());
        QTest::keyClick(&rig.window, Qt::Key_2, Qt::ControlModifier);
        QTRY_VERIFY(form->isVisible());
        QTRY_VERIFY(form->findChild<QLabel *>(QStringLiteral("revUpReason"))->isVisible());
    }
};

QTEST_MAIN(TestRevUpForm)
#include "tst_rev_up_form.moc"
