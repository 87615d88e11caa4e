#include "widgets/forms/rev_up_model.h"

#include "widgets/base/value_text.h"
#include "widgets/forms/rev_up_texts.h"

#include <QApplication>
#include <QFont>
#include <QPalette>
#include <QStyle>

#include <cmath>
#include <limits>

namespace widgets {
namespace {

using motor::RevUp;
using motor::RevUpMistake;
using motor::RevUpStage;

const char *const kRegister = "REVUP_DATA";

catalog::RegisterInfo numberOf(catalog::ValueType type)
{
    catalog::RegisterInfo info;
    info.type = type;
    info.access = catalog::Access::ReadWrite;
    return info;
}

std::optional<RevUp> stagesIn(const std::optional<catalog::Value> &value)
{
    const auto *bytes = value ? std::get_if<Bytes>(&*value) : nullptr;
    const auto stages = motor::revUpOfBytes(bytes != nullptr ? *bytes : Bytes{});
    if (!stages || stages->empty())
        return {};
    return motor::completed(*stages);
}

/// What the register holds; a pulse has no sign.
int digitsOf(const RevUpStage &stage, bool pulse)
{
    return pulse ? static_cast<std::uint16_t>(stage.current_digits) : stage.current_digits;
}

int columnOf(RevUpMistake mistake)
{
    switch (mistake) {
    case RevUpMistake::TooLittleTorque:
        return RevUpModel::TorqueColumn;
    case RevUpMistake::TooMuchCurrent:
        return RevUpModel::CurrentColumn;
    case RevUpMistake::StageWithoutTime:
    case RevUpMistake::NoStage:
        return RevUpModel::DurationColumn;
    case RevUpMistake::EndsTooSlow:
    case RevUpMistake::SpeedBeyondLimit:
    case RevUpMistake::SpeedDoesNotFit:
    case RevUpMistake::TurnsBack:
        break;
    }
    return RevUpModel::SpeedColumn;
}

} // namespace

RevUpModel::RevUpModel(RegisterModel &registers, QObject *parent)
    : QAbstractTableModel(parent)
    , m_registers(registers)
{
    connect(&registers, &RegisterModel::catalogSet, this, &RevUpModel::resolve);
    connect(&registers, &QAbstractItemModel::dataChanged, this,
        [this](const QModelIndex &from, const QModelIndex &to) {
            const QModelIndex mine = m_id ? m_registers.indexOf(*m_id) : QModelIndex();
            if (mine.isValid() && mine.parent() == from.parent() && mine.row() >= from.row()
                && mine.row() <= to.row())
                adoptRegister();
        });
    resolve();
}

void RevUpModel::resolve()
{
    m_id = m_registers.idOf(kRegister);
    m_before.clear();
    adoptRegister();
}

/// The register's news: another value, another edit, another outcome.
void RevUpModel::adoptRegister()
{
    const RevUp held = m_id ? stagesIn(m_registers.known(*m_id)).value_or(RevUp()) : RevUp();
    RevUp wanted = m_id ? stagesIn(m_registers.wanted(*m_id)).value_or(held) : RevUp();
    if (wanted.empty())
        wanted = held;
    if (!m_facts.angleSensor.isEmpty())
        wanted.clear(); // there, but not run
    using State = RegisterModel::EditState;
    const State state = m_id ? m_registers.editState(*m_id) : State::None;
    if (state != State::Sending && state != State::Verified && state != State::Unproved)
        m_before = held; // the flash of a write shows what has become another
    const bool was = !m_stages.empty(), is = !wanted.empty();
    m_editable =
        is && m_registers.editable(*m_id, RegisterModel::RawColumn) && state != State::Sending;
    if (was != is)
        beginResetModel();
    m_stages = std::move(wanted);
    judge();
    if (was != is)
        endResetModel();
    else if (is)
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    if (is)
        Q_EMIT headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
    Q_EMIT stagesChanged();
}

void RevUpModel::setFacts(const RevUpFacts &facts)
{
    if (facts == m_facts)
        return;
    const bool otherSensor = facts.angleSensor != m_facts.angleSensor;
    m_facts = facts;
    if (otherSensor)
        return adoptRegister();
    judge();
    if (!m_stages.empty()) {
        Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
        Q_EMIT headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
    Q_EMIT stagesChanged();
}

void RevUpModel::judge()
{
    motor::RevUpLimits limits = m_facts.limits;
    if (m_facts.sixStep) { // a pulse is no current
        limits.load = {};
        limits.maxCurrent_a = limits.nominalCurrent_a = 0.0;
    }
    m_findings = m_stages.empty() ? std::vector<motor::RevUpFinding>()
                                  : motor::checkRevUp(m_stages, m_facts.ampsPerDigit, limits);
}

QString RevUpModel::unavailable() const
{
    if (!m_registers.catalog())
        return tr("No board is connected.");
    if (!m_id)
        return tr("This firmware has no rev-up.");
    if (!m_registers.supported(*m_id))
        return tr(
            "This board starts without a rev-up: it has a sensor of the rotor's angle, or its "
            "firmware is a reduced one.");
    if (!m_facts.angleSensor.isEmpty())
        return tr("This drive starts by its sensor (%1) and runs no rev-up.")
            .arg(m_facts.angleSensor);
    return m_stages.empty() ? tr("The stages have not been read yet.") : QString();
}

motor::RevUpBounds RevUpModel::bounds() const
{
    double amps = m_facts.limits.maxCurrent_a;
    const double nominal = m_facts.limits.nominalCurrent_a;
    if (nominal > 0.0 && (!(amps > 0.0) || nominal < amps))
        amps = nominal;
    motor::RevUpBounds bounds = motor::revUpBounds(m_facts.limits.maxSpeed_rpm,
        m_facts.sixStep ? 0.0 : amps, m_facts.ampsPerDigit, m_facts.speedStep_rpm);
    bounds.pulse = m_facts.sixStep;
    return bounds;
}

double RevUpModel::shownPerDigit() const
{
    return !m_facts.sixStep && m_facts.ampsPerDigit > 0.0 ? m_facts.ampsPerDigit : 1.0;
}

QString RevUpModel::currentName() const
{
    return m_facts.sixStep ? tr("pulse", "of a six-step drive: the duty that its timer holds")
                           : tr("Iq");
}

QString RevUpModel::currentUnit() const
{
    return !m_facts.sixStep && m_facts.ampsPerDigit > 0.0 ? QStringLiteral("A") : QString();
}

bool RevUpModel::setStages(const RevUp &stages)
{
    if (!m_editable || stages.empty())
        return false;
    return m_registers.setPending(*m_id, motor::bytesOf(motor::completed(stages)));
}

bool RevUpModel::setStage(int row, const RevUpStage &stage)
{
    return row >= 0 && row < rowCount()
        && setStages(motor::withStage(m_stages, static_cast<std::size_t>(row), stage));
}

bool RevUpModel::addAfter(int row)
{
    if (used() >= static_cast<int>(motor::kRevUpStages))
        return false;
    return setStages(motor::withStageAfter(m_stages, static_cast<std::size_t>(std::max(row, 0))));
}

bool RevUpModel::remove(int row)
{
    return row >= 0 && row < used()
        && setStages(motor::withoutStage(m_stages, static_cast<std::size_t>(row)));
}

bool RevUpModel::move(int row, int by)
{
    const int to = row + by;
    if (row < 0 || to < 0 || row >= used() || to >= used())
        return false;
    return setStages(
        motor::withSwapped(m_stages, static_cast<std::size_t>(row), static_cast<std::size_t>(to)));
}

EntryRules RevUpModel::rulesOf(int column) const
{
    static const auto kDuration = numberOf(catalog::ValueType::U16),
                      kSpeed = numberOf(catalog::ValueType::S32),
                      kDigits = numberOf(catalog::ValueType::S16);
    const motor::RevUpBounds most = bounds();
    const double digits = most.digits;
    const catalog::Limits current{most.pulse ? 0.0 : -digits, digits};
    switch (column) {
    case DurationColumn:
        return {&kDuration, {1.0, "ms"}, {0.0, double(most.duration_ms)}};
    case SpeedColumn:
        return {&kSpeed, {1.0, "rpm"}, {-double(most.speed_rpm), double(most.speed_rpm)}};
    case CurrentColumn:
        return {&kDigits, {shownPerDigit(), "A"}, current};
    default:
        return {&kDigits, {1.0, ""}, current};
    }
}

int RevUpModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_stages.size());
}

int RevUpModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

bool RevUpModel::differs(const QModelIndex &index) const
{
    if (m_before.size() != m_stages.size())
        return false;
    const auto row = static_cast<std::size_t>(index.row());
    const RevUpStage &a = m_before[row], &b = m_stages[row];
    switch (index.column()) {
    case DurationColumn:
        return a.duration_ms != b.duration_ms;
    case SpeedColumn:
        return a.speed_rpm != b.speed_rpm;
    case CurrentColumn:
    case DigitsColumn:
        return a.current_digits != b.current_digits;
    default:
        return false;
    }
}

bool RevUpModel::marked(const QModelIndex &index) const
{
    return std::any_of(m_findings.begin(), m_findings.end(), [&](const auto &finding) {
        const int at = columnOf(finding.mistake);
        return static_cast<int>(finding.stage) == index.row()
            && (at == index.column() || (at == CurrentColumn && index.column() == DigitsColumn));
    });
}

QString RevUpModel::torque(int row) const
{
    const auto stage = static_cast<std::size_t>(row);
    const auto &load = m_facts.limits.load;
    if (row >= used())
        return tr("not used", "a stage of a rev-up");
    if (m_facts.sixStep || !(load.kt_nmpa > 0.0) || !(m_facts.ampsPerDigit > 0.0))
        return QStringLiteral("\u2013");
    const double given = motor::availableTorque_nm(m_stages, stage, m_facts.ampsPerDigit, load);
    const double needed = motor::neededTorque_nm(
        m_stages[stage], row > 0 ? m_stages[stage - 1].speed_rpm : 0.0, load);
    const int decimals = given < 0.1 ? 1 : 0;
    const QString left = !(load.inertia_kgm2 > 0.0) ? QStringLiteral("?")
        : std::isinf(needed)                        ? QStringLiteral("\u221e")
                                                    : numberText(1e3 * needed, decimals);
    return left + QStringLiteral(" / ") + numberText(1e3 * given, decimals);
}

QString RevUpModel::shown(int row, int column) const
{
    const RevUpStage &stage = m_stages[static_cast<std::size_t>(row)];
    switch (column) {
    case DurationColumn:
        return QString::number(stage.duration_ms);
    case SpeedColumn:
        return numberText(stage.speed_rpm, 0);
    case CurrentColumn:
        return currentUnit().isEmpty()
            ? QStringLiteral("\u2013")
            : numberText(stage.current_digits * shownPerDigit(), decimalsFor(shownPerDigit()));
    case DigitsColumn:
        return numberText(digitsOf(stage, m_facts.sixStep), 0);
    default:
        return torque(row);
    }
}

QString RevUpModel::toolTip(const QModelIndex &index) const
{
    QStringList lines;
    if (index.column() == TorqueColumn)
        lines.append(tr("Torque that the stage needs, and that its current gives."));
    else if (index.row() >= used())
        lines.append(tr("Not used: it takes no time. Give it a duration to use it."));
    if (differs(index)) {
        const RevUpStage &held = m_before[static_cast<std::size_t>(index.row())];
        lines.append(tr("The board holds %1\u202fms, %2\u202frpm, %3 digits.")
                         .arg(QString::number(held.duration_ms), QString::number(held.speed_rpm),
                             QString::number(digitsOf(held, m_facts.sixStep))));
    }
    for (const auto &finding : m_findings)
        if (static_cast<int>(finding.stage) == index.row())
            lines.append(revUpFindingText(finding, *this));
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'))
        .toHtmlEscaped()
        .replace(QLatin1Char('\n'), QStringLiteral("<br>"));
}

QVariant RevUpModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const bool unused = index.row() >= used();
    const QVariant state =
        m_registers.indexOf(*m_id, RegisterModel::RawColumn).data(Qt::BackgroundRole);
    switch (role) {
    case Qt::DisplayRole:
        return shown(index.row(), index.column());
    case Qt::EditRole: {
        const RevUpStage &stage = m_stages[static_cast<std::size_t>(index.row())];
        if (index.column() == TorqueColumn)
            return torque(index.row());
        const std::int64_t raw = index.column() == DurationColumn ? stage.duration_ms
            : index.column() == SpeedColumn                       ? stage.speed_rpm
                                            : digitsOf(stage, m_facts.sixStep);
        return shownEntryText(raw, rulesOf(index.column()));
    }
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::BackgroundRole:
        return differs(index) ? state : QVariant();
    case Qt::ForegroundRole:
        if (differs(index) && state.isValid())
            return QColor(Qt::black);
        return unused || index.column() == TorqueColumn
            ? QVariant(QApplication::palette().brush(QPalette::Disabled, QPalette::Text))
            : QVariant();
    case Qt::DecorationRole:
        return marked(index) ? QApplication::style()->standardIcon(QStyle::SP_MessageBoxWarning)
                             : QVariant();
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return toolTip(index);
    case Qt::AccessibleTextRole:
        return tr("Stage %1, %2: %3", "a cell of the rev-up table, for a screen reader")
            .arg(QString::number(index.row() + 1),
                headerData(index.column(), Qt::Horizontal, Qt::AccessibleTextRole).toString(),
                shown(index.row(), index.column()));
    default:
        return {};
    }
}

QVariant RevUpModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Vertical) {
        const bool wrong = std::any_of(m_findings.begin(), m_findings.end(),
            [section](const auto &finding) { return static_cast<int>(finding.stage) == section; });
        if (role == Qt::DisplayRole)
            return wrong ? QString::number(section + 1) + QStringLiteral("\u202f\u26a0")
                         : QString::number(section + 1);
        return {};
    }
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole && role != Qt::AccessibleTextRole)
        return {};
    const bool brief = role == Qt::DisplayRole;
    switch (section) {
    case DurationColumn:
        return brief ? tr("Time\nms", "duration of a stage") : tr("Duration of the stage, ms");
    case SpeedColumn:
        return brief ? tr("Speed\nrpm") : tr("Speed at the end of the stage, rpm");
    case CurrentColumn:
        return brief ? tr("Iq\nA") : tr("Iq at the end of the stage, A");
    case DigitsColumn:
        if (m_facts.sixStep)
            return brief ? tr("Pulse\ndigits") : tr("Pulse at the end of the stage, digits");
        return brief ? tr("Iq\ndigits") : tr("Iq at the end of the stage, digits of the register");
    case TorqueColumn:
        return brief ? tr("Torque\nmN\u00b7m") : tr("Torque needed / given, mN\u00b7m");
    default:
        return {};
    }
}

Qt::ItemFlags RevUpModel::flags(const QModelIndex &index) const
{
    if (!index.isValid())
        return QAbstractTableModel::flags(index);
    Qt::ItemFlags flags = QAbstractTableModel::flags(index) | Qt::ItemNeverHasChildren;
    const bool numbers = index.column() != TorqueColumn
        && (index.column() != CurrentColumn || !currentUnit().isEmpty());
    flags.setFlag(Qt::ItemIsEditable, m_editable && numbers);
    return flags;
}

bool RevUpModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::EditRole || !index.isValid() || !flags(index).testFlag(Qt::ItemIsEditable))
        return false;
    const EntryRules rules = rulesOf(index.column());
    const auto read = readShownEntry(value.toString(), rules);
    const auto *whole = read ? std::get_if<std::int64_t>(&*read) : nullptr;
    if (whole == nullptr)
        return false;
    const double keep = std::numeric_limits<double>::quiet_NaN();
    const auto raw = static_cast<double>(*whole);
    const bool speed = index.column() == SpeedColumn, time = index.column() == DurationColumn;
    const RevUpStage old = m_stages[static_cast<std::size_t>(index.row())];
    const RevUpStage stage = motor::fittedStage(
        old, speed ? raw : keep, speed || time ? keep : raw, time ? raw : keep, bounds());
    if (!setStage(index.row(), stage))
        return false;
    if (speed && stage.speed_rpm != *whole)
        Q_EMIT adjusted(
            tr("%1\u202frpm became %2\u202frpm: drives count speeds in steps of %3\u202frpm.")
                .arg(QString::number(*whole), QString::number(stage.speed_rpm),
                    QString::number(m_facts.speedStep_rpm)));
    return true;
}

} // namespace widgets
