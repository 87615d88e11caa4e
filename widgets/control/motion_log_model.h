// MotionLogModel: what was asked of the motors since the program began, one row an act, newest last, over every
// connection. When it is full the oldest acts go, and are counted. Words of the log are translated here, in its files
// they are not.
#pragma once

#include "session/files/motion_log_file.h"
#include "widgets/base/row_table.h"

namespace widgets {

class MotionLogModel : public RowTable {
    Q_OBJECT
public:
    enum Column {
        TimeColumn,
        MotorColumn,
        ActColumn,
        DetailColumn,
        OutcomeColumn,
        SourceColumn,
        BytesColumn
    };
    static constexpr std::size_t kMost = 100000; ///< acts
    static constexpr std::size_t kLeftOutAtOnce = 1000; ///< acts: to shift the others costs time

    explicit MotionLogModel(QObject *parent = nullptr);

    void accept(const drive::MotionEntry &entry, const QDateTime &now);
    const std::vector<session::LoggedMotion> &log() const { return m_log; }
    std::size_t leftOut() const { return m_leftOut; } ///< acts before the first row
    QByteArray text() const; ///< as a file has it
    static QString who(); ///< the user and program of the acts, as a file has it
    /// Rows as text with tabs between, for the clipboard.
    QString copyText(const QList<int> &rows) const;

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

private:
    std::size_t rowsHeld() const override { return m_log.size(); }
    void leaveOutOldest();
    QString cell(const session::LoggedMotion &one, int column) const;

    std::vector<session::LoggedMotion> m_log;
    session::WallClock m_clock;
    std::size_t m_leftOut = 0;
};

} // namespace widgets
