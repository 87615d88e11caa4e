// The trace of set-points as they were sent, in the real window, beside what the simulated board's firmware followed:
// on the way to a first speed, on the next, where its ramp is stopped, and behind a Stop.
#include "support/window_rig.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/control/panel.h"
#include "widgets/scope/view.h"

#include <QAction>
#include <QCheckBox>

#include <algorithm>
#include <cmath>
#include <vector>

using drive::MotorState;

class TestSetPointsSent : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theTraceIsWhatTheBoardFollows();

private:
    struct Sent {
        double seconds, ahead_s;
    };

    widgets::Device &device() { return m_rig->workbench.device(); }
    std::optional<capture::ChannelId> trace()
    {
        for (const capture::ChannelInfo &info : m_rig->workbench.capture().channels())
            if (info.name == "SPEED_SENT")
                return info.id;
        return {};
    }
    std::optional<double> at(double seconds)
    {
        return m_rig->workbench.capture().valueAt(*trace(), seconds);
    }
    double drawnUntil() { return m_rig->workbench.eventRecorder().now() - 0.4; }
    void send(const char *rpm)
    {
        const std::size_t before = m_sent.size();
        auto *speed = m_rig->window.findChild<widgets::ControlPanel *>()->speed();
        speed->setText(QLatin1String(rpm));
        QTest::keyClick(speed, Qt::Key_Return);
        QTRY_COMPARE(m_sent.size(), before + 1);
    }
    void waitUntilDrawn(double seconds) { QTRY_VERIFY_WITH_TIMEOUT(drawnUntil() > seconds, 15000); }
    QString falseAt();

    std::vector<std::pair<double, double>> m_truth; ///< of the session's thread, until that ended
    std::vector<Sent> m_sent;
    std::unique_ptr<facts::WindowRig> m_rig;
};

/// The first instant of the trace at which the firmware followed something else; empty: there is none.
QString TestSetPointsSent::falseAt()
{
    constexpr double kAround_s = 0.03, kRounded_rpm = 8.0;
    const auto span = m_rig->workbench.capture().timeSpan(*trace());
    int compared = 0;
    for (double seconds = span->from; seconds < span->to; seconds += 0.01) {
        const auto drawn = at(seconds);
        if (!drawn)
            continue;
        const double here = seconds - m_sent.back().ahead_s;
        const auto later = [](double time, const auto &entry) { return time < entry.first; };
        auto from = std::upper_bound(m_truth.begin(), m_truth.end(), here - kAround_s, later);
        const auto to = std::upper_bound(m_truth.begin(), m_truth.end(), here + kAround_s, later);
        if (from == m_truth.begin() || to == m_truth.end())
            continue;
        const auto [least, most] = std::minmax_element(std::prev(from), std::next(to),
            [](const auto &a, const auto &b) { return a.second < b.second; });
        ++compared;
        if (*drawn < least->second - kRounded_rpm || *drawn > most->second + kRounded_rpm)
            return QStringLiteral("%1 s behind the first: %2 rpm, and %3 to %4 were followed")
                .arg(QString::number(seconds - m_sent.front().seconds), QString::number(*drawn),
                    QString::number(least->second), QString::number(most->second));
    }
    return compared > 100 ? QString() : QStringLiteral("%1 compared").arg(compared);
}

void TestSetPointsSent::theTraceIsWhatTheBoardFollows()
{
    m_rig = std::make_unique<facts::WindowRig>();
    m_rig->boards.truthOfFirst = [this](TimePoint now, const simulation::MotorTruth &is) {
        m_truth.emplace_back(toSeconds(now.time_since_epoch()), is.referenceRpm);
    };
    m_rig->sayYesToMotion();
    connect(
        &m_rig->workbench.setPoints(), &session::SetPointTap::left, this,
        [this](const drive::SentSetPoint &sent) {
            m_sent.push_back({sent.seconds, sent.ahead_s});
        },
        Qt::QueuedConnection);
    QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
    QTest::mouseClick(m_rig->find<QPushButton>("connect"), Qt::LeftButton);
    QTRY_VERIFY(device().answering() && device().identified());
    QTRY_COMPARE(device().status(1).state, MotorState::Idle);
    QTest::keyClick(m_rig->find<QCheckBox>("arm"), Qt::Key_Space);
    QTRY_VERIFY(device().armed());
    QTRY_VERIFY(m_rig->find<QPushButton>("start")->isEnabled());
    QTest::mouseClick(m_rig->find<QPushButton>("start"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(device().status(1).state, MotorState::Running, 15000);
    m_rig->find<QAction>("setPointsAsSent")->trigger();
    m_rig->find<widgets::NumberEdit>("rampTime")->setValue(1000.0);

    // What boards hold is whole tenths of a Hz.
    send("2580"); // where it starts was not sent
    const double first = m_sent.back().seconds;
    waitUntilDrawn(first + 1.5);
    QVERIFY(trace());
    QVERIFY(m_rig->window.scope()->plotOf(*trace()) >= 0);
    QVERIFY(!at(first + 0.02) && !at(first + 0.5) && !at(first + 0.95));
    QCOMPARE(at(first + 1.05), std::optional(2580.0));

    send("1620");
    const double second = m_sent.back().seconds;
    waitUntilDrawn(second + 1.3);
    QVERIFY2(std::abs(at(second + 0.5).value_or(0.0) - 2100.0) < 2.0,
        qPrintable(QString::number(at(second + 0.5).value_or(0.0))));

    send("2580");
    const double third = m_sent.back().seconds;
    QTRY_VERIFY(m_rig->workbench.eventRecorder().now() > third + 0.3);
    QTest::mouseClick(m_rig->find<QPushButton>("stopRamp"), Qt::LeftButton);
    waitUntilDrawn(third + 2.0);
    const auto held = at(third + 1.5);
    QVERIFY(held && *held > 1650.0 && *held < 2550.0);
    const auto &events = m_rig->workbench.events().events();
    QVERIFY(std::any_of(events.begin(), events.end(), [](const widgets::ScopeEvent &event) {
        return event.text.startsWith(QStringLiteral("Stop ramp; at the board within"));
    }));

    const double stopped = m_rig->workbench.eventRecorder().now();
    QTest::keyClick(&m_rig->window, Qt::Key_Escape);
    waitUntilDrawn(stopped + 1.0);
    QVERIFY(at(stopped - 0.1));
    QVERIFY(!at(stopped + 0.5));
    device().close(); // the session's thread looks no more
    QTRY_VERIFY(!device().portOpen());
    const QString wrong = falseAt();
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    m_rig.reset();
}

QTEST_MAIN(TestSetPointsSent)
#include "tst_set_points_sent.moc"
