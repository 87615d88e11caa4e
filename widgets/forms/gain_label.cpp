#include "widgets/forms/gain_label.h"

#include <algorithm>

namespace widgets {

GainLabel::GainLabel(const char *name, QWidget *parent)
    : QLabel(parent)
{
    setObjectName(QLatin1String(name));
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    setFocusPolicy(Qt::NoFocus); // a click selects all the same
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    fit();
}

void GainLabel::say(const QString &sentence)
{
    if (text() == sentence)
        return;
    setText(sentence);
    fit();
}

void GainLabel::showEvent(QShowEvent *event)
{
    QLabel::showEvent(event);
    fit();
}

void GainLabel::resizeEvent(QResizeEvent *event)
{
    QLabel::resizeEvent(event);
    fit();
}

void GainLabel::fit()
{
    QSizePolicy policy = sizePolicy(); // a label asks for it anew with every text
    policy.setHeightForWidth(false);
    setSizePolicy(policy);
    setMinimumHeight(0); // the height for a width is never below it
    constexpr int kNarrowest = 20; // characters
    const int least = kNarrowest * fontMetrics().averageCharWidth();
    // Its width is not known before it is seen, and a page behind another must not make that one scroll.
    const int needed =
        isVisible() ? heightForWidth(std::max(width(), least)) : fontMetrics().height();
    setFixedHeight(text().isEmpty() ? 0 : needed);
}

} // namespace widgets
