// rotorscope: the window. Wiring only: arguments, language, theme, the workbench and its window.
#include "arguments.h"

#include "../cli/interrupt.h"

#include "session/files/limits_file.h"
#include "session/link/guardian.h"
#include "session/transports/port_list.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/look/theme.h"
#include "widgets/window/application.h"
#include "widgets/window/connect_bar.h"
#include "widgets/window/main_window.h"
#include "widgets/window/own_limits.h"
#include "widgets/window/settings.h"
#include "widgets/window/workbench.h"

#include <QFile>
#include <QIcon>
#include <QLibraryInfo>
#include <QScreen>
#include <QTimer>
#include <QTranslator>

#include <iostream>

namespace {

/// Texts of the window and of Qt itself, in the language asked for or the system's.
void loadLanguage(QApplication &application, const std::string &language)
{
    const QLocale locale =
        language.empty() ? QLocale::system() : QLocale(QString::fromStdString(language));
    QLocale::setDefault(locale);
    const std::pair<QString, QString> catalogues[] = {
        {QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath)},
        {QStringLiteral("registers"), QStringLiteral(":/i18n")},
        {QStringLiteral("rotorscope"), QStringLiteral(":/i18n")},
    };
    for (const auto &[name, folder] : catalogues) {
        auto *translator = new QTranslator(&application);
        // Without the user's language English is better than no plurals.
        if (translator->load(locale, name, QStringLiteral("_"), folder)
            || translator->load(name + QLatin1String("_en"), folder))
            QApplication::installTranslator(translator);
    }
}

/// What cannot be read at the start, or saved at the end, is told while there is a window to tell it.
void tellAboutSettings(widgets::MainWindow &window, const widgets::Settings &settings,
    const QString &file, const QString &damage)
{
    if (!damage.isEmpty())
        window.warn(damage);
    QObject::connect(&window, &widgets::MainWindow::settled, &window, [&window, settings, file] {
        if (const QString why = widgets::saveSettings(settings, file); !why.isEmpty())
            window.warn(why);
    });
}

int run(int argc, char **argv, const gui::Arguments &arguments)
{
    // Before the window, whose libraries have threads.
    const char *noGuardian = nullptr;
    const std::shared_ptr<session::Guardian> guardian = session::startGuardian(noGuardian);
    if (!guardian)
        std::cerr << "rotorscope: " << noGuardian << '\n';
    widgets::Application application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("rotorscope"));
    QApplication::setApplicationDisplayName(QStringLiteral("Rotorscope"));
    QApplication::setApplicationVersion(QStringLiteral(ROTORSCOPE_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("org.rotorscope.Rotorscope"));
    loadLanguage(application, arguments.language);

    const QString settingsFile = widgets::settingsPath();
    QString damage;
    widgets::Settings settings = widgets::loadSettings(settingsFile, &damage);
    if (!arguments.port.empty())
        settings.port = QString::fromStdString(arguments.port);
    if (arguments.baud != 0)
        settings.baud = arguments.baud;
    widgets::applyTheme(settings.theme);

    const session::SystemPortSource ports;
    widgets::FilePrompt files;
    session::Parts parts = session::realParts();
    parts.guardian = guardian;
    widgets::Workbench workbench(session::makeDiskSink, std::move(parts));
    widgets::MainWindow window(workbench, ports, files, settings);
    tellAboutSettings(window, settings, settingsFile, damage);
    widgets::OwnLimits limits(workbench.device(), session::limitsPath());
    QObject::connect(&limits, &widgets::OwnLimits::told, &window, &widgets::MainWindow::warn);
    limits.load();
    // Drawing it in all its sizes takes about a tenth of a start; the first picture does without.
    QObject::connect(&window, &widgets::MainWindow::settled, &application,
        [] { QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/rotorscope.svg"))); });
    window.showWithin(window.screen()->availableSize());
    // Asked to end by a signal: the same questions as when the user closes the window.
    const cli::Interrupt interrupt;
    QObject::connect(&interrupt, &cli::Interrupt::raised, &window, &QWidget::close);
    // A window that hangs does not ask. What this program drives is stopped whether it does or not.
    workbench.atSession([](session::Session &session) {
        const auto *asked = new cli::Interrupt(&session); // ends with it, in its thread
        QObject::connect(asked, &cli::Interrupt::raised, &session, &session::Session::stopOwn);
    });
    if (arguments.connect)
        QTimer::singleShot(0, window.connectBar(), &widgets::ConnectBar::connectOrDisconnect);
    if (!arguments.file.empty())
        QTimer::singleShot(0, &window,
            [&window, path = QFile::decodeName(arguments.file.c_str())] { window.openFile(path); });
    const int status = QApplication::exec();
    if (const QString why = widgets::saveSettings(window.settings(), settingsFile); !why.isEmpty())
        std::cerr << "rotorscope: " << why.toStdString() << '\n';
    return status;
}

} // namespace

int main(int argc, char **argv)
{
    const gui::Arguments arguments =
        gui::readArguments(std::vector<std::string>(argv + 1, argv + argc));
    if (!arguments.error.empty()) {
        std::cerr << "rotorscope: " << arguments.error << '\n';
        return 2;
    }
    if (arguments.help || arguments.version) {
        std::cout << (arguments.help ? gui::helpText()
                                     : std::string("rotorscope " ROTORSCOPE_VERSION "\n"));
        return 0;
    }
    return run(argc, argv, arguments);
}
