// README's session of the command line, line for line and in its order, on one simulated board. What measures a motor
// for long is played with ROTORSCOPE_LONG=1 alone, on each firmware profile that streams.
#include "support/places.h"
#include "support/programs/experiment_program_posix.h"

#include <QFile>
#include <QtTest>

class TestCliReadme : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itsSessionWorks_data();
    void itsSessionWorks();
};

namespace {

bool isLong() { return qEnvironmentVariableIntValue("ROTORSCOPE_LONG") != 0; }

/// Its commands, each without its remark.
QStringList readmeSession()
{
    QFile file(support::sourceFile(QStringLiteral("README.md")));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString text = QString::fromUtf8(file.readAll())
                             .section(QStringLiteral("\n## The command line\n"), 1)
                             .section(QStringLiteral("\n## "), 0, 0)
                             .replace(QLatin1String("\\\n"), QLatin1String(" "));
    QStringList commands;
    for (const QString &line : text.split(QLatin1Char('\n')))
        if (line.startsWith(QLatin1String("    rotorscope-cli ")))
            commands += line.section(QLatin1String(" #"), 0, 0).trimmed();
    return commands;
}

bool measuresForLong(const QString &command)
{
    for (const char *word : {" identify ", " response ", " autotune "})
        if (command.contains(QLatin1String(word)))
            return true;
    return false;
}

} // namespace

void TestCliReadme::itsSessionWorks_data()
{
    QTest::addColumn<QString>("profile");
    QTest::newRow("6.4") << QStringLiteral("mcsdk-6.4");
    if (isLong())
        for (const char *profile : {"mcsdk-6.0", "mcsdk-6.1", "mcsdk-6.2", "mcsdk-6.3"})
            QTest::newRow(profile) << QString::fromLatin1(profile);
}

void TestCliReadme::itsSessionWorks()
{
    QFETCH(const QString, profile);
    const support::Simulator board({QStringLiteral("--profile"), profile});
    QVERIFY(board.ready());
    const QTemporaryDir folder;
    const QString before = QDir::currentPath();
    QVERIFY(QDir::setCurrent(folder.path()));
    const auto back = qScopeGuard([&] { QDir::setCurrent(before); });
    QFile plan(QStringLiteral("plan.json"));
    QVERIFY(plan.open(QIODevice::WriteOnly));
    plan.write(R"({"experiment":"step","from_rpm":1500,"to_rpm":1800,"repeat":2,"hold_ms":300})");
    plan.close();

    const QStringList commands = readmeSession();
    QVERIFY2(commands.size() > 15, "README has another form");
    for (QString command : commands) {
        if (measuresForLong(command) && !isLong())
            continue;
        command.replace(QLatin1String("--seconds 3600"), QLatin1String("--seconds 2"));
        command.replace(QLatin1String("/dev/ttyACM0"), board.port());
        if (command.endsWith(QLatin1String("info")) && !command.contains(board.port()))
            continue; // of a board that is no longer this one
        const QStringList words = command.split(QLatin1Char(' '), Qt::SkipEmptyParts).mid(1);
        // A machine that stands still in the middle of an experiment ends it, as is documented: then nothing comes, or
        // what holds the speed comes late (tst_current_steps has how late it may be). Of a capture samples are lost.
        const auto spoilt = [](const support::CliRun &run) {
            return run.stalled()
                || (run.status == 4 && run.err.contains(QLatin1String("were lost")))
                || (run.endedEarly()
                    && (run.err.contains(QLatin1String("was not read"))
                        || run.err.contains(QLatin1String("no samples"))
                        || run.err.contains(QLatin1String("was lost"))
                        || run.err.contains(QLatin1String("rpm is below the"))));
        };
        bool starved = false;
        const auto play = [&] {
            constexpr int kLook_ms = 20;
            QProcess process;
            support::CoreWait wait(board.processId());
            support::startCli(process, words);
            while (!process.waitForFinished(kLook_ms) && process.state() != QProcess::NotRunning)
                wait.look(process.processId());
            starved = wait.starved();
            return support::resultOf(process);
        };
        support::CliRun run = play();
        for (int tries = 1; tries < 3 && spoilt(run); ++tries) {
            qWarning("%s: %s", qPrintable(command), qPrintable(run.err));
            board.cli("ramp 1500 500"); // it may have been left in torque control
            if (words.last().endsWith(QLatin1String(".pcapng")))
                QFile::remove(words.last()); // no recording takes the place of another
            run = play();
        }
        if (starved && spoilt(run)) { // as documented: a machine that is so busy shows no more
            board.cli("ramp 1500 500");
            continue;
        }
        QVERIFY2(run.status == 0,
            qPrintable(QStringLiteral("%1: %2 %3")
                           .arg(command, QString::number(run.status), run.err.left(500))));
    }
}

QTEST_GUILESS_MAIN(TestCliReadme)
#include "tst_cli_readme_posix.moc"
