// What the cells of a RegisterModel show: values in both unit systems, access and help, and the words around them.
#include "widgets/base/device_text.h"
#include "widgets/base/look/section_head.h"
#include "widgets/base/register_texts.h"
#include "widgets/base/value_text.h"
#include "widgets/registers/model.h"

#include <QApplication>
#include <QLocale>
#include <QPalette>

namespace widgets {
namespace {

/// What a register is, and what a digit of it is worth where its unit does not say that.
QString helpOf(const catalog::RegisterInfo &info, const catalog::Scale &scale)
{
    QStringList parts{registerHelpText(info), unitHelp(scale.unit)};
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" \u00b7 "));
}

} // namespace

QVariant RegisterModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    if (const Row *row = rowAt(index))
        return cell(*row, index.column(), role);
    if (role == Qt::DisplayRole && index.column() == NameColumn)
        return deviceText(m_groups[static_cast<std::size_t>(index.row())].name);
    if (role == Qt::FontRole)
        return inBold(QApplication::font());
    return {};
}

QVariant RegisterModel::cell(const Row &row, int column, int role) const
{
    const bool ofValue = column == ValueColumn || column == RawColumn || column == HexColumn;
    switch (role) {
    case Qt::DisplayRole:
        return display(row, column);
    case Qt::EditRole:
        return editText(row, column);
    case Qt::AccessibleDescriptionRole:
        return editSentence(row);
    case Qt::BackgroundRole:
        return ofValue ? editBackground(row) : QVariant();
    case EditStateRole:
        return static_cast<int>(editState(row.id));
    case Qt::ToolTipRole:
        return toolTip(row);
    case Qt::TextAlignmentRole:
        return ofValue ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::ForegroundRole:
        if (ofValue && editBackground(row).isValid())
            return QColor(Qt::black);
        if (ofValue && (row.stale || row.known != Known::Value))
            return QApplication::palette().brush(QPalette::Disabled, QPalette::Text);
        return {};
    case IdRole:
        return quint32(row.id);
    case SearchRole: {
        const QString name = QString::fromStdString(row.info->name);
        QStringList words{name, QString(name).remove(QLatin1Char('_')),
            QString::fromStdString(row.info->help), registerHelpText(*row.info),
            QString::fromStdString(row.info->group), registerGroupText(row.info->group)};
        for (const std::string &alias : row.info->aliases)
            words.append(QString::fromStdString(alias));
        return words.join(QLatin1Char('\n'));
    }
    case StaleRole:
        return row.stale || row.known != Known::Value;
    case PinnedRole:
        return m_pinned.contains(QString::fromStdString(row.info->name), Qt::CaseInsensitive);
    default:
        return {};
    }
}

/// Why there is no value to show, or the value.
QString RegisterModel::valueText(const Row &row) const
{
    if (!row.info->readable() && row.info->writable())
        return tr("write only", "a register that cannot be read, only written");
    if (!row.info->readable())
        return tr("scope only", "a register that cannot be read, only recorded");
    switch (row.known) {
    case Known::Nothing:
        return {};
    case Known::NotSupported:
        return tr("not supported");
    case Known::Refused:
        return tr("refused", "the board refused to read a register");
    case Known::Value:
        break;
    }
    return shownText(*row.info, row.value, row.scale);
}

QString RegisterModel::roundedText(catalog::RegisterId id, int column, int digits) const
{
    const Row *row = find(id);
    const Edit *edit = editOf(id);
    // What the user wants is shown as it was typed.
    const bool wanted = edit && edit->state != EditState::Verified;
    if (!row || wanted || row->known != Known::Value || !std::holds_alternative<double>(row->value))
        return {};
    if (column == ValueColumn)
        return shownText(*row->info, row->value, row->scale, digits);
    return column == RawColumn ? rawText(catalog::onWire(*row->info, row->value), digits)
                               : QString();
}

QVariant RegisterModel::display(const Row &row, int column) const
{
    if (column == NameColumn)
        return deviceText(m_catalog->nameOf(row.id));
    if (column == AccessColumn)
        return accessText(row);
    if (column == HelpColumn)
        return registerHelpText(*row.info);
    const Edit *edit = editOf(row.id);
    const bool wanted = edit && edit->state != EditState::Verified;
    if (column == ValueColumn)
        return wanted ? shownText(*row.info, edit->wanted, row.scale) : valueText(row);
    if (!wanted && (!row.info->readable() || row.known != Known::Value))
        return QString();
    const catalog::Value value = catalog::onWire(*row.info, wanted ? edit->wanted : row.value);
    return column == HexColumn ? hexText(row.info->type, value) : rawText(value);
}

QString RegisterModel::accessText(const Row &row) const
{
    if (row.info->readable())
        return row.info->writable() ? tr("RW", "access: read and write") : tr("R", "access: read");
    return row.info->writable() ? tr("W", "access: write") : tr("scope", "access: recorded only");
}

QString RegisterModel::details(catalog::RegisterId id) const
{
    const Row *row = find(id);
    if (!row)
        return {};
    QStringList parts{deviceText(m_catalog->nameOf(id)), accessText(*row)};
    const auto rules = rulesOf(id);
    const bool number =
        row->info->meaning == catalog::Meaning::Number && catalog::isInteger(row->info->type);
    if (rules && number) {
        const int decimals = decimalsFor(row->scale.factor);
        const QString unit = unitText(row->scale.unit);
        const QString range =
            tr("%1 to %2", "least and greatest value")
                .arg(numberText(rules->limits.least * row->scale.factor, decimals),
                    numberText(rules->limits.greatest * row->scale.factor, decimals));
        parts.append(
            unit.isEmpty() || unit == QLatin1String("-") ? range : range + QChar(0x202f) + unit);
    }
    const QString head = parts.join(QStringLiteral(" \u00b7 "));
    const QString help = helpOf(*row->info, row->scale);
    return help.isEmpty() ? head : head + QLatin1Char('\n') + help;
}

QVariant RegisterModel::editText(const Row &row, int column) const
{
    const Edit *edit = editOf(row.id);
    const auto rules = rulesOf(row.id);
    const bool wanted = edit && edit->state != EditState::Verified;
    if (column == NameColumn || !rules || (!wanted && row.known != Known::Value))
        return QString();
    const catalog::Value &value = wanted ? edit->wanted : row.value;
    return column == RawColumn ? rawEntryText(catalog::onWire(*rules->info, value))
                               : shownEntryText(value, *rules);
}

QString RegisterModel::toolTip(const Row &row) const
{
    const QString name = deviceToolTip(m_catalog->nameOf(row.id));
    const QString help = helpOf(*row.info, row.scale).toHtmlEscaped();
    QString state;
    if (row.known == Known::Value && row.stale)
        state = tr("This value is old: it is not being read.");
    else if (row.known == Known::NotSupported)
        state = tr("This board does not have it.");
    const bool drawable = row.info->readable() || row.info->streaming != catalog::Streaming::Polled;
    const QString drag = !drawable ? QString()
        : row.info->streaming == catalog::Streaming::Polled
        ? tr(
            "Drag it to the scope or press Enter: it is drawn at the rate at which it can be read.")
        : tr("Drag it to the scope or press Enter: it is recorded at the full control rate.");
    QString all;
    if (row.info->meaning == catalog::Meaning::Flags && row.known == Known::Value)
        all = shownText(*row.info, row.value, row.scale).toHtmlEscaped();
    QStringList lines{
        QStringLiteral("<b>%1</b>").arg(name), help, editToolTip(row), all, drag, state};
    lines.removeAll(QString());
    return lines.join(QStringLiteral("<br>"));
}

QVariant RegisterModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole
        && (section == ValueColumn || section == RawColumn || section == HexColumn))
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case NameColumn:
        return tr("Register");
    case ValueColumn:
        return m_believed ? tr("Value")
                          : tr("Last value", "heading of values that are not read any more");
    case RawColumn:
        return tr("Raw", "the number as it is on the wire");
    case HexColumn:
        return tr("Hex", "the number as it is on the wire, in hexadecimal digits");
    case AccessColumn:
        return tr("Access");
    case HelpColumn:
        return tr("Help", "what a register is");
    default:
        return {};
    }
}

} // namespace widgets
