#include "bench/paired.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>

#if defined(__linux__)
#include <unistd.h>
#endif

namespace bench {

namespace {
std::vector<Figure> &figures()
{
    static std::vector<Figure> all;
    return all;
}

struct LeftOut {
    std::string id, what, why;
};

std::vector<LeftOut> &leftOut()
{
    static std::vector<LeftOut> all;
    return all;
}

double secondsOf(const std::function<void()> &work)
{
    const double start = cpuSeconds();
    work();
    return cpuSeconds() - start;
}

/// P2 before P10.
struct ByNumber {
    bool operator()(const std::string &a, const std::string &b) const
    {
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    }
};

std::string quoted(const std::string &text)
{
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            result += '\\';
        result += c;
    }
    return result + '"';
}
} // namespace

void report(Figure figure) { figures().push_back(std::move(figure)); }

void leaveOut(const std::string &id, const std::string &what, const std::string &why)
{
    leftOut().push_back({id, what, why});
}

std::vector<std::string> withoutFigure(const std::vector<std::string> &wanted)
{
    std::vector<std::string> missing;
    for (const std::string &id : wanted) {
        if (std::none_of(figures().begin(), figures().end(),
                [&id](const Figure &figure) { return figure.id == id; }))
            missing.push_back(id);
    }
    return missing;
}

double cpuSeconds() { return double(std::clock()) / double(CLOCKS_PER_SEC); }

double quantile(std::vector<double> values, double share)
{
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(std::lround(share * double(values.size() - 1)))];
}

bool writeFigures(const std::string &path)
{
    std::map<std::string, std::vector<Figure>, ByNumber> byId;
    for (const Figure &figure : figures())
        byId[figure.id].push_back(figure);
    std::cout << "\nRatios (median of pairs, CPU time)\n";
    for (const auto &[id, list] : byId) {
        for (const Figure &figure : list) {
            std::cout << std::left << std::setw(5) << id << std::right << std::setw(10)
                      << std::setprecision(4) << figure.ratio << "  " << figure.what << ", against "
                      << figure.against << "; goal: " << figure.goal << '\n';
        }
    }
    for (const LeftOut &one : leftOut())
        std::cout << one.id << "  LEFT OUT: " << one.what << ": " << one.why << '\n';
    std::ofstream file(path);
    file << std::setprecision(6) << "{";
    const char *separator = "\n";
    for (const auto &[id, list] : byId) {
        file << separator << "  " << quoted(id) << ": [";
        separator = ",\n";
        const char *comma = "\n";
        for (const Figure &figure : list) {
            file << comma << "    {\"what\": " << quoted(figure.what)
                 << ", \"ratio\": " << figure.ratio << ", \"goal\": " << quoted(figure.goal)
                 << ", \"against\": " << quoted(figure.against) << "}";
            comma = ",\n";
        }
        file << "\n  ]";
    }
    if (!leftOut().empty()) {
        file << separator << "  \"left out\": [";
        const char *comma = "\n";
        for (const LeftOut &one : leftOut()) {
            file << comma << "    {\"id\": " << quoted(one.id) << ", \"what\": " << quoted(one.what)
                 << ", \"why\": " << quoted(one.why) << "}";
            comma = ",\n";
        }
        file << "\n  ]";
    }
    file << "\n}\n";
    file.close();
    return file.good();
}

Pair pairedRatio(benchmark::State &state, const std::function<void()> &a,
    const std::function<void()> &b, const std::function<void()> &before)
{
    const auto seconds = [&before](const std::function<void()> &work) {
        if (before)
            before();
        return secondsOf(work);
    };
    a();
    b();
    std::vector<double> ratios;
    std::vector<double> aTimes;
    std::vector<double> bTimes;
    bool first = true;
    for ([[maybe_unused]] auto _ : state) {
        double aTime = 0;
        double bTime = 0;
        if (first) {
            aTime = seconds(a);
            bTime = seconds(b);
        } else {
            bTime = seconds(b);
            aTime = seconds(a);
        }
        first = !first;
        aTimes.push_back(aTime);
        bTimes.push_back(bTime);
        ratios.push_back(bTime / std::max(aTime, 1e-7));
        state.SetIterationTime(aTime);
    }
    const Pair pair{quantile(ratios, 0.5), quantile(aTimes, 0.5), quantile(bTimes, 0.5)};
    state.counters["ratio"] = pair.ratio;
    state.counters["p10"] = quantile(ratios, 0.1);
    state.counters["p90"] = quantile(ratios, 0.9);
    state.counters["a_ms"] = pair.aSeconds * 1e3;
    state.counters["b_ms"] = pair.bSeconds * 1e3;
    return pair;
}

double residentBytes()
{
#if defined(__linux__)
    std::ifstream statm("/proc/self/statm");
    double size = 0;
    double resident = 0;
    if (statm >> size >> resident)
        return resident * double(sysconf(_SC_PAGESIZE));
#endif
    return 0.0;
}

void require(bool holds, const char *what)
{
    if (holds)
        return;
    std::cerr << "The benchmark's own result is wrong: " << what << '\n';
    std::exit(1);
}

} // namespace bench
