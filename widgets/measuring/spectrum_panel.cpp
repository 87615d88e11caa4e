#include "widgets/measuring/spectrum_panel.h"

#include "widgets/base/fields/whole_spin.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/row_list.h"
#include "widgets/base/si_text.h"
#include "widgets/base/steady_label.h"
#include "widgets/base/value_text.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/measuring/measure_text.h"
#include "widgets/measuring/spectrum_peaks.h"
#include "widgets/measuring/spectrum_plot.h"
#include "widgets/measuring/trace_box.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/view.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace widgets {

namespace {
constexpr std::array kListColumns{28, 84, 52, 88, 80}; // px, as in SpectrumPeaks::Column
constexpr int kMostAveraged = 256;
enum Axis { Hertz = -1, OrdersOfLargest = 0 }; // above: orders of that channel's speed
enum Scale { Amplitude, Decibels };
} // namespace

SpectrumPanel::SpectrumPanel(ScopeView &scope, const capture::Capture &capture,
    const Device &device, ChosenMotor motor, QWidget *parent)
    : Form(parent)
    , m_scope(scope)
    , m_capture(capture)
    , m_device(device)
    , m_motor(std::move(motor))
    , m_peaks(new SpectrumPeaks(this))
    , m_plot(new SpectrumPlot(this))
    , m_list(new RowList("spectrumPeaks", tr("Peaks of the spectrum"), m_peaks, this))
    , m_trace(new QComboBox(this))
    , m_range(new QComboBox(this))
    , m_window(new QComboBox(this))
    , m_size(new QComboBox(this))
    , m_axis(new QComboBox(this))
    , m_scale(new QComboBox(this))
    , m_average(new WholeSpin(this))
    , m_note(named(new SteadyLabel(this), "spectrumNote"))
{
    setObjectName(QStringLiteral("spectrumPanel"));
    m_pool.setMaxThreadCount(1);
    m_list->header()->setStretchLastSection(true);
    int width = 2 * m_list->frameWidth();
    for (int column = 0; column < SpectrumPeaks::kColumns; ++column) {
        const int its = std::max(kListColumns[static_cast<std::size_t>(column)],
            m_list->header()->sectionSizeHint(column)); // the heading whole, in every language
        m_list->setColumnWidth(column, its);
        width += its;
    }
    m_list->setFixedWidth(width);
    m_note->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_plot->setMinimumWidth(240);

    auto *middle = new QVBoxLayout;
    middle->addWidget(m_plot, 1);
    middle->addWidget(m_note);
    auto *layout = new QHBoxLayout(this);
    layout->addWidget(makeSide());
    layout->addLayout(middle, 1);
    layout->addWidget(m_list);

    connect(&scope, &ScopeView::channelsChanged, this, &SpectrumPanel::fillTraces);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
        [this](const QModelIndex &current) { m_plot->mark(current.row()); });
    fillTraces();
}

QFormLayout *SpectrumPanel::makeChoices()
{
    new WheelGuard(named(m_trace, "spectrumTrace"));
    new WheelGuard(named(m_range, "spectrumRange"));
    new WheelGuard(named(m_window, "spectrumWindow"));
    new WheelGuard(named(m_size, "spectrumSize"));
    new WheelGuard(named(m_average, "spectrumAverage"));
    new WheelGuard(named(m_axis, "spectrumAxis"));
    new WheelGuard(named(m_scale, "spectrumScale"));
    m_range->addItems({tr("the picture"), tr("between the cursors")});
    const auto addWindow = [this](const QString &name, scope::Window window, const QString &help) {
        m_window->addItem(name, static_cast<int>(window));
        m_window->setItemData(m_window->count() - 1, help, Qt::ToolTipRole);
    };
    addWindow(tr("Hann"), scope::Window::Hann, tr("To look around"));
    addWindow(
        tr("Flat top"), scope::Window::FlatTop, tr("To read amplitudes: true to 0.1 % everywhere"));
    addWindow(tr("Blackman-Harris"), scope::Window::BlackmanHarris,
        tr("To see small lines beside large ones"));
    addWindow(tr("Rectangular"), scope::Window::Rectangular, tr("For whole periods only"));
    m_size->addItem(tr("all samples"), 0);
    for (int size = 1024; size <= 65536; size *= 4)
        m_size->addItem(tr("%n samples", nullptr, size), size);
    m_size->setToolTip(tr("Samples of a transform. With fewer than there are, the transforms "
                          "overlap by half and are averaged."));
    m_average->setRange(1, kMostAveraged);
    m_average->setSpecialValueText(tr("off"));
    m_average->setToolTip(
        tr("The mean of so many spectra, one after the other, of samples that do not overlap"));
    m_scale->addItems({tr("amplitude"), tr("decibels")});

    auto *form = new QFormLayout;
    form->addRow(tr("T&race"), m_trace);
    form->addRow(tr("&In"), m_range);
    form->addRow(tr("&Window"), m_window);
    form->addRow(tr("&Length"), m_size);
    form->addRow(tr("Avera&ge"), m_average);
    form->addRow(tr("A&xis"), m_axis);
    form->addRow(tr("S&cale"), m_scale);
    return form;
}

QWidget *SpectrumPanel::makeSide()
{
    auto *side = new QWidget(this);
    side->setFixedWidth(kSideWidth);
    auto *again = named(new QPushButton(tr("Rest&art"), side), "spectrumAgain");
    again->setToolTip(tr("Forgets what was averaged"));
    auto *copyIt = named(new QPushButton(tr("C&opy"), side), "copyPeaks");
    copyIt->setToolTip(tr("The table of peaks"));
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(again);
    buttons->addWidget(copyIt);
    auto *layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(makeChoices());
    layout->addLayout(buttons);
    layout->addStretch(1);

    for (QComboBox *box : {m_trace, m_window, m_size})
        connect(box, &QComboBox::currentIndexChanged, this, &SpectrumPanel::compute);
    connect(m_range, &QComboBox::activated, this, [this](int range) {
        if (range == BetweenCursors && !m_scope.cursors().visible())
            m_scope.cursorActions().toggle();
        compute();
    });
    connect(m_axis, &QComboBox::currentIndexChanged, this, &SpectrumPanel::showMean);
    connect(m_scale, &QComboBox::currentIndexChanged, this, &SpectrumPanel::showMean);
    const auto begin = [this] {
        ++m_begun;
        m_averaged.clear();
        m_answered.reset();
        compute();
    };
    connect(m_average, &QSpinBox::valueChanged, this, begin);
    connect(again, &QPushButton::clicked, this, begin);
    connect(copyIt, &QPushButton::clicked, this,
        [this] { QApplication::clipboard()->setText(tableText(*m_peaks)); });
    return side;
}

void SpectrumPanel::fillTraces()
{
    fillTraceBox(*m_trace, m_scope, m_capture);
    fillAxes();
}

/// Hertz, or orders: of the largest peak, or of a speed that is recorded too.
void SpectrumPanel::fillAxes()
{
    const QSignalBlocker quiet(m_axis);
    const QVariant chosen = m_axis->currentData();
    m_axis->clear();
    m_axis->addItem(tr("frequency"), Axis::Hertz);
    m_axis->addItem(tr("orders: largest peak"), Axis::OrdersOfLargest);
    for (const capture::ChannelId id : m_scope.channels()) {
        const auto info = m_capture.info(id);
        if (info && info->unit == "rpm")
            m_axis->addItem(
                tr("orders: %1", "name of a speed").arg(m_scope.nameOf(id)), static_cast<int>(id));
    }
    m_axis->setCurrentIndex(std::max(0, m_axis->findData(chosen)));
    if (m_axis->currentData() != chosen) // that speed is no longer there
        showMean();
}

void SpectrumPanel::refresh(Milliseconds) { compute(); }

void SpectrumPanel::choose(capture::ChannelId channel)
{
    m_trace->setCurrentIndex(m_trace->findData(channel));
}

void SpectrumPanel::focusFirst()
{
    m_trace->setFocus(Qt::ShortcutFocusReason);
    compute();
}

SpectrumWanted SpectrumPanel::wanted() const
{
    ScopeView::TimeRange range = m_scope.visibleRange();
    const CursorPair &cursors = m_scope.cursors().pair();
    if (m_range->currentIndex() == BetweenCursors && m_scope.cursors().visible())
        range = {std::min(cursors.a, cursors.b), std::max(cursors.a, cursors.b)};
    SpectrumWanted wanted;
    wanted.channel = m_trace->currentData().toUInt();
    wanted.from = capture::toNanos(range.from);
    wanted.to = capture::toNanos(range.to);
    if (const capture::Channel *channel = m_capture.channel(wanted.channel))
        wanted.samples = channel->countIn(range.from, range.to);
    wanted.window = static_cast<scope::Window>(m_window->currentData().toInt());
    wanted.size = static_cast<std::size_t>(m_size->currentData().toULongLong());
    return wanted;
}

/// One job at a time; what changed meanwhile is seen at the next heartbeat.
void SpectrumPanel::compute()
{
    if (!m_rest.over(m_scope.running()) || !isVisible())
        return;
    const SpectrumWanted next = wanted();
    if (next == m_answered || waits(next))
        return;
    if (m_trace->currentIndex() < 0) {
        m_answered.reset();
        m_peaks->show({}, {}, {});
        m_note->clear();
        m_plot->showNothing(m_scope.channels().isEmpty() ? tr("No trace is shown on the scope.")
                                                         : tr("Choose a trace."));
        return;
    }
    m_rest.begin();
    const capture::Snapshot copy = m_capture.snapshot({&next.channel, 1});
    auto before = m_answer.mean;
    if (!before || beginsAnew(next))
        before = std::make_shared<const scope::SpectrumAverage>(
            static_cast<std::uint32_t>(m_average->value()));
    m_pool.start([this, copy, next, before, begun = m_begun] {
        const auto answer =
            std::make_shared<const SpectrumAnswer>(computeSpectrum(copy, next, *before));
        QMetaObject::invokeMethod(
            this, [this, answer, begun] { accept(*answer, begun); }, Qt::QueuedConnection);
    });
}

/// Some of its samples are in the mean already.
bool SpectrumPanel::overlaps(const SpectrumWanted &stretch) const
{
    return std::any_of(
        m_averaged.begin(), m_averaged.end(), [&stretch](const SpectrumWanted &there) {
            return stretch.from < there.to && there.from < stretch.to;
        });
}

/// Of the same trace, made in the same way, and about as long.
bool SpectrumPanel::continues(const SpectrumWanted &stretch) const
{
    if (!m_answered || m_averaged.empty())
        return false;
    const double length = capture::toSeconds(m_answered->to - m_answered->from);
    const double other = capture::toSeconds(stretch.to - stretch.from);
    constexpr double kAlike = 1e-3;
    return m_answered->channel == stretch.channel && m_answered->window == stretch.window
        && m_answered->size == stretch.size && std::abs(length - other) <= kAlike * length;
}

/// A picture that runs moves on a little at a time: what is averaged takes the next whole one.
bool SpectrumPanel::waits(const SpectrumWanted &next) const
{
    return m_average->value() > 1 && m_scope.running() && continues(next)
        && next.from > m_answered->from && overlaps(next);
}

/// No part of the mean until now.
bool SpectrumPanel::beginsAnew(const SpectrumWanted &stretch) const
{
    return !continues(stretch) || overlaps(stretch);
}

void SpectrumPanel::accept(const SpectrumAnswer &answer, int begun)
{
    m_rest.end();
    if (begun != m_begun) {
        compute();
        return;
    }
    if (beginsAnew(answer.wanted))
        m_averaged.clear();
    m_answered = answer.wanted;
    m_answer = answer;
    if (answer.spectrum) {
        if (m_averaged.size() >= kMostAveraged)
            m_averaged.erase(m_averaged.begin());
        m_averaged.push_back(answer.wanted);
        showMean();
    } else {
        m_averaged.clear();
        m_peaks->show({}, {}, {});
        m_note->clear();
        m_plot->showNothing(whyNot(answer.spectrum.error()));
    }
    Q_EMIT shown();
}

QString SpectrumPanel::whyNot(scope::NoSpectrum why) const
{
    if (why == scope::NoSpectrum::NotUniform)
        return tr("The samples of this trace are not at equal distances, so it has no spectrum.");
    return tr("Fewer than 16 samples in one piece: no spectrum.");
}

/// Of the motor whose speed it is, or that is chosen; 0 if it is not known, as in a file of another board.
int SpectrumPanel::polePairsOf(catalog::RegisterId speed) const
{
    const auto &board = m_device.identified();
    int motor = m_motor();
    if (!board || motor == 0)
        return 0;
    const catalog::RegisterInfo *info = board->catalog ? board->catalog->find(speed) : nullptr;
    if (info && info->perMotor)
        motor = board->catalog->motorOf(speed);
    const auto index = static_cast<std::size_t>(motor - 1);
    return index < board->limits.size() ? static_cast<int>(board->limits[index].polePairs) : 0;
}

/// Not valid where the axis is frequency, or the speed or the pole pairs are not known.
scope::OrderAxis SpectrumPanel::orders(double largestHz) const
{
    const int axis = m_axis->currentData().toInt();
    if (axis == Axis::Hertz || !m_answered)
        return {};
    if (axis == Axis::OrdersOfLargest)
        return {largestHz};
    const capture::Channel *speed = m_capture.channel(static_cast<capture::ChannelId>(axis));
    const int polePairs = speed ? polePairsOf(speed->info().registerId) : 0;
    if (polePairs == 0)
        return {};
    const auto moments = scope::SampleRange(*speed, m_answered->from, m_answered->to).moments();
    return moments ? scope::OrderAxis::ofSpeed(moments->mean, polePairs) : scope::OrderAxis();
}

void SpectrumPanel::showMean()
{
    if (!m_answer.mean || !m_answered)
        return;
    const scope::Spectrum &mean = m_answer.mean->mean();
    const auto info = m_capture.info(m_answered->channel);
    SpectrumPlot::Picture picture;
    picture.spectrum = mean;
    picture.peaks = m_answer.peaks;
    picture.unit = info ? unitText(info->unit) : QString();
    picture.orders = orders(picture.peaks.empty() ? 0.0 : picture.peaks.front().hertz);
    picture.decibels = m_scale->currentIndex() == Decibels;
    m_peaks->show(picture.peaks, picture.unit, picture.orders);
    showNote(mean);
    if (m_axis->currentData().toInt() != Axis::Hertz && !picture.orders.valid())
        m_note->setText(tr("No orders: the speed or the motor's pole pairs are not known."));
    m_plot->showSpectrum(std::move(picture));
}

void SpectrumPanel::showNote(const scope::Spectrum &spectrum)
{
    QString text =
        tr("%1 samples a transform, a line every %2",
            "a number of samples; a distance of frequencies")
            .arg(QString::number(spectrum.size), siText(spectrum.binHz, QStringLiteral("Hz")));
    const QString separator = QStringLiteral("  \u2022  ");
    if (spectrum.averaged > 1)
        text +=
            separator + tr("mean of %n transforms", nullptr, static_cast<int>(spectrum.averaged));
    if (m_answer.cut)
        text += separator + tr("only the newest samples");
    m_note->setText(text);
}

} // namespace widgets
