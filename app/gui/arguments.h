// The command line of the window: read before QApplication exists, so that --version and --help need no screen.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gui {

struct Arguments {
    bool version = false;
    bool help = false;
    bool connect = false;
    std::string port; ///< empty: the last one used
    std::uint32_t baud = 0; ///< 0: the last one used
    std::string language; ///< empty: the system's
    std::string file; ///< to open: a recording, CSV, or a workspace; empty: none
    std::string error; ///< one line that says what to do; empty if all was understood
};

/// Options with one dash (-platform, -style, ...) and their values are left to Qt.
Arguments readArguments(const std::vector<std::string> &arguments);

std::string helpText();

} // namespace gui
