// Reading the flags: a table from flag to the member it fills and what it may be.
#include "options.h"

#include "served.h"

#include "base/text.h"
#include "drive/protocol_table.h"
#include "session/files/motor_file.h"
#include "simulation/fcp/motor_board.h"
#include "simulation/mcp/profile.h"
#include "simulation/plant/presets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <utility>

namespace sim {

namespace {

constexpr std::string_view kHelp =
    R"(Usage: rotorscope-sim mcp [OPTION]...
       rotorscope-sim mcb [--rig FILE] [OPTION]...
       rotorscope-sim legacy|powerpc [--motors N] [--motor M] [OPTION]...
       rotorscope-sim legacy|powerpc --rig FILE [--link PATH | --tcp PORT]
                      [--control]

A simulated motor control board behind a pseudo-terminal. The first line it
prints is "ready PATH"; open PATH as if it were the serial port of a board.
It serves one client after the other until SIGTERM.

  --profile P       whose firmware; see --list-profiles (mcsdk-6.4)
  --with NAME,...   what the firmware is built with besides; see --list-options
  --motor M         a motor of --list-motors, or a JSON file whose name ends in
                    .json or holds a slash (pm24)
  --motors N        how many of them, 1 or 2 (1)
  --load L          a brake of so many Nm, or fan:K for K (rad/s)^2 in Nm, or
                    drive:NM for a machine that pushes; joined by commas: all
  --link PATH       also make PATH a symbolic link to the pseudo-terminal
  --tcp PORT        instead of a pseudo-terminal, a TCP port of 127.0.0.1 for one
                    client at a time; 0: a free one, see the first line
  --baud N          speed of the line in both directions (1843200)
  --hf-hz N         rate of the control task, 1000 to 50000 Hz (16000)
  --rx-max N        largest request, a multiple of 32 up to 2048 bytes (256)
  --txs-max N       largest response, a multiple of 32 up to 4096 bytes (256)
  --txa-max N       largest async packet, a multiple of 64 up to 8128 bytes
                    (2048); 0: no datalog
  --crc 0|1         payloads end in the two bytes that stand for a CRC (0)
  --version N       protocol version it answers, 0 to 7 (0)
  --liid N          link it is on: 0 UART A, 1 UART B (0)
  --streams N       signals the datalog can hold, 0 to 64 (10)
  --ts0 N           datalog time at power-on (0)
  --null-check 0|1  repeat the last response on an empty request (0)
  --wide 0|1        datalog sources for STATUS, SPEED_MEAS, SPEED_REF and
                    FAULTS_FLAGS (0)
  --user-cb N       user commands it knows, 0 to 2 (0)
  --watchdog MS     stop the motor when no heartbeat (user command 1) comes
                    for MS milliseconds, and say so in FW_NAME; 0: never (0)
  --liar NAME[:N],..  do these things wrong, each at one chance in N; the names
                    and what N is otherwise: --list-liars
  --seed N          of noise and lies; the same seed gives the same run (1)
  --control         obey words on standard input, one a line, and end with it:
                    reset | fault HEX | nofault | load NM [MOTOR] | mute MS |
                    corrupt N | inject HEX | quit
  --describe        print what this board is, as JSON, and end
  --list-profiles   what --profile can be, and end; so do
  --list-options    what --with can be,
  --list-motors     what --motor can be, and
  --list-liars      what --liar can be
  --help            this text

mcb is a drive on the Motion Control Bus (SPI), a servo with an encoder: it
answers each frame with as many bytes, those it would send at the same time.
It takes --motor (servo24), --load, --hf-hz, --link, --tcp, --seed, --control,
and besides:

  --profile P       whose registers: summit-1.12, or newer with other types
  --reply-delay N   so many IDLE frames before each answer, 0 to 1000 (0)
  --liar NAME[:N],..  see the last part of --list-liars
  --rig FILE        instead of all that a slave that stands still, with these
                    registers: JSON, see docs/simulator.md; obeys reset | quit

legacy and powerpc are a board of the older serial protocol at 115200 baud, in
its dialect for STM32 or for PowerPC. Without a rig motors turn behind it, and
it takes of the options above --profile, --motor, --motors, --load, --with,
--link, --tcp, --baud, --hf-hz, --seed and --control with their words.

  --profile P       legacy: as firmware 5.4.3 behaves, legacy-text: as it is
                    printed (legacy)
  --rig FILE        a static board instead: JSON, see docs/simulator.md; it says
                    which dialect is spoken
  --control         of a static board: obeys besides reset, nofault, fault, mute, corrupt, inject
                    and quit: state N | faults HEX | execute | rx-timeout |
                    rx-overrun
)";

struct Flag {
    std::string_view name;
    std::uint64_t least, most, step; ///< step: it must be a multiple of
    std::function<void(Options &, std::uint64_t)> put;
};

template <class Member>
auto into(Member simulation::BoardOptions::*member)
{
    return [member](Options &options, std::uint64_t value) {
        options.board.*member = static_cast<Member>(value);
    };
}

const std::vector<Flag> &flags()
{
    using B = simulation::BoardOptions;
    static const std::vector<Flag> table{
        {"--rx-max", 32, 2048, 32, into(&B::rxMax)},
        {"--txs-max", 32, 4096, 32, into(&B::txSyncMax)},
        {"--txa-max", 0, 8128, 64, into(&B::txAsyncMax)},
        {"--crc", 0, 1, 1, into(&B::dataCrc)},
        {"--version", 0, 7, 1, into(&B::version)},
        {"--liid", 0, 15, 1, into(&B::linkId)},
        {"--streams", 0, 64, 1, into(&B::streams)},
        {"--baud", 1200, 12'000'000, 1, into(&B::baud)},
        {"--hf-hz", 1000, 50'000, 1, into(&B::hfHz)},
        {"--ts0", 0, UINT32_MAX, 1, into(&B::firstTimestamp)},
        {"--null-check", 0, 1, 1, into(&B::nullCheck)},
        {"--wide", 0, 1, 1, into(&B::wide)},
        {"--user-cb", 0, 2, 1, into(&B::userCallbacks)},
        {"--watchdog", 0, 60'000, 1, into(&B::watchdogMs)},
        {"--seed", 0, UINT64_MAX, 1, into(&B::seed)},
        {"--motors", 1, 2, 1, into(&B::motors)},
        {"--reply-delay", 0, 1000, 1,
            [](Options &options, std::uint64_t value) {
                options.mcb.replyDelay = static_cast<int>(value);
            }},
        {"--tcp", 0, UINT16_MAX, 1,
            [](Options &options, std::uint64_t value) {
                options.tcp = static_cast<std::uint16_t>(value);
            }},
    };
    return table;
}

std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

std::string profileNames()
{
    std::string list;
    for (const std::string &name : simulation::profileNames())
        list += (list.empty() ? "" : ", ") + name;
    return list;
}

std::optional<double> realNumber(std::string_view text)
{
    const auto value = numberIn<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Fills the flag's member; a sentence if the value cannot be had.
std::optional<std::string> apply(const Flag &flag, std::string_view text, Options &options)
{
    const auto value = numberIn<std::uint64_t>(text);
    if (!value || *value < flag.least || *value > flag.most || *value % flag.step != 0) {
        std::string range = std::to_string(flag.least) + " to " + std::to_string(flag.most);
        if (flag.step > 1)
            range += ", a multiple of " + std::to_string(flag.step);
        return std::string(flag.name) + " takes a number from " + range + ", not " + quoted(text);
    }
    flag.put(options, *value);
    return std::nullopt;
}

/// Calls `take` with each item of a list with commas, until it returns a sentence.
template <class Take>
std::optional<std::string> eachItem(std::string_view list, Take &&take)
{
    while (!list.empty()) {
        const std::string_view item = list.substr(0, list.find(','));
        list.remove_prefix(std::min(list.size(), item.size() + 1));
        if (auto problem = take(item))
            return problem;
    }
    return std::nullopt;
}

/// The row of that name; nullptr if there is none.
template <class Row>
const Row *rowOf(std::span<const Row> rows, std::string_view name)
{
    const auto row =
        std::find_if(rows.begin(), rows.end(), [=](const Row &one) { return one.name == name; });
    return row == rows.end() ? nullptr : &*row;
}

/// Takes the lies of a list like "twice,noise:3".
/// @param add  gets the row of each and the chance, one in so many; 0: the list has none
template <class Row, class Add>
std::optional<std::string> readLies(std::string_view list, std::span<const Row> rows, Add &&add)
{
    return eachItem(list, [&](std::string_view item) -> std::optional<std::string> {
        constexpr std::uint64_t kMost = 1'000'000;
        const std::size_t colon = item.find(':');
        const std::string_view name = item.substr(0, colon);
        const Row *row = rowOf(rows, name);
        if (row == nullptr)
            return "there is no lie " + quoted(name) + "; see --list-liars";
        std::optional<std::uint64_t> oneIn = 0;
        if (colon != std::string_view::npos) {
            if constexpr (requires { row->oneIn; })
                if (row->oneIn == 0)
                    return std::string(name) + " has times of its own and takes no chance";
            oneIn = numberIn<std::uint64_t>(item.substr(colon + 1));
            if (!oneIn || *oneIn < 1 || *oneIn > kMost)
                return std::string(name) + ": the chance is one in 1 to 1000000, not "
                    + quoted(item.substr(colon + 1));
        }
        add(*row, static_cast<std::uint32_t>(*oneIn));
        return std::nullopt;
    });
}

/// Adds the build options of a list like "cordic,profiler".
std::optional<std::string> readBuildOptions(
    std::string_view list, std::vector<const simulation::BuildOption *> &with)
{
    return eachItem(list, [&](std::string_view item) -> std::optional<std::string> {
        const auto *row = rowOf(simulation::buildOptions(), item);
        if (row == nullptr)
            return "there is no option " + quoted(item) + " to build with; see --list-options";
        with.push_back(row);
        return std::nullopt;
    });
}

/// A preset's name, or a file: those have a slash or an ending in their name, presets have neither.
std::optional<std::string> readMotorOption(std::string_view text, simulation::BoardOptions &board)
{
    board.plant.reset();
    board.motor.clear();
    if (text.find('/') == std::string_view::npos && !text.ends_with(".json")) {
        board.motor = text;
        if (simulation::findPreset(text) != nullptr)
            return std::nullopt;
        return "there is no motor " + quoted(text) + "; see --list-motors";
    }
    const std::string path(text);
    auto file = session::readMotorFile(QString::fromStdString(path));
    if (!file)
        return session::motorFileErrorText(path, file.error());
    board.plant = std::move(file->machine);
    return std::nullopt;
}

/// "0.1", "fan:1e-6", "drive:-0.05", or several joined by commas.
std::optional<std::string> readLoad(std::string_view list, simulation::LoadParameters &load)
{
    return eachItem(list, [&](std::string_view item) -> std::optional<std::string> {
        constexpr double kMost = 1000.0;
        const std::size_t colon = item.find(':');
        const bool named = colon != std::string_view::npos;
        const std::string_view kind = named ? item.substr(0, colon) : std::string_view();
        const auto value = realNumber(named ? item.substr(colon + 1) : item);
        double *place = !named ? &load.constant_nm
            : kind == "fan"    ? &load.fan_nms2
            : kind == "drive"  ? &load.drive_nm
                               : nullptr;
        const double least = kind == "drive" ? -kMost : 0.0;
        if (place == nullptr || !value || *value < least || *value > kMost)
            return "--load takes NM, fan:K or drive:NM with numbers up to 1000, not "
                + quoted(item);
        *place = *value;
        return std::nullopt;
    });
}

// The firmware that a name stands for; a sentence if there is none.

std::optional<std::string> readMcpProfile(std::string_view name, Options &options)
{
    options.board.profile = name;
    if (simulation::findTraits(name) != nullptr)
        return std::nullopt;
    return "there is no profile " + quoted(name) + "; there are " + profileNames();
}

std::optional<std::string> readFcpProfile(std::string_view name, Options &options)
{
    options.board.profile = name;
    if (simulation::isFcpProfile(name))
        return std::nullopt;
    return "there is no profile " + quoted(name) + " of this protocol; see --help";
}

std::optional<std::string> readMcbProfile(std::string_view name, Options &options)
{
    options.mcb.servo.newer = name == "newer";
    if (options.mcb.servo.newer || name == "summit-1.12")
        return std::nullopt;
    return "there is no profile " + quoted(name) + "; there are summit-1.12, newer";
}

std::optional<std::string> readMcpLies(std::string_view list, Options &options)
{
    return readLies(list, simulation::lies(), [&](const auto &row, std::uint32_t oneIn) {
        options.board.lies.push_back({row.lie, oneIn});
    });
}

std::optional<std::string> readMcbLies(std::string_view list, Options &options)
{
    return readLies(list, simulation::mcbFaultList(), [&](const auto &row, std::uint32_t oneIn) {
        simulation::McbFaultChoice choice{row.fault};
        if (oneIn > 0)
            choice.every = oneIn;
        options.mcb.faults.push_back(choice);
    });
}

constexpr std::array kOfRigs{"--rig", "--link", "--tcp", "--control"};
constexpr std::array kOfServos{
    "--motor", "--load", "--hf-hz", "--seed", "--profile", "--reply-delay", "--liar"};
constexpr std::array kOfFcp{
    "--profile", "--motor", "--motors", "--load", "--with", "--baud", "--hf-hz", "--seed"};

bool isOneOf(std::span<const char *const> names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool mcpTakes(std::string_view name) { return name != "--rig" && name != "--reply-delay"; }
bool fcpTakes(std::string_view name) { return isOneOf(kOfRigs, name) || isOneOf(kOfFcp, name); }
bool mcbTakes(std::string_view name) { return isOneOf(kOfRigs, name) || isOneOf(kOfServos, name); }

/// A protocol's options here; its word, usual profile and baud rate are those of drive::protocolTable().
struct Spoken {
    drive::Protocol protocol;
    bool (*takes)(std::string_view name); ///< whether that option means something to its devices
    std::optional<std::string> (*readProfile)(std::string_view name, Options &options);
    std::optional<std::string> (*readLies)(std::string_view list, Options &options);
    decltype(Options::serve) serve;
};
constexpr std::array kSpoken{
    Spoken{drive::Protocol::Mcp, mcpTakes, readMcpProfile, readMcpLies, serveBoard},
    Spoken{drive::Protocol::Fcp, fcpTakes, readFcpProfile, nullptr, serveFcp},
    Spoken{drive::Protocol::PowerPc, fcpTakes, readFcpProfile, nullptr, serveFcp},
    Spoken{drive::Protocol::Mcb, mcbTakes, readMcbProfile, readMcbLies, serveMcb},
};

std::optional<std::string> applyNamed(
    const Spoken &spoken, std::string_view name, std::string_view value, Options &options)
{
    if (name == "--profile")
        return spoken.readProfile(value, options);
    if (name == "--liar")
        return spoken.readLies(value, options);
    if (name == "--with")
        return readBuildOptions(value, options.board.with);
    if (name == "--motor")
        return readMotorOption(value, options.board);
    if (name == "--load")
        return readLoad(value, options.board.load.emplace());
    if (name == "--rig") {
        options.rig = value;
        return std::nullopt;
    }
    if (name == "--link") {
        options.link = value;
        return std::nullopt;
    }
    for (const Flag &flag : flags()) {
        if (flag.name == name)
            return apply(flag, value, options);
    }
    return "there is no option " + quoted(name) + "; see --help";
}

/// They need nothing else.
constexpr Word<Action> kListings[] = {{"--list-profiles", Action::ListProfiles},
    {"--list-options", Action::ListOptions}, {"--list-motors", Action::ListMotors},
    {"--list-liars", Action::ListLiars}};

} // namespace

std::string_view helpText() { return kHelp; }

Result<Options, std::string> readOptions(const std::vector<std::string_view> &words)
{
    Options options;
    for (const std::string_view word : words) {
        if (word == "--help" || word == "-h")
            options.action = Action::Help;
        if (const auto *listing = findWord(kListings, word);
            listing != nullptr && options.action == Action::Serve)
            options.action = *listing;
    }
    if (options.action != Action::Serve)
        return options;
    const auto protocol = drive::protocolOf(words.empty() ? std::string_view() : words[0]);
    const auto spoken =
        std::ranges::find_if(kSpoken, [&](const Spoken &one) { return one.protocol == protocol; });
    if (spoken == kSpoken.end())
        return fail(std::string("say what to simulate: rotorscope-sim mcp|mcb|legacy|powerpc "
                                "[OPTION]...; see --help"));
    options.serve = spoken->serve;
    const drive::ProtocolRow &row = drive::rowOf(spoken->protocol);
    if (!row.boards.front().empty())
        options.board.profile = row.boards.front();
    if (row.baud > 0)
        options.board.baud = row.baud;
    std::string_view ofMotors; // an option that a rig leaves no room for
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string_view word = words[i];
        const std::size_t equals = word.find('=');
        const std::string_view name = word.substr(0, equals);
        if (!spoken->takes(name))
            return fail(std::string(name) + " does not go with this protocol; see --help");
        if (!isOneOf(kOfRigs, name))
            ofMotors = word;
        if (word == "--control") {
            options.control = true;
            continue;
        }
        if (word == "--describe") {
            options.action = Action::Describe;
            continue;
        }
        std::string_view value;
        if (equals != std::string_view::npos) {
            value = word.substr(equals + 1);
        } else if (!name.starts_with("--")) {
            return fail("there is no option " + quoted(name) + "; see --help");
        } else if (++i < words.size()) {
            value = words[i];
        } else {
            return fail(std::string(name) + " needs a value; see --help");
        }
        if (const auto problem = applyNamed(*spoken, name, value, options))
            return fail(*problem);
    }
    if (!options.rig.empty() && !ofMotors.empty())
        return fail(std::string(ofMotors) + " does not go with --rig; see --help");
    if (options.tcp && !options.link.empty())
        return fail(std::string("--link goes with a pseudo-terminal, not with --tcp"));
    return options;
}

} // namespace sim
