// EditBar: what is to be done with the edits of a RegisterModel: how the last write ended, why the next cannot be made,
// Revert and Apply. Each view that edits registers has one; all of them speak of the same edits. It is always there,
// and always as high: a link that is lost has something to say, too, and nothing is to move for it.
#pragma once

#include "widgets/registers/edits.h"

#include <QWidget>

#include <cstdint>

class QAction;
class QLabel;
class QPushButton;

namespace widgets {

class EditBar : public QWidget {
    Q_OBJECT
public:
    /// @param apply, revert  the window's actions; the buttons are enabled and explained as they are
    enum class Room : std::uint8_t { Wide /* all in one line */, Narrow };
    EditBar(RegisterEdits &edits, const RegisterModel &model, QAction *apply, QAction *revert,
        Room room, QWidget *parent = nullptr);

    void refresh();
    void tell(const QString &sentence, bool good);
    bool hasHeightForWidth() const override { return false; } ///< what is told has its lines

private:
    QString applyText(int count) const;

    RegisterEdits &m_edits;
    const RegisterModel &m_model;
    QAction *m_applyAction, *m_revertAction;
    bool m_wide;
    QLabel *m_told;
    QPushButton *m_revert, *m_apply;
    QString m_sentence; ///< how the last write ended
    bool m_good = true; ///< it ended well: not worth saying once the next edit waits
};

} // namespace widgets
