#include "session/transports/simulator_transport.h"

namespace session {

namespace {
/// A computer that slept did not simulate: longer pauses than this are cut out of the board's time.
constexpr Duration kLongestStep = std::chrono::seconds(1);
} // namespace

SimulatorTransport::SimulatorTransport(MakeBoard makeBoard)
    : m_makeBoard(std::move(makeBoard))
{
}

PortError SimulatorTransport::open(TimePoint now)
{
    m_board = m_makeBoard();
    if (!m_board)
        return {PortProblem::NotFound, {}};
    m_start = now;
    m_last = now;
    return {};
}

void SimulatorTransport::write(ByteView bytes, TimePoint now)
{
    if (m_board)
        m_board->receive(bytes, boardTime(now));
}

void SimulatorTransport::advance(TimePoint now)
{
    if (!m_board)
        return;
    if (now - m_last > kLongestStep)
        m_start += now - m_last - kLongestStep;
    m_last = now;
    m_board->advance(boardTime(now));
    const Bytes out = m_board->takeOutput();
    if (!out.empty())
        Q_EMIT received(QByteArray(
            reinterpret_cast<const char *>(out.data()), static_cast<qsizetype>(out.size())));
}

std::optional<TimePoint> SimulatorTransport::nextWake() const
{
    if (!m_board)
        return std::nullopt;
    return m_start + (m_board->nextWake() - TimePoint{});
}

} // namespace session
