#include "own_limits.h"

#include "commands.h"
#include "session/limits_file.h"

namespace cli {

Outcome<bool> addOwnLimits(Arguments &arguments, const QString &file)
{
    drive::UserLimits &limits = arguments.limits;
    if (arguments.command == nullptr || !arguments.command->canMove
        || (limits.maxSpeedRpm > 0.0 && limits.maxCurrentAmps > 0.0))
        return true;
    const auto own = session::loadLimits(file);
    if (!own)
        return failure(kFileError,
            QStringLiteral(
                "Your own limits in %1 cannot be read (%2); set them anew in the window, "
                "or give --max-rpm and --max-amps.")
                .arg(file, own.error()));
    if (!*own)
        return true;
    QStringList taken;
    const auto take = [&taken](double &limit, double its, const QString &unit) {
        if (limit > 0.0 || !(its > 0.0))
            return;
        limit = its;
        taken.append(numberText(its) + QLatin1Char(' ') + unit);
    };
    take(limits.maxSpeedRpm, (*own)->maxSpeedRpm, QStringLiteral("rpm"));
    take(limits.maxCurrentAmps, (*own)->maxCurrentAmps, QStringLiteral("A"));
    if (!taken.isEmpty())
        Output::error(QStringLiteral("Your own limits hold: %1 (from %2).")
                          .arg(taken.join(QStringLiteral(", ")), file));
    return true;
}

} // namespace cli
