#include "widgets/scope/tools.h"

#include "widgets/base/look/line_icon.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/ghosts.h"
#include "widgets/scope/trigger/control.h"

namespace widgets {

ScopeTools::ScopeTools(ScopeView &scope, TriggerControl &trigger, QWidget &window)
    : QObject(&window)
    , m_scope(scope)
    , m_window(window)
{
    makeTrigger(trigger);
    m_cursors = make(tr("Cursors"), Qt::Key_C,
        tr("Two times, their distance and the values there (C). "
           "1 and 2 give a cursor to the mouse, arrows move it by a sample."),
        [this] { m_scope.cursorActions().toggle(); });
    m_cursors->setCheckable(true);
    setLineIcon(*m_cursors, "cursors");
    QAction *takeA = make(tr("Take cursor &A"), Qt::Key_1, {}, [this] {
        m_scope.cursorActions().accept(CursorEnd::A);
        m_scope.setFocus(Qt::ShortcutFocusReason);
    });
    QAction *takeB = make(tr("Take c&ursor B"), Qt::Key_2, {}, [this] {
        m_scope.cursorActions().accept(CursorEnd::B);
        m_scope.setFocus(Qt::ShortcutFocusReason);
    });
    m_groups.append({m_cursors, takeA, takeB});
    QAction *marker = make(tr("Set a &marker"), Qt::Key_M,
        tr("At the mouse, else at the active cursor, else at the newest sample (M)"),
        [this] { m_scope.cursorActions().setMarker(); });
    marker->setAutoRepeat(false);
    setLineIcon(*marker, "marker");
    m_groups.append(QList<QAction *>{marker});
    QAction *overview = make(tr("&Whole recording below"), Qt::Key_O,
        tr("A strip with everything recorded, and a box around what the plots show (O)"),
        [this] { m_scope.setOverviewVisible(!m_scope.overviewVisible()); });
    QAction *grid = make(
        tr("&Grid"), Qt::Key_G, {}, [this] { m_scope.setGridVisible(!m_scope.gridVisible()); });
    setLineIcon(*grid, "grid");
    m_groups.append(QList<QAction *>{overview, grid});
    connect(&scope.cursors(), &Cursors::changed, m_cursors,
        [this] { m_cursors->setChecked(m_scope.cursors().visible()); });
}

void ScopeTools::makeTrigger(TriggerControl &trigger)
{
    QAction *single = make(tr("&Single record"), Qt::Key_S, {}, [&trigger] { trigger.single(); });
    QAction *force =
        make(tr("Force a &trigger"), Qt::Key_T, {}, [&trigger] { trigger.trigger().force(); });
    connect(&trigger, &TriggerControl::changed, this, [&trigger, single, force] {
        single->setEnabled(trigger.trigger().awaitsSamples());
        force->setEnabled(trigger.trigger().awaitsSamples());
    });
    setLineIcon(*single, "single");
    setLineIcon(*force, "force");
    m_groups.append(QList<QAction *>{single, force});
    QAction *before =
        make(tr("&Previous record"), Qt::Key_PageUp, {}, [&trigger] { trigger.step(-1); });
    QAction *after =
        make(tr("&Next record"), Qt::Key_PageDown, {}, [&trigger] { trigger.step(1); });
    setLineIcon(*before, "earlier");
    setLineIcon(*after, "later");
    m_groups.append(QList<QAction *>{before, after});
    QList<QAction *> references;
    const std::tuple<Reference, Qt::Key, QString, QString> all[] = {
        {Reference::A, Qt::Key_R, tr("&Keep as reference A"), tr("&Drop reference A")},
        {Reference::B, Qt::Key_B, tr("Keep as reference &B"), tr("D&rop reference B")}};
    for (const auto &[which, key, keep, drop] : all) {
        references.append(
            make(keep, key, {}, [this, which = which] { m_scope.ghosts().keep(which); }));
        QAction *away = make(
            drop, Qt::SHIFT | key, {}, [this, which = which] { m_scope.ghosts().drop(which); });
        const auto enable = [this, away, which = which] {
            away->setEnabled(m_scope.ghosts().hasReference(which));
        };
        connect(&m_scope.ghosts(), &ScopeGhosts::referencesChanged, away, enable);
        enable();
        references.append(away);
    }
    for (const auto &[which, text] : {std::pair(Reference::A, tr("Next event o&f reference A")),
             std::pair(Reference::B, tr("Next e&vent of reference B"))}) {
        QAction *next = make(text, {},
            tr("Lays another moment of its file at the trigger, or at the "
               "left edge of a picture that rolls"),
            [this, which = which] { m_scope.ghosts().nextInstant(which, 1); });
        next->setObjectName(
            which == Reference::A ? QStringLiteral("nextEventA") : QStringLiteral("nextEventB"));
        const auto enable = [this, next, which = which] {
            next->setEnabled(m_scope.ghosts().isFromFile(which));
        };
        connect(&m_scope.ghosts(), &ScopeGhosts::referencesChanged, next, enable);
        enable();
        references.append(next);
    }
    m_groups.append(references);
}

} // namespace widgets
