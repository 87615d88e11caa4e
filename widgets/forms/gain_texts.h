// The words of the gain forms: units of gains, and what is to be said about a plan.
#pragma once

#include "motor/gain_plan.h"

#include <QString>

namespace widgets {

class RegisterModel;

/// The board's gains are numbers in units of their own, not digits over a divisor.
bool gainsInUnits(const RegisterModel &model);
/// Of the numerator's register; its divisor's ends in "_DIV".
const char *gainRegister(motor::GainId id);
/// "V/A", "A/rad"; the same in every language.
QString gainUnit(motor::GainId id);
QString gainWithUnit(double physical, const QString &unit);
/// "4621/2^10"
QString fractionText(const motor::FixedPointGain &gain);

/// One sentence, with what to do.
QString gainFindingText(const motor::GainFinding &finding);

} // namespace widgets
