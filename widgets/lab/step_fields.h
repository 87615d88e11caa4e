// StepFields: what is to be stepped, as it is typed: from which speed to which, how long each is held, the ramp to the
// first one and back, how often.
#pragma once

#include "lab/step_plan.h"

#include <QWidget>

#include <optional>

class QGridLayout;
class QSpinBox;

namespace widgets {

class NumberEdit;

class StepFields : public QWidget {
    Q_OBJECT
public:
    explicit StepFields(QWidget *parent = nullptr);

    /// Empty: a speed is not understood, or beyond the limit.
    std::optional<lab::StepPlan> plan() const;
    QString problem() const; ///< why, in a sentence
    /// Of the motor that is shown: its greatest speed, 0 if it is not known, and what a motor without a sensor has to
    /// stay above.
    void setLimits(double greatestRpm, double leastRpm);
    void focusFirst();

Q_SIGNALS:
    void changed();

private:
    NumberEdit *addSpeed(int column, const QString &text, const char *name);
    QSpinBox *addSpin(int row, int column, const QString &text, const char *name);

    QGridLayout *m_grid;
    NumberEdit *m_from, *m_to;
    QSpinBox *m_hold, *m_approach, *m_repeat;
    bool m_offered = true; ///< the speeds are not the user's
    bool m_offering = false;
};

} // namespace widgets
