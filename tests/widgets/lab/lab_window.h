// The window with a simulated board that the judge watches, and a user who arms, presses the buttons of the lab's pages
// and answers their question.
#pragma once

#include "simulation/plant/presets.h"
#include "support/judged_line.h"
#include "support/window_rig.h"
#include "widgets/lab/experiments.h"

#include <QAbstractButton>
#include <QAbstractItemModel>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTranslator>
#include <QTreeView>

namespace support {

/// As long as it lives, windows that are made speak German, or English where that is asked for.
class Speaking {
public:
    explicit Speaking(bool german)
    {
        if (german && m_german.load(QStringLiteral(":/i18n/rotorscope_de")))
            QCoreApplication::installTranslator(&m_german);
    }

private:
    QTranslator m_german; // which takes itself out
};

/// All of it is in view.
inline bool isWhole(const QWidget &part)
{
    return part.isVisible() && part.visibleRegion().boundingRect().size() == part.size();
}

/// The parts of a page with words or numbers in them that are not seen whole, or have less room than they need.
inline QString cutParts(const QWidget &page)
{
    QStringList cut;
    for (const QWidget *part : page.findChildren<QWidget *>()) {
        const bool says = qobject_cast<const QLabel *>(part) != nullptr
            || qobject_cast<const QLineEdit *>(part) != nullptr
            || qobject_cast<const QComboBox *>(part) != nullptr
            || qobject_cast<const QAbstractButton *>(part) != nullptr;
        if (says && part->isVisible()
            && (!isWhole(*part) || part->width() < part->minimumSizeHint().width()))
            cut.append(QLatin1String(part->metaObject()->className()) + QLatin1Char(' ')
                + part->objectName());
    }
    return cut.join(QStringLiteral(", "));
}

struct LabWindow {
    static constexpr int kRunMs = 100'000; ///< a busy computer takes its time

    JudgedWorld world;
    facts::WindowRig rig;
    WindowActs acts;

    /// @param with  what its firmware is built with besides
    explicit LabWindow(const std::string &motor, const QSize &size = {1280, 720}, int motors = 1,
        const std::vector<std::string> &with = {})
        : world(boardOf(motor, motors, with), drive::Protocol::Mcp)
        , rig(settings(), session::makeDiskSink, world.parts())
        , acts(world, rig.window, rig.workbench.device())
    {
        rig.window.resize(size);
        QApplication::setActiveWindow(&rig.window);
    }
    ~LabWindow() { world.act(judge::Act::Kind::Leave); }

    static simulation::BoardOptions boardOf(
        const std::string &motor, int motors, const std::vector<std::string> &with)
    {
        simulation::BoardOptions options;
        options.motor = motor;
        options.motors = motors;
        options.load = simulation::findPreset(motor)->load;
        for (const simulation::BuildOption &option : simulation::buildOptions())
            if (std::ranges::find(with, option.name) != with.end())
                options.with.push_back(&option);
        return options;
    }
    static widgets::Settings settings()
    {
        widgets::Settings settings = facts::WindowRig::quietSettings();
        settings.port = QStringLiteral("/dev/ttyMotor");
        settings.protocol = QStringLiteral("mcp");
        settings.samplesOnDiskGB = 0.0;
        return settings;
    }

    widgets::Device &device() { return rig.workbench.device(); }
    drive::MotorState state() { return device().status(1).state; }
    template <class T = QWidget>
    T *find(const char *name) const
    {
        return rig.find<T>(name);
    }
    void open(int key, Qt::KeyboardModifiers modifiers)
    {
        QTest::keyClick(&rig.window, Qt::Key(key), modifiers);
    }
    bool connectBoard()
    {
        QTest::mouseClick(find<QPushButton>("connect"), Qt::LeftButton);
        return QTest::qWaitFor(
            [this] { return device().identified() && state() == drive::MotorState::Idle; });
    }
    /// Again where a computer stood still for so long that it was disarmed.
    bool arm(const char *button)
    {
        const auto ready = [&] {
            return device().armed() && find<QPushButton>(button)->isEnabled();
        };
        constexpr int kTries = 4, kEach_ms = 4000;
        for (int i = 0; i < kTries && !ready(); ++i) {
            if (auto *box = find<QCheckBox>("arm"); !box->isChecked())
                QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
            acts.noteArming();
            if (QTest::qWaitFor(ready, kEach_ms))
                break;
            qWarning("%sarmed; %s", device().armed() ? "" : "not ",
                qPrintable(find<QPushButton>(button)->toolTip()));
        }
        acts.noteArming(); // for what is written without another press
        return ready();
    }
    bool asks() const { return find<QDialog>("experimentQuestion") != nullptr; }
    int questions = 0; ///< that were answered with yes
    void press(const char *name)
    {
        QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton);
        acts.noteArming();
    }
    void agree()
    {
        auto *dialog = find<QDialog>("experimentQuestion");
        QVERIFY(dialog);
        ++questions;
        QTest::mouseClick(
            dialog->findChild<QPushButton *>(QStringLiteral("experimentConfirm")), Qt::LeftButton);
        QTRY_VERIFY(!asks());
        QApplication::setActiveWindow(&rig.window); // which a window manager does
    }
    bool running() { return rig.workbench.experiments().running(); }
    /// A run, from its button to the sentence of its end.
    bool runToItsEnd(const char *name)
    {
        press(name);
        if (asks())
            agree();
        return QTest::qWaitFor([this] { return running(); })
            && QTest::qWaitFor([this] { return !running(); }, kRunMs)
            && QTest::qWaitFor([&] { return find<QPushButton>(name)->isEnabled(); }, 20'000);
    }
    QString said(const char *name) const { return find<QLabel>(name)->text(); }
    QString cell(const char *table, int row, int column) const
    {
        return find<QTreeView>(table)->model()->index(row, column).data().toString();
    }
    std::int64_t held(const char *name)
    {
        const auto id = rig.workbench.registers().idOf(name);
        const auto value = id ? rig.workbench.registers().known(*id) : std::nullopt;
        return value ? std::get<std::int64_t>(*value) : 0;
    }
};

/// The window on the program's own board of the older protocol, which records nothing.
struct OlderBoardWindow {
    facts::WindowRig rig;

    void open(int key, Qt::KeyboardModifiers modifiers) ///< the page, and the board
    {
        QApplication::setActiveWindow(&rig.window);
        QTest::keyClick(&rig.window, Qt::Key(key), modifiers);
        session::Endpoint endpoint;
        endpoint.board = "legacy";
        endpoint.baud = 115200;
        endpoint.protocol = drive::Protocol::Fcp;
        rig.workbench.device().open(endpoint);
        QTRY_VERIFY_WITH_TIMEOUT(rig.workbench.device().identified(), 10'000);
    }
    void arm()
    {
        auto *box = rig.find<QCheckBox>("arm");
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
        QTRY_VERIFY(rig.workbench.device().armed());
        rig.acts.noteArming();
    }
};

} // namespace support
