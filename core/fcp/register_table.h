// The registers of both dialects: what each is, how wide it is on the wire, which builds have it. Read from
// resources/registers/legacy.csv, which is built in. A value is decoded only if its length fits its register.
#pragma once

#include "base/result.h"
#include "catalog/csv.h"
#include "catalog/register_info.h"
#include "fcp/protocol.h"
#include "fcp/reply.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace fcp {

/// What a build has to be made with to have a register.
enum class Need : std::uint8_t {
    Nothing,
    Pll, ///< the observer with PLL
    Cordic, ///< the observer with CORDIC
    Sensor, ///< encoder or Hall sensors
    FluxWeakening,
    FeedForward,
    Pfc,
    Dac,
    Injection,
    Profiler,
    Position,
};

struct Register {
    catalog::RegisterInfo info; ///< of the dialect; access None: cannot be read or written
    /// What goes over the wire; 0: refused. STM32: what firmware 5.4.3 does. PowerPC: what the text says.
    std::size_t readBytes = 0, writeBytes = 0;
    Need need = Need::Nothing;
    bool dacSource = false; ///< its number may be written to DAC_OUT1 and 2
};

/// The registers of a dialect in the order of their ids. Fails only if the table is not well-formed.
Result<std::vector<Register>, catalog::TableError> readRegisterTable(
    std::string_view csv, Dialect dialect);
/// The table that is built in; the same object each time.
const std::vector<Register> &registersOf(Dialect dialect);
/// nullptr if the dialect has none of that id.
const Register *findRegister(Dialect dialect, std::uint8_t id);

/// The number in a value of the register's full width or of the width in which firmware sends it; others are BadLength.
Result<catalog::Value, ReplyError> decodeValue(const Register &which, ByteView bytes);
/// The number in exactly `width` bytes, 1, 2 or 4: what does not fit loses its upper bits, as in firmware.
Bytes encodeValue(const Register &which, const catalog::Value &value, std::size_t width);

} // namespace fcp
