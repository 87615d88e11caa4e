// StepFields: what is to be stepped, as it is typed: a speed, a torque, the current along the magnets or a position of
// the shaft; from which to which, how long each is held, how often; of a speed the ramp to the first one and back, of a
// current the speed at which the motor turns, of a position how far it is moved and in which time. Each kind keeps what
// was typed for it.
#pragma once

#include "widgets/lab/step_result.h"

#include <QWidget>

#include <array>
#include <optional>

class QComboBox;
class QGridLayout;
class QLabel;
class QSpinBox;

namespace widgets {

class NumberEdit;

class StepFields : public QWidget {
    Q_OBJECT
public:
    explicit StepFields(QWidget *parent = nullptr);

    StepKind kind() const { return m_kind; }
    /// Empty: a number is not understood, or beyond the limit.
    std::optional<lab::Plan> plan(const drive::UserLimits &caps) const;
    QString problem() const; ///< why, in a sentence
    /// Of the motor that is shown; 0: not known.
    struct Limits {
        double greatestRpm = 0.0, greatestAmps = 0.0;
        double leastRpm = 0.0; ///< that a motor without a sensor has to stay above
        int turningRpm = 0; ///< offered for steps of a current
    };
    void setLimits(const Limits &limits);
    /// @param why  the board cannot step it, a sentence; empty: it can
    void grey(StepKind kind, const QString &why);
    void focusFirst();

Q_SIGNALS:
    void changed();
    void kindChanged(); ///< behind changed()

private:
    /// A field whose unit may be another one.
    struct Number {
        NumberEdit *edit = nullptr;
        QLabel *label = nullptr, *unit = nullptr;
    };
    /// What was typed for a kind that is not shown.
    struct Typed {
        QString from, to;
        int hold_ms = 0, approach_ms = 0; ///< 0: as offered
        bool offered = true;
    };
    Number addNumber(int row, int column, const QString &text, const char *name, bool &offered);
    void changeKind();
    void showKind();
    void offerSpeeds();
    void offerCurrents();
    bool ofSpeed() const { return m_kind == StepKind::Speed; }
    bool ofPosition() const { return m_kind == StepKind::Position; }
    bool ofCurrent() const { return !ofSpeed() && !ofPosition(); }
    std::vector<Number> numbers() const; ///< that count for the kind
    void show(const Number &number, bool shown);
    QSpinBox *addSpin(int row, int column, const QString &text, const char *name);

    QGridLayout *m_grid;
    QComboBox *m_which;
    Number m_from, m_to, m_turning;
    QLabel *m_rampLabel;
    QSpinBox *m_hold, *m_approach, *m_repeat;
    StepKind m_kind = StepKind::Speed;
    Limits m_limits;
    std::array<Typed, kStepKinds> m_typed;
    bool m_offered = true, m_turningOffered = true; ///< the numbers are not the user's
    bool m_offering = false;
};

} // namespace widgets
