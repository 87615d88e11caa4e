#include "widgets/scope/cursor_table.h"

#include "widgets/base/device_text.h"
#include "widgets/base/reading_text.h"
#include "widgets/scope/view.h"

#include <algorithm>

namespace widgets {

CursorTable::CursorTable(const ScopeView &scope, const capture::Capture &capture, QObject *parent)
    : QAbstractTableModel(parent)
    , m_scope(scope)
    , m_capture(capture)
{
    refresh();
    connect(&scope.cursors(), &Cursors::changed, this, &CursorTable::refresh);
    connect(&scope, &ScopeView::drawn, this, &CursorTable::refresh);
}

int CursorTable::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : kRows; }

int CursorTable::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
}

QVariant CursorTable::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.column() >= columnCount() || index.row() >= kRows)
        return {};
    const Column &column = m_columns[std::size_t(index.column())];
    if (role == Qt::DisplayRole)
        return column.text[index.row()];
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant CursorTable::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Vertical) {
        static constexpr const char16_t *kNames[kRows] = {u"A", u"B", u"\u0394"};
        const bool known = section >= 0 && section < kRows;
        return known && role == Qt::DisplayRole ? QString::fromUtf16(kNames[section]) : QVariant();
    }
    if (section < 0 || section >= columnCount())
        return {};
    const Column &column = m_columns[std::size_t(section)];
    if (role == Qt::DisplayRole)
        return column.name;
    if (role == Qt::ForegroundRole && section > 0)
        return m_scope.colorOf(column.channel);
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QString CursorTable::asText() const
{
    QString text = m_scope.cursors().pair().name;
    for (const Column &column : m_columns)
        text += QLatin1Char('\t') + column.name;
    for (int row = 0; row < kRows; ++row) {
        text += QLatin1Char('\n') + headerData(row, Qt::Vertical, Qt::DisplayRole).toString();
        for (const Column &column : m_columns)
            text += QLatin1Char('\t') + column.text[row];
    }
    const CursorPair &pair = m_scope.cursors().pair();
    text += QStringLiteral("\n1/\u0394t\t") + inverseTime(pair.b - pair.a, m_scope.locale());
    return text + QLatin1Char('\n');
}

CursorTable::Column CursorTable::timeColumn() const
{
    const CursorPair &pair = m_scope.cursors().pair();
    const double origin = m_scope.time().origin();
    const QLocale locale = m_scope.locale();
    return {0, tr("Time"),
        {exactTime(pair.a - origin, locale), exactTime(pair.b - origin, locale),
            exactTime(pair.b - pair.a, locale)}};
}

CursorTable::Column CursorTable::columnOf(capture::ChannelId channel) const
{
    const auto info = m_capture.info(channel);
    if (!info)
        return {channel, {}, {}};
    const CursorPair &pair = m_scope.cursors().pair();
    const std::optional<double> a = m_capture.valueAt(channel, pair.a);
    const std::optional<double> b = m_capture.valueAt(channel, pair.b);
    const double step = m_scope.readingStepOf(channel);
    const QString unit = QString::fromStdString(info->unit);
    const QLocale locale = m_scope.locale();
    const QString difference =
        a && b ? readingText(*b - *a, step, unit, locale) : QStringLiteral("\u2013");
    return {channel, deviceText(info->name),
        {readingText(a, step, unit, locale), readingText(b, step, unit, locale), difference}};
}

void CursorTable::refresh()
{
    std::vector<Column> now{timeColumn()};
    for (const capture::ChannelId channel : m_scope.channels())
        now.push_back(columnOf(channel));
    const auto sameHeading = [](const Column &one, const Column &other) {
        return one.channel == other.channel && one.name == other.name;
    };
    if (!std::equal(now.begin(), now.end(), m_columns.begin(), m_columns.end(), sameHeading)) {
        beginResetModel();
        m_columns = std::move(now);
        endResetModel();
    } else if (now != m_columns) {
        m_columns = std::move(now);
        Q_EMIT dataChanged(index(0, 0), index(kRows - 1, columnCount() - 1), {Qt::DisplayRole});
    }
}

} // namespace widgets
