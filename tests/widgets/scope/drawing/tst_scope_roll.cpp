// A picture that moved is made of the one before it, as far as that is still true: pixel by pixel it has to be the one
// that is painted anew at the same columns. Two scopes show the same; one of them looks away and back before each
// comparison, so that nothing of the picture before is left.
#include "support/scope_bench.h"
#include "support/seeds.h"
#include "widgets/scope/colors.h"
#include "widgets/scope/drawing/scope_canvas.h"
#include "widgets/scope/ghosts.h"

#include <random>

using namespace facts;
using capture::Nanos;

namespace {

constexpr double kTickHz = 10'000.0;
constexpr Nanos kTick = 100'000;
constexpr catalog::RegisterId kPolled = 77;

/// A capture of all kinds of signals, and two scopes that show it.
struct Twins {
    std::mt19937 random;
    double ratio; ///< device pixels
    Capture capture;
    widgets::EventLog events;
    ScopeView rolling{capture, events};
    ScopeView anew{capture, events};
    std::vector<ChannelId> all;
    std::vector<ChannelId> computed; ///< with a time of their own, up to which they are
    std::vector<Nanos> computedTo{0, 0};
    capture::Tick tick = 0;
    double from = 0.0, span = 5.0;
    QStringList acts;

    Twins(unsigned seed, double pixels)
        : random(seed)
        , ratio(pixels)
    {
        capture.begin({1, kTickHz, 0.0, 1,
            {{1, "A", "A", 0.001, 0.0}, {2, "B", "A", 0.001, 0.0}, {3, "C", "V", 0.01, 0.0},
                {4, "angle", "°", 360.0 / 65536, 0.0}},
            {{5, "speed", "rpm", 1.0, 0.0}}});
        computed = {capture.addImported("M", "A"), capture.addImported("N", "V")};
        append(40'000);
        for (const auto &info : capture.channels())
            all.push_back(info.id);
        forBoth([this](ScopeView &view) {
            view.resize(560, 380);
            view.setAttribute(Qt::WA_DontShowOnScreen);
            view.show();
            for (const ChannelId id : all)
                view.addChannel(id);
            view.setVisibleRange(from, from + span);
            view.fitValues();
        });
    }

    template <class Change>
    void forBoth(Change change)
    {
        change(rolling);
        change(anew);
    }
    int below(int bound) { return int(random() % unsigned(bound)); }
    double share() { return double(random() % 1'000'000) / 1e6; }
    double newest() const { return double(tick) / kTickHz; }

    int valueOf(int signal, capture::Tick at)
    {
        const double time = double(at) / kTickHz;
        if (signal == 3)
            return std::int16_t(std::int64_t(time * (int(time / 7) % 3 + 1) * 65536.0));
        const double wave = std::sin(time * (1 + signal * 5)) * (8000 + 4000 * std::sin(time / 3));
        return int(wave) + below(1 + 3000 * (int(time / 2) % (signal + 2)));
    }
    void append(int count)
    {
        capture::SampleBlock block{1, tick, std::uint32_t(count), {}, {}, 0};
        for (int signal = 0; signal < 4; ++signal)
            for (int i = 0; i < count; ++i)
                block.fast.push_back(std::int16_t(valueOf(signal, tick + i)));
        for (int i = 0; i < count; ++i)
            if ((tick + i) % 37 == 0)
                block.slow.push_back({tick + i, {valueOf(1, tick + i) / 4}});
        capture.append(block);
        tick += count;
        for (std::size_t i = 0; i < computed.size(); ++i)
            compute(i, Nanos(tick - below(300)) * kTick);
        if (below(3) != 0) {
            const double time = newest() - 1e-3 * share();
            capture.appendPolled(kPolled, "polled", "°C", time, 20 + 10 * share());
        }
    }
    /// The first at equal steps, the other at steps of many lengths.
    void compute(std::size_t which, Nanos until)
    {
        Nanos &to = computedTo[which];
        if (below(40) == 0)
            capture.breakImported(computed[which]);
        for (; to < until; to += which == 0 ? kTick : kTick / 2 + below(3 * int(kTick)))
            capture.appendImported(
                computed[which], to, 5.0 * std::sin(double(to) / 3e8) + share(), to + 2 * kTick);
    }

    void lookAt(ScopeView &view, double begin)
    {
        view.setVisibleRange(begin, begin + span);
        view.findChild<widgets::ScopeCanvas *>()->refresh();
        painted(view);
    }
    QImage painted(ScopeView &view) const
    {
        QWidget &plot = plotOf(view);
        QImage image(plot.size() * ratio, QImage::Format_RGB32);
        image.setDevicePixelRatio(ratio);
        image.fill(Qt::magenta);
        plot.render(&image);
        return image;
    }
    /// The stack has them with the next frame, which a timer brings.
    void setRecords(const std::vector<widgets::Ghost> &records)
    {
        forBoth([&records](ScopeView &view) {
            const quint64 before = view.redraws();
            view.ghosts().setRecords(records);
            view.redraw();
            while (view.redraws() == before)
                QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        });
    }
    void lose()
    {
        tick += 1 + below(below(4) == 0 ? 30'000 : 300);
        if (below(2) == 0)
            capture.endPolled(kPolled);
    }
    void zoom()
    {
        const double middle = from + span / 2;
        span = 0.02 * std::pow(10.0, 3.2 * share());
        from = middle - span / 2;
    }
    /// What is seen of the scopes, and nothing of the samples.
    void changeLook()
    {
        switch (below(7)) {
        case 0: {
            const ChannelId id = all[std::size_t(below(int(all.size())))];
            forBoth([id, shown = rolling.channels().contains(id)](
                        ScopeView &view) { shown ? view.removeChannel(id) : view.addChannel(id); });
            break;
        }
        case 1:
            forBoth([slot = below(8)](
                        ScopeView &view) { view.colors().choose(QStringLiteral("A"), slot); });
            break;
        case 2:
            forBoth([](ScopeView &view) { view.fitValues(); });
            break;
        case 3:
            forBoth([visible = !rolling.gridVisible()](
                        ScopeView &view) { view.setGridVisible(visible); });
            break;
        case 4:
            forBoth([dark = below(2) == 0](ScopeView &view) {
                QPalette palette;
                palette.setColor(QPalette::Base, dark ? Qt::black : Qt::white);
                palette.setColor(QPalette::Text, dark ? Qt::white : Qt::black);
                view.setPalette(palette);
            });
            break;
        case 5:
            setRecords(std::vector<widgets::Ghost>(
                std::size_t(below(3)), {nullptr, -0.7 * below(3), 110}));
            break;
        default:
            forBoth([zero = share()](ScopeView &view) { view.time().setOrigin(zero); });
        }
    }
    QString act()
    {
        const double pixel = span / rolling.plotRect(0).width() / ratio;
        const int what = below(20);
        if (what < 7) {
            append(1 + below(below(5) == 0 ? 5000 : 200));
            from = newest() - span;
            return QStringLiteral("follow");
        }
        if (what < 9) {
            append(1 + below(200));
            return QStringLiteral("append");
        }
        if (what < 15) {
            const double by = (share() - 0.5) * std::array{3.0, 20.0, 500.0}[std::size_t(below(3))];
            from += by * pixel;
            return QStringLiteral("drag %1").arg(by);
        }
        if (what < 17) {
            lose();
            return QStringLiteral("lose");
        }
        if (what < 18) {
            zoom();
            return QStringLiteral("zoom to %1").arg(span);
        }
        if (what < 19) {
            changeLook();
            return QStringLiteral("look");
        }
        capture.keepNewest(computed[0], capture.size(computed[0]) - 1 - std::uint64_t(below(5000)));
        return QStringLiteral("trim");
    }
    /// Empty: they are the same.
    QString difference()
    {
        for (int settled = 0; settled < 3;
             ++settled) // the legend takes its room with the next picture
            forBoth([this](ScopeView &view) { lookAt(view, from); });
        lookAt(anew, from + 1e4);
        lookAt(anew, from);
        const QImage one = painted(rolling);
        const QImage other = painted(anew);
        const QRect area = areaOf(rolling, 0);
        for (int y = qCeil(area.top() * ratio); y < qFloor(area.bottom() * ratio); ++y)
            for (int x = qCeil(area.left() * ratio); x < qFloor(area.right() * ratio); ++x)
                if (one.pixel(x, y) != other.pixel(x, y))
                    return QStringLiteral(
                        "the judge: picture: at %1, %2 %3 instead of %4, behind %5")
                        .arg(x)
                        .arg(y)
                        .arg(one.pixel(x, y), 0, 16)
                        .arg(other.pixel(x, y), 0, 16)
                        .arg(acts.join(QStringLiteral(", ")));
        return {};
    }
};

} // namespace

class TestScopeRoll : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aPictureThatMovedIsAsOnePaintedAnew()
    {
        const auto wrong = support::playSeeds(support::seedsOf(12, 600), [](std::uint64_t seed) {
            Twins twins(unsigned(seed), std::array{1.0, 2.0, 1.25, 1.5}[seed % 4]);
            QString difference;
            for (int step = 0; step < 60 && difference.isEmpty(); ++step) {
                twins.acts.append(twins.act());
                difference = twins.difference();
            }
            return std::optional(difference.toStdString());
        });
        QVERIFY2(wrong.empty(), wrong.c_str());
    }

    /// It stands still meanwhile, so that nothing but the records is another.
    void otherRecordsAreSeenBehindThePicture()
    {
        Twins twins(1, 1);
        twins.span = 1.0;
        for (const double shift : {0.0, -0.7, -0.3, -0.3}) {
            twins.from = 2.0;
            twins.setRecords({{nullptr, shift, 110}});
            twins.append(100);
            QCOMPARE(twins.difference(), QString());
        }
    }

    /// What is painted at the right edge begins left of it, behind the value that was given up.
    void aValueThatWasGivenUpEndsWhereTheNextOneIs()
    {
        Twins twins(1, 1);
        for (const double time : {4.2, 4.8})
            twins.capture.appendPolled(kPolled, "polled", "°C", time, 25.0);
        twins.capture.endPolled(kPolled); // up to 5.4 s, beyond the edge
        twins.capture.appendPolled(kPolled, "polled", "°C", 4.85, 25.0);
        twins.capture.endPolled(kPolled);
        const ChannelId polled = *twins.capture.find(kPolled, capture::ChannelInfo::Kind::Polled);
        twins.forBoth([polled](ScopeView &view) {
            if (!view.channels().contains(polled))
                view.addChannel(polled);
            view.fitValues();
        });
        twins.from = 0.3;
        QCOMPARE(twins.difference(), QString());
        twins.from -= 3 * twins.span / twins.rolling.plotRect(0).width();
        QCOMPARE(twins.difference(), QString());
    }
};

QTEST_MAIN(TestScopeRoll)
#include "tst_scope_roll.moc"
