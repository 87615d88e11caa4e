// The main function of a program of tests. It runs the test that it is called as (a link to it bears the test's name),
// or that its first argument names; all further arguments are the test's own.
#include "test_program.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

namespace {

std::map<std::string, support::TestMain> &tests()
{
    static std::map<std::string, support::TestMain> all;
    return all;
}

std::string nameOf(const char *path) { return std::filesystem::path(path).stem().string(); }

} // namespace

namespace support {

NamedTest::NamedTest(const char *source, TestMain main) { tests()[nameOf(source)] = main; }

} // namespace support

int main(int argc, char *argv[])
{
    for (int named = 0; named < std::min(argc, 2); ++named)
        if (const auto test = tests().find(nameOf(argv[named])); test != tests().end())
            return test->second(argc - named, argv + named);
    std::fputs("Which test? Its name comes first; these are here:\n", stderr);
    for (const auto &test : tests())
        std::fprintf(stderr, "  %s\n", test.first.c_str());
    return 2;
}
