// The ports the user can choose from: the simulated board first, then the boards' own USB ports,
// then all others.
#pragma once

#include <QList>
#include <QString>

namespace session {

/// A serial port as the system describes it.
struct SystemPort {
    QString path; ///< e.g. "/dev/ttyACM0", "COM3"
    QString description, manufacturer, serialNumber; ///< the device's words
    quint16 vendor = 0, product = 0; ///< USB; 0: none
};

/// Where system ports come from; the tests bring their own.
class PortSource {
public:
    virtual ~PortSource() = default;
    virtual QList<SystemPort> ports() const = 0;
};

class SystemPortSource : public PortSource {
public:
    QList<SystemPort> ports() const override;
};

struct PortChoice {
    enum class Kind : std::uint8_t {
        Simulator, ///< path is "sim", or "sim:" and what it speaks; the title says that
        StLink, ///< the debugger on ST's boards, whose serial port leads to the motor's controller
        Serial,
    };
    Kind kind = Kind::Serial;
    QString path;
    QString title; ///< the device's words, "" if there are none: plain text, never rich
    bool operator==(const PortChoice &) const = default;
};

/// The name of the simulated board among the ports. With ":" and a profile it is another one, e.g. "sim:powerpc".
inline constexpr char kSimulatorPath[] = "sim";

bool isStLink(quint16 vendor, quint16 product);
QList<PortChoice> simulatedBoards(); ///< known at once, while the system is asked for its ports
QList<PortChoice> portChoices(const PortSource &source = SystemPortSource());

} // namespace session
