// The real window with its workbench, on ports and file answers of the test's own. What leaves to a simulated board is
// judged.
#pragma once

#include "support/answered_files.h"
#include "support/judged_boards.h"
#include "support/window_facts.h"
#include "widgets/window/application.h"
#include "widgets/window/exporting.h"
#include "widgets/window/main_window.h"
#include "widgets/window/workbench.h"

#include <QPushButton>
#include <QTest>

// Tests of the window run in the application of the window: it is what sees the Esc key.
#undef QTEST_MAIN
#define QTEST_MAIN(Test) QTEST_MAIN_WRAPPER(Test, QTEST_QAPP_SETUP(widgets::Application))

namespace facts {

class NoPorts : public session::PortSource {
public:
    QList<session::SystemPort> ports() const override { return {}; }
};

struct WindowRig {
    support::JudgedBoards boards;
    NoPorts ports;
    AnsweredPrompt files;
    widgets::Workbench workbench;
    widgets::MainWindow window;
    support::WindowActs acts{boards, window, workbench.device()};

    explicit WindowRig(const widgets::Settings &settings = quietSettings(),
        session::MakeSink makeSink = session::makeDiskSink,
        session::Parts parts = session::realParts())
        : workbench(std::move(makeSink), boards.watch(std::move(parts)))
        , window(workbench, ports, files, settings)
    {
        window.show();
        window.finishTools(); // which a test may look for at once
    }

    ~WindowRig() { boards.act(judge::Act::Kind::Leave); } // the test ends, whatever turns

    /// From now on a user who says yes to every question about motion; `questions` counts them.
    void sayYesToMotion()
    {
        QObject::connect(
            &workbench.motion(), &widgets::MotionGate::asked, &window,
            [this] {
                ++questions;
                if (auto *yes = find<QPushButton>("motionConfirm"))
                    QTest::mouseClick(yes, Qt::LeftButton);
            },
            Qt::QueuedConnection);
    }
    int questions = 0;

    static widgets::Settings quietSettings()
    {
        widgets::Settings settings;
        settings.firstStepsDone = true;
        return settings;
    }

    template <class T>
    T *find(const char *name) const
    {
        return window.findChild<T *>(QLatin1String(name));
    }
};

} // namespace facts
