#include "widgets/measuring/math_table.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/base/reading_text.h"
#include "widgets/measuring/math_traces.h"
#include "widgets/scope/view.h"

#include <QPixmap>

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {
constexpr int kSwatch = 12; ///< pixels
constexpr double kDigits = 1e4; ///< of a value that is not drawn
} // namespace

MathTable::MathTable(MathChannels &channels, const capture::Capture &capture,
    const ScopeView &scope, QObject *parent)
    : RowTable(parent, {tr("Name"), tr("Formula"), tr("Last value")})
    , m_channels(channels)
    , m_capture(capture)
    , m_scope(scope)
    , m_entries(channels.entries())
{
    connect(&channels, &MathChannels::changed, this, &MathTable::follow);
}

void MathTable::follow()
{
    replace(m_entries, m_channels.entries(),
        [](const auto &one, const auto &other) { return one.formula.name == other.formula.name; });
}

void MathTable::refresh() { cellsChanged(ValueColumn, ValueColumn); }

int MathTable::rowOf(const QString &name) const
{
    const auto found = std::find_if(m_entries.begin(), m_entries.end(),
        [&name](const MathChannels::Entry &entry) { return entry.formula.name == name; });
    return found == m_entries.end() ? -1 : static_cast<int>(found - m_entries.begin());
}

QString MathTable::valueText(const MathChannels::Entry &entry) const
{
    if (entry.channel == 0)
        return tr("waits for its signals");
    const auto value = m_capture.lastValue(entry.channel);
    if (!value)
        return tr("no value yet");
    double step = m_scope.readingStepOf(entry.channel);
    if (!(step > 0.0))
        step = tickStep(std::max(std::abs(*value), 1e-6), int(kDigits));
    return readingText(value, step, entry.unit, m_scope.locale());
}

QVariant MathTable::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const MathChannels::Entry &its = entry(index.row());
    if (role == Qt::CheckStateRole && index.column() == NameColumn)
        return static_cast<int>(its.formula.shown ? Qt::Checked : Qt::Unchecked);
    if (role == Qt::DecorationRole && index.column() == NameColumn) {
        QPixmap swatch(kSwatch, kSwatch);
        const QColor color = MathTraces::colorOf(m_scope, its.channel);
        swatch.fill(color.isValid() ? color : Qt::transparent);
        return swatch;
    }
    if (role == Qt::ToolTipRole && index.column() == NameColumn)
        return tr("The tick draws it. It is computed either way.");
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case NameColumn:
        return its.formula.name;
    case FormulaColumn:
        return its.formula.text;
    default:
        return valueText(its);
    }
}

bool MathTable::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || index.row() >= rowCount() || role != Qt::CheckStateRole
        || index.column() != NameColumn)
        return false;
    m_channels.setShown(QString(entry(index.row()).formula.name), value.toInt() == Qt::Checked);
    return true;
}

Qt::ItemFlags MathTable::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = RowTable::flags(index);
    if (index.isValid() && index.column() == NameColumn)
        flags |= Qt::ItemIsUserCheckable;
    return flags;
}

} // namespace widgets
