// ScopePage: the scope and what is around it: its bar, what is recorded or replayed, the trigger, the cursors' values,
// the channels. It owns the actions of the bar.
#pragma once

#include <QWidget>

class QAction;
class QToolButton;
class QVBoxLayout;

namespace widgets {

class ChannelStrip;
class RecordingControl;
class ScopeTools;
class ScopeView;
class SignalSelection;
class TriggerControl;
class Workbench;

class ScopePage : public QWidget {
    Q_OBJECT
public:
    /// All outlive it.
    struct Parts {
        Workbench &workbench;
        ScopeView &scope;
        SignalSelection &selection;
        TriggerControl &trigger;
        RecordingControl &record;
        QAction *save; ///< export
        QWidget &window; ///< gets the actions, so that their keys work wherever no text is typed
    };
    ScopePage(const Parts &parts, QWidget *parent);

    ChannelStrip &strip() { return *m_strip; }
    const ScopeTools &tools() const { return *m_tools; }
    QList<QAction *> moving() const { return {m_run, m_follow}; } ///< for a menu
    QAction *setPoints() const { return m_setPoints; } ///< shows them as they were sent
    QList<QAction *> fitting() const { return {m_fit, m_fitValues, m_zoomIn, m_zoomOut}; }

public Q_SLOTS:
    void showSource(); ///< where the samples come from may have changed

protected:
    void changeEvent(QEvent *event) override;

private:
    void makeActions();
    QWidget *makeBar();
    void showCursorsIn(QVBoxLayout &layout);
    QString sourceText() const;
    void pace();
    void makeSetPoints();

    Parts m_parts;
    ScopeTools *m_tools;
    ChannelStrip *m_strip;
    QWidget *m_bar = nullptr;
    QAction *m_run = nullptr;
    bool m_calm = false; ///< no motor is driven
    QToolButton *m_runButton = nullptr;
    QAction *m_setPoints = nullptr;
    QAction *m_follow = nullptr;
    QAction *m_fit = nullptr;
    QAction *m_fitValues = nullptr;
    QAction *m_zoomIn = nullptr;
    QAction *m_zoomOut = nullptr;
};

} // namespace widgets
