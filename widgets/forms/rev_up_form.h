// RevUpForm: the drawing board for sensorless starts: the stages as a table and as a picture of the same model, what is
// wrong with them and what to change, start values, files, and the last measured start over the plan. It leaves pending
// edits; a start stays with the control panel.
#pragma once

#include "widgets/base/form.h"
#include "widgets/base/motor_description.h"
#include "widgets/forms/rev_up_model.h"
#include "widgets/registers/edits.h"

class QAction;
class QLabel;
class QListWidget;
class QPushButton;

namespace capture {
class Capture;
}

namespace widgets {

class EditBar;
class EntryEdit;
class FilePrompt;
class RevUpChart;
class RevUpStart;
class RevUpTable;

class RevUpForm : public Form {
    Q_OBJECT
public:
    /// What it works with; all of it outlives it.
    struct Parts {
        Device &device;
        RegisterModel &registers;
        RegisterEdits &edits;
        const capture::Capture &capture;
        FilePrompt &files;
        QAction *apply = nullptr, *revert = nullptr; ///< the window's
    };
    explicit RevUpForm(const Parts &parts, QWidget *parent = nullptr);

    RevUpModel &model() const { return *m_model; }
    RevUpChart &chart() const { return *m_chart; }
    RevUpStart &start() const { return *m_start; }

    std::vector<catalog::RegisterId> watchedRegisters() const override;
    ~RevUpForm() override;
    void refresh(Milliseconds now) override;
    QWidget *footer() const override { return m_footer; }
    void focusFirst() override;
    /// What is known of motors by now; what is typed here goes before it.
    void setInertias(const Inertias &inertias);

Q_SIGNALS:
    void inertiaRemembered(const QString &motor, double inertia_kgm2);

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *makeLeft();
    QWidget *makeMiddle();
    QWidget *makeFooter(const Parts &parts);
    QWidget *makeRight();
    QPushButton *makeButton(const QString &text, const char *name, const QString &toolTip);
    EntryEdit *makeNumber(const char *name, const QString &unit, double *value);
    void connectParts();
    void rememberInertia();
    void forgetAnothersNumbers();
    void adoptFacts();
    void fitHint();
    void showFacts();
    void showFindings();
    void showStart();
    void enableButtons();
    int currentStage() const;
    void goTo(int stage);
    void change(bool done, int stage);
    void openFile();
    void saveFile();
    void readFile(const QString &path);

    Device &m_device;
    RegisterModel &m_registers;
    FilePrompt &m_files;
    RevUpModel *m_model;
    RevUpStart *m_start;
    RevUpTable *m_table = nullptr;
    RevUpChart *m_chart = nullptr;
    QWidget *m_footer = nullptr;
    EditBar *m_bar = nullptr;
    QLabel *m_reason = nullptr, *m_hint = nullptr, *m_factsText = nullptr, *m_startText = nullptr;
    QListWidget *m_findings = nullptr;
    EntryEdit *m_inertia = nullptr, *m_friction = nullptr;
    QPushButton *m_add = nullptr, *m_remove = nullptr, *m_up = nullptr, *m_down = nullptr,
                *m_usual = nullptr, *m_open = nullptr, *m_save = nullptr;
    double m_inertiaTyped_gcm2 = 0.0, m_frictionTyped_mnm = 0.0; ///< 0: not typed
    double m_inertiaFound_kgm2 = 0.0; ///< by a profiler, or typed elsewhere
    Inertias m_inertias;
    QString m_motorName; ///< made fit to be shown
    QString m_typedName; ///< of the motor that inertia and friction are typed for; empty: not known
    int m_typedMotor = 1;
    std::vector<catalog::RegisterId> m_motorRegisters;
    QString m_folder;
};

} // namespace widgets
