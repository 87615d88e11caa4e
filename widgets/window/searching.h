// Searching: goes on to the next place in what was recorded where the trigger's condition is met. It is looked for in a
// thread, in a copy of the source's samples; the picture is brought there.
#pragma once

#include "capture/capture.h"
#include "scope/trigger_search.h"
#include "widgets/base/banner.h"
#include "widgets/files/job.h"

#include <QPointer>

class QAction;

namespace widgets {

class ScopeView;
class TriggerControl;

class Searching : public QObject {
    Q_OBJECT
public:
    /// All outlive it. @param window  progress is shown over it
    Searching(const TriggerControl &trigger, ScopeView &scope, const capture::Capture &capture,
        QWidget *window);

    QAction *action() { return m_action; }

public Q_SLOTS:
    /// From the last place on if that is in the picture, else from where the picture begins. One that is under way
    /// ends.
    void next();

Q_SIGNALS:
    void said(widgets::Banner::Kind kind, const QString &sentence);

private:
    void show(const std::optional<scope::TriggerHit> &hit);

    const TriggerControl &m_trigger;
    ScopeView &m_scope;
    const capture::Capture &m_capture;
    QAction *m_action;
    QPointer<FileJob> m_job;
    std::optional<scope::Nanos> m_last;
};

} // namespace widgets
