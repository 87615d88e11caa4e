#include "drive/mcb/identification.h"

#include "base/text.h"
#include "drive/mcb/set_points.h"
#include "drive/motion_limits.h"
#include "mcb/dictionary.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace drive {

namespace {

constexpr std::array kValues{mcbreg::kVendor, mcbreg::kProduct, mcbreg::kRevision, mcbreg::kSerial,
    mcbreg::kVersion, mcbreg::kWeb, mcbreg::kMaxVelocity, mcbreg::kMaxCurrent,
    mcbreg::kRatedCurrent, mcbreg::kPeakCurrent, mcbreg::kPolePairs, mcbreg::kEncoderCounts};

constexpr int kMostLosses = 3; ///< of a register, beyond what the link repeats by itself
constexpr double kExchangeHz = 1000.0; ///< of the cyclic state
constexpr double kMaxPolePairs = 100.0;

struct StateRow {
    std::uint16_t mask = 0, bits = 0;
    McbState state;
};
// Masks and bits: "MCB protocol description", section 7, and DS402 for the rest.
constexpr std::array kStates{
    StateRow{0x4F, 0x00, {MotorState::Unknown, "NOT_READY", 0x00}},
    StateRow{0x4F, 0x40, {MotorState::Idle, "SWITCH_ON_DISABLED", 0x40}},
    StateRow{0x6F, 0x21, {MotorState::Idle, "READY_TO_SWITCH_ON", 0x21}},
    StateRow{0x6F, 0x23, {MotorState::Starting, "SWITCHED_ON", 0x23}},
    StateRow{0x6F, 0x27, {MotorState::Running, "OPERATION_ENABLED", 0x27}},
    StateRow{0x6F, 0x07, {MotorState::Stopping, "QUICK_STOP_ACTIVE", 0x07}},
    StateRow{0x4F, 0x0F, {MotorState::FaultNow, "FAULT_REACTION_ACTIVE", 0x0F}},
    StateRow{0x4F, 0x08, {MotorState::FaultOver, "FAULT", 0x08}},
};

/// What a drive can do.
void addCapabilities(McbFacts &board)
{
    using namespace mcbreg;
    board.capabilities.clear();
    const std::string strange = board.knownFirmware
        ? ""
        : "This drive has no control word and status word; it is shown read-only.";
    const auto needs = [&](std::initializer_list<std::uint16_t> addresses, const char *reason) {
        const bool there = std::ranges::all_of(
            addresses, [&](std::uint16_t address) { return board.writable(address); });
        return !strange.empty() ? strange : there ? std::string() : std::string(reason);
    };
    board.tell(Feature::Start, needs({kMode}, "This drive has no modes."));
    board.tell(Feature::Stop, "");
    board.tell(Feature::AcknowledgeFaults, strange);
    board.tell(
        Feature::SpeedRamp, needs({kMode, kVelocity}, "This drive has no velocity set-point."));
    board.tell(
        Feature::TorqueRamp, "This drive has no ramp for currents; set the current reference.");
    board.tell(Feature::CurrentReference,
        needs({kMode, kIq, kId}, "This drive has no current set-point."));
    board.tell(Feature::Stream,
        board.streaming.maxSignals > 0 ? "" : "This drive has no registers that can be mapped.");
    board.tell(Feature::WriteRegisters, strange);
    std::string position =
        needs({kMode, kPosition, kProfileVelocity}, "This drive has no position set-point.");
    if (position.empty() && !(board.countsPerTurn > 0.0))
        position = "The drive does not say how many counts a turn has.";
    board.tell(Feature::PositionRamp, position);
    const bool travels = !McbSetPoints(board).entries().empty();
    board.tell(Feature::CyclicSetPoints,
        !strange.empty() ? strange
            : travels    ? ""
                         : "This drive has no set-points that can be mapped.");
    board.tell(Feature::CurrentScale, "The drive tells its current scale itself.");
}

} // namespace

McbState mcbStateOf(std::uint16_t statusWord)
{
    for (const StateRow &row : kStates)
        if ((statusWord & row.mask) == row.bits)
            return row.state;
    return {MotorState::Unknown, "UNKNOWN", statusWord & 0x6F};
}

std::vector<StateStep> McbProtocol::stateSteps()
{
    std::vector<StateStep> steps;
    for (const StateRow &row : kStates) {
        if (row.state.state == MotorState::Unknown)
            continue;
        if (!steps.empty() && steps.back().state == row.state.state)
            steps.back().names.emplace_back(row.state.name);
        else
            steps.push_back({row.state.state, {std::string(row.state.name)}});
    }
    return steps;
}

void McbIdentification::restart()
{
    m_phase = Phase::Infos;
    m_waiting.clear();
    for (const mcb::Entry &entry : mcb::dictionary())
        m_waiting.push_back(entry.address);
    m_words.clear();
    m_infos.clear();
    m_losses = 0;
    m_board.identity = {};
    m_board.expert.clear();
    m_board.identified = false;
}

std::optional<McbRequest> McbIdentification::nextRequest(TimePoint)
{
    if (m_waiting.empty())
        return std::nullopt;
    return m_phase == Phase::Infos ? mcbInfo(m_waiting.front()) : mcbRead(m_waiting.front());
}

void McbIdentification::onResponse(const McbAnswer &answer, TimePoint)
{
    if (m_waiting.empty())
        return;
    const std::uint16_t address = m_waiting.front();
    if (answer.ok && m_phase == Phase::Infos && answer.words.size() >= mcb::kConfigWords) {
        const mcb::Info info = mcb::infoOf({answer.words[0], answer.words[1], 0, 0});
        if (info.access != catalog::Access::None && info.size > 0)
            m_infos[address] = info;
    } else if (answer.ok) {
        m_words[address] = answer.words;
    }
    next();
}

void McbIdentification::onNoResponse(std::optional<bool>, TimePoint)
{
    if (m_waiting.empty() || ++m_losses < kMostLosses)
        return;
    next();
}

void McbIdentification::next()
{
    m_losses = 0;
    m_waiting.pop_front();
    if (!m_waiting.empty())
        return;
    if (m_phase == Phase::Infos) {
        m_board.infos = std::move(m_infos);
        m_phase = Phase::Values;
        for (const std::uint16_t address : kValues)
            if (m_board.readable(address))
                m_waiting.push_back(address);
    }
    if (m_waiting.empty())
        finish();
}

/// No source says which byte of a word comes first in a text; a web address and a version have letters that tell.
void McbIdentification::findTextOrder()
{
    const auto looksRight = [this](mcb::TextOrder order) {
        m_board.order = order;
        const std::string web = textAt(mcbreg::kWeb), version = textAt(mcbreg::kVersion);
        if (!web.empty())
            return web.starts_with("http") || web.starts_with("ww");
        const std::size_t dot = version.find('.');
        return dot != std::string::npos && numberIn<std::uint64_t>(version.substr(0, dot));
    };
    if (!looksRight(mcb::TextOrder::HighByteFirst) && !looksRight(mcb::TextOrder::LowByteFirst))
        m_board.order = mcb::TextOrder::HighByteFirst;
}

std::optional<Value> McbIdentification::valueAt(std::uint16_t address) const
{
    const auto at = m_words.find(address);
    return at == m_words.end() ? std::nullopt : mcbValueOf(m_board, address, at->second);
}

double McbIdentification::numberAt(std::uint16_t address) const
{
    const auto value = valueAt(address);
    const auto number = value ? catalog::asNumber(*value) : std::nullopt;
    return number && std::isfinite(*number) ? *number : 0.0;
}

std::string McbIdentification::textAt(std::uint16_t address) const
{
    auto value = valueAt(address);
    auto *text = value ? std::get_if<std::string>(&*value) : nullptr;
    return text != nullptr ? std::move(*text) : std::string();
}

void McbIdentification::finish()
{
    findTextOrder();
    m_board.motors = 1;
    m_board.catalog = mcbCatalogOf(m_board.infos);
    m_board.scales.assign(1, {});
    const mcb::Info *control = m_board.infoOf(mcbreg::kControl);
    const mcb::Info *status = m_board.infoOf(mcbreg::kStatus);
    m_board.knownFirmware = control != nullptr && status != nullptr
        && control->type == mcb::Type::UInt16 && status->type == mcb::Type::UInt16
        && m_board.writable(mcbreg::kControl) && m_board.readable(mcbreg::kStatus);

    MotorLimits limits;
    limits.maxSpeedRpm = plausible(kSecondsPerMinute * numberAt(mcbreg::kMaxVelocity), kHighestRpm);
    limits.maxCurrentAmps = plausible(numberAt(mcbreg::kMaxCurrent), kHighestAmps);
    const double peak = plausible(numberAt(mcbreg::kPeakCurrent), kHighestAmps);
    if (peak > 0.0 && limits.maxCurrentAmps > 0.0)
        limits.maxCurrentAmps = std::min(limits.maxCurrentAmps, peak);
    limits.nominalCurrentAmps = plausible(numberAt(mcbreg::kRatedCurrent), kHighestAmps);
    limits.polePairs = plausible(numberAt(mcbreg::kPolePairs), kMaxPolePairs);
    m_board.limits.assign(1, limits);
    m_board.countsPerTurn = plausible(numberAt(mcbreg::kEncoderCounts), 1e9);

    m_board.streaming = {};
    const bool streams = std::ranges::any_of(
        m_board.infos, [](const auto &one) { return one.second.cyclic == mcb::Cyclic::Tx; });
    if (streams) {
        m_board.streaming.tickHz = kExchangeHz;
        m_board.streaming.maxSignals = mcb::kMostMapped;
        m_board.streaming.maxPacket = mcb::kMostFrameBytes;
        m_board.streaming.linkBytesPerSecond = kExchangeHz * mcb::kMostFrameBytes;
        m_board.streaming.frameOverhead = mcb::kConfigFrameBytes;
    }

    Identity &identity = m_board.identity;
    identity.protocol = "MCB over SPI";
    identity.firmware = "product 0x" + hexDigits(std::uint64_t(numberAt(mcbreg::kProduct)), 8)
        + ", revision 0x" + hexDigits(std::uint64_t(numberAt(mcbreg::kRevision)), 8);
    identity.version = textAt(mcbreg::kVersion);
    identity.controlBoard = "vendor 0x" + hexDigits(std::uint64_t(numberAt(mcbreg::kVendor)), 8)
        + ", serial number " + std::to_string(std::uint64_t(numberAt(mcbreg::kSerial)));
    identity.motorNames = {""};
    identity.powerBoards = {""};
    m_board.requestBytes = m_board.responseBytes = mcb::kConfigFrameBytes;
    m_board.streamBytes = mcb::kMostFrameBytes;
    addCapabilities(m_board);
    m_board.identified = true;
}

} // namespace drive
