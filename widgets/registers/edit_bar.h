// EditBar: what is to be done with the edits of a RegisterModel: how the last write ended, why the next cannot be made,
// Revert and Apply. Each view that edits registers has one; all of them speak of the same edits.
#pragma once

#include "widgets/registers/register_edits.h"

#include <QWidget>

class QAction;
class QLabel;
class QPushButton;

namespace widgets {

class EditBar : public QWidget {
    Q_OBJECT
public:
    /// @param apply, revert  the window's actions; the buttons are enabled and explained as they are
    /// @param always  stays when there is nothing to apply (a page with room for it)
    EditBar(RegisterEdits &edits, const RegisterModel &model, QAction *apply, QAction *revert,
        bool always, QWidget *parent = nullptr);

    void refresh();
    void tell(const QString &sentence, bool good);
    /// Not of a wide page: it would be given its preferred height, and scroll although it fits.
    bool hasHeightForWidth() const override { return !m_always && QWidget::hasHeightForWidth(); }

private:
    RegisterEdits &m_edits;
    const RegisterModel &m_model;
    QAction *m_applyAction, *m_revertAction;
    bool m_always;
    QLabel *m_told;
    QPushButton *m_revert, *m_apply;
    QString m_sentence; ///< how the last write ended
    bool m_good = true; ///< it ended well: not worth saying once the next edit waits
};

} // namespace widgets
