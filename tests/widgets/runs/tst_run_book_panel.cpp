// The run book through the real window: series of steps are kept by themselves, a run of before shows what differs from
// the board and brings it back, and runs lie behind what is live.
#include "session/files/run_book.h"
#include "support/judged_line.h"
#include "support/window_rig.h"
#include "widgets/lab/experiments.h"
#include "widgets/lab/live_gain.h"
#include "widgets/lab/step_runs.h"
#include "widgets/runs/book_model.h"
#include "widgets/scope/ghosts.h"
#include "widgets/scope/view.h"
#include "widgets/snapshots/model.h"

#include <QCheckBox>
#include <QDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTreeView>

using drive::MotorState;

namespace {

constexpr int kSeriesMs = 30'000;

struct Bench {
    QTemporaryDir folder;
    support::JudgedWorld world;
    facts::WindowRig rig;
    support::WindowActs acts;

    Bench()
        : world(board(), drive::Protocol::Mcp)
        , rig(settings(), session::makeDiskSink, world.parts())
        , acts(world, rig.window, rig.workbench.device())
    {
        rig.window.resize(1280, 720);
        QApplication::setActiveWindow(&rig.window);
    }
    ~Bench() { world.act(judge::Act::Kind::Leave); }

    static simulation::BoardOptions board()
    {
        simulation::BoardOptions options;
        options.motor = "servo24";
        return options;
    }
    static widgets::Settings settings()
    {
        widgets::Settings settings = facts::WindowRig::quietSettings();
        settings.port = QStringLiteral("/dev/ttyServo");
        settings.protocol = QStringLiteral("mcp");
        settings.samplesOnDiskGB = 0.0;
        return settings;
    }
    template <class T = QWidget>
    T *find(const char *name) const
    {
        return rig.find<T>(name);
    }
    void press(const char *name)
    {
        QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton);
        acts.noteArming();
    }
    void openBook()
    {
        QTest::keyClick(&rig.window, Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
    }
    void openSteps() { QTest::keyClick(&rig.window, Qt::Key_T, Qt::ControlModifier); }
    QTreeView *table() const { return find<QTreeView>("runBookTable"); }
    widgets::RunBookModel &model() const
    {
        return *static_cast<widgets::RunBookModel *>(table()->model());
    }
    QString cell(int row, int column) const { return model().index(row, column).data().toString(); }
    void choose(QList<int> rows) const
    {
        table()->clearSelection();
        for (const int row : rows)
            table()->selectionModel()->select(
                model().index(row, 0), QItemSelectionModel::Select | QItemSelectionModel::Rows);
    }
    bool begin()
    {
        rig.files.answer = folder.path();
        openBook();
        press("runBookChoose");
        openSteps();
        press("connect");
        if (!QTest::qWaitFor(
                [this] {
                    return rig.workbench.device().identified()
                        && rig.workbench.device().status(1).state == MotorState::Idle;
                },
                kSeriesMs))
            return false;
        auto *arm = find<QCheckBox>("arm");
        QTest::mouseClick(arm, Qt::LeftButton, {}, QPoint(8, arm->height() / 2));
        acts.noteArming();
        find<QLineEdit>("stepFrom")->setText(QStringLiteral("1000"));
        find<QLineEdit>("stepTo")->setText(QStringLiteral("1500"));
        find<QSpinBox>("stepHold")->setValue(200);
        find<QSpinBox>("stepApproach")->setValue(200);
        find<QSpinBox>("stepRepeat")->setValue(1);
        return QTest::qWaitFor(
            [this] { return find<QPushButton>("stepRun")->isEnabled(); }, kSeriesMs);
    }
    /// One series, until it is in its folder.
    bool run(int number)
    {
        press("stepRun");
        if (auto *dialog = find<QDialog>("experimentQuestion")) {
            QTest::mouseClick(dialog->findChild<QPushButton *>(QStringLiteral("experimentConfirm")),
                Qt::LeftButton);
            if (!QTest::qWaitFor(
                    [this] { return find<QDialog>("experimentQuestion") == nullptr; }, kSeriesMs))
                return false;
            QApplication::setActiveWindow(&rig.window);
        }
        const QString file =
            folder.filePath(QStringLiteral("run-%1.json").arg(number, 4, 10, QLatin1Char('0')));
        return QTest::qWaitFor(
            [&] {
                return QFile::exists(file) && !rig.workbench.experiments().running()
                    && find<QPushButton>("stepRun")->isEnabled();
            },
            kSeriesMs);
    }
    std::int64_t held(const char *name)
    {
        const auto id = rig.workbench.registers().idOf(name);
        const auto value = id ? rig.workbench.registers().known(*id) : std::nullopt;
        return value ? std::get<std::int64_t>(*value) : 0;
    }
};

} // namespace

class TestRunBookPanel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void withoutAFolderNothingIsKept()
    {
        Bench bench;
        bench.openBook();
        QVERIFY(bench.find("runBook")->isVisible());
        QVERIFY(
            bench.find<QLabel>("runBookFolder")->text().contains(QLatin1String("choose a folder")));
        for (const char *name : {"runBookRegisters", "runBookReference", "runBookOpen"})
            QVERIFY2(!bench.find<QPushButton>(name)->isEnabled(), name);
    }

    void aRunOfBeforeIsBroughtBack()
    {
        using Book = widgets::RunBookModel;
        Bench bench;
        QVERIFY(bench.begin());
        QVERIFY(bench.run(1));
        const std::int64_t before = bench.held("SPEED_KP");
        QVERIFY(before > 0);

        auto *kp = bench.rig.window.findChild<widgets::LiveGain *>();
        kp->setFocus();
        QTest::keyClick(kp, Qt::Key_PageDown);
        bench.acts.noteArming();
        QTRY_VERIFY(bench.held("SPEED_KP") < before);
        const std::int64_t after = bench.held("SPEED_KP");
        QVERIFY(bench.run(2));

        bench.openBook();
        QTRY_COMPARE(bench.model().rowCount(), 2); // the newest first
        QCOMPARE(bench.cell(1, Book::RunColumn), QStringLiteral("1"));
        QCOMPARE(bench.cell(1, Book::ExperimentColumn),
            QStringLiteral("Speed step 1000 \u2192 1500 rpm"));
        QVERIFY(bench.cell(1, Book::GainsColumn)
                    .startsWith(QString::number(before) + QStringLiteral(" / ")));
        QVERIFY(bench.cell(0, Book::GainsColumn)
                    .startsWith(QString::number(after) + QStringLiteral(" / ")));
        QVERIFY2(bench.cell(1, Book::ResultColumn).startsWith(QLatin1String("rise ")),
            qPrintable(bench.cell(1, Book::ResultColumn)));

        // What the file says is what the page showed.
        const auto *steps = bench.rig.window.findChild<widgets::StepRuns *>();
        const auto book = session::readRunBook(bench.folder.path());
        QVERIFY(book && book->runs.size() == 2U && book->problems.isEmpty());
        const QJsonObject mean = book->runs[0].result[QStringLiteral("mean")].toObject();
        QCOMPARE(mean[QStringLiteral("rise_s")].toObject()[QStringLiteral("value")].toDouble(),
            steps->results().front().series.rise_s->value);

        // Two runs that differ in one register show just that.
        bench.choose({0, 1});
        QCOMPARE(bench.find<QPushButton>("runBookRegisters")->text(),
            QStringLiteral("Compare registers"));
        bench.press("runBookRegisters");
        auto *differences = bench.rig.window.findChild<widgets::SnapshotModel *>();
        QTRY_COMPARE(differences->differing(), 1);
        QVERIFY(differences->index(0, widgets::SnapshotModel::NameColumn)
                    .data()
                    .toString()
                    .contains(QLatin1String("SPEED_KP")));

        // Back to the first, and read back.
        bench.openBook();
        bench.choose({1});
        bench.press("runBookRegisters");
        QTRY_VERIFY(bench.find<QPushButton>("snapshotRestore")->isEnabled());
        QCOMPARE(differences->differing(), 1);
        bench.press("snapshotRestore");
        QTRY_COMPARE(bench.held("SPEED_KP"), before);
        QTRY_COMPARE(differences->differing(), 0);

        // Both behind what is live.
        bench.openBook();
        bench.choose({0, 1});
        bench.press("runBookReference");
        widgets::ScopeGhosts &ghosts = bench.rig.window.scope()->ghosts();
        QTRY_VERIFY(ghosts.hasReference(widgets::Reference::A)
            && ghosts.hasReference(widgets::Reference::B));
        QVERIFY(bench.rig.workbench.device().answering());

        // A recording in which no gain was turned is one run.
        bench.rig.files.answer = session::recordingOf(bench.folder.path(), 1);
        bench.press("runBookAdd");
        QTRY_COMPARE(bench.model().rowCount(), 3);
        QVERIFY2(
            bench.cell(0, Book::ExperimentColumn).startsWith(QLatin1String("run-0001.pcapng, ")),
            qPrintable(bench.cell(0, Book::ExperimentColumn)));
        QCOMPARE(bench.cell(0, Book::ResultColumn), bench.cell(2, Book::ResultColumn));
    }

    void starsAndNotesAreKept()
    {
        using Book = widgets::RunBookModel;
        Bench bench;
        QVERIFY(bench.begin());
        QVERIFY(bench.run(1));
        bench.openBook();
        QTRY_COMPARE(bench.model().rowCount(), 1);
        QVERIFY(bench.model().setData(
            bench.model().index(0, Book::RunColumn), Qt::Checked, Qt::CheckStateRole));
        bench.table()->setCurrentIndex(bench.model().index(0, Book::TimeColumn));
        QTest::keyClick(bench.table(), Qt::Key_F2);
        auto *editor = bench.table()->findChild<QLineEdit *>();
        QVERIFY(editor);
        QTest::keyClicks(editor, QStringLiteral("the good one"));
        QTest::keyClick(editor, Qt::Key_Return);
        const auto kept = [&] { return session::readRunBook(bench.folder.path())->runs.front(); };
        QTRY_COMPARE(kept().note, QStringLiteral("the good one"));
        QVERIFY(kept().starred);
        QVERIFY(bench.cell(0, Book::RunColumn).contains(QChar(0x2605)));
        QCOMPARE(bench.rig.window.settings().runFolder, bench.folder.path());
    }

    void whatWasNotCarriedOutHasNoNumbers()
    {
        using Book = widgets::RunBookModel;
        session::Run run;
        run.experiment = QStringLiteral("step plan");
        run.end = QStringLiteral("refused");
        run.reason = QStringLiteral("the motor is not in speed control");
        const QJsonValue none(QJsonValue::Null);
        run.result = {{QStringLiteral("kind"), QStringLiteral("step")},
            {QStringLiteral("mean"),
                QJsonObject{{QStringLiteral("rise_s"), none},
                    {QStringLiteral("overshoot_pct"), none},
                    {QStringLiteral("settling_s"), none}}}};
        Book book;
        book.setRuns({run});
        QCOMPARE(book.index(0, Book::ResultColumn).data().toString(),
            QStringLiteral("Not carried out: the motor is not in speed control."));
        run.end = QStringLiteral("aborted"); // by a fault: no Stop was sent
        run.reason = QStringLiteral("the board reports a fault: OVER_CURR");
        book.setRuns({run});
        QCOMPARE(book.index(0, Book::ResultColumn).data().toString(),
            QStringLiteral("Ended: the board reports a fault: OVER_CURR."));
        run.end = QStringLiteral("complete");
        run.reason.clear();
        run.result = {
            {QStringLiteral("kind"), QStringLiteral("response")}, {QStringLiteral("ms"), none}};
        run.notes = {QStringLiteral("no margin is told")};
        book.setRuns({run});
        QCOMPARE(book.index(0, Book::ResultColumn).data().toString(),
            QStringLiteral("no margin is told"));
    }

    void gainsThatWereLentAreThoseOfTheRun()
    {
        using Book = widgets::RunBookModel;
        session::Run run;
        run.experiment = QStringLiteral("response plan");
        run.end = QStringLiteral("complete");
        run.gains = {{QStringLiteral("SPEED_KP"), 700}, {QStringLiteral("SPEED_KI"), 30}};
        run.plan = {{QStringLiteral("speed ki"), QStringLiteral("0")},
            {QStringLiteral("speed kp"), QStringLiteral("0")}};
        Book book;
        book.setRuns({run});
        QCOMPARE(book.index(0, Book::GainsColumn).data().toString(), QStringLiteral("700 / 30"));
        run.plan = {{QStringLiteral("speed ki"), QStringLiteral("7")},
            {QStringLiteral("speed kp"), QStringLiteral("175")}};
        book.setRuns({run});
        QCOMPARE(book.index(0, Book::GainsColumn).data().toString(), QStringLiteral("175 / 7"));
    }

    void whatWasStoppedIsKeptAsThat()
    {
        Bench bench;
        QVERIFY(bench.begin());
        bench.press("stepRun");
        QTest::mouseClick(bench.find<QDialog>("experimentQuestion")
                              ->findChild<QPushButton *>(QStringLiteral("experimentConfirm")),
            Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(
            bench.rig.workbench.device().status(1).state == MotorState::Running, kSeriesMs);
        QTest::keyClick(&bench.rig.window, Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(
            QFile::exists(bench.folder.filePath(QStringLiteral("run-0001.json"))), kSeriesMs);
        const auto book = session::readRunBook(bench.folder.path());
        QVERIFY(book && book->problems.isEmpty());
        const session::Run &run = book->runs.front();
        QCOMPARE(run.end, QStringLiteral("interrupted"));
        QVERIFY(!run.reason.isEmpty());
        QVERIFY(run.registers && run.gains.contains(QStringLiteral("SPEED_KP")));
        bench.openBook();
        QTRY_COMPARE(bench.model().rowCount(), 1);
        QVERIFY(bench.cell(0, widgets::RunBookModel::ResultColumn)
                    .startsWith(QLatin1String("Interrupted: ")));

        // However long it is: which run it is stays in view, until its note is written.
        QTreeView *table = bench.table();
        table->header()->resizeSection(widgets::RunBookModel::ResultColumn, 4000);
        table->setCurrentIndex(bench.model().index(0, widgets::RunBookModel::ResultColumn));
        QCOMPARE(table->horizontalScrollBar()->value(), 0);
        QTest::keyClick(table, Qt::Key_F2);
        QVERIFY(table->horizontalScrollBar()->value() > 0);
    }
};

QTEST_MAIN(TestRunBookPanel)
#include "tst_run_book_panel.moc"
