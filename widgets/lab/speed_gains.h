// SpeedGains: the two gains of the speed loop, or of that of a current or a position, as fields that move the board's
// own, and what their digits come to.
#pragma once

#include "motor/gain_plan.h"
#include "widgets/lab/shown_motor.h"
#include "widgets/lab/step_result.h"
#include "widgets/registers/edits.h"

#include <QWidget>

class QGridLayout;
class QLabel;

namespace widgets {

class LiveGain;

class SpeedGains : public QWidget {
    Q_OBJECT
public:
    /// @param kind  whose loop it is
    SpeedGains(Device &device, RegisterModel &model, RegisterEdits &edits, StepKind kind,
        QWidget *parent = nullptr);

    std::vector<catalog::RegisterId> watchedRegisters() const;
    void setWanted(bool wanted); ///< else it is hidden
    bool refresh(); ///< true: other registers are to be watched from now on
    bool there() const; ///< the board has such gains
    bool known() const; ///< and has told them, and what they are worth
    bool settled() const; ///< none is on its way to the board
    /// Digits over divisors, as the board has them or is to have them.
    struct Values {
        std::optional<double> kp, ki;
        bool operator==(const Values &) const = default;
    };
    Values values() const;
    /// With its unit; as digits where that is not known.
    QString kpText(std::optional<double> value) const;
    QString kiText(std::optional<double> value) const;
    /// What the loop of the speed adds to the current's reference at once: A/rpm. 0: not known.
    double jumpPerRpm(const lab::Subject &subject) const;

Q_SIGNALS:
    void changed();

private:
    LiveGain *addGain(QGridLayout *grid, int row, const QString &text, const char *name);
    void adoptFacts();
    void updateTexts();
    QString textOf(std::optional<double> value, std::optional<motor::GainId> id) const;

    StepKind m_kind;
    std::optional<motor::GainId> m_kpId, m_kiId; ///< empty: only their digits are known
    bool m_wanted;
    RegisterModel &m_model;
    RegisterEdits &m_edits;
    ShownMotor m_facts;
    LiveGain *m_kp, *m_ki;
    QLabel *m_kpText, *m_kiText;
};

} // namespace widgets
