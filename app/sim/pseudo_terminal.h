// A raw pseudo-terminal: the board's end is ours, clients open the other by its path, come and go.
#pragma once

#include "base/bytes.h"
#include "base/result.h"

#include <string>

namespace sim {

class PseudoTerminal {
public:
    /// Opens one; a sentence if the system has none.
    static Result<PseudoTerminal, std::string> open();

    PseudoTerminal(PseudoTerminal &&other) noexcept;
    PseudoTerminal &operator=(PseudoTerminal &&) = delete;
    ~PseudoTerminal();

    const std::string &path() const { return m_path; } ///< what clients open
    int descriptor() const { return m_master; } ///< for poll(); only while clientPresent()

    /// Looks whether anybody has it open. What an earlier client did not read is thrown away when it leaves.
    bool clientPresent();
    Bytes read(); ///< what the client wrote; never waits
    /// As much as fits; a client that does not read loses the rest, as on a UART.
    void write(ByteView bytes);

private:
    PseudoTerminal(int master, std::string path);

    int m_master;
    std::string m_path;
    bool m_present = false;
};

/// A symbolic link that exists as long as this object.
class Link {
public:
    Link() = default;
    /// Replaces a symbolic link of that name, nothing else; a sentence if it cannot be made.
    static Result<Link, std::string> make(const std::string &path, const std::string &target);
    Link(Link &&other) noexcept;
    Link &operator=(Link &&other) noexcept;
    ~Link();

private:
    std::string m_path, m_target;
};

} // namespace sim
