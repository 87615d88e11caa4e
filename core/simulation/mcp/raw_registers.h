// Registers of more than four bytes: structures and texts, as rows of data.
#pragma once

#include "base/bytes.h"
#include "simulation/mcp/register_table.h"
#include "simulation/stale_bytes.h"

#include <string>

namespace simulation {

struct RawRow {
    using Get = Bytes (*)(const RegisterContext &); ///< without the size in front
    /// `value` starts behind the size; it can be read beyond `size`, as the firmware does.
    using Set = mcp::Status (*)(RegisterContext &, const StaleBytes &value, int size);

    mcp::RegisterId id{}; ///< without motor
    Get get = nullptr; ///< nullptr: GET answers UNKNOWN_REG
    Set set = nullptr; ///< nullptr: SET answers `refusal`
    mcp::Status refusal = mcp::Status::ReadOnly;
    RegisterRow::Exists exists = nullptr;
    RegisterRow::Scope scope = RegisterRow::Scope::Motor;
    bool refusedAnywhere = false; ///< SET answers `refusal` for the motor bits of others, too
    bool ofCalibration = false; ///< GET answers REGISTER_ACCESS before the first start
    bool looksAtRoom = true; ///< false: GET answers more than was agreed rather than refuse
};

struct TextRow {
    mcp::RegisterId id{};
    std::string (*get)(const RegisterContext &) = nullptr;
    RegisterRow::Scope scope = RegisterRow::Scope::Motor;
};

/// nullptr if this build does not have it. The datalog's registers are not among them.
const RawRow *findRaw(mcp::RegisterId id, const Traits &traits, const Build &build);
const TextRow *findText(mcp::RegisterId id);

} // namespace simulation
