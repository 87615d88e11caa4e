// MotorForm: what a board says of its motor and its drive, what follows from it and what is wrong with it; a motor file
// beside it; a converter between the ways people give a motor's figures. It asks for values once, and writes nothing to
// the board: these figures are built into the firmware.
#pragma once

#include "widgets/base/form.h"
#include "widgets/base/motor_description.h"
#include "widgets/forms/motor_model.h"
#include "widgets/registers/model.h"

class QLabel;
class QPushButton;
class QTreeView;

namespace widgets {

class FilePrompt;
class MotorConverter;
class SteadyLabel;

class MotorForm : public Form {
    Q_OBJECT
public:
    /// All outlive it.
    MotorForm(Device &device, RegisterModel &registers, MotorDescription &description,
        FilePrompt &files, QWidget *parent = nullptr);

    MotorModel &model() { return m_model; }
    void focusFirst() override;

public Q_SLOTS:
    void readAgain(); ///< asks the board
    void openFile();
    void saveFile();
    void closeFile();

Q_SIGNALS:
    /// In a file, of the motor it names.
    void inertiaFound(const QString &motor, double inertia_kgm2);

protected:
    void showEvent(QShowEvent *event) override;

private:
    QWidget *makeLeft();
    QWidget *makeRight();
    QPushButton *makeButton(const QString &text, const char *name, const QString &help);
    void boardChanged();
    void showBoard();
    void showDescription();
    void showWarnings();
    void accept(const QString &path);
    void say(const QString &sentence, bool bad = false);
    void copySelected();
    void expandGroups();
    void enableButtons();

    Device &m_device;
    RegisterModel &m_registers;
    MotorDescription &m_description;
    FilePrompt &m_files;
    MotorModel m_model;
    QTreeView *m_tree = nullptr;
    SteadyLabel *m_reason = nullptr;
    QLabel *m_told = nullptr, *m_warnings = nullptr;
    QPushButton *m_again = nullptr, *m_open = nullptr, *m_save = nullptr, *m_close = nullptr,
                *m_back = nullptr, *m_fromBoard = nullptr;
    MotorConverter *m_converter = nullptr;
    std::vector<catalog::RegisterId> m_ids; ///< what the board is asked for
    std::optional<drive::MotorFacts> m_facts; ///< once something has come
    drive::WishId m_reading = 0; ///< under way
    bool m_asked = false; ///< of this board and motor
    QString m_folder;
};

} // namespace widgets
