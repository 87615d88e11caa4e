#include "widgets/files/notes_panel.h"

#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"

#include <QPlainTextEdit>
#include <QVBoxLayout>

namespace widgets {

NotesPanel::NotesPanel(const QString &text, QWidget *parent)
    : Form(parent)
    , m_text(named(new QPlainTextEdit(text, this), "notes", tr("Notes")))
{
    setObjectName(QStringLiteral("notesPanel"));
    m_text->setPlaceholderText(tr("What is tried, and what came of it. Kept with the workspace."));
    m_text->setTabChangesFocus(true);
    auto *layout = edged(new QVBoxLayout(this), kToolEdges);
    layout->addWidget(m_text);
}

QString NotesPanel::text() const { return m_text->toPlainText(); }

void NotesPanel::setText(const QString &text) { m_text->setPlainText(text); }

void NotesPanel::focusFirst() { m_text->setFocus(Qt::ShortcutFocusReason); }

} // namespace widgets
