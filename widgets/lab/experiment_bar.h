// ExperimentBar: what every page of the lab has below it: the buttons that move the motor, Cancel, how far it is, and
// how it ended. It asks what has to be asked, begins what was agreed to, and has it evaluated in a thread of its own.
// What a page knows is which experiments a button stands for, and what came of them.
#pragma once

#include "widgets/lab/experiments.h"
#include "widgets/lab/plan_question.h"

#include <QElapsedTimer>
#include <QPointer>
#include <QThreadPool>
#include <QTimer>
#include <QWidget>

#include <functional>

class QBoxLayout;
class QDialog;
class QProgressBar;

namespace widgets {

class FlowLayout;
class MotionGate;
class MotorButton;
class SteadyLabel;

class ExperimentBar : public QWidget {
    Q_OBJECT
public:
    /// All outlive it.
    struct Parts {
        Device &device;
        const MotionGate &motion; ///< tells where a start goes to
        Experiments &experiments;
    };
    /// Shows what was found, and returns what has to be known of it.
    using Show = std::function<QStringList()>;
    /// Of all that was recorded, also where it ended early; in any thread, so it holds values, and what only `Show`
    /// uses.
    using Evaluate = std::function<Show(const Experiments::Run &)>;
    /// What a button begins: one after the other, each from where the motor was before.
    struct Run {
        std::vector<lab::Experiment> experiments;
        Evaluate evaluate;
        lab::SpeedRegulator regulator = {}; ///< that it is measured by
        /// Asked about along with it, for runs that follow.
        std::vector<lab::Experiment> later = {};
    };
    /// Or why there is none now, in a sentence.
    using Wanted = std::function<Result<Run, QString>()>;
    /// How far it is, of how much, and that in words; no words: it is told by the time.
    struct Progress {
        int done = 0, all = 1;
        QString words;
    };
    using Look = std::function<Progress(const lab::Happenings &)>;
    struct Button {
        QString text;
        const char *name = "";
        QString help;
        Wanted wanted;
        QKeySequence keys = {};
        std::function<void()> prepare = {}; ///< what is to be done before, such as a write
        /// That has reached the board, which is waited for so long:
        std::function<bool()> settled = {};
        std::chrono::milliseconds patience{500};
    };

    /// @param prefix  of the names of what is in it: "step" makes "stepCancel", "stepProgress", "stepSentence"
    ExperimentBar(const Parts &parts, const char *prefix, QWidget *page);

    int add(Button button); ///< its number, from 0
    void addAside(QWidget *widget); ///< behind the others
    /// It stands for something else now.
    void rename(int which, const QString &text, const QString &help);
    QSize minimumSizeHint() const override;
    void setLook(Look look) { m_look = std::move(look); }
    /// Its page says why none can begin now: the sentence leaves that out.
    void leaveOutObstacle() { m_saysObstacle = false; }
    /// Whether polled values do for some of its runs.
    void setPollable(bool pollable) { m_pollable = pollable; }

    void run(int which); ///< as its button does
    /// The same without a press, for what was agreed to along with the run before; false: it does not begin, as behind
    /// one that has left something on the board, and it is told why.
    bool goOn(int which);
    QString told() const { return m_told; } ///< how the last one ended
    QString more() const { return m_more; } ///< and what has to be known of it
    bool swung() const { return m_swung; } ///< it never began: its speed did not come to rest
    bool busy() const { return m_own || m_evaluating; } ///< with an experiment of this page
    bool running() const { return m_own; } ///< one of this page moves the motor
    QString hint(int which) const; ///< why it cannot be run now; empty if it can
    MotorBefore before() const;
    void tell(const QString &sentence);

public Q_SLOTS:
    void refresh(); ///< what a button needs may be another

Q_SIGNALS:
    void began(int which);
    void ended(int which, bool complete); ///< and what came of it is shown

protected:
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    QString obstacle() const { return m_parts.experiments.obstacle(m_pollable); }
    void fold();
    bool fits(const QString &text, int width) const;
    QString sentence() const;
    void makeRow(const char *prefix);
    Result<Run, QString> wanted(int which) const;
    bool settled(int which) const;
    bool agreed(const std::vector<lab::Experiment> &all) const;
    void runNow(int which);
    void begin(int which, const Run &run);
    QString turning() const;
    void progressed();
    void accept(const Experiments::RunPtr &run);
    void shown(bool complete, const QStringList &more);
    QString hints() const;

    Parts m_parts;
    std::vector<Button> m_buttons;
    std::vector<MotorButton *> m_runs;
    Look m_look;
    bool m_saysObstacle = true, m_pollable = false;
    QPointer<QDialog> m_question;
    QTimer m_patience; ///< with what is being written before a run
    int m_which = -1; ///< that is waited for, is running or is being evaluated
    bool m_own = false, m_evaluating = false, m_swung = false;
    bool m_hadFocus = false;
    std::vector<lab::Experiment> m_experiments; ///< that are running
    Evaluate m_evaluate; ///< of them
    MotorBefore m_before;
    QElapsedTimer m_since; ///< the one that is running began
    std::size_t m_part = 0;
    QString m_told; ///< how the last one ended
    QString m_left; ///< what it has left on the board, as a sentence
    bool m_known = false; ///< a board is
    bool m_crowded = false; ///< beside the buttons there was no room for how one ended
    QString m_more; ///< what has to be known of it

    QBoxLayout *m_row = nullptr;
    FlowLayout *m_flow = nullptr; ///< of the buttons
    QWidget *m_place = nullptr; ///< of the progress
    MotorButton *m_cancel = nullptr;
    QProgressBar *m_progress = nullptr;
    SteadyLabel *m_sentence = nullptr;
    QThreadPool m_pool; ///< last: its job ends before anything that it tells
};

} // namespace widgets
