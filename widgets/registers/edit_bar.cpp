#include "widgets/registers/edit_bar.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/line_icon.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace widgets {
namespace {

constexpr int kMostNamed = 88; ///< edits that the button has room for
constexpr int kLines = 2; ///< of what is told in a narrow panel; the tool tip has all of it

} // namespace

EditBar::EditBar(RegisterEdits &edits, const RegisterModel &model, QAction *apply, QAction *revert,
    Room room, QWidget *parent)
    : QWidget(parent)
    , m_edits(edits)
    , m_model(model)
    , m_applyAction(apply)
    , m_revertAction(revert)
    , m_wide(room == Room::Wide)
    , m_told(wrappedLabel("editsTold", this))
    , m_revert(named(new QPushButton(tr("Revert"), this), "revertEdits"))
    , m_apply(named(new QPushButton(this), "applyEdits"))
{
    connect(m_revert, &QPushButton::clicked, revert, &QAction::trigger);
    connect(m_apply, &QPushButton::clicked, apply, &QAction::trigger);
    auto *layout = bare(new QGridLayout(this));
    if (m_wide) { // else words go before signs
        setLineIcon(*m_revert, "revert");
        setLineIcon(*m_apply, "apply");
    }
    m_told->setFixedHeight((m_wide ? 1 : kLines) * m_told->fontMetrics().lineSpacing());
    m_told->setAlignment(Qt::AlignLeft | (m_wide ? Qt::AlignVCenter : Qt::AlignTop));
    if (m_wide) {
        layout->addWidget(m_told, 0, 0);
        layout->addWidget(m_revert, 0, 1);
        layout->addWidget(m_apply, 0, 2);
        layout->setColumnStretch(0, 1);
    } else {
        layout->addWidget(m_told, 0, 0, 1, 2);
        layout->addWidget(m_revert, 1, 0);
        layout->addWidget(m_apply, 1, 1);
    }
    int widest = 0; // however many wait
    for (const int count : {1, kMostNamed}) {
        m_apply->setText(applyText(count));
        widest = std::max(widest, m_apply->sizeHint().width());
    }
    m_apply->setFixedWidth(widest);
    m_revert->setSizePolicy(
        m_wide ? QSizePolicy::Minimum : QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(&edits, &RegisterEdits::told, this, &EditBar::tell);
    connect(&edits, &RegisterEdits::changed, this, &EditBar::refresh);
    connect(apply, &QAction::changed, this, &EditBar::refresh);
    connect(revert, &QAction::changed, this, &EditBar::refresh);
    refresh();
}

QString EditBar::applyText(int count) const
{
    return count == 0 ? tr("Apply")
        : m_wide      ? tr("Apply %n edit(s)", nullptr, count)
                      : tr("Apply (%1)", "so many edits").arg(QString::number(count));
}

void EditBar::refresh()
{
    const int count = m_edits.pendingCount();
    m_apply->setText(applyText(count));
    m_apply->setAccessibleName(count > 0 ? tr("Apply %n edit(s)", nullptr, count) : tr("Apply"));
    for (const auto &[button, action] :
        {std::pair(m_apply, m_applyAction), std::pair(m_revert, m_revertAction)}) {
        // Else the next field would get the focus, and take the undo key for its own text.
        if (button->hasFocus() && !action->isEnabled() && parentWidget() != nullptr)
            parentWidget()->setFocus(Qt::OtherFocusReason);
        button->setEnabled(action->isEnabled());
        button->setToolTip(action->toolTip());
    }
    if (count > 0 && m_good)
        m_sentence.clear();
    // Why a waiting edit cannot be written is said where people look, too.
    const QString why = count > 0 ? m_edits.applyHint() : QString();
    QString shown = why.isEmpty() || m_edits.underWay() ? m_sentence : why;
    // What waits out of sight is named: Apply writes it, too.
    if (const QStringList elsewhere = m_model.pendingElsewhere(); !elsewhere.isEmpty())
        shown = (shown + QLatin1Char(' ')
            + tr("Waiting for a motor that is not shown: %1.", "list of registers")
                  .arg(elsewhere.join(QStringLiteral(", "))))
                    .trimmed();
    m_told->setText(shown);
    m_told->setToolTip(plainToolTip(shown));
}

void EditBar::tell(const QString &sentence, bool good)
{
    m_sentence = sentence;
    m_good = good;
    m_told->setForegroundRole(good ? QPalette::PlaceholderText : QPalette::WindowText);
    QFont font = this->font();
    font.setBold(!good);
    m_told->setFont(font);
    refresh();
}

} // namespace widgets
