// LoopTuning: the speed loop from its measured response to proved gains: what was measured, what is proposed, what
// other gains would do, what was written and whether it keeps what was promised. It asks and moves nothing: it says
// which experiments to run, and takes what came of them. Gains are written through RegisterEdits, as one step.
#pragma once

#include "lab/evaluation/current_response_evaluation.h"
#include "lab/evaluation/step_series.h"
#include "widgets/lab/experiment_bar.h"
#include "widgets/lab/shown_motor.h"
#include "widgets/registers/edits.h"

#include <QObject>

#include <optional>

namespace widgets {

class LoopTuning : public QObject {
    Q_OBJECT
public:
    struct Gains {
        int kp = 0, ki = 0; ///< digits
        bool operator==(const Gains &) const = default;
    };
    struct Measured {
        lab::SpeedResponse response;
        /// With which it was measured; its digits are 0 where the board tells no gains.
        lab::SpeedLoop loop;
        std::vector<lab::GainCandidate> candidates;
        std::string whyNone; ///< there are none
        lab::Forecaster forecaster; ///< empty: for the same reason
        bool gainsKnown() const { return loop.digits.proportional != 0.0; }
    };
    struct Proof {
        lab::SpeedResponse response;
        lab::StepSeries steps;
        Gains gains;
        lab::Promise promised;
        lab::Kept kept = lab::Kept::Unclear; ///< what was promised
    };

    /// All outlive it.
    LoopTuning(Device &device, RegisterModel &registers, RegisterEdits &edits,
        const Experiments &experiments, QObject *parent = nullptr);

    std::vector<catalog::RegisterId> watchedRegisters() const;
    void refresh();

    /// What is to be run; behind one that did not begin because the speed swings, with a quarter of its gains.
    /// @param length  of a response
    Result<ExperimentBar::Run, QString> speedRun(std::chrono::milliseconds length);
    Result<ExperimentBar::Run, QString> currentRun(std::chrono::milliseconds length);
    /// Of gains that the board holds by then.
    Result<ExperimentBar::Run, QString> proofRun(
        std::chrono::milliseconds length, const Gains &gains);

    const std::optional<Measured> &measured() const { return m_measured; }
    const std::optional<lab::FrequencyResponse> &current() const { return m_current; }
    const std::optional<Proof> &proof() const { return m_proof; }
    std::optional<Gains> present() const; ///< as the board holds them
    std::optional<Gains> applied() const { return m_applied; } ///< last, and well
    bool holdsApplied() const { return !m_writing && m_applied && m_applied == present(); }
    std::optional<lab::GainCandidate> candidate(lab::Goal goal) const;

    /// What the loop would be with other gains; nothing where it was not measured.
    std::optional<lab::SpeedResponse> predicted(const Gains &gains) const;
    std::optional<lab::LoopForecast> forecast(const Gains &gains) const;
    /// How often something was measured or forgotten.
    int measurements() const { return m_measurements; }

    QString applyHint(const Gains &gains) const; ///< why they cannot be written; empty if they can
    void apply(const Gains &gains);
    QString backHint() const;
    void back(); ///< to the gains before the first apply()
    QString verdict() const; ///< of the proof, in words; empty: there is none

Q_SIGNALS:
    void changed();
    void watchedRegistersChanged();
    void written(bool good, const QString &sentence); ///< a write of this has ended

private:
    struct Promised {
        Gains gains;
        lab::Promise promise;
    };
    void boardChanged();
    void write(const Gains &gains, const QString &text);
    void hold(const Promised &written);
    QStringList adopt(const Measured &measured, const std::optional<lab::StepSeries> &steps,
        const std::optional<Gains> &toProve);
    ExperimentBar::Run responseRun(
        const lab::Subject &subject, const lab::ResponsePlan &plan, std::optional<Gains> toProve);
    QStringList calm(const lab::ResponsePlan &plan, const lab::SpeedLoop &loop);
    lab::Promise promised(const Gains &gains) const;

    Device &m_device;
    RegisterEdits &m_edits;
    const Experiments &m_experiments;
    ShownMotor m_facts;
    std::optional<Measured> m_measured;
    std::optional<lab::FrequencyResponse> m_current;
    std::optional<Proof> m_proof;
    std::optional<Gains> m_old, m_applied;
    std::optional<Promised> m_writing;
    struct Swinging {
        Gains with, calmed;
    };
    std::optional<Swinging> m_swinging; ///< with those gains no response can be measured
    int m_measurements = 0;
    int m_boards = 0; ///< how many have come and gone
    lab::Promise m_promised; ///< of what was applied
};

} // namespace widgets
