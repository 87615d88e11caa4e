// Says over the scope that its picture is not live: a light hatch on every plot and one line of words. Takes no mouse
// and knows no link; the caller gives the reason.
#pragma once

#include <QWidget>

namespace widgets {

class ScopeView;

class StaleMark : public QWidget {
    Q_OBJECT
public:
    /// Covers `scope` while there is a reason; hidden at first.
    explicit StaleMark(const ScopeView &scope, QWidget *parent);

    void say(const QString &why); ///< plain text; empty: what is shown is live
    QString why() const { return m_why; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const ScopeView &m_scope;
    QString m_why;
};

} // namespace widgets
