#include "widgets/window/status_strip.h"

#include "drive/protocol_table.h"
#include "widgets/base/device_text.h"
#include "widgets/base/lamp.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/messages.h"
#include "widgets/base/steady_label.h"
#include "widgets/base/value_text.h"
#include "widgets/control/fault_texts.h"

#include <QResizeEvent>

#include <initializer_list>

namespace widgets {
namespace {

constexpr Milliseconds kRatePeriod{1000};
constexpr std::uint64_t kMostCounted = 999'999; ///< that is written out in the line
constexpr int kLongestPlace = 33; ///< characters of a port that the line has room for
constexpr int kPartMargin = kGrid; ///< at either side
constexpr int kPartGap = 6; ///< of QStatusBar, between two parts

/// A number that keeps to its room; the tool tip has it whole.
QString countText(std::uint64_t count)
{
    return count > kMostCounted ? QStringLiteral("> ") + QString::number(kMostCounted)
                                : QString::number(count);
}

QStringList motorTexts()
{
    using drive::MotorState;
    QStringList all;
    for (const MotorState state :
        {MotorState::Unknown, MotorState::Idle, MotorState::Starting, MotorState::Running,
            MotorState::Stopping, MotorState::FaultNow, MotorState::FaultOver})
        all.append(StatusStrip::tr("Motor %1: %2", "number, state")
                       .arg(QStringLiteral("0"), motorStateText(state)));
    return all;
}

} // namespace

StatusStrip::StatusStrip(Device &device, QWidget *parent)
    : QStatusBar(parent)
    , m_device(device)
    , m_link(new Lamp(tr("Link"), this))
{
    setObjectName(QStringLiteral("statusStrip"));
    setSizeGripEnabled(false);
    setContentsMargins(kGrid, 0, kGrid, 0);
    addWidget(m_link);
    const QString most = countText(kMostCounted + 1);
    m_sizes = addPart("sizes",
        {tr("%1 / %2 / %3 B", "sizes in bytes: request, answer, stream")
                .arg(QStringLiteral("2048"), QStringLiteral("4096"), QStringLiteral("8128"))});
    m_motor = addPart("statusMotor", motorTexts());
    m_faults = addPart("statusFaults", {tr("Faults: %1", "how many").arg(QStringLiteral("00"))});
    m_rate = addPart("statusRate",
        {tr("%1 kB/s (%2 %)", "received, percent of the link")
                .arg(QStringLiteral("0000.0"), QStringLiteral("100"))});
    m_lost = addPart("statusLost", {tr("Lost: %1", "control periods without samples").arg(most)});
    m_bad = addPart("statusBad", {tr("Bad packets: %1").arg(most)});
    m_watchdog = addPart("statusWatchdog",
        {tr("Drive watchdog: none"), tr("Drive watchdog: %1 ms").arg(QStringLiteral("0000"))});
    m_sizes->setToolTip(tr("Negotiated packet sizes: request / answer / stream"));
    showHeld({});

    connect(&device, &Device::linkStateChanged, this, &StatusStrip::updateLink);
    connect(&device, &Device::portStateChanged, this, &StatusStrip::updateLink);
    connect(&device, &Device::identityChanged, this, &StatusStrip::updateLink);
    connect(&device, &Device::statusChanged, this, &StatusStrip::updateMotor);
    connect(&device, &Device::linkStateChanged, this, &StatusStrip::updateMotor);
    connect(&device, &Device::motorChanged, this, &StatusStrip::updateMotor);
    connect(&device, &Device::countersChanged, this, &StatusStrip::updateCounters);
    updateLink();
    updateMotor();
    updateCounters();
}

SteadyLabel *StatusStrip::addPart(const char *objectName, const QStringList &room)
{
    auto *label = new SteadyLabel(this);
    label->setObjectName(QLatin1String(objectName));
    label->setContentsMargins(kPartMargin, 0, kPartMargin, 0);
    label->setRoomFor(room);
    label->setMinimumWidth(1); // the window may be narrower than all of them
    addWidget(label);
    return label;
}

void StatusStrip::resizeEvent(QResizeEvent *event)
{
    QStatusBar::resizeEvent(event);
    fit();
}

/// By what they have room for, not by what they say: nothing comes and goes while values change.
void StatusStrip::fit()
{
    int left = contentsRect().width() - m_link->sizeHint().width() - kPartGap;
    for (SteadyLabel *part : {m_motor, m_faults, m_watchdog, m_lost, m_rate, m_bad, m_sizes}) {
        left -= part->sizeHint().width() + kPartGap;
        part->setVisible(left >= 0);
    }
    tellHidden();
}

void StatusStrip::tellHidden()
{
    QStringList all;
    for (const SteadyLabel *part : {m_motor, m_faults, m_watchdog, m_lost, m_rate, m_bad, m_sizes})
        if (part->isHidden() && !part->text().isEmpty())
            all.append(part->text());
    m_link->setToolTip(all.join(QLatin1Char('\n')));
}

void StatusStrip::showHeld(const QString &text)
{
    const QString rate = tr("Bytes received a second, and their share of what the link can carry");
    m_rate->setToolTip(text.isEmpty() ? rate : rate + QLatin1Char('\n') + text);
}

/// Of the port that is open, or was last.
QString StatusStrip::endpointText() const
{
    const session::Endpoint &endpoint = m_device.endpoint();
    if (replaying(m_device))
        return tr("replay of %1").arg(fileNameText(endpoint.path));
    const QString where = endpoint.kind == session::Endpoint::Kind::Simulator
        ? tr("simulated board")
        : deviceText(endpoint.path);
    const bool serial = drive::rowOf(endpoint.protocol).choice.serial;
    if (!serial && endpoint.kind == session::Endpoint::Kind::Simulator) // whose line has no rate
        return where;
    return QStringLiteral("%1 @ %2\u202f%3")
        .arg(where, QString::number(endpoint.baud), serial ? tr("baud") : QStringLiteral("Hz"));
}

void StatusStrip::updateLink()
{
    const QString where = endpointText();
    QStringList room = linkStateTexts();
    room.append(where.left(kLongestPlace));
    m_link->setRoomFor(room);
    fit();
    const QString text = m_device.portOpen() ? where : linkStateText(m_device.link());
    m_link->show(Lamp::lightOf(m_device.link().state), text);
    updateWatchdog();
    updateCounters();
    const auto identified = connected();
    m_sizes->setText(identified ? tr("%1 / %2 / %3 B", "sizes in bytes: request, answer, stream")
                                      .arg(QString::number(identified->requestBytes),
                                          QString::number(identified->responseBytes),
                                          QString::number(identified->streamBytes))
                                : QString());
    tellHidden();
}

/// What a board said of itself is of its connection.
std::optional<drive::Identified> StatusStrip::connected() const
{
    return m_device.portOpen() ? m_device.identified() : std::nullopt;
}

void StatusStrip::updateWatchdog()
{
    const auto identified = connected();
    if (!identified) {
        m_watchdog->clear();
        m_watchdog->setToolTip(QString());
    } else if (const auto &watchdog = identified->identity.watchdog) {
        m_watchdog->setText(tr("Drive watchdog: %1 ms").arg(QString::number(watchdog->count())));
        m_watchdog->setToolTip(
            tr("This drive stops its motor by itself when it has not been fed for that time. It "
               "needs a sign of life from a window that responds and is armed: disarming stops "
               "what turns. It is not a safety function."));
    } else {
        m_watchdog->setText(tr("Drive watchdog: none"));
        m_watchdog->setToolTip(tr("This drive has no communication time-out: when the link is "
                                  "gone, the motor goes on turning."));
    }
}

void StatusStrip::updateMotor()
{
    if (!m_device.statusIsNow(m_device.motor())) {
        m_motor->clear();
        m_faults->clear();
        return;
    }
    const drive::MotorStatus status = m_device.status(m_device.motor());
    m_motor->setText(tr("Motor %1: %2", "number, state")
                         .arg(QString::number(m_device.motor()), motorStateText(status.state)));
    m_faults->setText(
        tr("Faults: %1", "how many")
            .arg(QString::number(status.faultsNow.size() + faultsOver(status).size())));
    tellHidden();
}

void StatusStrip::updateCounters()
{
    const drive::LinkCounters &counters = m_device.counters();
    const bool open = m_device.portOpen();
    m_lost->setText(open ? tr("Lost: %1", "control periods without samples")
                               .arg(countText(counters.streamLostTicks))
                         : QString());
    QString lost = tr("Control periods that no packet holds") + QStringLiteral(": ")
        + QString::number(counters.streamLostTicks);
    if (m_device.droppedForDisplay() > 0)
        lost += QLatin1Char('\n')
            + tr("%1 samples were recorded by the board but came too fast to be shown.")
                  .arg(QString::number(m_device.droppedForDisplay()));
    m_lost->setToolTip(lost);
    m_bad->setText(open ? tr("Bad packets: %1").arg(countText(counters.badPackets)) : QString());
    m_bad->setToolTip(
        open ? tr("Bad packets: %1").arg(QString::number(counters.badPackets)) : QString());
    tellHidden();
}

void StatusStrip::refresh(Milliseconds now)
{
    if (now - m_lastTime < kRatePeriod)
        return;
    const std::uint64_t bytes = m_device.counters().bytesIn;
    const double seconds = static_cast<double>((now - m_lastTime).count()) / 1000.0;
    const double perSecond =
        bytes >= m_lastBytes ? static_cast<double>(bytes - m_lastBytes) / seconds : 0.0;
    m_lastTime = now;
    m_lastBytes = bytes;
    const double link = m_device.streamLimits().linkBytesPerSecond;
    if (!m_device.portOpen() || link <= 0.0)
        m_rate->clear();
    else
        m_rate->setText(
            tr("%1 kB/s (%2 %)", "received, percent of the link")
                .arg(numberText(perSecond / 1000.0, 1), numberText(100.0 * perSecond / link, 0)));
    updateCounters();
}

} // namespace widgets
