// GainLabel: a wrapped sentence that is exactly as high as its width asks for. (A plain wrapped label asks for the
// height of its narrowest width, and makes a low page scroll for nothing.)
#pragma once

#include <QLabel>

namespace widgets {

class GainLabel : public QLabel {
    Q_OBJECT
public:
    explicit GainLabel(const char *name, QWidget *parent = nullptr);

    void say(const QString &sentence); ///< plain text

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void fit();
};

} // namespace widgets
