// One signal over another as a tool: the circle of alpha and beta with what the bus allows, the vector of d and q, or
// any two traces. Follows the picture of the scope; computed in a thread of its own from a copy of the samples.
#pragma once

#include "widgets/base/form.h"
#include "widgets/measuring/job_rest.h"
#include "widgets/measuring/ready_formulas.h"
#include "widgets/measuring/xy_job.h"
#include "widgets/measuring/xy_plot.h"

#include <QThreadPool>

#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;

namespace widgets {

class RegisterModel;
class ScopeView;

class XyPanel : public Form {
    Q_OBJECT
public:
    /// What is drawn over what.
    enum class Kind : std::uint8_t {
        CurrentAlphaBeta,
        CurrentDq,
        VoltageAlphaBeta,
        VoltageDq,
        Any
    };

    /// All outlive it.
    XyPanel(ScopeView &scope, const capture::Capture &capture, const RegisterModel &registers,
        ChosenMotor motor, QWidget *parent = nullptr);

    /// The bus, where it is drawn.
    std::vector<catalog::RegisterId> watchedRegisters() const override;
    void refresh(Milliseconds now) override;
    double heightShare() const override { return 0.36; } // the traces are what is looked at
    /// Two traces over each other, this one upward.
    void choose(capture::ChannelId channel);
    void focusFirst() override;

    /// What is shown is what is chosen.
    bool settled() const { return !m_rest.busy() && m_answered == wanted(); }

private:
    /// The channels of a kind, if they are recorded.
    struct Pair {
        capture::ChannelId x = 0;
        capture::ChannelId y = 0;
        bool clarke = false;
    };
    QFormLayout *makeChoices();
    void fillTraces();
    Kind kind() const;
    std::optional<capture::ChannelId> recorded(
        std::string_view signal, const std::string &ending) const;
    std::optional<Pair> pair() const;
    std::optional<Pair> vectorOf(const std::string &ending) const;
    std::string motorShown() const;
    bool isVoltage() const;
    XyWanted wanted() const;
    void kindChosen();
    void compute();
    void accept(const XyAnswer &answer);
    void showAnswer();
    void showNote(const XyPlot::Picture &picture);
    QString missingText() const;
    std::optional<double> busVolts() const;
    QString labelOf(capture::ChannelId channel, const QString &instead) const;

    ScopeView &m_scope;
    const capture::Capture &m_capture;
    const RegisterModel &m_registers;
    ChosenMotor m_motor;
    XyPlot *m_plot;
    QComboBox *m_kind;
    QComboBox *m_x;
    QComboBox *m_y;
    QComboBox *m_range;
    QComboBox *m_trail;
    QCheckBox *m_equal;
    QLabel *m_note;
    QFormLayout *m_form = nullptr;
    std::optional<XyWanted> m_answered;
    XyAnswer m_answer;
    JobRest m_rest{50}; ///< ms between two pictures
    QThreadPool m_pool; // last: its job ends before anything that it tells
};

} // namespace widgets
