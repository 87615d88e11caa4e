// Banner: one sentence above the work, without stopping anything. It stays until its cause is gone or it is closed.
#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace widgets {

class Banner : public QFrame {
    Q_OBJECT
public:
    enum class Kind : std::uint8_t { Note, Warning, Bad };

    explicit Banner(QWidget *parent = nullptr);

    /// Replaces what was said.
    void say(Kind kind, const QString &sentence);
    void clear();
    QString text() const;
    Kind kind() const { return m_kind; }

protected:
    void changeEvent(QEvent *event) override;

private:
    void recolor();

    QLabel *m_mark;
    QLabel *m_text;
    QToolButton *m_close;
    Kind m_kind = Kind::Note;
};

} // namespace widgets
