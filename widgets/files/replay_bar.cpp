#include "widgets/files/replay_bar.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/section_head.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/steady_label.h"
#include "widgets/base/value_text.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/files/recording_control.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSlider>
#include <QToolButton>

#include <algorithm>

namespace widgets {
namespace {

constexpr int kPlaces = 1000; ///< of the slider
// Pixels at least: the bar never makes the window wider than its screen, where Stop would be out of sight.
constexpr int kPlaceWidth = 48;
constexpr int kPaceWidth = 72;

} // namespace

ReplayBar::ReplayBar(Device &device, session::Replay &replay, QWidget *parent)
    : QWidget(parent)
    , m_device(device)
    , m_replay(replay)
    , m_pause(named(new QToolButton(this), "replayPause", tr("Pause the replay")))
    , m_speed(named(new QComboBox(this), "replaySpeed", tr("Pace of the replay")))
    , m_place(named(new QSlider(Qt::Horizontal, this), "replayPlace", tr("Place in the recording")))
    , m_badge(named(new QLabel(tr("REPLAY"), this), "replayBadge"))
    , m_text(named(new SteadyLabel(this), "replayText"))
{
    setObjectName(QStringLiteral("replayBar"));
    for (const QString &word : {tr("Go on"), tr("Pause")}) { // what is beside it stays where it is
        m_pause->setText(word);
        m_pause->setMinimumWidth(std::max(m_pause->minimumWidth(), m_pause->sizeHint().width()));
    }
    m_pause->setToolTip(tr("Holds the replay; nothing is left out"));
    m_pause->setCheckable(true);
    m_pause->setFocusPolicy(Qt::TabFocus);
    m_speed->addItem(tr("1\u00d7, as it was"), 1.0);
    m_speed->addItem(tr("4\u00d7"), 4.0);
    m_speed->addItem(tr("as fast as possible"), 0.0);
    m_speed->setMinimumWidth(kPaceWidth);
    new WheelGuard(m_speed);
    m_place->setToolTip(tr("Goes to another place in the recording. Going back restarts it, after "
                           "what the scope already has."));
    m_place->setRange(0, kPlaces);
    m_place->setPageStep(kPlaces / 20);
    m_place->setSingleStep(kPlaces / 100);
    m_place->setTracking(false); // where it is let go
    m_place->setMinimumWidth(kPlaceWidth);
    new WheelGuard(m_place);
    m_badge->setContentsMargins(6, 1, 6, 1);
    m_badge->setAutoFillBackground(true);
    m_badge->setFont(inBold(m_badge->font()));
    paintBadge();
    m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);

    auto *layout = edged(new QHBoxLayout(this), {kGrid, 0, kGrid, kHalfGrid}, kGrid);
    layout->addWidget(m_badge);
    layout->addWidget(m_pause);
    layout->addWidget(m_speed);
    layout->addWidget(m_place, 1);
    layout->addWidget(m_text, 1);

    connect(m_pause, &QToolButton::toggled, this, [this](bool paused) {
        m_pause->setText(paused ? tr("Go on") : tr("Pause"));
        m_replay.setPaused(paused);
    });
    connect(m_speed, &QComboBox::currentIndexChanged, this,
        [this] { m_replay.setSpeed(m_speed->currentData().toDouble()); });
    connect(m_place, &QSlider::valueChanged, this, [this](int place) {
        if (!m_telling)
            m_replay.seek(static_cast<double>(place) / kPlaces);
    });
    connect(&replay, &session::Replay::advanced, this, &ReplayBar::tell);
    connect(&device, &Device::openWished, this, &ReplayBar::follow);
    connect(&device, &Device::portStateChanged, this, &ReplayBar::follow);
    follow();
}

/// As plain as a sign: nothing that is shown is happening now.
void ReplayBar::paintBadge()
{
    QPalette colors = palette();
    colors.setColor(QPalette::Window, QColor(0xf0, 0xb4, 0x29));
    colors.setColor(QPalette::WindowText, Qt::black);
    m_badge->setPalette(colors);
}

void ReplayBar::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        paintBadge();
}

void ReplayBar::follow()
{
    const bool shown = replaying(m_device) && m_device.portOpen();
    if (shown && isHidden()) { // a new one: as it was, from its beginning
        m_pause->setChecked(false);
        m_text->clear();
    }
    setVisible(shown);
}

void ReplayBar::tell(const session::ReplayState &state)
{
    QString text = tr("%1: %2, %3 %", "file name, duration, part of the file")
                       .arg(fileNameText(state.path), durationText(state.seconds),
                           numberText(state.fraction * 100.0, 0));
    if (state.damagedPlaces > 0)
        text += tr(", %n damaged place(s)", nullptr, static_cast<int>(state.damagedPlaces));
    if (state.ended)
        text += tr(" \u2013 its end");
    m_text->setText(text);
    m_pause->setEnabled(!state.ended);
    if (m_place->isSliderDown())
        return;
    const QScopedValueRollback telling(m_telling, true);
    m_place->setValue(static_cast<int>(state.fraction * kPlaces));
}

} // namespace widgets
