#include "widgets/window/replacing.h"

#include "widgets/base/device.h"
#include "widgets/base/device_text.h"
#include "widgets/files/marker_file.h"
#include "widgets/files/recording_control.h"
#include "widgets/window/workbench.h"

namespace widgets {

using Kind = Answer::Kind;

Replacing::Replacing(const Parts &parts, QObject *parent)
    : QObject(parent)
    , m_parts(parts)
{
}

/// Nothing is in the scope that is in no file.
bool Replacing::samplesAreKept() const
{
    const capture::Capture &capture = m_parts.workbench.capture();
    return m_parts.workbench.signalPlan().showsFile() || !capture.timeSpan()
        || capture.revision() == m_exported || m_parts.record.holds(capture);
}

void Replacing::before(std::function<void()> goOn)
{
    if (samplesAreKept()) {
        beforeMarkersGo(goOn);
        return;
    }
    Question question{.name = "replaceQuestion",
        .title = tr("Replace what was recorded?"),
        .text = tr("The scope holds samples that were not exported. A file that is opened takes "
                   "their place."),
        .more = tr("What was recorded to a disk stays there. The scope's own samples cannot be "
                   "brought back."),
        .answers = {{Kind::Lose, tr("&Replace"),
                        [this, goOn = std::move(goOn)] {
                            m_parts.markers.leave();
                            goOn();
                        },
                        "replaceYes"},
            {},
            {Kind::Go, tr("&Export first\u2026"), [this] { Q_EMIT exportWanted(); },
                "replaceSave"}},
        .usual = 1};
    if (m_parts.markers.changed()) {
        question.more += QLatin1Char(' ') + tr("Markers that are not saved are lost, too.");
        question.answers.append({Kind::Go, tr("Save the &markers"),
            [this] { m_parts.markers.saveThen({}); }, "replaceSaveMarkers"});
    }
    m_parts.prompt.ask(question);
}

void Replacing::beforeMarkersGo(const std::function<void()> &goOn)
{
    if (!m_parts.markers.changed()) {
        goOn();
        return;
    }
    if (m_parts.prompt.asks("markersQuestion"))
        return;
    const bool asks = m_parts.markers.place() == MarkerFile::Place::Opened
        || m_parts.markers.place() == MarkerFile::Place::List;
    m_parts.prompt.ask({.name = "markersQuestion",
        .title = tr("Leave the markers unsaved?"),
        .text = markersText(),
        .more = {},
        .answers = {{Kind::Lose, tr("&Leave unsaved"),
                        [this, goOn] {
                            m_parts.markers.leave();
                            goOn();
                        },
                        "leaveMarkers"},
            {},
            {Kind::Go, asks ? tr("&Save first\u2026") : tr("&Save first"),
                [this, goOn] { m_parts.markers.saveThen(goOn); }, "saveMarkersFirst"}},
        .usual = 1});
}

/// Which markers are in no file, and where they can go.
QString Replacing::markersText() const
{
    switch (m_parts.markers.place()) {
    case MarkerFile::Place::Opened:
        return tr("Markers of this recording were changed and are not saved.");
    case MarkerFile::Place::Recorded:
        return tr("The recording %1 does not hold all markers as they are now.")
            .arg(fileNameText(m_parts.markers.path()));
    case MarkerFile::Place::Running:
        return tr(
            "The recording that runs does not hold all markers: some were set before it began.");
    case MarkerFile::Place::List:
        break;
    }
    return tr("The markers are not saved. They can be "
              "saved as a list of times and words (CSV).");
}

void Replacing::clear()
{
    SignalPlan &plan = m_parts.workbench.signalPlan();
    const auto clear = [this, &plan] {
        const bool file = plan.showsFile();
        plan.clear();
        if (file && !plan.showsFile()) // a replay goes on
            m_parts.workbench.events().clear();
    };
    if (plan.showsFile() && !replaying(m_parts.workbench.device()))
        beforeMarkersGo(clear);
    else if (samplesAreKept())
        clear();
    else
        m_parts.prompt.ask({.name = "clearQuestion",
            .title = tr("Clear what was recorded?"),
            .text =
                tr("The scope holds samples that were not exported. They cannot be brought back."),
            .more = tr("What was recorded to a disk stays there, and markers stay."),
            .answers = {{Kind::Lose, tr("&Clear"), clear, "clearYes"}, {},
                {Kind::Go, tr("&Export first\u2026"), [this] { Q_EMIT exportWanted(); },
                    "clearSave"}},
            .usual = 1});
}

} // namespace widgets
