// Spectra in the real window: what is computed, shown, averaged and told in orders. The numbers are core's own
// business; here one of each kind shows that the right samples are asked and that what comes back is what the user
// sees.
#include "support/scope_window.h"
#include "widgets/base/trace_colors.h"
#include "widgets/measuring/spectrum_job.h"
#include "widgets/measuring/spectrum_panel.h"
#include "widgets/measuring/spectrum_peaks.h"
#include "widgets/measuring/spectrum_plot.h"
#include "widgets/scope/signals/selection.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTreeView>

#include <cmath>
#include <numbers>

using widgets::SpectrumPanel;
using widgets::SpectrumPeaks;

namespace {
int sine(double hertz, double amplitude, int tick)
{
    return int(std::lround(amplitude * std::sin(2 * std::numbers::pi * hertz * tick / 1000.0)));
}
} // namespace

class TestSpectrumPanel : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        QLocale::setDefault(QLocale::c());
        m_rig = std::make_unique<facts::ScopeWindow>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        // I_A: 50 Hz of 1000 A and 150 Hz of 100 A. I_B: 20 Hz of 400 A.
        m_rig->record(4000, [](int signal, int tick) {
            return signal == 0 ? sine(50, 1000, tick) + sine(150, 100, tick) : sine(20, 200, tick);
        });
        view().setRunning(false);
        view().setVisibleRange(0.0, 4.0);
        m_rig->draw();
        QTest::keyClick(&m_rig->window, Qt::Key_0, Qt::ControlModifier);
        choose("spectrumTrace", m_rig->id(facts::kCurrentA));
        update();
    }
    void cleanup() { m_rig.reset(); }

    void theLinesOfATraceAreFound();
    void anotherTraceAndTheCursorsAreAnotherSpectrum();
    void ordersAreMultiplesOfTheLargestPeak();
    void ordersOfASpeedAreReadable();
    void ordersOfASpeedNeedThePolePairs();
    void ordersAreOfTheMotorThatHasTheSpeed();
    void aFileHasNoOrdersOfABoard();
    void itStaysWithItsSignal();
    void whereThereIsNoSpectrumTheReasonIsSaid();
    void spectraAreAveragedAndBegunAnew();
    void eachSampleIsAveragedOnce();
    void aSpectrumThatStandsIsNotComputedAgain();
    void thePictureHasAStrokeAPixelAndNotABin();
    void keysMoveTheFrequencies();
    void veryLongPicturesAreCutToTheirNewestSamples();
    void theTableIsAModelAndACopy();
    void aHiddenPanelComputesNothing();

private:
    widgets::ScopeView &view() { return m_rig->scope(); }
    SpectrumPanel &panel() { return *m_rig->window.findChild<SpectrumPanel *>(); }
    widgets::SpectrumPlot &plot() { return *m_rig->window.findChild<widgets::SpectrumPlot *>(); }
    SpectrumPeaks &peaks() { return *m_rig->window.findChild<SpectrumPeaks *>(); }
    QString note() { return m_rig->find<QLabel>("spectrumNote")->text(); }
    QString why() { return m_rig->find<QLabel>("spectrumPlotWhy")->text(); }
    QString cell(int row, int column) { return peaks().index(row, column).data().toString(); }
    void choose(const char *box, const QVariant &data)
    {
        auto *combo = m_rig->find<QComboBox>(box);
        QVERIFY(combo->findData(data) >= 0);
        combo->setCurrentIndex(combo->findData(data));
    }
    /// Until what is chosen now has been computed: heartbeats, as a clock would send them.
    void update()
    {
        const auto beatUntilSettled = [this] {
            Q_EMIT m_rig->workbench.heartbeat({});
            return panel().settled();
        };
        QTRY_VERIFY(beatUntilSettled());
    }

    std::unique_ptr<facts::ScopeWindow> m_rig;
};

void TestSpectrumPanel::theLinesOfATraceAreFound()
{
    QVERIFY(peaks().rowCount() >= 2);
    QCOMPARE(cell(0, SpectrumPeaks::FrequencyColumn), QStringLiteral("50\u202fHz"));
    QVERIFY(std::abs(peaks().peaks()[0].amplitude - 1000.0) < 3.0);
    QVERIFY(std::abs(peaks().peaks()[1].hertz - 150.0) < 0.01);
    QVERIFY(std::abs(peaks().peaks()[1].amplitude - 100.0) < 0.5);
    QCOMPARE(cell(0, SpectrumPeaks::OrderColumn), QStringLiteral("\u2013"));
    QCOMPARE(cell(0, SpectrumPeaks::RelativeColumn), QStringLiteral("0.0\u00a0dB"));
    QCOMPARE(cell(1, SpectrumPeaks::RelativeColumn), QStringLiteral("\u221220.0\u00a0dB"));
    QVERIFY2(note().startsWith(QStringLiteral("4000 samples a transform")), qPrintable(note()));
    choose("spectrumSize", 1024);
    update();
    QVERIFY2(note().contains(QStringLiteral("mean of 6 transforms")), qPrintable(note()));
}

void TestSpectrumPanel::anotherTraceAndTheCursorsAreAnotherSpectrum()
{
    choose("spectrumTrace", m_rig->id(facts::kCurrentB));
    update();
    QVERIFY(std::abs(peaks().peaks()[0].hertz - 20.0) < 0.01);
    QVERIFY(std::abs(peaks().peaks()[0].amplitude - 400.0) < 2.0); // a digit is 2 A
    auto *range = m_rig->find<QComboBox>("spectrumRange");
    range->setCurrentIndex(1);
    Q_EMIT range->activated(1);
    QVERIFY(view().cursors().visible());
    view().cursors().move(widgets::CursorEnd::A, 3.0); // either order
    view().cursors().move(widgets::CursorEnd::B, 1.0);
    update();
    QVERIFY2(note().startsWith(QStringLiteral("2000 samples")), qPrintable(note()));
}

void TestSpectrumPanel::ordersAreMultiplesOfTheLargestPeak()
{
    choose("spectrumAxis", 0);
    QCOMPARE(cell(0, SpectrumPeaks::OrderColumn), QStringLiteral("1.00"));
    QCOMPARE(cell(1, SpectrumPeaks::OrderColumn), QStringLiteral("3.00"));
}

void TestSpectrumPanel::ordersOfASpeedAreReadable()
{
    const auto *axis = m_rig->find<QComboBox>("spectrumAxis");
    QStyleOptionComboBox option;
    option.initFrom(axis);
    const QRect room = axis->style()->subControlRect(
        QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, axis);
    const QString longest = QStringLiteral("orders: STOPLL_ROT_SPEED");
    QVERIFY2(axis->fontMetrics().horizontalAdvance(longest) <= room.width(),
        qPrintable(QString::number(room.width())));
}

void TestSpectrumPanel::ordersOfASpeedNeedThePolePairs()
{
    capture::Capture &capture = m_rig->workbench.capture();
    const auto speed = capture.addImported("SPEED", "rpm");
    for (int i = 0; i < 40; ++i)
        capture.appendImported(speed, i * 100'000'000LL, -750.0, (i + 1) * 100'000'000LL);
    view().addChannel(speed);
    choose("spectrumAxis", int(speed));
    QVERIFY2(note().startsWith(QStringLiteral("No orders")), qPrintable(note()));
    drive::Identified board = facts::identified();
    board.limits[0].polePairs = 4.0;
    facts::feed(m_rig->device(), {board});
    view().addChannel(speed); // what a new board is asked for says nothing about it
    choose("spectrumAxis", -1);
    choose("spectrumAxis", int(speed)); // 750 rpm backwards, 4 pole pairs: 50 Hz
    QCOMPARE(cell(0, SpectrumPeaks::OrderColumn), QStringLiteral("1.00"));
    QCOMPARE(cell(1, SpectrumPeaks::OrderColumn), QStringLiteral("3.00"));
}

void TestSpectrumPanel::ordersAreOfTheMotorThatHasTheSpeed()
{
    drive::Identified board = facts::identified();
    board.identity.motors = 2;
    auto registers = board.catalog->registers();
    for (catalog::RegisterInfo &info : registers)
        info.perMotor = info.id == facts::kSpeed;
    board.catalog = std::make_shared<const catalog::Catalog>(
        std::move(registers), 2, std::vector<catalog::Scales>(2));
    board.limits.resize(2);
    board.limits[0].polePairs = 2.0;
    board.limits[1].polePairs = 4.0;
    facts::feed(m_rig->device(), {board});
    QCOMPARE(m_rig->device().motor(), 1);
    capture::Capture &capture = m_rig->workbench.capture();
    for (int i = 0; i < 40; ++i)
        capture.appendPolled(facts::kSpeed | 2U, "SPEED_MEAS@2", "rpm", i * 0.1, 750.0);
    view().addChannel(m_rig->id(facts::kSpeed | 2U));
    choose("spectrumAxis", int(m_rig->id(facts::kSpeed | 2U))); // 4 pole pairs: 50 Hz
    QCOMPARE(cell(0, SpectrumPeaks::OrderColumn), QStringLiteral("1.00"));
}

void TestSpectrumPanel::aFileHasNoOrdersOfABoard()
{
    drive::Identified board = facts::identified();
    board.limits[0].polePairs = 4.0;
    facts::feed(m_rig->device(), {board});
    capture::Capture file;
    const auto trace = file.addImported("I", "A");
    const auto speed = file.addImported("SPEED", "rpm");
    for (int i = 0; i < 4000; ++i) {
        file.appendImported(trace, i * 1'000'000LL, sine(50, 1000, i), (i + 1) * 1'000'000LL);
        file.appendImported(speed, i * 1'000'000LL, 750.0, (i + 1) * 1'000'000LL);
    }
    m_rig->window.selection()->showFile(std::move(file));
    choose("spectrumTrace", view().channels().first());
    choose("spectrumAxis", int(view().channels().last()));
    update();
    QVERIFY(peaks().rowCount() > 0);
    QVERIFY2(note().startsWith(QStringLiteral("No orders")), qPrintable(note()));
}

void TestSpectrumPanel::itStaysWithItsSignal()
{
    capture::Capture &capture = m_rig->workbench.capture();
    const catalog::RegisterId own = capture::kFirstOwnRegister + 1000;
    const auto before = capture.addImported("M", "A", own);
    view().addChannel(before);
    choose("spectrumTrace", before);
    const auto after = capture.addImported("M", "A", own); // its formula was changed
    view().addChannel(after);
    view().removeChannel(before);
    capture.removeImported(before);
    const auto *box = m_rig->find<QComboBox>("spectrumTrace");
    QCOMPARE(box->currentData().toUInt(), after);
    view().removeChannel(after);
    QCOMPARE(box->currentIndex(), -1); // and no other in its place
    const auto asked = [this] {
        Q_EMIT m_rig->workbench.heartbeat({});
        return why();
    };
    QTRY_COMPARE(asked(), QStringLiteral("Choose a trace."));
    view().addChannel(after);
    QCOMPARE(box->currentData().toUInt(), after);
}

void TestSpectrumPanel::whereThereIsNoSpectrumTheReasonIsSaid()
{
    view().setVisibleRange(10.0, 20.0);
    update();
    QVERIFY2(why().startsWith(QStringLiteral("Fewer than 16")), qPrintable(why()));
    QVERIFY(m_rig->find<QLabel>("spectrumPlotWhy")->isVisible());
    QCOMPARE(peaks().rowCount(), 0);
    view().setVisibleRange(0.0, 4.0);
    update();
    QVERIFY(!m_rig->find<QLabel>("spectrumPlotWhy")->isVisible());
    QVERIFY(peaks().rowCount() > 0);
}

void TestSpectrumPanel::spectraAreAveragedAndBegunAnew()
{
    m_rig->find<QSpinBox>("spectrumAverage")->setValue(8);
    update();
    for (int i = 0; i < 4; ++i) { // other samples each time
        view().setVisibleRange(1.0 * i, 1.0 * i + 1.0);
        update();
    }
    QVERIFY2(note().contains(QStringLiteral("mean of 4")), qPrintable(note()));
    QTest::mouseClick(m_rig->find<QWidget>("spectrumAgain"), Qt::LeftButton);
    update();
    QVERIFY2(!note().contains(QStringLiteral("mean of")), qPrintable(note()));
}

void TestSpectrumPanel::eachSampleIsAveragedOnce()
{
    m_rig->find<QSpinBox>("spectrumAverage")->setValue(8);
    view().setVisibleRange(0.0, 1.0);
    update();
    view().setVisibleRange(1.0, 2.0);
    update();
    QVERIFY2(note().contains(QStringLiteral("mean of 2")), qPrintable(note()));
    view().setVisibleRange(1.5, 2.5); // moved by hand, over the same samples
    update();
    QVERIFY2(!note().contains(QStringLiteral("mean of")), qPrintable(note()));
    QSignalSpy shown(&panel(), &SpectrumPanel::shown);
    view().setRunning(true);
    for (int i = 1; i < 10; ++i) { // running: it waits until all of it is new
        view().setVisibleRange(1.5 + 0.1 * i, 2.5 + 0.1 * i);
        update();
    }
    QCOMPARE(shown.size(), 0);
    view().setVisibleRange(2.5, 3.5);
    update();
    QVERIFY2(note().contains(QStringLiteral("mean of 2")), qPrintable(note()));
    view().setVisibleRange(3.5, 4.0); // another length
    update();
    QVERIFY2(!note().contains(QStringLiteral("mean of")), qPrintable(note()));
}

void TestSpectrumPanel::aSpectrumThatStandsIsNotComputedAgain()
{
    QSignalSpy shown(&panel(), &SpectrumPanel::shown);
    Q_EMIT m_rig->workbench.heartbeat({});
    QVERIFY(panel().settled());
    m_rig->record(10, [](int, int) { return 5; }); // outside the picture
    Q_EMIT m_rig->workbench.heartbeat({});
    QVERIFY(panel().settled());
    view().setVisibleRange(0.0, 3.0);
    Q_EMIT m_rig->workbench.heartbeat({});
    QVERIFY(panel().busy());
    QVERIFY(shown.wait());
    QCOMPARE(shown.size(), 1);
}

void TestSpectrumPanel::thePictureHasAStrokeAPixelAndNotABin()
{
    scope::Spectrum many;
    many.size = 2'000'000;
    many.binHz = 0.01;
    many.meanSquares.assign(many.size / 2 + 1, 1e-6);
    many.meanSquares[123'457] = 4.0;
    widgets::SpectrumPlot alone;
    alone.resize(400, 200);
    alone.setAttribute(Qt::WA_DontShowOnScreen);
    alone.show();
    alone.showSpectrum({many, {}, QStringLiteral("A"), {}, false});
    QVERIFY(alone.points() <= 4 * 400);
    const QColor ink = widgets::traceColor(0, widgets::isDark(alone.palette()));
    const auto inked = [&] { // halfway up there is only the one high line, in its column
        const QImage picture = alone.grab().toImage();
        int count = 0;
        for (int x = 0; x < picture.width(); ++x)
            count += picture.pixelColor(x, picture.height() / 2) == ink ? 1 : 0;
        return count;
    };
    QTRY_VERIFY(inked() >= 1); // it is drawn at the next turn of the loop
    QVERIFY2(inked() <= 4, qPrintable(QString::number(inked())));
}

void TestSpectrumPanel::keysMoveTheFrequencies()
{
    plot().setFocus();
    QCOMPARE(plot().from(), 0.0);
    QCOMPARE(plot().to(), 500.0);
    const auto scope = view().visibleRange();
    QTest::keyClick(&plot(), Qt::Key_Plus);
    QVERIFY(plot().to() - plot().from() < 400.0);
    QTest::keyClick(&plot(), Qt::Key_Minus, Qt::KeypadModifier);
    QCOMPARE(plot().to(), 500.0);
    QTest::keyClick(&plot(), Qt::Key_Plus, Qt::AltModifier); // not the plot's
    QCOMPARE(plot().to(), 500.0);
    QTest::keyClick(&plot(), Qt::Key_Plus);
    const double before = plot().from();
    QTest::keyClick(&plot(), Qt::Key_Right);
    QVERIFY(plot().from() > before);
    for (int i = 0; i < 50; ++i)
        QTest::keyClick(&plot(), Qt::Key_Right);
    QVERIFY(plot().to() <= 500.0);
    for (int i = 0; i < 50; ++i)
        QTest::keyClick(&plot(), Qt::Key_Plus);
    QVERIFY(plot().to() - plot().from() > 1.0); // some bins
    QTest::keyClick(&plot(), Qt::Key_F);
    QCOMPARE(plot().from(), 0.0);
    QCOMPARE(plot().to(), 500.0);
    QCOMPARE(view().visibleRange().from, scope.from); // the scope has the same keys
    QCOMPARE(view().visibleRange().to, scope.to);
}

void TestSpectrumPanel::veryLongPicturesAreCutToTheirNewestSamples()
{
    capture::Capture capture;
    capture.begin({1, 16000.0, 0.0, 1, {{1, "A", "A", 1.0, 0.0}}, {}});
    const auto most = std::uint32_t(widgets::kMostSpectrumSamples);
    capture::SampleBlock block{1, 0, most + 100'000, {}, {}, 0};
    for (std::uint32_t i = 0; i < block.count; ++i)
        block.fast.push_back(i < 100'000 ? std::int16_t(i % 2 == 0 ? 900 : -900)
                                         : std::int16_t(i % 16 < 8 ? 100 : -100));
    capture.append(block);
    const auto id = *capture.find(1);
    const widgets::SpectrumWanted wanted{id, 0, 1'000'000'000'000LL, 0, scope::Window::Hann, 0};
    const auto answer = widgets::computeSpectrum(capture.snapshot({&id, 1}), wanted);
    QVERIFY(answer.cut);
    QVERIFY(answer.spectrum.has_value());
    QCOMPARE(answer.spectrum->size, std::size_t(most));
    // What takes the longer the more samples there are comes out of the job, not of the window.
    QVERIFY(answer.mean && answer.mean->count() == 1);
    QVERIFY(!answer.peaks.empty() && answer.peaks.size() <= widgets::kMostSpectrumPeaks);
    QVERIFY(std::abs(answer.peaks.front().hertz - 1000.0) < 0.1);
    const auto more = widgets::computeSpectrum(capture.snapshot({&id, 1}), wanted, *answer.mean);
    QCOMPARE(more.mean->count(), 1U); // no more than one was wanted in it
    QCOMPARE(answer.mean->count(), 1U);
    const auto two =
        widgets::computeSpectrum(capture.snapshot({&id, 1}), wanted, scope::SpectrumAverage(2));
    QCOMPARE(
        widgets::computeSpectrum(capture.snapshot({&id, 1}), wanted, *two.mean).mean->count(), 2U);
}

void TestSpectrumPanel::theTableIsAModelAndACopy()
{
    QAbstractItemModelTester tester(
        &peaks(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    view().setVisibleRange(10.0, 20.0);
    update();
    QCOMPARE(peaks().rowCount(), 0);
    view().setVisibleRange(0.0, 4.0);
    update();
    QVERIFY(peaks().rowCount() > 0);
    QTest::mouseClick(m_rig->find<QWidget>("copyPeaks"), Qt::LeftButton);
    const QStringList lines = QApplication::clipboard()->text().split(QLatin1Char('\n'));
    QCOMPARE(lines.size(), peaks().rowCount() + 2);
    QVERIFY(lines[1].startsWith(QStringLiteral("1\t50\u202fHz\t")));
}

void TestSpectrumPanel::aHiddenPanelComputesNothing()
{
    m_rig->find<QWidget>("spectrumDock")->hide();
    view().setVisibleRange(1.0, 2.0);
    Q_EMIT m_rig->workbench.heartbeat({});
    QVERIFY(!panel().busy());
    QVERIFY(!panel().settled());
}

QTEST_MAIN(TestSpectrumPanel)
#include "tst_spectrum_panel.moc"
