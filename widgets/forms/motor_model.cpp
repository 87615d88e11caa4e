#include "widgets/forms/motor_model.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/section_head.h"
#include "widgets/base/register_texts.h"
#include "widgets/base/si_text.h"
#include "widgets/base/value_text.h"
#include "widgets/forms/motor_messages.h"

#include <algorithm>

namespace widgets {
namespace {

constexpr quintptr kGroup = ~quintptr{0}; ///< internal id of groups; of rows: their group
constexpr double kGcm2PerKgm2 = 1e7;

QString hexText(std::int64_t bits)
{
    return QStringLiteral("0x")
        + QString::number(bits, 16).toUpper().rightJustified(4, QLatin1Char('0'));
}

constexpr int kBoardDigits = 7; ///< all that a board's float has

QString rawOf(const drive::StructureField &field)
{
    if (const auto *whole = std::get_if<std::int64_t>(&field.value))
        return field.flags || *whole > 0xFFFFFF ? hexText(*whole) : QString::number(*whole);
    if (const auto *real = std::get_if<double>(&field.value))
        return floatText(*real, kBoardDigits);
    return {};
}

QString figureText(motor::MotorQuantity quantity, const std::optional<double> &value)
{
    if (!value)
        return QStringLiteral("\u2013");
    if (quantity == motor::MotorQuantity::Inertia)
        return siText(*value * kGcm2PerKgm2, QStringLiteral("g cm\u00b2"));
    const auto unit = motor::motorQuantities()[static_cast<std::size_t>(quantity)].unit;
    return siText(*value, QString::fromUtf8(unit));
}

/// A value that follows from others: what it is, how, and of which unit.
struct Derived {
    const char *key;
    QString name, help, unit;
    std::optional<double> board, file;
};

} // namespace

void MotorModel::showBoard(
    const drive::MotorFacts &facts, std::vector<drive::StructureView> structures)
{
    m_facts = facts;
    m_structures = std::move(structures);
    rebuild();
}

void MotorModel::clearBoard()
{
    m_facts.reset();
    m_structures.clear();
    rebuild();
}

void MotorModel::showFile(const std::optional<motor::MotorSheet> &sheet)
{
    m_file = sheet;
    rebuild();
}

int MotorModel::differences() const
{
    if (!m_file || !m_facts)
        return 0;
    const auto rows = motor::compareMotors(drive::sheetOf(*m_facts), *m_file);
    return static_cast<int>(
        std::count_if(rows.begin(), rows.end(), [](const auto &row) { return row.differs; }));
}

int MotorModel::compared() const
{
    if (!m_file || !m_facts)
        return 0;
    const auto rows = motor::compareMotors(drive::sheetOf(*m_facts), *m_file);
    return static_cast<int>(std::count_if(
        rows.begin(), rows.end(), [](const auto &row) { return row.here && row.there; }));
}

void MotorModel::rebuild()
{
    beginResetModel();
    m_groups.clear();
    if (m_file)
        m_groups.push_back(comparisonGroup());
    for (const drive::StructureView &structure : m_structures) {
        m_groups.push_back(structureGroup(structure));
        if (structure.of == drive::StructureView::Of::Motor)
            m_groups.push_back(derivedGroup());
    }
    if (m_structures.empty() && m_file)
        m_groups.push_back(derivedGroup());
    endResetModel();
}

MotorModel::Group MotorModel::structureGroup(const drive::StructureView &structure) const
{
    Group group{QString::fromStdString(structure.name), structureText(structure.of), {}, {}, false};
    group.remark = !structure.bytes ? tr("not read yet")
        : structure.fields.empty()
        ? tr("%n byte(s) of an unknown form", nullptr, static_cast<int>(*structure.bytes))
        : structure.writable ? tr("can be written")
                             : tr("read-only");
    group.readOnly = !structure.writable;
    for (const drive::StructureField &field : structure.fields) {
        const FieldText text = fieldText(field.key);
        Row row{
            QString::fromStdString(field.key), text.name, {}, rawOf(field), {}, text.help, false};
        const QString unit = QString::fromStdString(field.unit);
        if (field.flags && field.names.empty())
            row.value = tr("nothing of it", "no flag is set");
        else if (!field.names.empty())
            row.value = valueNameTexts(field.names).join(QStringLiteral(", "));
        else if (const auto *words = std::get_if<std::string>(&field.value))
            row.value = deviceText(*words);
        else if (const auto *whole = std::get_if<std::int64_t>(&field.value))
            row.value = siText(static_cast<double>(*whole), unit);
        else if (const auto *real = std::get_if<double>(&field.value))
            row.value = siText(*real, unit);
        group.rows.push_back(std::move(row));
    }
    return group;
}

MotorModel::Group MotorModel::derivedGroup() const
{
    const auto sheet = m_facts ? drive::sheetOf(*m_facts) : motor::MotorSheet();
    const auto constants = [](const motor::MotorSheet &from) {
        return motor::motorConstants(from.parameters(), from.bus_v.value_or(0.0));
    };
    const auto torque = [](const motor::MotorSheet &from) -> std::optional<double> {
        if (!from.polePairs || !from.flux_wb || !from.nominalCurrent_a)
            return std::nullopt;
        return motor::ktOfFlux_nmpa(*from.flux_wb, *from.polePairs) * *from.nominalCurrent_a;
    };
    const auto board = constants(sheet);
    const motor::MotorSheet none;
    const motor::MotorSheet &file = m_file ? *m_file : none;
    const auto other = constants(file);
    const Derived rows[] = {
        {"flux", tr("Flux of the magnets \u03bb"),
            tr("\u03bb = Ke \u00b7 √2 / √3 / (p \u00b7 104.72 rad/s), p: pole pairs. "
               "Peak, linked with a phase."),
            QStringLiteral("Wb"), sheet.flux_wb, file.flux_wb},
        {"kt", tr("Torque constant Kt"), tr("Kt = 3/2 \u00b7 p \u00b7 \u03bb, per peak ampere."),
            QStringLiteral("N m/A"), board.kt_nmpa, other.kt_nmpa},
        {"ke", tr("Voltage constant Ke"),
            tr("Ke = \u03bb \u00b7 p \u00b7 104.72 rad/s \u00b7 √3 / √2: V rms between "
               "two terminals at 1000 rpm."),
            QStringLiteral("V/krpm"), board.ke_vrmsPerKrpm, other.ke_vrmsPerKrpm},
        {"kv", tr("Speed constant KV"),
            tr("KV = 1 / (√3 \u00b7 \u03bb \u00b7 p \u00b7 2\u03c0 / 60): rpm per volt, peak, "
               "between two terminals."),
            QStringLiteral("rpm/V"), board.kv_rpmpv, other.kv_rpmpv},
        {"tauQ", tr("Time constant, q"), tr("τq = Lq / Rs"), QStringLiteral("s"),
            board.timeConstantQ_s, other.timeConstantQ_s},
        {"tauD", tr("Time constant, d"), tr("τd = Ld / Rs"), QStringLiteral("s"),
            board.timeConstantD_s, other.timeConstantD_s},
        {"torque", tr("Torque at motor current"), tr("M = Kt \u00b7 I"), QStringLiteral("N m"),
            torque(sheet), torque(file)},
        {"baseSpeed", tr("Base speed"),
            tr("Where motor current and nominal bus voltage are used up without flux weakening: "
               "(Rs I + \u03c9 \u03bb)\u00b2 + (\u03c9 Lq I)\u00b2 = Vbus\u00b2 / 3."),
            QStringLiteral("rpm"), board.baseSpeed_rpm, other.baseSpeed_rpm},
    };
    Group group{
        QStringLiteral("derived"), tr("Derived values"), tr("computed from the motor"), {}, false};
    const auto shown = [](const std::optional<double> &value, const QString &unit) {
        return value ? siText(*value, unit) : QStringLiteral("\u2013");
    };
    for (const Derived &row : rows)
        group.rows.push_back({QLatin1String(row.key), row.name, shown(row.board, row.unit), {},
            m_file ? shown(row.file, row.unit) : QString(), row.help, false});
    return group;
}

MotorModel::Group MotorModel::comparisonGroup() const
{
    const auto sheet = m_facts ? drive::sheetOf(*m_facts) : motor::MotorSheet();
    Group group{QStringLiteral("comparison"), tr("Board and file"), {}, {}, false};
    group.remark = !m_facts  ? tr("no board to compare with")
        : differences() == 0 ? tr("no difference")
                             : tr("%n difference(s)", nullptr, differences());
    for (const motor::MotorComparison &row : motor::compareMotors(sheet, *m_file)) {
        const QString name = motorQuantityText(row.quantity);
        const auto &info = motor::motorQuantities()[static_cast<std::size_t>(row.quantity)];
        const QString raw = row.here ? floatText(*row.here, kBoardDigits) : QString();
        group.rows.push_back({QStringLiteral("compare %1").arg(int(row.quantity)), name,
            figureText(row.quantity, row.here), raw,
            (row.differs ? QStringLiteral("\u2260 ") : QString())
                + figureText(row.quantity, row.there),
            row.differs ? tr("The file has another value; in %1: %2", "unit, number")
                              .arg(QString::fromUtf8(info.unit),
                                  floatText(row.there.value_or(0.0), kBoardDigits))
                        : QString(),
            row.differs});
    }
    return group;
}

QModelIndex MotorModel::index(int row, int column, const QModelIndex &parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    return createIndex(row, column, parent.isValid() ? quintptr(parent.row()) : kGroup);
}

QModelIndex MotorModel::parent(const QModelIndex &child) const
{
    if (!child.isValid() || child.internalId() == kGroup)
        return {};
    return createIndex(static_cast<int>(child.internalId()), 0, kGroup);
}

int MotorModel::rowCount(const QModelIndex &parent) const
{
    if (!parent.isValid())
        return static_cast<int>(m_groups.size());
    if (parent.internalId() != kGroup || parent.column() != 0)
        return 0;
    return static_cast<int>(m_groups[static_cast<std::size_t>(parent.row())].rows.size());
}

const MotorModel::Row *MotorModel::rowAt(const QModelIndex &index) const
{
    if (!index.isValid() || index.internalId() == kGroup)
        return nullptr;
    return &m_groups[index.internalId()].rows[static_cast<std::size_t>(index.row())];
}

QVariant MotorModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Row *row = rowAt(index);
    if (row == nullptr) {
        const Group &group = m_groups[static_cast<std::size_t>(index.row())];
        if (role == KeyRole)
            return group.key;
        if (role == Qt::DisplayRole)
            return index.column() == NameColumn ? group.name
                : index.column() == ValueColumn ? group.remark
                                                : QString();
        if (role == Qt::ToolTipRole && group.readOnly)
            return tr("Built into the firmware: it is changed in the firmware's project, not over "
                      "the link.");
        if (role == Qt::FontRole && index.column() == NameColumn)
            return inBold({});
        return {};
    }
    const QString *const texts[] = {&row->name, &row->value, &row->file, &row->raw};
    if (role == Qt::DisplayRole)
        return *texts[index.column()];
    if (role == Qt::ToolTipRole) {
        QString text = row->help;
        if (index.column() == ValueColumn && row->value.size() > 24) // flags may not fit
            text = row->value + (text.isEmpty() ? QString() : QStringLiteral("\n") + text);
        return text.isEmpty() ? QVariant() : QVariant(plainToolTip(text));
    }
    if (role == KeyRole)
        return row->key;
    if (role == DiffersRole)
        return row->differs;
    if (role == Qt::FontRole && row->differs)
        return inBold({});
    if (role == Qt::TextAlignmentRole && index.column() == RawColumn)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant MotorModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case NameColumn:
        return tr("Field");
    case ValueColumn:
        return tr("On the board");
    case RawColumn:
        return tr("Raw");
    case FileColumn:
        return tr("In the file");
    default:
        return {};
    }
}

} // namespace widgets
