// ResponsePage: how motor and loops follow each frequency, and gains from that: the measured loop, what other gains
// would make of it, three that are proposed, and the proof of those that were written. What is measured and written is
// LoopTuning's.
#pragma once

#include "widgets/base/form.h"
#include "widgets/lab/loop/bode_plot.h"
#include "widgets/lab/loop/rows.h"
#include "widgets/lab/loop/tuning.h"

class QComboBox;
class QPushButton;
class QSpinBox;
class QTreeView;

namespace widgets {

class ResponsePage : public Form {
    Q_OBJECT
public:
    /// All outlive it.
    struct Parts {
        LoopTuning &tuning;
        ExperimentBar::Parts lab;
    };
    explicit ResponsePage(const Parts &parts, QWidget *parent = nullptr);

    std::vector<catalog::RegisterId> watchedRegisters() const override;
    void refresh(Milliseconds now) override;
    QWidget *footer() const override { return m_bar; }
    double heightShare() const override { return 0.58; }
    void focusFirst() override;

protected:
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    enum Picture { SpeedLoop, Motor, CurrentLoop, CurrentClosed };

    QWidget *makeChoices();
    QWidget *labelled(const QString &text, QWidget *field);
    QSpinBox *makeSpin(const char *name, const QString &help);
    void makeTable();
    void makeBar();
    void connectParts();
    void adoptTuning();
    void propose();
    void chosen();
    void whatIf();
    void predict();
    void showRows();
    void showLast();
    void showCurves();
    void enableButtons();
    LoopTuning::Gains gains() const;
    void setGains(const LoopTuning::Gains &gains);
    std::chrono::milliseconds length() const;

    Parts m_parts;
    bool m_proposed = false; ///< the candidates are shown
    bool m_setting = false;
    const char *m_last = ""; ///< the row of what ended last, until the user scrolls
    int m_measurement = -1; ///< that the prediction is of
    LoopTuning::Gains m_predictedFor;
    std::optional<lab::SpeedResponse> m_predicted; ///< with the gains in the fields
    std::optional<lab::LoopForecast> m_forecast;
    QTimer m_soon; ///< what gains would do is computed once for many turns of a wheel

    QSpinBox *m_length = nullptr, *m_kp = nullptr, *m_ki = nullptr;
    QComboBox *m_picture = nullptr;
    QPushButton *m_propose = nullptr, *m_apply = nullptr, *m_back = nullptr;
    LoopRows m_rows;
    QTreeView *m_table;
    BodePlot *m_plot;
    ExperimentBar *m_bar;
};

} // namespace widgets
