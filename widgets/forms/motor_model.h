// MotorModel: what a board says of its motor and its drive, what follows from it, and a file beside it, as a tree of
// groups. It only shows; where its values come from is the form's business.
#pragma once

#include "drive/motor_view.h"
#include "motor/sheet.h"

#include <QAbstractItemModel>

#include <optional>
#include <vector>

namespace widgets {

class MotorModel : public QAbstractItemModel {
    Q_OBJECT
public:
    /// What is compared stands side by side.
    enum Column { NameColumn, ValueColumn, FileColumn, RawColumn, ColumnCount };
    enum Role {
        KeyRole = Qt::
            UserRole, ///< of a row, not translated: "rated flux"; of a group: its structure's name
        DiffersRole, ///< bool: board and file have another value
    };

    using QAbstractItemModel::QAbstractItemModel;

    void showBoard(const drive::MotorFacts &facts, std::vector<drive::StructureView> structures);
    void clearBoard();
    /// A file's description beside the board's; nothing takes it away.
    void showFile(const std::optional<motor::MotorSheet> &sheet);
    bool hasFile() const { return m_file.has_value(); }
    int differences() const; ///< figures that board and file both have, with other values
    int compared() const; ///< figures that both have

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &child) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex & = {}) const override { return ColumnCount; }
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(
        int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Row {
        QString key, name, value, raw, file, help;
        bool differs = false;
    };
    struct Group {
        QString key, name, remark;
        std::vector<Row> rows;
        bool readOnly = false; ///< on the board
    };

    void rebuild();
    Group structureGroup(const drive::StructureView &structure) const;
    Group derivedGroup() const;
    Group comparisonGroup() const;
    const Row *rowAt(const QModelIndex &index) const;

    std::vector<Group> m_groups;
    std::optional<drive::MotorFacts> m_facts;
    std::vector<drive::StructureView> m_structures;
    std::optional<motor::MotorSheet> m_file;
};

} // namespace widgets
