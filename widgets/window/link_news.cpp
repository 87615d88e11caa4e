#include "widgets/window/link_news.h"

#include "widgets/base/device.h"
#include "widgets/base/messages.h"

#include <utility>

namespace widgets {

LinkNews::LinkNews(const Device &device, std::function<bool()> connecting,
    std::function<bool()> wereAtRest, Banner &banner, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_connecting(std::move(connecting))
    , m_wereAtRest(std::move(wereAtRest))
    , m_banner(banner)
{
}

void LinkNews::say(Banner::Kind kind, const QString &sentence)
{
    m_told = kind == Banner::Kind::Note ? Told::Done : Told::Other;
    m_banner.say(kind, sentence);
}

void LinkNews::setLeft(const QString &sentence, QWidget *act)
{
    m_left = sentence;
    m_giveBack = act;
    if (!sentence.isEmpty() && !tellsLoss() && !m_reset) // a board that was reset is met again
        sayLeft();
    else if (sentence.isEmpty() && m_told == Told::Left)
        clear();
}

void LinkNews::givenBack(const QString &sentence)
{
    if (m_left.isEmpty())
        say(Banner::Kind::Note, sentence);
    else if (!tellsLoss())
        sayLeft(sentence);
}

void LinkNews::sayLeft(const QString &first)
{
    m_banner.say(Banner::Kind::Warning,
        first.isEmpty() ? m_left : QStringLiteral("%1 %2").arg(first, m_left), m_giveBack);
    m_told = Told::Left;
}

/// Of what is over; what is left is not.
void LinkNews::clear()
{
    m_banner.clear();
    m_told = Told::Other;
    if (!m_left.isEmpty())
        sayLeft();
}

void LinkNews::portChanged()
{
    if (m_device.portOpen() && m_told == Told::Done) {
        m_banner.clear();
        m_told = Told::Other;
    }
    follow();
}

void LinkNews::linkChanged()
{
    const drive::LinkChanged link = m_device.link();
    if (!alive())
        m_reset = false;
    if (link.state == drive::LinkState::Connected && link.reason == drive::LinkReason::BoardReset) {
        m_reset = true;
        m_said.clear(); // also if it is the second one
    }
    follow();
}

void LinkNews::armedChanged(bool armed)
{
    if (armed)
        m_reset = false;
    follow();
    if (armed && !m_left.isEmpty())
        sayLeft();
}

/// Connected, though the board may be silent for a moment.
bool LinkNews::alive() const
{
    const drive::LinkState state = m_device.link().state;
    return state == drive::LinkState::Connected || state == drive::LinkState::Suspect
        || state == drive::LinkState::Recovering;
}

void LinkNews::follow()
{
    const Message now = message();
    const bool notOfTheLink = m_told == Told::Other || m_told == Told::Done || m_told == Told::Left;
    if (!now.sentence.isEmpty()) {
        // What was read and closed is not told again by the same happening; what is bad comes back from behind other
        // words.
        if (now.sentence == m_said && (!notOfTheLink || now.kind != Banner::Kind::Bad))
            return;
        m_banner.say(now.kind, now.sentence);
        m_said = now.sentence;
        m_told = now.told;
        return;
    }
    // Contact that was lost stays told until there is contact again, not until the next attempt.
    if (tellsLoss() && m_device.identified() && !m_device.answering() && m_connecting())
        return;
    m_said.clear();
    if (!notOfTheLink)
        clear();
}

LinkNews::Message LinkNews::message() const
{
    using drive::LinkState;
    const session::PortError error = m_device.portError();
    const drive::LinkChanged link = m_device.link();
    const bool known = m_device.identified().has_value();
    const auto ofMotors = [this] {
        return motorsOutOfReachText(m_wereAtRest(), m_device.identified()->identity.watchdog);
    };
    if (!m_device.portOpen() && error.problem != session::PortProblem::None) {
        const QString problem = portProblemText(error, m_device.endpoint().path);
        if (error.problem == session::PortProblem::Unplugged)
            return {Banner::Kind::Bad,
                known ? QStringLiteral("%1 %2").arg(problem, ofMotors()) : problem, Told::Loss};
        return {Banner::Kind::Bad, problem,
            error.problem == session::PortProblem::TakenOver ? Told::Loss : Told::Link};
    }
    if (link.state == LinkState::Lost && known)
        return {Banner::Kind::Bad,
            tr("Link lost. %1 %2").arg(ofMotors(), linkReasonText(link.reason)), Told::Loss};
    if (link.state == LinkState::Lost)
        return {Banner::Kind::Bad, linkReasonText(link.reason), Told::Link};
    if (link.state == LinkState::Connecting && link.reason != drive::LinkReason::None)
        return {Banner::Kind::Note, linkReasonText(link.reason), Told::Link};
    if (m_reset)
        return {Banner::Kind::Warning, linkReasonText(drive::LinkReason::BoardReset), Told::Link};
    if (known && alive() && !m_device.identified()->identity.knownFirmware)
        return {Banner::Kind::Note,
            tr("This firmware is not known: registers are shown raw and nothing is written."),
            Told::Link};
    return {};
}

} // namespace widgets
