// show: what is in a recording, and what is missing from it.
#include "commands.h"
#include "recording_work.h"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonObject>

#include <array>

namespace cli {

namespace {

using session::RecordingReport;

// Each in the order of its enumeration.
constexpr std::array kEndingWords{"stopped", "disk full", "write failed"};
constexpr std::array kKindWords{"fast", "slow", "polled"};

QString endingWord(const RecordingReport &report)
{
    return QLatin1String(report.ending
            ? kEndingWords.at(static_cast<std::size_t>(report.ending->reason))
            : "interrupted");
}

QString startText(const RecordingReport &report)
{
    return QDateTime::fromSecsSinceEpoch(report.begin.startSeconds, Qt::UTC).toString(Qt::ISODate);
}

QString happeningText(const recorded::Happening &happening)
{
    QString line = QString::fromStdString(happening.name);
    for (const auto &[key, value] : happening.fields) {
        if (!value.empty())
            line += QStringLiteral(" %1=%2").arg(
                QString::fromStdString(key), QString::fromStdString(value));
    }
    line.replace(QLatin1Char('\n'), QLatin1Char(' '));
    return line;
}

QString kindWord(capture::ChannelInfo::Kind kind)
{
    return QLatin1String(kKindWords.at(static_cast<std::size_t>(kind)));
}

QJsonObject json(const OpenedRecording &opened)
{
    const RecordingReport &report = opened.report;
    QJsonArray channels, happenings, notes, damage;
    for (const capture::ChannelInfo &info : opened.capture.channels()) {
        QJsonObject channel{{QStringLiteral("name"), QString::fromStdString(info.name)},
            {QStringLiteral("unit"), QString::fromStdString(info.unit)},
            {QStringLiteral("kind"), kindWord(info.kind)},
            {QStringLiteral("samples"), static_cast<qint64>(opened.capture.size(info.id))}};
        if (const auto span = opened.capture.timeSpan(info.id)) {
            channel.insert(QStringLiteral("from_s"), span->from);
            channel.insert(QStringLiteral("to_s"), span->to);
        }
        channels.append(channel);
    }
    for (const auto &[at, happening] : report.happenings) {
        QJsonObject fields;
        for (const auto &[key, value] : happening.fields)
            fields.insert(QString::fromStdString(key), QString::fromStdString(value));
        happenings.append(QJsonObject{{QStringLiteral("at_s"), capture::toSeconds(at)},
            {QStringLiteral("what"), QString::fromStdString(happening.name)},
            {QStringLiteral("fields"), fields}});
    }
    for (const recorded::Note &note : report.notes)
        notes.append(QJsonObject{{QStringLiteral("from_s"), capture::toSeconds(note.from)},
            {QStringLiteral("to_s"), capture::toSeconds(note.to)},
            {QStringLiteral("text"), QString::fromStdString(note.text)}});
    for (const recorded::Damage &place : report.damage)
        damage.append(QJsonObject{{QStringLiteral("offset"), static_cast<qint64>(place.offset)},
            {QStringLiteral("bytes"), static_cast<qint64>(place.bytes)},
            {QStringLiteral("blocks"), static_cast<qint64>(place.blocks)},
            {QStringLiteral("text"), session::damageText(place)}});
    return {{QStringLiteral("program"), QString::fromStdString(report.begin.program)},
        {QStringLiteral("source"), QString::fromStdString(report.begin.source)},
        {QStringLiteral("start"), startText(report)},
        {QStringLiteral("ending"), endingWord(report)},
        {QStringLiteral("blocks"), static_cast<qint64>(report.blocks)},
        {QStringLiteral("samples"), static_cast<qint64>(report.samples)},
        {QStringLiteral("link_bytes"), static_cast<qint64>(report.linkBytes)},
        {QStringLiteral("lost_samples"), static_cast<qint64>(report.lost.samples)},
        {QStringLiteral("lost_link_bytes"), static_cast<qint64>(report.lost.linkBytes)},
        {QStringLiteral("lost_others"), static_cast<qint64>(report.lost.others)},
        {QStringLiteral("left_out"), static_cast<qint64>(report.leftOut)},
        {QStringLiteral("snapshots"), static_cast<qint64>(report.snapshots.size())},
        {QStringLiteral("channels"), channels}, {QStringLiteral("events"), happenings},
        {QStringLiteral("notes"), notes}, {QStringLiteral("damage"), damage}};
}

void print(const OpenedRecording &opened, bool events, Output &out)
{
    const RecordingReport &report = opened.report;
    out.line(QStringLiteral("0 s is %1, recorded by %2 from %3")
                 .arg(startText(report), QString::fromStdString(report.begin.program),
                     QString::fromStdString(report.begin.source)));
    out.line(QStringLiteral("Ended: %1; %2 blocks, %3 samples, %4 bytes of the line")
                 .arg(endingWord(report), QString::number(report.blocks),
                     QString::number(report.samples), QString::number(report.linkBytes)));
    for (const capture::ChannelInfo &info : opened.capture.channels()) {
        const auto span = opened.capture.timeSpan(info.id);
        out.line(QStringLiteral("%1 [%2] %3: %4 samples, %5 s to %6 s")
                     .arg(QString::fromStdString(info.name), QString::fromStdString(info.unit),
                         kindWord(info.kind), QString::number(opened.capture.size(info.id)),
                         numberText(span ? span->from : 0.0), numberText(span ? span->to : 0.0)));
    }
    out.line(
        QStringLiteral("%1 events, %2 register snapshots, %3 notes")
            .arg(QString::number(report.happenings.size()),
                QString::number(report.snapshots.size()), QString::number(report.notes.size())));
    if (events) {
        for (const auto &[at, happening] : report.happenings)
            out.line(QStringLiteral("%1 s  %2")
                         .arg(numberText(capture::toSeconds(at)), happeningText(happening)));
    }
    for (const recorded::Note &note : report.notes)
        out.line(QStringLiteral("%1 s  note: %2")
                     .arg(numberText(capture::toSeconds(note.from)),
                         QString::fromStdString(note.text).replace(
                             QLatin1Char('\n'), QLatin1Char(' '))));
    for (const recorded::Damage &place : report.damage)
        out.line(QStringLiteral("Damaged: %1").arg(session::damageText(place)));
}

Outcome<int> runShow(const Arguments &arguments, Output &out)
{
    const QString &path = arguments.words.first();
    const auto opened = openRecording(path);
    if (!opened)
        return tl::make_unexpected(opened.error());
    if (out.json())
        out.line(json(**opened));
    else
        print(**opened, arguments.recording.events, out);
    const QString lack = lackText(**opened);
    if (!lack.isEmpty())
        return failure(kDataLost, QStringLiteral("%1 is not whole: %2.").arg(path, lack));
    return kDone;
}

constexpr OptionText kShowOptions[] = {
    {"events", "", "Prints what happened, line by line, with its time."}};

Outcome<bool> readShow(const Given &given, Arguments &arguments)
{
    arguments.recording.events = given.has("events");
    return true;
}

} // namespace

const Command kShow{.name = "show",
    .words = "FILE.pcapng",
    .help = "Says what is in a recording, and what is missing from it.",
    .least = 1,
    .most = 1,
    .options = kShowOptions,
    .read = readShow,
    .needsPort = false,
    .runAlone = runShow};

} // namespace cli
