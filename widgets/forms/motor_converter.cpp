#include "widgets/forms/motor_converter.h"

#include "widgets/base/device_text.h"
#include "widgets/base/fields/stepped_edit.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/setpoint_text.h"
#include "widgets/base/si_text.h"

#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

constexpr double kSmallest = 1e-9, kLargest = 1e9; ///< of what is typed, in the unit shown
constexpr qsizetype kMostTypedDigits = 16;

} // namespace

MotorConverter::MotorConverter(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("motorConverter"));
    auto *grid = bare(new QGridLayout(this), kGrid, kFineGrid);
    struct Cell {
        Field field;
        const char *name;
        int row, column;
        QString label, unit, help;
    };
    const QString terminals = tr("Between two terminals, as a meter shows it: twice the phase.");
    const QString phase = tr("Of one phase of the star, as boards and formulas use it.");
    const Cell cells[] = {
        {PolePairs, "convertPolePairs", 0, 0, tr("&Pole pairs"), {},
            tr("Half the number of magnets. Forgetting them is the usual mistake: \u03bb is wrong "
               "by that factor.")},
        {Ke, "convertKe", 1, 0, tr("&Ke"), QStringLiteral("V/krpm"),
            tr("V rms between two terminals at 1000 rpm, as ST gives it.")},
        {Kv, "convertKv", 1, 1, QStringLiteral("KV"), QStringLiteral("rpm/V"),
            tr("rpm per volt, peak, between two terminals, as model motors are sold.")},
        {Flux, "convertFlux", 2, 0, tr("\u03bb (f&lux)"), QStringLiteral("mWb"),
            tr("\u03bb = Ke \u00b7 √2 / √3 / (p \u00b7 104.72 rad/s). Peak, of a "
               "phase.")},
        {Kt, "convertKt", 2, 1, QStringLiteral("Kt"), QStringLiteral("mN m/A"),
            tr("Kt = 3/2 \u00b7 p \u00b7 \u03bb, per peak ampere.")},
        {MeasuredVolts, "convertVolts", 3, 0, tr("Measured"), QStringLiteral("V rms"),
            tr("A voltmeter between two terminals while the shaft is turned: gives Ke and decides "
               "which of two data sheets is right.")},
        {MeasuredRpm, "convertRpm", 3, 1, tr("at"), QStringLiteral("rpm"),
            tr("Speed of the shaft while the voltage was measured.")},
        {PhaseOhm, "convertPhaseOhm", 4, 0, tr("&R, phase"), QStringLiteral("\u03a9"), phase},
        {TerminalOhm, "convertTerminalOhm", 4, 1, tr("terminals"), QStringLiteral("\u03a9"),
            terminals},
        {PhaseHenry, "convertPhaseHenry", 5, 0, tr("L, phase"), QStringLiteral("mH"), phase},
        {TerminalHenry, "convertTerminalHenry", 5, 1, tr("terminals"), QStringLiteral("mH"),
            terminals},
    };
    for (const Cell &cell : cells) {
        QWidget *edit = makeField(cell.field, cell.name, cell.label, cell.unit, cell.help);
        grid->addWidget(m_labels[cell.field], cell.row, 3 * cell.column);
        grid->addWidget(edit, cell.row, 3 * cell.column + 1);
        auto *unit = new QLabel(cell.unit, this);
        grid->addWidget(unit, cell.row, 3 * cell.column + 2);
    }
    grid->setColumnStretch(5, 1);
    m_told = wrappedLabel("convertTold", this);
    grid->addWidget(m_told, 0, 3, 1, 3);
}

QWidget *MotorConverter::makeField(
    Field field, const char *name, const QString &label, const QString &unit, const QString &help)
{
    auto *edit = named(new QLineEdit(this), name);
    edit->setAlignment(Qt::AlignRight);
    edit->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("00000.00000")));
    edit->setToolTip(plainToolTip(help));
    edit->installEventFilter(this);
    auto *text = new QLabel(label, this);
    text->setBuddy(edit);
    text->setToolTip(plainToolTip(help));
    QString plain = label;
    plain.remove(QLatin1Char('&'));
    edit->setAccessibleName(unit.isEmpty() ? plain : tr("%1 in %2", "name, unit").arg(plain, unit));
    edit->setAccessibleDescription(help);
    m_edits[field] = edit;
    m_labels[field] = text;
    return edit;
}

void MotorConverter::suggest(const motor::MotorSheet &sheet)
{
    const auto typing = [](const QLineEdit *edit) {
        return edit->isModified() && focusIsIn(*edit);
    };
    if (!m_typed && std::none_of(m_edits.begin(), m_edits.end(), typing))
        accept(sheet);
}

void MotorConverter::accept(const motor::MotorSheet &sheet)
{
    m_typed = false;
    for (int field = 0; field < FieldCount; ++field)
        put(Field(field), 0.0);
    put(PolePairs, sheet.polePairs.value_or(0.0));
    put(PhaseOhm, sheet.rs_ohm.value_or(0.0));
    put(PhaseHenry, sheet.lq_h.value_or(0.0) * kMilli);
    put(Flux, sheet.flux_wb.value_or(0.0) * kMilli);
    convert(PhaseOhm);
    convert(PhaseHenry);
    m_strength = Flux;
    convert(Flux);
    m_strength = Ke; // other pole pairs: the measurable figure stays
    showNumbers();
    tell();
}

std::optional<double> MotorConverter::number(Field field) const
{
    return m_values[field] > 0.0 ? std::optional(m_values[field]) : std::nullopt;
}

void MotorConverter::put(Field field, double value)
{
    const bool good = std::isfinite(value) && value > 0.0;
    m_values[field] = good ? value : 0.0;
    m_shown[field] = good ? plainNumberText(value) : QString();
}

void MotorConverter::showNumbers()
{
    for (std::size_t field = 0; field < FieldCount; ++field) {
        followText(*m_edits[field], m_shown[field]);
        m_edits[field]->setModified(false);
    }
}

bool MotorConverter::eventFilter(QObject *watched, QEvent *event)
{
    for (int field = 0; field < FieldCount; ++field) {
        if (watched != m_edits[static_cast<std::size_t>(field)])
            continue;
        if (event->type() == QEvent::FocusOut)
            commit(Field(field));
        if (event->type() == QEvent::KeyPress) {
            const int key = static_cast<QKeyEvent *>(event)->key();
            if (key == Qt::Key_Return || key == Qt::Key_Enter) {
                commit(Field(field));
                return true;
            }
        }
    }
    return QWidget::eventFilter(watched, event);
}

void MotorConverter::commit(Field field)
{
    const QString text = m_edits[field]->text();
    if (text == m_shown[field])
        return;
    const auto read = readPlainNumber(text, kMostTypedDigits);
    const bool whole = field != PolePairs || (read && *read == std::round(*read) && *read <= 100.0);
    if (!read || !(*read >= kSmallest) || *read > kLargest || !whole) {
        m_edits[field]->setText(m_shown[field]);
        m_told->setText(!read ? setpointErrorText(read.error())
                : whole       ? tr("It has to be greater than 0.")
                              : tr("Pole pairs are a whole number up to 100."));
        return;
    }
    m_typed = true;
    m_values[field] = *read;
    m_shown[field] = text;
    if (field >= Ke && field <= Kt)
        m_strength = field;
    convert(field);
    showNumbers();
    tell();
}

void MotorConverter::convert(Field from)
{
    switch (from) {
    case PhaseOhm:
        return put(TerminalOhm, 2.0 * m_values[PhaseOhm]);
    case TerminalOhm:
        return put(PhaseOhm, m_values[TerminalOhm] / 2.0);
    case PhaseHenry:
        return put(TerminalHenry, 2.0 * m_values[PhaseHenry]);
    case TerminalHenry:
        return put(PhaseHenry, m_values[TerminalHenry] / 2.0);
    case MeasuredVolts:
    case MeasuredRpm:
        if (!number(MeasuredVolts) || !number(MeasuredRpm))
            return;
        put(Ke, m_values[MeasuredVolts] / m_values[MeasuredRpm] * 1000.0);
        m_strength = Ke;
        break;
    default:
        break;
    }
    // Ke and KV say nothing of the pole pairs, Kt neither: only the flux needs them.
    const double pairs = number(PolePairs).value_or(1.0);
    const double typed = m_values[m_strength];
    if (!(typed > 0.0) || (m_strength == Flux && !number(PolePairs)))
        return;
    const double flux_wb = m_strength == Ke ? motor::fluxOfKe_wb(typed, pairs)
        : m_strength == Kv                  ? motor::fluxOfKv_wb(typed, pairs)
        : m_strength == Flux                ? typed / kMilli
                                            : typed / kMilli / (1.5 * pairs);
    const auto show = [&](Field field, double value) {
        if (field != m_strength) // what was typed stays as it was typed
            put(field, value);
    };
    show(Ke, motor::keOfFlux_vrmsPerKrpm(flux_wb, pairs));
    show(Kv, motor::kvOfFlux_rpmpv(flux_wb, pairs));
    show(Flux, number(PolePairs) ? flux_wb * kMilli : 0.0);
    show(Kt, motor::ktOfFlux_nmpa(flux_wb, pairs) * kMilli);
}

void MotorConverter::tell()
{
    m_told->setText(number(PolePairs) ? QString() : tr("\u03bb needs the pole pairs."));
}

} // namespace widgets
