// GainsForm: the gains of every regulator of the board, and the lab that computes those of the three main loops. What
// the lab proposes becomes pending edits on "Preview", numerator and divisor together; Apply writes them as one step.
#pragma once

#include "drive/motor_view.h"
#include "widgets/base/form.h"
#include "widgets/base/motor_description.h"
#include "widgets/forms/gain_motor.h"
#include "widgets/registers/edits.h"

class QAction;
class QLabel;
class QTabWidget;

namespace widgets {

class EditBar;
class GainLab;
class GainTable;

class GainsForm : public Form {
    Q_OBJECT
public:
    /// All outlive the form. @param apply, revert  the window's actions
    GainsForm(Device &device, RegisterModel &model, RegisterEdits &edits, QAction *apply,
        QAction *revert, const Inertias &inertias, QWidget *parent = nullptr);

    std::vector<catalog::RegisterId> watchedRegisters() const override;
    void refresh(Milliseconds now) override;
    QWidget *footer() const override { return m_footer; }
    void focusFirst() override;
    /// As high as the page that is seen needs, not as the higher of the two.
    QSize sizeHint() const override;
    /// What is known of motors by now; what is typed here stays.
    void setInertias(const Inertias &inertias);
    /// Of the motor that is shown, by now; told again, it changes nothing. What is typed here stays.
    void setMeasured(const MeasuredMotor &measured);

Q_SIGNALS:
    void inertiaRemembered(const QString &motor, double inertia_kgm2);

private:
    void adoptFacts();
    void boardChanged();
    void showBoard(const drive::MotorFacts &facts);
    std::vector<drive::RegisterWrite> planned() const;
    void preview();
    void followPlan();
    void followPreview();
    void tellOfOthers();
    void dropPreview(const std::vector<drive::RegisterWrite> &edits);
    void editsChanged();

    Device &m_device;
    RegisterModel &m_model;
    RegisterEdits &m_edits;
    Inertias m_inertias;
    MeasuredMotor m_measured;
    QString m_motorName; ///< made fit to be shown
    std::vector<catalog::RegisterId> m_factRegisters; ///< not read yet
    /// What the last preview planned, while some of it waits.
    std::vector<drive::RegisterWrite> m_previewed;
    bool m_toldOfOthers = false; ///< the lab says that other numbers wait than are planned
    QTabWidget *m_pages;
    QLabel *m_board;
    GainTable *m_table;
    GainLab *m_lab;
    EditBar *m_editBar;
    QWidget *m_footer;
};

} // namespace widgets
