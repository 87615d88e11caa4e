// Banner: one sentence over the upper part of the work, without stopping or moving anything: it covers a strip of the
// widget that it lies on, below what has to be seen there. It stays until its cause is gone or it is closed.
#pragma once

#include <QFrame>

#include <functional>

class QLabel;
class QToolButton;

namespace widgets {

class Banner : public QFrame {
    Q_OBJECT
public:
    enum class Kind : std::uint8_t { Note, Warning, Bad };

    /// @param over  that it covers a strip of; somewhere inside `window`, so that pictures of it do not show this
    /// @param free  how many pixels of the upper edge it leaves free, as long as it fits below them
    Banner(QWidget *over, std::function<int()> free, QWidget *window);

    /// Replaces what was said. @param act  a button that belongs to it, which the banner takes in
    void say(Kind kind, const QString &sentence, QWidget *act = nullptr);
    void clear();
    QString text() const;
    Kind kind() const { return m_kind; }

public Q_SLOTS:
    void follow(); ///< what it leaves free may have changed

protected:
    void changeEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void recolor();
    void place();

    QWidget *m_over;
    std::function<int()> m_free;
    QLabel *m_mark;
    QLabel *m_text;
    QToolButton *m_close;
    QWidget *m_act = nullptr; ///< of what is said now
    Kind m_kind = Kind::Note;
};

} // namespace widgets
