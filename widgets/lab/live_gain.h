// LiveGain: a field for the digits of one gain that moves the board's own: arrow keys and the wheel by 5 % a notch,
// Page Up and Down by ten notches, or typed with Enter. Each is written at once while the drive is armed, through
// RegisterEdits, so that it is read back and can be undone; what is turned while a write is under way goes with the
// next one.
#pragma once

#include "widgets/registers/edits.h"
#include "widgets/registers/entry_edit.h"

#include <optional>

namespace widgets {

class LiveGain : public EntryEdit {
    Q_OBJECT
public:
    /// @param name  of the register in the catalogue; its divisor's ends in "_DIV"
    LiveGain(RegisterModel &model, RegisterEdits &edits, const char *name, QWidget *parent);

    std::optional<catalog::RegisterId> id() const; ///< of the motor that is shown
    std::optional<catalog::RegisterId> divisor() const;
    /// What it is to be, or is: digits over the divisor; empty: not known.
    std::optional<double> gain() const;
    std::optional<std::int64_t> digits() const; ///< that the board holds
    std::optional<std::int64_t> exponent() const;
    bool settled() const { return !m_wanted; } ///< the board has what was asked for, or said no

Q_SIGNALS:
    void changed(); ///< gain() or settled()

protected:
    void stepBy(int steps) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void want(std::int64_t digits);
    void send();
    void follow();
    void show();

    RegisterModel &m_model;
    RegisterEdits &m_edits;
    std::string m_name;
    std::optional<std::int64_t> m_wanted; ///< not yet held by the board
    std::optional<std::int64_t> m_sent; ///< under way
    std::pair<std::optional<std::int64_t>, std::optional<std::int64_t>> m_told; ///< by changed()
};

} // namespace widgets
