#include "widgets/runs/book_panel.h"

#include "session/files/run_stretches.h"
#include "widgets/base/device_text.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/row_list.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/steady_label.h"
#include "widgets/files/job.h"
#include "widgets/runs/book_model.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace widgets {
namespace {

constexpr qsizetype kMostTold = 3;

/// Whatever column is clicked or moved to, the first ones stay in view: they tell which run it is.
class RunList : public RowList {
public:
    using RowList::RowList;
    void scrollTo(const QModelIndex &index, ScrollHint hint) override
    {
        const int across = horizontalScrollBar()->value();
        RowList::scrollTo(index, hint);
        horizontalScrollBar()->setValue(across);
    }
};

QString problemsText(const QStringList &problems)
{
    if (problems.isEmpty())
        return {};
    QStringList told;
    for (const QString &problem : problems.mid(0, kMostTold))
        told.append(deviceText(problem));
    return RunBookPanel::tr("%n file(s) make no sense: ", nullptr, int(problems.size()))
        + told.join(QStringLiteral("; "));
}

} // namespace

RunBookPanel::RunBookPanel(RunKeeper &keeper, FilePrompt &files, QWidget *parent)
    : Form(parent)
    , m_keeper(keeper)
    , m_files(files)
    , m_model(new RunBookModel(this))
    , m_table(new RunList("runBookTable", tr("Runs"), m_model, this))
    , m_folder(named(new QLabel(this), "runBookFolder"))
    , m_told(named(new SteadyLabel(this, 1), "runBookTold"))
{
    setObjectName(QStringLiteral("runBook"));
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_table->setToolTip(tr("The tick gives a run its star, F2 its note."));
    m_table->installEventFilter(this);
    m_folder->setTextFormat(Qt::PlainText);
    m_folder->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_told->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    const auto button = [this](const QString &text, const char *name) {
        return named(new QPushButton(text, this), name);
    };
    auto *folder = button(tr("Folder\u2026"), "runBookChoose");
    m_split = button(tr("Add a recording\u2026"), "runBookAdd");
    m_split->setToolTip(plainToolTip(tr("Keeps each experiment of a recording, and each stretch "
                                        "between two changes of its gains, as a run")));
    m_registers = button({}, "runBookRegisters");
    m_reference = button(tr("As reference"), "runBookReference");
    m_open = button(tr("Open"), "runBookOpen");
    auto *above = new QHBoxLayout;
    above->addWidget(m_folder, 1);
    above->addWidget(m_split);
    above->addWidget(folder);
    auto *below = new QHBoxLayout;
    below->addWidget(m_told, 1);
    below->addWidget(m_registers);
    below->addWidget(m_reference);
    below->addWidget(m_open);
    auto *layout = edged(new QVBoxLayout(this), kToolEdges);
    layout->addLayout(above);
    layout->addWidget(m_table, 1);
    layout->addLayout(below);

    connect(folder, &QPushButton::clicked, this, &RunBookPanel::askFolder);
    connect(m_split, &QPushButton::clicked, this, &RunBookPanel::askRecording);
    connect(m_registers, &QPushButton::clicked, this, &RunBookPanel::compare);
    connect(m_reference, &QPushButton::clicked, this, [this] {
        for (const session::Run &run : chosen())
            Q_EMIT referenceWanted(session::recordingOf(m_keeper.folder(), run.number));
    });
    connect(m_open, &QPushButton::clicked, this, [this] {
        Q_EMIT recordingWanted(session::recordingOf(m_keeper.folder(), chosen().front().number));
    });
    connect(m_model, &RunBookModel::annotated, this, &RunBookPanel::annotate);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
        &RunBookPanel::updateButtons);
    connect(&keeper, &RunKeeper::folderChanged, this, [this] {
        m_read = false;
        if (isVisible())
            read();
    });
    connect(&keeper, &RunKeeper::kept, this, [this](const session::Run &run) {
        if (!m_read)
            return; // it is read with the others
        m_model->add(run);
        fitColumns();
        tell(tr("Run %1 is kept.", "number").arg(run.number));
    });
    updateButtons();
}

void RunBookPanel::focusFirst() { m_table->setFocus(Qt::ShortcutFocusReason); }

void RunBookPanel::showEvent(QShowEvent *event)
{
    Form::showEvent(event);
    if (!m_read)
        read();
}

/// F2 is the note's here, whatever column is the current one, and not a register's.
bool RunBookPanel::eventFilter(QObject *watched, QEvent *event)
{
    const auto type = event->type();
    const bool key = type == QEvent::KeyPress || type == QEvent::ShortcutOverride;
    if (watched != m_table || !key || static_cast<QKeyEvent *>(event)->key() != Qt::Key_F2)
        return Form::eventFilter(watched, event);
    if (type == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    const QModelIndex note = m_table->currentIndex().siblingAtColumn(RunBookModel::NoteColumn);
    m_table->setCurrentIndex(note);
    m_table->QTreeView::scrollTo(note); // to be seen while it is typed
    return false;
}

void RunBookPanel::askFolder()
{
    m_files.askFolder(window(), {tr("Keep experiments in a folder"), orHome(m_keeper.folder())},
        [this](const QString &path) { m_keeper.setFolder(path); });
}

void RunBookPanel::askRecording()
{
    m_files.askOpen(window(),
        {tr("Add a recording to the run book"), m_keeper.folder(), tr("Recordings (*.pcapng)")},
        [this](const QString &path) { split(path); });
}

void RunBookPanel::split(const QString &recording)
{
    const QString name = fileNameText(recording);
    new FileJob(
        tr("Adding %1").arg(name),
        [this, name, recording, folder = m_keeper.folder()](
            const FileJob::Proceed &proceed) -> FileJob::Finish {
            auto kept = session::keepStretches(folder, recording, proceed);
            return [this, name, folder, kept = std::move(kept)] {
                if (!kept)
                    return tell(tr("%1 is not added: %2.", "file, reason")
                                    .arg(name, deviceText(kept.error())));
                if (folder != m_keeper.folder())
                    return;
                for (const session::Run &run : kept->runs)
                    m_model->add(run);
                fitColumns();
                QString told = tr("%n run(s) are added.", nullptr, int(kept->runs.size()));
                if (kept->leftOut > 0)
                    told += QLatin1Char(' ')
                        + tr("%n stretch(es) are left out, because they are short.", nullptr,
                            kept->leftOut);
                tell(told);
            };
        },
        this);
}

void RunBookPanel::read()
{
    const QString folder = m_keeper.folder();
    m_folder->setText(folder.isEmpty()
            ? tr("Experiments are not kept: choose a folder for them.")
            : tr("Every experiment is kept in %1", "folder").arg(deviceText(folder)));
    m_folder->setToolTip(plainToolTip(folder));
    m_read = !folder.isEmpty();
    m_split->setEnabled(m_read);
    if (folder.isEmpty())
        return;
    m_model->setRuns({});
    new FileJob(
        tr("Reading the run book"),
        [this, folder](const FileJob::Proceed &proceed) -> FileJob::Finish {
            auto book = session::readRunBook(folder, proceed);
            return [this, folder, book = std::move(book)]() mutable {
                if (folder != m_keeper.folder())
                    return;
                if (!book)
                    return tell(tr("%1 cannot be read: %2.", "folder, reason")
                                    .arg(deviceText(folder), deviceText(book.error())));
                tell(problemsText(book->problems));
                m_model->setRuns(std::move(book->runs));
                fitColumns();
                updateButtons();
            };
        },
        this);
}

void RunBookPanel::fitColumns()
{
    for (int column = 0; column < m_model->columnCount(); ++column)
        m_table->resizeColumnToContents(column);
}

void RunBookPanel::annotate(int number, const QString &note, bool starred)
{
    const QString why = session::annotateRun(m_keeper.folder(), number, note, starred);
    tell(why.isEmpty() ? QString()
                       : tr("The note of run %1 is not kept: %2.", "number, reason")
                             .arg(QString::number(number), deviceText(why)));
}

std::vector<session::Run> RunBookPanel::chosen() const
{
    std::vector<session::Run> runs;
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
        runs.push_back(m_model->run(index.row()));
    std::sort(runs.begin(), runs.end(), [](const session::Run &one, const session::Run &other) {
        return one.number < other.number;
    });
    return runs;
}

void RunBookPanel::compare()
{
    const auto runs = chosen();
    const auto file = [this](const session::Run &run) {
        return session::registersOf(m_keeper.folder(), run.number);
    };
    Q_EMIT registersWanted(file(runs.front()), runs.size() == 2 ? file(runs.back()) : QString());
}

void RunBookPanel::updateButtons()
{
    const auto runs = chosen();
    const bool one = runs.size() == 1, two = runs.size() == 2;
    const bool known = std::all_of(
        runs.begin(), runs.end(), [](const session::Run &run) { return run.registers; });
    m_registers->setText(two ? tr("Compare registers") : tr("Back to this run\u2026"));
    m_registers->setEnabled((one || two) && known);
    m_registers->setToolTip(plainToolTip(two
            ? tr("Shows which registers differ between both runs")
            : tr("Shows what the board holds otherwise than behind this run; Restore writes it")));
    m_reference->setEnabled(one || two);
    m_reference->setToolTip(
        plainToolTip(tr("Lays one or two runs behind what the scope shows, as references")));
    m_open->setEnabled(one);
    m_open->setToolTip(
        plainToolTip(tr("Opens the recording of the run, in place of what is shown")));
}

void RunBookPanel::tell(const QString &sentence) { m_told->setText(sentence); }

} // namespace widgets
