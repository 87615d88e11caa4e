// The registers of a simulated MCB slave: words that a rig names, and the mapping registers that every drive has, with
// their checks. Nothing changes by itself.
//
//   0x640         1 config state, 2 cyclic state
//   0x650, 0x660  how many entries count; rx (master to drive), tx (drive to master)
//   0x651..0x65F, 0x661..0x66F  size in bytes x 65536 + address; 0: no entry
//
// Source: "MCB protocol description"; which check comes when, and the code for a wrong size, is not public: an entry is
// checked when it is written, its place in the list too (BadCyclicIndex), the sums when cyclic is switched on.
#pragma once

#include "mcb/error_code.h"
#include "mcb/value.h"

#include <map>
#include <optional>

namespace simulation {

struct McbRegister {
    mcb::Info info;
    mcb::Words words; ///< as they are sent
    bool operator==(const McbRegister &) const = default;
};

/// What a static slave is and holds.
struct McbRig {
    int replyDelay = 0; ///< IDLE frames before each answer
    std::map<std::uint16_t, McbRegister> registers; ///< by address
};

class McbRegisters {
public:
    static constexpr std::uint16_t kState = 0x640, kRxCount = 0x650, kTxCount = 0x660;
    static constexpr std::uint16_t kMostEntries = 15; ///< each way, behind its count
    static constexpr std::uint16_t kConfigState = 1, kCyclicState = 2;

    /// The mapping registers are as after power-on, whatever the rig says of them.
    explicit McbRegisters(const McbRig &rig);

    /// nullptr if there is none.
    const McbRegister *find(std::uint16_t address) const;
    std::uint32_t numberAt(std::uint16_t address) const; ///< 0: there is none
    Result<mcb::Words, mcb::ErrorCode> read(std::uint16_t address) const;
    /// @param words  may hold padding; a text that is shorter is filled up with zeros
    Result<void, mcb::ErrorCode> write(std::uint16_t address, mcb::WordView words);

    /// A value that lives; nothing if there is no such register.
    void put(std::uint16_t address, mcb::WordView words);

    /// What 0x640 reads: the state that is in force, not one that was asked for in vain.
    void setState(std::uint16_t state) { m_registers.at(kState).words = {state}; }

    /// Addresses of the registers that count, in the order of the list.
    struct Mapping {
        std::vector<std::uint16_t> rx, tx;
        std::size_t words = 0; ///< of a frame: the longer direction
    };
    /// The mapping as it stands, or why it cannot be switched on.
    Result<Mapping, mcb::ErrorCode> mapping() const;

    /// The values of the tx registers, then zeros up to the mapping's length.
    mcb::Words cyclicOutput(const Mapping &mapping) const;
    void acceptCyclicInput(const Mapping &mapping, mcb::WordView words);

private:
    Result<void, mcb::ErrorCode> checkEntry(std::uint16_t address, std::uint32_t entry) const;
    Result<void, mcb::ErrorCode> check(std::uint16_t address, mcb::WordView words) const;
    Result<std::vector<std::uint16_t>, mcb::ErrorCode> mapped(std::uint16_t count) const;
    std::size_t sumOf(const std::vector<std::uint16_t> &addresses) const;

    std::map<std::uint16_t, McbRegister> m_registers;
};

/// What stands behind the registers of a slave that is more than its registers: a motor and its control.
class McbLife {
public:
    McbLife() = default;
    McbLife(const McbLife &) = delete;
    McbLife &operator=(const McbLife &) = delete;
    virtual ~McbLife() = default;

    /// Puts the present values into the registers; before every frame.
    virtual void show(McbRegisters &registers) = 0;
    /// Why a value that the register could hold is not taken; before it is stored.
    virtual std::optional<mcb::ErrorCode> refusal(
        std::uint16_t address, mcb::WordView words) const = 0;
    /// Something was stored, by a write or by a cyclic frame.
    virtual void look(const McbRegisters &registers) = 0;
};

} // namespace simulation
