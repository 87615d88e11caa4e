#include "widgets/scope/signals/plan.h"

#include "widgets/base/device_text.h"
#include "widgets/base/messages.h"
#include "widgets/base/value_text.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace widgets {
namespace {

using Kind = capture::ChannelInfo::Kind;

constexpr Milliseconds kAgainAfter{1000};
constexpr int kToldAfter = 2; ///< times in a row: one alone is a Stop, mostly
constexpr std::string_view kMainSpeed = "main-speed@"; ///< in names, before the motor's number

/// As far as boards tell themselves apart: two of one kind do not.
bool isSame(const drive::Identity &one, const drive::Identity &other)
{
    const auto told = [](const drive::Identity &board) {
        return std::tie(board.protocol, board.firmware, board.version, board.controlBoard,
            board.powerBoards, board.motorNames, board.motors);
    };
    return told(one) == told(other);
}

Kind kindOf(Route route)
{
    return route == Route::Fast ? Kind::Fast : route == Route::Slow ? Kind::Slow : Kind::Polled;
}

} // namespace

SignalPlan::SignalPlan(Device &device, capture::Capture &capture, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_capture(capture)
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(0); // several drops in one turn of the loop make one stream
    connect(&m_soon, &QTimer::timeout, this, &SignalPlan::replan);
    connect(&device, &Device::openWished, this, &SignalPlan::opened);
    const auto lost = [this] {
        if (!m_device.answering() && !m_fromFile)
            endPolled();
        if (!m_device.answering() && !doubted())
            m_streamStale = false; // a board that is met anew is planned for anew
    };
    connect(&device, &Device::linkStateChanged, this, lost);
    connect(&device, &Device::portStateChanged, this, lost);
    connect(&device, &Device::wishEnded, this, [this](const drive::Ended &ended) {
        if (ended.id == 0 || ended.id != m_streamWish)
            return;
        m_streamWish = 0;
        const bool brokenOff =
            ended.outcome == drive::Outcome::NotSent || ended.outcome == drive::Outcome::Unknown;
        m_brokenOff = brokenOff ? m_brokenOff + 1 : 0;
        m_againAt.reset();
        m_streamed = m_streamed || brokenOff;
        const bool tells =
            brokenOff ? m_brokenOff == kToldAfter : ended.outcome != drive::Outcome::Ok;
        if (tells && m_device.answering())
            Q_EMIT failed(failureText(tr("Recording signals"), ended));
        if (m_streamStale)
            replanSoon();
    });
}

const WantedSignal *SignalPlan::find(catalog::RegisterId id) const
{
    const auto found =
        std::find_if(m_wanted.begin(), m_wanted.end(), [id](const auto &s) { return s.id == id; });
    return found == m_wanted.end() ? nullptr : &*found;
}

std::optional<capture::ChannelId> SignalPlan::channelOf(catalog::RegisterId id) const
{
    for (const PlannedSignal &planned : m_plan.signalList) {
        if (planned.id != id)
            continue;
        const auto channel = m_capture.find(id, kindOf(planned.route));
        // A drive whose samples are wider than a fast column records them as slow ones, however fast they come.
        return channel || planned.route != Route::Fast ? channel : m_capture.find(id, Kind::Slow);
    }
    return {};
}

std::vector<NamedSignal> SignalPlan::named() const
{
    if (!m_names.empty() || !m_catalog)
        return m_names;
    std::vector<NamedSignal> names;
    for (const WantedSignal &signal : m_wanted) {
        const std::string name = nameOf(signal.id);
        // That a board cannot stream its speed is no wish for the next one.
        const catalog::RegisterInfo *info = m_catalog->find(signal.id);
        const bool only = info && info->streaming == catalog::Streaming::Polled;
        const Route route = only && name.starts_with(kMainSpeed) ? Route::Fast : signal.route;
        names.push_back({name, route, signal.plot});
    }
    return names;
}

std::optional<catalog::RegisterId> SignalPlan::mainSpeed(int motor) const
{
    const auto at = static_cast<std::size_t>(motor - 1);
    const bool told = at < m_speeds.size() && !m_speeds[at].empty();
    const catalog::RegisterInfo *info = m_catalog->find(told ? m_speeds[at] : "SPEED_MEAS");
    if (info == nullptr || motor < 1 || motor > m_catalog->motors())
        return {};
    return m_catalog->withMotor(*info, motor);
}

/// The speed of the main sensor is no name of a register: the next board may have another sensor, and its firmware
/// sends zeros for those that it does not have.
std::string SignalPlan::nameOf(catalog::RegisterId id) const
{
    const int motor = std::max(1, m_catalog->motorOf(id));
    return mainSpeed(motor) == id ? std::string(kMainSpeed) + std::to_string(motor)
                                  : m_catalog->nameOf(id);
}

void SignalPlan::setNamed(std::vector<NamedSignal> names)
{
    m_names = std::move(names);
    if (!m_catalog || m_fromFile || m_names.empty())
        return;
    resolveNames();
    replan();
}

void SignalPlan::resolveNames()
{
    std::vector<WantedSignal> wanted;
    QStringList missing;
    for (const NamedSignal &signal : std::exchange(m_names, {})) {
        const bool main = signal.name.starts_with(kMainSpeed);
        const auto id = main ? mainSpeed(std::atoi(signal.name.c_str() + kMainSpeed.size()))
                             : m_catalog->resolve(signal.name);
        const bool polled = id && m_catalog->find(*id)->streaming == catalog::Streaming::Polled;
        if (id)
            wanted.push_back({*id, polled ? Route::Polled : signal.route, signal.plot});
        else
            missing.append(deviceText(signal.name));
    }
    if (!missing.isEmpty())
        Q_EMIT noticed(tr("This board does not have %1.", "names of signals")
                           .arg(missing.join(QStringLiteral(", "))));
    if (wanted.empty())
        return;
    for (const WantedSignal &signal : std::exchange(m_wanted, std::move(wanted)))
        if (!find(signal.id))
            m_capture.endPolled(signal.id);
}

void SignalPlan::addDefaults()
{
    if (!m_catalog)
        return;
    for (const char *name : {"I_A", "I_B", "I_Q_MEAS"})
        if (const catalog::RegisterInfo *info = m_catalog->find(std::string_view(name)))
            add(m_catalog->withMotor(*info, m_device.motor()), 0);
    if (const auto speed = mainSpeed(m_device.motor()))
        add(*speed, 1);
}

void SignalPlan::add(quint32 id, int plot)
{
    const auto catalog = m_device.catalog();
    const catalog::RegisterInfo *info = catalog ? catalog->find(id) : nullptr;
    const bool number =
        info && info->type != catalog::ValueType::Text && info->type != catalog::ValueType::Raw;
    if (!number || m_fromFile || find(id))
        return;
    const Route route = info->streaming == catalog::Streaming::Polled ? Route::Polled : Route::Fast;
    m_wanted.push_back({id, route, plot});
    replanSoon();
}

void SignalPlan::setPlot(quint32 id, int plot)
{
    for (WantedSignal &signal : m_wanted)
        if (signal.id == id)
            signal.plot = plot;
}

void SignalPlan::remove(quint32 id)
{
    if (std::erase_if(m_wanted, [id](const WantedSignal &signal) { return signal.id == id; }) == 0)
        return;
    m_capture.endPolled(id);
    replanSoon();
}

void SignalPlan::setRoute(quint32 id, Route route)
{
    for (WantedSignal &signal : m_wanted)
        if (signal.id == id)
            signal.route = route;
    replanSoon();
}

void SignalPlan::setFastEvery(unsigned ticks)
{
    if (ticks == m_fastEvery)
        return;
    m_fastEvery = ticks;
    replanSoon();
}

void SignalPlan::begin(const capture::StreamLayout &layout)
{
    m_capture.begin(layout);
    Q_EMIT changed();
}

void SignalPlan::adopt(capture::Capture file)
{
    Q_EMIT forgetting();
    m_capture.adopt(std::move(file));
    m_fromFile = true;
    m_met.reset();
    Q_EMIT forgot();
    Q_EMIT changed();
    Q_EMIT renewed();
}

void SignalPlan::clear()
{
    Q_EMIT forgetting();
    m_fromFile = m_replaying;
    m_capture.clear();
    if (!m_device.answering())
        m_met.reset();
    Q_EMIT forgot();
    Q_EMIT changed();
    Q_EMIT renewed();
}

/// A board's samples do not follow a file's, nor a replay's a board's.
void SignalPlan::opened(const session::Endpoint &endpoint)
{
    m_replaying = endpoint.kind == session::Endpoint::Kind::Trace;
    if (!m_fromFile && !m_replaying)
        return;
    clear();
    Q_EMIT begunAnew();
}

/// No trace goes from one board's values to another's.
void SignalPlan::meet()
{
    const auto &board = m_device.identified();
    if (!board)
        return;
    const bool other = m_met && !isSame(*m_met, board->identity);
    m_met = board->identity;
    if (!other)
        return;
    endPolled();
    Q_EMIT boardReplaced();
}

void SignalPlan::endPolled()
{
    for (const capture::ChannelInfo &info : m_capture.channels())
        if (info.kind == Kind::Polled)
            m_capture.endPolled(info.registerId);
}

void SignalPlan::boardChanged()
{
    const auto catalog = m_device.catalog();
    if (!catalog || m_replaying) // a recording streams what it streams
        return;
    m_names = named(); // another board has other numbers for its registers
    meet();
    m_catalog = catalog;
    m_speeds = m_device.identified()->identity.speedSignals;
    m_wanted.clear();
    resolveNames();
    m_streamWish = 0;
    m_brokenOff = 0;
    m_newBoard = true;
    for (const auto &[id, factor] : std::exchange(m_polledFactors, {}))
        if (catalog->readScale(id).factor != factor)
            m_capture.endPolledForGood(id); // the same unit by another scale
    if (m_wanted.empty())
        addDefaults();
    replan();
}

void SignalPlan::refresh(Milliseconds now)
{
    const bool missing = m_brokenOff > 0 || m_streamStale;
    if (!missing || m_streamWish != 0 || m_replaying || !m_device.answering())
        return;
    if (!m_againAt)
        m_againAt = now + kAgainAfter;
    else if (now >= *m_againAt)
        sendStream();
}

void SignalPlan::replan()
{
    const auto catalog = m_device.catalog();
    if (!catalog || m_replaying)
        return;
    const std::vector<catalog::RegisterId> polledBefore = m_plan.polled;
    const ChannelPlan before = std::exchange(m_newBoard, false) ? ChannelPlan() : m_plan;
    m_plan = planChannels(m_wanted, *catalog, m_device.streamLimits(), m_fastEvery);
    for (const catalog::RegisterId id : polledBefore)
        if (std::find(m_plan.polled.begin(), m_plan.polled.end(), id) == m_plan.polled.end())
            m_capture.endPolled(id);
    tellWhatDoesNotFit(before);
    sendStream();
    Q_EMIT changed();
}

/// Nothing that would lose samples starts without a word.
void SignalPlan::tellWhatDoesNotFit(const ChannelPlan &before)
{
    const drive::StreamLimits limits = m_device.streamLimits();
    const auto kilo = [](double bytes) { return numberText(bytes / 1000.0, 1); };
    if (m_plan.rateLowered
        && (!before.rateLowered || before.stream.fastEvery != m_plan.stream.fastEvery))
        Q_EMIT noticed(tr("These signals would need %1 kB/s, the link carries %2 kB/s: they are "
                          "recorded at %3 Hz.")
                           .arg(kilo(m_plan.fullRateBytes), kilo(limits.linkBytesPerSecond),
                               numberText(m_plan.fastHz, 0)));
    const auto crowdedOut = [](const ChannelPlan &plan) {
        return std::count_if(
            plan.signalList.begin(), plan.signalList.end(), [](const PlannedSignal &signal) {
                return signal.detour == Detour::TooManySignals || signal.detour == Detour::LinkFull;
            });
    };
    if (crowdedOut(m_plan) > crowdedOut(before))
        Q_EMIT noticed(tr("%n signal(s) do not fit into the recording and are polled.", nullptr,
            static_cast<int>(crowdedOut(m_plan))));
}

/// The link is in doubt: when it is well again, the board is not identified anew.
bool SignalPlan::doubted() const
{
    const drive::LinkState link = m_device.link().state;
    return link == drive::LinkState::Suspect || link == drive::LinkState::Recovering;
}

void SignalPlan::sendStream()
{
    const bool empty = m_plan.stream.fast.empty() && m_plan.stream.slow.empty();
    if (empty && !m_streamed) {
        m_streamStale = false;
        return;
    }
    m_streamStale = m_streamWish != 0 || doubted();
    if (m_streamStale || !m_device.answering())
        return;
    m_againAt.reset();
    m_streamed = !empty;
    m_streamWish = m_device.submit(m_plan.stream);
}

void SignalPlan::accept(const std::vector<drive::Reading> &readings)
{
    const auto catalog = m_device.catalog();
    if (!catalog || (m_plan.polled.empty() && !m_replaying))
        return;
    const auto asked = [this](catalog::RegisterId id) {
        return m_replaying
            || std::find(m_plan.polled.begin(), m_plan.polled.end(), id) != m_plan.polled.end();
    };
    // A recording does not say for what a value was read.
    using Asked = capture::Capture::Asked;
    const Asked why = m_replaying ? Asked::Aside : Asked::AsSignal;
    bool isNew = false;
    for (const drive::Reading &reading : readings) {
        if (reading.status != drive::ReadStatus::Ok || !asked(reading.id))
            continue;
        const catalog::Scale scale = catalog->readScale(reading.id);
        const bool known = m_capture.find(reading.id, Kind::Polled).has_value();
        m_polledFactors[reading.id] = scale.factor;
        m_capture.appendPolled(reading.id, catalog->nameOf(reading.id), scale.unit,
            toSeconds(reading.at.time_since_epoch()), rawNumber(reading.value) * scale.factor, why);
        isNew = isNew || !known;
    }
    if (isNew)
        Q_EMIT changed();
}

} // namespace widgets
