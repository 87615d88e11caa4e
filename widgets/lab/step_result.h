// A series of steps as its row and its curves show it. The numbers are those of core/lab, from the run alone; a curve
// is the speed, or the current, by which they were measured.
#pragma once

#include "lab/evaluation/step_series.h"
#include "widgets/lab/experiments.h"

#include <QString>
#include <QVector>

#include <cstdint>
#include <optional>
#include <utility>

namespace widgets {

/// What is stepped: the speed, Iq, Id, or where the shaft is.
enum class StepKind : std::uint8_t { Speed, Torque, Flux, Position };
constexpr std::size_t kStepKinds = 4;

/// One step: the speed, the current or the position over the time since its instant, as far as it was recorded. Empty:
/// no stretch of it is long enough to tell it.
struct StepCurve {
    bool up = true;
    QVector<double> seconds, values; ///< rpm, A of a current, or degrees
    QVector<qsizetype> gaps; ///< samples are missing before these points
};

struct StepResult {
    int number = 0; ///< of the series in its table, from 1
    QString kp, ki; ///< with which it was made, with units
    lab::StepSeries series; ///< its plan is that of a speed
    /// Empty: the speed was stepped.
    std::optional<lab::CurrentStepPlan> current;
    std::optional<lab::PositionPlan> position;
    QVector<StepCurve> curves;
    std::optional<std::pair<double, double>> bus_v; ///< least and greatest; empty: not known

    bool told() const; ///< at least one of its numbers is known
    StepKind kind() const;
};

/// @param bus  name of the register that tells the bus voltage; empty: there is none
/// @return  why there is none, in a sentence without a full stop
Result<StepResult, std::string> stepResult(const Experiments::Run &run, const std::string &bus);

} // namespace widgets
