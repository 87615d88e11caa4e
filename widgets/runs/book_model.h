// The runs of a run book as a table, the newest first. Notes are typed into it, and stars are ticked; it asks for both
// to be written.
#pragma once

#include "session/files/run_book.h"
#include "widgets/base/row_table.h"

namespace widgets {

class RunBookModel : public RowTable {
    Q_OBJECT
public:
    enum Column { RunColumn, TimeColumn, ExperimentColumn, GainsColumn, ResultColumn, NoteColumn };

    explicit RunBookModel(QObject *parent = nullptr);

    void setRuns(std::vector<session::Run> runs); ///< by their number
    void add(const session::Run &run);
    const session::Run &run(int row) const { return m_runs[m_runs.size() - 1 - std::size_t(row)]; }

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

Q_SIGNALS:
    void annotated(int number, const QString &note, bool starred);

private:
    std::size_t rowsHeld() const override { return m_runs.size(); }

    std::vector<session::Run> m_runs; ///< by their number
};

} // namespace widgets
