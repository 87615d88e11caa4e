// Step metrics as MATLAB's stepinfo defines them, so that the numbers agree, and what drives need besides: dead time,
// steady-state error, ripple, error integrals.
//
//   step size   final value - initial value; 0 % is the initial, 100 % the final value
//   rise, fall  from the last passing of 10 % to the first of 90 %
//   settling    from the step to the last entry into final +- 2 % of the step size
//   overshoot   largest value past the final one, % of the step size; 0 if there is none
//   undershoot  largest value on the wrong side of the initial one, % of the step size; 0 if there is none
//   dead time   from the step to the first passing of 5 %
// Times between samples are interpolated on a line. Source: the documentation of stepinfo (R2024).
#pragma once

#include "scope/measurement.h"
#include "scope/sample_range.h"

namespace scope {

struct StepSettings {
    std::optional<Nanos> at; ///< when the step was commanded; else where the range begins
    std::optional<double> initial; ///< else the mean before the step, or the first sample
    std::optional<double> final; ///< else the mean of the tail
    std::optional<double> setPoint; ///< what the value should become; errors need it
    /// Share of the time after the step at its end; the value must be settled before it.
    double tail = 0.2;
    double band = 0.02; ///< half the width of the settling band, share of the step size
};

/// Measures one step. The samples from the step to the end of the range are read a few times; nothing is copied.
class StepResponse {
public:
    StepResponse(const SampleRange &range, const StepSettings &settings);

    /// One of Rise, Fall, Overshoot, Undershoot, PeakTime, Settling, DeadTime, SteadyStateError, Ripple, RippleRms,
    /// AbsoluteError and TimedError.
    Measurement measure(Quantity quantity) const;

    /// Why nothing of it can be measured; nullopt if something can.
    std::optional<WhyNot> whyNot() const { return m_whyNot; }
    double initial() const { return m_initial; } ///< in the channel's unit
    double final() const { return m_final; }

private:
    void findValues(const SampleRange &range, const StepSettings &settings);
    void findSettling(const StepSettings &settings);
    double share(double value) const { return (value - m_initial) / (m_final - m_initial); }
    double valueAt(double share) const { return m_initial + share * (m_final - m_initial); }

    void transit(Measurement &result) const;
    void deadTime(Measurement &result) const;
    void excursion(Measurement &result) const;
    void settling(Measurement &result) const;
    void steadyStateError(Measurement &result) const;
    void ripple(Measurement &result) const;
    void errorIntegral(Measurement &result) const;
    double heldErrorIntegral(bool timed) const;
    double fastErrorIntegral(bool timed) const;

    SampleRange m_after; ///< from the step on
    StepSettings m_settings;
    std::optional<WhyNot> m_whyNot;
    double m_initial = 0.0;
    double m_final = 0.0;
    double m_tailStart = 0.0; ///< seconds since the step
    std::optional<double> m_settled; ///< seconds since the step; nothing if it is not
};

} // namespace scope
