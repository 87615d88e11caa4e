// How the judge of the wire is heard in a test: every finding is a line of its own, also when another assertion has
// failed before, and a finding fails the test.
#pragma once

#include "support/ms_rules.h"

#include <QDebug>
#include <QTest>

namespace support {

/// @param fails  false: the test takes the verdict into its own words
inline void speak(const judge::MsRules &judge, bool fails)
{
    for (const std::string &violation : judge.violations())
        qWarning().noquote() << "the judge:" << QString::fromStdString(violation);
    if (const std::string verdict = judge.verdict(); fails && !verdict.empty())
        QTest::qFail(verdict.c_str(), __FILE__, __LINE__);
}

} // namespace support
