// What the link tells an MCP drive: connected, lost, an answer, none, samples.
#include "drive/mcp/mcp_machine.h"
#include "mcp/protocol.h"

namespace drive {

namespace {

LinkReason reasonOf(Link::LostReason reason)
{
    switch (reason) {
    case Link::LostReason::NoAnswer:
        return LinkReason::NoAnswer;
    case Link::LostReason::OnlyGarbage:
        return LinkReason::OnlyGarbage;
    case Link::LostReason::OldProtocol:
        return LinkReason::OldProtocol;
    case Link::LostReason::NoAgreement:
        return LinkReason::NoAgreement;
    case Link::LostReason::Silence:
        return LinkReason::Silence;
    case Link::LostReason::RecoveryFailed:
        break;
    }
    return LinkReason::RecoveryFailed;
}

} // namespace

void McpDrive::onLinkEvents(TimePoint now)
{
    for (const Link::Event &event : m_link.takeEvents())
        std::visit([&](const auto &what) { on(what, now); }, event);
}

void McpDrive::on(const Link::Connected &event, TimePoint now)
{
    m_lost.reset();
    m_reconnectAt.reset();
    m_suspect = false;
    m_resetSeen = event.afterReset;
    if (event.afterReset)
        disarm();
    m_board.requestBytes = event.agreed.rxMax();
    m_board.responseBytes = event.agreed.txSyncMax();
    m_board.streamBytes = event.agreed.txAsyncMax();
    m_board.linkId = m_link.linkId();
    m_identification.restart();
    m_vitals.restart(now);
    m_heartbeat.restart(now);
    m_watch.restart(now);
    m_stream.connected();
    tell(LinkState::Connected, event.afterReset ? LinkReason::BoardReset : LinkReason::None);
}

void McpDrive::on(const Link::Lost &event, TimePoint now)
{
    if (!m_lost || event.reason != Link::LostReason::NoAnswer)
        m_lost = reasonOf(event.reason); // "no answer" while trying again is no news
    setArmed(false);
    cutAllWishes("link lost");
    m_task = nullptr;
    m_stopUnderWay = false;
    m_suspect = false;
    m_reconnectAt = now + m_config.reconnectEvery;
}

void McpDrive::on(const Link::Recovered &, TimePoint)
{
    m_suspect = false;
    m_stream.connected();
}

void McpDrive::on(const Link::Response &event, TimePoint now)
{
    if (m_task != nullptr) {
        takeAnswer(event.payload, now);
        afterTask(now);
    } else if (m_stopUnderWay) {
        m_stopUnderWay = false;
        const Bytes ok{static_cast<std::uint8_t>(mcp::Status::Ok)};
        if (event.payload == ok)
            m_stop.stopAnswered(m_stopMotor, now);
        m_vitals.hurry(now);
    }
}

void McpDrive::on(const Link::NoResponse &event, TimePoint now)
{
    if (m_task != nullptr) {
        m_task->takeNoResponse(event.executed, now);
        afterTask(now);
    } else {
        m_stopUnderWay = false;
    }
}

void McpDrive::tellIdentity()
{
    Identified event{m_identification.identity(), m_board.catalog, m_board.limits,
        m_board.streaming, m_board.capabilities, m_board.requestBytes, m_board.responseBytes,
        m_board.streamBytes, stateSteps()};
    event.identity.watchdog = m_board.watchdog;
    m_events.emplace_back(std::move(event));
}

void McpDrive::onIdentified(TimePoint now)
{
    m_stream.restart(m_resetSeen);
    tellIdentity();
    m_vitals.hurry(now); // now the speed can be read too
    if (m_stream.wanted() && m_mode == Mode::Open)
        m_wishes.addFirst(std::make_unique<StreamTask>(0, m_stream.wish(), m_stream));
}

} // namespace drive
