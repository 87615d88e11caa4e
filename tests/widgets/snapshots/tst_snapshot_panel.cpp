// Snapshots in the window: saved, compared, restored and told register by register, on a simulated board in virtual
// time.
#include "session/files/snapshot_json.h"
#include "session/files/whole_file.h"
#include "support/edit_bench.h"
#include "support/window_rig.h"
#include "widgets/snapshots/actions.h"
#include "widgets/snapshots/panel.h"
#include "widgets/window/shortcut_guard.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

using facts::EditBench;
using widgets::SnapshotDialog;
using widgets::SnapshotModel;
using namespace std::chrono_literals;

namespace {

const std::vector<const char *> kTwenty{"SPEED_KP", "SPEED_KI", "SPEED_KD", "I_Q_KP", "I_Q_KI",
    "I_Q_KD", "I_D_KP", "I_D_KI", "I_D_KD", "STOPLL_C1", "STOPLL_C2", "STOPLL_KI", "STOPLL_KP",
    "SPEED_KP_DIV", "SPEED_KI_DIV", "I_D_KP_DIV", "I_D_KI_DIV", "I_Q_KP_DIV", "I_Q_KI_DIV",
    "STOPLL_KP_DIV"};

struct PanelBench : EditBench {
    QTemporaryDir home;
    facts::AnsweredPrompt files;
    widgets::AutoSnapshots automatic{device, home.filePath(QStringLiteral("kept"))};
    widgets::SnapshotPanel compared{device, edits, automatic, files};
    QAbstractItemModelTester tester{
        compared.model(), QAbstractItemModelTester::FailureReportingMode::QtTest};

    explicit PanelBench(const simulation::BoardOptions &options = {})
        : EditBench(options)
    {
        edits.keepBeforeWriting(automatic);
        compared.resize(900, 320);
        compared.show();
        arm();
    }

    template <class T>
    T *find(const char *name) const
    {
        return compared.findChild<T *>(QLatin1String(name));
    }
    QPushButton *restoreButton() const { return find<QPushButton>("snapshotRestore"); }
    QTableView *table() const { return find<QTableView>("snapshotTable"); }

    bool saved(const QString &path)
    {
        files.answer = path;
        SnapshotDialog dialog(SnapshotDialog::Form::Snapshot, device, files, home.path(), nullptr);
        const QSignalSpy spy(&dialog, &SnapshotDialog::saved);
        dialog.open();
        const bool ended = pump([&] { return spy.size() == 1; });
        files.answer.clear();
        return ended;
    }
    bool pump(const std::function<bool()> &condition, Duration limit = 30s)
    {
        QCoreApplication::processEvents();
        return link.runUntil(
            [&] {
                QCoreApplication::processEvents();
                return condition();
            },
            limit);
    }
    bool quiet()
    {
        const auto *cancel = find<QPushButton>("snapshotCancel");
        return pump([&] { return cancel->isHidden() && !edits.underWay(); });
    }
    bool opened(const QString &path)
    {
        compared.openFile(path);
        return quiet();
    }
    bool change(const std::vector<const char *> &names, int by)
    {
        std::vector<drive::RegisterWrite> list;
        for (const char *name : names)
            list.push_back({id(name), std::get<std::int64_t>(held(name)) + by});
        edits.write({}, list);
        return quiet();
    }
    QStringList shown() const
    {
        QStringList names;
        for (int row = 0; row < table()->model()->rowCount(); ++row)
            names.append(table()->model()->index(row, 0).data().toString());
        return names;
    }
};

QStringList sorted(QStringList names)
{
    names.sort();
    return names;
}

QStringList twenty()
{
    QStringList names;
    for (const char *name : kTwenty)
        names.append(QString::fromLatin1(name));
    return sorted(names);
}

} // namespace

class TestSnapshotPanel : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void aSnapshotIsSavedFromThePageItself()
    {
        PanelBench bench;
        QAction save(QStringLiteral("Save"));
        save.setEnabled(false);
        bench.compared.offerSave(&save);
        auto *button = bench.find<QPushButton>("snapshotSave");
        QVERIFY(button != nullptr && !button->isEnabled());
        QTRY_VERIFY(button->isVisible());
        save.setEnabled(true);
        const QSignalSpy spy(&save, &QAction::triggered);
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(spy.size(), 1);
    }

    void twentyChangedRegistersAreFoundAndRestored()
    {
        PanelBench bench;
        const QString path = bench.home.filePath(QStringLiteral("s.json"));
        QVERIFY(bench.saved(path));
        const auto before = bench.readAll();
        QVERIFY(bench.opened(path));
        QCOMPARE(bench.shown(), QStringList());
        QCOMPARE(bench.find<QLabel>("snapshotSummary")->text(), QStringLiteral("No differences."));
        QVERIFY(!bench.restoreButton()->isEnabled());

        QVERIFY(bench.change(kTwenty, 1)); // the table follows what others write
        QCOMPARE(sorted(bench.shown()), twenty());
        QVERIFY(bench.restoreButton()->isEnabled());
        const int steps = bench.edits.steps().count();
        bench.restoreButton()->click();
        QVERIFY(bench.quiet());
        QCOMPARE(bench.shown(), QStringList());
        QVERIFY(bench.readAll() == before);
        QCOMPARE(bench.edits.steps().count(), steps + 1); // one step that can be taken back
        QVERIFY(bench.edits.steps().undoText().contains(QStringLiteral("s.json")));
        QVERIFY(bench.find<QPlainTextEdit>("snapshotReport")
                    ->toPlainText()
                    .startsWith(QStringLiteral("20 register(s) written")));
        bench.edits.undo();
        QVERIFY(bench.quiet());
        QCOMPARE(sorted(bench.shown()), twenty());
    }

    void onlyWhatIsCheckedAndShownIsWritten()
    {
        PanelBench bench;
        const QString path = bench.home.filePath(QStringLiteral("s.json"));
        QVERIFY(bench.saved(path));
        QVERIFY(bench.change({"SPEED_KP", "SPEED_KI", "I_Q_KP", "I_D_KP"}, 5));
        QVERIFY(bench.opened(path));
        QCOMPARE(bench.shown().size(), 4);
        bench.find<QLineEdit>("snapshotSearch")->setText(QStringLiteral("speed loop"));
        QCOMPARE(sorted(bench.shown()),
            (QStringList{QStringLiteral("SPEED_KI"), QStringLiteral("SPEED_KP")}));
        const int row = int(bench.shown().indexOf(QStringLiteral("SPEED_KI")));
        bench.table()->setCurrentIndex(bench.table()->model()->index(row, 0));
        const widgets::ShortcutGuard guard; // as in the window, where Space is the scope's
        QAction hold(&bench.compared);
        hold.setShortcut(Qt::Key_Space);
        bench.compared.addAction(&hold);
        const QSignalSpy held(&hold, &QAction::triggered);
        bench.compared.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&bench.compared));
        bench.table()->setFocus();
        QTest::keyClick(bench.table(), Qt::Key_Space); // unchecks it
        QCOMPARE(held.size(), 0);
        QVERIFY(bench.restoreButton()->text().contains(QStringLiteral("1 register")));
        bench.restoreButton()->click();
        QVERIFY(bench.quiet());
        bench.find<QLineEdit>("snapshotSearch")->clear();
        QCOMPARE(sorted(bench.shown()),
            (QStringList{
                QStringLiteral("I_D_KP"), QStringLiteral("I_Q_KP"), QStringLiteral("SPEED_KI")}));
        // What was unchecked stays so when the board was read again.
        const int again = int(bench.shown().indexOf(QStringLiteral("SPEED_KI")));
        QCOMPARE(bench.table()->model()->index(again, 0).data(Qt::CheckStateRole).toInt(),
            int(Qt::Unchecked));
    }

    void nothingIsWrittenUnlessArmed()
    {
        PanelBench bench;
        const QString path = bench.home.filePath(QStringLiteral("s.json"));
        QVERIFY(bench.saved(path));
        QVERIFY(bench.change({"SPEED_KP"}, 5));
        QVERIFY(bench.opened(path));
        bench.device.setArmed(false);
        const std::size_t writes = bench.writes.size();
        QVERIFY(!bench.restoreButton()->isEnabled());
        QVERIFY(bench.restoreButton()->toolTip().contains(QStringLiteral("Arm")));
        QVERIFY(bench.find<QLabel>("snapshotSummary")->text().contains(QStringLiteral("Arm")));
        bench.compared.restore();
        QCOMPARE(bench.writes.size(), writes);
    }

    void anUnplugInTheMiddleOfARestoreNamesEachRegister()
    {
        simulation::BoardOptions options;
        options.rxMax = 32; // seven to a request
        PanelBench bench(options);
        const QString path = bench.home.filePath(QStringLiteral("s.json"));
        QVERIFY(bench.saved(path));
        QVERIFY(bench.change(kTwenty, 1));
        QVERIFY(bench.opened(path));
        int sets = 0;
        bench.link.loses = [&](const Bytes &bytes) {
            if (support::changesSomething(bytes) && bytes.size() > 8)
                ++sets;
            if (sets >= 2)
                bench.link.toBoard.cut = bench.link.toDrive.cut = true;
            return false;
        };
        bench.compared.restore();
        QVERIFY(bench.pump([&] { return !bench.edits.underWay(); }, 60s));
        const QString report = bench.find<QPlainTextEdit>("snapshotReport")->toPlainText();
        const auto part = [&](const char *from) {
            QStringList names;
            bool inside = false;
            for (const QString &line : report.split(QLatin1Char('\n'))) {
                if (inside && line.startsWith(QStringLiteral("    ")))
                    names.append(line.trimmed().section(QLatin1Char(':'), 0, 0));
                else
                    inside = line == QLatin1String(from);
            }
            return names;
        };
        const QStringList written = part("Written, not verified:"),
                          unknown = part("It is not known whether these were written:"),
                          not_ = part("Not written:");
        QCOMPARE(written.size(), 7);
        QVERIFY2(part("Written and read back:").isEmpty(), qPrintable(report)); // none was
        QVERIFY2(!unknown.isEmpty() && !not_.isEmpty(), qPrintable(report));
        QCOMPARE(sorted(written + unknown + not_), twenty());
        // The cable again: the table agrees with what was told.
        bench.link.loses = nullptr;
        bench.link.toBoard.cut = bench.link.toDrive.cut = false;
        QVERIFY(bench.pump([&] { return bench.device.answering(); }, 60s));
        bench.compared.readBoard();
        QVERIFY(bench.quiet());
        for (const QString &name : written)
            QVERIFY2(!bench.shown().contains(name), qPrintable(name));
        for (const QString &name : not_)
            QVERIFY2(bench.shown().contains(name), qPrintable(name));
    }

    void otherHardwareNeedsAYesOfItsOwn()
    {
        PanelBench bench;
        const QString path = bench.home.filePath(QStringLiteral("s.json"));
        QVERIFY(bench.saved(path));
        QVERIFY(bench.change({"SPEED_KP"}, 5));
        QByteArray text = *session::readWholeFile(path);
        QVERIFY(text.contains("Sim PMSM 24V"));
        text.replace("Sim PMSM 24V", "Another %1 one");
        QVERIFY(session::writeWholeFile(path, text).isEmpty());
        QVERIFY(bench.opened(path));
        QVERIFY(!bench.restoreButton()->isEnabled());
        auto *yes = bench.find<QCheckBox>("snapshotOtherHardware");
        QVERIFY(yes->isVisible());
        QVERIFY(yes->toolTip().contains(QStringLiteral("Another %1 one")));
        yes->setChecked(true);
        QVERIFY(bench.restoreButton()->isEnabled());
    }

    void whatMovesAMotorIsNeverOffered()
    {
        PanelBench bench;
        const QString path = bench.home.filePath(QStringLiteral("s.json"));
        QVERIFY(bench.saved(path));
        bench.answerYes = true;
        bench.type("SPEED_REF", QStringLiteral("600")); // the board takes it as a ramp
        QVERIFY(bench.apply());
        QVERIFY(bench.change({"SPEED_KP"}, 1));
        QVERIFY(bench.opened(path));
        const auto checkable = [&](const char *name) {
            const int row = int(bench.shown().indexOf(QLatin1String(name)));
            return row >= 0
                && bench.table()->model()->index(row, 0).data(Qt::CheckStateRole).isValid();
        };
        QVERIFY(checkable("SPEED_KP"));
        QVERIFY(!bench.shown().contains(QStringLiteral("SPEED_RAMP"))); // no parameter
        bench.find<QCheckBox>("snapshotAll")->setChecked(true);
        const auto row = bench.shown().indexOf(QStringLiteral("SPEED_RAMP"));
        QVERIFY(row >= 0);
        QVERIFY(!checkable("SPEED_RAMP"));
        const QModelIndex cell = bench.table()->model()->index(int(row), 0);
        QVERIFY(cell.data(Qt::ToolTipRole).toString().contains(QStringLiteral("moves a motor")));
        QVERIFY(checkable("SPEED_KP"));
    }

    void bothUnitSystemsAreShownAndCopied()
    {
        PanelBench bench;
        const QString path = bench.home.filePath(QStringLiteral("s.json"));
        QVERIFY(bench.saved(path));
        QVERIFY(bench.change({"SPEED_KP"}, 5));
        QVERIFY(bench.opened(path));
        const auto cell = [&](int column) {
            return bench.table()->model()->index(0, column).data().toString();
        };
        const auto now = std::get<std::int64_t>(bench.held("SPEED_KP"));
        QCOMPARE(cell(SnapshotModel::NameColumn), QStringLiteral("SPEED_KP"));
        QCOMPARE(cell(SnapshotModel::MotorColumn), QStringLiteral("1"));
        QCOMPARE(cell(SnapshotModel::ARawColumn), QString::number(now - 5));
        QCOMPARE(cell(SnapshotModel::BRawColumn), QString::number(now));
        QTest::keySequence(bench.table(), QKeySequence::Copy);
        const QStringList lines = QGuiApplication::clipboard()->text().split(QLatin1Char('\n'));
        QCOMPARE(lines.size(), 2);
        QVERIFY(lines[0].startsWith(QStringLiteral("Register\tMotor\tA\tB\tUnit")));
        QCOMPARE(lines[1].split(QLatin1Char('\t')).size(), SnapshotModel::BRawColumn + 1);
    }

    void aDamagedFileLeavesWhatWasThere()
    {
        PanelBench bench;
        const QString good = bench.home.filePath(QStringLiteral("good.json"));
        QVERIFY(bench.saved(good));
        QVERIFY(bench.change({"SPEED_KP"}, 5));
        QVERIFY(bench.opened(good));
        const QString bad = bench.home.filePath(QStringLiteral("bad.json"));
        QByteArray text = *session::readWholeFile(good);
        text.replace("\"name\":\"SPEED_KI\",\"raw\":", "\"name\":\"SPEED_KI\",\"raw\":7777");
        QVERIFY(session::writeWholeFile(bad, text).isEmpty());
        bench.compared.openFile(bad);
        const QString told = bench.find<QLabel>("snapshotTold")->text();
        QVERIFY2(told.contains(QStringLiteral("bad.json"))
                && told.contains(QStringLiteral("register SPEED_KI"))
                && told.contains(QStringLiteral("line ")),
            qPrintable(told));
        QCOMPARE(bench.shown(), QStringList{QStringLiteral("SPEED_KP")});
        QCOMPARE(bench.find<QComboBox>("snapshotA")->currentText(), QStringLiteral("good.json"));
        bench.compared.openFile(bench.home.filePath(QStringLiteral("none.json")));
        QVERIFY(bench.find<QLabel>("snapshotTold")->text().contains(QStringLiteral("none.json")));
        QCOMPARE(bench.shown(), QStringList{QStringLiteral("SPEED_KP")});
    }

    void twoFilesNeedNoBoard()
    {
        PanelBench bench;
        const QString a = bench.home.filePath(QStringLiteral("a.json")),
                      b = bench.home.filePath(QStringLiteral("b.json"));
        QVERIFY(bench.saved(a));
        QVERIFY(bench.change({"SPEED_KP", "SPEED_KI"}, 5));
        QVERIFY(bench.saved(b));
        facts::feed(
            bench.device, {drive::LinkChanged{drive::LinkState::Lost, drive::LinkReason::Silence}});
        bench.compared.openFile(a);
        bench.files.answer = b;
        bench.find<QPushButton>("snapshotBOpen")->click();
        QCOMPARE(bench.shown().size(), 2);
        QVERIFY(!bench.restoreButton()->isEnabled());
    }

    void whatWasKeptBeforeAWriteCanBeChosen()
    {
        PanelBench bench;
        const auto kp = std::get<std::int64_t>(bench.held("SPEED_KP"));
        QVERIFY(bench.change({"SPEED_KP", "SPEED_KI"}, 5));
        auto *box = bench.find<QComboBox>("snapshotA");
        const int kept = 1;
        QVERIFY(box->itemText(kept).startsWith(QStringLiteral("Before a write")));
        QVERIFY(QMetaObject::invokeMethod(box, "activated", Q_ARG(int, kept)));
        bench.compared.readBoard();
        QVERIFY(bench.quiet());
        QCOMPARE(bench.shown().size(), 2);
        bench.restoreButton()->click();
        QVERIFY(bench.quiet());
        QCOMPARE(std::get<std::int64_t>(bench.held("SPEED_KP")), kp);
    }

    void aCancelledReadingSavesNothing()
    {
        PanelBench bench;
        const QString path = bench.home.filePath(QStringLiteral("s.json"));
        bench.files.answer = path;
        SnapshotDialog dialog(
            SnapshotDialog::Form::Snapshot, bench.device, bench.files, {}, nullptr);
        dialog.open();
        const std::size_t before = bench.link.requests.size();
        QVERIFY(bench.pump([&] { return bench.link.requests.size() > before + 3; }));
        dialog.findChild<QPushButton *>(QStringLiteral("snapshotDialogCancel"))->click();
        QVERIFY(!dialog.isVisible());
        bench.link.runFor(5s);
        QVERIFY(!QFile::exists(path));
    }

    void aSavedSnapshotHasTheNameOfTheTime()
    {
        PanelBench bench;
        QVERIFY(bench.saved(bench.home.filePath(QStringLiteral("x.json"))));
        const QRegularExpression form(QRegularExpression::anchoredPattern(
            QStringLiteral(R"(\d{4}-\d\d-\d\d_\d\d-\d\d-\d\d_motor_snapshot\.json)")));
        QVERIFY(form.match(bench.files.asked.suggestedName).hasMatch());
    }

    void aPlaceThatTakesNoFileIsToldAndAnotherCanBeChosen()
    {
        PanelBench bench;
        bench.files.answer = QStringLiteral("/no/such/folder/s.json");
        SnapshotDialog dialog(
            SnapshotDialog::Form::Snapshot, bench.device, bench.files, {}, nullptr);
        dialog.open();
        const auto *summary = dialog.findChild<QLabel *>(QStringLiteral("snapshotDialogSummary"));
        QVERIFY(bench.pump(
            [&] { return summary->text().contains(QStringLiteral("was not written")); }));
        QVERIFY(dialog.isVisible());
        bench.files.answer = bench.home.filePath(QStringLiteral("s.json"));
        dialog.findChild<QPushButton *>(QStringLiteral("snapshotDialogSave"))->click();
        QVERIFY(QFile::exists(bench.files.answer));
        QVERIFY(!dialog.isVisible());
    }

    void theHeaderHasTheTunedValuesOfTheMotor()
    {
        PanelBench bench;
        bench.type("SPEED_KP", QStringLiteral("4321"));
        QVERIFY(bench.apply());
        const QString path = bench.home.filePath(QStringLiteral("d.h"));
        bench.files.answer = path;
        SnapshotDialog dialog(SnapshotDialog::Form::Header, bench.device, bench.files, {}, nullptr);
        dialog.open();
        QVERIFY(bench.pump([&] { return QFile::exists(path); }));
        const QByteArray text = *session::readWholeFile(path);
        QVERIFY(text.contains("PID_SPEED_KP_DEFAULT") && text.contains("4321/(SPEED_UNIT/10)"));
        QVERIFY(text.contains("PHASE1_FINAL_CURRENT_A")); // the board's scale of current is known
        QVERIFY(bench.files.asked.suggestedName.endsWith(QStringLiteral("_drive_parameters.h")));
    }

    void aFileThatIsDroppedOnTheWindowIsOpened()
    {
        facts::WindowRig rig;
        const QTemporaryDir home;
        const QString path = home.filePath(QStringLiteral("s.json"));
        QVERIFY(session::writeWholeFile(path, session::snapshotJson({})).isEmpty());
        const auto drop = [&](const QString &file) {
            QMimeData data;
            data.setUrls({QUrl::fromLocalFile(file)});
            QDragEnterEvent enter(
                QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
            enter.ignore();
            QCoreApplication::sendEvent(&rig.window, &enter);
            if (!enter.isAccepted())
                return false;
            QDropEvent dropped(
                QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
            QCoreApplication::sendEvent(&rig.window, &dropped);
            return true;
        };
        QVERIFY(!drop(home.filePath(QStringLiteral("s.png"))));
        QVERIFY(drop(path));
        auto *panel = rig.window.findChild<widgets::SnapshotPanel *>();
        QVERIFY(panel);
        QTRY_VERIFY(panel->isVisible());
        QCOMPARE(panel->findChild<QComboBox *>(QStringLiteral("snapshotA"))->currentText(),
            QStringLiteral("s.json"));
        QCOMPARE(rig.window.settings().snapshotFolder, home.path());
    }

    void theMenuOffersItOnceABoardAnswers()
    {
        facts::WindowRig rig;
        auto *save = rig.find<QAction>("saveSnapshot");
        QVERIFY(save != nullptr);
        QVERIFY(!save->isEnabled());
        QVERIFY(!save->toolTip().isEmpty());
        rig.workbench.device().open({});
        QTRY_VERIFY_WITH_TIMEOUT(save->isEnabled(), 10000);
        const QTemporaryDir home;
        rig.files.answer = home.filePath(QStringLiteral("s.json"));
        save->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(rig.files.answer), 20000);
        QVERIFY(session::readSnapshotJson(*session::readWholeFile(rig.files.answer)).has_value());
    }
};

QTEST_MAIN(TestSnapshotPanel)
#include "tst_snapshot_panel.moc"
