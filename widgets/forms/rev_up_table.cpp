#include "widgets/forms/rev_up_table.h"

#include "widgets/forms/rev_up_model.h"
#include "widgets/registers/entry_edit.h"

#include <QHeaderView>
#include <QKeyEvent>

namespace widgets {
namespace {

constexpr int kLongestEntry = 64;
const char *const kFilled = "filled";

} // namespace

RevUpDelegate::RevUpDelegate(RevUpModel &model, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_model(model)
{
}

QWidget *RevUpDelegate::createEditor(
    QWidget *parent, const QStyleOptionViewItem &, const QModelIndex &index) const
{
    const int column = index.column();
    auto *edit = new EntryEdit([model = &m_model, column] { return model->rulesOf(column); },
        EntryEdit::As::Shown, parent);
    edit->setMaxLength(kLongestEntry);
    if (column == RevUpModel::SpeedColumn)
        edit->setStep(static_cast<int>(m_model.bounds().speedStep_rpm));
    edit->setObjectName(QStringLiteral("revUpEntry"));
    edit->setAccessibleName(index.data(Qt::AccessibleTextRole).toString());
    return edit;
}

void RevUpDelegate::setEditorData(QWidget *editor, const QModelIndex &index) const
{
    // Values that arrive while the user types must not replace the text.
    auto *edit = qobject_cast<EntryEdit *>(editor);
    if (edit == nullptr || edit->property(kFilled).isValid())
        return;
    const QString text = index.data(Qt::EditRole).toString();
    edit->setProperty(kFilled, text);
    edit->setText(text);
    edit->selectAll();
}

void RevUpDelegate::setModelData(
    QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const
{
    const auto *edit = qobject_cast<EntryEdit *>(editor);
    if (edit == nullptr || edit->text() == edit->property(kFilled).toString())
        return; // untouched: not a wish for a value that may have changed meanwhile
    if (!model->setData(index, edit->text(), Qt::EditRole))
        Q_EMIT entryRefused(edit->problem());
}

void RevUpDelegate::updateEditorGeometry(
    QWidget *editor, const QStyleOptionViewItem &option, const QModelIndex &) const
{
    QRect place = option.rect;
    place.setHeight(std::max(place.height(), editor->minimumSizeHint().height()));
    editor->setGeometry(place);
}

void RevUpDelegate::initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    // The colour of an edit is also seen in a selected row.
    if (index.data(Qt::BackgroundRole).isValid())
        option->state.setFlag(QStyle::State_Selected, false);
}

RevUpTable::RevUpTable(QWidget *parent)
    : QTableView(parent)
{
    setTabKeyNavigation(false);
    setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
    setSelectionMode(SingleSelection);
    setSelectionBehavior(SelectItems);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    horizontalHeader()->setSectionsClickable(false);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setSectionsClickable(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    setWordWrap(false);
}

void RevUpTable::setModel(QAbstractItemModel *model)
{
    QTableView::setModel(model);
    fitToFont();
}

/// All of it is always to be seen: five rows of numbers that are as wide as the register allows.
void RevUpTable::fitToFont()
{
    constexpr int kCellMargin = 10, kSign = 16; // px beside a number; a warning before it
    const QFontMetrics metrics(font());
    const auto width = [&](const QString &widest) {
        return metrics.horizontalAdvance(widest) + kCellMargin;
    };
    const motor::RevUpBounds most;
    const int widths[] = {width(QString::number(most.duration_ms)) + kSign,
        width(QString::number(-most.speed_rpm)) + kSign,
        width(QString::number(-1e-3 * most.digits, 'f', 3)) + kSign,
        width(QString::number(-most.digits)) + kSign,
        width(QStringLiteral("100.0 / 100.0")) + kSign};
    for (int column = 0; column < RevUpModel::ColumnCount; ++column)
        setColumnWidth(column, widths[column]);
    verticalHeader()->setDefaultSectionSize(metrics.height() + 8);
    verticalHeader()->setFixedWidth(width(QStringLiteral("5 W")));
    setFixedSize(sizeHint());
}

void RevUpTable::changeEvent(QEvent *event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange && model())
        fitToFont();
}

QSize RevUpTable::sizeHint() const
{
    const int rows = static_cast<int>(motor::kRevUpStages);
    return {horizontalHeader()->length() + verticalHeader()->minimumWidth() + 2 * frameWidth(),
        horizontalHeader()->sizeHint().height() + rows * verticalHeader()->defaultSectionSize()
            + 2 * frameWidth()};
}

bool editsNumber(const QKeyEvent &key)
{
    if ((key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) != Qt::NoModifier)
        return false;
    switch (key.key()) {
    case Qt::Key_F2:
    case Qt::Key_Minus:
    case Qt::Key_Plus:
    case Qt::Key_Comma:
    case Qt::Key_Period:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_Insert:
    case Qt::Key_Delete:
        return true;
    default:
        return key.key() >= Qt::Key_0 && key.key() <= Qt::Key_9;
    }
}

bool RevUpTable::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride
        && editsNumber(*static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    return QTableView::event(event);
}

void RevUpTable::keyPressEvent(QKeyEvent *event)
{
    const bool alt = event->modifiers().testFlag(Qt::AltModifier);
    switch (event->key()) {
    case Qt::Key_Insert:
        return addWanted();
    case Qt::Key_Delete:
        return removeWanted();
    case Qt::Key_Up:
    case Qt::Key_Down:
        if (alt)
            return moveWanted(event->key() == Qt::Key_Up ? -1 : 1);
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        // Enter in an editor comes here, too, before the editor is closed.
        if (state() != EditingState && model()
            && model()->flags(currentIndex()).testFlag(Qt::ItemIsEditable))
            return edit(currentIndex());
        break;
    default:
        break;
    }
    QTableView::keyPressEvent(event);
}

} // namespace widgets
