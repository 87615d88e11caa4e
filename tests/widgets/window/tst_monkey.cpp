// A monkey at the real window: sessions of random input (keys, clicks, wheel, drags, typing, questions answered either
// way, writes, undo, restores, ports unplugged, boards reset, threads frozen, clocks that jump), one and two motors,
// four protocols, with two judges beside it: of the wire, and of what the screen says. Acts are input events; what
// leaves must follow from them, and what is shown must be true. ROTORSCOPE_LONG=1 runs 1,000 sessions of 200 acts; a
// failure names its seed and the acts that it needs, as far as they are found in a minute; ROTORSCOPE_SEED=n runs that
// one, n-m those from n to m, with ROTORSCOPE_ACTS=3,17 these acts alone.
#include "support/fewer_acts.h"
#include "support/judged_line.h"
#include "support/link_pair.h"
#include "support/screen/screen_judge.h"
#include "support/seeds.h"
#include "support/window_rig.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFileInfo>
#include <QLineEdit>
#include <QPointer>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <QWheelEvent>

#include <cstdio>
#include <deque>
#include <numeric>

using judge::Act;
using support::JudgedWorld;
using support::Random;
using namespace std::chrono_literals;

namespace {

struct Kind {
    drive::Protocol protocol;
    const char *word, *profile;
    int motors;
    std::uint32_t baud;
    double stepRpm; ///< in which it keeps set-points, at least whole numbers
};
constexpr Kind kKinds[] = {{drive::Protocol::Mcp, "mcp", "mcsdk-6.4", 1, 1843200, 6.0},
    {drive::Protocol::Mcp, "mcp", "mcsdk-6.4", 2, 1843200, 6.0},
    {drive::Protocol::Fcp, "legacy", "legacy", 1, 115200, 6.0},
    {drive::Protocol::Mcp, "mcp", "mcsdk-6.2", 1, 1843200, 6.0},
    {drive::Protocol::PowerPc, "powerpc", "powerpc", 2, 115200, 6.0},
    {drive::Protocol::Mcb, "mcb", "mcsdk-6.4", 1, 1843200, 1.0}};

simulation::BoardOptions boardOf(const Kind &kind, std::uint64_t seed)
{
    simulation::BoardOptions options;
    options.profile = kind.profile;
    options.motors = kind.motors;
    options.baud = kind.baud;
    options.seed = seed;
    options.hfHz = 4000.0; // so that the computer keeps up with the motors
    return options;
}

widgets::Settings settingsOf(const Kind &kind)
{
    widgets::Settings settings = facts::WindowRig::quietSettings();
    settings.port = QStringLiteral("/dev/ttyMonkey");
    settings.baud = kind.baud;
    settings.protocol = QLatin1String(kind.word);
    settings.maxSpeedRpm = 2500.0;
    settings.samplesOnDiskGB = 0.0;
    return settings;
}

/// The window lives on for a while.
void live(int ms)
{
    QEventLoop loop;
    QTimer::singleShot(ms, &loop, &QEventLoop::quit);
    loop.exec();
}

class Monkey {
public:
    explicit Monkey(std::uint64_t seed)
        : m_seed(seed)
        , m_random(seed)
        , m_kind(kKinds[seed % std::size(kKinds)])
        , m_habit(static_cast<int>(seed % 8))
        , m_world(boardOf(m_kind, seed), m_kind.protocol)
        , m_rig(settingsOf(m_kind), session::makeDiskSink, m_world.parts())
        , m_acts(m_world, m_rig.window, m_rig.workbench.device())
        , m_screen(m_rig.window, m_world, m_kind.motors)
    {
        m_rig.files.answer = m_folder.filePath(QStringLiteral("file"));
        m_rig.window.resize(1280, 800);
        m_popups.callOnTimeout(&m_rig.window, [] {
            if (QWidget *popup = QApplication::activePopupWidget())
                popup->close(); // a menu has a loop of its own, in which no monkey acts
        });
        m_popups.start(20);
    }

    /// What went wrong; empty if nothing did.
    /// @param acts  their numbers; each is the same whichever others there are, as far as the window is
    std::string run(const std::vector<int> &acts)
    {
        rest(50);
        m_world.cut = m_random.chance(0.05); // no answers at first
        click("connect");
        if (m_world.cut) {
            rest(9000); // until it is told
            look();
            m_world.cut = false;
        }
        for (int i = 0; i < 100 && !device().identified(); ++i)
            rest(20);
        for (const int i : acts) {
            if (!verdict().empty())
                break;
            m_random = Random(m_seed * 1'000'003 + static_cast<std::uint64_t>(i));
            note("act " + std::to_string(i));
            if (i < 5 && m_random.chance(0.7))
                goOnPurpose(); // the user comes to turn a motor
            else
                act();
            rest(static_cast<int>(m_random.chance(0.04) ? 1000 : m_random.below(50)));
            look();
        }
        leave();
        return verdict();
    }

    std::string story() const
    {
        std::string text = std::string(m_kind.profile) + " over " + m_kind.word + ":";
        // The newest first: long messages are cut.
        for (std::size_t i = m_story.size(); i > 0 && i + 60 > m_story.size(); --i)
            text += "\n  " + m_story[i - 1];
        return text;
    }
    /// What went over the line before the finding.
    std::string tape() { return m_tape.empty() ? m_world.tape() : m_tape; }
    judge::MsRules::Counts counts() { return m_world.counts(); }
    int statements() const { return m_screen.statements(); }
    int tuned() const { return m_tuned; }

private:
    std::string verdict() { return m_untrue.empty() ? m_world.verdict() : m_untrue; }
    /// The second judge.
    void look()
    {
        const std::string untrue = m_screen.look();
        if (!untrue.empty())
            finds(untrue);
    }
    void finds(const std::string &untrue)
    {
        if (m_untrue.empty() && !untrue.empty()) {
            qWarning().noquote() << "the judge: untrue:" << QString::fromStdString(untrue);
            m_tape = m_world.tape();
        }
        if (m_untrue.empty())
            m_untrue = untrue;
    }

    widgets::Device &device() { return m_rig.workbench.device(); }

    void rest(int ms)
    {
        live(ms);
        m_acts.noteArming();
    }

    void note(const std::string &what) { m_story.push_back(what); }

    QWidget *top() const
    {
        QWidget *modal = QApplication::activeModalWidget();
        return modal != nullptr ? modal : const_cast<widgets::MainWindow *>(&m_rig.window);
    }

    void press(QWidget *widget, const std::string &what)
    {
        note(what);
        if (widget->objectName() == QLatin1String("connect") && device().portOpen())
            m_screen.closes();
        if (widget->objectName() == QLatin1String("triggerForce")
            || widget->objectName() == QLatin1String("stopRamp")) // a set-point, to a servo
            m_screen.forcesTrigger();
        const QPoint at =
            qobject_cast<QCheckBox *>(widget) ? QPoint(8, widget->height() / 2) : QPoint();
        const QPointer<QWidget> pressed = widget; // which may be gone with its dialog
        QTest::mousePress(pressed, Qt::LeftButton, {}, at);
        if (pressed)
            QTest::mouseRelease(pressed, Qt::LeftButton, {}, at);
        m_acts.noteArming();
    }
    bool click(const char *name)
    {
        // There may be one on each of several pages.
        for (auto *button : m_rig.window.findChildren<QAbstractButton *>(QLatin1String(name)))
            if (button->isVisible() && button->isEnabled()) {
                press(button, std::string("click ") + name);
                return true;
            }
        return false;
    }
    void key(QWidget *widget, Qt::Key which, Qt::KeyboardModifiers modifiers = {})
    {
        note("key " + std::to_string(which));
        if (which == Qt::Key_D && modifiers == Qt::ControlModifier && device().portOpen())
            m_screen.closes();
        QTest::keyClick(widget, which, modifiers);
        m_acts.noteArming();
    }

    template <class T>
    T *anyOf()
    {
        QList<T *> all = top()->findChildren<T *>();
        all.removeIf([](T *one) { return !one->isVisible() || !one->isEnabled(); });
        return all.isEmpty()
            ? nullptr
            : all[qsizetype(m_random.below(static_cast<std::uint64_t>(all.size())))];
    }

    void shortFault()
    {
        note("short fault");
        m_world.shortFault = true;
        rest(2800);
    }
    /// What some people do again and again.
    void habit()
    {
        switch (m_habit) {
        case 0: // starts at once what was stopped
            click("stop");
            rest(400 + int(m_random.below(400)));
            goOnPurpose();
            goOnPurpose();
            for (int i = 0; i < 8; ++i) {
                rest(300);
                look();
            }
            return;
        case 1: // has a loose cable, and looks at the other motor
            if (auto *box = m_rig.find<QComboBox>("motor"); box != nullptr && box->isVisible()) {
                note("other motor");
                box->setFocus();
                key(box, m_random.chance(0.7) ? Qt::Key_Down : Qt::Key_Up);
                look();
            }
            if (m_random.chance(0.3))
                return pullCable();
            note("loose cable");
            m_world.cut = true;
            rest(700 + int(m_random.below(1500)));
            if (m_random.chance(0.4)) { // and goes to look for it: all that is shown is old then
                rest(3000);
                look();
            }
            m_world.cut = false;
            for (int i = 0; i < 30; ++i) {
                rest(20);
                look();
            }
            return;
        case 2: // looks from one motor to the other
            choose();
            return goOnPurpose();
        case 3: // waits for the list
            shortFault();
            click("acknowledge");
            if (!m_random.chance(0.5))
                return;
            rest(static_cast<int>(m_random.below(60))); // it comes back at once
            return shortFault();
        case 4:
            return tune();
        case 5: // compares two boards
            return swapBoards();
        case 6: // waits for what comes
            return awaitTrigger();
        default:
            if (m_random.chance(0.5))
                return record();
            awaitPicture();
            return exportCsv();
        }
    }
    /// To another board at the same port, and back.
    void swapBoards()
    {
        if (m_kind.protocol != drive::Protocol::Mcp || top() != &m_rig.window)
            return goOnPurpose();
        for (const char *motor : {"servo24", "pm24"}) {
            note(std::string("another board: ") + motor);
            key(&m_rig.window, Qt::Key_Escape);
            rest(600);
            if (device().portOpen())
                click("connect");
            for (int i = 0; i < 50 && device().portOpen(); ++i) {
                rest(50);
                answerYes();
            }
            if (device().portOpen())
                return;
            m_world.swapAtOpening(motor);
            click("connect");
            for (int i = 0; i < 100 && !device().answering(); ++i)
                rest(20);
            goOnPurpose();
            goOnPurpose();
            for (int i = 0; i < 9; ++i) {
                rest(350);
                look();
            }
        }
    }
    bool chooseIn(const char *name, const QString &wanted)
    {
        auto *box = m_rig.find<QComboBox>(name);
        if (box == nullptr || !box->isVisible() || !box->isEnabled() || box->findText(wanted) < 0)
            return false;
        note("choose " + wanted.toStdString() + " in " + name);
        box->setFocus();
        key(box, Qt::Key_Home);
        for (int i = 0; i < box->count() && box->currentText() != wanted; ++i)
            key(box, Qt::Key_Down);
        return box->currentText() == wanted;
    }
    /// Arms the trigger for something, lets it come and looks at what is said of it.
    void awaitTrigger()
    {
        const auto which = m_random.below(3);
        static const char *const types[] = {"Fault", "Set-point", "Edge"};
        if (top() != &m_rig.window || !chooseIn("triggerMode", QStringLiteral("Normal"))
            || !chooseIn("triggerType", QLatin1String(types[which])))
            return goOnPurpose();
        m_screen.forcesTrigger(); // it waits anew, also where the same was chosen already
        for (int i = 0; i < 6; ++i) {
            rest(300);
            look();
        }
        if (which == 0) {
            note("short fault");
            m_world.shortFault = true;
        } else if (which == 1) {
            goOnPurpose();
            setPoint();
        }
        for (int i = 0; i < 11; ++i) {
            rest(300);
            look();
        }
        click("acknowledge");
        chooseIn("triggerMode", QStringLiteral("Roll"));
    }
    /// To a file, which is looked at when it is whole: the samples in it are those that the board sent meanwhile.
    void record()
    {
        auto *toggle = m_rig.find<QAction>("record");
        if (toggle == nullptr || !toggle->isEnabled() || toggle->isChecked()
            || top() != &m_rig.window)
            return goOnPurpose();
        note("record");
        m_rig.files.answer = m_folder.filePath(QStringLiteral("%1.pcapng").arg(++m_files));
        const QString path = m_rig.files.answer;
        m_screen.recordingBegins(path);
        m_world.act(Act::Kind::Input);
        toggle->trigger();
        for (int i = 0; i < 8; ++i) {
            rest(150);
            look();
            if (i == 3 && m_random.chance(0.5)) {
                note("cut");
                m_world.cut = true;
                rest(static_cast<int>(m_random.below(400)));
                m_world.cut = false;
            }
        }
        m_screen.recordingEnds();
        m_world.act(Act::Kind::Input);
        if (toggle->isChecked())
            toggle->trigger();
        for (int i = 0; i < 20 && toggle->isChecked(); ++i)
            rest(20);
        rest(300);
        finds(m_screen.recordedAsSent());
        look();
        if (m_random.chance(0.5))
            openBeside(path);
        // It is not written over.
        m_rig.files.answer = m_folder.filePath(QStringLiteral("other.csv"));
    }
    /// What was recorded, while the board is there: that is asked about, and takes the place of nothing.
    void openBeside(const QString &path)
    {
        if (!device().portOpen() || top() != &m_rig.window)
            return;
        note("open");
        m_rig.files.answer = path;
        m_world.act(Act::Kind::Input);
        m_rig.find<QAction>("openRecording")->trigger();
        for (int i = 0; i < 8; ++i) {
            rest(80);
            look();
        }
        auto *question = m_rig.find<QDialog>("disconnectQuestion");
        if (question != nullptr && m_random.chance(0.7))
            return openInstead(path);
        if (question != nullptr)
            question->reject();
        rest(200);
        look();
    }
    /// The connection goes, and what the scope held.
    void openInstead(const QString &path)
    {
        note("open instead");
        const QString said = QStringLiteral("Opened ") + path;
        m_screen.closes();
        auto *banner = m_rig.find<QLabel>("bannerText");
        for (int i = 0; i < 60 && !(banner->isVisible() && banner->text().contains(said)); ++i) {
            QWidget *modal = QApplication::activeModalWidget();
            for (const char *name : {"disconnectAndGoOn", "replaceYes", "leaveMarkers"})
                if (auto *button =
                        modal ? modal->findChild<QAbstractButton *>(QLatin1String(name)) : nullptr)
                    press(button, name);
            rest(100);
        }
        look();
        if (banner->isVisible() && banner->text().contains(said) && !device().portOpen())
            finds(m_screen.asOfAFile(path));
    }
    /// Once it follows what comes until all that is shown is of one connection.
    void awaitPicture()
    {
        if (top() != &m_rig.window || std::exchange(m_awaited, true))
            return;
        auto *run = m_rig.find<QAction>("scopeRun");
        m_world.act(Act::Kind::Input);
        if (run->isEnabled() && !run->isChecked())
            run->trigger();
        key(m_rig.window.scope(), Qt::Key_End);
        for (int i = 0; i < 50 && !m_screen.canJudgeExports(); ++i) {
            rest(200);
            look();
        }
    }
    /// What the scope shows, as CSV.
    void exportCsv()
    {
        auto *ask = m_rig.find<QAction>("export");
        if (ask == nullptr || !ask->isEnabled() || top() != &m_rig.window
            || !m_screen.canJudgeExports())
            return goOnPurpose();
        note("export");
        const QString path = m_folder.filePath(QStringLiteral("%1.csv").arg(++m_files));
        m_rig.files.answer = path;
        m_world.act(Act::Kind::Input);
        ask->trigger();
        rest(50);
        click("exportSave");
        for (int i = 0; i < 50 && !QFileInfo::exists(path); ++i)
            rest(40);
        finds(m_screen.exportedAsSent(path));
        if (QApplication::activeModalWidget() != nullptr)
            click("exportCancel");
        look();
    }
    void act()
    {
        if (QApplication::activeModalWidget() != nullptr && m_random.chance(0.7))
            return answer();
        if (m_random.chance(0.15))
            return habit();
        switch (m_random.below(26)) {
        case 0:
        case 1:
        case 2:
        case 3:
        case 4:
        case 5:
        case 6:
            return goOnPurpose();
        case 7:
        case 8:
            return setPoint();
        case 9:
            return key(top(), Qt::Key_Escape);
        case 10:
            click("stop");
            return;
        case 11:
        case 12:
            return anyButton();
        case 13:
            return typeAnywhere();
        case 14:
            return wheel();
        case 15:
            return drag();
        case 16:
            return choose();
        case 17:
            return shortcut();
        case 18:
        case 19:
            return lineTrouble();
        case 20:
            return freeze();
        case 21:
            return jog();
        case 24:
            return tune();
        case 25:
            switch (m_random.below(3)) {
            case 0:
                return awaitTrigger();
            case 1:
                return exportCsv();
            default:
                return record();
            }
        case 22:
            click(m_random.chance(0.5) ? "acknowledge" : "stopRamp");
            return;
        default:
            return restore();
        }
    }

    /// What the user comes for: arm, start, a set-point.
    void goOnPurpose()
    {
        if (!device().portOpen()) {
            click("connect");
            return rest(150);
        }
        auto *arm = m_rig.find<QCheckBox>("arm");
        if (arm != nullptr && arm->isEnabled() && !arm->isChecked()) {
            click("arm");
            return rest(20);
        }
        if (click("start")) {
            rest(20);
            if (m_random.chance(0.8))
                answerYes();
            return rest(60);
        }
        setPoint();
    }
    void setPoint()
    {
        auto *edit = m_rig.find<QLineEdit>("speed");
        if (edit == nullptr || !edit->isVisible() || !edit->isEnabled())
            return typeAnywhere();
        edit->setFocus();
        edit->selectAll();
        const auto rpm = static_cast<int>(m_random.below(6000)) - 3000;
        note("set-point " + std::to_string(rpm));
        QTest::keyClicks(edit, QString::number(rpm));
        keepEcho();
        const int before = m_world.counts().setPoints;
        key(edit, Qt::Key_Return);
        rest(20);
        if (m_random.chance(0.6))
            answerYes();
        rest(100);
        const auto counts = m_world.counts();
        if (counts.setPoints == before + 1 && counts.rpm)
            finds(setPointAsSaid(*counts.rpm));
    }
    void keepEcho()
    {
        const auto *label = m_rig.find<QLabel>("speedEcho");
        m_echoes.push_back(label != nullptr ? label->text() : QString());
    }
    /// One of the last fields said so: a question may still have been open about the one before.
    std::string setPointAsSaid(double rpm)
    {
        constexpr std::size_t kOpen = 4;
        while (m_echoes.size() > kOpen)
            m_echoes.pop_front();
        std::string untrue;
        for (const QString &echo : m_echoes) {
            untrue = support::ScreenJudge::setPointAsSaid(echo, rpm, m_kind.stepRpm);
            if (untrue.empty())
                break;
        }
        return untrue;
    }
    void answerYes()
    {
        QWidget *box = QApplication::activeModalWidget();
        if (box == nullptr)
            return;
        // Who enters expert mode types which motor is meant.
        if (auto *typed = box->findChild<QLineEdit *>(QStringLiteral("confirmationTyped"))) {
            const auto *motor = m_rig.find<QComboBox>("motor");
            const int number =
                motor != nullptr && motor->isVisible() ? motor->currentIndex() + 1 : 1;
            typed->setFocus();
            typed->selectAll();
            QTest::keyClicks(typed, QStringLiteral("motor %1").arg(number));
        }
        for (auto *button : box->findChildren<QAbstractButton *>()) {
            const QString name = button->objectName();
            const bool yes =
                name.endsWith(QLatin1String("Confirm")) || name == QLatin1String("writeAnyway");
            if (yes && button->isVisible() && button->isEnabled())
                return press(button, "yes to " + box->objectName().toStdString());
        }
    }
    void answer()
    {
        if (m_random.chance(0.4))
            return answerYes();
        if (m_random.chance(0.2))
            return key(top(), Qt::Key_Escape);
        anyButton();
    }
    void anyButton()
    {
        auto *button = anyOf<QAbstractButton>();
        if (button == nullptr)
            return;
        if (m_random.chance(0.1))
            return key(button, Qt::Key_Space);
        press(button,
            "click " + button->objectName().toStdString() + " \"" + button->text().toStdString()
                + "\"");
    }
    void typeAnywhere()
    {
        auto *edit = anyOf<QLineEdit>();
        if (edit == nullptr || edit->objectName() == QLatin1String("qt_spinbox_lineedit"))
            return;
        if (qobject_cast<QComboBox *>(edit->parentWidget()) != nullptr)
            return; // the port
        static const char *const texts[] = {"0", "1", "-1500", "1e9", "12,5", "nan", "800", "0x10"};
        const char *text = texts[m_random.below(std::size(texts))];
        note("type " + std::string(text) + " into " + edit->objectName().toStdString());
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, QLatin1String(text));
        if (edit->objectName() == QLatin1String("speed"))
            keepEcho();
        key(edit, m_random.chance(0.7) ? Qt::Key_Return : Qt::Key_Tab);
    }
    void wheel()
    {
        auto *widget = anyOf<QWidget>();
        if (widget == nullptr)
            return;
        note("wheel over " + widget->objectName().toStdString());
        const QPointF at(widget->rect().center());
        QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, m_random.chance(0.5) ? 120 : -120},
            Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(widget, &event);
    }
    void drag()
    {
        auto *view = anyOf<QAbstractItemView>();
        if (view == nullptr)
            return;
        note("drag in " + view->objectName().toStdString());
        QWidget *port = view->viewport();
        const QPoint from(10, 10 + int(m_random.below(60)));
        QTest::mousePress(port, Qt::LeftButton, {}, from);
        QTest::mouseMove(port, from + QPoint(30, 10));
        QTest::mouseMove(port, from + QPoint(80, 40));
        QTest::mouseRelease(port, Qt::LeftButton, {}, from + QPoint(80, 40));
    }
    void choose()
    {
        auto *box = m_random.chance(0.5) ? m_rig.find<QComboBox>("motor") : anyOf<QComboBox>();
        if (box == nullptr || !box->isVisible() || box->isEditable() || box->count() == 0
            || box->objectName() == QLatin1String("protocol"))
            return;
        note("choose in " + box->objectName().toStdString());
        box->setFocus();
        key(box, m_random.chance(0.5) ? Qt::Key_Down : Qt::Key_Up);
    }
    void shortcut()
    {
        static constexpr std::pair<Qt::Key, Qt::KeyboardModifier> kKeys[] = {
            {Qt::Key_Return, Qt::ControlModifier}, {Qt::Key_Z, Qt::ControlModifier},
            {Qt::Key_Return, Qt::NoModifier}, {Qt::Key_D, Qt::ControlModifier},
            {Qt::Key_Space, Qt::NoModifier}, {Qt::Key_Tab, Qt::NoModifier}};
        const auto &[which, modifier] = kKeys[m_random.below(std::size(kKeys))];
        QWidget *focus = QApplication::focusWidget();
        key(focus != nullptr ? focus : top(), which, modifier);
    }
    /// And reads what is said about it.
    void pullCable()
    {
        note("unplug");
        m_world.plugged = false;
        rest(static_cast<int>(m_random.below(200)));
        m_world.plugged = true;
        for (int i = 0; i < 10; ++i) {
            rest(50);
            look();
        }
    }
    void lineTrouble()
    {
        switch (m_random.below(7)) {
        case 5:
            note("short fault");
            m_world.shortFault = true;
            return;
        case 0:
            return pullCable();
        case 1:
            note("cut");
            m_world.cut = true;
            rest(static_cast<int>(m_random.below(700)));
            m_world.cut = false;
            return;
        case 2:
            note("reset");
            m_world.reset = true;
            return;
        case 3:
            note("fault");
            m_world.fault = 0x0002;
            return;
        case 4:
            note("fault over");
            m_world.fault = 0;
            return;
        default:
            note("jump");
            m_world.jump(std::chrono::milliseconds(m_random.below(5000)));
        }
    }
    void freeze()
    {
        const int ms = 100 + int(m_random.below(700));
        if (m_random.chance(0.5)) {
            note("freeze the line's thread for " + std::to_string(ms));
            m_world.freeze(ms);
            return;
        }
        note("freeze the window for " + std::to_string(ms));
        support::standStill(ms);
        m_world.stoodStill();
    }
    /// Plans gains, perhaps twice, and writes what is shown.
    void tune()
    {
        auto *open = m_rig.find<QAction>("gainsDockOpen");
        if (m_kind.protocol != drive::Protocol::Mcp || top() != &m_rig.window || open == nullptr)
            return;
        note("tune");
        m_world.act(Act::Kind::Input); // of a key that is not in the story
        open->trigger();
        rest(20);
        auto *pages = m_rig.find<QTabWidget>("gainPages");
        if (pages == nullptr || !pages->isVisible())
            return;
        QTest::mouseClick(pages->tabBar(), Qt::LeftButton, {},
            pages->tabBar()->tabRect(pages->count() - 1).center());
        auto *bandwidth = m_rig.find<QLineEdit>("labBandwidth");
        if (bandwidth == nullptr || !bandwidth->isVisible())
            return;
        const auto typeInto = [&](QLineEdit *edit, const QString &text) {
            edit->setFocus();
            edit->selectAll();
            QTest::keyClicks(edit, text);
        };
        const auto type = [&] { typeInto(bandwidth, QString::number(300 + m_random.below(1900))); };
        click("labFromBoard");
        for (const auto &[name, text] :
            {std::pair("labRs", "0.35"), std::pair("labLq", "0.6"), std::pair("labLd", "0.6")})
            if (auto *edit = m_rig.find<QLineEdit>(name); edit != nullptr && edit->text().isEmpty())
                typeInto(edit, QLatin1String(text));
        if (auto *arm = m_rig.find<QCheckBox>("arm"); arm != nullptr && !arm->isChecked())
            click("arm");
        rest(150); // the board's facts come
        type();
        click("labPreview");
        rest(20);
        if (m_random.chance(0.5))
            type();
        rest(20);
        const auto planned = m_screen.plannedGains();
        m_world.forgetWritten();
        if (!click("applyEdits"))
            return;
        if (QApplication::activeModalWidget() != nullptr)
            answerYes();
        rest(400);
        const auto written = m_world.counts().written;
        m_tuned += written.empty() || planned.empty() ? 0 : 1;
        finds(m_screen.gainsAsShown(planned, written));
    }
    /// Holds a jog button for a while.
    void jog()
    {
        auto *button = m_rig.find<QAbstractButton>(m_random.chance(0.5) ? "jogForth" : "jogBack");
        if (button == nullptr || !button->isVisible() || !button->isEnabled())
            return;
        note("jog");
        QTest::mousePress(button, Qt::LeftButton);
        rest(static_cast<int>(m_random.below(300)));
        if (QApplication::activeModalWidget() != nullptr)
            answerYes();
        QTest::mouseRelease(button, Qt::LeftButton);
    }
    /// Write what waits, take back, read or restore.
    void restore()
    {
        static const char *const names[] = {
            "applyEdits", "revertEdits", "undo", "snapshotRead", "snapshotRestore", "saveSnapshot"};
        click(names[m_random.below(std::size(names))]);
        rest(30);
        if (m_random.chance(0.5))
            answerYes();
    }

    /// Closes the window, and answers what it asks.
    void leave()
    {
        m_popups.stop();
        m_world.plugged = true;
        m_world.cut = false;
        for (int i = 0; i < 20 && QApplication::activeModalWidget() != nullptr; ++i) {
            QApplication::activeModalWidget()->close();
            rest(5);
        }
        note("quit");
        m_rig.window.close();
        QElapsedTimer clock;
        clock.start();
        while (m_rig.window.isVisible() && clock.elapsed() < 6000) {
            rest(20);
            QWidget *modal = QApplication::activeModalWidget();
            if (modal == nullptr)
                continue;
            for (auto *button : modal->findChildren<QAbstractButton *>())
                if (button->text().contains(QStringLiteral("all the same"))
                    || button->text().contains(QStringLiteral("eave running"))
                    || button->text().contains(QStringLiteral("without"))) {
                    QTest::mouseClick(button, Qt::LeftButton);
                    break;
                }
        }
        rest(50);
    }

    std::uint64_t m_seed;
    Random m_random; ///< of the act
    Kind m_kind;
    int m_habit;
    QTemporaryDir m_folder;
    JudgedWorld m_world; // outlives the window, whose session ends last
    facts::WindowRig m_rig;
    support::WindowActs m_acts;
    support::ScreenJudge m_screen;
    std::string m_untrue; ///< what the screen said first that was not so
    std::string m_tape; ///< of that moment
    QTimer m_popups;
    std::vector<std::string> m_story;
    std::deque<QString> m_echoes; ///< what stood below the field of the speed when it was sent
    int m_tuned = 0; ///< times that gains were written
    int m_files = 0; ///< that were recorded or exported
    bool m_awaited = false; ///< a picture that can be exported and judged
};

std::vector<int> firstActs(int count)
{
    std::vector<int> acts(static_cast<std::size_t>(count));
    std::iota(acts.begin(), acts.end(), 0);
    return acts;
}

std::string listOf(const std::vector<int> &acts)
{
    std::string text;
    for (const int act : acts)
        text += (text.empty() ? "" : ",") + std::to_string(act);
    return text;
}

/// What a failure is about, whatever its numbers are.
std::string ruleOf(const std::string &wrong)
{
    const std::size_t says = wrong.find(" says \"");
    return wrong.substr(0, says == std::string::npos ? wrong.find(':') : says);
}

/// The acts that a failure needs and what it came to, with no more than these; a session is not the same each time.
std::string minimised(int seed, std::vector<int> acts, const std::string &wrong)
{
    constexpr qint64 kSearch_ms = 60'000;
    QElapsedTimer clock;
    clock.start();
    std::string story;
    acts = support::fewerActs(
        std::move(acts),
        [&](const std::vector<int> &fewer) {
            Monkey monkey(static_cast<std::uint64_t>(seed));
            const std::string now = monkey.run(fewer);
            const bool same = !now.empty() && ruleOf(now) == ruleOf(wrong);
            if (same)
                story = now + "\n" + monkey.story();
            else if (!now.empty())
                qWarning("another finding: %s\n%s", now.c_str(), monkey.story().c_str());
            if (!now.empty())
                std::fputs(monkey.tape().c_str(), stderr); // messages of the test are cut
            return same;
        },
        [&clock] { return clock.elapsed() < kSearch_ms; });
    return "ROTORSCOPE_SEED=" + std::to_string(seed) + " ROTORSCOPE_ACTS=" + listOf(acts)
        + (story.empty() ? "\n(no part of them failed alone)" : "\n" + story);
}

} // namespace

class TestMonkey : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whateverIsPressedTheRulesHold();
};

void TestMonkey::whateverIsPressedTheRulesHold()
{
    const bool isLong = qEnvironmentVariableIntValue("ROTORSCOPE_LONG") != 0;
    const support::Seeds seeds = support::seedsOf(10, 1000);
    const int first = static_cast<int>(seeds.first);
    const int last = first + static_cast<int>(seeds.count) - 1;
    std::vector<int> all = firstActs(isLong ? 200 : 25);
    if (const QString chosen = qEnvironmentVariable("ROTORSCOPE_ACTS"); !chosen.isEmpty()) {
        all.clear();
        for (const QString &one : chosen.split(QLatin1Char(',')))
            all.push_back(one.toInt());
    }
    constexpr std::size_t kMinimised = 3; ///< failures that are made smaller: it takes time
    int armed = 0, started = 0, stopped = 0, acts = 0, statements = 0, tuned = 0;
    std::vector<std::string> failed;
    for (int seed = first; seed <= last; ++seed) {
        auto session = std::make_unique<Monkey>(static_cast<std::uint64_t>(seed));
        Monkey &monkey = *session;
        const std::string wrong = monkey.run(all);
        const auto counts = monkey.counts();
        armed += counts.arms > 0 ? 1 : 0;
        started += counts.starts > 0 ? 1 : 0;
        stopped += counts.stops > 0 ? 1 : 0;
        acts += counts.acts;
        statements += monkey.statements();
        tuned += monkey.tuned();
        if (seed % 100 == 0)
            qInfo() << "up to seed" << seed;
        if (wrong.empty())
            continue;
        failed.push_back("seed " + std::to_string(seed) + ": " + wrong + "\n" + monkey.story());
        qWarning("%s", failed.back().c_str());
        std::fputs(monkey.tape().c_str(), stderr);
        session.reset();
        if (failed.size() <= kMinimised)
            qWarning("%s", minimised(seed, all, wrong).c_str());
    }
    const int sessions = last - first + 1;
    qInfo() << sessions << "sessions of" << all.size() << "acts," << acts << "inputs, armed"
            << armed << "started" << started << "stopped" << stopped << "statements" << statements
            << "tuned" << tuned << "failed" << failed.size();
    QVERIFY2(failed.empty(), failed.empty() ? "" : failed.front().c_str());
    if (sessions >= 10)
        QVERIFY(2 * armed > sessions && 2 * started > sessions);
}

QTEST_MAIN(TestMonkey)
#include "tst_monkey.moc"
