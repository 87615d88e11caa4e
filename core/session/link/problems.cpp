#include "session/link/problems.h"

#include <array>

namespace session {
namespace {

// Both in the order of their enumeration.

constexpr std::array kLinkProblems{"",
    QT_TRANSLATE_NOOP("Link",
        "The port is open but no board answers. Check the baud rate, the cable and the board's "
        "power."),
    QT_TRANSLATE_NOOP("Link",
        "Bytes arrive but make no sense. The baud rate or the protocol is probably not the "
        "board's: try another one, and check the board's firmware."),
    QT_TRANSLATE_NOOP("Link",
        "The board answers but does not agree on the settings of the link. Reset the board and "
        "connect again."),
    QT_TRANSLATE_NOOP("Link", "The board went silent. Check the cable and the board's power."),
    QT_TRANSLATE_NOOP("Link",
        "Contact to the board could not be restored. Check the cable and the board's power, reset "
        "the board and connect again."),
    QT_TRANSLATE_NOOP("Link", "The board was reset."),
    QT_TRANSLATE_NOOP("Link", "The board speaks the protocol of older firmware."),
    QT_TRANSLATE_NOOP(
        "Link", "The drive does not say that it is ready. Check its power and the ready line."),
    QT_TRANSLATE_NOOP("Link",
        "Nothing drives the line to this computer. Check the wiring, the chip select and the "
        "drive's power."),
    QT_TRANSLATE_NOOP("Link",
        "Asking whether the board speaks the protocol of newer firmware; if no answer comes, that "
        "of older firmware is next."),
    QT_TRANSLATE_NOOP(
        "Link", "No answer in the protocol of newer firmware: asking in that of older firmware."),
    QT_TRANSLATE_NOOP("Link", "The board speaks the protocol of newer firmware.")};
static_assert(kLinkProblems.size() == std::size_t(drive::LinkReason::OtherProtocol) + 1);

/// %1 is the port, %2 the detail in brackets. Unplugged shows none: the system's words are left-overs of another call.
constexpr std::array kPortProblems{"",
    QT_TRANSLATE_NOOP("Link", "There is no port %1. Plug the board in, or choose another port."),
    QT_TRANSLATE_NOOP("Link",
        "You may not use %1. Join the group that owns it (serial ports: \"sudo usermod -aG dialout "
        "$USER\"), then log out and in again."),
    QT_TRANSLATE_NOOP("Link", "%1 is in use%2. Close what uses it, then connect again."),
    QT_TRANSLATE_NOOP("Link", "%1 refuses this baud rate. Choose another one."),
    QT_TRANSLATE_NOOP("Link", "%1 was unplugged. Check the cable."),
    QT_TRANSLATE_NOOP("Link",
        "This program did not run for a while. Its guardian has told every motor on %1 to stop, "
        "without evidence that they did."),
    QT_TRANSLATE_NOOP("Link", "The recording %1 cannot be read. Choose another file."),
    QT_TRANSLATE_NOOP("Link", "%1 cannot be opened%2. Check the cable, then connect again.")};
static_assert(kPortProblems.size() == std::size_t(PortProblem::Other) + 1);

} // namespace

QString linkProblemText(drive::LinkReason reason, ProblemWords wordsOf)
{
    return wordsOf(kLinkProblems.at(static_cast<std::size_t>(reason)));
}

QString portErrorText(const PortError &why, const QString &port, ProblemWords wordsOf)
{
    if (why.problem == PortProblem::None)
        return {};
    const QString detail =
        why.detail.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(why.detail);
    const QString text = wordsOf(kPortProblems.at(static_cast<std::size_t>(why.problem)));
    return text.contains(QLatin1String("%2")) ? text.arg(port, detail) : text.arg(port);
}

} // namespace session
