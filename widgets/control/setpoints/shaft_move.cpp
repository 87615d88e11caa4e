#include "widgets/control/setpoints/shaft_move.h"

#include "drive/set_points/shaft_position.h"
#include "motor/ramp.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/base/value_text.h"

#include <QCoreApplication>

#include <cmath>
#include <limits>
#include <numbers>

namespace widgets {
namespace {

struct Shaft {
    Q_DECLARE_TR_FUNCTIONS(Shaft)
};

constexpr double kFarthestDegrees = 360000.0, kDegreeStep = 0.1, kDegreeNotch = 1.0;
constexpr double kDegreesPerRad = 180.0 / std::numbers::pi;
constexpr int kDegreeDecimals = 1;

} // namespace

void makeAngleField(NumberEdit &edit)
{
    edit.setLimits(kFarthestDegrees, kDegreeStep, QStringLiteral("\u00b0"));
    edit.setNotch(kDegreeNotch);
    edit.setText({}); // not clear(), which Undo takes back
}

ShaftMove::ShaftMove(
    const Device &device, const RegisterModel &registers, double degrees, double duration_ms)
    : m_device(device)
    , m_degrees(degrees)
    , m_ms(duration_ms)
{
    if (const auto from = degreesNow(device, registers))
        m_peakRpm =
            motor::positionPeakSpeed_rpm((degrees - *from) / kDegreesPerRad, duration_ms / 1000.0);
}

std::optional<double> ShaftMove::degreesNow(const Device &device, const RegisterModel &registers)
{
    const auto catalog = device.catalog();
    if (!catalog)
        return {};
    const auto angle = drive::shaftAngle_rad(
        *catalog, device.motor(), [&](catalog::RegisterId id) { return registers.current(id); });
    return angle ? std::optional(*angle * kDegreesPerRad) : std::nullopt;
}

QString ShaftMove::angleText(double degrees)
{
    return numberText(degrees, kDegreeDecimals) + QStringLiteral("\u202f\u00b0");
}

double ShaftMove::boundRpm() const
{
    const double bound = m_device.bounds(m_device.motor()).rpm;
    return bound > 0.0 ? bound : std::numeric_limits<double>::infinity();
}

QString ShaftMove::refusal() const
{
    if (m_ms < 1.0)
        return Shaft::tr("A move to an angle needs a time.");
    if (m_peakRpm && *m_peakRpm > boundRpm())
        return Shaft::tr(
            "On the way %1 rpm would be needed: the limit is %2 rpm. Give it more time.")
            .arg(numberText(*m_peakRpm, 0), numberText(boundRpm(), 0));
    return {};
}

QString ShaftMove::outlook() const
{
    return m_peakRpm ? Shaft::tr("at most %1 rpm on the way").arg(numberText(*m_peakRpm, 0))
                     : QString();
}

drive::PositionRamp ShaftMove::wish() const
{
    return {m_device.motor(), m_degrees / kDegreesPerRad,
        std::chrono::milliseconds(std::llround(m_ms))};
}

} // namespace widgets
