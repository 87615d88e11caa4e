#include "widgets/registers/field.h"

#include "widgets/registers/delegate.h"
#include "widgets/registers/entry_edit.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>

namespace widgets {

RegisterField::RegisterField(
    RegisterModel &model, const QString &name, RegisterModel::Column column, QWidget *parent)
    : QWidget(parent)
    , m_model(model)
    , m_name(name)
    , m_column(column)
    , m_layout(new QHBoxLayout(this))
{
    setObjectName(
        (column == RegisterModel::RawColumn ? QStringLiteral("raw_") : QStringLiteral("field_"))
        + name);
    m_layout->setContentsMargins(0, 0, 0, 0);
    connect(&model, &QAbstractItemModel::modelReset, this, &RegisterField::resolve);
    connect(&model, &QAbstractItemModel::dataChanged, this,
        [this](const QModelIndex &from, const QModelIndex &to) {
            const QModelIndex mine = m_id ? m_model.indexOf(*m_id, m_column) : QModelIndex();
            if (mine.isValid() && mine.parent() == from.parent() && mine.row() >= from.row()
                && mine.row() <= to.row())
                show();
        });
    resolve();
}

void RegisterField::setLabel(QWidget *label)
{
    m_label = label;
    resolve();
}

std::optional<catalog::Value> RegisterField::wanted() const
{
    return m_id ? m_model.wanted(*m_id) : std::nullopt;
}

void RegisterField::resolve()
{
    const auto id = m_model.idOf(m_name.toStdString());
    delete m_editor;
    m_editor = nullptr;
    m_edit = nullptr;
    m_choice = nullptr;
    m_text = nullptr;
    m_shown.clear();
    m_id = id;
    setVisible(id.has_value());
    if (m_label)
        m_label->setVisible(id.has_value());
    if (id) {
        m_editor = makeRegisterEditor(m_model, *id, m_column, this);
        if (!m_editor) { // only to be read
            m_editor = m_text = new QLabel(this);
            m_text->setTextFormat(Qt::PlainText);
            m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
        }
        m_edit = qobject_cast<EntryEdit *>(m_editor);
        m_choice = qobject_cast<QComboBox *>(m_editor);
        m_editor->installEventFilter(this);
        m_layout->addWidget(m_editor);
        setFocusProxy(m_editor);
        if (auto *label = qobject_cast<QLabel *>(m_label))
            label->setBuddy(m_editor);
        if (m_choice)
            connect(m_choice, &QComboBox::activated, this, &RegisterField::commit);
        show();
    }
    Q_EMIT registerChanged();
}

void RegisterField::show()
{
    const QModelIndex index = m_id ? m_model.indexOf(*m_id, m_column) : QModelIndex();
    if (!index.isValid() || !m_editor)
        return;
    const QString text = index.data(m_text ? Qt::DisplayRole : Qt::EditRole).toString();
    if (m_text)
        m_text->setText(text);
    if (m_edit && (!m_edit->hasFocus() || m_edit->text() == m_shown))
        m_edit->setFollowed(text);
    if (m_choice && !m_choice->view()->isVisible())
        m_choice->setCurrentIndex(m_choice->findText(text));
    m_shown = text;
    m_editor->setEnabled(m_text || m_model.editable(*m_id, m_column));
    m_editor->setToolTip(index.data(Qt::ToolTipRole).toString());
    QPalette colors;
    if (const QVariant back = index.data(Qt::BackgroundRole); back.isValid()) {
        colors.setColor(QPalette::Base, back.value<QColor>());
        colors.setColor(QPalette::Button, back.value<QColor>());
        colors.setColor(QPalette::Text, Qt::black);
        colors.setColor(QPalette::ButtonText, Qt::black);
    } else if (index.data(RegisterModel::StaleRole).toBool()) { // as the tree marks it
        const QColor pale = QApplication::palette().color(QPalette::Disabled, QPalette::Text);
        for (const auto role : {QPalette::Text, QPalette::ButtonText, QPalette::WindowText})
            colors.setColor(role, pale);
    }
    m_editor->setPalette(colors);
    Q_EMIT valueChanged();
}

bool RegisterField::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_edit && event->type() == QEvent::FocusOut)
        commit();
    if (watched == m_edit && event->type() == QEvent::KeyPress) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
            commit();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

/// Takes the text over, or says why not and shows again what is wanted.
void RegisterField::commit()
{
    const QString text = m_edit ? m_edit->text() : m_choice->currentText();
    if (text == m_shown)
        return; // untouched: not a wish for a value that may have changed meanwhile
    const QString problem = m_edit ? m_edit->problem() : QString();
    m_shown = text;
    const bool taken = m_model.setData(m_model.indexOf(*m_id, m_column), text);
    show();
    if (!taken)
        Q_EMIT entryRefused(problem);
}

} // namespace widgets
