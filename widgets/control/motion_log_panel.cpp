#include "widgets/control/motion_log_panel.h"

#include "session/files/whole_file.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/messages.h"
#include "widgets/control/motion_log_model.h"

#include <QClipboard>
#include <QDir>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>

namespace widgets {

MotionLogPanel::MotionLogPanel(MotionLogModel &log, FilePrompt &files, QWidget *parent)
    : Form(parent)
    , m_log(log)
    , m_files(files)
    , m_table(named(new QTableView(this), "motionLog", tr("Motion log")))
    , m_leftOut(named(new QLabel(this), "motionLogLeftOut"))
{
    m_table->setModel(&log);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->setAlternatingRowColors(true);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 6);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setHighlightSections(false);
    const int unit = m_table->fontMetrics().averageCharWidth();
    const int widths[] = {18, 8, 20, 26, 26, 14};
    for (int column = 0; column < int(std::size(widths)); ++column)
        m_table->setColumnWidth(column, widths[column] * unit);

    const auto button = [this](const QString &text, const char *name, auto slot) {
        auto *made = named(new QToolButton(this), name);
        made->setText(text);
        made->setFocusPolicy(Qt::TabFocus);
        connect(made, &QToolButton::clicked, this, slot);
        return made;
    };
    m_copy = button(tr("Copy"), "motionLogCopy", &MotionLogPanel::copy);
    m_save = button(tr("Save\u2026"), "motionLogSave", &MotionLogPanel::save);
    auto *side = new QVBoxLayout;
    side->addWidget(m_copy);
    side->addWidget(m_save);
    side->addStretch(1);
    auto *layout = edged(new QHBoxLayout(this), kToolEdges);
    auto *rows = bare(new QVBoxLayout, kFineGrid);
    rows->addWidget(m_leftOut); // above the oldest row
    rows->addWidget(m_table, 1);
    layout->addLayout(rows, 1);
    layout->addLayout(side);

    connect(&log, &QAbstractItemModel::rowsAboutToBeInserted, this, [this] {
        const QScrollBar *bar = m_table->verticalScrollBar();
        if (bar->value() == bar->maximum()) // older rows that are being read stay
            QMetaObject::invokeMethod(m_table, &QTableView::scrollToBottom, Qt::QueuedConnection);
    });
    connect(&log, &QAbstractItemModel::rowsInserted, this, &MotionLogPanel::follow);
    connect(&log, &QAbstractItemModel::modelReset, this, &MotionLogPanel::follow);
    setFocusProxy(m_table);
    follow();
}

void MotionLogPanel::follow()
{
    m_leftOut->setVisible(m_log.leftOut() > 0);
    m_leftOut->setText(tr("%1 earlier acts are left out.").arg(QString::number(m_log.leftOut())));
    const bool some = m_log.rowCount() > 0;
    m_copy->setEnabled(some);
    m_save->setEnabled(some);
}

void MotionLogPanel::copy()
{
    QList<int> rows;
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
        rows.append(index.row());
    std::sort(rows.begin(), rows.end());
    if (rows.isEmpty())
        for (int row = 0; row < m_log.rowCount(); ++row)
            rows.append(row);
    QGuiApplication::clipboard()->setText(m_log.copyText(rows));
}

void MotionLogPanel::save()
{
    const QString now =
        QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss"));
    const SaveQuestion question{tr("Save the motion log"), QDir::homePath(),
        now + QStringLiteral("_motion.csv"), tr("CSV files (*.csv)"), QStringLiteral("csv")};
    m_files.askSave(this, question, [this](const QString &path) {
        const QString wrong = session::writeWholeFile(path, m_log.text());
        if (wrong.isEmpty())
            Q_EMIT saved(path);
        else
            Q_EMIT failed(exportFileErrorText({session::FileError::CannotOpen, wrong}, path));
    });
}

} // namespace widgets
