// Whether a number is what is expected of it; what it is instead is said.
#pragma once

#include <QDebug>

#include <cmath>

namespace support {

inline bool near(double is, double expected, double error)
{
    if (std::abs(is - expected) <= error)
        return true;
    qWarning("%.9g is not %.9g within %.3g", is, expected, error);
    return false;
}

/// The error as a share of what is expected.
inline bool nearByShare(double is, double expected, double share)
{
    return near(is, expected, share * std::abs(expected));
}

} // namespace support
