#include "widgets/files/open_recording.h"

#include "session/files/problems.h"
#include "widgets/base/device_text.h"
#include "widgets/base/messages.h"
#include "widgets/base/value_text.h"
#include "widgets/files/happening_text.h"
#include "widgets/files/job.h"
#include "widgets/scope/events/log.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

struct Opening {
    Q_DECLARE_TR_FUNCTIONS(Opening)
};

bool hasField(const recorded::Happening &happening, const char *key, const char *value)
{
    return std::any_of(happening.fields.begin(), happening.fields.end(),
        [=](const auto &field) { return field.first == key && field.second == value; });
}

EventKind kindOf(const recorded::Happening &happening)
{
    if (happening.name == "motor state")
        return hasField(happening, "state", "fault now") ? EventKind::Fault : EventKind::State;
    if (happening.name == "link trouble")
        return EventKind::Loss;
    if (happening.name == "link")
        return hasField(happening, "state", "lost") ? EventKind::Loss : EventKind::Recovery;
    return happening.name == "write" ? EventKind::Write : EventKind::Command;
}

/// What of a happening is news beside the others: a line of the motion log tells the end of what has an entry already.
bool isShown(const recorded::Happening &happening)
{
    if (happening.name == "motion")
        return hasField(happening, "act", "ARM") || hasField(happening, "act", "DISARM")
            || hasField(happening, "act", "LIMITS") || hasField(happening, "act", "EXPERT_MODE");
    return happening.name != "ended" || !hasField(happening, "outcome", "ok");
}

} // namespace

FileJob *openRecording(const QString &path, QWidget *window,
    std::function<void(OpenedRecording &)> take, std::function<void(const QString &)> fail,
    capture::Capture::Config config)
{
    return new FileJob(
        Opening::tr("Opening %1").arg(fileNameText(path)),
        [path, config = std::move(config), take = std::move(take), fail = std::move(fail)](
            const FileJob::Proceed &proceed) -> FileJob::Finish {
            auto opened = std::make_shared<OpenedRecording>(
                OpenedRecording{path, capture::Capture(config), {}});
            bool cancelled = false;
            auto report = session::readRecording(path, opened->capture, [&](double fraction) {
                cancelled = !proceed(fraction);
                return !cancelled;
            });
            if (cancelled)
                return {};
            if (!report)
                return [path, fail, why = report.error()] {
                    fail(Opening::tr("%1 cannot be opened (%2).")
                             .arg(deviceText(path), deviceText(why)));
                };
            opened->report = std::move(*report);
            return [opened, take] { take(*opened); };
        },
        window);
}

QString releasedText(const capture::Capture &capture)
{
    const auto span = capture.timeSpan();
    if (capture.released() == 0 || !span)
        return {};
    const double room = static_cast<double>(capture.maxBytes() + capture.archiveRoom());
    return Opening::tr("It is larger than the %1 GB of room for it: %2 samples before %3 s are "
                       "not shown, and marked as a gap.")
        .arg(numberText(room / 1e9, 1), QString::number(capture.released()),
            numberText(span->from, 1));
}

QString openedText(const OpenedRecording &opened, bool &whole)
{
    const session::RecordingReport &report = opened.report;
    QStringList sentences{Opening::tr("Opened %1.").arg(deviceText(opened.path))};
    if (const QString released = releasedText(opened.capture); !released.isEmpty())
        sentences.append(released);
    if (report.damagedPlaces > 0)
        sentences.append(
            Opening::tr("%n place(s) in it are damaged; what lies before and after is shown.",
                nullptr, static_cast<int>(report.damagedPlaces)));
    if (const QString lost = session::lostText(report.lost, translatedFileProblem); !lost.isEmpty())
        sentences.append(Opening::tr("It lacks %1, because the disk was too slow.").arg(lost));
    if (report.leftOut > 0)
        sentences.append(
            Opening::tr("%1 of its events, snapshots and notes are left out: they take "
                        "more than %2 MiB.")
                .arg(QString::number(report.leftOut),
                    QString::number(session::RecordingReport::kMostKeptBytes >> 20)));
    if (!report.ending)
        sentences.append(Opening::tr("The recording was interrupted."));
    else if (report.ending->reason == recorded::End::Reason::DiskFull)
        sentences.append(Opening::tr("It ends where the disk was full."));
    else if (report.ending->reason == recorded::End::Reason::WriteFailed)
        sentences.append(Opening::tr("It ends where the disk failed."));
    whole = sentences.size() == 1;
    return sentences.join(QLatin1Char(' '));
}

void fillEvents(EventLog &events, const session::RecordingReport &report)
{
    std::vector<ScopeEvent> all;
    // They come in the order of time, and words are made for those only that the log has room for.
    for (auto each = report.happenings.rbegin();
         each != report.happenings.rend() && all.size() < EventLog::kMost; ++each)
        if (const auto &[at, what] = *each; isShown(what))
            all.push_back({0, capture::toSeconds(at), kindOf(what), happeningText(what)});
    std::reverse(all.begin(), all.end());
    for (const recorded::Note &note : report.notes)
        all.push_back({0, capture::toSeconds(note.from), EventKind::Marker, deviceText(note.text)});
    events.setEvents(std::move(all));
}

std::optional<ReplayedWrites::Write> ReplayedWrites::accept(const session::ReplayedEntry &entry)
{
    const auto *happening = std::get_if<recorded::Happening>(&entry.entry);
    if (!happening || (happening->name != "write" && happening->name != "ended"))
        return {};
    std::string wish;
    QStringList taken; // what is told of each register begins with how it ended
    for (const auto &[key, value] : happening->fields) {
        if (key == "wish")
            wish = value;
        else if (key != "outcome" && key != "reason" && (value == "ok" || value.starts_with("ok,")))
            taken.append(deviceText(key));
    }
    if (happening->name == "write") {
        m_asked[wish] = entry.seconds;
        return {};
    }
    const auto asked = m_asked.find(wish);
    if (asked == m_asked.end())
        return {};
    const double seconds = asked->second;
    m_asked.erase(asked);
    return taken.isEmpty() ? std::nullopt : std::optional(Write{seconds, taken});
}

void addReplayed(EventLog &events, const session::ReplayedEntry &entry)
{
    if (const auto *happening = std::get_if<recorded::Happening>(&entry.entry)) {
        if (isShown(*happening))
            events.add(kindOf(*happening), entry.seconds, happeningText(*happening));
    } else if (const auto *note = std::get_if<recorded::Note>(&entry.entry)) {
        // A marker whose text was changed is told again.
        const QString text = deviceText(note->text);
        const auto &all = events.events();
        const auto known = std::find_if(all.begin(), all.end(), [&entry](const ScopeEvent &event) {
            return event.kind == EventKind::Marker
                && std::abs(event.seconds - entry.seconds) < 1e-6;
        });
        if (recorded::isTakenBack(*note)) {
            if (known != all.end())
                events.removeMarker(known->id);
        } else if (known != all.end())
            events.setText(known->id, text);
        else
            events.add(EventKind::Marker, entry.seconds, text);
    }
}

} // namespace widgets
