// revup: the stages of the start-up, what is wrong with them, and others in their place.
#include "motor/rev_up.h"
#include "motor_facts.h"
#include "session/files/json_text.h"
#include "session/files/problems.h"
#include "snapshot_work.h"
#include "write_report.h"

#include <QJsonArray>

#include <array>
#include <cmath>

namespace cli {

namespace {

using motor::RevUp;
using motor::RevUpFinding;
using motor::RevUpMistake;

const char *wordOf(RevUpMistake mistake)
{
    constexpr std::array kWords{"too little torque", "ends too slow", "too much current",
        "stage without time", "speed beyond limit", "speed does not fit", "turns back", "no stage"};
    return kWords.at(static_cast<std::size_t>(mistake));
}

auto badStage(const QString &word)
{
    return failure(kUsage,
        QStringLiteral("\"%1\" is no stage; write RPM,A,MS, such as 1200,2.5,1500.").arg(word));
}

Outcome<motor::RevUpStage> stageOf(
    double rpm, double amps, double ms, double ampsPerDigit, const QString &word)
{
    constexpr double kMost = 32767, kLongest_ms = 65535;
    const double digits = std::round(amps / ampsPerDigit);
    const auto tooLarge = [&word](const char *what, double most, const char *unit) {
        return usage(
            QStringLiteral("The %1 of \"%2\" is larger than a stage holds, %3 %4.")
                .arg(QLatin1String(what), word, QString::number(most), QLatin1String(unit)));
    };
    if (std::abs(rpm) > kMost)
        return tooLarge("speed", kMost, "rpm");
    if (std::abs(digits) > kMost)
        return tooLarge("current", kMost * ampsPerDigit, "A");
    if (ms > kLongest_ms)
        return tooLarge("time", kLongest_ms, "ms");
    const auto speed = session::wholeIn<std::int32_t>(rpm, -kMost, kMost);
    const auto current = session::wholeIn<std::int16_t>(digits, -kMost, kMost);
    const auto duration = session::wholeIn<std::uint16_t>(ms, 0, kLongest_ms);
    if (!speed || !current || !duration)
        return badStage(word);
    return motor::RevUpStage{*speed, *current, *duration};
}

Outcome<RevUp> stagesOfWords(const QStringList &words, double ampsPerDigit)
{
    RevUp stages;
    for (const QString &word : words) {
        const QStringList parts = word.split(QLatin1Char(','));
        if (parts.size() != 3)
            return badStage(word);
        const auto rpm = plainNumber(parts[0]), amps = plainNumber(parts[1]),
                   ms = plainNumber(parts[2]);
        if (!rpm || !amps || !ms)
            return badStage(word);
        const auto stage = stageOf(*rpm, *amps, *ms, ampsPerDigit, word);
        if (!stage)
            return tl::make_unexpected(stage.error());
        stages.push_back(*stage);
    }
    return stages;
}

Outcome<RevUp> stagesOfFile(const QString &path, double ampsPerDigit)
{
    const auto content = loadFile(path);
    if (!content)
        return tl::make_unexpected(content.error());
    const auto stages = session::readRevUpJson(*content, ampsPerDigit);
    if (!stages)
        return failure(kFileError,
            session::revUpProblemText(path, stages.error())
                + QStringLiteral(" rotorscope-cli revup --json prints such a file."));
    return *stages;
}

std::vector<RevUpFinding> findingsOf(const RevUp &stages, const drive::MotorFacts &facts)
{
    motor::RevUpLimits limits;
    limits.minimumSpeed_rpm = motor::minimumStartSpeed_rpm(facts.limits.maxSpeedRpm);
    limits.nominalCurrent_a = facts.limits.nominalCurrentAmps;
    limits.maxCurrent_a = facts.limits.maxCurrentAmps;
    limits.maxSpeed_rpm = facts.limits.maxSpeedRpm;
    return motor::checkRevUp(stages, facts.ampsPerDigit, limits);
}

/// Of `is` and `limit`, as motor::RevUpMistake says them.
QLatin1String unitOf(RevUpMistake mistake)
{
    constexpr std::array kUnits{"N m", "rpm", "A", "ms", "rpm", "rpm", "rpm", "ms"};
    return QLatin1String(kUnits.at(static_cast<std::size_t>(mistake)));
}

void printNotes(Output &out, const std::vector<RevUpFinding> &findings)
{
    for (const RevUpFinding &finding : findings)
        out.line(
            QStringLiteral("Note: stage %1: %2 (%3 %5, limit %4 %5)")
                .arg(QString::number(finding.stage + 1), QLatin1String(wordOf(finding.mistake)),
                    QString::number(finding.is, 'g', 5), QString::number(finding.limit, 'g', 5),
                    unitOf(finding.mistake)));
}

void print(Output &out, const RevUp &stages, const drive::MotorFacts &facts)
{
    const auto findings = findingsOf(stages, facts);
    const double duration_s = motor::revUpDuration_s(stages);
    if (out.json()) {
        QJsonArray list;
        for (const RevUpFinding &finding : findings)
            list.append(
                QJsonObject{{QStringLiteral("mistake"), QLatin1String(wordOf(finding.mistake))},
                    {QStringLiteral("stage"), static_cast<int>(finding.stage) + 1},
                    {QStringLiteral("is"), finding.is}, {QStringLiteral("limit"), finding.limit}});
        out.line(QJsonObject{
            {QStringLiteral("stages"), session::revUpStagesJson(stages, facts.ampsPerDigit)},
            {QStringLiteral("duration_s"), duration_s}, {QStringLiteral("findings"), list}});
        return;
    }
    for (std::size_t i = 0; i < stages.size(); ++i)
        out.line(QStringLiteral("Stage %1: %2 rpm, %3 A, %4 ms")
                     .arg(QString::number(i + 1), QString::number(stages[i].speed_rpm),
                         QString::number(stages[i].current_digits * facts.ampsPerDigit, 'g', 5),
                         QString::number(stages[i].duration_ms)));
    printNotes(out, findings);
    out.line(QStringLiteral("Total: %1 s").arg(QString::number(duration_s)));
}

void printRounding(Output &out, const RevUp &wanted, double step_rpm)
{
    const RevUp kept = motor::keptByFirmware(wanted, step_rpm);
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (kept[i].speed_rpm != wanted[i].speed_rpm)
            out.line(QStringLiteral("Note: stage %1: %2 rpm became %3; boards keep steps of %4 rpm")
                         .arg(QString::number(i + 1), QString::number(wanted[i].speed_rpm),
                             QString::number(kept[i].speed_rpm), QString::number(step_rpm)));
}

Outcome<int> writeStages(
    Desk &desk, drive::RegisterId id, const RevUp &stages, const drive::MotorFacts &facts)
{
    for (const RevUpFinding &finding : findingsOf(stages, facts)) {
        const bool current = finding.mistake == RevUpMistake::TooMuchCurrent;
        if (current || finding.mistake == RevUpMistake::SpeedBeyondLimit)
            return failure(kRefused,
                QStringLiteral("The %1 of stage %2 is beyond the limit of %3; nothing was written.")
                    .arg(QLatin1String(current ? "current" : "speed"),
                        QString::number(finding.stage + 1),
                        QString::number(finding.limit) + QLatin1String(current ? " A" : " rpm")));
    }
    const double step_rpm = facts.limits.speedStepRpm;
    const RevUp all = motor::keptByFirmware(motor::completed(stages), step_rpm);
    const drive::Write write{{{id, motor::bytesOf(all)}}, drive::Reach::Parameters};
    const auto written = writeAndReport(desk, write, Digits::Shown, QStringLiteral("The writing"));
    if (written && !desk.out.json()) {
        printRounding(desk.out, stages, step_rpm);
        print(desk.out, all, facts); // bytes alone say little
    }
    return written;
}

Outcome<int> runRevUp(Desk &desk)
{
    const auto facts = readMotorFacts(desk);
    if (!facts)
        return tl::make_unexpected(facts.error());
    const auto id = registerOf(desk, "REVUP_DATA");
    if (!id || !(facts->ampsPerDigit > 0.0))
        return failure(kRefused,
            QStringLiteral(
                "This board has no rev-up stages in amperes; see rotorscope-cli registers."));
    const QStringList &words = desk.arguments.words;
    if (desk.arguments.tuning.set) {
        const bool isFile = words.size() == 1 && !words[0].contains(QLatin1Char(','));
        const auto stages = isFile ? stagesOfFile(words[0], facts->ampsPerDigit)
                                   : stagesOfWords(words, facts->ampsPerDigit);
        if (!stages)
            return tl::make_unexpected(stages.error());
        return writeStages(desk, *id, *stages, *facts);
    }
    const auto readings = desk.talk.read({*id});
    if (!readings)
        return tl::make_unexpected(readings.error());
    const auto *bytes = std::get_if<Bytes>(&readings->front().value);
    const auto stages = motor::revUpOfBytes(bytes != nullptr ? *bytes : Bytes{});
    if (bytes == nullptr || !stages)
        return failure(kRefused,
            QStringLiteral("The board does not give REVUP_DATA; it starts with a sensor, its "
                           "firmware is a small one, or it answers in packets that are too "
                           "short for the list of stages."));
    print(desk.out, *stages, *facts);
    return kDone;
}

constexpr OptionText kRevupOptions[] = {
    {"set", "", "Writes stages RPM,A,MS, or those of a file as revup --json prints them."}};

Outcome<bool> readRevUp(const Given &given, Arguments &arguments)
{
    arguments.tuning.set = given.has("set");
    if (arguments.tuning.set == arguments.words.isEmpty())
        return usage(QStringLiteral(
            "Write revup, or revup --set and the stages as RPM,A,MS, such as 0,2.5,1000 "
            "1200,2.5,1500."));
    return true;
}

} // namespace

const Command kRevUp{.name = "revup",
    .words = "[--set FILE|RPM,A,MS...]",
    .help = "Shows the stages of the start-up and what is wrong with them, or writes others.",
    .most = 5,
    .options = kRevupOptions,
    .read = readRevUp,
    .ofOneMotor = true,
    .numbers = true,
    .run = runRevUp};

} // namespace cli
