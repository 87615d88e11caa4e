#include "widgets/window/searching.h"

#include "widgets/base/reading_text.h"
#include "widgets/scope/trigger/control.h"
#include "widgets/scope/view.h"

#include <QAction>
#include <QWidget>

namespace widgets {

Searching::Searching(const TriggerControl &trigger, ScopeView &scope,
    const capture::Capture &capture, QWidget *window)
    : QObject(window)
    , m_trigger(trigger)
    , m_scope(scope)
    , m_capture(capture)
    , m_action(new QAction(tr("Ne&xt where the trigger is met"), this))
{
    m_action->setObjectName(QStringLiteral("nextTrigger"));
    m_action->setShortcut(Qt::Key_N);
    m_action->setToolTip(tr("Goes on to the next place in what was recorded where the trigger's "
                            "condition is met (N)"));
    connect(m_action, &QAction::triggered, this, &Searching::next);
    for (const auto begunAnew : {&Trigger::conditionChanged, &Trigger::forgotten})
        connect(&trigger.trigger(), begunAnew, this, [this] { m_last.reset(); });
}

void Searching::next()
{
    const Trigger &trigger = m_trigger.trigger();
    const auto source = trigger.source();
    const capture::Channel *channel = source ? m_capture.channel(source->id) : nullptr;
    if (!fieldsOf(trigger.setup().type).source) {
        Q_EMIT said(Banner::Kind::Note,
            tr("This trigger waits for an event: the list of events has them all (Ctrl+7)."));
        return;
    }
    if (!channel || channel->empty() || trigger.error())
        return show({});
    const ScopeView::TimeRange seen = m_scope.visibleRange();
    const bool goesOn = m_last && seen.has(capture::toSeconds(*m_last));
    const scope::Nanos from = goesOn ? *m_last + 1 : capture::toNanos(seen.from);
    if (m_job)
        m_job->cancel();
    m_job = new FileJob(
        tr("Searching %1").arg(m_scope.nameOf(source->id)),
        [this, copy = m_capture.snapshot({&source->id, 1}), from,
            condition = conditionOf(trigger.setup(), source)](
            const FileJob::Proceed &proceed) -> FileJob::Finish {
            bool cancelled = false;
            const auto hit = scope::findTrigger(copy->front(), condition, from,
                [&](double done) { return !(cancelled = !proceed(done)); });
            if (cancelled)
                return {};
            return [this, hit] { show(hit); };
        },
        qobject_cast<QWidget *>(parent()));
}

void Searching::show(const std::optional<scope::TriggerHit> &hit)
{
    if (!hit) {
        Q_EMIT said(Banner::Kind::Note, tr("The trigger's condition is not met in what follows."));
        return;
    }
    m_last = hit->time;
    const double seconds = capture::toSeconds(hit->time);
    if (m_trigger.trigger().triggered())
        m_scope.setRunning(false); // the next record would take the picture away
    m_scope.time().centerOn(seconds);
    Q_EMIT said(Banner::Kind::Note,
        tr("The trigger's condition is met at %1.", "a time")
            .arg(exactTime(seconds - m_scope.time().origin(), m_scope.locale())));
}

} // namespace widgets
