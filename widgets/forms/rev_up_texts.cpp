#include "widgets/forms/rev_up_texts.h"

#include "widgets/base/value_text.h"

#include <QCoreApplication>

#include <cmath>
#include <numbers>

namespace widgets {
namespace {

using motor::RevUpFinding;
using motor::RevUpMistake;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(RevUp)
};

QString rpm(double value) { return numberText(value, 0) + QStringLiteral("\u202frpm"); }
QString amps(double value) { return numberText(value, 2) + QStringLiteral("\u202fA"); }

/// What would turn the rotor: more current, or more time. Empty parts where no number helps.
QString torqueAdvice(const RevUpFinding &finding, const RevUpModel &model)
{
    const auto &load = model.facts().limits.load;
    const motor::RevUp &stages = model.stages();
    const double from = finding.stage > 0 ? stages[finding.stage - 1].speed_rpm : 0.0;
    motor::RevUpStage endless = stages[finding.stage];
    const double radps = std::abs(endless.speed_rpm - from) * 2.0 * std::numbers::pi / 60.0;
    endless.duration_ms = model.bounds().duration_ms;
    const double friction = motor::neededTorque_nm(endless, from, load)
        - load.inertia_kgm2 * radps / (endless.duration_ms * 1e-3);
    const double left = finding.is - friction;
    const QString current = amps(finding.limit / load.kt_nmpa);
    if (finding.is <= 0.0 && finding.stage == 0)
        return Texts::tr("Begin with a stage at 0\u202frpm that brings the current, at least %1.")
            .arg(current);
    if (!(left > 0.0))
        return Texts::tr("Raise the current here and before to at least %1.").arg(current);
    const QString time = numberText(std::ceil(1e3 * load.inertia_kgm2 * radps / left), 0)
        + QStringLiteral("\u202fms");
    if (finding.limit / load.kt_nmpa > model.bounds().digits * model.shownPerDigit())
        return Texts::tr("Give it at least %1; so much current is not allowed.").arg(time);
    return Texts::tr("Give it at least %1, or a current of at least %2 here and before.")
        .arg(time, current);
}

} // namespace

QString torqueText(double nm)
{
    if (std::abs(nm) < 1.0)
        return numberText(1e3 * nm, std::abs(nm) < 0.1 ? 1 : 0) + QStringLiteral("\u202fmN\u00b7m");
    return numberText(nm, std::abs(nm) < 10.0 ? 2 : 1) + QStringLiteral("\u202fN\u00b7m");
}

QString revUpFindingText(const RevUpFinding &finding, const RevUpModel &model)
{
    const QString stage = QString::number(finding.stage + 1);
    switch (finding.mistake) {
    case RevUpMistake::TooLittleTorque:
        if (std::isinf(finding.limit))
            break;
        return Texts::tr("Stage %1 needs %2, its current gives %3: the rotor does not follow.")
                   .arg(stage, torqueText(finding.limit), torqueText(finding.is))
            + QLatin1Char(' ') + torqueAdvice(finding, model);
    case RevUpMistake::EndsTooSlow:
        return Texts::tr(
            "Stage %1 ends at %2, where the observer does not see the rotor yet. Let it "
            "end above %3.")
            .arg(stage, rpm(finding.is), rpm(finding.limit));
    case RevUpMistake::TooMuchCurrent:
        return Texts::tr("Stage %1 takes %2, more than the limit of %3. Lower it.")
            .arg(stage, amps(finding.is), amps(finding.limit));
    case RevUpMistake::StageWithoutTime:
        return Texts::tr("Stage %1 takes no time: speed or current jump, the rotor is left behind. "
                         "Give it time, or remove it.")
            .arg(stage);
    case RevUpMistake::SpeedBeyondLimit:
        return Texts::tr("Stage %1 goes to %2, beyond the limit of %3. Lower it.")
            .arg(stage, rpm(finding.is), rpm(finding.limit));
    case RevUpMistake::SpeedDoesNotFit:
        return Texts::tr("Stage %1 goes to %2; firmware keeps 16 bits of it, at most %3. Lower it.")
            .arg(stage, rpm(finding.is), rpm(finding.limit));
    case RevUpMistake::TurnsBack:
        return Texts::tr(
            "Stage %1 turns against the stage before. Give all the same sign; backwards "
            "starts come from the sign of the speed set-point.")
            .arg(stage);
    case RevUpMistake::NoStage:
        return Texts::tr(
            "No stage takes any time: the motor would not start. Add a stage, or begin "
            "with the start values.");
    }
    return {};
}

} // namespace widgets
