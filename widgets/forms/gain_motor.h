// GainMotor: the numbers of motor and load that gains are computed from: those that were measured, else the board's;
// typed by the user where they lack or are wrong. In the sizes people use (mH, mWb, g cm2); plant() is in SI units.
#pragma once

#include "drive/motor_view.h"
#include "lab/maths/statistics.h"
#include "motor/gain_plan.h"

#include <QWidget>

#include <vector>

class QGridLayout;

namespace widgets {

class NumberEdit;

/// What experiments have found of a motor.
struct MeasuredMotor {
    std::optional<lab::Estimate> rs_ohm, lq_h, ld_h, flux_wb, inertia_kgm2;
    bool operator==(const MeasuredMotor &) const = default;
};

class GainMotor : public QWidget {
    Q_OBJECT
public:
    explicit GainMotor(QWidget *parent = nullptr);

    /// What the board says; fields that the user has typed into keep what was typed.
    void setFacts(const drive::MotorFacts &facts, std::optional<double> rememberedInertia_kgm2);
    const drive::MotorFacts &facts() const { return m_facts; }
    /// Goes before what the board says, not before what the user has typed, now or an inertia of this name before.
    void setMeasured(const MeasuredMotor &measured);
    /// Back to the board's own numbers, before what was measured, too.
    void forgetTyped();

    /// 0 for what is missing or not understood.
    motor::GainPlant plant() const;
    /// Which fields show what was measured, with its intervals; empty: none.
    QString measuredText() const;
    /// What is wrong with a field, named; empty if nothing is.
    QString problem() const;

Q_SIGNALS:
    void edited(); ///< by the user
    void inertiaTyped(double inertia_kgm2);

private:
    NumberEdit *addInput(QGridLayout *grid, int row, int column, const char *name,
        const QString &label, const QString &unit, double least, double greatest);
    bool isTyped(const NumberEdit *field) const;
    void keepTyped(NumberEdit *field);
    void typed(NumberEdit *field);
    void fluxTyped(NumberEdit *field);
    void fill();
    /// What is shown of an inertia that was measured.
    std::optional<lab::Estimate> measuredInertia() const;

    drive::MotorFacts m_facts;
    MeasuredMotor m_measured;
    std::optional<double> m_remembered_kgm2;
    std::vector<NumberEdit *> m_typed; ///< fields that the user has changed
    NumberEdit *m_rs, *m_lq, *m_ld, *m_flux, *m_ke, *m_polePairs, *m_inertia;
};

} // namespace widgets
