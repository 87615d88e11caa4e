#include "widgets/window/settings.h"

#include "widgets/base/trace_colors.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QStandardPaths>

#include <cmath>

namespace widgets {
namespace {

constexpr qint64 kLargestFile = qint64{1024} * 1024;
constexpr double kMostOnDisk_GB = 100'000.0;
constexpr qsizetype kMostPinned = 200, kMostNumbers = 200;

QString themeName(Theme theme)
{
    return theme == Theme::Light ? QStringLiteral("light")
        : theme == Theme::Dark   ? QStringLiteral("dark")
                                 : QStringLiteral("system");
}

Theme themeOf(const QString &name)
{
    return name == QLatin1String("light") ? Theme::Light
        : name == QLatin1String("dark")   ? Theme::Dark
                                          : Theme::System;
}

QJsonObject numbersObject(const QMap<QString, double> &numbers)
{
    QJsonObject object;
    for (auto at = numbers.begin(); at != numbers.end(); ++at)
        object[at.key()] = at.value();
    return object;
}

/// Numbers above 0 by a name.
QMap<QString, double> numbersOf(const QJsonObject &object)
{
    QMap<QString, double> numbers;
    for (auto at = object.begin(); at != object.end() && numbers.size() < kMostNumbers; ++at)
        if (const double number = at.value().toDouble(); number > 0.0)
            numbers[at.key()] = number;
    return numbers;
}

QByteArray bytesOf(const QJsonValue &value)
{
    return QByteArray::fromBase64(value.toString().toLatin1());
}

/// A limit that is none bounds nothing: better than one that bounds everything or that nobody set.
double limitOf(const QJsonValue &value)
{
    const double limit = value.toDouble(0.0);
    return std::isfinite(limit) && limit > 0.0 ? limit : 0.0;
}

} // namespace

QByteArray toJson(const Settings &settings)
{
    QJsonObject object;
    object[QStringLiteral("geometry")] = QString::fromLatin1(settings.geometry.toBase64());
    object[QStringLiteral("layout")] = QString::fromLatin1(settings.layout.toBase64());
    object[QStringLiteral("port")] = settings.port;
    object[QStringLiteral("baud")] = double(settings.baud);
    object[QStringLiteral("protocol")] = settings.protocol;
    object[QStringLiteral("theme")] = themeName(settings.theme);
    object[QStringLiteral("exportFolder")] = settings.exportFolder;
    object[QStringLiteral("recordFolder")] = settings.recordFolder;
    object[QStringLiteral("snapshotFolder")] = settings.snapshotFolder;
    object[QStringLiteral("pinned")] = QJsonArray::fromStringList(settings.pinned);
    object[QStringLiteral("inertias")] = numbersObject(settings.inertias);
    object[QStringLiteral("currentScales")] = numbersObject(settings.currentScales);
    QJsonObject colors;
    for (auto each = settings.traceColors.begin(); each != settings.traceColors.end(); ++each)
        colors[each.key()] = each.value();
    object[QStringLiteral("traceColors")] = colors;
    object[QStringLiteral("registerColumns")] =
        QJsonArray::fromStringList(settings.registerColumns);
    object[QStringLiteral("maxSpeedRpm")] = settings.maxSpeedRpm;
    object[QStringLiteral("maxCurrentAmps")] = settings.maxCurrentAmps;
    object[QStringLiteral("samplesOnDiskGB")] = settings.samplesOnDiskGB;
    object[QStringLiteral("firstStepsDone")] = settings.firstStepsDone;
    object[QStringLiteral("ramps")] = rampPresetsJson(settings.ramps);
    object[QStringLiteral("formulas")] = mathFormulasJson(settings.formulas);
    return QJsonDocument(object).toJson();
}

Settings settingsFromJson(const QByteArray &json)
{
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    Settings settings;
    settings.geometry = bytesOf(object[QStringLiteral("geometry")]);
    settings.layout = bytesOf(object[QStringLiteral("layout")]);
    settings.port = object[QStringLiteral("port")].toString(settings.port);
    const double baud = object[QStringLiteral("baud")].toDouble(settings.baud);
    if (baud >= 1.0 && baud <= 4294967295.0)
        settings.baud = static_cast<quint32>(baud);
    settings.protocol = object[QStringLiteral("protocol")].toString(settings.protocol);
    settings.theme = themeOf(object[QStringLiteral("theme")].toString());
    settings.exportFolder = object[QStringLiteral("exportFolder")].toString();
    settings.recordFolder = object[QStringLiteral("recordFolder")].toString();
    settings.snapshotFolder = object[QStringLiteral("snapshotFolder")].toString();
    if (object[QStringLiteral("pinned")].isArray()) {
        settings.pinned.clear();
        const QJsonArray names = object[QStringLiteral("pinned")].toArray();
        for (qsizetype i = 0; i < std::min(names.size(), kMostPinned); ++i)
            settings.pinned.append(names[i].toString());
    }
    settings.inertias = numbersOf(object[QStringLiteral("inertias")].toObject());
    settings.currentScales = numbersOf(object[QStringLiteral("currentScales")].toObject());
    const QJsonObject colors = object[QStringLiteral("traceColors")].toObject();
    for (auto each = colors.begin(); each != colors.end(); ++each)
        if (const int slot = each.value().toInt(-1); slot >= 0 && slot < kTraceColors)
            settings.traceColors[each.key()] = slot;
    if (object[QStringLiteral("registerColumns")].isArray()) {
        settings.registerColumns.clear();
        const QJsonArray names = object[QStringLiteral("registerColumns")].toArray();
        for (qsizetype i = 0; i < std::min(names.size(), kMostPinned); ++i)
            settings.registerColumns.append(names[i].toString());
    }
    settings.maxSpeedRpm = limitOf(object[QStringLiteral("maxSpeedRpm")]);
    settings.maxCurrentAmps = limitOf(object[QStringLiteral("maxCurrentAmps")]);
    const double onDisk = object[QStringLiteral("samplesOnDiskGB")].toDouble(-1.0);
    if (onDisk >= 0.0 && onDisk <= kMostOnDisk_GB)
        settings.samplesOnDiskGB = onDisk;
    settings.firstStepsDone = object[QStringLiteral("firstStepsDone")].toBool(false);
    settings.ramps = rampPresetsOf(object[QStringLiteral("ramps")].toArray());
    settings.formulas = mathFormulasOf(object[QStringLiteral("formulas")].toArray());
    return settings;
}

QString settingsPath()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation))
        .filePath(QStringLiteral("settings.json"));
}

Settings loadSettings(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly) || file.size() > kLargestFile)
        return {};
    return settingsFromJson(file.readAll());
}

bool saveSettings(const Settings &settings, const QString &path)
{
    QDir().mkpath(QFileInfo(path).path());
    QSaveFile file(path);
    const QByteArray json = toJson(settings);
    if (!file.open(QIODevice::WriteOnly))
        return false;
    // On a full disk commit() can still succeed after a short write: the file would be cut.
    if (file.write(json) != json.size() || !file.flush()) {
        file.cancelWriting();
        return false;
    }
    return file.commit();
}

} // namespace widgets
