#include "widgets/control/panel.h"

#include "widgets/base/fields/number_edit.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/section_head.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/steady_label.h"
#include "widgets/base/value_text.h"
#include "widgets/control/command_box.h"
#include "widgets/control/jog_box.h"
#include "widgets/control/motion_gate.h"
#include "widgets/control/readout_box.h"
#include "widgets/control/setpoints/box.h"
#include "widgets/control/state_box.h"
#include "widgets/control/stop_words.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QResizeEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace widgets {
namespace {

constexpr int kMargin = kGrid;
constexpr int kLeastScrolled = 60; ///< pixels: a set-point
constexpr int kLeastRead = 40; ///< pixels: two of the read-outs

/// As high as what is in it at its width, and lower where there is no room.
class Scroll : public QScrollArea {
public:
    using QScrollArea::QScrollArea;
    QSize sizeHint() const override
    {
        return {widget() ? widget()->sizeHint().width() : 0, wantedHeight()};
    }

protected:
    void resizeEvent(QResizeEvent *event) override
    {
        placeBar();
        QScrollArea::resizeEvent(event);
        if (event->size().width() != event->oldSize().width())
            updateGeometry(); // text that wraps makes another height of it
    }
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        const bool taken = QScrollArea::eventFilter(watched, event);
        if (watched == widget() && event->type() == QEvent::LayoutRequest) {
            updateGeometry();
            placeBar();
        }
        return taken;
    }

private:
    int wantedHeight() const
    {
        if (!widget())
            return 0;
        return widget()->hasHeightForWidth() ? widget()->heightForWidth(width())
                                             : widget()->sizeHint().height();
    }
    /// At once: Qt takes its bar away a turn late, and for that turn all is narrower.
    void placeBar()
    {
        setVerticalScrollBarPolicy(
            height() >= wantedHeight() ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
    }
};

/// A scroll area for a part of the panel.
Scroll *scrolled(QWidget *content, const char *name, QWidget *parent)
{
    auto *scroll = named(new Scroll(parent), name);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(content);
    const int bar = scroll->verticalScrollBar()->sizeHint().width();
    scroll->setMinimumWidth(content->minimumSizeHint().width() + bar);
    return scroll;
}

/// What can be wished, and below it what is read: where there is little room the first gives way, and then the second.
class Parts : public QWidget {
public:
    Parts(Scroll *wished, Scroll *read, QWidget *parent)
        : QWidget(parent)
        , m_wished(wished)
        , m_read(read)
    {
        wished->setParent(this);
        read->setParent(this);
        setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    }
    QSize sizeHint() const override
    {
        return {std::max(m_wished->sizeHint().width(), m_read->sizeHint().width()),
            m_wished->sizeHint().height() + m_read->sizeHint().height()};
    }
    QSize minimumSizeHint() const override
    {
        return {std::max(m_wished->minimumWidth(), m_read->minimumWidth()),
            kLeastScrolled + kLeastRead};
    }

protected:
    bool event(QEvent *event) override
    {
        if (event->type() == QEvent::LayoutRequest)
            updateGeometry();
        if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize)
            place();
        return QWidget::event(event);
    }

private:
    void place()
    {
        const int whole = m_read->sizeHint().height();
        const int read = std::clamp(height() - kLeastScrolled, std::min(kLeastRead, whole), whole);
        const int wished = std::min(m_wished->sizeHint().height(), height() - read);
        m_wished->setGeometry(0, 0, width(), wished);
        m_read->setGeometry(0, wished, width(), read);
    }

    Scroll *m_wished, *m_read;
};

QFrame *line(QWidget *parent)
{
    auto *frame = new QFrame(parent);
    frame->setFrameShape(QFrame::HLine);
    frame->setFrameShadow(QFrame::Sunken);
    return frame;
}

} // namespace

ControlPanel::ControlPanel(
    Device &device, RegisterModel &registers, MotionGate &motion, QWidget *parent)
    : QWidget(parent)
    , m_device(device)
    , m_motion(motion)
    , m_state(new StateBox(device, this))
    , m_commands(new CommandBox(device, motion, this))
    , m_setpoints(new SetpointBox(device, registers, motion, this))
    , m_jog(new JogBox(device, motion, this))
    , m_readouts(new ReadoutBox(device, registers, this))
    , m_limits(named(new SteadyLabel(this, 2), "limits"))
    , m_changeLimits(named(new QToolButton(this), "changeLimits", tr("Change own limits")))
    , m_changeScale(
          named(new QToolButton(this), "changeCurrentScale", tr("Change the current scale")))
    , m_words(new StopWords(this))
{
    setObjectName(QStringLiteral("controlPanel"));
    Scroll *scroll = scrolled(makeBody(), "controlScroll", this);

    auto *fixed = new QWidget(this);
    auto *top = edged(new QVBoxLayout(fixed), {kMargin, kFineGrid, kMargin, 0}, kFineGrid);
    top->addWidget(m_state);
    connect(m_state, &StateBox::causesWanted, this, &ControlPanel::causesWanted);
    top->addWidget(line(this));
    top->addWidget(m_commands);
    top->addWidget(m_words);
    top->addWidget(new SectionHead(tr("Set-point"), this));
    keepPlace(*m_words); // what is below does not move when they come
    m_words->hide();
    // What the motor does is read also where a message and the words of a stop leave no room for all that can be
    // wished.
    auto *read = new QWidget(this);
    auto *bottom = edged(new QVBoxLayout(read), {kMargin, 0, kMargin, kFineGrid}, kFineGrid);
    bottom->addWidget(line(this)); // what is measured has names of its own
    bottom->addWidget(m_readouts);
    auto *layout = bare(new QVBoxLayout(this), 0);
    layout->addWidget(fixed);
    layout->addWidget(new Parts(scroll, scrolled(read, "readScroll", this), this));
    layout->addStretch(1);

    connect(&device, &Device::linkStateChanged, this, &ControlPanel::follow);
    connect(&device, &Device::statusChanged, this, &ControlPanel::follow);
    connect(&device, &Device::armedStateChanged, this, &ControlPanel::follow);
    connect(&device, &Device::boundsChanged, this, &ControlPanel::follow);
    connect(&device, &Device::motorChanged, this, [this] {
        m_setpoints->forget(); // what was typed was for the other motor
        m_setpoints->expectReference();
        follow();
    });
    connect(&device, &Device::identityChanged, this, [this] {
        if (!m_device.identified()) { // another board: the words were about one that is gone
            m_words->clear();
            m_words->hide();
        }
        m_setpoints->expectReference();
        follow();
    });
    connect(&device, &Device::stopAdvanced, this, &ControlPanel::stopAdvanced);
    connect(m_readouts, &ReadoutBox::watchedRegistersChanged, this,
        &ControlPanel::watchedRegistersChanged);
    connect(m_readouts, &ReadoutBox::updated, this, [this] {
        m_setpoints->offerReference(m_motion.startTarget(m_device.motor()).rpm);
        m_commands->follow();
    });
    connect(m_changeLimits, &QToolButton::clicked, this, &ControlPanel::limitsWanted);
    connect(m_changeScale, &QToolButton::clicked, this, &ControlPanel::currentScaleWanted);
    follow();
}

QWidget *ControlPanel::makeBody()
{
    auto *body = new QWidget(this);
    m_limits->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_changeLimits->setText(tr("Change\u2026", "the limits"));
    m_changeLimits->setFocusPolicy(Qt::TabFocus);
    auto *limits = new QHBoxLayout;
    limits->addWidget(m_limits, 1);
    limits->addWidget(m_changeLimits, 0, Qt::AlignTop);
    m_changeScale->setText(tr("Scale\u2026", "of the currents"));
    m_changeScale->setToolTip(tr("The current of %1 digits, which the board does not tell.")
                                  .arg(numberText(drive::kFullScaleDigits, 0)));
    m_changeScale->setFocusPolicy(Qt::TabFocus);
    m_readouts->putBeside("I_Q_MEAS", *m_changeScale);
    auto *layout = edged(new QVBoxLayout(body), {kMargin, kFineGrid, kMargin, 0}, kFineGrid);
    layout->addWidget(m_setpoints);
    layout->addWidget(line(this)); // its row has its name
    layout->addWidget(m_jog);
    layout->addLayout(limits);
    return body;
}

std::vector<catalog::RegisterId> ControlPanel::watchedRegisters() const
{
    std::vector<catalog::RegisterId> ids = m_readouts->watchedRegisters();
    if (const auto catalog = m_device.catalog(); catalog && m_device.identified())
        for (const catalog::RegisterId id : drive::startRegisters(*catalog, m_device.motor()))
            if (std::find(ids.begin(), ids.end(), id) == ids.end())
                ids.push_back(id);
    return ids;
}

NumberEdit *ControlPanel::speed() const { return m_setpoints->speed(); }
QString ControlPanel::startHint() const { return m_commands->startHint(); }
QString ControlPanel::acknowledgeHint() const { return m_commands->acknowledgeHint(); }

void ControlPanel::refresh(Milliseconds now)
{
    m_now = now;
    m_words->refresh(now);
    m_jog->refresh(now);
}

void ControlPanel::follow()
{
    using drive::MotorState;
    const int motor = m_device.motor();
    const MotorState state = m_device.status(motor).state;
    const auto turns = [](MotorState any) {
        return any == MotorState::Starting || any == MotorState::Running;
    };
    const auto before = std::exchange(m_followed, {motor, state});
    if (m_words->rested() && turns(state) && before.first == motor && !turns(before.second))
        m_words->hide(); // they told of a motor that stood, and now it is started
    m_commands->follow();
    m_setpoints->follow();
    m_jog->follow();
    showLimits();
}

/// Of the currents, where the board does not tell it; else empty.
QString ControlPanel::scaleText() const
{
    if (!m_changeScale->isEnabled())
        return {};
    const double amps = m_device.fullScaleAmps(m_device.motor());
    return amps > 0.0 ? tr("Current scale: %1 (yours)", "with unit")
                            .arg(numberText(amps, 2) + QChar(0x202f) + QLatin1Char('A'))
                      : tr("Current scale: not known");
}

void ControlPanel::showLimits()
{
    const bool asked =
        m_device.identified() && m_device.capability(drive::Feature::CurrentScale).available;
    m_changeScale->setEnabled(asked);
    m_changeScale->setVisible(asked);
    const int motor = m_device.motor();
    const drive::UserLimits &own = m_device.userLimits();
    const drive::MotionBounds bounds = drive::realBoundsOf(m_device.limits(motor), own);
    const bool expert = m_device.expert(motor);
    bool marked = false;
    const auto text = [&](double bound, double ownLimit, int decimals, const QString &unit) {
        if (!(bound > 0.0))
            return expert ? tr("none", "a limit") : tr("not known", "a limit");
        const QString number = numberText(bound, decimals) + QChar(0x202f) + unit;
        if (bound != ownLimit)
            return number;
        marked = true;
        return tr("%1 (yours)", "a limit of the person's own").arg(number);
    };
    const QString speed = text(bounds.rpm, own.maxSpeedRpm, 0, tr("rpm"));
    const QString current = text(bounds.amps, own.maxCurrentAmps, 2, QStringLiteral("A"));
    QStringList more{
        expert ? tr("Expert mode: the board does not tell all limits.") : QString(), scaleText()};
    more.removeAll(QString());
    QString all;
    if (!m_device.identified())
        all = tr("Limits: not known yet");
    else if (!expert && !(bounds.rpm > 0.0) && !(bounds.amps > 0.0))
        all = tr("Limits: not known");
    else if (expert && !(bounds.rpm > 0.0) && !(bounds.amps > 0.0))
        all = tr("Limits: none (expert mode)");
    else if (marked && more.isEmpty())
        all = tr("Limits: %1,\n%2", "speed, current, below each other").arg(speed, current);
    else
        all = tr("Limits: %1, %2", "speed, current").arg(speed, current);
    if (!more.isEmpty())
        all += QLatin1Char('\n') + more.join(QStringLiteral("; "));
    m_limits->setText(all); // of two lines, whatever they are
}

void ControlPanel::stopAdvanced(const drive::StopProgress &progress)
{
    m_words->show();
    m_words->accept(progress, m_now);
    if (progress.word != drive::StopWord::Requested)
        return;
    m_setpoints->forget();
    m_setpoints->expectReference(); // which a stop leaves on the board, for the next start
}

/// A file has nothing of the board that was stopped. Words of a Stop that has not ended stay.
void ControlPanel::fileShown()
{
    if (!m_words->rested())
        return;
    m_words->clear();
    m_words->hide();
}

void ControlPanel::start() { m_commands->start(); }
void ControlPanel::acknowledge() { m_commands->acknowledge(); }
void ControlPanel::go() { m_setpoints->go(); }
void ControlPanel::stopRamp() { m_setpoints->stopRamp(); }
void ControlPanel::toggleArmed() { m_device.setArmed(!m_device.armed()); }

} // namespace widgets
