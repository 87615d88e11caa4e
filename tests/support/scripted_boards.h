// Boards of MCP and the older protocol reduced to what a stop needs: answers at once, motors that only drive or do not.
// What fares badly on the line is chosen by the caller. No motor model runs behind them, so that thousands of runs are
// cheap.
#pragma once

#include "aspep/packet.h"
#include "catalog/catalog.h"
#include "drive/mcp/requests.h"
#include "drive/protocol_table.h"
#include "fcp/framer.h"
#include "fcp/reply.h"
#include "mcp/protocol.h"
#include "mcp/request.h"
#include "simulation/fcp/server.h"
#include "simulation/simulated_board.h"
#include "support/start_notice.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace support {

/// What a request is to the model.
struct Asked {
    enum class What : std::uint8_t {
        Link,
        Read,
        Stop,
        Start,
        Other,
        Fetch, ///< nothing of its own: the answer of what came before, where the bus needs that
    } what = What::Other;
    int motor = 0;
};

class ScriptedBoard {
public:
    ScriptedBoard() = default;
    ScriptedBoard(const ScriptedBoard &) = delete;
    ScriptedBoard &operator=(const ScriptedBoard &) = delete;
    virtual ~ScriptedBoard() = default;

    std::array<bool, 2> drives{}; ///< the motors
    bool obeys = true; ///< a STOP

    virtual std::unique_ptr<drive::Drive> makeDrive() const = 0;
    /// Takes an output of the drive; true once a request is whole.
    virtual bool accept(const Bytes &output) = 0;
    virtual Asked asked() const = 0; ///< the request that is whole
    virtual Bytes answer() = 0; ///< carries it out; empty: the board is silent
    virtual int motors() const { return 2; }
    /// @param fate  of the request that is whole, as the models name it
    /// @return what becomes of the bytes that come back at once
    virtual char fares(char fate) { return fate; }
    virtual bool beginsStartsWithStop() const { return false; }
    /// A motor of it is moved only with the user's word that its limits are not told.
    virtual bool needsExpert() const = 0;
    /// Later than the drive waits for an answer.
    virtual Duration late() const = 0;
    /// @return  what it sends by itself
    virtual Bytes reset() = 0;
};

/// MCP over ASPEP with two motors: what it tells of itself is the simulated board's.
class ScriptedMcpBoard final : public ScriptedBoard {
public:
    ScriptedMcpBoard()
    {
        simulation::BoardOptions options;
        options.motors = 2;
        m_model = simulation::makeBoard(options);
        ask(aspepHeader(aspep::Beacon{0, false, 7, 7, 32}));
        ask(aspepHeader(aspep::Ping{false, false, 0, 1}));
    }

    std::unique_ptr<drive::Drive> makeDrive() const override { return drive::makeMcpDrive({}); }
    bool needsExpert() const override { return false; }
    Duration late() const override { return std::chrono::milliseconds(60); }
    bool accept(const Bytes &output) override
    {
        if (m_payloadNext) {
            m_payloadNext = false;
            m_payload = output;
            return true;
        }
        const auto header = aspep::decodeHeader({output[0], output[1], output[2], output[3]});
        m_header = header.value_or(aspep::Nack{});
        m_payload.clear();
        m_payloadNext = std::holds_alternative<aspep::Data>(m_header);
        return !m_payloadNext;
    }
    Asked asked() const override
    {
        if (m_payload.empty())
            return {Asked::What::Link, 0};
        const auto request = mcp::decodeRequest(m_payload);
        switch (static_cast<mcp::CommandId>(request->command)) {
        case mcp::CommandId::GetRegister:
            return {Asked::What::Read, 0};
        case mcp::CommandId::StartMotor:
            return {Asked::What::Start, request->motor};
        case mcp::CommandId::StopMotor:
            return {Asked::What::Stop, request->motor};
        default:
            return {Asked::What::Other, request->motor};
        }
    }
    Bytes answer() override
    {
        if (const auto *beacon = std::get_if<aspep::Beacon>(&m_header)) {
            m_connected = false;
            m_configured = true;
            aspep::Beacon mine{0, false, 7, 7, 32};
            return aspepHeader(mine.txAsyncUnits < beacon->txAsyncUnits ? mine : *beacon);
        }
        if (const auto *ping = std::get_if<aspep::Ping>(&m_header)) {
            m_connected = m_configured;
            return aspepHeader(aspep::Ping{m_configured, m_parity, 0, ping->number});
        }
        if (!m_connected || m_payload.empty())
            return {};
        m_parity = !m_parity;
        const Bytes response = execute();
        Bytes packet = aspepHeader(aspep::Data{true, static_cast<std::uint16_t>(response.size())});
        packet.insert(packet.end(), response.begin(), response.end());
        return packet;
    }
    Bytes reset() override
    {
        drives = {};
        m_connected = m_configured = m_parity = false;
        return {};
    }

private:
    static Bytes aspepHeader(const aspep::Header &what)
    {
        const auto bytes = aspep::encodeHeader(what);
        return {bytes.begin(), bytes.end()};
    }
    Bytes execute()
    {
        const Asked what = asked();
        const Bytes ok{static_cast<std::uint8_t>(mcp::Status::Ok)};
        const auto motor = static_cast<std::size_t>(what.motor - 1);
        if (what.what == Asked::What::Start || what.what == Asked::What::Stop) {
            if (what.what == Asked::What::Start)
                drives.at(motor) = true;
            else if (obeys)
                drives.at(motor) = false;
            return ok;
        }
        return what.what == Asked::What::Read && isState() ? state() : told();
    }
    std::vector<mcp::RegisterId> ids() const
    {
        return mcp::decodeGetList(ByteView(m_payload).subspan(2))
            .value_or(std::vector<mcp::RegisterId>());
    }
    bool isState() const
    {
        const auto list = ids();
        return std::any_of(list.begin(), list.end(),
            [](mcp::RegisterId id) { return id.withMotor(0) == mcp::reg::kStatus; });
    }
    Bytes state() const
    {
        ByteWriter values;
        for (const mcp::RegisterId id : ids()) {
            const bool isDriven = drives.at(static_cast<std::size_t>(id.motor() - 1));
            if (id.withMotor(0) == mcp::reg::kStatus)
                values.u8(isDriven ? 6 : 0);
            else if (drive::wireWidth(id.bits) == 4)
                values.u32(id.withMotor(0) == mcp::reg::kFaultsFlags || !isDriven ? 0 : 1500);
            else
                values.u16(0);
        }
        return values.u8(static_cast<std::uint8_t>(mcp::Status::Ok)).take();
    }
    /// The same each time, so it is asked for once.
    Bytes told()
    {
        const auto known = m_told.find(m_payload);
        if (known != m_told.end())
            return known->second;
        Bytes request =
            aspepHeader(aspep::Data{false, static_cast<std::uint16_t>(m_payload.size())});
        const Bytes whole = ask(request, m_payload);
        return m_told[m_payload] =
                   whole.size() > 4 ? Bytes(whole.begin() + 4, whole.end()) : Bytes();
    }
    Bytes ask(const Bytes &header, const Bytes &payload = {})
    {
        using namespace std::chrono_literals;
        Bytes heard;
        m_model->receive(header, m_at);
        for (int i = 0; i < 40; ++i) {
            m_at += 500us;
            if (i == 4 && !payload.empty())
                m_model->receive(payload, m_at);
            m_model->advance(m_at);
            const Bytes more = m_model->takeOutput();
            heard.insert(heard.end(), more.begin(), more.end());
        }
        return heard;
    }

    std::unique_ptr<simulation::SimulatedBoard> m_model;
    TimePoint m_at{};
    std::map<Bytes, Bytes> m_told;
    aspep::Header m_header = aspep::Nack{};
    Bytes m_payload;
    bool m_payloadNext = false, m_configured = false, m_connected = false, m_parity = false;
};

/// The older protocol with two motors.
class ScriptedFcpBoard final : public ScriptedBoard, private simulation::FcpMachine {
public:
    ScriptedFcpBoard() { powerOn(); }

    std::unique_ptr<drive::Drive> makeDrive() const override
    {
        return drive::makeFcpDrive({.baud = 115200});
    }
    bool needsExpert() const override { return true; }
    Duration late() const override { return std::chrono::milliseconds(1030); }
    bool accept(const Bytes &output) override
    {
        fcp::Framer framer(fcp::Framer::Side::Board);
        ByteView bytes(output);
        m_whole = framer.next(bytes, m_frame) == fcp::Framer::Step::Frame;
        return m_whole || output.size() == 1; // 0xFF alone fills up what hangs
    }
    Asked asked() const override
    {
        if (!m_whole)
            return {Asked::What::Link, 0};
        const int motor = m_frame.header >> 5;
        switch (static_cast<fcp::FrameCode>(m_frame.header & 0x1FU)) {
        case fcp::FrameCode::GetBoardInfo:
            return {Asked::What::Link, motor};
        case fcp::FrameCode::Execute: {
            const auto command = static_cast<fcp::CommandId>(m_frame.payload.at(0));
            return {command == fcp::CommandId::StopMotor    ? Asked::What::Stop
                    : command == fcp::CommandId::StartMotor ? Asked::What::Start
                                                            : Asked::What::Other,
                motor};
        }
        case fcp::FrameCode::GetRegister:
        case fcp::FrameCode::GetRevUp:
        case fcp::FrameCode::GetFirmwareVersion:
            return {Asked::What::Read, motor};
        default:
            return {Asked::What::Other, motor};
        }
    }
    Bytes answer() override { return m_whole ? m_server->answer(m_frame) : Bytes(); }
    Bytes reset() override
    {
        drives = {};
        powerOn();
        return startNotice({1, "5.4.3", 1, 1, 1});
    }

private:
    void powerOn()
    {
        simulation::FcpMachine *machine = this;
        m_server.emplace(rig(), machine);
    }
    static simulation::FcpRig rig()
    {
        simulation::FcpRig rig;
        rig.name = "two motors";
        rig.motors.resize(2);
        return rig;
    }
    void refresh(std::size_t motor, simulation::FcpMotor &registers) override
    {
        registers.state = drives.at(motor) ? 6 : 0;
    }
    void written(std::size_t, std::uint8_t, std::int64_t) override { }
    void execute(std::size_t motor, fcp::CommandId command) override
    {
        if (command == fcp::CommandId::StartMotor)
            drives.at(motor) = true;
        else if (command == fcp::CommandId::StopMotor && obeys)
            drives.at(motor) = false;
    }
    void setControlMode(std::size_t, bool) override { }
    void rampSpeed(std::size_t, std::int32_t, std::uint16_t) override { }
    void rampTorque(std::size_t, std::int16_t, std::uint16_t) override { }
    void setCurrents(std::size_t, std::int16_t, std::int16_t) override { }
    void setRevUp(std::size_t, std::size_t, const fcp::StageFields &) override { }

    std::optional<simulation::FcpServer> m_server;
    fcp::Frame m_frame;
    bool m_whole = false;
};

} // namespace support
