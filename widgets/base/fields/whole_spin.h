// WholeSpin: a spin box for a whole number that drops nothing that is typed. Qt's own leaves out what is no digit, so
// that 12.5 becomes 125; here it stays, red with the reason, and the number of before counts until the text is good.
#pragma once

#include <QSpinBox>

namespace widgets {

class WholeSpin : public QSpinBox {
    Q_OBJECT
public:
    explicit WholeSpin(QWidget *parent = nullptr);

    QString problem() const; ///< one sentence; empty if the text is good

protected:
    QValidator::State validate(QString &input, int &cursor) const override;
    void fixup(QString &input) const override;

private:
    bool isGood(QString text) const;
    void textChanged();

    int m_before = 0; ///< what is being typed now
    bool m_typing = false;
};

} // namespace widgets
