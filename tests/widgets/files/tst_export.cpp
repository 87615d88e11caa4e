// Export and import through the real window: every format, every range, read back; and work that takes long.
#include "capture/csv_export.h"
#include "capture/csv_import.h"
#include "support/scope_window.h"
#include "widgets/base/banner.h"
#include "widgets/base/look/theme.h"
#include "widgets/files/export_order.h"
#include "widgets/files/job.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/view.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QLabel>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QThread>

#include <qcustomplot.h>

#include <algorithm>
#include <atomic>
#include <cmath>

using namespace capture;
using widgets::Banner;

namespace {

constexpr double kTick = 1.0 / 16000.0;

/// Two fast signals with a gap at [1.0 s, 1.1 s), and a slow one.
Capture recording()
{
    Capture capture;
    capture.begin(
        {1, 16000.0, 0.0, 1, {{1, "I_A", "A", 0.00123, 0.0}, {2, "I_B", "A", 0.00123, 0.0}},
            {{3, "SPEED", "rpm", 6.0, 0.0}}});
    for (Tick tick = 0; tick < 32000; tick += 100) {
        if (tick >= 16000 && tick < 17600)
            continue;
        SampleBlock block{1, tick, 100, {}, {{tick + 99, {static_cast<std::int32_t>(tick / 100)}}},
            tick == 17600 ? 1600 : 0};
        for (Tick i = 0; i < 200; ++i)
            block.fast.push_back(static_cast<std::int16_t>(i * 317 + tick * 11));
        capture.append(block);
    }
    return capture;
}

} // namespace

class TestExport : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_rig = std::make_unique<facts::WindowRig>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        const quint64 before = scope()->redraws();
        m_rig->window.selection()->showFile(recording());
        QTRY_VERIFY(scope()->redraws() > before);
        QCOMPARE(scope()->channels().size(), 3);
    }
    void cleanup() { m_rig.reset(); }

    void whatIsExportedIsImportedIdentically_data()
    {
        QTest::addColumn<QByteArray>("format");
        QTest::newRow("decimal point") << QByteArray("csv");
        QTest::newRow("decimal comma") << QByteArray("csv-continental");
    }
    void whatIsExportedIsImportedIdentically()
    {
        QFETCH(QByteArray, format);
        const QString path =
            m_folder.filePath(QStringLiteral("%1.csv").arg(QString::fromLatin1(format)));
        exportAs(format, kEverything, path);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Exported to ")));
        const Capture original = recording();
        m_rig->files.answer = path;
        m_rig->find<QAction>("importCsv")->trigger();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Imported ")));
        const auto &capture = m_rig->workbench.capture();
        QCOMPARE(capture.channels().size(), std::size_t(3));
        for (const ChannelId id : {original.channels()[0].id, original.channels()[1].id}) {
            const Channel *from = original.channel(id);
            const Channel *to = capture.channel(scope()->channels().at(qsizetype(id) - 1));
            QCOMPARE(
                QString::fromStdString(to->info().name), QString::fromStdString(from->info().name));
            QCOMPARE(QString::fromStdString(to->info().unit), QStringLiteral("A"));
            QCOMPARE(to->end() - to->begin(), from->end() - from->begin());
            for (Index i = 0; i < from->end(); ++i) {
                QCOMPARE(to->timeOf(to->begin() + i), from->timeOf(i));
                QCOMPARE(to->at(to->begin() + i), from->at(i));
            }
            QVERIFY(!to->valueAt(1.05)); // the gap is one again
        }
    }

    /// One register in two units has two channels, and some disks do not tell capitals from others.
    void aFileForEachRateIsNeverAnothers()
    {
        Capture capture;
        capture.appendPolled(9, "I_Q_REF", "s16A", 0.1, 100.0);
        capture.appendPolled(9, "I_Q_REF", "A", 0.2, 1.5);
        capture.appendPolled(10, "I-Q/REF", "A", 0.3, 2.5);
        capture.appendPolled(11, "I-Q-REF", "A", 0.4, 3.5);
        capture.appendPolled(12, "i_q_ref", "A", 0.5, 4.5);
        QCOMPARE(capture.channels().size(), std::size_t(5));
        m_rig->window.selection()->showFile(std::move(capture));
        const QTemporaryDir folder;
        m_rig->files.answer = folder.filePath(QStringLiteral("x.csv"));
        m_rig->window.findChild<widgets::Exporting *>()->ask();
        m_rig->find<QComboBox>("exportRange")->setCurrentIndex(kEverything);
        m_rig->find<QComboBox>("exportRates")->setCurrentIndex(1);
        QTest::mouseClick(m_rig->find<QPushButton>("exportSave"), Qt::LeftButton);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Exported to ")));
        QByteArrayList rows;
        const QDir made(folder.path());
        for (const QString &name : made.entryList(QDir::Files))
            rows.append(linesOf(made.filePath(name)).last());
        std::sort(rows.begin(), rows.end());
        QCOMPARE(rows, (QByteArrayList{"0.1,100", "0.2,1.5", "0.3,2.5", "0.4,3.5", "0.5,4.5"}));
        QVERIFY(made.exists(QStringLiteral("x_I_Q_REF_2.csv")));
    }

    void whatAFileHoldsIsKnown_data()
    {
        QTest::addColumn<QByteArray>("format");
        QTest::addColumn<bool>("alone");
        QTest::addColumn<bool>("all");
        QTest::newRow("one CSV") << QByteArray("csv") << false << false;
        QTest::newRow("one for each rate") << QByteArray("csv") << true << true;
        QTest::newRow("MATLAB") << QByteArray("mat") << false << true;
        QTest::newRow("NumPy") << QByteArray("npy") << false << true;
        QTest::newRow("WAV") << QByteArray("wav") << false << false;
    }
    /// Streamed for two seconds, then only read now and then: one table has the rows of what was streamed.
    void whatAFileHoldsIsKnown()
    {
        QFETCH(QByteArray, format);
        QFETCH(bool, alone);
        QFETCH(bool, all);
        Capture capture = recording();
        std::vector<ChannelId> ids;
        for (const ChannelInfo &info : capture.channels())
            ids.push_back(info.id);
        widgets::ExportOrder order;
        order.format = session::exportFormatNamed(format.toStdString());
        const auto carriedOut = [&] {
            order.parts.clear();
            const Snapshot channels = capture.snapshot(ids);
            const std::vector<Snapshot> parts =
                alone ? splitByRate(channels) : std::vector{channels};
            for (const Snapshot &part : parts)
                order.parts.append({m_folder.filePath(QStringLiteral("held%1_%2")
                                                          .arg(QString::fromLatin1(format),
                                                              QString::number(order.parts.size()))),
                    part});
            return widgets::carryOut(order, [](double) { return true; });
        };
        ids.resize(2); // the fast ones
        QVERIFY(carriedOut().ok());
        QCOMPARE(carriedOut().allInIt, format != "wav");
        capture.appendPolled(9, "TEMPERATURE", "\u00b0C", 60.0, 25.0);
        ids.push_back(*capture.find(9));
        QCOMPARE(carriedOut().allInIt, all);
        order.range = TimeSpan{0.0, 1.0};
        QVERIFY(!carriedOut().allInIt);
    }

    void whatNoRowHoldsIsAskedAbout()
    {
        m_rig.reset();
        for (const bool later : {false, true}) {
            facts::ScopeWindow rig;
            rig.record(1000, [](int, int tick) { return tick; });
            if (later)
                rig.workbench.capture().appendPolled(77, "TEMPERATURE", "\u00b0C", 60.0, 25.0);
            rig.files.answer = m_folder.filePath(QStringLiteral("live%1.csv").arg(later));
            rig.window.findChild<widgets::Exporting *>()->ask();
            rig.find<QComboBox>("exportRange")->setCurrentIndex(kEverything);
            QTest::mouseClick(rig.find<QPushButton>("exportSave"), Qt::LeftButton);
            // The banner warns of the board that is none.
            QTRY_VERIFY(QFile::exists(rig.files.answer));
            QTRY_VERIFY(!rig.window.findChild<widgets::FileJob *>());
            rig.device().portChanged(session::PortState::Closed, {});
            rig.files.answer.clear();
            rig.find<QAction>("openRecording")->trigger();
            QCOMPARE(rig.find<QMessageBox>("replaceQuestion") != nullptr, later);
        }
    }

    void theCursorsCutExactly()
    {
        auto &cursors = scope()->cursors();
        cursors.setVisible(true);
        cursors.move(widgets::CursorEnd::A, 0.5);
        cursors.move(widgets::CursorEnd::B, 0.25); // either may be first
        const QString path = m_folder.filePath(QStringLiteral("cursors.csv"));
        exportAs("csv", kCursors, path);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Exported to ")));
        const QList<QByteArray> lines = linesOf(path);
        QCOMPARE(lines.size(), 4000 + 1);
        QVERIFY(lines.at(1).startsWith("0.25,"));
        QVERIFY(lines.last().startsWith(QByteArray::number(0.5 - kTick, 'g', 10) + ','));
    }

    void whatTheScopeShowsIsCutExactly()
    {
        scope()->setVisibleRange(1.5, 1.75);
        const QString path = m_folder.filePath(QStringLiteral("visible.csv"));
        exportAs("csv", kVisible, path);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Exported to ")));
        QCOMPARE(linesOf(path).size(), 4000 + 1);
    }

    void thePictureIsHeldWhileItIsAskedFor()
    {
        m_rig.reset();
        facts::ScopeWindow rig;
        rig.record(1000, [](int, int tick) { return tick % 100; });
        rig.draw();
        QVERIFY(rig.scope().running() && rig.scope().time().following());
        const double seen = rig.scope().visibleRange().to;
        rig.files.answer = m_folder.filePath(QStringLiteral("held.csv"));
        rig.window.findChild<widgets::Exporting *>()->ask();
        rig.record(9000, [](int, int tick) { return tick % 100; }); // meanwhile
        rig.draw();
        QTest::mouseClick(rig.find<QPushButton>("exportSave"), Qt::LeftButton);
        QTRY_VERIFY(QFile::exists(rig.files.answer));
        QVERIFY(linesOf(rig.files.answer).last().split(',').first().toDouble() <= seen);
        QVERIFY(rig.scope().running());
    }

    void whatIsNotShownIsSaid()
    {
        for (const ChannelId id : scope()->channels())
            m_rig->window.selection()->showOfFile(id, false);
        m_rig->window.findChild<widgets::Exporting *>()->ask();
        auto *range = m_rig->find<QComboBox>("exportRange");
        range->setCurrentIndex(kVisible);
        QVERIFY(m_rig->find<QLabel>("exportSummary")
                    ->text()
                    .startsWith(QStringLiteral("No trace is shown")));
        range->setCurrentIndex(kEverything);
        QVERIFY(m_rig->find<QPushButton>("exportSave")->isEnabled());
    }

    void otherFormatsAreWhatTheirNameSays_data()
    {
        QTest::addColumn<QByteArray>("format");
        QTest::addColumn<QByteArray>("begin");
        QTest::addColumn<int>("atLeast");
        QTest::newRow("WAV") << QByteArray("wav") << QByteArray("RIFF") << 30400 * 4;
        QTest::newRow("MATLAB") << QByteArray("mat") << QByteArray("MATLAB 5.0") << 10000;
        QTest::newRow("NumPy") << QByteArray("npy") << QByteArray("\x93NUMPY") << 30400 * 8 * 2;
        QTest::newRow("PDF") << QByteArray("pdf") << QByteArray("%PDF-") << 2000;
    }
    void otherFormatsAreWhatTheirNameSays()
    {
        QFETCH(QByteArray, format);
        QFETCH(QByteArray, begin);
        QFETCH(int, atLeast);
        const QString path =
            m_folder.filePath(QStringLiteral("other.%1").arg(QString::fromLatin1(format)));
        exportAs(format, kEverything, path);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Exported to ")));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.size() >= atLeast);
        QVERIFY(file.readAll().startsWith(begin));
    }

    void picturesShowTheScope()
    {
        const QSize size = pixels(); // before a banner takes some of it
        const QString png = m_folder.filePath(QStringLiteral("a.png"));
        exportAs("png", kEverything, png);
        QVERIFY(banner()->text().startsWith(QStringLiteral("Exported to ")));
        const QImage image(png);
        QCOMPARE(image.size(), size);
        QVERIFY(hasTraceIn(image));
        const auto seen = scope()->visibleRange();
        scope()->events().add(
            widgets::EventKind::Marker, (seen.from + seen.to) / 2, QStringLiteral("look here"));
        const QString svg = m_folder.filePath(QStringLiteral("a.svg"));
        exportAs("svg", kEverything, svg);
        QFile text(svg);
        QVERIFY(text.open(QIODevice::ReadOnly));
        const QByteArray shapes = text.readAll();
        QVERIFY(!shapes.contains("<image")); // shapes, at any size
        QVERIFY(shapes.contains("look here")); // with the events, as on the screen
        QImage drawn(svg);
        QVERIFY(traceShare(drawn) > 0.1);
    }

    void reportsAreWhiteInTheDark()
    {
        widgets::applyTheme(widgets::Theme::Dark);
        QTRY_COMPARE(scope()->palette(), QApplication::palette());
        QList<QImage> drawn;
        for (const char *format : {"svg", "png"}) {
            const QString file = m_folder.filePath(QStringLiteral("dark.") + QLatin1String(format));
            exportAs(format, kEverything, file);
            drawn.append(QImage(file));
        }
        QGuiApplication::clipboard()->clear();
        m_rig->find<QAction>("copyPicture")->trigger();
        drawn.append(QGuiApplication::clipboard()->image());
        const QImage seen = scope()->grab().toImage();
        widgets::applyTheme(widgets::Theme::Light);
        const auto share = [](const QImage &image, auto &&counts) { // of ground, not of traces
            int count = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    count += counts(qGray(image.pixel(x, y))) ? 1 : 0;
            return double(count) / (image.width() * image.height());
        };
        const auto white = [](int gray) { return gray > 240; };
        const auto dark = [](int gray) { return gray < 50; };
        for (const QImage &picture : drawn) {
            QVERIFY(!picture.isNull());
            QVERIFY2(
                share(picture, white) > 0.3, qPrintable(QString::number(share(picture, white))));
            QVERIFY2(share(picture, dark) < 0.2, qPrintable(QString::number(share(picture, dark))));
        }
        // And the screen is as it was.
        QVERIFY2(share(seen, dark) > 0.3, qPrintable(QString::number(share(seen, dark))));
    }

    void thePictureIsCopied()
    {
        QGuiApplication::clipboard()->clear();
        const QSize size = pixels();
        m_rig->find<QAction>("copyPicture")->trigger();
        const QImage image = QGuiApplication::clipboard()->image();
        QCOMPARE(image.size(), size);
        QVERIFY(hasTraceIn(image));
    }

    void aFileThatIsNoTableLeavesThePicture()
    {
        const QString path = m_folder.filePath(QStringLiteral("bad.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("time [s],I [A]\n0,1\n0.1,oops\n");
        file.close();
        const auto shown = scope()->channels();
        m_rig->files.answer = path;
        m_rig->find<QAction>("importCsv")->trigger();
        QTRY_VERIFY(
            banner()->text().contains(QStringLiteral("line 3, column 2: \"oops\" is no number")));
        QCOMPARE(scope()->channels(), shown);
    }

    void aFileThatCountsFrom1970IsSeen()
    {
        const QString path = m_folder.filePath(QStringLiteral("epoch.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("__time,/motor/speed\n");
        for (int i = 0; i < 1000; ++i)
            file.write(QStringLiteral("17000000%1.%2,%3\n")
                           .arg(i / 100, 2, 10, QLatin1Char('0'))
                           .arg(i % 100, 2, 10, QLatin1Char('0'))
                           .arg(i)
                           .toLatin1());
        file.close();
        m_rig->files.answer = path;
        m_rig->find<QAction>("importCsv")->trigger();
        QTRY_COMPARE(scope()->channels().size(), 1);
        const Capture &capture = m_rig->workbench.capture();
        const ChannelId id = scope()->channels().first();
        const auto filled = [&] {
            const auto range = scope()->visibleRange();
            int count = 0;
            for (const MinMax &column : capture.columns(id, range.from, range.to, 500))
                count += column.empty() ? 0 : 1;
            return count;
        };
        QVERIFY2(filled() > 490, qPrintable(QString::number(filled())));
        QCOMPARE(capture.extremes(id, scope()->visibleRange().from, scope()->visibleRange().to).max,
            999.0F);
        const quint64 before = scope()->redraws();
        for (int i = 0; i < 60; ++i) // as near as it goes
            scope()->time().zoom(2.0);
        scope()->time().pan(0.5);
        QTRY_VERIFY(scope()->redraws() > before);
        const auto near = scope()->visibleRange();
        QVERIFY(near.from >= 1.7e9 && near.to <= 1.7e9 + 10.0);
        QVERIFY((near.to - near.from) / 1000.0 > near.to - std::nextafter(near.to, 0.0));
        scope()->fitAll();
        QVERIFY(filled() > 490);
    }

    void atAnyDensityTracesAreShapes()
    {
        for (const double span : {2.0, 0.001}) { // bands, and steps with dots
            scope()->setVisibleRange(0.2, 0.2 + span);
            const QString svg = m_folder.filePath(QStringLiteral("dense%1.svg").arg(span));
            const quint64 before = scope()->redraws();
            QTRY_VERIFY(scope()->redraws() > before);
            const QImage screen = scope()->findChild<QCustomPlot *>()->grab().toImage();
            exportAs("svg", kVisible, svg);
            QFile text(svg);
            QVERIFY(text.open(QIODevice::ReadOnly));
            const QByteArray content = text.readAll();
            QVERIFY(!content.contains("<image"));
            QVERIFY(content.size() < 3'000'000);
            const QImage drawn(svg);
            const double ratio = traceShare(drawn) / traceShare(screen);
            QVERIFY2(ratio > 0.5 && ratio < 2.0, qPrintable(QString::number(ratio)));
        }
    }

    void moreSignalsThanTheScopeTakesAreSaid()
    {
        const QString path = m_folder.filePath(QStringLiteral("many.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QByteArray heading = "time [s]";
        QByteArray row;
        for (int column = 0; column < 40; ++column) {
            heading += ",C" + QByteArray::number(column) + " [A]";
            row += ",1";
        }
        file.write(heading + "\n0" + row + "\n0.1" + row + "\n");
        file.close();
        m_rig->files.answer = path;
        m_rig->find<QAction>("importCsv")->trigger();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Imported ")));
        QCOMPARE(scope()->channels().size(), 32);
        QVERIFY2(
            banner()->text().contains(QStringLiteral("8 signal")), qPrintable(banner()->text()));
        const auto all = m_rig->workbench.capture().channels();
        m_rig->window.selection()->showOfFile(all.back().id, true);
        QCOMPARE(scope()->channels().size(), 32);
        QVERIFY(banner()->text().contains(QStringLiteral("up to 32 signals")));
        m_rig->window.selection()->showOfFile(all.front().id, false);
        m_rig->window.selection()->add(all.back().registerId); // as one that is dropped
        QVERIFY(scope()->plotOf(all.back().id) >= 0);
    }

    void rowsOfOneTimeThatAreLeftOutAreSaid()
    {
        const QString path = m_folder.filePath(QStringLiteral("same.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("time [s],A\n0,1\n0,2\n0.1,3\n0.1,4\n");
        file.close();
        m_rig->files.answer = path;
        m_rig->find<QAction>("importCsv")->trigger();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Imported ")));
        QVERIFY2(banner()->text().contains(QStringLiteral("2 row")), qPrintable(banner()->text()));
        QCOMPARE(banner()->kind(), Banner::Kind::Warning);
    }

    void aPlaceThatTakesNoFileIsOneSentence()
    {
        exportAs("mat", kEverything, m_folder.filePath(QStringLiteral("no/such/folder/a.mat")));
        QTRY_VERIFY(banner()->text().contains(QStringLiteral("cannot be written")));
        QCOMPARE(banner()->kind(), Banner::Kind::Warning);
    }

    void longWorkShowsItsProgressAndIsCancelled()
    {
        QSemaphore asked;
        std::atomic<bool> proceeds = true;
        bool finished = false;
        auto *job = new widgets::FileJob(
            QStringLiteral("Working"),
            [&](const widgets::FileJob::Proceed &proceed) -> widgets::FileJob::Finish {
                while (proceed(0.5))
                    asked.tryAcquire(1, 5);
                proceeds = false;
                return [&finished] { finished = true; };
            },
            &m_rig->window);
        QSignalSpy over(job, &widgets::FileJob::over);
        QVERIFY(!m_rig->find<QProgressDialog>("fileJob")); // short work is quiet
        QTRY_VERIFY(m_rig->find<QProgressDialog>("fileJob"));
        auto *dialog = m_rig->find<QProgressDialog>("fileJob");
        QVERIFY(!dialog->isModal());
        QTRY_COMPARE(dialog->value(), 500);
        QVERIFY(dialog->labelText().startsWith(QStringLiteral("Working: about ")));
        QTest::mouseClick(m_rig->find<QPushButton>("fileJobCancel"), Qt::LeftButton);
        QTRY_COMPARE(over.count(), 1);
        QVERIFY(finished && !proceeds);
        QVERIFY(!m_rig->find<QProgressDialog>("fileJob"));
    }

    void closingDuringAnExportAsks_data()
    {
        QTest::addColumn<int>("role");
        QTest::newRow("when it is written") << int(QMessageBox::AcceptRole);
        QTest::newRow("without it") << int(QMessageBox::DestructiveRole);
        QTest::newRow("not at all") << int(QMessageBox::RejectRole);
    }
    void closingDuringAnExportAsks()
    {
        QFETCH(int, role);
        std::atomic<bool> written = false;
        m_rig->window.findChild<widgets::Exporting *>()->write(QStringLiteral("Exporting"),
            [&](const widgets::FileJob::Proceed &proceed) -> widgets::FileJob::Finish {
                while (proceed(0.5) && !written)
                    QThread::yieldCurrentThread();
                return {};
            });
        auto *job = m_rig->window.findChild<widgets::FileJob *>();
        QSignalSpy over(job, &widgets::FileJob::over);
        QVERIFY(!m_rig->window.close());
        auto *box = m_rig->find<QMessageBox>("exportQuestion");
        QVERIFY(box);
        for (QAbstractButton *button : box->buttons())
            if (box->buttonRole(button) == role)
                QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(m_rig->window.isVisible(), role != QMessageBox::DestructiveRole);
        written = true;
        QTRY_COMPARE(over.count(), 1);
    }

    void anExportThatIsWaitedForClosesTheWindow()
    {
        m_rig->files.answer = m_folder.filePath(QStringLiteral("waited.csv"));
        m_rig->window.findChild<widgets::Exporting *>()->ask();
        m_rig->find<QComboBox>("exportRange")->setCurrentIndex(kEverything);
        QTest::mouseClick(m_rig->find<QPushButton>("exportSave"), Qt::LeftButton);
        QVERIFY(!m_rig->window.close()); // its end is told by the event loop
        for (QAbstractButton *button : m_rig->find<QMessageBox>("exportQuestion")->buttons())
            if (button->text().startsWith(QStringLiteral("Close when")))
                QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(m_rig->window.isVisible());
        QTRY_VERIFY(!m_rig->window.isVisible());
        QVERIFY(QFile::exists(m_rig->files.answer));
    }

    void whatWasWrittenBeforeACancelIsSaid()
    {
        const Capture capture = recording();
        std::vector<ChannelId> ids;
        for (const ChannelInfo &info : capture.channels())
            ids.push_back(info.id);
        widgets::ExportOrder order;
        order.format = session::exportFormatNamed("csv");
        for (const Snapshot &part : splitByRate(capture.snapshot(ids)))
            order.parts.append(
                {m_folder.filePath(QStringLiteral("part%1.csv").arg(order.parts.size())), part});
        QCOMPARE(order.parts.size(), 2);
        const auto result = widgets::carryOut(
            order, [&order](double) { return !QFile::exists(order.parts[0].path); });
        QVERIFY(result.cancelled());
        QVERIFY(QFile::exists(order.parts[0].path));
        QCOMPARE(widgets::exportErrorText(order, result),
            QStringLiteral("The export was cancelled. Written before: part0.csv."));
    }

    void workEndsWithItsWindow()
    {
        bool used = false;
        new widgets::FileJob(
            QStringLiteral("Working"),
            [&used](const widgets::FileJob::Proceed &proceed) -> widgets::FileJob::Finish {
                while (proceed(0.1))
                    QThread::yieldCurrentThread();
                return [&used] { used = true; };
            },
            &m_rig->window);
        m_rig.reset(); // waits for the work, and uses nothing of it
        QCoreApplication::processEvents();
        QVERIFY(!used);
    }

private:
    static constexpr int kVisible = 0, kEverything = 1, kCursors = 2; ///< rows of the choice

    void exportAs(const QByteArray &format, int range, const QString &path)
    {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // a dialog of before
        m_rig->files.answer = path;
        m_rig->window.findChild<widgets::Exporting *>()->ask();
        auto *choice = m_rig->find<QComboBox>("exportFormat");
        choice->setCurrentIndex(choice->findData(QString::fromLatin1(format)));
        m_rig->find<QComboBox>("exportRange")->setCurrentIndex(range);
        QTest::mouseClick(m_rig->find<QPushButton>("exportSave"), Qt::LeftButton);
    }
    static QList<QByteArray> linesOf(const QString &path)
    {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return {};
        return file.readAll().trimmed().split('\n');
    }
    QSize pixels() { return scope()->size() * scope()->devicePixelRatio(); }
    bool hasTraceIn(const QImage &image)
    {
        const QRgb wanted = scope()->colorOf(scope()->channels().first()).rgb();
        int found = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                found += (image.pixel(x, y) | 0xff000000U) == (wanted | 0xff000000U);
        return found > 200;
    }
    /// Of the pixels, how many are much nearer to a trace's colour than to grey.
    static double traceShare(const QImage &image)
    {
        int found = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                found += image.pixelColor(x, y).hslSaturation() > 60 ? 1 : 0;
        return double(found) / (double(image.width()) * double(image.height()));
    }
    Banner *banner() { return m_rig->window.findChild<Banner *>(); }
    widgets::ScopeView *scope() { return m_rig->window.scope(); }

    QTemporaryDir m_folder;
    std::unique_ptr<facts::WindowRig> m_rig;
};

QTEST_MAIN(TestExport)
#include "tst_export.moc"
