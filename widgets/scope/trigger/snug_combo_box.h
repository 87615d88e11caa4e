// A box of choices as wide as the word that is chosen, for bars where the widest choice would cost a line. Its list is
// as wide as its words.
#pragma once

#include <QComboBox>

namespace widgets {

class SnugComboBox : public QComboBox {
    Q_OBJECT
public:
    /// @param most  characters it shows at most; the rest is cut
    explicit SnugComboBox(int most, QWidget *parent = nullptr);

    QSize sizeHint() const override { return sizeFor(m_most); }
    QSize minimumSizeHint() const override;
    void showPopup() override;

private:
    QSize sizeFor(int most) const; ///< characters

    int m_most;
};

} // namespace widgets
