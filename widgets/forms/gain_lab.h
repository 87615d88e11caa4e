// GainLab: from the motor, a bandwidth of the current loops and a damping of the speed loop to gains: what they will
// be, what rounding costs, what the loops will do with them. Only computes and shows; a preview is asked for by a
// signal.
#pragma once

#include "drive/motor_view.h"
#include "widgets/forms/gain_plan_table.h"
#include "widgets/registers/model.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QPushButton;
class QSlider;

namespace widgets {

class GainForecast;
class GainLabel;
class GainMotor;
class NumberEdit;
struct MeasuredMotor;

class GainLab : public QWidget {
    Q_OBJECT
public:
    explicit GainLab(RegisterModel &model, QWidget *parent = nullptr);

    /// What the board says; fields that the user has typed into keep what was typed.
    void setFacts(const drive::MotorFacts &facts, std::optional<double> rememberedInertia_kgm2);
    /// What experiments found goes before what the board says.
    void setMeasured(const MeasuredMotor &measured);
    /// Back to the board's own numbers, as after another board or motor came.
    void forgetTyped();
    /// The board may hold other gains now.
    void refreshPresent();

    const motor::GainPlan &plan() const { return m_plan; }
    bool previewPossible() const { return obstacle().isEmpty(); }
    std::vector<catalog::RegisterId> registers() const;
    void focusFirst();
    /// Of its wishes; the caller places them, outside of what scrolls.
    QWidget *buttons() const { return m_buttons; }
    void tell(const QString &sentence); ///< what came of a preview; goes with the next change

Q_SIGNALS:
    void previewWished();
    void planChanged(); ///< other gains than before
    void inertiaTyped(double inertia_kgm2);

private:
    QWidget *makeWishes();
    QWidget *makeEnd();
    void connectWishes();
    void fillBandwidth(double radps, const QWidget *except);
    void fillDamping(double damping, const QWidget *except);
    void useBoardsBandwidth();
    void wished();
    double sliderEnd() const;
    void fillDelay();
    motor::GainPlant plant() const;
    void recompute();
    void showFindings();
    QString obstacle() const; ///< why no preview is possible; empty if it is

    RegisterModel &m_model;
    motor::PerGain<HeldGain> m_held;
    motor::GainPlan m_plan;
    bool m_wished = false; ///< bandwidth or damping are the user's
    bool m_delayTyped = false;
    GainMotor *m_motor;
    GainPlanTable *m_table = nullptr;
    GainForecast *m_forecast;
    NumberEdit *m_bandwidth = nullptr, *m_hertz = nullptr, *m_damping = nullptr, *m_delay = nullptr;
    QSlider *m_bandwidthSlider = nullptr, *m_dampingSlider = nullptr;
    QCheckBox *m_speed = nullptr;
    GainLabel *m_findings = nullptr, *m_told = nullptr;
    QWidget *m_buttons = nullptr;
    QPushButton *m_fromBoard = nullptr, *m_preview = nullptr;
};

} // namespace widgets
