// GainPlanTable: the gains of a plan beside those of the board: numbers, what they make at the motor, what rounding
// costs, how much room is left.
#pragma once

#include "motor/gain_plan.h"

#include <QTableWidget>

#include <cmath>
#include <optional>

namespace widgets {

/// What the board has of one gain.
struct HeldGain {
    std::optional<std::int64_t> numerator;
    std::optional<int> exponent;

    bool known() const { return numerator && exponent; }
    /// Digits for digits; 0 if it is not known.
    double value() const
    {
        return known() ? std::ldexp(static_cast<double>(*numerator), -*exponent) : 0.0;
    }
    bool operator==(const HeldGain &) const = default;
};

class GainPlanTable : public QTableWidget {
    Q_OBJECT
public:
    explicit GainPlanTable(QWidget *parent = nullptr);

    void showPlan(const motor::GainPlan &plan, const motor::PerGain<HeldGain> &board);

private:
    void fixColumns();
};

} // namespace widgets
