// StepPage: steps of the speed, the torque, the flux or the position, again and again: from, to, Run; every series a
// row and a curve. The gains of the loop that is stepped stand beside and are written as they are turned, so that a
// changed gain and its new step are two actions.
//
// A series is asked about once; further ones within the same caps are not, until the drive is disarmed. What it lacks
// is told where it cannot be run.
#pragma once

#include "widgets/base/form.h"
#include "widgets/lab/experiment_bar.h"
#include "widgets/lab/speed_gains.h"
#include "widgets/registers/edits.h"

#include <array>

class QComboBox;
class QPushButton;
class QTreeView;

namespace widgets {

class StepFields;
class StepOverlay;
class StepRuns;

class StepPage : public Form {
    Q_OBJECT
public:
    /// All outlive it.
    struct Parts {
        Device &device;
        RegisterModel &registers;
        RegisterEdits &edits;
        ExperimentBar::Parts lab;
    };
    explicit StepPage(const Parts &parts, QWidget *parent = nullptr);

    std::vector<catalog::RegisterId> watchedRegisters() const override;
    void refresh(Milliseconds now) override;
    QWidget *footer() const override { return m_bar; }
    double heightShare() const override { return 0.56; }
    void focusFirst() override;

protected:
    void changeEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *makeSide();
    void makeTable();
    void makeBar();
    void connectParts();

    void boardChanged();
    Result<ExperimentBar::Run, QString> wanted();
    Result<ExperimentBar::Run, QString> loadWanted();
    ExperimentBar::Evaluate evaluation(const lab::Subject &subject);
    QStringList addResult(StepResult result, const SpeedGains &gains,
        const SpeedGains::Values &begunWith, bool complete);
    void kindChanged();
    SpeedGains &gains() const; ///< of the loop that is stepped
    void enableButtons();
    void showResults();
    void takeAsReference();
    void removeChosen();

    Parts m_parts;

    StepFields *m_fields;
    std::array<SpeedGains *, kStepKinds> m_gains{};
    QComboBox *m_direction;
    StepOverlay *m_overlay;
    StepRuns *m_runs;
    QTreeView *m_table;
    QPushButton *m_reference = nullptr, *m_remove = nullptr;
    ExperimentBar *m_bar;
};

} // namespace widgets
