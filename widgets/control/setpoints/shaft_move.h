// ShaftMove: a move of the shaft to an angle within a time, as its fields have it: whether it may be sent, and what is
// said of it before. Degrees, as people turn shafts; the board's own zero.
#pragma once

#include "drive/wish.h"
#include "widgets/base/device.h"
#include "widgets/registers/model.h"

#include <optional>

namespace widgets {

class NumberEdit;

/// What a field for the angle takes; empty at first, for zero would be a place to go to.
void makeAngleField(NumberEdit &edit);

class ShaftMove {
public:
    /// @param duration  what stands in the field of the time
    ShaftMove(
        const Device &device, const RegisterModel &registers, double degrees, double duration_ms);

    /// Where the shaft is now; empty where the board does not tell.
    static std::optional<double> degreesNow(const Device &device, const RegisterModel &registers);
    static QString angleText(double degrees); ///< with its sign

    /// Why it is not sent, as far as can be told here; the drive looks again when it is.
    QString refusal() const;
    QString outlook() const; ///< how fast it gets on the way; empty where that is not known
    drive::PositionRamp wish() const;

private:
    double boundRpm() const;

    const Device &m_device;
    double m_degrees, m_ms;
    std::optional<double> m_peakRpm;
};

} // namespace widgets
