#include "arguments.h"

#include "base/text.h"

#include <optional>

namespace gui {
namespace {

std::optional<std::uint32_t> readBaud(const std::string &text)
{
    const auto baud = numberIn<std::uint32_t>(text);
    return baud && *baud != 0 ? baud : std::nullopt;
}

/// Takes the value of an option, given as "--name value" or "--name=value".
struct Cursor {
    const std::vector<std::string> &all;
    std::size_t at = 0;

    bool option(const std::string &name, std::string &value, std::string &error)
    {
        const std::string &word = all[at];
        if (word.starts_with(name + "=")) {
            value = word.substr(name.size() + 1);
            return true;
        }
        if (word != name)
            return false;
        if (at + 1 >= all.size())
            error = name + " needs a value; see --help.";
        else
            value = all[++at];
        return true;
    }
};

} // namespace

Arguments readArguments(const std::vector<std::string> &arguments)
{
    Arguments result;
    Cursor cursor{arguments};
    for (; cursor.at < arguments.size() && result.error.empty(); ++cursor.at) {
        const std::string &word = arguments[cursor.at];
        std::string value;
        if (word == "--version" || word == "-v") {
            result.version = true;
        } else if (word == "--help" || word == "-h") {
            result.help = true;
        } else if (word == "--connect") {
            result.connect = true;
        } else if (cursor.option("--port", result.port, result.error)
            || cursor.option("--language", result.language, result.error)) {
            continue;
        } else if (cursor.option("--baud", value, result.error)) {
            if (const auto baud = readBaud(value))
                result.baud = *baud;
            else if (result.error.empty())
                result.error =
                    "\"" + value + "\" is not a baud rate; give a number such as 1843200.";
        } else if (word.size() > 1 && word[0] == '-' && word[1] != '-') {
            if (cursor.at + 1 < arguments.size() && !arguments[cursor.at + 1].starts_with('-'))
                ++cursor.at; // Qt's own option and its value
        } else if (word.starts_with('-')) {
            result.error = "\"" + word + "\" is not an option; see --help.";
        } else if (!result.file.empty()) {
            result.error = "One file can be opened, not \"" + word + "\" besides; see --help.";
        } else {
            result.file = word;
        }
    }
    return result;
}

std::string helpText()
{
    return "Usage: rotorscope [OPTION]... [FILE]\n"
           "Opens the workbench for tuning electric motors, and in it FILE: a recording (.pcapng), "
           "CSV,\nor a workspace.\n"
           "\n"
           "  --port PORT      choose this port: a device path, or sim for the simulated board\n"
           "  --baud N         choose this baud rate\n"
           "  --connect        connect at once (read-only until it is armed)\n"
           "  --language CODE  language of the window, e.g. de; the system's if not given\n"
           "  --version        print the version and end\n"
           "  --help           print this help and end\n"
           "\n"
           "Exit status: 0 done, 2 wrong usage.\n";
}

} // namespace gui
