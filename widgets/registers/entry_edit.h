// EntryEdit: a text field for the value of a register, in a table or in a form, read as strictly as every value that
// reaches a board. A text that is not good is red and says why; it stays in the field.
#pragma once

#include "widgets/base/fields/stepped_edit.h"
#include "widgets/registers/entry.h"

#include <functional>
#include <optional>

namespace widgets {

class EntryEdit : public SteppedEdit {
    Q_OBJECT
public:
    enum class As : std::uint8_t { Shown, Raw };
    /// Asked anew each time: limits change.
    using Rules = std::function<std::optional<EntryRules>()>;

    explicit EntryEdit(Rules rules, As as = As::Shown, QWidget *parent = nullptr);

    std::optional<catalog::Value> value() const; ///< empty if the text is not good
    bool takes(const QString &text) const { return read(text).has_value(); }
    QString problem() const override;

    void setStep(int step) { m_step = step; } ///< of what the register can hold; 1 if not told
    void setEmptyAllowed(bool allowed) { m_emptyAllowed = allowed; }
    void keepWhatIsBad(); ///< Enter leaves an editor in a table open while its text is not good

protected:
    std::optional<EntryRules> rules() const { return m_rules(); } ///< empty: nothing can be typed
    void stepBy(int steps) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    Result<catalog::Value, EntryError> read(const QString &text) const;

    Rules m_rules;
    As m_as;
    int m_step = 1;
    bool m_emptyAllowed = false;
};

} // namespace widgets
