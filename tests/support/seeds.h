// Which seeds a campaign plays: few of them, many with ROTORSCOPE_LONG=1. ROTORSCOPE_SEED=n plays that one alone, n-m
// those from n to m; ROTORSCOPE_FIRST_SEED=n begins there, so that a campaign that runs again tries what has not been
// tried, and ROTORSCOPE_SEEDS=n plays so many.
#pragma once

#include <QStringList>

#include <cstdint>
#include <optional>
#include <string>

namespace support {

struct Seeds {
    std::uint64_t first = 1, count = 1;
    bool one = false; ///< which says nothing about all of them
};

inline Seeds seedsOf(std::uint64_t few, std::uint64_t many)
{
    if (qEnvironmentVariableIsSet("ROTORSCOPE_SEED")) {
        const QStringList ends = qEnvironmentVariable("ROTORSCOPE_SEED").split(QLatin1Char('-'));
        const std::uint64_t first = ends.first().toULongLong(), last = ends.last().toULongLong();
        return {first, last >= first ? last - first + 1 : 1, first == last};
    }
    Seeds seeds{1, qEnvironmentVariableIntValue("ROTORSCOPE_LONG") != 0 ? many : few};
    if (qEnvironmentVariableIsSet("ROTORSCOPE_FIRST_SEED"))
        seeds.first = qEnvironmentVariable("ROTORSCOPE_FIRST_SEED").toULongLong();
    if (qEnvironmentVariableIsSet("ROTORSCOPE_SEEDS"))
        seeds.count = qEnvironmentVariable("ROTORSCOPE_SEEDS").toULongLong();
    return seeds;
}

/// Plays all of them, also behind one that fails, and says how many there were: `./dev campaign` reads that.
/// @param play  of a seed, says what went wrong; an empty optional: there was nothing to be tried
/// @return  the first failures; empty if there are none
template <class Play>
std::string playSeeds(const Seeds &seeds, Play play)
{
    constexpr unsigned long long kTold = 5;
    std::string wrong;
    unsigned long long played = 0, failed = 0;
    for (std::uint64_t seed = seeds.first; seed < seeds.first + seeds.count; ++seed) {
        const std::optional<std::string> what = play(seed);
        if (!what)
            continue;
        ++played;
        if (what->empty() || ++failed > kTold)
            continue;
        wrong += "seed " + std::to_string(seed) + ": " + *what + "\n";
        qWarning("seed %llu: %s", static_cast<unsigned long long>(seed), what->c_str());
    }
    qInfo("sessions with faults: %llu, failed: %llu", played, failed);
    return wrong;
}

} // namespace support
