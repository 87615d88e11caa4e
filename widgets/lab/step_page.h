// StepPage: steps of the speed, again and again: from, to, Run; every series a row and a curve. The gains of the speed loop
// stand beside and are written as they are turned, so that a changed gain and its new step are two actions.
//
// A series is asked about once; further ones within the same caps are not, until the drive is disarmed. What it lacks is
// told where it cannot be run.
#pragma once

#include "widgets/base/form.h"
#include "widgets/lab/experiments.h"
#include "widgets/lab/speed_gains.h"
#include "widgets/lab/step_question.h"
#include "widgets/registers/register_edits.h"

#include <QPointer>
#include <QTimer>

class QComboBox;
class QDialog;
class QProgressBar;
class QPushButton;
class QTreeView;

namespace widgets {

class MotionGate;
class MotorButton;
class SteadyLabel;
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
        const MotionGate &motion; ///< knows where a start goes to
        Experiments &experiments;
    };
    explicit StepPage(const Parts &parts, QWidget *parent = nullptr);

    std::vector<catalog::RegisterId> watchedRegisters() const override;
    void refresh(Milliseconds now) override;
    QWidget *footer() const override { return m_footer; }
    double heightShare() const override { return 0.56; }
    void focusFirst() override;

protected:
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *makeSide();
    void makeTable();
    QWidget *makeFooter();
    void connectParts();

    void boardChanged();
    QString hint() const;
    std::optional<lab::Experiment> experiment() const;
    MotorBefore before() const;
    void run();
    void runNow();
    void begin(const lab::Experiment &experiment);
    void progressed();
    void ended(const Experiments::Record &record);
    void addResult(const Experiments::Record &record);
    void tell(const QString &sentence);
    void updateAll();
    void showResults();
    void takeAsReference();
    void removeChosen();

    Parts m_parts;
    QPointer<QDialog> m_question;
    QTimer m_patience; ///< with a gain that is being written before a run
    bool m_own = false; ///< the experiment that runs is this page's
    bool m_runHadFocus = false;
    int m_steps = 0; ///< of the one that runs, up and down
    std::string m_bus; ///< name of its register
    SpeedGains::Values m_begunWith;
    QString m_told; ///< how the last one ended

    StepFields *m_fields;
    SpeedGains *m_gains;
    QComboBox *m_direction;
    StepOverlay *m_overlay;
    StepRuns *m_runs;
    QTreeView *m_table;
    QPushButton *m_reference = nullptr, *m_remove = nullptr;
    MotorButton *m_run = nullptr, *m_cancel = nullptr;
    QProgressBar *m_progress = nullptr;
    SteadyLabel *m_sentence = nullptr;
    QWidget *m_footer;
};

} // namespace widgets
