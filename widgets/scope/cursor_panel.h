// The read-out of the scope's cursors: which pair, its distance and its inverse, and what every trace is at A and B.
// Shown only while the cursors are. It copies itself as text; it moves nothing.
#pragma once

#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QTableView;
class QToolButton;

namespace capture {
class Capture;
}

namespace widgets {

class CursorTable;
class ScopeView;

class CursorPanel : public QWidget {
    Q_OBJECT
public:
    /// Both outlive it.
    CursorPanel(ScopeView &scope, const capture::Capture &capture, QWidget *parent = nullptr);

    /// On the way of the Tab key it follows the scope, which is in the same window, however late it was made.
    void tabAfterScope();

public Q_SLOTS:
    void copy(); ///< the table as text, into the clipboard

protected:
    void changeEvent(QEvent *event) override;

private:
    QWidget *makeSide();
    void follow();
    void fitHeight();

    ScopeView &m_scope;
    CursorTable *m_model;
    QComboBox *m_pairs;
    QToolButton *m_add;
    QToolButton *m_remove;
    QToolButton *m_copy;
    QToolButton *m_hide;
    QLabel *m_distance;
    QTableView *m_table;
    QTimer m_look; ///< at the width of the table, when it has its place
    bool m_wide = false; ///< more traces than fit beside one another
};

} // namespace widgets
