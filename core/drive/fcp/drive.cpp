// Drive for boards of the older serial protocol, in both its dialects. It joins the link (fcp::Client) with the pieces
// of work that want something of the board (Task) and gives the link to the most urgent one whenever it is free:
//
//   the stop of every motor > identification > state poll > wishes that act > wishes that read > watched registers
//
// After every connection the board is identified with reads alone; only then anything else. Every frame names its
// motor. Boards of this protocol send nothing by themselves: what is drawn is read over and over, as often as the line
// gives.
#include "drive/drawn_watch.h"
#include "drive/fcp/commands.h"
#include "drive/fcp/identification.h"
#include "drive/fcp/vitals.h"
#include "drive/protocol_table.h"
#include "drive/task_drive.h"
#include "fcp/client.h"

namespace drive {

namespace {

/// The motion log has only what can change something.
bool changes(const fcp::Request &request)
{
    return !std::holds_alternative<fcp::GetRegister>(request.command)
        && !std::holds_alternative<fcp::GetRevUp>(request.command);
}

fcp::Request stopOf(int motor)
{
    return fcpRequest(motor, fcp::Execute{static_cast<std::uint8_t>(fcp::CommandId::StopMotor)});
}

class FcpDrive final : public TaskDrive<FcpProtocol> {
public:
    FcpDrive(const LineOptions &line, std::optional<fcp::Dialect> dialect)
        : TaskDrive({line.baud, line.patience}, dialect)
    {
        constexpr double kBitsPerByte = 10.0;
        m_board.bytesPerSecond = line.baud / kBitsPerByte;
    }

    std::vector<Output> stopScript() const override;

private:
    Made taskFor(const Wish &wish) override;
    std::string acceptScale(const CurrentScale &scale) override;

    // what the link tells
    void onLinkEvents(TimePoint now) override
    {
        for (const Link::Event &event : m_link.takeEvents())
            std::visit([&](const auto &what) { on(what, now); }, event);
    }
    void on(const Link::Connected &event, TimePoint now);
    void on(const Link::Answer &event, TimePoint now)
    {
        m_suspect = false;
        passAnswer(event.reply, now);
    }
    void on(const Link::NoAnswer &event, TimePoint now)
    {
        if (m_task != nullptr)
            passLoss(event.executed, now);
    }
    void on(const Link::Restarted &event, TimePoint now);
    void on(const Link::Suspect &, TimePoint) { m_suspect = true; }
    void on(const Link::Lost &event, TimePoint now);
    void onIdentified(TimePoint now) override;
    bool connected() const override { return m_link.connected(); }
    bool recovering() const override
    {
        return connected() && m_link.state() == Link::State::Recovering;
    }
    LinkCounters counters() const override;

    // what goes out
    void prepare(TimePoint) override
    {
        m_link.setDialect(m_board.dialect);
        m_link.setMotorDriven(m_vitals.motorDriven());
    }
    bool send(const fcp::Request &request, WishTask<FcpProtocol> *wish, TimePoint now) override;
    void sendStop(int motor, TimePoint now) override;
    TimePoint stopMayLeave() const override;
    void closeLink() override { m_link.close(); }

    std::optional<LinkReason> m_anew; ///< why the board is to be met again
};

FcpDrive::Made FcpDrive::taskFor(const Wish &wish)
{
    if (const auto setPoint = setPointOf(wish.what))
        return std::make_unique<FcpActTask>(wish.id, *setPoint, m_board);
    if (const auto *command = std::get_if<Command>(&wish.what))
        return std::make_unique<FcpActTask>(wish.id, *command, m_board);
    return nullptr;
}

void FcpDrive::on(const Link::Connected &event, TimePoint now)
{
    linkFound();
    if (event.again && m_board.identified && !m_anew)
        return; // a recovery: the same board, in step again
    meet(std::exchange(m_anew, std::nullopt).value_or(LinkReason::None), now, event.board);
}

/// Whatever was known of it is void, and this board is not armed.
void FcpDrive::on(const Link::Restarted &, TimePoint now)
{
    m_anew = LinkReason::BoardReset;
    setArmed(false);
    forgetLink("the board was reset");
    m_link.connect(now);
}

void FcpDrive::on(const Link::Lost &event, TimePoint now)
{
    m_anew = m_anew.value_or(LinkReason::None);
    linkLost(event.otherProtocol ? LinkReason::OtherProtocol
            : !event.connecting  ? LinkReason::RecoveryFailed
            : event.heardBytes   ? LinkReason::OnlyGarbage
                                 : LinkReason::NoAnswer,
        now);
}

/// The board is told anew, so that no units of before are used on; it is asked nothing.
std::string FcpDrive::acceptScale(const CurrentScale &scale)
{
    if (auto why = m_board.reasonAgainst(Feature::CurrentScale); !why.empty())
        return why;
    const double perDigit = scale.fullScaleAmps / kFullScaleDigits;
    if (perDigit == m_board.ampsPerDigit(scale.motor))
        return {};
    disarm();
    m_board.scales[static_cast<std::size_t>(scale.motor - 1)].ampsPerDigit = perDigit;
    m_board.catalog = std::make_shared<const catalog::Catalog>(
        m_board.catalog->registers(), m_board.motors, m_board.scales, m_board.catalog->start());
    m_identification.addCapabilities();
    tellIdentified();
    return {};
}

void FcpDrive::onIdentified(TimePoint now)
{
    if (auto readings = m_identification.takeReadings(); !readings.empty())
        m_events.emplace_back(RegistersRead{std::move(readings)});
    m_watch.restart(now);
}

/// The same in both dialects. Fillers end a frame that firmware may still wait for: see fcp/client.h.
std::vector<Output> FcpDrive::stopScript() const
{
    constexpr Duration kAnswerTime = std::chrono::milliseconds(10); // a frame before it is dropped
    constexpr int kFillers = 8;
    std::vector<Output> script;
    for (int motor = 1; motor <= motorsToStop(); ++motor)
        script.push_back({fcp::encodeRequest(stopOf(motor)).value_or(Bytes()), kAnswerTime});
    for (int i = 0; i < kFillers; ++i)
        script.push_back({Bytes{0xFF}, i == 0 ? kAnswerTime : Link::kFillPause});
    return script;
}

/// A board that answers drops what comes meanwhile: blind STOPs of several motors, too, leave it time. They come close
/// together, so that the line has its rest behind them.
TimePoint FcpDrive::stopMayLeave() const
{
    constexpr Duration kBetweenBlind = std::chrono::milliseconds(20);
    if (m_stopUnderWay)
        return m_stopSince + StopSequence::kRepeat;
    return m_link.canSend() ? TimePoint{} : m_stopSince + kBetweenBlind;
}

void FcpDrive::sendStop(int motor, TimePoint now)
{
    const bool clean = m_link.canSend() || m_link.state() == Link::State::Waiting;
    m_stopMotor = motor;
    m_stopSince = now;
    const fcp::Request request = stopOf(motor);
    noteStop(motor, fcp::encodeRequest(request).value_or(Bytes()), now);
    m_stopUnderWay = clean;
    m_link.sendUrgent(request, now);
    onLinkEvents(now);
}

bool FcpDrive::send(const fcp::Request &request, WishTask<FcpProtocol> *wish, TimePoint now)
{
    const auto frame = fcp::encodeRequest(request);
    if (!frame)
        return false;
    if (wish != nullptr && wish->motion() && changes(request))
        noteSent(*wish->motion(), *frame);
    m_link.send(request, now);
    return true;
}

LinkCounters FcpDrive::counters() const
{
    const Link::Stats &link = m_link.stats();
    return {.bytesIn = link.bytesIn,
        .bytesOut = link.bytesOut,
        .packetsIn = link.framesIn,
        .packetsOut = link.framesOut,
        .badPackets = link.bad,
        .nacks = link.nacks,
        .timeouts = link.timeouts,
        .recoveries = link.recoveries};
}

} // namespace

std::unique_ptr<Drive> makeFcpDrive(const LineOptions &line, std::optional<fcp::Dialect> dialect)
{
    return std::make_unique<FcpDrive>(line, dialect);
}

} // namespace drive
