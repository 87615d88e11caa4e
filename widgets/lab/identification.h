// Identification: which experiments measure the motor itself, and what they found. It moves nothing.
#pragma once

#include "widgets/lab/experiment_bar.h"
#include "widgets/lab/motor_findings.h"

#include <QObject>

namespace widgets {

class Identification : public QObject {
    Q_OBJECT
public:
    /// Both outlive it.
    Identification(const Device &device, const Experiments &experiments, QObject *parent = nullptr);

    Result<ExperimentBar::Run, QString> electricalRun(); ///< windings and magnets
    /// Inertia and friction. @param bothWays  backwards, too, each from rest
    Result<ExperimentBar::Run, QString> mechanicalRun(bool bothWays = false);
    Result<ExperimentBar::Run, QString> powerRun(); ///< at the speed that the motor has, if it runs
    /// Pole pairs of a motor that runs. @return  why they do not follow; empty: they are in findings()
    QString countPolePairs(double tachometer_rpm);
    MotorFindings &findings() { return m_findings; }

private:
    /// @param motor  that is measured: what is found of it is of no other one
    template <class Found>
    ExperimentBar::Evaluate evaluation(int motor,
        Result<Found, std::string> (*evaluate)(const capture::Capture &, const lab::Happenings &));

    const Device &m_device;
    const Experiments &m_experiments;
    MotorFindings m_findings;
    int m_boards = 0; ///< how many have come and gone
};

} // namespace widgets
