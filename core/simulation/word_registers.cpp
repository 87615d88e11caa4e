// The table of 16-bit registers.
#include "simulation/word_registers.h"

#include <array>

namespace simulation {

namespace {

using Use = WordRegister::Use;
using Build = WordRegister::Build;

constexpr WordRegister gain(std::uint16_t element, std::int16_t Tuning::*member)
{
    return {element, Use::Gain, nullptr, member, Build::Every};
}

constexpr WordRegister signal(
    std::uint16_t element, Use use, std::int16_t Signals::*member, Build build = Build::Every)
{
    return {element, use, member, nullptr, build};
}

constexpr std::array kRegisters{
    gain(2, &Tuning::speedKp),
    gain(3, &Tuning::speedKi),
    gain(4, &Tuning::speedKd),
    gain(6, &Tuning::qKp),
    gain(7, &Tuning::qKi),
    gain(8, &Tuning::qKd),
    gain(10, &Tuning::dKp),
    gain(11, &Tuning::dKi),
    gain(12, &Tuning::dKd),
    gain(13, &Tuning::pllC1),
    gain(14, &Tuning::pllC2),
    gain(17, &Tuning::pllKi),
    gain(18, &Tuning::pllKp),
    signal(22, Use::Measured, &Signals::busVoltage_v),
    signal(23, Use::Measured, &Signals::temperature_c),
    signal(31, Use::Logged, &Signals::iA),
    signal(32, Use::Logged, &Signals::iB),
    signal(33, Use::Logged, &Signals::iAlpha),
    signal(34, Use::Logged, &Signals::iBeta),
    signal(35, Use::Logged, &Signals::iQ),
    signal(36, Use::Logged, &Signals::iD),
    signal(37, Use::Reference, &Signals::iQRef),
    signal(38, Use::Reference, &Signals::iDRef),
    signal(39, Use::Logged, &Signals::vQ),
    signal(40, Use::Logged, &Signals::vD),
    signal(41, Use::Logged, &Signals::vAlpha),
    signal(42, Use::Logged, &Signals::vBeta),
    signal(45, Use::Logged, &Signals::pllAngle),
    signal(46, Use::LoggedSpeed, &Signals::pllSpeed),
    signal(47, Use::Measured, &Signals::pllIAlpha),
    signal(48, Use::Measured, &Signals::pllIBeta),
    signal(49, Use::Logged, &Signals::pllBemfAlpha),
    signal(50, Use::Logged, &Signals::pllBemfBeta),
    signal(59, Use::Logged, &Signals::hallAngle, Build::Hall),
    signal(60, Use::LoggedSpeed, &Signals::hallSpeed, Build::Hall),
    gain(81, &Tuning::speedKpDiv),
    gain(82, &Tuning::speedKiDiv),
    gain(83, &Tuning::speedKdDiv),
    gain(84, &Tuning::dKpDiv),
    gain(85, &Tuning::dKiDiv),
    gain(86, &Tuning::dKdDiv),
    gain(87, &Tuning::qKpDiv),
    gain(88, &Tuning::qKiDiv),
    gain(89, &Tuning::qKdDiv),
    gain(99, &Tuning::pllKiDiv),
    gain(100, &Tuning::pllKpDiv),
    signal(115, Use::OnlyLogged, &Signals::openLoopAngle, Build::OpenLoop),
};

} // namespace

const WordRegister *findWordRegister(unsigned element, const Traits &traits)
{
    for (const WordRegister &row : kRegisters) {
        if (row.element != element)
            continue;
        const bool there = row.build == Build::Every || (row.build == Build::Hall && traits.hasHall)
            || (row.build == Build::OpenLoop && traits.hasOpenLoopAngle);
        return there ? &row : nullptr;
    }
    return nullptr;
}

} // namespace simulation
