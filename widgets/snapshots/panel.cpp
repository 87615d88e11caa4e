#include "widgets/snapshots/panel.h"

#include "capture/tick_time.h"
#include "session/files/whole_file.h"
#include "widgets/base/device_text.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/value_text.h"
#include "widgets/snapshots/text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>

#include <algorithm>

namespace widgets {
namespace {

const QString kBoard = QStringLiteral("board");
constexpr qsizetype kMostKept = 20;
constexpr std::size_t kMostRecorded = 200; ///< the newest

} // namespace

SnapshotPanel::SnapshotPanel(Device &device, RegisterEdits &edits, AutoSnapshots &automatic,
    FilePrompt &files, QWidget *parent)
    : Form(parent)
    , m_device(device)
    , m_edits(edits)
    , m_automatic(automatic)
    , m_files(files)
    , m_reader(device)
    , m_model(new SnapshotModel(this))
    , m_proxy(new QSortFilterProxyModel(this))
{
    m_sources.push_back({Kind::Board, kBoard, {}, nullptr});
    m_b.key = kBoard;
    makeWidgets();
    listSources();
    connect(&m_reader, &SnapshotReader::progressed, this, [this](int done, int total) {
        m_progress->setRange(0, total);
        m_progress->setValue(done);
    });
    connect(&m_reader, &SnapshotReader::finished, this, &SnapshotPanel::boardRead);
    connect(&device, &Device::identityChanged, this, &SnapshotPanel::boardChanged);
    connect(&device, &Device::linkStateChanged, this, &SnapshotPanel::updateTexts);
    connect(&device, &Device::statusChanged, this, &SnapshotPanel::offer);
    connect(&edits, &RegisterEdits::changed, this, &SnapshotPanel::updateTexts);
    connect(&edits, &RegisterEdits::reported, this, &SnapshotPanel::restored);
    connect(&automatic, &AutoSnapshots::made, this, &SnapshotPanel::listSources);
    connect(m_model, &SnapshotModel::chosenChanged, this, &SnapshotPanel::updateTexts);
    updateTexts();
}

void SnapshotPanel::focusFirst() { m_a.box->setFocus(Qt::ShortcutFocusReason); }

void SnapshotPanel::showEvent(QShowEvent *event)
{
    listSources();
    Form::showEvent(event);
}

SnapshotPanel::Source *SnapshotPanel::source(const QString &key)
{
    const auto found = std::find_if(
        m_sources.begin(), m_sources.end(), [&](const Source &one) { return one.key == key; });
    return found == m_sources.end() ? nullptr : &*found;
}

std::shared_ptr<const snapshots::Snapshot> SnapshotPanel::snapshotOf(const Side &side) const
{
    for (const Source &one : m_sources)
        if (one.key == side.key)
            return one.snapshot;
    return nullptr;
}

bool SnapshotPanel::isBoard(const Side &side) const { return side.key == kBoard; }

/// The board, the files that were opened, and what was kept before writes, newest first.
void SnapshotPanel::listSources()
{
    std::erase_if(m_sources, [this](const Source &one) {
        return one.kind >= Kind::Kept && one.key != m_a.key && one.key != m_b.key;
    });
    const QString recording = fileNameText(m_recorded.path);
    const std::size_t recorded = m_recorded.all.size();
    for (std::size_t i = recorded - std::min(recorded, kMostRecorded); i < recorded; ++i) {
        const QString key = QStringLiteral("%1#%2").arg(m_recorded.path, QString::number(i));
        const double at = capture::toSeconds(m_recorded.all[i].first);
        if (source(key) == nullptr)
            m_sources.push_back({Kind::Recorded, key,
                tr("%1 at %2 s", "recording, seconds").arg(recording, numberText(at, 3)), nullptr});
    }
    const auto title = [](const QDateTime &at) {
        return tr("Before a write, %1", "date and time")
            .arg(QLocale().toString(at, QLocale::ShortFormat));
    };
    QStringList inMemory;
    for (const AutoSnapshots::Kept &kept : m_automatic.kept()) {
        const QString key = kept.at.toString(Qt::ISODateWithMs);
        inMemory.append(kept.file);
        if (source(key) == nullptr)
            m_sources.push_back({Kind::Kept, key, title(kept.at), kept.snapshot});
    }
    const QStringList files = m_automatic.folder().files().mid(0, kMostKept);
    for (const QString &file : files)
        if (!inMemory.contains(file) && source(file) == nullptr)
            m_sources.push_back({Kind::Kept, file, title(QFileInfo(file).lastModified()), nullptr});
    for (Side *side : {&m_a, &m_b}) {
        const QSignalBlocker quiet(side->box);
        side->box->clear();
        for (const Source &one : m_sources)
            side->box->addItem(
                one.kind == Kind::Board ? tr("The board, as it is now") : one.title, one.key);
        side->box->setCurrentIndex(side->box->findData(side->key));
    }
}

void SnapshotPanel::chooseSource(Side &side, int index)
{
    const QString before = side.key;
    side.key = side.box->itemData(index).toString();
    Source *chosen = source(side.key);
    const bool unread = chosen != nullptr && !chosen->snapshot;
    if (unread
        && ((chosen->kind == Kind::Kept && !load(side.key, side))
            || (chosen->kind == Kind::Recorded && !accept(*chosen))))
        side.key = before;
    const QSignalBlocker quiet(side.box);
    side.box->setCurrentIndex(side.box->findData(side.key));
    sourcesChanged();
}

void SnapshotPanel::askFile(Side &side)
{
    const OpenQuestion question{tr("Open a snapshot"), orHome(m_folder), tr("Snapshots (*.json)")};
    m_files.askOpen(window(), question, [this, &side](const QString &path) {
        if (load(path, side))
            sourcesChanged();
    });
}

/// A side has another source: what is missing is read.
void SnapshotPanel::sourcesChanged()
{
    if ((isBoard(m_a) || isBoard(m_b)) && !source(kBoard)->snapshot && m_device.answering())
        readBoard();
    compare();
}

/// Reads a file and makes it the side's source. False: it was told why not, and the side is what it was.
bool SnapshotPanel::load(const QString &path, Side &side)
{
    const auto content = session::readWholeFile(path);
    if (!content) {
        tell(tr("%1 cannot be read: %2.", "file, the system's words")
                 .arg(fileNameText(path), deviceText(content.error())));
        return false;
    }
    auto snapshot = session::readSnapshotJson(*content);
    if (!snapshot) {
        tell(snapshotFileErrorText(path, snapshot.error()));
        return false;
    }
    tell({});
    const auto value = std::make_shared<const snapshots::Snapshot>(std::move(*snapshot));
    if (Source *known = source(path))
        known->snapshot = value;
    else
        m_sources.insert(m_sources.begin() + 1, {Kind::File, path, fileNameText(path), value});
    side.key = path;
    if (source(path)->kind == Kind::File)
        m_folder = QFileInfo(path).path();
    listSources();
    return true;
}

/// Makes sense of what a recording holds. False: it was told why it is none.
bool SnapshotPanel::accept(Source &recorded)
{
    const auto number =
        static_cast<std::size_t>(recorded.key.section(QLatin1Char('#'), -1).toUInt());
    auto snapshot =
        session::readSnapshotJson(QByteArray::fromStdString(m_recorded.all.at(number).second.json));
    if (!snapshot) {
        tell(snapshotFileErrorText(m_recorded.path, snapshot.error()));
        return false;
    }
    tell({});
    recorded.snapshot = std::make_shared<const snapshots::Snapshot>(std::move(*snapshot));
    return true;
}

void SnapshotPanel::offerRecorded(RecordedSnapshots recorded)
{
    for (Side *side : {&m_a, &m_b}) { // what is compared stays, unless its name is of another now
        if (const Source *shown = source(side->key); shown && shown->kind == Kind::Recorded)
            side->key.clear();
    }
    m_recorded = std::move(recorded);
    listSources();
    compare();
}

void SnapshotPanel::openFile(const QString &path)
{
    if (!load(path, m_a))
        return;
    if (isBoard(m_b))
        readBoard();
    compare();
}

void SnapshotPanel::compareFiles(const QString &a, const QString &b)
{
    if (!load(a, m_a) || (!b.isEmpty() && !load(b, m_b)))
        return;
    if (b.isEmpty())
        m_b.key = kBoard;
    listSources();
    if (isBoard(m_b) && m_device.answering())
        readBoard();
    compare();
}

void SnapshotPanel::readBoard()
{
    if (m_reader.running())
        return;
    if (!m_device.answering() || !m_device.identified()) {
        tell(tr("No board is answering."));
        return;
    }
    tell({});
    m_progress->setRange(0, 0);
    m_reader.start(snapshots::Scope::All);
    updateTexts();
}

void SnapshotPanel::boardRead(const BoardReading &reading)
{
    if (reading.end == BoardReading::End::Whole) {
        source(kBoard)->snapshot = std::make_shared<const snapshots::Snapshot>(reading.snapshot);
        if (!reading.unanswered.isEmpty())
            tell(tr("The board never answered for: %1.", "list of registers")
                     .arg(reading.unanswered.join(QStringLiteral(", "))));
    } else if (reading.end == BoardReading::End::Broken) {
        tell(tr("The board could not be read to the end; the table shows what it held before."));
    }
    compare();
}

/// Another board, or the same one after a connection: what was read is no longer what it holds.
void SnapshotPanel::boardChanged()
{
    const bool wanted = isBoard(m_a) || isBoard(m_b);
    source(kBoard)->snapshot.reset();
    if (m_device.identified() && wanted && isVisible() && (snapshotOf(m_a) || snapshotOf(m_b)))
        readBoard();
    compare();
}

void SnapshotPanel::compare()
{
    m_model->compare(snapshotOf(m_a), snapshotOf(m_b),
        m_all->isChecked() ? snapshots::Scope::All : snapshots::Scope::Tunable);
    m_moving = {-1}; // none that can be: offer() has to look
    offer();
}

/// What of the table can be written now; anew when a motor begins to turn or comes to rest.
void SnapshotPanel::offer()
{
    std::vector<int> moving;
    const auto catalog = m_device.catalog();
    for (int motor = 1; catalog && motor <= catalog->motors(); ++motor)
        if (!drive::rests(m_device.status(motor).state))
            moving.push_back(motor);
    if (moving == m_moving)
        return;
    m_moving = moving;
    const auto a = snapshotOf(m_a), b = snapshotOf(m_b);
    const bool canBe = a && b && catalog && isBoard(m_b) && !isBoard(m_a);
    m_model->offer(
        canBe ? snapshots::planRestore(*a, *b, *catalog, {}, moving) : snapshots::RestorePlan());
    const auto others =
        canBe ? snapshots::otherHardware(a->board, b->board) : std::vector<std::string>();
    if (others.empty())
        m_otherHardware->setChecked(false);
    m_otherHardware->setVisible(!others.empty());
    m_otherHardware->setText(tr("A was taken of other hardware; restore it all the same"));
    m_otherHardware->setToolTip(plainToolTip(deviceNames(others)));
    updateTexts();
}

std::vector<drive::RegisterWrite> SnapshotPanel::chosen() const
{
    return m_model->chosen(
        [this](int row) { return m_proxy->mapFromSource(m_model->index(row, 0)).isValid(); });
}

QString SnapshotPanel::restoreHint() const
{
    if (isBoard(m_a) || !snapshotOf(m_a))
        return tr("Choose a snapshot as A.");
    if (!isBoard(m_b) || !snapshotOf(m_b))
        return tr("Choose the board as B.");
    if (m_reader.running())
        return tr("The board is being read.");
    if (chosen().empty())
        return m_model->differing() == 0 ? tr("The board holds these values already.")
                                         : tr("Nothing that can be written is chosen.");
    if (!m_otherHardware->isHidden() && !m_otherHardware->isChecked())
        return tr("A was taken of other hardware.");
    return m_edits.writeHint();
}

void SnapshotPanel::restore()
{
    if (!restoreHint().isEmpty())
        return;
    m_report->hide();
    m_restoring = tr("Restore %1", "a snapshot").arg(source(m_a.key)->title);
    m_edits.write(m_restoring, chosen());
    updateTexts();
}

/// Each register of the restore by name: none is left in doubt without being named.
void SnapshotPanel::restored(const WriteReport &report)
{
    if (isBoard(m_b) && snapshotOf(m_b) && m_device.answering() && isVisible())
        readBoard(); // whatever was written: the table is to show what the board holds
    if (report.text.isEmpty() || report.text != m_restoring)
        return;
    QStringList lines{report.sentence};
    const auto list = [&lines](const QString &title, const QStringList &names) {
        if (!names.isEmpty())
            lines.append(title + QStringLiteral("\n    ") + names.join(QStringLiteral("\n    ")));
    };
    if (!report.good()) {
        list(tr("Written and read back:"), report.written);
        list(tr("Written, not verified:"), report.unproved);
        list(tr("The board made another value of:"), report.different);
        list(tr("It is not known whether these were written:"), report.unknown);
        list(tr("Not written:"), report.notWritten);
    }
    m_report->setPlainText(lines.join(QLatin1Char('\n')));
    m_report->show();
}

void SnapshotPanel::tell(const QString &sentence)
{
    m_told->setText(sentence);
    m_told->setVisible(!sentence.isEmpty());
}

} // namespace widgets
