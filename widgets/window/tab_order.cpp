#include "widgets/window/tab_order.h"

#include <QWidget>

#include <algorithm>

namespace widgets {

void orderTabs(QWidget &window, const QList<QWidget *> &parts)
{
    QList<QWidget *> stops;
    for (QWidget *next = window.nextInFocusChain(); next != &window;
         next = next->nextInFocusChain()) {
        // What only hands the focus on is moved with what it hands it to.
        if (next->focusPolicy() != Qt::NoFocus && !next->focusProxy() && next->window() == &window)
            stops.append(next);
    }
    const auto partOf = [&parts](const QWidget *stop) {
        const auto part = std::find_if(parts.begin(), parts.end(),
            [stop](const QWidget *each) { return each == stop || each->isAncestorOf(stop); });
        return part - parts.begin();
    };
    std::stable_sort(stops.begin(), stops.end(),
        [&partOf](const QWidget *a, const QWidget *b) { return partOf(a) < partOf(b); });
    for (qsizetype i = 1; i < stops.size(); ++i)
        QWidget::setTabOrder(stops[i - 1], stops[i]);
}

} // namespace widgets
