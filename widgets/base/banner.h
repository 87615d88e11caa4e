// Banner: one sentence over the upper edge of the work, without stopping or moving anything: it covers a strip of the
// widget that it lies on. It stays until its cause is gone or it is closed.
#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace widgets {

class Banner : public QFrame {
    Q_OBJECT
public:
    enum class Kind : std::uint8_t { Note, Warning, Bad };

    /// @param over  whose upper edge it covers; somewhere inside `window`, so that pictures of it do not show this
    Banner(QWidget *over, QWidget *window);

    /// Replaces what was said.
    void say(Kind kind, const QString &sentence);
    void clear();
    QString text() const;
    Kind kind() const { return m_kind; }

protected:
    void changeEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void recolor();
    void place();

    QWidget *m_over;
    QLabel *m_mark;
    QLabel *m_text;
    QToolButton *m_close;
    Kind m_kind = Kind::Note;
};

} // namespace widgets
