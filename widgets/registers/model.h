// RegisterModel: the window's only truth about the registers of a board: what exists, its newest value, how old that
// is, what the user wants it to be and how a write of it ended. A tree of groups, the pinned registers first; tables,
// forms and read-outs are views of it. It asks for nothing by itself: which registers are polled is decided by what is
// visible.
#pragma once

#include "drive/event.h"
#include "widgets/base/device.h"
#include "widgets/registers/entry.h"

#include <QAbstractItemModel>
#include <QSet>

#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

namespace widgets {

class RegisterModel : public QAbstractItemModel {
    Q_OBJECT
public:
    /// The value in the unit people read; as digits and in hexadecimal, as on the wire; what may be done; what it is.
    enum Column {
        NameColumn,
        ValueColumn,
        RawColumn,
        HexColumn,
        AccessColumn,
        HelpColumn,
        ColumnCount
    };
    enum Role {
        IdRole = Qt::UserRole, ///< quint32; invalid for groups
        SearchRole, ///< name, aliases and help, in English too, in one text
        StaleRole, ///< bool
        PinnedRole, ///< bool
        EditStateRole, ///< EditState as int
    };
    enum class EditState : std::uint8_t {
        None, ///< shows what the board holds
        Pending, ///< typed, not written
        Sending,
        Verified, ///< written and read back, a moment ago
        Unproved, ///< taken by the board a moment ago, and not read back, or shown only later
        Refused, ///< was not written; the reason is in the tool tip
    };

    explicit RegisterModel(QObject *parent = nullptr);

    /// Replaces the contents. Registers that can neither be read nor be streamed are left out.
    void setCatalog(std::shared_ptr<const catalog::Catalog> catalog, int motor);
    std::shared_ptr<const catalog::Catalog> catalog() const { return m_catalog; }
    /// By name or alias, of the motor that is shown; empty if the board has no such register.
    std::optional<catalog::RegisterId> idOf(std::string_view name) const;

    /// Takes values in; `now` is any monotonic clock, the same as refresh() gets.
    void accept(const std::vector<drive::Reading> &readings, Milliseconds now);
    /// Marks values older than 3 periods as stale. A register's period is the one wished for, or the one at which its
    /// values really come where the link is slower.
    void refresh(Milliseconds now);
    /// False: nothing is known to be current any more, whatever its age (a link that is silent).
    void setBelieved(bool believed);

    /// Newest value in the unit people read; empty if there is none or it is stale.
    std::optional<double> shownValue(catalog::RegisterId id) const;
    /// The same as the board has it; also what is no number.
    std::optional<catalog::Value> current(catalog::RegisterId id) const;
    QString text(catalog::RegisterId id) const; ///< with unit; a dash where shownValue() is empty
    bool supported(catalog::RegisterId id) const; ///< false once the board has said it is not
    bool pollable(catalog::RegisterId id) const;

    // Edits. They belong to the board, not to the motor that is shown, and go with the board.

    /// What bounds the set-points of each motor.
    void setMotorLimits(std::vector<drive::MotorLimits> limits) { m_limits = std::move(limits); }
    /// How text for this register is read; empty if it cannot be written.
    std::optional<EntryRules> rulesOf(catalog::RegisterId id) const;
    bool editable(catalog::RegisterId id, int column) const;
    Result<catalog::Value, EntryError> readEntry(
        catalog::RegisterId id, int column, const QString &text) const;
    /// Wants a value; the one that the board holds takes the wish back. False if it must not be written.
    bool setPending(catalog::RegisterId id, const catalog::Value &value);
    std::vector<drive::RegisterWrite> pending() const; ///< in the order of the first edit of each
    /// All that are not on their way. @param of  these registers alone
    void forgetEdits(const std::function<bool(catalog::RegisterId)> &of = {});
    void markSending(const std::vector<drive::RegisterWrite> &writes); ///< the edits among them
    void markNotSent(); ///< what was on its way is pending again
    /// How writes ended. An edit that was not among them waits on, unless the board now holds what it wants.
    void onResults(const std::vector<drive::WriteResult> &results);
    bool hasEdits() const; ///< of any state but the flash of a write
    QStringList pendingElsewhere() const; ///< names of those of a motor that is not shown
    EditState editState(catalog::RegisterId id) const;
    std::optional<catalog::Value> known(catalog::RegisterId id) const; ///< newest, however old
    /// The value of the edit if there is one that is not yet written, known() otherwise.
    std::optional<catalog::Value> wanted(catalog::RegisterId id) const;
    QString describe(catalog::RegisterId id, const catalog::Value &value) const; ///< with unit
    /// What a cell of a floating-point number shows with so many digits that count; empty for all others, and
    /// for one with an edit.
    QString roundedText(catalog::RegisterId id, int column, int digits) const;
    QString copyText(catalog::RegisterId id) const; ///< name, value, raw: tabs between
    /// What a register is: name, access, range and help, in plain text; empty if it is not shown.
    QString details(catalog::RegisterId id) const;

    void setPinned(const QStringList &names); ///< before setCatalog(), or any time
    QStringList pinned() const { return m_pinned; }
    void togglePinned(catalog::RegisterId id);

    /// In its own group.
    QModelIndex indexOf(catalog::RegisterId id, Column column = NameColumn) const;

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &child) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex & = {}) const override { return ColumnCount; }
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(
        int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    QStringList mimeTypes() const override;
    QMimeData *mimeData(const QModelIndexList &indexes) const override;
    Qt::DropActions supportedDragActions() const override { return Qt::CopyAction; }

Q_SIGNALS:
    /// Another board or motor, or the same one found anew; a pin is none of these.
    void catalogSet();
    void editsChanged();

private:
    struct Edit {
        catalog::RegisterId id = 0;
        catalog::Value wanted;
        EditState state = EditState::Pending;
        QString reason;
        std::optional<Milliseconds> until; ///< of the flash; set at the first refresh
    };
    enum class Known : std::uint8_t { Nothing, Value, NotSupported, Refused };
    struct Row {
        catalog::RegisterId id = 0;
        const catalog::RegisterInfo *info = nullptr;
        catalog::Scale scale;
        Known known = Known::Nothing;
        bool stale = false;
        catalog::Value value;
        Milliseconds at{};
        Milliseconds interval{}; ///< between the newest two values
    };
    struct Group {
        QString name;
        std::vector<std::size_t> rows;
    };

    void rebuildGroups();
    void markStale(Milliseconds now);
    const Row *rowAt(const QModelIndex &index) const;
    const Row *find(catalog::RegisterId id) const;
    void rowsChanged(const std::vector<std::size_t> &changed);
    void rowChanged(catalog::RegisterId id);
    const Edit *editOf(catalog::RegisterId id) const;
    Edit &edit(catalog::RegisterId id);
    void keepEdits(const catalog::Catalog *before);
    void endFlashes(Milliseconds now);
    QVariant editBackground(const Row &row) const;
    QString editSentence(const Row &row) const; ///< what became of its edit; empty without one
    QString editToolTip(const Row &row) const;
    QVariant display(const Row &row, int column) const;
    QString valueText(const Row &row) const;
    QString accessText(const Row &row) const;
    QVariant cell(const Row &row, int column, int role) const;
    QVariant editText(const Row &row, int column) const;
    QString toolTip(const Row &row) const;

    std::shared_ptr<const catalog::Catalog> m_catalog;
    std::vector<Row> m_rows;
    std::vector<Group> m_groups;
    std::vector<Edit> m_edits;
    std::vector<drive::MotorLimits> m_limits;
    std::unordered_map<catalog::RegisterId, std::size_t> m_byId;
    QStringList m_pinned;
    int m_motor = 1;
    bool m_believed = true;
};

/// The whole number that a register is known to hold, of the motor that is shown.
std::optional<std::int64_t> knownWhole(const RegisterModel &model, std::string_view name);

} // namespace widgets
