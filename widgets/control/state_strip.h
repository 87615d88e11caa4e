// StateStrip: what a motor goes through, as cells of which one is lit. The names are the firmware's and come from the
// drive. What is lit is told by shape and words, too: a filled cell with a mark and bold letters.
#pragma once

#include "drive/event.h"

#include <QWidget>

namespace widgets {

class StateStrip : public QWidget {
    Q_OBJECT
public:
    explicit StateStrip(QWidget *parent = nullptr);

    bool hasSteps() const { return !m_steps.empty(); }
    /// It has the same height whatever they are.
    void setSteps(std::vector<drive::StateStep> steps);
    /// @param believed  false: nothing is lit, because it is not known
    void show(const drive::MotorStatus &status, bool believed);
    /// The name that is lit; empty if none is.
    QString litName() const { return m_lit; }
    QString textIn(std::size_t step) const; ///< of its cell, cut to its width

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;
    bool event(QEvent *event) override; ///< tool tips with all names of a cell

private:
    int columns() const;
    QRect cellRect(std::size_t step) const;
    QString cellText(std::size_t step) const;
    void describe();

    std::vector<drive::StateStep> m_steps;
    int m_current = -1; ///< step; -1: none
    QString m_lit;
};

/// What a state is painted in; the text's own colour where nothing moves and nothing is wrong.
QColor stateColor(drive::MotorState state, const QPalette &palette);

} // namespace widgets
