#include "widgets/scope/trigger/snug_combo_box.h"

#include <QAbstractItemView>
#include <QStyleOptionComboBox>

#include <algorithm>

namespace widgets {

namespace {
constexpr int kLeast = 3; ///< characters
constexpr int kStillRead = 6; ///< characters that are left where there is little room
constexpr int kAir = 4; ///< pixels: what the frames of styles take besides
} // namespace

SnugComboBox::SnugComboBox(int most, QWidget *parent)
    : QComboBox(parent)
    , m_most(most)
{
    connect(this, &QComboBox::currentTextChanged, this, &SnugComboBox::updateGeometry);
}

QSize SnugComboBox::minimumSizeHint() const { return sizeFor(std::min(m_most, kStillRead)); }

QSize SnugComboBox::sizeFor(int most) const
{
    const QFontMetrics metrics(font());
    const int digit = metrics.horizontalAdvance(QLatin1Char('0'));
    const int text = metrics.horizontalAdvance(currentText());
    QStyleOptionComboBox option;
    initStyleOption(&option);
    const QSize content(
        std::clamp(text, kLeast * digit, most * digit) + kAir, QComboBox::sizeHint().height());
    const QSize whole = style()->sizeFromContents(QStyle::CT_ComboBox, &option, content, this);
    return {whole.width(), content.height()};
}

void SnugComboBox::showPopup()
{
    view()->setTextElideMode(Qt::ElideNone); // the list is made with the first question for it
    const int words =
        view()->sizeHintForColumn(0) + view()->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    view()->setMinimumWidth(std::max(words, QComboBox::sizeHint().width()));
    QComboBox::showPopup();
}

} // namespace widgets
