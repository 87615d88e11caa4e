#include "widgets/control/current_scale_dialog.h"

#include "drive/motion_limits.h"
#include "motor/current_loop.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/setpoint_text.h"
#include "widgets/base/value_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <optional>

namespace widgets {
namespace {

constexpr double kMilli = 1e-3;

/// 0 for an empty line: not known. Empty if it is no full-scale current at all.
std::optional<double> ampsIn(const QString &text)
{
    if (text.trimmed().isEmpty())
        return 0.0;
    const auto amps = readSetpoint(text);
    const bool good = amps && *amps > 0.0 && drive::isPlausible(drive::CurrentScale{1, *amps});
    return good ? std::optional(*amps) : std::nullopt;
}

double positiveIn(const QLineEdit *edit) { return readSetpoint(edit->text()).value_or(0.0); }

} // namespace

CurrentScaleDialog::CurrentScaleDialog(int motor, double fullScaleAmps, QWidget *parent)
    : QDialog(parent)
    , m_motor(motor)
    , m_amps(named(new QLineEdit(this), "fullScaleCurrent"))
    , m_shunt(named(new QLineEdit(this), "shunt"))
    , m_gain(named(new QLineEdit(this), "amplifierGain"))
    , m_reference(named(new QLineEdit(this), "converterReference"))
    , m_says(named(new QLabel(this), "scaleSays"))
{
    setObjectName(QStringLiteral("currentScaleDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Current scale of motor %1").arg(motor));
    m_amps->setText(fullScaleAmps > 0.0 ? numberText(fullScaleAmps, 4) : QString());
    m_amps->setPlaceholderText(tr("not known", "the current scale"));
    for (QLineEdit *edit : {m_amps, m_shunt, m_gain, m_reference})
        edit->setAlignment(Qt::AlignRight);
    auto *explain = new QLabel(
        tr("This board does not tell the scale of its currents. Without it they are shown in "
           "digits and none can be asked for; with a wrong one the motor gets a wrong current. "
           "Setting it disarms."),
        this);
    for (QLabel *label : {explain, m_says})
        label->setWordWrap(true);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_amps, &QLineEdit::textChanged, this, &CurrentScaleDialog::follow);
    auto *form = edged(new QFormLayout(this), kDialogEdges, kGrid);
    form->addRow(explain);
    form->addRow(
        tr("&Full-scale current [A] (peak, %1 digits)").arg(numberText(drive::kFullScaleDigits, 0)),
        m_amps);
    form->addRow(makeCircuit());
    form->addRow(m_says);
    form->addRow(buttons);
    setMinimumWidth(460);
    m_amps->setFocus();
    follow();
}

/// Its fields are a calculator for the one above.
QGroupBox *CurrentScaleDialog::makeCircuit()
{
    auto *circuit = new QGroupBox(tr("Or from the measuring circuit"), this);
    auto *form = new QFormLayout(circuit);
    form->setSpacing(kGrid);
    form->addRow(tr("&Shunt [m\u03a9]"), m_shunt);
    form->addRow(tr("&Gain of the amplifier"), m_gain);
    form->addRow(tr("&Reference of the converter [V]"), m_reference);
    for (QLineEdit *edit : {m_shunt, m_gain, m_reference})
        connect(edit, &QLineEdit::textEdited, this, &CurrentScaleDialog::compute);
    return circuit;
}

void CurrentScaleDialog::compute()
{
    const double amps = motor::fullScaleCurrent_a(
        {positiveIn(m_shunt) * kMilli, positiveIn(m_gain), positiveIn(m_reference)});
    if (amps > 0.0)
        m_amps->setText(numberText(amps, 4));
}

void CurrentScaleDialog::follow()
{
    const auto amps = ampsIn(m_amps->text());
    m_ok->setEnabled(amps.has_value());
    if (!amps)
        m_says->setText(tr("A full-scale current is a plain number from 0.001 to %1 A, or nothing.")
                            .arg(numberText(drive::kHighestAmps, 0)));
    else if (*amps > 0.0)
        m_says->setText(tr("1 digit is %1 mA; 1 A is %2 digits.")
                            .arg(numberText(*amps / drive::kFullScaleDigits / kMilli, 4),
                                numberText(drive::kFullScaleDigits / *amps, 1)));
    else
        m_says->setText(tr("Currents are shown in digits."));
}

void CurrentScaleDialog::accept()
{
    const auto amps = ampsIn(m_amps->text());
    if (!amps)
        return;
    Q_EMIT chosen(m_motor, *amps);
    QDialog::accept();
}

} // namespace widgets
