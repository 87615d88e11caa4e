// What makes the tests of a folder one program: each is linked and compiled with the others, and still runs alone, by
// its name. Included before everything else in each test, by tests/CMakeLists.txt.
#pragma once

#include "support/watchdog/beats.h"

#include <QtTest>

namespace support {

using TestMain = int (*)(int argc, char *argv[]);

/// Makes a test known to its program under the name of its source, without folder and ending.
class NamedTest {
public:
    NamedTest(const char *source, TestMain main);
};

} // namespace support

// As in Qt, with a watchdog in it.
#undef QTEST_QAPP_SETUP
#define QTEST_QAPP_SETUP(Application)                                                              \
    support::Watched<Application> app(argc, argv);                                                 \
    app.setAttribute(Qt::AA_Use96Dpi, true);

// Qt's QTEST_MAIN and its kin are made of this one; several tests may be compiled at once. `...` are the lines that
// make an application object.
#undef QTEST_MAIN_WRAPPER
#define QTEST_MAIN_WRAPPER(TestObject, ...)                                                        \
    static int run##TestObject(int argc, char *argv[])                                             \
    {                                                                                              \
        QTest::Internal::callInitMain<TestObject>();                                               \
        __VA_ARGS__                                                                                \
        TestObject test;                                                                           \
        return QTest::qExec(&test, argc, argv);                                                    \
    }                                                                                              \
    static const support::NamedTest named##TestObject(__FILE__, run##TestObject);
