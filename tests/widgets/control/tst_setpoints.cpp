// The set-point fields under any board, any limits of one's own, any text and any locale: what leaves is a finite
// number inside both limits, and it is the one that was echoed.
#include "support/link_pair.h"
#include "support/window_facts.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/base/value_text.h"
#include "widgets/control/motion_gate.h"
#include "widgets/control/panel.h"
#include "widgets/control/setpoints/box.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>

#include <bit>
#include <cmath>
#include <limits>

namespace {

const char *const kTexts[] = {"nan", "NaN", "inf", "-inf", "1e999", "1e3", "1.234,5", "1'000",
    "1.234", "1,5", "-1", "0", "-0", "0x7FFF", "99999999999999999999", "65536", "-32769",
    "\u0661\u0662\u0663", "3.5 A", "600 rpm", "", " ", "+", "-", ".", "\u221212", "1\u00a0000",
    "0.1", "5.01", "4000", "4001", "3999.9", "600", "-1500", "0,005", "000000000001", "1..2"};

struct Rig {
    widgets::Device device;
    widgets::RegisterModel registers;
    widgets::MotionGate motion{device, registers};
    widgets::ControlPanel panel{device, registers, motion};
    std::vector<drive::Wish> moved; ///< set-points that left
    drive::WishId last = 0;

    Rig()
    {
        QObject::connect(
            &motion, &widgets::MotionGate::asked, &motion, &widgets::MotionGate::confirm);
        QObject::connect(
            &device, &widgets::Device::wishMade, &panel, [this](const drive::Wish &wish) {
                if (std::holds_alternative<drive::SpeedRamp>(wish.what)
                    || std::holds_alternative<drive::TorqueRamp>(wish.what)
                    || std::holds_alternative<drive::CurrentReference>(wish.what))
                    moved.push_back(wish);
                last = wish.id;
            });
        QObject::connect(&device, &widgets::Device::armWished, &device,
            &widgets::Device::armedChanged); // the session's part
        panel.show();
    }
    widgets::NumberEdit *edit(const char *name) const
    {
        return panel.findChild<widgets::NumberEdit *>(QLatin1String(name));
    }
    QString echo() const { return panel.findChild<QLabel *>(QStringLiteral("speedEcho"))->text(); }
};

/// What a structure of a board may decode to: mostly sensible, else any bits.
double anyLimit(support::Random &random, double sensible)
{
    if (random.chance(0.7))
        return sensible * static_cast<double>(1 + random.below(200)) / 100.0;
    const double odd[] = {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
        std::numeric_limits<double>::infinity(), 1e300, 1e-300,
        static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(random.next())))};
    return odd[random.below(std::size(odd))];
}

void disturb(QLineEdit *edit, support::Random &random)
{
    const QString text = QString::fromUtf8(kTexts[random.below(std::size(kTexts))]);
    switch (random.below(5)) {
    case 0:
        edit->selectAll();
        for (const QChar letter : text) // keyClicks() knows Latin letters only
            QTest::sendKeyEvent(
                QTest::Click, edit, Qt::Key_unknown, QString(letter), Qt::NoModifier);
        break;
    case 1:
        QGuiApplication::clipboard()->setText(text);
        edit->selectAll();
        edit->paste();
        break;
    case 2: {
        edit->setFocus();
        QWheelEvent wheel(QPointF(5, 5), edit->mapToGlobal(QPointF(5, 5)), {},
            QPoint(0, random.chance(0.5) ? 120 : -120), Qt::NoButton, Qt::NoModifier,
            Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(edit, &wheel);
        break;
    }
    case 3:
        QTest::keyClick(edit, random.chance(0.5) ? Qt::Key_PageUp : Qt::Key_Down);
        break;
    default:
        edit->setText(text);
        break;
    }
}

} // namespace

class TestSetpoints : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void aClickIntoAFieldSelectsAndARefusedNumberIsRed()
    {
        QWidget window;
        widgets::NumberEdit first(&window), edit(&window);
        edit.move(0, 60);
        edit.setLimits(4000.0, 6.0, QStringLiteral("rpm"));
        edit.setValue(1500.0);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        first.setFocus();
        std::vector<double> committed;
        connect(&edit, &widgets::NumberEdit::committed, this,
            [&](double value) { committed.push_back(value); });
        QTest::mouseClick(&edit, Qt::LeftButton);
        QTest::keyClicks(&edit, QStringLiteral("2600"));
        QCOMPARE(edit.text(), QStringLiteral("2600"));
        QTest::mouseClick(&edit, Qt::LeftButton); // in the field already: the cursor only
        QVERIFY(!edit.hasSelectedText());
        QTest::keyClick(&edit, Qt::Key_Return);
        QCOMPARE(committed, std::vector<double>{2598.0});
        edit.selectAll();
        QTest::keyClicks(&edit, QStringLiteral("26001500"));
        QCOMPARE(edit.palette().color(QPalette::Base), widgets::kRefusedColor);
        QCOMPARE(edit.accessibleDescription(), edit.echo());
        QTest::keyClick(&edit, Qt::Key_Return);
        QCOMPARE(committed.size(), std::size_t{1});
        QCOMPARE(QToolTip::text(), edit.echo().toHtmlEscaped()); // why
        QToolTip::hideText();
        edit.setLimits(30000000.0, 6.0, QStringLiteral("rpm")); // now it is good
        QVERIFY(edit.palette().color(QPalette::Base) != widgets::kRefusedColor);
    }

    void whatIsTypedTakesThePlaceOfWhatIsFollowed_data()
    {
        QTest::addColumn<int>("way");
        QTest::newRow("a click") << 0;
        QTest::newRow("a double click") << 1;
        QTest::newRow("Ctrl+A") << 2;
        QTest::newRow("Tab") << 3;
    }
    void whatIsTypedTakesThePlaceOfWhatIsFollowed()
    {
        QFETCH(int, way);
        Rig rig;
        facts::connectBoard(rig.device);
        rig.panel.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&rig.panel));
        auto *box = rig.panel.findChild<widgets::SetpointBox *>();
        auto *edit = rig.edit("speed");
        rig.edit("rampTime")->setFocus();
        box->offerReference(1500.0);
        QCOMPARE(edit->text(), QStringLiteral("1500"));
        if (way < 2)
            QTest::mouseClick(edit, Qt::LeftButton);
        else
            edit->setFocus(way == 3 ? Qt::TabFocusReason : Qt::OtherFocusReason);
        if (way == 1)
            QTest::mouseDClick(edit, Qt::LeftButton);
        if (way == 2)
            QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(edit->selectedText(), QStringLiteral("1500"));
        for (int i = 0; i < 3; ++i) // the board is read again and again
            box->offerReference(1500.0);
        QCOMPARE(edit->selectedText(), QStringLiteral("1500"));
        box->offerReference(900.0); // and may have another one
        QCOMPARE(edit->selectedText(), QStringLiteral("900"));
        QTest::keyClicks(edit, QStringLiteral("2600"));
        QCOMPARE(edit->text(), QStringLiteral("2600"));
        box->offerReference(900.0); // not over what was typed
        QCOMPARE(edit->text(), QStringLiteral("2600"));
        // What a stop leaves on the board is replaced as well.
        facts::feed(rig.device, {drive::StopProgress{1, drive::StopWord::Requested, {}}});
        QCOMPARE(edit->selectedText(), QStringLiteral("0"));
        box->offerReference(2600.0);
        QTest::keyClicks(edit, QStringLiteral("1200"));
        QCOMPARE(edit->text(), QStringLiteral("1200"));
    }

    void cursorAndSelectionStayWhereTheyWerePut()
    {
        QWidget window;
        widgets::NumberEdit edit(&window);
        edit.setLimits(4000.0, 1.0, QStringLiteral("rpm"));
        edit.setValue(1500.0);
        edit.setFocus();
        edit.setSelection(1, 2);
        edit.setValue(1500.0);
        QCOMPARE(edit.selectionStart(), 1);
        edit.setValue(1620.0);
        QCOMPARE(edit.selectedText(), QStringLiteral("62"));
        edit.setValue(90.0);
        QCOMPARE(edit.selectedText(), QStringLiteral("0"));
        edit.setCursorPosition(1);
        edit.setValue(1500.0);
        QCOMPARE(edit.cursorPosition(), 1);
        QVERIFY(!edit.hasSelectedText());
        edit.selectAll();
        QTest::keyClick(&edit, Qt::Key_Up); // a step takes no selection away either
        QTest::keyClicks(&edit, QStringLiteral("900"));
        QCOMPARE(edit.text(), QStringLiteral("900"));
    }

    void aStepDecidesWhatANumberIs()
    {
        QWidget window;
        widgets::NumberEdit stepped(&window);
        stepped.setLimits(4000.0, 6.0, QStringLiteral("rpm"));
        stepped.setValue(1233.4);
        QCOMPARE(stepped.text(), QStringLiteral("1233"));
        QCOMPARE(stepped.value(), std::optional(1233.0)); // what is seen, not what was given
        QCOMPARE(stepped.sentValue(), std::optional(1236.0));
        widgets::NumberEdit any(
            "any", QStringLiteral("Any"), QStringLiteral("mH"), 0.1, 1000.0, &window);
        QVERIFY(any.text().isEmpty() && any.problem().isEmpty() && !any.value());
        QVERIFY(!any.isUndoAvailable()); // nobody has typed
        any.setValue(1.0 / 3.0);
        QCOMPARE(any.text(), QStringLiteral("0.3333"));
        QCOMPARE(any.value(), std::optional(1.0 / 3.0)); // more than is seen
        QCOMPARE(any.sentValue(), any.value());
        bool left = false;
        connect(&any, &widgets::NumberEdit::committed, this, [&left] { left = true; });
        QTest::keyClick(&any, Qt::Key_Return);
        QVERIFY(!left);
        QTest::keyClick(&any, Qt::Key_Up); // a fiftieth of it
        QCOMPARE(any.text(), QStringLiteral("0.34"));
        QTest::keyClick(&stepped, Qt::Key_Up); // from what would be sent
        QCOMPARE(stepped.text(), QStringLiteral("1242"));
        any.setText(QStringLiteral("2000"));
        QCOMPARE(any.problem(), QStringLiteral("From 0.1 to 1000 mH."));
        stepped.setText(QStringLiteral("-5000"));
        QCOMPARE(stepped.problem(), QStringLiteral("The limit is 4000 rpm."));
        stepped.setRange(0.0, 4000.0, 6.0, QStringLiteral("rpm"));
        QCOMPARE(stepped.problem(), QStringLiteral("It cannot be negative."));
        any.setValue(std::nullopt); // not known
        stepped.setValue(std::nullopt);
        QVERIFY(any.text().isEmpty() && any.problem().isEmpty());
        QCOMPARE(stepped.text(), QStringLiteral("-5000"));
    }

    void whateverIsTypedWhatLeavesIsInsideAndEchoed()
    {
        const int rounds = qEnvironmentVariableIntValue("ROTORSCOPE_LONG") != 0 ? 20000 : 600;
        const auto seed =
            static_cast<std::uint64_t>(qEnvironmentVariableIntValue("ROTORSCOPE_SEED")) + 1;
        support::Random random(seed);
        const QList<QLocale> locales{
            QLocale::c(), QLocale(QLocale::German), QLocale(QLocale::Turkish)};
        Rig rig;
        facts::connectBoard(rig.device);
        auto *mode = rig.panel.findChild<QComboBox *>(QStringLiteral("setpointMode"));
        int sent = 0, refused = 0; // both have to be many, or nothing was tried
        for (int round = 0; round < rounds; ++round) {
            QLocale::setDefault(locales[static_cast<qsizetype>(random.below(3))]);
            if (round % 20 == 0)
                anotherBoard(rig, random);
            mode->setCurrentIndex(static_cast<int>(random.below(3)));
            const bool speeds = mode->currentIndex() == 0;
            auto *edit = rig.edit(speeds        ? "speed"
                    : mode->currentIndex() == 1 ? "torque"
                                                : "iqReference");
            for (const char *other : {"rampTime", "idReference"}) // nothing odd stays from before
                rig.edit(other)->setText(QStringLiteral("0"));
            disturb(edit, random);
            if (mode->currentIndex() == 2)
                disturb(rig.edit("idReference"), random);
            else if (random.chance(0.2))
                disturb(rig.edit("rampTime"), random);
            rig.moved.clear();
            const auto expected = edit->sentValue();
            QTest::keyClick(edit, Qt::Key_Return);
            QVERIFY(rig.moved.size() <= 1); // one act, one wish
            ++(rig.moved.empty() ? refused : sent);
            if (rig.moved.empty())
                continue;
            QVERIFY(expected.has_value());
            if (!judge(rig, edit, rig.moved[0], *expected)) {
                qWarning("seed %llu, round %d", static_cast<unsigned long long>(seed), round);
                return;
            }
        }
        QVERIFY(sent > rounds / 10);
        QVERIFY(refused > rounds / 10);
    }

    void aReferenceThatIsNoNumberChangesNoField()
    {
        Rig rig;
        facts::connectBoard(rig.device);
        rig.edit("speed")->setText(QStringLiteral("600"));
        for (const double odd : {std::numeric_limits<double>::quiet_NaN(),
                 std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
            rig.edit("speed")->setValue(odd);
        QCOMPARE(rig.edit("speed")->text(), QStringLiteral("600"));
    }

private:
    static void anotherBoard(Rig &rig, support::Random &random)
    {
        drive::Identified board = facts::identified();
        board.limits[0].maxSpeedRpm = anyLimit(random, 4000.0);
        board.limits[0].maxCurrentAmps = anyLimit(random, 32.0);
        board.limits[0].nominalCurrentAmps = anyLimit(random, 5.0);
        facts::feed(rig.device, {board, facts::status(drive::MotorState::Idle)});
        rig.device.setUserLimits(random.chance(0.5)
                ? drive::UserLimits{}
                : drive::UserLimits{anyLimit(random, 3000.0), anyLimit(random, 2.0)});
        rig.device.setArmed(true);
        if (random.chance(0.5)) {
            rig.device.becomeExpert(1);
            drive::Ended agreed;
            agreed.id = rig.last;
            facts::feed(rig.device, {agreed});
        }
    }
    static bool inside(double value, double limit, double own)
    {
        return std::isfinite(value) && (!(limit > 0.0) || std::abs(value) <= limit)
            && (!(own > 0.0) || std::abs(value) <= own);
    }
    static bool judge(
        const Rig &rig, const widgets::NumberEdit *edit, const drive::Wish &wish, double expected)
    {
        const drive::MotorLimits told = rig.device.limits(1);
        const drive::UserLimits own = rig.device.userLimits();
        const bool unbounded = !drive::gapsIn(told).empty();
        if (unbounded && !rig.device.expert(1))
            return QTest::qVerify(false, "known", "moved without limits", __FILE__, __LINE__);
        const auto most = [](double limit, double ceiling) {
            return std::isfinite(limit) && limit > 0.0 && limit <= ceiling ? limit : ceiling;
        };
        const double rpm = most(told.maxSpeedRpm, drive::kHighestRpm);
        const double amps = std::min(most(told.maxCurrentAmps, drive::kHighestAmps),
            most(told.nominalCurrentAmps, drive::kHighestAmps));
        double value = 0.0;
        bool good = true;
        if (const auto *speed = std::get_if<drive::SpeedRamp>(&wish.what)) {
            value = speed->rpm;
            good = inside(value, rpm, own.maxSpeedRpm) && speed->duration.count() >= 0
                && speed->duration.count() <= 65535;
        } else if (const auto *torque = std::get_if<drive::TorqueRamp>(&wish.what)) {
            value = torque->amps;
            good = inside(value, amps, own.maxCurrentAmps) && torque->duration.count() >= 0
                && torque->duration.count() <= 65535;
        } else {
            const auto &both = std::get<drive::CurrentReference>(wish.what);
            value = both.iqAmps;
            good = inside(value, amps, own.maxCurrentAmps)
                && inside(both.idAmps, amps, own.maxCurrentAmps);
        }
        const QString number = widgets::numberText(value, widgets::decimalsFor(edit->step()));
        const QByteArray about = QStringLiteral("sent %1, field %2, echo %3")
                                     .arg(value)
                                     .arg(edit->text(), rig.echo())
                                     .toUtf8();
        return QTest::qVerify(good, "inside both limits", about, __FILE__, __LINE__)
            && QTest::qVerify(value == expected, "as the field says", about, __FILE__, __LINE__)
            && QTest::qVerify(edit->echo().contains(number + QLatin1Char(' ')), "echoed", about,
                __FILE__, __LINE__);
    }
};

QTEST_MAIN(TestSetpoints)
#include "tst_setpoints.moc"
