// RampForm: ramps of speed and torque and current references, with a picture of what is to come, their progress, and
// names for those that are wanted again. Motion goes through the MotionGate; nothing here sends without the user's act.
#pragma once

#include "widgets/base/form.h"
#include "widgets/forms/ramp_line.h"
#include "widgets/forms/ramp_progress.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace widgets {

class MotionGate;

class RampForm : public Form {
    Q_OBJECT
public:
    /// All three outlive it.
    RampForm(
        Device &device, RegisterModel &registers, MotionGate &motion, QWidget *parent = nullptr);

    const RampProgress &progress() const { return m_progress; }
    QList<RampPreset> presets() const { return m_presets; }
    void setPresets(const QList<RampPreset> &presets);

    std::vector<catalog::RegisterId> watchedRegisters() const override;
    void refresh(Milliseconds now) override;
    QWidget *footer() const override { return m_footer; }
    void focusFirst() override;

public Q_SLOTS:
    void stopRamp();

private:
    QWidget *makeLines();
    QWidget *makePresets();
    QWidget *makeProgress();
    void send(RampLine &one);
    void look(RampLine &one);
    void updateAll();
    void updatePreview();
    void updateProgress();
    void drawRunning();
    void wished(const drive::Wish &wish);
    void ended(const drive::Ended &ended);
    RampProgress::Sight sight() const;
    std::optional<double> shown(const char *name) const;
    QString progressText() const;
    QString valueText(double value) const;
    void savePreset();
    void deletePreset();
    void choosePreset(int index);
    void fillPresets(const QString &current);
    QList<RampPreset>::iterator presetOf(const QString &name);
    RampLine &line(RampKind kind) const { return *m_lines[static_cast<std::size_t>(kind)]; }

    Device &m_device;
    RegisterModel &m_registers;
    MotionGate &m_motion;
    std::vector<RampLine *> m_lines; ///< in the order of RampKind
    RampLine *m_looked = nullptr; ///< the one that the picture shows
    RampPreview *m_preview = nullptr;
    QComboBox *m_preset = nullptr;
    QPushButton *m_save = nullptr, *m_delete = nullptr;
    QWidget *m_footer = nullptr;
    QProgressBar *m_bar = nullptr;
    QLabel *m_text = nullptr;
    MotorButton *m_stop = nullptr;

    RampProgress m_progress;
    RampKind m_running = RampKind::Speed; ///< what m_progress is about
    RampPicture m_runningPicture;
    std::vector<RampPicture::Point> m_measured;
    bool m_showRun = false; ///< the picture stays the last ramp's until something is typed
    std::optional<drive::Wish> m_sent; ///< not ended
    Milliseconds m_now{};
    QList<RampPreset> m_presets;
};

} // namespace widgets
