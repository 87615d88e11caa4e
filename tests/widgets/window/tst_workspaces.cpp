// The working place survives: saved, opened before and behind a connection, taken up at the next start; and what is
// wrong with a file changes nothing.
#include "session/files/whole_file.h"
#include "support/judged_line.h"
#include "support/window_rig.h"
#include "widgets/measuring/measure_panel.h"
#include "widgets/scope/ghosts.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/trigger/control.h"
#include "widgets/scope/view.h"

#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryDir>

#include <array>
#include <cmath>

using widgets::NamedSignal;
using widgets::Workspace;

namespace {

/// A window on a simulated board of its own.
struct WorkspaceBench {
    support::JudgedWorld world{simulation::BoardOptions(), drive::Protocol::Mcp};
    facts::WindowRig rig;

    explicit WorkspaceBench(const Workspace &workspace = {})
        : rig(settingsWith(workspace), session::makeDiskSink, world.parts())
    {
        rig.window.resize(1280, 720);
    }
    static widgets::Settings settingsWith(const Workspace &workspace)
    {
        widgets::Settings settings = facts::WindowRig::quietSettings();
        settings.port = QStringLiteral("/dev/ttyTest");
        settings.protocol = QStringLiteral("mcp");
        settings.workspace = workspace;
        return settings;
    }
    void connectBoard()
    {
        world.act(judge::Act::Kind::Input);
        rig.find<QPushButton>("connect")->click();
        QTRY_VERIFY_WITH_TIMEOUT(rig.workbench.device().answering(), 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(!rig.window.scope()->channels().isEmpty(), 20'000);
    }
    QAction *fileAction(const char *text) const
    {
        for (QMenu *menu : rig.window.findChildren<QMenu *>())
            for (QAction *action : menu->actions())
                if (action->text().remove(QLatin1Char('&')).startsWith(QLatin1String(text)))
                    return action;
        return nullptr;
    }
    QStringList shown() const
    {
        QStringList names;
        for (const capture::ChannelId id : rig.window.scope()->channels())
            names.append(rig.window.scope()->nameOf(id));
        return names;
    }
};

Workspace ofABench()
{
    Workspace workspace;
    workspace.signalList = {{"I_A", widgets::Route::Fast, 0},
        {"BUS_VOLTAGE", widgets::Route::Polled, 1}, {"I_Q_MEAS", widgets::Route::Slow, 0}};
    workspace.fastEvery = 4;
    workspace.span = 2.5;
    workspace.axes = {{QStringLiteral("I_A"), {-3.0, 3.5}}};
    workspace.trigger.type = widgets::TriggerType::Level;
    workspace.trigger.level = 0.25;
    workspace.trigger.mode = scope::Mode::Normal;
    workspace.trigger.length = 0.5;
    workspace.trigger.written = QStringLiteral("SPEED_KI");
    workspace.triggerSource = QStringLiteral("I_Q_MEAS");
    workspace.measures = {{QStringLiteral("I_A"), scope::Quantity::Overshoot, {}},
        {QStringLiteral("I_A"), scope::Quantity::Phase, QStringLiteral("I_Q_MEAS")}};
    workspace.formulas = {{QStringLiteral("M1"), QStringLiteral("I_A + 1"), false}};
    workspace.traceColors = {{QStringLiteral("I_A"), 4}};
    workspace.notes = QStringLiteral("spindle 3, 24 V");
    return workspace;
}

/// The lines in which they differ; not where docks are, which is Qt's.
QByteArray difference(Workspace one, Workspace other)
{
    one.layout.clear();
    other.layout.clear();
    const QList<QByteArray> first = widgets::toJson(one).split('\n'),
                            second = widgets::toJson(other).split('\n');
    QByteArray lines;
    for (qsizetype i = 0; i < std::max(first.size(), second.size()); ++i)
        if (first.value(i) != second.value(i))
            lines += first.value(i) + " |" + second.value(i) + '\n';
    return lines;
}

} // namespace

class TestWorkspaces : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void whatIsWrittenIsRead()
    {
        Workspace workspace = ofABench();
        workspace.layout = QByteArray("\x00\xff\x10", 3);
        const auto read = widgets::readWorkspace(widgets::toJson(workspace));
        QVERIFY(read.has_value());
        QVERIFY(*read == workspace);
        QVERIFY(*widgets::readWorkspace(widgets::toJson(Workspace())) == Workspace());
    }

    void whatIsNoWorkspaceIsNamed_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<QString>("says");
        QTest::newRow("cut") << QByteArray("{\n\"rotorscopeWorkspace\": 1,\n") << "Line 3";
        QTest::newRow("other") << QByteArray("{\"version\": 1}") << "no workspace";
        QTest::newRow("later") << QByteArray("{\"rotorscopeWorkspace\": 2}") << "later version";
        QTest::newRow("empty") << QByteArray() << "Line 1";
        QTest::newRow("a number") << QByteArray("{\"rotorscopeWorkspace\": 1, \"span_s\": -1}")
                                  << "span_s";
        QTest::newRow("a word") << QByteArray(
            "{\"rotorscopeWorkspace\": 1, \"trigger\": {\"type\": \"egde\"}}")
                                << "trigger.type";
        QTest::newRow("upside down")
            << QByteArray("{\"rotorscopeWorkspace\": 1, \"axes\": [{\"signal\": \"A\", "
                          "\"from\": 2, \"to\": 2}]}")
            << "axes";
        QTest::newRow("in a list")
            << QByteArray("{\"rotorscopeWorkspace\": 1, \"signals\": [{\"name\": \"A\", "
                          "\"route\": \"slow\"}, {\"name\": \"B\", \"route\": 7}]}")
            << "signals.2.route";
    }
    void whatIsNoWorkspaceIsNamed()
    {
        QFETCH(QByteArray, json);
        QFETCH(QString, says);
        const auto read = widgets::readWorkspace(json);
        QVERIFY(!read.has_value());
        QVERIFY2(read.error().contains(says), qPrintable(read.error()));
    }

    void whatIsMissingOrNotKnownDoesNoHarm()
    {
        const auto read = widgets::readWorkspace(
            "{\"rotorscopeWorkspace\": 1, \"span_s\": 2, \"of a later version\": 1}");
        QVERIFY2(read.has_value(), read ? "" : qPrintable(read.error()));
        QCOMPARE(read->span, 2.0);
    }

    void itIsTakenUpAtTheNextStart()
    {
        WorkspaceBench bench(ofABench());
        // No board yet.
        QCOMPARE(difference(bench.rig.window.settings().workspace, ofABench()), QByteArray());
        bench.connectBoard();
        QTRY_COMPARE(bench.shown().size(), 3);
        QVERIFY(bench.shown().contains(QStringLiteral("BUS_VOLTAGE")));
        const auto &wanted = bench.rig.workbench.signalPlan().wanted();
        QVERIFY(
            wanted[1].route == widgets::Route::Polled && wanted[2].route == widgets::Route::Slow);
        QCOMPARE(bench.rig.workbench.signalPlan().fastEvery(), 4U);
        const widgets::Trigger &trigger = bench.rig.workbench.trigger();
        QTRY_VERIFY(trigger.source() && trigger.source()->name == "I_Q_MEAS");
        QVERIFY(trigger.setup() == ofABench().trigger);
        QCOMPARE(bench.rig.find<QPlainTextEdit>("notes")->toPlainText(), ofABench().notes);
        QCOMPARE(difference(bench.rig.window.settings().workspace, ofABench()), QByteArray());
    }

    void axesSetByHandAreKeptAndOthersFitThemselves()
    {
        WorkspaceBench bench(ofABench());
        bench.connectBoard();
        QTRY_COMPARE(bench.shown().size(), 3);
        const widgets::ScopeView &scope = *bench.rig.window.scope();
        const auto rangeOf = [&](const char *name) {
            for (const capture::ChannelId id : scope.channels())
                if (scope.nameOf(id) == QLatin1String(name))
                    return scope.valueRangeOf(id);
            return widgets::ValueRange();
        };
        QTRY_VERIFY(rangeOf("BUS_VOLTAGE").from > 10.0); // it has been drawn, and fits 23 V
        const widgets::ValueRange held{-3.0, 3.5};
        QVERIFY(rangeOf("I_A") == held);
        QVERIFY(rangeOf("I_Q_MEAS") == held); // on the same axis
        QVERIFY((scope.heldRanges()
            == QMap<QString, widgets::ValueRange>{{QStringLiteral("I_A"), held}}));

        Workspace free = ofABench();
        free.axes.clear();
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("free.workspace"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(widgets::toJson(free));
        file.close();
        bench.rig.files.answer = path;
        bench.fileAction("Open a workspace")->trigger();
        QVERIFY(scope.heldRanges().isEmpty());
        QTRY_VERIFY(rangeOf("I_A") != held);
    }

    void aFileBringsItBack()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.workspace"));
        WorkspaceBench first(ofABench());
        first.connectBoard();
        QTRY_COMPARE(first.shown().size(), 3);
        first.rig.files.answer = path;
        first.fileAction("Save the workspace")->trigger();
        QVERIFY(QFileInfo::exists(path));

        WorkspaceBench second; // which is connected, and shows something else
        second.connectBoard();
        QTRY_COMPARE(second.shown().size(), 4);
        second.rig.files.answer = path;
        second.fileAction("Open a workspace")->trigger();
        QTRY_COMPARE(second.shown().size(), 3);
        QTRY_COMPARE(difference(second.rig.window.settings().workspace, ofABench()), QByteArray());
        QCOMPARE(second.rig.window.settings().recentFiles, QStringList{path});
        auto *recent = second.rig.find<QMenu>("recentFiles");
        Q_EMIT recent->aboutToShow();
        QCOMPARE(recent->actions().size(), 1);
        QVERIFY(recent->actions().front()->text().contains(QStringLiteral("a.workspace")));
    }

    /// With their gaps, to the digit, at the same place from zero.
    void aReferenceIsWrittenAndRead()
    {
        capture::Capture capture;
        const capture::ChannelId id = capture.addImported("I_Q_MEAS", "A");
        constexpr capture::Nanos kStep = 62'500;
        for (int i = 0; i < 3000; ++i) {
            if (i == 1000)
                capture.breakImported(id);
            const capture::Nanos time = 7'000'000'000 + (i < 1000 ? i : i + 500) * kStep;
            capture.appendImported(id, time, 0.1 * std::sin(0.01 * i), time + kStep);
        }
        const capture::Snapshot all = capture.snapshot(std::array{id});
        Workspace workspace;
        workspace.references = {{widgets::Reference::B, true, QStringLiteral("a step"),
            widgets::keptTraces(all, {7.01, 7.2}, 7.1, widgets::kMostReferenceSamples)}};
        const auto read = widgets::readWorkspace(widgets::toJson(workspace));
        QVERIFY(read.has_value());
        QVERIFY(*read == workspace);
        const capture::Snapshot back = widgets::snapshotOf(read->references.front().traces);
        const capture::Channel &was = all->front(), &is = back->front();
        QCOMPARE(is.info().name, std::string("I_Q_MEAS"));
        QCOMPARE(is.info().registerId, was.info().registerId);
        QCOMPARE(is.size(), was.countIn(7.01, 7.2));
        for (capture::Index i = is.begin(); i < is.end(); ++i) {
            const capture::Nanos time = is.timeOf(i) + 7'100'000'000;
            QVERIFY(was.valueAt(time) == is.at(i));
        }
        QCOMPARE(is.gaps(-1.0, 1.0, 1e-3).size(), std::size_t(1));
        QCOMPARE(is.gaps(-1.0, 1.0, 1e-3).front().from, -0.1 + 1000 * 62.5e-6);
        QVERIFY(widgets::keptTraces(all, {7.0, 8.0}, 7.0, 2999).empty()); // there are 3000
    }

    void whatIsNoReferenceIsNamed_data()
    {
        QTest::addColumn<QByteArray>("samples");
        QTest::newRow("no samples") << QByteArray();
        QTest::newRow("not packed") << QByteArray("nonsense");
        QTest::newRow("4 GB, it says") << QByteArray("\xff\xff\xff\xffnonsense", 12);
        QTest::newRow("cut") << qCompress(QByteArray("\0\0\0\1\0\0", 6));
        QTest::newRow("four milliards") << qCompress(QByteArray(40, '\xff'));
        QByteArray longer = qCompress(QByteArray("\0\0\0\1", 4) + QByteArray(24, '\0'));
        longer[3] = 27; // and is 28
        QTest::newRow("longer than it says") << longer;
        QTest::newRow("none in a stretch") << qCompress(QByteArray(40, '\0'));
    }
    void whatIsNoReferenceIsNamed()
    {
        QFETCH(QByteArray, samples);
        Workspace workspace;
        workspace.references = {{widgets::Reference::A, false, {},
            {{1, QStringLiteral("I_A"), QStringLiteral("A"), samples, 1}}}};
        const auto read = widgets::readWorkspace(widgets::toJson(workspace));
        QVERIFY(!read.has_value());
        QVERIFY2(
            read.error().contains(QStringLiteral("references.1.traces")), qPrintable(read.error()));
    }

    void referencesAreThereAtTheNextStart()
    {
        Workspace kept;
        {
            WorkspaceBench first;
            first.connectBoard();
            widgets::ScopeGhosts &ghosts = first.rig.window.scope()->ghosts();
            QVERIFY(first.rig.window.settings().workspace.references.empty());
            const capture::Capture &capture = first.rig.workbench.capture();
            QTRY_VERIFY(
                capture.timeSpan() && capture.timeSpan()->to - capture.timeSpan()->from > 0.3);
            ghosts.keep(widgets::Reference::A);
            kept = first.rig.window.settings().workspace;
            QCOMPARE(kept.references.size(), std::size_t(1));
            QVERIFY(kept.references.front().traces.size() >= 2);
        }
        WorkspaceBench second(kept);
        const widgets::ScopeGhosts &ghosts = second.rig.window.scope()->ghosts();
        QVERIFY(ghosts.hasReference(widgets::Reference::A));
        QVERIFY(!ghosts.hasReference(widgets::Reference::B));
        QVERIFY(second.rig.window.settings().workspace.references == kept.references);
        second.connectBoard();
        QVERIFY(second.rig.window.settings().workspace.references == kept.references);

        // one without any takes none away
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("without.workspace"));
        QVERIFY(session::writeWholeFile(path, widgets::toJson(ofABench())).isEmpty());
        second.rig.files.answer = path;
        second.fileAction("Open a workspace")->trigger();
        QVERIFY(ghosts.hasReference(widgets::Reference::A));
    }

    void notesThatAreInNoFileAreAskedAbout()
    {
        QTemporaryDir folder;
        Workspace other = ofABench();
        other.notes = QStringLiteral("another bench");
        const QString path = folder.filePath(QStringLiteral("other.workspace")),
                      first = folder.filePath(QStringLiteral("first.workspace"));
        QVERIFY(session::writeWholeFile(path, widgets::toJson(other)).isEmpty());
        QVERIFY(session::writeWholeFile(first, widgets::toJson(ofABench())).isEmpty());
        WorkspaceBench bench(ofABench());
        const auto notes = [&] { return bench.rig.window.settings().workspace.notes; };
        const auto question = [&] { return bench.rig.find<QMessageBox>("notesQuestion"); };
        const auto open = [&](const QString &file) {
            bench.rig.files.answer = file;
            bench.fileAction("Open a workspace")->trigger();
        };
        open(path);
        QVERIFY(question());
        QTest::keyClick(question(), Qt::Key_Return); // neither Enter nor Esc throws them away
        QTRY_VERIFY(!question());
        QCOMPARE(notes(), ofABench().notes);
        QVERIFY(bench.rig.window.settings().recentFiles.isEmpty());
        open(path);
        bench.rig.find<QPushButton>("keepNotes")->click();
        QTRY_VERIFY(!question());
        QCOMPARE(notes(), ofABench().notes);
        QCOMPARE(bench.rig.window.settings().recentFiles, QStringList{path});
        open(path);
        QVERIFY(question()); // they are still in no file
        bench.rig.find<QPushButton>("replaceNotes")->click();
        QTRY_VERIFY(!question());
        QCOMPARE(notes(), other.notes);
        open(first); // which the file before has
        QVERIFY(!question());
        QCOMPARE(notes(), ofABench().notes);
    }

    void aDamagedFileChangesNothing()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.workspace"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(widgets::toJson(Workspace()).chopped(20));
        file.close();
        WorkspaceBench bench(ofABench());
        const Workspace before = bench.rig.window.settings().workspace;
        bench.rig.files.answer = path;
        bench.fileAction("Open a workspace")->trigger();
        QVERIFY(bench.rig.window.settings().workspace == before);
        auto *banner = bench.rig.find<QLabel>("bannerText");
        QVERIFY(banner && banner->text().contains(QStringLiteral("JSON")));
    }

    void aBoardWithoutItsSignalsSaysSo()
    {
        Workspace workspace;
        workspace.signalList = {{"NEVER_HEARD_OF", widgets::Route::Fast, 0}};
        WorkspaceBench bench(workspace);
        QStringList noticed;
        connect(&bench.rig.workbench.signalPlan(), &widgets::SignalPlan::noticed, this,
            [&](const QString &sentence) { noticed.append(sentence); });
        bench.connectBoard();
        QVERIFY(!noticed.isEmpty());
        QVERIFY(noticed.first().contains(QStringLiteral("NEVER_HEARD_OF")));
        QTRY_COMPARE(bench.shown().size(), 4); // those of a first look
    }

    void readyArrangementsOpenTheirTools()
    {
        WorkspaceBench bench;
        auto *gains = bench.rig.find<QDockWidget>("gainsDock");
        auto *measures = bench.rig.find<QDockWidget>("measureDock");
        auto *revUp = bench.rig.find<QDockWidget>("revUpDock");
        bench.fileAction("Tuning")->trigger();
        QTRY_VERIFY(!gains->visibleRegion().isEmpty());
        QVERIFY(measures->visibleRegion().isEmpty()); // a tab behind: there is no room beside it
        QVERIFY(!measures->isHidden());
        bench.rig.window.resize(1920, 1080);
        bench.fileAction("Tuning")->trigger();
        QVERIFY(gains->isVisible() && measures->isVisible() && revUp->isHidden());
        QTRY_VERIFY(measures->geometry().left() > gains->geometry().right()); // side by side
        QTRY_VERIFY(!gains->visibleRegion().isEmpty() && !measures->visibleRegion().isEmpty());
        bench.fileAction("Start-up")->trigger();
        QVERIFY(gains->isHidden() && measures->isHidden() && revUp->isVisible());
        QVERIFY(bench.rig.workbench.trigger().setup().type == widgets::TriggerType::StateChange);
        QCOMPARE(bench.rig.workbench.trigger().setup().length, 3.0);
        bench.fileAction("Recording")->trigger();
        QVERIFY(bench.rig.find<QDockWidget>("notesDock")->isVisible());
        QCOMPARE(bench.rig.window.scope()->visibleRange().span(), 20.0);
    }
};

QTEST_MAIN(TestWorkspaces)
#include "tst_workspaces.moc"
