#include "widgets/window/connect_bar.h"

#include "drive/protocol_table.h"
#include "widgets/base/device_text.h"
#include "widgets/base/lamp.h"
#include "widgets/base/look/line_icon.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/messages.h"
#include "widgets/base/steady_label.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/window/settings.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <span>
#include <utility>

namespace widgets {
namespace {

constexpr quint32 kBauds[] = {1843200, 921600, 460800, 230400, 115200};
constexpr quint32 kClocks_hz[] = {1'000'000, 2'000'000, 5'000'000, 10'000'000, 20'000'000};
constexpr int kConnectWidth = 110;
constexpr int kPortWidth = 120; ///< at least: a bar 960 px wide has no more for it
constexpr quint32 kSlowestBaud = 1200;
constexpr quint32 kFastestBaud = 12'000'000;
constexpr quint32 kSlowestClock_hz = 10'000;
constexpr quint32 kFastestClock_hz = 100'000'000;

/// A box that tells before its list opens, so that the list has what was plugged in meanwhile.
class PortBox : public QComboBox {
public:
    PortBox(std::function<void()> aboutToOpen, QWidget *parent)
        : QComboBox(parent)
        , m_aboutToOpen(std::move(aboutToOpen))
    {
    }
    void showPopup() override
    {
        m_aboutToOpen();
        QComboBox::showPopup();
    }

private:
    std::function<void()> m_aboutToOpen;
};

QString fromCore(std::string_view text) { return QString::fromUtf8(text); }

void fillProtocols(QComboBox &box)
{
    for (const drive::ProtocolRow &row : drive::protocolTable()) {
        const drive::ProtocolChoice &choice = row.choice;
        if (!choice.serial)
            continue;
        box.addItem(choice.title.empty() ? ConnectBar::tr("Auto") : fromCore(choice.title),
            fromCore(choice.word));
        box.setItemData(box.count() - 1,
            choice.title.empty() ? ConnectBar::tr("Finds out what the board speaks; nothing that "
                                                  "is sent for it can move a motor")
                                 : fromCore(choice.help),
            Qt::ToolTipRole);
    }
}

QString choiceText(const session::PortChoice &choice)
{
    const QString title = deviceText(choice.title);
    if (choice.kind == session::PortChoice::Kind::Simulator)
        return title.isEmpty() ? ConnectBar::tr("Simulated board")
                               : ConnectBar::tr("Simulated board (%1)").arg(title);
    const QString mark =
        choice.kind == session::PortChoice::Kind::StLink ? QStringLiteral("ST-LINK") : title;
    return mark.isEmpty() ? deviceText(choice.path)
                          : QStringLiteral("%1 (%2)").arg(deviceText(choice.path), mark);
}

} // namespace

ConnectBar::ConnectBar(Device &device, const session::PortSource &ports, QWidget *parent)
    : QWidget(parent)
    , m_device(device)
    , m_source(ports)
    , m_port(named(new PortBox([this] { refreshPorts(); }, this), "port", tr("Port")))
    , m_baud(named(new QComboBox(this), "baud", tr("Baud rate")))
    , m_protocol(named(new QComboBox(this), "protocol", tr("Protocol")))
    , m_connect(named(new QPushButton(this), "connect"))
    , m_portLamp(named(new Lamp(tr("Port"), this), "portLamp"))
    , m_boardLamp(named(new Lamp(tr("Board"), this), "boardLamp"))
    , m_firmware(named(new SteadyLabel(this), "firmware"))
    , m_board(named(new SteadyLabel(this), "boardName"))
    , m_motor(named(new QComboBox(this), "motor", tr("Motor")))
{
    setObjectName(QStringLiteral("connectBar"));
    m_port->setToolTip(tr("A port of the list, or a path that you type"));
    m_port->setEditable(true);
    m_port->setInsertPolicy(QComboBox::NoInsert);
    m_port->setMinimumWidth(kPortWidth);
    m_baud->setEditable(true);
    m_baud->setInsertPolicy(QComboBox::NoInsert);
    keepPlace(*m_baud);
    fillRates();
    m_protocol->setToolTip(tr("What the board speaks; Auto finds it out"));
    fillProtocols(*m_protocol);
    setLineIcon(*m_connect, "connect");
    for (const QString &word : {tr("Connect"), tr("Disconnect")}) { // it keeps its width
        m_connect->setText(word);
        m_connect->setMinimumWidth(
            std::max({kConnectWidth, m_connect->minimumWidth(), m_connect->sizeHint().width()}));
    }
    // Its place is kept: what is beside it does not move when a board with two motors comes. Names are whole in its
    // list.
    m_motor->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_motor->setMinimumContentsLength(static_cast<int>(tr("Motor %1").size()));
    keepPlace(*m_motor);
    m_motor->hide();
    for (QComboBox *choice : {m_port, m_baud, m_protocol, m_motor})
        new WheelGuard(choice);
    m_portLamp->setRoomFor(
        {tr("port open"), tr("port not open"), tr("port closed"), tr("replay, no port")});
    m_boardLamp->setRoomFor(
        QStringList{tr("board as recorded"), tr("no board")} + linkStateTexts());
    for (QLabel *label : {m_firmware, m_board}) // whatever a board says
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_board->setEnabled(false);

    auto *lamps = bare(new QVBoxLayout, kFineGrid);
    lamps->addWidget(m_portLamp);
    lamps->addWidget(m_boardLamp);
    auto *who = bare(new QVBoxLayout, kFineGrid);
    who->addWidget(m_firmware);
    who->addWidget(m_board);
    auto *layout = bare(new QHBoxLayout(this), kGrid);
    layout->addWidget(m_port);
    layout->addWidget(m_baud);
    layout->addWidget(m_protocol);
    layout->addWidget(m_connect);
    layout->addSpacing(kHalfGrid);
    layout->addLayout(lamps);
    layout->addSpacing(kHalfGrid);
    layout->addLayout(who, 1);
    layout->addWidget(m_motor);

    connect(m_port, &QComboBox::editTextChanged, this, &ConnectBar::updateRate);
    connect(m_connect, &QPushButton::clicked, this, &ConnectBar::connectOrDisconnect);
    for (const QComboBox *typed : {m_port, m_baud})
        connect(typed->lineEdit(), &QLineEdit::returnPressed, m_connect, &QPushButton::click);
    connect(
        m_motor, &QComboBox::activated, this, [this](int index) { m_device.setMotor(index + 1); });
    connect(&device, &Device::linkStateChanged, this, &ConnectBar::updateLink);
    connect(&device, &Device::portStateChanged, this, &ConnectBar::updateLink);
    connect(&device, &Device::identityChanged, this, &ConnectBar::updateIdentity);
    fillPorts(session::simulatedBoards());
    updateLink();
    updateIdentity();
}

void ConnectBar::refreshPorts()
{
    if (!m_pathBefore.isEmpty())
        return; // the name of a recording stands in the place of a port
    fillPorts(session::portChoices(m_source));
    // The box may have been laid out before it had its ports.
    m_port->setSizeAdjustPolicy(QComboBox::AdjustToContents);
}

void ConnectBar::fillPorts(const QList<session::PortChoice> &choices)
{
    const QString before = path();
    m_port->clear();
    for (const session::PortChoice &choice : choices)
        m_port->addItem(choiceText(choice), choice.path);
    for (const QString &path : std::as_const(m_typed))
        if (m_port->findData(path) < 0)
            m_port->addItem(deviceText(path), path);
    if (!before.isEmpty())
        setEndpoint(before, 0);
}

void ConnectBar::setTyped(const QStringList &paths)
{
    m_typed = paths;
    fillPorts(session::simulatedBoards());
}

void ConnectBar::setEndpoint(const QString &path, quint32 baud)
{
    const int found = m_port->findData(path);
    if (found >= 0)
        m_port->setCurrentIndex(found);
    else
        m_port->setEditText(path);
    if (baud > 0)
        m_baud->setEditText(QString::number(baud));
    m_port->lineEdit()->home(false); // of a name that is longer than its box its beginning
}

QString ConnectBar::path() const
{
    if (!m_pathBefore.isEmpty())
        return m_pathBefore;
    const QString text = m_port->currentText().trimmed();
    const int index = m_port->findText(text);
    return index >= 0 ? m_port->itemData(index).toString() : text;
}

ConnectBar::Rate ConnectBar::rate() const
{
    const session::Endpoint endpoint = session::endpointFor(path(), 0);
    return drive::rowOf(endpoint.protocol).choice.serial   ? Rate::Baud
        : endpoint.kind == session::Endpoint::Kind::Serial ? Rate::Clock
                                                           : Rate::None;
}

/// What is chosen or typed stays.
void ConnectBar::fillRates()
{
    const bool clock = m_rate == Rate::Clock;
    const QString text = m_baud->currentText();
    m_baud->clear();
    for (const quint32 one : clock ? std::span<const quint32>(kClocks_hz) : kBauds)
        m_baud->addItem(QString::number(one), one);
    if (!text.isEmpty())
        m_baud->setEditText(text);
    const QString name = clock ? tr("Clock [Hz]") : tr("Baud rate");
    m_baud->setAccessibleName(name);
    m_baud->setToolTip(name);
}

void ConnectBar::updateRate()
{
    const Rate before = std::exchange(m_rate, rate());
    if (m_rate == before)
        return;
    m_baud->setHidden(m_rate == Rate::None);
    m_protocol->setEnabled(m_rate == Rate::Baud && !connecting()); // elsewhere only one is spoken
    fillRates();
}

quint32 ConnectBar::baud() const
{
    bool ok = false;
    const QString chosen = m_baudBefore.isEmpty() ? m_baud->currentText() : m_baudBefore;
    const quint32 baud = chosen.trimmed().toUInt(&ok);
    const bool clock = m_rate == Rate::Clock;
    const quint32 least = clock ? kSlowestClock_hz : kSlowestBaud;
    return ok && baud >= least && baud <= (clock ? kFastestClock_hz : kFastestBaud) ? baud : 0;
}

void ConnectBar::setProtocol(const QString &word)
{
    if (const int found = m_protocol->findData(word); found >= 0)
        m_protocol->setCurrentIndex(found);
}

QString ConnectBar::protocol() const { return m_protocol->currentData().toString(); }

void ConnectBar::connectOrDisconnect()
{
    if (connecting()) {
        Q_EMIT disconnectWanted();
        return;
    }
    // Where the line has none, what stands in the hidden field does not matter.
    const quint32 told = m_rate == Rate::None ? kBauds[0] : baud();
    session::Endpoint endpoint = session::endpointFor(
        path(), told, drive::protocolOf(protocol().toStdString()).value_or(drive::Protocol::Auto));
    if (endpoint.path.isEmpty()) {
        Q_EMIT refused(tr("Choose a port, or type its path."));
        return;
    }
    if (endpoint.baud == 0) {
        const QString typed = deviceText(m_baud->currentText());
        Q_EMIT refused(m_rate == Rate::Clock
                ? tr("\"%1\" is not an SPI clock from 10 kHz to 100 MHz, in Hz.").arg(typed)
                : tr("\"%1\" is not a baud rate.").arg(typed));
        return;
    }
    const auto open = [this, endpoint] {
        if (connecting())
            return; // meanwhile
        m_wanted = true;
        if (m_port->findData(endpoint.path) < 0) {
            m_typed.prepend(endpoint.path);
            m_typed = m_typed.mid(0, kMostTyped);
            m_port->addItem(deviceText(endpoint.path), endpoint.path);
        }
        if (endpoint.baud != baud()) { // some simulated boards have their own
            m_baudBefore = m_baud->currentText();
            m_baud->setEditText(QString::number(endpoint.baud));
        }
        m_device.open(endpoint);
        updateLink();
    };
    if (m_beforeOpening)
        m_beforeOpening(open);
    else
        open();
}

void ConnectBar::disconnectNow()
{
    m_wanted = false;
    m_device.close();
    updateLink();
}

void ConnectBar::openSimulator()
{
    if (connecting())
        return;
    setEndpoint(QLatin1String(session::kSimulatorPath), kBauds[0]);
    connectOrDisconnect();
}

void ConnectBar::openReplay(const QString &path)
{
    if (connecting())
        return;
    m_pathBefore = this->path();
    m_port->setEditText(fileNameText(path));
    session::Endpoint endpoint;
    endpoint.kind = session::Endpoint::Kind::Trace;
    endpoint.path = path;
    m_wanted = true;
    m_device.open(endpoint);
    updateLink();
}

void ConnectBar::focusPort()
{
    m_port->setFocus(Qt::OtherFocusReason);
    m_port->showPopup();
}

void ConnectBar::updateLink()
{
    const bool open = m_device.portOpen();
    const bool problem = m_device.portError().problem != session::PortProblem::None;
    const bool comesBack = m_device.portError().problem == session::PortProblem::Unplugged
        || m_device.portError().problem == session::PortProblem::TakenOver;
    if (!open && problem && !m_device.endpoint().path.isEmpty() && !comesBack)
        m_wanted = false;
    const bool replay = replaying(m_device); // there is no port then, and no board
    m_portLamp->show(open && !replay ? Lamp::Light::On
            : problem                ? Lamp::Light::Bad
                                     : Lamp::Light::Off,
        open && replay ? tr("replay, no port")
            : open     ? tr("port open")
            : problem  ? tr("port not open")
                       : tr("port closed"));
    using drive::LinkState;
    const LinkState state = m_device.link().state;
    const bool recorded = replay && state == LinkState::Connected;
    m_boardLamp->show(recorded ? Lamp::Light::Off : Lamp::lightOf(state),
        recorded                         ? tr("board as recorded")
            : state == LinkState::Closed ? tr("no board")
                                         : linkStateText(m_device.link()));
    m_connect->setText(connecting() ? tr("Disconnect") : tr("Connect"));
    m_connect->setToolTip(connecting() ? tr("Closes the port (Ctrl+D)")
                                       : tr("Opens the port and looks for a board (Ctrl+D)"));
    if (!connecting() && !m_pathBefore.isEmpty())
        setEndpoint(std::exchange(m_pathBefore, QString()), 0);
    if (!connecting() && !m_baudBefore.isEmpty())
        m_baud->setEditText(std::exchange(m_baudBefore, QString()));
    m_port->setEnabled(!connecting());
    m_baud->setEnabled(!connecting());
    m_protocol->setEnabled(!connecting() && m_rate == Rate::Baud);
    updateNames();
}

/// Which board it is; unknown at a port that is closed or where none answers.
void ConnectBar::updateNames()
{
    const auto &identified = m_device.identified();
    if (!identified || m_device.link().state == drive::LinkState::Closed
        || noBoardFound(m_device.link())) {
        m_firmware->clear();
        m_board->clear();
        m_boardLamp->setToolTip({});
        return;
    }
    const drive::Identity &identity = identified->identity;
    const QString firmware = deviceText(identity.firmware);
    const QString version = deviceText(identity.version);
    m_firmware->setText(
        firmware.contains(version) ? firmware : QStringLiteral("%1 %2").arg(firmware, version));
    m_firmware->setToolTip(deviceToolTip(identity.firmware) + QStringLiteral("<br>")
        + deviceToolTip(identity.protocol)
        + (identity.evidence.empty() ? QString()
                                     : QStringLiteral("<br>") + deviceToolTip(identity.evidence)));
    QStringList boards{deviceText(identity.controlBoard)};
    for (const std::string &power : identity.powerBoards)
        boards.append(deviceText(power));
    boards.removeAll(QString());
    boards.removeDuplicates();
    m_board->setText(boards.join(QStringLiteral(" + ")));
    m_board->setToolTip(boards.join(QStringLiteral(" + ")).toHtmlEscaped());
    // Where the bar has no room for them.
    m_boardLamp->setToolTip(m_firmware->toolTip() + QStringLiteral("<br>") + m_board->toolTip());
}

void ConnectBar::updateIdentity()
{
    updateNames();
    const auto &identified = m_device.identified();
    if (!identified) {
        m_motor->hide();
        return;
    }
    const drive::Identity &identity = identified->identity;
    m_motor->clear();
    for (int motor = 1; motor <= identity.motors; ++motor) {
        const auto i = static_cast<std::size_t>(motor - 1);
        const QString name =
            i < identity.motorNames.size() ? deviceText(identity.motorNames[i]) : QString();
        m_motor->addItem(name.isEmpty()
                ? tr("Motor %1").arg(QString::number(motor))
                : tr("Motor %1: %2", "number, name").arg(QString::number(motor), name));
    }
    m_motor->setCurrentIndex(m_device.motor() - 1); // told anew, it is still the chosen one
    m_motor->setVisible(identity.motors > 1);
}

} // namespace widgets
