#include "widgets/window/tools.h"

#include "widgets/base/device_text.h"
#include "widgets/control/motion_log_panel.h"
#include "widgets/files/notes_panel.h"
#include "widgets/forms/gains_form.h"
#include "widgets/forms/motor_form.h"
#include "widgets/forms/ramp_form.h"
#include "widgets/forms/rev_up_form.h"
#include "widgets/lab/identify_page.h"
#include "widgets/lab/loop/response_page.h"
#include "widgets/lab/step_page.h"
#include "widgets/lab/tour_page.h"
#include "widgets/measuring/math_panel.h"
#include "widgets/measuring/math_traces.h"
#include "widgets/measuring/measure_panel.h"
#include "widgets/measuring/measure_text.h"
#include "widgets/measuring/spectrum_panel.h"
#include "widgets/measuring/xy_panel.h"
#include "widgets/runs/book_panel.h"
#include "widgets/scope/colors.h"
#include "widgets/scope/events/panel.h"
#include "widgets/scope/signals/channel_strip.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/trigger/control.h"
#include "widgets/scope/trigger/record_panel.h"
#include "widgets/scope/view.h"
#include "widgets/snapshots/actions.h"
#include "widgets/snapshots/panel.h"
#include "widgets/window/opening.h"
#include "widgets/window/workbench.h"

#include <QMainWindow>
#include <QMenu>

namespace widgets {
namespace {

/// What gains are computed from.
MeasuredMotor measuredOf(const MotorFindings &found)
{
    using Row = MotorFindings;
    return {.rs_ohm = found.estimate(Row::Resistance),
        .lq_h = found.estimate(Row::Lq),
        .ld_h = found.estimate(Row::Ld),
        .flux_wb = found.estimate(Row::Flux),
        .inertia_kgm2 = found.estimate(Row::Inertia)};
}

} // namespace

Tools::Tools(const Parts &parts, const Settings &settings)
    : m_parts(parts)
    , m_device(parts.workbench.device())
    , m_settings(settings)
    , m_identification(m_device, parts.workbench.experiments())
    , m_tuning(m_device, parts.workbench.registers(), parts.workbench.edits(),
          parts.workbench.experiments())
    , m_docks(parts.window, parts.workbench)
{
    addScopeTools();
    addSnapshots();
    addForms();
    addRunBook();
    connect(&m_docks, &ToolDocks::failed, this,
        [this](const QString &sentence) { Q_EMIT said(Banner::Kind::Warning, sentence); });
}

void Tools::keep(Settings &settings) const
{
    settings.inertias = m_settings.inertias;
    if (m_snapshots)
        settings.snapshotFolder = m_snapshots->folder();
    if (m_ramps)
        settings.ramps = m_ramps->presets();
    settings.runFolder = m_runs->folder();
}

QList<NamedMeasure> Tools::measures() const
{
    return m_measures ? m_measures->measures() : m_settings.workspace.measures;
}

void Tools::setMeasures(const QList<NamedMeasure> &measures)
{
    m_settings.workspace.measures = measures;
    if (m_measures)
        m_measures->setMeasures(measures);
}

QString Tools::notes() const { return m_notes ? m_notes->text() : m_settings.workspace.notes; }

void Tools::setNotes(const QString &notes)
{
    m_settings.workspace.notes = notes;
    if (m_notes)
        m_notes->setText(notes);
}

QList<QAction *> Tools::snapshotActions() const { return m_snapshotActions->actions(); }

int Tools::motor() const
{
    return m_parts.workbench.signalPlan().showsFile() ? 0 : m_device.motor();
}

void Tools::addScopeTools()
{
    ScopeView &scope = m_parts.scope;
    capture::Capture &capture = m_parts.workbench.capture();
    MathChannels &math = m_parts.workbench.math();
    const auto ofMotor = [this] { return motor(); };
    QAction *open = m_docks.add(tr("Events"), "eventDock", "events", Qt::CTRL | Qt::Key_7,
        [this] { return m_events = new EventPanel(m_parts.scope); });
    connect(&scope, &ScopeView::noteWanted, this, [this, open](quint32 marker) {
        open->trigger();
        m_events->editNote(marker);
    });
    m_docks.add(tr("Records"), "recordDock", "records", Qt::CTRL | Qt::Key_8,
        [this] { return new RecordPanel(m_parts.trigger, m_parts.scope); });
    m_openMeasures = m_docks.add(
        tr("Measurements"), "measureDock", "measure", Qt::CTRL | Qt::Key_9, [this, &capture] {
            m_measures = new MeasurePanel(m_parts.scope, capture, m_parts.trigger);
            m_measures->setMeasures(m_settings.workspace.measures);
            return m_measures;
        });
    m_openSpectrum = m_docks.add(tr("Spectrum"), "spectrumDock", "spectrum", Qt::CTRL | Qt::Key_0,
        [this, &capture, ofMotor] {
            return m_spectrum = new SpectrumPanel(m_parts.scope, capture, m_device, ofMotor);
        });
    new MathTraces(math, capture, scope, this);
    QAction *openMath = m_docks.add(tr("Math"), "mathDock", "math",
        Qt::CTRL | Qt::SHIFT | Qt::Key_M, [this, &math, &capture, ofMotor] {
            m_math = new MathPanel(math, m_parts.scope, capture, ofMotor);
            offerToMath();
            return m_math;
        });
    showComputed(openMath);
    connect(&scope, &ScopeView::traceMenuOpening, this, &Tools::fillTraceMenu);
    m_openXy = m_docks.add(
        tr("XY"), "xyDock", "xy", Qt::CTRL | Qt::SHIFT | Qt::Key_X, [this, &capture, ofMotor] {
            return m_xy =
                       new XyPanel(m_parts.scope, capture, m_parts.workbench.registers(), ofMotor);
        });
}

/// What a formula lacks, if the board has it under that name.
void Tools::offerToMath()
{
    const auto idOf = [this](const QString &name) -> std::optional<catalog::RegisterId> {
        const auto catalog = m_device.catalog();
        const auto id = catalog ? catalog->resolve(name.toStdString()) : std::nullopt;
        const SignalPlan &plan = m_parts.workbench.signalPlan();
        const bool free = id && m_device.answering() && !plan.showsFile() && !plan.find(*id);
        return free && catalog->nameOf(*id) == name.toStdString() ? id : std::nullopt;
    };
    m_math->offerSignals([idOf](const QString &name) { return idOf(name).has_value(); });
    connect(m_math, &MathPanel::signalWanted, this, [this, idOf](const QString &name) {
        if (const auto id = idOf(name))
            m_parts.selection.add(*id);
    });
}

/// What the tools do with a trace that is clicked.
void Tools::fillTraceMenu(QMenu &menu, quint32 channel)
{
    using scope::Quantity;
    QMenu *measures = menu.addMenu(tr("&Measure"));
    measures->addAction(tr("&Step response"), this, [this, channel] {
        measure(
            channel, {Quantity::Rise, Quantity::Overshoot, Quantity::Settling, Quantity::PeakTime});
    });
    measures->addSeparator();
    for (const Quantity quantity : allQuantities())
        if (quantity != Quantity::Phase) // of two traces
            measures->addAction(quantityText(quantity), this,
                [this, channel, quantity] { measure(channel, {quantity}); });
    menu.addAction(tr("&Trigger on it"), this, [this, channel] {
        m_parts.trigger.trigger().setSource(channel);
        TriggerSetup setup = m_parts.trigger.trigger().setup();
        if (!fieldsOf(setup.type).source)
            setup.type = TriggerType::Edge;
        if (setup.mode == scope::Mode::Roll)
            setup.mode = scope::Mode::Auto;
        m_parts.trigger.setSetup(setup);
    });
    menu.addAction(tr("&Spectrum"), this, [this, channel] {
        m_openSpectrum->trigger();
        m_spectrum->choose(channel);
    });
    menu.addAction(tr("&XY, upward"), this, [this, channel] {
        m_openXy->trigger();
        m_xy->choose(channel);
    });
}

void Tools::measure(quint32 channel, const QList<scope::Quantity> &quantities)
{
    m_openMeasures->trigger();
    for (const scope::Quantity quantity : quantities)
        m_measures->measure(channel, quantity);
}

/// The chips of math channels, and what they do.
void Tools::showComputed(QAction *openMath)
{
    ScopeView &scope = m_parts.scope;
    MathChannels &math = m_parts.workbench.math();
    ChannelStrip &strip = m_parts.strip;
    const auto show = [&scope, &math, &strip] {
        QList<ChannelStrip::Computed> computed;
        for (const MathChannels::Entry &entry : math.entries()) {
            const QColor color = MathTraces::colorOf(scope, entry.channel);
            if (color.isValid())
                computed.append({entry.formula.name, entry.formula.text, color,
                    [&scope, &math, name = entry.formula.name](QMenu &menu) {
                        for (const MathChannels::Entry &now : math.entries())
                            if (now.formula.name == name)
                                scope.colors().fill(menu, now.channel);
                    }});
        }
        strip.setComputed(computed);
    };
    connect(&math, &MathChannels::changed, &strip, show);
    connect(&scope, &ScopeView::channelsChanged, &strip, show);
    connect(&strip, &ChannelStrip::computedRemoved, &math,
        [&math](const QString &name) { math.setShown(name, false); });
    connect(&strip, &ChannelStrip::computedChosen, this, [this, openMath](const QString &name) {
        openMath->trigger();
        m_math->choose(name);
    });
    show(); // those that were kept came before
}

void Tools::addSnapshots()
{
    m_openSnapshots =
        m_docks.add(tr("Snapshots"), "snapshotsDock", "snapshot", Qt::CTRL | Qt::Key_5, [this] {
            m_snapshots = new SnapshotPanel(
                m_device, m_parts.workbench.edits(), m_parts.workbench.snapshots(), m_parts.files);
            m_snapshots->setFolder(m_settings.snapshotFolder);
            m_snapshots->offerRecorded(m_parts.opening.snapshots());
            m_snapshots->offerSave(m_snapshotActions->save());
            return m_snapshots;
        });
    connect(&m_parts.opening, &Opening::snapshotsChanged, this, [this] {
        if (m_snapshots)
            m_snapshots->offerRecorded(m_parts.opening.snapshots());
    });
    const auto panel = [this]() -> SnapshotPanel & {
        m_docks.makeAll();
        return *m_snapshots;
    };
    m_snapshotActions = new SnapshotActions(m_device, m_parts.files, panel, m_parts.window);
    connect(m_snapshotActions, &SnapshotActions::panelWanted, m_openSnapshots, &QAction::trigger);
    connect(m_snapshotActions, &SnapshotActions::saved, this,
        [this](const QString &sentence) { Q_EMIT said(Banner::Kind::Note, sentence); });
}

void Tools::rememberInertia(const QString &motor, double inertia_kgm2)
{
    m_settings.inertias[motor] = inertia_kgm2;
    Q_EMIT inertiasChanged(m_settings.inertias);
}

void Tools::addForms()
{
    Workbench &workbench = m_parts.workbench;
    m_docks.add(tr("Gains"), "gainsDock", "gains", Qt::CTRL | Qt::Key_1, [this, &workbench] {
        auto *gains = new GainsForm(m_device, workbench.registers(), workbench.edits(),
            m_parts.edits.apply, m_parts.edits.revert, m_settings.inertias);
        connect(this, &Tools::inertiasChanged, gains, &GainsForm::setInertias);
        connect(gains, &GainsForm::inertiaRemembered, this, &Tools::rememberInertia);
        const MotorFindings &found = m_identification.findings();
        const auto tell = [gains, &found] { gains->setMeasured(measuredOf(found)); };
        connect(&found, &MotorFindings::dataChanged, gains, tell);
        tell();
        return gains;
    });
    m_docks.add(tr("Rev-up"), "revUpDock", "rev-up", Qt::CTRL | Qt::Key_2, [this, &workbench] {
        auto *revUp = new RevUpForm({m_device, workbench.registers(), workbench.edits(),
            workbench.capture(), m_parts.files, m_parts.edits.apply, m_parts.edits.revert});
        revUp->setInertias(m_settings.inertias);
        connect(this, &Tools::inertiasChanged, revUp, &RevUpForm::setInertias);
        connect(revUp, &RevUpForm::inertiaRemembered, this, &Tools::rememberInertia);
        return revUp;
    });
    m_docks.add(tr("Ramps"), "rampDock", "ramp", Qt::CTRL | Qt::Key_3, [this, &workbench] {
        m_ramps = new RampForm(m_device, workbench.registers(), workbench.motion());
        m_ramps->setPresets(m_settings.ramps);
        return m_ramps;
    });
    addLab();
    m_docks.add(
        tr("Motor and drive"), "motorDock", "motor", Qt::CTRL | Qt::Key_4, [this, &workbench] {
            auto *motor =
                new MotorForm(m_device, workbench.registers(), m_description, m_parts.files);
            connect(
                motor, &MotorForm::inertiaFound, this, [this](const QString &name, double inertia) {
                    if (!m_settings.inertias.contains(name)) // what was typed is better known
                        rememberInertia(name, inertia);
                });
            return motor;
        });
    m_docks.add(tr("Notes"), "notesDock", "notes", Qt::CTRL | Qt::SHIFT | Qt::Key_N,
        [this] { return m_notes = new NotesPanel(m_settings.workspace.notes); });
    m_docks.add(tr("Motion log"), "motionLogDock", "motion-log", Qt::CTRL | Qt::SHIFT | Qt::Key_L,
        [this, &workbench] {
            auto *log = new MotionLogPanel(workbench.motionLog(), m_parts.files);
            connect(log, &MotionLogPanel::saved, this, [this](const QString &path) {
                Q_EMIT said(Banner::Kind::Note, tr("Exported to %1.").arg(deviceText(path)));
            });
            return log;
        });
}

/// What moves the motor by itself.
void Tools::addLab()
{
    Workbench &workbench = m_parts.workbench;
    const ExperimentBar::Parts lab{m_device, workbench.motion(), workbench.experiments()};
    m_docks.add(tr("Step"), "stepDock", "step", Qt::CTRL | Qt::Key_T, [this, &workbench, lab] {
        return new StepPage({m_device, workbench.registers(), workbench.edits(), lab});
    });
    m_docks.add(
        tr("Identify"), "identifyDock", "identify", Qt::CTRL | Qt::Key_I, [this, &workbench, lab] {
            return new IdentifyPage(
                {m_device, workbench.registers(), m_description, m_identification, lab});
        });
    m_docks.add(
        tr("Response"), "responseDock", "response", Qt::CTRL | Qt::SHIFT | Qt::Key_F, [this, lab] {
            return new ResponsePage({m_tuning, lab});
        });
    m_docks.add(tr("Tour"), "tourDock", "tour", Qt::CTRL | Qt::SHIFT | Qt::Key_G, [this, lab] {
        return new TourPage({m_identification, m_tuning, lab});
    });
}

/// Experiments are kept whether or not the book is open.
void Tools::addRunBook()
{
    m_runs = new RunKeeper(m_device, m_parts.workbench.experiments(), &m_parts.window, this);
    m_runs->setFolder(m_settings.runFolder);
    connect(m_runs, &RunKeeper::failed, this,
        [this](const QString &sentence) { Q_EMIT said(Banner::Kind::Warning, sentence); });
    m_docks.add(
        tr("Run book"), "runBookDock", "run-book", Qt::CTRL | Qt::SHIFT | Qt::Key_B, [this] {
            auto *book = new RunBookPanel(*m_runs, m_parts.files);
            connect(book, &RunBookPanel::registersWanted, this,
                [this](const QString &a, const QString &b) {
                    m_openSnapshots->trigger();
                    m_snapshots->compareFiles(a, b);
                });
            connect(book, &RunBookPanel::referenceWanted, &m_parts.opening, &Opening::layBeside);
            connect(book, &RunBookPanel::recordingWanted, &m_parts.opening, &Opening::openPath);
            return book;
        });
}

} // namespace widgets
