// What rotorscope-cli prints is what the board gave and sent: the real program on a simulated board behind a
// pseudo-terminal, whose line is taken apart by the protocol's text beside it.
#include "support/board_on_terminal.h"
#include "support/programs/programs_posix.h"
#include "support/wire/mcp_board.h"
#include "support/wire/mcp_registers.h"

#include <QFile>
#include <QtTest>

#include <cmath>

class TestCliTruth : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void getPrintsWhatTheBoardGave();
    void captureHoldsEachSampleThatArrived_data();
    void captureHoldsEachSampleThatArrived();
    void showTellsWhatWasSent();
};

namespace {

constexpr double kHz = 4000.0;

class TruthBench {
public:
    TruthBench()
        : m_board(options())
    {
        m_board.onHeard = [this](const Bytes &bytes) { says.asks(bytes, true); };
        m_board.onSaid = [this](const Bytes &bytes) {
            const bool arrives = !lose || !lose();
            says.says(bytes, TimePoint(std::chrono::milliseconds(m_time.elapsed())), arrives);
            return arrives;
        };
        m_time.start();
    }
    support::CliRun cli(const char *line)
    {
        QStringList words{QStringLiteral("--port"), m_board.path()};
        words += QString::fromUtf8(line)
                     .replace(QLatin1String("FOLDER"), m_folder.path())
                     .split(QLatin1Char(' '));
        return support::runCliBeside(words);
    }
    QString file(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    double ampsPerDigit() const { return m_board.board().truth(1).ampsPerDigit; }

    judge::McpBoard says;
    std::function<bool()> lose; ///< what leaves now is lost on the line

private:
    static simulation::BoardOptions options()
    {
        simulation::BoardOptions options;
        options.hfHz = kHz;
        return options;
    }

    support::BoardOnTerminal m_board;
    QTemporaryDir m_folder;
    QElapsedTimer m_time;
};

std::uint16_t idOf(const char *name)
{
    return static_cast<std::uint16_t>(judge::findMcpRegister(name)->bare | 1U);
}

struct Row {
    std::int64_t tick; ///< from the first row
    std::int64_t digits;
};

/// Of a file with one signal, in amperes.
std::vector<Row> rowsOf(const QString &path, double ampsPerDigit)
{
    QFile file(path);
    std::vector<Row> rows;
    if (!file.open(QIODevice::ReadOnly))
        return rows;
    file.readLine();
    double begins = 0.0;
    while (!file.atEnd()) {
        const QList<QByteArray> cells = file.readLine().trimmed().split(',');
        if (cells.size() != 2)
            continue;
        const double time = cells[0].toDouble();
        if (rows.empty())
            begins = time;
        rows.push_back({std::llround((time - begins) * kHz),
            std::llround(cells[1].toDouble() / ampsPerDigit)});
    }
    return rows;
}

/// Whether these rows are those of the board from some sample on, with none left out and none made up.
bool areSent(const std::vector<Row> &rows, const std::deque<judge::McpBoard::Sample> &sent)
{
    for (std::size_t first = 0; first + rows.size() <= sent.size(); ++first) {
        std::size_t same = 0;
        while (same < rows.size() && rows[same].digits == sent[first + same].digits
            && rows[same].tick == sent[first + same].tick - sent[first].tick)
            ++same;
        if (same == rows.size())
            return true;
    }
    return false;
}

} // namespace

void TestCliTruth::getPrintsWhatTheBoardGave()
{
    TruthBench bench;
    const support::CliRun run =
        bench.cli("get SPEED_KP SPEED_KI I_Q_KP I_Q_KI_DIV BUS_VOLTAGE SPEED_MEAS I_A");
    QVERIFY2(run.status == 0, qPrintable(run.err));
    QCOMPARE(run.lines().size(), 7);
    for (const QString &line : run.lines()) {
        const QString name = line.section(QLatin1String(" = "), 0, 0);
        const auto *known = judge::findMcpRegister(name.toStdString());
        QVERIFY2(known != nullptr, qPrintable(line));
        const auto &gave = bench.says.given().of(idOf(name.toUtf8().constData()));
        QVERIFY2(!gave.empty(), qPrintable(name));
        const bool amps = known->digit == judge::McpRegister::Digit::Amps;
        const double truth = gave.back().number * (amps ? bench.ampsPerDigit() : 1.0);
        const double shown =
            line.section(QLatin1String(" = "), 1).section(QLatin1Char(' '), 0, 0).toDouble();
        QVERIFY2(std::abs(shown - truth) <= 1e-4 * std::max(1.0, std::abs(truth)),
            qPrintable(QStringLiteral("the judge: untrue: %1, and the board gave %2")
                           .arg(line)
                           .arg(truth)));
    }
}

void TestCliTruth::captureHoldsEachSampleThatArrived_data()
{
    // Samples, after which a twentieth of a second is lost; 0: never.
    QTest::addColumn<int>("lostAfter");
    QTest::newRow("whole") << 0;
    QTest::newRow("with a gap") << 1000;
}

void TestCliTruth::captureHoldsEachSampleThatArrived()
{
    QFETCH(int, lostAfter);
    TruthBench bench;
    QElapsedTimer since;
    if (lostAfter > 0)
        bench.lose = [&] {
            if (bench.says.samples() < std::uint64_t(lostAfter))
                return false;
            if (!since.isValid())
                since.start();
            return since.elapsed() < 50;
        };
    support::CliRun run;
    for (int tries = 0; tries < 3 && (tries == 0 || run.stalled()); ++tries) {
        bench.says.forgetSamples();
        run = bench.cli("--json capture --hf I_A --seconds 0.6 --start -o FOLDER/x.csv");
    }
    const int lossStatus = 4;
    QVERIFY2(run.status == (lostAfter > 0 ? lossStatus : 0), qPrintable(run.err + run.out));
    const std::vector<Row> rows = rowsOf(bench.file("x.csv"), bench.ampsPerDigit());
    const auto &sent = bench.says.samplesOf(idOf("I_A"));
    QVERIFY(rows.size() > 500);
    QVERIFY2(
        areSent(rows, sent), "the judge: untrue: the rows are not the samples that the board sent");
    const QJsonObject told = run.object();
    QCOMPARE(told.value(QLatin1String("rows")).toInt(), static_cast<int>(rows.size()));
    // The first and the last tick of the wanted length are there, what is between them and is not was lost.
    const std::int64_t length = std::llround(0.6 * kHz);
    const std::int64_t lost = length - static_cast<std::int64_t>(rows.size());
    QVERIFY2(told.value(QLatin1String("lost_ticks")).toInt() == lost,
        qPrintable(QStringLiteral("the judge: untrue: %1, and %2 ticks are missing")
                       .arg(run.out.trimmed())
                       .arg(lost)));
    QVERIFY(lostAfter > 0 ? lost > 0 : lost == 0);
    QCOMPARE(told.value(QLatin1String("seconds")).toDouble(), 0.6);
}

void TestCliTruth::showTellsWhatWasSent()
{
    TruthBench bench;
    const support::CliRun run =
        bench.cli("--json capture --hf I_A --seconds 0.5 --record FOLDER/x.pcapng");
    QVERIFY2(run.status == 0, qPrintable(run.err));
    const support::CliRun shown = bench.cli("--json show FOLDER/x.pcapng");
    QVERIFY2(shown.status == 0, qPrintable(shown.err));
    const auto &sent = bench.says.samplesOf(idOf("I_A"));
    bool found = false;
    for (const QJsonValue &each : shown.object().value(QLatin1String("channels")).toArray()) {
        const QJsonObject channel = each.toObject();
        if (channel.value(QLatin1String("name")).toString() != QLatin1String("I_A")
            || channel.value(QLatin1String("kind")).toString() != QLatin1String("fast"))
            continue;
        found = true;
        const int samples = channel.value(QLatin1String("samples")).toInt();
        QVERIFY2(samples >= int(0.5 * kHz) && samples <= int(sent.size()),
            qPrintable(QStringLiteral("%1 of %2").arg(samples).arg(sent.size())));
        const double seconds = channel.value(QLatin1String("to_s")).toDouble()
            - channel.value(QLatin1String("from_s")).toDouble();
        QVERIFY2(
            std::abs(seconds - samples / kHz) < 2.0 / kHz, qPrintable(QString::number(seconds)));
    }
    QVERIFY2(found, qPrintable(shown.out));
}

QTEST_GUILESS_MAIN(TestCliTruth)
#include "tst_cli_truth_posix.moc"
