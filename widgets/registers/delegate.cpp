#include "widgets/registers/delegate.h"

#include "catalog/names.h"
#include "widgets/base/register_texts.h"
#include "widgets/base/value_text.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/registers/entry_edit.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QToolTip>

#include <algorithm>

namespace widgets {
namespace {

constexpr int kNarrowest = 120;
const char *const kFilled = "filled";
constexpr int kLeastDigits = 3; ///< that count, of a value that is rounded
constexpr int kLeastRawDigits = 2; ///< the value stands beside it

/// The values that a combo box offers; empty where text is typed.
QList<std::pair<QString, qint64>> choicesOf(const catalog::RegisterInfo &info)
{
    QList<std::pair<QString, qint64>> choices;
    if (info.meaning == catalog::Meaning::Boolean)
        return {{booleanText(false), 0}, {booleanText(true), 1}};
    if (info.meaning == catalog::Meaning::Enumeration)
        for (const catalog::NamedValue &named : catalog::namedValues(info.name))
            choices.append({valueNameText(named.name), named.value});
    return choices;
}

QString signOf(RegisterModel::EditState state)
{
    switch (state) {
    case RegisterModel::EditState::Pending:
        return QStringLiteral("\u270e");
    case RegisterModel::EditState::Sending:
        return QStringLiteral("\u2026");
    case RegisterModel::EditState::Verified:
        return QStringLiteral("\u2713");
    case RegisterModel::EditState::Unproved:
        return QStringLiteral("?");
    case RegisterModel::EditState::Refused:
        return QStringLiteral("\u2717");
    case RegisterModel::EditState::None:
        break;
    }
    return {};
}

catalog::RegisterId idOf(const QModelIndex &index)
{
    return index.data(RegisterModel::IdRole).toUInt();
}

/// For the text of a cell, in pixels.
int roomIn(const QStyleOptionViewItem &option)
{
    const QWidget *view = option.widget;
    const int margin = view->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, view) + 1;
    return option.rect.width() - 2 * margin;
}

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

RegisterDelegate::RegisterDelegate(const RegisterModel &model, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_model(model)
{
    const auto learn = [this] { m_names.setNames(namesIn(m_model)); };
    connect(&model, &QAbstractItemModel::modelReset, this, learn);
    learn();
}

QStringList namesIn(const RegisterModel &model)
{
    QStringList names;
    for (int group = 0; group < model.rowCount(); ++group) {
        const QModelIndex parent = model.index(group, RegisterModel::NameColumn);
        for (int row = 0; row < model.rowCount(parent); ++row)
            names.append(model.index(row, RegisterModel::NameColumn, parent).data().toString());
    }
    return names;
}

QWidget *makeRegisterEditor(
    const RegisterModel &model, catalog::RegisterId id, int column, QWidget *parent)
{
    const auto rules = model.rulesOf(id);
    if (!rules)
        return nullptr;
    const auto choices = column == RegisterModel::ValueColumn ? choicesOf(*rules->info)
                                                              : QList<std::pair<QString, qint64>>();
    QWidget *editor = nullptr;
    if (choices.isEmpty()) {
        auto *edit = new EntryEdit([model = &model, id] { return model->rulesOf(id); },
            column == RegisterModel::RawColumn ? EntryEdit::As::Raw : EntryEdit::As::Shown, parent);
        edit->setObjectName(QStringLiteral("registerEntry"));
        edit->keepWhatIsBad();
        editor = edit;
    } else {
        auto *box = new QComboBox(parent);
        box->setObjectName(QStringLiteral("registerChoice"));
        for (const auto &[name, value] : choices)
            box->addItem(name, value);
        new WheelGuard(box);
        editor = box;
    }
    editor->setAccessibleName(model.indexOf(id).data().toString());
    return editor;
}

QWidget *RegisterDelegate::createEditor(
    QWidget *parent, const QStyleOptionViewItem &, const QModelIndex &index) const
{
    const auto rules = m_model.rulesOf(idOf(index));
    // Before its value is known, a list of flags would write 0 to all that was not touched.
    if (rules && index.column() == RegisterModel::ValueColumn && m_model.wanted(idOf(index))
        && rules->info->meaning == catalog::Meaning::Flags
        && !catalog::namedFlags(rules->info->name).empty()) {
        auto *flags = new FlagsEdit(rules->info->name, parent);
        flags->setAccessibleName(m_model.indexOf(idOf(index)).data().toString());
        return flags;
    }
    return makeRegisterEditor(m_model, idOf(index), index.column(), parent);
}

/// A floating-point number with fewer digits where its column is too narrow for all of them: cut off, it would lose its
/// unit or its power of ten. Empty if the text is to stay.
QString RegisterDelegate::roundedFor(
    const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    if (!option.widget || option.rect.width() <= 0 || index.column() == RegisterModel::NameColumn)
        return {};
    const int room = roomIn(option);
    const auto fits = [&](const QString &text) {
        return option.fontMetrics.horizontalAdvance(text) <= room;
    };
    if (fits(index.data().toString()))
        return {};
    const int least = index.column() == RegisterModel::RawColumn ? kLeastRawDigits : kLeastDigits;
    QString text;
    for (int digits = kFloatDigits - 1; digits >= least; --digits) {
        text = m_model.roundedText(idOf(index), index.column(), digits);
        if (text.isEmpty() || fits(text))
            break;
    }
    return text;
}

/// What was rounded is told whole.
bool RegisterDelegate::helpEvent(QHelpEvent *event, QAbstractItemView *view,
    const QStyleOptionViewItem &option, const QModelIndex &index)
{
    const bool cut = index.column() == RegisterModel::NameColumn && option.widget != nullptr
        && option.fontMetrics.horizontalAdvance(index.data().toString()) > roomIn(option);
    if (event->type() != QEvent::ToolTip || (!cut && roundedFor(option, index).isEmpty()))
        return QStyledItemDelegate::helpEvent(event, view, option, index);
    const QStringList parts{index.data().toString(), index.data(Qt::ToolTipRole).toString()};
    QToolTip::showText(event->globalPos(), parts.join(QLatin1Char('\n')).trimmed(), view);
    return true;
}

void RegisterDelegate::initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    if (const QString rounded = roundedFor(*option, index); !rounded.isEmpty())
        option->text = rounded;
    const auto state =
        static_cast<RegisterModel::EditState>(index.data(RegisterModel::EditStateRole).toInt());
    const bool edited = state != RegisterModel::EditState::None;
    if (index.column() != RegisterModel::NameColumn) {
        if (edited) // its colour is also seen in a selected row
            option->state.setFlag(QStyle::State_Selected, false);
        return;
    }
    option->textElideMode = Qt::ElideMiddle; // of a group
    // Not every user sees a colour alone.
    const QString sign = edited ? signOf(state) + QLatin1Char(' ') : QString();
    if (option->widget != nullptr && option->rect.width() > 0)
        option->text = m_names.text(option->text, option->fontMetrics,
            roomIn(*option) - option->fontMetrics.horizontalAdvance(sign));
    option->text.prepend(sign);
}

void RegisterDelegate::setEditorData(QWidget *editor, const QModelIndex &index) const
{
    // Values that arrive while the user types must not replace the text.
    if (editor->property(kFilled).isValid())
        return;
    const QString text = index.data(Qt::EditRole).toString();
    editor->setProperty(kFilled, text);
    if (auto *flags = qobject_cast<FlagsEdit *>(editor)) {
        const auto value = m_model.readEntry(idOf(index), index.column(), text);
        const auto *bits = value ? std::get_if<std::int64_t>(&*value) : nullptr;
        return flags->setBits(bits != nullptr ? *bits : 0);
    }
    if (auto *box = qobject_cast<QComboBox *>(editor)) {
        box->setCurrentIndex(box->findText(text));
    } else if (auto *edit = qobject_cast<EntryEdit *>(editor)) {
        edit->setText(text);
        edit->selectAll();
    }
}

void RegisterDelegate::setModelData(
    QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const
{
    if (const auto *box = qobject_cast<QComboBox *>(editor)) {
        if (box->currentIndex() >= 0 && box->currentText() != box->property(kFilled).toString())
            model->setData(index, box->currentText(), Qt::EditRole);
        return;
    }
    if (const auto *flags = qobject_cast<FlagsEdit *>(editor)) {
        if (flags->touched())
            model->setData(index, QString::number(flags->bits()), Qt::EditRole);
        return;
    }
    const auto *edit = qobject_cast<EntryEdit *>(editor);
    if (edit == nullptr || edit->text() == edit->property(kFilled).toString())
        return; // untouched: not a wish for a value that may have changed meanwhile
    if (!model->setData(index, edit->text(), Qt::EditRole))
        Q_EMIT entryRefused(edit->problem());
}

void RegisterDelegate::updateEditorGeometry(
    QWidget *editor, const QStyleOptionViewItem &option, const QModelIndex &) const
{
    QRect place = option.rect;
    const int width = std::max({place.width(), kNarrowest, editor->sizeHint().width()});
    const int height = std::max(place.height(), editor->minimumSizeHint().height());
    const QRect all = editor->parentWidget()->rect();
    place.setSize({std::min(width, all.width()), height});
    place.moveRight(std::max(place.right(), all.left() + place.width() - 1));
    if (place.right() > all.right())
        place.moveRight(all.right());
    if (place.left() < all.left())
        place.moveLeft(all.left());
    if (place.bottom() > all.bottom())
        place.moveBottom(all.bottom());
    if (place.top() < all.top())
        place.setTop(all.top());
    editor->setGeometry(place);
}

} // namespace widgets
