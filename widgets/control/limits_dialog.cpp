#include "widgets/control/limits_dialog.h"

#include "drive/motion_limits.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/setpoint_text.h"
#include "widgets/base/value_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <cmath>
#include <optional>

namespace widgets {
namespace {

/// 0 for an empty line: no limit. Empty if it is no limit at all.
std::optional<double> limitIn(const QString &text)
{
    if (text.trimmed().isEmpty())
        return 0.0;
    const auto value = readSetpoint(text);
    return value && *value > 0.0 ? std::optional(*value) : std::nullopt;
}

QString textOf(double limit)
{
    if (!(limit > 0.0))
        return {};
    const bool whole = limit == std::floor(limit);
    return numberText(limit, whole ? 0 : 3);
}

} // namespace

LimitsDialog::LimitsDialog(const drive::UserLimits &limits, QWidget *parent)
    : QDialog(parent)
    , m_speed(named(new QLineEdit(textOf(limits.maxSpeedRpm), this), "limitSpeed"))
    , m_current(named(new QLineEdit(textOf(limits.maxCurrentAmps), this), "limitCurrent"))
    , m_wrong(new QLabel(this))
{
    setObjectName(QStringLiteral("limitsDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Own limits"));
    for (QLineEdit *edit : {m_speed, m_current}) {
        edit->setAlignment(Qt::AlignRight);
        edit->setPlaceholderText(tr("none", "no limit"));
        connect(edit, &QLineEdit::textChanged, this, &LimitsDialog::follow);
    }
    auto *explain = new QLabel(
        tr("No set-point beyond these is sent, to any motor and any board. Where the board's own "
           "limits are lower, those count. Leave a field empty for no limit of your own."),
        this);
    explain->setWordWrap(true);
    m_wrong->setWordWrap(true);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *form = edged(new QFormLayout(this), kDialogEdges, kGrid);
    form->addRow(explain);
    form->addRow(tr("Greatest &speed [rpm]"), m_speed);
    form->addRow(tr("Greatest &current [A]"), m_current);
    form->addRow(m_wrong);
    form->addRow(buttons);
    setMinimumWidth(400);
    follow();
    resize(minimumWidth(), form->totalHeightForWidth(minimumWidth()));
}

void LimitsDialog::follow()
{
    const bool good = limitIn(m_speed->text()) && limitIn(m_current->text());
    m_ok->setEnabled(good);
    m_wrong->setText(good ? QString() : tr("A limit is a plain number above 0, or nothing."));
}

void LimitsDialog::accept()
{
    const auto speed = limitIn(m_speed->text()), current = limitIn(m_current->text());
    if (!speed || !current)
        return;
    Q_EMIT chosen({*speed, *current});
    QDialog::accept();
}

} // namespace widgets
