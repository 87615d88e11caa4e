#include "session/files/run_stretches.h"

#include "drive/values.h"
#include "lab/evaluation/finding.h"
#include "recorded/gain_stretches.h"
#include "session/files/run_writer.h"
#include "session/files/snapshot_json.h"
#include "session/recording/reader.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

namespace session {
namespace {

using recorded::GainStretch;
using Proceed = std::function<bool(double)>;

QString seconds(recorded::Nanos at) { return QString::number(capture::toSeconds(at), 'f', 3); }

/// What a recording says at first, which each of its parts has to say again.
class Heads {
public:
    void accept(const recorded::Entry &entry)
    {
        if (const auto *layout = std::get_if<capture::StreamLayout>(&entry))
            m_layout = *layout;
        else if (const auto *polled = std::get_if<recorded::PolledRegister>(&entry))
            m_polled[polled->id] = *polled;
    }
    bool write(RunWriter &writer, recorded::Nanos at) const
    {
        bool good = !m_layout || writer.add(at, *m_layout);
        for (const auto &[id, polled] : m_polled)
            good = good && writer.add(at, polled);
        return good;
    }

private:
    std::optional<capture::StreamLayout> m_layout;
    std::map<recorded::RegisterId, recorded::PolledRegister> m_polled;
};

/// With the gains of a stretch, as far as the snapshot has them.
snapshots::Snapshot withGains(
    snapshots::Snapshot registers, const std::map<std::string, double> &gains)
{
    for (snapshots::Entry &entry : registers.entries) {
        auto gain = gains.find(entry.name + "@" + std::to_string(entry.motor));
        if (gain == gains.end() && entry.motor <= 1)
            gain = gains.find(entry.name);
        const auto before = drive::asNumber(entry.value);
        if (gain == gains.end() || !before || *before == gain->second)
            continue;
        if (std::holds_alternative<std::int64_t>(entry.value))
            entry.value = static_cast<std::int64_t>(std::llround(gain->second));
        else
            entry.value = gain->second;
        entry.shown = entry.shown && *before != 0.0
            ? std::optional(*entry.shown * gain->second / *before)
            : std::nullopt;
    }
    return registers;
}

/// What the first pass over a recording finds.
struct Survey {
    recorded::GainStretches parts;
    lab::RunStarts experiments;
    std::size_t withOne = 0; ///< the stretch of the last of these, counted from 1; 0: none yet
    std::map<std::size_t, int> motors; ///< of each of these, by its stretch, counted from 1
    bool measures = false; ///< it has not ended
    std::vector<recorded::Happening> meanwhile; ///< gains that were written, such as those it lends
    std::optional<snapshots::Snapshot> registers; ///< the first that it has
};

bool writesGains(const recorded::Happening &what)
{
    return what.name == "ended" && std::ranges::any_of(what.fields, [](const auto &field) {
        return recorded::isGain(field.first);
    });
}

/// An experiment stays whole: what is written meanwhile counts from its end.
void acceptStretch(Survey &survey, const recorded::Item &item)
{
    const auto *happening = std::get_if<recorded::Happening>(&item.entry);
    const bool begins = happening != nullptr && survey.experiments.accept(*happening);
    if (begins && survey.withOne == survey.parts.all().size())
        survey.parts.part(item.at);
    if (begins || (happening != nullptr && happening->name == lab::kEndEntry)) {
        for (const recorded::Happening &written : std::exchange(survey.meanwhile, {}))
            survey.parts.accept(item.at, written);
        survey.measures = begins;
    }
    if (survey.measures && happening != nullptr && writesGains(*happening))
        survey.meanwhile.push_back(*happening);
    else
        survey.parts.accept(item.at, item.entry);
    if (begins) {
        survey.withOne = survey.parts.all().size();
        survey.motors[survey.withOne] = happening->number<int>("motor").value_or(1);
    }
}

void accept(Survey &survey, const recorded::Item &item)
{
    acceptStretch(survey, item);
    const auto *held = std::get_if<recorded::RegisterSnapshot>(&item.entry);
    if (held == nullptr || survey.registers)
        return;
    if (auto read = readSnapshotJson(QByteArray::fromStdString(held->json)))
        survey.registers = std::move(*read);
}

/// The second pass: each item goes to the run of its stretch.
class StretchWriter {
public:
    StretchWriter(
        QString folder, const QString &recording, const Survey &survey, recorded::Begin begin)
        : m_folder(std::move(folder))
        , m_name(QFileInfo(recording).fileName())
        , m_survey(survey)
        , m_begin(std::move(begin))
    {
    }

    void accept(recorded::Item &&item)
    {
        m_heads.accept(item.entry);
        if (std::holds_alternative<recorded::Begin>(item.entry)
            || std::holds_alternative<recorded::End>(item.entry))
            return;
        const auto &all = m_survey.parts.all();
        while (m_next < all.size() && item.at > all[m_next].to) {
            endRun();
            ++m_next;
        }
        if (m_next >= all.size() || !isKept(all[m_next]) || !m_why.isEmpty())
            return;
        if (!m_writer)
            beginRun(all[m_next]);
        if (m_writer)
            (void)m_writer->add(item.at, item.entry); // its end says why, if it is over
    }

    Result<KeptStretches, QString> end()
    {
        endRun();
        if (!m_why.isEmpty() && m_kept.runs.empty())
            return fail(m_why);
        m_kept.leftOut = static_cast<int>(m_survey.parts.all().size() - m_kept.runs.size());
        return std::move(m_kept);
    }

private:
    bool isKept(const GainStretch &stretch) const
    {
        return capture::toSeconds(stretch.to) - capture::toSeconds(stretch.from) >= kLeastStretch_s
            && m_kept.runs.size() < kMostStretches;
    }
    int motor() const;
    void beginRun(const GainStretch &stretch);
    void endRun();

    QString m_folder, m_name;
    const Survey &m_survey;
    recorded::Begin m_begin;
    Heads m_heads;
    std::size_t m_next = 0; ///< the stretch that is written or looked for
    std::unique_ptr<RunWriter> m_writer;
    KeptStretches m_kept;
    QString m_why; ///< nothing more is kept
};

/// Of the experiment in the stretch, or else of the last one before it, or else of the first.
int StretchWriter::motor() const
{
    const auto &motors = m_survey.motors;
    if (motors.empty())
        return 1;
    const auto behind = motors.upper_bound(m_next + 1);
    return behind == motors.begin() ? behind->second : std::prev(behind)->second;
}

void StretchWriter::beginRun(const GainStretch &stretch)
{
    constexpr recorded::Nanos kSecond = 1'000'000'000;
    Run run;
    run.experiment = QString::fromLatin1(kStretch);
    run.plan = {{QStringLiteral("from s"), seconds(stretch.from)},
        {QStringLiteral("recording"), m_name}, {QStringLiteral("to s"), seconds(stretch.to)}};
    constexpr std::int64_t kFarthest = 100'000'000'000; // a file may hold any number
    run.at = std::clamp(m_begin.startSeconds, -kFarthest, kFarthest) + stretch.to / kSecond;
    run.end = QStringLiteral("complete");
    run.motor = motor();
    if (const auto &held = m_survey.registers) {
        run.board = QString::fromStdString(held->board.firmware);
        const auto &names = held->board.motorNames;
        if (run.motor >= 1 && static_cast<std::size_t>(run.motor) <= names.size())
            run.motorName = QString::fromStdString(names[static_cast<std::size_t>(run.motor) - 1]);
    }
    auto writer = std::make_unique<RunWriter>(m_folder, std::move(run));
    m_why = writer->begin(m_begin);
    if (m_why.isEmpty() && m_heads.write(*writer, stretch.from))
        m_writer = std::move(writer);
}

void StretchWriter::endRun()
{
    if (!m_writer)
        return;
    const auto &held = m_survey.registers;
    const GainStretch &stretch = m_survey.parts.all()[m_next];
    auto run = m_writer->end(held ? std::optional(withGains(*held, stretch.gains)) : std::nullopt);
    if (run)
        m_kept.runs.push_back(std::move(*run));
    else
        m_why = run.error();
    m_writer.reset();
}

/// One of two passes.
Proceed half(const Proceed &proceed, double from)
{
    return [&proceed, from](double fraction) { return !proceed || proceed(from + fraction / 2.0); };
}

} // namespace

Result<KeptStretches, QString> keepStretches(
    const QString &folder, const QString &recording, const Proceed &proceed)
{
    Survey survey;
    const auto report = readRecording(
        recording, [&survey](recorded::Item &&item) { accept(survey, item); }, half(proceed, 0.0));
    if (!report)
        return fail(report.error());
    StretchWriter writer(folder, recording, survey, report->begin);
    const auto second = readRecording(
        recording, [&writer](recorded::Item &&item) { writer.accept(std::move(item)); },
        half(proceed, 0.5));
    if (!second)
        return fail(second.error());
    return writer.end();
}

} // namespace session
