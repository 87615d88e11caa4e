// The spectrum of a trace as a tool: window, length, averaging, a peak table, and orders of the electrical frequency.
// Computed in a thread of its own from a copy of the samples, a few times a second while it can be seen.
#pragma once

#include "widgets/base/form.h"
#include "widgets/measuring/job_rest.h"
#include "widgets/measuring/ready_formulas.h"
#include "widgets/measuring/spectrum_job.h"

#include <QThreadPool>

#include <optional>

class QComboBox;
class QFormLayout;
class QSpinBox;
class QTreeView;

namespace widgets {

class ScopeView;
class SpectrumPeaks;
class SpectrumPlot;
class SteadyLabel;

class SpectrumPanel : public Form {
    Q_OBJECT
public:
    /// All outlive it.
    SpectrumPanel(ScopeView &scope, const capture::Capture &capture, const Device &device,
        ChosenMotor motor, QWidget *parent = nullptr);

    void refresh(Milliseconds now) override;
    double heightShare() const override { return 0.36; } // the traces are what is looked at
    void choose(capture::ChannelId channel); ///< of the traces that are shown
    void focusFirst() override;

    bool busy() const { return m_rest.busy(); } ///< a spectrum is being computed
    /// What is shown is what is chosen, or what is averaged waits for samples that it has not seen.
    bool settled() const
    {
        const SpectrumWanted next = wanted();
        return !m_rest.busy() && (m_answered == next || waits(next));
    }

Q_SIGNALS:
    void shown(); ///< a spectrum, or why there is none

private:
    QWidget *makeSide();
    QFormLayout *makeChoices();
    void fillTraces();
    void fillAxes();
    void compute();
    SpectrumWanted wanted() const;
    bool overlaps(const SpectrumWanted &stretch) const;
    bool continues(const SpectrumWanted &stretch) const;
    bool waits(const SpectrumWanted &next) const;
    void accept(const SpectrumAnswer &answer, int begun);
    bool beginsAnew(const SpectrumWanted &stretch) const;
    void showMean();
    void showNote(const scope::Spectrum &spectrum);
    QString whyNot(scope::NoSpectrum why) const;
    scope::OrderAxis orders(double largestHz) const;
    int polePairsOf(catalog::RegisterId speed) const;

    ScopeView &m_scope;
    const capture::Capture &m_capture;
    const Device &m_device;
    ChosenMotor m_motor;
    SpectrumPeaks *m_peaks;
    SpectrumPlot *m_plot;
    QTreeView *m_list;
    QComboBox *m_trace;
    QComboBox *m_range;
    QComboBox *m_window;
    QComboBox *m_size;
    QComboBox *m_axis;
    QComboBox *m_scale;
    QSpinBox *m_average;
    SteadyLabel *m_note;
    SpectrumAnswer m_answer; ///< the newest
    std::optional<SpectrumWanted> m_answered; ///< it is of this
    std::vector<SpectrumWanted> m_averaged; ///< all of its mean: samples count once
    int m_begun = 0; ///< how often averaging began anew; an answer of before is none
    JobRest m_rest;
    QThreadPool m_pool; // last: its job ends before anything that it tells
};

} // namespace widgets
