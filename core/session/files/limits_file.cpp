#include "session/files/limits_file.h"

#include "drive/motion_limits.h"
#include "session/files/whole_file.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

#include <cmath>
#include <filesystem>

namespace session {

namespace {

constexpr qint64 kLargestFile = 4096;
constexpr QLatin1String kSpeed("maxSpeedRpm"), kCurrent("maxCurrentAmps");

} // namespace

QString limitsPath()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation))
        .filePath(QStringLiteral("rotorscope/limits.json"));
}

Result<std::optional<drive::UserLimits>, QString> loadLimits(const QString &path)
{
    // That it is not there has to be certain: a folder that cannot be looked into is another matter.
    std::error_code unknown;
    if (std::filesystem::status(QFileInfo(path).filesystemFilePath(), unknown).type()
        == std::filesystem::file_type::not_found)
        return std::optional<drive::UserLimits>();
    const auto content = readWholeFile(path, kLargestFile);
    if (!content)
        return fail(content.error());
    const QJsonObject object = QJsonDocument::fromJson(*content).object();
    const double nothing = std::nan("");
    const drive::UserLimits limits{
        object[kSpeed].toDouble(nothing), object[kCurrent].toDouble(nothing)};
    if (!drive::isPlausible(limits))
        return fail(QStringLiteral("it is damaged"));
    return std::optional(limits);
}

QString saveLimits(const drive::UserLimits &limits, const QString &path)
{
    const QJsonObject object{{kSpeed, limits.maxSpeedRpm}, {kCurrent, limits.maxCurrentAmps}};
    QDir().mkpath(QFileInfo(path).path());
    if (const QString wrong = writeWholeFile(path, QJsonDocument(object).toJson());
        !wrong.isEmpty())
        return wrong;
    const auto there = loadLimits(path);
    if (!there)
        return there.error();
    return *there == limits ? QString() : QStringLiteral("it does not hold what was written");
}

} // namespace session
