#include "widgets/window/first_steps.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace widgets {

FirstSteps::FirstSteps(Device &device, QWidget *parent)
    : QFrame(parent)
    , m_device(device)
    , m_title(new QLabel(this))
    , m_text(new QLabel(this))
    , m_first(new QPushButton(this))
    , m_second(new QPushButton(this))
    , m_close(new QPushButton(tr("Hide"), this))
{
    setObjectName(QStringLiteral("firstSteps"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setTextFormat(Qt::PlainText);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    // Two lines, also where a step says less: the scope's controls below stay where they are.
    m_text->setMinimumHeight(2 * m_text->fontMetrics().lineSpacing());
    m_text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_first->setObjectName(QStringLiteral("firstStepsFirst"));
    m_second->setObjectName(QStringLiteral("firstStepsSecond"));
    m_close->setObjectName(QStringLiteral("firstStepsHide"));
    m_close->setToolTip(tr("Help > First steps brings these cards back."));
    m_close->setFlat(true);

    auto *words = new QVBoxLayout;
    words->setSpacing(2);
    words->addWidget(m_title);
    words->addWidget(m_text);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 8, 8, 8);
    layout->setSpacing(8);
    layout->addLayout(words, 1);
    layout->addWidget(m_first);
    layout->addWidget(m_second);
    layout->addWidget(m_close);

    connect(m_first, &QPushButton::clicked, this, [this] {
        if (m_step == Step::Welcome)
            Q_EMIT simulatorWanted();
        else if (m_step == Step::Save)
            Q_EMIT exportWanted();
    });
    connect(m_second, &QPushButton::clicked, this, &FirstSteps::boardWanted);
    connect(m_close, &QPushButton::clicked, this, &FirstSteps::finish);
    connect(&device, &Device::identityChanged, this, &FirstSteps::follow);
    connect(&device, &Device::statusChanged, this, &FirstSteps::follow);
    connect(&device, &Device::wishEnded, this, &FirstSteps::follow);
    connect(&device, &Device::linkStateChanged, this, &FirstSteps::follow);
    hide();
}

void FirstSteps::restart()
{
    show(Step::Welcome);
    follow();
}

void FirstSteps::finish()
{
    m_step = Step::Done;
    place();
    Q_EMIT finished();
}

void FirstSteps::show(Step step)
{
    m_step = step;
    switch (step) {
    case Step::Welcome:
        m_title->setText(tr("Welcome to Rotorscope"));
        m_text->setText(
            tr("Try everything on a simulated board, or choose the port of your own board above."));
        m_first->setText(tr("Connect to simulated board"));
        m_second->setText(tr("Connect my board"));
        break;
    case Step::Start:
        m_title->setText(tr("Connected: the scope shows live signals"));
        m_text->setText(tr("Tick \"Arm\" on the right, then press Start. The Esc key stops every "
                           "motor, wherever you are."));
        break;
    case Step::Speed:
        m_title->setText(tr("The motor is running"));
        m_text->setText(tr("Type another speed and press Enter. Drag a register from the list onto "
                           "the scope to see it too."));
        break;
    case Step::Save:
        m_title->setText(tr("Save what you see"));
        m_text->setText(
            tr("The export writes the visible part, or all of it, as a CSV file with units."));
        m_first->setText(tr("Export CSV"));
        break;
    case Step::Done:
        break;
    }
    m_first->setVisible(step == Step::Welcome || step == Step::Save);
    m_second->setVisible(step == Step::Welcome);
    place();
}

void FirstSteps::setCrowded(bool crowded)
{
    m_crowded = crowded;
    place();
}

/// What a card says of the board holds only while the board answers; the banner has the word until then.
void FirstSteps::place()
{
    const bool holds = m_step == Step::Welcome || m_step == Step::Save || m_device.answering();
    setVisible(m_step != Step::Done && holds && !m_crowded);
}

void FirstSteps::follow()
{
    if (m_step == Step::Done)
        return;
    using drive::MotorState;
    const MotorState state = m_device.status(m_device.motor()).state;
    if (m_step == Step::Welcome && m_device.identified())
        show(Step::Start);
    place();
    if (m_step == Step::Start && state == MotorState::Running)
        show(Step::Speed);
    if (m_step == Step::Speed && (state == MotorState::Idle || state == MotorState::Stopping))
        show(Step::Save);
}

} // namespace widgets
