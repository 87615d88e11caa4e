#include "widgets/lab/loop/response_page.h"

#include "motor/fixed_point.h"
#include "widgets/base/device_text.h"
#include "widgets/base/fields/whole_spin.h"
#include "widgets/base/flow_layout.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/row_list.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/trace_colors.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/lab/text.h"

#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace widgets {
namespace {

constexpr int kLeast_s = 4, kMost_s = 40, kUsual_s = 16;
/// Colours of the rows.
constexpr int kMeasuredSlot = 0, kWhatIfSlot = 1, kProofSlot = 2, kCurrentSlot = 4;

/// In the order of lab::Goal.
constexpr std::array kGoalTexts{QT_TRANSLATE_NOOP("widgets::ResponsePage", "stiff"),
    QT_TRANSLATE_NOOP("widgets::ResponsePage", "medium"),
    QT_TRANSLATE_NOOP("widgets::ResponsePage", "quick")};

/// A number that is predicted has no interval of its own.
std::optional<lab::Estimate> predictedValue(double value)
{
    return lab::Estimate{value, std::nullopt, std::nullopt};
}

void setForecast(LoopRow &row, const lab::LoopForecast &forecast)
{
    row.kp = forecast.proportional;
    row.ki = forecast.integral;
    if (!(forecast.crossover_hz > 0.0))
        return;
    row.crossover_hz = predictedValue(forecast.crossover_hz);
    row.phaseMargin_deg = predictedValue(forecast.phaseMargin_deg);
    if (!forecast.stable)
        return;
    row.ms = predictedValue(forecast.ms);
    if (forecast.rise_s)
        row.rise_s = predictedValue(*forecast.rise_s);
    row.overshoot_pct = predictedValue(forecast.overshoot_pct);
}

void setMargins(LoopRow &row, const lab::FrequencyResponse &response)
{
    row.crossover_hz = response.crossover_hz;
    row.phaseMargin_deg = response.phaseMargin_deg;
    row.ms = response.ms;
}

} // namespace

ResponsePage::ResponsePage(const Parts &parts, QWidget *parent)
    : Form(parent)
    , m_parts(parts)
    , m_table(new RowList(
          "responseLoops", tr("Loops: measured, what if, proposed, proved"), &m_rows, this))
    , m_plot(new BodePlot(this))
    , m_bar(new ExperimentBar(parts.lab, "response", this))
{
    setObjectName(QStringLiteral("responsePage"));
    auto *both = new QSplitter(Qt::Horizontal, this);
    both->setChildrenCollapsible(false);
    auto *side = new QWidget(this);
    auto *column = bare(new QVBoxLayout(side), kHalfGrid);
    column->addWidget(makeChoices());
    column->addWidget(m_table, 1);
    both->addWidget(m_plot); // as high as there is room
    both->addWidget(side);
    both->setStretchFactor(0, 1);
    both->setStretchFactor(1, 1);
    both->setSizes({1000, 1200}); // shares of what there is
    makeTable();
    auto *layout = edged(new QVBoxLayout(this), {kGrid, kHalfGrid, kGrid, 0});
    layout->addWidget(both);
    makeBar();
    m_soon.setSingleShot(true);
    m_soon.setInterval(0);
    connectParts();
    adoptTuning();
}

/// A field with its label before it, which stay together.
QWidget *ResponsePage::labelled(const QString &text, QWidget *field)
{
    auto *both = new QWidget(this);
    auto *row = bare(new QHBoxLayout(both), kHalfGrid);
    auto *label = new QLabel(text, both);
    label->setBuddy(field);
    field->setAccessibleName(QString(text).remove(QLatin1Char('&')));
    row->addWidget(label);
    row->addWidget(field);
    return both;
}

QSpinBox *ResponsePage::makeSpin(const char *name, const QString &help)
{
    auto *spin = named(new WholeSpin(this), name);
    spin->setToolTip(help);
    new WheelGuard(spin);
    return spin;
}

QWidget *ResponsePage::makeChoices()
{
    m_length = makeSpin("responseLength", tr("The longer, the narrower the error bars"));
    m_length->setRange(kLeast_s, kMost_s);
    m_length->setValue(kUsual_s);
    m_length->setSuffix(QStringLiteral("\u202fs"));
    m_picture = named(new QComboBox(this), "responsePicture");
    m_picture->addItems({tr("speed loop, open"), tr("motor"), tr("current loop, open"),
        tr("current loop, closed")});
    new WheelGuard(m_picture);
    const QString help = tr("Moves the predicted loop; nothing is written until Apply");
    m_kp = makeSpin("whatIfKp", help);
    m_ki = makeSpin("whatIfKi", help);
    for (QSpinBox *gain : {m_kp, m_ki}) {
        gain->setRange(0, motor::kMaxNumerator);
        gain->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        gain->setAccelerated(true);
    }
    m_propose = named(new QPushButton(tr("Pr&opose"), this), "responsePropose");
    m_apply = named(new QPushButton(tr("&Apply"), this), "responseApply");
    m_back = named(new QPushButton(tr("&Back to the old gains"), this), "responseBack");
    auto *choices = new QWidget(this);
    auto *row = new FlowLayout(kGrid, choices);
    for (QWidget *one : {labelled(tr("&Length"), m_length), labelled(tr("P&icture"), m_picture),
             labelled(tr("What if &Kp"), m_kp), labelled(tr("Ki", "a gain"), m_ki),
             static_cast<QWidget *>(m_propose), static_cast<QWidget *>(m_apply),
             static_cast<QWidget *>(m_back)})
        row->addWidget(one);
    return choices;
}

void ResponsePage::makeTable()
{
    m_table->setMinimumHeight(60);
    m_table->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->header()->setStretchLastSection(false);
}

void ResponsePage::makeBar()
{
    LoopTuning &tuning = m_parts.tuning;
    m_bar->setPollable(true);
    m_bar->add({tr("S&peed"), "speedResponseRun",
        tr("Measures how motor and speed loop follow each frequency; then the motor is as it was."),
        [this, &tuning] { return tuning.speedRun(length()); }});
    m_bar->add({tr("&Current"), "currentResponseRun",
        tr("Measures how the current follows its reference; then the motor is as it was."),
        [&tuning] {
            constexpr std::chrono::seconds kLength{6};
            return tuning.currentRun(kLength);
        }});
    m_bar->add({tr("P&rove"), "proveRun",
        tr("Measures the response and steps of 200 rpm with the gains that were applied, and "
           "compares."),
        [this, &tuning]() -> Result<ExperimentBar::Run, QString> {
            if (!tuning.holdsApplied())
                return fail(tr("Apply gains first: they are what is proved."));
            return tuning.proofRun(length(), *tuning.applied());
        }});
}

void ResponsePage::connectParts()
{
    LoopTuning &tuning = m_parts.tuning;
    connect(&tuning, &LoopTuning::changed, this, &ResponsePage::adoptTuning);
    connect(&tuning, &LoopTuning::watchedRegistersChanged, this,
        &ResponsePage::watchedRegistersChanged);
    connect(&tuning, &LoopTuning::written, this, [this](bool, const QString &sentence) {
        if (isVisible())
            m_bar->tell(sentence);
    });
    connect(m_length, &QSpinBox::valueChanged, m_bar, &ExperimentBar::refresh);
    connect(m_picture, &QComboBox::currentIndexChanged, this, &ResponsePage::showCurves);
    for (QSpinBox *gain : {m_kp, m_ki})
        connect(gain, &QSpinBox::valueChanged, this, [this] {
            if (!m_setting)
                m_soon.start();
        });
    connect(&m_soon, &QTimer::timeout, this, [this] {
        whatIf();
        const QScopedValueRollback setting(m_setting, true); // what is written is no candidate's
        m_table->setCurrentIndex(m_rows.index(m_rows.rowOf("what-if"), 0));
    });
    connect(m_propose, &QPushButton::clicked, this, &ResponsePage::propose);
    connect(m_apply, &QPushButton::clicked, this, [this] { m_parts.tuning.apply(gains()); });
    connect(m_back, &QPushButton::clicked, this, [this] { m_parts.tuning.back(); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
        &ResponsePage::chosen);
    // The sentence below the page takes its room from the table.
    connect(m_table->verticalScrollBar(), &QScrollBar::rangeChanged, this, &ResponsePage::showLast,
        Qt::QueuedConnection);
    connect(
        m_table->verticalScrollBar(), &QScrollBar::actionTriggered, this, [this] { m_last = ""; });
    connect(m_bar, &ExperimentBar::ended, this, [this](int which, bool complete) {
        constexpr std::array kRowOf{"measured", "current", "proof"}; // in the order of the buttons
        m_last = complete ? kRowOf[std::size_t(which)] : "";
        showLast();
        constexpr int kCurrentRun = 1;
        const bool current = which == kCurrentRun;
        if (current != (m_picture->currentIndex() >= CurrentLoop))
            m_picture->setCurrentIndex(current ? CurrentClosed : SpeedLoop);
    });
}

std::vector<catalog::RegisterId> ResponsePage::watchedRegisters() const
{
    return m_parts.tuning.watchedRegisters();
}

void ResponsePage::showLast()
{
    if (const int row = m_rows.rowOf(m_last); row >= 0)
        m_table->scrollTo(m_rows.index(row, 0));
}

void ResponsePage::refresh(Milliseconds)
{
    m_parts.tuning.refresh();
    if (!m_parts.tuning.measured() && m_parts.tuning.present() != gains())
        adoptTuning();
    m_bar->refresh();
    enableButtons();
}

void ResponsePage::focusFirst() { m_kp->setFocus(Qt::ShortcutFocusReason); }

void ResponsePage::changeEvent(QEvent *event)
{
    Form::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        m_rows.setDark(isDark(palette()));
}

void ResponsePage::showEvent(QShowEvent *event)
{
    Form::showEvent(event);
    m_rows.setDark(isDark(palette()));
    adoptTuning();
}

std::chrono::milliseconds ResponsePage::length() const
{
    return std::chrono::seconds(m_length->value());
}

LoopTuning::Gains ResponsePage::gains() const { return {m_kp->value(), m_ki->value()}; }

void ResponsePage::setGains(const LoopTuning::Gains &gains)
{
    const QScopedValueRollback setting(m_setting, true);
    m_kp->setValue(gains.kp);
    m_ki->setValue(gains.ki);
    whatIf();
}

/// Something was measured, written or forgotten.
void ResponsePage::adoptTuning()
{
    if (!isVisible())
        return;
    const auto &measured = m_parts.tuning.measured();
    if (measured && gains() == LoopTuning::Gains()) // none were put in: the page was not there yet
        return setGains({measured->loop.proportional, measured->loop.integral});
    if (measured)
        return whatIf();
    m_proposed = false;
    // The fields begin with what the board has.
    setGains(m_parts.tuning.present().value_or(LoopTuning::Gains()));
}

void ResponsePage::propose()
{
    const auto &measured = m_parts.tuning.measured();
    if (!measured)
        return;
    if (measured->candidates.empty())
        return m_bar->tell(tr("Not conclusive: %1").arg(labSentence(measured->whyNone)));
    m_proposed = true;
    showRows();
    const int medium = m_rows.rowOf(lab::nameOf(lab::Goal::Medium));
    m_table->setCurrentIndex(m_rows.index(std::max(medium, 0), 0));
}

/// Its gains come into the fields, so that their loop is drawn and can be written.
void ResponsePage::chosen()
{
    const QModelIndex index = m_table->currentIndex();
    if (m_setting || !index.isValid() || index.row() >= m_rows.rowCount())
        return;
    const LoopRow &row = m_rows.rows()[static_cast<std::size_t>(index.row())];
    if (row.kp && row.ki)
        setGains({*row.kp, *row.ki});
}

/// Takes some milliseconds.
void ResponsePage::predict()
{
    const LoopTuning &tuning = m_parts.tuning;
    if (m_measurement == tuning.measurements() && m_predictedFor == gains())
        return;
    m_measurement = tuning.measurements();
    m_predictedFor = gains();
    m_predicted = tuning.predicted(gains());
    m_forecast = tuning.forecast(gains());
}

void ResponsePage::whatIf()
{
    predict();
    showRows();
    showCurves();
    enableButtons();
    m_bar->refresh();
}

void ResponsePage::showRows()
{
    const QScopedValueRollback setting(m_setting, true);
    const LoopTuning &tuning = m_parts.tuning;
    std::vector<LoopRow> rows;
    if (const auto &measured = tuning.measured()) {
        LoopRow row{"measured", tr("measured"), tr("With the gains that the board held then"),
            kMeasuredSlot, true};
        if (measured->gainsKnown()) {
            row.kp = measured->loop.proportional;
            row.ki = measured->loop.integral;
        }
        setMargins(row, measured->response);
        rows.push_back(std::move(row));
    }
    if (m_forecast) {
        LoopRow row{"what-if", tr("what if"),
            tr("With the gains in the fields, by the measured motor; its step is that of a fitted "
               "one"),
            kWhatIfSlot, true};
        setForecast(row, *m_forecast);
        if (!m_forecast->stable)
            row.name = tr("what if: unstable");
        rows.push_back(std::move(row));
    }
    for (const lab::Goal goal : lab::kGoals)
        if (const auto one = m_proposed ? tuning.candidate(goal) : std::nullopt) {
            LoopRow row{lab::nameOf(goal), tr(kGoalTexts[static_cast<std::size_t>(goal)]),
                tr("Ms at most %1, phase margin at least %2\u00b0, at the worst end of each error "
                   "bar")
                    .arg(QLocale().toString(lab::distanceOf(goal).ms),
                        QLocale().toString(lab::distanceOf(goal).phaseMargin_deg))};
            setForecast(row, *one);
            rows.push_back(std::move(row));
        }
    if (const auto &proof = tuning.proof()) {
        LoopRow row{"proof", tr("proved"), tuning.verdict(), kProofSlot, true};
        row.kp = proof->gains.kp;
        row.ki = proof->gains.ki;
        setMargins(row, proof->response);
        row.rise_s = proof->steps.rise_s;
        row.overshoot_pct = proof->steps.overshoot_pct;
        rows.push_back(std::move(row));
    }
    if (const auto &current = tuning.current()) {
        LoopRow row{"current", tr("current loop"), tr("As measured, at the current that flowed"),
            kCurrentSlot, true};
        setMargins(row, *current);
        rows.push_back(std::move(row));
    }
    m_rows.show(std::move(rows));
}

void ResponsePage::showCurves()
{
    const LoopTuning &tuning = m_parts.tuning;
    const int picture = m_picture->currentIndex();
    const BodeOf of = picture == SpeedLoop || picture == CurrentLoop ? BodeOf::Loop : BodeOf::Motor;
    QVector<BodeCurve> curves;
    const auto add = [&](const lab::FrequencyResponse &response, int slot, bool measured) {
        BodeCurve curve = bodeCurve(response, of);
        curve.slot = slot;
        curve.measured = measured;
        curves.append(std::move(curve));
    };
    if (picture >= CurrentLoop) {
        if (tuning.current())
            add(*tuning.current(), kCurrentSlot, true);
    } else {
        if (tuning.measured())
            add(tuning.measured()->response, kMeasuredSlot, true);
        if (tuning.proof())
            add(tuning.proof()->response, kProofSlot, true);
        if (m_predicted && picture == SpeedLoop)
            add(*m_predicted, kWhatIfSlot, false);
    }
    m_plot->showCurves(curves, picture == Motor ? QStringLiteral("(rad/s)/A") : QString());
}

void ResponsePage::enableButtons()
{
    const LoopTuning &tuning = m_parts.tuning;
    const auto enable = [](QPushButton &button, const QString &why, const QString &help) {
        button.setEnabled(why.isEmpty());
        button.setToolTip(plainToolTip(why.isEmpty() ? help : why));
    };
    const bool measured = tuning.measured().has_value();
    const bool known = measured && tuning.measured()->gainsKnown();
    m_kp->setEnabled(known);
    m_ki->setEnabled(known);
    enable(*m_propose, measured ? QString() : tr("Measure the response of the speed first."),
        tr("Three candidates from the measured motor: stiff, medium, quick"));
    enable(*m_apply,
        m_forecast && !m_forecast->stable
            ? tr("With these gains the loop would be unstable: its speed would swing ever more.")
            : tuning.applyHint(gains()),
        tr("Writes the gains in the fields as one step, which can be undone, and reads them back"));
    enable(*m_back, tuning.backHint(),
        tr("Writes the gains from before the first Apply, as one step"));
}

} // namespace widgets
