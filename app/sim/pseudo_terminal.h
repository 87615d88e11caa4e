// A raw pseudo-terminal: the board's end is ours, clients open the other by its path, come and go.
#pragma once

#include "base/result.h"
#include "port.h"

#include <memory>
#include <string>

namespace sim {

class PseudoTerminal final : public Port {
public:
    /// Opens one; a sentence if the system has none.
    static Result<std::unique_ptr<Port>, std::string> open();
    ~PseudoTerminal() override;

    std::string address() const override { return m_path; }
    int descriptor() const override { return m_master; }
    /// What an earlier client did not read is thrown away when it leaves.
    bool clientPresent() override;
    Bytes read() override;
    void write(ByteView bytes) override;

private:
    explicit PseudoTerminal(int master)
        : m_master(master)
    {
    }

    int m_master;
    std::string m_path;
    bool m_present = false;
};

/// A symbolic link that exists as long as this object.
class SymbolicLink {
public:
    SymbolicLink() = default;
    /// Replaces a symbolic link of that name, nothing else; a sentence if it cannot be made.
    static Result<SymbolicLink, std::string> make(
        const std::string &path, const std::string &target);
    SymbolicLink(SymbolicLink &&other) noexcept;
    SymbolicLink &operator=(SymbolicLink &&other) noexcept;
    ~SymbolicLink();

private:
    std::string m_path, m_target;
};

} // namespace sim
