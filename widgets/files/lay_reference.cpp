#include "widgets/files/lay_reference.h"

#include "widgets/base/device_text.h"
#include "widgets/files/happening_text.h"
#include "widgets/files/open_recording.h"
#include "widgets/scope/ghosts.h"
#include "widgets/scope/view.h"

#include <QCoreApplication>
#include <QKeySequence>

#include <algorithm>
#include <array>

namespace widgets {
namespace {

struct Laid {
    Q_DECLARE_TR_FUNCTIONS(Laid)
};

constexpr std::size_t kMostInstants = 1000;

bool isAct(const recorded::Happening &happening)
{
    static constexpr std::array kActs{
        "command", "speed ramp", "torque ramp", "current reference", "position ramp", "step"};
    return std::find(kActs.begin(), kActs.end(), happening.name) != kActs.end();
}

/// Its beginning, what was commanded, and what the user noted, in the order of time.
std::vector<Instant> instantsOf(const OpenedRecording &opened, double begin)
{
    std::vector<Instant> all;
    for (const auto &[at, what] : opened.report.happenings)
        if (isAct(what) && all.size() < kMostInstants)
            all.push_back({capture::toSeconds(at), happeningText(what)});
    for (const recorded::Note &note : opened.report.notes)
        if (all.size() < kMostInstants)
            all.push_back({capture::toSeconds(note.from), deviceText(note.text)});
    std::stable_sort(all.begin(), all.end(),
        [](const Instant &one, const Instant &other) { return one.seconds < other.seconds; });
    all.insert(all.begin(), {begin, Laid::tr("its beginning", "of a recording")});
    return all;
}

} // namespace

QString layReference(
    ScopeView &scope, const capture::Capture &shown, OpenedRecording &opened, bool &good)
{
    const QString name = fileNameText(opened.path);
    std::vector<capture::ChannelId> all;
    for (const capture::ChannelInfo &info : opened.capture.channels())
        all.push_back(info.id);
    int there = 0;
    const QList<capture::ChannelId> traces = scope.channels();
    for (const capture::ChannelId id : traces)
        if (const auto info = shown.info(id))
            there += opened.capture.find(info->registerId) ? 1 : 0;
    const auto span = opened.capture.timeSpan();
    good = there > 0 && span;
    if (!good)
        return Laid::tr("None of the signals on the scope is in %1.", "a file").arg(name);
    ScopeGhosts &ghosts = scope.ghosts();
    std::vector<Instant> instants = instantsOf(opened, span->from);
    // A trigger is laid upon what was done then, a picture that rolls upon the beginning.
    const std::size_t first = ghosts.zero().trigger && instants.size() > 1 ? 1 : 0;
    const Reference which = ghosts.hasReference(Reference::A) ? Reference::B : Reference::A;
    ghosts.lay(which, opened.capture.snapshot(all), std::move(instants), first);
    return Laid::tr("%1 is reference %2, with %3 of the %4 signals on the scope.",
               "file, A or B, numbers")
               .arg(name, which == Reference::A ? QStringLiteral("A") : QStringLiteral("B"),
                   QString::number(there), QString::number(traces.size()))
        + QLatin1Char(' ') + laidText(scope, which);
}

QString laidText(ScopeView &scope, Reference which)
{
    const ScopeGhosts &ghosts = scope.ghosts();
    const QString what = ghosts.instant(which).text;
    return (ghosts.zero().trigger ? Laid::tr("At the trigger lies: %1.", "a moment of a file")
                                  : Laid::tr("At the left edge lies: %1.", "a moment of a file"))
        .arg(what);
}

QString replacedText(Reference which, bool back)
{
    const QString letter(QLatin1Char(which == Reference::A ? 'A' : 'B'));
    if (back)
        return Laid::tr("Reference %1 is again the one before.", "a letter").arg(letter);
    const QKeySequence key(Qt::SHIFT | (which == Reference::A ? Qt::Key_R : Qt::Key_B));
    return Laid::tr(
        "There was a reference %1 already. It is replaced; %2 brings it back.", "a letter, a key")
        .arg(letter, key.toString(QKeySequence::NativeText));
}

} // namespace widgets
