// A day at the bench in twenty minutes: the real window beside a board in a process of its own, through what an
// engineer does from the first connection to the last recording. Prints for each act what the program computed, how
// often the scope was drawn, its longest beat and the memory it holds; docs/performance.md shows one such day.
//
//   rotorscope-day [SECONDS an act]
#include "bench/latency/simulated_board_posix.h"
#include "bench/soak/restless_hand.h"
#include "support/watchdog/beats.h"
#include "widgets/measuring/math_channels.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QSpinBox>

#include <cstdio>
#include <ctime>
#include <functional>
#include <vector>

namespace {

using namespace bench;
using support::Beat;

/// Of all threads of the process.
double computedSeconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

class Day {
public:
    explicit Day(int secondsAnAct)
        : m_secondsAnAct(secondsAnAct)
    {
        rig.sayYesToMotion();
        rig.window.resize(1280, 720);
        // The user says yes to what a recording takes the place of.
        m_yes.callOnTimeout(&rig.window, [this] {
            for (const char *name : {"disconnectAndGoOn", "replaceYes", "leaveMarkers"})
                if (auto *button = rig.find<QPushButton>(name); button && button->isVisible())
                    button->click();
        });
        m_yes.start(100);
    }

    struct Act {
        const char *name;
        std::function<bool()> begin; ///< false: it could not be done
        std::function<void(int)> tenTimesASecond = {}; ///< with its number
    };
    bool play(const Act &act)
    {
        if (!act.begin())
            return false;
        QTimer ticks;
        int tick = 0;
        if (act.tenTimesASecond) {
            ticks.callOnTimeout(&rig.window, [&] { act.tenTimesASecond(tick++); });
            ticks.start(100);
        }
        Beat::forget();
        const double cpu = computedSeconds();
        const quint64 redraws = rig.window.scope()->redraws();
        QElapsedTimer clock;
        clock.start();
        QEventLoop loop;
        QTimer::singleShot(std::chrono::seconds(m_secondsAnAct), &loop, &QEventLoop::quit);
        loop.exec();
        const double took = double(clock.nsecsElapsed()) * 1e-9;
        const Beat::Told told = Beat::told();
        std::printf("| %s | %.1f %% | %.1f | %.0f ms | %.0f MiB |\n", act.name,
            (computedSeconds() - cpu) / took * 100.0,
            double(rig.window.scope()->redraws() - redraws) / took, told.longest_s * 1e3,
            residentMiB().value_or(0.0));
        if (told.longest_s > Beat::kLong_s)
            std::fprintf(stderr, "%s: %s\n", act.name, qPrintable(told.what));
        std::fflush(stdout);
        return true;
    }

    bool connect(const QString &port)
    {
        widgets::Device &device = rig.workbench.device();
        device.open(session::Endpoint{.kind = session::Endpoint::Kind::Serial, .path = port});
        return until([&] { return device.answering() && device.identified().has_value(); })
            && until([&] { return rig.workbench.capture().streaming().size() > 1; })
            && showSignals(rig);
    }
    bool startMotor()
    {
        widgets::Device &device = rig.workbench.device();
        device.setArmed(true);
        if (!until([&] { return device.armed(); }))
            return false;
        QTest::mouseClick(rig.find<QPushButton>("start"), Qt::LeftButton);
        return until([&] { return device.status(1).state == drive::MotorState::Running; });
    }
    bool stopMotor()
    {
        rig.workbench.device().stop();
        return until(
            [&] { return rig.workbench.device().status(1).state == drive::MotorState::Idle; });
    }
    bool leave()
    {
        rig.workbench.device().close();
        return until([&] { return !rig.workbench.device().portOpen(); });
    }
    /// To the file of this number, or the end of it.
    bool record(int number)
    {
        rig.files.answer = file(number);
        auto *toggle = rig.find<QAction>("record");
        const bool on = !toggle->isChecked();
        toggle->trigger();
        return until([&] { return toggle->isChecked() == on; });
    }
    bool openRecording(int number)
    {
        rig.files.answer = file(number);
        rig.find<QAction>("openRecording")->trigger();
        const QString said = QStringLiteral("Opened ") + file(number);
        return until([&] { return rig.find<QLabel>("bannerText")->text().contains(said); });
    }
    bool open(const char *dock)
    {
        trigger((std::string(dock) + "Open").c_str());
        return true;
    }
    void trigger(const char *action) { rig.find<QAction>(action)->trigger(); }
    void choose(const char *box, int index) { rig.find<QComboBox>(box)->setCurrentIndex(index); }
    void mode(const char *name)
    {
        auto *modes = rig.find<QComboBox>("triggerMode");
        modes->setCurrentIndex(modes->findText(QLatin1String(name)));
        Q_EMIT modes->activated(modes->currentIndex());
    }
    void setFormulas(int count)
    {
        QList<widgets::MathFormula> all;
        for (int i = 0; i < count; ++i)
            all.append({QStringLiteral("M%1").arg(i + 1),
                QStringLiteral("I_Q_MEAS * %1 + I_A").arg(i + 1), true});
        rig.workbench.math().setFormulas(all);
    }
    bool toScreen(double ratio, QSize size)
    {
        for (QScreen *screen : QGuiApplication::screens())
            if (screen->devicePixelRatio() == ratio) {
                rig.window.setScreen(screen);
                rig.window.move(screen->geometry().topLeft());
                rig.window.resize(size);
                return true;
            }
        return false;
    }

    facts::WindowRig rig;
    std::unique_ptr<Hand> hand;

private:
    QString file(int number) const
    {
        return m_folder.filePath(QStringLiteral("%1.pcapng").arg(number));
    }

    const int m_secondsAnAct;
    QTemporaryDir m_folder;
    QTimer m_yes;
};

int live(int secondsAnAct)
{
    const SimulatedBoard board;
    Day day(secondsAnAct);
    if (!board.started())
        return 1;
    const QSize full(1920, 1080);
    const std::vector<Day::Act> acts{
        {"connected, the motor at rest", [&] { return day.connect(board.port()); }},
        {"the motor runs, five signals at 16 kHz", [&] { return day.startMotor(); }},
        {"first recording", [&] { return day.record(1); }},
        {"its spectrum, Blackman-Harris",
            [&] {
                day.open("spectrumDock");
                day.choose("spectrumWindow", 2);
                return true;
            }},
        {"XY of the picture",
            [&] {
                day.open("xyDock");
                day.choose("xyKind", 4);
                return true;
            }},
        {"16 math channels",
            [&] {
                day.setFormulas(16);
                return true;
            }},
        {"zoomed and dragged without a pause",
            [&] {
                day.setFormulas(0);
                day.hand = std::make_unique<Hand>(day.rig);
                return true;
            }},
        {"second recording, a trigger, 16 records behind",
            [&] {
                day.hand.reset();
                day.mode("Normal");
                day.rig.find<QSpinBox>("persistence")->setValue(16);
                return day.record(1) && day.record(2);
            }},
        {"resized ten times a second",
            [&] {
                day.rig.find<QSpinBox>("persistence")->setValue(0);
                day.mode("Roll");
                return true;
            },
            [&](int tick) { day.rig.window.resize(1280 + tick % 64 * 10, 720 + tick % 36 * 10); }},
        {"4K at 200 %", [&] { return day.toScreen(2.0, full); }},
        {"hidden",
            [&] {
                day.rig.window.hide();
                return true;
            }},
        {"seen again, third recording",
            [&] {
                day.rig.window.show();
                return day.toScreen(1.0, full) && day.record(2) && day.record(3);
            }},
        {"the motor stopped", [&] { return day.stopMotor() && day.record(3); }},
        {"first recording opened", [&] { return day.openRecording(1); }},
        {"zoomed and dragged",
            [&] {
                day.hand = std::make_unique<Hand>(day.rig);
                return true;
            }},
        {"second recording opened, fully out",
            [&] {
                day.hand.reset();
                return day.openRecording(2);
            }},
        {"third recording opened, from trigger to trigger", [&] { return day.openRecording(3); },
            [&](int tick) {
                if (tick % 10 == 0)
                    day.trigger("nextTrigger");
            }},
        {"connected again, the motor runs",
            [&] { return day.connect(board.port()) && day.startMotor(); }},
        {"stopped", [&] { return day.stopMotor(); }},
        {"disconnected", [&] { return day.leave(); }},
    };
    std::printf("| Act | a core | redraws/s | longest beat | memory |\n|---|---|---|---|---|\n");
    for (const Day::Act &act : acts)
        if (!day.play(act)) {
            std::fprintf(stderr, "rotorscope-day: %s: that could not be done\n", act.name);
            return 1;
        }
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    support::Watched<widgets::Application> app(argc, argv);
    const int seconds = argc > 1 ? QString::fromLocal8Bit(argv[1]).toInt() : 60;
    return seconds > 0 ? live(seconds) : 1;
}
