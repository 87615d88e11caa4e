// The math channels as a tool: those that there are, and one formula at a time to be written, checked while it is
// typed.
#pragma once

#include "widgets/base/form.h"
#include "widgets/measuring/ready_formulas.h"

class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QTreeView;

namespace capture {
class Capture;
}

#include <functional>

namespace widgets {

class MathChannels;
class MathTable;
class ScopeView;

class MathPanel : public Form {
    Q_OBJECT
public:
    /// All outlive it.
    MathPanel(MathChannels &channels, ScopeView &scope, const capture::Capture &capture,
        ChosenMotor motor, QWidget *parent = nullptr);

    void choose(const QString &name); ///< that channel, to be changed

    /// @param can  whether the board has a signal of this name that is not on the scope: it is offered then
    void offerSignals(std::function<bool(const QString &name)> can);

    void refresh(Milliseconds now) override;
    double heightShare() const override { return 0.3; } // the traces are what is looked at
    void focusFirst() override;

Q_SIGNALS:
    void signalWanted(const QString &name); ///< on the scope, for a formula

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeList();
    QWidget *makeEditor();
    void fillReady(QMenu &menu);
    void fillInsert(QMenu &menu);
    void insert(const QString &text);
    void beginNew();
    void showChosen();
    void check();
    void offer(const QString &name);
    void apply();
    void removeChosen();
    QString chosenName() const;

    MathChannels &m_channels;
    ScopeView &m_scope;
    ChosenMotor m_motor;
    MathTable *m_table;
    QTreeView *m_list;
    QLineEdit *m_name;
    QLineEdit *m_formula;
    QLabel *m_verdict;
    QPushButton *m_apply;
    QPushButton *m_remove;
    QPushButton *m_record; ///< the signal that a formula lacks
    QString m_lacking; ///< its name
    std::function<bool(const QString &)> m_can;
};

} // namespace widgets
