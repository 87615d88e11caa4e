// IdentifyPage: measures the motor itself: its windings and magnets, its inertia and friction, as a table with
// intervals beside what board and motor file say. What was measured is used in the motor description, as one step, when
// it is wanted.
#pragma once

#include "widgets/base/form.h"
#include "widgets/base/motor_description.h"
#include "widgets/lab/identification.h"
#include "widgets/lab/shown_motor.h"

class QCheckBox;
class QPushButton;
class QTreeView;

namespace widgets {

class IdentifyPage : public Form {
    Q_OBJECT
public:
    /// All outlive it.
    struct Parts {
        Device &device;
        RegisterModel &registers;
        MotorDescription &description;
        Identification &identification;
        ExperimentBar::Parts lab;
    };
    explicit IdentifyPage(const Parts &parts, QWidget *parent = nullptr);

    std::vector<catalog::RegisterId> watchedRegisters() const override;
    void refresh(Milliseconds now) override;
    QWidget *footer() const override { return m_bar; }
    double heightShare() const override { return 0.42; }
    void focusFirst() override;

private:
    MotorFindings &findings() { return m_parts.identification.findings(); }
    void makeTable();
    QWidget *tachometer();
    void makeBar();
    void boardChanged();
    void showKnown();
    void enableButtons();

    Parts m_parts;
    ShownMotor m_facts;
    QTreeView *m_table;
    ExperimentBar *m_bar;
    QCheckBox *m_bothWays = nullptr;
    QPushButton *m_use = nullptr, *m_back = nullptr;
};

} // namespace widgets
