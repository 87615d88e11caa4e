#include "drive/mcp/heartbeat.h"

#include "base/text.h"
#include "mcp/protocol.h"

namespace drive {

namespace {

constexpr std::string_view kMark = " RSWD";
constexpr long kShortest_ms = 100, kLongest_ms = 60'000;
constexpr auto kCommand =
    static_cast<mcp::CommandId>(static_cast<unsigned>(mcp::CommandId::UserFirst) + 1);
constexpr int kMotor = 1; // firmware ignores it

} // namespace

std::optional<std::chrono::milliseconds> watchdogIn(std::string_view firmwareName)
{
    const std::size_t at = firmwareName.rfind(kMark);
    if (at == std::string_view::npos)
        return std::nullopt;
    const std::string_view digits = firmwareName.substr(at + kMark.size());
    if (digits.empty() || digits.front() < '1' || digits.front() > '9')
        return std::nullopt;
    const auto time_ms = numberIn<long>(digits);
    if (!time_ms || *time_ms < kShortest_ms || *time_ms > kLongest_ms)
        return std::nullopt;
    return std::chrono::milliseconds(*time_ms);
}

std::optional<TimePoint> McpHeartbeat::due() const
{
    const bool asked = m_wanted && m_board.identified && m_board.identity.watchdog;
    return asked && !givenUp() ? std::optional<TimePoint>(m_due) : std::nullopt;
}

std::optional<McpRequest> McpHeartbeat::nextRequest(TimePoint now)
{
    const auto at = due();
    if (!at || now < *at)
        return std::nullopt;
    m_due = now + *m_board.identity.watchdog / 3;
    return McpAct{kCommand, kMotor,
        ByteWriter().u16(static_cast<std::uint32_t>(m_board.identity.watchdog->count())).take()};
}

void McpHeartbeat::onResponse(const McpAnswer &answer, TimePoint)
{
    m_refused = answer && answer->ok() && answer->data.empty() ? 0 : m_refused + 1;
}

} // namespace drive
