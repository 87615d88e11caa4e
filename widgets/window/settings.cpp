#include "widgets/window/settings.h"

#include "session/files/whole_file.h"
#include "widgets/base/device_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

#include <cmath>

namespace widgets {
namespace {

constexpr qint64 kLargestFile = qint64{32} << 20; // with references
constexpr double kMostOnDisk_GB = 100'000.0;
constexpr qsizetype kMostPinned = 200, kMostNumbers = 200, kMostRecent = 10;

struct SettingsFile {
    Q_DECLARE_TR_FUNCTIONS(SettingsFile)
};

/// At its old place the next saving would replace it, and with it what can still be read in it.
QString putAside(const QString &path)
{
    const QString aside = path + QStringLiteral(".bad");
    QFile::remove(aside); // of an earlier time
    return QFile::rename(path, aside)
        ? SettingsFile::tr("The settings could not be read, so all are as at first. The damaged "
                           "file is kept as %1.")
              .arg(deviceText(aside))
        : SettingsFile::tr("The settings could not be read, so all are as at first. The damaged "
                           "file %1 is replaced when Rotorscope ends.")
              .arg(deviceText(path));
}

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

/// The first texts of a list.
QStringList namesOf(const QJsonValue &list, qsizetype most)
{
    QStringList names;
    const QJsonArray array = list.toArray();
    for (qsizetype i = 0; i < std::min(array.size(), most); ++i)
        names.append(array[i].toString());
    return names;
}

/// A limit that is none bounds nothing: better than one that bounds everything or that was not set.
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
    object[QStringLiteral("port")] = settings.port;
    object[QStringLiteral("typedPorts")] = QJsonArray::fromStringList(settings.typedPorts);
    object[QStringLiteral("baud")] = double(settings.baud);
    object[QStringLiteral("protocol")] = settings.protocol;
    object[QStringLiteral("theme")] = themeName(settings.theme);
    object[QStringLiteral("exportFolder")] = settings.exportFolder;
    object[QStringLiteral("recordFolder")] = settings.recordFolder;
    object[QStringLiteral("snapshotFolder")] = settings.snapshotFolder;
    object[QStringLiteral("runFolder")] = settings.runFolder;
    object[QStringLiteral("pinned")] = QJsonArray::fromStringList(settings.pinned);
    object[QStringLiteral("inertias")] = numbersObject(settings.inertias);
    object[QStringLiteral("currentScales")] = numbersObject(settings.currentScales);
    object[QStringLiteral("registerColumns")] =
        QJsonArray::fromStringList(settings.registerColumns);
    object[QStringLiteral("maxSpeedRpm")] = settings.maxSpeedRpm;
    object[QStringLiteral("maxCurrentAmps")] = settings.maxCurrentAmps;
    object[QStringLiteral("samplesOnDiskGB")] = settings.samplesOnDiskGB;
    object[QStringLiteral("firstStepsDone")] = settings.firstStepsDone;
    object[QStringLiteral("ramps")] = rampPresetsJson(settings.ramps);
    object[QStringLiteral("recentFiles")] = QJsonArray::fromStringList(settings.recentFiles);
    object[QStringLiteral("workspace")] = workspaceJson(settings.workspace);
    return QJsonDocument(object).toJson();
}

Settings settingsFromJson(const QByteArray &json)
{
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    Settings settings;
    settings.geometry = bytesOf(object[QStringLiteral("geometry")]);
    settings.port = object[QStringLiteral("port")].toString(settings.port);
    const double baud = object[QStringLiteral("baud")].toDouble(settings.baud);
    if (baud >= 1.0 && baud <= 4294967295.0)
        settings.baud = static_cast<quint32>(baud);
    settings.protocol = object[QStringLiteral("protocol")].toString(settings.protocol);
    settings.theme = themeOf(object[QStringLiteral("theme")].toString());
    settings.exportFolder = object[QStringLiteral("exportFolder")].toString();
    settings.recordFolder = object[QStringLiteral("recordFolder")].toString();
    settings.snapshotFolder = object[QStringLiteral("snapshotFolder")].toString();
    settings.runFolder = object[QStringLiteral("runFolder")].toString();
    if (object[QStringLiteral("pinned")].isArray())
        settings.pinned = namesOf(object[QStringLiteral("pinned")], kMostPinned);
    settings.inertias = numbersOf(object[QStringLiteral("inertias")].toObject());
    settings.currentScales = numbersOf(object[QStringLiteral("currentScales")].toObject());
    if (object[QStringLiteral("registerColumns")].isArray())
        settings.registerColumns = namesOf(object[QStringLiteral("registerColumns")], kMostPinned);
    settings.maxSpeedRpm = limitOf(object[QStringLiteral("maxSpeedRpm")]);
    settings.maxCurrentAmps = limitOf(object[QStringLiteral("maxCurrentAmps")]);
    const double onDisk = object[QStringLiteral("samplesOnDiskGB")].toDouble(-1.0);
    if (onDisk >= 0.0 && onDisk <= kMostOnDisk_GB)
        settings.samplesOnDiskGB = onDisk;
    settings.firstStepsDone = object[QStringLiteral("firstStepsDone")].toBool(false);
    settings.ramps = rampPresetsOf(object[QStringLiteral("ramps")].toArray());
    settings.typedPorts = namesOf(object[QStringLiteral("typedPorts")], kMostTyped);
    settings.recentFiles = namesOf(object[QStringLiteral("recentFiles")], kMostRecent);
    settings.workspace = workspaceOf(object[QStringLiteral("workspace")].toObject());
    return settings;
}

QString settingsPath()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation))
        .filePath(QStringLiteral("settings.json"));
}

Settings loadSettings(const QString &path, QString *problem)
{
    if (!QFileInfo::exists(path))
        return {};
    const auto json = session::readWholeFile(path, kLargestFile);
    if (json && QJsonDocument::fromJson(*json).isObject())
        return settingsFromJson(*json);
    const QString sentence = putAside(path);
    if (problem != nullptr)
        *problem = sentence;
    return {};
}

QString saveSettings(const Settings &settings, const QString &path)
{
    QDir().mkpath(QFileInfo(path).path());
    const QString why = session::writeWholeFile(path, toJson(settings));
    return why.isEmpty()
        ? QString()
        : SettingsFile::tr("Settings and notes cannot be saved (%1): what is changed now is lost "
                           "when Rotorscope ends.")
              .arg(why);
}

} // namespace widgets
