// The stations of the tour, one a row: which, how it stands, and what came of it.
#pragma once

#include <QAbstractTableModel>
#include <QString>

#include <array>

namespace widgets {

class TourSteps : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Step { Check, Windings, Mechanics, Response, Gains, Proof, kSteps };
    enum class State : std::uint8_t { Waits, Runs, Done, Unclear, Impossible, Ended };
    enum Column { StepColumn, StateColumn, ResultColumn, kColumns };

    using QAbstractTableModel::QAbstractTableModel;

    void set(Step step, State state, const QString &result = {});
    State state(Step step) const { return m_rows[step].state; }
    void clear(); ///< all wait

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        State state = State::Waits;
        QString result;
        bool operator==(const Row &) const = default;
    };
    std::array<Row, kSteps> m_rows{};
};

} // namespace widgets
