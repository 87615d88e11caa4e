#include "session/files/run.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>

namespace session {
namespace {

constexpr char kFormat[] = "rotorscope-run";
constexpr int kVersion = 1;
constexpr int kMostNumber = 1'000'000;

QString key(const char *name) { return QString::fromLatin1(name); }

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
    const QJsonObject object{{key("format"), key(kFormat)}, {key("version"), kVersion},
        {key("at"), run.at}, {key("board"), run.board}, {key("motor"), run.motor},
        {key("motor_name"), run.motorName}, {key("experiment"), run.experiment},
        {key("plan"), plan}, {key("end"), run.end}, {key("reason"), run.reason},
        {key("gains"), gains},
        {key("result"), run.result.isEmpty() ? QJsonValue() : QJsonValue(run.result)},
        {key("notes"), QJsonArray::fromStringList(run.notes)}, {key("note"), run.note},
        {key("starred"), run.starred}};
    return QJsonDocument(object).toJson();
}

Result<Run, QString> readRunJson(const QByteArray &json)
{
    QJsonParseError error;
    const QJsonObject object = QJsonDocument::fromJson(json, &error).object();
    if (error.error != QJsonParseError::NoError)
        return fail(error.errorString());
    if (object[key("format")] != QJsonValue(key(kFormat)))
        return fail(QStringLiteral("it is no run"));
    if (object[key("version")].toInt() != kVersion)
        return fail(QStringLiteral("it is of a later version"));
    Run run;
    run.at = object[key("at")].toInteger();
    run.board = object[key("board")].toString();
    run.motor = object[key("motor")].toInt(1);
    run.motorName = object[key("motor_name")].toString();
    run.experiment = object[key("experiment")].toString();
    run.end = object[key("end")].toString();
    run.reason = object[key("reason")].toString();
    run.result = object[key("result")].toObject();
    run.note = object[key("note")].toString();
    run.starred = object[key("starred")].toBool();
    const QJsonObject plan = object[key("plan")].toObject();
    for (auto field = plan.begin(); field != plan.end(); ++field)
        run.plan.append({field.key(), field.value().toString()});
    const QJsonObject gains = object[key("gains")].toObject();
    for (auto gain = gains.begin(); gain != gains.end(); ++gain)
        if (gain.value().isDouble())
            run.gains[gain.key()] = gain.value().toDouble();
    const QJsonArray notes = object[key("notes")].toArray();
    for (const auto &note : notes)
        run.notes.append(note.toString());
    return run;
}

} // namespace session
