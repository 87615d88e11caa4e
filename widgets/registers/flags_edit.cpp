#include "widgets/registers/flags_edit.h"

#include "catalog/names.h"
#include "widgets/base/register_texts.h"

#include <QKeyEvent>

#include <algorithm>

namespace widgets {
namespace {

constexpr int kMostRows = 12;
constexpr int kMask = Qt::UserRole;

} // namespace

FlagsEdit::FlagsEdit(std::string_view registerName, QWidget *parent)
    : QListWidget(parent)
{
    setObjectName(QStringLiteral("registerFlags"));
    setUniformItemSizes(true);
    for (const catalog::NamedValue &flag : catalog::namedFlags(registerName)) {
        auto *item = new QListWidgetItem(valueNameText(flag.name), this);
        item->setData(kMask, qint64(flag.value));
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(Qt::Unchecked);
    }
    setCurrentRow(0);
}

void FlagsEdit::setBits(std::int64_t bits)
{
    m_before = bits;
    for (int row = 0; row < count(); ++row) {
        const std::int64_t mask = item(row)->data(kMask).toLongLong();
        item(row)->setCheckState((bits & mask) == mask ? Qt::Checked : Qt::Unchecked);
    }
}

std::int64_t FlagsEdit::bits() const
{
    std::int64_t bits = m_before;
    for (int row = 0; row < count(); ++row) {
        const std::int64_t mask = item(row)->data(kMask).toLongLong();
        bits = item(row)->checkState() == Qt::Checked ? bits | mask : bits & ~mask;
    }
    return bits;
}

void FlagsEdit::keyPressEvent(QKeyEvent *event)
{
    QListWidget::keyPressEvent(event);
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        event->accept(); // not for what the editor stands in: that would open it once more
}

QSize FlagsEdit::sizeHint() const
{
    const int rows = std::clamp(count(), 1, kMostRows);
    return {sizeHintForColumn(0) + 2 * frameWidth() + (count() > rows ? 24 : 8),
        rows * std::max(sizeHintForRow(0), 16) + 2 * frameWidth()};
}

} // namespace widgets
