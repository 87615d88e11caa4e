// What Rotorscope remembers between two runs, as plain values. A file of our own in JSON; a damaged or missing one
// gives the defaults, and saving replaces it whole or not at all. One that is damaged is put aside, not replaced.
#pragma once

#include "session/transports/endpoint.h"
#include "widgets/base/look/theme.h"
#include "widgets/forms/ramp_preset.h"
#include "widgets/window/workspace.h"

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>

namespace widgets {

constexpr qsizetype kMostTyped = 8; ///< ports that were typed

struct Settings {
    QByteArray geometry; ///< of the window, as Qt saves it
    QString port = QStringLiteral("sim");
    /// That were connected to and that the system does not list, newest first.
    QStringList typedPorts;
    quint32 baud = session::Endpoint{}.baud;
    QString protocol = QStringLiteral("auto");
    Theme theme = Theme::System;
    QString exportFolder;
    QString recordFolder;
    QString snapshotFolder;
    QString runFolder; ///< of the run book; empty: experiments are not kept
    QStringList pinned{QStringLiteral("SPEED_REF"), QStringLiteral("SPEED_MEAS"),
        QStringLiteral("I_Q_REF"), QStringLiteral("BUS_VOLTAGE"), QStringLiteral("HEATS_TEMP"),
        QStringLiteral("SPEED_KP"), QStringLiteral("SPEED_KI")};
    QMap<QString, double> inertias; ///< of rotor and load in kg m2, by the motor's name
    /// Full scale in A, by board and port, where boards do not tell.
    QMap<QString, double> currentScales;
    QStringList registerColumns{QStringLiteral("value"), QStringLiteral("raw")};
    /// Copy of the user's own limits, which have a file of their own; 0: none.
    double maxSpeedRpm = 0.0;
    double maxCurrentAmps = 0.0;
    double samplesOnDiskGB = -1.0; ///< negative: what is usual; 0: memory only
    bool firstStepsDone = false;
    QList<RampPreset> ramps; ///< that the user has named
    QStringList recentFiles; ///< newest first
    Workspace workspace; ///< the last one
    bool operator==(const Settings &) const = default;
};

QByteArray toJson(const Settings &settings);
/// Fields that are missing or of the wrong kind keep their defaults.
Settings settingsFromJson(const QByteArray &json);

QString settingsPath(); ///< in the user's configuration folder
/// A file that cannot be read goes to PATH.bad.
/// @param problem  a sentence about that; empty: there was none
Settings loadSettings(const QString &path, QString *problem = nullptr);
/// @return  why not, in a sentence; empty: they are saved
QString saveSettings(const Settings &settings, const QString &path);

} // namespace widgets
