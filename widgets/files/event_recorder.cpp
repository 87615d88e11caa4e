#include "widgets/files/event_recorder.h"

#include "base/overloaded.h"
#include "widgets/base/device_text.h"
#include "widgets/base/messages.h"
#include "widgets/base/reading_text.h"
#include "widgets/base/value_text.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace widgets {

namespace {
constexpr double kOtherAxis = 2.0; ///< seconds; a stamp so far off belongs to another clock
constexpr std::size_t kMostAsked = 1000;
// From the board's answer until it has forgotten the faults that were acknowledged, at most: some do it a cycle later.
constexpr Duration kForgets = std::chrono::milliseconds(10);
/// Set-points that follow each other sooner excite a motor, some hundred times a response: the first one stands for
/// all.
constexpr Duration kExcites = std::chrono::milliseconds(200);
constexpr double kDegreesPerRad = 180.0 / std::numbers::pi;
} // namespace

bool SessionClock::stamped(TimePoint at, Milliseconds now)
{
    const double lag = toSeconds(now) - toSeconds(at.time_since_epoch());
    const bool other = !m_lag || lag > *m_lag + kOtherAxis;
    // What arrives late makes the lag look longer, nothing makes it look shorter.
    if (other || lag < *m_lag)
        m_lag = lag;
    return other;
}

double SessionClock::secondsAt(Milliseconds now) const
{
    return toSeconds(now) - m_lag.value_or(0.0);
}

EventRecorder::EventRecorder(Device &device, const capture::Capture &capture, EventLog &log,
    std::function<Milliseconds()> now, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_capture(capture)
    , m_log(log)
    , m_now(std::move(now))
{
    connect(&device, &Device::wishMade, this, &EventRecorder::wished);
    connect(&device, &Device::wishEnded, this, &EventRecorder::ended);
    connect(&device, &Device::statusChanged, this, &EventRecorder::status);
    connect(&device, &Device::motionLogged, this, &EventRecorder::acted);
    connect(&device, &Device::linkStateChanged, this, &EventRecorder::link);
    connect(&device, &Device::portStateChanged, this, &EventRecorder::port);
    connect(&device, &Device::openWished, this, [this] { m_loss.reset(); });
    connect(&device, &Device::streamStarted, this, [this](const capture::StreamLayout &layout) {
        m_tickHz = layout.tickHz;
        if (!layout.empty()
            && std::exchange(m_origin, layout.originSeconds) != layout.originSeconds)
            m_axis.forget();
    });
    connect(&device, &Device::stopWished, this,
        [this] { note(EventKind::Command, this->samplesNow(), EventRecorder::tr("Stop motors")); });
    connect(&device, &Device::armedStateChanged, this, [this](bool armed) {
        note(EventKind::Command, this->samplesNow(),
            armed ? EventRecorder::tr("Armed") : EventRecorder::tr("Disarmed"));
    });
    connect(&device, &Device::stopAdvanced, this, [this](const drive::StopProgress &progress) {
        if (progress.word == drive::StopWord::NotConfirmed)
            note(EventKind::Fault, onAxis(progress.at),
                named(progress.motor, stopWordText(progress.word)));
    });
    connect(&device, &Device::readingsArrived, this,
        [this](const std::vector<drive::Reading> &readings) {
            for (const drive::Reading &reading : readings)
                stamped(reading.at);
        });
}

double EventRecorder::now() const { return m_clock.secondsAt(m_now()); }

void EventRecorder::stamped(TimePoint at)
{
    if (m_clock.stamped(at, m_now()))
        m_axis.forget(); // it was measured by another clock
}

double EventRecorder::onAxis(TimePoint at) const
{
    return m_axis.of(toSeconds(at.time_since_epoch()));
}

/// Of the samples in the capture: one that counts anew goes on there behind those of before.
void EventRecorder::hear()
{
    const auto streaming = m_capture.streaming();
    const capture::Channel *channel =
        streaming.empty() ? nullptr : m_capture.channel(streaming.front());
    if (channel && !channel->empty())
        m_axis.heard(now(), capture::toSeconds(channel->timeOf(channel->end() - 1)));
}

void EventRecorder::noteExperiment(TimePoint at, const QString &text)
{
    note(EventKind::Command, onAxis(at), tr("Experiment: %1").arg(text));
}

void EventRecorder::note(EventKind kind, double seconds, const QString &text)
{
    m_log.add(kind, seconds, text);
}

QString EventRecorder::named(int motor, const QString &text) const
{
    return motorText(motor, text, severalMotors());
}

bool EventRecorder::severalMotors() const
{
    return m_device.identified() && m_device.identified()->identity.motors > 1;
}

QString EventRecorder::motorText(int motor, const QString &text, bool several)
{
    return several ? tr("Motor %1: %2").arg(QString::number(motor), text) : text;
}

QString EventRecorder::wishText(const drive::Wish &wish, bool several)
{
    const auto named = [several](int motor, const QString &text) {
        return motorText(motor, text, several);
    };
    const auto inTime = [](std::chrono::milliseconds duration) {
        return QString::number(duration.count());
    };
    return std::visit(
        Overloaded{
            [&](const drive::Command &command) {
                switch (command.action) {
                case drive::MotorAction::Start:
                    return named(command.motor, tr("Start"));
                case drive::MotorAction::StopMotor:
                    return named(command.motor, tr("Stop"));
                case drive::MotorAction::StopRamp:
                    return named(command.motor, tr("Stop ramp"));
                case drive::MotorAction::AcknowledgeFaults:
                    return named(command.motor, tr("Acknowledge faults"));
                }
                return QString();
            },
            [&](const drive::SpeedRamp &ramp) {
                return named(ramp.motor,
                    tr("Ramp to %1 rpm in %2 ms")
                        .arg(QString::number(ramp.rpm), inTime(ramp.duration)));
            },
            [&](const drive::TorqueRamp &ramp) {
                return named(ramp.motor,
                    tr("Ramp to %1 A in %2 ms")
                        .arg(numberText(ramp.amps, 3), inTime(ramp.duration)));
            },
            [&](const drive::CurrentReference &reference) {
                return named(reference.motor,
                    tr("Currents Iq %1 A, Id %2 A")
                        .arg(numberText(reference.iqAmps, 3), numberText(reference.idAmps, 3)));
            },
            [&](const drive::PositionRamp &ramp) {
                return named(ramp.motor,
                    tr("Shaft to %1\u00b0 in %2 ms")
                        .arg(numberText(ramp.radians * kDegreesPerRad, 1), inTime(ramp.duration)));
            },
            [](const auto &) { return QString(); },
        },
        wish.what);
}

void EventRecorder::wished(const drive::Wish &wish)
{
    const bool write = std::holds_alternative<drive::Write>(wish.what);
    const QString text = wishText(wish, severalMotors());
    if ((!write && text.isEmpty()) || m_asked.size() >= kMostAsked)
        return;
    const double seconds = samplesNow();
    m_asked[wish.id] = {seconds, write ? 0 : m_log.add(EventKind::Command, seconds, text)};
}

void EventRecorder::ended(const drive::Ended &ended)
{
    const auto asked = m_asked.find(ended.id);
    if (asked == m_asked.end())
        return;
    const auto [seconds, id] = asked->second;
    m_asked.erase(asked);
    m_lastEnded = {ended.id, id};
    const ScopeEvent *event = m_log.find(id);
    if (event && ended.outcome != drive::Outcome::Ok)
        m_log.setText(
            id, tr("%1 (%2)", "a command and how it ended").arg(event->text, outcomeText(ended)));
    for (const drive::WriteResult &write : ended.writes)
        wrote(write, seconds);
}

void EventRecorder::left(drive::WishId wish, double within_s)
{
    // Told by the session itself, before or behind the end of the wish.
    const auto asked = m_asked.find(wish);
    const quint32 id = asked != m_asked.end() ? asked->second.event
        : m_lastEnded.first == wish           ? m_lastEnded.second
                                              : 0;
    if (const ScopeEvent *event = m_log.find(id); event && event->kind == EventKind::Command)
        m_log.setText(id,
            tr("%1; at the board within %2", "a command, a time")
                .arg(event->text, exactTime(within_s, QLocale())));
}

void EventRecorder::wrote(const drive::WriteResult &write, double seconds)
{
    const auto catalog = m_device.catalog();
    const catalog::RegisterInfo *info = catalog ? catalog->find(write.id) : nullptr;
    if (!info || write.outcome == drive::Outcome::NotSent)
        return;
    const auto shown = [&](const std::optional<drive::Value> &value) {
        return value ? deviceText(shownText(*info, *value, catalog->readScale(write.id)))
                     : QStringLiteral("?");
    };
    const QString name = deviceText(catalog->nameOf(write.id));
    QString text = tr("%1: %2 \u2192 %3", "a register, its value before and after")
                       .arg(name, shown(write.before), shown(write.readBack));
    if (write.outcome != drive::Outcome::Ok)
        text = tr("%1 (%2)", "a command and how it ended").arg(text, outcomeText(write.outcome));
    note(EventKind::Write, seconds, text);
    if (write.outcome == drive::Outcome::Ok)
        Q_EMIT written(seconds, name);
}

void EventRecorder::acted(const drive::MotionEntry &entry)
{
    if (entry.act == drive::MotionAct::AcknowledgeFaults && entry.outcome == drive::Outcome::Ok)
        m_acknowledged[entry.motor] = entry.ended;
    // What the user asks for is noted as it is asked for; an experiment asks without the Device.
    if (entry.source == drive::Source::Person)
        return;
    const auto before = std::exchange(m_experimented, {entry.act, entry.asked});
    if (entry.outcome == drive::Outcome::Ok && entry.act == before.first
        && entry.asked >= before.second && entry.asked < before.second + kExcites)
        return;
    QString text = motionActText(entry.act);
    if (!entry.detail.empty())
        text += QLatin1Char(' ') + deviceText(entry.detail);
    if (entry.motor > 0)
        text = named(entry.motor, text);
    if (entry.outcome != drive::Outcome::Ok)
        text = tr("%1 (%2)", "a command and how it ended").arg(text, outcomeText(entry.outcome));
    noteExperiment(entry.asked, text);
}

/// Whether what it tells of the past came since the faults of before were acknowledged.
bool EventRecorder::pastIsNew(const drive::MotorStatus &now)
{
    const auto at = m_acknowledged.find(now.motor);
    if (at == m_acknowledged.end() || now.asked < at->second + kForgets)
        return false;
    m_acknowledged.erase(at);
    return true;
}

void EventRecorder::status(int motor)
{
    const drive::MotorStatus now = m_device.status(motor);
    const auto known = m_status.find(motor);
    const bool met = known != m_status.end();
    drive::MotorStatus before = met ? known->second : drive::MotorStatus();
    // The same one again, before the board was seen without it.
    if (pastIsNew(now))
        before.faultsPast.clear();
    m_status[motor] = now;
    stamped(now.at);
    const double seconds = onAxis(now.at);
    // One that was over before the board was asked again is among the past ones only. Those of before the connection
    // are no event of it.
    const auto has = [](const std::vector<std::string> &faults, const std::string &fault) {
        return std::find(faults.begin(), faults.end(), fault) != faults.end();
    };
    std::vector<std::string> fresh = now.faultsNow;
    std::erase_if(fresh, [&](const std::string &fault) { return has(before.faultsNow, fault); });
    for (const std::string &fault : now.faultsPast)
        if (met && !has(before.faultsPast, fault) && !has(before.faultsNow, fault)
            && !has(now.faultsNow, fault))
            fresh.push_back(fault);
    for (const std::string &fault : fresh) {
        note(EventKind::Fault, seconds, named(motor, deviceText(fault)));
        Q_EMIT stateChanged(seconds, EventKind::Fault, 0);
        if (met)
            Q_EMIT faulted(seconds, motor, deviceText(fault));
    }
    if (now.state == before.state && now.rawState == before.rawState)
        return;
    // The firmware's own word is finer than ours: CHARGE_BOOT_CAP and ALIGNMENT are both a start.
    const QString word =
        now.stateName.empty() ? motorStateText(now.state) : deviceText(now.stateName);
    note(EventKind::State, seconds, named(motor, word));
    Q_EMIT stateChanged(seconds, EventKind::State, static_cast<quint32>(now.rawState));
}

void EventRecorder::link()
{
    using drive::LinkState;
    const drive::LinkChanged link = m_device.link();
    const LinkState before = std::exchange(m_link, link.state);
    if (before == link.state && link.reason != drive::LinkReason::BoardReset)
        return;
    const QString word = linkStateText(link);
    const bool wasThere = before == LinkState::Connected || before == LinkState::Suspect
        || before == LinkState::Recovering;
    switch (link.state) {
    case LinkState::Connected:
        // What it tells next is told anew, but not behind a moment of silence. A board that was reset has no past: each
        // fault that it knows of came since.
        if (link.reason == drive::LinkReason::BoardReset) {
            for (auto &[motor, status] : m_status)
                status = {};
        } else if (before != LinkState::Suspect && before != LinkState::Recovering) {
            m_status.clear();
            m_acknowledged.clear();
        }
        if (const ScopeEvent *began = m_loss ? m_log.find(m_loss->id) : nullptr;
            began && m_loss->how < Trouble::Lost && link.reason != drive::LinkReason::BoardReset) {
            m_log.setText(m_loss->id, // a moment that is over: its line is enough
                tr("%1, for %2", "trouble of the link, how long")
                    .arg(began->text, spanTime(now() - m_loss->since, QLocale())));
            m_loss.reset();
            break;
        }
        m_loss.reset();
        note(EventKind::Recovery, samplesNow(),
            link.reason == drive::LinkReason::BoardReset ? linkReasonText(link.reason) : word);
        break;
    case LinkState::Suspect:
    case LinkState::Recovering:
    case LinkState::Lost:
        noteLoss(link.state == LinkState::Lost     ? Trouble::Lost
                : link.state == LinkState::Suspect ? Trouble::Silent
                                                   : Trouble::Recovering,
            word);
        break;
    case LinkState::Closed:
        m_closing = wasThere;
        m_asked.clear();
        if (!m_device.portOpen()) // else its end is still to be told, and why
            port();
        break;
    case LinkState::Connecting:
        break;
    }
}

/// One line from the first doubt to the contact that ends it: it says the worst, at the time of the first.
void EventRecorder::noteLoss(Trouble how, const QString &text)
{
    if (!m_loss) {
        m_loss = {how, m_log.add(EventKind::Loss, samplesNow(), text), now()};
    } else if (how > m_loss->how) {
        m_loss->how = how;
        m_log.setText(m_loss->id, text);
    }
}

void EventRecorder::port()
{
    if (m_device.portOpen() || !std::exchange(m_closing, false))
        return;
    if (const session::PortError &error = m_device.portError();
        error.problem != session::PortProblem::None)
        noteLoss(Trouble::Port, portProblemText(error, m_device.endpoint().path));
    else
        note(EventKind::Command, samplesNow(), tr("Disconnected"));
}

void EventRecorder::replaced()
{
    const auto &board = m_device.identified();
    if (!board)
        return;
    QStringList names{deviceText(board->identity.firmware)};
    if (const QString version = deviceText(board->identity.version); !names[0].contains(version))
        names[0] += QLatin1Char(' ') + version;
    names.append(deviceText(board->identity.controlBoard));
    for (const std::string &motor : board->identity.motorNames)
        names.append(deviceText(motor));
    names.removeAll(QString());
    note(EventKind::Recovery, samplesNow(),
        tr("Another board: %1", "its names").arg(names.join(QStringLiteral(", "))));
}

void EventRecorder::stored(const capture::SampleBlock &block)
{
    hear();
    if (block.lostTicks <= 0 || !(m_tickHz > 0))
        return;
    const auto streaming = m_capture.streaming();
    const capture::Channel *channel =
        streaming.empty() ? nullptr : m_capture.channel(streaming.front());
    // A slow channel has a value for each group of the block, which may be none.
    const std::size_t count = channel && channel->fast() ? block.count : block.slow.size();
    if (!channel || channel->size() <= count)
        return; // nothing was there before: it is a beginning
    // Where the last sample before the gap ends.
    const capture::Index last = channel->end() - count - 1;
    const double seconds = capture::toSeconds(channel->holdUntil(last));
    const double length = static_cast<double>(block.lostTicks) / m_tickHz;
    note(EventKind::Loss, seconds, tr("%1 of samples lost").arg(exactTime(length, QLocale())));
}

} // namespace widgets
