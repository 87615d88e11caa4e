#include "widgets/control/state_box.h"

#include "widgets/base/device_text.h"
#include "widgets/base/lamp.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/section_head.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/messages.h"
#include "widgets/base/steady_label.h"
#include "widgets/control/fault_texts.h"
#include "widgets/control/state_strip.h"

#include <QEvent>
#include <QGridLayout>
#include <QToolButton>

namespace widgets {
namespace {

/// One line as wide as the panel, whatever it says.
SteadyLabel *lineLabel(QWidget *parent, const char *objectName)
{
    auto *label = named(new SteadyLabel(parent), objectName);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    return label;
}

} // namespace

StateBox::StateBox(Device &device, QWidget *parent)
    : QWidget(parent)
    , m_device(device)
    , m_state(lineLabel(this, "motorState"))
    , m_strip(new StateStrip(this))
    , m_faultsNow(lineLabel(this, "faultsNow"))
    , m_faultsPast(lineLabel(this, "faultsPast"))
    , m_causes(named(new QToolButton(this), "faultCauses"))
{
    m_state->setFont(inBold(m_state->font(), 1.4));
    m_causes->setText(tr("Causes\u2026"));
    m_causes->setToolTip(tr("What these faults mean and what to try"));
    m_causes->setFocusPolicy(Qt::TabFocus);
    connect(m_causes, &QToolButton::clicked, this, &StateBox::causesWanted);

    auto *grid = bare(new QGridLayout(this));
    grid->setVerticalSpacing(kFineGrid);
    grid->addWidget(m_state, 0, 0);
    grid->addWidget(m_causes, 0, 1); // where the row is high enough for it
    grid->addWidget(m_strip, 1, 0, 1, 2);
    grid->addWidget(m_faultsNow, 2, 0, 1, 2);
    grid->addWidget(m_faultsPast, 3, 0, 1, 2);
    grid->setColumnStretch(0, 1);
    // What is below must not move when a fault comes or goes: a hand may be on its way to it.
    for (QWidget *widget :
        std::initializer_list<QWidget *>{m_causes, m_strip, m_faultsNow, m_faultsPast})
        keepPlace(*widget);

    connect(&device, &Device::linkStateChanged, this, &StateBox::follow);
    connect(&device, &Device::statusChanged, this, &StateBox::follow);
    connect(&device, &Device::motorChanged, this, &StateBox::follow);
    connect(&device, &Device::identityChanged, this, [this] {
        const auto &board = m_device.identified();
        m_strip->setSteps(board ? board->states : std::vector<drive::StateStep>());
        follow();
    });
    follow();
}

QString StateBox::stateText() const { return m_state->text(); }

void StateBox::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        follow(); // the colours of states follow the theme
}

void StateBox::follow()
{
    const drive::MotorStatus status = m_device.status(m_device.motor());
    const bool believed = m_device.statusIsNow(m_device.motor());
    showState(status, believed);
    showFaults(status, believed);
}

void StateBox::showState(const drive::MotorStatus &status, bool believed)
{
    m_strip->show(status, believed);
    // It belongs to a board that is there, or is looked for.
    m_strip->setVisible(m_strip->hasSteps() && m_device.portOpen());
    QString text = believed ? motorStateText(status.state) : linkStateText(m_device.link());
    const auto &board = m_device.identified();
    if (believed && board && board->identity.motors > 1)
        text = tr("Motor %1: %2", "number, state").arg(QString::number(m_device.motor()), text);
    // A name that the strip does not have must not be hidden.
    const QString name = deviceText(status.stateName);
    const bool said = text.endsWith(name, Qt::CaseInsensitive);
    const bool recorded = believed && replaying(m_device); // nothing turns now
    if (believed && !recorded && !name.isEmpty() && !said && m_strip->litName().isEmpty())
        text += QStringLiteral(" (%1)").arg(name);
    if (recorded)
        text = tr("Recorded: %1", "state").arg(text);
    m_state->setText(text);
    m_state->setEnabled(believed && !recorded);
    QPalette colors = palette();
    // The link's words must not wear the colour of a state that is no longer known.
    if (believed && !recorded)
        colors.setColor(QPalette::WindowText, stateColor(status.state, palette()));
    else if (m_device.link().state == drive::LinkState::Lost)
        colors.setColor(QPalette::WindowText, Lamp::colorOf(Lamp::Light::Bad, palette()));
    m_state->setPalette(colors);
}

void StateBox::showFaults(const drive::MotorStatus &status, bool believed)
{
    QPalette red = palette();
    red.setColor(QPalette::WindowText, Lamp::colorOf(Lamp::Light::Bad, palette()));
    m_faultsNow->setPalette(status.faultsNow.empty() || !believed ? palette() : red);
    m_faultsNow->setText(!believed ? tr("Faults are not known")
            : status.faultsNow.empty()
            ? tr("No fault present")
            : QStringLiteral("\u2716 ") + tr("Present: %1").arg(deviceNames(status.faultsNow)));
    m_faultsNow->setEnabled(believed);
    const std::vector<std::string> over = faultsOver(status);
    m_faultsNow->setVisible(!believed || !status.faultsNow.empty() || over.empty());
    m_faultsPast->setVisible(believed && !over.empty());
    m_faultsPast->setText(tr("To acknowledge: %1").arg(deviceNames(over)));
    m_causes->setVisible(believed && (!status.faultsNow.empty() || !over.empty()));
}

} // namespace widgets
