#include "widgets/window/workspace.h"

#include "widgets/base/device_text.h"
#include "widgets/base/trace_colors.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <array>

namespace widgets {
namespace {

struct WorkspaceFile {
    Q_DECLARE_TR_FUNCTIONS(WorkspaceFile)
};

constexpr int kVersion = 1;
constexpr qsizetype kMostSignals = 64;
constexpr int kMostPlot = 15;
constexpr unsigned kMostFastEvery = 256;
constexpr QLatin1String kMark("rotorscopeWorkspace");

// In the order of their enumerations.
constexpr std::array kRoutes{"fast", "slow", "polled"};
constexpr std::array kTypes{"edge", "level", "window", "pulse", "slew", "dropout", "nthEdge",
    "state", "fault", "write", "setPoint"};
constexpr std::array kWays{"first", "second", "third"};
constexpr std::array kModes{"auto", "normal", "single", "roll"};
static_assert(kTypes.size() == kTriggerTypes);

template <class Words, class Enum>
QString wordOf(const Words &words, Enum value)
{
    return QLatin1String(words[static_cast<std::size_t>(value)]);
}

template <class Words, class Enum>
Enum enumOf(const Words &words, const QJsonValue &word, Enum otherwise)
{
    const auto at = std::find_if(words.begin(), words.end(),
        [text = word.toString()](const char *one) { return text == QLatin1String(one); });
    return at == words.end() ? otherwise : static_cast<Enum>(at - words.begin());
}

double numberOf(const QJsonValue &value, double least, double most, double otherwise)
{
    const double number = value.toDouble(otherwise);
    return number >= least && number <= most ? number : otherwise;
}

QJsonObject triggerJson(const TriggerSetup &setup, const QString &source)
{
    return {{QStringLiteral("source"), source},
        {QStringLiteral("type"), wordOf(kTypes, setup.type)},
        {QStringLiteral("way"), wordOf(kWays, setup.way)}, {QStringLiteral("level"), setup.level},
        {QStringLiteral("upper"), setup.upper}, {QStringLiteral("hysteresis"), setup.hysteresis},
        {QStringLiteral("least_s"), setup.least}, {QStringLiteral("most_s"), setup.most},
        {QStringLiteral("outside"), setup.outside}, {QStringLiteral("time_s"), setup.time},
        {QStringLiteral("count"), setup.count}, {QStringLiteral("written"), setup.written},
        {QStringLiteral("mode"), wordOf(kModes, setup.mode)},
        {QStringLiteral("preTrigger"), setup.preTrigger},
        {QStringLiteral("holdOff_s"), setup.holdOff}, {QStringLiteral("length_s"), setup.length}};
}

TriggerSetup triggerOf(const QJsonObject &object)
{
    constexpr double kAny = 1e12, kLongest_s = 3600.0;
    constexpr int kMostEdges = 1'000'000, kMostName = 100;
    TriggerSetup setup;
    const auto number = [&object](const char *name, double least, double most, double otherwise) {
        return numberOf(object[QLatin1String(name)], least, most, otherwise);
    };
    setup.type = enumOf(kTypes, object[QStringLiteral("type")], setup.type);
    setup.way = enumOf(kWays, object[QStringLiteral("way")], setup.way);
    setup.level = number("level", -kAny, kAny, setup.level);
    setup.upper = number("upper", -kAny, kAny, setup.upper);
    setup.hysteresis = number("hysteresis", 0.0, kAny, setup.hysteresis);
    setup.least = number("least_s", 0.0, kLongest_s, setup.least);
    setup.most = number("most_s", 0.0, kLongest_s, setup.most);
    setup.outside = object[QStringLiteral("outside")].toBool(setup.outside);
    setup.time = number("time_s", 0.0, kLongest_s, setup.time);
    setup.count = static_cast<int>(number("count", 1.0, kMostEdges, setup.count));
    setup.written =
        plainName(deviceText(object[QStringLiteral("written")].toString().left(kMostName)));
    setup.mode = enumOf(kModes, object[QStringLiteral("mode")], setup.mode);
    setup.preTrigger = number("preTrigger", 0.0, 1.0, setup.preTrigger);
    setup.holdOff = number("holdOff_s", 0.0, kLongest_s, setup.holdOff);
    setup.length = number("length_s", 0.0, kLongest_s, setup.length);
    return setup;
}

QJsonArray signalsJson(const std::vector<NamedSignal> &all)
{
    QJsonArray array;
    for (const NamedSignal &signal : all)
        array.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(signal.name)},
            {QStringLiteral("route"), wordOf(kRoutes, signal.route)},
            {QStringLiteral("plot"), signal.plot}});
    return array;
}

std::vector<NamedSignal> signalsOf(const QJsonArray &array)
{
    std::vector<NamedSignal> all;
    for (qsizetype i = 0; i < std::min(array.size(), kMostSignals); ++i) {
        const QJsonObject object = array[i].toObject();
        const QString name = object[QStringLiteral("name")].toString();
        if (!name.isEmpty())
            all.push_back({name.toStdString(),
                enumOf(kRoutes, object[QStringLiteral("route")], Route::Fast),
                static_cast<int>(numberOf(object[QStringLiteral("plot")], 0.0, kMostPlot, 0.0))});
    }
    return all;
}

QJsonArray axesJson(const QMap<QString, ValueRange> &axes)
{
    QJsonArray array;
    for (auto each = axes.begin(); each != axes.end(); ++each)
        array.append(QJsonObject{{QStringLiteral("signal"), each.key()},
            {QStringLiteral("from"), each->from}, {QStringLiteral("to"), each->to}});
    return array;
}

QMap<QString, ValueRange> axesOf(const QJsonArray &array)
{
    constexpr double kAny = 1e12;
    QMap<QString, ValueRange> axes;
    for (qsizetype i = 0; i < std::min(array.size(), kMostSignals); ++i) {
        const QJsonObject object = array[i].toObject();
        const QString signal = object[QStringLiteral("signal")].toString();
        const double from = object[QStringLiteral("from")].toDouble(kAny);
        const double to = object[QStringLiteral("to")].toDouble(-kAny);
        if (!signal.isEmpty() && from >= -kAny && from < to && to <= kAny)
            axes[signal] = {from, to};
    }
    return axes;
}

QJsonArray measuresJson(const QList<NamedMeasure> &measures)
{
    QJsonArray array;
    for (const NamedMeasure &measure : measures)
        array.append(QJsonObject{{QStringLiteral("signal"), measure.signal},
            {QStringLiteral("quantity"), quantityWord(measure.quantity)},
            {QStringLiteral("against"), measure.against}});
    return array;
}

QList<NamedMeasure> measuresOf(const QJsonArray &array)
{
    QList<NamedMeasure> measures;
    for (qsizetype i = 0; i < std::min<qsizetype>(array.size(), kMostMeasures); ++i) {
        const QJsonObject object = array[i].toObject();
        const QString signal = object[QStringLiteral("signal")].toString();
        const auto quantity = quantityOf(object[QStringLiteral("quantity")].toString());
        if (!signal.isEmpty() && quantity)
            measures.append({signal, *quantity, object[QStringLiteral("against")].toString()});
    }
    return measures;
}

/// Where what was given is not what came of it, e.g. "trigger.type"; empty if it all is. A key that is not known
/// may be of a later version.
QString changedPlace(const QJsonValue &given, const QJsonValue &kept)
{
    const auto within = [](const QString &key, const QString &place) {
        return place.startsWith(QLatin1Char(' ')) ? key : key + QLatin1Char('.') + place;
    };
    const QString here(QLatin1Char(' '));
    if (given.isObject() && kept.isObject()) {
        const QJsonObject all = given.toObject(), known = kept.toObject();
        for (auto each = known.begin(); each != known.end(); ++each)
            if (all.contains(each.key()))
                if (const QString place = changedPlace(all[each.key()], each.value());
                    !place.isEmpty())
                    return within(each.key(), place);
        return {};
    }
    if (given.isArray() && kept.isArray()) {
        const QJsonArray all = given.toArray(), known = kept.toArray();
        for (qsizetype i = 0; i < std::min(all.size(), known.size()); ++i)
            if (const QString place = changedPlace(all[i], known[i]); !place.isEmpty())
                return within(QString::number(i + 1), place);
        return all.size() == known.size() ? QString() : here;
    }
    const bool same =
        given.isDouble() && kept.isDouble() ? given.toDouble() == kept.toDouble() : given == kept;
    return same ? QString() : here;
}

} // namespace

QJsonObject workspaceJson(const Workspace &workspace)
{
    QJsonObject colors;
    for (auto each = workspace.traceColors.begin(); each != workspace.traceColors.end(); ++each)
        colors[each.key()] = each.value();
    return {{kMark, kVersion}, {QStringLiteral("signals"), signalsJson(workspace.signalList)},
        {QStringLiteral("fastEvery"), double(workspace.fastEvery)},
        {QStringLiteral("span_s"), workspace.span},
        {QStringLiteral("axes"), axesJson(workspace.axes)},
        {QStringLiteral("trigger"), triggerJson(workspace.trigger, workspace.triggerSource)},
        {QStringLiteral("measurements"), measuresJson(workspace.measures)},
        {QStringLiteral("formulas"), mathFormulasJson(workspace.formulas)},
        {QStringLiteral("references"), referencesJson(workspace.references)},
        {QStringLiteral("traceColors"), colors}, {QStringLiteral("notes"), workspace.notes},
        {QStringLiteral("layout"), QString::fromLatin1(workspace.layout.toBase64())}};
}

Workspace workspaceOf(const QJsonObject &object)
{
    constexpr double kShortest_s = 1e-6, kLongest_s = 1e6;
    Workspace workspace;
    workspace.signalList = signalsOf(object[QStringLiteral("signals")].toArray());
    workspace.fastEvery = static_cast<unsigned>(
        numberOf(object[QStringLiteral("fastEvery")], 1.0, kMostFastEvery, 1.0));
    workspace.span =
        numberOf(object[QStringLiteral("span_s")], kShortest_s, kLongest_s, workspace.span);
    workspace.axes = axesOf(object[QStringLiteral("axes")].toArray());
    const QJsonObject trigger = object[QStringLiteral("trigger")].toObject();
    workspace.trigger = triggerOf(trigger);
    workspace.triggerSource = trigger[QStringLiteral("source")].toString();
    workspace.measures = measuresOf(object[QStringLiteral("measurements")].toArray());
    workspace.formulas = mathFormulasOf(object[QStringLiteral("formulas")].toArray());
    workspace.references = referencesOf(object[QStringLiteral("references")].toArray());
    const QJsonObject colors = object[QStringLiteral("traceColors")].toObject();
    for (auto each = colors.begin(); each != colors.end(); ++each)
        if (const int slot = each.value().toInt(-1); slot >= 0 && slot < kTraceColors)
            workspace.traceColors[each.key()] = slot;
    workspace.notes = object[QStringLiteral("notes")].toString().left(kLongestNotes);
    workspace.layout =
        QByteArray::fromBase64(object[QStringLiteral("layout")].toString().toLatin1());
    return workspace;
}

QByteArray toJson(const Workspace &workspace)
{
    return QJsonDocument(workspaceJson(workspace)).toJson();
}

Result<Workspace, QString> readWorkspace(const QByteArray &json)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (document.isNull()) {
        const auto line = json.left(error.offset).count('\n') + 1;
        return fail(WorkspaceFile::tr("Line %1 is not JSON: %2.")
                        .arg(QString::number(line), error.errorString()));
    }
    const QJsonObject object = document.object();
    if (!object[kMark].isDouble())
        return fail(WorkspaceFile::tr("This is no workspace: it has no \"%1\".").arg(kMark));
    if (object[kMark].toInt() > kVersion)
        return fail(
            WorkspaceFile::tr("It was written by a later version of Rotorscope (its form is %1).")
                .arg(QString::number(object[kMark].toInt())));
    Workspace workspace = workspaceOf(object);
    if (const QString place = changedPlace(object, workspaceJson(workspace)); !place.isEmpty())
        return fail(WorkspaceFile::tr("Its value of %1 cannot be.").arg(place));
    return workspace;
}

} // namespace widgets
