// ConnectBar: where to connect to, whether the port is open, whether a board answers, and who it is. Two lamps, since
// an open port is not yet a board.
#pragma once

#include "session/transports/port_list.h"
#include "widgets/base/device.h"

#include <QStringList>
#include <QWidget>

#include <functional>

class QComboBox;
class QLabel;
class QPushButton;

namespace widgets {

class Lamp;
class SteadyLabel;

class ConnectBar : public QWidget {
    Q_OBJECT
public:
    /// @param ports  where the list of serial ports comes from; outlives the bar
    ConnectBar(Device &device, const session::PortSource &ports, QWidget *parent = nullptr);

    void setEndpoint(const QString &path, quint32 baud); ///< "sim" for the simulated board
    QString path() const; ///< as chosen or typed
    quint32 baud() const; ///< of an SPI device its clock in Hz; 0 if the text is no such rate
    /// Ports that were typed and connected to: they stay in the list beside those of the system, the newest first.
    void setTyped(const QStringList &paths);
    const QStringList &typed() const { return m_typed; }
    void setProtocol(const QString &word); ///< as drive::wordOf(); unknown ones are passed over
    QString protocol() const;
    /// Called instead of opening a port, with what opens it; a replay is asked about before it comes here.
    void setBeforeOpening(std::function<void(std::function<void()>)> ask)
    {
        m_beforeOpening = std::move(ask);
    }
    /// A connection is open, or wanted and being looked for.
    bool connecting() const { return m_wanted || m_device.portOpen(); }

public Q_SLOTS:
    void connectOrDisconnect(); ///< Ctrl+D
    void disconnectNow(); ///< whatever the motors do
    /// Asks the system, which takes some ten milliseconds; until then only simulated boards are listed.
    void refreshPorts();
    void openSimulator();
    void openReplay(const QString &path); ///< of a recording; nothing while connected
    void focusPort();

Q_SIGNALS:
    void disconnectWanted(); ///< not done: the motors come first
    void refused(const QString &sentence); ///< what was typed cannot be used

private:
    /// What the line at the chosen port is told.
    enum class Rate : std::uint8_t {
        Baud,
        Clock, ///< in Hz, of an SPI device
        None, ///< a simulated board whose line has none
    };
    Rate rate() const;
    void fillRates();
    void updateRate();
    void fillPorts(const QList<session::PortChoice> &choices);
    void updateLink();
    void updateNames();
    void updateIdentity();

    Device &m_device;
    const session::PortSource &m_source;
    QComboBox *m_port;
    QComboBox *m_baud;
    QComboBox *m_protocol;
    QPushButton *m_connect;
    Lamp *m_portLamp;
    Lamp *m_boardLamp;
    SteadyLabel *m_firmware;
    SteadyLabel *m_board;
    QComboBox *m_motor;
    std::function<void(std::function<void()>)> m_beforeOpening;
    QStringList m_typed;
    QString m_pathBefore; ///< while a recording is shown in its place
    QString m_baudBefore; ///< as chosen, while a connection at another one is shown
    Rate m_rate = Rate::Baud; ///< whose rates are listed
    bool m_wanted = false; ///< the user asked for a connection and has not taken that back
};

} // namespace widgets
