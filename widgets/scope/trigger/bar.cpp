#include "widgets/scope/trigger/bar.h"

#include "widgets/base/device.h"
#include "widgets/base/device_text.h"
#include "widgets/base/fields/value_edit.h"
#include "widgets/base/flow_layout.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/reading_text.h"
#include "widgets/base/steady_label.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/scope/trigger/control.h"
#include "widgets/scope/trigger/snug_combo_box.h"
#include "widgets/scope/view.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QFormLayout>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {
constexpr int kLevelMargin = 12; ///< pixels: what a field takes beside its text
constexpr int kDetailWidth = 120;
constexpr int kMostLetters = 12; ///< of a choice in the bar; whole in the list
constexpr int kNameLetters = 20; ///< the same of a trace's name
constexpr double kLongestTime = 60.0; ///< seconds
constexpr double kShortestRecord = 1e-5;
constexpr QLatin1String kBeforeAge(" \xb7 ");

QString fileText() { return TriggerBar::tr("File: replay it to trigger"); }

/// The state's word with a sign of its own, so that its colour is never the only one.
QString stateSign(scope::AcquisitionState state)
{
    switch (state) {
    case scope::AcquisitionState::Stop:
        return QStringLiteral("\u25a0 ");
    case scope::AcquisitionState::Armed:
        return QStringLiteral("\u25cb ");
    case scope::AcquisitionState::Triggered:
        return QStringLiteral("\u25cf ");
    case scope::AcquisitionState::Auto:
    case scope::AcquisitionState::Roll:
        break;
    }
    return QStringLiteral("\u25b6 ");
}
} // namespace

TriggerBar::TriggerBar(
    TriggerControl &control, ScopeView &scope, const Device &device, QWidget *parent)
    : QWidget(parent)
    , m_control(control)
    , m_scope(scope)
    , m_device(device)
    , m_mode(new SnugComboBox(kMostLetters, this))
    , m_type(new SnugComboBox(kMostLetters, this))
    , m_source(new SnugComboBox(kNameLetters, this))
    , m_written(new SnugComboBox(kNameLetters, this))
    , m_way(new QComboBox(this))
    , m_level(named(new ValueEdit(this), "triggerLevel"))
    , m_single(new QToolButton(this))
    , m_force(new QToolButton(this))
    , m_more(new QToolButton(this))
    , m_state(named(new SteadyLabel(this), "triggerState"))
{
    setObjectName(QStringLiteral("triggerBar"));
    makeBar();
    connect(&control, &TriggerControl::changed, this, &TriggerBar::follow);
    connect(&control, &TriggerControl::stateChanged, this, &TriggerBar::showState);
    connect(&scope, &ScopeView::channelsChanged, this, &TriggerBar::fillSources);
    connect(&device, &Device::identityChanged, this, &TriggerBar::fillWritten);
    follow();
}

void TriggerBar::makeBar()
{
    const auto choice = [this](QComboBox *box, const char *name, const QString &says) {
        named(box, name, says)->setToolTip(says);
        new WheelGuard(box);
    };
    choice(m_mode, "triggerMode",
        tr("Roll: the newest samples. Auto: records, also without a trigger. "
           "Normal: keeps the last record. Single: one record"));
    choice(m_type, "triggerType", tr("What the trigger waits for"));
    choice(m_source, "triggerSource", tr("The trace that is watched"));
    choice(m_written, "triggerWritten", tr("The register whose write is waited for"));
    choice(m_way, "triggerWay", {});
    m_way->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_mode->setAccessibleName(tr("Mode of the trigger"));
    using scope::Mode;
    for (const Mode mode : {Mode::Roll, Mode::Auto, Mode::Normal, Mode::Single})
        m_mode->addItem(modeText(mode), static_cast<int>(mode));
    for (int type = 0; type < kTriggerTypes; ++type)
        m_type->addItem(typeText(static_cast<TriggerType>(type)), type);
    const auto button = [](QToolButton *tool, const char *name, const QString &text,
                            const QString &says) {
        named(tool, name, says)->setToolTip(says);
        tool->setText(text);
        tool->setFocusPolicy(Qt::TabFocus);
    };
    button(m_single, "triggerSingle", tr("Single"), tr("Takes one record, then stops (S)"));
    button(m_force, "triggerForce", tr("Force"), tr("A trigger now (T)"));
    button(m_more, "triggerMore", QStringLiteral("\u22ef"), tr("All settings of the trigger"));

    auto *layout = edged(new QHBoxLayout(this), {kGrid, 0, kGrid, kHalfGrid}, kHalfGrid);
    auto *fields = new QWidget(this); // two lines where the words are long and the screen is small
    auto *flow = new FlowLayout(kHalfGrid, fields);
    for (QWidget *widget : std::initializer_list<QWidget *>{
             m_mode, m_single, m_force, m_type, m_source, m_written, m_way, m_level, m_more})
        flow->addWidget(widget);
    layout->addWidget(fields, 1);
    m_state->setMinimumHeight(m_mode->sizeHint().height()); // beside the first line
    layout->addWidget(m_state, 0, Qt::AlignTop);

    connect(m_mode, &QComboBox::activated, this, [this](int index) {
        m_control.setMode(static_cast<Mode>(m_mode->itemData(index).toInt()));
    });
    connect(m_type, &QComboBox::activated, this, [this](int index) {
        change([this, index](TriggerSetup &setup) {
            setup.type = static_cast<TriggerType>(m_type->itemData(index).toInt());
            setup.way = TriggerWay::First;
            if (fieldsOf(setup.type).upper && setup.upper <= setup.level)
                setup.upper = setup.level + std::max(std::abs(setup.level), 1.0);
        });
    });
    connect(m_source, &QComboBox::activated, this,
        [this](int index) { m_control.trigger().setSource(m_source->itemData(index).toUInt()); });
    connect(m_written, &QComboBox::activated, this, [this](int index) {
        change([this, index](
                   TriggerSetup &setup) { setup.written = m_written->itemData(index).toString(); });
    });
    connect(m_way, &QComboBox::activated, this, [this](int index) {
        change([index](TriggerSetup &setup) { setup.way = static_cast<TriggerWay>(index); });
    });
    connect(m_level, &ValueEdit::committed, this,
        [this](double value) { change([value](TriggerSetup &setup) { setup.level = value; }); });
    connect(m_single, &QToolButton::clicked, &m_control, &TriggerControl::single);
    connect(m_force, &QToolButton::clicked, &m_control.trigger(), &Trigger::force);
    connect(m_more, &QToolButton::clicked, this, &TriggerBar::openDetails);
}

QWidget *TriggerBar::makeDetails()
{
    auto *details = named(new QFrame(this, Qt::Popup), "triggerDetails");
    details->setFrameShape(QFrame::StyledPanel);
    m_form = new QFormLayout(details);
    const auto number = [this, details](const char *name, const QString &label, bool time,
                            double least, double most, double TriggerSetup::*field) {
        auto *edit = named(new ValueEdit(details), name);
        edit->setFixedWidth(kDetailWidth);
        edit->setBounds(least, most);
        if (time)
            edit->setTime();
        m_form->addRow(label, edit);
        connect(edit, &ValueEdit::committed, this, [this, field](double value) {
            change([field, value](TriggerSetup &setup) { setup.*field = value; });
        });
        return edit;
    };
    m_upper = number("triggerUpper", tr("&Upper level"), false, -1e12, 1e12, &TriggerSetup::upper);
    m_hysteresis =
        number("triggerHysteresis", tr("&Hysteresis"), false, 0.0, 1e12, &TriggerSetup::hysteresis);
    m_inside = named(new QComboBox(details), "triggerInside");
    m_inside->addItems({tr("between these times"), tr("all but between them")});
    new WheelGuard(m_inside);
    m_form->addRow(tr("&Duration"), m_inside);
    m_least =
        number("triggerLeast", tr("At &least"), true, 0.0, kLongestTime, &TriggerSetup::least);
    m_most = number("triggerMost", tr("At &most"), true, 0.0, kLongestTime, &TriggerSetup::most);
    m_time = number("triggerTime", tr("&Pause"), true, 0.0, kLongestTime, &TriggerSetup::time);
    m_count = named(new QSpinBox(details), "triggerCount");
    m_count->setRange(1, 1'000'000);
    m_count->setKeyboardTracking(false);
    new WheelGuard(m_count);
    m_form->addRow(tr("&Edges"), m_count);
    m_preTrigger = named(new ValueEdit(details), "triggerPre");
    m_preTrigger->setFixedWidth(kDetailWidth);
    m_preTrigger->setPlain(QStringLiteral("%"), 0.1);
    m_preTrigger->setBounds(0.0, 100.0);
    m_form->addRow(tr("Pre-trig&ger"), m_preTrigger);
    m_holdOff =
        number("triggerHoldOff", tr("Hold-&off"), true, 0.0, kLongestTime, &TriggerSetup::holdOff);
    m_length = number("triggerLength", tr("&Record length"), true, kShortestRecord, kLongestTime,
        &TriggerSetup::length);
    m_middle = named(new QPushButton(tr("Set level to &50 %"), details), "triggerMiddle");
    m_form->addRow(m_middle);
    m_problem = wrappedLabel("triggerProblem", details);
    m_form->addRow(m_problem);
    // Esc is Stop, everywhere: what it closes elsewhere needs another way out.
    auto *away = named(new QPushButton(tr("&Close"), details), "triggerDetailsClose");
    connect(away, &QPushButton::clicked, details, &QWidget::close);
    m_form->addRow(away);

    connect(m_inside, &QComboBox::activated, this, [this](int index) {
        change([index](TriggerSetup &setup) { setup.outside = index == 1; });
    });
    connect(m_count, &QSpinBox::valueChanged, this,
        [this](int value) { change([value](TriggerSetup &setup) { setup.count = value; }); });
    connect(m_preTrigger, &ValueEdit::committed, this, [this](double value) {
        change([value](TriggerSetup &setup) { setup.preTrigger = value / 100.0; });
    });
    connect(m_middle, &QPushButton::clicked, &m_control.trigger(), &Trigger::levelToMiddle);
    return details;
}

void TriggerBar::change(const std::function<void(TriggerSetup &)> &edit)
{
    TriggerSetup setup = m_control.trigger().setup();
    edit(setup);
    m_control.setSetup(setup);
}

void TriggerBar::openDetails()
{
    m_details->adjustSize();
    const QPoint below = m_more->mapToGlobal(QPoint(0, m_more->height() + 2));
    m_details->move(below);
    m_details->show();
    m_hysteresis->setFocus(Qt::PopupFocusReason);
}

void TriggerBar::fillSources()
{
    QString made;
    for (const capture::ChannelId id : m_scope.channels())
        made += QString::number(id) + QLatin1Char(' ');
    const auto source = m_control.trigger().source();
    if (made != m_sourcesShown) {
        m_sourcesShown = made;
        m_source->clear();
        for (const capture::ChannelId id : m_scope.channels())
            m_source->addItem(m_scope.nameOf(id), id);
    }
    m_source->setCurrentIndex(source ? m_source->findData(source->id) : -1);
}

/// Those of the board that can be written, and the chosen one though this board may not have it.
void TriggerBar::fillWritten()
{
    const TriggerSetup &setup = m_control.trigger().setup();
    if (!fieldsOf(setup.type).written)
        return;
    QStringList names;
    if (const auto catalog = m_device.catalog())
        for (const catalog::RegisterInfo &info : catalog->registers()) {
            const int motors = info.perMotor ? catalog->motors() : 1;
            for (int motor = 1; info.writable() && !info.stub && motor <= motors; ++motor)
                names.append(deviceText(catalog->nameOf(catalog->withMotor(info, motor))));
        }
    const auto isChosen = [&](const QString &name) { return plainName(name) == setup.written; };
    if (!setup.written.isEmpty() && std::none_of(names.begin(), names.end(), isChosen))
        names.append(setup.written);
    names.sort();
    names.prepend(tr("Any register"));
    QStringList shown;
    for (int i = 0; i < m_written->count(); ++i)
        shown.append(m_written->itemText(i));
    if (shown != names) {
        m_written->clear();
        m_written->addItem(names.first(), QString());
        for (const QString &name : names.mid(1))
            m_written->addItem(name, plainName(name));
    }
    m_written->setCurrentIndex(m_written->findData(setup.written));
}

void TriggerBar::fillWays()
{
    const QList<WayText> ways = wayTexts(m_control.trigger().setup().type);
    const auto same = [this](const WayText &way, int index) {
        return m_way->itemText(index) == way.sign
            && m_way->itemData(index, Qt::ToolTipRole).toString() == way.word;
    };
    bool made = m_way->count() == ways.size();
    for (int i = 0; made && i < ways.size(); ++i)
        made = same(ways[i], i);
    if (!made) {
        m_way->clear();
        for (int i = 0; i < ways.size(); ++i) {
            m_way->addItem(ways[i].sign);
            m_way->setItemData(i, ways[i].word, Qt::ToolTipRole);
            m_way->setItemData(i, ways[i].word, Qt::AccessibleTextRole);
        }
    }
    const int chosen = static_cast<int>(m_control.trigger().setup().way);
    m_way->setCurrentIndex(chosen);
    const QString word = chosen < ways.size() ? ways[chosen].word : QString();
    m_way->setToolTip(word);
    m_way->setAccessibleName(tr("Which way: %1").arg(word));
}

void TriggerBar::follow()
{
    const TriggerSetup &setup = m_control.trigger().setup();
    const TriggerFields fields = fieldsOf(setup.type);
    const bool awaits = m_control.trigger().awaitsSamples();
    const bool triggered = setup.mode != scope::Mode::Roll;
    const bool on = triggered || !awaits; // a file is searched for it
    m_mode->setCurrentIndex(m_mode->findData(static_cast<int>(setup.mode)));
    m_type->setCurrentIndex(m_type->findData(static_cast<int>(setup.type)));
    fillSources();
    fillWays();
    fillWritten();
    const auto source = m_control.trigger().source();
    const QString unit = source ? QString::fromStdString(source->unit) : QString();
    const double step = source && source->kind != capture::ChannelInfo::Kind::Polled
        ? std::abs(source->factor)
        : 0.001;
    m_level->setPlain(unit, step);
    fitLevel(setup.level, step, unit);
    m_level->setValue(setup.level);
    m_level->setAccessibleName(levelName(setup.type));
    m_level->setToolTip(
        tr("%1; also the arrow at the right edge of the plot").arg(levelName(setup.type)));

    m_mode->setEnabled(awaits || triggered); // back to Roll
    m_single->setEnabled(awaits);
    m_force->setEnabled(awaits);
    m_state->setRoomFor(awaits ? stateTexts(!triggered) : QStringList{fileText()});
    m_type->setVisible(on);
    m_force->setVisible(triggered);
    m_more->setVisible(on);
    m_source->setVisible(on && fields.source);
    m_written->setVisible(on && fields.written && awaits);
    m_way->setVisible(on && fields.ways);
    m_level->setVisible(on && fields.source);
    if (on && !m_details)
        m_details = makeDetails(); // the button that opens them is shown from here on
    if (m_details)
        followDetails(unit, step);
    showState();
}

/// Wide enough for its value in the unit of the trace; it grows, and does not shrink while the digits change.
void TriggerBar::fitLevel(double level, double step, const QString &unit)
{
    const QString widest = readingText(-std::abs(level), step, unit, locale());
    const int width = m_level->fontMetrics().horizontalAdvance(widest) + kLevelMargin;
    m_level->setFixedWidth(std::max(width, unit == m_levelUnit ? m_level->minimumWidth() : 0));
    m_levelUnit = unit;
}

void TriggerBar::followDetails(const QString &unit, double step)
{
    const TriggerSetup &setup = m_control.trigger().setup();
    const TriggerFields fields = fieldsOf(setup.type);
    for (ValueEdit *edit : {m_upper, m_hysteresis})
        edit->setPlain(unit, step);
    m_upper->setValue(setup.upper);
    m_hysteresis->setValue(setup.hysteresis);
    m_inside->setCurrentIndex(setup.outside ? 1 : 0);
    m_least->setValue(setup.least);
    m_most->setValue(setup.most);
    m_time->setValue(setup.time);
    const QSignalBlocker quiet(m_count);
    m_count->setValue(setup.count);
    m_preTrigger->setValue(setup.preTrigger * 100.0);
    m_holdOff->setValue(setup.holdOff);
    m_length->setValue(setup.length);

    const auto row = [this](QWidget *field, bool visible) {
        m_form->labelForField(field)->setVisible(visible);
        field->setVisible(visible);
    };
    row(m_upper, fields.upper);
    row(m_hysteresis, fields.hysteresis && fields.source);
    row(m_inside, fields.durations);
    row(m_least, fields.durations);
    row(m_most, fields.durations);
    row(m_time, fields.time);
    row(m_count, fields.count);
    m_middle->setVisible(fields.source);
    m_problem->setText(
        m_control.trigger().error() ? conditionErrorText(*m_control.trigger().error()) : QString());
    m_problem->setVisible(m_control.trigger().error().has_value());
    m_details->adjustSize();
}

/// What it may say: with a state that changes many times a second the fields beside it are not to move.
QStringList TriggerBar::stateTexts(bool roll)
{
    using State = scope::AcquisitionState;
    QStringList all;
    if (roll)
        for (const State state : {State::Stop, State::Roll})
            all.append(stateSign(state) + stateText(state));
    else
        for (const State state : {State::Stop, State::Armed, State::Triggered, State::Auto})
            for (const double age : {0.0, 119.0, 3599.0})
                all.append(stateSign(state) + stateText(state) + kBeforeAge + ageText(age));
    return all;
}

void TriggerBar::showState()
{
    const scope::AcquisitionState state = m_control.trigger().state();
    const bool roll = m_control.trigger().setup().mode == scope::Mode::Roll;
    const bool awaits = m_control.trigger().awaitsSamples();
    QString text = awaits ? stateSign(state) + stateText(state) : fileText();
    if (awaits && m_control.trigger().error() && !roll)
        text = QStringLiteral("\u26a0 ") + conditionErrorText(*m_control.trigger().error());
    if (const scope::Record *record = m_control.shown(); record && !roll) {
        const double age = m_control.trigger().now() - capture::toSeconds(record->trigger);
        text += kBeforeAge + ageText(age);
    }
    m_state->setText(text);
    m_state->setToolTip(awaits
            ? tr("State of the trigger, and how old the shown record is")
            : tr("The trigger waits for samples, and a file has none to come. A replay of it "
                 "(Ctrl+Shift+R) has."));
    m_state->setAccessibleName(text);
}

void TriggerBar::refreshAge()
{
    if (m_control.shown())
        showState();
}

} // namespace widgets
