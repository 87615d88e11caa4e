#include "widgets/lab/tour_steps.h"

#include "widgets/base/device_text.h"

namespace widgets {
namespace {

/// In the order of TourSteps::Step.
constexpr std::array kStations{QT_TRANSLATE_NOOP("widgets::TourSteps", "1. Check"),
    QT_TRANSLATE_NOOP("widgets::TourSteps", "2. Rs, L, flux"),
    QT_TRANSLATE_NOOP("widgets::TourSteps", "3. Inertia, friction"),
    QT_TRANSLATE_NOOP("widgets::TourSteps", "4. Response"),
    QT_TRANSLATE_NOOP("widgets::TourSteps", "5. Gains"),
    QT_TRANSLATE_NOOP("widgets::TourSteps", "6. Proof")};

/// In the order of TourSteps::State.
constexpr std::array kStates{QT_TRANSLATE_NOOP("widgets::TourSteps", "waits"),
    QT_TRANSLATE_NOOP("widgets::TourSteps", "\u25b6 runs"),
    QT_TRANSLATE_NOOP("widgets::TourSteps", "\u2713 done"),
    QT_TRANSLATE_NOOP("widgets::TourSteps", "? not conclusive"),
    QT_TRANSLATE_NOOP("widgets::TourSteps", "\u2013 not possible here"),
    QT_TRANSLATE_NOOP("widgets::TourSteps", "\u2013 passed over"),
    QT_TRANSLATE_NOOP("widgets::TourSteps", "\u2716 ended")};

} // namespace

TourSteps::TourSteps(QObject *parent)
    : RowTable(parent, {tr("Station"), tr("State"), tr("What came of it")})
{
}

void TourSteps::set(Step step, State state, const QString &result)
{
    const Row row{state, result};
    if (m_rows[step] == row)
        return;
    m_rows[step] = row;
    Q_EMIT dataChanged(index(step, 0), index(step, ResultColumn));
}

void TourSteps::clear()
{
    for (int step = 0; step < kSteps; ++step)
        set(Step(step), State::Waits);
}

QVariant TourSteps::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= kSteps)
        return {};
    const Row &row = m_rows[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole)
        return index.column() == StepColumn ? tr(kStations[std::size_t(index.row())])
            : index.column() == StateColumn ? tr(kStates[static_cast<std::size_t>(row.state)])
                                            : row.result;
    if (role == Qt::ToolTipRole && index.column() == ResultColumn && !row.result.isEmpty())
        return plainToolTip(row.result);
    return {};
}

} // namespace widgets
