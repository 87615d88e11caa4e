#include "widgets/control/jog_box.h"

#include "widgets/base/fields/number_edit.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/control/command_box.h"

#include <QGridLayout>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>

#include <cmath>

namespace widgets {
namespace {

constexpr double kFallbackRpm = 300.0;
// A busy X11 session tells some repeats as a release and a press of one and the same instant.
constexpr std::chrono::milliseconds kRepeatWithin{30};
// A sixth of what a hold lasts without being heard of.
constexpr std::chrono::milliseconds kHoldEvery{50};

bool isEnter(const QKeyEvent *event)
{
    return (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        && !(event->modifiers() & ~Qt::KeypadModifier);
}

} // namespace

JogButton::JogButton(const QString &text, QWidget *parent)
    : MotorButton(text, parent)
{
    setFocusPolicy(Qt::StrongFocus); // what has no focus cannot lose it
    setAutoRepeat(false);
    m_holding.setInterval(kHoldEvery);
    m_holding.setTimerType(Qt::PreciseTimer);
    connect(&m_holding, &QTimer::timeout, this, &JogButton::stillHeld);
    m_released.setSingleShot(true);
    m_released.setInterval(kRepeatWithin);
    connect(&m_released, &QTimer::timeout, this, [this] {
        setDown(false);
        end();
    });
    connect(qGuiApp, &QGuiApplication::applicationStateChanged, this,
        [this](Qt::ApplicationState state) {
            if (state != Qt::ApplicationActive)
                lose();
        });
}

void JogButton::begin()
{
    if (std::exchange(m_held, true))
        return;
    watchWindow(true);
    m_holding.start();
    Q_EMIT began();
}

void JogButton::end()
{
    if (!std::exchange(m_held, false))
        return;
    watchWindow(false);
    m_holding.stop();
    Q_EMIT ended();
}

void JogButton::lose()
{
    m_released.stop();
    if (!std::exchange(m_held, false))
        return;
    watchWindow(false);
    m_holding.stop();
    setDown(false);
    Q_EMIT lost();
}

void JogButton::watchWindow(bool watch)
{
    if (m_watched)
        m_watched->removeEventFilter(this);
    m_watched = watch ? window() : nullptr;
    if (m_watched)
        m_watched->installEventFilter(this);
}

/// A window that a dialog blocks gets no release any more, and not every desktop gives that dialog the focus.
bool JogButton::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::WindowBlocked)
        lose();
    return MotorButton::eventFilter(watched, event);
}

bool JogButton::event(QEvent *event)
{
    switch (event->type()) {
    case QEvent::FocusOut:
    case QEvent::Hide:
    case QEvent::WindowDeactivate:
    case QEvent::UngrabMouse:
        lose();
        break;
    case QEvent::EnabledChange:
        if (!isEnabled())
            lose();
        break;
    default:
        break;
    }
    return MotorButton::event(event);
}

void JogButton::mousePressEvent(QMouseEvent *event)
{
    MotorButton::mousePressEvent(event);
    if (event->button() == Qt::LeftButton && isDown())
        begin();
}

void JogButton::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        end();
    MotorButton::mouseReleaseEvent(event);
}

void JogButton::keyPressEvent(QKeyEvent *event)
{
    if (!isEnter(event))
        return MotorButton::keyPressEvent(event);
    event->accept();
    if (event->isAutoRepeat())
        return;
    if (m_released.isActive()) {
        m_released.stop();
        if (event->timestamp() == m_releasedAt)
            return; // it never came up
        end();
    }
    setDown(true);
    begin();
}

void JogButton::keyReleaseEvent(QKeyEvent *event)
{
    if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter)
        return MotorButton::keyReleaseEvent(event);
    event->accept();
    if (event->isAutoRepeat() || !m_held)
        return;
    m_releasedAt = event->timestamp();
    m_released.start();
}

JogBox::JogBox(Device &device, MotionGate &motion, QWidget *parent)
    : QWidget(parent)
    , m_device(device)
    , m_jog(device, motion)
    , m_speed(named(new NumberEdit(this), "jogSpeed", tr("Jog speed in rpm")))
    , m_back(makeButton(QStringLiteral("\u25c0 ") + tr("hold"), "jogBack", -1))
    , m_forth(makeButton(tr("hold") + QStringLiteral(" \u25b6"), "jogForth", 1))
{
    m_back->setAccessibleName(tr("Jog backwards while held"));
    m_forth->setAccessibleName(tr("Jog forwards while held"));
    m_speed->setFixedWidth(m_speed->fontMetrics().horizontalAdvance(QStringLiteral("00000")) + 14);
    auto *label = new QLabel(tr("Jog [rpm]"), this);
    label->setBuddy(m_speed);
    auto *grid = bare(new QGridLayout(this), kGrid);
    grid->addWidget(label, 0, 0);
    grid->addWidget(m_speed, 0, 1);
    grid->addWidget(m_back, 0, 2);
    grid->addWidget(m_forth, 0, 3);
    grid->setColumnStretch(2, 1);
    grid->setColumnStretch(3, 1);
    connect(&m_jog, &Jog::changed, this, &JogBox::follow);
    connect(m_speed, &NumberEdit::echoChanged, this, &JogBox::follow);
    connect(&device, &Device::boundsChanged, this, &JogBox::updateLimit);
    connect(&device, &Device::motorChanged, this, &JogBox::updateLimit);
    connect(&device, &Device::identityChanged, this, [this] {
        m_speedGiven = false;
        updateLimit();
    });
    updateLimit();
}

JogButton *JogBox::makeButton(const QString &text, const char *name, int sign)
{
    auto *button = named(new JogButton(text, this), name);
    connect(button, &JogButton::began, this, [this, sign] {
        if (const auto rpm = m_speed->sentValue())
            m_jog.hold(sign * static_cast<std::int32_t>(std::abs(*rpm)));
    });
    connect(button, &JogButton::stillHeld, &m_jog, &Jog::stamp);
    connect(button, &JogButton::ended, this, [this] {
        m_jog.release();
        follow();
    });
    connect(button, &JogButton::lost, this, [this] {
        m_jog.abort();
        follow();
    });
    return button;
}

void JogBox::updateLimit()
{
    const double most = m_jog.greatestRpm();
    const double step = m_device.limits(m_device.motor()).speedStepRpm;
    m_speed->setLimits(most > 0.0 ? most : kFallbackRpm, step, tr("rpm"));
    if (most > 0.0 && !std::exchange(m_speedGiven, true))
        m_speed->setValue(std::floor(most / 2.0 / step) * step);
    follow();
}

void JogBox::follow()
{
    MotionAllowed can = m_jog.allowed();
    if (can.yes && m_speed->sentValue().value_or(0.0) == 0.0)
        can = {false, m_speed->sentValue() ? tr("Give a speed to jog at.") : m_speed->echo()};
    m_speed->setWheelAllowed(can.yes);
    m_speed->setToolTip(m_speed->echo());
    const QString help = tr("Turns the motor while it is held, with the pointer or the Enter key; "
                            "letting go stops it.");
    for (JogButton *button : {m_back, m_forth}) {
        // What is held stays enabled, or it could not be let go; and the focus stays for the next time.
        const bool lettingGo = m_jog.underWay() && !m_jog.held() && button->hasFocus();
        if (!button->held() && !lettingGo)
            applyAllowed(button,
                m_jog.underWay() ? MotionAllowed{false, tr("The motor is being jogged.")} : can,
                help);
    }
}

} // namespace widgets
