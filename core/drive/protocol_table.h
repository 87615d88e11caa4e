// The protocols, a row each: the one list of them. The window, the command line, the simulated boards and
// Protocol::Auto choose from it. A protocol more is a folder below this one, and a row.
#pragma once

#include "drive/drive.h"
#include "drive/event.h"
#include "drive/protocol.h"

#include <array>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace fcp {
enum class Dialect : std::uint8_t;
}

namespace drive {

struct LineOptions {
    Protocol protocol = Protocol::Auto;
    std::uint32_t baud = 1843200; ///< of the open port; time-outs and stream sizes follow from it
    Duration patience{}; ///< added to the time-out of every reply
    /// Of Protocol::Auto: what was spoken there before, and is tried first.
    std::optional<Protocol> spoken{};
};

/// The drive for a line, by the protocol that is spoken on it.
std::unique_ptr<Drive> makeDrive(const LineOptions &options);

/// Whether a drive is made to find out who is there.
enum class Search : std::uint8_t {
    No,
    Hasty, ///< another protocol is tried next
    Patient,
};

struct ProtocolRow {
    ProtocolChoice choice;
    std::uint32_t baud = 0; ///< of its boards, unless one is told otherwise; 0: its lines have none
    /// Profiles of its simulated boards, the usual one first; empty: the standard one, or none.
    std::array<std::string_view, 2> boards;
    std::unique_ptr<Drive> (*make)(const LineOptions &options, Search search) = nullptr;

    // Of those that Protocol::Auto asks for.
    LinkReason asking = LinkReason::None; ///< told meanwhile; None: it is not asked for
    std::string_view evidence = {}; ///< of one that has answered, where the drive itself tells none
    bool hurries = false; ///< Search::Hasty ends it sooner
    /// Failures that prove that its board is there, also when another protocol was tried.
    std::array<LinkReason, 2> proofs{};
};

/// In the order in which they are offered and asked for.
std::span<const ProtocolRow> protocolTable();
const ProtocolRow &rowOf(Protocol protocol);

// What makes them, in a file each.
std::unique_ptr<Drive> makeMcpDrive(const LineOptions &line, Search search = Search::No);
/// @param dialect  that the user chose; empty: found out
std::unique_ptr<Drive> makeFcpDrive(
    const LineOptions &line, std::optional<fcp::Dialect> dialect = {});
std::unique_ptr<Drive> makeMcbDrive(const LineOptions &line, Search search = Search::No);
/// @param candidates  at least one; in the order in which they are tried
std::unique_ptr<Drive> makeAutoDrive(
    std::vector<const ProtocolRow *> candidates, const LineOptions &options);

} // namespace drive
