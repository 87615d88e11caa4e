#include "widgets/export_dialog.h"

#include "widgets/device_text.h"
#include "widgets/file_prompt.h"
#include "widgets/messages.h"
#include "widgets/scope/scope_view.h"
#include "widgets/value_text.h"

#include <QComboBox>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace widgets {
namespace {

constexpr int kProgressSteps = 1000;

/// "x.csv" and "HF" make "x_HF.csv".
QString partPath(const QString &path, const QString &part)
{
    const QFileInfo info(path);
    const QString name = info.completeBaseName() + QLatin1Char('_') + part + QStringLiteral(".csv");
    return QDir(info.path()).filePath(name);
}

QString partName(const capture::Channel &channel)
{
    using Kind = capture::ChannelInfo::Kind;
    switch (channel.info().kind) {
    case Kind::Fast:
        return QStringLiteral("HF");
    case Kind::Slow:
        return QStringLiteral("MF");
    case Kind::Polled:
        break;
    }
    QString name;
    for (const QChar c : deviceText(channel.info().name)) // what every file system takes
        name += c.unicode() < 128 && (c.isLetterOrNumber() || c == QLatin1Char('_'))
            ? c
            : QLatin1Char('-');
    return name;
}

} // namespace

QString suggestedCaptureName(const QDateTime &now)
{
    return QLocale::c().toString(now, QStringLiteral("yyyy-MM-dd_HH-mm-ss"))
        + QStringLiteral("_motor_capture.csv");
}

ExportDialog::ExportDialog(capture::Capture &capture, ScopeView &scope, FilePrompt &files,
    const QString &folder, QWidget *parent)
    : QDialog(parent)
    , m_capture(capture)
    , m_scope(scope)
    , m_files(files)
    , m_folder(folder)
    , m_range(new QComboBox(this))
    , m_rates(new QComboBox(this))
    , m_summary(new QLabel(this))
    , m_progress(new QProgressBar(this))
{
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export CSV"));
    setModal(true);
    m_range->setObjectName(QStringLiteral("exportRange"));
    m_range->addItem(tr("What the scope shows"));
    m_range->addItem(tr("Everything recorded"));
    m_rates->setObjectName(QStringLiteral("exportRates"));
    m_rates->addItem(tr("One file; slower signals keep their last value"));
    m_rates->addItem(tr("One file for each rate"));
    m_summary->setTextFormat(Qt::PlainText);
    m_summary->setWordWrap(true);
    m_summary->setEnabled(false);
    m_progress->setRange(0, kProgressSteps);
    m_progress->setAccessibleName(tr("Progress of the export"));
    m_progress->setVisible(false);

    auto *buttons = new QDialogButtonBox(this);
    m_save = buttons->addButton(tr("Export\u2026"), QDialogButtonBox::AcceptRole);
    m_save->setObjectName(QStringLiteral("exportSave"));
    m_cancel = buttons->addButton(QDialogButtonBox::Cancel);
    m_cancel->setObjectName(QStringLiteral("exportCancel"));
    connect(m_save, &QPushButton::clicked, this, &ExportDialog::ask);
    connect(m_cancel, &QPushButton::clicked, this, &ExportDialog::reject);
    connect(m_range, &QComboBox::currentIndexChanged, this, &ExportDialog::updateSummary);

    auto *form = new QFormLayout;
    form->addRow(tr("Range"), m_range);
    form->addRow(tr("Rates"), m_rates);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 14);
    layout->setSpacing(12);
    layout->addLayout(form);
    layout->addWidget(m_summary);
    layout->addWidget(m_progress);
    layout->addWidget(buttons);
    setMinimumWidth(420);
    updateSummary();
}

bool ExportDialog::running() const { return m_export != nullptr; }

bool ExportDialog::visibleOnly() const { return m_range->currentIndex() == 0; }

bool ExportDialog::ratesApart() const { return m_rates->currentIndex() == 1; }

capture::Snapshot ExportDialog::snapshot() const
{
    std::vector<capture::ChannelId> ids;
    if (visibleOnly()) {
        const auto shown = m_scope.channels();
        ids.assign(shown.begin(), shown.end());
    } else {
        for (const capture::ChannelInfo &info : m_capture.channels())
            ids.push_back(info.id);
    }
    return m_capture.snapshot(ids);
}

void ExportDialog::updateSummary()
{
    const auto channels = snapshot();
    if (channels->empty()) {
        m_summary->setText(tr("Nothing has been recorded yet."));
        m_save->setEnabled(false);
        return;
    }
    m_save->setEnabled(true);
    m_summary->setText(
        tr("%n signal(s). The first column is the time in seconds; numbers have a decimal point "
           "and columns are separated by commas. Lost samples have no row.",
            nullptr, static_cast<int>(channels->size())));
}

void ExportDialog::ask()
{
    SaveQuestion question;
    question.title = tr("Export CSV");
    question.folder = m_folder.isEmpty() ? QDir::homePath() : m_folder;
    question.suggestedName = suggestedCaptureName(QDateTime::currentDateTime());
    question.filter = tr("CSV files (*.csv)");
    question.suffix = QStringLiteral("csv");
    m_files.askSave(this, question, [this](const QString &path) { begin(path); });
}

void ExportDialog::begin(const QString &path)
{
    if (running())
        return;
    m_options = {};
    if (visibleOnly()) {
        const ScopeView::TimeRange range = m_scope.visibleRange();
        m_options.range = capture::TimeSpan{range.from, range.to};
    }
    const capture::Snapshot all = snapshot();
    m_parts.clear();
    if (ratesApart()) {
        for (const capture::Snapshot &part : capture::splitByRate(all))
            m_parts.append({partPath(path, partName(part->front())), part});
    } else {
        m_parts.append({path, all});
    }
    m_done = 0;
    m_rows = 0;
    m_folder = QFileInfo(path).path();
    QStringList taken;
    for (const Part &part : m_parts)
        if (part.path != path && QFileInfo::exists(part.path))
            taken.append(QFileInfo(part.path).fileName());
    if (!taken.isEmpty()) { // the prompt has asked about the name that was typed, not about these
        m_summary->setText(tr("%1 exists already. Choose another name.")
                               .arg(deviceText(taken.join(QStringLiteral(", ")))));
        return;
    }
    m_progress->setValue(0);
    m_progress->setVisible(true);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_save, m_range, m_rates})
        widget->setEnabled(false);
    nextPart();
}

void ExportDialog::nextPart()
{
    const Part &part = m_parts.at(m_done);
    m_export = std::make_unique<session::CsvExport>(part.path, part.channels, m_options);
    connect(m_export.get(), &session::CsvExport::progressed, this, [this](double fraction) {
        const double all =
            (static_cast<double>(m_done) + fraction) / static_cast<double>(m_parts.size());
        m_progress->setValue(static_cast<int>(all * kProgressSteps));
    });
    connect(m_export.get(), &session::CsvExport::finished, this, &ExportDialog::partFinished,
        Qt::QueuedConnection);
    m_export->start();
}

void ExportDialog::partFinished(const session::CsvResult &result)
{
    m_export.reset();
    m_rows += result.rows;
    if (result.error == session::CsvError::None && ++m_done < m_parts.size()) {
        nextPart();
        return;
    }
    for (QWidget *widget : std::initializer_list<QWidget *>{m_save, m_range, m_rates})
        widget->setEnabled(true);
    m_progress->setVisible(false);
    if (result.error == session::CsvError::None) {
        Q_EMIT exported(m_parts.first().path);
        accept();
        return;
    }
    const QString sentence = csvErrorText(result);
    m_summary->setText(sentence);
    m_summary->setEnabled(true);
    Q_EMIT failed(sentence);
}

void ExportDialog::reject()
{
    if (running())
        m_export->cancel();
    else
        QDialog::reject();
}

} // namespace widgets
