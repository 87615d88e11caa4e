#include "widgets/lab/tour_steps.h"

#include "widgets/base/device_text.h"

namespace widgets {
namespace {

QString nameOf(int step)
{
    switch (step) {
    case TourSteps::Check:
        return TourSteps::tr("1. Check");
    case TourSteps::Windings:
        return TourSteps::tr("2. Rs, L, flux");
    case TourSteps::Mechanics:
        return TourSteps::tr("3. Inertia, friction");
    case TourSteps::Response:
        return TourSteps::tr("4. Response");
    case TourSteps::Gains:
        return TourSteps::tr("5. Gains");
    case TourSteps::Proof:
        return TourSteps::tr("6. Proof");
    default:
        return {};
    }
}

QString stateText(TourSteps::State state)
{
    switch (state) {
    case TourSteps::State::Waits:
        return TourSteps::tr("waits");
    case TourSteps::State::Runs:
        return TourSteps::tr("\u25b6 runs");
    case TourSteps::State::Done:
        return TourSteps::tr("\u2713 done");
    case TourSteps::State::Unclear:
        return TourSteps::tr("? not conclusive");
    case TourSteps::State::Impossible:
        return TourSteps::tr("\u2013 not possible here");
    case TourSteps::State::Ended:
        return TourSteps::tr("\u2716 ended");
    }
    return {};
}

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
        return index.column() == StepColumn ? nameOf(index.row())
            : index.column() == StateColumn ? stateText(row.state)
                                            : row.result;
    if (role == Qt::ToolTipRole && index.column() == ResultColumn && !row.result.isEmpty())
        return plainToolTip(row.result);
    return {};
}

} // namespace widgets
