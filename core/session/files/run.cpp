#include "session/files/run.h"

#include "session/files/json_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>

namespace session {
namespace {

constexpr char kRunFormat[] = "rotorscope-run";
constexpr int kRunVersion = 1;
constexpr int kMostNumber = 1'000'000;

QString stemOf(const QString &folder, int number)
{
    return folder + QStringLiteral("/run-%1").arg(number, 4, 10, QLatin1Char('0'));
}

} // namespace

QString recordingOf(const QString &folder, int number)
{
    return stemOf(folder, number) + QStringLiteral(".pcapng");
}

QString registersOf(const QString &folder, int number)
{
    return stemOf(folder, number) + QStringLiteral("-registers.json");
}

QString runFileOf(const QString &folder, int number)
{
    return stemOf(folder, number) + QStringLiteral(".json");
}

int runNumberOf(const QString &fileName)
{
    static const QRegularExpression shape(
        QStringLiteral("^run-(\\d{4,7})(-registers)?\\.(json|pcapng)$"));
    const auto match = shape.match(fileName);
    const int number = match.hasMatch() ? match.captured(1).toInt() : 0;
    return number <= kMostNumber ? number : 0;
}

QByteArray runJson(const Run &run)
{
    QJsonObject plan, gains;
    for (const auto &[name, value] : run.plan)
        plan[name] = value;
    for (auto gain = run.gains.begin(); gain != run.gains.end(); ++gain)
        gains[gain.key()] = gain.value();
    const QJsonObject object{{keyOf("format"), keyOf(kRunFormat)}, {keyOf("version"), kRunVersion},
        {keyOf("at"), run.at}, {keyOf("board"), run.board}, {keyOf("motor"), run.motor},
        {keyOf("motor_name"), run.motorName}, {keyOf("experiment"), run.experiment},
        {keyOf("plan"), plan}, {keyOf("end"), run.end}, {keyOf("reason"), run.reason},
        {keyOf("gains"), gains},
        {keyOf("result"), run.result.isEmpty() ? QJsonValue() : QJsonValue(run.result)},
        {keyOf("notes"), QJsonArray::fromStringList(run.notes)}, {keyOf("note"), run.note},
        {keyOf("starred"), run.starred}};
    return QJsonDocument(object).toJson();
}

Result<Run, QString> readRunJson(const QByteArray &json)
{
    QJsonParseError error;
    const QJsonObject object = QJsonDocument::fromJson(json, &error).object();
    if (error.error != QJsonParseError::NoError)
        return fail(error.errorString());
    if (object[keyOf("format")] != QJsonValue(keyOf(kRunFormat)))
        return fail(QStringLiteral("it is no run"));
    if (object[keyOf("version")].toInt() != kRunVersion)
        return fail(QStringLiteral("it is of a later version"));
    Run run;
    run.at = object[keyOf("at")].toInteger();
    run.board = object[keyOf("board")].toString();
    run.motor = object[keyOf("motor")].toInt(1);
    run.motorName = object[keyOf("motor_name")].toString();
    run.experiment = object[keyOf("experiment")].toString();
    run.end = object[keyOf("end")].toString();
    run.reason = object[keyOf("reason")].toString();
    run.result = object[keyOf("result")].toObject();
    run.note = object[keyOf("note")].toString();
    run.starred = object[keyOf("starred")].toBool();
    const QJsonObject plan = object[keyOf("plan")].toObject();
    for (auto field = plan.begin(); field != plan.end(); ++field)
        run.plan.append({field.key(), field.value().toString()});
    const QJsonObject gains = object[keyOf("gains")].toObject();
    for (auto gain = gains.begin(); gain != gains.end(); ++gain)
        if (gain.value().isDouble())
            run.gains[gain.key()] = gain.value().toDouble();
    const QJsonArray notes = object[keyOf("notes")].toArray();
    for (const auto &note : notes)
        run.notes.append(note.toString());
    return run;
}

} // namespace session
