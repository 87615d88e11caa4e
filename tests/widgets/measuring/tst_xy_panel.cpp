// XY pictures in the real window: which signals go over which, what is drawn around them, and that it follows the
// scope.
#include "support/scope_window.h"
#include "widgets/measuring/xy_panel.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/trigger/control.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>

#include <cmath>
#include <numbers>

using widgets::XyPanel;
using widgets::XyPlot;

namespace {
constexpr double kAmps = 1000.0;

/// Phase A (0) or B (1) of a turning current vector of 1000 A, 20 turns a second; a digit of B is 2 A.
int phase(int signal, int tick)
{
    const double angle = 2 * std::numbers::pi * 20 * tick / 1000.0;
    const double amps = kAmps * std::cos(angle - signal * 2 * std::numbers::pi / 3);
    return int(std::lround(signal == 0 ? amps : amps / 2));
}
} // namespace

class TestXyPanel : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        QLocale::setDefault(QLocale::c());
        m_rig = std::make_unique<facts::ScopeWindow>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        m_rig->record(2000, phase);
        view().setRunning(false);
        view().setVisibleRange(0.0, 2.0);
        m_rig->draw();
        QTest::keyClick(&m_rig->window, Qt::Key_X, Qt::ControlModifier | Qt::ShiftModifier);
        update();
    }
    void cleanup() { m_rig.reset(); }

    void phaseCurrentsAreACircle();
    void aUnitIsAsLongOnBothAxes();
    void thePictureAndTheCursorsBoundIt();
    void anyTraceGoesOverAnyOther();
    void theBusLimitsVoltages();
    void whatIsMissingIsSaid();
    void ofSeveralMotorsItIsTheChosenOne();
    void strokesFollowThePixels();
    void aGapBreaksTheLine();
    void itFollowsTheRecordThatIsShown();
    void keysMoveIt();
    void aHiddenPanelComputesNothing();

private:
    widgets::ScopeView &view() { return m_rig->scope(); }
    XyPanel &panel() { return *m_rig->window.findChild<XyPanel *>(); }
    XyPlot &plot() { return *m_rig->window.findChild<XyPlot *>(); }
    QString note() { return m_rig->find<QLabel>("xyNote")->text(); }
    QString why()
    {
        auto *label = m_rig->find<QLabel>("xyPlotWhy");
        return label->isVisible() ? label->text() : QString();
    }
    void choose(XyPanel::Kind kind)
    {
        m_rig->find<QComboBox>("xyKind")->setCurrentIndex(int(kind));
        update();
    }
    void update()
    {
        const auto beatUntilSettled = [this] {
            Q_EMIT m_rig->workbench.heartbeat({});
            return panel().settled();
        };
        QTRY_VERIFY(beatUntilSettled());
    }
    /// The colour of a point of the picture, in the units of its axes.
    QColor at(double x, double y)
    {
        const auto ranges = plot().ranges();
        const QRect area = plot().area();
        const QImage picture = plot().grab().toImage();
        const QPointF place(
            area.left() + (x - ranges.left) / (ranges.right - ranges.left) * area.width(),
            area.bottom() - (y - ranges.bottom) / (ranges.top - ranges.bottom) * area.height());
        QColor best = picture.pixelColor(place.toPoint());
        for (int dx = -2; dx <= 2; ++dx) { // the line is one pixel wide
            for (int dy = -2; dy <= 2; ++dy) {
                const QColor near = picture.pixelColor(place.toPoint() + QPoint(dx, dy));
                if (near.saturation() > best.saturation())
                    best = near;
            }
        }
        return best;
    }
    bool inked(double x, double y) { return at(x, y).saturation() > 100; }
    capture::ChannelId addChannel(const char *name, const char *unit, double (*value)(int))
    {
        capture::Capture &capture = m_rig->workbench.capture();
        const auto id = capture.addImported(name, unit);
        for (int i = 0; i < 2000; ++i)
            capture.appendImported(id, i * 1'000'000LL, value(i), (i + 1) * 1'000'000LL);
        view().addChannel(id);
        return id;
    }

    std::unique_ptr<facts::ScopeWindow> m_rig;
};

void TestXyPanel::phaseCurrentsAreACircle()
{
    m_rig->find<QComboBox>("xyTrail")->setCurrentIndex(1); // all alike
    for (int i = 0; i < 8; ++i) {
        const double angle = 0.3 + i * std::numbers::pi / 4;
        QVERIFY2(inked(kAmps * std::cos(angle), kAmps * std::sin(angle)),
            qPrintable(QString::number(i)));
        QVERIFY(!inked(0.5 * kAmps * std::cos(angle), 0.5 * kAmps * std::sin(angle)));
    }
    QVERIFY2(note().contains(QStringLiteral("I_A and I_B")), qPrintable(note()));
    QVERIFY2(note().startsWith(QStringLiteral("Newest: 1000"))
            || note().startsWith(QStringLiteral("Newest: 999")),
        qPrintable(note()));
    m_rig->find<QComboBox>("xyTrail")->setCurrentIndex(2); // the newest only
    QVERIFY(!inked(0.0, kAmps));
}

void TestXyPanel::aUnitIsAsLongOnBothAxes()
{
    const auto equal = [this] {
        const auto r = plot().ranges();
        const double x = (r.right - r.left) / plot().area().width();
        const double y = (r.top - r.bottom) / plot().area().height();
        return std::abs(x / y - 1.0) < 0.02;
    };
    QVERIFY(equal());
    m_rig->window.resize(900, 900);
    QVERIFY(equal());
    choose(XyPanel::Kind::Any);
    QVERIFY(equal());
    m_rig->find<QCheckBox>("xyEqual")->setChecked(false);
    QVERIFY(!equal());
}

void TestXyPanel::thePictureAndTheCursorsBoundIt()
{
    QVERIFY2(note().contains(QStringLiteral("2000 point")), qPrintable(note()));
    view().setVisibleRange(0.0, 0.5);
    update();
    QVERIFY2(note().contains(QStringLiteral("500 point")), qPrintable(note()));
    auto *range = m_rig->find<QComboBox>("xyRange");
    range->setCurrentIndex(1);
    Q_EMIT range->activated(1);
    update();
    QVERIFY2(note().contains(QStringLiteral("100 point")), qPrintable(note()));
    range->setCurrentIndex(2);
    Q_EMIT range->activated(2);
    QVERIFY(view().cursors().visible());
    view().cursors().move(widgets::CursorEnd::A, 0.3); // either order
    view().cursors().move(widgets::CursorEnd::B, 0.1);
    update();
    QVERIFY2(note().contains(QStringLiteral("200 point")), qPrintable(note()));
}

void TestXyPanel::anyTraceGoesOverAnyOther()
{
    QVERIFY(!m_rig->find<QWidget>("xyX")->isVisible());
    addChannel("RAMP", "V", [](int i) { return i * 0.01; });
    choose(XyPanel::Kind::Any);
    QVERIFY(m_rig->find<QWidget>("xyX")->isVisible());
    auto *x = m_rig->find<QComboBox>("xyX");
    auto *y = m_rig->find<QComboBox>("xyY");
    x->setCurrentIndex(x->findText(QStringLiteral("RAMP")));
    y->setCurrentIndex(y->findText(QStringLiteral("RAMP")));
    m_rig->find<QComboBox>("xyTrail")->setCurrentIndex(1);
    update();
    QVERIFY(inked(10.0, 10.0));
    QVERIFY(!inked(10.0, 5.0));
    QVERIFY(plot().ranges().left <= 0.0 && plot().ranges().right >= 19.99);
}

void TestXyPanel::theBusLimitsVoltages()
{
    addChannel("V_ALPHA", "V", [](int i) { return 5.0 * std::cos(i * 0.1); });
    addChannel("V_BETA", "V", [](int i) { return 5.0 * std::sin(i * 0.1); });
    choose(XyPanel::Kind::VoltageAlphaBeta);
    QVERIFY2(note().contains(QStringLiteral("not known")), qPrintable(note()));
    QVERIFY(plot().ranges().top < 10.0);
    const auto watched = panel().watchedRegisters(); // the board is asked for it
    QCOMPARE(watched, std::vector<catalog::RegisterId>{facts::kVoltage});
    m_rig->workbench.registers().accept(
        {{facts::kVoltage, drive::ReadStatus::Ok, std::int64_t(24), {}}}, m_rig->workbench.now());
    update();
    QVERIFY2(note().contains(QStringLiteral("Dashed")), qPrintable(note()));
    QVERIFY(plot().ranges().top >= 24.0 / std::sqrt(3.0));
    choose(XyPanel::Kind::CurrentAlphaBeta);
    QVERIFY(panel().watchedRegisters().empty());
}

void TestXyPanel::whatIsMissingIsSaid()
{
    choose(XyPanel::Kind::VoltageDq);
    QVERIFY2(why().contains(QStringLiteral("V_D")), qPrintable(why()));
    choose(XyPanel::Kind::VoltageAlphaBeta); // not there either, and it is said which
    QVERIFY2(why().contains(QStringLiteral("V_ALPHA")), qPrintable(why()));
    choose(XyPanel::Kind::CurrentAlphaBeta);
    QCOMPARE(why(), QString());
    view().setVisibleRange(100.0, 101.0);
    update();
    QVERIFY2(why().contains(QStringLiteral("same time")), qPrintable(why()));
}

void TestXyPanel::ofSeveralMotorsItIsTheChosenOne()
{
    choose(XyPanel::Kind::CurrentDq);
    addChannel("I_D_MEAS@1", "A", [](int) { return 1.0; });
    addChannel("I_D_MEAS@2", "A", [](int) { return 3.0; });
    addChannel("I_Q_MEAS@2", "A", [](int) { return 4.0; });
    update();
    QVERIFY2(!why().isEmpty(), "motor 1 is chosen, and has only one of them");
    drive::Identified board = facts::identified();
    board.identity.motors = 2;
    facts::feed(m_rig->device(), {board});
    m_rig->device().setMotor(2);
    update();
    QCOMPARE(why(), QString());
    QVERIFY2(note().startsWith(QStringLiteral("Newest: 5")), qPrintable(note()));
    capture::Capture file; // says nothing about what is chosen
    for (const auto &[name, value] : {std::pair{"V_D@1", 6.0}, {"V_Q@1", 8.0}}) {
        const auto id = file.addImported(name, "V");
        for (int i = 0; i < 100; ++i)
            file.appendImported(id, i * 1'000'000LL, value, (i + 1) * 1'000'000LL);
    }
    m_rig->window.selection()->showFile(std::move(file));
    choose(XyPanel::Kind::VoltageDq);
    QVERIFY2(note().startsWith(QStringLiteral("Newest: 10")), qPrintable(note()));
}

void TestXyPanel::strokesFollowThePixels()
{
    m_rig->record(400'000, phase);
    view().setVisibleRange(0.0, 402.0);
    m_rig->find<QComboBox>("xyTrail")->setCurrentIndex(1);
    update();
    (void)plot().grab();
    const int pixels = plot().area().width() + plot().area().height();
    QVERIFY2(plot().strokes() > 100 && plot().strokes() <= 9 * pixels,
        qPrintable(QString::number(plot().strokes())));
    QVERIFY2(note().contains(QStringLiteral("each of")), qPrintable(note()));
    capture::Capture &capture = m_rig->workbench.capture();
    const std::array ids{m_rig->id(facts::kCurrentA), m_rig->id(facts::kCurrentB)};
    m_rig->record(int(widgets::kMostXySamples), phase);
    const auto answer = widgets::computeXy(
        capture.snapshot(ids), {ids[0], ids[1], true, 0, 10'000'000'000'000LL, 0, 1000});
    QVERIFY(answer.cut); // only the newest of them are looked at
    QVERIFY(answer.trace.points.size() <= 1001);
    QVERIFY(capture::toSeconds(answer.trace.points.front().time) >= 401.9);
}

void TestXyPanel::aGapBreaksTheLine()
{
    m_rig->lose(100);
    m_rig->record(100,
        [](int signal, int tick) { return signal == 0 ? phase(0, tick) + 3000 : phase(1, tick); });
    view().setVisibleRange(1.9, 2.2);
    m_rig->find<QComboBox>("xyTrail")->setCurrentIndex(1);
    update();
    int between = 0; // no line from the one circle to the other
    for (double y = -900; y <= 900; y += 100)
        between += inked(1500.0, y) ? 1 : 0;
    QCOMPARE(between, 0);
}

void TestXyPanel::itFollowsTheRecordThatIsShown()
{
    auto *trigger = m_rig->window.findChild<widgets::TriggerControl *>();
    widgets::TriggerSetup setup = trigger->trigger().setup();
    setup.mode = scope::Mode::Normal;
    setup.level = 0.0;
    setup.hysteresis = 1.0;
    setup.length = 0.2;
    trigger->setSetup(setup);
    m_rig->record(1000, phase);
    QVERIFY(trigger->shown());
    update();
    QVERIFY2(note().contains(QStringLiteral("200 point")), qPrintable(note()));
}

void TestXyPanel::keysMoveIt()
{
    plot().setFocus();
    const auto before = plot().ranges();
    const auto scope = view().visibleRange();
    QTest::keyClick(&plot(), Qt::Key_Plus);
    QVERIFY(plot().ranges().right - plot().ranges().left < (before.right - before.left) * 0.8);
    const auto zoomed = plot().ranges();
    QTest::keyClick(&plot(), Qt::Key_Right);
    QVERIFY(plot().ranges().left > zoomed.left);
    QTest::keyClick(&plot(), Qt::Key_Up);
    QVERIFY(plot().ranges().top > zoomed.top);
    const auto moved = plot().ranges();
    QTest::keyClick(&plot(), Qt::Key_Plus, Qt::AltModifier); // not the plot's
    QCOMPARE(plot().ranges().left, moved.left);
    QTest::keyClick(&plot(), Qt::Key_Minus, Qt::KeypadModifier);
    QVERIFY(plot().ranges().left < moved.left);
    QTest::keyClick(&plot(), Qt::Key_F);
    QCOMPARE(plot().ranges().left, before.left);
    QCOMPARE(view().visibleRange().from, scope.from); // the scope has the same keys
    QCOMPARE(view().visibleRange().to, scope.to);
}

void TestXyPanel::aHiddenPanelComputesNothing()
{
    m_rig->find<QWidget>("xyDock")->hide();
    view().setVisibleRange(1.0, 2.0);
    m_rig->draw();
    Q_EMIT m_rig->workbench.heartbeat({});
    QVERIFY(!panel().settled());
}

QTEST_MAIN(TestXyPanel)
#include "tst_xy_panel.moc"
