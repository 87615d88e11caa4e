#include "bench/paired.h"

#include "bench/goals.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <tuple>

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
    std::string goal, why;
};

std::vector<LeftOut> &leftOut()
{
    static std::vector<LeftOut> all;
    return all;
}

std::string numberOf(const std::string &goal) { return goal.substr(0, goal.find(' ')); }

double secondsOf(const std::function<void()> &work)
{
    const double start = cpuSeconds();
    work();
    return cpuSeconds() - start;
}

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
/// N before P, P2 before P10.
struct ByNumber {
    bool operator()(const std::string &a, const std::string &b) const
    {
        return std::tuple(a[0], a.size(), a) < std::tuple(b[0], b.size(), b);
    }
};

/// How busy the machine is; -1 where it does not tell.
double load()
{
    double one = -1.0;
#if defined(__linux__)
    if (getloadavg(&one, 1) != 1)
        one = -1.0;
#endif
    return one;
}

const char *wordFor(Goal::Verdict verdict)
{
    switch (verdict) {
    case Goal::Verdict::Met:
        return "met";
    case Goal::Verdict::Missed:
        return "MISSED";
    case Goal::Verdict::Fails:
        return "FAILS";
    }
    return "";
}

std::string goalText(const Goal &goal)
{
    std::ostringstream text;
    text << (goal.sense == Goal::Sense::AtMost ? "<= " : ">= ") << goal.value << ' ' << goal.unit;
    return text.str();
}

void print(const Figure &figure)
{
    const Goal *goal = goalNamed(figure.goal);
    const Measured &measured = figure.measured;
    std::cout << std::left << std::setw(5) << numberOf(figure.goal) << std::right << std::setw(10)
              << std::setprecision(4) << measured.value;
    if (measured.p10 && measured.p90)
        std::cout << " (" << *measured.p10 << ".." << *measured.p90 << ')';
    std::cout << "  " << figure.what << ", against " << figure.against;
    if (goal)
        std::cout << "; " << goalText(*goal) << ": " << wordFor(goal->judge(measured.value));
    std::cout << '\n';
}

void write(std::ostream &file, const Figure &figure)
{
    const Measured &measured = figure.measured;
    file << "    {\"what\": " << quoted(figure.what) << ", \"value\": " << measured.value;
    const auto more = [&file](const char *name, const std::optional<double> &value) {
        if (value)
            file << ", \"" << name << "\": " << *value;
    };
    more("p10", measured.p10);
    more("p90", measured.p90);
    more("ms", measured.ms);
    more("against ms", measured.againstMs);
    if (const Goal *goal = goalNamed(figure.goal))
        file << ", \"goal\": " << quoted(goalText(*goal))
             << ", \"verdict\": " << quoted(wordFor(goal->judge(measured.value)));
    file << ", \"against\": " << quoted(figure.against) << "}";
}

} // namespace

void report(Figure figure)
{
    require(goalNamed(figure.goal) || figure.goal == numberOf(figure.goal),
        ("no such goal: " + figure.goal).c_str());
    figures().push_back(std::move(figure));
}

void leaveOut(const std::string &goal, const std::string &why) { leftOut().push_back({goal, why}); }

Measured::Measured(const std::vector<double> &several)
    : value(quantile(several, 0.5))
    , p10(quantile(several, 0.1))
    , p90(quantile(several, 0.9))
{
}

Measured Measured::faster(const Pair &pair)
{
    Measured measured(pair.ratio);
    measured.p10 = pair.p10;
    measured.p90 = pair.p90;
    measured.ms = pair.aSeconds * 1e3;
    measured.againstMs = pair.bSeconds * 1e3;
    return measured;
}

Measured Measured::cost(const Pair &pair)
{
    Measured measured = faster(pair);
    std::swap(measured.ms, measured.againstMs);
    return measured;
}

double cpuSeconds() { return double(std::clock()) / double(CLOCKS_PER_SEC); }

double quantile(std::vector<double> values, double share)
{
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(std::lround(share * double(values.size() - 1)))];
}

Verdict writeFigures(const std::string &path)
{
    std::map<std::string, std::vector<Figure>, ByNumber> byNumber;
    Verdict verdict;
    for (const Figure &figure : figures()) {
        byNumber[numberOf(figure.goal)].push_back(figure);
        const Goal *goal = goalNamed(figure.goal);
        if (goal && goal->judge(figure.measured.value) == Goal::Verdict::Fails)
            verdict.failing.push_back(figure.goal);
    }
    for (const Goal &goal : goals()) {
        const std::string name(goal.name);
        const auto has = [&name](const auto &one) { return one.goal == name; };
        const auto isLeftOut = [&](const LeftOut &one) {
            return one.goal == name || one.goal == numberOf(name);
        };
        if (std::none_of(figures().begin(), figures().end(), has)
            && std::none_of(leftOut().begin(), leftOut().end(), isLeftOut))
            verdict.missing.push_back(name);
    }
    std::cout << "\nFigures (medians, p10..p90; CPU time where nothing else is said). Load of the "
                 "machine: "
              << load() << '\n';
    for (const auto &[number, list] : byNumber)
        std::for_each(list.begin(), list.end(), print);
    for (const LeftOut &one : leftOut())
        std::cout << one.goal << "  LEFT OUT: " << one.why << '\n';
    std::ofstream file(path);
    file << std::setprecision(6) << "{\n  \"load\": " << load();
    for (const auto &[number, list] : byNumber) {
        file << ",\n  " << quoted(number) << ": [";
        const char *comma = "\n";
        for (const Figure &figure : list) {
            file << comma;
            write(file, figure);
            comma = ",\n";
        }
        file << "\n  ]";
    }
    file << ",\n  \"left out\": {";
    const char *comma = "\n";
    for (const LeftOut &one : leftOut()) {
        file << comma << "    " << quoted(one.goal) << ": " << quoted(one.why);
        comma = ",\n";
    }
    file << "\n  }\n}\n";
    file.close();
    verdict.written = file.good();
    return verdict;
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
    const Pair pair{quantile(ratios, 0.5), quantile(aTimes, 0.5), quantile(bTimes, 0.5),
        quantile(ratios, 0.1), quantile(ratios, 0.9)};
    state.counters["ratio"] = pair.ratio;
    state.counters["p10"] = pair.p10;
    state.counters["p90"] = pair.p90;
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
