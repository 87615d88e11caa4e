#include "widgets/measuring/xy_panel.h"

#include "catalog/motor_signals.h"
#include "widgets/base/device_text.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/reading_text.h"
#include "widgets/base/value_text.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/measuring/trace_box.h"
#include "widgets/registers/model.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace widgets {

namespace {
constexpr int kXySideWidth = 250;
constexpr double kNewest = 0.1; ///< seconds
constexpr std::size_t kPointsAPixel = 8; ///< of the plot's width and height: some turns of a circle
enum class XyRange { Picture, NewestStretch, BetweenCursors };

struct Vector {
    catalog::SignalNames x, y; ///< the first pair that is recorded is taken
    const char *missing = nullptr;
};
/// In the order of XyPanel::Kind, but for the last one.
constexpr std::array kVectors{
    Vector{catalog::kCurrentAlpha, catalog::kCurrentBeta,
        QT_TRANSLATE_NOOP("widgets::XyPanel",
            "Record I_A and I_B, or the currents \u03b1 and \u03b2, to see this.")},
    Vector{catalog::kCurrentD, catalog::kCurrentQ,
        QT_TRANSLATE_NOOP("widgets::XyPanel", "Record the measured currents d and q to see this.")},
    Vector{catalog::kVoltageAlpha, catalog::kVoltageBeta,
        QT_TRANSLATE_NOOP("widgets::XyPanel", "Record V_ALPHA and V_BETA to see this.")},
    Vector{catalog::kVoltageD, catalog::kVoltageQ,
        QT_TRANSLATE_NOOP("widgets::XyPanel", "Record V_D and V_Q to see this.")}};
} // namespace

XyPanel::XyPanel(ScopeView &scope, const capture::Capture &capture, const RegisterModel &registers,
    ChosenMotor motor, QWidget *parent)
    : Form(parent)
    , m_scope(scope)
    , m_capture(capture)
    , m_registers(registers)
    , m_motor(std::move(motor))
    , m_plot(new XyPlot(this))
    , m_kind(new QComboBox(this))
    , m_x(new QComboBox(this))
    , m_y(new QComboBox(this))
    , m_range(new QComboBox(this))
    , m_trail(new QComboBox(this))
    , m_equal(new QCheckBox(tr("E&qual scales"), this))
    , m_note(wrappedLabel("xyNote", this))
{
    setObjectName(QStringLiteral("xyPanel"));
    m_pool.setMaxThreadCount(1);
    m_form = makeChoices();
    auto *sideWidget = new QWidget(this);
    sideWidget->setFixedWidth(kXySideWidth);
    auto *side = bare(new QVBoxLayout(sideWidget));
    side->addLayout(m_form);
    side->addWidget(m_equal);
    side->addWidget(m_note);
    side->addStretch(1);
    auto *layout = edged(new QHBoxLayout(this), kToolEdges);
    layout->addWidget(sideWidget);
    layout->addWidget(m_plot, 1);

    connect(&scope, &ScopeView::channelsChanged, this, &XyPanel::fillTraces);
    connect(&scope, &ScopeView::drawn, this, &XyPanel::compute);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &XyPanel::kindChosen);
    for (QComboBox *box : {m_x, m_y})
        connect(box, &QComboBox::currentIndexChanged, this, &XyPanel::compute);
    connect(m_range, &QComboBox::activated, this, [this](int range) {
        if (range == static_cast<int>(XyRange::BetweenCursors) && !m_scope.cursors().visible())
            m_scope.cursorActions().toggle();
        compute();
    });
    connect(m_trail, &QComboBox::currentIndexChanged, this, &XyPanel::showAnswer);
    connect(m_equal, &QCheckBox::toggled, this, &XyPanel::showAnswer);
    fillTraces();
    kindChosen();
}

QFormLayout *XyPanel::makeChoices()
{
    const auto named = [](QComboBox *field, const char *name) {
        field->setObjectName(QLatin1String(name));
        field->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        new WheelGuard(field);
    };
    named(m_kind, "xyKind");
    named(m_x, "xyX");
    named(m_y, "xyY");
    named(m_range, "xyRange");
    named(m_trail, "xyTrail");
    m_equal->setObjectName(QStringLiteral("xyEqual"));
    m_equal->setChecked(true);
    m_kind->addItems({tr("Currents \u03b1 \u03b2"), tr("Currents d q"),
        tr("Voltages \u03b1 \u03b2"), tr("Voltages d q"), tr("Two traces")});
    m_range->addItems({tr("the picture"), tr("its newest 100 ms"), tr("between the cursors")});
    m_trail->addItem(tr("the older the paler"), int(XyPlot::Trail::Fading));
    m_trail->addItem(tr("all alike"), int(XyPlot::Trail::Alike));
    m_trail->addItem(tr("the newest only"), int(XyPlot::Trail::None));
    auto *form = new QFormLayout;
    form->addRow(tr("Dra&w"), m_kind);
    form->addRow(tr("&X"), m_x);
    form->addRow(tr("&Y"), m_y);
    form->addRow(tr("&In"), m_range);
    form->addRow(tr("T&rail"), m_trail);
    return form;
}

void XyPanel::fillTraces()
{
    fillTraceBox(*m_x, m_scope, m_capture);
    fillTraceBox(*m_y, m_scope, m_capture, 1);
    compute();
}

void XyPanel::choose(capture::ChannelId channel)
{
    m_kind->setCurrentIndex(static_cast<int>(Kind::Any));
    m_y->setCurrentIndex(m_y->findData(channel));
}

XyPanel::Kind XyPanel::kind() const { return static_cast<Kind>(m_kind->currentIndex()); }

bool XyPanel::isVoltage() const
{
    return kind() == Kind::VoltageAlphaBeta || kind() == Kind::VoltageDq;
}

void XyPanel::kindChosen()
{
    const bool any = kind() == Kind::Any;
    for (QWidget *field : std::initializer_list<QWidget *>{m_x, m_y}) {
        field->setVisible(any);
        m_form->labelForField(field)->setVisible(any);
    }
    m_equal->setVisible(any); // vectors have no other
    Q_EMIT watchedRegistersChanged();
    m_answered.reset(); // what is missing is another thing now
    compute();
}

/// The channel of that name and motor that got a sample last.
std::optional<capture::ChannelId> XyPanel::recorded(
    std::string_view signal, const std::string &ending) const
{
    const std::string name = std::string(signal) + ending;
    for (const capture::ChannelInfo &info : m_capture.channels()) {
        if (info.name == name)
            return m_capture.find(info.registerId);
    }
    return std::nullopt;
}

/// Both of it are of one motor.
std::optional<XyPanel::Pair> XyPanel::pair() const
{
    if (kind() == Kind::Any) {
        const Pair chosen{m_x->currentData().toUInt(), m_y->currentData().toUInt(), false};
        return m_capture.channel(chosen.x) && m_capture.channel(chosen.y) ? std::optional(chosen)
                                                                          : std::nullopt;
    }
    for (const std::string &ending : motorEndings(m_motor()))
        if (const auto both = vectorOf(ending))
            return both;
    return std::nullopt;
}

std::optional<XyPanel::Pair> XyPanel::vectorOf(const std::string &ending) const
{
    std::optional<Pair> named;
    const Vector &vector = kVectors.at(static_cast<std::size_t>(kind()));
    for (std::size_t i = 0; i < vector.x.size(); ++i) {
        const auto x = recorded(vector.x.at(i), ending), y = recorded(vector.y.at(i), ending);
        if (x && y && !named)
            named = Pair{*x, *y, false};
    }
    if (kind() != Kind::CurrentAlphaBeta)
        return named;
    const auto a = recorded(catalog::kCurrentA, ending), b = recorded(catalog::kCurrentB, ending);
    // What is recorded now goes before what was once.
    const ScopeView::TimeRange seen = m_scope.visibleRange();
    const bool there = named && !m_capture.extremes(named->x, seen.from, seen.to).empty();
    return a && b && !there ? Pair{*a, *b, true} : named;
}

/// "@2"; empty where there is but one motor.
std::string XyPanel::motorShown() const
{
    const auto info = m_capture.info(m_answered ? m_answered->x : 0);
    return info ? motorEndingOf(info->name) : std::string();
}

QString XyPanel::missingText() const
{
    if (kind() != Kind::Any)
        return tr(kVectors.at(static_cast<std::size_t>(kind())).missing);
    return m_scope.channels().isEmpty() ? tr("No trace is shown on the scope.")
                                        : tr("Choose a trace for X and for Y.");
}

XyWanted XyPanel::wanted() const
{
    ScopeView::TimeRange range = m_scope.visibleRange();
    const CursorPair &cursors = m_scope.cursors().pair();
    if (m_range->currentIndex() == static_cast<int>(XyRange::BetweenCursors)
        && m_scope.cursors().visible())
        range = {std::min(cursors.a, cursors.b), std::max(cursors.a, cursors.b)};
    else if (m_range->currentIndex() == static_cast<int>(XyRange::NewestStretch))
        range.from = std::max(range.from, range.to - kNewest);
    XyWanted wanted;
    const auto both = pair();
    if (!both)
        return wanted;
    wanted.x = both->x;
    wanted.y = both->y;
    wanted.clarke = both->clarke;
    wanted.from = capture::toNanos(range.from);
    wanted.to = capture::toNanos(range.to);
    for (const capture::ChannelId id : {both->x, both->y})
        wanted.samples += m_capture.channel(id)->countIn(range.from, range.to);
    const QSize area = m_plot->area().size();
    const auto pixels = std::size_t(std::max(area.width() + area.height(), 400));
    wanted.most = std::min(kPointsAPixel * pixels, wanted.most);
    return wanted;
}

std::vector<catalog::RegisterId> XyPanel::watchedRegisters() const
{
    const auto bus = m_registers.idOf(catalog::kBusVoltage);
    return isVoltage() && bus ? std::vector{*bus} : std::vector<catalog::RegisterId>();
}

/// As recorded in the picture, else as it was asked for last.
std::optional<double> XyPanel::busVolts() const
{
    for (const std::string &ending : {motorShown(), std::string()}) {
        if (const auto channel = recorded(catalog::kBusVoltage, ending))
            if (const auto value = m_capture.valueAt(*channel, m_scope.visibleRange().to))
                return value;
    }
    const auto id = m_registers.idOf(catalog::kBusVoltage);
    return id ? m_registers.shownValue(*id) : std::nullopt;
}

void XyPanel::refresh(Milliseconds) { compute(); }

void XyPanel::focusFirst()
{
    m_kind->setFocus(Qt::ShortcutFocusReason);
    compute();
}

/// One job at a time; what changed meanwhile is seen when the scope draws again, or at the next heartbeat.
void XyPanel::compute()
{
    if (!m_rest.over(m_scope.running()) || !isVisible())
        return;
    const XyWanted next = wanted();
    if (next == m_answered) {
        if (isVoltage())
            showAnswer(); // the bus may have changed
        return;
    }
    if (next.x == 0) {
        m_answered = next;
        m_answer = {};
        m_note->clear();
        m_plot->showNothing(missingText());
        return;
    }
    m_rest.begin();
    const std::array ids{next.x, next.y};
    const capture::Snapshot copy = m_capture.snapshot(ids);
    m_pool.start([this, copy, next] {
        const auto answer = std::make_shared<const XyAnswer>(computeXy(copy, next));
        QMetaObject::invokeMethod(
            this, [this, answer] { accept(*answer); }, Qt::QueuedConnection);
    });
}

void XyPanel::accept(const XyAnswer &answer)
{
    m_rest.end();
    m_answered = answer.wanted;
    m_answer = answer;
    showAnswer();
}

QString XyPanel::labelOf(capture::ChannelId channel, const QString &instead) const
{
    const auto info = m_capture.info(channel);
    const QString name = instead.isEmpty() ? m_scope.nameOf(channel) : instead;
    const QString unit = info ? unitText(info->unit) : QString();
    return unit.isEmpty() ? name : tr("%1 in %2", "a signal and its unit").arg(name, unit);
}

void XyPanel::showAnswer()
{
    if (!m_answered || m_answered->x == 0)
        return;
    XyPlot::Picture picture;
    picture.points = m_answer.trace.points;
    const bool clarke = m_answered->clarke;
    const QString motor = QString::fromStdString(motorShown());
    picture.xLabel = labelOf(m_answered->x, clarke ? QStringLiteral("I\u03b1") + motor : QString());
    picture.yLabel = labelOf(m_answered->y, clarke ? QStringLiteral("I\u03b2") + motor : QString());
    picture.vector = kind() != Kind::Any;
    picture.equal = picture.vector || m_equal->isChecked();
    picture.trail = static_cast<XyPlot::Trail>(m_trail->currentData().toInt());
    if (isVoltage()) {
        picture.busVolts = busVolts().value_or(0.0);
        picture.hexagon = kind() == Kind::VoltageAlphaBeta;
    }
    if (picture.points.empty()) {
        m_note->clear();
        m_plot->showNothing(tr("Nothing is recorded of both at the same time in this stretch."));
        return;
    }
    showNote(picture);
    m_plot->showPicture(std::move(picture));
}

void XyPanel::showNote(const XyPlot::Picture &picture)
{
    QStringList lines;
    const scope::XyPoint &newest = picture.points.back();
    const auto info = m_capture.info(m_answered->x);
    const QString unit = info ? deviceText(info->unit) : QString();
    const auto text = [&](double value) {
        const double step = std::pow(10.0, std::floor(std::log10(std::abs(value) + 1e-9)) - 2);
        return readingText(value, step, unit, m_scope.locale());
    };
    if (picture.vector) {
        const double turn = std::atan2(newest.y, newest.x) * 180.0 / std::numbers::pi;
        lines.append(tr("Newest: %1 at %2\u00b0", "the length and the angle of a vector")
                         .arg(text(std::hypot(newest.x, newest.y)), numberText(turn, 1)));
    }
    lines.append(tr("%n point(s)", nullptr, static_cast<int>(picture.points.size())));
    if (m_answer.trace.every > 1)
        lines.last() += tr(", each of %1 instants", "a number, such as 4")
                            .arg(QString::number(m_answer.trace.every));
    if (m_answered->clarke)
        lines.append(tr("Computed from I_A and I_B, \u03b2 as the board counts it."));
    if (m_answer.cut)
        lines.append(tr("only the newest samples"));
    if (isVoltage())
        lines.append(picture.busVolts > 0.0
                ? tr("Dashed: what the bus allows; dotted: without distortion.")
                : tr("The bus voltage is not known, so its limits are not drawn."));
    m_note->setText(lines.join(QLatin1Char('\n')));
    m_plot->setAccessibleDescription(lines.first());
}

} // namespace widgets
