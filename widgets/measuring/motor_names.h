// Names of a motor's signals: a board with several motors has the motor behind them, as in I_A@2.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace widgets {

/// The motor whose signals are meant; 0 where a file is shown, which says nothing about what is chosen.
using ChosenMotor = std::function<int()>;

/// What may stand behind the names of one motor's signals: nothing where there is but one, else the chosen motor; for a
/// file any, the lowest first.
inline std::vector<std::string> motorEndings(int chosen)
{
    constexpr int kMostMotors = 7;
    std::vector<std::string> endings{""};
    for (int motor = 1; motor <= kMostMotors; ++motor)
        if (chosen == 0 || chosen == motor)
            endings.push_back("@" + std::to_string(motor));
    return endings;
}

/// "@2" of "I_A@2"; empty if there is none.
inline std::string motorEndingOf(const std::string &name)
{
    const std::size_t at = name.rfind('@');
    return at == std::string::npos ? std::string() : name.substr(at);
}

} // namespace widgets
