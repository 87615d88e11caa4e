// The stations of the tour, one a row: which, how it stands, and what came of it.
#pragma once

#include "widgets/base/row_table.h"

#include <QString>

#include <array>

namespace widgets {

class TourSteps : public RowTable {
    Q_OBJECT
public:
    enum Step { Check, Windings, Mechanics, Response, Gains, Proof, kSteps };
    enum class State : std::uint8_t { Waits, Runs, Done, Unclear, Impossible, PassedOver, Ended };
    enum Column { StepColumn, StateColumn, ResultColumn };

    explicit TourSteps(QObject *parent = nullptr);

    void set(Step step, State state, const QString &result = {});
    State state(Step step) const { return m_rows[step].state; }
    void clear(); ///< all wait

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

private:
    std::size_t rowsHeld() const override { return kSteps; }

    struct Row {
        State state = State::Waits;
        QString result;
        bool operator==(const Row &) const = default;
    };
    std::array<Row, kSteps> m_rows{};
};

} // namespace widgets
