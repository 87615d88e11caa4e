// Words of boards, files and other programs as the programs print them: a terminal is given no control character of
// them, JSON stays JSON, and what a file makes of memory is bounded and told.
#include "recorded/entry.h"
#include "session/recording/file.h"
#include "support/places.h"
#include "support/programs/programs_posix.h"

#include <QDir>
#include <QtTest>

using support::CliRun;

namespace {

/// Sets a window's title, colours in seven and eight bits, a line of its own, an order of its own.
const std::string kNasty = "A\x1b]0;PWN\x07 \x1b[31m \xC2\x9B"
                           "32m \r\nforged \xE2\x80\xAE"
                           "dab";

bool isHarmless(const QString &printed)
{
    return std::none_of(printed.begin(), printed.end(), [](QChar c) {
        return (c.category() == QChar::Other_Control && c != QLatin1Char('\n'))
            || c.category() == QChar::Other_Format;
    });
}

QString recordingOf(const QTemporaryDir &folder, const std::vector<recorded::Entry> &entries)
{
    const QString path = folder.filePath(QStringLiteral("r.pcapng"));
    QString text;
    session::RecordingFile file(session::makeDiskSink(path, text), {0, kNasty, kNasty});
    bool written = file.open();
    for (std::size_t i = 0; i < entries.size() && written; ++i)
        written = file.add(static_cast<recorded::Nanos>(i), entries[i]);
    return written && file.end() ? path : QString();
}

} // namespace

class TestCliForeignText : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatARecordingSaysIsPrintedHarmless()
    {
        const QTemporaryDir folder;
        const QString path = recordingOf(folder,
            {recorded::Happening{kNasty, {{kNasty, kNasty}}}, recorded::Note{0, 1, kNasty},
                recorded::PolledRegister{1, kNasty, kNasty},
                recorded::PolledValues{{{1, 5, 1.5}}}});
        QVERIFY(!path.isEmpty());
        const CliRun shown =
            support::runCli({QStringLiteral("show"), path, QStringLiteral("--events")});
        QVERIFY2(shown.status == 0, qPrintable(shown.err));
        QVERIFY2(isHarmless(shown.out), qPrintable(shown.out));
        for (const QString &line : shown.lines())
            QVERIFY2(!line.startsWith(QLatin1String("forged")), qPrintable(line));
        const CliRun json =
            support::runCli({QStringLiteral("--json"), QStringLiteral("show"), path});
        QVERIFY(isHarmless(json.out));
        const QJsonArray events = json.object()[QLatin1String("events")].toArray();
        QCOMPARE(events.at(0).toObject()[QLatin1String("what")].toString(),
            QString::fromStdString(kNasty)); // whole, for programs
    }

    void whatASnapshotSaysIsPrintedHarmless()
    {
        const support::Simulator board;
        const QString mine = board.file("mine.json");
        QCOMPARE(board.cli("snapshot -o", {mine}).status, 0);
        QFile file(mine);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray text = file.readAll();
        QVERIFY(text.contains("\"SPEED_KP\""));
        text.replace("\"SPEED_KP\"", "\"SPEED_KP\\u001b]0;PWN\\u0007\\u009b31m\\r\"");
        const QString nasty = board.file("nasty.json");
        QFile other(nasty);
        QVERIFY(other.open(QIODevice::WriteOnly) && other.write(text) == text.size());
        other.close();
        for (const QStringList &words : {QStringList{QStringLiteral("diff"), mine, nasty},
                 QStringList{QStringLiteral("--json"), QStringLiteral("diff"), mine, nasty}}) {
            const CliRun run = support::runCli(words);
            QVERIFY2(run.out.contains(QStringLiteral("PWN")), qPrintable(run.out + run.err));
            QVERIFY2(isHarmless(run.out), qPrintable(run.out));
        }
        const CliRun restored = board.cli("restore", {nasty});
        QVERIFY(isHarmless(restored.out));
        QVERIFY(isHarmless(restored.err));
    }

    void whatIsTypedComesBackHarmless()
    {
        const CliRun run = support::runCli({QStringLiteral("--port"), QStringLiteral("sim"),
            QStringLiteral("get"), QString::fromStdString(kNasty)});
        QCOMPARE(run.status, 2);
        QVERIFY(run.oneLineOfError());
        QVERIFY2(isHarmless(run.err), qPrintable(run.err));
    }

    /// Else they would name another file.
    void wordsThatAreNoUtf8AreRefused()
    {
        const QTemporaryDir folder;
        const QString from = folder.filePath(QStringLiteral("a.csv"));
        QFile file(from);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("time [s],A\n0,1\n") > 0);
        file.close();
        for (const char *name : {R"(b\377.csv)", R"(b\303.csv)", R"(b\355\240\200.csv)"}) {
            QProcess shell;
            shell.start(QStringLiteral("/bin/sh"),
                {QStringLiteral("-c"),
                    QStringLiteral(R"sh(exec "$0" export "$1" -o "$2/$(printf "$3")")sh"),
                    support::programFile(QStringLiteral("rotorscope-cli")), from, folder.path(),
                    QLatin1String(name)});
            QVERIFY(shell.waitForFinished(support::kProgramTime_ms));
            const CliRun run = support::resultOf(shell);
            COMPARE_STATUS(run, 2);
            QVERIFY2(run.oneLineOfError() && run.err.contains(QStringLiteral("not UTF-8")),
                qPrintable(run.err));
            QCOMPARE(
                QDir(folder.path()).entryList(QDir::Files), QStringList{QStringLiteral("a.csv")});
        }
        const QString other = folder.filePath(QStringLiteral("b\u00e4\U0001f600.csv"));
        COMPARE_STATUS(
            support::runCli({QStringLiteral("export"), from, QStringLiteral("-o"), other}), 0);
        QVERIFY(QFile::exists(other));
    }

    void theSimulatorsErrorsAreHarmless()
    {
        QProcess process;
        process.start(support::programFile(QStringLiteral("rotorscope-sim")),
            {QStringLiteral("mcp"), QStringLiteral("--motor"), QString::fromStdString(kNasty)});
        QVERIFY(process.waitForFinished(support::kProgramTime_ms));
        const CliRun run = support::resultOf(process);
        QCOMPARE(run.status, 2);
        QVERIFY2(isHarmless(run.err), qPrintable(run.err));
        QVERIFY2(run.oneLineOfError(), qPrintable(run.err));
    }

    void entriesThatTakeTooMuchMemoryAreLeftOutAndToldSo()
    {
        const QTemporaryDir folder;
        recorded::Happening many{"many", {}};
        for (int i = 0; i < 1000; ++i)
            many.fields.emplace_back("k", "v");
        std::vector<recorded::Entry> entries(1500, many);
        entries.insert(entries.begin(), recorded::RegisterSnapshot{"s", std::string(600'000, 'x')});
        const QString path = recordingOf(folder, entries);
        QVERIFY(!path.isEmpty());
        const CliRun shown = support::runCli({QStringLiteral("show"), path});
        QCOMPARE(shown.status, 4);
        QVERIFY2(
            shown.err.contains(QStringLiteral("are left out, because they take more than 64 MiB")),
            qPrintable(shown.err));
        const QJsonObject json =
            support::runCli({QStringLiteral("--json"), QStringLiteral("show"), path}).object();
        const auto kept = json[QLatin1String("events")].toArray().size();
        QVERIFY2(kept > 900 && kept < 1100, qPrintable(QString::number(kept)));
        QCOMPARE(kept + json[QLatin1String("left_out")].toInt(), 1500);
    }
};

QTEST_GUILESS_MAIN(TestCliForeignText)
#include "tst_cli_foreign_text_posix.moc"
