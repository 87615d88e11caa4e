// P10, N14: a CSV file of 8 signals x 1,000,000 rows, against what other programs do for each number; reading one back;
// and the same samples as a MATLAB file.
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "capture/csv_export.h"
#include "capture/csv_import.h"
#include "session/files/export_formats.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTextStream>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <deque>
#include <limits>
#include <memory>

namespace {

using namespace bench;

constexpr std::size_t kRows = 1'000'000;
constexpr qsizetype kPiece = 1 << 20;
constexpr const char *kWhat = "CSV, 8 x 1000000 rows to a file";

/// Rows of numbers; by signal, what is in them and where.
struct Table {
    std::vector<double> time; ///< s
    std::array<std::vector<double>, kSignals> values;
    std::array<std::vector<std::uint8_t>, kSignals> there;
};

/// The recording and where the files go; made once.
struct Export {
    QTemporaryDir folder;
    capture::Snapshot snapshot;
    std::vector<std::vector<std::int16_t>> codes;
    std::vector<std::deque<std::pair<double, double>>> series; ///< seconds and values
    double factor = motorLayout().fast[0].factor;

    Export()
    {
        capture::Capture capture;
        recordMotor(capture, kRows);
        std::vector<capture::ChannelId> ids;
        for (const auto &info : capture.channels())
            ids.push_back(info.id);
        snapshot = capture.snapshot(ids);
        for (int s = 0; s < kSignals; ++s)
            codes.push_back(motorSignal(s, kRows));
        for (const auto &signal : codes) {
            auto &points = series.emplace_back();
            for (const std::int16_t code : signal)
                points.emplace_back(double(points.size()) / kTickHz, code * factor);
        }
    }
    QString path(const char *name) const { return folder.filePath(QString::fromLatin1(name)); }

    /// As the program does: beside the old file, on the disk, then in its place.
    void ours() const
    {
        const auto result =
            session::exportFormatNamed("csv")->write(path("ours.csv"), {snapshot, {}}, {});
        require(result.file.error == session::FileError::None, "the CSV file was not written");
    }

    /// What no writer of this text can go below: the same bytes, ready made, in pieces of the same size.
    void bytesAlone() const
    {
        static const auto bytes = QFileInfo(path("ours.csv")).size();
        static const std::string piece(1 << 20, '1');
        QFile file(path("bytes.csv"));
        require(file.open(QIODevice::WriteOnly | QIODevice::Unbuffered), "cannot open a file");
        for (qint64 left = bytes; left > 0; left -= qint64(piece.size()))
            file.write(piece.data(), std::min(left, qint64(piece.size())));
    }

    /// Before each of the two: files, pages of which the next file gets. A virtual machine hands memory that lies free
    /// to its host after two seconds, and getting it back costs more than everything that is compared here.
    void warmPages() const
    {
        static const std::string piece(kPiece, '1');
        constexpr int kPieces = 128; // twice the file
        QFile file(path("pages"));
        require(file.open(QIODevice::WriteOnly | QIODevice::Unbuffered), "cannot open a file");
        for (int i = 0; i < kPieces; ++i)
            file.write(piece.data(), qint64(piece.size()));
        require(file.remove(), "cannot remove a file");
    }

    Pair against(benchmark::State &state, const std::function<void()> &other) const
    {
        return pairedRatio(
            state, [this] { ours(); }, other, [this] { warmPages(); });
    }

    /// A loop over rows; `format` turns a number into text at a place and returns its end.
    template <class Format>
    void plainLoop(const char *name, Format format) const
    {
        QFile file(path(name));
        require(file.open(QIODevice::WriteOnly | QIODevice::Unbuffered), "cannot open a file");
        std::string text;
        std::array<char, 64> number{};
        for (std::size_t row = 0; row < kRows; ++row) {
            text.append(number.data(), format(number.data(), double(row) / kTickHz));
            for (std::size_t s = 0; s < kSignals; ++s) {
                text += ',';
                text.append(number.data(), format(number.data(), codes[s][row] * factor));
            }
            text += '\n';
            if (qsizetype(text.size()) >= kPiece) {
                file.write(text.data(), qint64(text.size()));
                text.clear();
            }
        }
        file.write(text.data(), qint64(text.size()));
    }

    /// What PlotJuggler 3.17 does first in an export (its ToolboxCSV): a row is the smallest of the series' next times,
    /// with the values that lie within half a period of it.
    Table linedUp() const
    {
        Table table;
        std::array<std::size_t, kSignals> next{};
        const double tolerance = 0.5 / kTickHz;
        const double never = std::numeric_limits<double>::max();
        while (true) {
            double time = never;
            for (std::size_t s = 0; s < kSignals; ++s) {
                if (next[s] < series[s].size())
                    time = std::min(time, series[s][next[s]].first);
            }
            if (time == never)
                return table;
            table.time.push_back(time);
            for (std::size_t s = 0; s < kSignals; ++s) {
                const bool there = next[s] < series[s].size()
                    && std::abs(series[s][next[s]].first - time) <= tolerance;
                table.values[s].push_back(there ? series[s][next[s]].second : std::nan(""));
                table.there[s].push_back(there ? 1 : 0);
                next[s] += there ? 1 : 0;
            }
        }
    }

    /// And then: each cell as a QString of twelve digits through a QTextStream, each comma as a C string.
    void streamed(const Table &table) const
    {
        QFile file(path("stream.csv"));
        require(file.open(QIODevice::WriteOnly | QIODevice::Text), "cannot open a file");
        QTextStream stream(&file);
        for (std::size_t row = 0; row < table.time.size(); ++row) {
            stream << QString::number(table.time[row], 'f', 6);
            for (std::size_t s = 0; s < kSignals; ++s) {
                stream << ",";
                if (table.there[s][row] != 0)
                    stream << QString::number(table.values[s][row], 'g', 12);
            }
            stream << "\n";
        }
    }
};

const Export &data()
{
    static const Export made;
    return made;
}

void csvAgainstSnprintf(benchmark::State &state)
{
    const Export &e = data();
    const Pair pair = e.against(state, [&] {
        e.plainLoop("snprintf.csv",
            [](char *at, double value) { return at + std::snprintf(at, 64, "%.9g", value); });
    });
    state.counters["Mrows_per_s"] = double(kRows) / pair.aSeconds / 1e6;
    report({"P10", kWhat, Measured::faster(pair), "snprintf(\"%.9g\")"});
}

void csvAgainstToChars(benchmark::State &state)
{
    const Export &e = data();
    // The same text: of the 32 bits that a value has.
    const Pair pair = e.against(state, [&] {
        e.plainLoop("to_chars.csv", [](char *at, double value) {
            return std::to_chars(at, at + 64, static_cast<float>(value)).ptr;
        });
    });
    report({"N14 to_chars", kWhat, Measured::faster(pair), "std::to_chars of a float"});
}

void csvAgainstPlotJuggler(benchmark::State &state)
{
    const Export &e = data();
    const Pair pair = e.against(state, [&] { e.streamed(e.linedUp()); });
    report({"P10 PlotJuggler", kWhat, Measured::faster(pair),
        "PlotJuggler's export: rows lined up, QTextStream << QString::number"});
}

void csvAgainstTextStream(benchmark::State &state)
{
    const Export &e = data();
    const Table table = e.linedUp();
    const Pair pair = e.against(state, [&] { e.streamed(table); });
    report({"P10", kWhat, Measured::faster(pair), "of PlotJuggler's export the writing alone"});
}

void csvAgainstWrite(benchmark::State &state)
{
    const Export &e = data();
    e.ours();
    const Pair pair = pairedRatio(
        state, [&] { e.bytesAlone(); }, [&] { e.ours(); }, [&] { e.warmPages(); });
    report({"N14 write", kWhat, Measured::cost(pair),
        "write() of as many bytes, a mebibyte at a time"});
}

/// Every field of the file gives the very code that was recorded.
void csvReadsBack(benchmark::State &state)
{
    const Export &e = data();
    std::uint64_t wrong = 0;
    while (state.KeepRunning()) {
        capture::CsvWriter writer(e.snapshot);
        std::string text;
        for (std::string_view piece; writer.next(piece);)
            text += piece;
        const char *const end = text.data() + text.size();
        const char *at = std::find<const char *>(text.data(), end, '\n') + 1;
        std::size_t row = 0;
        for (; at < end; ++row) {
            double time = 0;
            at = std::from_chars(at, end, time).ptr;
            wrong += std::lround(time * kTickHz) != long(row);
            for (std::size_t s = 0; s < kSignals; ++s) {
                float value = 0;
                at = std::from_chars(at + 1, end, value).ptr;
                wrong += std::lround(double(value) / e.factor) != e.codes[s][row];
            }
            ++at;
        }
        require(row == kRows, "the CSV has another number of rows");
    }
    report({"P10 reads back", "numbers that do not read back to their code", double(wrong),
        "all 8000000"});
    require(wrong == 0, "a CSV number does not read back");
}

/// A file of ours read back as one of another program.
void csvIn(benchmark::State &state)
{
    const Export &e = data();
    e.ours();
    QFile file(e.path("ours.csv"));
    require(file.open(QIODevice::ReadOnly), "cannot read a file");
    const QByteArray text = file.readAll();
    std::vector<double> speeds;
    for ([[maybe_unused]] auto _ : state) {
        capture::Capture capture;
        capture::CsvImport import(capture);
        const double start = cpuSeconds();
        for (qsizetype at = 0; at < text.size(); at += kPiece)
            import.feed({text.data() + at, std::size_t(std::min(kPiece, text.size() - at))});
        require(import.finish() && import.rows() == kRows, "the CSV file was not read whole");
        const double used = cpuSeconds() - start;
        speeds.push_back(double(text.size()) / used / 1e6);
        state.SetIterationTime(used);
    }
    report({"N14 read", "CSV, 8 x 1000000 rows", Measured(speeds), "bytes of the text"});
}

void matlabFile(benchmark::State &state)
{
    const Export &e = data();
    std::vector<double> seconds;
    for ([[maybe_unused]] auto _ : state) {
        const double start = cpuSeconds();
        const auto result =
            session::exportFormatNamed("mat")->write(e.path("ours.mat"), {e.snapshot, {}}, {});
        require(result.file.error == session::FileError::None, "the MATLAB file was not written");
        const double used = cpuSeconds() - start;
        seconds.push_back(used * 1e8 / double(kRows * kSignals));
        state.SetIterationTime(used);
    }
    report({"N14 MAT", "MATLAB file of 8 x 1000000 samples, scaled", Measured(seconds), "samples"});
}

} // namespace

BENCHMARK(csvIn)->Iterations(3)->UseManualTime();
BENCHMARK(matlabFile)->Iterations(3)->UseManualTime();
BENCHMARK(csvAgainstSnprintf)->Iterations(3)->UseManualTime();
BENCHMARK(csvAgainstToChars)->Iterations(5)->UseManualTime();
BENCHMARK(csvAgainstPlotJuggler)->Iterations(5)->UseManualTime();
BENCHMARK(csvAgainstTextStream)->Iterations(3)->UseManualTime();
BENCHMARK(csvAgainstWrite)->Iterations(5)->UseManualTime();
BENCHMARK(csvReadsBack)->Iterations(1);
