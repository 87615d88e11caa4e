// GainMotor: the numbers of motor and load that gains are computed from, taken from the board where it has them, typed
// by the user where it has not or is wrong. In the sizes people use (mH, mWb, g cm2); plant() is in SI units.
#pragma once

#include "drive/motor_view.h"
#include "motor/gain_plan.h"

#include <QWidget>

#include <vector>

class QGridLayout;

namespace widgets {

class GainNumber;

class GainMotor : public QWidget {
    Q_OBJECT
public:
    explicit GainMotor(QWidget *parent = nullptr);

    /// What the board says; fields that the user has typed into keep what was typed.
    void setFacts(const drive::MotorFacts &facts, std::optional<double> rememberedInertia_kgm2);
    const drive::MotorFacts &facts() const { return m_facts; }
    /// Back to the board's own numbers.
    void forgetTyped();

    /// 0 for what is missing or not understood.
    motor::GainPlant plant() const;
    /// What is wrong with a field, named; empty if nothing is.
    QString problem() const;

Q_SIGNALS:
    void edited(); ///< by the user
    void inertiaTyped(double inertia_kgm2);

private:
    GainNumber *addInput(QGridLayout *grid, int row, int column, const char *name,
        const QString &label, const QString &unit, double least, double greatest);
    bool isTyped(const GainNumber *field) const;
    void keepTyped(GainNumber *field);
    void typed(GainNumber *field);
    void fluxTyped(GainNumber *field);
    void fill();

    drive::MotorFacts m_facts;
    std::optional<double> m_remembered_kgm2;
    std::vector<GainNumber *> m_typed; ///< fields that the user has changed
    GainNumber *m_rs, *m_lq, *m_ld, *m_flux, *m_ke, *m_polePairs, *m_inertia;
};

} // namespace widgets
