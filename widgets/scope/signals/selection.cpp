#include "widgets/scope/signals/selection.h"

#include "widgets/base/device_text.h"
#include "widgets/base/value_text.h"
#include "widgets/scope/colors.h"
#include "widgets/scope/view.h"

#include <QMenu>

#include <algorithm>
#include <set>
#include <utility>

namespace widgets {
namespace {

using Kind = capture::ChannelInfo::Kind;

constexpr qsizetype kMostFromFile = 32; ///< signals that are shown of a file
constexpr int kMostPlotsFromFile = 4;

} // namespace

SignalSelection::SignalSelection(
    Device &device, capture::Capture &capture, SignalPlan &plan, ScopeView &scope, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_capture(capture)
    , m_plan(plan)
    , m_scope(scope)
{
    connect(&plan, &SignalPlan::changed, this, &SignalSelection::follow);
    connect(&plan, &SignalPlan::forgetting, this, &SignalSelection::takeOffScope);
    connect(&plan, &SignalPlan::forgot, this, [this] { m_offered.clear(); });
    connect(&plan, &SignalPlan::begunAnew, &scope, [&scope] { scope.time().setFollowing(true); });
    connect(&scope.colors(), &ScopeColors::changed, this, &SignalSelection::changed);
    connect(&scope, &ScopeView::registerDropped, this,
        [this](quint32 id, int plot) { add(id, plot < 0 ? m_scope.plotCount() : plot); });
    connect(&scope, &ScopeView::removeRequested, this, [this](quint32 channel) {
        if (m_plan.showsFile())
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

QColor SignalSelection::colorOf(catalog::RegisterId id) const
{
    const auto channel = m_plan.channelOf(id);
    return channel && m_scope.plotOf(*channel) >= 0 ? m_scope.colorOf(*channel) : QColor();
}

void SignalSelection::fillColors(QMenu &menu, catalog::RegisterId id)
{
    if (const auto catalog = m_device.catalog())
        m_scope.colors().fill(menu, QString::fromStdString(catalog->nameOf(id)));
}

int SignalSelection::plotFor(catalog::RegisterId id) const
{
    const auto catalog = m_device.catalog();
    int last = 0;
    for (const WantedSignal &signal : m_plan.wanted()) {
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
    const WantedSignal *wanted = m_plan.find(id);
    if (m_plan.showsFile()) {
        if (const auto channel = m_capture.find(id))
            showOfFile(*channel, true);
    } else if (!wanted) {
        m_plan.add(id, plot >= 0 ? plot : plotFor(id));
    } else if (plot >= 0 && wanted->plot != plot) { // dropped onto another plot: it moves there
        if (const auto channel = m_plan.channelOf(id))
            m_scope.moveChannel(*channel, plot);
        else
            m_plan.setPlot(id, plot);
    }
}

void SignalSelection::remove(quint32 id)
{
    if (const auto channel = m_plan.channelOf(id))
        m_scope.removeChannel(*channel);
    m_plan.remove(id);
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
    m_unfilled = true;
    m_plan.adopt(std::move(file));
    m_scope.fitAll();
    return m_left;
}

void SignalSelection::follow()
{
    if (std::exchange(m_unfilled, false))
        fill();
    else if (!m_plan.showsFile())
        syncScope();
    else if (m_plan.replaying())
        showReplayed();
    Q_EMIT changed();
}

/// What was only read now and then, for the tables of the window, would bury what the user wanted to see; what was on
/// the scope before is wanted.
void SignalSelection::fill()
{
    const std::vector<capture::ChannelInfo> all = m_capture.channels();
    std::set<catalog::RegisterId> streamed;
    for (const capture::ChannelInfo &info : all)
        if (info.kind != Kind::Polled)
            streamed.insert(info.registerId);
    m_left = 0;
    for (const capture::ChannelInfo &info : all) {
        const bool wanted = m_plan.find(info.registerId) && !streamed.contains(info.registerId);
        if (!streamed.empty() && info.kind == Kind::Polled && !wanted)
            continue;
        if (isFullOfFile())
            ++m_left;
        else
            showOfFile(info.id, true);
    }
}

/// A plot for each unit, as long as there is room.
void SignalSelection::showOfFile(capture::ChannelId id, bool shown)
{
    const auto info = m_capture.info(id);
    if (!m_plan.showsFile() || !info || (m_scope.plotOf(id) >= 0) == shown)
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

void SignalSelection::fillFileSignals(QMenu &menu)
{
    menu.clear();
    menu.setEnabled(m_plan.showsFile());
    if (!m_plan.showsFile())
        return;
    std::vector<capture::ChannelInfo> all = m_capture.channels();
    std::stable_sort(all.begin(), all.end(), [](const auto &one, const auto &other) {
        return one.kind != Kind::Polled && other.kind == Kind::Polled;
    });
    for (const capture::ChannelInfo &info : all) {
        QString text = deviceText(info.name);
        if (!info.unit.empty())
            text += QStringLiteral(" [%1]").arg(unitText(info.unit));
        if (info.kind == Kind::Polled)
            text = tr("%1, polled", "a signal").arg(text);
        QAction *action = menu.addAction(text.replace(QLatin1Char('&'), QLatin1String("&&")));
        action->setCheckable(true);
        action->setChecked(m_scope.plotOf(info.id) >= 0);
        connect(action, &QAction::triggered, this, [this, action, id = info.id](bool on) {
            showOfFile(id, on);
            action->setChecked(m_scope.plotOf(id) >= 0); // the menu is still there
        });
    }
}

/// What a replay streams is shown once; what is taken away stays away.
void SignalSelection::showReplayed()
{
    for (const capture::ChannelId id : m_capture.streaming())
        if (m_offered.insert(id).second)
            showOfFile(id, true);
}

void SignalSelection::syncScope()
{
    std::vector<capture::ChannelId> shown;
    std::vector<const WantedSignal *> ordered; // so that the plots come in their order
    for (const WantedSignal &signal : m_plan.wanted())
        ordered.push_back(&signal);
    std::stable_sort(ordered.begin(), ordered.end(),
        [](const auto *one, const auto *other) { return one->plot < other->plot; });
    for (const WantedSignal *signal : ordered) {
        const auto channel = m_plan.channelOf(signal->id);
        if (!channel)
            continue;
        shown.push_back(*channel);
        if (m_scope.plotOf(*channel) < 0)
            show(*signal, *channel);
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

/// Beside a signal that is to be in the same plot; else in a plot of its own, in the order of the plots.
void SignalSelection::show(const WantedSignal &signal, capture::ChannelId channel)
{
    int later = m_scope.plotCount();
    for (const WantedSignal &other : m_plan.wanted()) {
        const auto shown = m_plan.channelOf(other.id);
        const int plot = shown ? m_scope.plotOf(*shown) : -1;
        if (plot >= 0 && other.plot == signal.plot)
            return m_scope.addChannel(channel, plot);
        if (plot >= 0 && other.plot > signal.plot)
            later = std::min(later, plot);
    }
    m_scope.addChannel(channel, later, true);
}

/// Plots vanish with their last trace: where the signals are is known once all of them are shown.
void SignalSelection::rememberPlots()
{
    std::vector<int> plots;
    for (const WantedSignal &signal : m_plan.wanted()) {
        const auto channel = m_plan.channelOf(signal.id);
        plots.push_back(channel ? m_scope.plotOf(*channel) : -1);
    }
    if (std::find(plots.begin(), plots.end(), -1) != plots.end())
        return;
    for (std::size_t i = 0; i < plots.size(); ++i)
        m_plan.setPlot(m_plan.wanted()[i].id, plots[i]);
}

} // namespace widgets
