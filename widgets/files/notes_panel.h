// Notes about the work at hand, as plain text; they are kept with the workspace.
#pragma once

#include "widgets/base/form.h"

class QPlainTextEdit;

namespace widgets {

class NotesPanel : public Form {
    Q_OBJECT
public:
    explicit NotesPanel(const QString &text, QWidget *parent = nullptr);

    QString text() const;
    void setText(const QString &text);
    double heightShare() const override { return 0.3; }
    void focusFirst() override;

private:
    QPlainTextEdit *m_text;
};

} // namespace widgets
