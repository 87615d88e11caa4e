// How right an estimate is, against the truth of a simulated motor. Macros, so that the test ends where it stands.
#pragma once

#include <QtTest>

#include <cmath>

#define VERIFY_WITHIN(estimate, truth, percent)                                                    \
    QVERIFY2(std::abs((estimate).value - (truth)) <= (percent) / 100.0 * (truth),                  \
        qPrintable(QStringLiteral("%1 is %2 %% off")                                               \
                       .arg(QLatin1String(#truth))                                                 \
                       .arg(((estimate).value / (truth)-1.0) * 100.0)))
#define VERIFY_HOLDS(estimate, truth)                                                              \
    QVERIFY2(*(estimate).low <= (truth) && (truth) <= *(estimate).high,                            \
        qPrintable(QStringLiteral("%1: %2 is not in %3 to %4")                                     \
                       .arg(QLatin1String(#truth))                                                 \
                       .arg(truth)                                                                 \
                       .arg(*(estimate).low)                                                       \
                       .arg(*(estimate).high)))
