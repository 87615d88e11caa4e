#include "widgets/window/workspaces.h"

#include "session/files/whole_file.h"
#include "widgets/base/device_text.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/question.h"
#include "widgets/scope/colors.h"
#include "widgets/scope/ghosts.h"
#include "widgets/scope/trigger/control.h"
#include "widgets/scope/view.h"
#include "widgets/window/tools.h"
#include "widgets/window/workbench.h"

#include <QFileInfo>
#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace widgets {
namespace {

bool has(const std::vector<KeptReference> &references, Reference which)
{
    return std::any_of(references.begin(), references.end(),
        [which](const KeptReference &one) { return one.which == which; });
}

} // namespace

Workspaces::Workspaces(const Parts &parts, QObject *parent)
    : QObject(parent)
    , m_parts(parts)
{
    connect(&parts.scope, &ScopeView::channelsChanged, this, &Workspaces::findTriggerSource);
}

Workspace Workspaces::now() const
{
    const SignalPlan &plan = m_parts.workbench.signalPlan();
    const Trigger &trigger = m_parts.trigger.trigger();
    Workspace workspace;
    workspace.signalList = plan.named();
    workspace.fastEvery = plan.fastEvery();
    workspace.span = m_parts.trigger.rollSpan();
    workspace.trigger = m_waitsForSource.isEmpty() ? trigger.setup() : m_waitingSetup;
    workspace.triggerSource = m_waitsForSource;
    if (m_waitsForSource.isEmpty() && trigger.source())
        workspace.triggerSource = deviceText(trigger.source()->name);
    workspace.formulas = m_parts.workbench.math().formulas();
    workspace.axes = m_parts.scope.heldRanges();
    workspace.references = m_parts.scope.ghosts().forWorkspace();
    workspace.traceColors = m_parts.scope.colors().chosen();
    workspace.measures = m_parts.tools.measures();
    workspace.notes = m_parts.tools.notes();
    workspace.layout = m_parts.window.saveState(kLayoutVersion);
    return workspace;
}

void Workspaces::apply(const Workspace &workspace)
{
    m_parts.scope.colors().setChosen(workspace.traceColors); // before anything is drawn
    m_parts.scope.setHeldRanges(workspace.axes);
    m_parts.workbench.math().setFormulas(workspace.formulas);
    m_parts.tools.setNotes(workspace.notes);
    m_parts.tools.setMeasures(workspace.measures);
    if (!workspace.layout.isEmpty())
        m_parts.window.restoreState(workspace.layout, kLayoutVersion);
    m_parts.trigger.setMode(scope::Mode::Roll);
    showSpan(workspace.span);
    m_parts.workbench.signalPlan().setFastEvery(workspace.fastEvery);
    m_waitsForSource = workspace.triggerSource;
    m_waitingSetup = workspace.trigger;
    m_parts.workbench.signalPlan().setNamed(workspace.signalList);
    if (m_waitsForSource.isEmpty())
        m_parts.trigger.setSetup(workspace.trigger);
    findTriggerSource();
    m_parts.scope.ghosts().adoptFromWorkspace(workspace.references);
}

void Workspaces::showSpan(double seconds)
{
    TimeWindow &time = m_parts.scope.time();
    const double to = time.range().to;
    time.set(to - seconds, to);
    time.setFollowing(true);
}

/// Of a board's signals the channel that they come into from now on: one of before goes.
bool Workspaces::isCurrent(capture::ChannelId id) const
{
    const auto info = m_parts.workbench.capture().info(id);
    return info
        && (!info->isBoards() || m_parts.workbench.signalPlan().channelOf(info->registerId) == id);
}

/// The trigger comes with its source: another trace would fulfil the condition at other times.
void Workspaces::findTriggerSource()
{
    if (m_waitsForSource.isEmpty())
        return;
    for (const capture::ChannelId id : m_parts.scope.channels())
        if (m_parts.scope.nameOf(id) == m_waitsForSource && isCurrent(id)) {
            m_waitsForSource.clear();
            m_parts.trigger.trigger().setSource(id);
            m_parts.trigger.setSetup(m_waitingSetup);
            return;
        }
}

QString Workspaces::filter() { return tr("Workspaces (*.workspace)"); }

void Workspaces::askForOpen()
{
    m_parts.files.askOpen(&m_parts.window, {tr("Open a workspace"), m_folder, filter()},
        [this](const QString &path) { open(path); });
}

void Workspaces::askForSave()
{
    m_parts.files.askSave(&m_parts.window,
        {tr("Save the workspace"), m_folder, tr("bench") + QStringLiteral(".workspace"), filter(),
            QStringLiteral("workspace")},
        [this](const QString &path) { save(path); });
}

bool Workspaces::open(const QString &path)
{
    const auto tell = [&](const QString &why) {
        Q_EMIT said(Banner::Kind::Warning,
            tr("%1 was not opened: %2", "a file, the reason").arg(deviceText(path), why));
        return false;
    };
    const auto json = session::readWholeFile(path);
    if (!json)
        return tell(json.error());
    auto workspace = readWorkspace(*json);
    if (!workspace)
        return tell(workspace.error());
    m_folder = QFileInfo(path).path();
    const QString notes = m_parts.tools.notes();
    if (notes.trimmed().isEmpty() || notes == workspace->notes || notes == m_keptNotes)
        adopt(path, *workspace);
    else
        askAboutNotes(path, std::move(*workspace));
    return true;
}

void Workspaces::askAboutNotes(const QString &path, Workspace workspace)
{
    using Kind = Answer::Kind;
    if (m_parts.prompt.asks("notesQuestion"))
        return;
    const auto keep = [this, path, workspace]() mutable {
        workspace.notes = m_parts.tools.notes();
        adopt(path, workspace);
        m_keptNotes.clear(); // those that stay are still in no file
    };
    m_parts.prompt.ask({.name = "notesQuestion",
        .title = tr("Replace the notes?"),
        .text = tr("The notes that are shown are in no workspace file. Those of %1 take their "
                   "place.")
                    .arg(fileNameText(path)),
        .more = tr("They cannot be brought back."),
        .answers = {{Kind::Lose, tr("&Replace the notes"),
                        [this, path, workspace] { adopt(path, workspace); }, "replaceNotes"},
            {}, {Kind::Go, tr("&Keep these notes"), keep, "keepNotes"}},
        .usual = 1});
}

void Workspaces::adopt(const QString &path, const Workspace &workspace)
{
    apply(workspace);
    m_keptNotes = workspace.notes;
    Q_EMIT used(path);
}

void Workspaces::save(const QString &path)
{
    m_folder = QFileInfo(path).path();
    const Workspace workspace = now();
    if (const QString why = session::writeWholeFile(path, toJson(workspace)); !why.isEmpty()) {
        Q_EMIT said(Banner::Kind::Warning,
            tr("%1 was not written: %2", "a file, the reason").arg(deviceText(path), why));
        return;
    }
    m_keptNotes = workspace.notes;
    QString sentence = tr("The workspace is in %1.").arg(deviceText(path));
    const ScopeGhosts &ghosts = m_parts.scope.ghosts();
    for (const auto &[which, letter] : {std::pair(Reference::A, 'A'), {Reference::B, 'B'}})
        if (ghosts.hasReference(which) && !has(workspace.references, which))
            sentence += QLatin1Char(' ')
                + tr("Reference %1 is not in it: there is room for %2 samples.")
                      .arg(QString(QLatin1Char(letter)), QString::number(kMostReferenceSamples));
    Q_EMIT said(Banner::Kind::Note, sentence);
    Q_EMIT used(path);
}

void Workspaces::arrange(Arrangement arrangement)
{
    TriggerSetup setup = m_parts.trigger.trigger().setup();
    ToolDocks &docks = m_parts.tools.docks();
    setup.mode = scope::Mode::Roll;
    switch (arrangement) {
    case Arrangement::Tune:
        docks.showOnly({QStringLiteral("gainsDock"), QStringLiteral("measureDock")});
        m_parts.trigger.setSetup(setup);
        return showSpan(2.0);
    case Arrangement::Record:
        docks.showOnly({QStringLiteral("eventDock"), QStringLiteral("notesDock")});
        m_parts.trigger.setSetup(setup);
        return showSpan(20.0);
    case Arrangement::StartUp:
        docks.showOnly({QStringLiteral("revUpDock"), QStringLiteral("eventDock")});
        setup.type = TriggerType::StateChange;
        setup.mode = scope::Mode::Normal;
        setup.preTrigger = 0.2;
        setup.length = 3.0;
        return m_parts.trigger.setSetup(setup);
    }
}

} // namespace widgets
