// RegisterField: one register in a form: its value with unit, typed as in the register tree or chosen by name. A view
// of the RegisterModel: it shows pending edits and their outcome in the same colours, and only makes pending edits.
//
// What the user is typing stays until Enter or until the focus leaves; what cannot be understood is not taken over and
// the field says why. Resolves its register anew for each board and motor; hidden if the board has no such register.
#pragma once

#include "widgets/registers/model.h"

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;

namespace widgets {

class EntryEdit;

class RegisterField : public QWidget {
    Q_OBJECT
public:
    /// @param name  of the register in the catalogue
    /// @param column  ValueColumn (unit people read) or RawColumn (digits)
    RegisterField(RegisterModel &model, const QString &name,
        RegisterModel::Column column = RegisterModel::ValueColumn, QWidget *parent = nullptr);

    std::optional<catalog::RegisterId> id() const { return m_id; }
    /// Pending value if there is one, the board's otherwise; empty if neither is known.
    std::optional<catalog::Value> wanted() const;
    /// A label for this field: its buddy, hidden with it.
    void setLabel(QWidget *label);

Q_SIGNALS:
    void registerChanged(); ///< another board or motor: id() may differ
    void valueChanged(); ///< wanted() may differ
    void entryRefused(const QString &sentence);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void resolve();
    void show();
    void commit();

    RegisterModel &m_model;
    QString m_name;
    RegisterModel::Column m_column;
    QHBoxLayout *m_layout;
    QWidget *m_label = nullptr;
    QWidget *m_editor = nullptr; ///< one of the next three, while there is a register
    EntryEdit *m_edit = nullptr;
    QComboBox *m_choice = nullptr;
    QLabel *m_text = nullptr;
    QString m_shown; ///< last text that was not typed
    std::optional<catalog::RegisterId> m_id;
};

} // namespace widgets
