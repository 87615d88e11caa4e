// A recording behind the traces of now.
#include "support/scope_bench.h"
#include "widgets/files/lay_reference.h"
#include "widgets/files/open_recording.h"
#include "widgets/scope/ghosts.h"

using facts::Bench;
using widgets::OpenedRecording;
using widgets::Reference;

namespace {

constexpr capture::Nanos kSecond = 1'000'000'000;

/// Signal `id` at 1 kHz from 100 s on, for two seconds, at 700; a ramp after one second, and a note.
OpenedRecording openedRecording(catalog::RegisterId id)
{
    OpenedRecording opened;
    opened.path = QStringLiteral("/somewhere/run.pcapng");
    capture::StreamLayout layout = facts::layoutOf({facts::signal(id, "A")});
    layout.originSeconds = 100.0;
    opened.capture.begin(layout);
    capture::SampleBlock block{1, 0, 2000, std::vector<std::int16_t>(2000, 700), {}, 0};
    opened.capture.append(block);
    opened.report.happenings.push_back({100 * kSecond, {"board", {{"firmware", "X"}}}});
    opened.report.happenings.push_back(
        {101 * kSecond, {"speed ramp", {{"motor", "1"}, {"rpm", "500"}, {"ms", "0"}}}});
    opened.report.notes.push_back({100 * kSecond + kSecond / 2, 100 * kSecond, "look"});
    return opened;
}

} // namespace

class TestLayReference : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void itIsDrawnBesideTheRunningPicture()
    {
        Bench bench({facts::signal(1, "A")});
        bench.view.addChannel(bench.id(1));
        bench.record(1000, -700);
        bench.view.fitAll();
        const QColor color = bench.view.colorOf(bench.id(1));
        const auto above = [&] { // the middle of the picture, where only the reference can be
            const QImage image = bench.picture();
            int marked = 0;
            for (int x = 200; x < 700; ++x)
                for (int y = 40; y < 180; ++y)
                    marked += qAbs(image.pixelColor(x, y).hue() - color.hue()) < 12
                            && image.pixelColor(x, y).saturation() > 40
                        ? 1
                        : 0;
            return marked;
        };
        bench.record(100, 1000); // room above
        bench.view.setVisibleRange(0.0, 1.1);
        bench.view.fitValues();
        bench.view.setVisibleRange(0.0, 0.9);
        QCOMPARE(above(), 0);
        OpenedRecording opened = openedRecording(1);
        bool good = false;
        const QString said = widgets::layReference(bench.view, bench.capture, opened, good);
        QVERIFY2(good, qPrintable(said));
        QVERIFY2(said.contains(QStringLiteral("run.pcapng is reference A, with 1 of the 1")),
            qPrintable(said));
        QVERIFY(said.contains(QStringLiteral("its beginning")));
        QVERIFY(bench.view.ghosts().isFromFile(Reference::A));
        QVERIFY(above() > 100);
        OpenedRecording second = openedRecording(1);
        widgets::layReference(bench.view, bench.capture, second, good); // the next one that is free
        QVERIFY(good && bench.view.ghosts().isFromFile(Reference::B));
    }

    void itsMomentsAreLaidOneAfterTheOther()
    {
        Bench bench({facts::signal(1, "A")});
        bench.view.addChannel(bench.id(1));
        bench.record(1000, 0);
        OpenedRecording opened = openedRecording(1);
        bool good = false;
        widgets::layReference(bench.view, bench.capture, opened, good);
        widgets::ScopeGhosts &ghosts = bench.view.ghosts();
        QSignalSpy laid(&ghosts, &widgets::ScopeGhosts::laid);
        QCOMPARE(ghosts.instant(Reference::A).seconds, 100.0);
        ghosts.nextInstant(Reference::A, 1);
        QCOMPARE(ghosts.instant(Reference::A).text, QStringLiteral("look"));
        QCOMPARE(ghosts.instant(Reference::A).seconds, 100.5);
        ghosts.nextInstant(Reference::A, 1);
        QCOMPARE(ghosts.instant(Reference::A).text, QStringLiteral("Ramp to 500 rpm in 0 ms"));
        QVERIFY(
            widgets::laidText(bench.view, Reference::A).contains(QStringLiteral("Ramp to 500")));
        ghosts.nextInstant(Reference::A, 1); // round
        QCOMPARE(ghosts.instant(Reference::A).seconds, 100.0);
        QCOMPARE(laid.size(), 3);
        ghosts.keep(Reference::A); // another kind of reference has no moments
        QVERIFY(!ghosts.isFromFile(Reference::A));
        ghosts.nextInstant(Reference::A, 1);
        QCOMPARE(laid.size(), 3);
    }

    void ofOtherSignalsNothingIsLaid()
    {
        Bench bench({facts::signal(1, "A")});
        bench.view.addChannel(bench.id(1));
        bench.record(1000, 0);
        OpenedRecording opened = openedRecording(2);
        bool good = true;
        const QString said = widgets::layReference(bench.view, bench.capture, opened, good);
        QVERIFY(!good && said.contains(QStringLiteral("run.pcapng")));
        QVERIFY(!bench.view.ghosts().hasReference());
    }
};

QTEST_MAIN(TestLayReference)
#include "tst_lay_reference.moc"
