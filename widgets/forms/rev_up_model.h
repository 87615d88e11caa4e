// RevUpModel: the stages of a sensorless start as a table. The one truth behind the table and the picture of the rev-up
// form: both show these stages and change nothing else. It keeps none of its own: they are the bytes of one register as
// a user wants them, and every change is a pending edit of that register.
#pragma once

#include "motor/rev_up.h"
#include "widgets/registers/model.h"

#include <QAbstractTableModel>

namespace widgets {

/// What the stages are judged and shown by.
struct RevUpFacts {
    double ampsPerDigit = 0.0; ///< 0: not known, currents are shown in digits only
    bool sixStep = false; ///< a pulse stands where the current does
    double boardSpeed_rpm = 0.0; ///< its highest; the user's own limit may be lower
    double speedStep_rpm = 1.0; ///< what the drive keeps of a speed
    QString angleSensor; ///< the drive starts by it and runs no stages; empty: it does
    motor::RevUpLimits limits;
    bool operator==(const RevUpFacts &) const = default;
};

class RevUpModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column {
        DurationColumn,
        SpeedColumn,
        CurrentColumn, ///< A; empty where the scale is not known
        DigitsColumn, ///< the same as the register holds it, or the pulse
        TorqueColumn, ///< needed and given; only to be read
        ColumnCount
    };

    /// @param registers  outlives it
    explicit RevUpModel(RegisterModel &registers, QObject *parent = nullptr);

    void setFacts(const RevUpFacts &facts);
    const RevUpFacts &facts() const { return m_facts; }

    std::optional<catalog::RegisterId> registerId() const { return m_id; }
    /// Why there are no stages, one sentence; empty if there are.
    QString unavailable() const;
    /// Five, or none; as the user wants them.
    const motor::RevUp &stages() const { return m_stages; }
    int used() const { return static_cast<int>(motor::usedStages(m_stages)); }
    bool editable() const { return m_editable; }
    motor::RevUpBounds bounds() const;
    /// What one digit of the register's current is worth on screen: A, or 1 where it is shown as it is.
    double shownPerDigit() const;
    QString currentName() const; ///< of what the digits are: Iq or the pulse
    QString currentUnit() const; ///< "A" or nothing
    const std::vector<motor::RevUpFinding> &findings() const { return m_findings; }

    // All changes make a pending edit, or return false and change nothing.
    bool setStages(const motor::RevUp &stages);
    bool setStage(int row, const motor::RevUpStage &stage); ///< as it is, bounds are the caller's
    bool addAfter(int row);
    bool remove(int row);
    bool move(int row, int by);

    /// How text in a column is read. Columns that can be edited only.
    EntryRules rulesOf(int column) const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(
        int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;

Q_SIGNALS:
    void stagesChanged(); ///< stages, facts, or whether they can be edited
    void adjusted(const QString &sentence); ///< what was typed is not what the register can hold

private:
    void resolve();
    void adoptRegister();
    void judge();
    bool differs(const QModelIndex &index) const;
    bool marked(const QModelIndex &index) const;
    QString shown(int row, int column) const;
    QString torque(int row) const;
    QString toolTip(const QModelIndex &index) const;

    RegisterModel &m_registers;
    std::optional<catalog::RegisterId> m_id;
    RevUpFacts m_facts;
    motor::RevUp m_stages;
    motor::RevUp m_before; ///< what the board held when they began to differ
    bool m_editable = false;
    std::vector<motor::RevUpFinding> m_findings;
};

} // namespace widgets
