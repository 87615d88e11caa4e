// TourPage: from an unknown motor to proved gains, station by station: the windings, the mechanics, the response of the
// speed, gains from it, and their proof. What moves by itself is asked about once, all of it; gains are written when
// they are wanted, and not before. What is found is where the other pages of the lab have it, too.
#pragma once

#include "widgets/base/form.h"
#include "widgets/lab/identification.h"
#include "widgets/lab/loop/tuning.h"
#include "widgets/lab/tour_steps.h"

class QComboBox;
class QPushButton;
class QSpinBox;
class QTreeView;

namespace widgets {

class TourPage : public Form {
    Q_OBJECT
public:
    /// All outlive it.
    struct Parts {
        Identification &identification;
        LoopTuning &tuning;
        ExperimentBar::Parts lab;
    };
    explicit TourPage(const Parts &parts, QWidget *parent = nullptr);

    std::vector<catalog::RegisterId> watchedRegisters() const override;
    void refresh(Milliseconds now) override;
    QWidget *footer() const override { return m_bar; }
    double heightShare() const override { return 0.42; }
    void focusFirst() override;

protected:
    void showEvent(QShowEvent *event) override;

private:
    using Step = TourSteps::Step;
    using State = TourSteps::State;

    QWidget *makeChoices();
    void makeBar();
    void forget(); ///< another board or motor
    void check();
    Result<ExperimentBar::Run, QString> runOf(Step step);
    Result<ExperimentBar::Run, QString> wholeTour();
    Result<ExperimentBar::Run, QString> proof();
    void began(int which);
    void ended(int which, bool complete);
    void waitAt(Step next); ///< by itself it does not go on
    void showStation(Step step);
    void showGains();
    /// The tour's was not conclusive, and none was measured since: one from before does not stand in for it.
    bool withoutResponse() const;
    static QString noGainsText();
    std::optional<LoopTuning::Gains> chosen() const;
    std::chrono::milliseconds length() const;
    lab::Goal goal() const;

    Parts m_parts;
    Step m_next = TourSteps::Windings; ///< what the tour runs next
    int m_measurements = 0; ///< of the tuning, when the tour's last station began
    TourSteps m_steps;
    QTreeView *m_table;
    QComboBox *m_goal = nullptr;
    QSpinBox *m_length = nullptr;
    QPushButton *m_back = nullptr;
    ExperimentBar *m_bar;
    int m_tour = 0, m_prove = 0; ///< buttons of it
};

} // namespace widgets
