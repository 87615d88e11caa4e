#include "widgets/scope/signals/channel_strip.h"

#include "widgets/base/device_text.h"
#include "widgets/base/flow_layout.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/steady_label.h"
#include "widgets/base/value_text.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/scope/drop.h"

#include <QActionGroup>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace widgets {
namespace {

/// Two digits, never three ("10.0").
QString rateText(double hz) { return numberText(hz, hz < 9.95 ? 1 : 0); }

constexpr unsigned kSlowestRate = 256;
constexpr double kGreatestRate = 888.0; ///< a chip has room for, times a second
constexpr Milliseconds kMeasureOver{1000};

struct Channels {
    Q_DECLARE_TR_FUNCTIONS(Channels)
};

QString routeText(Route route)
{
    switch (route) {
    case Route::Fast:
        return Channels::tr("HF", "high frequency: recorded at the control rate");
    case Route::Slow:
        return Channels::tr("MF", "medium frequency: 1 of 16 samples");
    case Route::Polled:
        return Channels::tr("polled", "asked for again and again");
    }
    return {};
}

QString polledText(double hz)
{
    return routeText(Route::Polled) + QLatin1Char(' ')
        + ChannelStrip::tr("%1/s", "times a second").arg(rateText(hz));
}

/// With the sign that there is more behind it.
QString tagText(const QString &words) { return words + QStringLiteral(" \u25be"); }

QString detourText(Detour detour)
{
    switch (detour) {
    case Detour::None:
        return {};
    case Detour::NotStreamable:
        return Channels::tr(
            "The board cannot record this register: it is polled and drawn at that rate.");
    case Detour::TooManySignals:
        return Channels::tr("The board records no more signals at once: this one is polled.");
    case Detour::LinkFull:
        return Channels::tr("The link is too slow to record it: it is polled.");
    }
    return {};
}

/// @param fill  puts them into the menu each time that it is opened
void addColors(QMenu &menu, const std::function<void(QMenu &)> &fill)
{
    QMenu *colors = menu.addMenu(ChannelStrip::tr("&Colour"));
    QObject::connect(colors, &QMenu::aboutToShow, colors, [colors, fill] {
        colors->clear();
        if (fill)
            fill(*colors);
    });
}

/// A chip: rounded, in the colour of its field, with the signal's colour at its left edge.
class Chip : public QWidget {
public:
    Chip(const QColor &color, QWidget *parent)
        : QWidget(parent)
        , m_color(color)
    {
    }

    /// What a right click or the menu key on the chip shows.
    void setMenu(QMenu *menu) { m_menu = menu; }

    /// The name, `tag` beside it, and the button by which `takeOff` takes it off the scope.
    void fill(const QString &name, QToolButton *tag, const std::function<void()> &takeOff)
    {
        setObjectName(QStringLiteral("chip_") + name);
        auto *label = new QLabel(name, this);
        label->setTextFormat(Qt::PlainText);
        auto *remove = new QToolButton(this);
        remove->setAutoRaise(true);
        remove->setText(QStringLiteral("\u00d7"));
        remove->setAccessibleName(ChannelStrip::tr("Remove %1").arg(name));
        remove->setToolTip(ChannelStrip::tr("Take it off the scope"));
        auto *layout = edged(new QHBoxLayout(this), {19, 1, 2, 1}, kFineGrid);
        layout->addWidget(label);
        layout->addWidget(tag);
        layout->addWidget(remove);
        QObject::connect(
            remove, &QToolButton::clicked, parentWidget(), takeOff, Qt::QueuedConnection);
    }

protected:
    void contextMenuEvent(QContextMenuEvent *event) override
    {
        if (m_menu)
            m_menu->popup(event->reason() == QContextMenuEvent::Mouse
                    ? event->globalPos()
                    : mapToGlobal(rect().bottomLeft()));
    }
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(palette().color(QPalette::Mid));
        painter.setBrush(palette().color(QPalette::Base));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
        painter.setPen(Qt::NoPen);
        painter.setBrush(
            m_color.isValid() ? m_color : palette().color(QPalette::Disabled, QPalette::Text));
        painter.drawRoundedRect(QRectF(5, height() / 2.0 - 5, 10, 10), 2, 2);
    }

private:
    QColor m_color;
    QMenu *m_menu = nullptr;
};

} // namespace

ChannelStrip::ChannelStrip(SignalSelection &selection, Device &device, QWidget *parent)
    : QWidget(parent)
    , m_selection(selection)
    , m_device(device)
    , m_chips(new QWidget(this))
    , m_flow(new FlowLayout(kHalfGrid, m_chips))
    , m_empty(new SteadyLabel(this))
    , m_fold(named(new QToolButton(this), "foldChips"))
    , m_rateLabel(new QLabel(tr("HF rate"), this))
    , m_rate(named(new QComboBox(this), "fastRate", tr("Rate of the fast signals")))
    , m_budget(named(new SteadyLabel(this), "linkBudget"))
{
    setObjectName(QStringLiteral("channelStrip"));
    setAcceptDrops(true);
    m_empty->setText(tr("Drag registers here or onto the scope, or press Enter in the list."));
    m_empty->setEnabled(false);
    m_empty->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    new WheelGuard(m_rate);
    m_rate->setToolTip(tr("Samples a second of each HF signal"));
    // Never makes the window wider.
    m_budget->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);

    m_fold->setAutoRaise(true);
    m_fold->setFocusPolicy(Qt::TabFocus);
    connect(m_fold, &QToolButton::clicked, this, [this] {
        m_foldedByHand = !m_folded;
        fold();
    });
    m_rateLabel->setBuddy(m_rate);
    auto *bottom = bare(new QHBoxLayout, kGrid);
    bottom->addWidget(m_fold);
    bottom->addWidget(m_rateLabel);
    bottom->addWidget(m_rate);
    bottom->addSpacing(kGrid);
    bottom->addWidget(m_budget, 1);
    auto *layout = edged(new QVBoxLayout(this), kToolEdges, kHalfGrid);
    layout->addWidget(m_empty);
    layout->addWidget(m_chips);
    layout->addLayout(bottom);

    connect(m_rate, &QComboBox::activated, this,
        [this](int index) { m_selection.plan().setFastEvery(m_rate->itemData(index).toUInt()); });
    connect(&selection, &SignalSelection::changed, this, &ChannelStrip::rebuild);
    connect(&device, &Device::identityChanged, this, &ChannelStrip::fillRates);
    connect(&device, &Device::identityChanged, this, [this] { m_rates.forget(); });
    connect(&device, &Device::readingsArrived, this,
        [this](const std::vector<drive::Reading> &readings) {
            for (const drive::Reading &reading : readings)
                if (m_polledTags.contains(reading.id))
                    m_rates.accept(reading);
        });
    fillRates();
    rebuild();
}

void ChannelStrip::dragEnterEvent(QDragEnterEvent *event)
{
    if (!registersIn(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void ChannelStrip::dropEvent(QDropEvent *event)
{
    for (const quint32 id : registersIn(*event->mimeData()))
        m_selection.add(id);
    event->acceptProposedAction();
}

void ChannelStrip::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_budget)
        rebuild(); // the scope's colours follow the theme
}

void ChannelStrip::fillRates()
{
    m_rate->clear();
    const double tickHz = m_device.streamLimits().tickHz;
    for (unsigned every = 1; every <= kSlowestRate && tickHz > 0.0; every *= 2) {
        const double hz = tickHz / every;
        const QString text = hz >= 1000.0
            ? tr("%1 kHz").arg(numberText(hz / 1000.0, hz < 10000.0 ? 2 : 1))
            : tr("%1 Hz").arg(numberText(hz, 1));
        m_rate->addItem(text, every);
    }
    m_rate->setEnabled(tickHz > 0.0);
    showFold();
    m_rate->setCurrentIndex(m_rate->findData(m_selection.plan().fastEvery()));
}

QWidget *ChannelStrip::makeChip(const PlannedSignal &planned)
{
    const quint32 id = planned.id;
    const QString name = m_selection.nameOf(id);
    auto *chip = new Chip(m_selection.colorOf(id), m_chips);
    auto *tag = new QToolButton(chip);
    tag->setAutoRaise(true);
    // The style's own arrow overlaps so short a text.
    tag->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    if (planned.route == Route::Polled) {
        // The chips behind it stay where they are when its rate is known.
        tag->setText(tagText(polledText(kGreatestRate)));
        tag->setMinimumWidth(tag->sizeHint().width());
    }
    tag->setText(tagText(routeText(planned.route)));
    tag->setPopupMode(QToolButton::InstantPopup);
    tag->setAccessibleName(tr("How %1 is recorded: %2").arg(name, routeText(planned.route)));
    tag->setToolTip(planned.detour == Detour::None ? tr("How this signal is recorded")
                                                   : detourText(planned.detour));
    if (planned.route == Route::Polled)
        m_polledTags[id] = tag;
    auto *menu = new QMenu(tag);
    const std::pair<Route, QString> routes[] = {
        {Route::Fast, tr("HF: every sample")},
        {Route::Slow, tr("MF: 1 of %n samples", nullptr, static_cast<int>(kSlowEvery))},
        {Route::Polled, tr("Polled: read in turn")},
    };
    for (const auto &[route, text] : routes) {
        QAction *action = menu->addAction(text);
        action->setCheckable(true);
        action->setChecked(route == planned.route);
        action->setEnabled(route == Route::Polled || planned.detour != Detour::NotStreamable);
        connect(action, &QAction::triggered, this,
            [this, id, chosen = route] { m_selection.plan().setRoute(id, chosen); });
    }
    menu->addSeparator();
    addColors(*menu, [this, id](QMenu &colors) { m_selection.fillColors(colors, id); });
    tag->setMenu(menu);
    chip->setMenu(menu);

    chip->fill(name, tag, [this, id] { m_selection.remove(id); });
    return chip;
}

/// The rate on the tag; what it means, and how well the times are known, in its tool tip.
void ChannelStrip::showRates()
{
    for (const PlannedSignal &planned : m_selection.plan().planned().signalList) {
        const auto tag = m_polledTags.find(planned.id);
        if (tag == m_polledTags.end())
            continue;
        QString text = routeText(planned.route);
        QStringList tip;
        if (planned.detour != Detour::None)
            tip.append(detourText(planned.detour));
        if (const auto reached = m_rates.reached(planned.id)) {
            const QString rate = rateText(reached->hz);
            text = polledText(reached->hz);
            tip.append(tr("Read %1 times a second.").arg(rate));
            if (reached->spread_s > 0.0)
                tip.append(
                    tr("Each value is one of the %1 ms before the time at which it is drawn: "
                       "question and answer lie so far apart.")
                        .arg(numberText(reached->spread_s * 1e3, 1)));
        }
        tag->second->setText(tagText(text));
        tag->second->setToolTip(
            tip.isEmpty() ? tr("How this signal is recorded") : tip.join(QLatin1Char('\n')));
        tag->second->setAccessibleDescription(tip.join(QLatin1Char(' ')));
    }
}

QWidget *ChannelStrip::makeComputedChip(const Computed &computed)
{
    const QString name = computed.name;
    auto *chip = new Chip(computed.color, m_chips);
    auto *tag = new QToolButton(chip);
    tag->setAutoRaise(true);
    tag->setText(QStringLiteral("\u0192")); // the sign of a function
    tag->setAccessibleName(tr("How %1 is computed").arg(name));
    tag->setToolTip(plainToolTip(computed.formula));
    connect(tag, &QToolButton::clicked, this, [this, name] { Q_EMIT computedChosen(name); });
    auto *menu = new QMenu(chip);
    connect(menu->addAction(tr("&Formula\u2026")), &QAction::triggered, this,
        [this, name] { Q_EMIT computedChosen(name); });
    addColors(*menu, computed.fillColors);
    chip->setMenu(menu);
    chip->fill(name, tag, [this, name] { Q_EMIT computedRemoved(name); });
    return chip;
}

void ChannelStrip::setComputed(const QList<Computed> &computed)
{
    if (computed == m_computed)
        return;
    m_computed = computed;
    rebuild();
}

void ChannelStrip::foldWhen(std::function<bool()> crowded)
{
    m_isCrowded = std::move(crowded);
    room();
}

void ChannelStrip::room()
{
    const bool crowded = m_isCrowded && m_isCrowded();
    if (crowded != std::exchange(m_crowded, crowded))
        fold();
}

void ChannelStrip::fold()
{
    if (!m_crowded && m_foldedByHand == std::optional(false))
        m_foldedByHand.reset(); // what was unfolded for want of room is as new when there is room
    m_folded = m_foldedByHand.value_or(m_crowded);
    showFold();
}

void ChannelStrip::showFold()
{
    // A file costs nothing of a link and takes no further signal; math channels it can have.
    const bool file = m_selection.plan().showsFile();
    const int count = m_flow->count();
    setVisible(!file || count != 0);
    m_empty->setVisible(count == 0 && !file);
    // Nor has a board a rate that records nothing by itself.
    const bool rate = !file && (!m_device.identified() || m_device.streamLimits().tickHz > 0.0);
    m_rate->setVisible(rate);
    m_rateLabel->setVisible(rate);
    m_budget->setVisible(!file);
    m_chips->setVisible(count != 0 && !m_folded);
    m_chips->updateGeometry();
    // Where the chips are seen the sign says enough.
    m_fold->setText(!m_folded ? QStringLiteral("\u25be")
                              : QStringLiteral("\u25b8 ") + tr("%n signal(s)", nullptr, count));
    m_fold->setVisible(count != 0);
    const QString says = m_folded ? tr("Shows the signals as chips")
                                  : tr("Folds the chips away: more room for the plots");
    m_fold->setToolTip(says);
    m_fold->setAccessibleName(says);
}

void ChannelStrip::rebuild()
{
    m_polledTags.clear();
    while (QLayoutItem *item = m_flow->takeAt(0)) {
        if (item->widget()) {
            item->widget()->hide();
            item->widget()->deleteLater();
        }
        delete item;
    }
    const bool file = m_selection.plan().showsFile();
    QList<QWidget *> chips;
    for (const PlannedSignal &planned :
        file ? std::vector<PlannedSignal>() : m_selection.plan().planned().signalList)
        chips.append(makeChip(planned));
    for (const Computed &computed : m_computed)
        chips.append(makeComputedChip(computed));
    for (QWidget *chip : chips) {
        m_flow->addWidget(chip);
        chip->show();
    }
    showFold();
    showRates();
    updateBudget();
}

/// What reading one by one gives: planned, and the slowest of what is reached.
QString ChannelStrip::pollingText(int polled) const
{
    const double planned = m_device.streamLimits().readsPerSecond / polled;
    QString text = tr("each signal read up to %1 times a second").arg(numberText(planned, 0));
    std::optional<double> slowest;
    for (const auto &[id, tag] : m_polledTags)
        if (const auto reached = m_rates.reached(id))
            slowest = std::min(slowest.value_or(reached->hz), reached->hz);
    if (slowest)
        text += tr(", reached %1").arg(rateText(*slowest));
    return text;
}

void ChannelStrip::updateBudget()
{
    const ChannelPlan &plan = m_selection.plan().planned();
    const double link = m_device.streamLimits().linkBytesPerSecond;
    m_rate->setCurrentIndex(m_rate->findData(
        plan.stream.fast.empty() ? m_selection.plan().fastEvery() : plan.stream.fastEvery));
    if (plan.signalList.empty() || link <= 0.0) {
        m_budget->clear();
        m_budget->setToolTip({});
        return;
    }
    const auto polledOnly = static_cast<int>(plan.polled.size());
    if (plan.bytesPerSecond <= 0.0 && polledOnly > 0
        && m_device.streamLimits().readsPerSecond > 0.0) {
        m_budget->setText(pollingText(polledOnly));
        m_budget->setToolTip(
            tr("This board records nothing by itself. Its line of %1 kB/s is shared "
               "by the signals, the registers that are seen and the motor's state.")
                .arg(numberText(link / 1000.0, 1)));
        m_budget->setAccessibleDescription(m_budget->toolTip());
        return;
    }
    QString text = tr("%1 of %2 kB/s (%3 %)", "used, available, percent")
                       .arg(numberText(plan.bytesPerSecond / 1000.0, 1),
                           numberText(link / 1000.0, 0), numberText(plan.share * 100.0, 0));
    if (m_measured)
        text += tr(", measured %1 kB/s").arg(numberText(*m_measured / 1000.0, 1));
    if (plan.rateLowered)
        text += QStringLiteral("  \u2022  ") + tr("rate lowered to fit the link");
    int polled = 0;
    for (const PlannedSignal &planned : plan.signalList)
        polled +=
            planned.detour == Detour::TooManySignals || planned.detour == Detour::LinkFull ? 1 : 0;
    if (polled > 0)
        text += QStringLiteral("  \u2022  ")
            + tr("%n signal(s) polled, see the chips", nullptr, polled);
    m_budget->setText(text);
    QStringList lines{
        tr("Planned: %1 kB/s of %2 kB/s; one packet every %3 ms.")
            .arg(numberText(plan.bytesPerSecond / 1000.0, 1), numberText(link / 1000.0, 1),
                numberText(plan.packetSeconds * 1e3, 1)),
        tr("This link carries %n HF signal(s) at every control period.", nullptr,
            static_cast<int>(plan.fitAtFullRate))};
    if (plan.rateLowered)
        lines.append(tr("At the chosen rate it would be %1 kB/s: recorded at one period in %2.")
                         .arg(numberText(plan.fullRateBytes / 1000.0, 1),
                             QString::number(plan.stream.fastEvery)));
    m_budget->setToolTip(lines.join(QLatin1Char('\n')));
    m_budget->setAccessibleDescription(lines.join(QLatin1Char(' ')));
}

void ChannelStrip::measure(Milliseconds now)
{
    const std::uint64_t bytes = m_device.counters().bytesIn;
    const Milliseconds since = now - m_measuredAt;
    if (since < kMeasureOver)
        return;
    const bool counted = m_measuredAt.count() > 0 && bytes >= m_bytesBefore;
    const bool streams = m_selection.plan().planned().bytesPerSecond > 0.0 && m_device.answering();
    m_measured.reset();
    if (counted && streams)
        m_measured = static_cast<double>(bytes - m_bytesBefore) / toSeconds(since);
    m_bytesBefore = bytes;
    m_measuredAt = now;
    m_rates.turn();
    showRates();
    updateBudget();
}

} // namespace widgets
