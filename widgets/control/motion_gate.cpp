#include "widgets/control/motion_gate.h"

#include "catalog/control_mode.h"
#include "drive/set_points/shaft_position.h"
#include "widgets/base/device_text.h"
#include "widgets/base/messages.h"
#include "widgets/base/value_text.h"
#include "widgets/control/setpoints/shaft_move.h"

#include <cmath>
#include <numbers>

namespace widgets {
namespace {

constexpr int kAmpDecimals = 2;
constexpr std::chrono::milliseconds kJogRamp{200};
constexpr std::chrono::milliseconds kPatience{1000};

int motorOf(const drive::WishContent &act)
{
    return std::visit(
        [](const auto &what) {
            if constexpr (requires { what.motor; })
                return what.motor;
            else
                return 1;
        },
        act);
}

QString targetText(const drive::StartTarget &target)
{
    const QChar space(0x202f);
    return target.rpm ? numberText(*target.rpm, 0) + space + MotionGate::tr("rpm")
        : target.amps ? numberText(*target.amps, kAmpDecimals) + space + QLatin1Char('A')
                      : QString();
}

QString shaftText(std::optional<double> radians)
{
    constexpr double kDegreesPerRad = 180.0 / std::numbers::pi;
    return radians ? ShaftMove::angleText(*radians * kDegreesPerRad)
                   : MotionGate::tr("not known", "the old value");
}

bool isStart(const drive::WishContent &act)
{
    const auto *command = std::get_if<drive::Command>(&act);
    return command != nullptr && command->action == drive::MotorAction::Start;
}

QString silentText()
{
    return MotionGate::tr("The question was withdrawn, and nothing was sent: the board stopped "
                          "answering for a moment. Press again to be asked again.");
}

} // namespace

MotionGate::MotionGate(Device &device, RegisterModel &registers, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_registers(registers)
{
    connect(&device, &Device::wishEnded, this, &MotionGate::ended);
    connect(&device, &Device::identityChanged, this, [this] {
        forgetStarts();
        m_agreedSteps.clear();
        withdraw();
    });
    connect(&device, &Device::motorChanged, this, &MotionGate::withdraw);
    const auto stopped = [this] {
        forgetStarts(); // what the board still holds may surprise: the next start is asked about
        withdraw();
    };
    connect(&device, &Device::stopWished, this, stopped);
    connect(&device, &Device::stopAdvanced, this, [stopped](const drive::StopProgress &progress) {
        if (progress.word == drive::StopWord::Requested)
            stopped(); // also where the user asked for none: a window that hung, an experiment
    });
    connect(&device, &Device::armedStateChanged, this, [this](bool armed) {
        if (armed)
            return;
        m_agreedSteps.clear();
        withdraw();
    });
    connect(&device, &Device::linkStateChanged, this, &MotionGate::linkChanged);
    m_patience.setSingleShot(true);
    m_patience.setInterval(kPatience);
    connect(&m_patience, &QTimer::timeout, this, [this] { withdrawAndTell(silentText()); });
}

/// Also of the starts whose outcome is still to come: they belong to what was before.
void MotionGate::forgetStarts()
{
    m_started.clear();
    m_agreed.clear();
    for (Open &open : m_open)
        open.startOf = 0;
}

/// A short gap in the link leaves the question open: questions that return are answered without being read.
void MotionGate::linkChanged()
{
    using drive::LinkState;
    if (m_device.answering())
        return m_patience.stop();
    m_rest.clear();
    const LinkState state = m_device.link().state;
    if (!asking() || (state != LinkState::Recovering && state != LinkState::Suspect))
        return withdrawAndTell(silentText());
    m_hiccup = true;
    if (!m_patience.isActive())
        m_patience.start();
}

void MotionGate::want(const QString &action, drive::WishContent act)
{
    want(action, std::vector<drive::WishContent>{std::move(act)});
}

void MotionGate::want(const QString &action, std::vector<drive::WishContent> acts)
{
    if (asking() || acts.empty() || needsExpert(acts))
        return;
    m_action = action;
    m_asked = std::move(acts);
    m_agreeOnly = false;
    wouldAsk(m_asked) ? ask() : send();
}

bool MotionGate::jog(const QString &action, int motor, std::int32_t rpm)
{
    std::vector<drive::WishContent> acts{
        drive::SpeedRamp{motor, rpm, kJogRamp}, drive::Command{drive::MotorAction::Start, motor}};
    if (asking() || needsExpert(acts))
        return false;
    m_action = action;
    m_asked = std::move(acts);
    m_agreeOnly = !jogAgreed(motor);
    if (m_agreeOnly) {
        ask();
        return false;
    }
    send();
    return true;
}

/// Whether one of them moves a motor whose limits are not all known: it would be refused.
bool MotionGate::needsExpert(const std::vector<drive::WishContent> &acts)
{
    for (const drive::WishContent &act : acts) {
        if (std::holds_alternative<drive::CyclicSetPoints>(act))
            continue; // moves nothing
        const auto *command = std::get_if<drive::Command>(&act);
        const bool moves = command == nullptr || command->action == drive::MotorAction::Start;
        const int motor = motorOf(act);
        if (moves && !m_device.expert(motor) && !drive::gapsIn(m_device.limits(motor)).empty()) {
            Q_EMIT expertNeeded(motor);
            return true;
        }
    }
    return false;
}

void MotionGate::ask()
{
    MotionQuestion question{motorOf(m_asked.front()), m_action, {}, offerFor(m_asked)};
    drive::MotionScene scene = sceneOf(question.motor);
    drive::StartTarget target = startTarget(question.motor);
    for (const drive::WishContent &act : m_asked) {
        question.lines += linesOf(act, scene, target);
        if (const auto *ramp = std::get_if<drive::SpeedRamp>(&act)) {
            scene.speedReferenceRpm = ramp->rpm;
            target = {catalog::ControlMode::Speed, ramp->rpm, {}}; // what a start after it goes to
        }
    }
    if (m_agreeOnly)
        question.lines.append(tr("Nothing moves now: press and hold again after you have agreed."));
    m_hiccup = false;
    m_subject = subject();
    Q_EMIT asked(question);
}

/// What is asked about, and why; the measured speed is never twice the same.
QStringList MotionGate::subject() const
{
    QStringList lines;
    for (const drive::WishContent &act : m_asked) {
        const int motor = motorOf(act);
        drive::MotionScene scene = sceneOf(motor);
        scene.speedRpm.reset();
        lines << motorStateText(scene.state) << linesOf(act, scene, startTarget(motor));
    }
    return lines;
}

bool MotionGate::wouldAsk(const std::vector<drive::WishContent> &acts) const
{
    return std::any_of(acts.begin(), acts.end(), [this](const drive::WishContent &act) {
        return !drive::cautionsOf(act, sceneOf(motorOf(act))).empty();
    });
}

void MotionGate::confirm()
{
    if (!asking())
        return;
    if (!m_device.armed())
        return withdraw();
    if (!m_device.answering())
        return withdrawAndTell(silentText());
    if (m_hiccup && subject() != m_subject)
        return withdrawAndTell(tr("Nothing was sent: the board stopped answering for a moment, and "
                                  "the motor is not as it was asked about. Press again."));
    if (!std::exchange(m_agreeOnly, false))
        return send();
    m_agreed.insert(motorOf(m_asked.front()));
    m_asked.clear();
}

/// The greatest set-points that the acts go to or come from; 0 where nothing of the kind is known.
MotionGate::Agreed MotionGate::stepsOf(const std::vector<drive::WishContent> &acts) const
{
    Agreed most;
    for (const drive::WishContent &act : acts) {
        const drive::MotionScene scene = sceneOf(motorOf(act));
        if (const auto *speed = std::get_if<drive::SpeedRamp>(&act))
            most.rpm = std::max(std::abs(static_cast<double>(speed->rpm)),
                std::abs(scene.speedReferenceRpm.value_or(0.0)));
        else if (const auto *torque = std::get_if<drive::TorqueRamp>(&act))
            most.amps =
                std::max(std::abs(torque->amps), std::abs(scene.iqReferenceAmps.value_or(0.0)));
        else if (const auto *current = std::get_if<drive::CurrentReference>(&act))
            most.amps = std::max(std::hypot(current->iqAmps, current->idAmps),
                std::hypot(
                    scene.iqReferenceAmps.value_or(0.0), scene.idReferenceAmps.value_or(0.0)));
    }
    return most;
}

/// Only where the length of the step is all that is in question.
QString MotionGate::offerFor(const std::vector<drive::WishContent> &acts) const
{
    for (const drive::WishContent &act : acts)
        for (const drive::MotionCaution caution : drive::cautionsOf(act, sceneOf(motorOf(act))))
            if (caution != drive::MotionCaution::Step
                && caution != drive::MotionCaution::StepFromUnknown)
                return {};
    const Agreed most = stepsOf(acts);
    if (m_agreeOnly || (most.rpm > 0.0) == (most.amps > 0.0))
        return {};
    const QString text = most.rpm > 0.0
        ? numberText(most.rpm, 0) + QChar(0x202f) + tr("rpm")
        : numberText(most.amps, kAmpDecimals) + QStringLiteral("\u202fA");
    return tr("Do not ask about steps up to %1 again until disarmed", "set-point with unit")
        .arg(text);
}

void MotionGate::agreeToSteps()
{
    if (!asking())
        return;
    Agreed &agreed = m_agreedSteps[motorOf(m_asked.front())];
    const Agreed most = stepsOf(m_asked);
    agreed.rpm = std::max(agreed.rpm, most.rpm);
    agreed.amps = std::max(agreed.amps, most.amps);
}

void MotionGate::decline()
{
    m_patience.stop();
    m_asked.clear();
}

void MotionGate::withdrawAndTell(const QString &why)
{
    const bool told = asking();
    withdraw();
    if (told)
        Q_EMIT failed(why);
}

void MotionGate::withdraw()
{
    m_patience.stop();
    m_rest.clear();
    if (!asking())
        return;
    m_asked.clear();
    Q_EMIT withdrawn();
}

void MotionGate::send()
{
    m_rest = std::exchange(m_asked, {});
    sendNext();
}

void MotionGate::sendNext()
{
    const drive::WishContent act = m_rest.front();
    m_rest.erase(m_rest.begin());
    const Open open{m_action, isStart(act) ? motorOf(act) : 0};
    m_last = m_device.submit(act);
    m_open.insert(m_last, open);
}

void MotionGate::ended(const drive::Ended &ended)
{
    if (!m_open.contains(ended.id))
        return;
    const Open open = m_open.take(ended.id);
    const bool mayHaveStarted =
        ended.outcome == drive::Outcome::Ok || ended.outcome == drive::Outcome::Unknown;
    if (open.startOf > 0 && mayHaveStarted)
        m_started.insert(open.startOf);
    if (ended.id == m_last && !m_rest.empty()) {
        if (ended.outcome == drive::Outcome::Ok && m_device.armed() && m_device.answering())
            sendNext();
        else
            m_rest.clear();
    }
    if (ended.outcome != drive::Outcome::Ok)
        Q_EMIT failed(failureText(open.action, ended));
}

/// Newest value of a register of a motor; empty if there is none or it is stale.
std::optional<double> MotionGate::reading(const char *name, int motor) const
{
    const auto catalog = m_device.catalog();
    const catalog::RegisterInfo *info = catalog ? catalog->find(name) : nullptr;
    if (info == nullptr)
        return {};
    return m_registers.shownValue(catalog->withMotor(*info, motor));
}

std::optional<double> MotionGate::shaftOf(int motor) const
{
    const auto catalog = m_device.catalog();
    return catalog ? drive::shaftAngle_rad(
               *catalog, motor, [this](catalog::RegisterId id) { return m_registers.current(id); })
                   : std::nullopt;
}

/// The references of a motor that rests are left-overs, of an experiment for one: nothing follows them. A step begins
/// where a start would go then; what is not controlled is at 0.
void MotionGate::setReferences(drive::MotionScene &scene, int motor) const
{
    if (!m_device.statusIsNow(motor) || !drive::rests(scene.state)) {
        scene.speedReferenceRpm = reading("SPEED_REF", motor);
        scene.iqReferenceAmps = reading("I_Q_REF", motor);
        scene.idReferenceAmps = reading("I_D_REF", motor);
        return;
    }
    const drive::StartTarget target = startTarget(motor);
    if (target.control == catalog::ControlMode::Other)
        return; // not known
    const bool torque = target.control == catalog::ControlMode::Torque;
    scene.speedReferenceRpm = torque ? 0.0 : target.rpm;
    scene.iqReferenceAmps = torque ? target.amps : 0.0;
    scene.idReferenceAmps = 0.0;
}

drive::MotionScene MotionGate::sceneOf(int motor) const
{
    const drive::MotorStatus status = m_device.status(motor);
    drive::MotionScene scene;
    scene.state = status.state;
    scene.startedBefore = m_started.contains(motor);
    scene.experiment = m_experiment;
    // A ceiling that stands in for a limit in expert mode makes no step a small one.
    scene.bounds = drive::realBoundsOf(m_device.limits(motor), m_device.userLimits());
    if (const auto agreed = m_agreedSteps.find(motor); agreed != m_agreedSteps.end()) {
        scene.agreedRpm = agreed->second.rpm;
        scene.agreedAmps = agreed->second.amps;
    }
    scene.ownSpeedLimitRpm = m_device.userLimits().maxSpeedRpm;
    scene.speedRpm = status.speedRpm;
    setReferences(scene, motor);
    if (const auto mode = reading("CONTROL_MODE", motor))
        scene.torqueMode =
            catalog::controlModeOf(std::llround(*mode)) == catalog::ControlMode::Torque;
    return scene;
}

drive::StartTarget MotionGate::startTarget(int motor) const
{
    const auto catalog = m_device.catalog();
    if (!catalog)
        return {};
    return drive::startTarget(*catalog, m_device.limits(motor), motor,
        [this](catalog::RegisterId id) { return m_registers.current(id); });
}

QString MotionGate::startText(int motor) const { return targetText(startTarget(motor)); }

QStringList MotionGate::linesOf(const drive::WishContent &act, const drive::MotionScene &scene,
    const drive::StartTarget &target) const
{
    const QString rpm = tr("rpm"), amps = QStringLiteral("A");
    const auto number = [](std::optional<double> value, int decimals, const QString &unit) {
        return value ? numberText(*value, decimals) + QChar(0x202f) + unit
                     : tr("not known", "the old value");
    };
    QString change;
    if (isStart(act))
        change = tr("%1 \u2192 start, then to %2", "state now, speed it will go to")
                     .arg(motorStateText(scene.state),
                         targetText(target).isEmpty() ? tr("not known", "the old value")
                                                      : targetText(target));
    else if (const auto *speed = std::get_if<drive::SpeedRamp>(&act))
        change = tr("speed %1 \u2192 %2 in %3 ms", "old, new, time")
                     .arg(number(scene.speedReferenceRpm, 0, rpm), number(speed->rpm, 0, rpm),
                         QString::number(speed->duration.count()));
    else if (const auto *torque = std::get_if<drive::TorqueRamp>(&act))
        change = tr("current Iq %1 \u2192 %2 in %3 ms", "old, new, time")
                     .arg(number(scene.iqReferenceAmps, kAmpDecimals, amps),
                         number(torque->amps, kAmpDecimals, amps),
                         QString::number(torque->duration.count()));
    else if (const auto *current = std::get_if<drive::CurrentReference>(&act))
        change = tr("Iq %1 \u2192 %2, Id %3 \u2192 %4, immediately", "old, new, old, new")
                     .arg(number(scene.iqReferenceAmps, kAmpDecimals, amps),
                         number(current->iqAmps, kAmpDecimals, amps),
                         number(scene.idReferenceAmps, kAmpDecimals, amps),
                         number(current->idAmps, kAmpDecimals, amps));
    else if (const auto *position = std::get_if<drive::PositionRamp>(&act))
        change = tr("position %1 \u2192 %2 in %3 ms", "old, new, time")
                     .arg(shaftText(shaftOf(position->motor)), shaftText(position->radians),
                         QString::number(position->duration.count()));
    QStringList lines{
        tr("Motor %1: %2", "number, change").arg(QString::number(motorOf(act)), change)};
    const bool ofCurrent = !std::holds_alternative<drive::SpeedRamp>(act);
    for (const drive::MotionCaution caution : drive::cautionsOf(act, scene))
        lines.append(QStringLiteral("\u2013 ")
            + motionCautionText(caution,
                ofCurrent ? number(scene.bounds.amps, kAmpDecimals, amps)
                          : number(scene.bounds.rpm, 0, rpm),
                number(scene.speedRpm, 0, rpm)));
    return lines;
}

} // namespace widgets
