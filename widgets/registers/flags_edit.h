// FlagsEdit: the bits of a register as a list of names with check boxes. Space switches one, the arrows go from one to the
// next; a bit without a name keeps its value.
#pragma once

#include <QListWidget>

#include <string_view>

namespace widgets {

class FlagsEdit : public QListWidget {
    Q_OBJECT
public:
    explicit FlagsEdit(std::string_view registerName, QWidget *parent = nullptr);

    void setBits(std::int64_t bits);
    std::int64_t bits() const;
    bool touched() const { return bits() != m_before; } ///< by the user, since setBits()

    QSize sizeHint() const override; ///< all of them, up to a dozen
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    std::int64_t m_before = 0;
};

} // namespace widgets
