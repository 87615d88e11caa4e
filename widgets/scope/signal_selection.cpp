#include "widgets/scope/signal_selection.h"

#include "widgets/base/device_text.h"
#include "widgets/base/messages.h"
#include "widgets/base/value_text.h"
#include "widgets/scope/scope_view.h"

#include <algorithm>
#include <utility>

namespace widgets {
namespace {

using Kind = capture::ChannelInfo::Kind;

constexpr qsizetype kMostFromFile = 32; ///< signals that are shown of a file
constexpr int kMostPlotsFromFile = 4;

Kind kindOf(Route route)
{
    return route == Route::Fast ? Kind::Fast : route == Route::Slow ? Kind::Slow : Kind::Polled;
}

} // namespace

SignalSelection::SignalSelection(
    Device &device, capture::Capture &capture, ScopeView &scope, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_capture(capture)
    , m_scope(scope)
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(0); // several drops in one turn of the loop make one stream
    connect(&m_soon, &QTimer::timeout, this, &SignalSelection::replan);
    connect(&device, &Device::openWished, this, &SignalSelection::opened);
    connect(&device, &Device::identityChanged, this, &SignalSelection::boardChanged);
    connect(&device, &Device::readingsArrived, this, &SignalSelection::takeReadings);
    connect(&scope, &ScopeView::colorsChanged, this, &SignalSelection::changed);
    connect(&device, &Device::streamStarted, this, [this](const capture::StreamLayout &layout) {
        m_capture.begin(layout);
        syncScope();
        showReplayed();
        Q_EMIT changed();
    });
    connect(&device, &Device::samplesArrived, this,
        [this](const capture::SampleBlock &block) { m_capture.append(block); });
    connect(&device, &Device::wishEnded, this, [this](const drive::Ended &ended) {
        if (ended.id == 0 || ended.id != m_streamWish)
            return;
        m_streamWish = 0;
        if (ended.outcome != drive::Outcome::Ok && m_device.answering())
            Q_EMIT failed(failureText(tr("Recording signals"), ended));
        if (m_streamStale)
            replanSoon();
    });
    connect(&scope, &ScopeView::registerDropped, this,
        [this](quint32 id, int plot) { add(id, plot < 0 ? m_scope.plotCount() : plot); });
    connect(&scope, &ScopeView::removeRequested, this, [this](quint32 channel) {
        if (m_fromFile)
            showOfFile(channel, false);
        else if (const auto info = m_capture.info(channel))
            remove(info->registerId);
    });
    connect(&scope, &ScopeView::channelMoved, this, &SignalSelection::rememberPlots);
}

QString SignalSelection::nameOf(catalog::RegisterId id) const
{
    const auto catalog = m_device.catalog();
    return catalog ? deviceText(catalog->nameOf(id)) : QString();
}

std::optional<capture::ChannelId> SignalSelection::channelOf(catalog::RegisterId id) const
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

QColor SignalSelection::colorOf(catalog::RegisterId id) const
{
    const auto channel = channelOf(id);
    return channel && m_scope.plotOf(*channel) >= 0 ? m_scope.colorOf(*channel) : QColor();
}

void SignalSelection::fillColors(QMenu &menu, catalog::RegisterId id)
{
    if (const auto catalog = m_device.catalog())
        m_scope.fillColors(menu, QString::fromStdString(catalog->nameOf(id)));
}

void SignalSelection::addDefaults()
{
    const auto catalog = m_device.catalog();
    if (!catalog)
        return;
    const bool simulated = m_device.endpoint().kind == session::Endpoint::Kind::Simulator;
    // Which speed sensor a real board has is not known before it is asked; its measured speed always exists.
    const std::pair<const char *, int> defaults[] = {{"I_A", 0}, {"I_B", 0}, {"I_Q_MEAS", 0},
        {simulated ? "STOPLL_ROT_SPEED" : "SPEED_MEAS", 1}};
    for (const auto &[name, plot] : defaults) {
        const catalog::RegisterInfo *info = catalog->find(name);
        if (info)
            add(info->perMotor ? catalog->withMotor(*info, m_device.motor()) : info->id, plot);
    }
}

int SignalSelection::plotFor(catalog::RegisterId id) const
{
    const auto catalog = m_device.catalog();
    int last = 0;
    for (const WantedSignal &signal : m_wanted) {
        if (catalog && catalog->readScale(signal.id).unit == catalog->readScale(id).unit)
            return signal.plot;
        last = std::max(last, signal.plot + 1);
    }
    const auto shown = m_scope.channels(); // what is computed has its plots, too
    for (const capture::ChannelId channel : shown) {
        const auto info = m_capture.info(channel);
        if (info && !info->isBoards())
            last = std::max(last, m_scope.plotOf(channel) + 1);
    }
    return last;
}

void SignalSelection::add(quint32 id, int plot)
{
    if (m_fromFile) {
        if (const auto channel = m_capture.find(id))
            showOfFile(*channel, true);
        return;
    }
    const auto catalog = m_device.catalog();
    const catalog::RegisterInfo *info = catalog ? catalog->find(id) : nullptr;
    if (!info || info->type == catalog::ValueType::Text || info->type == catalog::ValueType::Raw)
        return;
    const int wantedPlot = plot >= 0 ? plot : plotFor(id);
    const Route route = info->streaming == catalog::Streaming::Polled ? Route::Polled : Route::Fast;
    const auto found =
        std::find_if(m_wanted.begin(), m_wanted.end(), [id](const auto &s) { return s.id == id; });
    if (found == m_wanted.end()) {
        m_wanted.push_back({id, route, wantedPlot});
        replanSoon();
    } else if (plot >= 0 && found->plot != plot) { // dropped onto another plot: it moves there
        if (const auto channel = channelOf(id))
            m_scope.moveChannel(*channel, plot);
        else
            found->plot = plot;
    }
}

void SignalSelection::remove(quint32 id)
{
    if (const auto channel = channelOf(id))
        m_scope.removeChannel(*channel);
    if (std::erase_if(m_wanted, [id](const WantedSignal &signal) { return signal.id == id; }) == 0)
        return;
    m_capture.endPolled(id);
    replanSoon();
}

void SignalSelection::setRoute(quint32 id, Route route)
{
    for (WantedSignal &signal : m_wanted)
        if (signal.id == id)
            signal.route = route;
    replanSoon();
}

void SignalSelection::setFastEvery(unsigned ticks)
{
    if (ticks == m_fastEvery)
        return;
    m_fastEvery = ticks;
    replanSoon();
}

void SignalSelection::takeOffScope()
{
    const auto shown = m_scope.channels();
    // The first one last: a trigger on it would go to the next, with a level of its own.
    std::for_each(shown.rbegin(), shown.rend(),
        [this](capture::ChannelId channel) { m_scope.removeChannel(channel); });
}

bool SignalSelection::isFullOfFile() const { return m_scope.channels().size() >= kMostFromFile; }

int SignalSelection::showFile(capture::Capture file)
{
    takeOffScope();
    m_capture.adopt(std::move(file));
    m_fromFile = true;
    Q_EMIT forgot();
    // What was only read now and then, for the tables of the window, would bury what somebody wanted to see.
    const std::vector<capture::ChannelInfo> all = m_capture.channels();
    const bool streamed = std::any_of(
        all.begin(), all.end(), [](const auto &info) { return info.kind != Kind::Polled; });
    int left = 0;
    for (const capture::ChannelInfo &info : all) {
        if (streamed && info.kind == Kind::Polled)
            continue;
        if (isFullOfFile())
            ++left;
        else
            showOfFile(info.id, true);
    }
    m_scope.captureChanged();
    m_scope.fitAll();
    Q_EMIT changed();
    return left;
}

/// A plot for each unit, as long as there is room.
void SignalSelection::showOfFile(capture::ChannelId id, bool shown)
{
    const auto info = m_capture.info(id);
    if (!m_fromFile || !info || (m_scope.plotOf(id) >= 0) == shown)
        return;
    if (!shown) {
        m_scope.removeChannel(id);
        return;
    }
    if (isFullOfFile()) {
        Q_EMIT noticed(
            tr("The scope shows up to %1 signals of a file: take one off to see another.")
                .arg(QString::number(kMostFromFile)));
        return;
    }
    const QList<capture::ChannelId> there = m_scope.channels();
    int plot = there.isEmpty() ? 0 : std::min(m_scope.plotCount(), kMostPlotsFromFile - 1);
    for (const capture::ChannelId other : there)
        if (m_capture.info(other)->unit == info->unit)
            plot = m_scope.plotOf(other);
    m_scope.addChannel(id, plot);
}

void SignalSelection::opened(const session::Endpoint &endpoint)
{
    m_replaying = endpoint.kind == session::Endpoint::Kind::Trace;
    leaveFile();
    if (!m_replaying)
        return;
    m_offered.clear();
    m_scope.events().clear();
    clearRecorded(); // nor do a file's follow a board's
    m_scope.setFollowing(true);
}

/// What a replay streams is shown once; whoever takes it away has taken it away.
void SignalSelection::showReplayed()
{
    if (!m_replaying)
        return;
    for (const capture::ChannelId id : m_capture.streaming())
        if (m_offered.insert(id).second)
            showOfFile(id, true);
}

/// A board's samples do not follow a file's.
void SignalSelection::leaveFile()
{
    if (!m_fromFile)
        return;
    m_scope.events().clear();
    clearRecorded();
    m_scope.setFollowing(true);
}

void SignalSelection::clearRecorded()
{
    takeOffScope();
    m_fromFile = m_replaying;
    m_capture.clear();
    m_offered.clear();
    Q_EMIT forgot();
    syncScope();
    showReplayed();
    m_scope.captureChanged();
    Q_EMIT changed();
}

void SignalSelection::boardChanged()
{
    const auto catalog = m_device.catalog();
    if (!catalog || m_replaying) // a recording streams what it streams
        return;
    std::erase_if(
        m_wanted, [&](const WantedSignal &signal) { return catalog->find(signal.id) == nullptr; });
    m_streamWish = 0;
    m_newBoard = true;
    for (const auto &[id, factor] : std::exchange(m_polledFactors, {}))
        if (catalog->readScale(id).factor != factor)
            m_capture.endPolledForGood(id); // the same unit by another scale
    if (m_wanted.empty())
        addDefaults();
    replan();
}

void SignalSelection::replanSoon() { m_soon.start(); }

void SignalSelection::replan()
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
    syncScope();
    Q_EMIT changed();
}

/// Nothing that would lose samples starts without a word.
void SignalSelection::tellWhatDoesNotFit(const ChannelPlan &before)
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
        Q_EMIT noticed(tr("%n signal(s) do not fit into the recording and are read one by one.",
            nullptr, static_cast<int>(crowdedOut(m_plan))));
}

void SignalSelection::sendStream()
{
    m_streamStale = m_streamWish != 0;
    const bool empty = m_plan.stream.fast.empty() && m_plan.stream.slow.empty();
    if (m_streamStale || !m_device.answering() || (empty && !m_streamed))
        return;
    m_streamed = !empty;
    m_streamWish = m_device.submit(m_plan.stream);
}

void SignalSelection::takeReadings(const std::vector<drive::Reading> &readings)
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
    if (isNew) {
        syncScope();
        Q_EMIT changed();
    }
}

void SignalSelection::syncScope()
{
    if (m_fromFile)
        return;
    std::vector<capture::ChannelId> shown;
    std::vector<const WantedSignal *> ordered; // so that the plots come in their order
    for (const WantedSignal &signal : m_wanted)
        ordered.push_back(&signal);
    std::stable_sort(ordered.begin(), ordered.end(),
        [](const auto *one, const auto *other) { return one->plot < other->plot; });
    for (const WantedSignal *signal : ordered) {
        const auto channel = channelOf(signal->id);
        if (!channel)
            continue;
        shown.push_back(*channel);
        if (m_scope.plotOf(*channel) < 0)
            m_scope.addChannel(*channel, shownPlotOf(*signal));
    }
    const auto there = m_scope.channels();
    for (const capture::ChannelId channel : there) {
        const auto info = m_capture.info(channel);
        const bool anothers = info && !info->isBoards(); // such as what is computed
        if (!anothers && std::find(shown.begin(), shown.end(), channel) == shown.end())
            m_scope.removeChannel(channel);
    }
    rememberPlots();
}

/// Beside a signal that is to be in the same plot; else in that plot if no other signal has it, or in a new one.
int SignalSelection::shownPlotOf(const WantedSignal &signal) const
{
    bool taken = false;
    for (const WantedSignal &other : m_wanted) {
        const auto channel = channelOf(other.id);
        const int plot = channel ? m_scope.plotOf(*channel) : -1;
        if (plot >= 0 && other.plot == signal.plot)
            return plot;
        taken = taken || plot == signal.plot;
    }
    return taken ? m_scope.plotCount() : signal.plot;
}

/// Plots vanish with their last trace: where the signals are is known once all of them are shown.
void SignalSelection::rememberPlots()
{
    std::vector<int> plots;
    for (const WantedSignal &signal : m_wanted) {
        const auto channel = channelOf(signal.id);
        plots.push_back(channel ? m_scope.plotOf(*channel) : -1);
    }
    if (std::find(plots.begin(), plots.end(), -1) != plots.end())
        return;
    for (std::size_t i = 0; i < plots.size(); ++i)
        m_wanted[i].plot = plots[i];
}

} // namespace widgets
