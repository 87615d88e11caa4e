// A board of MCP over ASPEP without a motor model: every state but the motors' own is what the simulated board says.
// Its answers are asked for once a process and kept, so that a connection costs microseconds.
#pragma once

#include "fuzz/drive_script.h"
#include "mcp/datalog.h"
#include "mcp/request.h"
#include "mcp/structures.h"
#include "support/board_bench.h"

#include <unordered_map>

namespace fuzz {

class McpPeer final : public Peer {
public:
    explicit McpPeer(int motors)
        : m_motors(static_cast<std::size_t>(motors))
    {
    }

    void receive(ByteView bytes, TimePoint now) override
    {
        m_in.insert(m_in.end(), bytes.begin(), bytes.end());
        while (takePacket(now)) { }
    }
    void advance(TimePoint now) override
    {
        while (!m_coming.empty() && m_coming.front().at <= now) {
            const Bytes &bytes = m_coming.front().bytes;
            m_out.insert(m_out.end(), bytes.begin(), bytes.end());
            m_coming.pop_front();
        }
        if (m_nextSamples <= now)
            sendSamples(now);
    }
    Bytes takeOutput() override { return std::exchange(m_out, {}); }
    TimePoint nextWake() const override
    {
        return m_coming.empty() ? m_nextSamples : std::min(m_nextSamples, m_coming.front().at);
    }
    void reset() override
    {
        m_motors.assign(m_motors.size(), {});
        m_in.clear();
        m_coming.clear();
        m_configured = m_connected = false;
        m_requests = 0;
        m_nextSamples = TimePoint::max();
        m_timestamp = 0;
    }
    void setFaults(std::uint16_t present) override
    {
        for (Motor &motor : m_motors) {
            motor.faults = std::uint32_t{present} << 16 | motor.faults | present;
            if (present != 0)
                motor.state = kFaultNow;
            else if (motor.state == kFaultNow)
                motor.state = kFaultOver;
            motor.faults &= present == 0 ? 0xFFFFU : 0xFFFFFFFFU;
        }
    }
    std::vector<judge::Motor> truth() const override
    {
        std::vector<judge::Motor> all;
        for (const Motor &motor : m_motors) {
            const bool driven = motor.state == kStart || motor.state == kRun;
            all.push_back({driven, !driven, motor.state == kRun ? kTurning_rpm : 0.0});
        }
        return all;
    }

private:
    // STATUS
    static constexpr std::uint8_t kIdle = 0, kStart = 4, kRun = 6, kStop = 8, kFaultNow = 10,
                                  kFaultOver = 11;
    static constexpr std::int32_t kTurning_rpm = 1000;
    static constexpr Duration kAnswersAfter = 1ms;
    static constexpr std::size_t kMostComing = 16;
    static constexpr double kTickHz = 16000.0;

    struct Motor {
        std::uint8_t state = kIdle;
        std::uint32_t faults = 0; ///< present << 16 | not acknowledged
        std::map<std::uint16_t, Bytes> written;
    };
    struct Coming {
        TimePoint at;
        Bytes bytes;
    };

    void say(const aspep::Header &header, ByteView payload, TimePoint now)
    {
        if (m_coming.size() >= kMostComing)
            return;
        const auto head = aspep::encodeHeader(header);
        Bytes bytes(head.begin(), head.end());
        bytes.insert(bytes.end(), payload.begin(), payload.end());
        const TimePoint at = now + kAnswersAfter;
        m_coming.push_back({m_coming.empty() ? at : std::max(at, m_coming.back().at), bytes});
    }
    bool takePacket(TimePoint now)
    {
        if (m_in.size() < aspep::kHeaderSize)
            return false;
        const auto header = aspep::decodeHeader({m_in[0], m_in[1], m_in[2], m_in[3]});
        std::size_t used = aspep::kHeaderSize;
        if (!header) {
            constexpr std::uint8_t kBadHeaderCrc = 4;
            say(aspep::Nack{kBadHeaderCrc}, {}, now);
            used = m_in.size(); // deaf for one burst
        } else if (const auto *beacon = std::get_if<aspep::Beacon>(&*header)) {
            m_connected = false;
            m_configured = *beacon == kOwn;
            say(kOwn, {}, now);
        } else if (const auto *ping = std::get_if<aspep::Ping>(&*header)) {
            aspep::Ping reply = *ping;
            reply.configured = m_configured;
            reply.parity = m_requests % 2 != 0;
            m_connected = m_configured;
            say(reply, {}, now);
        } else if (const auto *data = std::get_if<aspep::Data>(&*header)) {
            used += data->length;
            if (m_in.size() < used)
                return false;
            const Bytes request(m_in.begin() + 4, m_in.begin() + static_cast<std::ptrdiff_t>(used));
            if (m_connected && !request.empty()) {
                ++m_requests;
                const Bytes answer = execute(request, now);
                say(aspep::Data{true, static_cast<std::uint16_t>(answer.size())}, answer, now);
            }
        }
        m_in.erase(m_in.begin(), m_in.begin() + static_cast<std::ptrdiff_t>(used));
        return true;
    }

    Bytes execute(const Bytes &payload, TimePoint now)
    {
        const auto request = mcp::decodeRequest(payload);
        if (!request)
            return {status(mcp::Status::Nok)};
        switch (static_cast<mcp::CommandId>(request->command)) {
        case mcp::CommandId::GetMcpVersion:
            return {1, 0, 0, 0, 0};
        case mcp::CommandId::GetRegister:
            return get(request->content);
        case mcp::CommandId::SetRegister:
            return set(request->content, now);
        default:
            break;
        }
        if (request->motor == 0 || request->motor > m_motors.size())
            return {status(mcp::Status::Nok)};
        return {status(command(request->command, m_motors[request->motor - 1U]))};
    }
    static std::uint8_t status(mcp::Status which) { return static_cast<std::uint8_t>(which); }

    static mcp::Status command(std::uint16_t command, Motor &motor)
    {
        switch (static_cast<mcp::CommandId>(command)) {
        case mcp::CommandId::StartMotor:
            if (motor.state != kIdle || motor.faults != 0)
                return mcp::Status::Nok;
            motor.state = kStart;
            return mcp::Status::Ok;
        case mcp::CommandId::StopMotor:
            if (motor.state == kStart || motor.state == kRun)
                motor.state = kStop;
            return mcp::Status::Ok;
        case mcp::CommandId::FaultAck:
            if (motor.state == kFaultOver) {
                motor.state = kIdle;
                motor.faults = 0;
            }
            return mcp::Status::Ok;
        case mcp::CommandId::StopRamp:
            return mcp::Status::Ok;
        default:
            return mcp::Status::CommandUnknown;
        }
    }

    Motor *motorOf(mcp::RegisterId id)
    {
        const unsigned number = std::max<unsigned>(id.motor(), 1);
        return number <= m_motors.size() ? &m_motors[number - 1] : nullptr;
    }
    Bytes get(ByteView content)
    {
        const auto ids = mcp::decodeGetList(content);
        if (!ids)
            return {status(mcp::Status::Nok)};
        Bytes answer;
        for (const mcp::RegisterId id : *ids) {
            Bytes value = read(id);
            answer.insert(answer.end(), value.begin(), value.end() - 1);
            if (value.back() != status(mcp::Status::Ok) || answer.size() > kOwn.txSyncMax() - 1) {
                answer.push_back(std::max<std::uint8_t>(value.back(), 1));
                return answer;
            }
        }
        answer.push_back(status(mcp::Status::Ok));
        return answer;
    }
    /// Its value and behind it the status.
    Bytes read(mcp::RegisterId id)
    {
        Motor *motor = motorOf(id);
        if (motor == nullptr)
            return {status(mcp::Status::Nok)};
        const mcp::RegisterId bare = id.withMotor(0);
        if (bare == mcp::reg::kStatus) {
            const std::uint8_t state = motor->state; // and what comes next
            if (state == kStart)
                motor->state = kRun;
            else if (state == kStop)
                motor->state = kIdle;
            return {state, 0};
        }
        if (bare == mcp::reg::kFaultsFlags)
            return ByteWriter().u32(motor->faults).u8(0).take();
        if (bare == mcp::reg::kSpeedMeas)
            return ByteWriter().s32(motor->state == kRun ? kTurning_rpm : 0).u8(0).take();
        const auto written = motor->written.find(id.bits);
        return written != motor->written.end() ? written->second : asTheBoardSays(id);
    }
    Bytes asTheBoardSays(mcp::RegisterId id) const
    {
        static std::array<std::unordered_map<std::uint16_t, Bytes>, 2> known;
        auto &answers = known[m_motors.size() - 1];
        const auto at = answers.find(id.bits);
        if (at != answers.end())
            return at->second;
        static std::array<std::unique_ptr<support::BoardBench>, 2> boards;
        auto &bench = boards[m_motors.size() - 1];
        if (!bench) {
            simulation::BoardOptions options;
            options.hfHz = 1000.0;
            options.motors = static_cast<int>(m_motors.size());
            bench = std::make_unique<support::BoardBench>(options);
            bench->connect();
        }
        Bytes answer = bench->ask(ByteWriter().u16(2U << 3U).u16(id.bits).take());
        if (answer.empty())
            answer = {status(mcp::Status::Nok)};
        return answers.emplace(id.bits, std::move(answer)).first->second;
    }
    Bytes set(ByteView content, TimePoint now)
    {
        const mcp::SetList list = mcp::decodeSetList(content);
        if (list.error || list.writes.empty())
            return {status(mcp::Status::Nok)};
        for (const mcp::RegisterValue &write : list.writes) {
            Motor *motor = motorOf(write.id);
            ByteWriter value;
            if (motor == nullptr || !mcp::encodeValue(write.id, write.value, value))
                return {status(mcp::Status::Nok)};
            if (write.id.withMotor(0) == mcp::datalogRegister(0).withMotor(0))
                configure(std::get<Bytes>(write.value), now);
            else
                motor->written[write.id.bits] = value.u8(0).take();
        }
        return {status(mcp::Status::Ok)};
    }

    void configure(const Bytes &raw, TimePoint now)
    {
        m_nextSamples = TimePoint::max();
        const auto config = mcp::decodeDatalog(raw);
        if (!config || config->stops())
            return;
        const mcp::DatalogLayout layout(*config);
        if (!layout.fullLength() || layout.fullBlocks() == 0)
            return;
        m_mark = config->mark;
        m_length = *layout.fullLength();
        m_ticks = static_cast<std::uint32_t>(layout.fullBlocks() * layout.step());
        m_nextSamples = now + fromSeconds(m_ticks / kTickHz);
    }
    void sendSamples(TimePoint now)
    {
        Bytes payload(m_length);
        for (std::size_t i = 0; i < 4; ++i)
            payload[i] = static_cast<std::uint8_t>(m_timestamp >> (8 * i));
        payload[m_length - 2] = m_mark;
        m_timestamp += m_ticks;
        if (m_connected)
            say(aspep::Data{false, static_cast<std::uint16_t>(payload.size())}, payload, now);
        m_nextSamples = now + std::max<Duration>(fromSeconds(m_ticks / kTickHz), 2ms);
    }

    static constexpr aspep::Beacon kOwn{
        .version = 0, .dataCrc = false, .rxUnits = 7, .txSyncUnits = 7, .txAsyncUnits = 8};

    std::vector<Motor> m_motors;
    Bytes m_in, m_out;
    std::deque<Coming> m_coming;
    bool m_configured = false, m_connected = false;
    unsigned m_requests = 0;
    TimePoint m_nextSamples = TimePoint::max();
    std::uint8_t m_mark = 0;
    std::size_t m_length = 0;
    std::uint32_t m_ticks = 0, m_timestamp = 0;
};

} // namespace fuzz
