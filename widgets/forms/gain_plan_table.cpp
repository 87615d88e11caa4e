#include "widgets/forms/gain_plan_table.h"

#include "widgets/base/look/section_head.h"
#include "widgets/base/si_text.h"
#include "widgets/base/value_text.h"
#include "widgets/forms/gain_texts.h"

#include <QHeaderView>

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

using motor::GainId;

enum Column { NameColumn, BoardColumn, NewColumn, RealColumn, RoundingColumn, RoomColumn, Columns };

} // namespace

GainPlanTable::GainPlanTable(QWidget *parent)
    : QTableWidget(int(motor::kGainIds), Columns, parent)
{
    setObjectName(QStringLiteral("labGains"));
    setAccessibleName(tr("Planned gains"));
    setHorizontalHeaderLabels(
        {tr("Gain"), tr("Board"), tr("New"), tr("At the motor"), tr("Rounding"), tr("Room")});
    horizontalHeaderItem(RoomColumn)
        ->setToolTip(tr("How many times larger the number could be before it, or its product with "
                        "the largest error, overflows."));
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
    verticalHeader()->setMinimumSectionSize(fontMetrics().height() + 2);
    fixColumns();
    horizontalHeader()->setStretchLastSection(true);
    horizontalHeader()->setHighlightSections(false);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setTabKeyNavigation(false);
    setAlternatingRowColors(true);
    setShowGrid(false);
    for (int row = 0; row < rowCount(); ++row)
        for (int column = 0; column < Columns; ++column)
            setItem(row, column, new QTableWidgetItem);
}

/// As wide as the longest texts: columns that followed the numbers would jump with each turn of a slider.
void GainPlanTable::fixColumns()
{
    const QFontMetrics plain(font()), bold(inBold(font()));
    const int room = 2 * plain.averageCharWidth();
    const QString fraction =
        QStringLiteral("-%1/2^%2")
            .arg(QString::number(motor::kMaxNumerator), QString::number(motor::kMaxExponent));
    const int texts[] = {plain.horizontalAdvance(QStringLiteral("SPEED_KP")),
        plain.horizontalAdvance(fraction), bold.horizontalAdvance(fraction),
        plain.horizontalAdvance(QStringLiteral("0.1234 A/(rad/s)")),
        plain.horizontalAdvance(QStringLiteral("-0.01 %")),
        plain.horizontalAdvance(QStringLiteral("1000\u00d7"))};
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    int all = 2 * frameWidth();
    for (int column = 0; column < Columns; ++column) {
        const int head = plain.horizontalAdvance(horizontalHeaderItem(column)->text());
        const int width = std::max(texts[column], head) + room;
        setColumnWidth(column, width);
        all += width;
    }
    setMinimumWidth(all);
}

void GainPlanTable::showPlan(const motor::GainPlan &plan, const motor::PerGain<HeldGain> &board)
{
    for (std::size_t i = 0; i < motor::kGainIds; ++i) {
        const auto id = static_cast<GainId>(i);
        const int row = static_cast<int>(i);
        const auto put = [this, row](int column, const QString &text, bool strong = false) {
            QTableWidgetItem *cell = item(row, column);
            cell->setText(text);
            cell->setTextAlignment(
                (column == NameColumn ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
            cell->setFont(strong ? inBold(font()) : font());
        };
        const HeldGain &held = board[i];
        const motor::PlannedGain *gain = plan.find(id);
        put(NameColumn, QLatin1String(gainRegister(id)));
        put(BoardColumn,
            held.known() ? fractionText({int(*held.numerator), *held.exponent})
                         : QStringLiteral("\u2013"));
        if (!gain) {
            put(NewColumn, tr("stays"));
            for (const int column : {RealColumn, RoundingColumn, RoomColumn})
                put(column, {});
            continue;
        }
        const motor::Quantised &kept = gain->quantised;
        const bool changes =
            held.numerator != kept.gain.numerator || held.exponent != kept.gain.exponent;
        put(NewColumn, fractionText(kept.gain), changes);
        put(RealColumn, gainWithUnit(gain->real, gainUnit(id)));
        put(RoundingColumn,
            tr("%1 %").arg(numberText(std::round(1e4 * kept.error) / 100.0 + 0.0, 2)));
        const double room = std::min(kept.numeratorMargin, kept.productMargin);
        put(RoomColumn,
            std::isfinite(room) ? QStringLiteral("%1\u00d7").arg(significantText(room, 2))
                                : QString());
    }
}

} // namespace widgets
