// The motion log in the window: every act of the session is a row, it can be copied and saved, and it goes with each
// export.
#include "support/scope_window.h"
#include "widgets/control/motion_log_model.h"
#include "widgets/control/motion_log_panel.h"
#include "widgets/files/export_dialog.h"
#include "widgets/files/job.h"
#include "widgets/scope/signals/selection.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>

using widgets::MotionLogModel;
using namespace std::chrono_literals;

namespace {

drive::MotionEntry ramp()
{
    drive::MotionEntry entry;
    entry.act = drive::MotionAct::SpeedRamp;
    entry.motor = 1;
    entry.detail = "1200 rpm in 500 ms";
    entry.asked = TimePoint(10s);
    entry.ended = TimePoint(10s + 250ms);
    entry.requests = 1;
    entry.sent = {{0x08, 0x00, 0xA9}};
    return entry;
}

} // namespace

class TestMotionLog : public QObject {
    Q_OBJECT

    static void exportTo(facts::ScopeWindow &rig, const QString &path)
    {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // a dialog of before
        rig.files.answer = path;
        rig.window.findChild<widgets::Exporting *>()->ask();
        QTest::mouseClick(rig.find<QPushButton>("exportSave"), Qt::LeftButton);
        QTRY_VERIFY(!rig.window.findChild<widgets::FileJob *>());
    }
    static QByteArray contentOf(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void recordsBecomeRowsAndStay()
    {
        MotionLogModel model;
        QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const QDateTime now(QDate(2026, 5, 4), QTime(13, 2, 59, 500), Qt::UTC);
        model.accept(ramp(), now);
        drive::MotionEntry stop;
        stop.act = drive::MotionAct::Stop;
        stop.stop = drive::StopWord::NotConfirmed;
        model.accept(stop, now);
        QCOMPARE(model.rowCount(), 2);
        const auto cell = [&](int row, int column) {
            return model.index(row, column).data().toString();
        };
        QCOMPARE(cell(0, MotionLogModel::MotorColumn), QStringLiteral("1"));
        QVERIFY(cell(0, MotionLogModel::DetailColumn).contains(QStringLiteral("1200 rpm")));
        QCOMPARE(cell(0, MotionLogModel::BytesColumn), QStringLiteral("08 00 A9"));
        QVERIFY(cell(1, MotionLogModel::OutcomeColumn).contains(QStringLiteral("not confirmed")));
        QCOMPARE(model.log()[0].asked, now.addMSecs(-250)); // when it was asked, not when it ended
        const QByteArrayList lines = model.text().trimmed().split('\n');
        QCOMPARE(lines.size(), 3);
        QVERIFY(lines[1].startsWith("1,2026-05-04T13:02:59.250Z,"));
        QVERIFY(lines[2].contains("NOT confirmed"));
    }

    void ofVeryManyActsTheNewestAreHeld()
    {
        MotionLogModel model;
        const QDateTime now(QDate(2026, 5, 4), QTime(13, 2, 59, 500), Qt::UTC);
        for (std::size_t i = 0; i < MotionLogModel::kMost; ++i)
            model.accept(ramp(), now);
        facts::AnsweredPrompt files;
        widgets::MotionLogPanel panel(model, files);
        const auto *leftOut = panel.findChild<QLabel *>(QStringLiteral("motionLogLeftOut"));
        QVERIFY(leftOut->isHidden());
        QCOMPARE(model.leftOut(), std::size_t{0});
        drive::MotionEntry last = ramp();
        last.detail = "1300 rpm in 500 ms";
        model.accept(last, now);
        QCOMPARE(model.leftOut(), MotionLogModel::kLeftOutAtOnce);
        QCOMPARE(model.rowCount(), int(MotionLogModel::kMost - MotionLogModel::kLeftOutAtOnce) + 1);
        QVERIFY(model.index(model.rowCount() - 1, MotionLogModel::DetailColumn)
                    .data()
                    .toString()
                    .contains(QStringLiteral("1300 rpm")));
        QVERIFY(!leftOut->isHidden());
        QVERIFY(leftOut->text().startsWith(QStringLiteral("1000 earlier acts")));
        const QByteArrayList lines = model.text().trimmed().split('\n');
        QCOMPARE(lines[1], QByteArray(",,,,,,1000 earlier acts are left out,,,,"));
        QCOMPARE(lines[1].count(','), lines[0].count(','));
        QVERIFY(lines[2].startsWith("1001,"));
        QVERIFY(lines.last().startsWith("100001,") && lines.last().contains("1300 rpm"));
    }

    /// What became of a Stop is noted more or less late, and never before the Stop.
    void whatBecameOfAStopIsToldWhenItWasSeen()
    {
        MotionLogModel model;
        const QDateTime now(QDate(2026, 5, 4), QTime(13, 2, 59, 500), Qt::UTC);
        const auto take = [&](drive::StopWord word, TimePoint ended, int notedMs) {
            drive::MotionEntry entry;
            entry.act = drive::MotionAct::Stop;
            entry.stop = word;
            entry.asked = TimePoint(10s);
            entry.ended = ended;
            model.accept(entry, now.addMSecs(notedMs));
        };
        take(drive::StopWord::Requested, TimePoint(10s), 20); // the window heard of it so late
        take(drive::StopWord::Accepted, TimePoint(10s + 9ms), 12);
        take(drive::StopWord::DriveIdle, TimePoint(10s + 450ms), 480);
        const auto time = [&](int row) {
            return QTime::fromString(model.index(row, MotionLogModel::TimeColumn).data().toString(),
                QStringLiteral("HH:mm:ss.zzz"));
        };
        QCOMPARE(time(0).msecsTo(time(1)), 9);
        QCOMPARE(time(0).msecsTo(time(2)), 450);
    }

    void theFilesNameGoesWithTheCaptures()
    {
        QCOMPARE(session::motionLogPath(QStringLiteral("/a/run.csv")),
            QStringLiteral("/a/run.motion.csv"));
        QCOMPARE(session::motionLogPath(QStringLiteral("/a/run.2.CSV")),
            QStringLiteral("/a/run.2.motion.csv"));
        QCOMPARE(session::motionLogPath(QStringLiteral("/a.b/run")),
            QStringLiteral("/a.b/run.motion.csv"));
    }

    void aNewConnectionGoesOnWithTheLog()
    {
        facts::WindowRig rig;
        facts::feed(rig.workbench.device(), {ramp()});
        QCOMPARE(rig.workbench.motionLog().rowCount(), 1);
        rig.workbench.device().portChanged(session::PortState::Closed, {});
        rig.workbench.device().open({});
        facts::feed(rig.workbench.device(), {ramp()});
        // What was recorded before is still there, too.
        QCOMPARE(rig.workbench.motionLog().rowCount(), 2);
    }

    void itCanBeCopiedAndSaved()
    {
        facts::WindowRig rig;
        QVERIFY(!rig.find<QToolButton>("motionLogSave")->isEnabled());
        facts::feed(rig.workbench.device(), {ramp(), ramp()});
        rig.find<QToolButton>("motionLogCopy")->click();
        QCOMPARE(QGuiApplication::clipboard()->text().count(QLatin1Char('\n')), 1);
        QTemporaryDir folder;
        rig.files.answer = folder.filePath(QStringLiteral("log.csv"));
        rig.find<QToolButton>("motionLogSave")->click();
        QFile file(rig.files.answer);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), rig.workbench.motionLog().text());
        QVERIFY(rig.find<QLabel>("bannerText")->text().contains(QStringLiteral("log.csv")));

        rig.workbench.device().portChanged(session::PortState::Closed, {});
        rig.workbench.device().portChanged(session::PortState::Open, {});
        QVERIFY(!rig.find<QLabel>("bannerText")->text().contains(QStringLiteral("log.csv")));

        rig.files.answer = folder.filePath(QStringLiteral("missing/log.csv"));
        rig.find<QToolButton>("motionLogSave")->click();
        QVERIFY(
            rig.find<QLabel>("bannerText")->text().contains(QStringLiteral("cannot be written")));
    }

    void itGoesBesideEachExport()
    {
        facts::ScopeWindow rig;
        rig.record(100, [](int, int tick) { return tick; });
        QTemporaryDir folder;
        const QString beside = folder.filePath(QStringLiteral("run.motion.csv"));
        exportTo(rig, folder.filePath(QStringLiteral("run.csv")));
        QVERIFY(!QFile::exists(beside)); // nothing was asked of a motor
        for (int acts = 1; acts <= 2; ++acts) { // who replaces the capture replaces its log
            facts::feed(rig.workbench.device(), {ramp()});
            exportTo(rig, folder.filePath(QStringLiteral("run.csv")));
            QCOMPARE(contentOf(beside), rig.workbench.motionLog().text());
            QCOMPARE(rig.workbench.motionLog().rowCount(), acts);
            QVERIFY(
                rig.find<QLabel>("bannerText")->text().contains(QStringLiteral("run.motion.csv")));
        }
    }

    void aFilesExportHasNoneOfThisSession()
    {
        facts::ScopeWindow rig;
        facts::feed(rig.workbench.device(), {ramp()});
        capture::Capture file;
        file.appendPolled(9, "TEMPERATURE", "\u00b0C", 0.1, 20.0);
        rig.window.selection()->showFile(std::move(file));
        QTemporaryDir folder;
        exportTo(rig, folder.filePath(QStringLiteral("run.csv")));
        QVERIFY(QFile::exists(folder.filePath(QStringLiteral("run.csv"))));
        QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("run.motion.csv"))));
    }

    void anothersLogIsNotReplaced()
    {
        facts::ScopeWindow rig;
        rig.record(100, [](int, int tick) { return tick; });
        facts::feed(rig.workbench.device(), {ramp()});
        QTemporaryDir folder;
        const QString beside = folder.filePath(QStringLiteral("run.motion.csv"));
        QFile kept(beside);
        QVERIFY(kept.open(QIODevice::WriteOnly));
        kept.write("kept");
        kept.close();
        exportTo(rig, folder.filePath(QStringLiteral("run.csv")));
        QCOMPARE(contentOf(beside), QByteArray("kept"));
        QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("run.csv"))));
        QVERIFY(
            rig.find<QLabel>("exportSummary")->text().startsWith(QStringLiteral("run.motion.csv")));
    }

    void theDockIsThereAndHidden()
    {
        facts::WindowRig rig;
        auto *dock = rig.find<QWidget>("motionLogDock");
        QVERIFY(dock && !dock->isVisible());
    }
};

QTEST_MAIN(TestMotionLog)
#include "tst_motion_log.moc"
