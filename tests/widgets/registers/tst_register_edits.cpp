// Editing registers: pending, written, read back, taken back, on a simulated board in virtual time.
#include "support/edit_bench.h"
#include "widgets/registers/delegate.h"
#include "widgets/registers/write_question.h"

#include <QAbstractItemModelTester>
#include <QAbstractProxyModel>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

using catalog::Value;
using drive::Outcome;
using facts::EditBench;
using widgets::RegisterModel;
using State = RegisterModel::EditState;
using namespace std::chrono_literals;

namespace {

State stateOf(const EditBench &bench, const char *name)
{
    return bench.model.editState(bench.id(name));
}

Value whole(std::int64_t number) { return number; }

std::size_t setsIn(const EditBench &bench)
{
    return support::count(bench.link.requests, mcp::CommandId::SetRegister);
}

/// A snapshot that takes as long as the test wants.
struct SlowSnapshot : widgets::KeepBeforeWriting {
    int asked = 0;
    void make() override { ++asked; }
};

struct Cells : widgets::RegisterDelegate {
    using RegisterDelegate::initStyleOption, RegisterDelegate::RegisterDelegate;
};

} // namespace

class TestRegisterEdits : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void anEditWaitsAndIsWrittenOnApplyOnly()
    {
        EditBench bench;
        QAbstractItemModelTester tester(
            &bench.model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        bench.arm();
        const Value old = bench.held("SPEED_KP");
        QVERIFY(bench.type("SPEED_KP", QStringLiteral("1234")));
        QVERIFY(bench.type("SPEED_KI", QStringLiteral("0x20"), RegisterModel::RawColumn));
        bench.link.runFor(200ms);
        QVERIFY(stateOf(bench, "SPEED_KP") == State::Pending);
        QVERIFY(bench.held("SPEED_KP") == old);
        QCOMPARE(bench.edits.pendingCount(), 2);

        const std::size_t before = setsIn(bench);
        QVERIFY(bench.apply());
        QCOMPARE(setsIn(bench), before + 1); // both in one
        QVERIFY(bench.held("SPEED_KP") == whole(1234));
        QVERIFY(bench.held("SPEED_KI") == whole(32));
        QVERIFY(stateOf(bench, "SPEED_KP") == State::Verified);
        QCOMPARE(bench.told.last(), QStringLiteral("2 register(s) written and verified."));
        bench.model.refresh(bench.ms());
        bench.model.refresh(bench.ms() + 1499ms);
        QVERIFY(stateOf(bench, "SPEED_KP") == State::Verified);
        bench.model.refresh(bench.ms() + 1500ms);
        QVERIFY(stateOf(bench, "SPEED_KP") == State::None);
    }

    void theBoardsOwnValueIsNoEdit()
    {
        EditBench bench;
        QVERIFY(bench.type("SPEED_KP", QStringLiteral("7")));
        const auto held = std::get<std::int64_t>(bench.held("SPEED_KP"));
        QVERIFY(bench.type("SPEED_KP", QString::number(held)));
        QVERIFY(stateOf(bench, "SPEED_KP") == State::None);
        QCOMPARE(bench.edits.pendingCount(), 0);
    }

    void nothingIsWrittenUnlessArmed()
    {
        EditBench bench;
        bench.type("SPEED_KP", QStringLiteral("7"));
        QVERIFY(bench.edits.applyHint().contains(QStringLiteral("Arm")));
        bench.edits.apply();
        QVERIFY(bench.writes.empty());
        auto *apply = bench.panel.findChild<QPushButton *>(QStringLiteral("applyEdits"));
        QVERIFY(!apply->isEnabled());
        QVERIFY(apply->toolTip().contains(QStringLiteral("Arm")));
        bench.arm();
        QVERIFY(apply->isEnabled());
        QVERIFY(bench.edits.applyHint().isEmpty());
    }

    void revertForgetsWhatWaits()
    {
        EditBench bench;
        bench.type("SPEED_KP", QStringLiteral("7"));
        bench.edits.revert();
        QVERIFY(stateOf(bench, "SPEED_KP") == State::None);
        QVERIFY(!bench.model.hasEdits());
    }

    void whatTheBoardRefusesIsRedAndNotInTheList()
    {
        EditBench bench;
        bench.arm();
        bench.type("SPEED_KP", QStringLiteral("77"));
        // Not in this build, which is not known yet.
        bench.model.setPending(bench.id("FF_2"), whole(3));
        const auto reading = bench.link.values[bench.id("FF_2")].status;
        QVERIFY(reading != drive::ReadStatus::Ok);
        QVERIFY(bench.apply());
        QVERIFY(stateOf(bench, "SPEED_KP") == State::Verified);
        QVERIFY(stateOf(bench, "FF_2") == State::Refused);
        const QModelIndex cell = bench.model.indexOf(bench.id("FF_2"), RegisterModel::ValueColumn);
        QVERIFY(cell.data(Qt::ToolTipRole).toString().contains(QStringLiteral("UNKNOWN_REG")));
        QVERIFY(bench.told.last().contains(QStringLiteral("FF_2: UNKNOWN_REG")));
        QCOMPARE(bench.edits.steps().count(), 1);
        QCOMPARE(bench.edits.steps().undoText(), QStringLiteral("SPEED_KP"));
        bench.edits.apply(); // a refused value is not sent again by itself
        QCOMPARE(bench.writes.size(), 1U);
    }

    void anUndoIsAWriteThatIsReadBack()
    {
        EditBench bench;
        bench.arm();
        const Value old = bench.held("SPEED_KP");
        bench.type("SPEED_KP", QStringLiteral("77"));
        QVERIFY(bench.apply());
        bench.edits.undo();
        QVERIFY(bench.edits.steps().canUndo()); // not before the board has taken it
        QVERIFY(bench.settle());
        QVERIFY(!bench.edits.steps().canUndo());
        QVERIFY(bench.held("SPEED_KP") == old);
        bench.edits.redo();
        QVERIFY(bench.settle());
        QVERIFY(bench.held("SPEED_KP") == whole(77));
        QVERIFY(!bench.edits.steps().canRedo());
        bench.device.setArmed(false);
        bench.edits.undo();
        QVERIFY(!bench.edits.underWay());
        QVERIFY(bench.edits.undoHint().contains(QStringLiteral("Arm")));
    }

    /// The yes was to a drive that was armed then; who arms it again means something else.
    void aWriteThatWaitsForItsSnapshotEndsWithTheArming()
    {
        EditBench bench;
        SlowSnapshot snapshot;
        bench.edits.keepBeforeWriting(snapshot);
        for (const bool disarmed : {true, false}) {
            bench.arm();
            bench.type("SPEED_KP", disarmed ? QStringLiteral("77") : QStringLiteral("78"));
            bench.type("SPEED_KI", disarmed ? QStringLiteral("87") : QStringLiteral("88"));
            const std::size_t before = setsIn(bench);
            snapshot.asked = 0;
            bench.edits.apply();
            QCOMPARE(snapshot.asked, 1);
            if (disarmed) {
                bench.device.setArmed(false);
                bench.arm();
            }
            Q_EMIT snapshot.made();
            QVERIFY(bench.settle());
            QCOMPARE(setsIn(bench) > before, !disarmed);
            if (disarmed)
                QVERIFY(bench.told.last().contains(QStringLiteral("disarmed meanwhile")));
        }
    }

    void undoOfFiftyRandomEditsRestoresEveryByte()
    {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            EditBench bench;
            bench.answerYes = true;
            bench.arm();
            const auto start = bench.readAll();
            QVERIFY(start.size() > 30);
            support::Random random(seed);
            // References are commands: the board's record of the last ramp tells of the undo, too.
            std::vector<drive::RegisterId> ids;
            for (const auto &[id, value] : start)
                if (bench.model.editable(id, RegisterModel::ValueColumn)
                    && bench.model.rulesOf(id)->info->setPoint == catalog::SetPoint::None)
                    ids.push_back(id);
            int edits = 0;
            for (int tries = 0; edits < 50 && tries < 5000; ++tries) {
                const drive::RegisterId id = ids[random.below(ids.size())];
                const auto rules = *bench.model.rulesOf(id);
                const double span = rules.limits.greatest - rules.limits.least;
                const double part = static_cast<double>(random.below(10000)) / 10000.0;
                const double raw = rules.info->type == catalog::ValueType::F32
                    ? static_cast<double>(static_cast<float>(part * 100.0))
                    : std::floor(rules.limits.least + part * span);
                const Value value = rules.info->type == catalog::ValueType::F32
                    ? Value(raw)
                    : Value(static_cast<std::int64_t>(raw));
                const QString text = widgets::shownEntryText(value, rules);
                if (!bench.model.setData(bench.model.indexOf(id, RegisterModel::ValueColumn), text)
                    || bench.edits.pendingCount() == 0)
                    continue;
                const int steps = bench.edits.steps().count();
                QVERIFY(bench.apply());
                edits += bench.edits.steps().count() - steps;
                bench.model.forgetEdits();
            }
            QCOMPARE(edits, 50);
            QVERIFY(bench.readAll() != start);
            for (int i = 0; i < 50; ++i) {
                bench.edits.undo();
                QVERIFY(bench.settle());
            }
            QVERIFY2(!bench.edits.steps().canUndo(), qPrintable(bench.told.last()));
            const auto end = bench.readAll();
            for (const auto &[id, value] : start)
                QVERIFY2(end.at(id) == value, bench.device.catalog()->nameOf(id).c_str());
        }
    }

    void anUnplugTellsWhichWereWritten()
    {
        simulation::BoardOptions options;
        options.rxMax = 32; // seven to a request
        EditBench bench(options);
        bench.arm();
        const std::vector<const char *> names{"SPEED_KP", "SPEED_KI", "SPEED_KD", "I_Q_KP",
            "I_Q_KI", "I_Q_KD", "I_D_KP", "I_D_KI", "I_D_KD", "STOPLL_C1", "STOPLL_C2"};
        for (const char *name : names)
            QVERIFY(bench.type(name, QStringLiteral("31")));
        int sets = 0;
        bench.link.loses = [&](const Bytes &bytes) {
            if (bench.edits.underWay() && support::changesSomething(bytes) && bytes.size() > 8)
                ++sets;
            if (sets >= 2)
                bench.link.toBoard.cut = bench.link.toDrive.cut = true;
            return false;
        };
        bench.edits.apply();
        QVERIFY(bench.link.runUntil([&] { return !bench.edits.underWay(); }, 30s));
        int written = 0;
        int unclear = 0;
        int waiting = 0;
        for (const char *name : names) {
            const State state = stateOf(bench, name);
            QVERIFY2(state != State::Verified, name); // none was read back
            if (state == State::Unproved) {
                ++written;
                const QModelIndex cell = bench.model.indexOf(bench.id(name));
                const QString says = cell.data(Qt::AccessibleDescriptionRole).toString();
                QVERIFY2(
                    says.startsWith(QStringLiteral("Written, not verified")), qPrintable(says));
                QVERIFY(cell.data(Qt::ToolTipRole).toString().contains(says.toHtmlEscaped()));
            }
            unclear += state == State::Refused ? 1 : 0;
            waiting += state == State::Pending ? 1 : 0;
        }
        QCOMPARE(written + unclear + waiting, 11);
        QCOMPARE(written, 7);
        QVERIFY(unclear + waiting == 4);
        QVERIFY(bench.told.last().contains(QStringLiteral("I_D_KI"))
            || bench.told.at(bench.told.size() - 2).contains(QStringLiteral("I_D_KI")));
        // The board took seven, and none was read back.
        QVERIFY(!bench.told.filter(QStringLiteral("Written, not verified: ")).isEmpty());
        QVERIFY(bench.told.filter(QStringLiteral("written and verified")).isEmpty());
        QVERIFY(bench.link.runUntil(
            [&] { return bench.device.link().state == drive::LinkState::Lost; }, 30s));
        QCOMPARE(bench.edits.steps().count(), 0);
        QVERIFY(!bench.edits.applyHint().isEmpty());
    }

    /// The board says OK, and what it has is not read, or shows only later: neither is as good as read back.
    void whatWasNotReadBackIsMarkedApart()
    {
        EditBench bench;
        bench.arm();
        const auto ends = [&](const char *name, std::optional<bool> verified, const char *reason) {
            drive::WriteResult result{bench.id(name), Outcome::Ok, reason, {}, {}, verified};
            if (verified)
                result.readBack = whole(7);
            bench.model.onResults({result});
            const auto cell = [&](RegisterModel::Column column) {
                return bench.model.indexOf(bench.id(name), column);
            };
            QStyleOptionViewItem option;
            Cells(bench.model).initStyleOption(&option, cell(RegisterModel::NameColumn));
            return std::tuple(stateOf(bench, name), option.text.left(1),
                cell(RegisterModel::ValueColumn).data(Qt::AccessibleDescriptionRole).toString(),
                cell(RegisterModel::ValueColumn).data(Qt::BackgroundRole).value<QColor>());
        };
        const auto [state, sign, says, color] = ends("SPEED_KP", true, "");
        QVERIFY(state == State::Verified);
        QCOMPARE(says, QStringLiteral("Written and read back."));
        const auto [silentState, silentSign, silent, silentColor] = ends("SPEED_KI", {}, "");
        QVERIFY(silentState == State::Unproved);
        QCOMPARE(silent, QStringLiteral("Written, not verified."));
        QVERIFY(silentSign != sign);
        QVERIFY(silentColor != color);
        const auto later = std::get<2>(ends("SPEED_KD", {}, "shown from the next start on"));
        QCOMPARE(later, QStringLiteral("Written, not verified: shown from the next start on"));
        QVERIFY(!bench.model.hasEdits()); // the board took them
        bench.model.refresh(bench.ms());
        bench.model.refresh(bench.ms() + 1500ms);
        for (const char *name : {"SPEED_KP", "SPEED_KI", "SPEED_KD"})
            QVERIFY(stateOf(bench, name) == State::None);
    }

    void aResetOfTheBoardEmptiesTheList()
    {
        EditBench bench;
        bench.arm();
        bench.type("SPEED_KP", QStringLiteral("77"));
        QVERIFY(bench.apply());
        QCOMPARE(bench.edits.steps().count(), 1);
        facts::feed(bench.device,
            {drive::LinkChanged{drive::LinkState::Connected, drive::LinkReason::BoardReset}});
        QCOMPARE(bench.edits.steps().count(), 0);
        QVERIFY(bench.told.last().contains(QStringLiteral("reconnect")));
    }

    void aStepThatWentBackHalfWayKeepsTheOtherHalf()
    {
        EditBench bench;
        bench.arm();
        bench.type("SPEED_KP", QStringLiteral("77"));
        bench.type("SPEED_KI", QStringLiteral("78"));
        QVERIFY(bench.apply());
        // The board's answer is made up: one of the two was refused.
        const drive::WishId next = bench.device.submit(drive::Watch{}) + 1;
        bench.device.blockSignals(true);
        bench.edits.undo();
        bench.device.blockSignals(false);
        drive::Ended ended{next, Outcome::Refused, "RO_REG", {}};
        ended.writes = {{bench.id("SPEED_KI"), Outcome::Ok, {}, whole(78), whole(1), true},
            {bench.id("SPEED_KP"), Outcome::Refused, "RO_REG", whole(77), {}, {}}};
        facts::feed(bench.device, {ended});
        QVERIFY(bench.edits.steps().canUndo());
        QVERIFY(!bench.edits.steps().canRedo());
        bench.edits.undo();
        QCOMPARE(bench.writes.back().writes.size(), 1U);
        QCOMPARE(bench.writes.back().writes.front().id, bench.id("SPEED_KP"));
    }

    void aDangerousWriteIsAskedAboutAndCancelIsTheDefault()
    {
        EditBench bench({}, false);
        bench.panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.panel));
        bench.arm();
        QVERIFY(bench.type("SPEED_REF", QStringLiteral("600 rpm")));
        QSignalSpy declined(&bench.edits, &widgets::RegisterEdits::declined);
        for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Escape}) {
            bench.edits.apply();
            auto *box = bench.panel.findChild<QMessageBox *>(QStringLiteral("writeQuestion"));
            QVERIFY(box);
            QTRY_VERIFY(box->isVisible());
            QVERIFY(box->informativeText().contains(QStringLiteral("Motor 1")));
            QVERIFY(box->informativeText().contains(QStringLiteral("SPEED_REF")));
            QVERIFY(box->informativeText().contains(QStringLiteral("600\u202frpm")));
            QTest::keyClick(box, key);
            QTRY_VERIFY(!bench.panel.findChild<QMessageBox *>(QStringLiteral("writeQuestion")));
            QVERIFY(!bench.edits.underWay());
            QVERIFY(bench.writes.empty());
        }
        QCOMPARE(declined.size(), 3);
        bench.edits.apply();
        auto *box = bench.panel.findChild<QMessageBox *>(QStringLiteral("writeQuestion"));
        QVERIFY(box);
        box->findChild<QPushButton *>(QStringLiteral("writeAnyway"))->click();
        QVERIFY(bench.settle());
        QCOMPARE(bench.writes.size(), 1U);
    }

    void whatActsStandsFirstInTheQuestionAndIsNeverFoldedAway()
    {
        EditBench bench({}, false);
        bench.panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.panel));
        QList<widgets::WriteLine> lines;
        for (int i = 0; i < 20; ++i)
            lines.append({QStringLiteral("GAIN_%1").arg(i), QStringLiteral("1"),
                QStringLiteral("9"), 1, catalog::Caution::GainJump});
        for (int i = 0; i < 15; ++i)
            lines.append({QStringLiteral("REFERENCE_%1").arg(i), QStringLiteral("0"),
                QStringLiteral("900"), 1, catalog::Caution::Dangerous, true});
        widgets::askBeforeWriting(&bench.panel, bench.edits, lines);
        auto *box = bench.panel.findChild<QMessageBox *>(QStringLiteral("writeQuestion"));
        QVERIFY(box);
        const QString text = box->informativeText();
        for (int i = 0; i < 15; ++i)
            QVERIFY2(text.contains(QStringLiteral("REFERENCE_%1:").arg(i)), qPrintable(text));
        QVERIFY(!text.contains(QStringLiteral("GAIN_0:")));
        QVERIFY(text.contains(QStringLiteral("20 more")));
        box->reject();
    }

    void aGainJumpIsAskedAboutOnlyWhileTheMotorRuns()
    {
        EditBench bench;
        bench.arm();
        const auto kp = std::get<std::int64_t>(bench.held("SPEED_KP")) / 10;
        bench.type("SPEED_KP", QString::number(kp));
        QVERIFY(bench.apply());
        QCOMPARE(bench.questions, 0);
        facts::feed(bench.device, {facts::status(drive::MotorState::Running)});
        bench.type("SPEED_KP", QString::number(3 * kp));
        bench.edits.apply();
        QVERIFY(bench.edits.underWay());
        QCoreApplication::processEvents();
        QCOMPARE(bench.questions, 1);
        QCOMPARE(bench.writes.size(), 1U);
        bench.device.setArmed(false); // while the question is open
        bench.edits.confirm();
        QCOMPARE(bench.writes.size(), 1U);
        QVERIFY(stateOf(bench, "SPEED_KP") == State::Pending);
        QVERIFY(bench.told.last().contains(QStringLiteral("Arm")));
    }

    void anEditIsSeenInASelectedRow()
    {
        EditBench bench;
        bench.panel.resize(420, 600);
        bench.panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.panel));
        bench.type("SPEED_KP", QStringLiteral("77"));
        QTreeView *tree = bench.panel.findChild<QTreeView *>();
        const auto *proxy = qobject_cast<const QAbstractProxyModel *>(tree->model());
        const QModelIndex cell = proxy->mapFromSource(
            bench.model.indexOf(bench.id("SPEED_KP"), RegisterModel::ValueColumn));
        tree->expand(cell.parent());
        tree->scrollTo(cell);
        tree->setCurrentIndex(cell);
        QVERIFY(tree->selectionModel()->isSelected(cell));
        const QRect place = tree->visualRect(cell);
        const QImage picture = tree->viewport()->grab().toImage();
        QCOMPARE(picture.pixelColor(place.topLeft() + QPoint(3, 3)),
            cell.data(Qt::BackgroundRole).value<QColor>());
    }

    void anEditIsSeenWithoutItsColour()
    {
        EditBench bench;
        bench.panel.resize(420, 600);
        bench.panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.panel));
        QTreeView *tree = bench.panel.findChild<QTreeView *>();
        const auto *proxy = qobject_cast<const QAbstractProxyModel *>(tree->model());
        const QModelIndex name = proxy->mapFromSource(
            bench.model.indexOf(bench.id("SPEED_KP"), RegisterModel::NameColumn));
        tree->expand(name.parent());
        tree->scrollTo(name);
        const auto picture = [&] {
            return tree->viewport()->grab(tree->visualRect(name)).toImage();
        };
        const QImage before = picture();
        QVERIFY(name.data(Qt::AccessibleDescriptionRole).toString().isEmpty());
        bench.type("SPEED_KP", QStringLiteral("77"));
        QVERIFY(picture() != before);
        QVERIFY(!name.data(Qt::AccessibleDescriptionRole).toString().isEmpty());
        QCOMPARE(name.data().toString(), QStringLiteral("SPEED_KP")); // as it is copied and dragged
        bench.edits.revert();
        QVERIFY(picture() == before);
    }

    void goodNewsEndWithTheNextEdit()
    {
        EditBench bench;
        const auto *told = bench.panel.findChild<QLabel *>(QStringLiteral("editsTold"));
        bench.arm();
        bench.type("SPEED_KP", QStringLiteral("77"));
        QVERIFY(bench.apply());
        QVERIFY(told->text().contains(QStringLiteral("written")));
        bench.type("SPEED_KP", QStringLiteral("78"));
        QVERIFY(told->text().isEmpty());
        bench.device.setArmed(false);
        QVERIFY(told->text().contains(QStringLiteral("Arm")));
    }

    void setPointsEndAtTheBoardsOwnLimits()
    {
        EditBench bench;
        const double rpm = bench.device.identified()->limits.front().maxSpeedRpm;
        QVERIFY(rpm > 0.0);
        QVERIFY(bench.type("SPEED_REF", QString::number(std::floor(rpm))));
        QVERIFY(!bench.type("SPEED_REF", QString::number(std::floor(rpm) + 1.0)));
        QVERIFY(!bench.type("I_Q_REF", QStringLiteral("1000 A")));
        QVERIFY(bench.type("I_Q_REF", QStringLiteral("0,5 A")));
        QVERIFY(!bench.type("I_Q_REF", QStringLiteral("0.5 V")));
    }
};

QTEST_MAIN(TestRegisterEdits)
#include "tst_register_edits.moc"
